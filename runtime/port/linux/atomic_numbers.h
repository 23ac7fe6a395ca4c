/* Numbers that two processes see whole: C++ before C++23 does not know C's word for them. */
#ifndef TB_ATOMIC_NUMBERS_H
#define TB_ATOMIC_NUMBERS_H

#ifdef __cplusplus
#include <atomic>
#include <cstdint>
typedef std::atomic<uint32_t> tb_atomic_u32;
typedef std::atomic<uint64_t> tb_atomic_u64;
#else
#include <stdatomic.h>
#include <stdint.h>
typedef _Atomic uint32_t tb_atomic_u32;
typedef _Atomic uint64_t tb_atomic_u64;
#endif

#endif
