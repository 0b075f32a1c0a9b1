// SPDX-License-Identifier: Apache-2.0
// The common part of the two campaigns of hostile bytes: a generator of random numbers, the bytes of a message, and the order of messages.  It
// was written from docs/config.md 11.16 alone.
#ifndef TESTS_NET_ORACLE_H
#define TESTS_NET_ORACLE_H

#include "runtime-c/net.h"

static uint64_t state;

static uint64_t next_random(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

static size_t below(size_t n) { return (size_t)(next_random() % n); }

static void put(uint8_t *at, uint64_t x, unsigned n)
{
    for (unsigned i = 0; i < n; i++)
        at[i] = (uint8_t)(x >> 8 * i);
}

static uint64_t get(const uint8_t *at, unsigned n)
{
    uint64_t x = 0;

    for (unsigned i = n; i-- > 0;)
        x = x << 8 | at[i];
    return x;
}

typedef struct Oracle {
    size_t size;
    uint32_t hash;
    bool sealed, any;
    uint32_t run, number;
    uint64_t seen, accepted_at;
    uint64_t limit;           // after this many nanoseconds without a message, the channel is silent
} Oracle;

static bool is_finite_f32(uint64_t bits) { return (bits & 0x7F800000u) != 0x7F800000u; }

static SmNetCount judge_order(Oracle *o, uint32_t run, uint32_t number, uint64_t now)
{
    const bool silent = now - o->accepted_at > o->limit;
    const int64_t ahead = (int32_t)(number - o->number);

    if (o->any && run == o->run && ahead <= 0)
        return ahead > -64 && (o->seen >> -ahead & 1) ? SM_NET_repeated : SM_NET_late;
    if ((!o->any && o->sealed && run < o->run) || (o->any && run != o->run && (o->sealed ? run < o->run : !silent)))
        return SM_NET_late;
    o->seen = o->any && run == o->run && ahead < 64 ? o->seen << ahead | 1 : 1;
    o->any = true;
    o->run = run;
    o->number = number;
    o->accepted_at = now;
    return SM_NET_accepted;
}

#endif
