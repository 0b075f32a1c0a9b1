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

#if SM_F64_SOFT
static inline uint64_t soft_more(uint64_t v, uint32_t n) { return sm_soft_exceeds(&v, n); }
static inline uint64_t soft_since(uint64_t start, uint64_t time, uint32_t n) { return sm_soft_elapsed_exceeds(&start, &time, n); }
static inline uint64_t soft_count(uint64_t v) { sm_soft_increment(&v); return v; }
static inline uint64_t soft_advance(uint64_t gate, uint64_t time) { return sm_soft_advance(&gate, &time) ? gate : ~gate; }
#endif

#endif
