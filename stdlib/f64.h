// SPDX-License-Identifier: Apache-2.0
// SmF64: the one number of the language, IEEE binary64, and its operators.  The only place that decides how it is
// represented: here a C `double`, on chips whose double is shorter a soft type that will take its place.  Callers
// use the functions below and never C's operators, so that they need not change.
// All functions are exact IEEE: round to nearest even, no trap, no errno.  The sign and payload of a NaN carry no meaning.
#ifndef SM_F64_H
#define SM_F64_H

#include <float.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#if DBL_MANT_DIG != 53 || DBL_MAX_EXP != 1024
#error "smc: this compiler's double is not IEEE binary64"
#endif
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "smc: fast-math changes what programs mean; build without it"
#endif

typedef double SmF64;

static inline uint64_t sm_bits(SmF64 x) { uint64_t u; memcpy(&u, &x, sizeof u); return u; }
static inline SmF64 sm_from_bits(uint64_t u) { SmF64 x; memcpy(&x, &u, sizeof x); return x; }

static inline SmF64 sm_add(SmF64 a, SmF64 b) { return a + b; }
static inline SmF64 sm_sub(SmF64 a, SmF64 b) { return a - b; }
static inline SmF64 sm_mul(SmF64 a, SmF64 b) { return a * b; }
static inline SmF64 sm_div(SmF64 a, SmF64 b) { return a / b; }
static inline SmF64 sm_neg(SmF64 a) { return sm_from_bits(sm_bits(a) ^ 0x8000000000000000u); }   // the sign bit, of zero and NaN too

static inline bool sm_lt(SmF64 a, SmF64 b) { return a < b; }     // false if either is NaN, as the two below
static inline bool sm_le(SmF64 a, SmF64 b) { return a <= b; }
static inline bool sm_eq(SmF64 a, SmF64 b) { return a == b; }
static inline bool sm_is_nan(SmF64 a) { return a != a; }

#endif
