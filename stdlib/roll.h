// SPDX-License-Identifier: Apache-2.0
// Rolling windows (language.md 7), in memory that the caller owns.  A window stores the last n samples of a value, one a step.  Sample k is
// stored in slot k mod n.  A statistic depends only on the contents of the slots, so a sample that has left the window has no influence.
//
//     uint32_t kind = sm_roll_kind(SM_F32, stats);      // the type of the samples, and the set of statistics that will be read
//     uint64_t w[…];                                    // sm_roll_words(n, kind) words, all zero: an empty window
//     sm_roll_sample(w, n, kind, x);                    // once a step
//     y = sm_roll_stat(w, n, kind, SM_STAT_MEDIAN);
//
// A statistic of an empty window is 0.  A sample is passed as an int64_t: an integer as it is, an F32 or F64 as its bits (sm_roll_of_f32,
// sm_roll_of_f64), with NaN replaced by 0.  A window stores the key of each sample.  Where keys are compared, they are integers whose order is
// that of the samples' values, with -0 below 0; otherwise a key is the sample itself.  Samples of I64 and U64 are stored as F64.
//
// A window of the type SM_ROLL_TIMES stores times.  Its sample is an event, 0, 1 or 2, at the current time (sm_roll_sample_event):
//
//     SM_ROLL_ELAPSED          the last n times of events other than 0
//     SM_ROLL_RUN_STEPS, …_TIME a run: 0 ends it, 1 extends it or begins one, 2 begins a new one.  Two words, the times of the first and the
//                              newest event of the run; the number of samples in the ring is that of its events, at most n
//
// The first word of w is the ring: the number of samples, and the slot of the next one.  The functions that sm_roll_sample and sm_roll_stat call
// receive w + 1, which is the window without its ring.  Emitted C calls these, with n and kind as constants: sm_roll_advance; sm_roll_push or one
// of its variants; then sm_roll_combine, if the window stores partial results; and sm_roll_avg and similar.  There, windows of one size share a
// ring, because every step adds a sample to each.
//
// The cost of adding a sample, the cost of reading a statistic, and the memory beside the n slots:
//
//                                           add a sample                          read             memory
//     average of integers                   constant                             constant         a word
//     of F32, F64: n <= SM_ROLL_SHORT       constant                             n additions      none
//                  longer                   log2 n additions                     constant         n F64: sums of 2, 4, 8, … slots
//     smallest, largest: n <= SM_ROLL_SCAN  constant                             n comparisons    none
//                  longer                   log2 n comparisons                   constant         n words each, of 2, 4, 8, … slots
//     oldest, newest                        constant                             constant         none
//     median:      n <= SM_ROLL_SHORT       n comparisons, no branch             constant         n samples, in order
//                  longer                   2 log2 n comparisons, moving 2 SM_   constant         n samples, in order, and
//                                           ROLL_BLOCK samples and 1 a block                      2 bytes a block
//
// In a window with a median, the smallest and largest have no additional cost.  With SM_ROLL_SMALL a window stores only its slots and, for a
// median, the samples in order.  Average, smallest and largest then visit all slots, and adding a sample for a median moves up to n samples.
//
// Lines `// snippet of emitted C: NAME` divide this file into the snippets that emitted C can contain; f64.h explains them.  The file is long because it is
// one library in this order: emitted C contains the snippets that a machine needs in the order of the file, and each uses only earlier ones.
#ifndef SM_ROLL_H
#define SM_ROLL_H

#include <stddef.h>

#include "stdlib/convert.h"
#include "stdlib/f64.h"
#include "stdlib/roll_small.h"
#include "stdlib/types.h"

