// SPDX-License-Identifier: Apache-2.0
// SmF64 without a `double`: implements the functions of f64.h with those of soft.h.  Included only by f64.h.
#ifndef SM_F64_SOFT_H
#define SM_F64_SOFT_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "stdlib/soft.h"

// A struct, so that C's operators do not compile for it.
typedef struct SmF64 { uint64_t bits; } SmF64;

static inline uint64_t sm_bits(SmF64 x) { return x.bits; }
static inline SmF64 sm_from_bits(uint64_t u) { SmF64 x; x.bits = u; return x; }
static inline SmF64 sm_add(SmF64 a, SmF64 b) { return sm_from_bits(sm_soft_add(a.bits, b.bits)); }
static inline SmF64 sm_sub(SmF64 a, SmF64 b) { return sm_from_bits(sm_soft_sub(a.bits, b.bits)); }
static inline SmF64 sm_mul(SmF64 a, SmF64 b) { return sm_from_bits(sm_soft_mul(a.bits, b.bits)); }
static inline SmF64 sm_div(SmF64 a, SmF64 b) { return sm_from_bits(sm_soft_div(a.bits, b.bits)); }
static inline SmF64 sm_neg(SmF64 a) { return sm_from_bits(a.bits ^ 0x8000000000000000u); }
static inline bool sm_lt(SmF64 a, SmF64 b) { return sm_soft_lt(a.bits, b.bits); }
static inline bool sm_le(SmF64 a, SmF64 b) { return sm_soft_le(a.bits, b.bits); }
static inline bool sm_eq(SmF64 a, SmF64 b) { return sm_soft_eq(a.bits, b.bits); }
static inline bool sm_is_nan(SmF64 a) { return sm_soft_is_nan(a.bits); }
static inline SmF64 sm_from_i32(int32_t v) { return sm_from_bits(sm_soft_from_i32(v)); }
static inline SmF64 sm_from_u32(uint32_t v) { return sm_from_bits(sm_soft_from_u32(v)); }
static inline SmF64 sm_from_i64(int64_t v) { return sm_from_bits(sm_soft_from_i64(v)); }
static inline SmF64 sm_from_u64(uint64_t v) { return sm_from_bits(sm_soft_from_u64(v)); }
static inline SmF64 sm_from_f32(float v) { uint32_t u; memcpy(&u, &v, sizeof u); return sm_from_bits(sm_soft_from_f32(u)); }
static inline float sm_round_f32(SmF64 x) { const uint32_t u = sm_soft_to_f32(x.bits); float v; memcpy(&v, &u, sizeof v); return v; }

// Conversions to integers.  Unlike those of f64.h, they saturate if the result does not fit.
static inline int32_t sm_truncate_i32(SmF64 x) { return sm_soft_to_i32(x.bits); }
static inline uint32_t sm_truncate_u32(SmF64 x) { return sm_soft_to_u32(x.bits); }
static inline int64_t sm_truncate_i64(SmF64 x) { return sm_soft_to_i64(x.bits); }
static inline uint64_t sm_truncate_u64(SmF64 x) { return sm_soft_to_u64(x.bits); }

// sm_to_X: the value that a store of x in an element writes (convert.h).
static inline int32_t sm_to_i32(SmF64 x) { return sm_truncate_i32(x); }
static inline uint32_t sm_to_u32(SmF64 x) { return sm_truncate_u32(x); }
static inline int64_t sm_to_i64(SmF64 x) { return sm_truncate_i64(x); }
static inline uint64_t sm_to_u64(SmF64 x) { return sm_truncate_u64(x); }
static inline int32_t sm_to_clipped(SmF64 x, int32_t lo, int32_t hi)
{
    const int32_t v = sm_truncate_i32(x);
    return v < lo ? lo : v > hi ? hi : v;
}
static inline int16_t sm_to_i16(SmF64 x) { return (int16_t)sm_to_clipped(x, INT16_MIN, INT16_MAX); }
static inline int8_t sm_to_i8(SmF64 x) { return (int8_t)sm_to_clipped(x, INT8_MIN, INT8_MAX); }
static inline uint16_t sm_to_u16(SmF64 x) { return (uint16_t)sm_to_clipped(x, 0, UINT16_MAX); }
static inline uint8_t sm_to_u8(SmF64 x) { return (uint8_t)sm_to_clipped(x, 0, UINT8_MAX); }
static inline bool sm_to_bool(SmF64 x) { return sm_soft_truth(x.bits); }

// sm_read_X and sm_no_nan_f32: the value that reading an element returns (convert.h).
static inline float sm_no_nan_f32(float v)
{
    uint32_t u;
    memcpy(&u, &v, sizeof u);
    return (u & 0x7FFFFFFFu) > 0x7F800000u ? 0.0f : v;
}
static inline SmF64 sm_read_f32(float v) { return sm_from_f32(sm_no_nan_f32(v)); }

#endif
