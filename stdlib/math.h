// SPDX-License-Identifier: Apache-2.0
// The pure builtins (language.md 3), F64 in and F64 out.  All are exact or correctly rounded, so their results have
// the same bits on every target; no libm.
//
// Lines `// snippet: NAME` divide this file into the snippets that emitted C can contain; f64.h explains them.
#ifndef SM_MATH_H
#define SM_MATH_H

#include "stdlib/f64.h"

// snippet: sm_abs
// x without its sign bit.
static inline SmF64 sm_abs(SmF64 x) { return sm_from_bits(sm_bits(x) & 0x7FFFFFFFFFFFFFFFu); }
// snippet: sm_trunc
// x without its fraction; preserves the sign of zero.
static inline SmF64 sm_trunc(SmF64 x)
{
    const uint64_t u = sm_bits(x);
    const unsigned exponent = (unsigned)(u >> 52) & 0x7FFu;
    if (exponent >= 1075u)   // no fraction, infinity or NaN
        return x;
    if (exponent < 1023u)    // below 1
        return sm_from_bits(u & 0x8000000000000000u);
    return sm_from_bits(u & ~(0x000FFFFFFFFFFFFFu >> (exponent - 1023u)));
}
// snippet: sm_floor
static inline SmF64 sm_floor(SmF64 x)
{
    const SmF64 t = sm_trunc(x);
    return sm_lt(x, t) ? sm_sub(t, sm_from_i32(1)) : t;
}
// snippet: sm_ceil
static inline SmF64 sm_ceil(SmF64 x)
{
    const SmF64 t = sm_trunc(x);
    return sm_lt(t, x) ? sm_add(t, sm_from_i32(1)) : t;
}
// snippet: sm_round
// The nearest whole number, halves away from zero; preserves the sign of zero.
static inline SmF64 sm_round(SmF64 x)
{
    const SmF64 t = sm_trunc(x);
    const SmF64 twice = sm_sub(sm_sub(x, t), sm_sub(t, x));   // twice the fraction, exactly
    if (sm_le(sm_from_i32(1), twice))
        return sm_add(t, sm_from_i32(1));
    return sm_le(twice, sm_from_i32(-1)) ? sm_sub(t, sm_from_i32(1)) : t;
}
// snippet: sm_sqrt
// The square root, correctly rounded, computed one bit at a time; NaN below zero, -0 for -0.
static inline SmF64 sm_sqrt(SmF64 x)
{
    uint64_t rest = sm_bits(x) & 0x000FFFFFFFFFFFFFu, root = 0, done = 0, bit;
    int exponent = (int)(sm_bits(x) >> 52) & 0x7FF;
    if (exponent == 0x7FF || sm_eq(x, sm_from_i32(0)) || sm_lt(x, sm_from_i32(0)))
        return sm_lt(x, sm_from_i32(0)) ? sm_from_bits(0x7FF8000000000000u) : x;
    if (exponent != 0)
        rest |= 0x0010000000000000u;
    else
        for (exponent = 1; rest < 0x0010000000000000u; exponent--)
            rest <<= 1;
    exponent += 1023;        // twice the bias: half of it is the result's exponent
    rest <<= exponent % 2 != 0 ? 2 : 1;
    for (bit = 0x0020000000000000u; bit != 0; bit >>= 1) {
        if (done + bit <= rest) {
            rest -= done + bit;
            done += 2 * bit;
            root += bit;
        }
        rest <<= 1;
    }
    // root has one extra bit, so adding 1 and shifting rounds to nearest: no root is halfway between two F64 values.
    return sm_from_bits((((root + 1) >> 1) & 0x000FFFFFFFFFFFFFu) | (uint64_t)(exponent / 2) << 52);
}
// snippet: sm_sign
// -1, 1, or x itself if it is a zero or NaN.
static inline SmF64 sm_sign(SmF64 x)
{
    return sm_lt(x, sm_from_i32(0)) ? sm_from_i32(-1) : sm_lt(sm_from_i32(0), x) ? sm_from_i32(1) : x;
}
// snippet: sm_min
// The smaller; -0 is below +0; NaN if either is.
static inline SmF64 sm_min(SmF64 a, SmF64 b)
{
    if (sm_eq(a, b))         // only zeros can differ here, in their sign bit
        return sm_from_bits(sm_bits(a) | sm_bits(b));
    return sm_lt(a, b) || sm_is_nan(a) ? a : b;
}
// snippet: sm_max
// The larger; +0 is above -0; NaN if either is.
static inline SmF64 sm_max(SmF64 a, SmF64 b)
{
    if (sm_eq(a, b))         // only zeros can differ here, in their sign bit
        return sm_from_bits(sm_bits(a) & sm_bits(b));
    return sm_lt(b, a) || sm_is_nan(a) ? a : b;
}
// snippet: sm_lower
// The smaller one.  y must not be NaN, and x and y must not be zeros of different signs.
static inline SmF64 sm_lower(SmF64 x, SmF64 y) { return sm_lt(y, x) ? y : x; }
// snippet: sm_higher
// The larger one.  y must not be NaN, and x and y must not be zeros of different signs.
static inline SmF64 sm_higher(SmF64 x, SmF64 y) { return sm_lt(x, y) ? y : x; }
// snippet: sm_abs_i32
// |x| of an integer.  x must not be the smallest integer, for which C's minus overflows.
static inline int32_t sm_abs_i32(int32_t x) { return x < 0 ? -x : x; }
// snippet: sm_abs_i64
static inline int64_t sm_abs_i64(int64_t x) { return x < 0 ? -x : x; }
// snippet: sm_abs_f32
// x without its sign bit.
static inline float sm_abs_f32(float x)
{
    uint32_t u;
    memcpy(&u, &x, sizeof u);
    u &= 0x7FFFFFFFu;
    memcpy(&x, &u, sizeof x);
    return x;
}
// snippet: sm_sign_i32
static inline int32_t sm_sign_i32(int32_t x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
// snippet: sm_sign_i64
static inline int64_t sm_sign_i64(int64_t x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
// snippet: sm_min_i32
static inline int32_t sm_min_i32(int32_t a, int32_t b) { return a < b ? a : b; }
// snippet: sm_min_i64
static inline int64_t sm_min_i64(int64_t a, int64_t b) { return a < b ? a : b; }
// snippet: sm_max_i32
static inline int32_t sm_max_i32(int32_t a, int32_t b) { return a > b ? a : b; }
// snippet: sm_max_i64
static inline int64_t sm_max_i64(int64_t a, int64_t b) { return a > b ? a : b; }
// snippet: sm_clamp
static inline SmF64 sm_clamp(SmF64 x, SmF64 lo, SmF64 hi) { return sm_min(sm_max(x, lo), hi); }
// snippet: end

#endif
