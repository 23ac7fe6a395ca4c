#define _GNU_SOURCE /* recvmmsg */

#include "socketcan.h"

#include <errno.h>
#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#define CLOSED (-1)
#define BYTES_OF_FRAME 768 /* that the kernel counts for a frame on its way */
#define MOST_READS 4u      /* system calls in one receive: more are error frames without end */
#define CONTROLLER_BYTE 1u /* of an error frame: what the controller reports */

static const tb_can_statistics nothing_yet = {0};

/* Room for a number from the kernel beside a frame. */
typedef struct {
    _Alignas(struct cmsghdr) char bytes[CMSG_SPACE(sizeof(uint32_t))];
} tb_control;

/* What one system call reads. */
typedef struct {
    struct canfd_frame frames[TB_SOCKETCAN_READ_AT_ONCE];
    struct iovec places[TB_SOCKETCAN_READ_AT_ONCE];
    tb_control controls[TB_SOCKETCAN_READ_AT_ONCE];
    struct mmsghdr messages[TB_SOCKETCAN_READ_AT_ONCE];
} tb_batch;

static tb_socketcan *socketcan_of(tb_can_port *port)
{
    return (tb_socketcan *)(void *)port;
}

/* The interface is down or has gone: nothing will come of it until it is opened again. */
static tb_can_result lose_interface(tb_socketcan *socketcan)
{
    socketcan->state = TB_CAN_NOT_OPEN;
    return TB_CAN_CLOSED;
}

static bool is_only_busy(int error)
{
    return (error == EAGAIN) || (error == EWOULDBLOCK) || (error == EINTR) || (error == ENOBUFS);
}

static canid_t id_and_flags(const tb_can_frame *frame)
{
    canid_t id = frame->id;
    id |= ((frame->flags & TB_CAN_EXTENDED) != 0) ? CAN_EFF_FLAG : 0;
    id |= ((frame->flags & TB_CAN_REMOTE) != 0) ? CAN_RTR_FLAG : 0;
    return id;
}

static struct canfd_frame for_kernel(const tb_can_frame *frame)
{
    struct canfd_frame raw = {0};
    raw.can_id = id_and_flags(frame);
    raw.len = frame->length;
    raw.flags = ((frame->flags & TB_CAN_BIT_RATE_SWITCH) != 0) ? CANFD_BRS : 0;
    memcpy(raw.data, frame->data, frame->length);
    return raw;
}

static tb_can_result why_not_sent(tb_socketcan *socketcan, int error)
{
    if (is_only_busy(error)) {
        tb_can_count(&socketcan->port.statistics.refused, 1);
        return TB_CAN_FULL;
    }
    return lose_interface(socketcan);
}

static tb_can_result send_frame(tb_can_port *port, const tb_can_frame *frame)
{
    tb_socketcan *const socketcan = socketcan_of(port);
    bool const fd = (frame->flags & TB_CAN_FD) != 0;
    if (socketcan->state == TB_CAN_NOT_OPEN) {
        return TB_CAN_CLOSED;
    }
    if (!tb_can_is_frame(frame) || (fd && !socketcan->fd)) {
        return TB_CAN_REFUSED;
    }
    if (socketcan->state == TB_CAN_BUS_OFF) {
        return why_not_sent(socketcan, ENOBUFS);
    }
    struct canfd_frame const raw = for_kernel(frame);
    if (send(socketcan->socket, &raw, fd ? CANFD_MTU : CAN_MTU, MSG_DONTWAIT) < 0) {
        return why_not_sent(socketcan, errno);
    }
    tb_can_count(&port->statistics.sent, 1);
    return TB_CAN_OK;
}

