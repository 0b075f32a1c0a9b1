// SPDX-License-Identifier: Apache-2.0
// Windows in the decoded form: the functions for the common types and statistics, on top of stdlib/roll.h.  The size of a window is
// known only at run time, but the decoder has selected the instruction by an upper bound of it.
// Of the functions for a type K, w points to the operand words that describe a window: its address, its size.
//   sample_K          converts F to a sample            push_…_K   adds a sample to a window that supports only this statistic
//   memory_sample_K   reads a sample from memory        others     return a statistic of the window
#ifndef SMVM_FAST_WINDOW_H
#define SMVM_FAST_WINDOW_H

#include <string.h>

#include "bytecode-vm/fast.h"
#include "stdlib/convert.h"
#include "stdlib/roll.h"

// Lets the compiler omit code for cases in which the condition is false.
#ifdef __GNUC__
#define ASSUME(condition) do { if (!(condition)) __builtin_unreachable(); } while (0)
#else
#define ASSUME(condition) (void)0
#endif

static inline uint64_t *window_ring(const SmvmWord *w) { return (uint64_t *)w->p; }
static inline uint64_t *window_words(const SmvmWord *w) { return (uint64_t *)w->p + 1; }
static inline SmRollSize window_count(const SmvmWord *w) { return sm_roll_count(window_ring(w)); }
// Returns the number of slots of a window; the decoder has selected the instruction for windows of at most `most` slots.
static inline uint32_t window_size(const SmvmWord *w, uint32_t most)
{
    const uint32_t n = (uint32_t)w[1].u;

    ASSUME(n >= 1 && n <= most);
    return n;
}

// ---- averages: samples of a short window are added in pairs, the sums in pairs again, and so on ----

