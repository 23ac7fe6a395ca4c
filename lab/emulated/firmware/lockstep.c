/* The runtime on an emulated Cortex-M, run cycle by cycle by the host: the functions of the lockstep's
 * shim, called through two named pipes. target.py is the host's side, and says what is exchanged. */
#include "../../lockstep_shim.c"
#include "semihosting.h"

#define CPUID (*(volatile const uint32_t *)0xE000ED00u)
#define ROOM 256u /* frames that one step of the master can send at most */

typedef enum { SYNC, RUN, GIVE, SET_BUS, DESCRIBE, SAVE, END } command;
enum { NO_PIPE = 2, HOST_HAS_GONE = 3, TOO_MANY_FRAMES = 4 };

typedef struct {
    uint32_t command;
    uint32_t number;
} request;

typedef struct {
    uint32_t count;
    shim_frame frames[ROOM];
} sent_frames;

extern uint32_t stack_used(void);
extern uint32_t data_start[], bss_end[];

static shim_machine machine;
static int32_t from_host, to_host;

static void get(void *to, size_t size)
{
    if (semihosting_read(from_host, to, size) != 0u) {
        semihosting_exit(HOST_HAS_GONE);
    }
}

static void put(const void *from, size_t size)
{
    if (semihosting_write(to_host, from, size) != 0u) {
        semihosting_exit(HOST_HAS_GONE);
    }
}

static void put_sent(const sent_frames *sent)
{
    put(sent, sizeof sent->count + (sent->count * sizeof sent->frames[0]));
}

static void synchronise(void)
{
    static sent_frames sent;
    sent.count = shim_sync(&machine, sent.frames, ROOM);
    put_sent(&sent);
}

static void run(uint32_t missed)
{
    static struct {
        tb_view view;
        sent_frames sent;
    } answer;
    tb_wishes wishes;
    get(&wishes, sizeof wishes);
    answer.sent.count = shim_run(&machine, &wishes, missed, answer.sent.frames, ROOM);
    shim_look(&machine, &answer.view);
    put(&answer, offsetof(__typeof__(answer), sent.frames) +
                     (answer.sent.count * sizeof answer.sent.frames[0]));
}

static void give(uint32_t count)
{
    static shim_frame frames[ROOM];
    if (count > ROOM) {
        semihosting_exit(TOO_MANY_FRAMES);
    }
    get(frames, count * sizeof frames[0]);
    uint32_t const taken = shim_give(&machine, frames, count);
    put(&taken, sizeof taken);
}

/* number: the bus, its state and whether it is full, a byte each. */
static void set_bus(uint32_t number)
{
    shim_set_bus(&machine, number & 0xFFu, (number >> 8) & 0xFFu, number >> 16);
}

static void describe(void)
{
    uint32_t const master = (uint32_t)(uintptr_t)&machine.master;
    uint32_t const facts[] = {CPUID, (uint32_t)sizeof shim_layout, stack_used(), master};
    put(facts, sizeof facts);
    put(shim_layout, sizeof shim_layout);
}

/* All variables. */
static void save(void)
{
    uint32_t const size = (uint32_t)((uintptr_t)bss_end - (uintptr_t)data_start);
    put(&size, sizeof size);
    put(data_start, size);
}

static bool obey(const request *asked)
{
    switch ((command)asked->command) {
    case SYNC:
        synchronise();
        return true;
    case RUN:
        run(asked->number);
        return true;
    case GIVE:
        give(asked->number);
        return true;
    case SET_BUS:
        set_bus(asked->number);
        return true;
    case DESCRIBE:
        describe();
        return true;
    case SAVE:
        save();
        return true;
    case END:
    default:
        return false;
    }
}

int main(void)
{
    request asked;
    from_host = semihosting_open("to_target", SEMIHOSTING_READ);
    to_host = semihosting_open("from_target", SEMIHOSTING_WRITE);
    if ((from_host < 0) || (to_host < 0)) {
        return NO_PIPE;
    }
    shim_start(&machine);
    do {
        get(&asked, sizeof asked);
    } while (obey(&asked));
    return 0;
}
