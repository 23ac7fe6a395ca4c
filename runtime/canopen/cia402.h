/* Drive profile CiA 402: power states from statuswords, controlwords towards a goal. Stateless: a
 * drive is told in every cycle what leads from where it is to where it shall be. */
#ifndef TB_CIA402_H
#define TB_CIA402_H

#include <stdbool.h>
#include <stdint.h>

#include "drive.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Objects */
#define TB_OBJECT_MODE 0x6060u
#define TB_OBJECT_MODE_DISPLAY 0x6061u

/* Bits of the controlword */
#define TB_CONTROL_HOMING_START 0x0010u
#define TB_CONTROL_FAULT_RESET 0x0080u

/* Bits of the statusword */
#define TB_STATUS_REMOTE 0x0200u /* the drive follows the bus */

/** Power state that a statusword says; TB_POWER_UNKNOWN for a pattern CiA 402 does not know. */
tb_power tb_cia402_power(uint16_t statusword);

/** How far homing is, from the statusword of a drive that was told to start it. */
tb_homing tb_cia402_homing(uint16_t statusword);

/** The controlword that leads on from a power state to a goal, or holds it.
 *  home: keep homing while enabled. previous: the controlword sent before; only the fault reset
 *  reads it: that is a rising edge, which may get lost, so it falls and rises until it acts.
 *  An unknown state is taken off the power: nobody can say what else would be safe. */
uint16_t tb_cia402_controlword(tb_power power, tb_goal goal, bool home, uint16_t previous);

#ifdef __cplusplus
}
#endif

#endif
