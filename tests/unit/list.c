// SPDX-License-Identifier: Apache-2.0
// min, max, median and average of several values.  The results are compared with statistics of windows and with the reference.  The form of the
// IR steps is checked, too.
#include "compiler/sema/list.h"

#include <math.h>
#include <string.h>

#include "compiler/script/ref.h"
#include "stdlib/roll.h"
#include "tests/test.h"

static uint64_t random_state = 88172645463325252u;

static uint64_t next_random(void)                     // xorshift
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    return random_state ^= random_state << 17;
}

// Returns a number for which the mean of two is difficult: special, near the limits of the range, near another number, or any bits.
static double random_number(void)
{
    static const double edge[] = {0.0, -0.0, 5e-324, -5e-324, 1e-323, INFINITY, -INFINITY, 0x1.fffffffffffffp1023, -0x1.fffffffffffffp1023,
                                  0x1p-1022, 0x1p1023, -0x1p1023, 0x1p970, -0x1p970, -0x1p969, 1, -1, 3};
    const uint64_t r = next_random();

    switch (r % 4) {
    case 0: return edge[r / 4 % (sizeof edge / sizeof *edge)];
    case 1: return (double)(int)(r / 4 % 7) - 3;
    case 2: return (1 + (double)(r / 4 % 8) * 0x1p-52) * (r & 256 ? 1 : -1);
    default: return sm_from_bits(next_random());
    }
}

static bool same(double a, double b) { return sm_bits(a) == sm_bits(b) || (a != a && b != b); }

// Returns the statistic of a window with these samples, none of which is NaN.
static double statistic(SmStat stat, uint32_t n, const double *value)
{
    uint64_t window[256] = {0};
    const uint32_t kind = sm_roll_kind(SM_F64, 1u << stat);

    CHECK(sm_roll_words(n, kind) <= 256);
    for (uint32_t i = 0; i < n; i++)
        sm_roll_sample(window, n, kind, value[i]);
    return sm_roll_stat(window, n, kind, stat);
}

static void compare(void)
{
    static const struct { SmBuiltin fn; SmStat stat; } function[] = {
        {SM_FN_min, SM_STAT_MIN}, {SM_FN_max, SM_STAT_MAX}, {SM_FN_median, SM_STAT_MEDIAN}, {SM_FN_average, SM_STAT_AVG}};
    const uint32_t n = 2 + (uint32_t)(next_random() % (SM_LIST_MAX - 1)), f = (uint32_t)(next_random() % 4);
    double value[SM_LIST_MAX], sorted[SM_LIST_MAX];
    bool nan = false;

    for (uint32_t i = 0; i < n; i++)
        nan |= isnan(value[i] = random_number());
    memcpy(sorted, value, sizeof sorted);
    const double result = list_value(function[f].fn, n, value);
    CHECK(same(result, ref_list(function[f].fn, sorted, n)));
    CHECK(nan ? isnan(result) : same(result, statistic(function[f].stat, n, value)));
}

// Every operand of a step is an earlier value, and every step but the last is an operand of a later one.  A median of an odd number of values
// has only min and max, so that it is exact on integers.
static void check_steps(SmBuiltin fn, uint32_t n)
{
    ListStep step[LIST_STEPS_MAX];
    bool used[SM_LIST_MAX + LIST_STEPS_MAX] = {false};
    const uint32_t steps = list_steps(fn, n, step);

    CHECK(steps > 0 && steps <= LIST_STEPS_MAX);
    for (uint32_t i = 0; i < steps; i++) {
        const bool has_a = step[i].op != LIST_NUMBER, has_b = has_a && step[i].op != LIST_NEG;
        CHECK((!has_a || step[i].a < n + i) && (!has_b || step[i].b < n + i));
        used[step[i].a] |= has_a;
        used[step[i].b] |= has_b;
        CHECK(fn != SM_FN_median || n % 2 == 0 || step[i].op == LIST_MIN || step[i].op == LIST_MAX);
    }
    for (uint32_t i = 0; i + 1 < n + steps; i++)
        CHECK(used[i]);
}

static void check_sizes(void)
{
    ListStep step[LIST_STEPS_MAX];

    CHECK(list_steps(SM_FN_min, 2, step) == 1 && list_steps(SM_FN_max, 16, step) == 15);
    CHECK(list_steps(SM_FN_average, 2, step) == 3 && list_steps(SM_FN_average, 16, step) == 17);
    CHECK(list_steps(SM_FN_median, 3, step) == 4 && list_steps(SM_FN_median, 5, step) == 10 && list_steps(SM_FN_median, 7, step) == 20);
    for (uint32_t n = 2; n <= SM_LIST_MAX; n++) {
        check_steps(SM_FN_min, n);
        check_steps(SM_FN_max, n);
        check_steps(SM_FN_median, n);
        check_steps(SM_FN_average, n);
    }
}

int main(void)
{
    check_sizes();
    for (int i = 0; i < 400000; i++)
        compare();
    return test_end("list");
}
