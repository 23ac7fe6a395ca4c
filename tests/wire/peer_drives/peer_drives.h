/**
 * CiA 402 servo drives on CAN buses with wire times: a peer to judge a CANopen master with.
 *
 * Written from CiA 301, CiA 402, ISO 11898-1, the Lawicel text protocol and public facts of the
 * EPOS4, without a look at the master. A pure library: no clock, no input or output, no state
 * outside `peer`, and memory is taken in peer_new() only. Make it a shared library: the
 * functions its sources share have short names.
 *
 * UNITS. Time is a count of nanoseconds from 0, when all drives are switched on. Angles rad,
 * torques N m at the motor shaft and in the motor's own sense, inertias kg m^2; what a drive's
 * objects hold is in the objects' own units (counts, mA, uNm, per mille, rpm).
 *
 * ORDER OF CALLS. peer_new(); then again and again:
 *   peer_send(), peer_write()   what the master hands to its controller now or later, or writes now
 *   peer_turn()                 where the owner's physics has the shafts, with that time
 *   peer_run()                  time passes; or peer_run_to_arrival(): no further than that
 *   peer_receive(), peer_read() what arrived, with the time of its arrival
 *   peer_torque()               for the physics
 * and peer_free(). No time given may be before one already reached: what is late counts as given
 * now. Numbers of buses and drives are those of the configuration, from 0, and are not checked.
 *
 * THE WIRE. A bus carries one frame at a time, to its end. When the bus is free the lowest
 * identifier among the frames that are ready wins: each drive offers its lowest (first come of
 * equal ones), the master its oldest. A frame lasts as many bits as its bit pattern has with CRC
 * and stuff bits, and 3 more between frames; it has arrived 3 bits before the bus is free again.
 * Nothing moves while fewer than two nodes are there to acknowledge each other. Two nodes that
 * send unequal frames of one identifier at one moment destroy both. They try again; a drive goes
 * bus-off after 32 such errors and stays so until its power was off.
 *
 * THE MASTER is on a bus's wire from the start, or, on a bus with `adapter`, behind a serial line
 * and a Lawicel adapter: commands C O L S0..S8 s Z M m W V N F E X t T r R; then peer_send() and
 * peer_receive() are not for that bus. The adapter's bit rate must be the bus's, or nothing
 * passes. What a bus carries while the adapter is closed the master never hears.
 *
 * A DRIVE has the objects of objects.h. It answers SDO requests one after the other, each within
 * sdo_delay; a request has its effect when it is answered. At a SYNC the drive samples what its
 * synchronous TPDOs carry, then applies what its synchronous RPDOs brought since the SYNC before;
 * the TPDOs are ready within answer_delay. A controlword is acted on within one servo period (250
 * us), and only once: a command of before a fault does not come back by itself. Torque (mode 10)
 * follows at the SYNC. Modes: 10 CST, 8 CSP with linear interpolation over 60C2, 6 homing by
 * methods -3, -4 (current threshold; 30B1 is the move that follows, signed) and 35, 37 (here); in
 * the other modes of an EPOS4 the position is held. The position controller of CSP, homing and all
 * ramps is tuned to `tuned_inertia`, 15 Hz.
 *
 * A coupled motor is where peer_turn() says, between two calls and after the last on a straight
 * line. A motor never turned is a free rotor of `rotor_inertia` with `friction` and end stops. The
 * encoder of a drive counts `initial_count` at angle 0.
 *
 * Loss of the master's heartbeat: emergency 0x8130, behaviour 1029:1, reaction 6007, and the drive
 * ends in FAULT, which only a reset after NMT "reset communication" leaves (as EPOS4). With the
 * variation `reaction_is_command` it ends where CiA 402 has the command of 6007 end instead. NMT
 * "stop" and "reset communication" are a lost connection too, without an error.
 *
 * VARIATIONS are zero for a plain drive or adapter and may be changed at any time, by peer_vary()
 * and peer_vary_bus(). Legal ones a master must live with; illegal ones it must refuse or stop on.
 *
 * NOT SIMULATED: bit errors and what follows from them, propagation delay, block transfer, RTR to
 * PDOs, node guarding, LSS, SYNC counter, software position limits, profile modes and CSV, limit
 * and home switches, index pulse, the electrical time constants of the motor, the bit rate of the
 * serial line, writing 2000 and 2001 (kept, without effect).
 */
