// SPDX-License-Identifier: Apache-2.0
// Steps in which only timers and counters change are skipped: that is exact.  A machine that integrates a reading, or filters it, changes
// in every step.  Its run leaps to the next timer: variables that change by the same amount in each step continue to do so, others keep
// their values.  That shows where to search; the caller confirms an effect by an exact run.
#include "compiler/analysis/sensor_failure.h"

#include <string.h>

#include "stdlib/math.h"

// How healthy readings move.  `noise` is in units of the distance to the next reading that a comparison distinguishes.  `slope`
// is in units of TrialInput.scale per step.  Only the group of the failing sensor moves like this; other sensors have small noise.
typedef struct ReadingMotion { double noise, slope; } ReadingMotion;
static const ReadingMotion motion[FAILURE_MOTIONS] = {
    {0, 0},                       // no motion: for every failure except STICKS
    {0.02, 0},                    // the noise of a good sensor: too small to change the result of a comparison
    {0, 0.003},                   // a slow change: the reading crosses the scale in 333 steps, and differs in every step
    {0.3, 0},                     // the noise of a poor sensor
    {5, 0}, {100, 0}              // if the scale is unknown: so much noise that it changes comparisons of the difference between two samples
};

enum {
    STEPS_AFTER_WINDOWS = 5,      // healthy steps after windows are full: locals that read a statistic settle, too
    FAILED_STEPS = 20,            // steps after windows are full of failed readings in which an effect is expected
    STEPS_TO_SETTLE = 3,          // steps after which only timers and counters of a settled machine change
    ADVANCES_MAX = 400,           // the most events and steps to which both machines advance after a sensor has failed
    ADVANCES_MOVING = 20,         // as ADVANCES_MAX, but while readings move and the failed machine has not left its state
    STEPS_BEFORE_LEAP = 40,       // steps in which filters settle, before the first leap in a state
    STEPS_BETWEEN_LEAPS = 5       // steps run after a leap to a timer's limit, in which the machine can react to that timer
};
static const double least_peak = 1e-9;          // assumed largest level of an output that has never been on, so that the rise required of it is not 0
static const double noise_fraction = 0.001;     // noise of the other sensors as a fraction of their scale, while only the failing one moves
static const double rough_noise = 300;          // replaces the distance to the next reading, as a unit of noise, for a sensor whose scale is unknown

// ---- readings ----

// Returns the reading of a sensor with failure f; `before` is its last healthy reading.
static double reading_of_failure(const TrialInput *i, FailureKind f, double before)
{
    const Fact type = fact_of_type(i->v->type);

    switch (f) {
    case READS_ZERO: return 0;
    case READS_LOW_END: return i->lo;
    case READS_HIGH_END: return i->hi;
    case READS_FAR_ABOVE: return sm_min(type.hi, 1e30);
    case READS_FAR_BELOW: return sm_max(type.lo, -1e30);
    case STICKS: case FAILURES: break;
    }
    return before;
}

// Returns a pseudo-random number between -1 and 1 that depends only on the step and the input.
static double hash_to_noise(uint32_t step, uint32_t input)
{
    return (double)((step * 2654435761u ^ (input + 1) * 2246822519u) * 3266489917u >> 8) / 8388608.0 - 1;
}

// ---- one trial ----

// Returns the distance from a reading to the nearest other reading that comparisons distinguish.
static double distance_to_next(const TrialInput *i, double reading)
{
    double least = i->scale;

    for (uint32_t k = 0; k < i->readings; k++)
        if (i->reading[k] != reading)
            least = sm_min(least, sm_abs(i->reading[k] - reading));
    return least;
}

// Adds the noise and the slope of the case to the failed sensor's reading in this step, and noise to the readings of other sensors.  The
// noise never moves another sensor to a reading that a comparison distinguishes, unless its scale is unknown.
static void vary_readings(const FailureTrial *z, const FailureCase *c, double *in)
{
    const Trials *t = z->t;
    const ReadingMotion m = motion[c->motion];
    const TrialInput *i = &t->input[c->sensor];
    const double by = m.noise * distance_to_next(i, c->reading) * hash_to_noise(z->clock, i->group) + m.slope * i->scale * z->clock;

    for (uint32_t k = 0; k < t->inputs && (m.noise > 0 || z->others > 0); k++) {
        const TrialInput *other = &t->input[k];
        double most;                                          // the largest noise on this sensor
        if (other->command || other->group == i->group)
            continue;
        most = z->others == 0 ? noise_fraction * other->scale : other->rough ? rough_noise * z->others : z->others * distance_to_next(other, in[k]);
        in[k] = trial_clamp_reading(other, in[k] + most * hash_to_noise(z->clock, other->group));
    }
    if (by != 0)
        trial_set_group(t, in, c->sensor, trial_clamp_reading(i, c->reading + by));
}

