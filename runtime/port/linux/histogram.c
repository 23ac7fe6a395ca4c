#include "histogram.h"

#define US ((int64_t)1000) /* ns */

const int64_t tb_histogram_edges[TB_HISTOGRAM_BINS - 1] = {
    1 * US,   2 * US,   5 * US,   10 * US,   20 * US,   50 * US,
    100 * US, 200 * US, 500 * US, 1000 * US, 2000 * US, 5000 * US,
};

void tb_histogram_add(tb_histogram *histogram, int64_t duration)
{
    uint32_t bin = 0;
    while ((bin < TB_HISTOGRAM_BINS - 1) && (duration > tb_histogram_edges[bin])) {
        bin++;
    }
    histogram->bins[bin]++;
    if ((histogram->count == 0) || (duration < histogram->least)) {
        histogram->least = duration;
    }
    if ((histogram->count == 0) || (duration > histogram->most)) {
        histogram->most = duration;
    }
    histogram->count++;
    histogram->sum += duration;
}
