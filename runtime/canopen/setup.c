#include "setup.h"

#include <stddef.h>

#include "cia402.h"
#include "little_endian.h"

/* A drive that starts twice boots again within these; so does a second one with its number. */
#define SETTLE_CYCLES 50u

static const tb_setup unknown;

static void clear_sdo(tb_setup *setup)
{
    tb_sdo_start(&setup->sdo, setup->drive->node, (uint32_t)TB_ANSWER_TIMEOUT);
}

/* ---- Ends of a task ---- */

static void finish(tb_setup *setup)
{
    setup->progress = TB_TASK_DONE;
}

static void fail(tb_setup *setup, tb_failure failure, uint32_t detail)
{
    setup->progress = TB_TASK_FAILED;
    setup->failure = (uint8_t)failure;
    setup->detail = detail;
}

static void fail_at(tb_setup *setup, const tb_object *object, tb_failure failure, uint32_t detail)
{
    setup->index = object->index;
    setup->subindex = object->subindex;
    fail(setup, failure, detail);
}

/* ---- Objects: IDENTIFY, CONFIGURE, MODE ---- */

static const tb_object *objects_of(const tb_setup *setup)
{
    switch (setup->task) {
    case TB_TASK_IDENTIFY:
        return setup->drive->identity;
    case TB_TASK_CONFIGURE:
        return setup->drive->contract;
    default:
        return setup->switching;
    }
}

static uint16_t count_of(const tb_setup *setup)
{
    switch (setup->task) {
    case TB_TASK_IDENTIFY:
        return setup->drive->identity_count;
    case TB_TASK_CONFIGURE:
        return setup->drive->contract_count;
    default:
        return 2;
    }
}

uint32_t tb_setup_value(const tb_drive_table *drive, const tb_object *object)
{
    bool const is_of_node = object->action == TB_OBJECT_WRITE_OF_NODE;
    return object->value + (is_of_node ? drive->node : 0u);
}

static void read_object(tb_setup *setup, const tb_object *object)
{
    setup->reads = 1;
    tb_sdo_upload(&setup->sdo, object->index, object->subindex, setup->value, sizeof setup->value);
}

static void write_object(tb_setup *setup, const tb_object *object)
{
    setup->reads = 0;
    tb_put_u32(setup->value, tb_setup_value(setup->drive, object));
    tb_sdo_download(&setup->sdo, object->index, object->subindex, setup->value, object->size);
}

/* The request that was not answered, once more: what was written may be written again. */
static bool repeat(tb_setup *setup, const tb_object *object)
{
    if (setup->repeats == TB_MOST_REPEATS) {
        return false;
    }
    setup->repeats++;
    if (setup->reads != 0) {
        read_object(setup, object);
    } else {
        write_object(setup, object);
    }
    return true;
}

static void begin_object(tb_setup *setup)
{
    if (setup->entry == count_of(setup)) {
        setup->mode = (setup->task == TB_TASK_MODE) ? setup->target_mode : setup->mode;
        finish(setup);
        return;
    }
    const tb_object *const object = &objects_of(setup)[setup->entry];
    if (object->action == TB_OBJECT_CHECK) {
        read_object(setup, object);
    } else {
        write_object(setup, object);
    }
}

/* ---- What an object holds ---- */

/* Of the first bytes that were read, four at most; the rest of value is from another transfer. */
static uint32_t value_of(const tb_setup *setup, uint32_t count)
{
    uint8_t bytes[4] = {0};
    for (size_t i = 0; (i < sizeof bytes) && (i < count); i++) {
        bytes[i] = setup->value[i];
    }
    return tb_get_u32(bytes);
}

/* Whether the bytes beyond the object's own say nothing: undefined ones, where the drive did not
 * say how many there are, or zeros, or the sign of the value. */
static bool is_padded(const tb_setup *setup, const tb_object *object)
{
    bool const is_negative = (setup->value[object->size - 1u] & 0x80u) != 0;
    bool zeros = true;
    bool signs = is_negative;
    for (size_t i = object->size; i < setup->sdo.done; i++) {
        zeros = zeros && (setup->value[i] == 0x00u);
        signs = signs && (setup->value[i] == 0xFFu);
    }
    return (setup->sdo.sized == 0) || zeros || signs;
}

