// SPDX-License-Identifier: Apache-2.0
// Reports machines that change their state in every step while their inputs are constant.
//
//   ping-pong      two states, or a few, whose conditions are true together
//   never-rests    a cycle of transitions without any condition
//   cascade        a state that is always left in its first step, by a conditional transition on the same sensor that led into it
//
// A state that is left without a condition lasts one step, which is intended.  A cycle with such a state and at least one condition is
// intended, too: it repeats an action as long as the condition is true.  It is reported only if an output changes in it.
#include <string.h>

#include "compiler/analysis/input_deps.h"
#include "compiler/analysis/trial_checks.h"

enum {
    ENTRIES_TRIED = 6,            // how many situations at the entry of a state are tried
    INPUTS_TRIED = 80,            // inputs tried from each of these situations
    STEPS_SEARCHED = 24,          // the number of last steps of a run that are searched for a cycle
    ARRIVALS_LEAST = 8,           // how often a transition must lead to a state before it can be reported as a cascade
    CYCLE_MAX = 8                 // transitions in the longest cycle
};

typedef struct CycleSearch {
    Trials *t;
    void *at;
    double *in;
    const Transition *taken[STEPS_SEARCHED];
    bool switches;                // an output has changed during the searched steps
    double *level;                // by IR variable: its value in the step before
} CycleSearch;

// Chooses the inputs of the n-th try: without commands, with one command, or with any commands.
static void choose_cycle_inputs(CycleSearch *f, const TrialEntry *e, int n)
{
    Trials *t = f->t;

    memcpy(f->in, e->in, t->inputs * sizeof *f->in);
    if (n == 0)
        return;
    trial_draw_inputs(t, f->in, NULL, n % 4 == 3, false);
    if (n % 4 == 3)
        return;
    for (uint32_t i = 0; i < t->inputs; i++)
        if (t->input[i].command)
            f->in[i] = 0;
    if (t->inputs > 0 && n % 2) {
        const uint32_t i = trial_random_below(t, t->inputs);
        if (t->input[i].command)
            f->in[i] = t->input[i].reading[trial_random_below(t, t->input[i].readings)];
    }
}

// Runs from an entry with constant inputs.  If the last steps repeat a cycle of transitions, returns the number of transitions in the
// cycle; 0 if a step took no transition, or the transitions do not repeat.
static size_t find_cycle(CycleSearch *f, const TrialEntry *e)
{
    Trials *t = f->t;
    const uint32_t counted = STEPS_SEARCHED + (t->count ? 300 : 0);      // enough steps for a counter to end the repetition
    const double *var = ir_run_vars(t->run, f->at);
    size_t n = 1;

    f->switches = false;
    trial_copy_situation(t, f->at, e->situation);
    for (uint32_t left = counted + t->window; left > 0; left--) {
        trial_step(t, f->at, f->in, t->dt, &t->trace);
        if (t->trace.transition == 0 && left <= counted)
            return 0;
        if (t->trace.transition == 0)
            continue;
        for (uint32_t v = 0; v < t->run->m->var.n; v++) {
            f->switches |= left <= STEPS_SEARCHED && t->actuator[v] && var[v] != f->level[v];
            f->level[v] = var[v];
        }
        memmove(f->taken, f->taken + 1, sizeof f->taken - sizeof *f->taken);
        f->taken[STEPS_SEARCHED - 1] = t->transition[t->trace.transition];
    }
    while (n <= CYCLE_MAX && f->taken[STEPS_SEARCHED - 1 - n] != f->taken[STEPS_SEARCHED - 1])
        n++;
    for (size_t k = 0; k < n && n <= CYCLE_MAX; k++)
        if (f->taken[STEPS_SEARCHED - 1 - k] != f->taken[STEPS_SEARCHED - 1 - k - n])
            return 0;
    return n <= CYCLE_MAX ? n : 0;
}

// Whether some condition of the transition can be unmet, so that the transition is not taken.
static bool has_undecided_condition(const Analysis *a, const Transition *x)
{
    for (const Condition *c = x->when; c; c = c->outer)
        if (c->holds ? a->stmt[c->stmt->number].otherwise : a->stmt[c->stmt->number].then)
            return true;
    return false;
}

