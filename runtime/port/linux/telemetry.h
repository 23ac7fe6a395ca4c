/* Telemetry: a shared file through which other programs watch the machine and send it wishes.
 *
 * The file is memory that both sides map. Neither ever waits for the other: no lock, no system call.
 *
 *   header      who writes, and where everything is; does not change
 *   layout      the description of everything (layout.h): readers go by the names in it
 *   status      counters, times, buses: the latest
 *   cycles      a ring of the last TB_TELEMETRY_CYCLES control cycles
 *   inbox       what other programs write: requests, the application's force, the hand's force
 *
 * Reading. Status and every slot of the ring begin with a `sequence`. It is odd while the control
 * thread writes the rest, and grows by 2 with every writing. Read the sequence, copy, read it again:
 * only a copy between two equal, even values is whole. A slot's sequence is 2 (number + 1) for the
 * cycle `number`, which is in slot number % slots; status.published counts the cycles.
 *
 * Writing. Requests are counters: add 1 to ask once. Forces: make the sequence odd, write, make it
 * even. A force counts for TB_FORCE_CYCLES cycles after it was written; then the application's is 0
 * and the hand's is unknown.
 *
 * The control thread holds a lock (flock) on the file until it ends: a file that can be locked
 * belongs to a program that has ended.
 *
 * All numbers are little-endian, real numbers are double in either precision of the runtime, arrays
 * have the machine's sizes, which the header repeats. lab/live/telemetry.py is a reader. */
#ifndef TB_TELEMETRY_H
#define TB_TELEMETRY_H

#include <stdbool.h>
#include <stdint.h>

#include "atomic_numbers.h"
#include "can.h"
#include "cycle.h"
#include "histogram.h"
#include "layout.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TB_TELEMETRY_MAGIC "TBTELEM" /* 8 bytes with the final 0 */
#define TB_TELEMETRY_VERSION 4u
#define TB_TELEMETRY_CYCLES 4096u
#define TB_TELEMETRY_NAME 32u   /* bytes of a name with the final 0; longer ones are cut */
#define TB_TELEMETRY_TEXT 1024u /* bytes of a sentence with the final 0; none is as long */
#define TB_TELEMETRY_ROWS 256u  /* room for the description */
#define TB_FORCE_CYCLES 20u     /* cycles for which a force of the inbox counts */

/** Who writes, and where everything is. The layout of this struct up to layout_rows is part of the
 *  version; all the rest is in the description. */
typedef struct {
    char magic[8]; /* written last: a file without it is not ready */
    uint32_t version;
    uint32_t bytes;       /* of the file */
    uint32_t layout_at;   /* bytes from the beginning of the file, as below */
    uint32_t layout_rows; /* of the description */
    char machine[TB_TELEMETRY_NAME];
    char hash[TB_TELEMETRY_NAME];
    uint32_t dof;
    uint32_t cables;
    uint32_t rails; /* slots: at least 1 */
    uint32_t drives;
    uint32_t buses;
    uint32_t status_at;
    uint32_t cycles_at;
    uint32_t slots;
    uint32_t inbox_at;
    uint32_t pid;
    uint32_t simulated;                   /* 1: a simulation keeps the time, of cycles as well */
    uint32_t has_rails;                   /* 0: the slot of a rail is not used */
    double period;                        /* s, one cycle */
    double tension_min;                   /* N */
    double tension_max;                   /* N */
    int64_t edges[TB_HISTOGRAM_BINS - 1]; /* ns, of the histograms */
    char drive_names[TB_DRIVES][TB_TELEMETRY_NAME];
    char bus_names[TB_BUSES][TB_TELEMETRY_NAME];
} tb_telemetry_header;

/** A bus. */
typedef struct {
    uint64_t bits;  /* sent and received, stuff bits not counted */
    uint32_t state; /* tb_can_state */
    uint32_t sent;
    uint32_t received;
    uint32_t refused;
    uint32_t lost;
    uint32_t malformed;
    uint32_t bus_errors;
    uint32_t bus_off;
    uint32_t bit_rate; /* bit/s */
    uint32_t divider;  /* a SYNC every so many cycles */
} tb_telemetry_bus;

