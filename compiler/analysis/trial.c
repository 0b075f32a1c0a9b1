// SPDX-License-Identifier: Apache-2.0
// The search for situations that the machine can reach.  Each try starts from a situation already found, changes inputs, and keeps them
// constant for a few steps, until windows are full, or until the next timers end.  Every new situation at the entry of a state is stored
// with the inputs that led to it.
#include "compiler/analysis/trial.h"

#include <string.h>

#include "compiler/analysis/input_deps.h"
#include "compiler/analysis/trial_inputs.h"
#include "compiler/analysis/trial_near.h"
#include "compiler/ir/eval.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

enum {
    ENTRIES_MAX = 32,             // situations stored for each state
    PATTERNS_MAX = 4,             // further ones with a pattern (TrialPattern)
    ENTRIES_LASTING = 4,          // situations from which a state is tried for whether it lasts
    ROUNDS = 8,
    ROUNDS_MORE = 16,             // further rounds, only from states with transitions that no trial has taken
    TRIES = 40,                   // tries from each state in each round
    INPUT_CHANGES = 4,            // changes of inputs in one try
    STORED_BYTES_MAX = 4 << 20    // the most bytes of all stored situations
};
static const uint64_t work_max = 40000000;          // instructions spent on the search

// ---- entries ----

// Magnitudes are divided into SIZES classes, and each class by sign.
enum { SIZES = 5, SIZE_CLASSES = 2 * (SIZES + 1) + 1 };

// Returns a class for the magnitude and sign of x, below SIZE_CLASSES; 0 for zero.
static uint32_t size_class(double x)
{
    static const double size[SIZES] = {0, 2, 20, 200, 2000};
    uint32_t n = 0;

    while (n < SIZES && sm_abs(x) > size[n])
        n++;
    return n == 0 ? 0 : x > 0 ? n : SIZES + 1 + n;
}

// Returns a hash of the size classes of all variables that the machine writes, except G, T and S.
static uint64_t entry_key(const Trials *t, const void *situation)
{
    const double *var = trial_vars(t, situation);
    const IrMachine *m = t->run->m;
    uint64_t key = 0;

    for (uint32_t v = 0; v < m->var.n; v++)
        if (m->var.at[v].writable && v != m->g && v != m->t && v != m->s)
            key = key * SIZE_CLASSES + size_class(var[v]);
    return key;
}

typedef struct TrialSearch {
    Trials *t;
    void *at;                     // the current situation of the try
    double *in, *now, *was;       // inputs without noise; inputs of this step; `in` before its last change
    double noise;                 // largest noise on sensors, in units of TrialInput.scale
    uint32_t steps;               // as in TrialEntry, for the current situation
    bool unhealthy, commanded;
    const TrialPattern *pattern;  // as in TrialEntry, for the current situation
    uint32_t most;                // how many entries may be stored for each state
    void *after;                  // a copy of the situation, for the step after a transition
} TrialSearch;

// Stores the situation as an entry of its state, unless a similar one (entry_key) is already stored.  One with a pattern comes first, because
// the checks try only the first entries of a state.
static void add_entry(TrialSearch *k, const Transition *via)
{
    Trials *t = k->t;
    TrialState *s = &t->state[trial_state(k->at) - 1];
    TrialEntry e = {NULL, NULL, via, k->steps, k->unhealthy, k->commanded, k->pattern, entry_key(t, k->at)};

    if (s->entry.n >= k->most + (k->pattern ? PATTERNS_MAX : 0))
        return;
    for (size_t i = 0; i < s->entry.n; i++) {
        const TrialEntry *old = &s->entry.at[i];
        if (old->via == e.via && old->key == e.key && old->unhealthy == e.unhealthy && !old->pattern == !e.pattern)
            return;
    }
    e.situation = trial_copy_situation(t, NULL, k->at);
    e.in = arena_copy(t->a->arena, k->in, (t->inputs + 1) * sizeof *k->in);
    vec_push(t->a->arena, &s->entry, e);
    for (size_t i = s->entry.n - 1; i > 0 && e.pattern && !s->entry.at[i - 1].pattern; i--) {
        s->entry.at[i] = s->entry.at[i - 1];
        s->entry.at[i - 1] = e;
    }
}

