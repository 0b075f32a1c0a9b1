// SPDX-License-Identifier: Apache-2.0
// Software binary64 in portable C: add, subtract, multiply, divide (soft.h).  Simple rather than fast.
#include "stdlib/soft.h"
#include "stdlib/soft_pack.h"

#ifndef SM_SOFT_ASSEMBLY
// ---- add, subtract ----

// Returns |a| + |b|, or |a| - |b| if `subtract`, with the sign of a.  |a| must not be below |b|, and both must be finite.
static uint64_t add_ordered(uint64_t a, uint64_t b, bool subtract)
{
    SmSoft x = sm_soft_unpack(a), y = sm_soft_unpack(b);

    y.digits = sm_soft_shift(y.digits, (int16_t)(x.exponent - y.exponent));
    x.digits += subtract ? ~y.digits + 1 : y.digits;
    if (subtract)
        return x.digits == 0 ? 0 : sm_soft_pack(sm_soft_normal(x));      // the difference of equal numbers is 0, not -0
    if (x.digits >> 63 != 0) {
        x.digits = sm_soft_shift(x.digits, 1);
        x.exponent++;
    }
    return sm_soft_pack(x);
}

uint64_t sm_soft_add(uint64_t a, uint64_t b)
{
    const bool subtract = (a ^ b) >> 63 != 0;

    if (a << 1 < b << 1) {
        const uint64_t larger = b;
        b = a;
        a = larger;
    }
    if (sm_soft_is_finite(a))
        return add_ordered(a, b, subtract);
    return sm_soft_is_nan(a) || (subtract && !sm_soft_is_finite(b)) ? SM_SOFT_NAN : a;      // the bits of a NaN compare above all others
}

uint64_t sm_soft_sub(uint64_t a, uint64_t b) { return sm_soft_add(a, b ^ SM_SOFT_SIGN); }

// ---- multiply, divide ----

// Returns the upper half of the 128-bit product a * b.  Its lowest bit is also set if the lower half is not zero.
static uint64_t multiply_upper_half(uint64_t a, uint64_t b)
{
    const uint64_t mask = 0xFFFFFFFFu, a0 = a & mask, a1 = a >> 32, b0 = b & mask, b1 = b >> 32;
    const uint64_t low = a0 * b0, mid = a1 * b0 + (low >> 32), middle = (mid & mask) + a0 * b1;

    return (a1 * b1 + (mid >> 32) + (middle >> 32)) | ((middle & mask) != 0 || (low & mask) != 0);
}

uint64_t sm_soft_mul(uint64_t a, uint64_t b)
{
    const uint64_t sign = (a ^ b) & SM_SOFT_SIGN;
    const bool zero = a << 1 == 0 || b << 1 == 0;
    SmSoft x, y;

    if (sm_soft_is_nan(a) || sm_soft_is_nan(b))
        return SM_SOFT_NAN;
    if (!sm_soft_is_finite(a) || !sm_soft_is_finite(b))
        return zero ? SM_SOFT_NAN : sign | SM_SOFT_INFINITY;
    if (zero)
        return sign;
    x = sm_soft_normal(sm_soft_unpack(a));
    y = sm_soft_normal(sm_soft_unpack(b));
    x.sign = sign;
    x.exponent = (int16_t)(x.exponent + y.exponent - 1022);
    x.digits = multiply_upper_half(x.digits << 1, y.digits);
    return sm_soft_pack(sm_soft_normal(x));
}

// Divides two significands, whose leading bits are bit 62, by long division, one bit at a time.  The quotient is less than 2, and its bit 62
// has weight 1.  A nonzero remainder sets its lowest bit.
static uint64_t divide_significands(uint64_t a, uint64_t b)
{
    uint64_t q = 0;

    for (uint8_t i = 0; i < 56; i++) {
        q <<= 1;
        if (a >= b) {
            a -= b;
            q |= 1;
        }
        a <<= 1;
    }
    return q << 7 | (a != 0);
}

uint64_t sm_soft_div(uint64_t a, uint64_t b)
{
    const uint64_t sign = (a ^ b) & SM_SOFT_SIGN;
    SmSoft x, y;

    if (sm_soft_is_nan(a) || sm_soft_is_nan(b) || a << 1 == b << 1) {      // |a| == |b| is 1 or -1, or NaN for 0/0 and infinities
        const bool one = sm_soft_is_finite(a) && sm_soft_is_finite(b) && a << 1 != 0;
        return one ? sign | UINT64_C(0x3FF0000000000000) : SM_SOFT_NAN;
    }
    if (!sm_soft_is_finite(a) || b << 1 == 0)
        return sign | SM_SOFT_INFINITY;
    if (!sm_soft_is_finite(b) || a << 1 == 0)
        return sign;
    x = sm_soft_normal(sm_soft_unpack(a));
    y = sm_soft_normal(sm_soft_unpack(b));
    x.sign = sign;
    x.exponent = (int16_t)(x.exponent - y.exponent + 1023);
    x.digits = divide_significands(x.digits, y.digits);
    return sm_soft_pack(sm_soft_normal(x));
}
#else
extern int sm_soft_arith_is_assembly;         // a file must not be empty in C
#endif
