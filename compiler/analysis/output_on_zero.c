// SPDX-License-Identifier: Apache-2.0
// Reports effects of a single failed sensor: an output switches on, or an @abort state ends.
//
// Two machines run side by side from one situation.  In the healthy one every reading is constant or moves a little; in the
// other one sensor fails.  If the healthy machine stays in its state and an output switches on in the other, the failure is the
// cause.
//
// The failure is reported only if its effect does not depend on another sensor: the same output switches on for all tried readings of the
// other sensors with which the healthy machine is quiet (it stays in its state with the output off).  An effect that needs a second sensor
// with a certain reading at the same time is not reported.  An effect that depends on earlier readings of other sensors or earlier
// commands, or that a timer would have had later, is reported.
//
// For an @abort state, the effect is that the failed machine leaves the state without any command, but the healthy one does not.
//
// A reaction to a failed sensor can be intended:
//   - the machine goes to an @abort state, or to a state that always leads there;
//   - the same output switches on at a reading far above and at one far below;
//   - no reading within the @range has this effect.
#include <string.h>

#include "compiler/analysis/abort.h"
#include "compiler/analysis/trial_checks.h"
#include "stdlib/math.h"

typedef enum FailureKind { READS_ZERO, READS_LOW_END, READS_HIGH_END, STICKS, READS_FAR_ABOVE, READS_FAR_BELOW, FAILURES } FailureKind;

// How healthy readings move.  `noise` is in units of the distance to the next reading that a comparison distinguishes.  `slope`
// is in units of TrialInput.scale per step.  Only the group of the failing sensor moves like this; other sensors have small noise.
typedef struct ReadingMotion { double noise, slope; } ReadingMotion;
static const ReadingMotion motion[] = {{0, 0}, {0.02, 0}, {0, 0.003}, {0.3, 0}, {5, 0}, {100, 0}};
static const double noise_of_others[] = {0, 0.02, 0.3};
enum { MOTIONS = sizeof motion / sizeof *motion, MOTIONS_OF_SCALE = 4 };     // the other motions are used if the scale is unknown

enum {
    OUTPUTS_NAMED = 4,            // the most outputs that one finding names
    ENTRIES_TRIED = 6,            // the most situations that are tried at the entry of a state
    OTHERS_FIRST = 12,            // readings of the other sensors with which a failure is tried first
    OTHERS = 32,                  // random readings of the other sensors with which an effect must be confirmed
    OTHERS_OF_ONE = 12,           // before OTHERS: readings tried for each other sensor alone, while the rest are unchanged
    QUIET_LEAST = 4,              // a report requires that the healthy machine is quiet with at least this many of these readings
    ADVANCES_MAX = 200            // the most events to which both machines advance after a sensor has failed
};
static const uint64_t effort = 4000000, effort_in_all = 100000000;      // most IR instructions per sensor and state; in total

typedef struct FailureCase {      // one trial: the sensor reads `reading`, with a motion, and fails at some time
    const TrialEntry *entry;
    uint32_t sensor;              // the failing sensor: index in Trials.input
    double reading;
    uint32_t motion;              // how the readings move: index in motion[]
    FailureKind failure;
} FailureCase;

typedef struct FailureEffect {
    uint32_t transition;          // the first transition of the failed machine (Stmt.number); 0: none
    const Stmt *at;               // the statement that only the failed machine executed: a transition, or an assignment
    const Var *output[OUTPUTS_NAMED];
    const Stmt *on[OUTPUTS_NAMED];      // the assignment that switched it on
    uint32_t outputs;
    double before, failed;        // readings of the sensor
    uint32_t steps;
} FailureEffect;

