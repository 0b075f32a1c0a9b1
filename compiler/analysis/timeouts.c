// SPDX-License-Identifier: Apache-2.0
// Reports states in which the machine may stay forever.
//
//   waits-for-sensor    only one sensor can end the state: while it reads 0 or an end of its @range, sticks or is noisy, the machine
//                       does not leave the state at any reading of another sensor or at any time
//   missing-timeout     the state switches an output on, and never ends while inputs are constant
//
// The first state is checked only if it switches an output on, because before that nothing has begun that must continue.
// Elements marked @command do not change: a state that only a person can end may last forever in flight.  Other bools do change in
// the check for one sensor: they can be switches that the flight operates, such as a pull wire.
#include <string.h>

#include "compiler/analysis/trial_checks.h"

enum {
    ENTRIES_TRIED = 3,            // situations at the entry of a state from which histories start
    HISTORIES_MAX = 24,           // histories (sequences of inputs) that are tried before a state is reported as never ending
    LAST_ADVANCES = 20,             // an output that is on in one of the last calls of trial_advance_to_event is assumed to stay or come on forever
    INPUT_CHANGES = 4             // changes of the other inputs in one history
};

typedef struct TimeoutCheck {
    Trials *t;
    void *at;                 // the current situation of the run
    double *in, *now;             // inputs without noise; inputs of this step
    double *mid;                  // the variables halfway through a long stay in the state
    double noise;                 // largest noise on healthy sensors, in units of TrialInput.scale
    const SensorFailure *failed;  // the failed sensor, or NULL
    const Stmt *on;               // a statement of the state that switched on an output which is on at the end; or NULL
} TimeoutCheck;

// Sets w->now, the inputs of this step: w->in with noise, and the reading of the failed sensor.
static void set_inputs(TimeoutCheck *w)
{
    Trials *t = w->t;
    const SensorFailure *f = w->failed;

    memcpy(w->now, w->in, t->inputs * sizeof *w->now);
    trial_add_noise(t, w->now, w->noise);
    if (f)
        w->now[f->input] = f->reading + f->noise * (trial_random_below(t, 2001) / 1000.0 - 1);
}

// Unless w->on is set: sets it to a statement of the state that switched on an output which is on now.
static void find_output_on(TimeoutCheck *w, const State *s)
{
    const Trials *t = w->t;
    const double *var = ir_run_vars(t->run, w->at);
    const uint32_t *writer = ir_run_writers(t->run, w->at);

    for (uint32_t v = 0; v < t->run->m->var.n && !w->on; v++) {
        const Stmt *on = t->actuator[v] && var[v] != 0 ? t->stmt[writer[v]] : NULL;
        if (on && t->state_of[on->number] == s)
            w->on = on;
    }
}

// Runs with constant inputs until windows are full, and then until nothing can change any more, for at most TRIAL_ADVANCES calls of
// trial_advance_to_event.  Returns false if the machine leaves the state, or if a timer or counter still approaches a limit at the end.
static bool hold_inputs_in_state(TimeoutCheck *w, uint32_t state)
{
    Trials *t = w->t;
    const double *var = ir_run_vars(t->run, w->at);
    int idle = 0;

    for (uint32_t n = t->window + 5; n > 0; n--) {
        set_inputs(w);
        trial_step(t, w->at, w->now, t->dt, &t->trace);
        if (trial_state(w->at) != state)
            return false;
    }
    w->on = NULL;
    for (int n = 0; n < TRIAL_ADVANCES && idle < 2; n++) {
        if (n == TRIAL_ADVANCES / 2)
            memcpy(w->mid, var, t->run->m->var.n * sizeof *w->mid);
        set_inputs(w);
        idle = trial_advance_to_event(t, w->at, w->now, &t->trace) ? 0 : idle + 1;
        if (trial_state(w->at) != state)
            return false;
        for (uint32_t v = 0; v < t->run->m->var.n; v++)
            if (var[v] < w->mid[v])
                w->mid[v] = 1e300;                    // a variable that falls, as a counter that is reset, does not count as advancing
        if (idle == 2 || n > TRIAL_ADVANCES - LAST_ADVANCES)
            find_output_on(w, t->a->p->state.at[state - 1]);
    }
    return idle == 2 || !trial_approaches_limit(t, w->mid, w->at);
}

