// SPDX-License-Identifier: Apache-2.0
// Reports states that lack an abort that other states have:
//
//   - on a bool input, such as a button, on which nearly all other states abort, also one that follows.  Where no state that follows aborts on
//     it either, as in a last state that vents, the danger can be over;
//   - on a condition on which every state before it and every state after it aborts.  What [all_states] aborts on does not count: there the
//     author has named the states that are excepted.
//
// That is read from the guards of the paths in the abort matrix, through definitions and windows.  An input that is stored in a local says
// nothing here: a later guard can read that local instead.
#include "compiler/analysis/abort.h"
#include "compiler/analysis/trial_checks.h"

enum {
    OTHERS_LEAST = 3,             // a state that does not abort on the input is reported only if at least this many others do
    OTHERS_FOR_EACH = 3           // and at least this many for each state that does not
};

static bool any_reads(const Condition *when, const Var *v)
{
    bool any = false;

    for (; when && !any; when = when->outer)
        any = expr_reads(when->stmt->value, v);
    return any;
}

// Whether an assignment to a local depends on the input: by its value, or by a guard around it.
static bool is_stored(const Trials *t, const Var *input)
{
    for (uint32_t n = 1; n <= t->a->p->stmts; n++) {
        const Stmt *s = t->stmt[n];
        if (s && s->kind == ST_ASSIGN && s->var->kind == VAR_LOCAL && (expr_reads(s->value, input) || any_reads(t->when[n], input)))
            return true;
    }
    return false;
}

const AbortPath *abort_path_that_reads(const AbortRow *r, const Var *input)
{
    for (size_t k = 0; k < r->path.n; k++)
        if (abort_is_bounded(&r->path.at[k]) && any_reads(r->path.at[k].first->when, input))
            return &r->path.at[k];
    return NULL;
}

// Whether a missing abort in the state can be a mistake: the machine reaches the state, which is neither an @abort state nor @safe.
static bool can_need_abort(const AbortRow *r)
{
    return r->verdict != ABORT_ITSELF && r->verdict != ABORT_UNREACHED && !r->state->is_safe;
}

// Whether some transition leads to a state that aborts on the input.
static bool is_followed_by_abort_on(const Analysis *a, const AbortMatrix *x, const AbortRow *r, const Var *input)
{
    bool any = false;

    for (size_t i = 0; i < a->transition.n && !any; i++)
        any = a->transition.at[i].from == r->state && a->stmt[a->transition.at[i].stmt->number].reached &&
              abort_path_that_reads(&x->row[a->transition.at[i].to->number - 1], input) != NULL;
    return any;
}

// Whether an output is on in the state: in some trial, or because a statement of the state switches it on.
static bool has_output_on(const Trials *t, const AbortRow *r)
{
    bool any = r->drives;

    for (uint32_t n = 1; n <= t->a->p->stmts && !any; n++) {
        const Stmt *s = t->stmt[n];
        const StmtFact *f = &t->a->stmt[n];
        any = s && s->kind == ST_ASSIGN && t->state_of[n] == r->state && t->actuator[t->a->m->var_of[s->var->index]] && f->reached &&
              (f->value.lo < 0 || f->value.hi > 0);
    }
    return any;
}

// Whether the state must be reported if enough other states abort on the input.
static bool lacks_abort(const Trials *t, const AbortMatrix *x, const AbortRow *r, const Var *input)
{
    return can_need_abort(r) && has_output_on(t, r) && !abort_path_that_reads(r, input) && is_followed_by_abort_on(t->a, x, r, input);
}

// Reports the states that do not abort on this input although other states do.
static void report_states_without(Trials *t, const AbortMatrix *x, const Var *input)
{
    Analysis *a = t->a;
    const AbortPath *example = NULL;
    size_t with = 0, without = 0;

    for (size_t s = 0; s < x->n; s++) {
        const AbortPath *path = can_need_abort(&x->row[s]) ? abort_path_that_reads(&x->row[s], input) : NULL;
        example = example ? example : path;
        with += path != NULL;
        without += lacks_abort(t, x, &x->row[s], input);
    }
    if (with < OTHERS_LEAST || with < OTHERS_FOR_EACH * without)
        return;
    for (size_t s = 0; s < x->n; s++) {
        const AbortRow *r = &x->row[s];
        Diag *d;
        if (!lacks_abort(t, x, r, input))
            continue;
        d = diag_report(a->diags, DIAG_abort_skips_input, r->state->span, r->state->name->text, input->name->text,
                        format_in(a->arena, "%lu", (unsigned long)with));
        diag_note(a->diags, d, example->first->stmt->span, DIAG_note_aborts_on_input, example->first->from->name->text, input->name->text);
    }
}

