#include "transition.h"

#include <stddef.h>

void tb_enter(tb_supervisor *supervisor, tb_state state, tb_phase phase)
{
    supervisor->state = (uint8_t)state;
    supervisor->complement = (uint8_t) ~(uint8_t)state;
    supervisor->phase = (uint8_t)phase;
    supervisor->cycles = 0;
    supervisor->calm = 0;
    for (size_t i = 0; i < TB_BUSES; i++) {
        supervisor->spoiled[i] = 0;
    }
}
