/* Emergency messages of a drive (CiA 301, 7.2.7): what broke, and how bad that is. */
#ifndef TB_EMCY_H
#define TB_EMCY_H

#include <stdbool.h>
#include <stdint.h>

#include "can.h"
#include "tb_drives.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The emergency that stands: the first of the worst class since the last all-clear. */
typedef struct {
    uint16_t code;       /* 0 for none */
    uint8_t error_class; /* tb_error_class of code */
} tb_emcy;

/** Read an emergency message of a drive of this kind; code 0x0000 clears what stands. False: malformed, and ignored. */
bool tb_emcy_take(tb_emcy *emergency, const tb_drive_kind *kind, const tb_can_frame *frame);

/** How severe an error code of CiA 301 or CiA 402 is. */
tb_error_class tb_emcy_class(uint16_t code);

/** An error code of CiA 301 or CiA 402 in words; others are named after their group. */
const char *tb_emcy_text(uint16_t code);

#ifdef __cplusplus
}
#endif

#endif
