// SPDX-License-Identifier: Apache-2.0
// The functions of stdlib/soft_cells.h as operations on two operands, and the results that hardware computes.
#ifndef SOFT_TEST_CELLS_H
#define SOFT_TEST_CELLS_H

#include "stdlib/soft_cells.h"
#include "tests/soft/soft.h"

// Returns the upper half of b as a limit: finite, and if `zero` is false, not zero.
static inline uint32_t cell_limit(uint64_t b, bool zero)
{
    const uint32_t n = (b >> 52 & 0x7FF) == 0x7FF ? (uint32_t)(b >> 32) ^ 0x00100000u : (uint32_t)(b >> 32);

    return n << 1 == 0 && !zero ? n + 1 : n;
}
static inline uint32_t cell_limit_f32(uint64_t b) { return (b >> 55 & 0xFF) == 0xFF ? (uint32_t)(b >> 32) ^ 0x00800000u : (uint32_t)(b >> 32) | 1; }

// Two kinds of integers: of any length; and for counting, near 2^53 or near a carry.
static inline uint64_t cell_short(uint64_t a, uint64_t b) { return a >> (b >> 58); }
static inline uint64_t cell_counted(uint64_t a, uint64_t b) { return (b & 7) == 0 ? 0x20000000000000u : a >> 11 | ((b & 7) == 1 ? 0xFFFFFFu : 0); }
static inline uint64_t cell_time(uint64_t a, uint64_t b) { return (b & 1) != 0 ? a + (b >> 1 & 3) - 2 : b; }

// A window of up to 20 samples of F32, from two operands: any numbers, or of either sign with exponents that are up to 18 apart, which have less than 24
// digits or are 0.  Returns their number; key: as roll.h stores them.
enum { CELL_SAMPLES = 20 };
static inline uint8_t cell_samples(uint64_t a, uint64_t b, uint32_t *key)
{
    const uint8_t n = (uint8_t)(1 + b % CELL_SAMPLES), spread = (uint8_t)(1 + (b >> 8) % 19), least = (uint8_t)(a >> 52);
    uint64_t r = a ^ b << 17 ^ 88172645463325252u;

    for (uint8_t i = 0; i < n; i++) {
        uint32_t v;
        r ^= r << 13;
        r ^= r >> 7;
        r ^= r << 17;
        v = (uint32_t)(r >> 32);
        if ((b >> 16 & 15) != 0)
            v = (v & 0x807FFFFFu & UINT32_MAX << (r & 15)) | (((uint32_t)least + (uint8_t)(r >> 8) % spread) & 255u) << 23;
        if ((r >> 16 & 63) == 0)
            v &= 0x80000000u;
        if ((v & 0x7FFFFFFFu) > 0x7F800000u)
            v = 0x7F800000u;                  // a window contains no NaN
        key[i] = v >> 31 != 0 ? v ^ 0x7FFFFFFFu : v;
    }
    return n;
}

#if SM_F64_SOFT
static inline uint64_t soft_sum_f32(uint64_t a, uint64_t b)
{
    uint32_t key[CELL_SAMPLES];
    const uint8_t n = cell_samples(a, b, key);

    return sm_soft_sum_f32((const unsigned char *)key, n);
}
static inline uint64_t soft_more(uint64_t v, uint32_t n) { return sm_soft_exceeds(&v, n); }
static inline uint64_t soft_since(uint64_t start, uint64_t time, uint32_t n) { return sm_soft_elapsed_exceeds(&start, &time, n); }
static inline uint64_t soft_count(uint64_t v) { sm_soft_increment(&v); return v; }
static inline uint64_t soft_advance(uint64_t gate, uint64_t time) { return sm_soft_advance(&gate, &time) ? gate : ~gate; }
#endif

#endif
