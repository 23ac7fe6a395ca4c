#include "measurement.h"

#define FARTHEST TB_C(1e6) /* m; no drive counts further */

static const tb_track unknown;

void tb_measurement_forget(tb_measurement *measurement, size_t drive)
{
    measurement->tracks[drive] = unknown;
}

/* Most that a drive can move in a cycle. */
static real_t largest_move(size_t drive)
{
    return TB_PERIOD * ((drive < TB_CABLES) ? TB_CABLE_SPEED_LIMIT : TB_RAIL_SPEED_LIMIT);
}

/* Where a drive is so many cycles after its last message. */
static real_t position_after(const tb_track *track, uint16_t cycles)
{
    return track->position + (track->rate * (real_t)cycles);
}

/* Cycles between the SYNCs of the last message and of this one. */
static uint16_t time_between(const tb_track *track, uint8_t age)
{
    return (track->age > age) ? (uint16_t)(track->age - age) : 1;
}

/* The first message may be wherever a drive can be; a NaN fails the comparison. */
static bool is_believable(const tb_track *track, real_t position, uint16_t time, real_t largest)
{
    real_t const bound = (track->known != 0) ? (largest * (real_t)time) : FARTHEST;
    return TB_ABS(position - position_after(track, time)) <= bound;
}

static void keep(tb_track *track, real_t position, uint16_t time, uint8_t age)
{
    if (track->known != 0) {
        track->rate = (position - track->position) / (real_t)time;
    }
    track->known = 1;
    track->position = position;
    track->age = age;
}

static void grow_older(tb_track *track, uint32_t skipped)
{
    uint16_t const left = (uint16_t)(UINT16_MAX - track->age);
    track->age = (skipped < left) ? (uint16_t)(track->age + 1U + skipped) : UINT16_MAX;
}

static void take(tb_track *track, const tb_drive_report *report, real_t largest, uint32_t skipped)
{
    grow_older(track, skipped);
    track->jumped = 0;
    if (report->fresh != 0) {
        uint16_t const time = time_between(track, report->age);
        if (is_believable(track, report->position, time, largest)) {
            keep(track, report->position, time, report->age);
        } else {
            track->jumped = 1;
        }
    }
}

void tb_measurement_take(tb_measurement *measurement, const tb_drive_report reports[TB_DRIVES],
                         uint32_t skipped)
{
    for (size_t i = 0; i < TB_DRIVES; i++) {
        take(&measurement->tracks[i], &reports[i], largest_move(i), skipped);
    }
}

void tb_measurement_rebase(tb_measurement *measurement, size_t drive, const tb_drive_report *report)
{
    tb_track *const track = &measurement->tracks[drive];
    if ((track->jumped != 0) && (TB_ABS(report->position) <= FARTHEST)) {
        track->position = report->position;
        track->age = report->age;
        track->jumped = 0;
    }
}

/* Its message answers the last SYNC: there was none since. */
static bool is_current(const tb_measurement *measurement, size_t drive)
{
    return measurement->tracks[drive].age < tb_buses[tb_drives[drive].bus].divider;
}

size_t tb_measurement_missing(const tb_measurement *measurement)
{
    size_t drive = 0;
    while ((drive + 1 < TB_DRIVES) && is_current(measurement, drive)) {
        drive++;
    }
    return drive;
}

bool tb_measurement_is_complete(const tb_measurement *measurement)
{
    return is_current(measurement, tb_measurement_missing(measurement));
}

real_t tb_measured_position(const tb_measurement *measurement, size_t drive)
{
    const tb_track *const track = &measurement->tracks[drive];
    return position_after(track, track->age);
}

void tb_measured_winding(const tb_measurement *measurement, real_t wound[TB_CABLES])
{
    for (size_t i = 0; i < TB_CABLES; i++) {
        wound[i] = tb_measured_position(measurement, i);
    }
}

void tb_measured_rails(const tb_measurement *measurement, real_t rails[TB_RAIL_SLOTS])
{
#if TB_RAILS == 0
    rails[0] = 0; /* the slot of an array that nobody fills or reads */
#endif
    for (size_t i = TB_CABLES; i < TB_DRIVES; i++) {
        rails[i - TB_CABLES] = tb_measured_position(measurement, i);
    }
}

real_t tb_measured_speed(const tb_measurement *measurement, size_t drive)
{
    return measurement->tracks[drive].rate / TB_PERIOD;
}
