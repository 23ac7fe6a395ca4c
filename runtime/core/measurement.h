/* Measurement: the positions of cables and bases in this cycle, from the last reports of their drives.
 *
 * In some cycles a drive reports nothing: its bus is slower than the control loop, its answer comes a
 * cycle after the SYNC, or its answer was missed. The position of that drive is then extrapolated at
 * the speed between its last two messages. A message further from the extrapolated position than
 * anything can have moved since the last message is a jump: a fault of the encoder. A speed that grows
 * beyond its limit from message to message is a runaway, not a jump. */
#ifndef TB_MEASUREMENT_H
#define TB_MEASUREMENT_H

#include <stdbool.h>
#include <stddef.h>

#include "drive.h"
#include "tb_machine.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A drive's position over time. */
typedef struct {
    real_t position; /* m, of its last message */
    real_t rate;     /* m a cycle, between its last two messages */
    uint16_t age;    /* cycles since the SYNC of the last message; stops at its largest value */
    uint8_t known;   /* 1 from the first message on */
    uint8_t jumped;  /* 1 when this cycle's message is a jump */
} tb_track;

/** All positions. */
typedef struct {
    tb_track tracks[TB_DRIVES];
} tb_measurement;

/** Forget where a drive was: its next message is no jump, wherever it is. */
void tb_measurement_forget(tb_measurement *measurement, size_t drive);

/** This cycle's jump of a drive is none: it counts from another zero than before, where it may. */
void tb_measurement_rebase(tb_measurement *measurement, size_t drive,
                           const tb_drive_report *report);

/** Take over this cycle's reports. skipped: cycles that were left out since the last one. */
void tb_measurement_take(tb_measurement *measurement, const tb_drive_report reports[TB_DRIVES],
                         uint32_t skipped);

/** Whether every drive has answered the last SYNC of its bus, in this cycle or before. */
bool tb_measurement_is_complete(const tb_measurement *measurement);

/** A drive that has not; call it when there is one. */
size_t tb_measurement_missing(const tb_measurement *measurement);

/** Position of a drive in this cycle [m]; always finite. */
real_t tb_measured_position(const tb_measurement *measurement, size_t drive);

/** Cable wound in [m] (TB_CABLES). */
void tb_measured_winding(const tb_measurement *measurement, real_t wound[TB_CABLES]);

/** Rail coordinates [m] (TB_RAIL_SLOTS). */
void tb_measured_rails(const tb_measurement *measurement, real_t rails[TB_RAIL_SLOTS]);

/** Speed of a drive between its last two messages [m/s], > 0 winds in. */
real_t tb_measured_speed(const tb_measurement *measurement, size_t drive);

#ifdef __cplusplus
}
#endif

#endif
