#include "echo.h"

#include <stddef.h>
#include <string.h>

/* A frame that is forgotten before it came back weighs as much as so many that came: an adapter may
 * lose some. Another master sends only a part of what this one does. */
#define WEIGHT_OF_LOSS 4u
#define MOST_LOSSES 64u
/* Frames that are sent without a word from any drive; all lost, they weigh half of what is too much. */
#define FRAMES_WITHOUT_DRIVE 8u

static void weigh(tb_echo *echo, const tb_echo_frame *kept)
{
    bool const returned = kept->returned != 0;
    bool const is_lost = !returned && (kept->passed != 0);
    if (is_lost) { /* beyond MOST_LOSSES nothing is kept any more */
        echo->losses = (uint8_t)(echo->losses + WEIGHT_OF_LOSS);
    } else if (returned && (echo->losses > 0)) {
        echo->losses--;
    } else {
        /* it cannot be more, or less */
    }
}

static void forget_oldest(tb_echo *echo)
{
    weigh(echo, &echo->frames[echo->first]);
    echo->first = (uint8_t)((echo->first + 1u) % TB_ECHO_FRAMES);
    echo->count--;
}

void tb_echo_hear(tb_echo *echo)
{
    echo->acknowledged = FRAMES_WITHOUT_DRIVE;
}

static bool is_same(const tb_echo_frame *kept, const tb_can_frame *frame)
{
    return (kept->id == frame->id) && (kept->length == frame->length) &&
           (memcmp(kept->data, frame->data, kept->length) == 0);
}

/* Whether a frame that waits for the first drive stands for this one too. */
static bool is_kept(const tb_echo *echo, const tb_can_frame *frame)
{
    bool kept = false;
    for (uint32_t i = 0; i < echo->count; i++) {
        const tb_echo_frame *const other = &echo->frames[(echo->first + i) % TB_ECHO_FRAMES];
        kept = kept || ((other->passed == 0) && is_same(other, frame));
    }
    return kept;
}

/* Whether the adapter does not echo: then nothing has to be remembered. */
static bool is_over(const tb_echo *echo)
{
    return echo->losses >= MOST_LOSSES;
}

void tb_echo_keep(tb_echo *echo, const tb_can_frame *frame)
{
    if (is_over(echo)) {
        return;
    }
    uint8_t const passed = (echo->acknowledged > 0) ? 1 : 0;
    if ((passed == 0) && is_kept(echo, frame)) {
        return;
    }
    if (echo->count == TB_ECHO_FRAMES) {
        forget_oldest(echo);
    }
    tb_echo_frame *const kept = &echo->frames[(echo->first + echo->count) % TB_ECHO_FRAMES];
    kept->id = (uint16_t)frame->id;
    kept->length = frame->length;
    kept->returned = 0;
    kept->passed = passed;
    echo->acknowledged = (uint8_t)(echo->acknowledged - passed);
    memcpy(kept->data, frame->data, sizeof kept->data);
    echo->count++;
}

/* A frame that has not come back yet, of those sent before the first drive was heard or of those sent
 * since; NULL for none. */
static tb_echo_frame *find_awaited(tb_echo *echo, const tb_can_frame *frame, uint8_t passed)
{
    for (uint32_t i = 0; i < echo->count; i++) {
        tb_echo_frame *const kept = &echo->frames[(echo->first + i) % TB_ECHO_FRAMES];
        if ((kept->passed == passed) && (kept->returned == 0) && is_same(kept, frame)) {
            return kept;
        }
    }
    return NULL;
}

bool tb_echo_take(tb_echo *echo, const tb_can_frame *frame)
{
    if (is_over(echo)) {
        return false;
    }
    tb_echo_frame *const sent = find_awaited(echo, frame, 1);
    if (sent != NULL) {
        sent->returned = 1;
        return true;
    }
    return find_awaited(echo, frame, 0) != NULL;
}