// Runs the step after a transition in a copy of the situation, and counts in t->next whether and where that step makes a transition.
static void record_next_step(TrialSearch *k, uint32_t transition)
{
    Trials *t = k->t;
    TrialNext *next = &t->next[transition];

    if (next->trials == UINT32_MAX)
        return;
    trial_step(t, trial_copy_situation(t, k->after, k->at), k->now, t->dt, &t->trace);
    next->left += t->trace.transition != 0;
    if (next->most == 0)
        next->transition = t->trace.transition;
    next->most += next->transition == t->trace.transition ? 1 : -1;
    next->trials++;
}

// ---- the search ----

// Adds to k->steps the steps since G was `before`.  If some steps were skipped, fills windows with samples for them.  If the length of a
// step is unknown, the number of skipped steps is unknown, too (TRIAL_MANY).
static void add_elapsed_steps(TrialSearch *k, double before)
{
    const Trials *t = k->t;
    const double n = (((const IrSituation *)k->at)->last_g - before) / t->dt;

    if (k->steps == TRIAL_MANY || (n > 1 && t->a->step == 0) || k->steps + n > SM_WINDOW_MAX) {
        k->steps = TRIAL_MANY;
        return;
    }
    k->steps += n > 1 ? (uint32_t)n : 1;
    if (n > 1)
        trial_fill_skipped(t, k->at, n - 1 < t->window ? (uint32_t)n - 1 : t->window);
}

// Runs one step, or, with `to_event`, up to the next transition, timer or counter limit (trial_advance_to_event).  After a transition, stores
// the situation if it is new.  Returns whether the machine went to another state.
static bool search_step(TrialSearch *k, bool to_event)
{
    Trials *t = k->t;
    const IrSituation *at = k->at;
    const double before = at->ran ? at->last_g : -t->dt;
    const Transition *via;

    memcpy(k->now, k->in, t->inputs * sizeof *k->now);
    trial_add_noise(t, k->now, k->noise);
    if (to_event)
        trial_advance_to_event(t, k->at, k->now, &t->trace);
    else
        trial_step(t, k->at, k->now, t->dt, &t->trace);
    add_elapsed_steps(k, before);
    for (uint32_t v = 0; v < t->run->m->var.n; v++)
        if (t->actuator[v] && sm_abs(trial_vars(t, k->at)[v]) > t->peak[v])
            t->peak[v] = sm_abs(trial_vars(t, k->at)[v]);
    if (t->trace.transition == 0)
        return false;
    via = t->transition[t->trace.transition];
    t->taken[t->trace.transition] = true;
    if (t->a->step == 0 && t->by_time[t->trace.transition])
        k->steps = TRIAL_MANY;                        // an unknown number of steps
    add_entry(k, via);
    record_next_step(k, via->stmt->number);
    return via->to != via->from;
}

// Runs with constant inputs for some steps, until windows are full, or until the next timers end.
static void hold_inputs(TrialSearch *k)
{
    static const uint32_t holds[] = {1, 1, 2, 5};
    static const double noise[] = {0, 0, 0, 0.001, 0.01, 0.1};
    Trials *t = k->t;
    const bool to_event = trial_random_below(t, 3) == 0;
    uint32_t n = to_event ? 1 + trial_random_below(t, 2 * (t->waits + t->count) + 2) : holds[trial_random_below(t, 4)];

    k->noise = noise[trial_random_below(t, 6)];
    if (!to_event && trial_random_below(t, 4) == 0)
        n = t->window + 1;
    while (n-- > 0) {
        if (search_step(k, to_event))
            return;
    }
}

// Records whether the inputs, which were k->was, show a command or a sensor that has failed.  groups: sensors of a group that differ have
// failed, too.
static void record_change(TrialSearch *k, bool groups)
{
    const Trials *t = k->t;

    for (uint32_t i = 0; i < t->inputs; i++)
        if (t->input[i].command)
            k->commanded |= k->steps > 0 && k->in[i] != k->was[i];
        else
            k->unhealthy |= !trial_is_healthy(&t->input[i], k->in[i]) || (groups && k->in[i] != k->in[t->input[i].group]);
}

