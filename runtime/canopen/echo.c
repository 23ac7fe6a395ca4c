#include "echo.h"

#include <string.h>

/* A frame that is forgotten before it came back weighs as much as so many that came: an adapter may
 * lose some. Another master sends only a part of what this one does. */
#define WEIGHT_OF_LOSS 4u
#define MOST_LOSSES 64u

static void weigh_loss(tb_echo *echo, bool returned)
{
    if (!returned && (echo->losses < MOST_LOSSES)) {
        echo->losses = (uint8_t)(echo->losses + WEIGHT_OF_LOSS);
    } else if (returned && (echo->losses > 0)) {
        echo->losses--;
    } else {
        /* it cannot be more, or less */
    }
}

static void forget_oldest(tb_echo *echo)
{
    weigh_loss(echo, echo->frames[echo->first].returned != 0);
    echo->first = (uint8_t)((echo->first + 1u) % TB_ECHO_FRAMES);
    echo->count--;
}

void tb_echo_keep(tb_echo *echo, const tb_can_frame *frame)
{
    if (echo->count == TB_ECHO_FRAMES) {
        forget_oldest(echo);
    }
    tb_echo_frame *const kept = &echo->frames[(echo->first + echo->count) % TB_ECHO_FRAMES];
    kept->id = (uint16_t)frame->id;
    kept->length = frame->length;
    kept->returned = 0;
    memcpy(kept->data, frame->data, sizeof kept->data);
    echo->count++;
}

static bool is_awaited(const tb_echo_frame *kept, const tb_can_frame *frame)
{
    return (kept->returned == 0) && (kept->id == frame->id) && (kept->length == frame->length) &&
           (memcmp(kept->data, frame->data, kept->length) == 0);
}

bool tb_echo_take(tb_echo *echo, const tb_can_frame *frame)
{
    for (uint32_t i = 0; (i < echo->count) && (echo->losses < MOST_LOSSES); i++) {
        tb_echo_frame *const kept = &echo->frames[(echo->first + i) % TB_ECHO_FRAMES];
        if (is_awaited(kept, frame)) {
            kept->returned = 1;
            return true;
        }
    }
    return false;
}
