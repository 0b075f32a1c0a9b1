// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/timestamps.h"

#include "compiler/analysis/analysis.h"
#include "stdlib/math.h"

// ---- sums ----

static TimeSum no_time_sum(void) { return (TimeSum){.linear = false}; }

static TimeSum sum_of_number(SmF64 x)
{
    return (TimeSum){.linear = true, .number = x};
}

static TimeSum sum_of_var(const Timestamps *m, const Var *v)
{
    TimeSum s = {.linear = true, .number = sm_from_i32(0)};

    s.time = v == m->p->t || v == m->p->g;
    s.stamp = !s.time && m->of[v->index] != TIMESTAMP_NONE;
    s.shifted = m->of[v->index] == TIMESTAMP_SHIFTED;
    s.other = !s.time && !s.stamp;
    return s;
}

TimeSum time_sum_difference(TimeSum a, TimeSum b)
{
    return (TimeSum){a.linear && b.linear, a.time || b.time,   a.stamp || b.stamp, a.shifted || b.shifted,
                     a.other || b.other,   a.scaled || b.scaled, sm_sub(a.number, b.number)};
}

static TimeSum scale_sum(TimeSum s, SmF64 number)
{
    s.number = number;
    s.scaled |= s.time || s.stamp;
    return s;
}

// Whether the sum contains no variable.
static bool is_number(const TimeSum *s) { return !s->time && !s->stamp && !s->other; }

static TimeSum sum_of_product(const Timestamps *m, const Expr *e)
{
    const TimeSum a = time_sum_of(m, e->arg[0]), b = time_sum_of(m, e->arg[1]);

    if (!a.linear || !b.linear)
        return no_time_sum();
    if (is_number(&b))
        return scale_sum(a, e->op == SM_OP_MUL ? sm_mul(a.number, b.number) : sm_div(a.number, b.number));
    if (e->op == SM_OP_MUL && is_number(&a))
        return scale_sum(b, sm_mul(a.number, b.number));
    if (a.time || a.stamp || b.time || b.stamp)
        return no_time_sum();
    return (TimeSum){.linear = true, .other = true, .number = sm_from_i32(0)};
}

static TimeSum sum_of_operator(const Timestamps *m, const Expr *e)
{
    TimeSum b;

    if (e->op == SM_OP_MUL || e->op == SM_OP_DIV)
        return sum_of_product(m, e);
    if (e->op != SM_OP_ADD && e->op != SM_OP_SUB)
        return no_time_sum();
    b = time_sum_of(m, e->arg[1]);
    if (e->op == SM_OP_ADD)
        b.number = sm_neg(b.number);
    return time_sum_difference(time_sum_of(m, e->arg[0]), b);
}

// Returns the expression e as a sum. The recursion depth equals the nesting of expressions, which AST_DEPTH_MAX bounds.
TimeSum time_sum_of(const Timestamps *m, const Expr *e)
{
    TimeSum s;

    switch (e->kind) {
    case EX_NUMBER: return sum_of_number(e->number);
    case EX_VAR: return e->var->is_constant ? sum_of_number(expr_constant_value(e)) : sum_of_var(m, e->var);
    case EX_BINARY: return sum_of_operator(m, e);
    case EX_UNARY:
        s = e->op == SM_OP_NEG ? time_sum_of(m, e->arg[0]) : no_time_sum();
        s.number = sm_neg(s.number);
        return s;
    case EX_CALL: return expr_is_constant(e) ? sum_of_number(expr_constant_value(e)) : no_time_sum();
    case EX_CHAIN: case EX_ROLL: case EX_EVERY: case EX_AT: case EX_RANDOM: break;
    }
    return no_time_sum();
}

// ---- locals ----

typedef struct TimestampSearch {
    Timestamps m;
    bool *refused;            // by Var.index: some assignment stores a value that is neither a time nor a constant
    uint8_t *found;           // by Var.index: the highest TimestampKind of an assignment
} TimestampSearch;

// Records which kind of time an assignment stores in a local: a copy of a time, a shifted time (a time plus a constant), or no time.
static void record_assignment(const Stmt *stmt, void *context)
{
    TimestampSearch *f = context;
    TimestampKind kind;
    TimeSum s;

    if (stmt->kind != ST_ASSIGN || stmt->var->kind != VAR_LOCAL || expr_is_constant(stmt->value))
        return;
    s = time_sum_of(&f->m, stmt->value);
    if (!s.linear || s.scaled || !(s.time || s.stamp)) {
        f->refused[stmt->var->index] = true;
        return;
    }
    kind = s.shifted || s.other || !sm_eq(s.number, sm_from_i32(0)) ? TIMESTAMP_SHIFTED : TIMESTAMP_COPY;
    if (f->found[stmt->var->index] < kind)
        f->found[stmt->var->index] = (uint8_t)kind;
}

Timestamps timestamps_of(Arena *arena, const Program *p)
{
    TimestampSearch f = {{p, ARENA_ARRAY(arena, uint8_t, p->var.n)}, NULL, NULL};

    for (int round = 0; round < 2; round++) {                 // in round 2, the locals found in round 1 count as times
        f.refused = ARENA_ARRAY(arena, bool, p->var.n);
        f.found = ARENA_ARRAY(arena, uint8_t, p->var.n);
        each_stmt(p, record_assignment, &f);
        for (size_t v = 0; v < p->var.n; v++)
            f.m.of[v] = f.refused[v] ? (uint8_t)TIMESTAMP_NONE : f.found[v];
    }
    return f.m;
}