// snippet of emitted C: SmRoll
#ifndef SM_ROLL_SMALL
// 1: rolling windows use as little memory as possible, and more time.  Must be the same for all files that are compiled together.
#ifdef __AVR__
#define SM_ROLL_SMALL 1
#else
#define SM_ROLL_SMALL 0
#endif
#endif
// snippet of emitted C: end
// Outside emitted C: inlined when optimizing for speed.  Otherwise there is one copy of each function, with size and kind as arguments.
#if defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define SM_ROLL_INLINE static inline __attribute__((always_inline))
#else
#define SM_ROLL_INLINE static inline
#endif
#define SM_ROLL_INLINE_FOR_SPEED SM_ROLL_INLINE
#define SM_ROLL_OUTLINE SM_ROLL_INLINE
#ifndef SM_ROLL_CONSTANT_SIZE
#define SM_ROLL_CONSTANT_SIZE 0
#endif
#ifdef __OPTIMIZE_SIZE__
#define SM_ROLL_AT_ONCE 1u
#endif
// snippet of emitted C: SM_ROLL_INLINE
// Callers pass the size and kind of a window as constants, and inlined with constants these functions are short.  The longer functions are
// inlined at every call only when optimizing for speed (SM_ROLL_INLINE_FOR_SPEED).
#if !defined(SM_ROLL_INLINE) && defined(__OPTIMIZE__)
#define SM_ROLL_INLINE static inline __attribute__((always_inline))
#elif !defined(SM_ROLL_INLINE)
#define SM_ROLL_INLINE static inline
#endif
#if !defined(SM_ROLL_INLINE_FOR_SPEED) && defined(__OPTIMIZE_SIZE__)
#define SM_ROLL_INLINE_FOR_SPEED static inline
#elif !defined(SM_ROLL_INLINE_FOR_SPEED)
#define SM_ROLL_INLINE_FOR_SPEED SM_ROLL_INLINE
#endif
#ifndef SM_ROLL_CONSTANT_SIZE
#define SM_ROLL_CONSTANT_SIZE 1         // the C compiler knows the size of each window: a comparison with it costs no code
#endif
#if !defined(SM_ROLL_OUTLINE) && defined(__GNUC__)
#define SM_ROLL_OUTLINE __attribute__((noinline)) static
#elif !defined(SM_ROLL_OUTLINE)
#define SM_ROLL_OUTLINE static
#endif
// The kind of a window: the type in which it stores its samples, and the statistics that it supports.
enum {
    SM_ROLL_I8 = 0, SM_ROLL_I16 = 1, SM_ROLL_I32 = 2, SM_ROLL_U8 = 4, SM_ROLL_U16 = 5, SM_ROLL_U32 = 6,
    SM_ROLL_F32 = 8, SM_ROLL_F64 = 9, SM_ROLL_BOOL = 10, SM_ROLL_TYPE = 15,
    SM_ROLL_AVG = 16, SM_ROLL_MEDIAN = 32, SM_ROLL_MIN = 64, SM_ROLL_MAX = 128, SM_ROLL_RANGE = 256,
    SM_ROLL_OLDEST = 512, SM_ROLL_NEWEST = 1024, SM_ROLL_CHANGE = 2048,
    SM_ROLL_TIMES = 7,         // a window of times or a run, with its own statistics:
    SM_ROLL_ELAPSED = 4096, SM_ROLL_RUN_STEPS = 8192, SM_ROLL_RUN_TIME = 16384,
    SM_ROLL_ORDER = 480        // the statistics that compare samples
};
#define SM_ROLL_MEDIAN_OF_3 ((uint32_t)SM_ROLL_MEDIAN | 0x8000u)        // the same as SM_ROLL_MEDIAN, of a window of three slots in emitted C
#define SM_ROLL_ANY_ZERO 0x10000u      // only for reading a statistic: a result of 0 may have the wrong sign
// SM_ROLL_SHORT: the longest window whose average is summed up when it is read, and which is sorted by one pass over all samples.
// SM_ROLL_SCAN: the longest window whose smallest and largest are found by visiting all samples.
// SM_ROLL_BLOCK: the number of ordered samples in a block that moves at once.
#define SM_ROLL_SHORT 32u
#define SM_ROLL_SCAN 64u
#define SM_ROLL_BLOCK 2048u
#define SM_ROLL_LONG(n) (!SM_ROLL_SMALL && (n) > SM_ROLL_BLOCK)
// snippet of emitted C: end
#ifndef SM_ROLL_UNROLL
#define SM_ROLL_UNROLL      // outside emitted C, sizes are known only at run time, so loops are not unrolled
#endif
// snippet of emitted C: SM_ROLL_UNROLL
// Placed before a loop over a short window, to unroll it completely.
#ifndef SM_ROLL_UNROLL
#if defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__) && !defined(__clang__) && defined(__GNUC__) && __GNUC__ >= 8
#define SM_ROLL_UNROLL _Pragma("GCC unroll 32")
#else
#define SM_ROLL_UNROLL
#endif
#endif
// snippet of emitted C: end
#ifndef SM_ROLL_BY_VALUE
#define SM_ROLL_BY_VALUE 0      // outside emitted C, the smaller code
#endif
// snippet of emitted C: SM_ROLL_BY_VALUE
// 1: a window of F32 or F64 stores its samples as they are, and compares them as numbers, unless a median stores them in order.  For processors
// whose registers hold such numbers, where that costs less than comparing keys.
#ifndef SM_ROLL_BY_VALUE
#if !SM_ROLL_SMALL && (defined(__SSE2__) || defined(_M_X64) || defined(__aarch64__) || defined(_M_ARM64))
#define SM_ROLL_BY_VALUE 1
#else
#define SM_ROLL_BY_VALUE 0
#endif
#endif
// snippet of emitted C: end
#ifndef SM_ROLL_LATE_ORDER
#define SM_ROLL_LATE_ORDER 0    // outside emitted C: files that share a window can be compiled with different options
#endif
// snippet of emitted C: SM_ROLL_LATE_ORDER
// 1: three samples are put in order when their median is read, which takes less time than storing them in order.  It is more code, unless they are
// compared as numbers.
#ifndef SM_ROLL_LATE_ORDER
#if !SM_ROLL_SMALL && defined(__OPTIMIZE__) && (SM_ROLL_BY_VALUE || !defined(__OPTIMIZE_SIZE__))
#define SM_ROLL_LATE_ORDER 1
#else
#define SM_ROLL_LATE_ORDER 0
#endif
#endif
// snippet of emitted C: SM_ROLL_AT_ONCE
// The number of samples that one iteration adds or compares: 4 or 1.
#if !defined(SM_ROLL_AT_ONCE)
#define SM_ROLL_AT_ONCE 4u
#endif
// snippet of emitted C: end
// The key of a sample.  Emitted C defines it as the smallest type that its windows need.
typedef int64_t SmRollKey;
// snippet of emitted C: SmRollSize
// The type of a number of samples: at most 100000, and fewer where memory has 64 KB.
#if SIZE_MAX > 65535
typedef uint32_t SmRollSize;
#else
typedef uint16_t SmRollSize;
#endif
// snippet of emitted C: sm_roll_of_f32
// The bits of a sample; NaN counts as 0.
static inline int32_t sm_roll_of_f32(float x)
{
    int32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return x != x ? 0 : bits;
}
// snippet of emitted C: sm_roll_of_f64
// The bits of a sample; NaN counts as 0.
static inline int64_t sm_roll_of_f64(SmF64 x)
{
    int64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return sm_is_nan(x) ? 0 : bits;
}
// snippet of emitted C: sm_roll_ordered
// Converts a sample to an integer, or that integer to its sample.  These integers have the order of the numbers, with -0 below 0.
SM_ROLL_INLINE SmRollKey sm_roll_ordered(uint32_t kind, SmRollKey sample)
{
    if ((kind & SM_ROLL_TYPE) < SM_ROLL_F32 || sample >= 0)
        return sample;
    return (SmRollKey)(sample ^ ((kind & SM_ROLL_TYPE) == SM_ROLL_F32 ? 0x7FFFFFFF : 0x7FFFFFFFFFFFFFFF));
}
// snippet of emitted C: sm_roll_stores_order
// Whether a window stores its samples as the integers of sm_roll_ordered.  Otherwise it stores their bits.
SM_ROLL_INLINE bool sm_roll_stores_order(uint32_t kind)
{
    const uint32_t in_order = SM_ROLL_LATE_ORDER ? SM_ROLL_MEDIAN_OF_3 : (uint32_t)SM_ROLL_MEDIAN;
    if (!SM_ROLL_BY_VALUE)
        return SM_ROLL_SMALL || (kind & SM_ROLL_ORDER) != 0;
    return (kind & in_order) == SM_ROLL_MEDIAN;
}
// snippet of emitted C: sm_roll_key
// Converts a sample to its key, which is what the window stores, or a key to its sample.
SM_ROLL_INLINE SmRollKey sm_roll_key(uint32_t kind, SmRollKey sample)
{
    return sm_roll_stores_order(kind) ? sm_roll_ordered(kind, sample) : sample;
}
// snippet of emitted C: sm_roll_order_of_key
// Converts a key to the integer of sm_roll_ordered, or that integer to its key.
SM_ROLL_INLINE SmRollKey sm_roll_order_of_key(uint32_t kind, SmRollKey key)
{
    return !SM_ROLL_BY_VALUE || sm_roll_stores_order(kind) ? key : sm_roll_ordered(kind, key);
}
// snippet of emitted C: sm_roll_value
// Converts a key to the value of its sample.
SM_ROLL_INLINE SmF64 sm_roll_value(uint32_t kind, SmRollKey key)
{
    const SmRollKey sample = sm_roll_key(kind, key);
    const int32_t bits = (int32_t)sample;
    float f;
    if ((kind & SM_ROLL_TYPE) == SM_ROLL_F64)
        return sm_from_bits((uint64_t)sample);
    if ((kind & SM_ROLL_TYPE) != SM_ROLL_F32)
        return sizeof sample > 4 ? sm_from_i64(sample) : sm_from_i32((int32_t)sample);
    memcpy(&f, &bits, sizeof f);
    return sm_from_f32(f);
}
// snippet of emitted C: sm_roll_shift
// Returns the size of a sample as a power of two: it has 1 << result bytes.
SM_ROLL_INLINE unsigned sm_roll_shift(uint32_t kind)
{
    const unsigned type = kind & SM_ROLL_TYPE;
    return type < 8 ? type & 3u : type == SM_ROLL_BOOL ? 0 : type - 6u;
}
// snippet of emitted C: sm_roll_load
// Returns key i of an array.
SM_ROLL_INLINE SmRollKey sm_roll_load(const unsigned char *a, SmRollSize i, uint32_t kind)
{
    switch (kind & SM_ROLL_TYPE) {
    case SM_ROLL_I8: { int8_t v; memcpy(&v, a + i, 1); return v; }
    case SM_ROLL_I16: { int16_t v; memcpy(&v, a + (size_t)i * 2, 2); return v; }
    case SM_ROLL_I32: case SM_ROLL_F32: { int32_t v; memcpy(&v, a + (size_t)i * 4, 4); return (SmRollKey)v; }
    case SM_ROLL_U16: { uint16_t v; memcpy(&v, a + (size_t)i * 2, 2); return (SmRollKey)v; }
    case SM_ROLL_U32: { uint32_t v; memcpy(&v, a + (size_t)i * 4, 4); return (SmRollKey)v; }
    case SM_ROLL_F64: { int64_t v; memcpy(&v, a + (size_t)i * 8, 8); return (SmRollKey)v; }
    default: return a[i];
    }
}
// snippet of emitted C: sm_roll_store
SM_ROLL_INLINE void sm_roll_store(unsigned char *a, SmRollSize i, uint32_t kind, SmRollKey key)
{
    switch (sm_roll_shift(kind)) {
    case 0: a[i] = (unsigned char)key; break;
    case 1: { const uint16_t v = (uint16_t)key; memcpy(a + (size_t)i * 2, &v, 2); break; }
    case 2: { const uint32_t v = (uint32_t)key; memcpy(a + (size_t)i * 4, &v, 4); break; }
    default: { const int64_t v = key; memcpy(a + (size_t)i * 8, &v, 8); break; }
    }
}
// snippet of emitted C: sm_roll_partials
// Returns which partial results a window stores beside its samples, as bits: the sum as a whole number (1) or as an F64 (2), the smallest
// sample (4), the largest (8).
SM_ROLL_INLINE unsigned sm_roll_partials(uint32_t n, uint32_t kind)
{
    const bool real = (kind & SM_ROLL_TYPE) == SM_ROLL_F32 || (kind & SM_ROLL_TYPE) == SM_ROLL_F64;
    const unsigned sum = (kind & SM_ROLL_AVG) == 0 ? 0 : !real ? 1u : n > SM_ROLL_SHORT ? 2u : 0;
    if (SM_ROLL_SMALL)
        return 0;
    if ((kind & SM_ROLL_MEDIAN) != 0 || n <= SM_ROLL_SCAN)
        return sum;
    return sum | ((kind & (SM_ROLL_MIN | SM_ROLL_RANGE)) != 0 ? 4u : 0) | ((kind & (SM_ROLL_MAX | SM_ROLL_RANGE)) != 0 ? 8u : 0);
}
// snippet of emitted C: sm_roll_partial_words
// The number of words that the partial results of the whole window take: one each.
SM_ROLL_INLINE unsigned sm_roll_partial_words(unsigned partials) { return ((partials & 3u) != 0) + (partials >> 2 & 1u) + (partials >> 3); }
// snippet of emitted C: sm_roll_node_partials
// Returns which partial results a window also stores for each group of 2, 4, 8, … slots, as bits of sm_roll_partials.
SM_ROLL_INLINE unsigned sm_roll_node_partials(uint32_t n, uint32_t kind) { return sm_roll_partials(n, kind) & 14u; }
// snippet of emitted C: sm_roll_slots_at
// The index of the word where the slots begin.  A window consists of: the partial results of the whole window, in the order of
// sm_roll_partials, the largest as the complement of its key; the slots; for a median the samples in order; the partial results of the groups
// of 2, 4, 8, … slots.
SM_ROLL_INLINE unsigned sm_roll_slots_at(uint32_t n, uint32_t kind) { return sm_roll_partial_words(sm_roll_partials(n, kind)); }
// snippet of emitted C: sm_roll_row_bytes
// Bytes of an array of n samples, rounded up to words.
SM_ROLL_INLINE uint32_t sm_roll_row_bytes(uint32_t n, uint32_t kind) { return ((n << sm_roll_shift(kind)) + 7u) & ~(uint32_t)7; }
// snippet of emitted C: sm_roll_heads_bytes
// Bytes of the array that stores, for each block of ordered samples, at which index in the block its order begins.
SM_ROLL_INLINE uint32_t sm_roll_heads_bytes(uint32_t n) { return SM_ROLL_LONG(n) ? (n / SM_ROLL_BLOCK * 2u + 9u) & ~(uint32_t)7 : 0; }
// snippet of emitted C: sm_roll_tree_words
// Words between the trees of two kinds of partial results.  A tree has n / 2 results for pairs of slots, n / 4 for groups of four, and so on,
// each number rounded up.
SM_ROLL_INLINE uint32_t sm_roll_tree_words(uint32_t n) { return n + 15; }
// snippet of emitted C: sm_roll_nodes_at
// The index of the word where the partial results of pairs of slots begin.
SM_ROLL_INLINE uint32_t sm_roll_nodes_at(uint32_t n, uint32_t kind)
{
    const uint32_t row = sm_roll_row_bytes(n, kind);
    return sm_roll_slots_at(n, kind) + ((kind & SM_ROLL_MEDIAN) == 0 ? row : 2 * row + sm_roll_heads_bytes(n)) / 8;
}
// snippet of emitted C: sm_roll_count
// The number of samples in the windows of a ring, at most its number of slots.
SM_ROLL_INLINE SmRollSize sm_roll_count(const uint64_t *ring) { uint32_t v; memcpy(&v, ring, 4); return (SmRollSize)v; }
// snippet of emitted C: sm_roll_next
// The slot of the next sample.
SM_ROLL_INLINE SmRollSize sm_roll_next(const uint64_t *ring) { uint32_t v; memcpy(&v, (const unsigned char *)ring + 4, 4); return (SmRollSize)v; }
// snippet of emitted C: sm_roll_set_count
// Stores the number of samples.
SM_ROLL_INLINE void sm_roll_set_count(uint64_t *ring, uint32_t count) { memcpy(ring, &count, 4); }
// snippet of emitted C: sm_roll_set_next
// Stores the slot of the next sample.
SM_ROLL_INLINE void sm_roll_set_next(uint64_t *ring, uint32_t next) { memcpy((unsigned char *)ring + 4, &next, 4); }
// snippet of emitted C: SmRollAt
// Where a step adds its samples: the slot, and the number of samples before.
typedef struct SmRollAt { SmRollSize slot, count; } SmRollAt;
// snippet of emitted C: sm_roll_advance
// Begins a step of the windows of a ring of n slots.  Returns where the step adds their samples; the ring then counts these.
SM_ROLL_INLINE_FOR_SPEED SmRollAt sm_roll_advance(uint64_t *ring, uint32_t n)
{
    const SmRollAt at = { sm_roll_next(ring), sm_roll_count(ring) };
    sm_roll_set_next(ring, at.slot + 1u < n ? at.slot + 1u : 0);
    if (at.count < n)
        sm_roll_set_count(ring, at.count + 1u);
    return at;
}
// snippet of emitted C: sm_roll_slot_key
// The key in slot i.
SM_ROLL_INLINE SmRollKey sm_roll_slot_key(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize i)
{
    return sm_roll_load((const unsigned char *)(w + sm_roll_slots_at(n, kind)), i, kind);
}
// snippet of emitted C: sm_roll_push_key
// Adds a sample to a window of n slots, by its key.
SM_ROLL_INLINE void sm_roll_push_key(uint64_t *w, uint32_t n, uint32_t kind, SmRollAt at, SmRollKey key)
{
    if ((sm_roll_partials(n, kind) & 1u) != 0)
        w[0] += (uint64_t)((int64_t)key - sm_roll_slot_key(w, n, kind, at.slot));   // an empty slot contains 0
    sm_roll_store((unsigned char *)(w + sm_roll_slots_at(n, kind)), at.slot, kind, key);
}
// snippet of emitted C: sm_roll_push
// Adds a sample to a window of n slots.
SM_ROLL_INLINE_FOR_SPEED void sm_roll_push(uint64_t *w, uint32_t n, uint32_t kind, SmRollAt at, SmRollKey sample)
{
    sm_roll_push_key(w, n, kind, at, sm_roll_key(kind, sample));
}
// snippet of emitted C: sm_roll_insert_stepwise
// Inserts a key among `count` ordered keys.  In a full window it replaces `old`.  The gap moves from the end, or from `old`, step by step.
SM_ROLL_INLINE_FOR_SPEED void sm_roll_insert_stepwise(unsigned char *sorted, SmRollSize count, bool full, uint32_t kind, SmRollKey old, SmRollKey key)
{
    SmRollSize i = full ? 0 : count;
    while (full && i + 1u < count && sm_roll_load(sorted, i, kind) != old)
        i++;
    for (; i > 0 && key < sm_roll_load(sorted, (SmRollSize)(i - 1u), kind); i--)
        sm_roll_store(sorted, i, kind, sm_roll_load(sorted, (SmRollSize)(i - 1u), kind));
    for (; full && i + 1u < count && sm_roll_load(sorted, (SmRollSize)(i + 1u), kind) < key; i++)
        sm_roll_store(sorted, i, kind, sm_roll_load(sorted, (SmRollSize)(i + 1u), kind));
    sm_roll_store(sorted, i, kind, key);
}
// snippet of emitted C: sm_roll_is_ordered
// Whether a window with a median stores its samples in order.
SM_ROLL_INLINE bool sm_roll_is_ordered(uint32_t n) { return !SM_ROLL_LATE_ORDER || n != 3; }
// snippet of emitted C: sm_roll_push_sorted
// Adds a sample to a short window that also stores its samples in order.  One pass without branches inserts the new one and removes the oldest.
SM_ROLL_INLINE void sm_roll_push_sorted(uint64_t *w, uint32_t n, uint32_t kind, SmRollAt at, SmRollKey sample)
{
    unsigned char *const sorted = (unsigned char *)(w + sm_roll_slots_at(n, kind)) + sm_roll_row_bytes(n, kind);
    const SmRollKey old = sm_roll_slot_key(w, n, kind, at.slot);
    SmRollKey key = sm_roll_key(kind, sample), a = sm_roll_load(sorted, 0, kind), next;
    const bool full = at.count == n;
    SmRollSize i;
    sm_roll_push_key(w, n, kind, at, key);
    if (!sm_roll_is_ordered(n))
        return;
    if (SM_ROLL_SMALL || !full) {
        sm_roll_insert_stepwise(sorted, at.count, full, kind, old, key);
    } else {
        SM_ROLL_UNROLL
        for (i = 0; i + 1u < n; i++) {
            next = sm_roll_load(sorted, (SmRollSize)(i + 1u), kind);
            a = a < old ? a : next;                      // the remaining sample of rank i
            sm_roll_store(sorted, i, kind, key < a ? key : a);
            key = key < a ? a : key;
            a = next;
        }
        sm_roll_store(sorted, i, kind, key);
    }
}
// snippet of emitted C: sm_roll_index_of_rank
// The index of the ordered sample of a rank.  A long array consists of blocks, each of them a ring that may begin anywhere.
SM_ROLL_INLINE SmRollSize sm_roll_index_of_rank(const unsigned char *sorted, uint32_t n, uint32_t kind, uint32_t rank)
{
    const uint32_t first = rank & ~(SM_ROLL_BLOCK - 1), end = n - first < SM_ROLL_BLOCK ? n : first + SM_ROLL_BLOCK;
    if (!SM_ROLL_LONG(n))
        return (SmRollSize)rank;
    rank = rank + (uint16_t)sm_roll_load(sorted + sm_roll_row_bytes(n, kind), (SmRollSize)(first / SM_ROLL_BLOCK), SM_ROLL_U16);
    return (SmRollSize)(rank < end ? rank : rank - end + first);
}
// snippet of emitted C: sm_roll_count_below
// The number of the first `count` ordered samples that are below key.
SM_ROLL_INLINE_FOR_SPEED uint32_t sm_roll_count_below(const unsigned char *sorted, uint32_t n, uint32_t kind, uint32_t count, SmRollKey key)
{
    uint32_t lo = 0, half;
    for (; count > 1; count -= half) {
        half = count / 2;
        lo += half & (0u - (uint32_t)(sm_roll_load(sorted, sm_roll_index_of_rank(sorted, n, kind, lo + half - 1), kind) < key));
    }
    if (count == 1 && sm_roll_load(sorted, sm_roll_index_of_rank(sorted, n, kind, lo), kind) < key)
        lo++;
    return lo;
}
// snippet of emitted C: sm_roll_slide
// Moves a gap among the ordered samples from index `from` to index `to`, by shifting the samples between them by one.
SM_ROLL_INLINE_FOR_SPEED void sm_roll_slide(unsigned char *sorted, uint32_t kind, uint32_t from, uint32_t to)
{
    const unsigned shift = sm_roll_shift(kind);
    unsigned char *const a = sorted + ((size_t)from << shift), *const b = sorted + ((size_t)to << shift);
    if (from <= to)
        memmove(a, a + ((size_t)1 << shift), (size_t)(b - a));
    else
        memmove(b + ((size_t)1 << shift), b, (size_t)(a - b));
}
// snippet of emitted C: sm_roll_slide_in_block
// Moves a gap from rank `from` to rank `to` of one block.  The shift may need two parts, because a block is a ring.
SM_ROLL_INLINE_FOR_SPEED void sm_roll_slide_in_block(unsigned char *sorted, uint32_t n, uint32_t kind, uint32_t from, uint32_t to)
{
    const uint32_t first = from & ~(SM_ROLL_BLOCK - 1), last = (n - first < SM_ROLL_BLOCK ? n : first + SM_ROLL_BLOCK) - 1;
    const bool up = from <= to;
    uint32_t a = sm_roll_index_of_rank(sorted, n, kind, from);
    const uint32_t b = sm_roll_index_of_rank(sorted, n, kind, to);
    if (SM_ROLL_LONG(n) && (a <= b) != up) {
        sm_roll_slide(sorted, kind, a, up ? last : first);
        a = up ? first : last;
        sm_roll_store(sorted, (SmRollSize)(up ? last : first), kind, sm_roll_load(sorted, (SmRollSize)a, kind));
    }
    sm_roll_slide(sorted, kind, a, b);
}
// snippet of emitted C: sm_roll_slide_ranks
// Moves a gap from rank `from` to rank `to`.  Each block on the way passes one sample to the next; whole blocks in between are only rotated.
SM_ROLL_INLINE_FOR_SPEED void sm_roll_slide_ranks(unsigned char *sorted, uint32_t n, uint32_t kind, uint32_t from, uint32_t to)
{
    unsigned char *const heads = sorted + sm_roll_row_bytes(n, kind);
    const uint32_t mask = SM_ROLL_BLOCK - 1, step = from <= to ? 1u : UINT32_MAX;
    uint32_t end, head;
    SmRollSize out;
    while (SM_ROLL_LONG(n) && (from & ~mask) != (to & ~mask)) {
        end = step == 1 ? from | mask : from & ~mask;
        sm_roll_slide_in_block(sorted, n, kind, from, end);
        from = end + step;
        out = sm_roll_index_of_rank(sorted, n, kind, from);
        sm_roll_store(sorted, sm_roll_index_of_rank(sorted, n, kind, end), kind, sm_roll_load(sorted, out, kind));
        if ((from & ~mask) != (to & ~mask)) {
            head = (uint32_t)sm_roll_load(heads, (SmRollSize)(from / SM_ROLL_BLOCK), SM_ROLL_U16);
            sm_roll_store(heads, (SmRollSize)(from / SM_ROLL_BLOCK), SM_ROLL_U16, (head + step) & mask);
            from ^= mask;
        }
    }
    sm_roll_slide_in_block(sorted, n, kind, from, to);
}
// snippet of emitted C: sm_roll_insert_sorted
// Inserts a key among the ordered samples of a longer window; if the window is full, removes the oldest sample.  Finds the rank of the key and
// the rank that becomes free, and shifts the samples between them.
SM_ROLL_INLINE_FOR_SPEED void sm_roll_insert_sorted(uint64_t *w, uint32_t n, uint32_t kind, SmRollAt at, SmRollKey key)
{
    unsigned char *const sorted = (unsigned char *)(w + sm_roll_slots_at(n, kind)) + sm_roll_row_bytes(n, kind);
    const uint32_t count = at.count;
    const uint32_t from = count < n ? count : sm_roll_count_below(sorted, n, kind, count, sm_roll_slot_key(w, n, kind, at.slot));
    uint32_t to = sm_roll_count_below(sorted, n, kind, count, key);
    to -= from < to;                                 // the rank without the oldest sample
    sm_roll_slide_ranks(sorted, n, kind, from, to);
    sm_roll_store(sorted, sm_roll_index_of_rank(sorted, n, kind, to), kind, key);
}
// snippet of emitted C: sm_roll_push_blocks
// Adds a sample to a longer window that also stores its samples in order.
SM_ROLL_INLINE_FOR_SPEED void sm_roll_push_blocks(uint64_t *w, uint32_t n, uint32_t kind, SmRollAt at, SmRollKey sample)
{
    sm_roll_insert_sorted(w, n, kind, at, sm_roll_key(kind, sample));
    sm_roll_push(w, n, kind, at, sample);
}
// snippet of emitted C: sm_roll_update_sums
// Returns the sum of all slots after sample i was added; `sum` is the sum of its pair.  Stores the sums of pairs and of groups of four,
// eight, … slots.  An odd last group passes its sum on unchanged.
SM_ROLL_INLINE_FOR_SPEED SmF64 sm_roll_update_sums(uint64_t *node, uint32_t n, uint32_t i, uint32_t count, SmF64 sum)
{
    SM_ROLL_UNROLL
    for (n = (n + 1) / 2; n > 1; n = (n + 1) / 2) {
        i /= 2;
        count = (count + 1) / 2;
        node[i] = sm_bits(sum);
        if ((i ^ 1u) < count)
            sum = sm_add(sum, sm_from_bits(node[i ^ 1u]));
        node += n;
    }
    return sum;
}
// snippet of emitted C: sm_roll_update_smallest
// Returns the smallest key of all slots after sample i was added; `least` is the smaller key of its pair.  Stores the smallest keys of pairs
// and of groups of four, eight, … slots.
SM_ROLL_INLINE_FOR_SPEED int64_t sm_roll_update_smallest(uint64_t *node, uint32_t n, uint32_t i, uint32_t count, int64_t least)
{
    for (n = (n + 1) / 2; n > 1; n = (n + 1) / 2) {
        i /= 2;
        count = (count + 1) / 2;
        node[i] = (uint64_t)least;
        if ((i ^ 1u) < count && (int64_t)node[i ^ 1u] < least)
            least = (int64_t)node[i ^ 1u];
        node += n;
    }
    return least;
}
// snippet of emitted C: sm_roll_combine
// After a sample was added: updates the results of the groups of 2, 4, 8, … slots that contain it, and of the whole window.
SM_ROLL_INLINE_FOR_SPEED void sm_roll_combine(uint64_t *w, uint32_t n, uint32_t kind, SmRollAt at)
{
    const unsigned partials = sm_roll_node_partials(n, kind);
    const uint32_t i = at.slot, count = at.count < n ? at.count + 1u : n;
    const bool paired = (i ^ 1u) < count;
    SmRollKey key = sm_roll_slot_key(w, n, kind, (SmRollSize)i), other = sm_roll_slot_key(w, n, kind, (SmRollSize)(i ^ (uint32_t)paired));
    uint64_t *node = w + sm_roll_nodes_at(n, kind), *all = w + (sm_roll_partials(n, kind) & 1u);
    SmF64 sum = sm_roll_value(kind, key);
    if ((partials & 2u) != 0) {
        sum = paired ? sm_add(sum, sm_roll_value(kind, other)) : sum;
        *all++ = sm_bits(SM_ROLL_CONSTANT_SIZE && count == n ? sm_roll_update_sums(node, n, i, n, sum) : sm_roll_update_sums(node, n, i, count, sum));
        node += sm_roll_tree_words(n);
    }
    key = sm_roll_order_of_key(kind, key);
    other = sm_roll_order_of_key(kind, other);
    if ((partials & 4u) != 0) {
        *all++ = (uint64_t)sm_roll_update_smallest(node, n, i, count, key < other ? key : other);
        node += sm_roll_tree_words(n);
    }
    if ((partials & 8u) != 0)
        *all = (uint64_t)sm_roll_update_smallest(node, n, i, count, ~(int64_t)(key > other ? key : other));
}
// snippet of emitted C: sm_roll_sum_group
// The sum of the first SM_ROLL_AT_ONCE of the `left` slots from `at` on, or of all if these are fewer, added in pairs.
SM_ROLL_INLINE SmF64 sm_roll_sum_group(const unsigned char *at, uint32_t left, uint32_t kind)
{
    SmF64 sum = sm_roll_value(kind, sm_roll_load(at, 0, kind)), other;
    if (SM_ROLL_AT_ONCE == 1 || left == 1)
        return sum;
    sum = sm_add(sum, sm_roll_value(kind, sm_roll_load(at, 1, kind)));
    if (left == 2)
        return sum;
    other = sm_roll_value(kind, sm_roll_load(at, 2, kind));
    return sm_add(sum, left > 3 ? sm_add(other, sm_roll_value(kind, sm_roll_load(at, 3, kind))) : other);
}
// snippet of emitted C: sm_roll_sum
// The sum of all slots: adds slots in pairs, the sums of pairs in pairs again, and so on.  `part` has the sums that wait for their partner.
SM_ROLL_INLINE_FOR_SPEED SmF64 sm_roll_sum(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count)
{
    const unsigned char *at = (const unsigned char *)(w + sm_roll_slots_at(n, kind));
    SmF64 part[17], *end = part, sum = sm_from_bits(0);
    SmRollSize i, whole;
    if (SM_ROLL_CONSTANT_SIZE && n <= SM_ROLL_AT_ONCE)
        return sm_roll_sum_group(at, count, kind);
    for (i = 0; i < count; i = (SmRollSize)(i + SM_ROLL_AT_ONCE), at += (size_t)SM_ROLL_AT_ONCE << sm_roll_shift(kind)) {
        sum = sm_roll_sum_group(at, (uint32_t)(count - i), kind);
        for (whole = (SmRollSize)(i / SM_ROLL_AT_ONCE); whole % 2 != 0; whole /= 2)
            sum = sm_add(*--end, sum);
        *end++ = sum;
    }
    for (end--; end != part;)
        sum = sm_add(*--end, sum);
    return sum;
}
// snippet of emitted C: sm_roll_sum_of_integers
SM_ROLL_INLINE_FOR_SPEED SmF64 sm_roll_sum_of_integers(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count)
{
    const unsigned char *const at = (const unsigned char *)(w + sm_roll_slots_at(n, kind));
    int64_t sum = 0;
    int32_t sum_of_short = 0;                           // no overflow: 32768 samples of 16 bits
    SmRollSize i;
    if (sizeof(SmRollKey) == 2 && n <= 32768) {
        for (i = 0; i < count; i++)
            sum_of_short += (int32_t)sm_roll_load(at, i, kind);
        return sm_from_i32(sum_of_short);
    }
    for (i = 0; i < count; i++)
        sum += sm_roll_load(at, i, kind);
    return sm_from_i64(sum);
}
// snippet of emitted C: sm_roll_avg
SM_ROLL_INLINE_FOR_SPEED SmF64 sm_roll_avg(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count)
{
    const unsigned partials = sm_roll_partials(n, kind);
    SmF64 sum;
    if (count == 0)
        return sm_from_i32(0);
    if ((partials & 3u) != 0)
        sum = (partials & 1u) != 0 ? sm_from_i64((int64_t)w[0]) : sm_from_bits(w[0]);
    else
        sum = !SM_ROLL_SMALL || (kind & SM_ROLL_TYPE) == SM_ROLL_F32 || (kind & SM_ROLL_TYPE) == SM_ROLL_F64 ? sm_roll_sum(w, n, kind, count) : sm_roll_sum_of_integers(w, n, kind, count);
    return sm_div(sum, sm_from_u32(count));
}
// snippet of emitted C: end
#if SM_F64_SOFT
#include "stdlib/soft_cells.h"
// snippet of emitted C: sm_roll_avg_of_f32
// The same for at most SM_SOFT_SUM_MOST samples of F32, which are usually so close to each other that their sum is exact.
SM_ROLL_INLINE_FOR_SPEED SmF64 sm_roll_avg_of_f32(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count)
{
    const unsigned char *const keys = (const unsigned char *)(w + sm_roll_slots_at(n, kind));
    const uint64_t sum = SM_ROLL_SMALL && count > 0 ? sm_soft_sum_f32(keys, (uint8_t)count) : 0;
    return sum == 0 ? sm_roll_avg(w, n, kind, count) : sm_div(sm_from_bits(sum), sm_from_u32(count));
}
// snippet of emitted C: end
#endif
// snippet of emitted C: sm_roll_load_f32
SM_ROLL_INLINE float sm_roll_load_f32(const unsigned char *at) { float x; memcpy(&x, at, sizeof x); return x; }
// snippet of emitted C: sm_roll_load_f64
SM_ROLL_INLINE SmF64 sm_roll_load_f64(const unsigned char *at) { SmF64 x; memcpy(&x, at, sizeof x); return x; }
// snippet of emitted C: sm_roll_extreme_of_f32
// The smaller number, or the larger if `up`.  A comparison in this form is one instruction on x86.
SM_ROLL_INLINE float sm_roll_extreme_of_f32(bool up, float a, float b) { return (up ? b < a : a < b) ? a : b; }
// snippet of emitted C: sm_roll_extreme_of_f64
// The smaller F64, or the larger if `up`.
SM_ROLL_INLINE SmF64 sm_roll_extreme_of_f64(bool up, SmF64 a, SmF64 b) { return (up ? sm_lt(b, a) : sm_lt(a, b)) ? a : b; }
// snippet of emitted C: sm_roll_extreme_of_two
// The smaller key, or the larger if `up`.
SM_ROLL_INLINE SmRollKey sm_roll_extreme_of_two(bool up, SmRollKey a, SmRollKey b) { return (up ? a > b : a < b) ? a : b; }
// snippet of emitted C: end
#ifndef SM_ROLL_VECTORS
#define SM_ROLL_VECTORS 0       // outside emitted C, sizes are known only at run time
#endif
// snippet of emitted C: SM_ROLL_VECTORS
// 1: the smallest and largest of F32 are found four at a time, by instructions that every x86-64 has.
#ifndef SM_ROLL_VECTORS
#if SM_ROLL_BY_VALUE && defined(__SSE2__) && defined(__GNUC__) && defined(__OPTIMIZE__)
#define SM_ROLL_VECTORS 1
#else
#define SM_ROLL_VECTORS 0
#endif
#endif
#if SM_ROLL_VECTORS
#include <xmmintrin.h>
#endif
// snippet of emitted C: sm_roll_extreme_vector
#if SM_ROLL_VECTORS
// The smallest of n >= 4 numbers, or the largest if `up`.  If that is 0, its sign can be wrong.  The last four overlap the four before them.
SM_ROLL_INLINE __m128 sm_roll_load_vector(const unsigned char *at) { return _mm_loadu_ps((const float *)(const void *)at); }
SM_ROLL_INLINE __m128 sm_roll_extreme_of_vectors(bool up, __m128 a, __m128 b) { return up ? _mm_max_ps(a, b) : _mm_min_ps(a, b); }
SM_ROLL_INLINE float sm_roll_extreme_vector(const unsigned char *at, uint32_t n, bool up)
{
    __m128 end = sm_roll_load_vector(at + (size_t)(n - 4) * 4);
    uint32_t i;
    SM_ROLL_UNROLL
    for (i = 0; i + 4 < n; i += 4)
        end = sm_roll_extreme_of_vectors(up, end, sm_roll_load_vector(at + (size_t)i * 4));
    end = sm_roll_extreme_of_vectors(up, end, _mm_movehl_ps(end, end));
    return _mm_cvtss_f32(sm_roll_extreme_of_vectors(up, end, _mm_shuffle_ps(end, end, 1)));
}
#endif
// snippet of emitted C: sm_roll_extreme_f32
// The smallest number, or the largest if `up`.  If that is 0, its sign can be wrong.
SM_ROLL_INLINE float sm_roll_extreme_f32(const unsigned char *at, uint32_t n, SmRollSize left, bool up)
{
    float end = sm_roll_load_f32(at), a, b;
#if SM_ROLL_VECTORS
    if (n >= 4 && left == n)
        return sm_roll_extreme_vector(at, n, up);
#else
    (void)n;
#endif
    for (; SM_ROLL_AT_ONCE == 4u && left >= 4; left = (SmRollSize)(left - 4u), at += 16) {
        a = sm_roll_extreme_of_f32(up, sm_roll_load_f32(at), sm_roll_load_f32(at + 4));
        b = sm_roll_extreme_of_f32(up, sm_roll_load_f32(at + 8), sm_roll_load_f32(at + 12));
        end = sm_roll_extreme_of_f32(up, end, sm_roll_extreme_of_f32(up, a, b));
    }
    for (; left > 0; left--, at += 4)
        end = sm_roll_extreme_of_f32(up, end, sm_roll_load_f32(at));
    return end;
}
// snippet of emitted C: sm_roll_extreme_f64
// As sm_roll_extreme_f32, for numbers of type F64.
SM_ROLL_INLINE SmF64 sm_roll_extreme_f64(const unsigned char *at, SmRollSize left, bool up)
{
    SmF64 end = sm_roll_load_f64(at), a, b;
    for (; SM_ROLL_AT_ONCE == 4u && left >= 4; left = (SmRollSize)(left - 4u), at += 32) {
        a = sm_roll_extreme_of_f64(up, sm_roll_load_f64(at), sm_roll_load_f64(at + 8));
        b = sm_roll_extreme_of_f64(up, sm_roll_load_f64(at + 16), sm_roll_load_f64(at + 24));
        end = sm_roll_extreme_of_f64(up, end, sm_roll_extreme_of_f64(up, a, b));
    }
    for (; left > 0; left--, at += 8)
        end = sm_roll_extreme_of_f64(up, end, sm_roll_load_f64(at));
    return end;
}
// snippet of emitted C: sm_roll_compares_numbers
// Whether the smallest and largest of a window are found by comparing its samples as numbers.
SM_ROLL_INLINE bool sm_roll_compares_numbers(uint32_t n, uint32_t kind)
{
    const bool real = (kind & SM_ROLL_TYPE) == SM_ROLL_F32 || (kind & SM_ROLL_TYPE) == SM_ROLL_F64;
    return SM_ROLL_BY_VALUE && real && !sm_roll_stores_order(kind) && sm_roll_partials(n, kind) < 4;
}
// snippet of emitted C: sm_roll_extreme_number
// The smallest sample, or the largest if `up`, by comparing numbers.  If that is 0, its sign can be wrong.
SM_ROLL_INLINE SmF64 sm_roll_extreme_number(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count, bool up)
{
    const unsigned char *const at = (const unsigned char *)(w + sm_roll_slots_at(n, kind));
    return (kind & SM_ROLL_TYPE) == SM_ROLL_F32 ? sm_from_f32(sm_roll_extreme_f32(at, n, count, up)) : sm_roll_extreme_f64(at, count, up);
}
// snippet of emitted C: sm_roll_extreme_zero
// Returns the smallest sample, or the largest if `up`, where it is a zero: the smallest is -0 if any sample is -0, the largest 0 if any is 0.
SM_ROLL_INLINE_FOR_SPEED SmF64 sm_roll_extreme_zero(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count, bool up)
{
    const SmRollKey minus = (kind & SM_ROLL_TYPE) == SM_ROLL_F32 ? (SmRollKey)INT32_MIN : (SmRollKey)INT64_MIN, sought = up ? 0 : minus;
    SmRollSize i = 0;
    while (i < count && sm_roll_slot_key(w, n, kind, i) != sought)
        i++;
    return sm_from_bits(up == (i < count) ? 0 : 0x8000000000000000u);
}
// snippet of emitted C: sm_roll_extreme_key
// The smallest key of all, or the largest if `up`.
SM_ROLL_INLINE SmRollKey sm_roll_extreme_key(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count, bool up)
{
    const unsigned char *at = (const unsigned char *)(w + sm_roll_slots_at(n, kind));
    const size_t one = (size_t)1 << sm_roll_shift(kind);
    SmRollKey end = sm_roll_load(at, 0, kind), a, b;
    SmRollSize left;
    for (left = count; !SM_ROLL_SMALL && SM_ROLL_AT_ONCE == 4u && left >= 4; left = (SmRollSize)(left - 4u), at += 4 * one) {
        a = sm_roll_extreme_of_two(up, sm_roll_load(at, 0, kind), sm_roll_load(at, 1, kind));
        b = sm_roll_extreme_of_two(up, sm_roll_load(at, 2, kind), sm_roll_load(at, 3, kind));
        end = sm_roll_extreme_of_two(up, end, sm_roll_extreme_of_two(up, a, b));
    }
    for (; left > 0; left--, at += one)
        end = sm_roll_extreme_of_two(up, end, sm_roll_load(at, 0, kind));
    return end;
}
// snippet of emitted C: sm_roll_rank_of_three
// The key of a rank in a window of three slots, of which `count` are used.
SM_ROLL_INLINE SmRollKey sm_roll_rank_of_three(const uint64_t *w, uint32_t kind, SmRollSize count, SmRollSize rank)
{
    const SmRollKey a = sm_roll_order_of_key(kind, sm_roll_slot_key(w, 3, kind, 0)), b = sm_roll_order_of_key(kind, sm_roll_slot_key(w, 3, kind, 1));
    const SmRollKey c = sm_roll_order_of_key(kind, sm_roll_slot_key(w, 3, kind, 2)), lo = a < b ? a : b, hi = a < b ? b : a, mid = hi < c ? hi : c;
    if (count == 1)
        return sm_roll_order_of_key(kind, a);
    if (count == 2)
        return sm_roll_order_of_key(kind, rank == 0 ? lo : hi);
    return sm_roll_order_of_key(kind, rank == 1 ? (lo < mid ? mid : lo) : rank == 0 ? (lo < c ? lo : c) : (hi < c ? c : hi));
}
// snippet of emitted C: sm_roll_middle_f32
// The median of three numbers.  If that is 0, its sign can be wrong.
SM_ROLL_INLINE float sm_roll_middle_f32(const unsigned char *at)
{
    const float a = sm_roll_load_f32(at), b = sm_roll_load_f32(at + 4), c = sm_roll_load_f32(at + 8);
    const float lo = sm_roll_extreme_of_f32(false, a, b), hi = sm_roll_extreme_of_f32(true, a, b);
    return sm_roll_extreme_of_f32(true, lo, sm_roll_extreme_of_f32(false, hi, c));
}
// snippet of emitted C: sm_roll_middle_f64
// As sm_roll_middle_f32, for numbers of type F64.
SM_ROLL_INLINE SmF64 sm_roll_middle_f64(const unsigned char *at)
{
    const SmF64 a = sm_roll_load_f64(at), b = sm_roll_load_f64(at + 8), c = sm_roll_load_f64(at + 16);
    const SmF64 lo = sm_roll_extreme_of_f64(false, a, b), hi = sm_roll_extreme_of_f64(true, a, b);
    return sm_roll_extreme_of_f64(true, lo, sm_roll_extreme_of_f64(false, hi, c));
}
// snippet of emitted C: sm_roll_middle_number
// The median of a full window of three slots, by comparing numbers.  If that is 0, at least two of the three have its sign.
SM_ROLL_INLINE SmF64 sm_roll_middle_number(const uint64_t *w, uint32_t kind)
{
    const unsigned char *const at = (const unsigned char *)(w + sm_roll_slots_at(3, kind));
    const SmF64 x = (kind & SM_ROLL_TYPE) == SM_ROLL_F32 ? sm_from_f32(sm_roll_middle_f32(at)) : sm_roll_middle_f64(at);
    SmRollKey a, b, c;
    if ((kind & SM_ROLL_ANY_ZERO) != 0 || !sm_eq(x, sm_from_bits(0)))
        return x;
    a = sm_roll_slot_key(w, 3, kind, 0);
    b = sm_roll_slot_key(w, 3, kind, 1);
    c = sm_roll_slot_key(w, 3, kind, 2);
    return sm_from_bits(((a & b) | (a & c) | (b & c)) < 0 ? 0x8000000000000000u : 0);
}
// snippet of emitted C: sm_roll_key_of_rank
// The key of the sample that has this rank in ascending order.
SM_ROLL_INLINE SmRollKey sm_roll_key_of_rank(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count, SmRollSize rank)
{
    const unsigned char *const sorted = (const unsigned char *)(w + sm_roll_slots_at(n, kind)) + sm_roll_row_bytes(n, kind);
    if (!sm_roll_is_ordered(n))
        return sm_roll_rank_of_three(w, kind, count, rank);
    return sm_roll_load(sorted, sm_roll_index_of_rank(sorted, n, kind, rank), kind);
}
// snippet of emitted C: sm_roll_value_of_rank
// The value of the ordered sample of a rank.
SM_ROLL_INLINE SmF64 sm_roll_value_of_rank(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count, SmRollSize rank)
{
    return sm_roll_value(kind, sm_roll_key_of_rank(w, n, kind, count, rank));
}
// snippet of emitted C: sm_roll_whole_median
// The median of integers of at most 16 bits, without its fraction.
SM_ROLL_INLINE_FOR_SPEED int32_t sm_roll_whole_median(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count)
{
    int32_t a;
    if (count == 0)
        return 0;
    a = (int32_t)sm_roll_key_of_rank(w, n, kind, count, (SmRollSize)((count - 1u) / 2u));
    return count % 2 != 0 ? a : (a + (int32_t)sm_roll_key_of_rank(w, n, kind, count, (SmRollSize)(count / 2u))) / 2;
}
// snippet of emitted C: sm_roll_mean_of_two
// The mean of a <= b, the two samples in the middle.
SM_ROLL_OUTLINE SmF64 sm_roll_mean_of_two(SmF64 a, SmF64 b)
{
    SmF64 d;
    if (sm_eq(a, b))
        return a;
    d = sm_sub(b, a);
    if (!sm_lt(d, sm_from_bits(0x7FF0000000000000u)))   // too far apart: the difference is infinite
        return sm_add(sm_div(a, sm_from_i32(2)), sm_div(b, sm_from_i32(2)));
    return sm_add(a, sm_div(d, sm_from_i32(2)));
}
// snippet of emitted C: sm_roll_median
SM_ROLL_INLINE_FOR_SPEED SmF64 sm_roll_median(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count)
{
    SmF64 a;
    if (count == 0)
        return sm_from_i32(0);
    a = sm_roll_value_of_rank(w, n, kind, count, (count - 1u) / 2u);
    return count % 2 != 0 ? a : sm_roll_mean_of_two(a, sm_roll_value_of_rank(w, n, kind, count, count / 2u));
}
// snippet of emitted C: sm_roll_median_of_3
// The median of a window of three slots.  It is another function than sm_roll_median, because that is shared when optimizing for size.
SM_ROLL_INLINE_FOR_SPEED SmF64 sm_roll_median_of_3(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count)
{
    if (!SM_ROLL_LATE_ORDER)
        return sm_roll_median(w, n, kind, count);
    if (count >= 3)
        return sm_roll_compares_numbers(n, kind) ? sm_roll_middle_number(w, kind) : sm_roll_value_of_rank(w, n, kind, 3, 1);
    if (count == 2)
        return sm_roll_mean_of_two(sm_roll_value_of_rank(w, n, kind, 2, 0), sm_roll_value_of_rank(w, n, kind, 2, 1));
    return count == 0 ? sm_from_i32(0) : sm_roll_value_of_rank(w, n, kind, 1, 0);
}
// snippet of emitted C: sm_roll_extreme
// The smallest sample, or the largest if `up`; -0 is below +0.
SM_ROLL_INLINE SmF64 sm_roll_extreme(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count, bool up)
{
    const unsigned partials = sm_roll_partials(n, kind);
    if (count == 0)
        return sm_from_i32(0);
    if ((kind & SM_ROLL_MEDIAN) != 0)
        return sm_roll_value_of_rank(w, n, kind, count, up ? count - 1u : 0);
    if (sm_roll_compares_numbers(n, kind)) {
        const SmF64 x = sm_roll_extreme_number(w, n, kind, count, up);
        return (kind & SM_ROLL_ANY_ZERO) == 0 && sm_eq(x, sm_from_bits(0)) ? sm_roll_extreme_zero(w, n, kind, count, up) : x;
    }
    if (partials < 4)
        return sm_roll_value(kind, sm_roll_extreme_key(w, n, kind, count, up));
    return sm_roll_value(kind, sm_roll_order_of_key(kind, (SmRollKey)(up ? ~w[sm_roll_partial_words(partials) - 1u] : w[sm_roll_partial_words(partials & 3u)])));
}
// snippet of emitted C: sm_roll_min
SM_ROLL_INLINE SmF64 sm_roll_min(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count) { return sm_roll_extreme(w, n, kind, count, false); }
// snippet of emitted C: sm_roll_max
SM_ROLL_INLINE SmF64 sm_roll_max(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count) { return sm_roll_extreme(w, n, kind, count, true); }
// snippet of emitted C: sm_roll_range
// The largest minus the smallest sample; 0 if they are equal, even if infinite.
SM_ROLL_INLINE_FOR_SPEED SmF64 sm_roll_range(const uint64_t *w, uint32_t n, uint32_t kind, SmRollSize count)
{
    SmF64 lo, hi;
    if (count != 0 && sm_roll_compares_numbers(n, kind)) {      // the sign of a zero among them does not change the result
        lo = sm_roll_extreme_number(w, n, kind, count, false);
        hi = sm_roll_extreme_number(w, n, kind, count, true);
    } else {
        lo = sm_roll_min(w, n, kind, count);
        hi = sm_roll_max(w, n, kind, count);
    }
    return sm_eq(lo, hi) ? sm_from_i32(0) : sm_sub(hi, lo);
}
// snippet of emitted C: sm_roll_oldest_slot
// The slot of the oldest sample; slot 0 of an empty window.
SM_ROLL_INLINE SmRollSize sm_roll_oldest_slot(const uint64_t *ring, uint32_t n) { return sm_roll_count(ring) < n ? 0 : sm_roll_next(ring); }
// snippet of emitted C: sm_roll_newest_slot
// The slot of the newest sample; slot n - 1 of an empty window.
SM_ROLL_INLINE SmRollSize sm_roll_newest_slot(const uint64_t *ring, uint32_t n) { return (SmRollSize)((sm_roll_next(ring) != 0 ? sm_roll_next(ring) : n) - 1u); }
// snippet of emitted C: sm_roll_oldest
SM_ROLL_INLINE SmF64 sm_roll_oldest(const uint64_t *w, uint32_t n, uint32_t kind, const uint64_t *ring)
{
    return sm_roll_value(kind, sm_roll_slot_key(w, n, kind, sm_roll_oldest_slot(ring, n)));
}
// snippet of emitted C: sm_roll_newest
SM_ROLL_INLINE SmF64 sm_roll_newest(const uint64_t *w, uint32_t n, uint32_t kind, const uint64_t *ring)
{
    return sm_roll_value(kind, sm_roll_slot_key(w, n, kind, sm_roll_newest_slot(ring, n)));
}
// snippet of emitted C: sm_roll_change
SM_ROLL_INLINE SmF64 sm_roll_change(const uint64_t *w, uint32_t n, uint32_t kind, const uint64_t *ring)
{
    return sm_roll_count(ring) < 2 ? sm_from_i32(0) : sm_sub(sm_roll_newest(w, n, kind, ring), sm_roll_oldest(w, n, kind, ring));
}
// snippet of emitted C: sm_roll_push_time
// Adds a time to a window of n times, unless the event is 0.
SM_ROLL_INLINE void sm_roll_push_time(uint64_t *w, uint32_t n, uint64_t *ring, uint32_t event, uint64_t now)
{
    if (event != 0)
        w[sm_roll_advance(ring, n).slot] = now;
}
// snippet of emitted C: sm_roll_elapsed
SM_ROLL_INLINE SmF64 sm_roll_elapsed(const uint64_t *w, uint32_t n, const uint64_t *ring)
{
    return sm_roll_count(ring) == 0 ? sm_from_i32(0) : sm_from_u64(w[sm_roll_newest_slot(ring, n)] - w[sm_roll_oldest_slot(ring, n)]);
}
// snippet of emitted C: sm_roll_run_length
// The number of events of a run, at most its size; 0: it has ended.
SM_ROLL_INLINE uint32_t sm_roll_run_length(const uint64_t *ring) { uint32_t v; memcpy(&v, ring, 4); return v; }
// snippet of emitted C: sm_roll_run_steps
SM_ROLL_INLINE SmF64 sm_roll_run_steps(const uint64_t *ring) { return sm_from_u32(sm_roll_run_length(ring)); }
// snippet of emitted C: sm_roll_run_time
SM_ROLL_INLINE SmF64 sm_roll_run_time(const uint64_t *w, const uint64_t *ring)
{
    return sm_roll_run_length(ring) == 0 ? sm_from_i32(0) : sm_from_u64(w[1] - w[0]);
}
// snippet of emitted C: sm_roll_extend_run
// Adds an event to a run: 0 ends it, 1 extends it or begins one, 2 begins a new one.
SM_ROLL_INLINE void sm_roll_extend_run(uint64_t *w, uint32_t n, uint64_t *ring, uint32_t event, uint64_t now)
{
    const uint32_t length = event == 2 ? 0 : sm_roll_run_length(ring);       // not 0 where the event is 0: that jump is often predicted wrongly
    if (length == 0)
        w[0] = now;
    w[1] = now;
    sm_roll_set_count(ring, event == 0 ? 0 : length < n ? length + 1 : n);
}
// snippet of emitted C: end

