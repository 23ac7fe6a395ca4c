/* Distribution of durations, in steps of 1, 2, 5 from 1 us to 5 ms. */
#ifndef TB_HISTOGRAM_H
#define TB_HISTOGRAM_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TB_HISTOGRAM_BINS 13

/** Bin i counts durations up to tb_histogram_edges[i]; the last one counts all that is longer. */
typedef struct {
    uint64_t bins[TB_HISTOGRAM_BINS];
    uint64_t count;
    int64_t least; /* ns */
    int64_t most;  /* ns */
    int64_t sum;   /* ns */
} tb_histogram;

extern const int64_t tb_histogram_edges[TB_HISTOGRAM_BINS - 1]; /* ns */

/** Count a duration [ns]. */
void tb_histogram_add(tb_histogram *histogram, int64_t duration);

#ifdef __cplusplus
}
#endif

#endif