typedef struct FailureTrial {
    Trials *t;
    AbortBound bound;
    void *healthy, *failed;       // the situations of the two machines
    void *begin, *saved;          // the situation when the sensor fails; a copy of `begin`, while other readings are tried
    double *in;                   // inputs without motion
    double *now, *broken;         // inputs of this step: of the healthy machine, of the failed one
    double *before, *before_failed;       // variables before a step, of the two machines
    double *other;                // replaces `in` while other readings are tried
    double reading;               // the sensor's reading in the step before it fails
    uint32_t clock;               // number of steps in this trial, from which the motion is computed
    double *level;                // by IR variable: its largest magnitude in the healthy machine before the sensor fails
    uint32_t only;                // only an effect with this cause (Stmt.number) counts; 0: any
    bool *reported;               // by Stmt.number: already reported for this sensor and state
    double others;                // noise on other sensors, in distances to their next reading
    double rise;                  // the fraction of its largest level by which an output has to rise
    bool leaves;                  // the state is an @abort state: the effect is that the machine leaves it
    int tries;                    // number of attempts with other inputs
    uint64_t effort;              // instructions for one sensor in one state
    uint64_t until;               // value of Trials.run.work at which this sensor and state are finished
} FailureTrial;

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
        most = z->others == 0 ? other->scale / 1000 : other->rough ? 300 * z->others : z->others * distance_to_next(other, in[k]);
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
static bool run_to_steady_state(FailureTrial *z, const FailureCase *c)
{
    const double *var = ir_run_vars(z->t->run, z->healthy);
    const uint32_t vars = z->t->run->m->var.n;

    memset(z->level, 0, vars * sizeof *z->level);
    for (uint32_t n = z->t->window + 5; n > 0; n--) {
        step_healthy(z, c, z->healthy);
        if (z->t->trace.transition)
            return false;
        for (uint32_t v = 0; v < vars && n < z->t->window + 4; v++)
            z->level[v] = sm_max(z->level[v], sm_abs(var[v]));
    }
    return true;
}

