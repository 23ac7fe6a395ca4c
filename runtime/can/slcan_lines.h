/* Lines to and from an adapter, for the files of the slcan driver. */
#ifndef TB_SLCAN_LINES_H
#define TB_SLCAN_LINES_H

#include "slcan.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An adapter that nothing is known of, closed. */
void tb_slcan_forget(tb_slcan *slcan);

/** Write a line: TB_CAN_OK, TB_CAN_FULL when it cannot begin now, or TB_CAN_CLOSED. */
tb_can_result tb_slcan_write_line(tb_slcan *slcan, const char *line, uint8_t length);

/** Read bytes that are here, in place of those read before: TB_CAN_OK, TB_CAN_EMPTY or
 *  TB_CAN_CLOSED. */
tb_can_result tb_slcan_read_bytes(tb_slcan *slcan);

/** The next item among the bytes that were read; TB_SLCAN_NOTHING when there are no more. */
tb_slcan_item tb_slcan_next_item(tb_slcan *slcan, tb_can_frame *frame);

#ifdef __cplusplus
}
#endif

#endif
