// SPDX-License-Identifier: Apache-2.0
// The pure builtins: special values as a table, a million random bit patterns against the C library, and the square root of
// exact squares and their neighbours.
#include <math.h>

#include "stdlib/math.h"
#include "tests/test.h"
#include "tests/unit/random.h"

#define INF sm_from_bits(0x7FF0000000000000u)
#define NAN_ sm_from_bits(0x7FF8000000000000u)

static bool same(SmF64 a, SmF64 b) { return (a != a && b != b) || sm_bits(a) == sm_bits(b); }

typedef struct Row { SmF64 x, floor, ceil, trunc, round, sqrt, sign; } Row;

static void test_one_argument(void)
{
    const Row row[] = {
        { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
        { -0.0, -0.0, -0.0, -0.0, -0.0, -0.0, -0.0 },
        { 0.5, 0, 1, 0, 1, 0.70710678118654757, 1 },
        { -0.5, -1, -0.0, -0.0, -1, NAN_, -1 },
        { 0.49999999999999994, 0, 1, 0, 0, 0.70710678118654746, 1 },
        { -0.3, -1, -0.0, -0.0, -0.0, NAN_, -1 },
        { 2.5, 2, 3, 2, 3, 1.5811388300841898, 1 },
        { -2.5, -3, -2, -2, -3, NAN_, -1 },
        { 4503599627370495.5, 4503599627370495.0, 4503599627370496.0, 4503599627370495.0, 4503599627370496.0, 67108863.999999993, 1 },
        { 4503599627370497.0, 4503599627370497.0, 4503599627370497.0, 4503599627370497.0, 4503599627370497.0, 67108864.000000007, 1 },
        { 5e-324, 0, 1, 0, 0, 2.2227587494850775e-162, 1 },
        { -5e-324, -1, -0.0, -0.0, -0.0, NAN_, -1 },
        { 1e300, 1e300, 1e300, 1e300, 1e300, 1e150, 1 },
        { INF, INF, INF, INF, INF, INF, 1 },
        { -INF, -INF, -INF, -INF, -INF, NAN_, -1 },
        { NAN_, NAN_, NAN_, NAN_, NAN_, NAN_, NAN_ },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        CHECK(same(sm_floor(row[i].x), row[i].floor));
        CHECK(same(sm_ceil(row[i].x), row[i].ceil));
        CHECK(same(sm_trunc(row[i].x), row[i].trunc));
        CHECK(same(sm_round(row[i].x), row[i].round));
        CHECK(same(sm_sqrt(row[i].x), row[i].sqrt));
        CHECK(same(sm_sign(row[i].x), row[i].sign));
        CHECK(sm_bits(sm_abs(row[i].x)) == (sm_bits(row[i].x) & 0x7FFFFFFFFFFFFFFFu));
    }
}

static void test_two_arguments(void)
{
    static const struct { SmF64 a, b, min, max; } row[] = {
        { 1, 2, 1, 2 }, { -1, 1, -1, 1 }, { 3, 3, 3, 3 }, { 0.0, -0.0, -0.0, 0.0 }, { -0.0, -0.0, -0.0, -0.0 },
        { 0.0, 0.0, 0.0, 0.0 },
        { 5e-324, 0.0, 0.0, 5e-324 }, { -5e-324, -0.0, -5e-324, -0.0 }, { 1e308, -1e308, -1e308, 1e308 },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        CHECK(same(sm_min(row[i].a, row[i].b), row[i].min) && same(sm_min(row[i].b, row[i].a), row[i].min));
        CHECK(same(sm_max(row[i].a, row[i].b), row[i].max) && same(sm_max(row[i].b, row[i].a), row[i].max));
    }
    CHECK(same(sm_min(INF, 1), 1) && same(sm_max(-INF, 1), 1) && same(sm_min(-INF, INF), -INF) && same(sm_max(-INF, INF), INF));
    CHECK(same(sm_min(NAN_, 1), NAN_) && same(sm_min(1, NAN_), NAN_) && same(sm_min(NAN_, -INF), NAN_));
    CHECK(same(sm_max(NAN_, 1), NAN_) && same(sm_max(1, NAN_), NAN_) && same(sm_max(INF, NAN_), NAN_));
}

static void test_clamp(void)
{
    CHECK(same(sm_clamp(5, 0, 10), 5) && same(sm_clamp(-5, 0, 10), 0) && same(sm_clamp(15, 0, 10), 10));
    CHECK(same(sm_clamp(5, 10, 0), 0));                    // min(max(x, lo), hi), also when lo > hi
    CHECK(same(sm_clamp(-0.0, 0.0, 1), 0.0) && same(sm_clamp(0.0, -1, -0.0), -0.0));
    CHECK(same(sm_clamp(NAN_, 0, 1), NAN_) && same(sm_clamp(0, NAN_, 1), NAN_) && same(sm_clamp(0, 0, NAN_), NAN_));
}

static void test_against_libm(void)
{
    for (int i = 0; i < 1000000; i++) {
        const SmF64 x = sm_from_bits(random_f64_bits());
        CHECK(same(sm_floor(x), floor(x)));
        CHECK(same(sm_ceil(x), ceil(x)));
        CHECK(same(sm_trunc(x), trunc(x)));
        CHECK(same(sm_round(x), round(x)));
        CHECK(same(sm_sqrt(x), sqrt(x)));
        CHECK(same(sm_abs(x), fabs(x)));
    }
}

// Returns the position of x in a total order of all numbers, from its bits.  Min and max must agree with this order.
static int64_t order_key(SmF64 x)
{
    const uint64_t u = sm_bits(x);
    return u >> 63 != 0 ? -(int64_t)(u & 0x7FFFFFFFFFFFFFFFu) - 1 : (int64_t)u;
}

static void test_order(void)
{
    for (int i = 0; i < 1000000; i++) {
        const SmF64 a = sm_from_bits(random_f64_bits()), b = i % 5 == 0 ? sm_neg(a) : sm_from_bits(random_f64_bits());
        const bool nan = a != a || b != b;
        CHECK(same(sm_min(a, b), nan ? NAN_ : order_key(a) < order_key(b) ? a : b));
        CHECK(same(sm_max(a, b), nan ? NAN_ : order_key(a) < order_key(b) ? b : a));
        CHECK(same(sm_sign(a), a > 0 ? 1.0 : a < 0 ? -1.0 : a));
    }
}

static void test_squares(void)
{
    for (int i = 0; i < 300000; i++) {
        const double root = (double)(random_u64() >> 38);            // its square is exact
        const double square = root * root;
        CHECK(same(sm_sqrt(square), root));
        CHECK(same(sm_sqrt(sm_from_bits(sm_bits(square) + 1)), sqrt(sm_from_bits(sm_bits(square) + 1))));
    }
}

int main(void)
{
    test_one_argument();
    test_two_arguments();
    test_clamp();
    test_against_libm();
    test_order();
    test_squares();
    return test_end("stdlib_math");
}