// Runs one step of a healthy machine from this situation.  Stores the inputs of the step in z->now.
static void step_healthy(FailureTrial *z, const FailureCase *c, void *situation)
{
    memcpy(z->now, z->in, z->t->inputs * sizeof *z->now);
    vary_readings(z, c, z->now);
    z->clock++;
    trial_step(z->t, situation, z->now, z->t->dt, &z->t->trace);
}

// Runs the healthy machine until its rolling windows contain only the current inputs.  Returns false if the machine leaves its state.
bool failure_run_to_steady_state(FailureTrial *z, const FailureCase *c)
{
    const double *var = ir_run_vars(z->t->run, z->healthy);
    const uint32_t vars = z->t->run->m->var.n;

    memset(z->level, 0, vars * sizeof *z->level);
    for (uint32_t n = z->t->window + STEPS_AFTER_WINDOWS; n > 0; n--) {
        step_healthy(z, c, z->healthy);
        if (z->t->trace.transition)
            return false;
        for (uint32_t v = 0; v < vars && n < z->t->window + STEPS_AFTER_WINDOWS - 1; v++)
            z->level[v] = sm_max(z->level[v], sm_abs(var[v]));
    }
    return true;
}

// Runs the healthy machine from z->begin until the next timer or counter reaches its limit, and then to a steady state.  Returns
// false if the machine leaves its state, or if no timer or counter is running.
bool failure_advance_to_next_timer(FailureTrial *z, const FailureCase *c)
{
    Trials *t = z->t;
    uint32_t n = 0;

    trial_copy_situation(t, z->healthy, z->begin);
    for (int k = 0; k < STEPS_TO_SETTLE && n == 0; k++) {
        memcpy(z->before, ir_run_vars(t->run, z->healthy), t->run->m->var.n * sizeof *z->before);
        step_healthy(z, c, z->healthy);
        if (t->trace.transition)
            return false;
        n = trial_steps_to_event(t, z->before, z->healthy);
    }
    if (n == 0)
        n = trial_steps_to_timer(t, z->healthy);
    if (n == TRIAL_MANY)
        return false;
    trial_skip_steps(t, z->before, z->healthy, n);
    return failure_run_to_steady_state(z, c);
}

// Adds to *e the outputs that the failed machine has switched on and the healthy one has not.  Adds only outputs with one cause: the
// transition that the failed machine has taken, or else one assignment.  Each cause is reported once.
static void add_outputs_switched_on(FailureTrial *z, FailureEffect *e)
{
    const Trials *t = z->t;
    const double *healthy = ir_run_vars(t->run, z->healthy), *failed = ir_run_vars(t->run, z->failed);
    const uint32_t *writer = ir_run_writers(t->run, z->failed);
    uint32_t cause = e->transition;

    for (uint32_t v = 0; v < t->run->m->var.n && e->outputs < FAILURE_OUTPUTS; v++) {
        if (!t->actuator[v] || sm_abs(failed[v]) - sm_max(z->level[v], sm_abs(healthy[v])) < z->rise * sm_max(t->peak[v], least_peak))
            continue;
        if (e->transition == 0 && (z->reported[writer[v]] || (cause != 0 && cause != writer[v]) || (z->only && z->only != writer[v])))
            continue;
        cause = e->transition ? e->transition : writer[v];
        e->output[e->outputs] = t->var[v];
        e->on[e->outputs++] = t->stmt[writer[v]];
    }
    e->at = t->stmt[cause];
}

static bool is_bound_for_abort(const FailureTrial *z, const void *situation) { return z->bound.bound[trial_state(situation) - 1]; }

// Whether the last transition of the failed machine was not its first one and left an @safe state.  The safe state is then the cause of
// what follows.
static bool has_left_safe_state(const FailureTrial *z, const FailureEffect *e)
{
    const uint32_t taken = z->t->trace.transition;

    return taken && taken != e->transition && z->t->transition[taken]->from->is_safe;
}

