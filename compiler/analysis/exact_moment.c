// SPDX-License-Identifier: Apache-2.0
// Waiting for one exact time: T, G, or a local computed from them is compared by == or != with a time that steps may jump over.
// A difference of zero is not reported: T == 0 is a state's first step, G == start is the step in which start was stored.  Also
// limits of T that are shorter than a step, or not whole numbers: the user probably meant seconds where milliseconds are
// counted.
#include "compiler/analysis/analysis.h"
#include "compiler/analysis/timestamps.h"
#include "stdlib/math.h"

typedef struct Look { Analysis *a; Moments m; } Look;

// The difference of the two sides is zero apart from plain copies of the time.
static bool is_beginning(const TimeSum *s)
{
    const bool zero = sm_eq(s->number, sm_from_i32(0)) && !s->other;

    return zero && (!s->shifted || !s->time);
}

// T == 5.5 is never true; W0414 reports it.
static bool never_is(const Expr *time, const Expr *other)
{
    const SmF64 x = expr_is_constant(other) ? expr_constant_value(other) : sm_from_i32(0);

    return time->kind == EX_VAR && !sm_eq(x, sm_floor(x));
}

// T is a multiple of the step, if the step is known.
static bool is_on_a_step(const Look *k, const Expr *time, const Expr *other)
{
    double steps;

    if (k->a->step == 0 || time->kind != EX_VAR || time->var != k->a->p->t || !expr_is_constant(other))
        return false;
    steps = expr_constant_value(other) / (double)k->a->step;
    return steps == sm_floor(steps);
}

// Whether a limit x of T separates steps in an unlikely place.  T >= 1 and T < 1 (`behind`) are about the first step.
static bool is_short(const Look *k, SmF64 x, bool behind)
{
    const SmF64 one = sm_from_i32(1);

    if (!sm_lt(sm_from_i32(0), x) || !sm_lt(x, sm_from_i32(1000)))
        return false;
    return !sm_eq(x, sm_floor(x)) || (sm_lt(x, sm_from_u64(k->a->step)) && !(behind && sm_eq(x, one)));
}

static void look_at_limit(Look *k, const Expr *whole, const Expr *time, SmOperator op, const Expr *other)
{
    const bool behind = op == SM_OP_GE || op == SM_OP_LT;
    SmF64 x;
    Diag *d;

    if (op == SM_OP_EQ || op == SM_OP_NE || time->kind != EX_VAR || time->var != k->a->p->t || !expr_is_constant(other) ||
        !is_short(k, x = expr_constant_value(other), behind))
        return;
    d = diag_report(k->a->diags, DIAG_short_time, whole->span, const_text(k->a->arena, x),
                    sm_eq(x, sm_floor(x)) ? format_in(k->a->arena, "advances by %llu in each step", (unsigned long long)k->a->step) : "is a whole number");
    if (k->a->p->g)
        diag_label(k->a->diags, d, DIAG_label_seconds, const_text(k->a->arena, sm_mul(x, sm_from_i32(1000))), k->a->p->g->name->text);
}

static void look_at_limits(Look *k, const Expr *e)
{
    for (uint32_t i = 0; i + 1 < e->n; i++) {
        const SmOperator op = e->kind == EX_CHAIN ? expr_ops(e)[i] : e->op;
        look_at_limit(k, e, e->arg[i], op, e->arg[i + 1]);
        look_at_limit(k, e, e->arg[i + 1], relation_mirrored(op), e->arg[i]);
    }
}

static void look_at_expr(Expr *e, void *context)
{
    Look *k = context;
    const Expr *time, *other;
    TimeSum s;

    if (e->kind == EX_CHAIN || (e->kind == EX_BINARY && sm_op_info[e->op].op_class == SM_CLASS_RELATION))
        look_at_limits(k, e);
    if (e->kind != EX_BINARY || (e->op != SM_OP_EQ && e->op != SM_OP_NE))
        return;
    time = e->arg[0];
    s = time_sum(&k->m, time);
    if (!s.time && !s.moment)
        time = e->arg[1];
    other = time == e->arg[0] ? e->arg[1] : e->arg[0];
    s = time_difference(time_sum(&k->m, time), time_sum(&k->m, other));
    if (!s.linear || !(s.time || s.moment) || is_beginning(&s) || never_is(time, other) || is_on_a_step(k, time, other))
        return;
    diag_report(k->a->diags, DIAG_exact_moment, e->span, source_text(k->a->arena, time->span),
                expr_is_constant(other) ? const_text(k->a->arena, expr_constant_value(other)) : source_text(k->a->arena, other->span));
}

static void look_at_stmt(const Stmt *stmt, void *context)
{
    if (stmt->operators & COMPARISONS)
        expr_walk(stmt->value, look_at_expr, context);
}

void analyse_exact_moment(Analysis *a)
{
    Look k = {.a = a};

    if (!(a->p->operators & COMPARISONS))
        return;
    if (a->p->operators & EQUALITIES)
        k.m = moments_of(a->arena, a->p);
    each_stmt(a->p, look_at_stmt, &k);
}
