/* Messages to the person at the terminal. */
#ifndef TB_SAY_H
#define TB_SAY_H

#ifdef __cplusplus
extern "C" {
#endif

/** Write one line to stderr, with the program's name in front. */
void tb_say(const char *format, ...) __attribute__((format(printf, 1, 2)));

/** Write a text of any length to stdout. */
void tb_print_text(const char *text);

/** Write one line to stdout. */
void tb_print(const char *format, ...) __attribute__((format(printf, 1, 2)));

#ifdef __cplusplus
}
#endif

#endif
