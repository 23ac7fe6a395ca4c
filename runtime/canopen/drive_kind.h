/* What the maker of a drive says by numbers, in words: its kind's own tables first, then what CiA 301
 * and CiA 402 say. */
#ifndef TB_DRIVE_KIND_H
#define TB_DRIVE_KIND_H

#include <stdint.h>

#include "tb_drives.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How severe an error code is. */
tb_error_class tb_drive_kind_error_class(const tb_drive_kind *kind, uint16_t code);

/** An error code in words; a code that no one has described is named after its group. */
const char *tb_drive_kind_error_text(const tb_drive_kind *kind, uint16_t code);

/** An SDO abort code in words. */
const char *tb_drive_kind_abort_text(const tb_drive_kind *kind, uint32_t code);

#ifdef __cplusplus
}
#endif

#endif