#ifndef SM_ROLL_NONE
// 1: a VM without windows, for chips with too little memory: its verifier rejects images that have any.  Must be the same for all files
// that are compiled together.  Emitted C still supports windows.
#define SM_ROLL_NONE 0
#endif

// The kind of a window over samples of a type; stats has the bit 1u << SmStat for each statistic that will be read.
static inline uint32_t sm_roll_kind(SmType type, uint32_t stats)
{
    if ((stats & SM_STATS_OF_TIMES) != 0)
        return SM_ROLL_TIMES | stats << 4;
    return (type == SM_I64 || type == SM_U64 ? (uint32_t)SM_ROLL_F64 : (uint32_t)type) | stats << 4;
}

// Whether a kind is valid: statistics that exist, and a type that windows store (bits 0 to 2, 4 to 6 and 8 to 10 of 0x777).
static inline bool sm_roll_is_kind(uint32_t kind)
{
    const uint32_t stats = kind >> 4;
    if (SM_ROLL_NONE || stats >> SM_STAT_COUNT != 0)
        return false;
    if ((kind & SM_ROLL_TYPE) == SM_ROLL_TIMES)
        return stats == 1u << SM_STAT_ELAPSED || (stats != 0 && (stats & ~SM_STATS_OF_RUNS) == 0);
    return (stats & SM_STATS_OF_TIMES) == 0 && (0x777u >> (kind & SM_ROLL_TYPE) & 1u) != 0;
}

