// SPDX-License-Identifier: Apache-2.0
// Trial runs: the machine is simulated from situations that it can reach, with inputs that are chosen to make its conditions true
// and false.  A situation is the complete state of a running machine: its state, variables and rolling windows.  A check compares the
// machine's behaviour with and without an assumption (a sensor fails, a window is full, inputs stay constant).  Behaviour that a trial
// shows does occur with those inputs.  Behaviour that no trial shows may still occur.
//
// All choices come from one generator with a fixed seed, and the effort is bounded by instructions, not by time.  So the same
// machine produces the same findings everywhere.
//
// Inputs are:
//   sensor    a number that the machine only reads
//   command   operated by a person: an element marked @command; a bool that the machine only reads, or a number that it only reads
//             and only compares with constants by == and !=
// Sensors measure the same quantity if they are added, compared, averaged or stored in the same variable, or if one state
// compares them in the same way.  They form a group, and in a healthy group all sensors read the same number.
#ifndef SMC_TRIAL_H
#define SMC_TRIAL_H

#include "compiler/analysis/analysis.h"
#include "compiler/analysis/trial_gaps.h"
#include "compiler/ir/ir_run.h"

typedef struct TrialInput {
    const Var *v;
    uint32_t var;                     // index in IrMachine.var
    bool command;               // the input is operated by a person; false: a sensor
    uint32_t group;                   // index in Trials.input of the first input of this input's group
    double lo, hi;                    // the range of healthy readings: the @range, or the range of the element's type
    double *reading;                  // readings that comparisons distinguish, ascending: `readings` of them
    uint32_t readings;
    bool rough;                       // `scale` is unknown: the sensor has no @range and no comparison with other values
    double scale;                     // width of the range of the group's readings: the unit of noise and slopes
} TrialInput;

// How an input goes on by itself in trials that begin along a run of the search: a feedback follows an output, a counter counts, a reading moves.
// Without that, a machine that checks its feedbacks and counters leaves every state.
typedef struct TrialPattern {
    ScenarioKind kind;                // SCENARIO_HOLD: the input has the value that the trial chooses
    uint32_t source;                  // COPY: IR variable that the input follows
    double by;                        // RAMP: added in each step; ALTERNATE: added in every second step
} TrialPattern;

// A situation just before the first step in a state.
typedef struct TrialEntry {
    void *situation;
    double *in;                       // by input: the value of the input in the step that led to this situation
    const Transition *via;            // the transition that led to this situation; NULL: the machine's start
    uint32_t steps;                   // number of steps since the machine's start; TRIAL_MANY: many, or an unknown number
    bool unhealthy;                   // earlier in this trial a reading was outside its healthy range, or differed from others of its group
    bool commanded;                   // earlier in this trial a person changed a command
    const TrialPattern *pattern;      // by input: how it went on in the run that led to this situation; NULL: no input did
    uint64_t key;                     // a hash of the variables, by which similar situations are recognised (entry_key)
} TrialEntry;
#define TRIAL_MANY UINT32_MAX

// Counts over all trials what the machine does in the step after a transition, with the inputs that led to the transition.
typedef struct TrialNext {
    uint32_t trials, left;            // number of trials that ran such a step; in how many of them the machine left the state in this step
    uint32_t transition;              // Stmt.number of the majority's transition, by the Boyer-Moore vote; 0: none is made
    int most;                         // the counter of the majority vote; above 0 if there is a majority
} TrialNext;

typedef struct TrialState {
    bool reached;                     // the search has reached the state from the machine's start
    VEC(TrialEntry) entry;      // the situations found at the entry of the state
    bool *relevant;                   // by input: the state's behaviour can depend on this input
} TrialState;

// The values that the parameters of the machine have in all trials: their defaults, or the lower or upper ends of their ranges.
typedef enum TrialSetting { TRIAL_DEFAULTS, TRIAL_LOWEST, TRIAL_HIGHEST, TRIAL_SETTINGS } TrialSetting;

