// SPDX-License-Identifier: Apache-2.0
// Rolling windows (language.md 7) over memory that the caller owns.  Sample k sits in slot k mod n; a statistic is a function
// of what the slots hold and nothing else, so what has left the window leaves no trace.
//
//     uint32_t kind = sm_roll_kind(SM_F32, stats);      // the samples' type; a bit for each statistic that will be asked
//     uint64_t w[…];                                    // sm_roll_words(n, kind) of them, all zero: an empty window
//     sm_roll_sample(w, n, kind, x);                    // once a step
//     y = sm_roll_stat(w, n, kind, SM_STAT_MEDIAN);
//
// An empty window gives 0.  A sample comes as an int64_t: a whole number itself, of F32 and F64 the bits, from sm_roll_of_…, where NaN
// is 0 already.  Inside it is its key, in the order of the numbers, -0 below 0.  I64 and U64 are kept as F64.
//
// Emitted C calls the functions below sm_roll_sample, with n and kind as constants: sm_roll_push or one of its kind, then
// sm_roll_combine where there are parts; and sm_roll_avg and its like.
//
// What a sample costs, what asking does, and the memory beside the n slots.
//
//                                           a sample                             asking           memory
//     average of integers                   constant                             constant         a word
//     of F32, F64: n <= SM_ROLL_SHORT       constant                             n additions      none
//                  longer                   log2 n additions                     constant         n F64: sums of 2, 4, 8, … slots
//     smallest, largest: n <= SM_ROLL_SCAN  constant                             n comparisons    none
//                  longer                   log2 n comparisons                   constant         n words each, of 2, 4, 8, … slots
//     median:      n <= SM_ROLL_SHORT       n comparisons, no branch             constant         n samples, in order
//                  longer                   2 log2 n comparisons, moving 2 SM_   constant         n samples, in order, and
//                                           ROLL_BLOCK samples and 1 a block                      2 bytes a block
//
// With a median, smallest and largest come for nothing.  With SM_ROLL_SMALL a window has its slots and, for a median, the samples in
// order, no more: average, smallest and largest then look at all slots when asked, and a sample of a median moves up to n.
#ifndef SM_ROLL_H
#define SM_ROLL_H

#include <stddef.h>

#include "stdlib/convert.h"
#include "stdlib/f64.h"
#include "stdlib/roll_small.h"
#include "stdlib/types.h"

