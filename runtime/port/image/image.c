#include "image.h"

#include <stddef.h>

#ifndef TB_BOARD_NAME
#define TB_BOARD_NAME "bare"
#endif
#ifndef TB_BUILD_FLAGS
#define TB_BUILD_FLAGS ""
#endif

_Static_assert(sizeof TB_BOARD_NAME <= sizeof tb_image_record.board,
               "a name of 19 letters at most");
_Static_assert(sizeof TB_BUILD_FLAGS <= sizeof tb_image_record.flags,
               "flags of 215 letters at most");

#define ERASED UINT32_MAX

extern const uint8_t tb_image_begin[]; /* of the linker script: the first byte in flash */

/* Volatile: the host writes into the image what the compiler has never seen. */
__attribute__((used, section(".tb_image"))) const volatile tb_image tb_image_record = {
    .mark = TB_IMAGE_MARK,
    .length = ERASED,
    .memory = ERASED,
    .crc = ERASED,
    .board = TB_BOARD_NAME,
    .flags = TB_BUILD_FLAGS,
};

/* Four bits at a time: a table of 64 bytes instead of a kilobyte. */
static uint32_t crc_of(uint32_t crc, const volatile uint8_t *bytes, uint32_t count)
{
    static const uint32_t table[16] = {
        0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu, 0x76DC4190u, 0x6B6B51F4u,
        0x4DB26158u, 0x5005713Cu, 0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
        0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu,
    };
    for (uint32_t i = 0; i < count; i++) {
        crc ^= bytes[i];
        crc = crc >> 4 ^ table[crc & 0xFu];
        crc = crc >> 4 ^ table[crc & 0xFu];
    }
    return crc;
}

bool tb_image_is_whole(uint32_t most)
{
    const volatile uint8_t *const begin = tb_image_begin;
    const volatile uint8_t *const place = (const volatile uint8_t *)&tb_image_record.crc;
    const uint32_t before = (uint32_t)(place - begin);
    const uint32_t after = before + (uint32_t)sizeof tb_image_record.crc;
    const uint32_t length = tb_image_record.length;
    const uint8_t zero[sizeof tb_image_record.crc] = {0};
    if (length < after || length > most) {
        return false;
    }
    uint32_t crc = crc_of(UINT32_MAX, begin, before);
    crc = crc_of(crc, zero, sizeof zero);
    crc = crc_of(crc, begin + after, length - after);
    return ~crc == tb_image_record.crc;
}
