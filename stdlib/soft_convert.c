// SPDX-License-Identifier: Apache-2.0
// Software binary64 in portable C: comparisons, conversions from and to integers and binary32 (soft.h).
#include "stdlib/soft.h"
#include "stdlib/soft_pack.h"

#ifndef SM_SOFT_ASSEMBLY
// ---- compare ----

bool sm_soft_is_nan(uint64_t a) { return a << 1 > SM_SOFT_INFINITY << 1; }

// Whether a is neither zero nor NaN.
bool sm_soft_truth(uint64_t a) { return a << 1 != 0 && !sm_soft_is_nan(a); }

bool sm_soft_eq(uint64_t a, uint64_t b)
{
    return !sm_soft_is_nan(a) && (a == b || (a | b) << 1 == 0);
}

// Like sm_soft_lt, but -0 is below +0.
static bool is_below_as_bits(uint64_t a, uint64_t b)
{
    const bool negative = a >> 63 != 0;

    if (sm_soft_is_nan(a) || sm_soft_is_nan(b))
        return false;
    if ((a ^ b) >> 63 != 0)
        return negative;
    return negative ? b < a : a < b;
}

bool sm_soft_lt(uint64_t a, uint64_t b) { return (a | b) << 1 != 0 && is_below_as_bits(a, b); }
bool sm_soft_le(uint64_t a, uint64_t b) { return sm_soft_eq(a, b) || is_below_as_bits(a, b); }

// Returns 1 if a is less than b, 2 if equal, 4 if a is greater, 8 if one is NaN.
uint8_t sm_soft_relation(uint64_t a, uint64_t b) { return sm_soft_lt(a, b) ? 1 : sm_soft_eq(a, b) ? 2 : sm_soft_lt(b, a) ? 4 : 8; }

// ---- from integers ----

// Returns the binary64 of the integer v, with this sign bit.
static uint64_t pack_integer(uint64_t sign, uint64_t v)
{
    SmSoft x = {sign, 1023 + 62, v};

    if (v == 0)
        return sign;
    if (v >> 63 != 0) {
        x.digits = sm_soft_shift(v, 1);
        x.exponent++;
    }
    return sm_soft_pack(sm_soft_normal(x));
}

uint64_t sm_soft_from_u64(uint64_t v) { return pack_integer(0, v); }
uint64_t sm_soft_from_u32(uint32_t v) { return pack_integer(0, v); }
uint64_t sm_soft_from_i64(int64_t v) { return v < 0 ? pack_integer(SM_SOFT_SIGN, ~(uint64_t)v + 1) : pack_integer(0, (uint64_t)v); }
uint64_t sm_soft_from_i32(int32_t v) { return sm_soft_from_i64(v); }

// ---- to integers ----

// Returns |a| truncated toward zero, but at most `limit`; 0 for NaN.
static uint64_t truncate_magnitude(uint64_t a, uint64_t limit)
{
    const int16_t exponent = (int16_t)((int16_t)(a >> 52) & 0x7FF);
    uint64_t digits = (a << 11) | SM_SOFT_SIGN;        // the leading bit is bit 63

    if (exponent < 1023 || sm_soft_is_nan(a))
        return 0;
    if (exponent > 1023 + 63)
        return limit;
    digits >>= 1023 + 63 - exponent;
    return digits < limit ? digits : limit;
}

// Converts to an integer: truncates toward zero, then saturates; NaN becomes 0.
int32_t sm_soft_to_i32(uint64_t a)
{
    if (a >> 63 != 0)
        return (int32_t)-(int64_t)truncate_magnitude(a, UINT64_C(0x80000000));
    return (int32_t)truncate_magnitude(a, INT32_MAX);
}

int64_t sm_soft_to_i64(uint64_t a)
{
    if (a >> 63 == 0)
        return (int64_t)truncate_magnitude(a, INT64_MAX);
    return -1 - (int64_t)(truncate_magnitude(a, SM_SOFT_SIGN) - 1);
}

uint32_t sm_soft_to_u32(uint64_t a) { return a >> 63 != 0 ? 0 : (uint32_t)truncate_magnitude(a, UINT32_MAX); }
uint64_t sm_soft_to_u64(uint64_t a) { return a >> 63 != 0 ? 0 : truncate_magnitude(a, UINT64_MAX); }

// ---- binary32 ----

uint64_t sm_soft_from_f32(uint32_t v)
{
    const uint64_t sign = (uint64_t)(v >> 31) << 63;
    const int16_t exponent = (int16_t)(v >> 23 & 0xFF);
    SmSoft x = {sign, (int16_t)(exponent + 1023 - 127), (uint64_t)(v & 0x7FFFFFu) << 39};

    if (v << 1 == 0)
        return sign;
    if (exponent == 0xFF)
        return (v & 0x7FFFFFu) != 0 ? SM_SOFT_NAN : sign | SM_SOFT_INFINITY;
    if (exponent == 0)
        x.exponent++;
    else
        x.digits |= SM_SOFT_FIRST;
    return sm_soft_pack(sm_soft_normal(x));
}

uint32_t sm_soft_to_f32(uint64_t a)
{
    const uint32_t sign = (uint32_t)(a >> 63) << 31, infinity = UINT32_C(0x7F800000);
    SmSoft x = sm_soft_unpack(a);
    uint32_t digits, kept;

    if (sm_soft_is_nan(a))
        return UINT32_C(0x7FC00000);
    x.exponent = (int16_t)(x.exponent - 1023 + 127);
    if (x.exponent >= 0xFF)
        return sign | infinity;
    digits = (uint32_t)sm_soft_shift(x.digits, x.exponent < 1 ? (int16_t)(33 - x.exponent) : 32);      // the leading bit is bit 30
    kept = (digits + 0x40) >> 7;
    if ((digits & 0x7F) == 0x40)
        kept &= ~(uint32_t)1;
    return sign | (((uint32_t)(x.exponent < 1 ? 0 : x.exponent - 1) << 23) + kept);
}
#else
extern int sm_soft_convert_is_assembly;       // a file must not be empty in C
#endif
