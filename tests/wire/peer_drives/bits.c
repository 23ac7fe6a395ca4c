/* A frame's bits (ISO 11898-1): arbitration, check sequence, stuff bits, length. */
#include "peer.h"

enum { MOST_BITS = 1 + 11 + 2 + 18 + 3 + 4 + 64 + 15, TRAILER_BITS = 13 };

typedef struct {
    uint8_t bit[MOST_BITS];
    unsigned count;
} pattern;

static void append(pattern *const to, uint32_t const value, unsigned const width)
{
    for (unsigned i = width; i-- > 0;) {
        to->bit[to->count++] = (uint8_t)(value >> i & 1U);
    }
}

static void append_identifier(pattern *const to, peer_frame const *const frame)
{
    append(to, 0, 1); /* start of frame */
    if (frame->extended) {
        append(to, frame->id >> 18, 11);
        append(to, 3, 2); /* SRR, IDE */
        append(to, frame->id, 18);
        append(to, frame->remote, 1);
        append(to, 0, 2); /* reserved */
    } else {
        append(to, frame->id, 11);
        append(to, frame->remote, 1);
        append(to, 0, 2); /* IDE, reserved */
    }
}

static uint16_t crc15(pattern const *const bits)
{
    uint32_t crc = 0;
    for (unsigned i = 0; i < bits->count; i++) {
        uint32_t const next = bits->bit[i] ^ (crc >> 14 & 1U);
        crc = (crc << 1 & 0x7FFFU) ^ (next != 0 ? 0x4599U : 0U);
    }
    return (uint16_t)crc;
}

static pattern before_crc(peer_frame const *const frame)
{
    pattern bits;
    bits.count = 0;
    append_identifier(&bits, frame);
    append(&bits, frame->length, 4);
    for (unsigned i = 0; !frame->remote && i < frame->length; i++) {
        append(&bits, frame->data[i], 8);
    }
    return bits;
}

static unsigned stuff_bits(pattern const *const bits)
{
    unsigned stuffed = 0;
    unsigned run = 0;
    unsigned last = 2;
    for (unsigned i = 0; i < bits->count; i++) {
        run = bits->bit[i] == last ? run + 1 : 1;
        last = bits->bit[i];
        if (run == 5) { /* the bit stuffed begins a run of its own */
            stuffed++;
            last ^= 1U;
            run = 1;
        }
    }
    return stuffed;
}

uint16_t peer_frame_crc(peer_frame const *const frame)
{
    pattern const bits = before_crc(frame);
    return crc15(&bits);
}

uint32_t peer_frame_bits(peer_frame const *const frame)
{
    pattern bits = before_crc(frame);
    append(&bits, crc15(&bits), 15);
    return bits.count + stuff_bits(&bits) + TRAILER_BITS;
}

uint32_t peer_frame_bits_worst(peer_frame const *const frame)
{
    uint32_t const data = frame->remote ? 0U : frame->length;
    return (frame->extended ? 80U : 55U) + 10U * data;
}

uint64_t frame_arbitration(peer_frame const *const frame)
{
    pattern bits;
    bits.count = 0;
    append_identifier(&bits, frame);
    uint64_t value = 0;
    for (unsigned i = 0; i < 33; i++) { /* what a shorter identifier lacks never decides */
        value = value << 1 | (i < bits.count ? bits.bit[i] : 0U);
    }
    return value;
}

bool frame_valid(peer_frame const *const frame)
{
    return frame->length <= 8 && frame->id < (frame->extended ? 1U << 29 : 1U << 11);
}

bool frame_equal(peer_frame const *const a, peer_frame const *const b)
{
    bool const same = a->id == b->id && a->extended == b->extended && a->remote == b->remote &&
                      a->length == b->length;
    return same && (a->remote || memcmp(a->data, b->data, a->length) == 0);
}

peer_time bits_time(uint32_t const bits, uint32_t const bit_rate)
{
    return (peer_time)((bits * 1000000000ULL + bit_rate / 2) / bit_rate);
}
