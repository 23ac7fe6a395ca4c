/* A serial adapter with the Lawicel text protocol, between the master and its bus. */
#include "peer.h"

enum { BELL = 7, PIECE_ODDS = 4 };

static char const digits_of[][17] = {"0123456789ABCDEF", "0123456789abcdef"};

static void put_byte(peer *const p, bus *const b, uint8_t const byte)
{
    adapter *const a = &b->adapter;
    if (a->count == LINE_BYTES) {
        b->counters.overflows++;
        return;
    }
    peer_time ready = p->now + b->config.variation.latency;
    if (a->count > 0) {
        line_byte const *const last = &a->out[(a->first + a->count - 1) % LINE_BYTES];
        peer_time const most = b->config.variation.piece_delay;
        peer_time const pause = last->ends_piece ? random_delay(p, most) : 0;
        ready = last->ready + pause > ready ? last->ready + pause : ready;
    }
    bool const cut = b->config.variation.pieces && random_below(p, PIECE_ODDS) == 0;
    a->out[(a->first + a->count++) % LINE_BYTES] = (line_byte){byte, cut, ready};
}

static void put_text(peer *const p, bus *const b, char const *const text)
{
    for (char const *c = text; *c != '\0'; c++) {
        put_byte(p, b, (uint8_t)*c);
    }
}

static void put_line(peer *const p, bus *const b, char const *const text)
{
    put_text(p, b, text);
    put_text(p, b, b->config.variation.line_feed ? "\r\n" : "\r");
}

static void acknowledge(peer *const p, bus *const b, char const *const text)
{
    if (b->config.variation.acknowledgement != PEER_ACK_NONE) {
        put_line(p, b, text);
    }
}

static void refuse(peer *const p, bus *const b)
{
    if (b->config.variation.acknowledgement != PEER_ACK_NONE) {
        put_byte(p, b, BELL);
    }
}

void adapter_begin(peer *const p, bus *const b)
{
    if (b->config.variation.stale) {
        put_text(p, b, "34567890\rt18"); /* the end of one old line and the begin of another */
    }
}

bool adapter_on_wire(bus const *const b)
{
    adapter const *const a = &b->adapter;
    return !b->config.adapter || (a->open && !a->listen && a->bit_rate == b->config.bit_rate);
}

static char *put_hex(bus const *const b, char *to, uint32_t const value, unsigned const width)
{
    for (unsigned i = width; i-- > 0;) {
        *to++ = digits_of[b->config.variation.lower_case][value >> 4 * i & 15U];
    }
    return to;
}

void adapter_frame(peer *const p, bus *const b, peer_frame const *const frame)
{
    char text[40];
    char *to = text;
    *to++ = frame->extended ? (frame->remote ? 'R' : 'T') : (frame->remote ? 'r' : 't');
    to = put_hex(b, to, frame->id, frame->extended ? 8 : 3);
    to = put_hex(b, to, frame->length, 1);
    for (unsigned i = 0; !frame->remote && i < frame->length; i++) {
        to = put_hex(b, to, frame->data[i], 2);
    }
    if (b->adapter.timestamps || b->config.variation.timestamps) {
        to = put_hex(b, to, (uint32_t)(p->now / MILLISECOND % 60000), 4);
    }
    *to = '\0';
    put_line(p, b, text);
}

