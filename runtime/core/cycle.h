/* What one control cycle sees, orders and tells; states, phases and requests. */
#ifndef TB_CYCLE_H
#define TB_CYCLE_H

#include <stdint.h>

#include "controller.h"
#include "drive.h"

#ifdef __cplusplus
extern "C" {
#endif

/** States of the machine: supervisor.h. */
typedef enum {
    TB_STATE_INIT = 0,
    TB_STATE_IDENTIFY,
    TB_STATE_CONFIGURE,
    TB_STATE_HOME,
    TB_STATE_TENSION,
    TB_STATE_RUN,
    TB_STATE_SOFT_STOP,
    TB_STATE_HARD_STOP,
    TB_STATE_FAULT
} tb_state;

/** Step within a state, for people. */
typedef enum {
    TB_PHASE_NONE = 0,
    /* CONFIGURE */
    TB_PHASE_CONTRACT,    /* writing and reading back the drives' objects */
    TB_PHASE_START,       /* drives become operational */
    TB_PHASE_FAULT_RESET, /* drives leave their fault state */
    TB_PHASE_READY,       /* waiting for TB_REQUEST_ARM */
    /* HOME */
    TB_PHASE_CABLE_MODE, /* cable drives to torque mode */
    TB_PHASE_CABLE_POWER,
    TB_PHASE_TIGHTEN,    /* slack is wound in, to T_min */
    TB_PHASE_TRY_CABLES, /* which way the cables' encoders count: direction.h */
    TB_PHASE_TRY_MODE,   /* base drives to torque mode */
    TB_PHASE_TRY_POWER,
    TB_PHASE_TRY_BASES, /* which way the bases' encoders count */
    TB_PHASE_TRY_RELEASE,
    TB_PHASE_BASE_MODE, /* base drives to homing mode */
    TB_PHASE_BASE_POWER,
    TB_PHASE_BASE_HOMING, /* bases run to their mechanical stops */
    TB_PHASE_BASE_RELEASE,
    TB_PHASE_BASE_WORK_MODE,
    TB_PHASE_BASE_WORK_POWER,
    TB_PHASE_GATHER, /* bases to where their sweep begins */
    TB_PHASE_SWEEP,  /* bases and tensions sweep; without rails: move the handle around */
    TB_PHASE_SOLVE,  /* computing the cables' zeros */
    /* TENSION */
    TB_PHASE_APPROACH, /* bases to where the pose wants them, slowly */
    TB_PHASE_CLOSE,    /* the measured lengths must agree */
    /* SOFT_STOP, HARD_STOP */
    TB_PHASE_RELAX,   /* cables to T_min */
    TB_PHASE_SLACKEN, /* cables to no torque */
    TB_PHASE_POWER_OFF
} tb_phase;

/* Requests; the supervisor acts on the cycle in which a bit appears. */
#define TB_REQUEST_ARM ((uint32_t)1)   /* from CONFIGURE to HOME */
#define TB_REQUEST_STOP ((uint32_t)2)  /* soft stop; acts as long as it stands */
#define TB_REQUEST_RESET ((uint32_t)4) /* from FAULT to INIT */

/** What one cycle sees. */
typedef struct {
    tb_drive_report drives[TB_DRIVES];
    tb_bus_report buses[TB_BUSES];
    real_t force[TB_DOF];      /* N, force the application wants; any value, NaN included */
    real_t hand_force[TB_DOF]; /* N, measured; read only if TB_HAND_FORCE_MEASURED */
    uint32_t hand_force_fresh; /* 1 while the force sensor delivers; else no compensation */
    uint32_t requests;
    uint32_t missed; /* cycles that were skipped since the last one */
} tb_observation;

/** What one cycle orders and tells. */
typedef struct {
    tb_drive_order drives[TB_DRIVES];
    tb_outputs controller;   /* of the controller step; all zero where it does not run */
    real_t slack[TB_CABLES]; /* m, how far each cable alone would explain the closure error */
    uint8_t beat;            /* 1: this cycle is checked and complete, the heartbeat may go out;
                                  after a hard stop began, only while every drive is off */
    uint8_t state;           /* tb_state */
    uint8_t phase;           /* tb_phase */
    uint8_t cause;           /* tb_cause, first since the last reset */
    uint16_t culprit;        /* this and the rest: tb_blame */
    uint16_t index;
    uint8_t subindex;
    uint8_t failure;
    uint32_t detail;
} tb_orders;

#ifdef __cplusplus
}
#endif

#endif
