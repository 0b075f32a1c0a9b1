// SPDX-License-Identifier: Apache-2.0
// Arguments of the elementary functions for tests: from every binade (the numbers from 2^n to 2^(n + 1)), and those with the largest errors.
#ifndef ELEMENTARY_ARGUMENTS_H
#define ELEMENTARY_ARGUMENTS_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

typedef enum Function {
#define FN(name, arguments, stdlib, reference) FN_##name,
#include "tests/elementary/functions.def"
#undef FN
    FUNCTIONS
} Function;

static inline double of_bits(uint64_t u) { double x; memcpy(&x, &u, sizeof x); return x; }

static inline uint64_t next_u64(uint64_t *state)
{
    uint64_t z = *state += 0x9E3779B97F4A7C15u;

    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}

static inline double random_in(uint64_t *state, double lo, double hi) { return lo + (hi - lo) * ((double)(next_u64(state) >> 11) * 0x1p-53); }
static inline double random_sign(uint64_t *state, double x) { return next_u64(state) & 1 ? -x : x; }

// Returns a number with a uniformly distributed logarithm, of either sign.
static inline double random_log(uint64_t *state, double lo, double hi) { return random_sign(state, exp2(random_in(state, lo, hi))); }

// Returns any finite number; all binades are equally likely.
static inline double random_finite(uint64_t *state)
{
    double x;

    do
        x = of_bits(next_u64(state));
    while (!(fabs(x) <= 1.7976931348623157e308));
    return x;
}

// Sets argument number i of function f.  Arguments outside its domain are replaced by valid ones.
static inline void pick_arguments(Function f, uint64_t *state, unsigned i, double *x, double *y)
{
    const unsigned kind = i % 4;

    *x = random_finite(state);
    *y = 0;
    switch (f) {
    case FN_exp:
        if (kind > 0)
            *x = kind == 1 ? random_in(state, -745.2, 709.8) : kind == 2 ? random_in(state, -1, 1) : random_log(state, -60, 9.5);
        break;
    case FN_log: case FN_log10:
        *x = fabs(*x);
        if (kind > 1)
            *x = kind == 2 ? random_in(state, 0.5, 2) : 1 + random_log(state, -52, -2);
        break;
    case FN_pow:
        *x = fabs(kind == 2 ? random_in(state, 0, 10) : kind == 3 ? 1 + random_log(state, -52, -1) : *x);
        *y = *x == 0 || *x == 1 || kind == 0 ? random_finite(state) : random_in(state, -746, 711) / log(*x) * (kind == 1 ? random_in(state, 0, 1) : 1);
        break;
    case FN_sin: case FN_cos: case FN_tan:
        if (kind > 0)
            *x = kind == 1 ? random_in(state, -10, 10) : kind == 2 ? rint(random_in(state, -1e6, 1e6)) * 1.5707963267948966
                 : random_log(state, -30, 60);
        break;
    case FN_asin: case FN_acos:
        *x = kind == 0 ? random_log(state, -1074, 0) : kind == 1 ? random_log(state, -30, 0)
             : kind == 2 ? random_sign(state, 1 - exp2(random_in(state, -53, -1))) : random_in(state, -1, 1);
        break;
    case FN_atan:
        if (kind > 0)
            *x = kind == 1 ? random_in(state, -4, 4) : random_log(state, -30, 66);
        break;
    case FN_atan2: case FN_hypot:
        *y = kind == 0 ? random_finite(state) : *x * random_log(state, kind == 1 ? -70 : -4, kind == 1 ? 70 : 4);
        if (kind == 3)
            *x = random_in(state, -1, 1), *y = random_in(state, -1, 1);
        break;
    case FUNCTIONS: break;
    }
}

#endif
