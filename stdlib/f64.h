// SPDX-License-Identifier: Apache-2.0
// SmF64: the only number type of the language, IEEE binary64, and its operators.  Only this file decides how SmF64 is represented.  Where
// C's `double` is binary64 and is computed correctly, SmF64 is a `double`.  Elsewhere, as on AVR, it is a struct with the bits of the number,
// with arithmetic in software (soft.h).  -DSM_F64_SOFT=1 selects software on any target; all files of a program must agree on it.  Callers use
// the functions below and never C's operators, which the struct does not support.
// All functions are exact IEEE: round to nearest even, no trap, no errno.  The sign and payload of a NaN carry no meaning.
//
// Emitted C contains the source of the functions that it uses, as snippets (compiler/emit/c/embed_tool.c).  A line `// snippet of emitted C: NAME` begins the
// snippet NAME, which ends at the next such line; `// snippet of emitted C: end` begins none.  After some names it says that the snippet
// exists only where SmF64 is a `double`.  Comments inside a snippet appear in emitted C, so write them for its readers.
#ifndef SM_F64_H
#define SM_F64_H

#include <float.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

// gcc's software double for ARM chips without a double FPU rounds some sums wrongly whose operands are 33 bits apart.  The version for the
// smallest chips (Cortex-M0) is correct.
#ifndef SM_F64_SOFT
#if defined(__arm__) && defined(__GNUC__) && !defined(__clang__) && !(__ARM_FP & 8) && __ARM_ARCH_ISA_THUMB != 1
#define SM_F64_SOFT 1
#elif DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024
#define SM_F64_SOFT 0
#else
#define SM_F64_SOFT 1
#endif
#endif
#if !SM_F64_SOFT && (DBL_MANT_DIG != 53 || DBL_MAX_EXP != 1024)
#error "smc: this compiler's double is not IEEE binary64; build with -DSM_F64_SOFT=1"
#endif
#if FLT_MANT_DIG != 24 || FLT_MAX_EXP != 128
#error "smc: this compiler's float is not IEEE binary32"
#endif
// FLT_EVAL_METHOD 1 is harmless: it only widens float, and nothing here computes with float.
#if !SM_F64_SOFT && defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2)
#error "smc: this compiler computes doubles with excess precision; on 32-bit x86 build with -msse2 -mfpmath=sse"
#endif
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "smc: fast-math changes what programs mean; build without it"
#endif
// a * b + c must be two operations, each rounded.  Builds ensure that with -ffp-contract=off.  If a chip has a fused multiply-add, gcc uses
// it unless disabled here; and the Arduino tools offer no way to pass options.
#if (defined(ARDUINO) || defined(__FP_FAST_FMA)) && !SM_F64_SOFT && defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize ("fp-contract=off")
#elif defined(ARDUINO) && !SM_F64_SOFT && defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

// snippet of emitted C: SM_UNLIKELY
// The condition c, which is almost never true.  gcc otherwise computes both values of a choice and selects one, which delays all that follows.
// With -Os it jumps anyway.
#if defined(SM_UNLIKELY)
#elif defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 9 && !defined(__OPTIMIZE_SIZE__)
#define SM_UNLIKELY(c) __builtin_expect_with_probability(c, 0, 1.0)
#else
#define SM_UNLIKELY(c) (c)
#endif
// snippet of emitted C: end