// The number of slots of a window: a run has two, whatever its size.
static inline uint32_t sm_roll_slots(uint32_t n, uint32_t kind) { return (kind & (SM_ROLL_RUN_STEPS | SM_ROLL_RUN_TIME)) != 0 ? 2 : n; }

// The number of words of memory that a window needs, and the ring that precedes it.  n is at most SM_WINDOW_MAX.
static inline uint32_t sm_roll_words(uint32_t n, uint32_t kind)
{
    const unsigned partials = sm_roll_node_partials(n, kind);
    uint32_t words = sm_roll_nodes_at(sm_roll_slots(n, kind), kind);
    if (partials == 0)
        return words + 1;
    words += (sm_roll_partial_words(partials) - 1) * sm_roll_tree_words(n);
    for (; n > 1; words += n)           // the last group is the whole window, whose result is not stored
        n = (n + 1) / 2;
    return words;
}

// The number of bytes of memory that a window needs.
static inline uint32_t sm_roll_bytes(uint32_t n, uint32_t kind)
{
    if (SM_ROLL_SMALL)
        return 8 + (sm_roll_row_bytes(sm_roll_slots(n, kind), kind) << ((kind & SM_ROLL_MEDIAN) != 0));
    return 8 * sm_roll_words(n, kind);
}