#ifndef PEER_DRIVES_H
#define PEER_DRIVES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { PEER_BUSES = 8, PEER_DRIVES = 32 };

/** Nanoseconds. */
typedef int64_t peer_time;

typedef struct {
    uint32_t id;
    uint8_t length; /**< of a remote frame: the length asked for */
    bool extended;
    bool remote;
    uint8_t data[8];
} peer_frame;

/** How a drive answers an SDO upload. */
typedef enum {
    PEER_UPLOAD_EXACT,            /**< expedited, with the size of the object */
    PEER_UPLOAD_NO_SIZE,          /**< expedited, 0x42 */
    PEER_UPLOAD_PADDED,           /**< expedited, 0x43 whatever the size, padded with zeros */
    PEER_UPLOAD_SEGMENTED,        /**< segments, the size announced */
    PEER_UPLOAD_SEGMENTED_NO_SIZE /**< segments, the size not announced */
} peer_upload;

typedef enum {
    PEER_ENCODER_GOOD,
    PEER_ENCODER_REVERSED, /**< counts the other way from now on */
    PEER_ENCODER_FROZEN,   /**< stays at its count */
    PEER_ENCODER_JUMP,     /**< jumps by encoder_value counts, once */
    PEER_ENCODER_SLIP,     /**< creeps by encoder_value counts a second */
    PEER_ENCODER_SCALED    /**< counts encoder_value times what it should */
} peer_encoder_fault;

typedef enum {
    PEER_TORQUE_GOOD,
    PEER_TORQUE_NOT_GIVEN, /**< the shaft gets none */
    PEER_TORQUE_DOUBLED    /**< the shaft gets twice what is demanded */
} peer_torque_fault;

typedef struct {
    /* Legal */
    uint32_t upload;            /**< a peer_upload */
    uint32_t segment_bytes;     /**< data of an upload segment, 1 to 7; 0: 7 */
    uint32_t fill;              /**< what unused bytes of SDO answers hold */
    uint32_t restarts;          /**< so many boot-ups are followed by a restart and another one */
    peer_time restart_after;    /**< time from such a boot-up to the next */
    uint32_t heartbeat_percent; /**< of the heartbeat period set; 0: 100 */
    uint32_t status_set;        /**< statusword bits set; bit 5 only where it has no meaning */
    uint32_t status_toggle;     /**< statusword bits inverted in every second sample */
    peer_time burst_period;     /**< between bursts of emergencies; 0: none */
    uint32_t burst_count;       /**< warnings 0xFF01 in a burst, which 0x0000 ends */
    peer_time inhibit_jitter;   /**< inhibit times are longer by up to so much */
    bool any_order;             /**< each TPDO takes its own delay */
    peer_time transition_delay; /**< commands of state and mode are acted on so much later */
    bool reaction_is_command;   /**< after a lost heartbeat not FAULT but where 6007 leads */
    /* Illegal */
    uint32_t rated_torque;  /**< 6076 says this instead, uNm; 0: the truth */
    uint32_t misread_index; /**< an SDO upload of this object ... */
    uint32_t misread_sub;
    uint32_t misread_xor; /**< ... has these bits inverted */
    bool remote_clear;    /**< statusword bit 9 stays 0 */
    bool missing;         /**< the drive has no power */
    bool toggle_error;    /**< SDO segments are answered with the wrong toggle bit */
    uint32_t abort_index; /**< SDO requests for this object are aborted ... */
    uint32_t abort_sub;
    uint32_t abort_code;    /**< ... with this code; 0: none */
    int32_t mode_display;   /**< 6061 says this; 0: the truth */
    uint32_t status_forced; /**< the statusword is this; 0: the truth */
    /* Faults of encoder and torque */
    uint32_t encoder; /**< a peer_encoder_fault */
    double encoder_value;
    uint32_t torque;    /**< a peer_torque_fault */
    bool torque_hidden; /**< the drive's own figures, 6077 and 30D1, do not show it */
} peer_variation;

