// SPDX-License-Identifier: Apache-2.0
// Rolling windows of any type, in little code: sm_roll_sample and sm_roll_stat of roll.h use this if SM_ROLL_SMALL is set.  The same code
// serves all types, because it compares the keys of samples (roll.h) byte by byte.  Functions pass F64 values by pointer, because each
// call that passes two in registers costs an 8-bit computer fifty bytes of code.
#ifndef SM_ROLL_SMALL_H
#define SM_ROLL_SMALL_H

#include <stddef.h>

#include "stdlib/convert.h"

// For functions that must not be inlined when optimizing for size.
#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define SM_ROLL_NOINLINE __attribute__((noinline, unused)) static
#else
#define SM_ROLL_NOINLINE static inline
#endif

typedef struct SmRollSmall {
    unsigned char *slot, *sorted;      // sorted: the samples in order; NULL: no median is needed
    size_t n, count, next;             // number of slots, number of samples, slot of the next sample
    uint8_t type, bytes;               // SmType of a sample; bytes of a sample
} SmRollSmall;

// The index of byte i of a key, where i counts from the least significant byte.
static inline uint8_t sm_roll_byte(uint8_t i, uint8_t bytes)
{
    const uint16_t one = 1;
    unsigned char low;
    memcpy(&low, &one, 1);
    return low ? i : (uint8_t)(bytes - 1 - i);
}

static inline bool sm_roll_is_real(uint8_t type) { return type == SM_F32 || type == SM_F64; }
static inline bool sm_roll_is_signed(uint8_t type) { return type < SM_U8 || sm_roll_is_real(type); }

// Converts the bits of an F32 or F64 to a key, or a key to these bits: if the sign bit is set, flips all other bits.
SM_ROLL_NOINLINE void sm_roll_small_key(uint8_t type, uint8_t bytes, unsigned char *key)
{
    uint8_t i;
    if (!sm_roll_is_real(type) || key[sm_roll_byte((uint8_t)(bytes - 1), bytes)] < 0x80u)
        return;
    for (i = 0; i < bytes; i++)
        key[i] ^= 0xFFu;
    key[sm_roll_byte((uint8_t)(bytes - 1), bytes)] ^= 0x80u;
}

// The address of sample i in an array.
SM_ROLL_NOINLINE unsigned char *sm_roll_small_at(const SmRollSmall *s, unsigned char *row, size_t i) { return row + i * s->bytes; }

// Whether key a is below key b.
static inline bool sm_roll_is_below(const SmRollSmall *s, const unsigned char *a, const unsigned char *b)
{
    uint8_t i = s->bytes, at, sign = sm_roll_is_signed(s->type) ? 0x80u : 0;
    for (;;) {
        at = sm_roll_byte(--i, s->bytes);
        if (a[at] != b[at] || i == 0)
            return (a[at] ^ sign) < (b[at] ^ sign);
        sign = 0;
    }
}

// Adds an integer sample to a sum of eight bytes.
SM_ROLL_NOINLINE void sm_roll_add_integer(const SmRollSmall *s, unsigned char *sum, const unsigned char *key)
{
    const uint8_t bytes = s->bytes;
    uint8_t b, fill = 0;
    uint16_t digit = 0;
    unsigned char *to;
    for (b = 0; b < 8; b++) {
        if (b < bytes) {
            fill = key[sm_roll_byte(b, bytes)];
            digit = (uint16_t)(digit + fill);
        } else
            digit = (uint16_t)(digit + (fill >= 0x80u && s->type < SM_U8 ? 0xFFu : 0));
        to = &sum[sm_roll_byte(b, 8)];
        digit = (uint16_t)(digit + *to);
        *to = (unsigned char)digit;
        digit >>= 8;
    }
}

// Sets *x to the value of a key.
SM_ROLL_NOINLINE void sm_roll_small_value(const SmRollSmall *s, SmF64 *x, const unsigned char *key)
{
    uint64_t whole = 0;
    float f;
    if (!sm_roll_is_real(s->type)) {
        sm_roll_add_integer(s, (unsigned char *)&whole, key);
        *x = sm_from_i64((int64_t)whole);
        return;
    }
    memcpy(x, key, s->bytes);
    sm_roll_small_key(s->type, s->bytes, (unsigned char *)x);
    if (s->type == SM_F32) {
        memcpy(&f, x, sizeof f);
        *x = sm_from_f32(f);
    }
}

// ---- a sample ----

// Returns the address after the last ordered sample that is below key.
static inline unsigned char *sm_roll_find_position(const SmRollSmall *s, const unsigned char *key)
{
    unsigned char *at = s->sorted;
    size_t left = s->count, half;
    for (; left > 0; left = half) {
        half = left / 2;
        if (sm_roll_is_below(s, sm_roll_small_at(s, at, half), key)) {
            at = sm_roll_small_at(s, at, half + 1);
            half = left - half - 1;
        }
    }
    return at;
}

// Inserts a key among the ordered keys; if the window is full, removes the key of the oldest sample.
SM_ROLL_NOINLINE void sm_roll_small_insert(const SmRollSmall *s, const unsigned char *key)
{
    unsigned char *from = sm_roll_small_at(s, s->sorted, s->count), *to = sm_roll_find_position(s, key);
    if (s->count == s->n)
        from = sm_roll_find_position(s, sm_roll_small_at(s, s->slot, s->next));
    if (from < to) {
        to -= s->bytes;
        memmove(from, from + s->bytes, (size_t)(to - from));
    } else {
        memmove(to + s->bytes, to, (size_t)(from - to));
    }
    memcpy(to, key, s->bytes);
}