//: SmRoll
#ifndef SM_ROLL_SMALL
// 1: rolling windows take as little memory as they can, and more time.  The same for all that is compiled together.
#ifdef __AVR__
#define SM_ROLL_SMALL 1
#else
#define SM_ROLL_SMALL 0
#endif
#endif
//: SM_ROLL_INLINE
// Size and kind of a window are constants where it is used: made for it, these functions are short.
#if defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define SM_ROLL_INLINE static inline __attribute__((always_inline))
#else
#define SM_ROLL_INLINE static inline
#endif
// The kind of a window: in which type it keeps its samples, and which statistics it is made for.
enum {
    SM_ROLL_I8 = 0, SM_ROLL_I16 = 1, SM_ROLL_I32 = 2, SM_ROLL_U8 = 4, SM_ROLL_U16 = 5, SM_ROLL_U32 = 6,
    SM_ROLL_F32 = 8, SM_ROLL_F64 = 9, SM_ROLL_BOOL = 10, SM_ROLL_TYPE = 15,
    SM_ROLL_AVG = 16, SM_ROLL_MEDIAN = 32, SM_ROLL_MIN = 64, SM_ROLL_MAX = 128, SM_ROLL_RANGE = 256,
    SM_ROLL_ORDER = 480        // those that ask which is larger
};
// The longest window whose samples are added up when that is asked, and put in order by a pass over all; the longest of which all are
// looked at for the smallest and largest; how many samples in order make a block that moves at once.
#define SM_ROLL_SHORT 32u
#define SM_ROLL_SCAN 64u
#define SM_ROLL_BLOCK 2048u
#define SM_ROLL_LONG(n) (!SM_ROLL_SMALL && (n) > SM_ROLL_BLOCK)
//: end
#ifndef SM_ROLL_FLAT
#define SM_ROLL_FLAT        // here, where sizes are known when it runs
#endif
//: SM_ROLL_FLAT
// Before a loop over a short window: it is to be laid out flat.
#ifndef SM_ROLL_FLAT
#if defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__) && !defined(__clang__) && defined(__GNUC__) && __GNUC__ >= 8
#define SM_ROLL_FLAT _Pragma("GCC unroll 32")
#else
#define SM_ROLL_FLAT
#endif
#endif
//: SM_ROLL_AT_ONCE
// How many samples are added up or compared at once: 4, or 1 where code is to be small.
#ifdef __OPTIMIZE_SIZE__
#define SM_ROLL_AT_ONCE 1u
#else
#define SM_ROLL_AT_ONCE 4u
#endif
//: sm_roll_of_f32
// The bits of a sample; NaN counts as 0.
static inline int64_t sm_roll_of_f32(float x)
{
    int32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return x != x ? 0 : bits;
}
//: sm_roll_of_f64
// The bits of a sample; NaN counts as 0.
static inline int64_t sm_roll_of_f64(SmF64 x)
{
    int64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return sm_is_nan(x) ? 0 : bits;
}
//: sm_roll_turned
// The key of a sample, ordered as the numbers are, -0 below 0; of a key the sample.  Who is not asked for an order needs none.
SM_ROLL_INLINE int64_t sm_roll_turned(uint32_t kind, int64_t sample)
{
    if ((kind & SM_ROLL_TYPE) < SM_ROLL_F32 || sample >= 0 || (!SM_ROLL_SMALL && (kind & SM_ROLL_ORDER) == 0))
        return sample;
    return sample ^ ((kind & SM_ROLL_TYPE) == SM_ROLL_F32 ? 0x7FFFFFFF : 0x7FFFFFFFFFFFFFFF);
}
//: sm_roll_value
// The number of a key.
SM_ROLL_INLINE SmF64 sm_roll_value(uint32_t kind, int64_t key)
{
    const int64_t sample = sm_roll_turned(kind, key);
    const int32_t bits = (int32_t)sample;
    float f;
    if ((kind & SM_ROLL_TYPE) == SM_ROLL_F64)
        return sm_from_bits((uint64_t)sample);
    if ((kind & SM_ROLL_TYPE) != SM_ROLL_F32)
        return sm_from_i64(sample);
    memcpy(&f, &bits, sizeof f);
    return sm_from_f32(f);
}
//: sm_roll_shift
// A sample takes 1 << this bytes.
SM_ROLL_INLINE unsigned sm_roll_shift(uint32_t kind)
{
    const unsigned type = kind & SM_ROLL_TYPE;
    return type < 8 ? type & 3u : type == SM_ROLL_BOOL ? 0 : type - 6u;
}
//: sm_roll_get
// Key i of an array.
SM_ROLL_INLINE int64_t sm_roll_get(const unsigned char *a, uint32_t i, uint32_t kind)
{
    switch (kind & SM_ROLL_TYPE) {
    case SM_ROLL_I8: { int8_t v; memcpy(&v, a + i, 1); return v; }
    case SM_ROLL_I16: { int16_t v; memcpy(&v, a + (size_t)i * 2, 2); return v; }
    case SM_ROLL_I32: case SM_ROLL_F32: { int32_t v; memcpy(&v, a + (size_t)i * 4, 4); return v; }
    case SM_ROLL_U16: { uint16_t v; memcpy(&v, a + (size_t)i * 2, 2); return v; }
    case SM_ROLL_U32: { uint32_t v; memcpy(&v, a + (size_t)i * 4, 4); return v; }
    case SM_ROLL_F64: { int64_t v; memcpy(&v, a + (size_t)i * 8, 8); return v; }
    default: return a[i];
    }
}
//: sm_roll_put
SM_ROLL_INLINE void sm_roll_put(unsigned char *a, uint32_t i, uint32_t kind, int64_t key)
{
    switch (sm_roll_shift(kind)) {
    case 0: a[i] = (unsigned char)key; break;
    case 1: { const uint16_t v = (uint16_t)key; memcpy(a + (size_t)i * 2, &v, 2); break; }
    case 2: { const uint32_t v = (uint32_t)key; memcpy(a + (size_t)i * 4, &v, 4); break; }
    default: memcpy(a + (size_t)i * 8, &key, 8); break;
    }
}
//: sm_roll_keeps
// What a window keeps beside its samples: their sum as a whole number (1) or as an F64 (2), the smallest (4), the largest (8).
SM_ROLL_INLINE unsigned sm_roll_keeps(uint32_t n, uint32_t kind)
{
    const bool real = (kind & SM_ROLL_TYPE) == SM_ROLL_F32 || (kind & SM_ROLL_TYPE) == SM_ROLL_F64;
    const unsigned sum = (kind & SM_ROLL_AVG) == 0 ? 0 : !real ? 1u : n > SM_ROLL_SHORT ? 2u : 0;
    if (SM_ROLL_SMALL)
        return 0;
    if ((kind & SM_ROLL_MEDIAN) != 0 || n <= SM_ROLL_SCAN)
        return sum;
    return sum | ((kind & (SM_ROLL_MIN | SM_ROLL_RANGE)) != 0 ? 4u : 0) | ((kind & (SM_ROLL_MAX | SM_ROLL_RANGE)) != 0 ? 8u : 0);
}
//: sm_roll_size
// A word each.
SM_ROLL_INLINE unsigned sm_roll_size(unsigned keeps) { return ((keeps & 3u) != 0) + (keeps >> 2 & 1u) + (keeps >> 3); }
//: sm_roll_node_keeps
// What it keeps of 2, 4, 8, … slots.
SM_ROLL_INLINE unsigned sm_roll_node_keeps(uint32_t n, uint32_t kind) { return sm_roll_keeps(n, kind) & 14u; }
//: sm_roll_slots
// In which word the slots begin.  Before them: a word that counts the samples and names the next slot; what is kept of them all,
// in the order of sm_roll_keeps, of the largest the key's complement.  Behind them: the samples in order, for a median; what is kept
// of two, four, eight, … slots.
SM_ROLL_INLINE unsigned sm_roll_slots(uint32_t n, uint32_t kind) { return 1u + sm_roll_size(sm_roll_keeps(n, kind)); }
//: sm_roll_row
// Bytes of n samples in a row.
SM_ROLL_INLINE uint32_t sm_roll_row(uint32_t n, uint32_t kind) { return ((n << sm_roll_shift(kind)) + 7u) & ~(uint32_t)7; }
//: sm_roll_heads
// Bytes of the numbers that say where the blocks of ordered samples begin.
SM_ROLL_INLINE uint32_t sm_roll_heads(uint32_t n) { return SM_ROLL_LONG(n) ? (n / SM_ROLL_BLOCK * 2u + 9u) & ~(uint32_t)7 : 0; }
//: sm_roll_tree
// Words for what is kept of two, four, eight, … slots, all but the last: half of them, a quarter, …, each rounded up.
SM_ROLL_INLINE uint32_t sm_roll_tree(uint32_t n) { return n + 15; }
//: sm_roll_nodes
// In which word what is kept of two slots begins.
SM_ROLL_INLINE uint32_t sm_roll_nodes(uint32_t n, uint32_t kind)
{
    const uint32_t row = sm_roll_row(n, kind);
    return sm_roll_slots(n, kind) + ((kind & SM_ROLL_MEDIAN) == 0 ? row : 2 * row + sm_roll_heads(n)) / 8;
}
//: sm_roll_count
// How many samples there are.
SM_ROLL_INLINE uint32_t sm_roll_count(const uint64_t *w) { return (uint32_t)sm_roll_get((const unsigned char *)w, 0, SM_ROLL_U32); }
//: sm_roll_next
// The slot of the next sample.
SM_ROLL_INLINE uint32_t sm_roll_next(const uint64_t *w) { return (uint32_t)sm_roll_get((const unsigned char *)w, 1, SM_ROLL_U32); }
//: sm_roll_slot
// Slot i.
SM_ROLL_INLINE int64_t sm_roll_slot(const uint64_t *w, uint32_t n, uint32_t kind, uint32_t i)
{
    return sm_roll_get((const unsigned char *)(w + sm_roll_slots(n, kind)), i, kind);
}
//: sm_roll_oldest
// The key of the sample that leaves when the next one comes, if the window is full.
SM_ROLL_INLINE int64_t sm_roll_oldest(const uint64_t *w, uint32_t n, uint32_t kind) { return sm_roll_slot(w, n, kind, sm_roll_next(w)); }
//: sm_roll_enter
// A window of n slots takes a sample, by its key.
SM_ROLL_INLINE void sm_roll_enter(uint64_t *w, uint32_t n, uint32_t kind, int64_t key)
{
    const uint32_t next = sm_roll_next(w), count = sm_roll_count(w);
    if ((sm_roll_keeps(n, kind) & 1u) != 0)
        w[1] += (uint64_t)(key - sm_roll_oldest(w, n, kind));       // an empty slot holds 0
    sm_roll_put((unsigned char *)(w + sm_roll_slots(n, kind)), next, kind, key);
    sm_roll_put((unsigned char *)w, 1, SM_ROLL_U32, next + 1 < n ? next + 1 : 0);
    if (count < n)
        sm_roll_put((unsigned char *)w, 0, SM_ROLL_U32, count + 1);
}
//: sm_roll_push
// A window of n slots takes a sample.
SM_ROLL_INLINE void sm_roll_push(uint64_t *w, uint32_t n, uint32_t kind, int64_t sample)
{
    sm_roll_enter(w, n, kind, sm_roll_turned(kind, sample));
}
//: sm_roll_push_sorted
// The same for a short window that keeps its samples in order: one pass without a branch puts the new one in and takes the oldest out.
SM_ROLL_INLINE void sm_roll_push_sorted(uint64_t *w, uint32_t n, uint32_t kind, int64_t sample)
{
    unsigned char *const sorted = (unsigned char *)(w + sm_roll_slots(n, kind)) + sm_roll_row(n, kind);
    const int64_t old = sm_roll_oldest(w, n, kind);
    int64_t key = sm_roll_turned(kind, sample), a = sm_roll_get(sorted, 0, kind), next;
    uint32_t i = sm_roll_count(w);
    const bool full = i == n;
    sm_roll_enter(w, n, kind, key);
    if (full) {
        SM_ROLL_FLAT
        for (i = 0; i + 1 < n; i++) {
            next = sm_roll_get(sorted, i + 1, kind);
            a = a < old ? a : next;                      // number i of those that stay
            sm_roll_put(sorted, i, kind, key < a ? key : a);
            key = key < a ? a : key;
            a = next;
        }
    } else {
        for (; i > 0 && key < sm_roll_get(sorted, i - 1, kind); i--)
            sm_roll_put(sorted, i, kind, sm_roll_get(sorted, i - 1, kind));
    }
    sm_roll_put(sorted, i, kind, key);
}
//: sm_roll_place
// Where the ordered sample of a rank is.  A long row is a row of blocks, and each of them a ring that begins anywhere.
SM_ROLL_INLINE uint32_t sm_roll_place(const unsigned char *sorted, uint32_t n, uint32_t kind, uint32_t rank)
{
    const uint32_t first = rank & ~(SM_ROLL_BLOCK - 1), end = n - first < SM_ROLL_BLOCK ? n : first + SM_ROLL_BLOCK;
    if (!SM_ROLL_LONG(n))
        return rank;
    rank += (uint32_t)sm_roll_get(sorted + sm_roll_row(n, kind), first / SM_ROLL_BLOCK, SM_ROLL_U16);
    return rank < end ? rank : rank - end + first;
}
//: sm_roll_rank
// How many of the first `count` ordered samples are below key.
SM_ROLL_INLINE uint32_t sm_roll_rank(const unsigned char *sorted, uint32_t n, uint32_t kind, uint32_t count, int64_t key)
{
    uint32_t lo = 0, half;
    for (; count > 1; count -= half) {
        half = count / 2;
        lo += half & (0u - (uint32_t)(sm_roll_get(sorted, sm_roll_place(sorted, n, kind, lo + half - 1), kind) < key));
    }
    return lo + (count == 1 && sm_roll_get(sorted, sm_roll_place(sorted, n, kind, lo), kind) < key);
}
//: sm_roll_slide
// Moves ordered samples by one place so that the free one is no longer `from` but `to`.
SM_ROLL_INLINE void sm_roll_slide(unsigned char *sorted, uint32_t kind, uint32_t from, uint32_t to)
{
    const unsigned shift = sm_roll_shift(kind);
    unsigned char *const a = sorted + ((size_t)from << shift), *const b = sorted + ((size_t)to << shift);
    if (from <= to)
        memmove(a, a + ((size_t)1 << shift), (size_t)(b - a));
    else
        memmove(b + ((size_t)1 << shift), b, (size_t)(a - b));
}
//: sm_roll_turn
// The same for ranks of one block: its ring may have to be moved in two pieces.
SM_ROLL_INLINE void sm_roll_turn(unsigned char *sorted, uint32_t n, uint32_t kind, uint32_t from, uint32_t to)
{
    const uint32_t first = from & ~(SM_ROLL_BLOCK - 1), last = (n - first < SM_ROLL_BLOCK ? n : first + SM_ROLL_BLOCK) - 1;
    const bool up = from <= to;
    uint32_t a = sm_roll_place(sorted, n, kind, from);
    const uint32_t b = sm_roll_place(sorted, n, kind, to);
    if (SM_ROLL_LONG(n) && (a <= b) != up) {
        sm_roll_slide(sorted, kind, a, up ? last : first);
        a = up ? first : last;
        sm_roll_put(sorted, up ? last : first, kind, sm_roll_get(sorted, a, kind));
    }
    sm_roll_slide(sorted, kind, a, b);
}
//: sm_roll_move
// The same for any ranks: samples cross from block to block at their ends, and blocks between are only turned.
SM_ROLL_INLINE void sm_roll_move(unsigned char *sorted, uint32_t n, uint32_t kind, uint32_t from, uint32_t to)
{
    unsigned char *const heads = sorted + sm_roll_row(n, kind);
    const uint32_t mask = SM_ROLL_BLOCK - 1, step = from <= to ? 1u : UINT32_MAX;
    uint32_t end, head, out;
    while (SM_ROLL_LONG(n) && (from & ~mask) != (to & ~mask)) {
        end = step == 1 ? from | mask : from & ~mask;
        sm_roll_turn(sorted, n, kind, from, end);
        from = end + step;
        out = sm_roll_place(sorted, n, kind, from);
        sm_roll_put(sorted, sm_roll_place(sorted, n, kind, end), kind, sm_roll_get(sorted, out, kind));
        if ((from & ~mask) != (to & ~mask)) {
            head = (uint32_t)sm_roll_get(heads, from / SM_ROLL_BLOCK, SM_ROLL_U16);
            sm_roll_put(heads, from / SM_ROLL_BLOCK, SM_ROLL_U16, (head + step) & mask);
            from ^= mask;
        }
    }
    sm_roll_turn(sorted, n, kind, from, to);
}
//: sm_roll_sort_in
// A key is about to enter a longer one: finds its place and that of the oldest, and moves what is between.
SM_ROLL_INLINE void sm_roll_sort_in(uint64_t *w, uint32_t n, uint32_t kind, int64_t key)
{
    unsigned char *const sorted = (unsigned char *)(w + sm_roll_slots(n, kind)) + sm_roll_row(n, kind);
    const uint32_t count = sm_roll_count(w);
    const uint32_t from = count < n ? count : sm_roll_rank(sorted, n, kind, count, sm_roll_oldest(w, n, kind));
    uint32_t to = sm_roll_rank(sorted, n, kind, count, key);
    to -= from < to;                                 // without the old one
    sm_roll_move(sorted, n, kind, from, to);
    sm_roll_put(sorted, sm_roll_place(sorted, n, kind, to), kind, key);
}
//: sm_roll_push_blocks
// The same for a longer window that keeps its samples in order.
SM_ROLL_INLINE void sm_roll_push_blocks(uint64_t *w, uint32_t n, uint32_t kind, int64_t sample)
{
    sm_roll_sort_in(w, n, kind, sm_roll_turned(kind, sample));
    sm_roll_push(w, n, kind, sample);
}
//: sm_roll_sum_up
// The sum of all slots, of which sample i is new; `sum` is that of its pair.  Notes the sums of four, eight, … slots; an odd last one
// passes on as it is.
SM_ROLL_INLINE SmF64 sm_roll_sum_up(uint64_t *node, uint32_t n, uint32_t i, uint32_t count, SmF64 sum)
{
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
//: sm_roll_least_up
// The same for the least key.
SM_ROLL_INLINE int64_t sm_roll_least_up(uint64_t *node, uint32_t n, uint32_t i, uint32_t count, int64_t least)
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
//: sm_roll_combine
// After a sample has come: works out anew what is kept of the two, four, eight, … slots that it belongs to, and of all of them.
SM_ROLL_INLINE void sm_roll_combine(uint64_t *w, uint32_t n, uint32_t kind)
{
    const unsigned keeps = sm_roll_node_keeps(n, kind);
    const uint32_t next = sm_roll_next(w), i = (next == 0 ? n : next) - 1, count = sm_roll_count(w);
    const bool paired = (i ^ 1u) < count;
    const int64_t key = sm_roll_slot(w, n, kind, i), other = sm_roll_slot(w, n, kind, paired ? i ^ 1u : i);
    uint64_t *node = w + sm_roll_nodes(n, kind), *all = w + 1 + (sm_roll_keeps(n, kind) & 1u);
    SmF64 sum = sm_roll_value(kind, key);
    if ((keeps & 2u) != 0) {
        sum = paired ? sm_add(sum, sm_roll_value(kind, other)) : sum;
        *all++ = sm_bits(sm_roll_sum_up(node, n, i, count, sum));
        node += sm_roll_tree(n);
    }
    if ((keeps & 4u) != 0) {
        *all++ = (uint64_t)sm_roll_least_up(node, n, i, count, key < other ? key : other);
        node += sm_roll_tree(n);
    }
    if ((keeps & 8u) != 0)
        *all = (uint64_t)sm_roll_least_up(node, n, i, count, key > other ? ~key : ~other);
}
//: sm_roll_sum_of_some
// The sum of up to SM_ROLL_AT_ONCE slots, in pairs; at: the first of those that are left.
SM_ROLL_INLINE SmF64 sm_roll_sum_of_some(const unsigned char *at, uint32_t left, uint32_t kind)
{
    SmF64 sum = sm_roll_value(kind, sm_roll_get(at, 0, kind)), other;
    if (SM_ROLL_AT_ONCE == 1 || left == 1)
        return sum;
    sum = sm_add(sum, sm_roll_value(kind, sm_roll_get(at, 1, kind)));
    if (left == 2)
        return sum;
    other = sm_roll_value(kind, sm_roll_get(at, 2, kind));
    return sm_add(sum, left > 3 ? sm_add(other, sm_roll_value(kind, sm_roll_get(at, 3, kind))) : other);
}
//: sm_roll_sum
// Slots are added in pairs, those sums in pairs, and so on: what waits for its other half stands in a row.
SM_ROLL_INLINE SmF64 sm_roll_sum(const uint64_t *w, uint32_t n, uint32_t kind)
{
    const unsigned char *at = (const unsigned char *)(w + sm_roll_slots(n, kind));
    SmF64 part[18], *end = part;
    const uint32_t count = sm_roll_count(w);
    uint32_t i, whole;
    for (i = 0; i < count; i += SM_ROLL_AT_ONCE, at += (size_t)SM_ROLL_AT_ONCE << sm_roll_shift(kind)) {
        *end++ = sm_roll_sum_of_some(at, count - i, kind);
        for (whole = i / SM_ROLL_AT_ONCE; whole % 2 != 0; whole /= 2, end--)
            end[-2] = sm_add(end[-2], end[-1]);
    }
    for (; end != part + 1; end--)
        end[-2] = sm_add(end[-2], end[-1]);
    return part[0];
}
//: sm_roll_avg
SM_ROLL_INLINE SmF64 sm_roll_avg(const uint64_t *w, uint32_t n, uint32_t kind)
{
    const unsigned keeps = sm_roll_keeps(n, kind);
    const uint32_t count = sm_roll_count(w);
    SmF64 sum;
    if (count == 0)
        return sm_from_i32(0);
    if ((keeps & 3u) != 0)
        sum = (keeps & 1u) != 0 ? sm_from_i64((int64_t)w[1]) : sm_from_bits(w[1]);
    else
        sum = sm_roll_sum(w, n, kind);
    return sm_div(sum, sm_from_u32(count));
}
//: sm_roll_further
// The smaller one, or the larger.
SM_ROLL_INLINE int64_t sm_roll_further(bool up, int64_t a, int64_t b) { return (up ? a > b : a < b) ? a : b; }
//: sm_roll_end
// The least key of all, or the largest.
SM_ROLL_INLINE int64_t sm_roll_end(const uint64_t *w, uint32_t n, uint32_t kind, bool up)
{
    const unsigned char *at = (const unsigned char *)(w + sm_roll_slots(n, kind));
    const size_t one = (size_t)1 << sm_roll_shift(kind);
    int64_t end = sm_roll_get(at, 0, kind), a, b;
    uint32_t left;
    for (left = sm_roll_count(w); SM_ROLL_AT_ONCE == 4 && left >= 4; left -= 4, at += 4 * one) {
        a = sm_roll_further(up, sm_roll_get(at, 0, kind), sm_roll_get(at, 1, kind));
        b = sm_roll_further(up, sm_roll_get(at, 2, kind), sm_roll_get(at, 3, kind));
        end = sm_roll_further(up, end, sm_roll_further(up, a, b));
    }
    for (; left > 0; left--, at += one)
        end = sm_roll_further(up, end, sm_roll_get(at, 0, kind));
    return end;
}
//: sm_roll_ordered
// The ordered sample of a rank.
SM_ROLL_INLINE SmF64 sm_roll_ordered(const uint64_t *w, uint32_t n, uint32_t kind, uint32_t rank)
{
    const unsigned char *const sorted = (const unsigned char *)(w + sm_roll_slots(n, kind)) + sm_roll_row(n, kind);
    return sm_roll_value(kind, sm_roll_get(sorted, sm_roll_place(sorted, n, kind, rank), kind));
}
//: sm_roll_median
SM_ROLL_INLINE SmF64 sm_roll_median(const uint64_t *w, uint32_t n, uint32_t kind)
{
    const uint32_t count = sm_roll_count(w);
    SmF64 a, b, d;
    if (count == 0)
        return sm_from_i32(0);
    a = sm_roll_ordered(w, n, kind, (count - 1) / 2);
    if (count % 2 != 0)
        return a;
    b = sm_roll_ordered(w, n, kind, count / 2);
    if (sm_eq(a, b))
        return a;
    d = sm_sub(b, a);
    if (!sm_lt(d, sm_from_bits(0x7FF0000000000000u)))   // too far apart: infinite
        return sm_add(sm_div(a, sm_from_i32(2)), sm_div(b, sm_from_i32(2)));
    return sm_add(a, sm_div(d, sm_from_i32(2)));
}
//: sm_roll_extreme
// The smallest sample, or the largest; -0 is below +0.
SM_ROLL_INLINE SmF64 sm_roll_extreme(const uint64_t *w, uint32_t n, uint32_t kind, bool up)
{
    const unsigned keeps = sm_roll_keeps(n, kind);
    const uint32_t count = sm_roll_count(w);
    if (count == 0)
        return sm_from_i32(0);
    if ((kind & SM_ROLL_MEDIAN) != 0)
        return sm_roll_ordered(w, n, kind, up ? count - 1 : 0);
    if (keeps < 4)
        return sm_roll_value(kind, sm_roll_end(w, n, kind, up));
    return sm_roll_value(kind, up ? (int64_t)~w[sm_roll_size(keeps)] : (int64_t)w[1 + sm_roll_size(keeps & 3u)]);
}
//: sm_roll_min
SM_ROLL_INLINE SmF64 sm_roll_min(const uint64_t *w, uint32_t n, uint32_t kind) { return sm_roll_extreme(w, n, kind, false); }
//: sm_roll_max
SM_ROLL_INLINE SmF64 sm_roll_max(const uint64_t *w, uint32_t n, uint32_t kind) { return sm_roll_extreme(w, n, kind, true); }
//: sm_roll_range
// The largest less the smallest sample; 0 if they are equal, infinities too.
SM_ROLL_INLINE SmF64 sm_roll_range(const uint64_t *w, uint32_t n, uint32_t kind)
{
    const SmF64 lo = sm_roll_min(w, n, kind), hi = sm_roll_max(w, n, kind);
    return sm_eq(lo, hi) ? sm_from_i32(0) : sm_sub(hi, lo);
}
//: end

#ifndef SM_ROLL_NONE
// 1: a VM without windows, for chips that have no room for them: its verifier refuses images that have any.  The same for all that is
// compiled together.  Emitted C has windows all the same.
#define SM_ROLL_NONE 0
#endif

// The kind of a window over samples of a type; stats has the bit 1u << SmStat of each statistic that will be asked for.
static inline uint32_t sm_roll_kind(SmType type, uint32_t stats)
{
    return (type == SM_I64 || type == SM_U64 ? (uint32_t)SM_ROLL_F64 : (uint32_t)type) | stats << 4;
}

static inline bool sm_roll_is_kind(uint32_t kind)
{
    return !SM_ROLL_NONE && kind >> 4 >> SM_STAT_COUNT == 0 && (0x777u >> (kind & SM_ROLL_TYPE) & 1u) != 0;
}

// How many words of memory a window needs.  n is at most SM_WINDOW_MAX.
static inline uint32_t sm_roll_words(uint32_t n, uint32_t kind)
{
    const unsigned keeps = sm_roll_node_keeps(n, kind);
    uint32_t words = sm_roll_nodes(n, kind);
    if (keeps == 0)
        return words;
    words += (sm_roll_size(keeps) - 1) * sm_roll_tree(n);
    while ((n = (n + 1) / 2) > 1)
        words += n;
    return words;
}

// The same in bytes.
static inline uint32_t sm_roll_bytes(uint32_t n, uint32_t kind)
{
    if (SM_ROLL_SMALL)
        return 8 + (sm_roll_row(n, kind) << ((kind & SM_ROLL_MEDIAN) != 0));
    return 8 * sm_roll_words(n, kind);
}

// A sample that is converted to the window's type, as storing does.
static inline int64_t sm_roll_converted(uint32_t kind, SmF64 x)
{
    const SmType type = (SmType)(kind & SM_ROLL_TYPE);
    unsigned char cell[8] = { 0 };
    sm_store(type, cell, x);
    return sm_roll_get(cell, 0, kind);
}

// A window of any kind takes a sample.
SM_ROLL_INLINE void sm_roll_take(uint64_t *w, uint32_t n, uint32_t kind, int64_t sample)
{
#ifndef __OPTIMIZE_SIZE__
    if ((kind & SM_ROLL_MEDIAN) != 0 && n <= SM_ROLL_SHORT)
        sm_roll_push_sorted(w, n, kind, sample);
    else
#endif
    {
        if ((kind & SM_ROLL_MEDIAN) != 0)
            sm_roll_sort_in(w, n, kind, sm_roll_turned(kind, sample));
        sm_roll_push(w, n, kind, sample);
    }
    if (sm_roll_node_keeps(n, kind) != 0)
        sm_roll_combine(w, n, kind);
}

#if SM_ROLL_NONE
static inline void sm_roll_sample(uint64_t *w, uint32_t n, uint32_t kind, SmF64 x) { (void)w; (void)n; (void)kind; (void)x; }
static inline void sm_roll_sample_cell(uint64_t *w, uint32_t n, uint32_t kind, unsigned char *cell) { (void)w; (void)n; (void)kind; (void)cell; }

static inline SmF64 sm_roll_stat(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat)
{
    (void)w; (void)n; (void)kind; (void)stat;
    return sm_from_i32(0);
}
#elif SM_ROLL_SMALL
// A window as roll_small.h sees it.
SM_ROLL_APART void sm_roll_small(SmRollSmall *s, const uint64_t *w, size_t n, uint16_t kind)
{
    s->type = (uint8_t)kind & SM_ROLL_TYPE;
    s->bytes = (uint8_t)(1u << sm_roll_shift(s->type));
    s->slot = (unsigned char *)(uintptr_t)(w + sm_roll_slots((uint32_t)n, kind));
    s->sorted = (kind & SM_ROLL_MEDIAN) == 0 ? NULL : s->slot + ((n * s->bytes + 7u) & ~(size_t)7);
    s->n = n;
    s->count = (size_t)sm_roll_count(w);
    s->next = (size_t)sm_roll_next(w);
}

// A window takes a sample that is stored as its type already, in a cell that is used up by that.
static inline void sm_roll_sample_cell(uint64_t *w, uint32_t n, uint32_t kind, unsigned char *cell)
{
    SmRollSmall s;
    sm_roll_small(&s, w, (size_t)n, (uint16_t)kind);
    sm_roll_small_push(&s, cell);
    if (s.count < s.n)
        sm_roll_put((unsigned char *)w, 0, SM_ROLL_U32, (int64_t)(s.count + 1));
    sm_roll_put((unsigned char *)w, 1, SM_ROLL_U32, (int64_t)(s.next + 1 < s.n ? s.next + 1 : 0));
}

// A window takes a sample, which is converted to its type as storing does.
static inline void sm_roll_sample(uint64_t *w, uint32_t n, uint32_t kind, SmF64 x)
{
    unsigned char cell[8];
    sm_store((SmType)(kind & SM_ROLL_TYPE), cell, x);
    sm_roll_sample_cell(w, n, kind, cell);
}

// One of the statistics that a window was made for.
static inline SmF64 sm_roll_stat(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat)
{
    SmF64 x[SM_ROLL_WAITING];
    SmRollSmall s;
    sm_roll_small(&s, w, (size_t)n, (uint16_t)kind);
    s.count += s.count == 0;                         // its slots hold 0
    sm_roll_small_stat(&s, stat, x);
    return x[0];
}
#else
// A window takes a sample, which is converted to its type as storing does.  Where there is room, made for each type.
static inline void sm_roll_sample(uint64_t *w, uint32_t n, uint32_t kind, SmF64 x)
{
#ifdef __OPTIMIZE_SIZE__
    sm_roll_take(w, n, kind, sm_roll_converted(kind, x));
#else
    const uint32_t stats = kind & ~(uint32_t)SM_ROLL_TYPE;
    switch (kind & SM_ROLL_TYPE) {
    case SM_ROLL_I8: sm_roll_take(w, n, stats | SM_ROLL_I8, sm_to_i8(x)); break;
    case SM_ROLL_I16: sm_roll_take(w, n, stats | SM_ROLL_I16, sm_to_i16(x)); break;
    case SM_ROLL_I32: sm_roll_take(w, n, stats | SM_ROLL_I32, sm_to_i32(x)); break;
    case SM_ROLL_U16: sm_roll_take(w, n, stats | SM_ROLL_U16, sm_to_u16(x)); break;
    case SM_ROLL_U32: sm_roll_take(w, n, stats | SM_ROLL_U32, sm_to_u32(x)); break;
    case SM_ROLL_F32: sm_roll_take(w, n, stats | SM_ROLL_F32, sm_roll_of_f32(sm_to_f32(x))); break;
    case SM_ROLL_F64: sm_roll_take(w, n, stats | SM_ROLL_F64, sm_roll_of_f64(x)); break;
    default: sm_roll_take(w, n, stats | SM_ROLL_U8, sm_roll_converted(kind, x)); break;
    }
#endif
}

// One of the statistics that a window was made for.
SM_ROLL_INLINE SmF64 sm_roll_ask(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat)
{
    switch (stat) {
    case SM_STAT_AVG: return sm_roll_avg(w, n, kind);
    case SM_STAT_MEDIAN: return sm_roll_median(w, n, kind);
    case SM_STAT_MIN: return sm_roll_min(w, n, kind);
    case SM_STAT_MAX: return sm_roll_max(w, n, kind);
    case SM_STAT_RANGE: return sm_roll_range(w, n, kind);
    case SM_STAT_COUNT: break;
    }
    return sm_from_i32(0);
}

// The same of a window of any kind.  Where there is room, made for each type.
static inline SmF64 sm_roll_stat(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat)
{
#ifdef __OPTIMIZE_SIZE__
    return sm_roll_ask(w, n, kind, stat);
#else
    const uint32_t stats = kind & ~(uint32_t)SM_ROLL_TYPE;
    switch (kind & SM_ROLL_TYPE) {
    case SM_ROLL_I8: return sm_roll_ask(w, n, stats | SM_ROLL_I8, stat);
    case SM_ROLL_I16: return sm_roll_ask(w, n, stats | SM_ROLL_I16, stat);
    case SM_ROLL_I32: return sm_roll_ask(w, n, stats | SM_ROLL_I32, stat);
    case SM_ROLL_U16: return sm_roll_ask(w, n, stats | SM_ROLL_U16, stat);
    case SM_ROLL_U32: return sm_roll_ask(w, n, stats | SM_ROLL_U32, stat);
    case SM_ROLL_F32: return sm_roll_ask(w, n, stats | SM_ROLL_F32, stat);
    case SM_ROLL_F64: return sm_roll_ask(w, n, stats | SM_ROLL_F64, stat);
    default: return sm_roll_ask(w, n, stats | SM_ROLL_U8, stat);
    }
#endif
}
#endif

#endif
