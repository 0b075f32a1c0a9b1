// SPDX-License-Identifier: Apache-2.0
// Sets of numbers as arrays of bits: bit n is set if the set contains n.  The caller allocates the words; zeroed words are the empty set.
#ifndef SMC_BITSET_H
#define SMC_BITSET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

static inline size_t bitset_words(size_t limit) { return limit / 64 + 1; }       // number of words of a set of numbers below limit

static inline bool bitset_has(const uint64_t *set, size_t number) { return (set[number / 64] >> number % 64 & 1) != 0; }
static inline void bitset_add(uint64_t *set, size_t number) { set[number / 64] |= UINT64_C(1) << number % 64; }
static inline void bitset_remove(uint64_t *set, size_t number) { set[number / 64] &= ~(UINT64_C(1) << number % 64); }

// Adds all numbers of the set `more`.  Returns true if the set grew.
static inline bool bitset_merge(uint64_t *set, const uint64_t *more, size_t words)
{
    bool grew = false;

    for (size_t w = 0; w < words; w++) {
        grew |= (more[w] & ~set[w]) != 0;
        set[w] |= more[w];
    }
    return grew;
}

#endif
