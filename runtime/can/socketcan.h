/* A CAN interface of the Linux kernel (SocketCAN): can0, vcan0.
 *
 * The kernel may hold about TB_SOCKETCAN_AHEAD frames that are not yet on the wire; one more is
 * refused. The queue of the interface is shared with other programs: keep it short too (ip link
 * set can0 txqueuelen 10). Bit rate and restart after bus-off are the interface's (ip link set can0
 * type can bitrate 1000000 restart-ms 0). Frames of this port do not come back to it. */
#ifndef TB_SOCKETCAN_H
#define TB_SOCKETCAN_H

#include "can.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TB_SOCKETCAN_AHEAD 16u        /* frames on their way */
#define TB_SOCKETCAN_READ_AT_ONCE 16u /* frames a system call reads */
#define TB_SOCKETCAN_MOST_FILTERS 32u

/** An interface. */
typedef struct {
    tb_can_port port;
    tb_can_state state;
    int socket;    /* file descriptor; below 0: closed */
    bool fd;       /* carries CAN FD */
    uint32_t lost; /* frames the kernel had no room for, as it counts them */
    uint32_t next; /* first of `frames` that is not yet received */
    uint32_t end;
    tb_can_frame frames[TB_SOCKETCAN_READ_AT_ONCE];
} tb_socketcan;

/** What passes to the port. */
typedef struct {
    const tb_can_filter *filters; /* frames that pass any of these; none given: all frames */
    uint32_t count;               /* at most TB_SOCKETCAN_MOST_FILTERS */
    bool fd;                      /* CAN FD frames too: TB_CAN_MOST_DATA must be 64u */
} tb_socketcan_options;

/** Open the interface called `name`.
 *  TB_CAN_OK, or why not: TB_CAN_UNSUPPORTED (no SocketCAN in this kernel), TB_CAN_NO_DEVICE,
 *  TB_CAN_NO_PERMISSION, TB_CAN_NOT_CAN, TB_CAN_DOWN or TB_CAN_REFUSED (no FD, too many filters). */
tb_can_result tb_socketcan_open(tb_socketcan *socketcan, const char *name,
                                const tb_socketcan_options *options);

#ifdef __cplusplus
}
#endif

#endif
