#define _GNU_SOURCE /* cpu_set_t */
#include "realtime.h"

#include <errno.h>
#include <sched.h>
#include <stddef.h>
#include <string.h>
#include <sys/mman.h>

#include "say.h"

#define STACK_BYTES (256u * 1024u) /* more than the loop ever uses */
#define PAGE_BYTES 4096u

/* A page that is touched the first time is fetched by the kernel, which takes time. */
static void touch_stack(void)
{
    char stack[STACK_BYTES];
    for (size_t i = 0; i < STACK_BYTES; i += PAGE_BYTES) {
        volatile char *const page = &stack[i];
        *page = 0;
    }
}

static bool take_priority(int priority)
{
    struct sched_param const parameters = {.sched_priority = priority};
    return sched_setscheduler(0, SCHED_FIFO, &parameters) == 0;
}

static bool take_processor(int cpu)
{
    cpu_set_t processors;
    CPU_ZERO(&processors);
    if (cpu >= 0) {
        CPU_SET((size_t)cpu, &processors);
        if (sched_setaffinity(0, sizeof processors, &processors) != 0) {
            tb_say("--cpu %d: %s", cpu,
                   (errno == EINVAL) ? "this computer, or this user, has no such processor"
                                     : strerror(errno));
            return false;
        }
    }
    return true;
}

static void say_what_is_missing(bool first, bool locked, int priority)
{
    tb_say(
        "notice: without %s%s%s cycles may come late. The unit turnbuckle@.service has the rights; "
        "for a user, put \"USER - rtprio %d\" and \"USER - memlock unlimited\" into "
        "/etc/security/limits.d/turnbuckle.conf and log in again; --priority 0 does without",
        first ? "" : "real-time priority (SCHED_FIFO)", (first || locked) ? "" : " and ",
        locked ? "" : "locked memory", priority);
}

bool tb_realtime_enter(const tb_options *options)
{
    if (!take_processor(options->cpu)) {
        return false;
    }
    if ((options->priority > 0) && (options->clock == NULL)) {
        bool const locked = mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
        bool const first = take_priority(options->priority);
        if (!locked || !first) {
            say_what_is_missing(first, locked, options->priority);
        }
    }
    touch_stack();
    return true;
}
