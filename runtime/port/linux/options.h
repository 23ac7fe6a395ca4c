/* What the command line says. */
#ifndef TB_OPTIONS_H
#define TB_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "adapters.h"
#include "tb_drives.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TB_LARGEST_PRIORITY 99
#define TB_MOST_PROCESSORS 1024
#define TB_LONGEST_DEVICE 300 /* characters: a folder of /dev and the longest name of a file */

/** How a bus is reached. */
typedef struct {
    const tb_adapter *adapter; /* NULL: not given */
    const char *device;
} tb_bus_option;

typedef struct {
    tb_bus_option buses[TB_BUSES]; /* in the order of the machine file */
    const char *telemetry;         /* path of the shared file */
    const char *record;            /* file or folder of the flight recorder; NULL for none */
    uint64_t cycles;               /* run for so many, then stop; 0 for without end */
    const char *clock;             /* socket of a simulation that keeps time; NULL for real time */
    int priority;                  /* of SCHED_FIFO; 0 for none */
    int cpu;                       /* run on this one alone; -1 for any */
    bool arm;                      /* arm once, as soon as the machine waits for it */
    bool seal;                     /* allow the cyclic path no system call that it does not need */
} tb_options;

/** What to do after the command line was read. */
typedef enum {
    TB_OPTIONS_RUN = 0,
    TB_OPTIONS_DONE, /* --help or --version: printed */
    TB_OPTIONS_WRONG /* a message is on stderr */
} tb_options_answer;

/** Read the command line. The options keep pointers into argv. */
tb_options_answer tb_options_read(int argc, char *argv[], tb_options *options);

#ifdef __cplusplus
}
#endif

#endif
