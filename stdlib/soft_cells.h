// SPDX-License-Identifier: Apache-2.0
// What emitted C asks of 64 bits where they are (smc build --soft): a chip of 8 bits looks at the bytes that matter and moves none.  In
// portable C: soft_cells.c; for AVR in its assembly: soft_cells_avr.S.
#ifndef SM_SOFT_CELLS_H
#define SM_SOFT_CELLS_H

#include <stdbool.h>
#include <stdint.h>

#include "stdlib/f64.h"

#ifdef __cplusplus
extern "C" {
#endif

// Comparisons with a finite number whose lower 32 bits are zero: `n` has the upper ones.  A NaN in memory counts as 0.
bool sm_soft_beyond(const SmF64 *x, uint32_t n);      // farther from zero than n, on its side (that of -0: below)
bool sm_soft_reaches(const SmF64 *x, uint32_t n);     // that, or n itself; n is not zero

bool sm_soft_more(const uint64_t *v, uint32_t n);                               // *v > n
bool sm_soft_since(const uint64_t *start, const uint64_t *time, uint32_t n);    // *time - *start > n
void sm_soft_count(uint64_t *v);                      // up by one as a number: from 2^53 on it stays

// A step at that time: whether it is later than the last one, and not the end of time; then it is the last one.  *gate is the time of
// the last one and 1, or 0 where there was none.
bool sm_soft_advance(uint64_t *gate, const uint64_t *time);

#ifdef __cplusplus
}
#endif

// The same of a float, `n` being the bits of one.
static inline bool sm_soft_beyond_f32(float x, uint32_t n)
{
    uint32_t u;
    memcpy(&u, &x, sizeof u);
    u ^= n & 0x80000000u;
    return u > (n & 0x7FFFFFFFu) && u <= 0x7F800000u;
}
static inline bool sm_soft_reaches_f32(float x, uint32_t n)
{
    uint32_t u;
    memcpy(&u, &x, sizeof u);
    u ^= n & 0x80000000u;
    return u >= (n & 0x7FFFFFFFu) && u <= 0x7F800000u;
}

#endif
