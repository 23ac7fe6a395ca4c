/* Bringing one drive into service: the tasks of the supervisor, done by NMT and SDO.
 *
 *   RESET      reset its communication; done when it booted, and did not boot again for a while
 *   IDENTIFY   read the objects of tb_drives[].identity and compare
 *   CONFIGURE  write the objects of tb_drives[].contract in their order, read each back, compare
 *   START      NMT start; done when its heartbeat says operational and it answered a SYNC
 *   MODE       write the mode of operation, wait until the drive shows it
 *
 * One frame a call, and no call waits. A task that fails says which object it was, and what of. An
 * SDO request whose answer does not come is repeated a few times: a frame may get lost.
 *
 * Boot-up messages do not tell two drives with one number from a drive that starts twice; their
 * answers do: each of the two answers every request. */
#ifndef TB_SETUP_H
#define TB_SETUP_H

#include <stdbool.h>
#include <stdint.h>

#include "drive.h"
#include "nmt.h"
#include "sdo.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The task of one drive, and what the tasks before it reached. */
typedef struct {
    const tb_drive_table *drive;
    tb_sdo_client sdo;
    tb_object switching[2]; /* TB_TASK_MODE: mode of operation, and its display */
    uint32_t waited;        /* cycles since the task began, or its NMT command was sent */
    uint32_t settled;       /* cycles since the boot-up message */
    uint32_t detail;        /* see tb_failure */
    uint16_t entry;         /* object being worked on */
    uint16_t index;         /* of the object that failed */
    uint8_t subindex;       /* of the object that failed */
    uint8_t value[8];       /* what is transferred */
    uint8_t task;           /* tb_task */
    uint8_t progress;       /* tb_progress */
    uint8_t failure;        /* tb_failure */
    uint8_t reads;          /* 1: the object is being read; 0: written */
    uint8_t repeats;        /* SDO requests of this task that were repeated */
    uint8_t boots;          /* its boot-up messages until the configuration began */
    uint8_t commanded;      /* 1: the NMT command of this task has been sent */
    uint8_t started;        /* 1: NMT start was sent: its status messages count */
    uint8_t operational;    /* 1: started, and seen to be: it gets setpoints */
    uint8_t target_mode;    /* tb_mode, ordered */
    uint8_t mode;           /* tb_mode, confirmed */
} tb_setup;

/** What an object of a drive must hold. */
uint32_t tb_setup_value(const tb_drive_table *drive, const tb_object *object);

/** A drive that nothing is known of. */
void tb_setup_start(tb_setup *setup, const tb_drive_table *drive);

/** Take up a task, if it is a new one. mode (tb_mode): for TB_TASK_MODE. */
void tb_setup_order(tb_setup *setup, tb_task task, tb_mode mode);

/** Next frame to send. False: there is none. */
bool tb_setup_frame(tb_setup *setup, tb_heartbeat *heartbeat, tb_can_frame *frame);

/** A cycle has passed: go on with the task. answered: the drive answered this cycle's SYNC. */
void tb_setup_advance(tb_setup *setup, const tb_heartbeat *heartbeat, bool answered);

#ifdef __cplusplus
}
#endif

#endif