// Chooses random values for all inputs on which state s depends, or changes one input.
static void change_inputs(TrialSearch *k, const TrialState *s)
{
    Trials *t = k->t;
    const bool unhealthy = trial_random_below(t, 5) == 0;

    memcpy(k->was, k->in, t->inputs * sizeof *k->was);
    if (trial_random_below(t, 3) > 0) {
        trial_draw_inputs(t, k->in, s, trial_random_below(t, 2), unhealthy);
    } else {
        const uint32_t i = trial_random_below(t, t->inputs);
        if (t->inputs > 0 && t->input[i].command)
            k->in[i] = trial_pick_reading(t, &t->input[i], true);
        else if (t->inputs > 0)
            trial_set_group(t, k->in, i, trial_pick_reading(t, &t->input[i], unhealthy));
    }
    record_change(k, true);
}

// Runs one trial of a state: from a random entry, with a few changes of its inputs one after another.
static void run_one_try(TrialSearch *k, uint32_t state)
{
    Trials *t = k->t;
    const TrialState *s = &t->state[state];
    const TrialEntry *e = &s->entry.at[trial_random_below(t, (uint32_t)s->entry.n)];

    trial_copy_situation(t, k->at, e->situation);
    memcpy(k->in, e->in, (t->inputs + 1) * sizeof *k->in);
    t->pattern = k->pattern = e->pattern && trial_random_below(t, 2) ? e->pattern : NULL;
    k->steps = e->steps;
    k->unhealthy = e->unhealthy;
    k->commanded = e->commanded;
    for (int n = 0; n < INPUT_CHANGES; n++) {
        change_inputs(k, &t->state[trial_state(k->at) - 1]);
        hold_inputs(k);
    }
}

// Whether the state has a transition that the facts allow but that no trial has taken.
static bool has_untaken_transition(const Trials *t, uint32_t state)
{
    for (size_t i = 0; i < t->a->transition.n; i++) {
        const Transition *x = &t->a->transition.at[i];
        if (x->from->number - 1 == state && !t->taken[x->stmt->number] && t->a->stmt[x->stmt->number].reached)
            return true;
    }
    return false;
}

// ---- runs that another search has found ----

// Returns the reading of an input in a step; `change` is the last change of the input.
static double reading_of_change(const Trials *t, const ScenarioChange *change, uint64_t step, const double *var, uint64_t *cell)
{
    const Program *p = t->a->p;

    if (change->kind == SCENARIO_COPY && t->a->m->var_of[change->source] != IR_NONE)
        cell[change->source] = sm_cell_from_f64(p->var.at[change->source]->type, var[t->a->m->var_of[change->source]]);
    return sm_cell_to_f64(p->var.at[change->var]->type, scenario_cell(p, change, step, cell));
}

// Returns how the inputs go on after these changes, by input; NULL: all keep their values.
static const TrialPattern *pattern_of_changes(const Trials *t, const ScenarioChange *const *current)
{
    TrialPattern *p = ARENA_ARRAY(t->a->arena, TrialPattern, t->inputs + 1u);
    bool any = false;

    for (uint32_t i = 0; i < t->inputs; i++) {
        const ScenarioChange *c = current[t->input[i].v->index];
        const bool is_limited = c && c->kind == SCENARIO_RAMP && t->input[i].v->range;         // it would leave its @range
        if (!c || c->kind == SCENARIO_HOLD || is_limited || (c->kind == SCENARIO_COPY && t->a->m->var_of[c->source] == IR_NONE))
            continue;
        p[i].kind = c->kind;
        p[i].source = c->kind == SCENARIO_COPY ? t->a->m->var_of[c->source] : 0;
        p[i].by = c->kind == SCENARIO_ALTERNATE ? c->b - c->a : c->b;
        any = true;
    }
    return any ? p : NULL;
}

