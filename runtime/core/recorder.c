#include "recorder.h"

#include <stdbool.h>

_Static_assert(sizeof(TB_MACHINE_NAME) <= TB_RECORDING_NAME, "the machine's name is too long");
_Static_assert(sizeof(TB_MACHINE_HASH) <= TB_RECORDING_NAME, "the machine's hash is too long");

#define HEAD_SIZE offsetof(tb_segment, cycles)
/* What of a segment is read next. */
enum { MEMORY, CYCLES, HEAD, HEADER };

#define CYCLES_AFTER (TB_SEGMENT_CYCLES * TB_RECORDER_SEGMENTS / 2u)

static void open_segment(tb_recorder *recorder, const tb_supervisor *supervisor)
{
    tb_segment *const segment = &recorder->segments[recorder->opened % TB_RECORDER_SEGMENTS];
    segment->head = (tb_segment_head){.first = recorder->number};
    segment->before = *supervisor;
    recorder->opened++;
}

static uint32_t newest(const tb_recorder *recorder)
{
    return (recorder->opened - 1u) % TB_RECORDER_SEGMENTS;
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
    tb_segment *const segment = &recorder->segments[newest(recorder)];
    segment->cycles[segment->head.count].seen = *seen;
    segment->cycles[segment->head.count].orders = *orders;
    segment->head.count++;
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
    bool const full = recorder->segments[newest(recorder)].head.count == TB_SEGMENT_CYCLES;
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

tb_recorder_mark tb_recorder_now(const tb_recorder *recorder)
{
    return (tb_recorder_mark){recorder->opened, recorder->segments[newest(recorder)].head.count};
}

/* CRC-32, four bits at a time. */
static uint32_t checksum(uint32_t sum, const void *begin, size_t size)
{
    static const uint32_t steps[16] = {0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu,
                                       0x76DC4190u, 0x6B6B51F4u, 0x4DB26158u, 0x5005713Cu,
                                       0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
                                       0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu};
    const unsigned char *const bytes = begin;
    sum = ~sum;
    for (size_t i = 0; i < size; i++) {
        sum ^= bytes[i];
        sum = (sum >> 4) ^ steps[sum & 15u];
        sum = (sum >> 4) ^ steps[sum & 15u];
    }
    return ~sum;
}

static size_t layout_size(void)
{
    return tb_recording_layout_rows * sizeof(tb_layout_row);
}

/* Where the segments begin in the file. */
static size_t segments_begin(void)
{
    return sizeof(tb_recording_header) + layout_size();
}

size_t tb_recording_size(uint32_t segments)
{
    return segments_begin() + ((size_t)segments * sizeof(tb_segment));
}

void tb_recorder_open(tb_recorder_reader *reader, const tb_recorder *recorder)
{
    *reader = (tb_recorder_reader){
        .recorder = recorder,
        .header = {.version = TB_RECORDING_VERSION,
                   .byte_order = TB_RECORDING_BYTE_ORDER,
                   .layout_rows = tb_recording_layout_rows,
                   .layout_checksum = checksum(0, tb_recording_layout, layout_size()),
                   .head_size = (uint32_t)HEAD_SIZE,
                   .segment_size = (uint32_t)sizeof(tb_segment),
                   .segment_cycles = TB_SEGMENT_CYCLES},
    };
    copy_text(sizeof(reader->header.magic), TB_RECORDING_MAGIC, reader->header.magic);
    copy_text(sizeof(TB_MACHINE_NAME), TB_MACHINE_NAME, reader->header.machine);
    copy_text(sizeof(TB_MACHINE_HASH), TB_MACHINE_HASH, reader->header.hash);
}

static const tb_segment *segment_of(const tb_recorder_reader *reader)
{
    return &reader->recorder->segments[reader->segment % TB_RECORDER_SEGMENTS];
}

/* Bytes of the segment that is read, with their place in the file. */
static tb_recorder_piece part(const tb_recorder_reader *reader, const void *bytes, size_t begin,
                              size_t size)
{
    size_t const place = (size_t)(reader->segment % TB_RECORDER_SEGMENTS) * sizeof(tb_segment);
    return (tb_recorder_piece){bytes, size, segments_begin() + place + begin};
}

/* The memory and everything up to the first cycle. */
static tb_recorder_piece read_memory(tb_recorder_reader *reader)
{
    size_t const begin = offsetof(tb_segment, before);
    const void *const memory = &segment_of(reader)->before;
    reader->checksum = checksum(0, memory, HEAD_SIZE - begin);
    return part(reader, memory, begin, HEAD_SIZE - begin);
}

static tb_recorder_piece read_cycles(tb_recorder_reader *reader, uint32_t count)
{
    const tb_recorded_cycle *const cycles = &segment_of(reader)->cycles[reader->cycles];
    size_t const begin = HEAD_SIZE + (reader->cycles * sizeof(tb_recorded_cycle));
    size_t const size = (count - reader->cycles) * sizeof(tb_recorded_cycle);
    reader->checksum = checksum(reader->checksum, cycles, size);
    reader->cycles = count;
    return part(reader, cycles, begin, size);
}

/* The head comes after what it counts: a reader of the file believes it. */
static tb_recorder_piece read_head(tb_recorder_reader *reader)
{
    reader->head =
        (tb_segment_head){.first = segment_of(reader)->head.first, .count = reader->cycles};
    reader->head.checksum =
        checksum(reader->checksum, &reader->head, offsetof(tb_segment_head, checksum));
    return part(reader, &reader->head, 0, sizeof(reader->head));
}

static tb_recorder_piece read_layout(tb_recorder_reader *reader)
{
    reader->described = 1;
    return (tb_recorder_piece){tb_recording_layout, layout_size(), sizeof(tb_recording_header)};
}

static tb_recorder_piece read_header(tb_recorder_reader *reader)
{
    uint32_t const used = reader->segment + 1u;
    reader->header.segments = (used < TB_RECORDER_SEGMENTS) ? used : TB_RECORDER_SEGMENTS;
    return (tb_recorder_piece){&reader->header, sizeof(reader->header), 0};
}

static void begin_segment(tb_recorder_reader *reader, uint32_t segment)
{
    reader->segment = segment;
    reader->cycles = 0;
    reader->stage = MEMORY;
}

/* Cycles of the segment that is read, as far as the mark goes. */
static uint32_t available(const tb_recorder_reader *reader, tb_recorder_mark mark)
{
    uint32_t const number = reader->segment + 1u;
    return (number > mark.opened)    ? 0u
           : (number == mark.opened) ? mark.count
                                     : segment_of(reader)->head.count;
}

/* Go on to the next segment after one that is complete, and past those that the ring has overtaken. */
static void find_segment(tb_recorder_reader *reader, tb_recorder_mark mark)
{
    uint32_t const oldest =
        (mark.opened > TB_RECORDER_SEGMENTS) ? (mark.opened - TB_RECORDER_SEGMENTS) : 0u;
    if (reader->segment < oldest) {
        begin_segment(reader, oldest);
    } else if ((reader->stage == CYCLES) && (reader->cycles == available(reader, mark)) &&
               ((reader->segment + 1u) < mark.opened)) {
        begin_segment(reader, reader->segment + 1u);
    }
}

tb_recorder_piece tb_recorder_read(tb_recorder_reader *reader, tb_recorder_mark mark)
{
    find_segment(reader, mark);
    uint32_t const count = available(reader, mark);
    bool const is_new = reader->cycles < count;
    if (is_new && (reader->described == 0)) {
        return read_layout(reader);
    }
    switch (reader->stage) {
    case MEMORY:
        reader->stage = is_new ? CYCLES : MEMORY;
        return is_new ? read_memory(reader) : (tb_recorder_piece){NULL, 0, 0};
    case CYCLES:
        reader->stage = is_new ? HEAD : CYCLES;
        return is_new ? read_cycles(reader, count) : (tb_recorder_piece){NULL, 0, 0};
    case HEAD:
        reader->stage = HEADER;
        return read_head(reader);
    default:
        reader->stage = CYCLES;
        return read_header(reader);
    }
}

tb_recorder_piece tb_recorder_close(tb_recorder_reader *reader)
{
    reader->header.ended = 1;
    return (tb_recorder_piece){&reader->header, sizeof(reader->header), 0};
}
