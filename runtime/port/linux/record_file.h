/* The file of a recording: new beside the one that it replaces, and in its place as soon as there is
 * something in it. */
#ifndef TB_RECORD_FILE_H
#define TB_RECORD_FILE_H

#include <limits.h>
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A file that is being written. */
typedef struct {
    char path[PATH_MAX];
    char fresh[PATH_MAX]; /* its name until it is in place */
    int descriptor;
    bool placed;
} tb_record_file;

/** Make the fresh file, with room for all of a recording. path: of a file or a folder. False, with a
 *  message, where that cannot be, or another file than a flight recording is there. */
bool tb_record_file_open(tb_record_file *file, const char *path);

/** Put the file in the place of the old one. False with errno. */
bool tb_record_file_place(tb_record_file *file);

/** Close the file; it goes where it was not placed. */
void tb_record_file_drop(const tb_record_file *file);

#ifdef __cplusplus
}
#endif

#endif
