// SPDX-License-Identifier: Apache-2.0
// Unpacks and packs numbers for the operations of soft.h.  Internal to stdlib/soft_*.c.
//
// Inside an operation, a finite number is a sign, an exponent and `digits`, the significand with its leading bit at bit 62.  Binary64
// does not store that bit.  The ten bits below the 53 of the result are for rounding; the lowest of them is a sticky bit, also set if a
// nonzero bit was below it.
#ifndef SM_SOFT_PACK_H
#define SM_SOFT_PACK_H

// AVR uses assembly (soft_avr.S).  SM_SOFT_PORTABLE selects portable C there too, for comparison.
#if defined(__AVR_HAVE_MUL__) && !defined(SM_SOFT_PORTABLE)
#define SM_SOFT_ASSEMBLY
#endif

#ifndef __ASSEMBLER__
#include "stdlib/soft.h"

#define SM_SOFT_SIGN UINT64_C(0x8000000000000000)
#define SM_SOFT_INFINITY UINT64_C(0x7FF0000000000000)
#define SM_SOFT_FIRST UINT64_C(0x4000000000000000)     // the leading bit of `digits`

typedef struct SmSoft {
    uint64_t sign;            // 0 or SM_SOFT_SIGN
    int16_t exponent;         // biased as in binary64, but 1 for subnormals and zero; may be outside the range of binary64 until the result is packed
    uint64_t digits;
} SmSoft;

static inline bool sm_soft_is_finite(uint64_t a) { return a << 1 < SM_SOFT_INFINITY << 1; }

// Returns digits >> n.  The lowest bit of the result is sticky: it is also set if a nonzero bit was shifted out.
static inline uint64_t sm_soft_shift(uint64_t digits, int16_t n)
{
    if (n == 0)
        return digits;
    return n > 63 ? digits != 0 : digits >> n | ((digits << (64 - n)) != 0);
}

// Unpacks a finite number.  The leading bit of subnormals is below bit 62; zero has none.
static inline SmSoft sm_soft_unpack(uint64_t a)
{
    SmSoft x = {a & SM_SOFT_SIGN, (int16_t)((int16_t)(a >> 52) & 0x7FF), a << 10 & (SM_SOFT_FIRST - 1)};

    if (x.exponent == 0)
        x.exponent = 1;
    else
        x.digits |= SM_SOFT_FIRST;
    return x;
}

// Normalizes: returns the same number with its leading bit at bit 62.  x must not be zero.
static inline SmSoft sm_soft_normal(SmSoft x)
{
    while (x.digits < SM_SOFT_FIRST) {
        x.digits <<= 1;
        x.exponent--;
    }
    return x;
}

// Rounds to nearest even and packs.  The leading bit must be bit 62; it may be lower if the exponent is 1.
static inline uint64_t sm_soft_pack(SmSoft x)
{
    const uint64_t half = 0x200, rest = 0x3FF;
    uint64_t kept;

    if (x.exponent < 1) {
        x.digits = sm_soft_shift(x.digits, (int16_t)(1 - x.exponent));
        x.exponent = 1;
    }
    if (x.exponent >= 0x7FF)
        return x.sign | SM_SOFT_INFINITY;
    kept = (x.digits + half) >> 10;
    if ((x.digits & rest) == half)
        kept &= ~(uint64_t)1;
    // The leading bit adds one to the exponent, and so does a carry from rounding, which can produce infinity.
    return x.sign | (((uint64_t)(x.exponent - 1) << 52) + kept);
}

#endif
#endif
