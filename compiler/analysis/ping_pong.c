// SPDX-License-Identifier: Apache-2.0
// Reports machines that change their state in every step while their inputs are constant.
//
//   ping-pong      two states, or a few, whose conditions are true together; also if counters delay each of them by a few steps
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
    STEPS_SEARCHED = 24,          // the number of last transitions of a run that are searched for a cycle
    ARRIVALS_LEAST = 8,           // how often a transition must lead to a state before it can be reported as a cascade
    CYCLE_MAX = 8,                // transitions in the longest cycle
    PAUSE_MAX = 20                // steps between two transitions of a cycle that counters delay
};

typedef struct CycleSearch {
    Trials *t;
    void *at;                     // the current situation of the run
    double *in;                   // the inputs of the run, by input
    const Transition *taken[STEPS_SEARCHED];      // the last transitions of the run, the newest last; NULL: fewer were taken
    uint32_t at_step[STEPS_SEARCHED];     // the number of the step in which each of these transitions was taken
    bool switches;                // an output has changed during the steps that are searched
    double *level;                // by IR variable: its value after the last transition
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

// Runs from an entry with constant inputs, and stores the last transitions.  Returns false if, when windows are full, more than `pause` steps
// follow a transition before the next one.
static bool run_transitions(CycleSearch *f, const TrialEntry *e, uint32_t pause)
{
    Trials *t = f->t;
    // Enough steps for a counter to end the repetition, and then for the transitions that are searched.
    const uint32_t steps = t->window + (t->count ? 300 : 0) + STEPS_SEARCHED * (1 + pause), searched = steps - STEPS_SEARCHED * (1 + pause);
    const double *var = ir_run_vars(t->run, f->at);
    uint32_t last = 0;

    f->switches = false;
    memset(f->taken, 0, sizeof f->taken);
    trial_copy_situation(t, f->at, e->situation);
    for (uint32_t n = 1; n <= steps; n++) {
        trial_step(t, f->at, f->in, t->dt, &t->trace);
        if (t->trace.transition == 0 && n > t->window && n - (last > t->window ? last : t->window) > pause)
            return false;
        if (t->trace.transition == 0)
            continue;
        for (uint32_t v = 0; v < t->run->m->var.n; v++) {
            f->switches |= n > searched && t->actuator[v] && var[v] != f->level[v];
            f->level[v] = var[v];
        }
        memmove(f->taken, f->taken + 1, sizeof f->taken - sizeof *f->taken);
        memmove(f->at_step, f->at_step + 1, sizeof f->at_step - sizeof *f->at_step);
        f->taken[STEPS_SEARCHED - 1] = t->transition[t->trace.transition];
        f->at_step[STEPS_SEARCHED - 1] = last = n;
    }
    return true;
}

// Runs from an entry with constant inputs.  If the last steps repeat a cycle of transitions, returns the number of transitions in the
// cycle; 0 if more than `pause` steps took no transition, or the transitions do not repeat.
static size_t find_cycle(CycleSearch *f, const TrialEntry *e, uint32_t pause)
{
    size_t n = 1;

    if (!run_transitions(f, e, pause))
        return 0;
    while (n <= CYCLE_MAX && f->taken[STEPS_SEARCHED - 1 - n] != f->taken[STEPS_SEARCHED - 1])
        n++;
    for (size_t k = 0; k < n && n <= CYCLE_MAX; k++)
        if (f->taken[STEPS_SEARCHED - 1 - k] != f->taken[STEPS_SEARCHED - 1 - k - n] || !f->taken[STEPS_SEARCHED - 1 - k])
            return 0;
    return n <= CYCLE_MAX ? n : 0;
}

// Whether e reads a variable that is wanted: the variable v, or a sensor if v is NULL.
static bool reads_wanted_variable(const InputDepsTable *deps, const Expr *e, const Var *v)
{
    bool any = e->kind == EX_VAR && (v ? e->var == v : is_sensor(deps, e->var));

    for (uint32_t i = 0; i < e->n && !any; i++)
        any = reads_wanted_variable(deps, e->arg[i], v);
    return any;
}

static bool any_reads(const InputDepsTable *deps, const Condition *when, const Var *v)
{
    bool any = false;

    for (; when && !any; when = when->outer)
        any = reads_wanted_variable(deps, when->stmt->value, v);
    return any;
}

// Whether the transition waits for a sensor: its conditions read a sensor, or a variable that the state changes depending on a sensor.
static bool waits_for_sensor(const Trials *t, const InputDepsTable *deps, const Transition *x)
{
    bool any = any_reads(deps, x->when, NULL);

    for (uint32_t n = 1; n <= t->a->p->stmts && !any; n++) {
        const Stmt *s = t->stmt[n];
        any = s && s->kind == ST_ASSIGN && t->state_of[n] == x->from && any_reads(deps, x->when, s->var) &&
              (any_reads(deps, t->when[n], NULL) || reads_wanted_variable(deps, s->value, NULL));
    }
    return any;
}

// Whether each of the last n transitions waits for a sensor and none for a time: then a counter that delays them filters the sensor.
static bool waits_for_sensors_only(const CycleSearch *f, size_t n)
{
    const InputDepsTable *deps = input_deps_of(f->t->a);
    bool only = true;

    for (size_t k = 0; k < n && only; k++) {
        const Transition *x = f->taken[STEPS_SEARCHED - 1 - k];
        only = !input_deps_of_condition(deps, x->when).time && waits_for_sensor(f->t, deps, x);
    }
    return only;
}

// Whether some condition of the transition can be unmet, so that the transition is not taken.
static bool has_undecided_condition(const Analysis *a, const Transition *x)
{
    for (const Condition *c = x->when; c; c = c->outer)
        if (c->holds ? a->stmt[c->stmt->number].otherwise : a->stmt[c->stmt->number].then)
            return true;
    return false;
}

// Returns how often the machine flips, as the end of a sentence.
static const char *round_text(const CycleSearch *f, size_t n)
{
    const uint32_t steps = f->at_step[STEPS_SEARCHED - 1] - f->at_step[STEPS_SEARCHED - 1 - n];

    return steps == n ? "in every step" : format_in(f->t->a->arena, "again and again: one round takes %lu steps", (unsigned long)steps);
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
        d = diag_report(a->diags, DIAG_ping_pong, there->stmt->span, there->from->name->text, there->to->name->text, round_text(f, n));
        diag_note(a->diags, d, back->stmt->span, DIAG_note_transition_back, condition_text(a->arena, back->when));
    }
}

// Finds cycles of states with a transition in every step, or every few steps, while inputs are constant.
void check_ping_pong(Trials *t)
{
    CycleSearch f = {.t = t, .at = arena_alloc(t->a->arena, t->run->size), .in = trial_new_inputs(t)};

    f.level = ARENA_ARRAY(t->a->arena, double, t->run->m->var.n);
    for (size_t s = 0; s < t->a->p->state.n; s++)
        for (size_t n = 0; n < t->state[s].entry.n && n < ENTRIES_TRIED; n++)
            for (int k = 0; k < INPUTS_TRIED && trial_may_continue(t); k++) {
                size_t cycle;
                choose_cycle_inputs(&f, &t->state[s].entry.at[n], k);
                cycle = find_cycle(&f, &t->state[s].entry.at[n], 0);
                if (cycle == 0 && t->count > 0) {
                    cycle = find_cycle(&f, &t->state[s].entry.at[n], PAUSE_MAX);
                    cycle = cycle > 1 && waits_for_sensors_only(&f, cycle) ? cycle : 0;
                }
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
