/* Fuzz target: any characters into the slcan reader.
 *
 * What must hold: a frame that is read is a frame; written and read again it is the same; whatever
 * came before, the line after the next carriage return is read as if nothing had; a line feed behind
 * every end of a line changes nothing; characters without an end of a line are told of. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "slcan_text.h"

static void require(bool condition)
{
    if (!condition) {
        __builtin_trap();
    }
}

/* Reads a line from any reader at the beginning of a line. */
static tb_slcan_item read_text(tb_slcan_reader *reader, const char *text, size_t length,
                               tb_can_frame *frame)
{
    tb_slcan_item item = TB_SLCAN_NOTHING;
    for (size_t i = 0; i < length; i++) {
        require(item == TB_SLCAN_NOTHING);
        item = tb_slcan_read(reader, text[i], frame);
    }
    return item;
}

static void check_frame(const tb_can_frame *frame)
{
    char line[TB_SLCAN_LONGEST_LINE];
    tb_slcan_reader second;
    tb_can_frame again;
    memset(&again, 0xA5, sizeof again);
    tb_slcan_start(&second);
    require(tb_can_is_frame(frame));
    uint8_t const length = tb_slcan_write(frame, line);
    require((length > 0) && (length <= TB_SLCAN_LONGEST_LINE));
    require(read_text(&second, line, length, &again) == TB_SLCAN_FRAME);
    require((again.id == frame->id) && (again.flags == frame->flags));
    require((again.length == frame->length));
    require(memcmp(again.data, frame->data, sizeof again.data) == 0);
}

static void check_recovery(tb_slcan_reader *reader)
{
    static const char known[] = "t1232ABCD\r";
    tb_can_frame frame;
    (void)tb_slcan_read(reader, '\r', &frame);
    require(read_text(reader, known, sizeof known - 1u, &frame) == TB_SLCAN_FRAME);
    require((frame.id == 0x123u) && (frame.length == 2u) && (frame.data[1] == 0xCDu));
}

static bool ends_line(char character)
{
    return (character == '\r') || (character == '\n') || (character == '\a');
}

/* The same character into a reader whose adapter ends lines with a line feed too. */
static void check_line_feed(tb_slcan_reader *fed, char character, tb_slcan_item item)
{
    tb_can_frame frame;
    require(tb_slcan_read(fed, character, &frame) == item);
    if (ends_line(character)) {
        require(tb_slcan_read(fed, '\n', &frame) == TB_SLCAN_NOTHING);
    }
}

/* unended: characters since the last end of a line. */
static void check_length(char character, tb_slcan_item item, size_t *unended)
{
    *unended = ends_line(character) ? 0 : *unended + 1u;
    require((*unended == TB_SLCAN_LONGEST_LINE + 1u) || ends_line(character) ||
            (item == TB_SLCAN_NOTHING));
    require((*unended != TB_SLCAN_LONGEST_LINE + 1u) || (item == TB_SLCAN_MALFORMED));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    tb_slcan_reader reader;
    tb_slcan_reader fed;
    tb_can_frame frame;
    size_t unended = 0;
    tb_slcan_start(&reader);
    tb_slcan_start(&fed);
    for (size_t i = 0; i < size; i++) {
        memset(&frame, 0x5A, sizeof frame);
        tb_slcan_item const item = tb_slcan_read(&reader, (char)data[i], &frame);
        if (item == TB_SLCAN_FRAME) {
            check_frame(&frame);
        }
        require(reader.length <= TB_SLCAN_LONGEST_LINE);
        check_line_feed(&fed, (char)data[i], item);
        check_length((char)data[i], item, &unended);
    }
    check_recovery(&reader);
    return 0;
}
