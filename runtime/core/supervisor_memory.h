/* What the supervisor remembers from cycle to cycle: one flat struct, no pointers. Its parts are
 * written by the files named below; read it for diagnosis. */
#ifndef TB_SUPERVISOR_MEMORY_H
#define TB_SUPERVISOR_MEMORY_H

#include "calibration.h"
#include "carriage.h"
#include "cause.h"
#include "cycle.h"
#include "direction.h"
#include "guide.h"
#include "measurement.h"
#include "watch.h"

/** What is remembered of a drive. */
typedef struct {
    tb_drive_order wanted; /* before the gate */
    real_t sent;           /* N m, or m where it follows a position: what the gate let through */
    real_t released;       /* N m, a cable drive's torque when the soft stop began */
    uint16_t deaf;         /* cycles in a row in which its torque was not what it was told */
    uint8_t online;        /* 1 from its first status message in service: now it is judged */
    uint8_t patience;      /* cycles until its report can show the ordered power state */
    uint8_t reached;       /* 1 once it was in the ordered power state */
    uint8_t ran;           /* 1 once its homing was seen running */
} tb_drive_memory;

/** Everything remembered from cycle to cycle. */
typedef struct {
    uint8_t state;      /* tb_state */
    uint8_t complement; /* its complement, to find damage */
    uint8_t phase;      /* tb_phase */
    uint8_t damaged;    /* 1 once damage was found: no heartbeat until the reset */
    uint32_t cycles;    /* in this phase, from 1 */
    uint32_t calm;      /* cycles in a row in which all was as the phase wants it */
    uint32_t failed;    /* controller steps failed in a row */
    uint32_t requests;  /* of the last cycle */
    tb_blame first;
    tb_drive_memory drives[TB_DRIVES];
    uint16_t corrupt[TB_BUSES]; /* faults.c */
    uint8_t spoiled[TB_BUSES];  /* 1: something malformed came in this phase */
    tb_measurement measurement;
    tb_trial trial;
    tb_carriage carriages[TB_RAIL_SLOTS];
    tb_guide guide;
    tb_calibration calibration;
    tb_watch watch;
    tb_controller controller;
    tb_outputs outputs; /* of the controller in this cycle */
    real_t slack[TB_CABLES];
} tb_supervisor;

#endif