// Follows a run from the machine's start, and stores the situations at the entries of states.
static void follow_run(TrialSearch *k, const Scenario *s)
{
    Trials *t = k->t;
    const Program *p = t->a->p;
    const ScenarioChange **current = ARENA_ARRAY(t->a->arena, const ScenarioChange *, p->var.n + 1u);
    uint64_t *cell = ARENA_ARRAY(t->a->arena, uint64_t, p->var.n + 1u);
    const TrialPattern *pattern = NULL;
    size_t next = 0;

    ir_run_start(t->run, k->at, s->init_state->number);
    memset(k->in, 0, (t->inputs + 1) * sizeof *k->in);
    k->steps = 0;
    k->noise = 0;
    k->unhealthy = k->commanded = false;
    for (uint64_t step = 1; step <= s->steps; step++) {
        memcpy(k->was, k->in, t->inputs * sizeof *k->was);
        if (next < s->changes && s->change[next].step <= step) {
            for (; next < s->changes && s->change[next].step <= step; next++)
                current[s->change[next].var] = &s->change[next];
            pattern = pattern_of_changes(t, current);
        }
        for (uint32_t i = 0; i < t->inputs; i++)
            if (current[t->input[i].v->index])
                k->in[i] = reading_of_change(t, current[t->input[i].v->index], step, trial_vars(t, k->at), cell);
        record_change(k, false);
        k->pattern = pattern;
        search_step(k, false);
    }
    k->pattern = NULL;
}

// Whether the machine stays in a state, from one of its entries, until all windows have only samples of constant inputs.
static bool has_lasting_entry(TrialSearch *k, const TrialState *s)
{
    Trials *t = k->t;
    bool lasts = false;

    for (size_t e = 0; e < s->entry.n && e < ENTRIES_LASTING && !lasts; e++) {
        const uint32_t state = trial_state(s->entry.at[e].situation);
        trial_begin_at_entry(t, &s->entry.at[e], k->at, k->in);
        lasts = true;
        for (uint32_t n = t->window + 1; n > 0 && lasts; n--) {
            trial_step(t, k->at, k->in, t->dt, &t->trace);
            lasts = trial_state(k->at) == state;
        }
    }
    t->pattern = NULL;
    return lasts;
}

// Whether each state has an entry in which the machine stays with constant inputs, or that a pattern of the inputs goes on with.
static bool has_reached_all(TrialSearch *k)
{
    const Trials *t = k->t;
    bool all = true;

    for (uint32_t s = 0; s < t->a->p->state.n && all; s++)
        all = !facts_may_reach(t->a->facts, s, BLOCK_ENTRY) ||
              (t->state[s].entry.n > 0 && (t->a->p->state.at[s]->is_abort || has_lasting_entry(k, &t->state[s])));
    return all;
}

// Returns the cells of the parameters in a setting, by Var.index.
static const uint64_t *cells_of_parameters(const Analysis *a, TrialSetting setting)
{
    uint64_t *cell = ARENA_ARRAY(a->kept, uint64_t, a->p->var.n + 1u);

    for (size_t v = 0; v < a->p->var.n; v++) {
        const Var *var = a->p->var.at[v];
        if (var->parameter)
            cell[v] = sm_cell_from_f64(var->type, trial_value_of_parameter(setting, var));
    }
    return cell;
}

// If a state has not been reached although the facts allow it, or constant inputs end it, follows the runs that Analysis.search finds: those of the
// defaults of parameters first, then those of the present setting.  Returns whether it did.
static bool follow_found_runs(TrialSearch *k)
{
    Analysis *a = k->t->a;
    const TrialSetting own = k->t->setting;
    bool any = false;

    for (int n = 0; n < 2 && a->search && !has_reached_all(k); n++) {
        const TrialSetting setting = n == 0 ? TRIAL_DEFAULTS : own;
        if (n > 0 && own == TRIAL_DEFAULTS)
            break;
        if (!a->runs[setting]) {
            a->runs[setting] = ARENA_NEW(a->kept, AnalysisRuns);
            *a->runs[setting] = a->search(a->kept, a->p, (uint64_t)k->t->dt, cells_of_parameters(a, setting), k->t->share);
        }
        for (uint32_t i = 0; i < a->runs[setting]->n; i++)
            follow_run(k, &a->runs[setting]->at[i]);
        any |= a->runs[setting]->n > 0;
    }
    return any;
}

