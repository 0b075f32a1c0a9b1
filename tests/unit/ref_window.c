// SPDX-License-Identifier: Apache-2.0
// Windows of the reference, compared with values computed by hand where the order of additions or the sign of zero matters, and with stdlib.
#include "compiler/script/ref.h"

#include <math.h>
#include <stdlib.h>

#include "stdlib/roll.h"
#include "tests/heap.h"
#include "tests/test.h"

static Arena arena;
static jmp_buf oom;

// Windows over variable 0, an F64.
typedef struct Fixture { Windows list; RefWindows windows; Expr *sample; Var var; } Fixture;

static void set_up(Fixture *f, uint32_t size)
{
    Window w = {.sample = ARENA_NEW(&arena, Expr), .size = size, .stat = SM_STAT_AVG};

    *f = (Fixture){.sample = w.sample, .var = {.kind = VAR_ELEMENT, .type = SM_F64}};
    f->sample->kind = EX_VAR;
    f->sample->var = &f->var;
    vec_push(&arena, &f->list, w);
    ref_windows_init(&f->windows, &arena, &f->list);
}

static void push(Fixture *f, double x)
{
    uint64_t cell = sm_bits(x);

    ref_windows_sample(&f->windows, &cell);
}

static double stat(const Fixture *f, SmStat s) { return ref_statistic(&f->windows, 0, s); }
static bool same(double a, double b) { return sm_bits(a) == sm_bits(b) || (a != a && b != b); }

static void check_by_hand(void)
{
    Fixture f;

    set_up(&f, 4);
    push(&f, 1e16), push(&f, 1);
    CHECK(stat(&f, SM_STAT_AVG) == (1e16 + 1) / 2 && stat(&f, SM_STAT_MEDIAN) == 1 + (1e16 - 1) / 2);
    push(&f, 1), push(&f, 1);
    CHECK(stat(&f, SM_STAT_AVG) == ((1e16 + 1) + (1 + 1)) / 4);          // in pairs: one after another would give 1e16 / 4
    CHECK(((1e16 + 1) + (1 + 1)) / 4 != (((1e16 + 1) + 1) + 1) / 4);
    push(&f, INFINITY), push(&f, -INFINITY);
    CHECK(isnan(stat(&f, SM_STAT_AVG)) && stat(&f, SM_STAT_RANGE) == INFINITY && stat(&f, SM_STAT_MEDIAN) == 1);
    for (int i = 0; i < 4; i++)
        push(&f, 5);
    CHECK(stat(&f, SM_STAT_AVG) == 5 && same(stat(&f, SM_STAT_RANGE), 0));        // samples that have left the window have no effect
    push(&f, NAN);
    CHECK(stat(&f, SM_STAT_MIN) == 0 && stat(&f, SM_STAT_MEDIAN) == 5);
}

static void check_zeros_and_extremes(void)
{
    Fixture f;

    set_up(&f, 2);
    push(&f, 0.0), push(&f, -0.0);
    CHECK(same(stat(&f, SM_STAT_MIN), -0.0) && same(stat(&f, SM_STAT_MAX), 0.0));
    CHECK(same(stat(&f, SM_STAT_MEDIAN), -0.0) && same(stat(&f, SM_STAT_RANGE), 0.0));
    push(&f, 1.7e308), push(&f, -1.7e308);
    CHECK(stat(&f, SM_STAT_MEDIAN) == 0 && stat(&f, SM_STAT_RANGE) == INFINITY);
    push(&f, INFINITY), push(&f, INFINITY);
    CHECK(stat(&f, SM_STAT_RANGE) == 0 && stat(&f, SM_STAT_MEDIAN) == INFINITY);
    set_up(&f, 3);
    push(&f, -0.0);
    CHECK(same(stat(&f, SM_STAT_AVG), -0.0));                                     // empty slots are not added as 0
}

static void compare_with_stdlib(uint32_t size, uint32_t samples)
{
    static const double values[] = {0.0, -0.0, 1, -1, 0.1, 1e308, -1e308, INFINITY, -INFINITY, NAN, 3, 1e-300};
    const uint32_t kind = sm_roll_kind(SM_F64, 31);
    uint64_t *roll = ARENA_ARRAY(&arena, uint64_t, sm_roll_words(size, kind));
    uint32_t r = size * 2654435761u + 1;
    Fixture f;

    set_up(&f, size);
    for (uint32_t i = 0; i < samples; i++) {
        double x = (r = r * 1664525u + 1013904223u) >> 31 ? values[(r >> 8) % 12] : (double)(r >> 12) / 7;
        push(&f, x);
        sm_roll_sample(roll, size, kind, x);
        for (int s = 0; s < SM_STAT_ELAPSED; s++)
            CHECK(same(stat(&f, (SmStat)s), sm_roll_stat(roll, size, kind, (SmStat)s)));
    }
}

int main(void)
{
    if (setjmp(oom))
        return 1;
    arena_init(&arena, heap_alloc, NULL, &oom);
    check_by_hand();
    check_zeros_and_extremes();
    for (uint32_t size = 1; size <= 70; size++)
        compare_with_stdlib(size, 3 * size);
    compare_with_stdlib(1000, 2500);
    arena_free(&arena);
    return test_end("ref_window");
}
