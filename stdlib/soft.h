// SPDX-License-Identifier: Apache-2.0
// Software binary64: the operations of f64.h on the bits of numbers, without a `double`.  f64.h uses them where C's `double` is
// not IEEE binary64.  The implementation in portable C (soft_arith.c, soft_convert.c) and the one in assembly for AVR
// (soft_avr.S) have results with the same bits.
//
// The operations round to nearest even and support subnormals, signed zeros and infinities.  A NaN result is always SM_SOFT_NAN.
#ifndef SM_SOFT_H
#define SM_SOFT_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SM_SOFT_NAN UINT64_C(0x7FF8000000000000)

uint64_t sm_soft_add(uint64_t a, uint64_t b);
uint64_t sm_soft_sub(uint64_t a, uint64_t b);
uint64_t sm_soft_mul(uint64_t a, uint64_t b);
uint64_t sm_soft_div(uint64_t a, uint64_t b);

bool sm_soft_lt(uint64_t a, uint64_t b);      // sm_soft_lt, _le and _eq are false if either is NaN
bool sm_soft_le(uint64_t a, uint64_t b);
bool sm_soft_eq(uint64_t a, uint64_t b);
uint8_t sm_soft_relation(uint64_t a, uint64_t b);     // 1 if a is less, 2 if equal, 4 if a is greater, 8 if one is NaN
bool sm_soft_is_nan(uint64_t a);
bool sm_soft_truth(uint64_t a);               // whether a is neither zero nor NaN

uint64_t sm_soft_from_i32(int32_t v);
uint64_t sm_soft_from_u32(uint32_t v);
uint64_t sm_soft_from_i64(int64_t v);         // exact up to 2^53, rounded above
uint64_t sm_soft_from_u64(uint64_t v);        // exact up to 2^53, rounded above
uint64_t sm_soft_from_f32(uint32_t v);        // v: the bits of a binary32; the conversion is exact

int32_t sm_soft_to_i32(uint64_t a);           // to integers: truncate toward zero, then saturate; NaN becomes 0
uint32_t sm_soft_to_u32(uint64_t a);
int64_t sm_soft_to_i64(uint64_t a);
uint64_t sm_soft_to_u64(uint64_t a);
uint32_t sm_soft_to_f32(uint64_t a);          // the bits of a binary32: to nearest even, overflow to infinity

// On AVR, sm_sqrt_digits of math.h in assembly.
#if defined(__AVR_HAVE_MUL__) && !defined(SM_SOFT_PORTABLE)
#define SM_SOFT_SQRT_DIGITS
uint64_t sm_soft_sqrt_digits(uint64_t n);
#endif

#ifdef __cplusplus
}
#endif
#endif
