// SPDX-License-Identifier: Apache-2.0
// Windows as an expert writes them for a fixed size.  They are rings, with statistics that do not branch on samples, so that noise costs no
// time.  Medians are sorting networks, from which the compiler removes what the middle does not need.  The first sample fills the whole ring, so
// that the minimum and the maximum always read all of it.  The average and the median of a ring that is not full are slow.
#ifndef BENCH_HAND_WINDOW_H
#define BENCH_HAND_WINDOW_H

#include <stdbool.h>
#include <string.h>

// HAND_RING: a ring Name of SIZE samples, and its average.  HAND_ENDS: its minimum and maximum.  HAND_MEDIAN_5: its median.
#define HAND_RING(Name, name, Type, SIZE)                                                                      \
    typedef struct Name { Type sample[SIZE]; unsigned n, next; } Name;                                         \
                                                                                                               \
    static inline void name##_put(Name *w, Type x)                                                             \
    {                                                                                                          \
        for (unsigned i = 0; w->n == 0 && i < SIZE; i++)                                                       \
            w->sample[i] = x;                                                                                  \
        w->sample[w->next] = x;                                                                                \
        w->next = w->next + 1 < SIZE ? w->next + 1 : 0;                                                        \
        w->n += w->n < SIZE;                                                                                   \
    }

// Four sums that do not depend on each other.
#define HAND_AVERAGE(Name, name, Type, SIZE)                                                                   \
    static inline Type name##_average(const Name *w)                                                           \
    {                                                                                                          \
        Type a = 0, b = 0, c = 0, d = 0;                                                                       \
        unsigned i = 0;                                                                                        \
        for (; i + 4 <= w->n; i += 4) {                                                                        \
            a += w->sample[i];                                                                                 \
            b += w->sample[i + 1];                                                                             \
            c += w->sample[i + 2];                                                                             \
            d += w->sample[i + 3];                                                                             \
        }                                                                                                      \
        for (; i < w->n; i++)                                                                                  \
            a += w->sample[i];                                                                                 \
        return (a + b + (c + d)) / (Type)w->n;                                                                 \
    }

#define HAND_LESS(x, y) ((x) < (y) ? (x) : (y))
#define HAND_MORE(x, y) ((x) > (y) ? (x) : (y))

// Four lanes, which the compiler can put into a vector.
#define HAND_END(Name, name, Type, SIZE, which, PICK)                                                          \
    static inline Type name##_##which(const Name *w)                                                           \
    {                                                                                                          \
        const Type *x = w->sample;                                                                             \
        Type lane[4] = {x[0], x[1], x[2], x[3]};                                                               \
        for (unsigned i = 4; i + 4 <= SIZE; i += 4)                                                            \
            for (unsigned k = 0; k < 4; k++)                                                                   \
                lane[k] = PICK(x[i + k], lane[k]);                                                             \
        for (unsigned i = SIZE / 4 * 4; i < SIZE; i++)                                                         \
            lane[i % 4] = PICK(x[i], lane[i % 4]);                                                             \
        lane[0] = PICK(lane[0], lane[1]);                                                                      \
        lane[2] = PICK(lane[2], lane[3]);                                                                      \
        return PICK(lane[0], lane[2]);                                                                         \
    }
#define HAND_ENDS(Name, name, Type, SIZE)                                                                      \
    HAND_END(Name, name, Type, SIZE, least, HAND_LESS)                                                         \
    HAND_END(Name, name, Type, SIZE, most, HAND_MORE)

#define HAND_MEDIAN(Name, name, Type, SIZE)                                                                    \
    static Type name##_early(const Name *w)                                                                    \
    {                                                                                                          \
        Type s[SIZE];                                                                                          \
        for (unsigned i = 0; i < w->n; i++) {                                                                  \
            unsigned k = i;                                                                                    \
            for (; k > 0 && s[k - 1] > w->sample[i]; k--)                                                      \
                s[k] = s[k - 1];                                                                               \
            s[k] = w->sample[i];                                                                               \
        }                                                                                                      \
        return (Type)((s[(w->n - 1) / 2] + s[w->n / 2]) / 2);                                                  \
    }                                                                                                          \
    static inline Type name##_median(const Name *w)                                                            \
    {                                                                                                          \
        Type s[SIZE], lo, hi;                                                                                  \
        if (w->n < SIZE)                                                                                       \
            return name##_early(w);                                                                            \
        memcpy(s, w->sample, sizeof s);                                                                        \
        HAND_SORT_##SIZE                                                                                       \
        return s[SIZE / 2];                                                                                    \
    }

