/* Regenerate: turnbuckle generate machines/yoon_fixed_orthogonal.toml --out <this folder>
 * Machine c858d0533419e597, turnbuckle 0.2.0, casadi 3.8.2. Do not edit.
 * SPDX-License-Identifier: 0BSD */
#ifndef TB_TYPES_H
#define TB_TYPES_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

#define TB_VERSION 200 /* Turnbuckle 0.2.0; the runtime must be of the same */

/* Options of the compiler that let it reckon as if there were no NaN, which would take every guard
 * away without a word, or that change bits. Not all of them can be seen here: docs/targets.md. */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#error "NaN would pass every guard: compile without -ffast-math, -Ofast and -ffinite-math-only"
#endif
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) \
    || defined(__NO_SIGNED_ZEROS__)
#error "other bits: compile without -ffast-math, -Ofast and all of -funsafe-math-optimizations"
#endif
#if FLT_EVAL_METHOD != 0
#error "other bits: real numbers keep more digits than their type; on 32-bit x86 use -mfpmath=sse"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* A constant without a suffix is a double: compile without -fsingle-precision-constant. */
typedef char tb_constants_are_double[sizeof(1.0) == sizeof(double) ? 1 : -1];

/* One source, two precisions: compile with -DTB_REAL_FLOAT for single precision. Use -std=c99 or
 * -ffp-contract=off, so that every target computes the same bits, and -fno-math-errno, so that the
 * square root is one instruction. */
#ifdef TB_REAL_FLOAT
typedef float real_t;
#define TB_C(digits) digits##F
#define TB_SQRT(x) sqrtf(x)
#define TB_ABS(x) fabsf(x)
#define TB_COPYSIGN(x, y) copysignf(x, y)
#define TB_EPSILON FLT_EPSILON
#else
typedef double real_t;
#define TB_C(digits) digits
#define TB_SQRT(x) sqrt(x)
#define TB_ABS(x) fabs(x)
#define TB_COPYSIGN(x, y) copysign(x, y)
#define TB_EPSILON DBL_EPSILON
#endif

/** What a function answers. With TB_OK and TB_INFEASIBLE the outputs are valid; with the others they
 *  hold the function's fallback, never NaN. */
typedef enum {
    TB_OK = 0,
    TB_INFEASIBLE = 1,
    TB_SINGULAR = 2,
    TB_OUT_OF_DOMAIN = 3,
    TB_INACCURATE = 4
} tb_status;

static inline real_t tb_min(const real_t a, const real_t b) { return a < b ? a : b; }
static inline real_t tb_max(const real_t a, const real_t b) { return a > b ? a : b; }

#ifdef __cplusplus
}
#endif

#endif
