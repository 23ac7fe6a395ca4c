/* Regenerate: turnbuckle generate machines/yoon_fixed_diagonal.toml --out generated/yoon_fixed_diagonal
 * Machine 46bec6a745675823, generator 0.1.4, casadi 3.8.2. Do not edit. */
#ifndef TB_TYPES_H
#define TB_TYPES_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

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

#endif
