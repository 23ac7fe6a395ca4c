/* A drive as the supervisor sees it: what it reports, what it is ordered to do. SI units, and no
 * word about the bus that carries both.
 *
 * Drives are numbered: first the cable drives in the order of the cables, then the base drives in
 * the order of the rails. A cable drive's position is cable wound in [m], so it pulls with a torque
 * > 0 and its position grows as the cable shortens; where zero is, the calibration finds out. A
 * base drive's position is its rail coordinate [m] once it is homed. */
#ifndef TB_DRIVE_H
#define TB_DRIVE_H

#include <stdbool.h>
#include <stdint.h>

#include "runtime_version.h"
#include "tb_drives.h"
#include "tb_types.h"

/** State of a drive's power stage (CiA 402). */
typedef enum {
    TB_POWER_UNKNOWN = 0, /* no status yet, or one that CiA 402 does not know */
    TB_POWER_NOT_READY,
    TB_POWER_OFF,     /* switch on disabled */
    TB_POWER_READY,   /* ready to switch on */
    TB_POWER_ON,      /* switched on, motor not controlled */
    TB_POWER_ENABLED, /* operation enabled: torque */
    TB_POWER_QUICK_STOP,
    TB_POWER_FAULT_REACTION,
    TB_POWER_FAULT
} tb_power;

/** Where a drive's power stage shall be. */
typedef enum {
    TB_GOAL_OFF = 0,    /* no torque: disable voltage */
    TB_GOAL_READY,      /* switched on, no torque */
    TB_GOAL_ENABLED,    /* torque as ordered */
    TB_GOAL_QUICK_STOP, /* stop by the drive's own quick stop */
    TB_GOAL_FAULT_RESET /* leave the fault state, then off */
} tb_goal;

/** What a drive follows. */
typedef enum {
    TB_MODE_NONE = 0,
    TB_MODE_TORQUE,   /* cyclic synchronous torque */
    TB_MODE_POSITION, /* cyclic synchronous position */
    TB_MODE_HOMING
} tb_mode;

/** How far a homing run is. */
typedef enum {
    TB_HOMING_IDLE = 0, /* interrupted or not started */
    TB_HOMING_RUNNING,
    TB_HOMING_DONE,
    TB_HOMING_FAILED
} tb_homing;

/** What the bus is to do with a drive by acyclic messages. The order stands until it is done; the
 *  same task is done again when another one has been ordered in between. */
typedef enum {
    TB_TASK_NONE = 0,
    TB_TASK_RESET,     /* reset its communication and wait for its boot-up message */
    TB_TASK_IDENTIFY,  /* compare identity and ratings with the machine file */
    TB_TASK_CONFIGURE, /* write the contract, read it back, compare */
    TB_TASK_START,     /* make it operational: from now on it answers SYNC */
    TB_TASK_MODE       /* switch to the ordered mode, and see that it did */
} tb_task;

/** How far a task is. */
typedef enum {
    TB_TASK_IDLE = 0,
    TB_TASK_BUSY,
    TB_TASK_DONE,
    TB_TASK_FAILED /* `failure` says why */
} tb_progress;

/** Why a task failed. */
typedef enum {
    TB_FAILURE_NONE = 0,
    TB_FAILURE_SILENT,    /* no answer in time */
    TB_FAILURE_ABORT,     /* the drive aborted the transfer: `detail` is the abort code */
    TB_FAILURE_DIFFERENT, /* the object holds `detail`, not what the machine file says */
    TB_FAILURE_TWICE,     /* two drives answer for this node */
    TB_FAILURE_SIZE,      /* the object has `detail` bytes, not as many as the machine file says */
    TB_FAILURE_RESTARTED  /* it booted again while it was set up */
} tb_failure;

/** Why a drive cannot be relied on to obey. */
typedef enum {
    TB_SILENCE_NONE = 0,
    TB_SILENCE_UNHEARD, /* its heartbeat stopped, or says it is not operational */
    TB_SILENCE_LOCAL    /* it says that it is not under remote control */
} tb_silence;

/** SDO requests that are repeated in one task, where the answer does not come: for frames that got
 *  lost. A drive that is always too late takes more. */
#define TB_MOST_REPEATS 2u

/** What a drive reported until this cycle. */
typedef struct {
    real_t position;     /* m, of its last status message */
    real_t torque;       /* N m, > 0 pulls; of its last status message */
    uint16_t statusword; /* as received, for people */
    uint16_t error_code; /* emergency that stands, 0 for none */
    uint8_t error_class; /* tb_error_class of error_code */
    uint8_t power;       /* tb_power */
    uint8_t mode;        /* tb_mode that the drive confirmed last */
    uint8_t homing;      /* tb_homing; read only in TB_MODE_HOMING */
    uint8_t fresh;       /* 1 when a status message came since the last cycle */
    uint8_t age;         /* cycles since the SYNC that this message answers */
    uint8_t missed;      /* SYNCs in a row that it did not answer, not even late; stops at 255 */
    uint8_t late;        /* status messages in a row that came too late for their cycle */
    uint8_t silent;      /* tb_silence */
    uint8_t task;        /* tb_task that `progress` is about */
    uint8_t progress;    /* tb_progress */
    uint8_t failure;     /* tb_failure */
    uint8_t subindex;    /* of the object that failed */
    uint16_t index;      /* of the object that failed */
    uint32_t detail;     /* see tb_failure */
} tb_drive_report;

/** What a drive is to do in this cycle. */
typedef struct {
    real_t torque;   /* N m, gated */
    real_t position; /* m, gated; read only in TB_MODE_POSITION */
    uint8_t goal;    /* tb_goal */
    uint8_t mode;    /* tb_mode, for TB_TASK_MODE */
    uint8_t task;    /* tb_task */
    uint8_t home;    /* 1: run the homing; 0 stops it */
} tb_drive_order;

/** A stranger that says what only a master says: this, and its function code (CiA 301, table 33). */
#define TB_STRANGER_MASTER ((uint8_t)0x80)

/** How a bus is. From TB_BUS_OFF on it carries nothing. */
typedef enum {
    TB_BUS_ACTIVE = 0, /* all is well */
    TB_BUS_WARNING,    /* errors on it */
    TB_BUS_PASSIVE,    /* many errors: it may soon be off */
    TB_BUS_OFF,        /* the controller was cut off from it */
    TB_BUS_NOT_OPEN    /* closed, or its device has gone */
} tb_bus_state;

/** What a bus reported in this cycle. */
typedef struct {
    uint8_t state;     /* tb_bus_state */
    uint8_t refused;   /* frames that could not be sent since the last cycle, stops at 255 */
    uint8_t stranger;  /* a node that is not in the machine file spoke: its number, or
                          TB_STRANGER_MASTER and what it said; 0 for none */
    uint8_t malformed; /* since the last cycle: frames with the wrong length or content, and what
                          arrived and was no frame; stops at 255 */
} tb_bus_report;

#endif
