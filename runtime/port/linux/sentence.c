#include "sentence.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "words.h"

const char *tb_sentence_of_state(const tb_orders *orders)
{
    const char *const phase = tb_phase_text((tb_phase)orders->phase);
    return (phase[0] != '\0') ? phase : tb_state_text((tb_state)orders->state);
}

/* Name of the bus, or of the drive that a drive or cable number stands for. */
static const char *name_of(const tb_orders *orders, const char *kind)
{
    if (strcmp(kind, "bus") == 0) {
        return (orders->culprit < TB_BUSES) ? tb_buses[orders->culprit].name : "?";
    }
    return (orders->culprit < TB_DRIVES) ? tb_drives[orders->culprit].name : "?";
}

/* The object of the dictionary that a task failed at, and how. */
static void tell_object(const tb_orders *orders, size_t room, char text[])
{
    if (orders->failure == TB_FAILURE_ABORT) {
        snprintf(text, room, ": object %04X:%02X, aborted with %08" PRIX32, orders->index,
                 orders->subindex, orders->detail);
    } else if (orders->failure == TB_FAILURE_DIFFERENT) {
        snprintf(text, room, ": object %04X:%02X, found 0x%" PRIX32, orders->index,
                 orders->subindex, orders->detail);
    } else {
        snprintf(text, room, ": object %04X:%02X, no answer", orders->index, orders->subindex);
    }
}

/* What is known beyond the cause; empty for nothing. */
static void tell_detail(const tb_orders *orders, size_t room, char text[])
{
    text[0] = '\0';
    if (orders->index != 0) {
        tell_object(orders, room, text);
    } else if (orders->cause == TB_CAUSE_DRIVE_FAULT) {
        snprintf(text, room, ": error %04" PRIX32, orders->detail);
    } else if (orders->cause == TB_CAUSE_STRANGER) {
        snprintf(text, room, ": node %" PRIu32, orders->detail);
    } else if (orders->cause == TB_CAUSE_CYCLES_MISSED) {
        snprintf(text, room, ": %" PRIu32 " cycles at once", orders->detail);
    }
}

void tb_sentence_of_cause(const tb_orders *orders, size_t room, char text[])
{
    tb_cause const cause = (tb_cause)orders->cause;
    if (cause == TB_CAUSE_NONE) {
        text[0] = '\0';
        return;
    }
    char detail[64];
    const char *const kind = tb_culprit_text(cause);
    tell_detail(orders, sizeof detail, detail);
    if (kind[0] == '\0') {
        snprintf(text, room, "%s%s", tb_cause_text(cause), detail);
    } else {
        snprintf(text, room, "%s %s: %s%s", kind, name_of(orders, kind), tb_cause_text(cause),
                 detail);
    }
}
