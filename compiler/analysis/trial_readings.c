// SPDX-License-Identifier: Apache-2.0
// The readings of an input that trials choose from, and the times that a machine waits for.
//
// A comparison changes its result at a reading (a root) where its two sides are equal.  Roots are found with the secant method, because
// most comparisons are linear.  One reading from each interval between roots, and zero, are enough to make every comparison
// true and false.
#include <stdlib.h>
#include <string.h>

#include "compiler/analysis/trial_inputs.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

enum { ROOTS_MAX = 64 };              // the most roots stored for one input

// Executes each assignment of one state, or of all states if `state` is 0, once in file order.
static void run_assignments(TrialFinder *f, uint32_t state)
{
    for (size_t i = 0; i < f->assign.n; i++)
        if (state == 0 || f->assign_state.at[i] == state)
            f->value[f->assign.at[i]->var->index] = expr_eval(f->assign.at[i]->value, f->value);
}

// Computes the values of the variables after every assignment has been executed, with the current inputs.
static void compute_vars(TrialFinder *f)
{
    for (size_t v = 0; v < f->p->var.n; v++)
        if (f->p->var.at[v]->kind == VAR_LOCAL)
            f->value[v] = f->p->var.at[v]->parameter ? trial_value_of_parameter(f->t->setting, f->p->var.at[v])
                                                     : sm_cell_to_f64(f->p->var.at[v]->type, f->p->var.at[v]->init);
    run_assignments(f, 0);
}

// Readings at which the sides of a comparison are equal.
typedef struct Roots { double at[ROOTS_MAX]; uint32_t n; bool full; } Roots;

// Adds a reading at which some condition changes, unless the list contains it.
static void add_root(Roots *r, double x)
{
    if (!(x > -1e15 && x < 1e15))
        return;
    for (uint32_t i = 0; i < r->n; i++)
        if (sm_abs(r->at[i] - x) <= 1e-9 * sm_abs(x))
            return;
    if (r->n < ROOTS_MAX)
        r->at[r->n++] = x;
    else
        r->full = true;
}

// Which variables are assumed to keep their values when a reading changes, because another state or an earlier step stored them: none,
// those that other states assign, or all.
typedef enum ReadingMemory { REMEMBER_NOTHING, REMEMBER_OTHER_STATES, REMEMBER_EVERYTHING, READING_MEMORIES } ReadingMemory;

// Computes the difference of the two sides of each comparison, and stores it in d.
static void compute_differences(TrialFinder *f, ReadingMemory remembered, double *d)
{
    for (size_t c = 0; c < f->comparison.n; c++) {
        if (remembered == REMEMBER_OTHER_STATES && (c == 0 || f->comparison.at[c].state != f->comparison.at[c - 1].state)) {
            memcpy(f->value, f->saved, f->p->var.n * sizeof *f->value);
            run_assignments(f, f->comparison.at[c].state);
        }
        d[c] = expr_eval(f->comparison.at[c].pair.a, f->value) - expr_eval(f->comparison.at[c].pair.b, f->value);
    }
}

// Finds the roots of an input, a group or the time, which `set` sets to the reading x.  bit: the input on which a comparison must depend to
// be considered; IR_NONE: considers all comparisons.
static void find_roots(TrialFinder *f, void (*set)(TrialFinder *f, uint32_t which, double x), uint32_t which, uint32_t bit,
                       ReadingMemory remembered, Roots *out)
{
    static const double at[] = {-1e5, -40, 0, 1, 90, 3000, 1e5};
    enum { POINTS = sizeof at / sizeof *at };
    const size_t n = f->comparison.n;
    double *d = ARENA_ARRAY(f->arena, double, n * POINTS + 1);

    set(f, which, bit == IR_NONE ? 0 : at[0]);            // if the time is searched: variables that store a time store 0, a time in the past
    compute_vars(f);
    for (size_t k = 0; k < POINTS; k++) {
        set(f, which, at[k]);
        if (remembered == REMEMBER_NOTHING)
            compute_vars(f);
        memcpy(f->saved, f->value, f->p->var.n * sizeof *f->value);
        compute_differences(f, remembered, d + k * n);
        memcpy(f->value, f->saved, f->p->var.n * sizeof *f->value);
    }
    for (size_t c = 0; c < n; c++) {
        memset(f->bits, 0, f->words * sizeof *f->bits);
        if (bit != IR_NONE) {
            trial_add_inputs(f, f->comparison.at[c].pair.a, f->data, f->bits);
            trial_add_inputs(f, f->comparison.at[c].pair.b, f->data, f->bits);
        }
        for (size_t k = 1; k < POINTS && (bit == IR_NONE || bitset_has(f->bits, bit)); k++) {
            const double d0 = d[(k - 1) * n + c], d1 = d[k * n + c];
            if (d0 != d1)
                add_root(out, at[k - 1] - d0 * (at[k] - at[k - 1]) / (d1 - d0));
        }
    }
}

// Sets all inputs to 0 except this one.
static void set_one_input(TrialFinder *f, uint32_t input, double x)
{
    for (uint32_t i = 0; i < f->t->inputs; i++)
        f->value[f->t->input[i].v->index] = 0;
    f->value[f->p->g->index] = f->value[f->p->t->index] = 0;
    f->value[f->t->input[input].v->index] = x;
}

