/* Writes telemetry as fast as it can: every word of a record holds the number of the writing, so
 * that a reader can tell a record that is a mixture of two. */
#include <stddef.h>
#include <stdlib.h>

#include "telemetry.h"

static void fill(uint64_t value, size_t bytes, void *record)
{
    uint64_t *const words = record;
    for (size_t i = 0; i < bytes / sizeof *words; i++) {
        words[i] = value;
    }
}

int main(int argc, char *argv[])
{
    tb_telemetry_file *const file = (argc == 3) ? tb_telemetry_open(argv[1], false) : NULL;
    if (file == NULL) {
        return 2;
    }
    static tb_telemetry_cycle cycle;
    static tb_telemetry_status status;
    uint64_t const last = strtoull(argv[2], NULL, 10);
    for (uint64_t number = 0; number < last; number++) {
        fill(number, sizeof cycle, &cycle);
        tb_telemetry_append(file, &cycle);
        fill(number + 1u, sizeof status, &status);
        tb_telemetry_tell(file, &status);
    }
    return 0;
}
