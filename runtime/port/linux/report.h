/* What a run was like, told at its end. */
#ifndef TB_REPORT_H
#define TB_REPORT_H

#include "loop.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Print the report; the exit status of the program: 0 stopped as asked, 1 not. */
int tb_report(const tb_loop *loop, tb_end end);

#ifdef __cplusplus
}
#endif

#endif
