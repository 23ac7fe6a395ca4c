/* Numbers in CANopen messages: least significant byte first. */
#ifndef TB_LITTLE_ENDIAN_H
#define TB_LITTLE_ENDIAN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

static inline void tb_put_u16(uint8_t bytes[2], uint16_t value)
{
    bytes[0] = (uint8_t)(value & 0xFFu);
    bytes[1] = (uint8_t)(value >> 8);
}

static inline void tb_put_u32(uint8_t bytes[4], uint32_t value)
{
    tb_put_u16(&bytes[0], (uint16_t)(value & 0xFFFFu));
    tb_put_u16(&bytes[2], (uint16_t)(value >> 16));
}

static inline uint16_t tb_get_u16(const uint8_t bytes[2])
{
    return (uint16_t)(bytes[0] | ((uint16_t)bytes[1] << 8));
}

static inline uint32_t tb_get_u32(const uint8_t bytes[4])
{
    return tb_get_u16(&bytes[0]) | ((uint32_t)tb_get_u16(&bytes[2]) << 16);
}

/* The number whose two's complement a word holds; no cast that a compiler may define. */
static inline int16_t tb_signed_16(uint16_t word)
{
    return (int16_t)((int32_t)(word & 0x7FFFu) - (int32_t)(word & 0x8000u));
}

static inline int32_t tb_signed_32(uint32_t word)
{
    return (int32_t)((int64_t)(word & 0x7FFFFFFFu) - (int64_t)(word & 0x80000000u));
}

#ifdef __cplusplus
}
#endif

#endif
