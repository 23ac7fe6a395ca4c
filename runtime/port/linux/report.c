#include "report.h"

#include <inttypes.h>
#include <stddef.h>

#include "say.h"
#include "sentence.h"

static double microseconds(int64_t nanoseconds)
{
    return (double)nanoseconds / 1000.0;
}

static double mean(const tb_histogram *histogram)
{
    return (histogram->count > 0) ? microseconds(histogram->sum) / (double)histogram->count : 0.0;
}

/* The edge [us] below which 99 % of the durations are; the longest where that is the last bin. */
static double most_of(const tb_histogram *histogram)
{
    uint64_t below = 0;
    for (size_t i = 0; i + 1u < TB_HISTOGRAM_BINS; i++) {
        below += histogram->bins[i];
        if (below * 100u >= histogram->count * 99u) {
            return microseconds(tb_histogram_edges[i]);
        }
    }
    return microseconds(histogram->most);
}

static void report_times(const char *what, const tb_histogram *histogram)
{
    tb_print("%-10s mean %.1f us, 99 %% below %.0f us, longest %.1f us", what, mean(histogram),
             most_of(histogram), microseconds(histogram->most));
}

static void report_bus(const char *name, const tb_can_statistics *counted)
{
    tb_print("bus %s: %" PRIu32 " frames sent, %" PRIu32 " received, %" PRIu32 " refused, %" PRIu32
             " lost, %" PRIu32 " malformed, %" PRIu32 " bus errors, %" PRIu32 " times off",
             name, counted->sent, counted->received, counted->refused, counted->lost,
             counted->malformed, counted->bus_errors, counted->bus_off);
}

static int report_end(const tb_loop *loop, tb_end end)
{
    const tb_orders *const orders = &loop->master->orders;
    bool const asked = (orders->cause == TB_CAUSE_NONE) || (orders->cause == TB_CAUSE_REQUESTED);
    if (!asked) {
        char cause[TB_TELEMETRY_TEXT];
        tb_sentence_of_cause(orders, sizeof cause, cause);
        tb_reopening_tell(&loop->reopening, sizeof cause, cause);
        tb_say("stopped: %s", cause);
    }
    if (end == TB_END_NOT_OFF) {
        tb_say("a drive did not go off in time; it is left to its own supervision");
    }
    if (end == TB_END_AT_ONCE) {
        tb_say("ended at once; the drives are left to their own supervision");
    }
    return (asked && (end == TB_END_OFF)) ? 0 : 1;
}

int tb_report(const tb_loop *loop, tb_end end)
{
    tb_print("%" PRIu64 " cycles, %" PRIu64 " missed, at most %" PRIu64 " at once", loop->number,
             loop->times.missed, loop->times.longest_gap);
    if (loop->options->clock ==
        NULL) { /* in a simulation nothing is late, and computing takes no time */
        report_times("late", &loop->times.lateness);
        report_times("computing", &loop->times.computing);
    }
    for (size_t i = 0; i < TB_BUSES; i++) {
        report_bus(tb_buses[i].name, &loop->ports[i]->statistics);
    }
    return report_end(loop, end);
}
