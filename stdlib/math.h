// SPDX-License-Identifier: Apache-2.0
// The pure builtins (language.md 3), F64 in and F64 out.  All are exact or correctly rounded, so their results have
// the same bits on every target; no libm.
//
// Lines `// snippet of emitted C: NAME` divide this file into the snippets that emitted C can contain; f64.h explains them.
#ifndef SM_MATH_H
#define SM_MATH_H

#include "stdlib/f64.h"

// snippet of emitted C: sm_abs
// x without its sign bit.
static inline SmF64 sm_abs(SmF64 x) { return sm_from_bits(sm_bits(x) & 0x7FFFFFFFFFFFFFFFu); }
// snippet of emitted C: sm_trunc
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
// snippet of emitted C: sm_floor
static inline SmF64 sm_floor(SmF64 x)
{
    const SmF64 t = sm_trunc(x);
    return sm_bits(x) > (sm_bits(t) | 0x8000000000000000u) ? sm_sub(t, sm_from_i32(1)) : t;    // negative, with a fraction
}
// snippet of emitted C: sm_ceil
static inline SmF64 sm_ceil(SmF64 x)
{
    const SmF64 t = sm_trunc(x);
    return (sm_bits(x) & 0x7FFFFFFFFFFFFFFFu) > sm_bits(t) ? sm_add(t, sm_from_i32(1)) : t;    // positive, with a fraction
}
// snippet of emitted C: sm_round
// The nearest whole number, halves away from zero; preserves the sign of zero.
static inline SmF64 sm_round(SmF64 x)
{
    const uint64_t u = sm_bits(x);
    const unsigned exponent = (unsigned)(u >> 52) & 0x7FFu;
    if (exponent - 1022u >= 53u)   // below 1/2, or no fraction, infinity or NaN
        return sm_trunc(x);
    // Adds a half to the magnitude.  A carry out of the significand adds one to the exponent, as it has to.
    return sm_trunc(sm_from_bits(u + (0x0010000000000000u >> (exponent - 1022u))));
}
// snippet of emitted C: sm_upper_half
#ifndef SM_SQRT_INSTRUCTION
static inline uint32_t sm_upper_half(uint32_t a, uint32_t b) { return (uint32_t)(((uint64_t)a * b) >> 32); }
#endif
// snippet of emitted C: sm_sqrt_digits
#ifndef SM_SQRT_INSTRUCTION
// The integer nearest to the square root of f * 2^104, where f is from 1 to below 4, and n is f * 2^60 and a multiple of 2^8.  No root is halfway
// between two integers.
static inline uint64_t sm_sqrt_digits(uint64_t n)
{
#if defined(SM_SOFT_SQRT_DIGITS)
    return sm_soft_sqrt_digits(n);
#elif defined(__AVR__) || (defined(__OPTIMIZE_SIZE__) && defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 1)
    // This processor multiplies by a long function, or not at all: one bit at a time is slower, and less code.
    uint64_t rest = n >> 7, root = 0, bit;
    for (bit = 0x0020000000000000u; bit != 0; bit >>= 1) {
        if (2 * root + bit <= rest) {
            rest -= 2 * root + bit;
            root += bit;
        }
        rest <<= 1;
    }
    return (root + 1) >> 1;
#else
    const uint32_t high = (uint32_t)(n >> 30), g = high >> 31 != 0 ? high : high << 1;     // f * 2^30; f or f / 2, times 2^31
    // r is 2^31 / sqrt(g), and then 2^31 / sqrt(f), by a polynomial with an error below 2^-8.  Two steps of Newton's method make that 2^-27.
    uint32_t r = 3379453669u - sm_upper_half(g, 3101982430u - sm_upper_half(g, 1245237712u)), root;
    uint64_t digits;
    int i;
    if (high >> 31 != 0)
        r = sm_upper_half(r, 3037000500u);
    for (i = 0; i < 2; i++)
        r = sm_upper_half((0x2FFFFFFEu - sm_upper_half(high, sm_upper_half(r, r))) << 2, r) << 1;
    // 30 bits of the root, never too large.  What is left of n yields the other 22.  The error is from -1.25 to 0.25.
    root = sm_upper_half(high, r << 1);
    digits = ((uint64_t)root << 22) + ((sm_upper_half((uint32_t)((n - (uint64_t)root * root) >> 5), r << 1) + 4) >> 4);
    return digits + ((int64_t)((n << 44) - digits * digits) > (int64_t)digits);   // the difference is below 2^55: its lower half is enough
#endif
}
#endif
// snippet of emitted C: sm_sqrt
// The square root, correctly rounded; NaN below zero, -0 for -0.
static inline SmF64 sm_sqrt(SmF64 x)
{
#ifdef SM_SQRT_INSTRUCTION
    if (x < 0)
        return sm_from_bits(0x7FF8000000000000u);
    SM_SQRT_INSTRUCTION(x);
    return x;
#else
    const uint64_t u = sm_bits(x);
    uint64_t digits = u & 0x000FFFFFFFFFFFFFu;
    int exponent = (int)(u >> 52);
    if (u - 1 >= 0x7FEFFFFFFFFFFFFFu)      // zero, infinity, NaN or negative
        return u > 0x8000000000000000u && u <= 0xFFF0000000000000u ? sm_from_bits(0x7FF8000000000000u) : x;
    if (exponent != 0)
        digits |= 0x0010000000000000u;
    else
        for (exponent = 1; digits < 0x0010000000000000u; exponent--)
            digits <<= 1;
    exponent += 1023;        // twice the bias: half of it is the result's exponent
    digits = sm_sqrt_digits(digits << (exponent % 2 != 0 ? 9 : 8));
    return sm_from_bits(digits + ((uint64_t)(exponent / 2 - 1) << 52));
#endif
}
// snippet of emitted C: sm_sign
// -1, 1, or x itself if it is a zero or NaN.
static inline SmF64 sm_sign(SmF64 x)
{
    if (sm_is_nan(x) || sm_bits(x) << 1 == 0)
        return x;
    return sm_from_bits((sm_bits(x) & 0x8000000000000000u) | 0x3FF0000000000000u);
}
// snippet of emitted C: sm_min
// The smaller; -0 is below +0; NaN if either is.
static inline SmF64 sm_min(SmF64 a, SmF64 b)
{
    if (sm_eq(a, b))         // only zeros can differ here, in their sign bit
        return sm_from_bits(sm_bits(a) | sm_bits(b));
    return sm_lt(a, b) || sm_is_nan(a) ? a : b;
}
// snippet of emitted C: sm_max
// The larger; +0 is above -0; NaN if either is.
static inline SmF64 sm_max(SmF64 a, SmF64 b)
{
    if (sm_eq(a, b))         // only zeros can differ here, in their sign bit
        return sm_from_bits(sm_bits(a) & sm_bits(b));
    return sm_lt(b, a) || sm_is_nan(a) ? a : b;
}
// snippet of emitted C: sm_lower
// The smaller one.  y must not be NaN, and x and y must not be zeros of different signs.
static inline SmF64 sm_lower(SmF64 x, SmF64 y) { return sm_lt(y, x) ? y : x; }
// snippet of emitted C: sm_higher
// The larger one.  y must not be NaN, and x and y must not be zeros of different signs.
static inline SmF64 sm_higher(SmF64 x, SmF64 y) { return sm_lt(x, y) ? y : x; }
// snippet of emitted C: sm_abs_i32
// |x| of an integer.  x must not be the smallest integer, for which C's minus overflows.
static inline int32_t sm_abs_i32(int32_t x) { return x < 0 ? -x : x; }
// snippet of emitted C: sm_abs_i64
static inline int64_t sm_abs_i64(int64_t x) { return x < 0 ? -x : x; }
// snippet of emitted C: sm_saturating_abs_i64
static inline int64_t sm_saturating_abs_i64(int64_t x) { return x < -INT64_MAX ? INT64_MAX : x < 0 ? -x : x; }
// snippet of emitted C: sm_abs_f32
// x without its sign bit.
static inline float sm_abs_f32(float x)
{
    uint32_t u;
    memcpy(&u, &x, sizeof u);
    u &= 0x7FFFFFFFu;
    memcpy(&x, &u, sizeof x);
    return x;
}
// snippet of emitted C: sm_sign_i32
static inline int32_t sm_sign_i32(int32_t x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
// snippet of emitted C: sm_sign_i64
static inline int64_t sm_sign_i64(int64_t x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
// snippet of emitted C: sm_min_i32
static inline int32_t sm_min_i32(int32_t a, int32_t b) { return a < b ? a : b; }
// snippet of emitted C: sm_min_i64
static inline int64_t sm_min_i64(int64_t a, int64_t b) { return a < b ? a : b; }
// snippet of emitted C: sm_max_i32
static inline int32_t sm_max_i32(int32_t a, int32_t b) { return a > b ? a : b; }
// snippet of emitted C: sm_max_i64
static inline int64_t sm_max_i64(int64_t a, int64_t b) { return a > b ? a : b; }
// snippet of emitted C: sm_clamp
static inline SmF64 sm_clamp(SmF64 x, SmF64 lo, SmF64 hi) { return sm_min(sm_max(x, lo), hi); }
// snippet of emitted C: end

#endif
