// SPDX-License-Identifier: Apache-2.0
// Operations on 64-bit values in memory (soft_cells.h), in portable C.
#define SM_F64_SOFT 1
#include "stdlib/soft_cells.h"
#include "stdlib/soft_pack.h"

#ifndef SM_SOFT_ASSEMBLY
// Returns the bits of |*x| if *x has the sign of n; 0 if it has the other sign or is NaN.
static uint64_t magnitude_if_same_sign(const SmF64 *x, uint32_t n)
{
    const uint64_t u = x->bits ^ ((uint64_t)(n & 0x80000000u) << 32);
    return u > SM_SOFT_INFINITY ? 0 : u;
}

bool sm_soft_beyond(const SmF64 *x, uint32_t n) { return magnitude_if_same_sign(x, n) > (uint64_t)(n & 0x7FFFFFFFu) << 32; }
bool sm_soft_reaches(const SmF64 *x, uint32_t n) { return magnitude_if_same_sign(x, n) >= (uint64_t)(n & 0x7FFFFFFFu) << 32; }
bool sm_soft_exceeds(const uint64_t *v, uint32_t n) { return *v > n; }
bool sm_soft_elapsed_exceeds(const uint64_t *start, const uint64_t *time, uint32_t n) { return *time - *start > n; }
void sm_soft_increment(uint64_t *v) { *v += *v < UINT64_C(0x20000000000000); }

// Begins a step at *time: if *time is later than the last step and not the largest time, updates *gate and returns true.  *gate is the time
// of the last step plus 1; 0 before the first step.
bool sm_soft_advance(uint64_t *gate, const uint64_t *time)
{
    const uint64_t next = *time + 1;

    if (next <= *gate)
        return false;
    *gate = next;
    return true;
}

// ---- sums of F32 ----

enum { SM_SOFT_SPREAD = 15 };                 // the largest difference of two exponents in a sum

static uint32_t load_key(const unsigned char *keys, uint8_t i)
{
    uint32_t key;

    memcpy(&key, keys + (size_t)i * 4, sizeof key);
    return key;
}

// The next functions return the sign, magnitude, exponent and digits of the number with this key.  A key is the bits of the number, all but the sign
// bit flipped if the number is negative.
static bool is_negative(uint32_t key) { return key >> 31 != 0; }
static uint32_t magnitude_of(uint32_t key) { return (is_negative(key) ? ~key : key) & 0x7FFFFFFFu; }
static uint8_t exponent_of(uint32_t key) { return magnitude_of(key) >> 23 != 0 ? (uint8_t)(magnitude_of(key) >> 23) : 1; }
static uint32_t digits_of(uint32_t key) { return (magnitude_of(key) & 0x7FFFFFu) | (magnitude_of(key) >> 23 != 0 ? 0x800000u : 0); }

// Returns the largest exponent of n keys, but at least 1.
static uint8_t largest_exponent(const unsigned char *keys, uint8_t n)
{
    uint8_t most = 1, i, e;

    for (i = 0; i < n; i++) {
        e = exponent_of(load_key(keys, i));
        most = e > most ? e : most;
    }
    return most;
}

// Adds the samples as integers in units of the lowest digit of the smallest exponent that is allowed.
uint64_t sm_soft_sum_f32(const unsigned char *keys, uint8_t n)
{
    const uint8_t most = largest_exponent(keys, n);
    int64_t sum = 0;
    uint8_t i;

    if (most == 0xFF)                         // an infinity
        return 0;
    for (i = 0; i < n; i++) {
        const uint32_t key = load_key(keys, i);
        const unsigned below = (unsigned)(most - exponent_of(key));
        if (below <= SM_SOFT_SPREAD)
            sum += (is_negative(key) ? -(int64_t)digits_of(key) : (int64_t)digits_of(key)) * ((int64_t)1 << (SM_SOFT_SPREAD - below));
        else if (digits_of(key) != 0)
            return 0;
    }
    if (sum == 0)
        return 0;
    return sm_soft_from_i64(sum) + ((uint64_t)most << 52) - ((uint64_t)(150 + SM_SOFT_SPREAD) << 52);
}
#else
extern int sm_soft_cells_is_assembly;         // a file must not be empty in C
#endif
