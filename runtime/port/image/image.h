/* What stands in a board's flash beside the program: what it was built for and with, how long it is
 * and its checksum. The host finds it without running anything; the board checks itself by it. */
#ifndef TB_IMAGE_H
#define TB_IMAGE_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TB_IMAGE_MARK "TBIMAGE" /* what the record begins with, its end of string too */

/** The record as it stands in the image, in the byte order of the processor. */
typedef struct {
    char mark[8];
    uint32_t length; /**< of the image [B]; the host puts it in when the program has been linked */
    uint32_t memory; /**< of variables and stack [B]; put in by the host as well */
    uint32_t crc;    /**< CRC-32 of the image as if this were zero; put in by the host as well */
    char board[20];
    char flags[216]; /**< what its C was compiled with */
} tb_image;

/** The record of this program; the linker keeps it within the first kilobyte of the image. */
extern const volatile tb_image tb_image_record;

/** Whether the image is as it was built; most: bytes of flash there are. Needs no variable in memory
 *  but the stack, so that nothing else has to run before. */
bool tb_image_is_whole(uint32_t most);

#ifdef __cplusplus
}
#endif

#endif
