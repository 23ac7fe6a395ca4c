#define _POSIX_C_SOURCE 200809L
#include "stop.h"

#include <signal.h>
#include <stddef.h>

/* The one thing that is global and changes: a signal handler can reach nothing else. */
static volatile sig_atomic_t wishes;

static void count_wish(int signal)
{
    (void)signal;
    wishes = (wishes < 2) ? wishes + 1 : 2;
}

void tb_stop_listen(void)
{
    struct sigaction count = {.sa_handler = count_wish, .sa_flags = SA_RESTART};
    sigfillset(&count.sa_mask); /* one signal at a time: two together are two wishes */
    struct sigaction const ignore = {.sa_handler = SIG_IGN};
    sigaction(SIGINT, &count, NULL);
    sigaction(SIGTERM, &count, NULL);
    sigaction(SIGHUP, &count, NULL); /* the terminal has gone, and its person with it */
    sigaction(SIGPIPE, &ignore, NULL);
}

int tb_stop_wished(void)
{
    return wishes;
}