/* How an object that was read differs from what it must hold, and in what. */
static tb_failure examine(const tb_setup *setup, const tb_object *object, uint32_t *detail)
{
    uint32_t const wanted = tb_setup_value(setup->drive, object);
    uint32_t const count = setup->sdo.done;
    bool const is_whole = count >= object->size;
    bool const is_padding = is_whole && is_padded(setup, object);
    if (!is_whole || ((count > sizeof object->value) && !is_padding)) {
        *detail = count;
        return TB_FAILURE_SIZE;
    }
    *detail = value_of(setup, is_padding ? object->size : count);
    return (*detail == wanted) ? TB_FAILURE_NONE : TB_FAILURE_DIFFERENT;
}

/* A drive may show its new mode a little after it took the order; the order reads back at once. */
static bool may_change(const tb_setup *setup, const tb_object *object)
{
    return (object->index == TB_OBJECT_MODE_DISPLAY) &&
           (setup->waited <= (uint32_t)TB_STATE_TIMEOUT);
}

static void compare(tb_setup *setup, const tb_object *object)
{
    uint32_t detail;
    tb_failure const failure = examine(setup, object, &detail);
    if (failure == TB_FAILURE_NONE) {
        setup->entry++;
        begin_object(setup);
    } else if (may_change(setup, object)) {
        read_object(setup, object);
    } else {
        fail_at(setup, object, failure, detail);
    }
}

static void transferred(tb_setup *setup, const tb_object *object)
{
    if (setup->reads != 0) {
        compare(setup, object);
    } else {
        read_object(setup, object);
    }
}

static void advance_objects(tb_setup *setup)
{
    const tb_object *const object = &objects_of(setup)[setup->entry];
    switch (setup->sdo.result) {
    case TB_SDO_DONE:
        transferred(setup, object);
        break;
    case TB_SDO_REFUSED:
    case TB_SDO_BROKEN:
        fail_at(setup, object, TB_FAILURE_ABORT, setup->sdo.code);
        break;
    case TB_SDO_SILENT:
        if (!repeat(setup, object)) {
            fail_at(setup, object, TB_FAILURE_SILENT, 0);
        }
        break;
    default:
        break; /* under way */
    }
}

/* ---- NMT: RESET, START ---- */

static bool is_overdue(const tb_setup *setup)
{
    return setup->waited > (uint32_t)TB_STATE_TIMEOUT;
}

/* A drive may boot late, and once more after that; but not again and again. */
static void advance_reset(tb_setup *setup, const tb_heartbeat *heartbeat, bool restarted)
{
    bool const booted = (setup->commanded != 0) && (heartbeat->boots > 0);
    setup->settled = (restarted ? 0 : setup->settled) + (booted ? 1u : 0u);
    if (setup->settled > SETTLE_CYCLES) {
        clear_sdo(setup);
        finish(setup);
    } else if (!booted && is_overdue(setup)) {
        fail(setup, TB_FAILURE_SILENT, 0);
    } else if (setup->waited > (2u * (uint32_t)TB_STATE_TIMEOUT)) {
        fail(setup, TB_FAILURE_RESTARTED, 0);
    } else {
        /* it may still boot */
    }
}

static void advance_start(tb_setup *setup, const tb_heartbeat *heartbeat, bool answered)
{
    if (answered && (heartbeat->state == TB_NMT_OPERATIONAL)) {
        setup->operational = 1;
        finish(setup);
    } else if (is_overdue(setup)) {
        fail(setup, TB_FAILURE_SILENT, 0);
    } else {
        /* a heartbeat takes its time */
    }
}

static bool is_nmt(const tb_setup *setup)
{
    return (setup->task == TB_TASK_RESET) || (setup->task == TB_TASK_START);
}

static tb_can_frame command(tb_setup *setup, tb_heartbeat *heartbeat)
{
    setup->commanded = 1;
    setup->waited = 0;
    if (setup->task == TB_TASK_START) {
        setup->started = 1;
        return tb_nmt_frame(TB_NMT_START, setup->drive->node);
    }
    tb_heartbeat_start(heartbeat);
    return tb_nmt_frame(TB_NMT_RESET_COMMUNICATION, setup->drive->node);
}

