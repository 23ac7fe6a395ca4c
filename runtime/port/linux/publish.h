/* What a cycle saw and ordered, put into the shared file. */
#ifndef TB_PUBLISH_H
#define TB_PUBLISH_H

#include "loop.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Publish the cycle that has just run and began at `time` [ns], and what is counted. */
void tb_publish(const tb_loop *loop, int64_t time);

#ifdef __cplusplus
}
#endif

#endif
