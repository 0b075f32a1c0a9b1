// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/timestamps.h"

#include "stdlib/math.h"

// ---- sums ----

static TimeSum no_sum(void) { return (TimeSum){.linear = false}; }

static TimeSum number_sum(SmF64 x)
{
    return (TimeSum){.linear = true, .number = x};
}

static TimeSum var_sum(const Moments *m, const Var *v)
{
    TimeSum s = {.linear = true, .number = sm_from_i32(0)};

    s.time = v == m->p->t || v == m->p->g;
    s.moment = !s.time && m->of[v->index] != MOMENT_NONE;
    s.shifted = m->of[v->index] == MOMENT_SHIFTED;
    s.other = !s.time && !s.moment;
    return s;
}

TimeSum time_difference(TimeSum a, TimeSum b)
{
    return (TimeSum){a.linear && b.linear, a.time || b.time,   a.moment || b.moment, a.shifted || b.shifted,
                     a.other || b.other,   a.scaled || b.scaled, sm_sub(a.number, b.number)};
}

static TimeSum scaled(TimeSum s, SmF64 number)
{
    s.number = number;
    s.scaled |= s.time || s.moment;
    return s;
}

static bool is_number(const TimeSum *s) { return !s->time && !s->moment && !s->other; }

static TimeSum product(const Moments *m, const Expr *e)
{
    const TimeSum a = time_sum(m, e->arg[0]), b = time_sum(m, e->arg[1]);

    if (!a.linear || !b.linear)
        return no_sum();
    if (is_number(&b))
        return scaled(a, e->op == SM_OP_MUL ? sm_mul(a.number, b.number) : sm_div(a.number, b.number));
    if (e->op == SM_OP_MUL && is_number(&a))
        return scaled(b, sm_mul(a.number, b.number));
    if (a.time || a.moment || b.time || b.moment)
        return no_sum();
    return (TimeSum){.linear = true, .other = true, .number = sm_from_i32(0)};
}

static TimeSum operator_sum(const Moments *m, const Expr *e)
{
    TimeSum b;

    if (e->op == SM_OP_MUL || e->op == SM_OP_DIV)
        return product(m, e);
    if (e->op != SM_OP_ADD && e->op != SM_OP_SUB)
        return no_sum();
    b = time_sum(m, e->arg[1]);
    if (e->op == SM_OP_ADD)
        b.number = sm_neg(b.number);
    return time_difference(time_sum(m, e->arg[0]), b);
}

// Recursion depth equals the nesting of expressions, which AST_DEPTH_MAX bounds.
TimeSum time_sum(const Moments *m, const Expr *e)
{
    TimeSum s;

    switch (e->kind) {
    case EX_NUMBER: return number_sum(e->number);
    case EX_VAR: return e->var->is_constant ? number_sum(expr_constant_value(e)) : var_sum(m, e->var);
    case EX_BINARY: return operator_sum(m, e);
    case EX_UNARY:
        s = e->op == SM_OP_NEG ? time_sum(m, e->arg[0]) : no_sum();
        s.number = sm_neg(s.number);
        return s;
    case EX_CALL: return expr_is_constant(e) ? number_sum(expr_constant_value(e)) : no_sum();
    case EX_CHAIN: case EX_ROLL: break;
    }
    return no_sum();
}

// ---- locals ----

typedef struct Finder {
    Moments m;
    bool *refused;            // by Var.index: it has another kind of assignment too
    uint8_t *found;
} Finder;

static Moment moment_of(const TimeSum *s)
{
    if (!s->linear || s->scaled || !(s->time || s->moment))
        return MOMENT_NONE;
    return s->shifted || s->other || !sm_eq(s->number, sm_from_i32(0)) ? MOMENT_SHIFTED : MOMENT_COPY;
}

static void look_at(Finder *f, const Stmt *stmt)
{
    const TimeSum s = time_sum(&f->m, stmt->value);
    const Moment moment = moment_of(&s);
    uint8_t *found = &f->found[stmt->var->index];

    if (expr_is_constant(stmt->value))
        return;
    if (moment == MOMENT_NONE)
        f->refused[stmt->var->index] = true;
    else if (*found < moment)
        *found = (uint8_t)moment;
}

static void look_at_stmts(Finder *f, const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *stmt = stmts->at[i];
        if (stmt->kind == ST_ASSIGN && stmt->var->kind == VAR_LOCAL)
            look_at(f, stmt);
        look_at_stmts(f, &stmt->then);
        look_at_stmts(f, &stmt->otherwise);
    }
}

// Called twice, because a time may be computed from another one.
static void find(Finder *f)
{
    for (size_t s = 0; s < f->m.p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            look_at_stmts(f, &f->m.p->state.at[s]->block[b]);
    for (size_t v = 0; v < f->m.p->var.n; v++)
        f->m.of[v] = f->refused[v] ? (uint8_t)MOMENT_NONE : f->found[v];
}

Moments moments_of(Arena *arena, const Program *p)
{
    Finder f = {{p, ARENA_ARRAY(arena, uint8_t, p->var.n)}, NULL, NULL};

    for (int round = 0; round < 2; round++) {
        f.refused = ARENA_ARRAY(arena, bool, p->var.n);
        f.found = ARENA_ARRAY(arena, uint8_t, p->var.n);
        find(&f);
    }
    return f.m;
}