#define HAND_SORT(a, b) lo = HAND_LESS(a, b); hi = HAND_MORE(a, b); a = lo; b = hi;
#define HAND_SORT_3                                                                                            \
    HAND_SORT(s[0], s[2]) HAND_SORT(s[0], s[1]) HAND_SORT(s[1], s[2])
#define HAND_SORT_5                                                                                            \
    HAND_SORT(s[0], s[3]) HAND_SORT(s[1], s[4]) HAND_SORT(s[0], s[2]) HAND_SORT(s[1], s[3])                    \
    HAND_SORT(s[0], s[1]) HAND_SORT(s[2], s[4]) HAND_SORT(s[1], s[2]) HAND_SORT(s[3], s[4])                    \
    HAND_SORT(s[2], s[3])
#define HAND_SORT_9                                                                                            \
    HAND_SORT(s[0], s[3]) HAND_SORT(s[1], s[7]) HAND_SORT(s[2], s[5]) HAND_SORT(s[4], s[8])                    \
    HAND_SORT(s[0], s[7]) HAND_SORT(s[2], s[4]) HAND_SORT(s[3], s[8]) HAND_SORT(s[5], s[6])                    \
    HAND_SORT(s[0], s[2]) HAND_SORT(s[1], s[3]) HAND_SORT(s[4], s[5]) HAND_SORT(s[7], s[8])                    \
    HAND_SORT(s[1], s[4]) HAND_SORT(s[3], s[6]) HAND_SORT(s[5], s[7]) HAND_SORT(s[0], s[1])                    \
    HAND_SORT(s[2], s[4]) HAND_SORT(s[3], s[5]) HAND_SORT(s[6], s[8]) HAND_SORT(s[2], s[3])                    \
    HAND_SORT(s[4], s[5]) HAND_SORT(s[6], s[7]) HAND_SORT(s[1], s[2]) HAND_SORT(s[3], s[4])                    \
    HAND_SORT(s[5], s[6])
#define HAND_SORT_11                                                                                           \
    HAND_SORT(s[0], s[9]) HAND_SORT(s[1], s[6]) HAND_SORT(s[2], s[4]) HAND_SORT(s[3], s[7])                    \
    HAND_SORT(s[5], s[8]) HAND_SORT(s[0], s[1]) HAND_SORT(s[3], s[5]) HAND_SORT(s[4], s[10])                   \
    HAND_SORT(s[6], s[9]) HAND_SORT(s[7], s[8]) HAND_SORT(s[1], s[3]) HAND_SORT(s[2], s[5])                    \
    HAND_SORT(s[4], s[7]) HAND_SORT(s[8], s[10]) HAND_SORT(s[0], s[4]) HAND_SORT(s[1], s[2])                   \
    HAND_SORT(s[3], s[7]) HAND_SORT(s[5], s[9]) HAND_SORT(s[6], s[8]) HAND_SORT(s[0], s[1])                    \
    HAND_SORT(s[2], s[6]) HAND_SORT(s[4], s[5]) HAND_SORT(s[7], s[8]) HAND_SORT(s[9], s[10])                   \
    HAND_SORT(s[2], s[4]) HAND_SORT(s[3], s[6]) HAND_SORT(s[5], s[7]) HAND_SORT(s[8], s[9])                    \
    HAND_SORT(s[1], s[2]) HAND_SORT(s[3], s[4]) HAND_SORT(s[5], s[6]) HAND_SORT(s[7], s[8])                    \
    HAND_SORT(s[2], s[3]) HAND_SORT(s[4], s[5]) HAND_SORT(s[6], s[7])

#endif
