// SPDX-License-Identifier: Apache-2.0
// The abort matrix: from which states a machine can abort, by which guards, after how many steps, and on which inputs this depends.
// Reports show the matrix.  The findings abort-blind and abort-single-sensor are derived from it.
//
//     const AbortMatrix x = abort_build_matrix(trials_of(a));
//     for (size_t s = 0; s < x.n; s++)                          // x.row[s] is the row of the state with State.number s + 1
//         for (size_t k = 0; k < x.row[s].path.n; k++) …
//
// The analysis' arena owns the matrix.
#ifndef SMC_ABORT_H
#define SMC_ABORT_H

#include "compiler/analysis/input_deps.h"
#include "compiler/analysis/trial.h"

#define ABORT_NOT_BOUNDED UINT32_MAX      // a number of steps that is unknown, because the machine may wait in a state on the path

// One transition out of a state from which every path ends in an @abort state.
typedef struct AbortPath {
    const Transition *first;      // the transition, with its condition (first->when) and its source position (first->stmt->span)
    const char *guard;            // text of the condition of `first` (condition_text); "" if the transition is unconditional
    uint32_t steps;               // the most steps from the step in which the guard is true to the first step in an @abort state; 1:
                                  // the transition itself leads to an @abort state
    const Var **sensor;           // the sensors that the guard of `first` depends on, also through windows and locals
    size_t sensors;
    bool by_time;                 // the guard of `first` depends on T or G
    bool by_input;                // the guard of `first` depends on an input that is not a sensor: a bool, or a command (an integer that is only
                                  // compared by == or !=)
    bool by_command;              // the guard of `first` depends on a command; where no element is marked @command, the same as by_input
    bool possible;                // the facts allow the transition to be taken
} AbortPath;

typedef enum AbortVerdict {
    ABORT_ITSELF,                 // the state is an @abort state
    ABORT_UNREACHED,              // the machine never reaches the state
    ABORT_NO_PATH,                // no transition out of the state starts a path that always ends in an @abort state
    ABORT_LATER,                  // the machine aborts from this state only through states in which it may wait
    ABORT_BY_COMMAND,             // the machine aborts from this state only if a person gives a command
    ABORT_ONE_SENSOR,             // the machine cannot abort from this state if one sensor fails: `single` or `blind`
    ABORT_OK                      // the machine can abort from this state, also if one sensor fails
} AbortVerdict;

typedef struct AbortRow {
    const State *state;
    AbortVerdict verdict;
    VEC(AbortPath) path;          // the paths from the state, in file order
    uint32_t steps;               // the highest AbortPath.steps of the paths that take a bounded number of steps; 0: no path does
    const Var *single;            // if this sensor sticks at `stuck`, which can be a healthy reading, no path remains; or NULL
    SmF64 stuck;                  // the reading of `single`
    const Var *blind;             // if this sensor reads `blind_at`, no path remains; or NULL
    const char *blind_at;         // "0", "more than 40", "0 or less than -5"
    const Var *latch;             // a variable whose old value prevents an abort when the state is entered again; or NULL
    const AbortPath *latched;     // the path whose guard reads `latch`
    double latched_at;            // the old value of `latch`
    bool drives;                  // an output was on in this state in some trial
    bool by_itself;               // some trial aborted, or left the state at once, without a command
    bool by_command;              // no trial without commands aborted or left at once, but some trial with a command did
    const State *next;            // the next state of the longest path from this state; NULL: there is no path, or this is an @abort state
} AbortRow;

typedef struct AbortMatrix {
    bool declared;                // some state is marked @abort; otherwise every row has ABORT_NO_PATH or ABORT_UNREACHED
    AbortRow *row;
    size_t n;
    const InputDepsTable *deps;   // the inputs on which variables and guards depend; NULL if no state is marked @abort
} AbortMatrix;

AbortMatrix abort_build_matrix(Trials *t);

// Returns the state after s on the longest path.  To visit the states of a path: start with first->to, and call this until the state
// is marked @abort.
const State *abort_next_state(const AbortMatrix *x, const State *s);

// Returns the first path of the row that is bounded and whose guard reads the variable itself, also through a window; NULL: there is none.
const AbortPath *abort_path_that_reads(const AbortRow *r, const Var *v);

// ---- inside compiler/analysis ----

// Indexed by state (State.number - 1).
typedef struct AbortBound {
    bool *bound;                  // by state: the state is an @abort state, or each of its transitions leads to an @abort state or a bound state
    uint32_t *steps;              // of a bound state: the most steps until the machine is in the @abort state, or ABORT_NOT_BOUNDED
    const State **next;           // of a bound state that is not an @abort state: the next state on the longest path
} AbortBound;

AbortBound abort_find_bound(Analysis *a);
bool abort_is_bounded(const AbortPath *p);     // whether p can be taken and reaches an @abort state within a bounded number of steps

// abort_sensors.c: fills in the inputs that the paths of each row depend on, and the results of the trials.
void abort_run_trials(Trials *t, AbortMatrix *x, const AbortBound *b);

// abort_commands.c: reports the states that cannot abort on a bool input on which nearly all others do.
void abort_report_skipped_inputs(Trials *t, const AbortMatrix *x);

#endif
