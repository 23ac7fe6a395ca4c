/* The version of this runtime, which must be that of the generated C: from one version to the next
 * functions, constants and tables may change their meaning. */
#ifndef TB_RUNTIME_VERSION_H
#define TB_RUNTIME_VERSION_H

#include "tb_types.h"

#define TB_RUNTIME_VERSION 200 /* Turnbuckle 0.2.0, as pyproject.toml says */
#define TB_RUNTIME_VERSION_TEXT "0.2.0"

#if TB_VERSION != TB_RUNTIME_VERSION
#error "Generated C is not of Turnbuckle 0.2.0 like the runtime: run turnbuckle generate again"
#endif

#endif
