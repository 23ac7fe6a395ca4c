/* What codegen/controller.py needs around the controller step to drive it from Python.
 * Runs on a host only; nothing of it goes to a machine. */
#define _POSIX_C_SOURCE 199309L

#include <stddef.h>
#include <stdint.h>
#include <time.h>

#include "controller.h"

size_t shim_inputs_size(void);
size_t shim_outputs_size(void);
size_t shim_controller_size(void);
void shim_run(tb_controller *controller, size_t cycles, const tb_inputs inputs[],
              tb_outputs outputs[], int64_t nanoseconds[]);

size_t shim_inputs_size(void)
{
    return sizeof(tb_inputs);
}

size_t shim_outputs_size(void)
{
    return sizeof(tb_outputs);
}

size_t shim_controller_size(void)
{
    return sizeof(tb_controller);
}

static int64_t now(void)
{
    struct timespec time;
    (void)clock_gettime(CLOCK_MONOTONIC, &time);
    return ((int64_t)time.tv_sec * 1000000000) + (int64_t)time.tv_nsec;
}

void shim_run(tb_controller *controller, size_t cycles, const tb_inputs inputs[],
              tb_outputs outputs[], int64_t nanoseconds[])
{
    int64_t before = now();
    for (size_t i = 0; i < cycles; i++) {
        (void)tb_controller_step(controller, &inputs[i], &outputs[i]);
        int64_t const after = now();
        nanoseconds[i] = after - before;
        before = after;
    }
}
