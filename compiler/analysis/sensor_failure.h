// SPDX-License-Identifier: Apache-2.0
// Runs two machines side by side from one situation.  In the healthy machine, every reading is constant or has a *motion*: a small change
// from step to step, as a ramp, an oscillation or noise.  In the failed machine, one sensor fails.  If the healthy machine stays in its
// state and an output switches on in the failed one, the failure is the cause.
#ifndef SMC_SENSOR_FAILURE_H
#define SMC_SENSOR_FAILURE_H

#include "compiler/analysis/abort.h"
#include "compiler/analysis/trial_checks.h"

// How a sensor fails: it reads 0, the lower or upper end of its @range, its last healthy reading forever, or a number far outside its range.
typedef enum FailureKind { READS_ZERO, READS_LOW_END, READS_HIGH_END, STICKS, READS_FAR_ABOVE, READS_FAR_BELOW, FAILURES } FailureKind;

typedef struct FailureCase {      // one trial: the sensor reads `reading`, with a motion, and fails at some time
    const TrialEntry *entry;
    uint32_t sensor;                  // the failing sensor: index in Trials.input
    double reading;                   // the reading of the sensor before it fails, without motion
    uint32_t motion;              // how the readings move: one of FAILURE_MOTIONS; 0: not at all
    FailureKind failure;
} FailureCase;

enum {
    FAILURE_MOTIONS = 6, FAILURE_MOTIONS_OF_SCALE = 4,      // all motions; those (the first ones) that are used if the sensor's scale is known
    FAILURE_OUTPUTS = 4           // the most outputs that one effect names
};

typedef struct FailureEffect {
    uint32_t transition;          // the first transition of the failed machine (Stmt.number); 0: none
    const Stmt *at;               // the statement that only the failed machine executed: a transition, or an assignment
    const Var *output[FAILURE_OUTPUTS];
    const Stmt *on[FAILURE_OUTPUTS];    // by entry of `output`: the assignment that switched it on
    uint32_t outputs;
    double before, failed;        // readings of the sensor just before it failed (without noise) and just after
    uint32_t steps;               // number of steps from the failure to the effect
} FailureEffect;

typedef struct FailureTrial {
    Trials *t;
    AbortBound bound;                 // the states that always lead to an @abort state
    void *healthy, *failed;       // the situations of the two machines
    void *begin;                  // the situation when the sensor fails
    double *in;                   // inputs without motion
    double *now, *broken;         // inputs of this step: of the healthy machine, of the failed one
    double *before, *before_failed;       // variables before a step, of the two machines
    double *earlier, *earlier_failed;     // variables before the previous step, of the two machines
    uint32_t sensor;              // the failing sensor: index in Trials.input
    double reading;               // the sensor's reading in the step before it fails
    uint32_t clock;               // number of steps in this trial, from which the motion is computed
    double *level;                // by IR variable: the variable's largest magnitude in the healthy machine before the sensor fails
    uint32_t only;                // Stmt.number: only an effect that this statement causes counts; 0: any effect
    bool *reported;               // by Stmt.number: already reported for this sensor and state
    double others;                // largest noise on other sensors, in units of the distance to the next reading that a comparison distinguishes
    double rise;                  // an output counts as switched on if it rises by this fraction of its largest level
    bool leaves;                  // the state is an @abort state: the effect is that the machine leaves it
    uint32_t exact;               // the most steps of an exact run, which skips no step that changes more than counters; 0: leaps are allowed
    bool leapt;                   // the last run has leapt over steps that change more than counters
    bool cut;                     // the last run ended while timers or counters still approached their limits
} FailureTrial;

// Values of FailureTrial.rise: in the search for an effect, and while a found effect is tried with other readings.
#define FAILURE_RISE 0.5                // half of the output's largest level: an output that a control law moves a little is not switched on
#define FAILURE_RISE_CONFIRMED 0.02     // any visible rise of the output that has been switched on once

// INCONCLUSIVE: the failed machine reacts in a way that is intended, or that has been reported.  HEALTHY_LEFT: the healthy machine has left
// its state, so that it can no longer be compared.
typedef enum StepEffect { NO_EFFECT, INCONCLUSIVE, HEALTHY_LEFT, HAS_EFFECT } StepEffect;

FailureTrial failure_trial_new(Trials *t);
// Whether motion number `motion` (see FailureCase) adds noise to the readings.
bool failure_has_noise(uint32_t motion);
// Runs the healthy machine until its rolling windows contain only the current inputs.  Returns false if the machine leaves its state.
bool failure_run_to_steady_state(FailureTrial *z, const FailureCase *c);
// Runs the healthy machine from z->begin until the next timer or counter reaches its limit, and then to a steady state.  Returns
// false if the machine leaves its state, or if no timer or counter is running.
bool failure_advance_to_next_timer(FailureTrial *z, const FailureCase *c);
// Runs both machines from z->begin, the situation in which the sensor fails, and describes the first effect in *e.
StepEffect failure_run(FailureTrial *z, const FailureCase *c, FailureEffect *e);

#endif
