/* Why the machine stopped. docs/safety.md has what the machine does for each cause, and the user. */
#ifndef TB_CAUSE_H
#define TB_CAUSE_H

#include <stdint.h>

/** Why the machine stopped. The number in `culprit` is a drive, a cable or a bus, from 0. */
typedef enum {
    TB_CAUSE_NONE = 0,
    TB_CAUSE_REQUESTED,       /* TB_REQUEST_STOP, a signal, the end of the program */
    TB_CAUSE_DRIVE_MISSING,   /* drive: did not boot */
    TB_CAUSE_DRIVE_DIFFERENT, /* drive: identity or rating is not the machine file's */
    TB_CAUSE_DRIVE_SETUP,     /* drive: refused or changed its configuration */
    TB_CAUSE_DRIVE_TWICE,     /* drive: two nodes have its number */
    TB_CAUSE_STRANGER,        /* bus: a message of a node that the machine file does not have */
    TB_CAUSE_DRIVE_SILENT,    /* drive: status messages or heartbeat stopped */
    TB_CAUSE_DRIVE_LATE,      /* drive: status messages come too late again and again */
    TB_CAUSE_DRIVE_FAULT,     /* drive: in its fault state, or an emergency message */
    TB_CAUSE_DRIVE_STATE, /* drive: left the ordered power state, or a status unknown to CiA 402 */
    TB_CAUSE_DRIVE_STUCK, /* drive: did not reach the ordered power state or mode in time */
    TB_CAUSE_DRIVE_DEAF,  /* drive: its torque is not what it was told */
    TB_CAUSE_BUS_OFF,     /* bus: cut off, or its device has gone */
    TB_CAUSE_BUS_FULL,    /* bus: a frame could not be sent (ENOBUFS) */
    TB_CAUSE_BUS_CORRUPT, /* bus: what it delivers is malformed again and again, or kept a drive
                                   from being heard */
    TB_CAUSE_CYCLES_MISSED,      /* the loop came too late */
    TB_CAUSE_HOMING,             /* drive: homing failed or found no stop in time */
    TB_CAUSE_CALIBRATION,        /* cable zeros not observable, or the fit does not close */
    TB_CAUSE_ENCODER_JUMP,       /* drive: moved further in a cycle than anything can */
    TB_CAUSE_CABLE_SLACK,        /* cable: longer than the platform is far */
    TB_CAUSE_CABLE_BREAK,        /* cable: wound in without the platform */
    TB_CAUSE_RUNAWAY,            /* cable: faster than the machine may be */
    TB_CAUSE_CLOSURE,            /* the measured lengths disagree, no single cable explains it */
    TB_CAUSE_BASE_LOST,          /* drive: a base does not follow its target */
    TB_CAUSE_CONTROLLER,         /* the controller step failed too often: status in `detail` */
    TB_CAUSE_MEMORY,             /* the runtime's own memory was damaged */
    TB_CAUSE_BASE_RUNAWAY,       /* drive: its carriage is faster than it may be */
    TB_CAUSE_BASE_BLOCKED,       /* drive: pushed at its limit, its carriage does not move */
    TB_CAUSE_WRONG_WAY,          /* drive: its position goes against its torque */
    TB_CAUSE_ANSWERS_INCOMPLETE, /* drive: misses the cycles in which the others have answered */
    TB_CAUSE_DRIVE_LOCAL,        /* drive: says that it is not under remote control */
    TB_CAUSE_OTHER_MASTER        /* bus: another master says in `detail` what only one says */
} tb_cause;

/** A cause with what is known about it. */
typedef struct {
    uint32_t detail; /* abort code, value found, emergency code, statusword, tb_status or a count */
    uint16_t culprit; /* drive, cable or bus, from 0 */
    uint16_t index;   /* object of TB_CAUSE_DRIVE_DIFFERENT and _SETUP */
    uint8_t subindex;
    uint8_t failure; /* tb_failure of the same */
    uint8_t cause;   /* tb_cause */
} tb_blame;

#endif
