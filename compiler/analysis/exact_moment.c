// SPDX-License-Identifier: Apache-2.0
// Waiting for one exact time: T, G, or a local computed from them is compared by == or != with a time that steps may jump over.
// A difference of zero is not reported: T == 0 is a state's first step, G == start is the step in which start was stored.  Also
// limits of T that are shorter than a step, or not whole numbers: the user probably meant seconds where milliseconds are
// counted.
#include "compiler/analysis/analysis.h"
#include "compiler/analysis/timestamps.h"
#include "stdlib/math.h"

typedef struct TimeChecks { Analysis *a; Timestamps m; } TimeChecks;

// The difference of the two sides is zero apart from plain copies of the time.
static bool is_zero_difference(const TimeSum *s)
{
    const bool zero = sm_eq(s->number, sm_from_i32(0)) && !s->other;

    return zero && (!s->shifted || !s->time);
}

// T == 5.5 is never true; W0414 reports it.
static bool is_never_equal(const Expr *time, const Expr *other)
{
    const SmF64 x = expr_is_constant(other) ? expr_constant_value(other) : sm_from_i32(0);

    return time->kind == EX_VAR && !sm_eq(x, sm_floor(x));
}

// T is a multiple of the step, if the step is known.
static bool is_multiple_of_step(const TimeChecks *k, const Expr *time, const Expr *other)
{
    double steps;

    if (k->a->step == 0 || time->kind != EX_VAR || time->var != k->a->p->t || !expr_is_constant(other))
        return false;
    steps = expr_constant_value(other) / (double)k->a->step;
    return steps == sm_floor(steps);
}

// Whether a limit x of T separates steps in an unlikely place.  T >= 1 and T < 1 (`first_step`) are about the first step.
static bool is_unlikely_limit(const TimeChecks *k, SmF64 x, bool first_step)
{
    const SmF64 one = sm_from_i32(1);

    if (!sm_lt(sm_from_i32(0), x) || !sm_lt(x, sm_from_i32(1000)))
        return false;
    return !sm_eq(x, sm_floor(x)) || (sm_lt(x, sm_from_u64(k->a->step)) && !(first_step && sm_eq(x, one)));
}

static void check_limit(TimeChecks *k, const Expr *whole, const Expr *time, SmOperator op, const Expr *other)
{
    const bool first_step = op == SM_OP_GE || op == SM_OP_LT;
    const char *reason;
    SmF64 x;
    Diag *d;

    if (op == SM_OP_EQ || op == SM_OP_NE || time->kind != EX_VAR || time->var != k->a->p->t || !expr_is_constant(other) ||
        !is_unlikely_limit(k, x = expr_constant_value(other), first_step))
        return;
    reason = sm_eq(x, sm_floor(x)) ? format_in(k->a->arena, "advances by %llu in each step", (unsigned long long)k->a->step)
                                   : "is a whole number";
    d = diag_report(k->a->diags, DIAG_short_time, whole->span, const_text(k->a->arena, x), reason);
    if (k->a->p->g)
        diag_label(k->a->diags, d, DIAG_label_seconds, const_text(k->a->arena, sm_mul(x, sm_from_i32(1000))), k->a->p->g->name->text);
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
    s = time_sum(&k->m, time);
    if (!s.time && !s.stamp)
        time = e->arg[1];
    other = time == e->arg[0] ? e->arg[1] : e->arg[0];
    s = time_difference(time_sum(&k->m, time), time_sum(&k->m, other));
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
    if (a->p->operators & EQUALITIES)
        k.m = timestamps_of(a->arena, a->p);
    each_stmt(a->p, check_stmt, &k);
}
