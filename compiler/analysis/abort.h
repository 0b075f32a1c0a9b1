// SPDX-License-Identifier: Apache-2.0
// The abort matrix: from which states a machine can abort, by which guards, how fast, and what the ability hangs on.  Reports show
// it, the findings abort-blind and abort-single-sensor are drawn from it.
//
//     const AbortMatrix x = abort_matrix(trials_of(a));
//     for (size_t s = 0; s < x.n; s++)                          // x.row[s] is of State.number s + 1
//         for (size_t w = 0; w < x.row[s].way.n; w++) …
//
// All of it lives in the analysis' arena.
#ifndef SMC_ABORT_H
#define SMC_ABORT_H

#include "compiler/analysis/sensors.h"
#include "compiler/analysis/trial.h"

#define ABORT_NOT_BOUNDED UINT32_MAX      // of steps: a state on the way may wait for something

// One transition out of a state that leads to @abort states and nowhere else.
typedef struct AbortWay {
    const Transition *first;      // its condition is first->when, its place first->stmt->span
    const char *guard;            // condition_text of it; "" where it stands alone
    uint32_t steps;               // at worst, from the step in which the guard holds to the first in an @abort state: 1 directly
    const Var **sensor;           // that its guard looks at, through windows and locals too
    size_t sensors;
    bool by_time;                 // its guard looks at T or G
    bool by_input;                // at a bool or a command (an integer that is only compared by == or !=), which are no sensors
    bool possible;                // it can be made at all
} AbortWay;

typedef enum AbortVerdict {
    ABORT_ITSELF,                 // an @abort state
    ABORT_UNREACHED,              // the machine never comes here
    ABORT_NO_PATH,                // no transition from here leads to @abort states only
    ABORT_LATER,                  // only through states that may wait
    ABORT_BY_COMMAND,             // only when a person gives a command
    ABORT_ONE_SENSOR,             // no way is left if one sensor fails: `single` or `blind`
    ABORT_OK
} AbortVerdict;

typedef struct AbortRow {
    const State *state;
    AbortVerdict verdict;
    VEC(AbortWay) way;            // in file order
    uint32_t steps;               // the worst of those ways that are bounded; 0: none is
    const Var *single;            // if this one sticks at `stuck`, which may well be a healthy reading, no way is left; or NULL
    SmF64 stuck;
    const Var *blind;             // if this one reads `blind_at`, no way is left; or NULL
    const char *blind_at;         // "0", "more than 40", "0 or less than -5"
    const Var *latch;             // what keeps it from aborting when it begins again; or NULL
    const AbortWay *latched;      // the transition that reads it
    double latched_at;            // its value then
    bool drives;                  // some trial had an output on in this state
    bool by_itself;               // some trial aborted, or left the state at once, without a command
    bool by_command;              // no trial did, but with a command some did
    const State *onward;          // where a way leads on from here at worst; NULL: nowhere, or this is an @abort state
} AbortRow;

typedef struct AbortMatrix {
    bool declared;                // some state is marked @abort; else every row says ABORT_NO_PATH or ABORT_UNREACHED
    AbortRow *row;
    size_t n;
    const Sensors *sensors;       // where some state is marked
} AbortMatrix;

AbortMatrix abort_matrix(Trials *t);

// The states of a way in order: first->to, then what this gives, until it is marked @abort.
const State *abort_onward(const AbortMatrix *x, const State *s);

// ---- inside compiler/analysis ----

// By state (State.number - 1).
typedef struct AbortBound {
    bool *bound;                  // it is an @abort state, or all its ways out lead to bound states
    uint32_t *steps;              // of a bound one: at worst until the machine is in the @abort state, or ABORT_NOT_BOUNDED
    const State **onward;         // of a bound one that is no @abort state: the next one on that way
} AbortBound;

AbortBound abort_bound(Analysis *a);
uint32_t abort_one_more(uint32_t steps);
bool abort_is_sure(const AbortWay *w);         // it can be made, and then the machine is in an @abort state within some steps

// Fills in what the ways of each row look at, and what trials show.
void abort_ask(Trials *t, AbortMatrix *x, const AbortBound *b);

#endif
