// SPDX-License-Identifier: Apache-2.0
// Finds out on which sensors and commands a state's ability to abort depends, by trials in which a sensor has failed and trials without
// any command.
//
// A state can abort if some trial from it reaches an @abort state, directly or through states that lead nowhere else.  It is
// reported as unable to abort only if two things are true: no trial aborts, and every transition to an abort depends on the failed
// sensor.  Of a state that no run has reached, nothing is concluded: trials begin in it without what earlier states have stored.
#include "compiler/analysis/abort.h"

#include <string.h>

#include "compiler/analysis/trial_gaps.h"
#include "compiler/analysis/trial_checks.h"

enum {
    ENTRIES_TRIED = 4,            // situations at the entry of a state (TrialEntry) from which trials start
    LATCH_ENTRIES_TRIED = 8,      // how many situations at the entry of a state find_latch compares with each other
    TRIALS_PER_ENTRY = 80,        // if so many trials from a situation do not abort, no trial from it is assumed to abort
    INPUT_CHANGES = 4,            // how often the inputs change in one trial
    WORK_MAX = 1600000             // instructions spent on one state and sensor
};
static const double healthy_noise = 0.001;      // as a fraction of a sensor's scale: some machines take a reading without any noise for a dead sensor

typedef struct AbortTrials {
    Trials *t;
    const AbortBound *b;          // the states that always lead to an @abort state
    const InputDepsTable *deps;
    void *at;                     // the current situation
    double *in, *now;             // the inputs of the present trial; with their noise, those of the last step
    double noise;                 // the most noise of healthy sensors, as a fraction of their scale
    bool commands;                // trials also change commands at random.  If false, commands keep their values; but if some element is
                                  // marked @command, bools without the mark are no commands here and do change
    const SensorFailure *failed;  // the failed sensor, or NULL
    bool left_at_once;            // some trial left the state within two steps, and did not abort
    bool left;                    // some trial left the state later, but before windows were full, and did not abort
    bool stayed;                  // some trial stayed in the state until windows were full
    bool aborted;                 // some trial aborted
    bool cut;                     // no trial aborted, and the effort ended before all trials had run: they show nothing
    bool driven;                  // an output was on during a trial
    uint64_t until;               // value of Trials.run.work at which the trials stop
} AbortTrials;

typedef enum TrialEnd { TRIAL_STAYS, TRIAL_ABORTS, TRIAL_LEAVES } TrialEnd;

// ---- trials ----

// Returns where the last step led from this state.  If the machine stayed in the state, records whether an output is on.
static TrialEnd classify_last_step(AbortTrials *k, uint32_t state)
{
    Trials *t = k->t;
    const double *var = ir_run_vars(t->run, k->at);

    if (trial_state(k->at) != state)
        return k->b->bound[trial_state(k->at) - 1] ? TRIAL_ABORTS : TRIAL_LEAVES;
    for (uint32_t v = 0; v < t->run->m->var.n && !k->driven; v++)
        k->driven = t->actuator[v] && var[v] != 0;
    return TRIAL_STAYS;
}

static TrialEnd run_step(AbortTrials *k, uint32_t state)
{
    memcpy(k->now, k->in, k->t->inputs * sizeof *k->now);
    trial_add_noise(k->t, k->now, k->noise);
    if (k->failed)
        k->now[k->failed->input] = k->in[k->failed->input] = k->failed->reading;
    trial_step(k->t, k->at, k->now, k->t->dt, &k->t->trace);
    return classify_last_step(k, state);
}