// Adds an entry for each state that the search could not reach, as if the machine were started in it.
static void add_unreached_states(TrialSearch *k)
{
    Trials *t = k->t;

    for (uint32_t s = 0; s < t->a->p->state.n; s++)
        t->state[s].reached = t->state[s].entry.n > 0;
    for (uint32_t s = 0; s < t->a->p->state.n; s++)
        if (!t->state[s].reached && facts_may_reach(t->a->facts, s, BLOCK_ENTRY)) {
            trial_add_gap(t->gaps, (TrialGap){GAP_STATE, t->a->p->state.at[s], NULL, NULL});
            if (t->gaps && !t->gaps->near)
                t->gaps->near = t->near;
            ir_run_start(t->run, k->at, s + 1);
            memset(k->in, 0, (t->inputs + 1) * sizeof *k->in);
            k->steps = TRIAL_MANY;
            k->unhealthy = k->commanded = true;
            add_entry(k, NULL);
        }
}

// Runs the rounds `from` to `to` - 1 of the search: in each round, some tries from each state.  From round ROUNDS on, skips states whose
// transitions have all been taken by some trial.
static void search_rounds(TrialSearch *k, int from, int to)
{
    Trials *t = k->t;

    for (int round = from; round < to; round++)
        for (uint32_t s = 0; s < t->a->p->state.n; s++) {
            if (t->state[s].entry.n == 0 || (round >= ROUNDS && !has_untaken_transition(t, s)))
                continue;
            for (int n = 0; n < TRIES && t->run->work < work_max / t->share; n++)
                run_one_try(k, s);
        }
}

// Runs trials, in rounds, that find situations in which each state can be entered.
static void search_situations(Trials *t)
{
    TrialSearch k = {.t = t, .at = arena_alloc(t->a->arena, t->run->size), .in = trial_new_inputs(t)};
    const size_t states = t->a->p->state.n;

    k.most = (uint32_t)(STORED_BYTES_MAX / (states * (t->run->size + t->inputs * sizeof(double)) + 1));
    k.most = k.most > ENTRIES_MAX ? ENTRIES_MAX : k.most < 2 ? 2 : k.most;
    k.now = trial_new_inputs(t);
    k.was = trial_new_inputs(t);
    k.after = arena_alloc(t->a->arena, t->run->size);
    ir_run_start(t->run, k.at, 1);
    add_entry(&k, NULL);
    t->near = t->gaps ? trial_near_new(t) : NULL;
    search_rounds(&k, 0, ROUNDS + ROUNDS_MORE);
    if (follow_found_runs(&k))
        search_rounds(&k, ROUNDS, ROUNDS + ROUNDS_MORE);
    add_unreached_states(&k);
    t->near = NULL;
    search_rounds(&k, ROUNDS, ROUNDS + ROUNDS_MORE);
}

// ---- entry points ----

static void record_stmt(const StmtLocation *at, void *context)
{
    Trials *t = context;

    t->stmt[at->stmt->number] = at->stmt;
    t->state_of[at->stmt->number] = at->state;
    t->when[at->stmt->number] = at->when;
}

double trial_value_of_parameter(TrialSetting setting, const Var *v)
{
    return setting == TRIAL_LOWEST ? v->parameter->lo : setting == TRIAL_HIGHEST ? v->parameter->hi : sm_cell_to_f64(v->type, v->parameter->standard);
}

static void set_parameters(Trials *t)
{
    for (size_t v = 0; v < t->a->p->var.n; v++) {
        const Var *var = t->a->p->var.at[v];
        if (var->parameter && t->a->m->var_of[v] != IR_NONE)
            t->run->initial[t->a->m->var_of[v]] = ir_convert(var->type, trial_value_of_parameter(t->setting, var));
    }
}

typedef struct NestedWindows { const uint32_t *samples; uint32_t most; } NestedWindows;

static void find_nested_window(Expr *e, void *context)
{
    NestedWindows *nested = context;

    if (e->kind == EX_ROLL && nested->samples[e->window] > nested->most)
        nested->most = nested->samples[e->window];
}

