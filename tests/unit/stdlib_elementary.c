// SPDX-License-Identifier: Apache-2.0
// The elementary functions: the special values of C's Annex F, exact values, and the errors for a fixed sample whose results were computed with
// mpmath (tests/elementary/sample.py).
#include <math.h>

#include "stdlib/elementary.h"
#include "tests/test.h"

#define INF sm_from_bits(0x7FF0000000000000u)
#define NAN_ sm_from_bits(0x7FF8000000000000u)
#define PI sm_from_bits(0x400921FB54442D18u)
#define HALF_PI sm_from_bits(0x3FF921FB54442D18u)
#define TINY 5e-324
#define HUGE_ 1.7976931348623157e308

static bool same(SmF64 a, SmF64 b) { return (a != a && b != b) || sm_bits(a) == sm_bits(b); }

typedef struct One { SmF64 (*f)(SmF64 x); SmF64 x, y; } One;
typedef struct Two { SmF64 (*f)(SmF64 x, SmF64 y); SmF64 x, y, z; } Two;

static void test_one_argument(void)
{
    const One row[] = {
        { sm_exp, 0.0, 1 }, { sm_exp, -0.0, 1 }, { sm_exp, INF, INF }, { sm_exp, -INF, 0.0 }, { sm_exp, NAN_, NAN_ },
        { sm_exp, 709.782712893384, 1.7976931348622732e308 }, { sm_exp, 709.7827128933841, INF }, { sm_exp, HUGE_, INF },
        { sm_exp, -745.1332191019411, TINY }, { sm_exp, -745.1332191019412, 0.0 }, { sm_exp, -HUGE_, 0.0 }, { sm_exp, TINY, 1 },
        { sm_log, 1, 0.0 }, { sm_log, 0.0, -INF }, { sm_log, -0.0, -INF }, { sm_log, -1, NAN_ }, { sm_log, -INF, NAN_ },
        { sm_log, INF, INF }, { sm_log, NAN_, NAN_ }, { sm_log, -TINY, NAN_ }, { sm_log, TINY, -744.4400719213812 },
        { sm_log, HUGE_, 709.782712893384 },
        { sm_log10, 1, 0.0 }, { sm_log10, 0.0, -INF }, { sm_log10, -0.0, -INF }, { sm_log10, -1, NAN_ }, { sm_log10, -INF, NAN_ },
        { sm_log10, INF, INF }, { sm_log10, NAN_, NAN_ }, { sm_log10, TINY, -323.3062153431158 }, { sm_log10, 1e22, 22 },
        { sm_sin, 0.0, 0.0 }, { sm_sin, -0.0, -0.0 }, { sm_sin, INF, NAN_ }, { sm_sin, -INF, NAN_ }, { sm_sin, NAN_, NAN_ },
        { sm_sin, TINY, TINY }, { sm_sin, -TINY, -TINY }, { sm_sin, 1e22, -0.8522008497671888 },
        { sm_cos, 0.0, 1 }, { sm_cos, -0.0, 1 }, { sm_cos, INF, NAN_ }, { sm_cos, -INF, NAN_ }, { sm_cos, NAN_, NAN_ }, { sm_cos, TINY, 1 },
        { sm_tan, 0.0, 0.0 }, { sm_tan, -0.0, -0.0 }, { sm_tan, INF, NAN_ }, { sm_tan, -INF, NAN_ }, { sm_tan, NAN_, NAN_ }, { sm_tan, TINY, TINY },
        { sm_asin, 0.0, 0.0 }, { sm_asin, -0.0, -0.0 }, { sm_asin, 1, HALF_PI }, { sm_asin, -1, -HALF_PI }, { sm_asin, 1.0000000000000002, NAN_ },
        { sm_asin, -2, NAN_ }, { sm_asin, INF, NAN_ }, { sm_asin, NAN_, NAN_ }, { sm_asin, TINY, TINY },
        { sm_acos, 1, 0.0 }, { sm_acos, -1, PI }, { sm_acos, 0.0, HALF_PI }, { sm_acos, -0.0, HALF_PI }, { sm_acos, 1.0000000000000002, NAN_ },
        { sm_acos, -INF, NAN_ }, { sm_acos, NAN_, NAN_ }, { sm_acos, TINY, HALF_PI },
        { sm_atan, 0.0, 0.0 }, { sm_atan, -0.0, -0.0 }, { sm_atan, INF, HALF_PI }, { sm_atan, -INF, -HALF_PI }, { sm_atan, NAN_, NAN_ },
        { sm_atan, HUGE_, HALF_PI }, { sm_atan, -TINY, -TINY }, { sm_atan, 1, 0.7853981633974483 },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        if (!same(row[i].f(row[i].x), row[i].y)) {
            printf("row %u of one argument: %.17g\n", (unsigned)i, row[i].f(row[i].x));
            CHECK(false);
        }
    CHECK(sizeof row / sizeof *row > 60);
}

static void test_two_arguments(void)
{
    const Two row[] = {
        { sm_pow, 0.0, -1, INF }, { sm_pow, -0.0, -1, -INF }, { sm_pow, 0.0, -2, INF }, { sm_pow, -0.0, -2, INF }, { sm_pow, -0.0, -0.5, INF },
        { sm_pow, 0.0, -INF, INF }, { sm_pow, -0.0, -INF, INF }, { sm_pow, 0.0, 3, 0.0 }, { sm_pow, -0.0, 3, -0.0 }, { sm_pow, -0.0, 2, 0.0 },
        { sm_pow, -0.0, 0.5, 0.0 }, { sm_pow, 0.0, INF, 0.0 }, { sm_pow, -1, INF, 1 }, { sm_pow, -1, -INF, 1 }, { sm_pow, 1, NAN_, 1 },
        { sm_pow, 1, INF, 1 }, { sm_pow, NAN_, 0.0, 1 }, { sm_pow, NAN_, -0.0, 1 }, { sm_pow, INF, 0.0, 1 }, { sm_pow, -3, 0.5, NAN_ },
        { sm_pow, -TINY, 0.5, NAN_ }, { sm_pow, 0.5, -INF, INF }, { sm_pow, -0.5, -INF, INF }, { sm_pow, 2, -INF, 0.0 }, { sm_pow, -2, -INF, 0.0 },
        { sm_pow, 0.5, INF, 0.0 }, { sm_pow, -0.5, INF, 0.0 }, { sm_pow, 2, INF, INF }, { sm_pow, -2, INF, INF }, { sm_pow, -INF, -3, -0.0 },
        { sm_pow, -INF, -2, 0.0 }, { sm_pow, -INF, -0.5, 0.0 }, { sm_pow, -INF, 3, -INF }, { sm_pow, -INF, 2, INF }, { sm_pow, -INF, 0.5, INF },
        { sm_pow, INF, -1, 0.0 }, { sm_pow, INF, 1, INF }, { sm_pow, INF, INF, INF }, { sm_pow, -INF, INF, INF }, { sm_pow, -INF, -INF, 0.0 },
        { sm_pow, NAN_, 1, NAN_ }, { sm_pow, 2, NAN_, NAN_ }, { sm_pow, -1, NAN_, NAN_ }, { sm_pow, -2, 3, -8 }, { sm_pow, -2, -3, -0.125 },
        { sm_pow, -2, 1024, INF }, { sm_pow, -2, 1025, -INF }, { sm_pow, -2, -1075, -0.0 }, { sm_pow, 2, -1074, TINY }, { sm_pow, 2, 1023, 8.98846567431158e307 },
        { sm_pow, 10, 15, 1e15 }, { sm_pow, 3, 2, 9 }, { sm_pow, -1, 9007199254740993.0, 1 }, { sm_pow, -1, 9007199254740991.0, -1 },
        { sm_pow, HUGE_, HUGE_, INF }, { sm_pow, TINY, HUGE_, 0.0 }, { sm_pow, TINY, 1, TINY }, { sm_pow, HUGE_, 1, HUGE_ }, { sm_pow, 2, TINY, 1 },
        { sm_atan2, 0.0, 1, 0.0 }, { sm_atan2, -0.0, 1, -0.0 }, { sm_atan2, 0.0, 0.0, 0.0 }, { sm_atan2, -0.0, 0.0, -0.0 }, { sm_atan2, 0.0, -0.0, PI },
        { sm_atan2, -0.0, -0.0, -PI }, { sm_atan2, 0.0, -1, PI }, { sm_atan2, -0.0, -1, -PI }, { sm_atan2, 1, 0.0, HALF_PI }, { sm_atan2, -1, -0.0, -HALF_PI },
        { sm_atan2, 1, -INF, PI }, { sm_atan2, -1, -INF, -PI }, { sm_atan2, 1, INF, 0.0 }, { sm_atan2, -1, INF, -0.0 }, { sm_atan2, 0.0, INF, 0.0 },
        { sm_atan2, INF, 1, HALF_PI }, { sm_atan2, -INF, -1, -HALF_PI }, { sm_atan2, INF, -INF, 2.356194490192345 }, { sm_atan2, -INF, -INF, -2.356194490192345 },
        { sm_atan2, INF, INF, 0.7853981633974483 }, { sm_atan2, -INF, INF, -0.7853981633974483 }, { sm_atan2, NAN_, 1, NAN_ }, { sm_atan2, 1, NAN_, NAN_ },
        { sm_atan2, INF, NAN_, NAN_ }, { sm_atan2, NAN_, -INF, NAN_ }, { sm_atan2, TINY, HUGE_, 0.0 }, { sm_atan2, TINY, -HUGE_, PI }, { sm_atan2, HUGE_, TINY, HALF_PI },
        { sm_atan2, TINY, TINY, 0.7853981633974483 }, { sm_atan2, HUGE_, -HUGE_, 2.356194490192345 }, { sm_atan2, TINY, 1, TINY },
        { sm_hypot, 3, 4, 5 }, { sm_hypot, -3, 4, 5 }, { sm_hypot, 0.0, -0.0, 0.0 }, { sm_hypot, -0.0, -0.0, 0.0 }, { sm_hypot, INF, NAN_, INF },
        { sm_hypot, NAN_, -INF, INF }, { sm_hypot, NAN_, 1, NAN_ }, { sm_hypot, 1, NAN_, NAN_ }, { sm_hypot, -INF, 1, INF }, { sm_hypot, HUGE_, HUGE_, INF },
        { sm_hypot, HUGE_, 0.0, HUGE_ }, { sm_hypot, TINY, 0.0, TINY }, { sm_hypot, 3 * TINY, 4 * TINY, 5 * TINY }, { sm_hypot, 3e300, 4e300, 5e300 },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        if (!same(row[i].f(row[i].x, row[i].y), row[i].z)) {
            printf("row %u of two arguments: %.17g\n", (unsigned)i, row[i].f(row[i].x, row[i].y));
            CHECK(false);
        }
    CHECK(sizeof row / sizeof *row > 90);
}

// Powers of ten and of two that a binary64 represents.
static void test_exact(void)
{
    SmF64 power = 1;

    for (int i = 0; i <= 22; i++, power *= 10) {
        CHECK(same(sm_log10(power), i));
        CHECK(same(sm_pow(10, i), power));
    }
    for (int i = -1074; i <= 1023; i++)
        CHECK(same(sm_pow(2, i), ldexp(1, i)));
    for (int i = 1; i <= 1000; i++)
        CHECK(same(sm_pow(i, 2), (SmF64)i * i) && same(sm_pow((SmF64)i * i, 0.5), i) && same(sm_hypot(3 * i, -4 * i), 5 * i));
}

// sin and similar functions are odd; cos and hypot are even.
static void test_symmetry(void)
{
    for (SmF64 x = 1e-9; x < 1e200; x *= 1.7) {
        CHECK(same(sm_sin(-x), -sm_sin(x)) && same(sm_cos(-x), sm_cos(x)) && same(sm_tan(-x), -sm_tan(x)));
        CHECK(same(sm_atan(-x), -sm_atan(x)) && same(sm_hypot(-x, 1), sm_hypot(1, x)));
        CHECK(same(sm_atan2(x, 3), -sm_atan2(-x, 3)) && same(sm_asin(-1 / x), -sm_asin(1 / x)));
    }
}

// Returns the error of `got` in units of the last place of the exact result, hi + lo.
static double error_of(double got, double hi, double lo)
{
    int e;

    if (got == hi && lo == 0)
        return 0;
    frexp(hi, &e);
    return fabs((got - hi) - lo) / ldexp(1, (e < -1021 ? -1021 : e) - 53);
}

#define CALL_exp   sm_exp(x)
#define CALL_log   sm_log(x)
#define CALL_log10 sm_log10(x)
#define CALL_pow   sm_pow(x, y)
#define CALL_sin   sm_sin(x)
#define CALL_cos   sm_cos(x)
#define CALL_tan   sm_tan(x)
#define CALL_asin  sm_asin(x)
#define CALL_acos  sm_acos(x)
#define CALL_atan  sm_atan(x)
#define CALL_atan2 sm_atan2(x, y)
#define CALL_hypot sm_hypot(x, y)
typedef enum Function {
    FN_exp, FN_log, FN_log10, FN_pow, FN_sin, FN_cos, FN_tan, FN_asin, FN_acos, FN_atan, FN_atan2, FN_hypot, FUNCTIONS
} Function;
typedef struct Sample { Function f; uint64_t x, y, hi, lo; } Sample;
static const Sample sample[] = {
#define ROW(name, x, y, hi, lo) { FN_##name, x, y, hi, lo },
#include "tests/elementary/sample.def"
#undef ROW
};

static SmF64 call(Function f, SmF64 x, SmF64 y)
{
    switch (f) {
    case FN_exp: return CALL_exp;
    case FN_log: return CALL_log;
    case FN_log10: return CALL_log10;
    case FN_pow: return CALL_pow;
    case FN_sin: return CALL_sin;
    case FN_cos: return CALL_cos;
    case FN_tan: return CALL_tan;
    case FN_asin: return CALL_asin;
    case FN_acos: return CALL_acos;
    case FN_atan: return CALL_atan;
    case FN_atan2: return CALL_atan2;
    case FN_hypot: return CALL_hypot;
    case FUNCTIONS: break;
    }
    return 0;
}

static void test_sample(void)
{
    unsigned judged[FUNCTIONS] = {0};

    for (size_t i = 0; i < sizeof sample / sizeof *sample; i++) {
        const Sample *s = &sample[i];
        const SmF64 got = call(s->f, sm_from_bits(s->x), sm_from_bits(s->y));
        judged[s->f]++;
        if (!(error_of(got, sm_from_bits(s->hi), sm_from_bits(s->lo)) < 0.85)) {
            printf("row %u of the sample: %a\n", (unsigned)i, got);
            CHECK(false);
        }
    }
    for (int f = 0; f < FUNCTIONS; f++)
        CHECK(judged[f] >= 50);
}

int main(void)
{
    test_one_argument();
    test_two_arguments();
    test_exact();
    test_symmetry();
    test_sample();
    return test_end("stdlib_elementary");
}