#if SM_F64_SOFT
#include "stdlib/f64_soft.h"
#else
// snippet of emitted C: SmF64 (only where SmF64 is a double)
#ifndef SM_F64_TYPE
#define SM_F64_TYPE
typedef double SmF64;   // IEEE binary64
#endif
// snippet of emitted C: sm_bits (only where SmF64 is a double)
static inline uint64_t sm_bits(SmF64 x) { uint64_t u; memcpy(&u, &x, sizeof u); return u; }
// snippet of emitted C: sm_from_bits (only where SmF64 is a double)
static inline SmF64 sm_from_bits(uint64_t u) { SmF64 x; memcpy(&x, &u, sizeof x); return x; }
// snippet of emitted C: sm_add (only where SmF64 is a double)
static inline SmF64 sm_add(SmF64 a, SmF64 b) { return a + b; }
// snippet of emitted C: sm_sub (only where SmF64 is a double)
static inline SmF64 sm_sub(SmF64 a, SmF64 b) { return a - b; }
// snippet of emitted C: sm_mul (only where SmF64 is a double)
static inline SmF64 sm_mul(SmF64 a, SmF64 b) { return a * b; }
// snippet of emitted C: sm_div (only where SmF64 is a double)
static inline SmF64 sm_div(SmF64 a, SmF64 b) { return a / b; }
// snippet of emitted C: sm_neg (only where SmF64 is a double)
// Flips the sign bit, also of zero and NaN.
static inline SmF64 sm_neg(SmF64 a) { return sm_from_bits(sm_bits(a) ^ 0x8000000000000000u); }
// snippet of emitted C: sm_lt (only where SmF64 is a double)
static inline bool sm_lt(SmF64 a, SmF64 b) { return a < b; }    // false if either is NaN
// snippet of emitted C: sm_le (only where SmF64 is a double)
static inline bool sm_le(SmF64 a, SmF64 b) { return a <= b; }   // false if either is NaN
// snippet of emitted C: sm_eq (only where SmF64 is a double)
static inline bool sm_eq(SmF64 a, SmF64 b) { return a == b; }   // false if either is NaN
// snippet of emitted C: sm_is_nan (only where SmF64 is a double)
static inline bool sm_is_nan(SmF64 a) { return a != a; }
// snippet of emitted C: sm_from_i32 (only where SmF64 is a double)
static inline SmF64 sm_from_i32(int32_t v) { return (SmF64)v; }
// snippet of emitted C: sm_from_u32 (only where SmF64 is a double)
static inline SmF64 sm_from_u32(uint32_t v) { return (SmF64)v; }
// snippet of emitted C: sm_from_i64 (only where SmF64 is a double)
// Rounds above 2^53.  32-bit x86 converts 64 bits in an x87 register, where compilers can leave more bits than a double has.
// Therefore the two halves are converted, which is exact, and their sum is rounded once, like every sum.
static inline SmF64 sm_from_i64(int64_t v)
{
#if defined(__i386__) || defined(_M_IX86)
    return (SmF64)(int32_t)(v >> 32) * 4294967296.0 + (SmF64)(uint32_t)v;
#else
    return (SmF64)v;
#endif
}
// snippet of emitted C: sm_from_u64 (only where SmF64 is a double)
// Rounds above 2^53.  On 32-bit x86 the two halves are converted, and their sum is rounded once, as in sm_from_i64.
static inline SmF64 sm_from_u64(uint64_t v)
{
#if defined(__i386__) || defined(_M_IX86)
    return (SmF64)(uint32_t)(v >> 32) * 4294967296.0 + (SmF64)(uint32_t)v;
#else
    return (SmF64)v;
#endif
}
// snippet of emitted C: sm_from_f32 (only where SmF64 is a double)
static inline SmF64 sm_from_f32(float v) { return (SmF64)v; }       // exact
// snippet of emitted C: sm_truncate_i32 (only where SmF64 is a double)
static inline int32_t sm_truncate_i32(SmF64 x) { return (int32_t)x; }    // toward zero; the result must be in range
// snippet of emitted C: sm_truncate_u32 (only where SmF64 is a double)
static inline uint32_t sm_truncate_u32(SmF64 x) { return (uint32_t)x; }  // toward zero; the result must be in range
// snippet of emitted C: sm_truncate_i64 (only where SmF64 is a double)
static inline int64_t sm_truncate_i64(SmF64 x) { return (int64_t)x; }    // toward zero; the result must be in range
// snippet of emitted C: sm_truncate_u64 (only where SmF64 is a double)
static inline uint64_t sm_truncate_u64(SmF64 x) { return (uint64_t)x; }  // toward zero; the result must be in range
// snippet of emitted C: sm_round_f32 (only where SmF64 is a double)
static inline float sm_round_f32(SmF64 x) { return (float)x; }      // to nearest even, overflow to infinity
// snippet of emitted C: SM_SQRT_INSTRUCTION (only where SmF64 is a double)
// Replaces x by its square root, with one instruction.  Not defined where no such instruction is known.  sqrt() of C would need libm.
#if !defined(SM_SQRT_INSTRUCTION) && defined(__GNUC__) && !defined(__TINYC__)
#if defined(__SSE2_MATH__) && defined(__AVX__)
#define SM_SQRT_INSTRUCTION(x) __asm__("vsqrtsd %0, %0, %0" : "+x"(x))
#elif defined(__SSE2_MATH__)
#define SM_SQRT_INSTRUCTION(x) __asm__("sqrtsd %0, %0" : "+x"(x))
#elif defined(__aarch64__)
#define SM_SQRT_INSTRUCTION(x) __asm__("fsqrt %d0, %d0" : "+w"(x))
#elif defined(__arm__) && (__ARM_FP & 8)
#define SM_SQRT_INSTRUCTION(x) __asm__("vsqrt.f64 %P0, %P0" : "+w"(x))
#elif defined(__riscv_flen) && __riscv_flen >= 64
#define SM_SQRT_INSTRUCTION(x) __asm__("fsqrt.d %0, %0" : "+f"(x))
#elif defined(__s390x__)
#define SM_SQRT_INSTRUCTION(x) __asm__("sqdbr %0, %0" : "+f"(x))
#endif
#endif
// snippet of emitted C: end
#endif

#endif
