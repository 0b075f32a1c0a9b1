// SPDX-License-Identifier: Apache-2.0
// Measures the largest errors of the elementary functions against libquadmath, whose results have 113 bits.
//   precision N SEED      N random arguments for each function, beginning with every binade
// Fails if an error is 1 ulp or more, or a result is NaN, infinite or finite where it should not be.
#include <quadmath.h>
#include <stdio.h>
#include <stdlib.h>

#include "stdlib/elementary.h"
#include "tests/elementary/arguments.h"

static double call_stdlib(Function f, double x, double y)
{
    switch (f) {
#define FN(name, arguments, stdlib, reference) case FN_##name: return stdlib;
#include "tests/elementary/functions.def"
#undef FN
    case FUNCTIONS: break;
    }
    return 0;
}

static __float128 call_reference(Function f, double x, double y)
{
    const __float128 p = x, q = y;

    switch (f) {
#define FN(name, arguments, stdlib, reference) case FN_##name: return reference;
#include "tests/elementary/functions.def"
#undef FN
    case FUNCTIONS: break;
    }
    return 0;
}

// Returns the error in units of the last place (ulp) of the exact result; 100 if one is finite and the other is infinite or NaN.  Infinity is
// correct from half a unit above the largest number on, and for 1 unit below that its error is also below 1.
static double error_of(double got, __float128 exact)
{
    const __float128 largest = 0x1.fffffffffffffp1023Q, unit = 0x1p971Q;
    int e;

    if (isnan(got) || isnanq(exact))
        return isnan(got) && isnanq(exact) ? 0 : 100;
    if (isinf(got))
        return fabsq(exact) > largest && (got < 0) == (exact < 0) ? 0 : 100;
    if (isinfq(exact) || fabsq(exact) >= largest + unit)
        return 100;
    if (exact == 0)
        return got == 0 ? 0 : 100;
    frexpq(exact, &e);
    return (double)(fabsq((__float128)got - exact) / ldexpq(1, (e < -1021 ? -1021 : e) - 53));
}

typedef struct Worst { double error, x, y; unsigned long tried; } Worst;

static void judge(Worst *w, Function f, double x, double y)
{
    const double error = error_of(call_stdlib(f, x, y), call_reference(f, x, y));

    w->tried++;
    if (error > w->error) {
        w->error = error;
        w->x = x;
        w->y = y;
    }
}

// Tests eight arguments of every binade and of either sign; for two arguments, each binade with 64 others.
static void judge_binades(Worst *w, Function f, int arguments, uint64_t *state)
{
    for (unsigned sign_exponent = 0; sign_exponent < 4096; sign_exponent++) {
        const double x = of_bits((uint64_t)sign_exponent << 52 | next_u64(state) >> 12);
        if (!(fabs(x) <= 1.7976931348623157e308))
            continue;
        for (int i = 0; i < (arguments == 1 ? 8 : 64); i++)
            judge(w, f, of_bits((uint64_t)sign_exponent << 52 | next_u64(state) >> 12), arguments == 1 ? 0 : random_finite(state));
    }
}

int main(int argc, char **argv)
{
    static const char *const name[] = {
#define FN(name, arguments, stdlib, reference) #name,
#include "tests/elementary/functions.def"
#undef FN
    };
    static const int arguments[] = {
#define FN(name, arguments, stdlib, reference) arguments,
#include "tests/elementary/functions.def"
#undef FN
    };
    const unsigned long n = argc > 1 ? strtoul(argv[1], NULL, 10) : 20000;
    uint64_t state = argc > 2 ? strtoul(argv[2], NULL, 10) : 1;
    int passed = 0, failed = 0;

    for (int f = 0; f < FUNCTIONS; f++) {
        Worst w = {0, 0, 0, 0};
        double x, y;
        judge_binades(&w, (Function)f, arguments[f], &state);
        for (unsigned long i = 0; i < n; i++) {
            pick_arguments((Function)f, &state, (unsigned)i, &x, &y);
            judge(&w, (Function)f, x, y);
        }
        printf("%-6s %.4f ulp of %lu, at %a", name[f], w.error, w.tried, w.x);
        printf(arguments[f] == 2 ? ", %a\n" : "\n", w.y);
        passed += w.error < 1 && w.error > 0.4;
        failed += !(w.error < 1 && w.error > 0.4);
    }
    printf("precision: %d passed, %d failed\n", passed, failed);
    return failed != 0 || passed != FUNCTIONS;
}
