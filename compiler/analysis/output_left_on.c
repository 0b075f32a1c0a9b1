// SPDX-License-Identifier: Apache-2.0
// Reports outputs that stay on in a state where the machine may stay forever: a state marked @safe, or a state that only a command ends.
//
// Starts from every situation that the search (trial.h) found at the entry of such a state, with constant inputs for which the machine
// stays in the state.  Reports an output that another state switched on and that is still on when nothing changes any more.
#include <string.h>

#include "compiler/analysis/trial_checks.h"

enum {
    INPUTS_TRIED = 10,            // inputs tried in each situation
    OUTPUTS_NAMED = 4             // outputs named in one finding
};

typedef struct LeftOnSearch {
    Trials *t;
    void *at;                     // the current situation of the run
    double *in;                   // the inputs of the run, by input
    const Var *output[OUTPUTS_NAMED];   // the outputs found on in the current state
    const Stmt *on[OUTPUTS_NAMED];      // by entry of `output`: the statement that switched the output on
    const Transition *via[OUTPUTS_NAMED];         // by entry of `output`: the transition into the state
    uint32_t outputs;
} LeftOnSearch;

// Whether some reachable assignment can set v to 0.
static bool is_ever_switched_off(const Trials *t, const Var *v)
{
    for (uint32_t n = 1; n <= t->a->p->stmts; n++) {
        const Stmt *s = t->stmt[n];
        const StmtFact *f = &t->a->stmt[n];
        if (s && s->kind == ST_ASSIGN && s->var == v && f->reached && f->value.lo <= 0 && f->value.hi >= 0)
            return true;
    }
    return false;
}

// ---- findings ----

// Reports a state, with the outputs that are on and the transition into the state.
static void report_outputs(const LeftOnSearch *l, const State *s)
{
    const Analysis *a = l->t->a;
    Diag *d = diag_report(a->diags, DIAG_output_left_on, s->span, s->name->text, trial_check_join_names(a->arena, l->output, l->outputs));

    for (uint32_t i = 0; i < l->outputs; i++) {
        l->t->rests_on[a->m->var_of[l->output[i]->index]] = true;
        diag_note_declaration(a->diags, d, DIAG_OUTPUTS, l->output[i]->span);
        diag_note_step(a->diags, d, l->on[i]->span, DIAG_note_switched_on, l->output[i]->name->text);
        diag_note_step(a->diags, d, l->via[i]->stmt->span, DIAG_note_still_on, l->output[i]->name->text, s->name->text);
        if (!is_ever_switched_off(l->t, l->output[i]))
            diag_note(a->diags, d, (Span){0}, DIAG_note_never_off, l->output[i]->name->text);
    }
}

// Runs with constant inputs until no timer or counter can change anything any more.  Returns false if the machine leaves the state.
static bool hold_inputs_in_state(LeftOnSearch *l, uint32_t state)
{
    Trials *t = l->t;

    for (uint32_t n = t->window + 5; n > 0; n--) {
        trial_step(t, l->at, l->in, t->dt, &t->trace);
        if (trial_state(l->at) != state)
            return false;
    }
    for (int n = 0, idle = 0; n < TRIAL_ADVANCES && idle < 2; n++) {
        idle = trial_advance_to_event(t, l->at, l->in, &t->trace) ? 0 : idle + 1;
        if (trial_state(l->at) != state)
            return false;
    }
    return true;
}

// Whether the output is intended to be on: the branch that switches it on also contains the transition into the state.
static bool is_intended(const Trials *t, const Stmt *on, const Transition *via)
{
    const Condition *when = t->when[on->number];

    return when && via->when && when->stmt == via->when->stmt && when->holds == via->when->holds;
}

// Adds the outputs that are on now and were switched on by another state.  Returns whether there are any.
static bool add_outputs_on(LeftOnSearch *l, const TrialEntry *e, const State *s)
{
    Trials *t = l->t;
    const double *var = ir_run_vars(t->run, l->at);
    const uint32_t *writer = ir_run_writers(t->run, l->at);
    bool any = false;

    for (uint32_t v = 0; v < t->run->m->var.n; v++) {
        const Stmt *on = t->actuator[v] && var[v] != 0 ? t->stmt[writer[v]] : NULL;
        uint32_t i = 0;
        if (!on || t->state_of[on->number] == s || is_intended(t, on, e->via))
            continue;
        any = true;
        while (i < l->outputs && l->output[i] != t->var[v])
            i++;
        if (i < l->outputs || i == OUTPUTS_NAMED)
            continue;
        l->output[i] = t->var[v];
        l->on[i] = on;
        l->via[i] = e->via;
        l->outputs++;
    }
    return any;
}

// Tries several inputs from e, a situation at the entry of the state, until outputs are found that stay on.
static void try_entry(LeftOnSearch *l, const State *s, const TrialEntry *e)
{
    Trials *t = l->t;

    for (int n = 0; n < INPUTS_TRIED && trial_may_continue(t); n++) {
        trial_copy_situation(t, l->at, e->situation);
        memcpy(l->in, e->in, t->inputs * sizeof *l->in);
        for (uint32_t i = 0; i < t->inputs && n > 0; i++)
            if (t->input[i].command)
                l->in[i] = 0;
        if (n > 1)
            trial_draw_inputs(t, l->in, &t->state[s->number - 1], n % 2, false);
        if (hold_inputs_in_state(l, s->number) && add_outputs_on(l, e, s))
            return;
    }
}

// Whether some trial leaves the state without a command.  Also true if not all trials could be run.
static bool can_end_without_command(LeftOnSearch *l, const State *s)
{
    Trials *t = l->t;
    const TrialState *ts = &t->state[s->number - 1];

    for (size_t n = 0; n < ts->entry.n && n < 4; n++)
        for (int k = 0; k < 4 * INPUTS_TRIED; k++) {
            trial_copy_situation(t, l->at, ts->entry.at[n].situation);
            memcpy(l->in, ts->entry.at[n].in, t->inputs * sizeof *l->in);
            trial_draw_inputs(t, l->in, ts, false, true);
            if (!trial_may_continue(t) || !hold_inputs_in_state(l, s->number))
                return true;
        }
    return false;
}

// Finds outputs that stay on where the machine rests.
void check_output_left_on(Trials *t)
{
    LeftOnSearch l = {.t = t, .at = arena_alloc(t->a->arena, t->run->size), .in = trial_new_inputs(t)};

    for (size_t s = 0; s < t->a->p->state.n; s++) {
        const State *state = t->a->p->state.at[s];
        if (t->state[s].entry.n == 0 || (!state->is_safe && can_end_without_command(&l, state)))
            continue;
        l.outputs = 0;
        for (size_t n = 0; n < t->state[s].entry.n; n++)
            if (t->state[s].entry.at[n].via)
                try_entry(&l, state, &t->state[s].entry.at[n]);
        if (l.outputs > 0)
            report_outputs(&l, state);
    }
}