// Returns how many samples fill every window and last as long as every `held`.  A window that samples another one, as in
// held(roll_range(p, 10) < 1, 200 ms), needs the samples of both.
static uint32_t count_samples(const Trials *t)
{
    const Windows *all = &t->a->p->window;
    uint32_t *samples = ARENA_ARRAY(t->a->arena, uint32_t, all->n + 1), most = 0;

    for (size_t w = 0; w < all->n; w++) {
        const Window *window = &all->at[w];
        NestedWindows nested = {samples, 1};
        double n = window->size;
        if (t->a->m->window_of[w] == IR_NONE)
            continue;
        if (window->stat == SM_STAT_RUN_TIME)
            n = sm_ceil(t->run_time / t->dt) + 1;
        expr_walk(window->sample, find_nested_window, &nested);
        samples[w] = (uint32_t)sm_min(n + nested.most - 1, SM_WINDOW_MAX);
        most = samples[w] > most ? samples[w] : most;
    }
    return most;
}

Trials *trials_of(Analysis *a) { return trials_at(a, TRIAL_DEFAULTS, 1, NULL); }

Trials *trials_at(Analysis *a, TrialSetting setting, uint32_t share, TrialGaps *gaps)
{
    Trials *t = ARENA_NEW(a->arena, Trials);
    const InputDepsTable *deps = input_deps_of(a);

    t->a = a;
    t->setting = setting;
    t->share = share;
    t->gaps = gaps;
    t->run = ir_run_new(a->arena, a->m);
    set_parameters(t);
    t->state = ARENA_ARRAY(a->arena, TrialState, a->p->state.n);
    t->transition = ARENA_ARRAY(a->arena, const Transition *, a->p->stmts + 1u);
    t->stmt = ARENA_ARRAY(a->arena, const Stmt *, a->p->stmts + 1u);
    t->state_of = ARENA_ARRAY(a->arena, const State *, a->p->stmts + 1u);
    t->when = ARENA_ARRAY(a->arena, const Condition *, a->p->stmts + 1u);
    each_stmt_location(a->arena, a->p, record_stmt, t);
    t->taken = ARENA_ARRAY(a->arena, bool, a->p->stmts + 1u);
    t->by_time = ARENA_ARRAY(a->arena, bool, a->p->stmts + 1u);
    for (size_t i = 0; i < a->transition.n; i++)
        t->by_time[a->transition.at[i].stmt->number] = input_deps_of_condition(deps, a->transition.at[i].when).time;
    t->next = ARENA_ARRAY(a->arena, TrialNext, a->p->stmts + 1u);
    t->actuator = ARENA_ARRAY(a->arena, bool, a->m->var.n);
    t->rests_on = ARENA_ARRAY(a->arena, bool, a->m->var.n);
    t->peak = ARENA_ARRAY(a->arena, double, a->m->var.n);
    t->stamp = ARENA_ARRAY(a->arena, bool, a->m->var.n);
    t->limit = ARENA_ARRAY(a->arena, double *, a->m->var.n);
    t->scratch = arena_alloc(a->arena, t->run->size);
    t->before = ARENA_ARRAY(a->arena, double, a->m->var.n);
    t->trace.at = ARENA_ARRAY(a->arena, uint32_t, a->p->stmts + 2u);
    t->random = TRIAL_SEED;
    t->until = UINT64_MAX;
    t->broken = IR_NONE;
    t->var = ARENA_ARRAY(a->arena, const Var *, a->m->var.n);
    for (size_t v = 0; v < a->p->var.n; v++)
        if (a->m->var_of[v] != IR_NONE)
            t->var[a->m->var_of[v]] = a->p->var.at[v];
    for (size_t i = 0; i < a->transition.n; i++)
        t->transition[a->transition.at[i].stmt->number] = &a->transition.at[i];
    t->samples_written = ARENA_ARRAY(a->arena, bool, a->m->window.n + 1u);
    trial_find_inputs(t);
    // If the step is unknown, assumes milliseconds and steps of 10.  If all times are below 100, assumes another unit and steps of 1.
    t->dt = a->step > 0 ? (double)a->step : t->waits > 0 && t->wait[t->waits - 1] < 100 ? 1 : 10;
    t->window = count_samples(t);
    search_situations(t);
    return t;
}