// Converts a number to a sample of the window's type, as a store does.
static inline int64_t sm_roll_convert(uint32_t kind, SmF64 x)
{
    const SmType type = (SmType)(kind & SM_ROLL_TYPE);
    unsigned char cell[8] = { 0 };
    sm_store(type, cell, x);
    return sm_roll_load(cell, 0, kind);
}

// Adds a sample to a window of any kind.
SM_ROLL_INLINE void sm_roll_add_sample(uint64_t *w, uint32_t n, uint32_t kind, int64_t sample)
{
    const SmRollAt at = sm_roll_advance(w++, n);
#ifndef __OPTIMIZE_SIZE__
    if ((kind & SM_ROLL_MEDIAN) != 0 && n <= SM_ROLL_SHORT)
        sm_roll_push_sorted(w, n, kind, at, sample);
    else
#endif
    {
        if ((kind & SM_ROLL_MEDIAN) != 0 && sm_roll_is_ordered(n))
            sm_roll_insert_sorted(w, n, kind, at, sm_roll_key(kind, sample));
        sm_roll_push(w, n, kind, at, sample);
    }
    if (sm_roll_node_partials(n, kind) != 0)
        sm_roll_combine(w, n, kind, at);
}

// Adds an event at the time `now` to a window of times: 0, 1, or 2 for any greater number.
static inline void sm_roll_sample_event(uint64_t *w, uint32_t n, uint32_t kind, uint64_t number, uint64_t now)
{
    const uint32_t event = number < 2 ? (uint32_t)number : 2;
    if ((kind & SM_ROLL_ELAPSED) != 0)
        sm_roll_push_time(w + 1, n, w, event, now);
    else
        sm_roll_extend_run(w + 1, n, w, event, now);
}

