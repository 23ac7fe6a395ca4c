/* Controller step: measurements in, torques and forces out, once every TB_PERIOD seconds.
 *
 * One cycle does, in this order:
 *   1. location: cable lengths, rail coordinates and their filtered rates -> pose and velocity
 *   2. wanted force: virtual walls (Yoon eqs 26, 27) + the force the application asks for
 *   3. tension distribution: wanted force -> cable tensions within the bounds (Yoon eqs 22, 23)
 *   4. disturbance observer (Yoon Fig. 11, eq. 24), when the machine has one
 *   5. motor torque: drum radius x tension + compensation
 *   6. bases: targets from the pose, PID -> force on every carriage
 *   7. the torque gate: the only way to a motor
 *
 * Pure: everything the step remembers is in tb_controller; no input or output, no heap, no global
 * state, no floating-point library. The same inputs from the same memory give the same outputs.
 *
 * A cycle FAILS when its inputs or a result are outside their domain (status other than TB_OK and
 * TB_INFEASIBLE). Then the outputs are safe: every cable goes to its minimum tension, no faster
 * than the gate's rate; the carriages get no force. The memory keeps what the last good cycle
 * knew, and the next good cycle continues from it without a jump. How long failures may last, and
 * what follows, is the supervisor's decision: it stops the machine or calls tb_controller_start.
 *
 * The compensation of a disturbance is limited to what TB_TORQUE_LIMIT leaves above the torque of
 * TB_TENSION_MAX, in both directions: a wrong estimate can slacken no cable by more than that.
 *
 * TB_INFEASIBLE is a good cycle: the cables deliver as much of the wanted force as the machine's
 * tension policy gives; `delivered` says how much.
 *
 * Where the pose has no closed form, its search begins at the pose of the last good cycle; one that
 * ends without a pose (TB_INACCURATE) or at a singular one is a failed cycle like any other.
 *
 * Arrays: cables in the order of the machine file; rails in the order of the cables that have one
 * (a machine without rails keeps one unread slot, filled with 0). A platform that turns adds to
 * positions [m] its rotation [rad], to velocities [m/s] its spin [rad/s], to forces [N] moments
 * about its centre [N m]. */
#ifndef TB_CONTROLLER_H
#define TB_CONTROLLER_H

#include <stdint.h>

#include "runtime_version.h"
#include "tb_machine.h"
#include "tb_types.h"
#include "torque_gate.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TB_OBSERVER_MEMORY 5 /* numbers that tb_observe_disturbance remembers of each cable */
#define TB_BASE_MEMORY 3     /* numbers that tb_base_pid remembers of each rail */

/* Options of one cycle, to be added up; 0 is normal operation. */
#define TB_OPTION_UNCOMPENSATED ((uint32_t)1) /* estimate the disturbance, do not compensate it */

/** What one cycle reads. */
typedef struct {
    real_t lengths[TB_CABLES];   /* m, measured cable lengths */
    real_t rails[TB_RAIL_SLOTS]; /* m, measured rail coordinates */
    real_t force[TB_DOF];        /* N, force on the platform that the application wants */
    real_t hand_force[TB_DOF];   /* N, measured force of the hand on the handle; read only if
                                      TB_HAND_FORCE_MEASURED, and refused beyond what all cables
                                      together can pull */
    uint32_t options;            /* sum of TB_OPTION_... */
} tb_inputs;

/** What one cycle gives. Always finite. */
typedef struct {
    real_t pose[TB_DOF];               /* m; after a failed cycle the last good pose */
    real_t velocity[TB_DOF];           /* m/s, filtered */
    real_t residual;                   /* m, norm of measured minus computed lengths: how far the
                                        redundant measurements disagree (slack, encoder fault) */
    real_t wanted_force[TB_DOF];       /* N, walls + application */
    real_t delivered_force[TB_DOF];    /* N, what the commanded tensions give */
    real_t tension[TB_CABLES];         /* N, commanded */
    real_t disturbance[TB_CABLES];     /* N m, estimated at each motor, 0 without an observer */
    real_t motor_torque[TB_CABLES];    /* N m, gated: what to send to the cable motors, > 0 pulls */
    real_t rail_target[TB_RAIL_SLOTS]; /* m, wanted rail coordinates */
    real_t rail_force[TB_RAIL_SLOTS];  /* N, force to apply to each carriage along its rail */
    real_t rail_torque[TB_RAIL_SLOTS]; /* N m, the same at the pinion: what to send */
    uint32_t gate[TB_CABLES];          /* flags of the torque gate, see torque_gate.h */
    int32_t status;                    /* tb_status that the step returned */
} tb_outputs;

/** What the controller remembers from cycle to cycle. Read it for diagnosis; never write it. */
typedef struct {
    real_t pose[TB_DOF];                             /* m */
    real_t lengths[TB_CABLES];                       /* m */
    real_t length_rates[TB_CABLES];                  /* m/s, filtered */
    real_t rails[TB_RAIL_SLOTS];                     /* m */
    real_t rail_rates[TB_RAIL_SLOTS];                /* m/s, filtered */
    real_t observer[TB_CABLES * TB_OBSERVER_MEMORY]; /* rows: see tb_observe_disturbance */
    real_t base[TB_RAIL_SLOTS * TB_BASE_MEMORY];     /* rows: see tb_base_pid */
    real_t torque[TB_CABLES];                        /* N m, let through in the last cycle */
    uint32_t interrupted;                            /* 1 until a good cycle follows */
} tb_controller;

/** Start at rest, with no torque on any motor; the first cycles raise it at the gate's rate.
 *  Where the pose has no closed form (tb_machine.h has TB_START_POSE) it is searched from there: the
 *  platform should be near the target's centre, and about upright.
 *  lengths [m] (TB_CABLES), rails [m] (TB_RAIL_SLOTS): the measurements at this moment.
 *  Returns the status of their forward kinematics. When it is not TB_OK the controller is started
 *  all the same: its cycles fail safely until a good measurement comes. */
tb_status tb_controller_start(tb_controller *controller, const real_t lengths[TB_CABLES],
                              const real_t rails[TB_RAIL_SLOTS]);

/** Tell the controller what the motors did while others decided it, so that it goes on from there.
 *  torque [N m] (TB_CABLES): what the cable motors were given in the last cycle.
 *  base (TB_RAIL_SLOTS * TB_BASE_MEMORY): memory of the tb_base_pid that moved the bases. */
void tb_controller_take_over(tb_controller *controller, const real_t torque[TB_CABLES],
                             const real_t base[TB_RAIL_SLOTS * TB_BASE_MEMORY]);

/** Run one cycle. Call it every TB_PERIOD seconds, with fresh measurements.
 *  Returns TB_OK, TB_INFEASIBLE, or why the cycle failed; all outputs are written in every case. */
tb_status tb_controller_step(tb_controller *controller, const tb_inputs *inputs,
                             tb_outputs *outputs);

#ifdef __cplusplus
}
#endif

#endif
