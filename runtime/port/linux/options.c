#include "options.h"

#include <ctype.h>
#include <errno.h>
#include <getopt.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "identity.h"
#include "say.h"
#include "tb_machine.h"

#define LONGEST_NAME 31     /* of a bus in a machine file */
#define LONGEST_WAYS 400    /* of words about all adapters */
#define DEFAULT_PRIORITY 80 /* below the threads of the CAN device's interrupts, above the rest */

static const char usage_of_buses[] =
    "Usage: turnbuckle --bus NAME=ADAPTER:DEVICE ... [options]\n"
    "\n"
    "Controls the machine " TB_MACHINE_NAME " (" TB_MACHINE_HASH ").\n"
    "\n";

static const char usage_of_the_rest[] =
    "  --arm             arm as soon as every drive is configured\n"
    "  --cycles N        stop after N cycles\n"
    "  --record FILE     keep the flight recorder in FILE; a folder: in a file of the run's own\n"
    "  --telemetry FILE  shared file for monitors and applications\n"
    "                    [default: /dev/shm/turnbuckle-" TB_MACHINE_NAME "]\n"
    "  --priority N      of SCHED_FIFO, 1 to 99; 0 for none [default: 80]\n"
    "  --cpu N           run on processor N alone\n"
    "  --clock PATH      live by the clock of a simulation, not by the computer's: for the "
    "simulated\n"
    "                    drives of turnbuckle run --sim alone\n"
    "  --seal            allow no system call that the control loop does not need\n"
    "  --version         print machine and hash, precision, version, processor\n"
    "  --help            print this\n"
    "\n"
    "SIGINT and SIGTERM stop the machine softly. Once more ends the program at once: then the\n"
    "drives miss its heartbeat, and switch themselves off.\n"
    "Exit status: 0 stopped as asked, 1 stopped by a fault, 2 could not start.\n";

static const struct option known[] = {{"bus", required_argument, NULL, 'b'},
                                      {"arm", no_argument, NULL, 'a'},
                                      {"cycles", required_argument, NULL, 'n'},
                                      {"record", required_argument, NULL, 'r'},
                                      {"telemetry", required_argument, NULL, 't'},
                                      {"priority", required_argument, NULL, 'p'},
                                      {"cpu", required_argument, NULL, 'c'},
                                      {"clock", required_argument, NULL, 'k'},
                                      {"seal", no_argument, NULL, 'e'},
                                      {"version", no_argument, NULL, 'v'},
                                      {"help", no_argument, NULL, 'h'},
                                      {NULL, 0, NULL, 0}};

static const tb_options defaults = {
    .telemetry = "/dev/shm/turnbuckle-" TB_MACHINE_NAME,
    .priority = DEFAULT_PRIORITY,
    .cpu = -1,
};

/* A whole number in plain digits; anything else is refused. */
static bool read_number(const char *option, const char *text, uint64_t low, uint64_t high,
                        uint64_t *number)
{
    char *end = NULL;
    errno = 0;
    unsigned long long const value = strtoull(text, &end, 10);
    if ((isdigit((unsigned char)text[0]) == 0) || (*end != '\0') || (errno != 0) || (value < low) ||
        (value > high)) {
        tb_say("%s: found \"%s\"; allowed: a whole number from %llu to %llu", option, text,
               (unsigned long long)low, (unsigned long long)high);
        return false;
    }
    *number = value;
    return true;
}

static bool read_int(const char *option, const char *text, int low, int high, int *number)
{
    uint64_t value = 0;
    if (!read_number(option, text, (uint64_t)low, (uint64_t)high, &value)) {
        return false;
    }
    *number = (int)value;
    return true;
}

/* Names of all buses, for messages. */
static const char *bus_names(char *names, size_t room)
{
    size_t used = 0;
    for (size_t i = 0; i < TB_BUSES; i++) {
        const char *const parts[2] = {(i == 0) ? "" : ", ", tb_buses[i].name};
        for (size_t p = 0; p < 2; p++) {
            size_t const length = strlen(parts[p]);
            if (used + length + 1u < room) {
                memcpy(names + used, parts[p], length);
                used += length;
            }
        }
    }
    names[used] = '\0';
    return names;
}

/* Number of the bus whose name is the first `length` characters of text; -1 for none. */
static int find_bus(const char *text, size_t length)
{
    for (int i = 0; i < TB_BUSES; i++) {
        if ((strlen(tb_buses[i].name) == length) &&
            (strncmp(tb_buses[i].name, text, length) == 0)) {
            return i;
        }
    }
    return -1;
}