static void take_controller_state(tb_socketcan *socketcan, uint8_t reported)
{
    if ((reported & CAN_ERR_CRTL_RX_OVERFLOW) != 0) {
        tb_can_count(&socketcan->port.statistics.lost, 1);
    }
    if ((reported & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0) {
        socketcan->state = TB_CAN_ERROR_PASSIVE;
    } else if ((reported & (CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING)) != 0) {
        socketcan->state = TB_CAN_ERROR_WARNING;
    } else if ((reported & CAN_ERR_CRTL_ACTIVE) != 0) {
        socketcan->state = TB_CAN_ERROR_ACTIVE;
    }
}

static void take_error(tb_socketcan *socketcan, const struct canfd_frame *raw)
{
    tb_can_statistics *const statistics = &socketcan->port.statistics;
    tb_can_count(&statistics->bus_errors, 1);
    if ((raw->can_id & CAN_ERR_RESTARTED) != 0) {
        socketcan->state = TB_CAN_ERROR_ACTIVE;
    }
    if ((raw->can_id & CAN_ERR_CRTL) != 0) {
        take_controller_state(socketcan, raw->data[CONTROLLER_BYTE]);
    }
    if ((raw->can_id & CAN_ERR_BUSOFF) != 0) {
        tb_can_count(&statistics->bus_off, 1);
        socketcan->state = TB_CAN_BUS_OFF;
    }
}

static tb_can_frame from_kernel(const struct canfd_frame *raw, bool fd)
{
    tb_can_frame frame = {0};
    bool const extended = (raw->can_id & CAN_EFF_FLAG) != 0;
    bool const remote = (raw->can_id & CAN_RTR_FLAG) != 0;
    bool const fast = fd && ((raw->flags & CANFD_BRS) != 0);
    frame.id = raw->can_id & (extended ? CAN_EFF_MASK : CAN_SFF_MASK);
    frame.flags = (uint8_t)((extended ? TB_CAN_EXTENDED : 0) | (remote ? TB_CAN_REMOTE : 0) |
                            (fd ? TB_CAN_FD : 0) | (fast ? TB_CAN_BIT_RATE_SWITCH : 0));
    frame.length = raw->len;
    memcpy(frame.data, raw->data, raw->len);
    return frame;
}

static void take_message(tb_socketcan *socketcan, const struct canfd_frame *raw, size_t size)
{
    if ((size != CAN_MTU) && (size != CANFD_MTU)) {
        tb_can_count(&socketcan->port.statistics.malformed, 1);
    } else if ((raw->can_id & CAN_ERR_FLAG) != 0) {
        take_error(socketcan, raw);
    } else if (raw->len > TB_CAN_MOST_DATA) {
        tb_can_count(&socketcan->port.statistics.malformed, 1);
    } else {
        socketcan->frames[socketcan->end] = from_kernel(raw, size == CANFD_MTU);
        socketcan->end++;
    }
}

/* Beside a frame the kernel says how many it has dropped until then. */
static void take_losses(tb_socketcan *socketcan, struct msghdr *message)
{
    for (struct cmsghdr *part = CMSG_FIRSTHDR(message); part != NULL;
         part = CMSG_NXTHDR(message, part)) {
        if ((part->cmsg_level == SOL_SOCKET) && (part->cmsg_type == SO_RXQ_OVFL)) {
            uint32_t lost = 0;
            memcpy(&lost, CMSG_DATA(part), sizeof lost);
            tb_can_count(&socketcan->port.statistics.lost, lost - socketcan->lost);
            socketcan->lost = lost;
        }
    }
}

static void prepare(tb_batch *batch)
{
    memset(batch, 0, sizeof *batch);
    for (uint32_t i = 0; i < TB_SOCKETCAN_READ_AT_ONCE; i++) {
        struct msghdr *const message = &batch->messages[i].msg_hdr;
        batch->places[i].iov_base = &batch->frames[i];
        batch->places[i].iov_len = sizeof batch->frames[i];
        message->msg_iov = &batch->places[i];
        message->msg_iovlen = 1;
        message->msg_control = batch->controls[i].bytes;
        message->msg_controllen = sizeof batch->controls[i];
    }
}

static tb_can_result read_frames(tb_socketcan *socketcan)
{
    tb_batch batch;
    prepare(&batch);
    socketcan->next = 0;
    socketcan->end = 0;
    int const count =
        recvmmsg(socketcan->socket, batch.messages, TB_SOCKETCAN_READ_AT_ONCE, MSG_DONTWAIT, NULL);
    if (count < 0) {
        return is_only_busy(errno) ? TB_CAN_EMPTY : lose_interface(socketcan);
    }
    for (int i = 0; i < count; i++) {
        take_losses(socketcan, &batch.messages[i].msg_hdr);
        take_message(socketcan, &batch.frames[i], batch.messages[i].msg_len);
    }
    return TB_CAN_OK;
}

static tb_can_result receive_frame(tb_can_port *port, tb_can_frame *frame)
{
    tb_socketcan *const socketcan = socketcan_of(port);
    tb_can_result result = (socketcan->state == TB_CAN_NOT_OPEN) ? TB_CAN_CLOSED : TB_CAN_OK;
    for (uint8_t reads = 0; (result == TB_CAN_OK) && (reads < MOST_READS); reads++) {
        if (socketcan->next < socketcan->end) {
            *frame = socketcan->frames[socketcan->next];
            socketcan->next++;
            tb_can_count(&port->statistics.received, 1);
            return TB_CAN_OK;
        }
        result = read_frames(socketcan);
    }
    return (result == TB_CAN_OK) ? TB_CAN_EMPTY : result;
}

static tb_can_state bus_state(tb_can_port *port)
{
    return socketcan_of(port)->state;
}

static void close_port(tb_can_port *port)
{
    tb_socketcan *const socketcan = socketcan_of(port);
    if (socketcan->socket >= 0) {
        (void)close(socketcan->socket);
    }
    socketcan->socket = CLOSED;
    socketcan->state = TB_CAN_NOT_OPEN;
}

static tb_can_result open_socket(tb_socketcan *socketcan)
{
    socketcan->socket = socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW);
    if (socketcan->socket >= 0) {
        return TB_CAN_OK;
    }
    return ((errno == EPERM) || (errno == EACCES)) ? TB_CAN_NO_PERMISSION : TB_CAN_UNSUPPORTED;
}

/* Ask the kernel one thing about an interface; false when it is not there. */
static bool ask(const tb_socketcan *socketcan, const char *name, unsigned long question,
                struct ifreq *answer)
{
    memset(answer, 0, sizeof *answer);
    memcpy(answer->ifr_name, name, strnlen(name, IFNAMSIZ - 1));
    return ioctl(socketcan->socket, question, answer) == 0;
}

