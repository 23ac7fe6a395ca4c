/* Fuzz target: any frames sent to a bus, any frames that come back.
 *
 * Every three bytes are a step: whether frames are sent or received, and how many of which. What must
 * hold: while drives are heard, no frame counts as an echo more often than it was sent; where nothing
 * was sent, there is none. */
#include <stddef.h>
#include <stdint.h>

#include "echo.h"

#define STEP 3u
#define KINDS 8u

static void require(bool condition)
{
    if (!condition) {
        __builtin_trap();
    }
}

static tb_can_frame frame_of(uint32_t kind)
{
    tb_can_frame frame = {.id = 0x080u + ((kind & 1u) << 8), .length = (uint8_t)(kind & 2u)};
    frame.data[0] = (uint8_t)(kind >> 2);
    return frame;
}

/* Kinds of the same length 0 are the same frame. */
static uint32_t name_of(uint32_t kind)
{
    return ((kind & 2u) == 0) ? (kind & 1u) : kind;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint32_t sent[KINDS] = {0};
    uint32_t echoed[KINDS] = {0};
    tb_echo echo = {.first = 0};
    for (size_t at = 0; (at + STEP) <= size; at += STEP) {
        uint32_t const kind = data[at + 1u] % KINDS;
        tb_can_frame const frame = frame_of(kind);
        for (uint32_t i = 0; i <= (data[at + 2u] % 80u); i++) {
            tb_echo_hear(&echo);
            if ((data[at] & 1u) != 0) {
                tb_echo_keep(&echo, &frame);
                sent[name_of(kind)]++;
            } else {
                echoed[name_of(kind)] += tb_echo_take(&echo, &frame) ? 1u : 0u;
            }
            require(echoed[name_of(kind)] <= sent[name_of(kind)]);
            require((echo.count <= TB_ECHO_FRAMES) && (echo.first < TB_ECHO_FRAMES));
        }
    }
    return 0;
}
