#define _POSIX_C_SOURCE 200809L /* PATH_MAX */
#include "say.h"

#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "tb_machine.h"

#define PROGRAM "turnbuckle-" TB_MACHINE_NAME ": "

/* Room for the three longest paths that the kernel takes; longer lines are cut. Not stdio's streams: they
 * take memory and locks when they please. */
#define LONGEST_LINE (4 * PATH_MAX)

static void write_line(int to, const char *prefix, const char *format, va_list arguments)
    __attribute__((format(printf, 3, 0)));

static void write_line(int to, const char *prefix, const char *format, va_list arguments)
{
    char line[LONGEST_LINE + 1];
    size_t const begin = strlen(prefix);
    memcpy(line, prefix, begin);
    int const wanted = vsnprintf(line + begin, LONGEST_LINE - begin, format, arguments);
    size_t const room = LONGEST_LINE - begin - 1u;
    size_t const end = begin + ((wanted < 0)              ? 0u
                                : ((size_t)wanted < room) ? (size_t)wanted
                                                          : room);
    line[end] = '\n';
    ssize_t const written = write(to, line, end + 1u);
    (void)written; /* nobody is left to be told */
}

void tb_say(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    write_line(STDERR_FILENO, PROGRAM, format, arguments);
    va_end(arguments);
}

void tb_print(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    write_line(STDOUT_FILENO, "", format, arguments);
    va_end(arguments);
}

void tb_print_text(const char *text)
{
    ssize_t const written = write(STDOUT_FILENO, text, strlen(text));
    (void)written;
}
