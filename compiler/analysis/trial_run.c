// SPDX-License-Identifier: Apache-2.0
// Runs a machine from a situation, passes time, and chooses the readings of its inputs.
#include <string.h>

#include "compiler/analysis/trial.h"
#include "compiler/analysis/trial_near.h"
#include "compiler/ir/eval.h"
#include "stdlib/math.h"

enum {
    STEPS_PER_ADVANCE = 40,              // most steps in one call of trial_advance_to_event while a variable other than a counter changes
    READINGS_TRIED = 6,               // readings that are tried to make a state last
    LASTING_STEPS = 3,                // steps for which the machine must stay in the state
    WORK_PER_CHECK = 100000           // instructions between two checks whether the host ends the trials: about a millisecond
};

// ---- running ----

void *trial_copy_situation(const Trials *t, void *to, const void *from)
{
    if (!to)
        to = arena_alloc(t->a->arena, t->run->size);
    return memcpy(to, from, t->run->size);
}

// Returns the value of an input in the next step, if the trial has chosen x.  It follows from the variables alone, so that situations can be copied.
static double continue_pattern(const Trials *t, const double *vars, uint32_t input, double x)
{
    const TrialPattern *p = &t->pattern[input];
    const double last = vars[t->input[input].var];

    switch (p->kind) {
    case SCENARIO_HOLD: break;
    case SCENARIO_COPY: return vars[p->source];
    case SCENARIO_RAMP: return last + p->by;
    case SCENARIO_ALTERNATE: return trial_clamp_reading(&t->input[input], last == ir_convert(t->input[input].v->type, x) ? x + p->by : x);
    }
    return x;
}

// Stores the inputs in the variables of a situation, converted to the types of the variables.
void trial_store_inputs(const Trials *t, double *vars, const double *in)
{
    for (uint32_t i = 0; i < t->inputs; i++)
        vars[t->input[i].var] = ir_convert(t->input[i].v->type, t->pattern && i != t->broken ? continue_pattern(t, vars, i, in[i]) : in[i]);
}

// As the inputs of ir_run_fill_windows: continues patterns.  Other inputs keep their values.
static void continue_patterns(void *context, double *vars, uint32_t sample)
{
    const Trials *t = context;

    (void)sample;
    for (uint32_t i = 0; i < t->inputs && t->pattern; i++)
        if (t->pattern[i].kind != SCENARIO_HOLD && t->pattern[i].kind != SCENARIO_ALTERNATE && i != t->broken)
            vars[t->input[i].var] = ir_convert(t->input[i].v->type, continue_pattern(t, vars, i, 0));
}

void trial_fill_skipped(const Trials *t, void *situation, uint32_t samples)
{
    ir_run_fill_windows(t->run, situation, samples, t->dt, continue_patterns, (void *)t);
}

// Runs one step with the inputs `in`; G is dt later than in the last step.
void trial_step(Trials *t, void *situation, const double *in, double dt, IrTrace *trace)
{
    const IrSituation *s = situation;
    double *var = ir_run_vars(t->run, situation);

    var[t->run->m->g] = s->ran ? s->last_g + dt : 0;
    trial_store_inputs(t, var, in);
    ir_run_step(t->run, situation, trace);
    if (t->near && trace)
        trial_near_record(t->near, situation, trace);
    if (t->run->work >= t->check_at) {
        arena_check_host(t->a->arena);
        t->check_at = t->run->work + WORK_PER_CHECK;
    }
}

// ---- passing time ----

static const double endless = 1e9;                   // a number of steps, larger than any timer needs

// Returns how many steps come before the step in which a value that changes by `by` per step reaches the limit; `endless` if it never
// does.
static double steps_to_limit(double from, double limit, double by)
{
    const double n = sm_ceil((limit - from) / by);

    return n > 0 ? n - 1 : n == 0 ? 0 : endless;
}

// Returns how many steps come before the next time that the machine waits for.
static double steps_to_next_wait(const Trials *t, const void *situation)
{
    const IrSituation *s = situation;
    const double *var = trial_vars(t, situation);
    double n = endless;

    for (uint32_t w = 0; w < t->waits; w++)
        if (t->wait[w] >= s->last_g - s->start)
            n = sm_min(n, steps_to_limit(s->last_g - s->start, t->wait[w], t->dt));
    for (uint32_t v = 0; v < t->run->m->var.n; v++)
        for (uint32_t w = 0; w < t->waits && t->stamp[v]; w++)
            if (t->wait[w] >= s->last_g - var[v])
                n = sm_min(n, steps_to_limit(s->last_g - var[v], t->wait[w], t->dt));
    for (uint32_t w = 0; w < t->waits && t->stamped; w++)
        n = sm_min(n, sm_max(sm_ceil(sm_max(t->wait[w] / 2, (s->last_g - s->start) / 4) / t->dt) - 1, 0));
    return n;
}

