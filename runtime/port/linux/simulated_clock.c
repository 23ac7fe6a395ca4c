#define _POSIX_C_SOURCE 200809L
#include "simulated_clock.h"

#include <errno.h>
#include <stddef.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>

#include "say.h"
#include "stop.h"
#include "unix_socket.h"

#define PATIENCE 600 /* s of the computer's time, until a simulation has answered */

static tb_simulated_clock *simulated_of(tb_clock *clock)
{
    return (tb_simulated_clock *)(void *)clock;
}

static int64_t now(const tb_clock *clock)
{
    return ((const tb_simulated_clock *)(const void *)clock)->time;
}

static bool tell(const tb_simulated_clock *clock, int64_t until)
{
    tb_moment moment = {.time = until};
    for (size_t i = 0; i < TB_BUSES; i++) {
        moment.frames[i] = clock->awaited[i].sent;
    }
    return send(clock->socket, &moment, sizeof moment, MSG_NOSIGNAL) == (ssize_t)sizeof moment;
}

/* A signal, or having been stopped, interrupts the wait; so does a person who has asked twice. */
static bool hear(const tb_simulated_clock *clock, tb_moment *moment)
{
    ssize_t length = -1;
    do {
        length = recv(clock->socket, moment, sizeof *moment, MSG_TRUNC);
    } while ((length < 0) && (errno == EINTR) && (tb_stop_wished() < 2));
    if ((length >= 0) && (length != (ssize_t)sizeof *moment)) {
        errno = (length == 0) ? EPIPE : EPROTO;
    }
    return length == (ssize_t)sizeof *moment;
}

static void say_why(const tb_simulated_clock *clock)
{
    if ((errno == EPIPE) || (errno == ECONNRESET)) {
        tb_say("--clock %s: the simulation has ended, and time with it", clock->path);
    } else if (errno == EPROTO) {
        tb_say("--clock %s: no simulation of this machine: it speaks of another number of buses",
               clock->path);
    } else if ((errno == EAGAIN) || (errno == EWOULDBLOCK)) {
        tb_say("--clock %s: the simulation has let no time pass for %d s", clock->path, PATIENCE);
    } else if (errno != EINTR) { /* a person who has asked twice knows why */
        tb_say("--clock %s: %s", clock->path, strerror(errno));
    }
}

static bool let_time_pass(tb_simulated_clock *clock, int64_t until)
{
    tb_moment moment;
    if (!tell(clock, until) || !hear(clock, &moment)) {
        say_why(clock);
        return false;
    }
    clock->time = moment.time;
    for (size_t i = 0; i < TB_BUSES; i++) {
        clock->awaited[i].promised = moment.frames[i];
    }
    return true;
}

static bool has_every_frame(const tb_simulated_clock *clock)
{
    for (size_t i = 0; i < TB_BUSES; i++) {
        if (clock->awaited[i].deceived) {
            tb_say("--clock %s: frames of the simulation on the bus %s did not come", clock->path,
                   tb_buses[i].name);
            return false;
        }
    }
    return true;
}

static void sleep_until(tb_clock *clock, int64_t time)
{
    tb_simulated_clock *const simulated = simulated_of(clock);
    if (!clock->stopped && (time > simulated->time)) {
        clock->stopped = !has_every_frame(simulated) || !let_time_pass(simulated, time);
    }
}

bool tb_simulated_clock_open(tb_simulated_clock *clock, const char *path,
                             tb_can_port *const ports[TB_BUSES])
{
    struct timeval const patience = {.tv_sec = PATIENCE};
    *clock = (tb_simulated_clock){.clock = {.now = now, .sleep_until = sleep_until}, .path = path};
    for (size_t i = 0; i < TB_BUSES; i++) {
        tb_awaited_port_start(&clock->awaited[i], ports[i]);
        clock->ports[i] = &clock->awaited[i].port;
    }
    clock->socket = tb_unix_connect(SOCK_SEQPACKET, path);
    if ((clock->socket < 0) ||
        (setsockopt(clock->socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience) != 0)) {
        tb_say(
            "--clock %s: %s; allowed: the socket of a simulation, as turnbuckle run --sim has it",
            path, strerror(errno));
        return false;
    }
    return let_time_pass(clock, 0); /* what time it is */
}