// Runs one step of both machines.
static StepEffect step_both(FailureTrial *z, const FailureCase *c, FailureEffect *e)
{
    Trials *t = z->t;

    step_healthy(z, c, z->healthy);
    if (t->trace.transition)
        return HEALTHY_LEFT;
    memcpy(z->broken, z->now, t->inputs * sizeof *z->broken);
    z->broken[c->sensor] = e->failed;
    t->broken = c->sensor;
    trial_step(t, z->failed, z->broken, t->dt, &t->trace);
    t->broken = IR_NONE;
    if (t->trace.transition && e->transition == 0)
        e->transition = t->trace.transition;
    if (z->reported[e->transition] || has_left_safe_state(z, e))
        return INCONCLUSIVE;
    if (z->only && e->transition && e->transition != z->only)
        return NO_EFFECT;
    if (z->leaves) {
        e->at = t->stmt[e->transition];
        return !is_bound_for_abort(z, z->failed) ? HAS_EFFECT : NO_EFFECT;
    }
    if (e->transition && is_bound_for_abort(z, z->failed))
        return INCONCLUSIVE;
    add_outputs_switched_on(z, e);
    return e->outputs > 0 ? HAS_EFFECT : NO_EFFECT;
}

// Whether every variable that the machine writes, except counters, has changed by the same amount in the last two steps.
static bool changes_evenly(const Trials *t, const double *earlier, const double *before, const void *situation)
{
    const double *var = trial_vars(t, situation);
    const IrMachine *m = t->run->m;

    for (uint32_t v = 0; v < m->var.n; v++)
        if (m->var.at[v].writable && v != m->s && !t->limit[v] && !trial_is_even(before[v] - earlier[v], var[v] - before[v]))
            return false;
    return true;
}

// Skips the steps to the next timer or counter limit of either machine, whatever else changes.  Returns their number.
static uint32_t leap_to_limit(FailureTrial *z)
{
    Trials *t = z->t;
    const uint32_t healthy = trial_steps_to_limit(t, z->before, z->healthy), failed = trial_steps_to_limit(t, z->before_failed, z->failed);
    const uint32_t skip = failed < healthy ? failed : healthy;

    if (skip == 0 || skip == TRIAL_MANY)
        return 0;
    trial_leap(t, z->earlier, z->before, z->healthy, skip);
    t->broken = z->sensor;
    trial_leap(t, z->earlier_failed, z->before_failed, z->failed, skip);
    t->broken = IR_NONE;
    z->leapt = true;
    return skip;
}

// Stores copies of the variables of both machines before a step.  Keeps the copies from before the previous step.
static void remember_vars(FailureTrial *z)
{
    const size_t size = z->t->run->m->var.n * sizeof *z->before;

    memcpy(z->earlier, z->before, size);
    memcpy(z->earlier_failed, z->before_failed, size);
    memcpy(z->before, ir_run_vars(z->t->run, z->healthy), size);
    memcpy(z->before_failed, ir_run_vars(z->t->run, z->failed), size);
}

// Skips the steps in which only timers and counters change in both machines.  Returns their number.
static uint32_t skip_to_event(FailureTrial *z)
{
    Trials *t = z->t;
    const uint32_t healthy = trial_steps_to_event(t, z->before, z->healthy);
    const uint32_t failed = trial_is_entering(z->failed) ? 0 : trial_steps_to_event(t, z->before_failed, z->failed);
    const uint32_t skip = failed < healthy ? failed : healthy;

    trial_skip_steps(t, z->before, z->healthy, skip);
    t->broken = z->sensor;
    trial_skip_steps(t, z->before_failed, z->failed, skip);
    t->broken = IR_NONE;
    return skip;
}

// Whether the run has reached its limit on steps or advances. n: number of advances so far.
static bool is_run_over(const FailureTrial *z, const FailureCase *c, const FailureEffect *e, int n)
{
    if (z->exact > 0)
        return (uint32_t)n >= z->exact;
    return n >= (c->motion == 0 || e->transition ? ADVANCES_MAX : ADVANCES_MOVING);
}