/** The loop: how well it keeps time. */
typedef struct {
    uint64_t missed;        /* cycles that were skipped because they would have begun too late */
    uint64_t longest_gap;   /* cycles that were skipped at once, at most */
    tb_histogram lateness;  /* of the wake-up at the beginning of a cycle */
    tb_histogram computing; /* from the second wake-up until all commands are sent */
} tb_loop_times;

/** What is counted and told, the latest. */
typedef struct {
    tb_atomic_u64 sequence;
    uint64_t published; /* cycles in the ring so far */
    tb_loop_times times;
    tb_telemetry_bus buses[TB_BUSES];
    char doing[TB_TELEMETRY_TEXT]; /* what the machine does, in words */
    char cause[TB_TELEMETRY_TEXT]; /* why it stopped, in words; empty for no cause */
} tb_telemetry_status;

/** A drive in one cycle. */
typedef struct {
    double position;       /* m */
    double torque;         /* N m, measured */
    double ordered_torque; /* N m */
    uint16_t statusword;
    uint16_t error_code;
    uint8_t power;  /* tb_power */
    uint8_t mode;   /* tb_mode */
    uint8_t homing; /* tb_homing */
    uint8_t fresh;
    uint8_t missed;
    uint8_t silent;
    uint8_t task;     /* tb_task */
    uint8_t progress; /* tb_progress */
    uint8_t goal;     /* tb_goal */
    uint8_t reserved[3];
} tb_telemetry_drive;

/** One control cycle. */
typedef struct {
    tb_atomic_u64 sequence;
    uint64_t number; /* of the cycle, skipped ones are not counted */
    int64_t time;    /* ns of CLOCK_MONOTONIC, or simulated; at its beginning */
    uint32_t missed; /* cycles skipped just before */
    uint32_t requests;
    uint8_t state; /* tb_state */
    uint8_t phase;
    uint8_t cause; /* tb_cause */
    uint8_t beat;
    int32_t status; /* tb_status of the controller step */
    double pose[TB_DOF];
    double velocity[TB_DOF];
    double residual;                   /* m */
    double force[TB_DOF];              /* N, of the application */
    double wanted_force[TB_DOF];       /* N, walls + application */
    double delivered_force[TB_DOF];    /* N */
    double tension[TB_CABLES];         /* N, commanded */
    double slack[TB_CABLES];           /* m */
    double rail_target[TB_RAIL_SLOTS]; /* m */
    tb_telemetry_drive drives[TB_DRIVES];
} tb_telemetry_cycle;

/** What other programs write. */
typedef struct {
    tb_atomic_u32 arm; /* requests: add 1 to ask once */
    tb_atomic_u32 stop;
    tb_atomic_u32 reset;
    uint32_t reserved;
    tb_atomic_u64 force_sequence;
    double force[TB_DOF]; /* N, wanted by the application */
    tb_atomic_u64 hand_sequence;
    double hand_force[TB_DOF]; /* N, measured force of the hand on the handle */
} tb_telemetry_inbox;

/** The whole file. */
typedef struct {
    tb_telemetry_header header;
    tb_layout_row layout[TB_TELEMETRY_ROWS];
    tb_telemetry_status status;
    tb_telemetry_cycle cycles[TB_TELEMETRY_CYCLES];
    tb_telemetry_inbox inbox;
} tb_telemetry_file;

/** The description of what is in the file. */
extern const tb_layout_row tb_telemetry_layout[];
extern const uint32_t tb_telemetry_layout_rows;

/** Make the file anew and map it. A message tells why it cannot be; then NULL is returned. */
tb_telemetry_file *tb_telemetry_open(const char *path, bool simulated);

/** Append a cycle; its sequence is set here. */
void tb_telemetry_append(tb_telemetry_file *file, const tb_telemetry_cycle *cycle);

/** Replace what is counted and told; sequence and number of cycles are set here. */
void tb_telemetry_tell(tb_telemetry_file *file, const tb_telemetry_status *status);

#ifdef __cplusplus
}
#endif

#endif
