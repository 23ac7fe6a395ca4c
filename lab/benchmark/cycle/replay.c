/* Runs recorded cycles of a master once more: what drives answered goes in, what it sends is thrown
 * away. Built together with the lockstep's shim, whose machine it runs. */
#include "../../lockstep_shim.c"

/** A recorded cycle: how many frames came in answer to SYNC, and how many after the setpoints. */
typedef struct {
    uint32_t answers;
    uint32_t others;
} shim_arrived;

size_t shim_replay(shim_machine *machine, const tb_wishes wishes[], const shim_arrived arrived[],
                   const shim_frame frames[], size_t cycles);

/* The number of frames that the master sent. */
size_t shim_replay(shim_machine *machine, const tb_wishes wishes[], const shim_arrived arrived[],
                   const shim_frame frames[], size_t cycles)
{
    shim_frame sent[64];
    size_t const room = sizeof sent / sizeof sent[0];
    size_t count = 0;
    for (size_t i = 0; i < cycles; i++) {
        count += shim_sync(machine, sent, room);
        frames += shim_give(machine, frames, arrived[i].answers);
        count += shim_run(machine, &wishes[i], 0, sent, room);
        frames += shim_give(machine, frames, arrived[i].others);
    }
    return count;
}
