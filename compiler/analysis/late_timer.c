// SPDX-License-Identifier: Apache-2.0
// Reports a guard that waits for a T which its state never reaches, because a shorter time limit ends the state whatever else is true.
//
//     T > 5000 and cold: -> Ready              # never true
//     T > 120: -> Abort                        # ends the state after 120 ms
//
// Needs the step: then T takes the values 0, step, 2 * step, ...  A guard below the limit that the limit implies is reported as a shadowed
// transition; this one also finds guards above it.  Guards of [all_states] are not judged: a general limit can be longer than a state.  Nor is a
// machine with an @mode: T can be any time later when it steps again, and the guard above the limit is then the first one that is true.
#include "compiler/analysis/analysis.h"
#include "stdlib/math.h"

// The first value of T in which a time limit ends the state.
typedef struct StateEnd { const Stmt *stmt; double last; } StateEnd;

typedef struct LateTimerCheck { Analysis *a; StateEnd end; } LateTimerCheck;

// Returns the smallest multiple of the step for which `T op limit` is true; a negative number: no T
// makes it true, or the comparison has another form.
static double first_true(const LateTimerCheck *k, const Comparison *c)
{
    const double step = (double)k->a->step;
    double n;

    if (c->a->kind != EX_VAR || c->a->var != k->a->p->t || !expr_is_constant(c->b) || (c->op != SM_OP_GT && c->op != SM_OP_GE))
        return -1;
    n = sm_ceil(expr_constant_value(c->b) / step);
    if (c->op == SM_OP_GT && n * step == expr_constant_value(c->b))
        n += 1;
    return n > 0 ? n * step : 0;
}

static double first_true_of_guard(const LateTimerCheck *k, const Expr *e)
{
    Comparison c;

    if (comparison_count(e) != 1)
        return -1;
    c = comparison_at(e, 0);
    if (c.b->kind == EX_VAR) {
        const Comparison swapped = {c.b, c.a, comparison_swapped(c.op)};
        c = swapped;
    }
    return first_true(k, &c);
}

// Returns the first value of T from which the guard is true whatever else is; a negative number: none is known.
static double end_of_guard(const LateTimerCheck *k, const Expr *e)
{
    double x, y;

    if (e->kind != EX_BINARY || e->op != SM_OP_OR)
        return first_true_of_guard(k, e);
    x = end_of_guard(k, e->arg[0]);
    y = end_of_guard(k, e->arg[1]);
    return x < 0 ? y : y < 0 || x < y ? x : y;
}

static StateEnd find_end(const LateTimerCheck *k, const State *s)
{
    const Stmts *list = &s->block[BLOCK_STEP];
    StateEnd end = {NULL, -1};

    for (size_t i = 0; i < list->n; i++) {
        const Stmt *c = list->at[i];
        const double last = c->kind == ST_IF && always_leaves(&c->then) ? end_of_guard(k, c->value) : -1;
        if (last >= 0 && (!end.stmt || last < end.last)) {
            end.stmt = c;
            end.last = last;
        }
    }
    return end;
}

// Reports the comparisons of T in a conjunction that are never true before the state ends.
static void check_guard(LateTimerCheck *k, const Stmt *s, const Expr *e)
{
    double first;
    Diag *d;

    if (e->kind == EX_BINARY && e->op == SM_OP_AND) {
        check_guard(k, s, e->arg[0]);
        check_guard(k, s, e->arg[1]);
        return;
    }
    first = first_true_of_guard(k, e);
    if (first <= k->end.last || s == k->end.stmt)
        return;
    d = diag_report(k->a->diags, DIAG_late_timer, s->value->span, source_text(k->a->arena, e->span), const_text(k->a->arena, k->end.last));
    diag_note(k->a->diags, d, k->end.stmt->value->span, DIAG_note_ends_state);
}

static void check_list(LateTimerCheck *k, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->kind != ST_IF)
            continue;
        if (k->a->stmt[s->number].then && !s->span.src->copy_of)
            check_guard(k, s, s->value);
        check_list(k, &s->then);
        check_list(k, &s->otherwise);
    }
}

void analyse_late_timer(Analysis *a)
{
    LateTimerCheck k = {.a = a};

    for (size_t i = 0; i < a->p->state.n && a->step > 0 && !a->pauses; i++) {
        const State *s = a->p->state.at[i];
        k.end = find_end(&k, s);
        if (k.end.stmt)
            check_list(&k, &s->block[BLOCK_STEP]);
    }
}
