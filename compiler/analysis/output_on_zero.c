// SPDX-License-Identifier: Apache-2.0
// Reports effects of a single failed sensor: an output switches on, or an @abort state ends.
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
//
// The effort is spread: first each failure of each sensor that a state depends on is tried in a few situations at the entry of the state.
// What remains goes to more situations, later times and other readings of the other sensors, in turn.
#include <string.h>

#include "compiler/analysis/sensor_failure.h"
#include "stdlib/math.h"

enum {
    ENTRIES_TRIED = 6,            // the most situations at the entry of a state from which failures are tried
    ENTRIES_FIRST = 2,            // how many of these situations are tried with each reading of the sensor, even if the effort is used up
    OTHERS_FIRST = 12,            // number of choices of the other sensors' readings with which a failure is tried
    OTHERS = 32,                  // number of random choices of the other sensors' readings with which an effect must be confirmed
    OTHERS_OF_ONE = 12,           // before the random choices: readings tried for each other sensor alone, while the rest are unchanged
    QUIET_LEAST = 4,              // a report requires that the healthy machine is quiet with at least this many of these readings
    MOTION_SHARE = 2,             // failures while readings move may use 1 / MOTION_SHARE of the effort for failures while they are constant
    SHARE_OF_REST = 3,            // a situation, with one choice of the other readings, may use 1 / SHARE_OF_REST of the effort that remains
    STEPS_AFTER_GUESS = 400       // steps that an exact run may take longer than the run with leaps that it confirms
};
// Noise of the other sensors while an effect is confirmed, used in turn: none, that of a good sensor, that of a poor one.  In units of the distance
// from a reading to the next one that a comparison distinguishes.
static const double noise_of_others[] = {0, 0.02, 0.3};
// The most IR instructions for one sensor in one state (about 10 ms), and for all sensors and states (a quarter of a second).
static const uint64_t effort = 4000000, effort_in_all = 100000000;

typedef struct FailureSearch {
    FailureTrial run;
    void *saved;                  // a copy of run.begin, while other readings are tried
    double *other;                // replaces run.in while other readings are tried
    uint32_t tries;               // number of choices of the other sensors' readings that are tried
    uint64_t effort;              // the most IR instructions for one sensor in one state
    unsigned kinds;               // bit set of FailureKind: the failures that the sensor can have
    unsigned tried;               // bit set of FailureKind: the failures that a run in this state has followed to its end
    bool lasted;                  // the machine has stayed in the state until it was in a steady state
} FailureSearch;


// ---- confirming a finding ----

// Chooses the n-th combination of readings of the other sensors: first each reading of each group alone, then all groups at random.
// Returns false if there are no more combinations.
static bool choose_other_readings(FailureSearch *k, const FailureCase *c, uint32_t n)
{
    const FailureTrial *z = &k->run;
    Trials *t = z->t;
    const TrialState *s = &t->state[trial_state(k->saved) - 1];

    memcpy(k->other, z->in, t->inputs * sizeof *k->other);
    for (uint32_t g = 0; g < t->inputs; g++) {
        const TrialInput *i = &t->input[g];
        const uint32_t readings = i->readings < OTHERS_OF_ONE ? i->readings : OTHERS_OF_ONE;
        if (i->command || i->group != g || g == t->input[c->sensor].group || !s->relevant[g])
            continue;
        if (n < readings) {
            const double x = i->reading[n * i->readings / readings];
            trial_set_group(t, k->other, g, trial_is_healthy(i, x) ? x : z->in[g]);
            return true;
        }
        n -= readings;
    }
    trial_draw_inputs(t, k->other, s, false, false);
    trial_unify_groups(t, k->other);
    trial_set_group(t, k->other, c->sensor, c->reading);
    return n < OTHERS;
}

// Whether the effect is the same for all tried readings of other sensors from z->begin on, of which at least QUIET_LEAST
// leave the healthy machine in its state until the time of the effect.  Other readings show nothing.
// Earlier readings of other sensors and earlier commands are not varied, because only the current situation counts.
static bool is_effect_independent_of_other_sensors(FailureSearch *k, const FailureCase *c, const FailureEffect *e)
{
    FailureTrial *z = &k->run;
    Trials *t = z->t;
    double *in = z->in;
    const uint32_t clock = z->clock;
    const double reading = z->reading;
    const double *level = z->leaves ? NULL : &z->level[t->a->m->var_of[e->output[0]->index]];
    bool needed = false;
    uint32_t quiet = 0;                   // number of readings with which the healthy machine stayed in its state
    FailureEffect again;

    trial_copy_situation(t, k->saved, z->begin);
    z->rise = FAILURE_RISE_CONFIRMED;
    z->only = e->at->number;
    for (uint32_t n = 0; !needed && choose_other_readings(k, c, n); n++) {
        trial_copy_situation(t, z->healthy, k->saved);
        z->clock = clock;
        z->others = noise_of_others[n % 3];
        z->in = k->other;
        if (failure_run_to_steady_state(z, c)) {
            StepEffect effect;
            z->reading = z->now[c->sensor];
            trial_copy_situation(t, z->begin, z->healthy);
            effect = failure_run(z, c, &again);
            if (effect != HEALTHY_LEFT || again.steps > e->steps) {
                quiet++;
                needed = effect != HAS_EFFECT && (!level || *level == 0);
            }
        }
        z->in = in;
    }
    trial_copy_situation(t, z->begin, k->saved);
    z->clock = clock;
    z->reading = reading;
    z->others = 0;
    z->rise = FAILURE_RISE;
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
    found = failure_run(z, &other, &effect) == HAS_EFFECT;
    z->only = 0;
    return found;
}

