#include "serial_line.h"
#include "slcan_lines.h"

#define ANSWER_TIME 200 /* ms, until an adapter that answers has answered */
#define SILENCE 50      /* ms without a byte: what was under way has arrived */
#define LOOK_TIME 10    /* ms between two looks at the clock, where nothing comes */

/* What is said to the adapter, one after the other. */
typedef enum {
    CLOSE_BUS = 0, /* the first line ends what another program left unfinished, the second closes */
    SET_BIT_RATE,
    OPEN_BUS,
    OPENED
} tb_step;

/* Bit rates in the order of their commands S0 to S8. */
static const uint32_t bit_rates[] = {10000,  20000,  50000,  100000, 125000,
                                     250000, 500000, 800000, 1000000};
#define BIT_RATES (sizeof bit_rates / sizeof bit_rates[0])

static void enter(tb_slcan_opening *opening, tb_step step)
{
    opening->step = (uint8_t)step;
    opening->said = false;
    opening->until = tb_serial_milliseconds() + ANSWER_TIME;
}

static bool is_over(const tb_slcan_opening *opening)
{
    return tb_serial_milliseconds() >= opening->until;
}

/* ---- Saying ---- */

static tb_can_result write_command(tb_slcan *slcan)
{
    char const rate[] = {'S', slcan->opening.rate, '\r'};
    switch (slcan->opening.step) {
    case CLOSE_BUS:
        return tb_slcan_write_line(slcan, "C\rC\r", 4);
    case SET_BIT_RATE:
        return tb_slcan_write_line(slcan, rate, sizeof rate);
    default:
        return tb_slcan_write_line(slcan, "O\r", 2);
    }
}

static tb_can_result say(tb_slcan *slcan)
{
    tb_slcan_opening *const opening = &slcan->opening;
    tb_can_result const result = write_command(slcan);
    if (result == TB_CAN_OK) {
        int64_t const now = tb_serial_milliseconds();
        opening->said = true;
        opening->until = now + ANSWER_TIME;
        opening->silent = now + SILENCE;
    }
    if (result == TB_CAN_FULL) {
        return is_over(opening) ? TB_CAN_REFUSED : TB_CAN_EMPTY;
    }
    return result;
}

/* ---- Hearing ---- */

/* Skip all that arrives until nothing does. */
static tb_can_result hear_silence(tb_slcan *slcan)
{
    tb_slcan_opening *const opening = &slcan->opening;
    tb_can_result const result = tb_slcan_read_bytes(slcan);
    slcan->next = slcan->end;
    if (result == TB_CAN_CLOSED) {
        return result;
    }
    if (result == TB_CAN_OK) {
        opening->silent = tb_serial_milliseconds() + SILENCE;
    }
    if ((tb_serial_milliseconds() < opening->silent) && !is_over(opening)) {
        return TB_CAN_EMPTY;
    }
    tb_slcan_start(&slcan->reader);
    return TB_CAN_OK;
}

/* The answer among the bytes that are here; what is none is skipped. */
static tb_can_result find_answer(tb_slcan *slcan)
{
    tb_can_frame skipped;
    tb_slcan_item item = TB_SLCAN_NOTHING;
    do {
        item = tb_slcan_next_item(slcan, &skipped);
    } while ((item != TB_SLCAN_NOTHING) && (item != TB_SLCAN_DONE) && (item != TB_SLCAN_FAILED));
    if (item == TB_SLCAN_NOTHING) {
        return TB_CAN_EMPTY;
    }
    return (item == TB_SLCAN_DONE) ? TB_CAN_OK : TB_CAN_REFUSED;
}

/* An adapter that says nothing in time has agreed. */
static tb_can_result hear_answer(tb_slcan *slcan)
{
    tb_can_result result = tb_slcan_read_bytes(slcan);
    if (result == TB_CAN_OK) {
        result = find_answer(slcan);
        slcan->answers = slcan->answers || (result == TB_CAN_OK);
    }
    if ((result == TB_CAN_REFUSED) && (slcan->opening.step == SET_BIT_RATE)) {
        return TB_CAN_BIT_RATE;
    }
    return ((result == TB_CAN_EMPTY) && is_over(&slcan->opening)) ? TB_CAN_OK : result;
}

/* ---- Steps ---- */

/* TB_CAN_OK: the step is done; TB_CAN_EMPTY: not yet; else why it cannot be. */
static tb_can_result take_step(tb_slcan *slcan)
{
    if (!slcan->opening.said) {
        tb_can_result const result = say(slcan);
        if (result != TB_CAN_OK) {
            return result;
        }
    }
    return (slcan->opening.step == CLOSE_BUS) ? hear_silence(slcan) : hear_answer(slcan);
}

static bool find_rate(uint32_t bit_rate, char *digit)
{
    for (uint8_t i = 0; i < BIT_RATES; i++) {
        if (bit_rates[i] == bit_rate) {
            *digit = (char)('0' + i);
            return true;
        }
    }
    return false;
}

tb_can_result tb_slcan_begin(tb_slcan *slcan, const char *path, uint32_t bit_rate)
{
    tb_slcan_forget(slcan);
    if (!find_rate(bit_rate, &slcan->opening.rate)) {
        return TB_CAN_BIT_RATE;
    }
    enter(&slcan->opening, CLOSE_BUS);
    tb_can_result const result = tb_serial_open(path, &slcan->device);
    return (result == TB_CAN_OK) ? TB_CAN_EMPTY : result;
}

tb_can_result tb_slcan_proceed(tb_slcan *slcan)
{
    tb_can_result result = TB_CAN_OK;
    while ((result == TB_CAN_OK) && (slcan->opening.step != OPENED)) {
        result = take_step(slcan);
        if (result == TB_CAN_OK) {
            enter(&slcan->opening, (tb_step)(slcan->opening.step + 1));
        }
    }
    if (result == TB_CAN_OK) {
        slcan->state = TB_CAN_ERROR_ACTIVE;
    } else if (result != TB_CAN_EMPTY) {
        tb_can_close(&slcan->port);
    } else {
        /* it takes its time */
    }
    return result;
}

tb_can_result tb_slcan_open(tb_slcan *slcan, const char *path, uint32_t bit_rate)
{
    tb_can_result result = tb_slcan_begin(slcan, path, bit_rate);
    while (result == TB_CAN_EMPTY) {
        tb_serial_await(slcan->device, !slcan->opening.said, LOOK_TIME);
        result = tb_slcan_proceed(slcan);
    }
    return result;
}
