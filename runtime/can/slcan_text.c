#include "slcan_text.h"

#define END_OF_LINE '\r'
#define LINE_FEED '\n'
#define FAILURE '\a'
#define STANDARD_DIGITS 3u
#define EXTENDED_DIGITS 8u
#define STAMP_DIGITS 4u
#define MOST_CLASSIC_CODE 8u
#define TOLD_AGAIN 16384u /* characters of a line that does not end: 1.4 s at 115200 baud */

/* Which letter stands for which flags. */
typedef struct {
    char letter;
    uint8_t flags;
} tb_slcan_kind;

static const tb_slcan_kind kinds[] = {
    {'t', 0},
    {'T', TB_CAN_EXTENDED},
    {'r', TB_CAN_REMOTE},
    {'R', TB_CAN_REMOTE | TB_CAN_EXTENDED},
    {'d', TB_CAN_FD},
    {'D', TB_CAN_FD | TB_CAN_EXTENDED},
    {'b', TB_CAN_FD | TB_CAN_BIT_RATE_SWITCH},
    {'B', TB_CAN_FD | TB_CAN_BIT_RATE_SWITCH | TB_CAN_EXTENDED},
};
#define KINDS (sizeof kinds / sizeof kinds[0])

static const tb_can_frame no_frame = {0};

static char letter_of(uint8_t flags)
{
    char letter = kinds[0].letter;
    for (uint8_t i = 0; i < KINDS; i++) {
        if (kinds[i].flags == flags) {
            letter = kinds[i].letter;
        }
    }
    return letter;
}

static bool find_flags(char letter, uint8_t *flags)
{
    for (uint8_t i = 0; i < KINDS; i++) {
        if (kinds[i].letter == letter) {
            *flags = kinds[i].flags;
            return true;
        }
    }
    return false;
}

static uint8_t id_digits(uint8_t flags)
{
    return ((flags & TB_CAN_EXTENDED) != 0) ? EXTENDED_DIGITS : STANDARD_DIGITS;
}

/* Bytes of data in the line: none when the frame only asks for them. */
static uint8_t data_bytes(const tb_can_frame *frame)
{
    return ((frame->flags & TB_CAN_REMOTE) != 0) ? 0 : frame->length;
}

static char *write_number(char *end, uint32_t value, uint8_t digits)
{
    for (uint8_t i = digits; i > 0; i--) {
        *end = "0123456789ABCDEF"[(value >> (4u * (i - 1u))) & 0xFu];
        end++;
    }
    return end;
}

uint8_t tb_slcan_write(const tb_can_frame *frame, char line[TB_SLCAN_LONGEST_LINE])
{
    char *end = line;
    if (!tb_can_is_frame(frame)) {
        return 0;
    }
    *end = letter_of(frame->flags);
    end = write_number(end + 1, frame->id, id_digits(frame->flags));
    end = write_number(end, tb_can_code_of_length(frame->length), 1);
    for (uint8_t i = 0; i < data_bytes(frame); i++) {
        end = write_number(end, frame->data[i], 2);
    }
    *end = END_OF_LINE;
    return (uint8_t)(end + 1 - line);
}

/* What is left of a line, and whether all of it was a number so far. */
typedef struct {
    const char *next;
    const char *end;
    bool good;
} tb_slcan_rest;

static bool find_digit(char character, uint32_t *digit)
{
    if ((character >= '0') && (character <= '9')) {
        *digit = (uint32_t)(character - '0');
    } else if ((character >= 'A') && (character <= 'F')) {
        *digit = (uint32_t)(character - 'A') + 10u;
    } else if ((character >= 'a') && (character <= 'f')) {
        *digit = (uint32_t)(character - 'a') + 10u;
    } else {
        return false;
    }
    return true;
}

static uint32_t read_number(tb_slcan_rest *rest, uint8_t digits)
{
    uint32_t value = 0;
    for (uint8_t i = 0; i < digits; i++) {
        uint32_t digit = 0;
        if ((rest->next == rest->end) || !find_digit(*rest->next, &digit)) {
            rest->good = false;
            return 0;
        }
        value = (value << 4) | digit;
        rest->next++;
    }
    return value;
}

