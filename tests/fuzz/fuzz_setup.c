/* Fuzz target: any SDO answers and boot-up messages to a drive that is set up.
 *
 * The first byte chooses drive and task. Every nine bytes after that are a step: the first says whether
 * it is an answer, what is changed in a right one, or a boot-up message, and how many cycles pass; the
 * rest is the answer. What must hold: an object passes only if its own bytes were read as they must
 * be; what is told of another one differs from what it must hold; the task ends once nothing answers. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "cob.h"
#include "little_endian.h"
#include "setup.h"

#define STEP 9u

static void require(bool condition)
{
    if (!condition) {
        __builtin_trap();
    }
}

/* The set-up, and the last answer to a read of one frame. */
typedef struct {
    tb_setup setup;
    tb_heartbeat heartbeat;
    uint8_t held[4];
    uint8_t command;
} tb_bench;

static const tb_object *objects_of(const tb_setup *setup, size_t *count)
{
    bool const checks = setup->task == TB_TASK_IDENTIFY;
    *count = checks ? setup->drive->identity_count : setup->drive->contract_count;
    return checks ? setup->drive->identity : setup->drive->contract;
}

static uint32_t value_of(const tb_setup *setup, const tb_object *object)
{
    return object->value + ((object->action == TB_OBJECT_WRITE_OF_NODE) ? setup->drive->node : 0u);
}

/* A drive that holds what it must: the answer to what is asked now. */
static void answer_rightly(const tb_bench *bench, uint8_t data[8])
{
    size_t count;
    const tb_object *const objects = objects_of(&bench->setup, &count);
    const tb_object *const object = &objects[bench->setup.entry];
    memset(data, 0, 8);
    data[0] = (bench->setup.reads != 0) ? (uint8_t)(0x43u | ((4u - object->size) << 2)) : 0x60u;
    tb_put_u16(&data[1], object->index);
    data[3] = object->subindex;
    if (bench->setup.reads != 0) {
        tb_put_u32(&data[4], value_of(&bench->setup, object));
    }
}

static uint32_t lowest_bytes(uint32_t value, uint32_t count)
{
    return (count < 4u) ? (value & ((1u << (8u * count)) - 1u)) : value;
}

/* Of an answer of one frame: of as many bytes as the object has where none are told, else of as many
 * as are told, the value or its sign carried on. */
static void check_passed(const tb_bench *bench, const tb_object *object)
{
    bool const is_told = (bench->command & 1u) != 0;
    uint32_t const count = is_told ? (4u - ((bench->command >> 2) & 3u)) : object->size;
    uint32_t const value = value_of(&bench->setup, object);
    uint32_t const sign = value >> ((8u * object->size) - 1u);
    uint32_t const carried = (sign != 0) ? ~lowest_bytes(~0u, object->size) : 0;
    uint32_t const held = lowest_bytes(tb_get_u32(bench->held), count);
    bool const is_value = held == value;
    bool const is_carried = held == lowest_bytes(value | carried, count);
    require(((bench->command & 0xE2u) != 0x42u) ||
            ((count >= object->size) && (is_value || is_carried)));
}

static void check_failure(const tb_setup *setup)
{
    size_t count;
    const tb_object *const objects = objects_of(setup, &count);
    bool const different = setup->failure == TB_FAILURE_DIFFERENT;
    require(!different || (setup->detail != value_of(setup, &objects[setup->entry])));
    require((setup->failure != TB_FAILURE_SIZE) || (setup->detail != objects[setup->entry].size));
    require(setup->failure <= TB_FAILURE_RESTARTED);
}

static void pass_cycle(tb_bench *bench)
{
    size_t count;
    const tb_object *const objects = objects_of(&bench->setup, &count);
    uint16_t const entry = bench->setup.entry;
    tb_can_frame frame;
    (void)tb_setup_frame(&bench->setup, &bench->heartbeat, &frame);
    tb_setup_advance(&bench->setup, &bench->heartbeat, true);
    require(bench->setup.entry <= count);
    if (bench->setup.entry != entry) {
        check_passed(bench, &objects[entry]);
    }
    if (bench->setup.progress == TB_TASK_FAILED) {
        check_failure(&bench->setup);
    }
    require(bench->setup.repeats <= TB_MOST_REPEATS);
}

static void take_answer(tb_bench *bench, const uint8_t data[8])
{
    tb_can_frame frame = {.id = 0x580u + bench->setup.drive->node, .length = 8};
    memcpy(frame.data, data, 8);
    bool const was_busy = bench->setup.sdo.result == TB_SDO_BUSY;
    require(tb_sdo_take(&bench->setup.sdo, &frame));
    if (was_busy && (bench->setup.sdo.result == TB_SDO_DONE)) {
        bench->command = data[0];
        memcpy(bench->held, &data[4], sizeof bench->held);
    }
}

static void take_step(tb_bench *bench, const uint8_t step[STEP])
{
    static const tb_can_frame boot = {.length = 1};
    uint8_t data[8];
    for (uint32_t i = 0; i <= ((uint32_t)step[0] >> 4); i++) {
        pass_cycle(bench);
    }
    if ((step[0] & 7u) == 7u) {
        (void)tb_heartbeat_take(&bench->heartbeat, &boot);
    } else if ((step[0] & 7u) == 6u) {
        take_answer(bench, &step[1]);
    } else if (bench->setup.progress == TB_TASK_BUSY) {
        answer_rightly(bench, data);
        data[0] ^= ((step[0] & 1u) != 0) ? (step[1] & 0x1Fu) : 0u;
        data[4u + ((step[0] >> 1) & 3u)] ^= step[2];
        take_answer(bench, data);
    } else {
        /* nobody asks */
    }
    pass_cycle(bench);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0) {
        return 0;
    }
    tb_bench bench = {.command = 0};
    tb_heartbeat_start(&bench.heartbeat);
    tb_setup_start(&bench.setup, &tb_drives[(data[0] >> 1) % TB_DRIVES]);
    tb_setup_order(&bench.setup, ((data[0] & 1u) != 0) ? TB_TASK_IDENTIFY : TB_TASK_CONFIGURE,
                   TB_MODE_NONE);
    for (size_t at = 1; (at + STEP) <= size; at += STEP) {
        take_step(&bench, &data[at]);
    }
    for (uint32_t i = 0; i <= ((TB_MOST_REPEATS + 1u) * 2u * (uint32_t)TB_ANSWER_TIMEOUT); i++) {
        pass_cycle(&bench);
    }
    require(bench.setup.progress != TB_TASK_BUSY);
    return 0;
}
