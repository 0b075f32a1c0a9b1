// SPDX-License-Identifier: Apache-2.0
// The machines of this folder as an expert writes them for an ATmega328P, with the checks that the language requires: time advances, and a NaN
// is read as 0.
#ifndef BENCH_AVR_HAND_H
#define BENCH_AVR_HAND_H

#include <stdbool.h>
#include <stdint.h>

// The times of a machine.  `ran`: the current step is executed.  `first`: it is the first step in its state.
typedef struct HandTime { uint64_t last, start; bool ran, first; } HandTime;

static inline bool hand_time(HandTime *t, uint64_t time)
{
    if (time == UINT64_MAX || (t->ran && time <= t->last))
        return false;
    t->ran = true;
    t->last = time;
    if (t->first)
        t->start = time;
    return true;
}

// A window of SIZE samples, with a copy in ascending order.  A new sample replaces the oldest in the copy, and moves from there to its position.
#define HAND_SORTED(Name, name, Type, SIZE)                                                                    \
    typedef struct Name { Type sample[SIZE], sorted[SIZE]; uint8_t n, next; } Name;                            \
                                                                                                               \
    static void name##_put(Name *w, Type x)                                                                    \
    {                                                                                                          \
        Type *s = w->sorted, old = w->sample[w->next];                                                         \
        uint8_t i = 0;                                                                                         \
        if (w->n < SIZE)                                                                                       \
            i = w->n++;                                                                                        \
        else                                                                                                   \
            while (s[i] != old)                                                                                \
                i++;                                                                                           \
        for (; i > 0 && s[i - 1] > x; i--)                                                                     \
            s[i] = s[i - 1];                                                                                   \
        for (; i + 1 < w->n && s[i + 1] < x; i++)                                                              \
            s[i] = s[i + 1];                                                                                   \
        s[i] = x;                                                                                              \
        w->sample[w->next] = x;                                                                                \
        w->next = w->next + 1 < SIZE ? w->next + 1 : 0;                                                        \
    }

#endif
