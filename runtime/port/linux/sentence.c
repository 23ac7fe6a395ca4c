#include "sentence.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "calibration.h"
#include "cia402.h"
#include "cob.h"
#include "drive_kind.h"
#include "setup.h"
#include "words.h"

const char *tb_sentence_of_state(const tb_orders *orders)
{
    const char *const phase = tb_phase_text((tb_phase)orders->phase);
    return (phase[0] != '\0') ? phase : tb_state_text((tb_state)orders->state);
}

/* The bus, or the drive of a cable or a number; with its place on the buses. */
static void tell_culprit(const tb_orders *orders, const char *kind, size_t room, char text[])
{
    uint16_t const number = orders->culprit;
    if (kind[0] == '\0') {
        text[0] = '\0';
    } else if ((strcmp(kind, "bus") == 0) && (number < TB_BUSES)) {
        snprintf(text, room, "bus %s: ", tb_buses[number].name);
    } else if (number < TB_DRIVES) {
        const tb_drive_table *const drive = &tb_drives[number];
        snprintf(text, room, "%s %s (bus %s, node %u): ", kind, drive->name,
                 tb_buses[drive->bus].name, (unsigned)drive->node);
    } else {
        snprintf(text, room, "%s %u: ", kind, (unsigned)number);
    }
}

/* The kind of the drive that is to blame; of another number the first one's. */
static const tb_drive_kind *kind_of(const tb_orders *orders)
{
    return tb_drives[(orders->culprit < TB_DRIVES) ? orders->culprit : 0].kind;
}

/* What the machine file wants of an object. Some are written more than once: the first that it does
 * not hold. */
static const tb_object *find_object(const tb_drive_table *drive, const tb_object objects[],
                                    size_t count, const tb_orders *orders)
{
    bool const is_size = orders->failure == TB_FAILURE_SIZE;
    for (size_t i = 0; i < count; i++) {
        const tb_object *const object = &objects[i];
        uint32_t const wanted = is_size ? object->size : tb_setup_value(drive, object);
        bool const differs = orders->detail != wanted;
        if ((object->index == orders->index) && (object->subindex == orders->subindex) && differs) {
            return object;
        }
    }
    return NULL;
}

static const tb_object *wanted_object(const tb_orders *orders)
{
    if (orders->culprit >= TB_DRIVES) {
        return NULL;
    }
    const tb_drive_table *const drive = &tb_drives[orders->culprit];
    const tb_object *const object =
        find_object(drive, drive->identity, drive->identity_count, orders);
    return (object != NULL) ? object
                            : find_object(drive, drive->contract, drive->contract_count, orders);
}

/* The mode that a drive was told to take, or to show; the contract's comes before anyone orders one. */
static bool is_of_mode(const tb_orders *orders)
{
    bool const is_mode =
        (orders->index == TB_OBJECT_MODE) || (orders->index == TB_OBJECT_MODE_DISPLAY);
    return is_mode && (orders->culprit < TB_DRIVES) &&
           (orders->drives[orders->culprit].mode != TB_MODE_NONE);
}

static void tell_difference(const tb_orders *orders, size_t room, char text[])
{
    const tb_object *const wanted = wanted_object(orders);
    if (is_of_mode(orders)) {
        uint8_t const mode = kind_of(orders)->modes[orders->drives[orders->culprit].mode];
        snprintf(text, room, ": object %04X:%02X holds 0x%" PRIX32 ", it was told 0x%X",
                 orders->index, orders->subindex, orders->detail, (unsigned)mode);
    } else if (wanted == NULL) {
        snprintf(text, room, ": object %04X:%02X holds 0x%" PRIX32, orders->index, orders->subindex,
                 orders->detail);
    } else {
        snprintf(text, room,
                 ": object %04X:%02X holds 0x%" PRIX32 ", the machine file says 0x%" PRIX32,
                 orders->index, orders->subindex, orders->detail,
                 tb_setup_value(&tb_drives[orders->culprit], wanted));
    }
}

