// SPDX-License-Identifier: Apache-2.0
// Divisions by a value that is always 0, and by a value that can be 0 because no stored value, guard or @range of a sensor
// excludes it.
//
// Facts describe one variable at a time.  Guards can relate two variables (`a > b` for a - b) or limit an expression, as
// `abs(d) > 0.1` does for d.  Those relations are searched in the guards themselves, but only where the facts leave a doubt.
#include "compiler/analysis/analysis.h"
#include "compiler/analysis/assume.h"
#include "compiler/analysis/decided_comparison.h"
#include "compiler/analysis/guards_known.h"

#include "stdlib/convert.h"
#include "stdlib/math.h"

typedef struct Doubt Doubt;
struct Doubt {                    // a divisor that can be 0 according to the facts
    Span span;
    const Doubt *next;            // of the same statement
};

typedef struct Divide {
    Analysis *a;
    const Doubt **doubt;          // by Stmt.number; 0 for windows
    const Stmt *stmt;             // the current statement; NULL: a window
} Divide;

// ---- facts ----

static bool has_zero(Fact f) { return f.lo <= 0 && f.hi >= 0; }

// A product that underflows to 0 does not count: one of its factors must be able to be 0.
static bool can_be_zero(const Analysis *a, const IrFn *f, const Fact *of, IrRef r)
{
    const IrIns *i = &f->ins.at[r];

    if (!has_zero(of[r]))
        return false;
    switch ((int)i->op) {
    case IR_mul: return can_be_zero(a, f, of, i->a) || can_be_zero(a, f, of, i->b);
    case IR_div: case IR_neg: case IR_abs: case IR_sqrt: case IR_cvt: return can_be_zero(a, f, of, i->a);
    case IR_stat: return i->stat == SM_STAT_RANGE || has_zero(facts_of_window(a->facts, i->var));
    }
    return true;
}

static void note_doubt(Divide *k, const IrIns *divisor)
{
    Doubt *d = ARENA_NEW(k->a->arena, Doubt);

    *d = (Doubt){divisor->span, k->doubt[divisor->stmt]};
    k->doubt[divisor->stmt] = d;
}

static void look_at_division(Divide *k, const IrFn *f, const Fact *of, const IrIns *i)
{
    const Fact by = of[i->b];

    if (by.lo == 0 && by.hi == 0 && !by.nan)
        diag_report(k->a->diags, DIAG_division_by_zero, f->ins.at[i->b].span);
    else if (can_be_zero(k->a, f, of, i->b))
        note_doubt(k, &f->ins.at[i->b]);
}

static void look_at_function(Divide *k, const IrFn *f, const FactFlow *flow)
{
    for (size_t b = 0; b < f->blk.n; b++)
        for (size_t n = 0; flow->reached[b] && n < f->blk.at[b].ins.n; n++)
            if (f->ins.at[f->blk.at[b].ins.at[n]].op == IR_div)
                look_at_division(k, f, flow->of, &f->ins.at[f->blk.at[b].ins.at[n]]);
}

static void look_at_flow(Analysis *a, const FlowPlace *at, void *context)
{
    (void)a;
    look_at_function(context, at->f, &at->flow);
}

static void look_at_facts(Divide *k, Analysis *a)
{
    FactFlow flow;

    each_flow(a, look_at_flow, k);
    if (!a->m->sample)
        return;
    flow = facts_of_function(a->facts, a->m->sample, facts_begin_sample(a->facts));
    look_at_function(k, a->m->sample, &flow);
}

// ---- doubts ----

static bool is_doubted(const Divide *k, const Expr *divisor)
{
    for (const Doubt *d = k->doubt[k->stmt ? k->stmt->number : 0]; d; d = d->next)
        if (d->span.at == divisor->span.at && d->span.len == divisor->span.len)
            return true;
    return false;
}

// The value that is stored in place of the infinity or the NaN.
static const char *outcome(const Divide *k)
{
    const Stmt *stmt = k->stmt;
    SmType type;

    if (!stmt || stmt->kind != ST_ASSIGN || stmt->value->kind != EX_BINARY || stmt->value->op != SM_OP_DIV)
        return "an infinity, or NaN where 0 is divided";
    type = stmt->var->type;
    if (sm_type_info[type].kind == SM_KIND_FLOAT || type == SM_BOOL)
        return "an infinity, or NaN where 0 is divided, which is stored as 0";
    return format_in(k->a->arena, "an infinity, stored as %s, or NaN where 0 is divided, stored as 0",
                     const_text(k->a->arena, sm_cell_to_f64(type, sm_cell_from_f64(type, sm_div(sm_from_i32(1), sm_from_i32(0))))));
}

static void judge(void *context, const Expr *e, const Known *known)
{
    Divide *k = context;
    const Expr *divisor = e->arg[1];

    if (is_doubted(k, divisor) && !known_not_zero(k->a, known, divisor))
        diag_report(k->a->diags, DIAG_maybe_division_by_zero, divisor->span, source_text(k->a->arena, divisor->span), outcome(k));
}

static bool is_division(const Expr *e) { return e->kind == EX_BINARY && e->op == SM_OP_DIV; }

static void look_at_stmt(void *context, const Stmt *stmt, const Known *known)
{
    Divide *k = context;

    k->stmt = stmt;
    if (k->doubt[stmt->number])
        known_within(k->a, stmt->value, known, is_division, judge, k);
}

static void look_at_divisions(Analysis *a)
{
    const Program *p = a->p;
    Analysis in_range = suppose_ranges(a);
    Divide k = {a, ARENA_ARRAY(a->arena, const Doubt *, p->stmts + 1u), NULL};
    bool any = false;

    look_at_facts(&k, &in_range);
    for (size_t i = 0; i <= p->stmts; i++)
        any |= k.doubt[i] != NULL;
    for (size_t i = 0; any && i < p->window.n; i++)
        known_within(a, p->window.at[i].sample, NULL, is_division, judge, &k);
    for (size_t s = 0; any && s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            known_each(a, &p->state.at[s]->block[b], look_at_stmt, &k);
}

void analyse_division_by_zero(Analysis *a)
{
    if (a->p->operators & 1u << SM_OP_DIV)
        look_at_divisions(a);
}
