// SPDX-License-Identifier: Apache-2.0
// A scenario: the values that the inputs of a machine have from its start on, and how long it runs.  Searches produce scenarios, and scripts
// are written from them.
//
// The machine starts in `init_state`.  Step k, counted from 1, runs with G = (k - 1) * delta_t.  Before it runs, the inputs are set: for each
// variable, the last change with a step of at most k determines the value.  A variable without such a change keeps its initial value, as in a
// script (language.md 8.12).  The scenario ends after step `steps`.
#ifndef SMC_SCENARIO_H
#define SMC_SCENARIO_H

#include "compiler/script/engine.h"
#include "compiler/sema/program.h"

typedef enum ScenarioKind {
    SCENARIO_HOLD,            // a in each step
    SCENARIO_ALTERNATE,       // a in the step of the change, b in the next one, then a again: a sensor with noise
    SCENARIO_RAMP,            // a in the step of the change, and b more in each step after it
    SCENARIO_COPY             // the value that `source` has when the step begins, so that a feedback follows its command
} ScenarioKind;

typedef struct ScenarioChange {
    uint64_t step;            // the first step in which the change applies
    uint32_t var;             // index into Program.var: what is set
    ScenarioKind kind;
    double a, b;              // parameters of `kind`; values are converted to the variable's type as by an assignment (language.md 2.13)
    uint32_t source;          // COPY: index into Program.var of the variable whose value is copied
} ScenarioChange;

// A loop repeats the changes in the steps `from` to from + period - 1: each is made again every `period` steps, as long as the step is below
// `to`.  All of them are HOLDs of variables that the machine never stores, and no other change is made from `from` to `to`.
typedef struct ScenarioLoop { uint64_t from, period, to; } ScenarioLoop;

typedef struct Scenario {
    const State *init_state;
    uint64_t delta_t;         // by how much G grows in a step; at least 1
    uint64_t steps;
    const ScenarioChange *change;     // sorted by step; at most one for each variable and step
    size_t changes;
    const ScenarioLoop *loop; // sorted by `from`; loops do not overlap
    size_t loops;
} Scenario;

// How many times there are at which inputs change: the changes of one step have one time.
size_t scenario_times(const Scenario *s);
// The loop that repeats a change made in this step; NULL: none.
const ScenarioLoop *scenario_loop_at(const Scenario *s, uint64_t step);
// Returns the same scenario without loops: every change is listed as often as it is made.
Scenario scenario_unroll(Arena *arena, const Scenario *s);

// The value that a change has in step `step`, as a cell of the type of its variable.  `cell`, by Var.index, has all values before the step:
// only a COPY reads it, and for other kinds it can be NULL.
uint64_t scenario_cell(const Program *p, const ScenarioChange *c, uint64_t step, const uint64_t *cell);
// Runs a scenario on any engine.  Calls `after` with the number of each step, if it is not NULL.  Returns the status of the last step.
EngineStatus scenario_run(Arena *arena, const Program *p, const Scenario *s, Engine *e,
                          void (*after)(void *context, uint64_t step, const EngineStep *result), void *context);

#endif