typedef struct Trials {
    Analysis *a;
    TrialSetting setting;
    uint32_t share;                   // limits on the number of instructions are divided by this: 1, or the number of settings of the parameters
    TrialGaps *gaps;                  // receives what is not tried; may be NULL
    struct TrialNear *near;           // records the guards of the search's steps (trial_near.h); NULL: not searching
    IrRun *run;
    uint64_t until;                   // value of run->work at which the present check ends
    uint64_t check_at;                // value of run->work at which trial_step lets the host end the trials
    TrialInput *input;
    uint32_t inputs;
    TrialState *state;                // state[State.number - 1]
    const Transition **transition;    // by Stmt.number: the transition that the statement is; or NULL
    const Stmt **stmt;                // stmt[Stmt.number] is the statement; [0] is NULL
    const State **state_of;           // by Stmt.number: the state that contains the statement
    const Condition **when;           // by Stmt.number: the conditions around the statement
    bool *taken;                      // by Stmt.number of a transition: the transition was taken in some trial
    bool *by_time;                    // by Stmt.number of a transition: the transition's condition depends on T or G
    TrialNext *next;                  // by Stmt.number of a transition: what the machine does in the step after it
    bool *actuator;                   // by IR variable: the variable is an output that drives something (is_actuator)
    bool *rests_on;                   // by IR variable: check_output_left_on has reported that the output stays on
    double *peak;                     // by IR variable: if it is an actuator, its largest magnitude during the search
    const Var **var;                  // by IR variable: the variable in the Program
    double *wait;                     // the times that conditions compare T and G with, ascending
    uint32_t waits;
    bool *stamp;                      // by IR variable: assignments store G in the variable, and waits begin at that time
    bool stamped;                     // some variable is computed from a time: waits may begin at any time
    double **limit;                   // by IR variable: for a counter, the values with which it is compared, followed by NaN; otherwise NULL
    double dt;                        // how much G advances in a step
    double run_time;                  // the longest time that a condition must be true (`held`); 0: none
    uint32_t window;                  // number of samples until every window is full and `run_time` is over
    bool *samples_written;            // by index in IrMachine.window: the window samples variables that the machine writes
    uint32_t count;                   // number of limits of all counters (`limit`)
    uint64_t random;              // state of the pseudo-random generator
    double *before;                   // variables before a step, for trial_advance_to_event
    const TrialPattern *pattern;      // by input: how it goes on in the present trial; NULL: no input does
    uint32_t broken;                  // index of an input that has no pattern now, because it has failed; IR_NONE: no input has failed
    void *scratch;                    // memory for a situation that trial_fill_windows needs
    IrTrace trace;                // what the last step has executed
} Trials;

#define TRIAL_SEED 20221              // the seed for the choices of each check

// Prepares trials with the defaults of parameters, and with all effort.
Trials *trials_of(Analysis *a);
// Prepares trials with a setting, which have 1 / share of the effort.  `gaps` lists what they do not try; it may be NULL.
Trials *trials_at(Analysis *a, TrialSetting setting, uint32_t share, TrialGaps *gaps);
// Returns the value of a parameter in these trials.
double trial_value_of_parameter(TrialSetting setting, const Var *v);

// ---- running ----

// Whether the present check may execute further instructions.  A check that may not continue must conclude nothing from trials not run.
static inline bool trial_may_continue(const Trials *t) { return t->run->work < t->until; }