/* ---- The task ---- */

static void forget_service(tb_setup *setup)
{
    clear_sdo(setup);
    setup->started = 0;
    setup->operational = 0;
    setup->mode = TB_MODE_NONE;
}

static void prepare_mode(tb_setup *setup)
{
    uint8_t const mode = setup->drive->kind->modes[setup->target_mode];
    tb_object const ordered = {TB_OBJECT_MODE, 0, 1, TB_OBJECT_WRITE, mode};
    tb_object const shown = {TB_OBJECT_MODE_DISPLAY, 0, 1, TB_OBJECT_CHECK, mode};
    setup->switching[0] = ordered;
    setup->switching[1] = shown;
    setup->mode = TB_MODE_NONE;
}

static void begin(tb_setup *setup)
{
    tb_sdo_cancel(&setup->sdo);
    setup->progress = TB_TASK_BUSY;
    setup->failure = TB_FAILURE_NONE;
    setup->index = 0;
    setup->subindex = 0;
    setup->detail = 0;
    setup->entry = 0;
    setup->waited = 0;
    setup->settled = 0;
    setup->commanded = 0;
    setup->repeats = 0;
    if (setup->task == TB_TASK_NONE) {
        setup->progress = TB_TASK_IDLE;
    } else if (setup->task == TB_TASK_RESET) {
        forget_service(setup);
    } else if (setup->task == TB_TASK_MODE) {
        prepare_mode(setup);
        begin_object(setup);
    } else if (setup->task != TB_TASK_START) {
        begin_object(setup);
    } else {
        /* TB_TASK_START has no object to write: tb_setup_frame sends its NMT command */
    }
}

void tb_setup_start(tb_setup *setup, const tb_drive_table *drive)
{
    *setup = unknown;
    setup->drive = drive;
    clear_sdo(setup);
}

void tb_setup_order(tb_setup *setup, tb_task task, tb_mode mode)
{
    bool const is_other_mode = (task == TB_TASK_MODE) && (mode != setup->target_mode);
    if ((task != setup->task) || is_other_mode) {
        setup->task = (uint8_t)task;
        setup->target_mode = (uint8_t)mode;
        begin(setup);
    }
}

bool tb_setup_frame(tb_setup *setup, tb_heartbeat *heartbeat, tb_can_frame *frame)
{
    if (is_nmt(setup) && (setup->progress == TB_TASK_BUSY) && (setup->commanded == 0)) {
        *frame = command(setup, heartbeat);
        return true;
    }
    return tb_sdo_frame(&setup->sdo, frame);
}

/* More answers than one drive gives; those to requests from before the reset are an older story. */
static bool is_twice(const tb_setup *setup)
{
    return (setup->task != TB_TASK_RESET) && (setup->sdo.extra > 0);
}

/* A drive that boots has forgotten what was written. */
static bool is_configured(const tb_setup *setup)
{
    return (setup->task == TB_TASK_CONFIGURE) || (setup->task == TB_TASK_START) ||
           (setup->task == TB_TASK_MODE);
}

/* It booted again since the last cycle; once it is being configured: at any time since. */
static bool has_restarted(tb_setup *setup, const tb_heartbeat *heartbeat)
{
    bool const restarted = heartbeat->boots != setup->boots;
    setup->boots = is_configured(setup) ? setup->boots : heartbeat->boots;
    return restarted;
}

void tb_setup_advance(tb_setup *setup, const tb_heartbeat *heartbeat, bool answered)
{
    bool const restarted = has_restarted(setup, heartbeat);
    tb_sdo_tick(&setup->sdo);
    if (setup->progress != TB_TASK_BUSY) {
        return;
    }
    setup->waited++;
    if (is_twice(setup)) {
        fail(setup, TB_FAILURE_TWICE, 0);
    } else if (restarted && is_configured(setup)) {
        fail(setup, TB_FAILURE_RESTARTED, 0);
    } else if (setup->task == TB_TASK_RESET) {
        advance_reset(setup, heartbeat, restarted);
    } else if (setup->task == TB_TASK_START) {
        advance_start(setup, heartbeat, answered);
    } else {
        advance_objects(setup);
    }
}
