// SPDX-License-Identifier: Apache-2.0
// Rolling windows (language.md 7) over memory that the caller owns.  Sample k sits in slot k mod n; a statistic is a function
// of what the slots hold and nothing else, so what has left the window leaves no trace.
//
//     SmRoll r;
//     sm_roll_init(&r, memory, n, 1u << SM_STAT_AVG | 1u << SM_STAT_MEDIAN);   // memory: sm_roll_bytes(n, the same) bytes
//     sm_roll_push(&r, x);                                                     // once a step
//     y = sm_roll_stat(&r, SM_STAT_MEDIAN);
//
// A push costs O(1), with a median O(n) moves; average, and without a median minimum and maximum, cost O(n) when asked.
// An empty window gives 0.
#ifndef SM_ROLL_H
#define SM_ROLL_H

#include <stddef.h>

#include "stdlib/f64.h"
#include "stdlib/math.h"
#include "stdlib/types.h"

//: SmRoll
#ifndef SM_ROLL_TYPE
#define SM_ROLL_TYPE
// A rolling window over the last n samples.
typedef struct SmRoll {
    SmF64 *slot;              // sample k is in slot k mod n
    SmF64 *sorted;            // the same samples in order, or NULL; kept where a median is asked for
    uint32_t n, count, next;  // slots, slots filled, slot of the next sample
} SmRoll;
#endif
//: sm_roll_begin
// An empty window of 1 <= n <= 100000 slots; sorted is NULL or has n as well.
static inline void sm_roll_begin(SmRoll *r, SmF64 *slot, SmF64 *sorted, uint32_t n)
{
    r->slot = slot;
    r->sorted = sorted;
    r->n = n;
    r->count = 0;
    r->next = 0;
}
//: sm_roll_put
// Takes a sample into a window without `sorted`; NaN enters as 0.
static inline void sm_roll_put(SmRoll *r, SmF64 x)
{
    r->slot[r->next] = sm_is_nan(x) ? sm_from_i32(0) : x;
    r->next = r->next + 1 < r->n ? r->next + 1 : 0;
    if (r->count < r->n)
        r->count++;
}
//: sm_roll_place
// How many of the sorted samples come before x; -0 comes before +0.
static inline uint32_t sm_roll_place(const SmRoll *r, SmF64 x)
{
    uint32_t lo = 0, hi = r->count;
    while (lo < hi) {
        const uint32_t mid = lo + (hi - lo) / 2;
        const SmF64 y = r->sorted[mid];
        if (sm_lt(y, x) || (sm_eq(y, x) && sm_bits(y) > sm_bits(x)))
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo;
}
//: sm_roll_put_sorted
// Takes a sample into a window with `sorted`; NaN enters as 0.
static inline void sm_roll_put_sorted(SmRoll *r, SmF64 x)
{
    const SmF64 y = sm_is_nan(x) ? sm_from_i32(0) : x;
    const uint32_t from = r->count < r->n ? r->count : sm_roll_place(r, r->slot[r->next]);   // the place that becomes free
    uint32_t to = sm_roll_place(r, y);
    if (from < to) {
        to--;
        memmove(r->sorted + from, r->sorted + from + 1, (size_t)(to - from) * sizeof *r->sorted);
    } else {
        memmove(r->sorted + to + 1, r->sorted + to, (size_t)(from - to) * sizeof *r->sorted);
    }
    r->sorted[to] = y;
    sm_roll_put(r, y);
}
//: sm_roll_sum
// Slots are added in pairs, those sums in pairs, and so on: part[i] is the sum of 2^i slots that waits for its other half.
static inline SmF64 sm_roll_sum(const SmRoll *r)
{
    SmF64 part[17], sum = sm_from_i32(0);
    uint32_t i, left;
    unsigned level;
    for (i = 0; i < r->count; i++) {
        sum = r->slot[i];
        for (level = 0; (i >> level & 1u) != 0; level++)
            sum = sm_add(part[level], sum);
        part[level] = sum;
    }
    left = r->count & (r->count - 1);         // the last sum is complete; older ones wait for it
    for (level = 0; left >> level != 0; level++)
        if ((left >> level & 1u) != 0)
            sum = sm_add(part[level], sum);
    return sum;
}
//: sm_roll_avg
static inline SmF64 sm_roll_avg(const SmRoll *r)
{
    return r->count == 0 ? sm_from_i32(0) : sm_div(sm_roll_sum(r), sm_from_u32(r->count));
}
//: sm_roll_median
// Of a window with `sorted`.
static inline SmF64 sm_roll_median(const SmRoll *r)
{
    SmF64 a, b, d;
    if (r->count == 0 || r->sorted == NULL)
        return sm_from_i32(0);
    a = r->sorted[(r->count - 1) / 2];
    b = r->sorted[r->count / 2];
    if (sm_eq(a, b))
        return a;
    d = sm_sub(b, a);
    if (!sm_lt(d, sm_from_bits(0x7FF0000000000000u)))   // too far apart: infinite
        return sm_add(sm_div(a, sm_from_i32(2)), sm_div(b, sm_from_i32(2)));
    return sm_add(a, sm_div(d, sm_from_i32(2)));
}
//: sm_roll_min
// The smallest sample; -0 is below +0.
static inline SmF64 sm_roll_min(const SmRoll *r)
{
    SmF64 x;
    uint32_t i;
    if (r->count == 0)
        return sm_from_i32(0);
    if (r->sorted != NULL)
        return r->sorted[0];
    x = r->slot[0];
    for (i = 1; i < r->count; i++)
        x = sm_min(x, r->slot[i]);
    return x;
}
//: sm_roll_max
// The largest sample; +0 is above -0.
static inline SmF64 sm_roll_max(const SmRoll *r)
{
    SmF64 x;
    uint32_t i;
    if (r->count == 0)
        return sm_from_i32(0);
    if (r->sorted != NULL)
        return r->sorted[r->count - 1];
    x = r->slot[0];
    for (i = 1; i < r->count; i++)
        x = sm_max(x, r->slot[i]);
    return x;
}
//: sm_roll_range
// The largest less the smallest sample; 0 if they are equal, infinities too.
static inline SmF64 sm_roll_range(const SmRoll *r)
{
    const SmF64 lo = sm_roll_min(r), hi = sm_roll_max(r);
    return sm_eq(lo, hi) ? sm_from_i32(0) : sm_sub(hi, lo);
}
//: end

// How many bytes of memory, aligned for SmF64, a window of n slots needs; stats has the bit 1u << SmStat of each statistic
// that will be asked for.  n is at most SM_WINDOW_MAX.
static inline uint32_t sm_roll_bytes(uint32_t n, uint32_t stats)
{
    const uint32_t copies = (stats & 1u << SM_STAT_MEDIAN) != 0 ? 2 : 1;
    return n * copies * (uint32_t)sizeof(SmF64);
}

static inline void sm_roll_init(SmRoll *r, void *memory, uint32_t n, uint32_t stats)
{
    SmF64 *slot = (SmF64 *)memory;
    sm_roll_begin(r, slot, (stats & 1u << SM_STAT_MEDIAN) != 0 ? slot + n : NULL, n);
}

static inline void sm_roll_push(SmRoll *r, SmF64 x)
{
    if (r->sorted != NULL)
        sm_roll_put_sorted(r, x);
    else
        sm_roll_put(r, x);
}

// One of the statistics that the window was made for.
static inline SmF64 sm_roll_stat(const SmRoll *r, SmStat stat)
{
    switch (stat) {
    case SM_STAT_AVG: return sm_roll_avg(r);
    case SM_STAT_MEDIAN: return sm_roll_median(r);
    case SM_STAT_MIN: return sm_roll_min(r);
    case SM_STAT_MAX: return sm_roll_max(r);
    case SM_STAT_RANGE: return sm_roll_range(r);
    case SM_STAT_COUNT: break;
    }
    return sm_from_i32(0);
}

#endif
