#include "setup.h"

#include <stddef.h>

#include "cia402.h"
#include "little_endian.h"

#define SETTLE_CYCLES 50u /* a second drive with the same number boots within them */

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

static void read_object(tb_setup *setup, const tb_object *object)
{
    setup->reads = 1;
    tb_sdo_upload(&setup->sdo, object->index, object->subindex, setup->value,
                  sizeof setup->value);
}

static void write_object(tb_setup *setup, const tb_object *object)
{
    setup->reads = 0;
    tb_put_u32(setup->value, object->value);
    tb_sdo_download(&setup->sdo, object->index, object->subindex, setup->value, object->size);
}

static void begin_object(tb_setup *setup)
{
    if (setup->entry == count_of(setup)) {
        setup->mode = (setup->task == TB_TASK_MODE) ? setup->target_mode : setup->mode;
        finish(setup);
        return;
    }
    const tb_object *const object = &objects_of(setup)[setup->entry];
    if (object->action == TB_OBJECT_WRITE) {
        write_object(setup, object);
    } else {
        read_object(setup, object);
    }
}

/* Of the bytes that were read; the rest of value is from another transfer. */
static uint32_t found_value(const tb_setup *setup)
{
    uint8_t bytes[4] = {0};
    for (size_t i = 0; (i < sizeof bytes) && (i < setup->sdo.done); i++) {
        bytes[i] = setup->value[i];
    }
    return tb_get_u32(bytes);
}

/* A drive may show a new mode a little after it took it. */
static bool may_change(const tb_setup *setup)
{
    return (setup->task == TB_TASK_MODE) && (setup->waited <= (uint32_t)TB_STATE_TIMEOUT);
}

static void compare(tb_setup *setup, const tb_object *object)
{
    uint32_t const found = found_value(setup);
    if ((setup->sdo.done == object->size) && (found == object->value)) {
        setup->entry++;
        begin_object(setup);
    } else if (may_change(setup)) {
        read_object(setup, object);
    } else {
        fail_at(setup, object, TB_FAILURE_DIFFERENT, found);
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
        fail_at(setup, object, TB_FAILURE_SILENT, 0);
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

static void advance_reset(tb_setup *setup, const tb_heartbeat *heartbeat)
{
    bool const booted = (setup->commanded != 0) && (heartbeat->boots > 0);
    setup->settled += booted ? 1 : 0;
    if (setup->settled > SETTLE_CYCLES) {
        clear_sdo(setup);
        finish(setup);
    } else if (!booted && is_overdue(setup)) {
        fail(setup, TB_FAILURE_SILENT, 0);
    } else {
        /* it may still boot, and so may a second drive */
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
    uint8_t const mode = tb_cia402_mode((tb_mode)setup->target_mode);
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
        /* START: only a command to send */
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

/* More answers or boot-up messages than one drive gives. What comes before the reset is an older
 * story, and so are answers to requests from before it. */
static bool is_twice(const tb_setup *setup, const tb_heartbeat *heartbeat)
{
    if (setup->task == TB_TASK_RESET) {
        return (setup->commanded != 0) && (heartbeat->boots > 1);
    }
    return (setup->sdo.extra > 0) || (heartbeat->boots > 1);
}

void tb_setup_advance(tb_setup *setup, const tb_heartbeat *heartbeat, bool answered)
{
    tb_sdo_tick(&setup->sdo);
    if (setup->progress != TB_TASK_BUSY) {
        return;
    }
    setup->waited++;
    if (is_twice(setup, heartbeat)) {
        fail(setup, TB_FAILURE_TWICE, 0);
    } else if (setup->task == TB_TASK_RESET) {
        advance_reset(setup, heartbeat);
    } else if (setup->task == TB_TASK_START) {
        advance_start(setup, heartbeat, answered);
    } else {
        advance_objects(setup);
    }
}