// Sets this input and all of its group to the same reading, and all other inputs to 0.
static void set_input_group(TrialFinder *f, uint32_t input, double x)
{
    set_one_input(f, input, x);
    for (uint32_t i = 0; i < f->t->inputs; i++)
        if (f->t->input[i].group == f->t->input[input].group)
            f->value[f->t->input[i].v->index] = x;
}

// Sets G and T to x, as in the first state of a machine that started at 0, and all inputs to 0.
static void set_time(TrialFinder *f, uint32_t which, double x)
{
    (void)which;
    for (uint32_t i = 0; i < f->t->inputs; i++)
        f->value[f->t->input[i].v->index] = 0;
    f->value[f->p->g->index] = f->value[f->p->t->index] = x;
}

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

// Adds x, as the input's type stores it, to the readings that trials choose for the input.
static void add_reading(TrialInput *i, double x)
{
    const SmType type = i->v->type;

    x = sm_cell_to_f64(type, sm_cell_from_f64(type, x));
    for (uint32_t k = 0; k < i->readings; k++)
        if (i->reading[k] == x)
            return;
    i->reading[i->readings++] = x;
}

// Finds the readings of an input with which trials are worthwhile: some on each side of each reading at which a condition changes.
static void find_readings(TrialFinder *f, uint32_t input)
{
    TrialInput *i = &f->t->input[input];
    const bool whole = sm_type_info[i->v->type].kind != SM_KIND_FLOAT;
    Roots r = {{0}, 0, false};

    i->reading = ARENA_ARRAY(f->arena, double, 3 * ROOTS_MAX + 16);
    find_roots(f, set_one_input, input, input, REMEMBER_NOTHING, &r);
    if (i->v->type == SM_BOOL)
        r.n = 0;
    else
        for (int remembered = 0; remembered < READING_MEMORIES; remembered++)
            find_roots(f, set_input_group, input, input, (ReadingMemory)remembered, &r);
    if (r.full)
        trial_add_gap(f->t->gaps, (TrialGap){GAP_NUMBERS, NULL, i->v, NULL});
    qsort(r.at, r.n, sizeof *r.at, compare_numbers);
    i->rough = !i->v->range && r.n == 0;
    i->scale = i->v->range ? i->hi - i->lo : r.n > 1 ? r.at[r.n - 1] - r.at[0] : r.n == 1 && r.at[0] != 0 ? sm_abs(r.at[0]) : 1;
    if (i->v->range) {
        add_reading(i, i->lo);
        add_reading(i, i->hi);
        add_reading(i, (i->lo + i->hi) / 2);
    }
    for (uint32_t k = 0; k < r.n; k++) {
        if (k == 0)
            add_reading(i, r.at[0] - 0.5 * i->scale - 1);
        if (whole || i->command)
            add_reading(i, r.at[k]);
        add_reading(i, k + 1 < r.n ? (r.at[k] + r.at[k + 1]) / 2 : r.at[k] + 0.5 * i->scale + 1);
    }
    add_reading(i, 0);
    if (i->v->type == SM_BOOL || r.n == 0)
        add_reading(i, 1);
    if (!i->v->range && r.n > 0) {
        add_reading(i, r.at[0] - 20 * i->scale - 20);
        add_reading(i, r.at[r.n - 1] + 20 * i->scale + 20);
    }
    if (i->rough && i->v->type != SM_BOOL)
        for (double x = 30; x < 1e5; x *= 30)
            add_reading(i, x);
    qsort(i->reading, i->readings, sizeof *i->reading, compare_numbers);
}

void trial_find_readings(TrialFinder *f)
{
    Trials *t = f->t;

    for (uint32_t i = 0; i < t->inputs; i++)
        find_readings(f, i);
    for (uint32_t i = 0; i < t->inputs; i++)
        if (t->input[i].group != i)
            t->input[i].scale = t->input[t->input[i].group].scale;
}

// ---- times ----

static void mark_if_time(Expr *e, void *context)
{
    TrialFinder *f = context;

    f->reads_time |= e->kind == EX_VAR && e->var == f->p->g;
}

// Marks the variables that store a time.  The time itself, as in `launch = time`, is exact: waits begin there.  After an expression such as
// `deadline = time + 500`, they may begin at any time.
static void find_stamps(TrialFinder *f)
{
    Trials *t = f->t;

    for (size_t i = 0; i < f->assign.n; i++) {
        const Stmt *s = f->assign.at[i];
        f->reads_time = false;
        expr_walk(s->value, mark_if_time, f);
        if (f->reads_time && s->value->kind == EX_VAR)
            t->stamp[t->a->m->var_of[s->var->index]] = true;
        else
            t->stamped |= f->reads_time;
    }
}

void trial_find_waits(TrialFinder *f)
{
    Roots r = {{0}, 0, false};
    Trials *t = f->t;

    find_roots(f, set_time, 0, IR_NONE, REMEMBER_NOTHING, &r);
    find_roots(f, set_time, 0, IR_NONE, REMEMBER_EVERYTHING, &r);
    if (r.full)
        trial_add_gap(t->gaps, (TrialGap){GAP_NUMBERS, NULL, NULL, NULL});
    qsort(r.at, r.n, sizeof *r.at, compare_numbers);
    t->wait = ARENA_ARRAY(f->arena, double, ROOTS_MAX);
    for (uint32_t k = 0; k < r.n; k++)
        if (r.at[k] > 0 && r.at[k] < 1e12)
            t->wait[t->waits++] = sm_ceil(r.at[k]);
    find_stamps(f);
}