// Reads a statistic of a window of times.
static inline SmF64 sm_roll_stat_of_times(const uint64_t *w, uint32_t n, SmStat stat)
{
    return stat == SM_STAT_ELAPSED ? sm_roll_elapsed(w + 1, n, w) : stat == SM_STAT_RUN_STEPS ? sm_roll_run_steps(w) : sm_roll_run_time(w + 1, w);
}

// sm_roll_sample converts a number to the window's type, as a store does, and adds it as a sample.  sm_roll_sample_cell adds a sample that
// the cell contains in the window's type, and overwrites the cell.  sm_roll_stat reads one of the statistics that the window supports.
#if SM_ROLL_NONE
static inline void sm_roll_sample(uint64_t *w, uint32_t n, uint32_t kind, SmF64 x) { (void)w; (void)n; (void)kind; (void)x; }
static inline void sm_roll_sample_cell(uint64_t *w, uint32_t n, uint32_t kind, unsigned char *cell) { (void)w; (void)n; (void)kind; (void)cell; }

static inline SmF64 sm_roll_stat(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat)
{
    (void)w; (void)n; (void)kind; (void)stat;
    return sm_from_i32(0);
}
#elif SM_ROLL_SMALL
// Sets s to describe a window, for the functions of roll_small.h.
SM_ROLL_NOINLINE void sm_roll_small_init(SmRollSmall *s, const uint64_t *w, size_t n, uint16_t kind)
{
    s->type = (uint8_t)kind & SM_ROLL_TYPE;
    s->bytes = (uint8_t)(1u << sm_roll_shift(s->type));
    s->slot = (unsigned char *)(uintptr_t)(w + 1 + sm_roll_slots_at((uint32_t)n, kind));
    s->sorted = (kind & SM_ROLL_MEDIAN) == 0 ? NULL : s->slot + ((n * s->bytes + 7u) & ~(size_t)7);
    s->n = n;
    s->count = (size_t)sm_roll_count(w);
    s->next = (size_t)sm_roll_next(w);
}