// Reports the cycle of the last n transitions if it is not intended, at the transition whose source state is first in the file.
static void report_cycle(const CycleSearch *f, size_t n)
{
    const Analysis *a = f->t->a;
    const Transition *there = f->taken[STEPS_SEARCHED - 1], *back = there;
    size_t conditions = 0;
    Diag *d;

    for (size_t k = 0; k < n; k++) {
        const Transition *taken = f->taken[STEPS_SEARCHED - 1 - k];
        conditions += has_undecided_condition(a, taken);
        if (taken->from->number < there->from->number)
            there = taken;
    }
    for (size_t k = n; k-- > 0;)
        if (f->taken[STEPS_SEARCHED - 1 - k]->to == there->from)
            back = f->taken[STEPS_SEARCHED - 1 - k];
    if (n == 1 && conditions == 1)
        return;                               // intended: the state starts again as long as a condition is true
    if (conditions == 0) {
        d = diag_report(a->diags, DIAG_never_rests, there->stmt->span, there->from->name->text);
        for (size_t k = n; k > 0 && n > 1; k--)
            if (f->taken[STEPS_SEARCHED - k] != there)
                diag_note(a->diags, d, f->taken[STEPS_SEARCHED - k]->stmt->span, DIAG_note_goes_on,
                          f->taken[STEPS_SEARCHED - k]->from->name->text, f->taken[STEPS_SEARCHED - k]->to->name->text);
    } else if (conditions == n || (f->switches && n > 1)) {
        d = diag_report(a->diags, DIAG_ping_pong, there->stmt->span, there->from->name->text, there->to->name->text);
        diag_note(a->diags, d, back->stmt->span, DIAG_note_transition_back, condition_text(a->arena, back->when));
    }
}

// Finds states that follow each other at every step while nothing changes.
void check_ping_pong(Trials *t)
{
    CycleSearch f = {.t = t, .at = arena_alloc(t->a->arena, t->run->size), .in = trial_new_inputs(t)};

    f.level = ARENA_ARRAY(t->a->arena, double, t->run->m->var.n);
    for (size_t s = 0; s < t->a->p->state.n; s++)
        for (size_t n = 0; n < t->state[s].entry.n && n < ENTRIES_TRIED; n++)
            for (int k = 0; k < INPUTS_TRIED; k++) {
                size_t cycle;
                choose_cycle_inputs(&f, &t->state[s].entry.at[n], k);
                cycle = find_cycle(&f, &t->state[s].entry.at[n]);
                if (cycle > 0)
                    report_cycle(&f, cycle);
            }
}

// ---- cascades ----

// Whether `out` depends only on sensors and time, and shares at least one sensor with `in`.
static bool shares_sensor(const InputDepsTable *s, const Transition *in, const Transition *out)
{
    const InputDeps by = input_deps_of_condition(s, in->when), then = input_deps_of_condition(s, out->when);
    bool shared = false;

    for (uint32_t i = 0; i < then.n; i++)
        shared |= input_deps_include(&by, then.sensor[i]);
    return shared && !then.input;
}

// Finds states that are left again at once.
void check_cascade(Trials *t)
{
    const Analysis *a = t->a;
    const InputDepsTable *s = input_deps_of(t->a);

    for (size_t i = 0; i < a->transition.n; i++) {
        const Transition *in = &a->transition.at[i], *out;
        const TrialNext next = t->next[in->stmt->number];
        Diag *d;
        if (!in->when || next.trials < ARRIVALS_LEAST || next.left < next.trials || next.most <= 0)
            continue;
        out = t->transition[next.transition];
        if (!has_undecided_condition(a, out) || !shares_sensor(s, in, out) || out->to == in->from || out->to == out->from ||
            in->to == in->from)
            continue;
        d = diag_report(a->diags, DIAG_cascade, out->stmt->span, out->from->name->text, condition_text(a->arena, in->when));
        diag_note(a->diags, d, in->stmt->span, DIAG_note_led_here, in->from->name->text);
    }
}
