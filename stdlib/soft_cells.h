// SPDX-License-Identifier: Apache-2.0
// Operations on 64-bit values in memory, for emitted C (smc build --soft).  They are passed by pointer, so that an 8-bit chip reads only
// the bytes that it needs and copies none.  Implemented in portable C (soft_cells.c) and in assembly for AVR (soft_cells_avr.S).
#ifndef SM_SOFT_CELLS_H
#define SM_SOFT_CELLS_H

#include <stdbool.h>
#include <stdint.h>

#include "stdlib/f64.h"

#ifdef __cplusplus
extern "C" {
#endif

// These compare *x with a finite binary64 whose lower 32 bits are zero; `n` is its upper 32 bits.  A NaN in *x counts as 0.
bool sm_soft_beyond(const SmF64 *x, uint32_t n);      // *x > n if n > 0 or +0; *x < n if n < 0 or -0
bool sm_soft_reaches(const SmF64 *x, uint32_t n);     // *x >= n if n > 0; *x <= n if n < 0; n is not zero

bool sm_soft_exceeds(const uint64_t *v, uint32_t n);                               // *v > n
bool sm_soft_elapsed_exceeds(const uint64_t *start, const uint64_t *time, uint32_t n);    // *time - *start > n
void sm_soft_increment(uint64_t *v);                      // adds one as F64 does: 2^53 remains 2^53; *v must not be above 2^53

// Begins a step at *time: if *time is later than the last step and not the largest time, updates *gate and returns true.  *gate is the time of
// the last step plus 1; 0 before the first step.
bool sm_soft_advance(uint64_t *gate, const uint64_t *time);

// The sum of n >= 1 samples of F32, whose keys (sm_roll_key of roll.h) are at `keys`, as the bits of a binary64, if it is exact in any order: n is
// at most SM_SOFT_SUM_MOST, and no sample but 0 is less than 2^-15 of the largest power of two.  Otherwise, or if the sum is 0: 0.
#define SM_SOFT_SUM_MOST 127
uint64_t sm_soft_sum_f32(const unsigned char *keys, uint8_t n);

#ifdef __cplusplus
}
#endif

// sm_soft_beyond and sm_soft_reaches for a float; `n` is the bits of a float.
static inline bool sm_soft_beyond_f32(float x, uint32_t n)
{
    uint32_t u;
    memcpy(&u, &x, sizeof u);
    u ^= n & 0x80000000u;
    return u > (n & 0x7FFFFFFFu) && u <= 0x7F800000u;
}
// Whether x is n or further from 0 on the same side; false for NaN.  n is not zero.
static inline bool sm_soft_reaches_f32(float x, uint32_t n)
{
    uint32_t u;
    memcpy(&u, &x, sizeof u);
    u ^= n & 0x80000000u;
    return u >= (n & 0x7FFFFFFFu) && u <= 0x7F800000u;
}

#endif