// sum_n_K is the sum of n samples, added in pairs.  sum_K splits `count` samples into groups of 16, 8, 4, 2 and 1, as the bits of `count`
// say, and adds the sums of the groups from the last to the first.  The start value is -0, which changes no sum.
#define DEFINE_FLOAT_AVERAGE(K)                                                                                                            \
    static inline SmF64 sum_1_##K(const unsigned char *at) { return sm_roll_value(SM_ROLL_##K | SM_ROLL_AVG, sm_roll_load(at, 0, SM_ROLL_##K)); } \
    static inline SmF64 sum_2_##K(const unsigned char *at) { return sm_add(sum_1_##K(at), sum_1_##K(at + BYTES_##K)); }                    \
    static inline SmF64 sum_4_##K(const unsigned char *at) { return sm_add(sum_2_##K(at), sum_2_##K(at + 2 * BYTES_##K)); }                \
    static inline SmF64 sum_8_##K(const unsigned char *at) { return sm_add(sum_4_##K(at), sum_4_##K(at + 4 * BYTES_##K)); }                \
    static inline SmF64 sum_16_##K(const unsigned char *at) { return sm_add(sum_8_##K(at), sum_8_##K(at + 8 * BYTES_##K)); }               \
    static inline SmF64 sum_##K(const unsigned char *at, uint32_t count)                                                                   \
    {                                                                                                                                      \
        const unsigned char *end = at + (size_t)count * BYTES_##K;                                                                         \
        SmF64 sum = sm_from_bits((uint64_t)1 << 63);                                                                                       \
        if ((count & 1u) != 0) { end -= BYTES_##K; sum = sum_1_##K(end); }                                                                 \
        if ((count & 2u) != 0) { end -= 2 * BYTES_##K; sum = sm_add(sum_2_##K(end), sum); }                                                \
        if ((count & 4u) != 0) { end -= 4 * BYTES_##K; sum = sm_add(sum_4_##K(end), sum); }                                                \
        if ((count & 8u) != 0) { end -= 8 * BYTES_##K; sum = sm_add(sum_8_##K(end), sum); }                                                \
        if ((count & 16u) != 0) { end -= 16 * BYTES_##K; sum = sm_add(sum_16_##K(end), sum); }                                             \
        return count == 32 ? sm_add(sum_16_##K(at), sum_16_##K(at + 16 * BYTES_##K)) : sum;                                                \
    }                                                                                                                                      \
    static inline SmF64 avg_##K(const SmvmWord *w)                                                                                         \
    {                                                                                                                                      \
        const uint32_t count = window_count(w);                                                                                            \
        if (count == 0)                                                                                                                    \
            return sm_from_i32(0);                                                                                                         \
        return sm_div(sum_##K((const unsigned char *)window_words(w), count), sm_from_u32(count));                                         \
    }

#define DEFINE_INTEGER_AVERAGE(K)                                                                                                          \
    static inline SmF64 avg_##K(const SmvmWord *w) { return sm_roll_avg(window_words(w), window_size(w, SM_WINDOW_MAX), SM_ROLL_##K | SM_ROLL_AVG, window_count(w)); }

enum { BYTES_F32 = 4, BYTES_F64 = 8 };
DEFINE_FLOAT_AVERAGE(F32)
DEFINE_FLOAT_AVERAGE(F64)
DEFINE_INTEGER_AVERAGE(I16)
DEFINE_INTEGER_AVERAGE(U16)
DEFINE_INTEGER_AVERAGE(I32)

// ---- samples, medians and extremes (smallest, largest, range) ----

#define DEFINE_FOR_TYPE(K, ctype, to, of, most_of_avg)                                                                                     \
    static inline int64_t sample_##K(SmF64 x) { return of(to(x)); }                                                                        \
    static inline int64_t memory_sample_##K(const SmvmWord *w) { ctype v; memcpy(&v, w->p, sizeof v); return of(v); }                      \
    static inline void push_avg_##K(const SmvmWord *w, int64_t sample)                                                                     \
    {                                                                                                                                      \
        const uint32_t n = window_size(w, most_of_avg);                                                                                    \
        sm_roll_push(window_words(w), n, SM_ROLL_##K | SM_ROLL_AVG, sm_roll_advance(window_ring(w), n), sample);                           \
    }                                                                                                                                      \
    static inline void push_extremes_##K(const SmvmWord *w, int64_t sample)                                                                \
    {                                                                                                                                      \
        const uint32_t n = window_size(w, SM_ROLL_SCAN);                                                                                   \
        sm_roll_push(window_words(w), n, SM_ROLL_##K | SM_ROLL_RANGE, sm_roll_advance(window_ring(w), n), sample);                         \
    }                                                                                                                                      \
    static inline void push_median_##K(const SmvmWord *w, int64_t sample)                                                                  \
    {                                                                                                                                      \
        const uint32_t n = window_size(w, SM_ROLL_SHORT);                                                                                  \
        sm_roll_push_sorted(window_words(w), n, SM_ROLL_##K | SM_ROLL_MEDIAN, sm_roll_advance(window_ring(w), n), sample);                 \
    }                                                                                                                                      \
    static inline SmF64 median_##K(const SmvmWord *w)                                                                                      \
    {                                                                                                                                      \
        return sm_roll_median(window_words(w), window_size(w, SM_ROLL_SHORT), SM_ROLL_##K | SM_ROLL_MEDIAN, window_count(w));                               \
    }                                                                                                                                      \
    static inline SmF64 smallest_##K(const SmvmWord *w) { return sm_roll_min(window_words(w), window_size(w, SM_ROLL_SCAN), SM_ROLL_##K | SM_ROLL_MIN, window_count(w)); } \
    static inline SmF64 largest_##K(const SmvmWord *w) { return sm_roll_max(window_words(w), window_size(w, SM_ROLL_SCAN), SM_ROLL_##K | SM_ROLL_MAX, window_count(w)); } \
    static inline SmF64 range_##K(const SmvmWord *w) { return sm_roll_range(window_words(w), window_size(w, SM_ROLL_SCAN), SM_ROLL_##K | SM_ROLL_RANGE, window_count(w)); }

DEFINE_FOR_TYPE(I16, int16_t, sm_to_i16, , SM_WINDOW_MAX)
DEFINE_FOR_TYPE(U16, uint16_t, sm_to_u16, , SM_WINDOW_MAX)
DEFINE_FOR_TYPE(I32, int32_t, sm_to_i32, , SM_WINDOW_MAX)
DEFINE_FOR_TYPE(F32, float, sm_to_f32, sm_roll_of_f32, SM_ROLL_SHORT)
DEFINE_FOR_TYPE(F64, SmF64, , sm_roll_of_f64, SM_ROLL_SHORT)

#endif
