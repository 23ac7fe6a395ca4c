/* SYNC: the message on which every drive acts on its last setpoint and answers with its status. */
#ifndef TB_SYNC_H
#define TB_SYNC_H

#include "cob.h"

#ifdef __cplusplus
extern "C" {
#endif

static inline tb_can_frame tb_sync_frame(void)
{
    return tb_cob_frame(TB_COB_SYNC, 0, 0);
}

#ifdef __cplusplus
}
#endif

#endif