// Runs the healthy machine from z->begin until the next timer or counter reaches its limit, and then to a steady state.  Returns
// false if the machine leaves its state, or if no timer or counter is running.
static bool advance_to_next_timer(FailureTrial *z, const FailureCase *c)
{
    Trials *t = z->t;
    uint32_t n = 0;

    trial_copy_situation(t, z->healthy, z->begin);
    for (int k = 0; k < 3 && n == 0; k++) {
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
    return run_to_steady_state(z, c);
}

// Adds to *e the outputs that the failed machine has switched on and the healthy one has not.  Adds only outputs with one cause: the
// transition that the failed machine has taken, or else one assignment.  Each cause is reported once.
static void add_outputs_switched_on(FailureTrial *z, FailureEffect *e)
{
    const Trials *t = z->t;
    const double *healthy = ir_run_vars(t->run, z->healthy), *failed = ir_run_vars(t->run, z->failed);
    const uint32_t *writer = ir_run_writers(t->run, z->failed);
    uint32_t cause = e->transition;

    for (uint32_t v = 0; v < t->run->m->var.n && e->outputs < OUTPUTS_NAMED; v++) {
        if (!t->actuator[v] || sm_abs(failed[v]) - sm_max(z->level[v], sm_abs(healthy[v])) < z->rise * sm_max(t->peak[v], 1e-9))
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

typedef enum StepEffect { NO_EFFECT, INCONCLUSIVE, HAS_EFFECT } StepEffect;

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
        return INCONCLUSIVE;
    memcpy(z->broken, z->now, t->inputs * sizeof *z->broken);
    z->broken[c->sensor] = e->failed;
    trial_step(t, z->failed, z->broken, t->dt, &t->trace);
    if (t->trace.transition && e->transition == 0)
        e->transition = t->trace.transition;
    if (z->reported[e->transition] || has_left_safe_state(z, e))
        return INCONCLUSIVE;
    if (z->only && e->transition && e->transition != z->only)
        return NO_EFFECT;
    e->steps++;
    if (z->leaves) {
        e->at = t->stmt[e->transition];
        return !is_bound_for_abort(z, z->failed) ? HAS_EFFECT : NO_EFFECT;
    }
    if (e->transition && is_bound_for_abort(z, z->failed))
        return INCONCLUSIVE;
    add_outputs_switched_on(z, e);
    return e->outputs > 0 ? HAS_EFFECT : NO_EFFECT;
}

// Runs both machines until their windows contain only readings after the failure, and ends if their variables are equal again then.
// Otherwise runs them until no timer or counter can change anything, skipping steps in which nothing happens in either machine.  Returns
// the first effect.
static StepEffect run_both(FailureTrial *z, const FailureCase *c, FailureEffect *e)
{
    Trials *t = z->t;
    const size_t size = t->run->m->var.n * sizeof *z->before;
    StepEffect effect = NO_EFFECT;

    for (uint32_t n = 0; n < t->window + 20 && effect == NO_EFFECT; n++) {
        effect = step_both(z, c, e);
        if (n > t->window + 2 && trial_is_same_situation(t, z->healthy, z->failed))
            return effect;
    }
    for (int n = 0, idle = 0; n < (c->motion == 0 ? ADVANCES_MAX : ADVANCES_MAX / 10) && effect == NO_EFFECT && idle < 2; n++) {
        uint32_t skip, in_failed;
        memcpy(z->before, ir_run_vars(t->run, z->healthy), size);
        memcpy(z->before_failed, ir_run_vars(t->run, z->failed), size);
        effect = step_both(z, c, e);
        skip = trial_steps_to_event(t, z->before, z->healthy);
        in_failed = trial_is_entering(z->failed) ? 0 : trial_steps_to_event(t, z->before_failed, z->failed);
        skip = in_failed < skip ? in_failed : skip;
        if (effect == NO_EFFECT) {
            trial_skip_steps(t, z->before, z->healthy, skip);
            trial_skip_steps(t, z->before_failed, z->failed, skip);
        }
        idle = skip != TRIAL_MANY ? 0 : idle + 1;
    }
    return effect;
}

// Runs both machines from z->begin, the situation in which the sensor fails, and describes the effect in *e.
static StepEffect run_failure(FailureTrial *z, const FailureCase *c, FailureEffect *e)
{
    Trials *t = z->t;
    const uint32_t clock = z->clock;
    StepEffect effect;

    memset(e, 0, sizeof *e);
    trial_copy_situation(t, z->healthy, z->begin);
    trial_copy_situation(t, z->failed, z->begin);
    e->before = motion[c->motion].noise > 0 ? c->reading : z->reading;      // without the noise of the last step
    e->failed = reading_of_failure(&t->input[c->sensor], c->failure, e->before);
    effect = run_both(z, c, e);
    z->clock = clock;
    return effect;
}

// ---- confirming a finding ----

// Chooses the n-th combination of readings of the other sensors: first each reading of each group alone, then all groups at random.
// Returns false if there are no more combinations.
static bool choose_other_readings(FailureTrial *z, const FailureCase *c, uint32_t n)
{
    Trials *t = z->t;
    const TrialState *s = &t->state[trial_state(z->saved) - 1];

    memcpy(z->other, z->in, t->inputs * sizeof *z->other);
    for (uint32_t g = 0; g < t->inputs; g++) {
        const TrialInput *i = &t->input[g];
        const uint32_t readings = i->readings < OTHERS_OF_ONE ? i->readings : OTHERS_OF_ONE;
        if (i->command || i->group != g || g == t->input[c->sensor].group || !s->relevant[g])
            continue;
        if (n < readings) {
            const double x = i->reading[n * i->readings / readings];
            trial_set_group(t, z->other, g, trial_is_healthy(i, x) ? x : z->in[g]);
            return true;
        }
        n -= readings;
    }
    trial_draw_inputs(t, z->other, s, false, false);
    trial_unify_groups(t, z->other);
    trial_set_group(t, z->other, c->sensor, c->reading);
    return n < OTHERS;
}

// Whether the effect is the same for all tried readings of other sensors from z->begin on, as long as the healthy machine stays quiet.
// Earlier readings of other sensors and earlier commands are not varied, because only the current situation counts.
static bool is_effect_independent_of_other_sensors(FailureTrial *z, const FailureCase *c, const FailureEffect *e)
{
    Trials *t = z->t;
    double *in = z->in;
    const uint32_t clock = z->clock;
    const double reading = z->reading;
    const double *level = z->leaves ? NULL : &z->level[t->a->m->var_of[e->output[0]->index]];
    bool needed = false;
    uint32_t quiet = 0;
    FailureEffect again;

    trial_copy_situation(t, z->saved, z->begin);
    z->rise = 0.02;
    z->only = e->at->number;
    for (uint32_t n = 0; !needed && choose_other_readings(z, c, n); n++) {
        trial_copy_situation(t, z->healthy, z->saved);
        z->clock = clock;
        z->others = noise_of_others[n % 3];
        z->in = z->other;
        if (run_to_steady_state(z, c)) {
            quiet++;
            z->reading = z->now[c->sensor];
            trial_copy_situation(t, z->begin, z->healthy);
            needed = run_failure(z, c, &again) != HAS_EFFECT && (!level || *level == 0);
        }
        z->in = in;
    }
    trial_copy_situation(t, z->begin, z->saved);
    z->clock = clock;
    z->reading = reading;
    z->others = 0;
    z->rise = 0.5;
    z->only = 0;
    return quiet >= QUIET_LEAST && !needed;
}

// Whether another failure of the sensor in the same situation lets the same statement store the output.
static bool has_same_effect(FailureTrial *z, const FailureCase *c, FailureKind f, const FailureEffect *e)
{
    FailureCase other = *c;
    FailureEffect effect;
    bool found;

    other.failure = f;
    z->only = e->at->number;
    found = run_failure(z, &other, &effect) == HAS_EFFECT;
    z->only = 0;
    return found;
}

// Whether the effect is an intended reaction to a failed sensor (see the top of this file).  The sensor fails at z->begin.
static bool is_intended(FailureTrial *z, const FailureCase *c, const FailureEffect *e)
{
    const TrialInput *i = &z->t->input[c->sensor];

    if (c->failure == STICKS || z->leaves)
        return false;
    if (has_same_effect(z, c, READS_FAR_ABOVE, e) && has_same_effect(z, c, READS_FAR_BELOW, e))
        return true;
    return i->v->range && !trial_is_healthy(i, e->failed) && !has_same_effect(z, c, READS_LOW_END, e) &&
           !has_same_effect(z, c, READS_HIGH_END, e);
}

// ---- findings ----

static const char *failure_text(Arena *arena, const FailureCase *c, const FailureEffect *e)
{
    return format_in(arena, c->failure == STICKS ? "sticks at %s" : "reads %s", const_text(arena, e->failed));
}

static void report_effect(FailureTrial *z, const FailureCase *c, const FailureEffect *e)
{
    Analysis *a = z->t->a;
    const char *sensor = z->t->input[c->sensor].v->name->text, *failure = failure_text(a->arena, c, e);
    const char *state = a->p->state.at[trial_state(c->entry->situation) - 1]->name->text;
    Diag *d;

    if (z->leaves)
        d = diag_report(a->diags, DIAG_abort_exit, e->at->span, sensor, state, failure);
    else
        d = diag_report(a->diags, DIAG_output_on_zero, e->at->span, sensor, trial_check_join_names(a->arena, e->output, e->outputs),
                        failure);
    for (uint32_t i = 0; i < e->outputs; i++) {
        diag_note_declaration(a->diags, d, DIAG_OUTPUTS, e->output[i]->span);
        if (e->on[i] != e->at)
            diag_note(a->diags, d, e->on[i]->span, DIAG_note_switched_on, e->output[i]->name->text);
    }
    diag_note_declaration(a->diags, d, DIAG_SENSOR, z->t->input[c->sensor].v->span);
    diag_note(a->diags, d, (Span){0}, DIAG_note_failure_example, state, sensor, const_text(a->arena, trial_check_round(e->before)),
              const_text(a->arena, e->failed), format_in(a->arena, "%lu", (unsigned long)e->steps));
    diag_note(a->diags, d, (Span){0}, DIAG_note_failure_advice, sensor);
}

// ---- the cases ----

// Whether failure f is tried in case c.  A stuck sensor differs from a healthy one only if the healthy reading moves, so STICKS is tried
// only with motion, and the other failures only without.
static bool is_failure_of_case(const TrialInput *i, const FailureCase *c, FailureKind f)
{
    switch (f) {
    case READS_ZERO: return c->motion == 0 && c->reading != 0;
    case READS_LOW_END: return c->motion == 0 && i->v->range && i->lo != 0 && c->reading != i->lo;
    case READS_HIGH_END: return c->motion == 0 && i->v->range && i->hi != 0 && c->reading != i->hi;
    case STICKS: return c->motion != 0;
    case READS_FAR_ABOVE: case READS_FAR_BELOW: case FAILURES: break;
    }
    return false;
}

// Tries each failure of the sensor.  The healthy machine must be in a steady state.
static void try_failures(FailureTrial *z, FailureCase *c)
{
    FailureEffect e;

    trial_copy_situation(z->t, z->begin, z->healthy);
    z->reading = z->now[c->sensor];
    for (FailureKind f = READS_ZERO; f <= STICKS; f++) {
        c->failure = f;
        if (!is_failure_of_case(&z->t->input[c->sensor], c, f) || run_failure(z, c, &e) != HAS_EFFECT || is_intended(z, c, &e) ||
            !is_effect_independent_of_other_sensors(z, c, &e))
            continue;
        report_effect(z, c, &e);
        z->reported[e.at->number] = true;
    }
}

// Tries all failures of the sensor at one healthy reading, with several readings of the other sensors.
static void try_reading(FailureTrial *z, FailureCase *c)
{
    Trials *t = z->t;

    for (int others = 0; others < z->tries && t->run->work < z->until; others++) {
        memcpy(z->in, c->entry->in, t->inputs * sizeof *z->in);
        if (others > 0)
            trial_draw_inputs(t, z->in, &t->state[trial_state(c->entry->situation) - 1], others > 1, false);
        trial_unify_groups(t, z->in);
        trial_set_group(t, z->in, c->sensor, c->reading);
        for (uint32_t i = 0; i < t->inputs && z->leaves; i++)
            if (t->input[i].command)
                z->in[i] = 0;
        z->clock = 0;
        trial_copy_situation(t, z->healthy, c->entry->situation);
        if (!run_to_steady_state(z, c))
            continue;
        do
            try_failures(z, c);
        while (t->run->work < z->until && advance_to_next_timer(z, c));
    }
}

static void try_sensor(FailureTrial *z, const TrialState *s, uint32_t sensor)
{
    Trials *t = z->t;
    const TrialInput *i = &t->input[sensor];
    const uint32_t motions = i->rough ? MOTIONS : MOTIONS_OF_SCALE;
    bool depends_on_others = false, has_healthy_entry = false;
    FailureCase c = {.sensor = sensor};

    memset(z->reported, 0, (t->a->p->stmts + 1u) * sizeof *z->reported);
    for (uint32_t k = 0; k < t->inputs; k++)
        depends_on_others |= s->relevant[k] && t->input[k].group != i->group;
    for (size_t n = 0; n < s->entry.n; n++)
        has_healthy_entry |= !s->entry.at[n].unhealthy;
    z->tries = depends_on_others ? OTHERS_FIRST : 1;
    for (c.motion = 0; c.motion < motions; c.motion++) {
        uint32_t tried = 0;
        z->until = t->run->work + z->effort / (c.motion == 0 ? 1 : 2);
        for (size_t n = 0; n < s->entry.n && tried < ENTRIES_TRIED; n++) {
            c.entry = &s->entry.at[n];
            if (c.entry->unhealthy && has_healthy_entry)
                continue;
            tried++;
            for (uint32_t k = 0; k < i->readings; k++) {
                c.reading = i->reading[k];
                if (trial_is_healthy(i, c.reading))
                    try_reading(z, &c);
            }
        }
    }
}

void check_output_on_zero(Trials *t)
{
    FailureTrial z = {.t = t, .bound = abort_find_bound(t->a), .rise = 0.5};

    z.healthy = arena_alloc(t->a->arena, t->run->size);
    z.failed = arena_alloc(t->a->arena, t->run->size);
    z.begin = arena_alloc(t->a->arena, t->run->size);
    z.saved = arena_alloc(t->a->arena, t->run->size);
    z.in = trial_new_inputs(t);
    z.other = trial_new_inputs(t);
    z.now = trial_new_inputs(t);
    z.broken = trial_new_inputs(t);
    z.before = ARENA_ARRAY(t->a->arena, double, t->run->m->var.n);
    z.before_failed = ARENA_ARRAY(t->a->arena, double, t->run->m->var.n);
    z.level = ARENA_ARRAY(t->a->arena, double, t->run->m->var.n);
    z.reported = ARENA_ARRAY(t->a->arena, bool, t->a->p->stmts + 1u);
    z.effort = effort_in_all / (t->a->p->state.n * t->inputs + 1) < effort ? effort_in_all / (t->a->p->state.n * t->inputs + 1) : effort;
    z.effort /= t->share;
    for (size_t s = 0; s < t->a->p->state.n; s++) {
        z.leaves = t->a->p->state.at[s]->is_abort;
        for (uint32_t i = 0; i < t->inputs; i++)
            if (!t->input[i].command && t->state[s].relevant[i])
                try_sensor(&z, &t->state[s], i);
    }
}
