// SPDX-License-Identifier: Apache-2.0
// Waiting for one exact moment: T, G, or a local that is reckoned from them, compared by == or != with a moment that steps may
// jump over.  Zero is none: T == 0 is a state's first step, G == start the step in which start was noted.
#include "compiler/analysis/analysis.h"
#include "compiler/analysis/moments.h"
#include "stdlib/math.h"

typedef struct Look { Analysis *a; Moments m; } Look;

// Neither side moves against the other by more than a plain copy does.
static bool is_beginning(const TimeSum *s)
{
    const bool zero = sm_eq(s->number, sm_from_i32(0)) && !s->other;

    return zero && (!s->shifted || !s->time);
}

// T == 5.5 is never: W0414 says so.
static bool never_is(const Expr *time, const Expr *other)
{
    const SmF64 x = expr_is_constant(other) ? const_eval(other) : sm_from_i32(0);

    return time->kind == EX_VAR && !sm_eq(x, sm_floor(x));
}

static void look_at_expr(Expr *e, void *context)
{
    Look *k = context;
    const Expr *time, *other;
    TimeSum s;

    if (e->kind != EX_BINARY || (e->op != SM_OP_EQ && e->op != SM_OP_NE))
        return;
    time = e->arg[0];
    s = time_sum(&k->m, time);
    if (!s.time && !s.moment)
        time = e->arg[1];
    other = time == e->arg[0] ? e->arg[1] : e->arg[0];
    s = time_difference(time_sum(&k->m, time), time_sum(&k->m, other));
    if (!s.linear || !(s.time || s.moment) || is_beginning(&s) || never_is(time, other))
        return;
    diag_report(k->a->diags, DIAG_exact_moment, e->span, source_text(k->a->arena, time->span),
                expr_is_constant(other) ? const_text(k->a->arena, const_eval(other)) : source_text(k->a->arena, other->span));
}

static void look_at_stmt(const Stmt *stmt, void *context)
{
    if (stmt->operators & EQUALITIES)
        expr_walk(stmt->value, look_at_expr, context);
}

void analyse_moment(Analysis *a)
{
    Look k;

    if (!(a->p->operators & EQUALITIES))
        return;
    k = (Look){a, moments_of(a->arena, a->p)};
    each_stmt(a->p, look_at_stmt, &k);
}