static bool read_frame(tb_slcan_rest *rest, uint8_t flags, tb_can_frame *frame)
{
    tb_can_frame read = no_frame;
    read.flags = flags;
    read.id = read_number(rest, id_digits(flags));
    uint8_t const code = (uint8_t)read_number(rest, 1);
    if (((flags & TB_CAN_FD) == 0) && (code > MOST_CLASSIC_CODE)) {
        return false;
    }
    read.length = tb_can_length_of_code(code);
    if (!tb_can_is_frame(&read)) {
        return false;
    }
    for (uint8_t i = 0; i < data_bytes(&read); i++) {
        read.data[i] = (uint8_t)read_number(rest, 2);
    }
    if (rest->next != rest->end) {
        (void)read_number(rest, STAMP_DIGITS);
    }
    if (!rest->good || (rest->next != rest->end)) {
        return false;
    }
    *frame = read;
    return true;
}

static tb_slcan_item read_status(tb_slcan_rest *rest, uint8_t *status)
{
    uint8_t const read = (uint8_t)read_number(rest, 2);
    if (!rest->good || (rest->next != rest->end)) {
        return TB_SLCAN_MALFORMED;
    }
    *status = read;
    return TB_SLCAN_STATUS;
}

/* A command that opens, asks or closes: adapters hear it, and say it only where they repeat all. */
static bool is_command(const char *line, uint8_t length)
{
    if (length == 1u) {
        return (line[0] == 'O') || (line[0] == 'C') || (line[0] == 'F');
    }
    return (length == 2u) && (line[0] == 'S') && (line[1] >= '0') && (line[1] <= '8');
}

static tb_slcan_item read_line(tb_slcan_reader *reader, uint8_t length, tb_can_frame *frame)
{
    tb_slcan_rest rest = {reader->line, reader->line + length, true};
    uint8_t flags = 0;
    if (length == 0) {
        return TB_SLCAN_DONE;
    }
    if (is_command(reader->line, length)) {
        return TB_SLCAN_ECHO;
    }
    char const letter = *rest.next;
    rest.next++;
    if (find_flags(letter, &flags)) {
        return read_frame(&rest, flags, frame) ? TB_SLCAN_FRAME : TB_SLCAN_MALFORMED;
    }
    if (letter == 'F') {
        return read_status(&rest, &reader->status);
    }
    bool const sent = ((letter == 'z') || (letter == 'Z')) && (length == 1u);
    return sent ? TB_SLCAN_DONE : TB_SLCAN_MALFORMED;
}

void tb_slcan_start(tb_slcan_reader *reader)
{
    reader->length = 0;
    reader->status = 0;
    reader->skipped = 0;
}

/* A line that is too long is told of at once: it may have no end. Then again now and then. */
static tb_slcan_item keep(tb_slcan_reader *reader, char character)
{
    if (reader->length < TB_SLCAN_LONGEST_LINE) {
        reader->line[reader->length] = character;
        reader->length++;
        return TB_SLCAN_NOTHING;
    }
    bool const is_due = (reader->skipped == 0) || (reader->skipped == TOLD_AGAIN);
    reader->skipped = is_due ? 1u : (uint16_t)(reader->skipped + 1u);
    return is_due ? TB_SLCAN_MALFORMED : TB_SLCAN_NOTHING;
}

static tb_slcan_item end_line(tb_slcan_reader *reader, char end, tb_can_frame *frame)
{
    uint8_t const length = reader->length;
    bool const is_told = reader->skipped != 0;
    reader->length = 0;
    reader->skipped = 0;
    if (is_told) {
        return TB_SLCAN_NOTHING;
    }
    if (end == FAILURE) {
        return (length == 0) ? TB_SLCAN_FAILED : TB_SLCAN_MALFORMED;
    }
    return read_line(reader, length, frame);
}

/* A line feed after nothing belongs to the end of the line before, which has been read. */
tb_slcan_item tb_slcan_read(tb_slcan_reader *reader, char character, tb_can_frame *frame)
{
    if (character == LINE_FEED) {
        return (reader->length == 0) ? TB_SLCAN_NOTHING : end_line(reader, character, frame);
    }
    bool const ends = (character == END_OF_LINE) || (character == FAILURE);
    return ends ? end_line(reader, character, frame) : keep(reader, character);
}