// ---- conditions ----

// Returns the innermost guard of the path if the state itself contains it, and it reads an input; else NULL.
static const Expr *guard_of_state(const AbortPath *path)
{
    const Condition *when = path->first->when;
    const bool counts = when && when->holds && path->possible && abort_is_bounded(path) && (path->sensors > 0 || path->by_input);

    return counts && !when->stmt->span.src->copy_of ? when->stmt->value : NULL;
}

static bool aborts_on(const Trials *t, const AbortRow *r, const Expr *guard)
{
    bool any = false;

    for (size_t k = 0; k < r->path.n && !any; k++) {
        const Expr *own = guard_of_state(&r->path.at[k]);
        any = own && expr_equal(own, guard, t->a->m->window_of);
    }
    return any;
}

// Whether the state has an abort, by any guard, that depends on a sensor of `path`.  Also true if `path` depends on no sensor, because
// report_states_without judges paths that depend on buttons.
static bool aborts_on_same_inputs(const AbortRow *r, const AbortPath *path)
{
    for (size_t k = 0; k < r->path.n; k++) {
        const AbortPath *own = &r->path.at[k];
        for (size_t i = 0; i < own->sensors; i++)
            for (size_t n = 0; n < path->sensors; n++)
                if (own->sensor[i] == path->sensor[n] && abort_is_bounded(own))
                    return true;
    }
    return path->sensors == 0;
}

// Whether all predecessors of the state, and all its successors, abort on the guard; @abort states are not considered.  False if the state has no
// predecessor or no successor.
static bool is_between_aborts_on(const Trials *t, const AbortMatrix *x, const AbortRow *r, const Expr *guard)
{
    size_t before = 0, after = 0;

    for (size_t i = 0; i < t->a->transition.n; i++) {
        const Transition *step = &t->a->transition.at[i];
        const State *other = step->to == r->state ? step->from : step->to;
        if ((step->from == r->state) == (step->to == r->state) || !t->a->stmt[step->stmt->number].reached ||
            x->row[other->number - 1].verdict == ABORT_ITSELF)
            continue;
        if (!aborts_on(t, &x->row[other->number - 1], guard))
            return false;
        before += step->to == r->state;
        after += step->from == r->state;
    }
    return before > 0 && after > 0;
}

// Reports abort paths that the state of `before` has and the state of r lacks.  A transition leads from `before` to r.
static void report_missing_guards(Trials *t, const AbortMatrix *x, const AbortRow *r, const AbortRow *before)
{
    Analysis *a = t->a;

    for (size_t k = 0; k < before->path.n; k++) {
        const AbortPath *path = &before->path.at[k];
        const Expr *guard = guard_of_state(path);
        Diag *d;
        if (!guard || aborts_on_same_inputs(r, path) || !is_between_aborts_on(t, x, r, guard))
            continue;
        d = diag_report(a->diags, DIAG_abort_skips_guard, r->state->span, r->state->name->text, source_text(a->arena, guard->span));
        diag_note(a->diags, d, path->first->stmt->span, DIAG_note_aborts_on_input, before->state->name->text,
                  source_text(a->arena, guard->span));
    }
}

static void report_states_between(Trials *t, const AbortMatrix *x)
{
    for (size_t i = 0; i < t->a->transition.n; i++) {
        const Transition *step = &t->a->transition.at[i];
        const AbortRow *r = &x->row[step->to->number - 1];
        if (step->from != step->to && can_need_abort(r) && has_output_on(t, r))
            report_missing_guards(t, x, r, &x->row[step->from->number - 1]);
    }
}

void abort_report_skipped_inputs(Trials *t, const AbortMatrix *x)
{
    for (size_t v = 0; v < t->a->p->var.n; v++) {
        const Var *input = t->a->p->var.at[v];
        if (input->kind == VAR_ELEMENT && input->type == SM_BOOL && !input->written && !is_stored(t, input))
            report_states_without(t, x, input);
    }
    report_states_between(t, x);
}
