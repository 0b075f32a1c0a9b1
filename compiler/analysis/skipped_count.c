// SPDX-License-Identifier: Apache-2.0
// Reports counters that are compared by == or != with a number that they skip.  A counter is a variable that only counts up or down by one
// constant.  Whether it skips the number is found by counting from each constant that is assigned to it, with the rounding of its
// type.
#include "compiler/analysis/analysis.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

enum { STARTS_MAX = 8, COUNTS_MAX = 2000000 };        // the most constants recorded for a counter; the most increments simulated from one of them

// What is known about a variable from its assignments: whether it is a counter, and how it counts.
typedef struct Counter {
    bool other;                   // an assignment is neither a constant nor the increment `by`: the variable is not checked
    SmF64 by;                     // the increment of the counter; 0: not yet known
    SmF64 start[STARTS_MAX];      // the constants assigned to the counter
    uint32_t starts;              // number of entries of `start`
} Counter;

typedef struct Counters { Analysis *a; Counter *counter; } Counters;

// Returns the increment of an assignment v = v + k or v = k + v (k) or v = v - k (-k); 0 for any other assignment.
static SmF64 increment_of(const Stmt *s)
{
    const Expr *e = s->value;
    const bool sum = e->kind == EX_BINARY && e->op == SM_OP_ADD, less = e->kind == EX_BINARY && e->op == SM_OP_SUB;

    if ((sum || less) && e->arg[0]->kind == EX_VAR && e->arg[0]->var == s->var && expr_is_constant(e->arg[1]))
        return sum ? expr_constant_value(e->arg[1]) : sm_neg(expr_constant_value(e->arg[1]));
    if (sum && e->arg[1]->kind == EX_VAR && e->arg[1]->var == s->var && expr_is_constant(e->arg[0]))
        return expr_constant_value(e->arg[0]);
    return sm_from_i32(0);
}

static SmF64 stored_value(const Var *v, SmF64 x) { return sm_cell_to_f64(v->type, sm_cell_from_f64(v->type, x)); }

static void record_assignment(const Stmt *s, void *context)
{
    Counters *k = context;
    Counter *c;
    SmF64 by;

    if (s->kind != ST_ASSIGN)
        return;
    c = &k->counter[s->var->index];
    by = increment_of(s);
    if (expr_is_constant(s->value) && c->starts < STARTS_MAX)
        c->start[c->starts++] = stored_value(s->var, expr_constant_value(s->value));
    else if (expr_is_constant(s->value) || sm_eq(by, sm_from_i32(0)) || (!sm_eq(c->by, sm_from_i32(0)) && !sm_eq(c->by, by)))
        c->other = true;
    else
        c->by = by;
}

// Whether the variable becomes x when it counts from `start`.  Also true if COUNTS_MAX increments do not decide this.
static bool counts_to(const Counter *c, const Var *v, SmF64 start, SmF64 x)
{
    const bool up = sm_lt(sm_from_i32(0), c->by);
    SmF64 now = start;

    for (uint32_t n = 0; n < COUNTS_MAX; n++) {
        const SmF64 next = stored_value(v, sm_add(now, c->by));
        if (sm_eq(now, x))
            return true;
        if (sm_eq(next, now) || (up ? sm_lt(x, now) : sm_lt(now, x)))
            return false;
        now = next;
    }
    return true;
}

// Whether the counter passes the number x without ever having it.
static bool is_skipped(const Counter *c, const Var *v, SmF64 x)
{
    if (c->other || sm_eq(c->by, sm_from_i32(0)) || counts_to(c, v, sm_cell_to_f64(v->type, v->init), x))
        return false;
    for (uint32_t i = 0; i < c->starts; i++)
        if (counts_to(c, v, c->start[i], x))
            return false;
    return true;
}

static void check_equality(Expr *e, void *context)
{
    const Counters *k = context;

    if (e->kind != EX_BINARY || (e->op != SM_OP_EQ && e->op != SM_OP_NE))
        return;
    for (int side = 0; side < 2; side++) {
        const Expr *v = e->arg[side], *x = e->arg[1 - side];
        Diag *d;
        if (v->kind != EX_VAR || v->var->kind == VAR_TIME || !expr_is_constant(x) ||
            !is_skipped(&k->counter[v->var->index], v->var, expr_constant_value(x)))
            continue;
        d = diag_report(k->a->diags, DIAG_exact_moment, e->span, v->var->name->text, const_text(k->a->arena, expr_constant_value(x)));
        diag_note(k->a->diags, d, (Span){0}, DIAG_note_counts_by, v->var->name->text,
                  const_text(k->a->arena, k->counter[v->var->index].by));
    }
}

static void check_stmt(const Stmt *stmt, void *context)
{
    if (stmt->operators & EQUALITIES)
        expr_walk(stmt->value, check_equality, context);
}

void analyse_skipped_count(Analysis *a)
{
    Counters k = {a, ARENA_ARRAY(a->arena, Counter, a->p->var.n)};

    if (!(a->p->operators & EQUALITIES))
        return;
    each_stmt(a->p, record_assignment, &k);
    each_stmt(a->p, check_stmt, &k);
}
