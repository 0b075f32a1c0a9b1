// SPDX-License-Identifier: Apache-2.0
// Reports two limits of one value that switch a variable on and off in the same step: a hysteresis whose limits are exchanged.
//
//     temperature > 95: valve = true           # between 95 and 98 both are true, and the second assignment wins
//     temperature < 98: valve = false
//
// Proved from the statements: both guards are one comparison of the same expression with a constant, in opposite directions, and some value makes
// both true.  They are in one list, and nothing between them assigns what they read, reads what they assign or leaves the state.  One of the two
// constants is 0: of two numbers, as of zones, the second can be an exception from the first.
#include "compiler/analysis/analysis.h"
#include "stdlib/math.h"

// A conditional `value > limit: variable = constant`, with the four comparisons.
typedef struct LimitStore {
    const Stmt *conditional, *store;
    const Expr *value;
    double limit;
    bool above;                   // the guard is true above the limit; false: below
} LimitStore;

// Fills in the comparison, if the guard is one.
static bool find_limit(const Expr *guard, LimitStore *l)
{
    Comparison c;

    if (comparison_count(guard) != 1)
        return false;
    c = comparison_at(guard, 0);
    if (expr_is_constant(c.a)) {
        const Comparison swapped = {c.b, c.a, comparison_swapped(c.op)};
        c = swapped;
    }
    if (!expr_is_constant(c.b) || expr_is_constant(c.a) || c.op == SM_OP_EQ || c.op == SM_OP_NE)
        return false;
    l->value = c.a;
    l->limit = expr_constant_value(c.b);
    l->above = c.op == SM_OP_GT || c.op == SM_OP_GE;
    return true;
}

// Returns the first assignment of a constant among the statements of the conditional; NULL: they assign no constant.
static const Stmt *find_constant_store(const Stmt *conditional)
{
    for (size_t i = 0; i < conditional->then.n; i++)
        if (conditional->then.at[i]->kind == ST_ASSIGN && expr_is_constant(conditional->then.at[i]->value))
            return conditional->then.at[i];
    return NULL;
}

static bool find_limit_store(const Stmt *s, LimitStore *l)
{
    if (s->kind != ST_IF || s->otherwise.n > 0 || always_leaves(&s->then) || !find_limit(s->value, l))
        return false;
    l->conditional = s;
    l->store = find_constant_store(s);
    return l->store != NULL;
}

// Whether the statement leaves the state, assigns something that the value depends on, or reads the variable that the limit assigns.
static bool ends_comparison(const Stmt *s, const LimitStore *x)
{
    bool ends = s->kind == ST_TRANSITION || (s->kind == ST_ASSIGN && expr_reads(x->value, s->var)) ||
                (s->value && expr_reads(s->value, x->store->var));

    for (size_t i = 0; i < s->then.n && !ends; i++)
        ends = ends_comparison(s->then.at[i], x);
    for (size_t i = 0; i < s->otherwise.n && !ends; i++)
        ends = ends_comparison(s->otherwise.at[i], x);
    return ends;
}

static bool overlap(const Analysis *a, const LimitStore *x, const LimitStore *y)
{
    const double low = x->above ? x->limit : y->limit, high = x->above ? y->limit : x->limit;

    return x->above != y->above && low < high && x->store->var == y->store->var && expr_equal(x->value, y->value, a->m->window_of) &&
           sm_to_bool(expr_constant_value(x->store->value)) != sm_to_bool(expr_constant_value(y->store->value)) &&
           a->stmt[x->store->number].reached && a->stmt[y->store->number].reached;
}

static void report_overlap(const Analysis *a, const LimitStore *x, const LimitStore *y)
{
    const double low = x->above ? x->limit : y->limit, high = x->above ? y->limit : x->limit;
    const char *value = source_text(a->arena, x->value->span);
    Diag *d = diag_report(a->diags, DIAG_overlapping_limits, y->store->span, y->store->var->name->text, const_text(a->arena, low),
                          value, const_text(a->arena, high));

    diag_note(a->diags, d, x->store->span, DIAG_note_overwritten_after, x->store->var->name->text);
}

static void check_list(const Analysis *a, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        LimitStore x, y;
        bool ended = !find_limit_store(list->at[i], &x);
        for (size_t n = i + 1; n < list->n && !ended; n++) {
            if (find_limit_store(list->at[n], &y) && overlap(a, &x, &y)) {
                report_overlap(a, &x, &y);
                break;
            }
            ended = ends_comparison(list->at[n], &x);
        }
        check_list(a, &list->at[i]->then);
        check_list(a, &list->at[i]->otherwise);
    }
}

void analyse_overlapping_limits(Analysis *a)
{
    for (size_t s = 0; s < a->p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            check_list(a, &a->p->state.at[s]->block[b]);
}
