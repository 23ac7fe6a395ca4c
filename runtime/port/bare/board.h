/* What a board without an operating system gives the runtime: write these functions for yours.
 *
 * Nothing here may wait for hardware without an end. Times are nanoseconds since the start. */
#ifndef TB_BOARD_H
#define TB_BOARD_H

#include <stdbool.h>
#include <stdint.h>

#include "fieldbus.h"
#include "master.h"
#include "wishes.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Bring up clock, pins, buses and watchdog. The fieldbus, started; NULL where anything is not as it
 *  must be: then nothing is sent, and drives that hear no heartbeat give no torque. */
tb_fieldbus *tb_board_start(void);

/** Time since the start [ns]. */
int64_t tb_board_time(void);

/** Sleep until a point in time [ns]; one that has passed is no sleep. */
void tb_board_sleep_until(int64_t time);

/** What the application and the people at the machine wish in this cycle. */
void tb_board_wish(tb_wishes *wishes);

/** The cycle is over: show what it saw and did to whoever looks. */
void tb_board_tell(const tb_master *master);

/** Keep the watchdog, which resets the board after a few cycles without this, from doing so. */
void tb_board_feed(void);

#ifdef __cplusplus
}
#endif

#endif
