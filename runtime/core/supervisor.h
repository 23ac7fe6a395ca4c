/* Supervisor: brings the machine from power-on to work and from anything wrong to a safe state.
 *
 *   INIT        reset the drives' communication; every drive of the machine file must answer
 *   IDENTIFY    identity, ratings: as the machine file says
 *   CONFIGURE   write and read back every drive's contract; then wait for TB_REQUEST_ARM, no torque
 *   HOME        cables at T_min; the counting direction of every encoder: direction.h; all bases to
 *               their mechanical stops at once (Yoon III-E), because a base without torque would be
 *               pulled away while another base homes; then the cables' zeros: calibration.h
 *   TENSION     controller on, forces of the application off; closure must hold
 *   RUN         forces of walls and application
 *   SOFT_STOP   forces to zero, all cables together to T_min, then together to no torque, off
 *   HARD_STOP   all cables together to no torque at the gate's rate, off
 *   FAULT       no torque; the first cause stands until TB_REQUEST_RESET leads to INIT
 *
 * A stop that was asked for ends in CONFIGURE and takes a new TB_REQUEST_ARM; every other cause
 * ends in FAULT. Requests are edges: a request that stands does not arm again. The first fault
 * stands until the reset, but takes the place of TB_CAUSE_REQUESTED, which is no fault.
 * No cable pulls while another one that should pull cannot: whatever stops one drive stops all.
 *
 * Pure, as the controller step is: one call a cycle, everything remembered is in tb_supervisor.
 * The same observations from the same memory give the same orders, to the bit: recorder.h. */
#ifndef TB_SUPERVISOR_H
#define TB_SUPERVISOR_H

#include "cycle.h"
#include "supervisor_memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Begin in INIT, without torque. */
void tb_supervisor_start(tb_supervisor *supervisor);

/** Run one cycle; all orders are written. */
void tb_supervisor_step(tb_supervisor *supervisor, const tb_observation *seen, tb_orders *orders);

#ifdef __cplusplus
}
#endif

#endif