void *trial_copy_situation(const Trials *t, void *to, const void *from);        // returns `to`; NULL: allocates the copy
// Runs one step with the inputs `in`; G is dt later than in the last step.
void trial_step(Trials *t, void *situation, const double *in, double dt, IrTrace *trace);
static inline uint32_t trial_state(const void *situation) { return ((const IrSituation *)situation)->state; }
static inline const double *trial_vars(const Trials *t, const void *situation)
{
    return (const double *)(const void *)((const char *)situation + t->run->vars);
}
static inline bool trial_is_entering(const void *situation) { return ((const IrSituation *)situation)->first; }
// Returns how many steps that change the variables like the last step can follow before a timer or a counter reaches a limit.  The last
// step led from the variables `before` to the situation.  0: a variable that is not a counter has changed.  TRIAL_MANY: no limit is ahead.
uint32_t trial_steps_to_event(const Trials *t, const double *before, const void *situation);
// Returns how many steps can follow before a timer reaches a limit, whatever else changes; TRIAL_MANY: no limit is ahead.
uint32_t trial_steps_to_timer(const Trials *t, const void *situation);
// Returns how many steps can follow before a timer or a counter reaches a limit, whatever else changes; TRIAL_MANY: no limit is ahead.
uint32_t trial_steps_to_limit(const Trials *t, const double *before, const void *situation);
// Advances time and counters by `steps` steps that change the variables like the last step (see trial_steps_to_event).  If the machine
// has conditions that must be true for some time, samples windows with the inputs of the last step; else windows keep their samples.
void trial_skip_steps(const Trials *t, const double *before, void *situation, uint32_t steps);
// Whether two changes of a variable, in two steps, are equal apart from rounding.
bool trial_is_even(double before, double now);
// Advances like trial_skip_steps.  Variables that have changed by the same amount in the last two steps continue to do so, and others keep
// their values.  That is a guess: the last two steps led from the variables `earlier` to `before`, and from there to the situation.
void trial_leap(const Trials *t, const double *earlier, const double *before, void *situation, uint32_t steps);
// Runs with constant inputs: steps until a transition, or until only timers and counters change, at most 40; then, without a transition, skips
// the steps that remain before the next timer or counter reaches its limit.  Returns false if none will: nothing can change any more.
bool trial_advance_to_event(Trials *t, void *situation, const double *in, IrTrace *trace);
enum { TRIAL_ADVANCES = 300 };          // after this many calls of trial_advance_to_event, a machine that still changes is assumed to change forever
// Whether a timer or a rising counter has moved closer to a limit since the variables were `before`, so that it may reach the limit later.
bool trial_approaches_limit(const Trials *t, const double *before, const void *situation);
// Whether two situations are in the same state, with equal values in all variables that the machine writes, except G, S and T.
bool trial_is_same_situation(const Trials *t, const void *a, const void *b);
// Returns a variable that the machine writes, that one of these conditions reads, and that differs between two situations; or NULL.
const Var *trial_find_difference(const Trials *t, const Condition *when, const void *a, const void *b);
// Copies the situation of an entry, and sets `in` to the inputs that led to it, or to other readings if the machine would leave the
// state with those inputs.  All commands are 0, unless the machine stays in the state only with the commands that led to the entry.
void trial_begin_at_entry(Trials *t, const TrialEntry *e, void *situation, double *in);
// Fills every window with samples of the inputs of the last step, and of how they go on, for steps that were skipped.
void trial_fill_skipped(const Trials *t, void *situation, uint32_t samples);
// Fills every window with samples of these inputs.  Windows over variables that the machine writes keep their samples.
void trial_fill_windows(Trials *t, void *situation, const double *in);

// ---- choosing ----

uint32_t trial_random_below(Trials *t, uint32_t n);               // a pseudo-random number from 0 to n - 1; 0 if n is 0
double *trial_new_inputs(Trials *t);                              // a new array with a reading for each input
double trial_pick_reading(Trials *t, const TrialInput *i, bool unhealthy);     // one of i's readings; within @range unless `unhealthy`
// Draws readings for the inputs that the state depends on (all inputs if s is NULL).  The sensors of a group mostly read the same
// number.  Commands change only with `commands`.
void trial_draw_inputs(Trials *t, double *in, const TrialState *s, bool commands, bool unhealthy);
// Draws readings, unhealthy ones too, for the sensors that the state depends on, and for bools that are not marked @command.
void trial_draw_inputs_freely(Trials *t, double *in, const TrialState *s);
// Adds noise to sensors: at most the fraction `most` of their scale, equal for all sensors of a group.  Healthy readings stay within
// their range.
void trial_add_noise(Trials *t, double *in, double most);
// Makes all sensors of a group read the same number as the first sensor of the group.
void trial_unify_groups(const Trials *t, double *in);
void trial_set_group(const Trials *t, double *in, uint32_t input, double reading);      // sets all sensors of the group of `input`
bool trial_is_healthy(const TrialInput *i, double reading);        // whether the reading is from i->lo to i->hi
double trial_clamp_reading(const TrialInput *i, double reading);          // returns the reading limited to i's @range; unchanged without a @range
// Stores the inputs in the variables of a situation, converted to the types of the variables.
void trial_store_inputs(const Trials *t, double *vars, const double *in);

#endif
