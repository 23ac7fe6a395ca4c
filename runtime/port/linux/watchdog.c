#include "watchdog.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>

#include "clock.h"
#include "say.h"
#include "unix_socket.h"

#define DEFAULT_INTERVAL (TB_SECOND / 10) /* where systemd does not say how patient it is */

/* A third of what systemd waits ($WATCHDOG_USEC), so that two may get lost. */
static int64_t interval(void)
{
    const char *const text = getenv("WATCHDOG_USEC");
    long long const patience = (text == NULL) ? 0 : strtoll(text, NULL, 10); /* us */
    return ((patience > 0) && (patience < INT32_MAX)) ? ((int64_t)patience * 1000) / 3
                                                      : DEFAULT_INTERVAL;
}

bool tb_watchdog_open(tb_watchdog *watchdog)
{
    const char *const path = getenv("NOTIFY_SOCKET");
    *watchdog = (tb_watchdog){.socket = -1, .interval = interval()};
    if (path == NULL) {
        return true;
    }
    watchdog->socket = tb_unix_connect(SOCK_DGRAM | SOCK_NONBLOCK, path);
    if (watchdog->socket < 0) {
        tb_say("$NOTIFY_SOCKET %s: %s", path, strerror(errno));
        return false;
    }
    return true;
}

/* A sign of life that cannot be sent is one that is missing: that is what the watchdog is for. */
static void tell(const tb_watchdog *watchdog, const char *text)
{
    if (watchdog->socket >= 0) {
        ssize_t const sent = send(watchdog->socket, text, strlen(text), MSG_NOSIGNAL);
        (void)sent;
    }
}

void tb_watchdog_ready(const tb_watchdog *watchdog)
{
    tell(watchdog, "READY=1");
}

void tb_watchdog_feed(tb_watchdog *watchdog)
{
    int64_t const now = tb_clock_monotonic();
    if (now >= watchdog->next) {
        tell(watchdog, "WATCHDOG=1");
        watchdog->next = now + watchdog->interval;
    }
}

void tb_watchdog_stopping(const tb_watchdog *watchdog)
{
    tell(watchdog, "STOPPING=1");
}