// Whether a run in which no step is skipped has the same effect.  If so, describes that run in *e.
static bool confirm_exactly(FailureTrial *z, const FailureCase *c, FailureEffect *e)
{
    const Stmt *at = e->at;
    StepEffect effect;

    z->exact = e->steps + STEPS_AFTER_GUESS;
    effect = failure_run(z, c, e);
    z->exact = 0;
    return effect == HAS_EFFECT && e->at == at;
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

// Whether the sensor can have failure f.
static bool is_failure_of_sensor(const TrialInput *i, FailureKind f)
{
    switch (f) {
    case READS_ZERO: case STICKS: return true;
    case READS_LOW_END: return i->v->range && i->lo != 0;
    case READS_HIGH_END: return i->v->range && i->hi != 0;
    case READS_FAR_ABOVE: case READS_FAR_BELOW: case FAILURES: break;
    }
    return false;
}

// Whether failure f is tried in case c.  A stuck sensor differs from a healthy one only if the healthy reading moves, so STICKS is tried
// only with motion, and the other failures only without.
static bool is_failure_of_case(const TrialInput *i, const FailureCase *c, FailureKind f)
{
    const bool reads_already = f == READS_LOW_END ? c->reading == i->lo : f == READS_HIGH_END ? c->reading == i->hi : c->reading == 0;

    return is_failure_of_sensor(i, f) && (f == STICKS ? c->motion != 0 : c->motion == 0 && !reads_already);
}

// Tries each failure of the sensor.  The healthy machine must be in a steady state.
static void try_failures(FailureSearch *k, FailureCase *c)
{
    FailureTrial *z = &k->run;
    FailureEffect e;

    trial_copy_situation(z->t, z->begin, z->healthy);
    z->reading = z->now[c->sensor];
    for (FailureKind f = READS_ZERO; f <= STICKS; f++) {
        bool found;
        c->failure = f;
        if (!trial_may_continue(z->t) || !is_failure_of_case(&z->t->input[c->sensor], c, f))
            continue;
        found = failure_run(z, c, &e) == HAS_EFFECT;
        k->tried |= z->cut ? 0 : 1u << f;
        if (!found || (z->leapt && !confirm_exactly(z, c, &e)) || is_intended(z, c, &e) ||
            !is_effect_independent_of_other_sensors(k, c, &e))
            continue;
        report_effect(z, c, &e);
        z->reported[e.at->number] = true;
    }
}

// Chooses the inputs of the n-th run from an entry of a state: first those with which the state was entered, then random readings of the sensors
// other than the failed one.  If the run must leave the state by itself, the inputs that are commands of an operator stay 0.
static void choose_failure_inputs(FailureTrial *z, const FailureCase *c, uint32_t n)
{
    Trials *t = z->t;

    memcpy(z->in, c->entry->in, t->inputs * sizeof *z->in);
    if (n > 0)
        trial_draw_inputs(t, z->in, &t->state[trial_state(c->entry->situation) - 1], n > 1, false);
    trial_unify_groups(t, z->in);
    trial_set_group(t, z->in, c->sensor, c->reading);
    for (uint32_t i = 0; i < t->inputs && z->leaves; i++)
        if (t->input[i].command)
            z->in[i] = 0;
}

// Tries all failures of the sensor at one healthy reading: when the machine is in a steady state, and then each time that a timer or counter
// has reached its limit, until the effort `until` is used.  Returns false if the machine does not stay in its state.
static bool try_reading(FailureSearch *k, FailureCase *c, uint32_t n, uint64_t until)
{
    FailureTrial *z = &k->run;
    Trials *t = z->t;

    choose_failure_inputs(z, c, n);
    t->pattern = c->entry->pattern;
    z->clock = 0;
    trial_copy_situation(t, z->healthy, c->entry->situation);
    if (!failure_run_to_steady_state(z, c))
        return false;
    k->lasted = true;
    do
        try_failures(k, c);
    while (t->run->work < until && failure_advance_to_next_timer(z, c));
    return true;
}

typedef struct FailureCases { const TrialEntry *entry[ENTRIES_TRIED]; uint32_t n; } FailureCases;

// Returns the situations from which the failures of a sensor are tried: healthy ones, if there are any.
static FailureCases cases_of(const TrialState *s)
{
    FailureCases l = {.n = 0};
    bool has_healthy_entry = false;

    for (size_t n = 0; n < s->entry.n; n++)
        has_healthy_entry |= !s->entry.at[n].unhealthy;
    for (size_t n = 0; n < s->entry.n && l.n < ENTRIES_TRIED; n++)
        if (!s->entry.at[n].unhealthy || !has_healthy_entry)
            l.entry[l.n++] = &s->entry.at[n];
    return l;
}

// Tries all readings of a sensor from one situation, with the n-th readings of the other sensors.  Each reading has an equal share of the
// effort.  `is_first`: each is tried once, whatever the effort, and with the first readings of the others with which the state lasts.
static void try_readings(FailureSearch *k, FailureCase *c, uint32_t n, bool is_first, uint64_t until)
{
    const Trials *t = k->run.t;
    const TrialInput *i = &t->input[c->sensor];

    for (uint32_t m = 0; m < i->readings; m++) {
        const uint64_t work = t->run->work, share = work < until ? work + (until - work) / (i->readings - m) : work;
        bool lasts = false;
        c->reading = i->reading[m];
        if (!trial_is_healthy(i, c->reading) || !(is_first ? trial_may_continue(t) : work < until))
            continue;
        for (uint32_t others = n; others < (is_first ? k->tries : n + 1) && !lasts && trial_may_continue(t); others++)
            lasts = try_reading(k, c, others, share);
    }
}

// Tries the failures of a sensor with one motion of its readings.  Visits the pairs of a situation and a choice of the other sensors' readings along
// the diagonals of their table, so that both vary from the beginning.
static void try_motion(FailureSearch *k, const FailureCases *l, FailureCase *c)
{
    const IrRun *run = k->run.t->run;
    const uint64_t until = run->work + k->effort / (c->motion == 0 ? 1 : MOTION_SHARE);

    for (uint32_t sum = 0; sum + 1 < l->n + k->tries; sum++)
        for (uint32_t e = 0; e <= sum && e < l->n; e++) {
            const uint32_t n = sum - e;
            const bool is_first = n == 0 && e < ENTRIES_FIRST;
            c->entry = l->entry[e];
            if (n < k->tries && (run->work < until || is_first))
                try_readings(k, c, n, is_first, run->work < until ? run->work + (until - run->work) / SHARE_OF_REST : run->work);
        }
}

// Tries the failures of one sensor from the entries of a state.
static void try_sensor(FailureSearch *k, const TrialState *s, uint32_t sensor)
{
    FailureTrial *z = &k->run;
    const Trials *t = z->t;
    const TrialInput *i = &t->input[sensor];
    const uint32_t motions = i->rough ? FAILURE_MOTIONS : FAILURE_MOTIONS_OF_SCALE;
    const FailureCases l = cases_of(s);
    bool depends_on_others = false;
    FailureCase c = {.sensor = sensor};

    memset(z->reported, 0, (t->a->p->stmts + 1u) * sizeof *z->reported);
    for (uint32_t n = 0; n < t->inputs; n++)
        depends_on_others |= s->relevant[n] && t->input[n].group != i->group;
    k->tries = depends_on_others ? OTHERS_FIRST : 1;
    k->kinds = k->tried = 0;
    k->lasted = false;
    for (FailureKind f = READS_ZERO; f <= STICKS; f++)
        k->kinds |= is_failure_of_sensor(i, f) ? 1u << f : 0;
    for (c.motion = 0; c.motion < motions; c.motion++)
        try_motion(k, &l, &c);
    if (l.n > 0 && (k->kinds & ~k->tried) != 0)
        trial_add_gap(t->gaps, (TrialGap){GAP_SENSOR, t->a->p->state.at[s - t->state], i->v, NULL});
}

// Whether failures of the input are tried in the state.
static bool tries_failures_of(const Trials *t, size_t state, uint32_t input) { return !t->input[input].command && t->state[state].relevant[input]; }

// Finds outputs that switch on, and @abort states that end, because one sensor has failed.
void check_output_on_zero(Trials *t)
{
    FailureSearch k = {.run = failure_trial_new(t)};
    uint64_t pairs = 1;

    k.saved = arena_alloc(t->a->arena, t->run->size);
    k.other = trial_new_inputs(t);
    for (size_t s = 0; s < t->a->p->state.n; s++)
        for (uint32_t i = 0; i < t->inputs; i++)
            pairs += tries_failures_of(t, s, i);
    k.effort = (effort_in_all / pairs < effort ? effort_in_all / pairs : effort) / t->share;
    for (size_t s = 0; s < t->a->p->state.n; s++) {
        k.run.leaves = t->a->p->state.at[s]->is_abort;
        for (uint32_t i = 0; i < t->inputs; i++)
            if (tries_failures_of(t, s, i))
                try_sensor(&k, &t->state[s], i);
    }
}