// Adds the sample whose bits in the window's type are at `key`; overwrites them with the sample's key.  The caller must update count and next.
SM_ROLL_NOINLINE void sm_roll_small_push(const SmRollSmall *s, unsigned char *key)
{
    sm_roll_small_key(s->type, s->bytes, key);
    if (s->sorted != NULL)
        sm_roll_small_insert(s, key);
    memcpy(sm_roll_small_at(s, s->slot, s->next), key, s->bytes);
}

// ---- statistics ----

// *x = *x op *y.
SM_ROLL_NOINLINE void sm_roll_calculate(SmF64 *x, char op, const SmF64 *y)
{
    const SmF64 a = *x, b = *y;
    *x = op == '+' ? sm_add(a, b) : op == '-' ? sm_sub(a, b) : op == '*' ? sm_mul(a, b) : sm_div(a, b);
}

// Sets x[0] to the average.  F32 and F64 samples are added in pairs, the sums in pairs again, and so on; x contains the sums that wait for
// their partner.  Integers are added to x[0] as one 64-bit integer, which has the same result: a sum of 100000 of them is exact as an F64.
SM_ROLL_NOINLINE void sm_roll_small_avg(const SmRollSmall *s, SmF64 *x)
{
    const bool real = sm_roll_is_real(s->type);
    const unsigned char *at = s->slot;
    SmF64 *end = x;
    size_t i, whole;
    if (!real)
        *end++ = sm_from_bits(0);
    for (i = 0; i < s->count; i++, at += s->bytes)
        if (real) {
            sm_roll_small_value(s, end++, at);
            for (whole = i; whole % 2 != 0; whole /= 2, end--)
                sm_roll_calculate(end - 2, '+', end - 1);
        } else
            sm_roll_add_integer(s, (unsigned char *)x, at);
    for (; end != x + 1; end--)
        sm_roll_calculate(end - 2, '+', end - 1);
    if (!real)
        *x = sm_from_i64((int64_t)sm_bits(*x));
    *end = sm_from_u32((uint32_t)s->count);
    sm_roll_calculate(x, '/', end);
}

// Sets *x to the value of the ordered sample of a rank.  If the window does not store its samples in order, `rank` must be the first or last.
SM_ROLL_NOINLINE void sm_roll_small_value_of_rank(const SmRollSmall *s, SmF64 *x, size_t rank)
{
    const unsigned char *at = s->slot, *best = at;
    size_t i;
    if (s->sorted != NULL)
        best = sm_roll_small_at(s, s->sorted, rank);
    else
        for (i = s->count; --i > 0;) {
            at += s->bytes;
            if (rank == 0 ? sm_roll_is_below(s, at, best) : sm_roll_is_below(s, best, at))
                best = at;
        }
    sm_roll_small_value(s, x, best);
}

static inline bool sm_roll_is_infinite(const SmF64 *x)       // whether *x, which must not be negative, is infinite
{
    const unsigned char *const byte = (const unsigned char *)x;
    return byte[sm_roll_byte(7, 8)] == 0x7Fu && byte[sm_roll_byte(6, 8)] >= 0xF0u;
}

// How many sums of 8 bytes sm_roll_small_avg may store on the stack: enough for windows of 2^(SM_ROLL_WAITING - 1) slots.  A window has
// fewer than 2^17.  A target whose memory has room for fewer F32 samples can define a smaller number.
#ifndef SM_ROLL_WAITING
#define SM_ROLL_WAITING 18
#endif

// Computes a statistic of a window with at least one sample, into x[0].  x has room for SM_ROLL_WAITING numbers.
SM_ROLL_NOINLINE void sm_roll_small_stat(const SmRollSmall *s, SmStat stat, SmF64 *x)
{
    const bool median = stat == SM_STAT_MEDIAN;
    const size_t last = s->count - 1, low = median ? last / 2 : stat == SM_STAT_MAX ? last : 0;
    const size_t high = median ? s->count / 2 : stat == SM_STAT_MIN ? 0 : last;
    SmF64 *const b = x + 1, *const half = x + 2;
    if (stat == SM_STAT_AVG) {
        sm_roll_small_avg(s, x);
        return;
    }
    sm_roll_small_value_of_rank(s, x, low);
    if (low == high && stat != SM_STAT_RANGE)
        return;
    sm_roll_small_value_of_rank(s, b, high);
    sm_roll_calculate(b, '-', x);
    if (!sm_to_bool(*b)) {                 // 0, or NaN: equal infinities
        if (!median)
            *x = sm_from_bits(0);
        return;
    }
    if (stat == SM_STAT_RANGE) {
        *x = *b;
        return;
    }
    *half = sm_from_bits(0x3FE0000000000000u);
    if (sm_roll_is_infinite(b)) {          // too far apart: the difference is infinite
        sm_roll_small_value_of_rank(s, b, high);
        sm_roll_calculate(x, '*', half);
    }
    sm_roll_calculate(b, '*', half);
    sm_roll_calculate(x, '+', b);
}

#endif
