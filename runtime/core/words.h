/* States, phases and causes in words, for people. Every text is constant and lives as long as the
 * program. */
#ifndef TB_WORDS_H
#define TB_WORDS_H

#include "cause.h"
#include "cycle.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What the machine does in a state. */
const char *tb_state_text(tb_state state);

/** What the machine does in a phase; empty where the state's text says enough. */
const char *tb_phase_text(tb_phase phase);

/** What is wrong, to be read after the culprit's name. */
const char *tb_cause_text(tb_cause cause);

/** What the number of a cause's culprit counts: "drive", "cable", "bus" or "". */
const char *tb_culprit_text(tb_cause cause);

/** What the user can do about it; empty where there is nothing to do. */
const char *tb_advice_text(tb_cause cause);

#ifdef __cplusplus
}
#endif

#endif
