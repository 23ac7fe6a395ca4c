/* The watchdog of systemd (sd_notify): told only by cycles that were completed and checked.
 * Its patience is the computer's time, whichever clock the control loop has. */
#ifndef TB_WATCHDOG_H
#define TB_WATCHDOG_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Where to tell it; without systemd there is no socket, and nothing is told. */
typedef struct {
    int socket;       /* -1 for none */
    int64_t interval; /* ns between two signs of life */
    int64_t next;     /* ns, when the next one is due */
} tb_watchdog;

/** Connect to $NOTIFY_SOCKET, where there is one; false with a message where that cannot be. */
bool tb_watchdog_open(tb_watchdog *watchdog);

/** The program is ready. */
void tb_watchdog_ready(const tb_watchdog *watchdog);

/** A cycle is complete and checked. */
void tb_watchdog_feed(tb_watchdog *watchdog);

/** The program is about to end. */
void tb_watchdog_stopping(const tb_watchdog *watchdog);

#ifdef __cplusplus
}
#endif

#endif