// Runs with constant inputs until the rolling windows are full, and then until no timer or counter can change anything any more.
// Returns whether the machine stays in the state, aborts or leaves otherwise.
static TrialEnd hold_inputs_in_state(AbortTrials *k, uint32_t state)
{
    Trials *t = k->t;
    TrialEnd f = TRIAL_STAYS;

    for (uint32_t n = t->window + 5; n > 0 && f == TRIAL_STAYS; n--) {
        f = run_step(k, state);
        *(n > t->window + 3 ? &k->left_at_once : &k->left) |= f == TRIAL_LEAVES;
    }
    k->stayed |= f == TRIAL_STAYS;
    for (int n = 0, idle = 0; n < TRIAL_ADVANCES && f == TRIAL_STAYS && idle < 2; n++) {
        idle = trial_advance_to_event(t, k->at, k->in, &t->trace) ? 0 : idle + 1;
        f = classify_last_step(k, state);
    }
    return f;
}

// In the first trials, sets sensors to an end of their range: all of them to the upper end, all to the lower, then each one alone.  So a guard
// on a second sensor, as in max(a, b) > 60, is tried even if random readings never make it true.
static void set_to_ends(AbortTrials *k, int trial)
{
    const Trials *t = k->t;

    for (uint32_t i = 0; i < t->inputs; i++)
        if (!t->input[i].command && (trial < 2 || (uint32_t)trial / 2 == i + 1))
            k->in[i] = trial % 2 ? t->input[i].lo : t->input[i].hi;
}

// Runs trials from a situation at the entry of a state until one aborts.  Returns whether one did.
static bool find_aborting_trial(AbortTrials *k, const TrialEntry *e)
{
    Trials *t = k->t;
    const uint32_t state = trial_state(e->situation);

    for (int n = 0; n < TRIALS_PER_ENTRY && t->run->work < k->until; n++) {
        TrialEnd f = TRIAL_STAYS;
        k->noise = n % 4 == 3 ? healthy_noise : 0;
        trial_begin_at_entry(t, e, k->at, k->in);
        t->pattern = n % 4 < 2 ? t->pattern : NULL;         // a feedback that no longer follows its output can cause an abort
        t->broken = k->failed ? k->failed->input : IR_NONE;
        if (k->failed) {
            k->in[k->failed->input] = k->failed->reading;
            trial_fill_windows(t, k->at, k->in);
        }
        for (int c = 0; c < INPUT_CHANGES && f == TRIAL_STAYS; c++) {
            if (!k->commands && k->deps->marks_commands)
                trial_draw_inputs_freely(t, k->in, &t->state[state - 1]);
            else
                trial_draw_inputs(t, k->in, &t->state[state - 1], k->commands, true);
            if (c == 0 && (uint32_t)n < 2 + 2 * t->inputs)
                set_to_ends(k, n);
            else if (c == 0 && n % 2)
                f = run_step(k, state);
            if (f == TRIAL_STAYS)
                f = hold_inputs_in_state(k, state);
        }
        t->broken = IR_NONE;
        if (f == TRIAL_ABORTS)
            return true;
    }
    return false;
}

// Returns the value of Trials.run.work at which the next trials of a state stop.  `bounded`: also at the end of the check's effort.
static uint64_t until_of_trials(const AbortTrials *k, bool bounded)
{
    const uint64_t until = k->t->run->work + WORK_MAX / k->t->share;

    return bounded && until > k->t->until ? k->t->until : until;
}

// Runs trials of a state, with or without commands, and with or without a failed sensor.  Returns true if a trial aborted.  Also returns
// true if the trials do not show that the state cannot abort: no trial stayed in the state, or, with a failed sensor, too few could be run
// (k->cut).
static bool try_to_abort(AbortTrials *k, const AbortRow *r, bool commands, const SensorFailure *failed)
{
    const TrialState *s = &k->t->state[r->state->number - 1];
    bool found = false;

    k->commands = commands;
    k->failed = failed;
    k->stayed = k->left = k->left_at_once = false;
    k->until = until_of_trials(k, failed != NULL);
    for (size_t n = 0; n < s->entry.n && n < ENTRIES_TRIED && !found; n++)
        found = find_aborting_trial(k, &s->entry.at[n]);
    k->failed = NULL;
    k->aborted = found;
    k->cut = failed && !found && k->t->run->work >= k->until;
    if (k->cut) {
        trial_add_gap(k->t->gaps, (TrialGap){GAP_SENSOR, r->state, k->t->input[failed->input].v, NULL});
        return true;
    }
    return found || !k->stayed;
}

