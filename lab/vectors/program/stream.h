/* Where the arguments come from, and where the results go. */
#ifndef STREAM_H
#define STREAM_H

#include <stdbool.h>
#include <stddef.h>

/** Open both; false where that is not possible. */
bool stream_open(void);

/** Read so many bytes; false where there are not as many. */
bool stream_take(void *to, size_t size);

/** Write so many bytes; false where they cannot be written. */
bool stream_give(const void *from, size_t size);

#endif