/* Whether the interface is what was asked for, and its number. */
static tb_can_result find_interface(const tb_socketcan *socketcan, const char *name, int *number)
{
    struct ifreq answer;
    if ((strnlen(name, IFNAMSIZ) == IFNAMSIZ) || !ask(socketcan, name, SIOCGIFHWADDR, &answer)) {
        return TB_CAN_NO_DEVICE;
    }
    if (answer.ifr_hwaddr.sa_family != ARPHRD_CAN) {
        return TB_CAN_NOT_CAN;
    }
    if (!ask(socketcan, name, SIOCGIFFLAGS, &answer) || ((answer.ifr_flags & IFF_UP) == 0)) {
        return TB_CAN_DOWN;
    }
    bool const carries_fd =
        ask(socketcan, name, SIOCGIFMTU, &answer) && (answer.ifr_mtu >= (int)CANFD_MTU);
    if (socketcan->fd && (!carries_fd || (TB_CAN_MOST_DATA < CANFD_MAX_DLEN))) {
        return TB_CAN_REFUSED;
    }
    if (!ask(socketcan, name, SIOCGIFINDEX, &answer)) {
        return TB_CAN_NO_DEVICE;
    }
    *number = answer.ifr_ifindex;
    return TB_CAN_OK;
}

static bool set(const tb_socketcan *socketcan, int level, int option, const void *value,
                size_t size)
{
    return setsockopt(socketcan->socket, level, option, value, (socklen_t)size) == 0;
}

static bool set_filters(const tb_socketcan *socketcan, const tb_socketcan_options *options)
{
    struct can_filter filters[TB_SOCKETCAN_MOST_FILTERS];
    if (options->count > TB_SOCKETCAN_MOST_FILTERS) {
        return false;
    }
    for (uint32_t i = 0; i < options->count; i++) {
        canid_t const kind = options->filters[i].extended ? CAN_EFF_FLAG : 0;
        filters[i].can_id = options->filters[i].id | kind;
        filters[i].can_mask = options->filters[i].mask | CAN_EFF_FLAG;
    }
    return (options->count == 0) ||
           set(socketcan, SOL_CAN_RAW, CAN_RAW_FILTER, filters, options->count * sizeof filters[0]);
}

static bool set_options(const tb_socketcan *socketcan, const tb_socketcan_options *options)
{
    int const on = 1;
    int const off = 0;
    int const fd = socketcan->fd ? 1 : 0;
    can_err_mask_t const every_error = CAN_ERR_MASK;
    /* The kernel doubles the number for its own needs, and counts those. */
    int const room = (int)TB_SOCKETCAN_AHEAD * BYTES_OF_FRAME / 2;
    return set_filters(socketcan, options) &&
           set(socketcan, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, &every_error, sizeof every_error) &&
           set(socketcan, SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, &off, sizeof off) &&
           set(socketcan, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, &fd, sizeof fd) &&
           set(socketcan, SOL_SOCKET, SO_RXQ_OVFL, &on, sizeof on) &&
           set(socketcan, SOL_SOCKET, SO_SNDBUF, &room, sizeof room);
}

static tb_can_result attach(const tb_socketcan *socketcan, int number)
{
    struct sockaddr_can address = {0};
    address.can_family = AF_CAN;
    address.can_ifindex = number;
    if (bind(socketcan->socket, (const struct sockaddr *)(const void *)&address, sizeof address) ==
        0) {
        return TB_CAN_OK;
    }
    return (errno == ENETDOWN) ? TB_CAN_DOWN : TB_CAN_NO_DEVICE;
}

static tb_can_result open_interface(tb_socketcan *socketcan, const char *name,
                                    const tb_socketcan_options *options)
{
    int number = 0;
    tb_can_result result = open_socket(socketcan);
    if (result == TB_CAN_OK) {
        result = find_interface(socketcan, name, &number);
    }
    if (result == TB_CAN_OK) {
        result = set_options(socketcan, options) ? TB_CAN_OK : TB_CAN_REFUSED;
    }
    return (result == TB_CAN_OK) ? attach(socketcan, number) : result;
}

static const tb_can_driver driver = {send_frame, receive_frame, bus_state, close_port};

static void forget_all(tb_socketcan *socketcan)
{
    socketcan->port.driver = &driver;
    socketcan->port.statistics = nothing_yet;
    socketcan->state = TB_CAN_NOT_OPEN;
    socketcan->socket = CLOSED;
    socketcan->lost = 0;
    socketcan->next = 0;
    socketcan->end = 0;
}

tb_can_result tb_socketcan_open(tb_socketcan *socketcan, const char *name,
                                const tb_socketcan_options *options)
{
    forget_all(socketcan);
    socketcan->fd = options->fd;
    tb_can_result const result = open_interface(socketcan, name, options);
    if (result == TB_CAN_OK) {
        socketcan->state = TB_CAN_ERROR_ACTIVE;
    } else {
        close_port(&socketcan->port);
    }
    return result;
}