// Adds a sample to a rolling window of values. `cell`: the sample's bytes, in the window's type.
static inline void sm_roll_sample_cell(uint64_t *w, uint32_t n, uint32_t kind, unsigned char *cell)
{
    SmRollSmall s;
    sm_roll_small_init(&s, w, (size_t)n, (uint16_t)kind);
    sm_roll_small_push(&s, cell);
    if (s.count < s.n)
        sm_roll_set_count(w, (uint32_t)(s.count + 1));
    sm_roll_set_next(w, (uint32_t)(s.next + 1 < s.n ? s.next + 1 : 0));
}

static inline void sm_roll_sample(uint64_t *w, uint32_t n, uint32_t kind, SmF64 x)
{
    unsigned char cell[8];
    sm_store((SmType)(kind & SM_ROLL_TYPE), cell, x);
    sm_roll_sample_cell(w, n, kind, cell);
}

static inline SmF64 sm_roll_stat(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat)
{
    SmF64 x[SM_ROLL_WAITING];
    SmRollSmall s;
    if ((kind & SM_ROLL_TYPE) == SM_ROLL_TIMES)
        return sm_roll_stat_of_times(w, n, stat);
    sm_roll_small_init(&s, w, (size_t)n, (uint16_t)kind);
    s.count += s.count == 0;                         // an empty window: its slots contain 0
    if (stat < SM_STAT_OLDEST) {
        sm_roll_small_stat(&s, stat, x);
        return x[0];
    }
    sm_roll_small_value(&s, x, sm_roll_small_at(&s, s.slot, sm_roll_newest_slot(w, n)));
    sm_roll_small_value(&s, x + 1, sm_roll_small_at(&s, s.slot, sm_roll_oldest_slot(w, n)));
    if (stat == SM_STAT_OLDEST)
        return x[1];
    if (stat == SM_STAT_CHANGE && s.count < 2)
        return sm_from_i32(0);
    if (stat == SM_STAT_CHANGE)
        sm_roll_calculate(x, '-', x + 1);
    return x[0];
}
#else
// Converts a number to the window's type, as a store does, and adds it as a sample.  Specialized for each type unless optimizing for size.
static inline void sm_roll_sample(uint64_t *w, uint32_t n, uint32_t kind, SmF64 x)
{
#ifdef __OPTIMIZE_SIZE__
    sm_roll_add_sample(w, n, kind, sm_roll_convert(kind, x));
#else
    const uint32_t stats = kind & ~(uint32_t)SM_ROLL_TYPE;
    switch (kind & SM_ROLL_TYPE) {
    case SM_ROLL_I8: sm_roll_add_sample(w, n, stats | SM_ROLL_I8, sm_to_i8(x)); break;
    case SM_ROLL_I16: sm_roll_add_sample(w, n, stats | SM_ROLL_I16, sm_to_i16(x)); break;
    case SM_ROLL_I32: sm_roll_add_sample(w, n, stats | SM_ROLL_I32, sm_to_i32(x)); break;
    case SM_ROLL_U16: sm_roll_add_sample(w, n, stats | SM_ROLL_U16, sm_to_u16(x)); break;
    case SM_ROLL_U32: sm_roll_add_sample(w, n, stats | SM_ROLL_U32, sm_to_u32(x)); break;
    case SM_ROLL_F32: sm_roll_add_sample(w, n, stats | SM_ROLL_F32, sm_roll_of_f32(sm_to_f32(x))); break;
    case SM_ROLL_F64: sm_roll_add_sample(w, n, stats | SM_ROLL_F64, sm_roll_of_f64(x)); break;
    default: sm_roll_add_sample(w, n, stats | SM_ROLL_U8, sm_roll_convert(kind, x)); break;
    }
#endif
}