static void tell_size(const tb_orders *orders, size_t room, char text[])
{
    const tb_object *const wanted = wanted_object(orders);
    unsigned const bytes = (wanted == NULL) ? 1u : wanted->size; /* a mode has one */
    snprintf(text, room, ": object %04X:%02X has %" PRIu32 " %s, the machine file says %u",
             orders->index, orders->subindex, orders->detail,
             (orders->detail == 1u) ? "byte" : "bytes", bytes);
}

/* The object of the dictionary that a task failed at, and how. */
static void tell_object(const tb_orders *orders, size_t room, char text[])
{
    if (orders->failure == TB_FAILURE_ABORT) {
        snprintf(text, room, ": object %04X:%02X, aborted with %08" PRIX32 " (%s)", orders->index,
                 orders->subindex, orders->detail,
                 tb_drive_kind_abort_text(kind_of(orders), orders->detail));
    } else if (orders->failure == TB_FAILURE_DIFFERENT) {
        tell_difference(orders, room, text);
    } else if (orders->failure == TB_FAILURE_SIZE) {
        tell_size(orders, room, text);
    } else {
        snprintf(text, room, ": object %04X:%02X, no answer", orders->index, orders->subindex);
    }
}

/* What only a master says, by its function code. */
static const char *master_message(uint32_t function)
{
    switch (function << TB_COB_NODE_BITS) {
    case TB_COB_NMT:
        return "an NMT command";
    case TB_COB_SYNC:
        return "SYNC";
    case TB_COB_TIME:
        return "TIME";
    case TB_COB_SDO_REQUEST:
        return "an SDO request";
    case TB_COB_ERROR_CONTROL:
        return "a master's heartbeat";
    default:
        return "setpoints";
    }
}

/* How a task failed at no object in particular. */
static void tell_task(const tb_orders *orders, size_t room, char text[])
{
    if (orders->failure == TB_FAILURE_RESTARTED) {
        snprintf(text, room,
                 ": it booted again; its supply failed, or another drive has its number");
    } else if (orders->cause == TB_CAUSE_DRIVE_SETUP) {
        snprintf(text, room, ": it did not become operational");
    } else {
        text[0] = '\0';
    }
}

/* What is known beyond the cause; empty for nothing. */
static void tell_detail(const tb_orders *orders, size_t room, char text[])
{
    if (orders->index != 0) {
        tell_object(orders, room, text);
    } else if (orders->cause == TB_CAUSE_DRIVE_FAULT) {
        snprintf(text, room, ": error %04" PRIX32 " (%s)", orders->detail,
                 tb_drive_kind_error_text(kind_of(orders), (uint16_t)orders->detail));
    } else if (orders->cause == TB_CAUSE_STRANGER) {
        snprintf(text, room, ": of node %" PRIu32, orders->detail);
    } else if (orders->cause == TB_CAUSE_OTHER_MASTER) {
        snprintf(text, room, ": it sent %s", master_message(orders->detail));
    } else if (orders->cause == TB_CAUSE_CALIBRATION) {
        snprintf(text, room, "%s",
                 (orders->detail == (uint32_t)TB_CALIBRATION_OPEN)
                     ? ": the lengths do not close; an encoder counts wrongly, or pulleys, "
                       "rails or anchors are not as in the machine file"
                     : ": the poses do not tell them apart");
    } else if (orders->cause == TB_CAUSE_CYCLES_MISSED) {
        snprintf(text, room, ": %" PRIu32 " cycles at once", orders->detail);
    } else {
        tell_task(orders, room, text);
    }
}

void tb_sentence_of_cause(const tb_orders *orders, size_t room, char text[])
{
    tb_cause const cause = (tb_cause)orders->cause;
    const char *const advice = tb_advice_text(cause);
    tell_culprit(orders, tb_culprit_text(cause), room, text);
    size_t used = strlen(text);
    snprintf(text + used, room - used, "%s", tb_cause_text(cause));
    used = strlen(text);
    tell_detail(orders, room - used, text + used);
    used = strlen(text);
    snprintf(text + used, room - used, "%s%s", (advice[0] == '\0') ? "" : "; ", advice);
}
