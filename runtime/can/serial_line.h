/* A serial line that belongs to this program alone: bytes as they are, none held back. Linux.
 *
 * Nothing waits but tb_serial_close. Signals disturb nothing: what they interrupt is done later. */
#ifndef TB_SERIAL_LINE_H
#define TB_SERIAL_LINE_H

#include <stdbool.h>
#include <stddef.h>

#include "can.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TB_SERIAL_CLOSED (-1)

/** Open the line at `path`. line: its file descriptor, or TB_SERIAL_CLOSED.
 *  TB_CAN_OK, or why not: TB_CAN_NO_DEVICE, TB_CAN_NO_PERMISSION, TB_CAN_BUSY or TB_CAN_NOT_CAN. */
tb_can_result tb_serial_open(const char *path, int *line);

/** Write what the kernel takes now. TB_CAN_OK: `written` bytes, at least one; TB_CAN_FULL: none;
 *  TB_CAN_CLOSED: the device has gone. */
tb_can_result tb_serial_write(int line, const char *text, size_t length, size_t *written);

/** Read what has come. TB_CAN_OK: `count` bytes, at least one; TB_CAN_EMPTY: none; TB_CAN_CLOSED:
 *  the device has gone. */
tb_can_result tb_serial_read(int line, char *text, size_t room, size_t *count);

/** Wait until the line can be read, or written to, at most so many milliseconds. */
void tb_serial_await(int line, bool to_write, int milliseconds);

/** Give the line back. patient: wait for what was written to leave, 100 ms at most; the rest, or
 *  else all of it, is dropped. */
void tb_serial_close(int line, bool patient);

/** Milliseconds that have passed on a clock that never leaps. */
int64_t tb_serial_milliseconds(void);

#ifdef __cplusplus
}
#endif

#endif