// ---- inputs of the paths ----

// A path is bounded (abort_is_bounded) if it can be taken and reaches an @abort state within a known number of steps.

// Whether there are bounded paths that do not depend on commands alone, and all of them depend on this sensor.
static bool all_paths_depend_on(const AbortRow *r, const Var *v)
{
    bool any = false;

    for (size_t k = 0; k < r->path.n; k++) {
        const AbortPath *path = &r->path.at[k];
        const bool by_command_alone = path->by_command && path->sensors == 0 && !path->by_time;
        bool depends = false;
        for (size_t i = 0; i < path->sensors; i++)
            depends |= path->sensor[i] == v;
        if (!depends && abort_is_bounded(path) && !by_command_alone)
            return false;
        any |= depends && abort_is_bounded(path);
    }
    return any;
}

// Whether every bounded path depends on a command.
static bool all_paths_need_command(const AbortRow *r)
{
    for (size_t p = 0; p < r->path.n; p++)
        if (abort_is_bounded(&r->path.at[p]) && !r->path.at[p].by_command)
            return false;
    return true;
}

// Whether some transition out of the state starts a path that can be taken and aborts within a known number of steps.
static bool can_abort_in_known_time(const AbortRow *r)
{
    for (size_t p = 0; p < r->path.n; p++)
        if (abort_is_bounded(&r->path.at[p]))
            return true;
    return false;
}

// ---- a sensor that has failed ----

// Whether the trials show that the state cannot abort at this reading: no trial aborts, and at least one stays until windows are full, or
// all leave the state, but not within two steps.  (If they leave within two steps, the state has no time to abort.)
static bool fails_to_abort_at(AbortTrials *k, const AbortRow *r, uint32_t input, double reading)
{
    const SensorFailure f = {input, reading, 0};

    return !try_to_abort(k, r, false, &f) || (!k->cut && !k->stayed && !k->aborted && k->left && !k->left_at_once);
}

// Whether the state fails to abort at a reading that no healthy sensor delivers.  Unlike in fails_to_abort_at, a state that is left at once
// without an abort also counts as failing.
static bool is_blind_at(AbortTrials *k, const AbortRow *r, uint32_t input, double reading)
{
    return fails_to_abort_at(k, r, input, reading) || (!k->cut && !k->stayed && !k->aborted && k->left_at_once);
}

// Finds out whether the state cannot abort while the sensor reads 0, or a number outside its range that the type can represent.
static void find_blind_readings(AbortTrials *k, AbortRow *r, uint32_t input)
{
    const TrialInput *i = &k->t->input[input];
    const Fact type = fact_of_type(i->v->type);
    const bool ranged = i->v->range != NULL;
    const bool zero = is_blind_at(k, r, input, 0);
    const bool below = ranged && fact_next_below(type, i->lo) >= type.lo && is_blind_at(k, r, input, fact_next_below(type, i->lo)) &&
                       is_blind_at(k, r, input, i->lo - i->scale);
    const bool above = ranged && fact_next_above(type, i->hi) <= type.hi && is_blind_at(k, r, input, fact_next_above(type, i->hi)) &&
                       is_blind_at(k, r, input, i->hi + i->scale);
    Arena *arena = k->t->a->arena;
    const bool name_zero = zero && !(below && i->lo > 0) && !(above && i->hi < 0);

    if (!zero && !below && !above)
        return;
    r->blind = i->v;
    r->blind_at = format_in(arena, "%s%s%s%s%s", name_zero ? "0" : "", name_zero && (below || above) ? " or " : "",
                            below ? format_in(arena, "less than %s", const_text(arena, i->lo)) : "", below && above ? " or " : "",
                            above ? format_in(arena, "more than %s", const_text(arena, i->hi)) : "");
}

