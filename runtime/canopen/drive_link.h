/* The connection to one drive: its messages in, its setpoints and set-up messages out.
 *
 * A drive counts modulo 2^32, from wherever it stood at power-on. Its position is the difference from
 * its first count in service, so that no start value and no number of turns costs digits or jumps. A
 * drive that homes knows where it is: from its homing mode on its own count, signed, is its position. */
#ifndef TB_DRIVE_LINK_H
#define TB_DRIVE_LINK_H

#include <stdbool.h>
#include <stdint.h>

#include "can.h"
#include "drive.h"
#include "emcy.h"
#include "nmt.h"
#include "pdo.h"
#include "setup.h"

#ifdef __cplusplus
extern "C" {
#endif

/** One drive on its bus. */
typedef struct {
    const tb_drive_table *drive;
    tb_setup setup;
    tb_heartbeat heartbeat;
    tb_emcy emergency;
    tb_pdo_status status; /* of its last status message */
    uint32_t duplicates;  /* status messages beyond one a SYNC; the last one counts */
    int32_t origin;       /* increments at which its position is zero: first seen, or home */
    uint16_t controlword; /* sent last */
    uint8_t power;        /* tb_power of the last status message */
    uint8_t has_origin;   /* 1: it told a position in service */
    uint8_t answered;     /* 1: a status message came since the last SYNC, late or not */
    uint8_t fresh;        /* 1: one came in time since the last report */
    uint8_t missed;       /* SYNCs in a row without an answer */
    uint8_t late;         /* answers in a row that came too late */
    uint8_t booted;       /* 1: a boot-up message came since the last report */
    uint8_t most_late;    /* the most of them since the last report */
    uint8_t homing_syncs; /* SYNCs since homing was started; stops at 255 */
} tb_drive_link;

/** A drive that nothing is known of. */
void tb_drive_link_start(tb_drive_link *link, const tb_drive_table *drive);

/** Read a message from the drive. in_time: it answers the last SYNC before the next one is due.
 *  False: malformed, and ignored. */
bool tb_drive_link_take(tb_drive_link *link, const tb_can_frame *frame, bool in_time);

/** A cycle begins; is_synced: with a SYNC on the drive's bus. */
void tb_drive_link_sync(tb_drive_link *link, bool is_synced);

/** All messages of the cycle are read: go on with the task, report. age: cycles since the last SYNC;
 *  is_over: the next cycle begins with another one, so what has not come by now is missing. */
void tb_drive_link_report(tb_drive_link *link, uint8_t age, bool is_over, tb_drive_report *report);

/** Setpoint for the next SYNC. False: the drive is not in service yet. */
bool tb_drive_link_setpoint(tb_drive_link *link, const tb_drive_order *order, tb_can_frame *frame);

/** Next frame of the drive's task. False: there is none. */
bool tb_drive_link_acyclic(tb_drive_link *link, tb_can_frame *frame);

#ifdef __cplusplus
}
#endif

#endif