// Returns how many steps can follow before a timer reaches a limit, whatever else changes; TRIAL_MANY: no limit is ahead.
uint32_t trial_steps_to_timer(const Trials *t, const void *situation)
{
    const double n = steps_to_next_wait(t, situation);

    return n >= endless ? TRIAL_MANY : (uint32_t)sm_min(n, 1e8);
}

// Returns how many steps that change the variables like the last step can follow before a timer or a counter reaches a limit.
uint32_t trial_steps_to_event(const Trials *t, const double *before, const void *situation)
{
    const double *var = trial_vars(t, situation);
    const IrMachine *m = t->run->m;
    double n = steps_to_next_wait(t, situation);

    for (uint32_t v = 0; v < m->var.n; v++) {
        if (!m->var.at[v].writable || v == m->s || var[v] == before[v])
            continue;
        if (!t->limit[v])
            return 0;
        for (const double *l = t->limit[v]; *l == *l; l++)
            n = sm_min(n, steps_to_limit(var[v], *l, var[v] - before[v]));
    }
    return n >= endless ? TRIAL_MANY : (uint32_t)sm_min(n, 1e8);
}

// Returns how many steps can follow before a timer or a counter reaches a limit, whatever else changes.
uint32_t trial_steps_to_limit(const Trials *t, const double *before, const void *situation)
{
    const double *var = trial_vars(t, situation);
    double n = steps_to_next_wait(t, situation);

    for (uint32_t v = 0; v < t->run->m->var.n; v++)
        for (const double *l = t->limit[v]; l && *l == *l && var[v] != before[v]; l++)
            n = sm_min(n, steps_to_limit(var[v], *l, var[v] - before[v]));
    return n >= endless ? TRIAL_MANY : (uint32_t)sm_min(n, 1e8);
}

// Advances time and counters by `steps` steps that change the variables like the last step (see trial_steps_to_event).
void trial_skip_steps(const Trials *t, const double *before, void *situation, uint32_t steps)
{
    IrSituation *s = situation;
    double *var = ir_run_vars(t->run, situation);
    const IrMachine *m = t->run->m;
    const double n = steps == TRIAL_MANY ? endless : steps;

    s->last_g += n * t->dt;
    for (uint32_t v = 0; v < m->var.n; v++)
        if (t->limit[v] && m->var.at[v].writable)
            var[v] = ir_convert(m->var.at[v].type, var[v] + n * (var[v] - before[v]));
    if (t->run_time > 0)
        trial_fill_skipped(t, situation, (uint32_t)sm_min(n, t->window));
}

// Whether two changes of a variable are equal, apart from rounding.
bool trial_is_even(double before, double now) { return sm_abs(now - before) <= 1e-6 * sm_abs(now); }

// Advances like trial_skip_steps.  Variables that have changed by the same amount in the last two steps continue to do so.
void trial_leap(const Trials *t, const double *earlier, const double *before, void *situation, uint32_t steps)
{
    double *var = ir_run_vars(t->run, situation);
    const IrMachine *m = t->run->m;

    for (uint32_t v = 0; v < m->var.n; v++)
        if (m->var.at[v].writable && v != m->g && v != m->t && v != m->s && !t->limit[v] &&
            trial_is_even(before[v] - earlier[v], var[v] - before[v]))
            var[v] = ir_convert(m->var.at[v].type, var[v] + steps * (var[v] - before[v]));
    trial_skip_steps(t, before, situation, steps);
}

// Runs with constant inputs: steps until a transition, or until only timers and counters change, at most 40; then, without a transition,
// skips the steps that remain before the next timer or counter reaches its limit.
bool trial_advance_to_event(Trials *t, void *situation, const double *in, IrTrace *trace)
{
    uint32_t n = 0;

    for (int k = 0; k < STEPS_PER_ADVANCE && n == 0; k++) {
        memcpy(t->before, ir_run_vars(t->run, situation), t->run->m->var.n * sizeof *t->before);
        trial_step(t, situation, in, t->dt, trace);
        if (trace->transition)
            return true;
        n = trial_steps_to_event(t, t->before, situation);
    }
    trial_skip_steps(t, t->before, situation, n);
    return n != TRIAL_MANY;
}

