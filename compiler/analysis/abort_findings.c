// SPDX-License-Identifier: Apache-2.0
// Reports states that cannot abort, or not if one sensor fails, or not without a command.  Derives the findings from the abort matrix: at
// most one per state and kind.
#include "compiler/analysis/abort.h"
#include "compiler/analysis/trial_checks.h"

enum { PATHS_SHOWN = 3, STATES_FOLLOWED = 50 };       // the most notes in one finding; the most states of a path that are followed to its end

// Returns the @abort state at the end of the longest path from s.
static const State *follow_to_abort_state(const AbortMatrix *x, const State *s)
{
    for (int i = 0; i < STATES_FOLLOWED && !s->is_abort; i++)
        s = abort_next_state(x, s);
    return s;
}

// Adds a note for each transition that starts a path to an @abort state and depends on the sensor.  If several are inside one guard, only
// the first gets a note.
static void note_paths(Analysis *a, Diag *d, const AbortMatrix *x, const AbortRow *r, const Var *sensor)
{
    const char *name = sensor->name->text;
    const Stmt *last = NULL;
    size_t shown = 0;

    for (size_t k = 0; k < r->path.n && shown < PATHS_SHOWN; k++) {
        const AbortPath *path = &r->path.at[k];
        const Condition *when = abort_is_bounded(path) ? input_deps_find_condition(x->deps, path->first->when, sensor) : NULL;
        const State *to = path->first->to;
        const Stmt *store;
        if (!when || when->stmt == last)
            continue;
        store = input_deps_find_indirect_store(x->deps, when->stmt->value, sensor);
        if (to->is_abort)
            diag_note(a->diags, d, when->stmt->span, DIAG_note_abort_transition, to->name->text, name);
        else
            diag_note(a->diags, d, when->stmt->span, DIAG_note_abort_transitions, to->name->text, follow_to_abort_state(x, to)->name->text, name);
        if (store)
            diag_note(a->diags, d, store->span, DIAG_note_made_of_sensor, store->var->name->text, name);
        last = when->stmt;
        shown++;
    }
}

// Reports everything that is wrong with one state's ability to abort.
static void report_row(Analysis *a, const AbortMatrix *x, const AbortRow *r)
{
    const Span span = r->state->span;
    const char *state = r->state->name->text;
    Diag *d;

    if (r->state->is_safe && !r->drives)
        return;                                       // a safe state with all outputs off needs no abort
    if (r->verdict == ABORT_NO_PATH && r->drives && !r->state->is_safe)
        diag_report(a->diags, DIAG_abort_missing, span, state);      // not for ABORT_LATER: the machine can abort from a later state
    if (r->verdict == ABORT_BY_COMMAND && r->drives)
        diag_report(a->diags, DIAG_abort_by_command, span, state);
    if (r->latch)
        diag_report(a->diags, DIAG_abort_latched, r->latched->first->stmt->span, state, r->latch->name->text,
                    const_text(a->arena, r->latched_at));
    if (r->verdict == ABORT_ONE_SENSOR && r->blind) {
        d = diag_report(a->diags, DIAG_abort_blind, span, state, r->blind->name->text, r->blind_at);
        note_paths(a, d, x, r, r->blind);
        diag_note(a->diags, d, (Span){0}, DIAG_note_abort_blind_advice, r->blind->name->text);
    }
    if (r->verdict == ABORT_ONE_SENSOR && r->single) {
        d = diag_report(a->diags, DIAG_abort_single_sensor, span, state, r->single->name->text, const_text(a->arena, r->stuck));
        note_paths(a, d, x, r, r->single);
        diag_note(a->diags, d, (Span){0}, DIAG_note_abort_single_advice);
    }
}

// Finds states that cannot abort, or not if one sensor fails, or not without a person.
void check_abort(Trials *t)
{
    const AbortMatrix x = abort_build_matrix(t);

    for (size_t s = 0; s < x.n && x.declared; s++)
        report_row(t->a, &x, &x.row[s]);
    if (x.declared)
        abort_report_skipped_inputs(t, &x);
}