static int hex_digit(char const c)
{
    if (c >= '0' && c <= '9') {
        return c - '0';
    }
    if (c >= 'A' && c <= 'F') {
        return c - 'A' + 10;
    }
    return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/* A number of so many digits; false when one of them is none. */
static bool take_hex(char const **const from, unsigned const width, uint32_t *const value)
{
    *value = 0;
    for (unsigned i = 0; i < width; i++) {
        int const digit = hex_digit(**from);
        if (digit < 0) {
            return false;
        }
        *value = *value << 4 | (uint32_t)digit;
        (*from)++;
    }
    return true;
}

static bool parse_frame(char const *text, peer_frame *const frame)
{
    uint32_t value = 0;
    *frame = (peer_frame){.extended = *text == 'T' || *text == 'R',
                          .remote = *text == 'r' || *text == 'R'};
    text++;
    if (!take_hex(&text, frame->extended ? 8 : 3, &frame->id) || !take_hex(&text, 1, &value)) {
        return false;
    }
    frame->length = (uint8_t)value;
    if (!frame_valid(frame)) {
        return false;
    }
    for (unsigned i = 0; !frame->remote && i < frame->length; i++) {
        if (!take_hex(&text, 2, &value)) {
            return false;
        }
        frame->data[i] = (uint8_t)value;
    }
    return *text == '\0';
}

static void transmit(peer *const p, bus *const b)
{
    uint32_t const number = (uint32_t)(b - p->bus);
    char const *const accepted[] = {
        [PEER_ACK_Z] = b->adapter.line[0] == 'T' || b->adapter.line[0] == 'R' ? "Z" : "z",
        [PEER_ACK_CR] = "",
        [PEER_ACK_NONE] = ""};
    peer_frame frame;
    bool const able = b->adapter.open && !b->adapter.listen && parse_frame(b->adapter.line, &frame);
    if (able && peer_send(p, number, p->now, &frame)) {
        acknowledge(p, b, accepted[b->config.variation.acknowledgement]);
    } else {
        refuse(p, b);
    }
}

/* S0..S8; S7 is 800k with some makers, 750k with others: here what the bus has of the two. */
static bool set_rate(bus *const b)
{
    static uint32_t const rates[] = {10000,  20000,  50000,  100000, 125000,
                                     250000, 500000, 800000, 1000000};
    char const digit = b->adapter.line[1];
    if (b->adapter.open || b->adapter.length != 2 || digit < '0' || digit > '8') {
        return false;
    }
    uint32_t const rate = rates[digit - '0'];
    b->adapter.bit_rate = rate == 800000 && b->config.bit_rate == 750000 ? 750000 : rate;
    return true;
}

static bool open_channel(bus *const b, bool const listen)
{
    if (b->adapter.open || b->adapter.bit_rate == 0) {
        return false;
    }
    b->adapter.open = true;
    b->adapter.listen = listen;
    return true;
}

static bool close_channel(bus *const b)
{
    bool const open = b->adapter.open;
    b->adapter.open = false;
    b->master = (fifo){0}; /* what was not sent never is */
    return open;
}

static bool set_timestamps(bus *const b)
{
    if (b->adapter.open || b->adapter.length != 2) {
        return false;
    }
    b->adapter.timestamps = b->adapter.line[1] == '1';
    return true;
}

/* A command that is answered with CR or BELL. */
static bool command(bus *const b)
{
    switch (b->adapter.line[0]) {
    case 'S': return set_rate(b);
    case 'O': return open_channel(b, false);
    case 'L': return open_channel(b, true);
    case 'C': return close_channel(b);
    case 'Z': return set_timestamps(b);
    case 's':
    case 'M':
    case 'm':
    case 'W': return !b->adapter.open;
    case 'X':
    case 'E': return true;
    default: return false;
    }
}

static void execute(peer *const p, bus *const b)
{
    adapter *const a = &b->adapter;
    switch (a->line[0]) {
    case 't':
    case 'T':
    case 'r':
    case 'R': transmit(p, b); break;
    case 'V': put_line(p, b, "V1013"); break;
    case 'N': put_line(p, b, "NP402"); break;
    case 'F':
        if (a->open) {
            put_line(p, b, "F00");
        } else {
            refuse(p, b);
        }
        break;
    case '\0': acknowledge(p, b, ""); break;
    default:
        if (command(b)) {
            acknowledge(p, b, "");
        } else {
            refuse(p, b);
        }
    }
}

void peer_write(peer *const p, uint32_t const number, uint8_t const *const bytes,
                size_t const count)
{
    bus *const b = &p->bus[number];
    adapter *const a = &b->adapter;
    for (size_t i = 0; i < count; i++) {
        if (bytes[i] == '\r') {
            a->line[a->length] = '\0';
            execute(p, b);
            a->length = 0;
        } else if (bytes[i] != '\n' && a->length < sizeof a->line - 1) {
            a->line[a->length++] = (char)bytes[i];
        }
    }
}

size_t peer_read(peer *const p, uint32_t const number, uint8_t *const bytes, size_t const room)
{
    adapter *const a = &p->bus[number].adapter;
    size_t count = 0;
    bool end = false;
    while (!end && count < room && a->count > 0 && a->out[a->first].ready <= p->now) {
        bytes[count++] = a->out[a->first].byte;
        end = a->out[a->first].ends_piece;
        a->first = (a->first + 1) % LINE_BYTES;
        a->count--;
    }
    return count;
}