// Finds a healthy reading other than 0 at which the sensor may stick so that the state cannot abort, among the readings of the trials.
static void find_stuck_reading(AbortTrials *k, AbortRow *r, uint32_t input)
{
    const TrialInput *i = &k->t->input[input];

    for (uint32_t n = 0; n < i->readings; n++) {
        const double x = i->reading[(n + i->readings / 2) % i->readings];
        if (x == 0 || !trial_is_healthy(i, x) || !fails_to_abort_at(k, r, input, x))
            continue;
        r->single = i->v;
        r->stuck = x;
        return;
    }
}

// ---- state that remains from an earlier abort ----

// If trials from one situation at the entry of the state abort but trials from another one do not, stores in *r a variable that differs
// between the two situations and that the guard of a path reads.
static void find_latch(AbortTrials *k, AbortRow *r)
{
    const TrialState *s = &k->t->state[r->state->number - 1];
    const TrialEntry *can = NULL, *cannot = NULL;

    k->commands = true;
    for (size_t n = 0; n < s->entry.n && n < LATCH_ENTRIES_TRIED && !(can && cannot); n++) {
        k->stayed = false;
        k->until = until_of_trials(k, true);
        if (find_aborting_trial(k, &s->entry.at[n]))
            can = &s->entry.at[n];
        else if (k->stayed && k->t->run->work < k->until)
            cannot = &s->entry.at[n];
    }
    for (size_t p = 0; can && cannot && p < r->path.n && !r->latch; p++) {
        r->latch = trial_find_difference(k->t, r->path.at[p].first->when, cannot->situation, can->situation);
        r->latched = &r->path.at[p];
    }
    if (r->latch)
        r->latched_at = trial_vars(k->t, cannot->situation)[k->t->a->m->var_of[r->latch->index]];
}

// Runs trials from the entries of a state, and fills in its row of the abort table.
static void fill_in_trial_results(AbortTrials *k, AbortRow *r)
{
    Trials *t = k->t;

    if (t->state[r->state->number - 1].entry.n == 0)
        return;
    k->driven = false;
    r->by_itself = try_to_abort(k, r, false, NULL);
    r->by_command = can_abort_in_known_time(r) && !r->by_itself && all_paths_need_command(r) && try_to_abort(k, r, true, NULL);
    r->drives = k->driven;
    if (!can_abort_in_known_time(r) || !r->by_itself || !t->state[r->state->number - 1].reached)
        return;
    find_latch(k, r);
    for (uint32_t i = 0; i < t->inputs && !(r->blind && r->single); i++)
        if (!t->input[i].command && all_paths_depend_on(r, t->input[i].v)) {
            if (!r->blind)
                find_blind_readings(k, r, i);
            if (!r->single)
                find_stuck_reading(k, r, i);
        }
}

void abort_run_trials(Trials *t, AbortMatrix *x, const AbortBound *b)
{
    Arena *arena = t->a->arena;
    AbortTrials k = {.t = t, .b = b, .deps = input_deps_of(t->a), .at = arena_alloc(arena, t->run->size), .in = trial_new_inputs(t)};

    k.now = trial_new_inputs(t);
    x->deps = k.deps;
    for (size_t s = 0; s < x->n; s++) {
        AbortRow *r = &x->row[s];
        for (size_t i = 0; i < r->path.n; i++) {
            AbortPath *path = &r->path.at[i];
            const InputDeps deps = input_deps_of_condition(k.deps, path->first->when);
            path->sensor = arena_copy(arena, deps.sensor, deps.n * sizeof *deps.sensor);
            path->sensors = deps.n;
            path->by_time = deps.time;
            path->by_input = deps.input;
            path->by_command = deps.command;
        }
        if (!r->state->is_abort)
            fill_in_trial_results(&k, r);
    }
}
