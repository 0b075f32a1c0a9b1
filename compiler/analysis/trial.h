// SPDX-License-Identifier: Apache-2.0
// Trial runs: the machine is run, from situations that it can reach, with inputs that are chosen to make its conditions come out
// both ways.  A question supposes something (a sensor fails, a window is full, nothing changes any more) and compares what the
// machine does with what it would have done.  What a trial shows does happen with those inputs; what no trial shows may
// happen all the same.
//
// All choices come from one generator with a fixed seed, and the effort is bounded by instructions, not by time: the same machine
// gives the same findings everywhere.
//
// What inputs are:
//   sensor    a number that the machine only reads
//   command   what a person operates: an element marked @command; a bool, or a number that is only compared with constants by ==
//             and !=, that the machine only reads
// Sensors that are added, compared, averaged or stored in the same variable, or that one state compares in the same way, measure the
// same quantity: they form a group, and a healthy group reads one number.
#ifndef SMC_TRIAL_H
#define SMC_TRIAL_H

#include "compiler/analysis/analysis.h"
#include "compiler/ir/run.h"

typedef struct TrialInput {
    const Var *v;
    uint32_t var;                     // in IrMachine.var
    bool command;
    uint32_t group;                   // the first input (index) of its group
    double lo, hi;                    // what a healthy sensor reads: @range, or what its type holds
    double *reading;                  // readings that differ in what comparisons make of them, ascending
    uint32_t readings;
    bool rough;                       // no comparison tells the scale
    double scale;                     // of its group: how far apart its readings are: the unit for noise and slopes
} TrialInput;

// A situation just before the first step in a state.
typedef struct TrialEntry {
    void *situation;
    double *in;                       // inputs of the step that led here, by input
    const Transition *via;            // NULL: the start
    uint32_t steps;                   // that have run since the start; TRIAL_MANY: many, or an unknown number
    bool sick;                        // on the way a sensor has left its healthy range, or disagreed with its group
    bool commanded;                   // a person has changed a command on the way
    uint64_t key;                     // which locals and elements are zero
} TrialEntry;
#define TRIAL_MANY UINT32_MAX

// What the step after a transition did, over all trials, with the inputs that led to the transition.
typedef struct TrialNext {
    uint32_t trials, left;            // how many; how many of them made a transition
    uint32_t transition;              // Stmt.number of the one that most made, if most made one
    int most;                         // by how many more than any other
} TrialNext;

typedef struct TrialState {
    VEC(TrialEntry) entry;
    bool *relevant;                   // by input: what the state does can depend on it
} TrialState;

typedef struct Trials {
    Analysis *a;
    IrRun *run;
    TrialInput *input;
    uint32_t inputs;
    TrialState *state;                // by State.number - 1
    const Transition **transition;    // by Stmt.number
    const Stmt **stmt;                // by Stmt.number; of 0 NULL
    const State **state_of;           // by Stmt.number
    const Condition **when;           // by Stmt.number: what it is under
    bool *taken;                      // by Stmt.number of a transition: some trial made it
    bool *by_time;                    // by Stmt.number of a transition: its condition depends on T or G
    TrialNext *next;                  // by Stmt.number of a transition
    bool *actuator;                   // by IR variable
    double *peak;                     // by IR variable: the largest magnitude it had in a trial
    const Var **var;                  // by IR variable
    double *wait;                     // times that conditions on T and G wait for, ascending
    uint32_t waits;
    bool stamped;                     // some variable holds a time: waits begin at any time
    double **limit;                   // by IR variable that only counts by a constant: what it is compared with, ended by NaN; else NULL
    double dt;                        // how far G advances in a step
    uint32_t window;                  // samples until every window is full
    bool *computed;                   // by IrMachine.window: it samples what the machine itself writes
    uint32_t count;                   // limits of counters, in all
    uint64_t random;
    double *before;                   // variables before a step, for trial_pass
    void *scratch;                    // a situation, for trial_fill_windows
    IrTrace trace;
} Trials;

#define TRIAL_SEED 20221              // where the choices of each question begin

Trials *trials_of(Analysis *a);

// ---- running ----

void *trial_copy(const Trials *t, void *to, const void *from);
// One step, G being dt after the last one.
void trial_step(Trials *t, void *situation, const double *in, double dt, IrTrace *trace);
static inline uint32_t trial_state(const void *situation) { return ((const IrSituation *)situation)->state; }
static inline const double *trial_vars(const Trials *t, const void *situation)
{
    return (const double *)(const void *)((const char *)situation + t->run->vars);
}
static inline bool trial_entering(const void *situation) { return ((const IrSituation *)situation)->first; }
// How many steps like the last one, which led from the variables `before` to the situation, can follow before a timer or a counter
// comes to a limit.  0: something changes that is no counter.  TRIAL_MANY: nothing can happen any more.
// The same of timers alone, whatever else changes.
uint32_t trial_wait_steps(const Trials *t, const void *situation);
uint32_t trial_leap_steps(const Trials *t, const double *before, const void *situation);
// Makes them at once.  Windows keep their samples.
void trial_leap(const Trials *t, const double *before, void *situation, uint32_t steps);
// Some steps, and then as many more as nothing happens in.  False: nothing can happen any more while inputs stay as they are.
bool trial_pass(Trials *t, void *situation, const double *in, IrTrace *trace);
enum { TRIAL_PASSES = 300 };          // after so many a machine that still does something goes on so
// Whether a timer or a counter that goes up has come closer to a limit since variables were `before`, in the same state: it can still get there.
bool trial_advances(const Trials *t, const double *before, const void *situation);
// Whether anything but time differs between two situations.
bool trial_same(const Trials *t, const void *a, const void *b);
// A variable that the machine writes, that one of these conditions reads, and that differs between two situations; NULL: there is none.
const Var *trial_differing(const Trials *t, const Condition *when, const void *a, const void *b);
// Begins at an entry, with the inputs that led there; without any command, unless the state lasts only with those.  Chooses other
// readings where the state does not last with these.
void trial_begin(Trials *t, const TrialEntry *e, void *situation, double *in);
// Fills every window with samples taken while the inputs read this; what windows hold of variables that the machine writes stays.
void trial_fill_windows(Trials *t, void *situation, const double *in);

// ---- choosing ----

uint32_t trial_below(Trials *t, uint32_t n);                      // 0 … n - 1; 0 if n is 0
double *trial_new_inputs(Trials *t);                              // one array for all inputs
double trial_some_reading(Trials *t, const TrialInput *i, bool sick);     // within @range unless sick
// Other readings for the inputs that matter to the state: groups read one number.  Commands are changed only with `commands`.
void trial_draw(Trials *t, double *in, const TrialState *s, bool commands, bool sick);
// Sensors, sick ones too, and bools that are not marked @command.
void trial_draw_free(Trials *t, double *in, const TrialState *s);
// Noise on sensors, so much of their scale at most, the same on each of a group; healthy readings stay within their range.
void trial_add_noise(Trials *t, double *in, double most);
// Makes every group read one number.
void trial_tie_groups(const Trials *t, double *in);
void trial_set_group(const Trials *t, double *in, uint32_t input, double reading);
bool trial_is_healthy(const TrialInput *i, double reading);

#endif