typedef struct {
    uint32_t bus;             /**< from 0 */
    uint32_t node;            /**< 1 to 127; two of a bus may share one, which is illegal */
    uint32_t counts_per_turn; /**< a multiple of 4 */
    uint32_t nominal_current; /**< mA */
    uint32_t current_limit;   /**< mA */
    uint32_t torque_constant; /**< uNm/A */
    uint32_t vendor;
    uint32_t product;
    uint32_t revision;
    uint32_t serial;
    int32_t initial_count;
    double rotor_inertia; /**< kg m^2 */
    double tuned_inertia; /**< what the position controller is tuned to; 0: the rotor's */
    double friction;      /**< of a free rotor, N m s */
    double stop_low;      /**< end stops of a free rotor, rad; both 0: none */
    double stop_high;
    peer_time boot_delay; /**< from power on, or a reset, to the boot-up message */
    peer_variation variation;
} peer_drive;

/** How an adapter acknowledges frames (z CR or CR) and all other commands (CR). */
typedef enum { PEER_ACK_Z, PEER_ACK_CR, PEER_ACK_NONE } peer_ack;

typedef struct {
    /* Legal: the adapter's text */
    uint32_t acknowledgement; /**< a peer_ack */
    bool lower_case;          /**< hexadecimal digits */
    bool line_feed;           /**< lines end with CR LF */
    bool timestamps;          /**< even without Z1 */
    bool pieces;              /**< lines arrive in pieces of any length */
    peer_time piece_delay;    /**< a piece comes so much after the one before at most */
    bool stale;               /**< the rest of older lines is in the line at first */
    bool echo_frames;         /**< frames sent come back as lines too */
    peer_time latency;        /**< of the serial line, towards the master */
    /* Foreign and illegal */
    bool echo_sync;           /**< the master receives its own SYNC */
    peer_time time_period;    /**< of a TIME message (0x100); 0: none */
    peer_time foreign_period; /**< of a foreign node's heartbeat; 0: none */
    uint32_t foreign_node;
    uint32_t foreign_state;
} peer_bus_variation;

typedef struct {
    uint32_t bit_rate; /**< bit/s */
    bool adapter;      /**< the master is behind a serial adapter */
    peer_bus_variation variation;
} peer_bus;

typedef struct {
    peer_time answer_delay;      /**< SYNC to TPDO, at most */
    peer_time sdo_delay;         /**< SDO request to answer, at most */
    peer_time setpoint_deadline; /**< setpoints so long after a SYNC count as late; 0: none do */
    uint64_t seed;               /**< of all delays */
    bool worst;                  /**< all frames and delays as long as they can be */
} peer_timing;

typedef struct {
    uint32_t bus_count;
    uint32_t drive_count;
    peer_bus const *buses;
    peer_drive const *drives;
    peer_timing timing;
} peer_config;

/** NMT states by their heartbeat; PEER_INITIALISING until the boot-up message. */
typedef enum {
    PEER_INITIALISING = 0x00,
    PEER_STOPPED = 0x04,
    PEER_OPERATIONAL = 0x05,
    PEER_PRE_OPERATIONAL = 0x7F
} peer_nmt;

typedef enum {
    PEER_NOT_READY,
    PEER_SWITCH_ON_DISABLED,
    PEER_READY,
    PEER_SWITCHED_ON,
    PEER_OPERATION_ENABLED,
    PEER_QUICK_STOP,
    PEER_FAULT_REACTION,
    PEER_FAULT
} peer_power;