// Reads one of the statistics that the window supports.
SM_ROLL_INLINE SmF64 sm_roll_read_stat(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat)
{
    const uint64_t *const ring = w++;
    const SmRollSize count = sm_roll_count(ring);
    switch (stat) {
    case SM_STAT_AVG: return sm_roll_avg(w, n, kind, count);
    case SM_STAT_MEDIAN: return SM_ROLL_LATE_ORDER && n == 3 ? sm_roll_median_of_3(w, n, kind, count) : sm_roll_median(w, n, kind, count);
    case SM_STAT_MIN: return sm_roll_min(w, n, kind, count);
    case SM_STAT_MAX: return sm_roll_max(w, n, kind, count);
    case SM_STAT_RANGE: return sm_roll_range(w, n, kind, count);
    case SM_STAT_OLDEST: return sm_roll_oldest(w, n, kind, ring);
    case SM_STAT_NEWEST: return sm_roll_newest(w, n, kind, ring);
    case SM_STAT_CHANGE: return sm_roll_change(w, n, kind, ring);
    case SM_STAT_ELAPSED: case SM_STAT_RUN_STEPS: case SM_STAT_RUN_TIME: break;
    case SM_STAT_COUNT: break;
    }
    return sm_from_i32(0);
}

// Reads one of the statistics that a window of any kind supports.  Specialized for each type unless optimizing for size.
static inline SmF64 sm_roll_stat(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat)
{
#ifdef __OPTIMIZE_SIZE__
    return (kind & SM_ROLL_TYPE) == SM_ROLL_TIMES ? sm_roll_stat_of_times(w, n, stat) : sm_roll_read_stat(w, n, kind, stat);
#else
    const uint32_t stats = kind & ~(uint32_t)SM_ROLL_TYPE;
    switch (kind & SM_ROLL_TYPE) {
    case SM_ROLL_TIMES: return sm_roll_stat_of_times(w, n, stat);
    case SM_ROLL_I8: return sm_roll_read_stat(w, n, stats | SM_ROLL_I8, stat);
    case SM_ROLL_I16: return sm_roll_read_stat(w, n, stats | SM_ROLL_I16, stat);
    case SM_ROLL_I32: return sm_roll_read_stat(w, n, stats | SM_ROLL_I32, stat);
    case SM_ROLL_U16: return sm_roll_read_stat(w, n, stats | SM_ROLL_U16, stat);
    case SM_ROLL_U32: return sm_roll_read_stat(w, n, stats | SM_ROLL_U32, stat);
    case SM_ROLL_F32: return sm_roll_read_stat(w, n, stats | SM_ROLL_F32, stat);
    case SM_ROLL_F64: return sm_roll_read_stat(w, n, stats | SM_ROLL_F64, stat);
    default: return sm_roll_read_stat(w, n, stats | SM_ROLL_U8, stat);
    }
#endif
}
#endif

#endif
