// SPDX-License-Identifier: Apache-2.0
// How the operations of soft.h take a number apart and put one together.  Internal to stdlib/soft_*.c.
//
// Inside an operation a finite number is its sign, its exponent and its digits: a whole number whose first digit, which binary64
// does not store, is bit 62.  The ten bits below the 53 that are kept are for rounding; the lowest of them is set, too, if
// anything but zeros stood further below.
#ifndef SM_SOFT_PACK_H
#define SM_SOFT_PACK_H

// AVR has assembly (soft_avr.S); SM_SOFT_PORTABLE takes the portable C there too, for comparing.
#if defined(__AVR_HAVE_MUL__) && !defined(SM_SOFT_PORTABLE)
#define SM_SOFT_ASSEMBLY
#endif

#ifndef __ASSEMBLER__
#include "stdlib/soft.h"

#define SM_SOFT_SIGN UINT64_C(0x8000000000000000)
#define SM_SOFT_INFINITY UINT64_C(0x7FF0000000000000)
#define SM_SOFT_FIRST UINT64_C(0x4000000000000000)     // of the digits inside an operation

typedef struct SmSoft {
    uint64_t sign;            // 0 or SM_SOFT_SIGN
    int16_t exponent;         // as binary64 stores it, but 1 for subnormals and zero, and without limits
    uint64_t digits;
} SmSoft;

static inline bool sm_soft_is_finite(uint64_t a) { return a << 1 < SM_SOFT_INFINITY << 1; }

// Shifts to the right; what falls out leaves its mark in the lowest bit.
static inline uint64_t sm_soft_shift(uint64_t digits, int16_t n)
{
    if (n == 0)
        return digits;
    return n > 63 ? digits != 0 : digits >> n | ((digits << (64 - n)) != 0);
}

// Of a finite number.  A subnormal one, and zero, begin below bit 62.
static inline SmSoft sm_soft_unpack(uint64_t a)
{
    SmSoft x = {a & SM_SOFT_SIGN, (int16_t)((int16_t)(a >> 52) & 0x7FF), a << 10 & (SM_SOFT_FIRST - 1)};

    if (x.exponent == 0)
        x.exponent = 1;
    else
        x.digits |= SM_SOFT_FIRST;
    return x;
}

// The same number with its first digit at bit 62; not of zero.
static inline SmSoft sm_soft_normal(SmSoft x)
{
    while (x.digits < SM_SOFT_FIRST) {
        x.digits <<= 1;
        x.exponent--;
    }
    return x;
}

// Rounds to nearest even.  The digits begin at bit 62; where the exponent is 1 also below.
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
    // The first digit, and what rounding carries beyond it, count up the exponent: to that of infinity too.
    return x.sign | (((uint64_t)(x.exponent - 1) << 52) + kept);
}

#endif
#endif
