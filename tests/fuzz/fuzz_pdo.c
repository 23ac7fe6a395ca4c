/* Fuzz target: any frames for a drive's status messages, heartbeats and power states.
 *
 * The first byte is the length of a frame, the rest its data. What must hold: only a frame of the right
 * length is taken, and then what it says is what is reported; a malformed one changes nothing; whatever
 * a drive says, the controlword is one that CiA 402 has, and resets a fault only where that is the
 * goal; from wherever a drive begins to count, its position is how far it went from there, and where
 * it is asked to be is counted as the drive counts. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "cia402.h"
#include "drive_link.h"
#include "little_endian.h"
#include "nmt.h"
#include "pdo.h"

static void require(bool condition)
{
    if (!condition) {
        __builtin_trap();
    }
}

/* What a port may claim, whether there is room for it or not. */
#define LONGEST_FRAME 64u

static tb_can_frame read_frame(uint32_t id, const uint8_t *data, size_t size)
{
    tb_can_frame frame = {.id = id};
    frame.length = (uint8_t)(data[0] % (LONGEST_FRAME + 1u));
    size_t const sent = ((size - 1u) < frame.length) ? (size - 1u) : frame.length;
    memcpy(frame.data, &data[1], (sent < sizeof frame.data) ? sent : sizeof frame.data);
    return frame;
}

static void check_status(const tb_can_frame *frame)
{
    tb_pdo_status const before = {.position = 0x12345678, .torque = -77, .statusword = 0xA5A5};
    tb_pdo_status status = before;
    bool const taken = tb_pdo_take(&status, frame);
    require(taken == (frame->length == 8u));
    if (!taken) {
        require((status.position == before.position) && (status.torque == before.torque) &&
                (status.statusword == before.statusword));
        return;
    }
    uint32_t const position = (uint32_t)status.position;
    uint16_t const torque = (uint16_t)status.torque;
    require((uint8_t)(status.statusword >> 8) == frame->data[1]);
    require((uint8_t)(position >> 24) == frame->data[5]);
    require((uint8_t)(torque >> 8) == frame->data[7]);
    require((uint8_t)torque == frame->data[6]);
}

static void check_plan(uint16_t statusword, uint16_t previous)
{
    tb_power const power = tb_cia402_power(statusword);
    require(power <= TB_POWER_FAULT);
    require(tb_cia402_homing(statusword) <= TB_HOMING_FAILED);
    for (int goal = TB_GOAL_OFF; goal <= TB_GOAL_FAULT_RESET; goal++) {
        bool const resets = goal == TB_GOAL_FAULT_RESET;
        uint16_t const word = tb_cia402_controlword(power, (tb_goal)goal, true, previous);
        require((word & ~0x9Fu) == 0);
        require(((word & TB_CONTROL_FAULT_RESET) == 0) || resets);
        require(((word & TB_CONTROL_HOMING_START) == 0) || (goal == TB_GOAL_ENABLED));
    }
}

static void check_heartbeat(const tb_can_frame *frame)
{
    tb_heartbeat heartbeat;
    tb_heartbeat_start(&heartbeat);
    bool const taken = tb_heartbeat_take(&heartbeat, frame);
    require(!taken || (frame->length == 1u));
    require(taken || ((heartbeat.state == TB_NMT_UNHEARD) && (heartbeat.boots == 0)));
    require(heartbeat.boots <= 1u);
}

static tb_can_frame status_at(uint32_t count)
{
    tb_can_frame frame = {.id = 0x180u, .length = 8, .data = {0x37u, 0x02u}};
    tb_put_u32(&frame.data[2], count);
    return frame;
}

static void check_counts(uint32_t first, uint32_t next)
{
    tb_drive_table drive = {.node = 1,
                            .mode = 1,
                            .metres_per_increment = 1,
                            .increments_per_metre = 1,
                            .kind = tb_drives[0].kind};
    tb_drive_order const order = {.goal = TB_GOAL_ENABLED, .position = 1000};
    tb_can_frame const frames[] = {status_at(first), status_at(next)};
    tb_drive_link link;
    tb_drive_report report;
    tb_can_frame setpoint;
    tb_drive_link_start(&link, &drive);
    link.setup.started = 1;
    link.setup.operational = 1;
    link.setup.mode = TB_MODE_POSITION;
    for (size_t i = 0; i < 2u; i++) {
        require(tb_drive_link_take(&link, &frames[i], true));
        tb_drive_link_report(&link, 0, true, &report);
        require(report.position == ((i == 0) ? (real_t)0 : (real_t)tb_signed_32(next - first)));
        require(tb_drive_link_setpoint(&link, &order, &setpoint));
        require(tb_get_u32(&setpoint.data[2]) == (uint32_t)(first + 1000u));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0) {
        return 0;
    }
    tb_can_frame const frame = read_frame(0x185u, data, size);
    check_status(&frame);
    check_heartbeat(&frame);
    check_counts(tb_get_u32(&frame.data[0]), tb_get_u32(&frame.data[4]));
    check_plan((uint16_t)(frame.data[0] | (frame.data[1] << 8)),
               (uint16_t)(frame.data[2] | (frame.data[3] << 8)));
    return 0;
}