/** What a drive saw since time 0. A setpoint is a synchronous RPDO with 6071 or 607A. */
typedef struct {
    uint64_t syncs;            /**< SYNCs while OPERATIONAL */
    uint64_t setpoints;        /**< all that arrived while OPERATIONAL */
    uint64_t late;             /**< arrived after setpoint_deadline */
    uint64_t doubled;          /**< SYNCs that found more than one */
    uint64_t lost;             /**< SYNCs that found none, since the first setpoint */
    peer_time latest_setpoint; /**< the longest time from a SYNC to a setpoint */
    uint64_t short_pdos;       /**< RPDOs with less than is mapped */
    uint64_t heartbeats;       /**< heard, of nodes it watches */
    peer_time last_heartbeat;  /**< time of the last of them; -1: none */
    peer_time last_sync;       /**< time of the last SYNC; -1: none */
    uint64_t dropped;          /**< frames of its own it had no room for */
    uint32_t transitions;      /**< bit n: transition n of CiA 402 was taken */
} peer_counters;

typedef struct {
    uint64_t frames;     /**< that passed */
    peer_time busy;      /**< time the wire was taken, with the 3 bits between frames */
    uint64_t collisions; /**< of unequal frames with one identifier */
    uint64_t overflows;  /**< frames or bytes the master did not fetch in time */
} peer_bus_counters;

typedef struct peer peer;

/** Drives and buses at time 0; NULL for a configuration outside its ranges, or without memory. */
peer *peer_new(peer_config const *config);
void peer_free(peer *p);

/** Lets time pass. The time reached: `until`, or the present where that is later. */
peer_time peer_run(peer *p, peer_time until);

/** The same, but no further than to where the master has something to receive or read. */
peer_time peer_run_to_arrival(peer *p, peer_time until);

/** Hands a frame to the master's controller; false when 64 are waiting there or it is no frame. */
bool peer_send(peer *p, uint32_t bus, peer_time time, peer_frame const *frame);

/** A frame of some other node on the bus; false when 64 are waiting or it is no frame. */
bool peer_inject(peer *p, uint32_t bus, peer_time time, peer_frame const *frame);

/** The next frame that arrived at the master; false when there is none. */
bool peer_receive(peer *p, uint32_t bus, peer_frame *frame, peer_time *time);

/** What the master writes to the adapter of a bus, now. */
void peer_write(peer *p, uint32_t bus, uint8_t const *bytes, size_t count);

/** The next bytes from the adapter, at most `room`; 0 when there are none. */
size_t peer_read(peer *p, uint32_t bus, uint8_t *bytes, size_t room);

/** Torque at the shaft now, N m. */
double peer_torque(peer const *p, uint32_t drive);

/** Couples a motor: its shaft is, was or will be at an angle at a time, times ascending. */
void peer_turn(peer *p, uint32_t drive, peer_time time, double angle);

/** Angle of the shaft now, rad. */
double peer_angle(peer const *p, uint32_t drive);

void peer_vary(peer *p, uint32_t drive, peer_variation const *variation);
void peer_vary_bus(peer *p, uint32_t bus, peer_bus_variation const *variation);

/** An error of the drive itself, by its code, now. */
void peer_raise(peer *p, uint32_t drive, uint16_t code);

peer_nmt peer_nmt_state(peer const *p, uint32_t drive);
peer_power peer_power_state(peer const *p, uint32_t drive);

/** What an object holds now, without SDO; false when there is no such number. */
bool peer_object(peer *p, uint32_t drive, uint16_t index, uint8_t sub, int64_t *value);
peer_counters peer_counted(peer const *p, uint32_t drive);
peer_bus_counters peer_bus_counted(peer const *p, uint32_t bus);

/** Frames of the master that are still to be sent. */
size_t peer_waiting(peer const *p, uint32_t bus);

/** Bits of a frame on the wire from start of frame to the end of the 3 bits between frames. */
uint32_t peer_frame_bits(peer_frame const *frame);

/** The most that a frame of this kind and length can take. */
uint32_t peer_frame_bits_worst(peer_frame const *frame);

/** The check sequence of a frame, 15 bits. */
uint16_t peer_frame_crc(peer_frame const *frame);

#ifdef __cplusplus
}
#endif

#endif