// Runs one history, in which the other inputs change several times.  Returns whether the machine stays in the state.
static bool lasts_in_one_history(TimeoutCheck *w, const TrialEntry *e)
{
    Trials *t = w->t;
    const uint32_t state = trial_state(e->situation);

    trial_begin_at_entry(t, e, w->at, w->in);
    for (int n = 0; n < INPUT_CHANGES; n++) {
        static const double noise[] = {0, 0.001, 0.01, 0.1};
        trial_draw_inputs_freely(t, w->in, &t->state[state - 1]);
        w->noise = noise[trial_random_below(t, 4)];
        if (!hold_inputs_in_state(w, state))
            return false;
    }
    return true;
}

// Runs many histories, with one failed sensor, or with none if `failed` is NULL.  Returns whether the machine stays in the state in all of
// them; false if the effort limit does not allow all.
static bool lasts_in_all_histories(TimeoutCheck *w, const TrialEntry *e, const SensorFailure *failed)
{
    bool all = true;

    w->failed = failed;
    for (int n = 0; n < (failed ? HISTORIES_MAX : 8 * HISTORIES_MAX) && all; n++)
        all = trial_may_continue(w->t) && lasts_in_one_history(w, e);
    w->failed = NULL;
    w->noise = 0;
    return all;
}

// ---- one sensor ----

// Reports the failure f if the state never ends with it.  Returns whether it was reported.
static bool report_if_lasts(TimeoutCheck *w, const State *s, const TrialEntry *e, SensorFailure f)
{
    const Analysis *a = w->t->a;
    const char *reads;
    Diag *d;

    if (!lasts_in_all_histories(w, e, &f))
        return false;
    reads = f.noise > 0 ? "is noisy" : format_in(a->arena, "reads %s", const_text(a->arena, f.reading));
    d = diag_report(a->diags, DIAG_waits_for_sensor, s->span, s->name->text, w->t->input[f.input].v->name->text, reads);
    diag_note(a->diags, d, (Span){0}, DIAG_note_wait_advice, s->name->text);
    return true;
}

// Tries failures of the sensor, and reports the first with which the state never ends.  Returns whether there is one.
static bool try_failures_of_sensor(TimeoutCheck *w, const State *s, const TrialEntry *e, uint32_t input)
{
    static const double noise[] = {0.1, 5, 100};
    const TrialInput *i = &w->t->input[input];
    bool found = report_if_lasts(w, s, e, (SensorFailure){input, 0, 0});

    if (i->v->range && !found)
        found = report_if_lasts(w, s, e, (SensorFailure){input, i->lo, 0}) || report_if_lasts(w, s, e, (SensorFailure){input, i->hi, 0});
    for (uint32_t k = 0; k < i->readings && !found; k++)
        found = trial_is_healthy(i, i->reading[k]) && report_if_lasts(w, s, e, (SensorFailure){input, i->reading[k], 0});
    for (size_t k = 0; k < sizeof noise / sizeof *noise && !found; k++)
        found = report_if_lasts(w, s, e, (SensorFailure){input, i->reading[i->readings / 2], noise[k] * i->scale});
    return found;
}

// Whether statement n belongs to the state and can switch an output on.
static bool switches_on(const Trials *t, uint32_t n, const State *state)
{
    const Stmt *s = t->stmt[n];
    const StmtFact *f = &t->a->stmt[n];

    return s && s->kind == ST_ASSIGN && t->state_of[n] == state && t->actuator[t->a->m->var_of[s->var->index]] && f->reached &&
           (f->value.lo < 0 || f->value.hi > 0);
}

// Whether the state switches an output on.
static bool drives_output(const Trials *t, const State *state)
{
    for (uint32_t n = 1; n <= t->a->p->stmts; n++)
        if (switches_on(t, n, state))
            return true;
    return false;
}

static TimeoutCheck new_timeout_check(Trials *t)
{
    return (TimeoutCheck){.t = t, .at = arena_alloc(t->a->arena, t->run->size), .in = trial_new_inputs(t), .now = trial_new_inputs(t),
                          .mid = ARENA_ARRAY(t->a->arena, double, t->run->m->var.n)};
}

