#include "recorder.h"

#include <stdbool.h>

_Static_assert(sizeof(TB_MACHINE_NAME) <= TB_RECORDING_NAME, "the machine's name is too long");
_Static_assert(sizeof(TB_MACHINE_HASH) <= TB_RECORDING_NAME, "the machine's hash is too long");

#define HEAD_SIZE offsetof(tb_segment, cycles)
#define CYCLES_AFTER (TB_SEGMENT_CYCLES * TB_RECORDER_SEGMENTS / 2u)

static void open_segment(tb_recorder *recorder, const tb_supervisor *supervisor)
{
    tb_segment *const segment = &recorder->segments[recorder->opened % TB_RECORDER_SEGMENTS];
    segment->first = recorder->number;
    segment->count = 0;
    segment->reserved = 0;
    segment->before = *supervisor;
    recorder->opened++;
}

static tb_segment *newest(tb_recorder *recorder)
{
    return &recorder->segments[(recorder->opened - 1u) % TB_RECORDER_SEGMENTS];
}

void tb_recorder_start(tb_recorder *recorder, const tb_supervisor *supervisor)
{
    recorder->number = 0;
    recorder->opened = 0;
    recorder->since = 0;
    open_segment(recorder, supervisor);
}

static bool is_fault(const tb_orders *orders)
{
    return (orders->cause != TB_CAUSE_NONE) && (orders->cause != TB_CAUSE_REQUESTED);
}

static void append(tb_recorder *recorder, const tb_observation *seen, const tb_orders *orders)
{
    tb_segment *const segment = newest(recorder);
    segment->cycles[segment->count].seen = *seen;
    segment->cycles[segment->count].orders = *orders;
    segment->count++;
}

void tb_recorder_keep(tb_recorder *recorder, const tb_observation *seen, const tb_orders *orders,
                      const tb_supervisor *supervisor)
{
    bool const held = recorder->since >= CYCLES_AFTER;
    bool const fault = is_fault(orders);
    if (!held) {
        append(recorder, seen, orders);
    }
    recorder->number++;
    recorder->since = fault ? (held ? recorder->since : (recorder->since + 1u)) : 0u;
    bool const full = newest(recorder)->count == TB_SEGMENT_CYCLES;
    if ((held && !fault) || (full && (recorder->since < CYCLES_AFTER))) {
        open_segment(recorder, supervisor);
    }
}

static void copy_text(size_t count, const char from[], char to[])
{
    for (size_t i = 0; i < count; i++) {
        to[i] = from[i];
    }
}

static uint32_t count_segments(const tb_recorder *recorder)
{
    return (recorder->opened < TB_RECORDER_SEGMENTS) ? recorder->opened : TB_RECORDER_SEGMENTS;
}

void tb_recorder_open(tb_recorder_reader *reader, const tb_recorder *recorder)
{
    *reader = (tb_recorder_reader){
        .recorder = recorder,
        .header = {.version = TB_RECORDING_VERSION,
                   .byte_order = TB_RECORDING_BYTE_ORDER,
                   .real_size = (uint32_t)sizeof(real_t),
                   .head_size = (uint32_t)HEAD_SIZE,
                   .supervisor_size = (uint32_t)sizeof(tb_supervisor),
                   .observation_size = (uint32_t)sizeof(tb_observation),
                   .orders_size = (uint32_t)sizeof(tb_orders),
                   .cycle_size = (uint32_t)sizeof(tb_recorded_cycle),
                   .segments = count_segments(recorder),
                   .segment_cycles = TB_SEGMENT_CYCLES},
    };
    copy_text(sizeof(reader->header.magic), TB_RECORDING_MAGIC, reader->header.magic);
    copy_text(sizeof(TB_MACHINE_NAME), TB_MACHINE_NAME, reader->header.machine);
    copy_text(sizeof(TB_MACHINE_HASH), TB_MACHINE_HASH, reader->header.hash);
    copy_text(sizeof(reader->end.magic), TB_RECORDING_END_MAGIC, reader->end.magic);
}

/* CRC-32, four bits at a time. */
static uint32_t checksum(uint32_t sum, tb_recorder_piece piece)
{
    static const uint32_t steps[16] = {
        0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu, 0x76DC4190u, 0x6B6B51F4u,
        0x4DB26158u, 0x5005713Cu, 0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
        0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu,
    };
    const unsigned char *const bytes = piece.bytes;
    sum = ~sum;
    for (size_t i = 0; i < piece.size; i++) {
        sum ^= bytes[i];
        sum = (sum >> 4) ^ steps[sum & 15u];
        sum = (sum >> 4) ^ steps[sum & 15u];
    }
    return ~sum;
}

static tb_recorder_piece segment_piece(const tb_recorder_reader *reader, uint32_t index)
{
    const tb_recorder *const recorder = reader->recorder;
    uint32_t const oldest = recorder->opened - reader->header.segments;
    const tb_segment *const segment = &recorder->segments[(oldest + index) % TB_RECORDER_SEGMENTS];
    return (tb_recorder_piece){segment, HEAD_SIZE + (segment->count * sizeof(tb_recorded_cycle))};
}

tb_recorder_piece tb_recorder_read(tb_recorder_reader *reader)
{
    uint32_t const index = reader->next;
    uint32_t const last = reader->header.segments + 1u;
    tb_recorder_piece piece = {NULL, 0};
    if (index == 0u) {
        piece = (tb_recorder_piece){&reader->header, sizeof(reader->header)};
    } else if (index < last) {
        piece = segment_piece(reader, index - 1u);
    } else if (index == last) {
        reader->end.checksum = reader->checksum;
        piece = (tb_recorder_piece){&reader->end, sizeof(reader->end)};
    } else {
        return piece;
    }
    reader->checksum = checksum(reader->checksum, piece);
    reader->next++;
    return piece;
}
