/* One CAN bus as the runtime sees it: a port with a driver behind it.
 *
 * A port never blocks and never allocates; only opening and closing may wait, not for long. What it
 * cannot send at once it refuses and counts: a torque that waits in a queue is an old torque. A
 * device that has gone stays gone until it is opened again. All memory of a driver is in its own
 * struct, whose first member is the port; its header has the function that opens it.
 *
 *   slcan.h      any USB adapter that speaks ASCII over a serial line
 *   socketcan.h  a CAN interface of the Linux kernel
 *   loopback.h   frames in memory: simulated drives in the same process */
#ifndef TB_CAN_H
#define TB_CAN_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes in a frame. Classic CAN has 8; define it as 64u, in all of a program, for CAN FD: every frame
 * is then copied with room for that many. */
#ifndef TB_CAN_MOST_DATA
#define TB_CAN_MOST_DATA 8u
#endif

/* Flags of a frame, to be added up. */
#define TB_CAN_EXTENDED ((uint8_t)1)        /* 29 bits of identifier, not 11 */
#define TB_CAN_REMOTE ((uint8_t)2)          /* asks for data, has none */
#define TB_CAN_FD ((uint8_t)4)              /* CAN FD: up to TB_CAN_MOST_DATA bytes */
#define TB_CAN_BIT_RATE_SWITCH ((uint8_t)8) /* CAN FD: data at the faster bit rate */

/** A CAN frame. */
typedef struct {
    uint32_t id;
    uint8_t flags;  /* sum of the flags above */
    uint8_t length; /* bytes of data; of a remote frame, bytes asked for */
    uint8_t data[TB_CAN_MOST_DATA];
} tb_can_frame;

/** Frames that pass a filter: those whose identifier agrees with `id` in the bits of `mask`. */
typedef struct {
    uint32_t id;
    uint32_t mask;
    bool extended; /* frames with 29 bits of identifier, not 11 */
} tb_can_filter;

/** What a port answers. */
typedef enum {
    TB_CAN_OK = 0,
    TB_CAN_EMPTY,         /* receive: no frame is waiting; open: it is under way */
    TB_CAN_FULL,          /* send: no room (ENOBUFS), or the bus is off; the frame is gone, and
                             counted */
    TB_CAN_CLOSED,        /* not open, or the device has gone */
    TB_CAN_REFUSED,       /* send: not a frame this port can carry; open: the adapter refuses */
    TB_CAN_NO_DEVICE,     /* open: no such interface or device */
    TB_CAN_NO_PERMISSION, /* open: may not be used by this user */
    TB_CAN_BUSY,          /* open: another program has it */
    TB_CAN_NOT_CAN,       /* open: it is there, but no CAN interface or serial line */
    TB_CAN_DOWN,          /* open: the interface is there, but down */
    TB_CAN_BIT_RATE,      /* open: not at this bit rate */
    TB_CAN_UNSUPPORTED,   /* open: the operating system has no CAN */
    TB_CAN_RESULTS        /* how many there are */
} tb_can_result;

/** How the bus itself is (CiA 301, ISO 11898-1 fault confinement). */
typedef enum {
    TB_CAN_ERROR_ACTIVE = 0, /* all is well */
    TB_CAN_ERROR_WARNING,    /* an error counter passed 96 */
    TB_CAN_ERROR_PASSIVE,    /* an error counter passed 127 */
    TB_CAN_BUS_OFF,          /* cut off from the bus */
    TB_CAN_NOT_OPEN          /* closed, or the device has gone */
} tb_can_state;

/** Counted since the port was opened; every counter stops at its largest value. */
typedef struct {
    uint32_t sent;
    uint32_t received;
    uint32_t refused;    /* frames that could not be sent at once: TB_CAN_FULL */
    uint32_t lost;       /* frames that arrived where there was no room for them */
    uint32_t malformed;  /* what arrived and was no frame */
    uint32_t bus_errors; /* error frames, or errors that the adapter reported */
    uint32_t bus_off;    /* times the bus was cut off */
    uint64_t bits;       /* tb_can_bits of all frames sent and received */
} tb_can_statistics;

typedef struct tb_can_port tb_can_port;

/** What a driver does for its port; only close may wait, for a moment. */
typedef struct {
    tb_can_result (*send)(tb_can_port *port, const tb_can_frame *frame);
    tb_can_result (*receive)(tb_can_port *port, tb_can_frame *frame);
    tb_can_state (*state)(tb_can_port *port);
    void (*close)(tb_can_port *port);
} tb_can_driver;

/** A port; the first member of every driver's own struct. */
struct tb_can_port {
    const tb_can_driver *driver;
    tb_can_statistics statistics;
};

/** Bits that a classic frame takes on the bus, with the pause behind it; stuff bits not counted. */
static inline uint64_t tb_can_bits(const tb_can_frame *frame)
{
    bool const has_data = (frame->flags & TB_CAN_REMOTE) == 0;
    uint64_t const frame_bits = ((frame->flags & TB_CAN_EXTENDED) != 0) ? 67u : 47u;
    return frame_bits + (has_data ? (uint64_t)frame->length * 8u : 0u);
}

/** Send a frame, now or never. */
static inline tb_can_result tb_can_send(tb_can_port *port, const tb_can_frame *frame)
{
    tb_can_result const result = port->driver->send(port, frame);
    port->statistics.bits += (result == TB_CAN_OK) ? tb_can_bits(frame) : 0u;
    return result;
}

/** Take the frame that has waited longest; TB_CAN_EMPTY where there is none. */
static inline tb_can_result tb_can_receive(tb_can_port *port, tb_can_frame *frame)
{
    tb_can_result const result = port->driver->receive(port, frame);
    port->statistics.bits += (result == TB_CAN_OK) ? tb_can_bits(frame) : 0u;
    return result;
}

/** How the bus is. */
static inline tb_can_state tb_can_port_state(tb_can_port *port)
{
    return port->driver->state(port);
}

/** Give the device back; frames that wait are dropped. Closing twice does no harm. */
static inline void tb_can_close(tb_can_port *port)
{
    port->driver->close(port);
}

/** Add to a counter, as far as it goes. */
static inline void tb_can_count(uint32_t *counter, uint32_t more)
{
    *counter = (more < UINT32_MAX - *counter) ? (*counter + more) : UINT32_MAX;
}

/** Whether a frame can exist, and fits: identifier, length and flags belong together. */
bool tb_can_is_frame(const tb_can_frame *frame);

/** Bytes of data (0..64) that a data length code (0..15; its low four bits) stands for. */
uint8_t tb_can_length_of_code(uint8_t code);

/** The least data length code (0..15) whose frame has room for `length` bytes (0..64). */
uint8_t tb_can_code_of_length(uint8_t length);

/** What a result means and what to do about it: for people, without the name of the device. */
const char *tb_can_result_text(tb_can_result result);

#ifdef __cplusplus
}
#endif

#endif
