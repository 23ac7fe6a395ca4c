/* Regenerate: turnbuckle generate machines/yoon2023.toml --out <this folder>
 * Machine 499338192b9e5092, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_DRIVES_H
#define TB_DRIVES_H

#include <stdint.h>

#include "tb_types.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TB_BUSES 3
#define TB_DRIVES 8 /* cable drives in the order of the cables, then base drives in that of the rails */
#define TB_NODE_FRAMES 1 /* of nodes that are no drives */

/* Times */
#define TB_COMPUTE_PHASE 500 /* us from SYNC until every answer is there: turnbuckle bus */
#define TB_HEARTBEAT_CYCLES 10 /* cycles between heartbeats of the master */
#define TB_HEARTBEAT_TIMEOUT 100 /* cycles without a heartbeat of a drive until it counts as silent */
#define TB_ANSWER_TIMEOUT 500 /* cycles until an SDO request has failed */
#define TB_STATE_TIMEOUT 2000 /* cycles that a drive may take to an ordered power state or mode */
#define TB_HOMING_TIMEOUT 20000 /* cycles of one homing run */
#define TB_STOP_CYCLES 300 /* cycles of a soft stop, from work to no torque */

/* Supervision */
#define TB_MISSED_LIMIT 2 /* SYNCs in a row without an answer that are bridged */
#define TB_SKIPPED_LIMIT 2 /* control cycles skipped at once that are bridged */
#define TB_FAILED_LIMIT 20 /* controller steps failed in a row that are bridged */
#define TB_CLOSURE_LIMIT TB_C(0.002) /* m, largest residual of the measured lengths */
#define TB_CLOSURE_CYCLES 5 /* cycles beyond it that are bridged */
#define TB_CABLE_SPEED_LIMIT TB_C(5.0) /* m/s */
#define TB_RAIL_SPEED_LIMIT TB_C(3.0) /* m/s */
#define TB_RAIL_LAG_LIMIT TB_C(0.05) /* m, between a base and its target */
#define TB_RAIL_LAG_CYCLES 200 /* cycles beyond it that are bridged */
#define TB_BLOCKED_CYCLES 20 /* cycles that a carriage may stand still while it is pushed at its limit */
#define TB_BLOCKED_TRAVEL TB_C(0.0002) /* m, motion that is none yet */

/* Process data */
#define TB_STATUS_LENGTH 8 /* bytes */
#define TB_STATUS_STATUSWORD 0 /* byte of 6041h, 16 bits */
#define TB_STATUS_POSITION 2 /* byte of 6064h, 32 bits */
#define TB_STATUS_TORQUE 6 /* byte of 6077h, 16 bits */
#define TB_TORQUE_COMMAND_LENGTH 4 /* bytes */
#define TB_TORQUE_COMMAND_CONTROLWORD 0 /* byte of 6040h, 16 bits */
#define TB_TORQUE_COMMAND_TORQUE 2 /* byte of 6071h, 16 bits */
#define TB_POSITION_COMMAND_LENGTH 6 /* bytes */
#define TB_POSITION_COMMAND_CONTROLWORD 0 /* byte of 6040h, 16 bits */
#define TB_POSITION_COMMAND_POSITION 2 /* byte of 607Ah, 32 bits */

/* Base drives */
#define TB_RAIL_LENGTHS {TB_C(0.7118), TB_C(0.4618), TB_C(0.7118), TB_C(0.4618)} /* m (TB_RAIL_SLOTS) */
#define TB_RAIL_TORQUE_LIMIT TB_C(0.8999999999999999) /* N m */
#define TB_RAIL_TORQUE_STEP TB_C(0.2) /* N m, largest change of a torque in one cycle */

/* Calibration of the cables' zeros */
#define TB_CALIBRATION_SAMPLES 24 /* poses that are measured */
#define TB_CALIBRATION_CYCLES 100 /* cycles between two of them */
#define TB_CALIBRATION_TRAVEL TB_C(0.1) /* m, sweep of each base to either side of the middle of its rail */

/** What is done with an entry of a drive's object dictionary. */
typedef enum {
    TB_OBJECT_CHECK = 0,        /* read it; it must hold the value */
    TB_OBJECT_WRITE = 1,        /* write the value, read it back */
    TB_OBJECT_WRITE_OF_NODE = 2 /* the same, with the drive's number added to the value */
} tb_object_action;

/** An entry of a drive's object dictionary. */
typedef struct {
    uint16_t index;
    uint8_t subindex;
    uint8_t size;   /* bytes */
    uint8_t action; /* tb_object_action */
    uint32_t value; /* a negative one in two's complement of `size` bytes */
} tb_object;

/** How severe an emergency of a drive is. */
typedef enum {
    TB_ERROR_NONE = 0,
    TB_ERROR_WARNING,      /* goes on: for people to read */
    TB_ERROR_FAULT,        /* its power stage is off or going off */
    TB_ERROR_COMMUNICATION /* as FAULT; cleared only by a reset of its communication */
} tb_error_class;

/** Error codes of a drive's maker, from one to another, both included. */
typedef struct {
    uint16_t first;
    uint16_t last;
    uint8_t error_class; /* tb_error_class */
    const char *text;
} tb_error_text;

/** An SDO abort code of a drive's maker. */
typedef struct {
    uint32_t code;
    const char *text;
} tb_abort_text;

/** What drives of one kind have of their own beside their objects. */
typedef struct {
    const tb_error_text *errors; /* those that CiA 301 and CiA 402 do not name, or name otherwise */
    const tb_abort_text *aborts;
    uint16_t error_count;
    uint16_t abort_count;
    uint8_t modes[4]; /* by tb_mode: the mode of operation (6060) */
} tb_drive_kind;

/** A bus of the machine file. */
typedef struct {
    const char *name;
    uint32_t bit_rate; /* bit/s */
    uint8_t divider;   /* control cycles from one SYNC to the next */
} tb_bus_table;

/** A drive of the machine file; increments are counts of its encoder, units of torque those of its
 *  target torque (6071). */
typedef struct {
    const char *name;
    uint8_t bus;  /* its number in tb_buses */
    uint8_t node; /* its number on the bus */
    uint8_t mode; /* at work it follows 0 torque (CST), 1 position (CSP) */
    real_t metres_per_increment; /* < 0 where the encoder counts against the position */
    real_t increments_per_metre;
    real_t torque_per_unit;     /* N m; < 0 where the motor turns against the position */
    real_t units_per_torque;    /* 1/(N m) */
    int16_t most_torque_units;  /* most the drive is asked for, either way */
    uint16_t identity_count;
    uint16_t contract_count;
    const tb_object *identity; /* IDENTIFY reads these */
    const tb_object *contract; /* CONFIGURE writes these and reads them back, in this order */
    const tb_drive_kind *kind;
} tb_drive_table;

/** A frame that a node other than a drive may send; 0x800 is none. */
typedef struct {
    uint16_t id; /* its identifier */
    uint8_t bus; /* number of the bus in tb_buses */
} tb_node_frame;

extern const tb_bus_table tb_buses[TB_BUSES];
extern const tb_drive_table tb_drives[TB_DRIVES];
extern const tb_node_frame tb_node_frames[TB_NODE_FRAMES];

#ifdef __cplusplus
}
#endif

#endif