// Whether a timer or a rising counter has moved closer to a limit since the variables were `before`, so that it may reach the limit later.
bool trial_approaches_limit(const Trials *t, const double *before, const void *situation)
{
    const double *var = trial_vars(t, situation);
    const IrMachine *m = t->run->m;

    for (uint32_t w = 0; w < t->waits; w++)
        if (var[m->t] > before[m->t] && t->wait[w] > var[m->t])
            return true;
    for (uint32_t v = 0; v < m->var.n; v++)
        for (const double *l = t->limit[v]; l && *l == *l; l++)
            if (var[v] > before[v] && *l > var[v])
                return true;
    return false;
}

// Whether two situations are in the same state, with equal values in all variables that the machine writes, except G, S and T.
bool trial_is_same_situation(const Trials *t, const void *a, const void *b)
{
    const double *x = trial_vars(t, a);
    const double *y = trial_vars(t, b);
    const IrMachine *m = t->run->m;

    if (trial_state(a) != trial_state(b) || trial_is_entering(a) != trial_is_entering(b))
        return false;
    for (uint32_t v = 0; v < m->var.n; v++)
        if (m->var.at[v].writable && v != m->g && v != m->t && v != m->s && x[v] != y[v])
            return false;
    return true;
}

// ---- choosing ----

// Returns a pseudo-random number from 0 to n - 1; 0 if n is 0.
uint32_t trial_random_below(Trials *t, uint32_t n)
{
    t->random = t->random * 6364136223846793005u + 1442695040888963407u;
    return n == 0 ? 0 : (uint32_t)((t->random >> 33) % n);
}

double *trial_new_inputs(Trials *t) { return ARENA_ARRAY(t->a->arena, double, t->inputs + 1); }

bool trial_is_healthy(const TrialInput *i, double reading) { return reading >= i->lo && reading <= i->hi; }

void trial_set_group(const Trials *t, double *in, uint32_t input, double reading)
{
    for (uint32_t i = 0; i < t->inputs; i++)
        if (t->input[i].group == t->input[input].group && !t->input[i].command)
            in[i] = reading;
}

// Returns x limited to the @range of i; x itself if i has no @range.
double trial_clamp_reading(const TrialInput *i, double x) { return i->v->range ? sm_min(sm_max(x, i->lo), i->hi) : x; }

// Adds noise to sensors: at most the fraction `most` of their scale, equal for all sensors of a group.
void trial_add_noise(Trials *t, double *in, double most)
{
    for (uint32_t g = 0; g < t->inputs && most > 0; g++) {
        const double noise = most * t->input[g].scale * (trial_random_below(t, 2001) / 1000.0 - 1);
        if (t->input[g].command || t->input[g].group != g)
            continue;
        for (uint32_t i = g; i < t->inputs; i++)
            if (t->input[i].group == g)
                in[i] = trial_is_healthy(&t->input[i], in[i]) ? trial_clamp_reading(&t->input[i], in[i] + noise) : in[i] + noise;
    }
}

void trial_unify_groups(const Trials *t, double *in)
{
    for (uint32_t i = 0; i < t->inputs; i++)
        if (!t->input[i].command)
            in[i] = in[t->input[i].group];
}

// Returns one of i's readings: within its @range unless `unhealthy`.
double trial_pick_reading(Trials *t, const TrialInput *i, bool unhealthy)
{
    double x = i->reading[trial_random_below(t, i->readings)];

    for (int k = 0; k < 4 && !unhealthy && !trial_is_healthy(i, x); k++)
        x = i->reading[trial_random_below(t, i->readings)];
    return x;
}

// Draws readings for the inputs that the state depends on (all inputs if s is NULL): sensors of a group get one reading, some of them one of their
// own.  `commands`: also for commands; `unhealthy`: readings outside @range, too.
void trial_draw_inputs(Trials *t, double *in, const TrialState *s, bool commands, bool unhealthy)
{
    for (uint32_t i = 0; i < t->inputs; i++) {
        const TrialInput *input = &t->input[i];
        if (s && !s->relevant[i])
            continue;
        if (input->command) {
            if (commands)
                in[i] = trial_random_below(t, 2) ? 0 : trial_pick_reading(t, input, true);
        } else if (input->group == i) {
            trial_set_group(t, in, i, trial_pick_reading(t, input, unhealthy));
        } else if (trial_random_below(t, 3) == 0) {
            in[i] = trial_pick_reading(t, input, unhealthy);
        }
    }
}