// Whether the state depends on an input other than a command.
static bool has_relevant_sensor(const Trials *t, size_t state)
{
    for (uint32_t i = 0; i < t->inputs; i++)
        if (!t->input[i].command && t->state[state].relevant[i])
            return true;
    return false;
}

// Finds states that only one sensor can end.
void check_waits_for_sensor(Trials *t)
{
    TimeoutCheck w = new_timeout_check(t);

    for (size_t s = 0; s < t->a->p->state.n; s++) {
        const State *state = t->a->p->state.at[s];
        bool found = false;
        if (state->is_safe || state->is_abort || (s == 0 && !drives_output(t, state)) || !has_relevant_sensor(t, s))
            continue;
        for (size_t n = 0; n < t->state[s].entry.n && n < ENTRIES_TRIED && !found; n++) {
            const TrialEntry *e = &t->state[s].entry.at[n];
            if (lasts_in_all_histories(&w, e, NULL))
                continue;
            for (uint32_t i = 0; i < t->inputs && !found; i++)
                found = !t->input[i].command && t->state[s].relevant[i] && try_failures_of_sensor(&w, state, e, i);
        }
    }
}

// ---- no time limit ----

// Reports a state that never ends and has switched on the output of w->on.  Names that output first, and then the other outputs that the
// state switches on: none of them has a time limit.
static void report_missing_timeout(const TimeoutCheck *w, const State *s)
{
    const Trials *t = w->t;
    const Analysis *a = t->a;
    const Var **output = ARENA_ARRAY(a->arena, const Var *, a->p->var.n + 1);
    uint32_t outputs = 0;
    Diag *d;

    output[outputs++] = w->on->var;
    for (uint32_t n = 1; n <= a->p->stmts; n++) {
        uint32_t k = 0;
        if (!switches_on(t, n, s))
            continue;
        while (k < outputs && output[k] != t->stmt[n]->var)
            k++;
        if (k == outputs)
            output[outputs++] = t->stmt[n]->var;
    }
    d = diag_report(a->diags, DIAG_no_timeout, s->span, s->name->text, trial_check_join_names(a->arena, output, outputs));
    for (uint32_t i = 0; i < outputs; i++)
        diag_note_declaration(a->diags, d, DIAG_OUTPUTS, output[i]->span);
    diag_note(a->diags, d, w->on->span, DIAG_note_switched_on, w->on->var->name->text);
}

// Whether a transition from s to another state can be taken.  If none can, missing-way-out reports the state instead.
static bool is_ever_left(const Trials *t, const State *s)
{
    for (size_t i = 0; i < t->a->transition.n; i++) {
        const Transition *x = &t->a->transition.at[i];
        if (x->from == s && x->to != s && t->a->stmt[x->stmt->number].reached)
            return true;
    }
    return false;
}

// Tries several inputs from e, a situation at the entry of the state.  Reports the state if it never ends and has an output on.  Returns
// whether the state was reported.
static bool try_entry_for_timeout(TimeoutCheck *w, const State *s, const TrialEntry *e)
{
    Trials *t = w->t;

    for (int n = 0; n < HISTORIES_MAX && trial_may_continue(t); n++) {
        trial_begin_at_entry(t, e, w->at, w->in);
        if (n > 0)
            trial_draw_inputs(t, w->in, &t->state[s->number - 1], n % 2, false);
        if (!hold_inputs_in_state(w, s->number) || !w->on)
            continue;
        report_missing_timeout(w, s);
        return true;
    }
    return false;
}

// Finds states that drive an output and that time alone never ends.
void check_missing_timeout(Trials *t)
{
    TimeoutCheck w = new_timeout_check(t);

    for (size_t s = 0; s < t->a->p->state.n; s++) {
        const State *state = t->a->p->state.at[s];
        bool found = state->is_safe || state->is_abort || !is_ever_left(t, state);
        for (size_t n = 0; n < t->state[s].entry.n && n < ENTRIES_TRIED && !found; n++)
            found = try_entry_for_timeout(&w, state, &t->state[s].entry.at[n]);
    }
}