static bool read_bus(const char *text, tb_options *options)
{
    char names[TB_BUSES * (LONGEST_NAME + 2) + 1];
    size_t const length = strcspn(text, "=");
    int const number = find_bus(text, length);
    if (number < 0) {
        tb_say("--bus %s: found the bus \"%.*s\"; allowed: one of %s, as in --bus "
               "%s=%s:%s",
               text, (int)length, text, bus_names(names, sizeof names), tb_buses[0].name,
               tb_adapters[0]->name, tb_adapters[0]->example);
        return false;
    }
    tb_bus_option *const bus = &options->buses[number];
    if (bus->adapter != NULL) {
        tb_say("--bus %s: the bus %s was given before", text, tb_buses[number].name);
        return false;
    }
    if (strlen(text) - length > TB_LONGEST_DEVICE) {
        tb_say("--bus %.*s=: found a device of %zu characters; allowed: %d, a link to it as well",
               (int)length, text, strlen(text) - length, TB_LONGEST_DEVICE);
        return false;
    }
    bus->adapter =
        (text[length] == '\0') ? NULL : tb_adapter_find(text + length + 1u, &bus->device);
    if (bus->adapter == NULL) {
        char ways[LONGEST_WAYS];
        tb_say("--bus %s: allowed: %s", text,
               tb_adapters_tell(tb_buses[number].name, sizeof ways, ways));
        return false;
    }
    return true;
}

static bool has_every_bus(const tb_options *options)
{
    for (size_t i = 0; i < TB_BUSES; i++) {
        if (options->buses[i].adapter == NULL) {
            char ways[LONGEST_WAYS];
            tb_say("the bus %s is missing: --bus %s", tb_buses[i].name,
                   tb_adapters_tell(tb_buses[i].name, sizeof ways, ways));
            return false;
        }
    }
    for (size_t i = 1; i < TB_BUSES; i++) {
        for (size_t k = 0; k < i; k++) {
            if (strcmp(options->buses[i].device, options->buses[k].device) == 0) {
                tb_say("--bus: %s and %s are both on %s; allowed: a device of its own for each bus",
                       tb_buses[k].name, tb_buses[i].name, options->buses[i].device);
                return false;
            }
        }
    }
    return true;
}

static bool read_value(int letter, const char *value, tb_options *options)
{
    switch (letter) {
    case 'b':
        return read_bus(value, options);
    case 'n':
        return read_number("--cycles", value, 1, INT64_MAX, &options->cycles);
    case 'p':
        return read_int("--priority", value, 0, TB_LARGEST_PRIORITY, &options->priority);
    case 'c':
        return read_int("--cpu", value, 0, TB_MOST_PROCESSORS - 1, &options->cpu);
    case 'r':
        options->record = value;
        return true;
    case 'k':
        options->clock = value;
        return true;
    default:
        options->telemetry = value;
        return true;
    }
}

static void print_usage(void)
{
    tb_print_text(usage_of_buses);
    for (size_t i = 0; tb_adapters[i] != NULL; i++) {
        char way[LONGEST_WAYS];
        snprintf(way, sizeof way, "%s:%s", tb_adapters[i]->name, tb_adapters[i]->example);
        tb_print("  --bus NAME=%-20s  a bus %s", way, tb_adapters[i]->meaning);
    }
    tb_print_text(usage_of_the_rest);
}

static tb_options_answer read_option(int letter, char *argv[], tb_options *options)
{
    switch (letter) {
    case 'a':
        options->arm = true;
        return TB_OPTIONS_RUN;
    case 'e':
        options->seal = true;
        return TB_OPTIONS_RUN;
    case 'h':
        print_usage();
        return TB_OPTIONS_DONE;
    case 'v':
        tb_print("%s", TB_IDENTITY_TEXT);
        return TB_OPTIONS_DONE;
    case ':':
        tb_say("%s: a value is missing; --help lists the options", argv[optind - 1]);
        return TB_OPTIONS_WRONG;
    case '?':
        tb_say("%s: no such option; --help lists them", argv[optind - 1]);
        return TB_OPTIONS_WRONG;
    default:
        return read_value(letter, optarg, options) ? TB_OPTIONS_RUN : TB_OPTIONS_WRONG;
    }
}

tb_options_answer tb_options_read(int argc, char *argv[], tb_options *options)
{
    *options = defaults;
    for (int letter = 0; (letter = getopt_long(argc, argv, ":", known, NULL)) != -1;) {
        tb_options_answer const answer = read_option(letter, argv, options);
        if (answer != TB_OPTIONS_RUN) {
            return answer;
        }
    }
    if (optind < argc) {
        tb_say("%s: not an option; --help lists them", argv[optind]);
        return TB_OPTIONS_WRONG;
    }
    return has_every_bus(options) ? TB_OPTIONS_RUN : TB_OPTIONS_WRONG;
}
