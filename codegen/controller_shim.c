/* What codegen/controller.py needs around the controller step to drive it from Python.
 * Runs on a host only; nothing of it goes to a machine. */
#define _POSIX_C_SOURCE 199309L

#include <stddef.h>
#include <stdint.h>
#include <time.h>

#include "controller_layout.h"

extern const tb_layout_row shim_layout[];
extern const uint32_t shim_layout_rows;
void shim_run(tb_controller *controller, size_t cycles, const tb_inputs inputs[],
              tb_outputs outputs[], int64_t nanoseconds[]);

const tb_layout_row shim_layout[] = {TB_CONTROLLER_LAYOUT};

const uint32_t shim_layout_rows = sizeof(shim_layout) / sizeof(shim_layout[0]);

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