// Draws readings, unhealthy ones too, for the sensors that the state depends on, and for bools that are not marked @command.
void trial_draw_inputs_freely(Trials *t, double *in, const TrialState *s)
{
    trial_draw_inputs(t, in, s, false, true);
    for (uint32_t i = 0; i < t->inputs; i++)
        if (t->input[i].command && !t->input[i].v->command)
            in[i] = trial_pick_reading(t, &t->input[i], true);
}

// ---- the start of a trial ----

typedef struct HeldInputs { const Trials *t; const double *in; } HeldInputs;

static void set_held_inputs(void *context, double *vars, uint32_t sample)
{
    const HeldInputs *h = context;

    (void)sample;
    trial_store_inputs(h->t, vars, h->in);
}

// Moves a situation to a later G, with the same T, if less time has passed since the start than the samples of the windows need.
static void make_room_for_samples(const Trials *t, void *situation)
{
    IrSituation *s = situation;
    const double later = t->window * t->dt - s->last_g;

    if (later <= 0)
        return;
    s->last_g += later;
    s->start += later;
    s->ran = true;
}

// Fills every window with samples of these inputs.
void trial_fill_windows(Trials *t, void *situation, const double *in)
{
    void *before = trial_copy_situation(t, t->scratch, situation);
    HeldInputs h = {t, in};

    if (t->run_time > 0)
        make_room_for_samples(t, situation);
    ir_run_fill_windows(t->run, situation, t->window, t->dt, set_held_inputs, &h);
    for (uint32_t w = 0; w < t->run->m->window.n; w++)
        if (t->samples_written[w])
            ir_run_copy_window(t->run, situation, before, w);
}

// Returns whether the machine stays in the state for some steps with the inputs `in`.  If not, draws other healthy readings for the sensors
// in `in`, and tries again a few times.  Returns false if the machine never stays.
static bool find_lasting_inputs(Trials *t, const TrialEntry *e, void *situation, double *in)
{
    const uint32_t state = trial_state(e->situation);
    bool same = false;

    for (int readings = 0; readings < READINGS_TRIED && !same; readings++) {
        if (readings > 0)
            trial_draw_inputs(t, in, &t->state[state - 1], false, false);
        trial_copy_situation(t, situation, e->situation);
        same = true;
        for (int n = 0; n < LASTING_STEPS && same; n++) {
            trial_step(t, situation, in, t->dt, &t->trace);
            same = trial_state(situation) == state;
        }
    }
    return same;
}

// Copies the situation of an entry, and sets `in` to the inputs that led to it, or to other readings if the machine would leave the state
// with those inputs.
void trial_begin_at_entry(Trials *t, const TrialEntry *e, void *situation, double *in)
{
    bool lasts_with_commands;

    t->pattern = e->pattern;
    memcpy(in, e->in, t->inputs * sizeof *in);
    lasts_with_commands = find_lasting_inputs(t, e, situation, in);
    for (uint32_t i = 0; i < t->inputs; i++)
        if (t->input[i].command)
            in[i] = 0;
    if (!find_lasting_inputs(t, e, situation, in) && lasts_with_commands)
        memcpy(in, e->in, t->inputs * sizeof *in);
    trial_copy_situation(t, situation, e->situation);
}

// ---- comparing ----

// Returns the first variable in e that the machine writes and whose values in a and b differ; or NULL.
static const Var *find_differing_var(const Trials *t, const Expr *e, const double *a, const double *b)
{
    const Var *found = NULL;

    for (uint32_t i = 0; i < e->n && !found; i++)
        found = find_differing_var(t, e->arg[i], a, b);
    if (!found && e->kind == EX_VAR && e->var->written) {
        const uint32_t v = t->a->m->var_of[e->var->index];
        found = v != IR_NONE && a[v] != b[v] ? e->var : NULL;
    }
    return found;
}

// Returns a variable that the machine writes, that one of these conditions reads, and that differs between two situations; or NULL.
const Var *trial_find_difference(const Trials *t, const Condition *when, const void *a, const void *b)
{
    const Var *found = NULL;

    for (; when && !found; when = when->outer)
        found = find_differing_var(t, when->stmt->value, trial_vars(t, a), trial_vars(t, b));
    return found;
}
