// SPDX-License-Identifier: Apache-2.0
// Reports divisions by a value that is always 0, and by a value that can be 0 because no stored value, guard or @range of a sensor
// excludes 0.
//
// Facts describe one variable at a time.  A guard can relate two variables (with `a > b`, a - b is not 0) or limit an expression
// (with `abs(d) > 0.1`, d is not 0).  Where the facts do not exclude 0, such relations are searched in the guards themselves.
#include "compiler/analysis/analysis.h"
#include "compiler/analysis/assume.h"
#include "compiler/analysis/decided_comparison.h"
#include "compiler/analysis/guards_known.h"

#include "stdlib/convert.h"
#include "stdlib/math.h"

typedef struct PossibleZero PossibleZero;
struct PossibleZero {                    // a divisor that can be 0 according to the facts
    Span span;
    const PossibleZero *next;            // the next divisor of the same statement that can be 0
};

typedef struct Divisions {
    Analysis *a;
    const PossibleZero **possible;       // by Stmt.number: list of the statement's divisors that can be 0; [0]: of those in samples of windows
    const Stmt *stmt;                    // the current statement; NULL: the sample of a window is checked
} Divisions;

// ---- facts ----

static bool contains_zero(Fact f) { return f.lo <= 0 && f.hi >= 0; }

// Whether temporary r can be 0 according to the facts `of`.  Ignores underflow: a product is assumed to be 0 only if a factor can be 0.
static bool can_be_zero(const Analysis *a, const IrFn *f, const Fact *of, IrRef r)
{
    const IrIns *i = &f->ins.at[r];

    if (!contains_zero(of[r]))
        return false;
    switch ((int)i->op) {
    case IR_mul: return can_be_zero(a, f, of, i->a) || can_be_zero(a, f, of, i->b);
    case IR_div: case IR_neg: case IR_abs: case IR_sqrt: case IR_cvt: return can_be_zero(a, f, of, i->a);
    case IR_stat: return i->stat == SM_STAT_RANGE || contains_zero(facts_of_window(a->facts, i->var));
    }
    return true;
}

// Reports divisors that are always 0, and records divisors that can be 0 in k->possible.
static void check_function(Divisions *k, const IrFn *f, const FactFlow *flow)
{
    for (size_t b = 0; b < f->blk.n; b++)
        for (size_t n = 0; flow->reached[b] && n < f->blk.at[b].ins.n; n++) {
            const IrIns *i = &f->ins.at[f->blk.at[b].ins.at[n]], *divisor;
            Fact by;
            if (i->op != IR_div)
                continue;
            divisor = &f->ins.at[i->b];
            by = flow->of[i->b];
            if (by.lo == 0 && by.hi == 0 && !by.nan) {
                diag_report(k->a->diags, DIAG_division_by_zero, divisor->span);
            } else if (can_be_zero(k->a, f, flow->of, i->b)) {
                PossibleZero *p = ARENA_NEW(k->a->arena, PossibleZero);
                *p = (PossibleZero){divisor->span, k->possible[divisor->stmt]};
                k->possible[divisor->stmt] = p;
            }
        }
}

// Whether a divisor of the function can be 0.
static bool has_zero_divisor(const Analysis *a, const IrFn *f, const FactFlow *flow)
{
    for (size_t b = 0; b < f->blk.n; b++)
        for (size_t n = 0; flow->reached[b] && n < f->blk.at[b].ins.n; n++) {
            const IrIns *i = &f->ins.at[f->blk.at[b].ins.at[n]];
            if (i->op == IR_div && can_be_zero(a, f, flow->of, i->b))
                return true;
        }
    return false;
}

// Sets *context, a bool, if a divisor of the function can be 0.
static void find_zero_divisor(Analysis *a, const ReachableFn *r, void *context)
{
    *(bool *)context |= has_zero_divisor(a, r->fn, &r->flow);
}

// Whether some divisor can be 0, whatever the sensors read.  If none can, the facts about sensors within their ranges are not needed.
static bool can_divide_by_zero(Analysis *a)
{
    bool any = false;

    if (a->m->sample) {
        const FactFlow flow = facts_of_function(a->facts, a->m->sample, facts_at_begin_of_sample(a->facts));
        any = has_zero_divisor(a, a->m->sample, &flow);
    }
    if (!any)
        each_reachable_fn(a, find_zero_divisor, &any);
    return any;
}

static void check_reachable_function(Analysis *a, const ReachableFn *r, void *context)
{
    (void)a;
    check_function(context, r->fn, &r->flow);
}

// ---- guards ----

// Describes the result of a division by 0 for the diagnostic, and what an assignment stores instead of it.
static const char *describe_quotient(const Divisions *k)
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

static void check_divisor(void *context, const Expr *e, const KnownGuard *known)
{
    Divisions *k = context;
    const Span divisor = e->arg[1]->span;
    bool can_be_zero_by_facts = false;

    for (const PossibleZero *d = k->possible[k->stmt ? k->stmt->number : 0]; d; d = d->next)
        can_be_zero_by_facts |= d->span.at == divisor.at && d->span.len == divisor.len;
    if (can_be_zero_by_facts && !guards_exclude_zero(k->a, known, e->arg[1]))
        diag_report(k->a->diags, DIAG_maybe_division_by_zero, divisor, source_text(k->a->arena, divisor), describe_quotient(k));
}

static bool is_division(const Expr *e) { return e->kind == EX_BINARY && e->op == SM_OP_DIV; }

static void check_stmt(void *context, const Stmt *stmt, const KnownGuard *known)
{
    Divisions *k = context;

    k->stmt = stmt;
    if (k->possible[stmt->number])
        guards_known_each_expr(k->a, stmt->value, known, is_division, check_divisor, k);
}

void analyse_division_by_zero(Analysis *a)
{
    const Program *p = a->p;
    Divisions k = {a, ARENA_ARRAY(a->arena, const PossibleZero *, p->stmts + 1u), NULL};
    Analysis in_range;
    bool any = false;

    if (!(p->operators & 1u << SM_OP_DIV) || !can_divide_by_zero(a))
        return;
    in_range = assume_ranges(a);
    each_reachable_fn(&in_range, check_reachable_function, &k);
    if (a->m->sample) {
        const FactFlow flow = facts_of_function(in_range.facts, a->m->sample, facts_at_begin_of_sample(in_range.facts));
        check_function(&k, a->m->sample, &flow);
    }
    for (size_t i = 0; i <= p->stmts; i++)
        any |= k.possible[i] != NULL;
    for (size_t i = 0; any && i < p->window.n; i++)
        guards_known_each_expr(a, p->window.at[i].sample, NULL, is_division, check_divisor, &k);
    for (size_t s = 0; any && s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            guards_known_each_stmt(a, &p->state.at[s]->block[b], check_stmt, &k);
}
