/** What the sources of the peer share. Nothing here is for the owner. */
#ifndef PEER_H
#define PEER_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "objects.h"
#include "peer_drives.h"

#define NEVER INT64_MAX
#define SECOND ((peer_time)1000000000)
#define MILLISECOND ((peer_time)1000000)
#define PI 3.14159265358979323846

enum {
    PDOS = 4,
    MAPPED = 12, /* objects in a PDO */
    SERVO_PERIOD = 250000,
    QUEUE = 64,    /* frames of the master and of other nodes */
    OUTGOING = 32, /* frames of one drive */
    INBOX = 1024,
    REQUESTS = 8, /* SDO requests of one drive */
    LINE_BYTES = 32768
};

#define SLOT_NAME(name, ...) O_##name,
enum { ALL_OBJECTS(SLOT_NAME) SLOTS };
enum { MAP_STRIDE = MAPPED + 1, RPDO_STRIDE = 3, TPDO_STRIDE = 4, NO_SLOT = -1 };

typedef enum { U8, I8, U16, I16, U32, I32, STRING } value_type;
typedef enum { RO, ROM, RW, RWM, RWP } access;

typedef struct {
    uint16_t index;
    uint8_t sub;
    value_type type;
    access access;
    int64_t factory;
    int64_t least;
    int64_t greatest;
} object;

/** Abort codes of SDO transfers. */
enum {
    ABORT_NONE = 0,
    ABORT_TOGGLE = 0x05030000,
    ABORT_COMMAND = 0x05040001,
    ABORT_WRITE_ONLY = 0x06010001,
    ABORT_READ_ONLY = 0x06010002,
    ABORT_COUNT_NOT_ZERO = 0x06010003,
    ABORT_NO_OBJECT = 0x06020000,
    ABORT_NOT_MAPPABLE = 0x06040041,
    ABORT_MAP_LENGTH = 0x06040042,
    ABORT_LENGTH = 0x06070010,
    ABORT_TOO_LONG = 0x06070012,
    ABORT_TOO_SHORT = 0x06070013,
    ABORT_NO_SUB = 0x06090011,
    ABORT_RANGE = 0x06090030,
    ABORT_TOO_HIGH = 0x06090031,
    ABORT_TOO_LOW = 0x06090032,
    ABORT_NOT_STORED = 0x08000020,
    ABORT_STATE = 0x08000022,
    ABORT_NMT_STATE = 0x0F00FFC0
};

typedef struct {
    peer_frame frame;
    peer_time ready; /* to be sent; in an inbox: when it arrived */
    uint64_t order;
    uint64_t rank; /* frame_arbitration() */
} queued;

typedef struct {
    queued item[QUEUE];
    unsigned first;
    unsigned count;
} fifo;

typedef struct {
    uint8_t byte;
    bool ends_piece;
    peer_time ready;
} line_byte;

typedef struct {
    bool open;
    bool listen;
    bool timestamps;
    uint32_t bit_rate; /* 0: not set */
    char line[40];
    unsigned length;
    line_byte out[LINE_BYTES];
    unsigned first;
    unsigned count;
} adapter;

/** What a bus carries at the moment. */
typedef struct {
    bool busy;
    bool delivered;
    bool broken; /* a collision: nobody receives it */
    peer_frame frame;
    peer_time arrival;
    peer_time free;
    uint64_t senders; /* by source */
} wire;

enum { FROM_MASTER, FROM_OTHERS, FROM_DRIVE }; /* a source; a drive is FROM_DRIVE + its number */

typedef struct {
    peer_bus config;
    wire wire;
    fifo master;
    fifo others;
    queued inbox[INBOX];
    unsigned first;
    unsigned count;
    unsigned drive[PEER_DRIVES];
    unsigned drives;
    peer_time next_time;
    peer_time next_foreign;
    adapter adapter;
    peer_bus_counters counters;
} bus;

/** A segmented transfer in progress. */
typedef struct {
    enum { SDO_IDLE, SDO_DOWNLOAD, SDO_UPLOAD } kind;
    int slot;
    uint8_t toggle;
    bool sized;
    uint32_t size;
    uint32_t done;
    uint8_t data[64];
} transfer;

typedef struct {
    transfer transfer;
    uint8_t request[REQUESTS][8];
    unsigned waiting;
    peer_time serve; /* when the first of them is answered */
} sdo_server;

typedef struct {
    bool fresh;
    uint8_t length;
    uint8_t data[8];
    unsigned syncs;      /* TPDO: since it was sent */
    bool event;          /* TPDO: to be sent for a change */
    peer_time inhibited; /* TPDO: until */
} pdo;

typedef struct {
    peer_time expires; /* NEVER until the node is heard */
} consumer;

typedef struct {
    bool coupled;
    double angle;
    double rate;
    peer_time at;
} shaft;

typedef struct {
    double counts; /* the true ones when the fault began */
    double reading;
    peer_time since;
} encoder_fault;

typedef enum { ACT_COAST, ACT_TORQUE, ACT_POSITION } action;

typedef struct {
    action action;
    double torque;  /* at the shaft, N m */
    double current; /* as the drive sees it, mA */
    double current_demand;
    double current_averaged;
    bool limited;
    double heat;        /* I2t, 1: the limit becomes the nominal current */
    double demand;      /* counts, which do not wrap here */
    double demand_rate; /* counts/s */
    double goal;        /* of CSP's interpolation, counts */
    unsigned steps;     /* left to the goal */
    double integral;
    double counts;   /* at the last servo period */
    double tracked;  /* the estimate of it, counts */
    double velocity; /* estimated, counts/s */
    int32_t shift;   /* by homing: position = count + shift */
} servo;

