/* The executable: one machine, its buses, one thread; and a process that writes its record. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include <errno.h>
#include <stddef.h>
#include <string.h>
#include <sys/mman.h>

#include "buses.h"
#include "clock.h"
#include "loop.h"
#include "network.h"
#include "options.h"
#include "realtime.h"
#include "record.h"
#include "report.h"
#include "say.h"
#include "seal.h"
#include "simulated_clock.h"
#include "stop.h"
#include "telemetry.h"

#define STOPPED 0
#define FAILED 1
#define CANNOT 2

/** All memory of the program: there is no other. The writer of the record shares it. */
typedef struct {
    tb_options options;
    tb_bus_ports buses;
    tb_clock clock;
    tb_simulated_clock simulated; /* with --clock: instead of the other one */
    tb_can_port *const *ports;    /* what the network sees of the buses */
    tb_network network;
    tb_master master;
    tb_loop loop;
    tb_record record;
} tb_program;

static bool open_clock(tb_program *program)
{
    const char *const path = program->options.clock;
    if (path == NULL) {
        program->clock = tb_system_clock;
        program->loop.clock = &program->clock;
        program->ports = program->buses.ports;
        return true;
    }
    program->loop.clock = &program->simulated.clock;
    program->ports = program->simulated.ports;
    return tb_simulated_clock_open(&program->simulated, path, program->buses.ports);
}

static bool prepare(tb_program *program)
{
    tb_loop *const loop = &program->loop;
    *loop = (tb_loop){.options = &program->options,
                      .master = &program->master,
                      .ports = program->buses.ports,
                      .record = &program->record,
                      .reopening = {.options = &program->options, .buses = &program->buses}};
    tb_stop_listen();
    loop->telemetry = tb_telemetry_open(program->options.telemetry, program->options.clock != NULL);
    return (loop->telemetry != NULL) && tb_watchdog_open(&loop->watchdog) &&
           tb_buses_open(&program->buses, &program->options) && open_clock(program) &&
           tb_realtime_enter(&program->options) && (!program->options.seal || tb_seal());
}

static int run(tb_program *program)
{
    tb_network_start(&program->network, program->ports);
    tb_master_start(&program->master, &program->network.fieldbus);
    tb_end const end = tb_loop_run(&program->loop);
    int const status = tb_report(&program->loop, end);
    tb_buses_close(&program->buses);
    return status;
}

/* The writer of the record is made first: it shall have none of what the program opens. */
static int record_run(tb_program *program)
{
    if (!tb_record_open(&program->record, &program->master.recorder, program->options.record)) {
        return CANNOT;
    }
    int const status = prepare(program) ? run(program) : CANNOT;
    bool const recorded = tb_record_close(&program->record);
    return (recorded || (status == CANNOT)) ? status : FAILED;
}

/* NULL with errno where there is none. */
static tb_program *share_memory(void)
{
    void *const memory = mmap(NULL, sizeof(tb_program), PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
    return (memory == MAP_FAILED) ? NULL : memory;
}

int main(int argc, char *argv[])
{
    tb_program *const program = share_memory();
    if (program == NULL) {
        tb_say("no memory: %s", strerror(errno));
        return CANNOT;
    }
    switch (tb_options_read(argc, argv, &program->options)) {
    case TB_OPTIONS_RUN:
        return record_run(program);
    case TB_OPTIONS_DONE:
        return STOPPED;
    default:
        return CANNOT;
    }
}
