// SPDX-License-Identifier: Apache-2.0
// Reports two mistakes with times.  First, waiting for one exact time: T, G, or a local computed from them is compared by == or != with a
// time that no step may have.  Comparing a time with itself is not reported: T == 0 is true in a state's first step, G == start in the
// step in which `start` was stored.  Second, comparing T, or the time since a stored one as in `G - start`, with a number that is less than the
// length of a step or not whole: the user probably meant seconds, but both count milliseconds.
#include "compiler/analysis/analysis.h"
#include "compiler/analysis/timestamps.h"
#include "stdlib/math.h"

typedef struct TimeChecks { Analysis *a; Timestamps m; } TimeChecks;      // m: computed when it is first needed

static const Timestamps *find_timestamps(TimeChecks *k)
{
    if (!k->m.of)
        k->m = timestamps_of(k->a->arena, k->a->p);
    return &k->m;
}

// Whether s, the difference of the two sides of an equality, contains only times and no constant: then the sides are equal in an intended step,
// such as the step in which a time was stored. False if a local with a shifted time is compared with T or G.
static bool is_zero_difference(const TimeSum *s)
{
    const bool zero = sm_eq(s->number, sm_from_i32(0)) && !s->other;

    return zero && (!s->shifted || !s->time);
}

// Whether T is compared with a fraction, as in T == 5.5, which is never true.  decided_comparison.c reports such comparisons.
static bool is_never_equal(const Expr *time, const Expr *other)
{
    const SmF64 x = expr_is_constant(other) ? expr_constant_value(other) : sm_from_i32(0);

    return time->kind == EX_VAR && !sm_eq(x, sm_floor(x));
}

// Whether T is compared with a multiple of the step, so that T reaches this value exactly.  False if the length of the step is unknown.
static bool is_multiple_of_step(const TimeChecks *k, const Expr *time, const Expr *other)
{
    double steps;

    if (k->a->step == 0 || time->kind != EX_VAR || time->var != k->a->p->t || !expr_is_constant(other))
        return false;
    steps = expr_constant_value(other) / (double)k->a->step;
    return steps == sm_floor(steps);
}

// Whether x, with which T is compared, is probably not in milliseconds: x is a fraction or less than a step.  False for x <= 0 and for
// x >= 1000.  `first_step`: the operator is >= or <; then false also for 1, which separates the first step from the others.
static bool is_unlikely_limit(const TimeChecks *k, SmF64 x, bool first_step)
{
    const SmF64 one = sm_from_i32(1);

    if (!sm_lt(sm_from_i32(0), x) || !sm_lt(x, sm_from_i32(1000)))
        return false;
    return !sm_eq(x, sm_floor(x)) || (sm_lt(x, sm_from_u64(k->a->step)) && !(first_step && sm_eq(x, one)));
}

// Whether x, a time with a unit, is above 0 and less than half a step. A larger one is intended to separate the first step, where T is 0, from the
// second, where T is about a step.
static bool is_much_less_than_step(const TimeChecks *k, SmF64 x)
{
    return sm_lt(sm_from_i32(0), x) && sm_lt(sm_add(x, x), sm_from_u64(k->a->step));
}

// Whether e is a time that has passed: T, or the time since one that a local stores, as in `G - start`.
static bool is_duration(TimeChecks *k, const Expr *e)
{
    const Program *p = k->a->p;
    const Expr *from;

    if (e->kind == EX_VAR)
        return e->var == p->t;
    if (e->kind != EX_BINARY || e->op != SM_OP_SUB || e->arg[0]->kind != EX_VAR || (e->arg[0]->var != p->g && e->arg[0]->var != p->t))
        return false;
    from = e->arg[1];
    return from->kind == EX_VAR && from->var->kind == VAR_LOCAL && find_timestamps(k)->of[from->var->index] == TIMESTAMP_COPY;
}

// Reports `time op other` if `time` is a time that has passed and `other` is an unlikely number.  `whole`: the expression that contains the
// comparison.
static void check_limit(TimeChecks *k, const Expr *whole, const Expr *time, SmOperator op, const Expr *other)
{
    const bool first_step = op == SM_OP_GE || op == SM_OP_LT;
    const char *reason;
    SmF64 x;
    Diag *d;

    if (op == SM_OP_EQ || op == SM_OP_NE || !expr_is_constant(other) || !is_duration(k, time))
        return;
    x = expr_constant_value(other);
    if (other->unit == TIME_NONE ? !is_unlikely_limit(k, x, first_step) : !is_much_less_than_step(k, x))
        return;
    reason = sm_eq(x, sm_floor(x)) ? format_in(k->a->arena, "advances by %llu in each step", (unsigned long long)k->a->step)
                                   : "is a whole number";
    d = diag_report(k->a->diags, DIAG_short_time, whole->span, source_text(k->a->arena, time->span), const_text(k->a->arena, x), reason);
    diag_label(k->a->diags, d, DIAG_label_seconds, const_text(k->a->arena, x));
}

static void check_expr(Expr *e, void *context)
{
    TimeChecks *k = context;
    const Expr *time, *other;
    TimeSum s;

    for (uint32_t i = 0; i < comparison_count(e); i++) {
        const Comparison c = comparison_at(e, i);
        check_limit(k, e, c.a, c.op, c.b);
        check_limit(k, e, c.b, comparison_swapped(c.op), c.a);
    }
    if (e->kind != EX_BINARY || (e->op != SM_OP_EQ && e->op != SM_OP_NE))
        return;
    time = e->arg[0];
    s = time_sum_of(find_timestamps(k), time);
    if (!s.time && !s.stamp)
        time = e->arg[1];
    other = time == e->arg[0] ? e->arg[1] : e->arg[0];
    s = time_sum_difference(time_sum_of(&k->m, time), time_sum_of(&k->m, other));
    if (!s.linear || !(s.time || s.stamp) || is_zero_difference(&s) || is_never_equal(time, other) || is_multiple_of_step(k, time, other))
        return;
    diag_report(k->a->diags, DIAG_exact_moment, e->span, source_text(k->a->arena, time->span),
                expr_is_constant(other) ? const_text(k->a->arena, expr_constant_value(other)) : source_text(k->a->arena, other->span));
}

static void check_stmt(const Stmt *stmt, void *context)
{
    if (stmt->operators & COMPARISONS)
        expr_walk(stmt->value, check_expr, context);
}

void analyse_exact_moment(Analysis *a)
{
    TimeChecks k = {.a = a};

    if (!(a->p->operators & COMPARISONS))
        return;
    each_stmt(a->p, check_stmt, &k);
}