typedef enum { HOMING_IDLE, HOMING_SEEK, HOMING_MOVE, HOMING_DONE, HOMING_FAILED } homing_phase;

typedef struct {
    homing_phase phase;
    double target; /* of the move after the reference, counts */
    bool homed;
} homing;

typedef struct {
    peer_power state;
    uint16_t controlword;
    bool pending;        /* the controlword was written and may ask for a transition */
    peer_time commanded; /* since when */
    bool reset_edge;
    bool stopping; /* a ramp runs, then `after` by transition `number` */
    peer_power after;
    unsigned number;
    double deceleration; /* of the ramp, rpm/s */
    bool latched;        /* communication error: needs "reset communication" */
    bool referenced_off; /* the error's reset loses the home position */
    bool warning;
} power;

typedef struct {
    peer_drive config;
    unsigned number;
    bool on; /* has power */
    peer_nmt nmt;
    peer_time boot_at;
    peer_time restart_at;
    uint32_t restarts; /* still to come */
    peer_time heartbeat_at;
    peer_time burst_at;
    int mode;
    peer_time mode_at; /* when the mode asked for is taken */
    consumer consumer[2];
    unsigned errors; /* of its CAN controller */
    bool bus_off;
    int64_t value[SLOTS];
    int64_t stored[SLOTS];
    int64_t factory[SLOTS];
    bool restore; /* factory values at the next start */
    int rpdo_slot[PDOS][MAPPED];
    int tpdo_slot[PDOS][MAPPED];
    pdo rpdo[PDOS];
    pdo tpdo[PDOS];
    unsigned setpoints_since_sync;
    bool setpoints_began;
    bool toggled;
    queued out[OUTGOING];
    unsigned outgoing;
    sdo_server sdo;
    power power;
    servo servo;
    homing homing;
    shaft shaft;
    encoder_fault encoder;
    peer_counters counters;
    peer *peer;
} drive;

struct peer {
    peer_time now;
    peer_time servo_at;
    uint64_t random;
    uint64_t order;
    peer_timing timing;
    unsigned buses;
    unsigned drives;
    bus bus[PEER_BUSES];
    drive drive[PEER_DRIVES];
};

/* bits.c */
uint64_t frame_arbitration(peer_frame const *frame);
bool frame_valid(peer_frame const *frame);
bool frame_equal(peer_frame const *a, peer_frame const *b);
peer_time bits_time(uint32_t bits, uint32_t bit_rate);

/* random.c: all delays */
uint32_t random_below(peer *p, uint32_t bound);
peer_time random_delay(peer *p, peer_time most);

/* bus.c */
peer_time bus_next(peer const *p, bus const *b);
void bus_step(peer *p, bus *b);
void bus_put_inbox(peer *p, bus *b, peer_frame const *frame);
void drive_transmit(drive *d, uint32_t id, uint8_t const *data, uint8_t length, peer_time ready);

/* adapter.c */
void adapter_begin(peer *p, bus *b);
bool adapter_on_wire(bus const *b);
void adapter_frame(peer *p, bus *b, peer_frame const *frame);

/* objects.c */
extern object const objects[SLOTS];
int object_find(uint16_t index, uint8_t sub);
bool object_exists(uint16_t index);
unsigned object_bytes(int slot);
char const *object_string(int slot);
void objects_begin(drive *d);
void objects_power_on(drive *d);
void objects_reset_communication(drive *d);
void objects_refresh(drive *d);
uint32_t object_write(drive *d, int slot, int64_t value);
void object_receive(drive *d, int slot, int64_t value);
void rated_torque_refresh(drive *d);

/* nmt.c */
void nmt_power(drive *d, bool on);
void nmt_command(drive *d, peer_frame const *frame);
void nmt_enter(drive *d, peer_nmt state);
void nmt_boot(drive *d, peer_time delay);
void nmt_timers(drive *d);
peer_time nmt_next(drive const *d);
void nmt_heartbeat_heard(drive *d, uint32_t node);
void nmt_producer_written(drive *d);

/* emergency.c */
void emergency_raise(drive *d, uint16_t code);
void emergency_send(drive *d, uint16_t code);
void emergency_cleared(drive *d);
bool emergency_is_latched(uint16_t code);

/* sdo.c */
void sdo_request(drive *d, peer_frame const *frame);
void sdo_serve(drive *d);
void sdo_reset(drive *d);

/* pdo.c */
void pdo_reset(drive *d);
void pdo_map_resolve(drive *d);
uint32_t pdo_check(drive const *d, int slot, int64_t value);
bool pdo_is_parameter(int slot);
void pdo_receive(drive *d, peer_frame const *frame);
void pdo_sync(drive *d);
void pdo_events(drive *d);
void pdo_start(drive *d);

/* cia402.c */
void cia402_power_on(drive *d);
void cia402_tick(drive *d);
void cia402_controlword(drive *d, uint16_t word);
void cia402_fault(drive *d, bool ramp);
void cia402_connection_lost(drive *d, uint16_t code);
uint16_t cia402_statusword(drive const *d);
bool cia402_powered(drive const *d);

/* homing.c */
void homing_begin(drive *d);
void homing_tick(drive *d, double dt);
void homing_stop(drive *d);
void homing_leave(drive *d);

/* servo.c */
void servo_reset(drive *d);
void servo_tick(drive *d, double dt);
void servo_output(drive *d, double dt);
void servo_take(drive *d);
void servo_target(drive *d);
bool servo_standstill(drive const *d);
double servo_counts(drive const *d, peer_time time);
int32_t servo_position(drive const *d, double counts);
void servo_vary(drive *d, peer_variation const *next);
double counts_per_second(drive const *d, double rpm);

#endif