// Runs both machines until no timer or counter can change anything, skipping steps in which nothing happens in either machine.  Returns
// the first effect.
static StepEffect run_until_idle(FailureTrial *z, const FailureCase *c, FailureEffect *e)
{
    const Trials *t = z->t;
    StepEffect effect = NO_EFFECT;
    int idle = 0, moving = 0, wait = STEPS_BEFORE_LEAP;       // moving: steps since the last skip or transition

    for (int n = 0; effect == NO_EFFECT && idle < 2 && !is_run_over(z, c, e, n); n++) {
        uint32_t skip;
        remember_vars(z);
        effect = step_both(z, c, e);
        if (effect != NO_EFFECT)
            return effect;
        skip = skip_to_event(z);
        moving = skip == 0 && !trial_is_entering(z->failed) ? moving + 1 : 0;
        if (trial_is_entering(z->failed))
            wait = STEPS_BEFORE_LEAP;
        if (z->exact == 0 && moving > 2 && (moving >= wait || (changes_evenly(t, z->earlier, z->before, z->healthy) &&
                                                           changes_evenly(t, z->earlier_failed, z->before_failed, z->failed)))) {
            skip = leap_to_limit(z);
            wait = skip > 0 ? STEPS_BETWEEN_LEAPS : wait;
            moving = skip > 0 ? 0 : moving;
        }
        idle = skip != TRIAL_MANY ? 0 : idle + 1;
    }
    z->cut = effect == NO_EFFECT && idle < 2 && e->transition && trial_steps_to_limit(t, z->before_failed, z->failed) != TRIAL_MANY;
    return effect;
}

// Runs both machines until their windows contain only readings after the failure, and then until nothing changes any more.
static StepEffect run_both(FailureTrial *z, const FailureCase *c, FailureEffect *e)
{
    Trials *t = z->t;
    StepEffect effect = NO_EFFECT;

    for (uint32_t n = 0; n < t->window + FAILED_STEPS && effect == NO_EFFECT; n++) {
        effect = step_both(z, c, e);
        if (n > t->window + 2 && c->motion != 0 && trial_is_same_situation(t, z->healthy, z->failed))
            return effect;                            // while readings move, every step would have to be run
    }
    return effect == NO_EFFECT ? run_until_idle(z, c, e) : effect;
}

// Runs both machines from z->begin, the situation in which the sensor fails, and describes the effect in *e.
StepEffect failure_run(FailureTrial *z, const FailureCase *c, FailureEffect *e)
{
    Trials *t = z->t;
    const uint32_t clock = z->clock;
    StepEffect effect;

    memset(e, 0, sizeof *e);
    z->leapt = z->cut = false;
    trial_copy_situation(t, z->healthy, z->begin);
    trial_copy_situation(t, z->failed, z->begin);
    z->sensor = c->sensor;
    e->before = motion[c->motion].noise > 0 ? c->reading : z->reading;      // without the noise of the last step
    if (t->pattern && t->pattern[c->sensor].kind != SCENARIO_HOLD)
        e->before = trial_vars(t, z->begin)[t->input[c->sensor].var];
    e->failed = reading_of_failure(&t->input[c->sensor], c->failure, e->before);
    effect = run_both(z, c, e);
    e->steps = (uint32_t)((((IrSituation *)z->failed)->last_g - ((IrSituation *)z->begin)->last_g) / t->dt + 0.5);
    z->clock = clock;
    return effect;
}

bool failure_has_noise(uint32_t m) { return motion[m].noise > 0; }

FailureTrial failure_trial_new(Trials *t)
{
    FailureTrial z = {.t = t, .bound = abort_find_bound(t->a), .rise = FAILURE_RISE};
    const size_t vars = t->run->m->var.n;

    z.healthy = arena_alloc(t->a->arena, t->run->size);
    z.failed = arena_alloc(t->a->arena, t->run->size);
    z.begin = arena_alloc(t->a->arena, t->run->size);
    z.in = trial_new_inputs(t);
    z.now = trial_new_inputs(t);
    z.broken = trial_new_inputs(t);
    z.before = ARENA_ARRAY(t->a->arena, double, vars);
    z.before_failed = ARENA_ARRAY(t->a->arena, double, vars);
    z.earlier = ARENA_ARRAY(t->a->arena, double, vars);
    z.earlier_failed = ARENA_ARRAY(t->a->arena, double, vars);
    z.level = ARENA_ARRAY(t->a->arena, double, vars);
    z.reported = ARENA_ARRAY(t->a->arena, bool, t->a->p->stmts + 1u);
    return z;
}
