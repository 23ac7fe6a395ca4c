/* The program of a board: one machine, for ever. */
#include <stddef.h>

#include "board.h"
#include "cycles.h"

int main(void)
{
    static tb_cycles cycles;
    tb_fieldbus *const fieldbus = tb_board_start();
    if (fieldbus == NULL) {
        return 1;
    }
    tb_cycles_start(&cycles, fieldbus);
    for (;;) {
        tb_cycles_run(&cycles);
    }
}
