// SPDX-License-Identifier: Apache-2.0
// Finds what trials need to know about a machine: its inputs and the readings that its conditions distinguish, its outputs that drive
// something, such as a valve, and the times that it waits for.
#ifndef SMC_TRIAL_INPUTS_H
#define SMC_TRIAL_INPUTS_H

#include "compiler/analysis/trial.h"
#include "compiler/base/bitset.h"

// Fills in the fields input, state[].relevant, actuator, wait, stamp, stamped, limit and count of *t.  Its fields run, state and var must be set.
void trial_find_inputs(Trials *t);

// ---- parts of trial_find_inputs ----

// A comparison in the state with number `state`.  `pair.op` is SM_OP_COUNT for two arguments of a call.
typedef struct TrialComparison { Comparison pair; uint32_t state; } TrialComparison;

typedef struct TrialFinder {
    Trials *t;
    Arena *arena;
    const Program *p;
    size_t words;                 // number of words of a set of inputs (bitset.h)
    uint64_t *data, *all;         // by Var.index: sets of the inputs on which the variable's values depend; `all` includes those of guards
    uint32_t *input_of;           // by Var.index: the variable's index in Trials.input; IR_NONE: it is no input
    uint32_t *parent;             // by Var.index: parent in a union-find, whose sets are variables that measure the same quantity
    VEC(TrialComparison) comparison;      // every comparison of the machine
    VEC(const Stmt *) assign;     // every assignment, in file order
    VEC(uint32_t) assign_state;   // by entry of `assign`: number of the state that contains the assignment
    double *value, *saved;        // by Var.index: values of the variables while readings are searched; a copy of them
    uint32_t state;               // number of the state whose statements are visited
    uint64_t *bits;               // set of the inputs on which the current expression depends
    bool reads_time;              // the current expression reads G
    bool *read;                   // by Var.index: a guard or an assigned value reads the variable
    bool *zeroed;                 // by Var.index: some assignment can set the variable to 0
    bool *bounded;                // by Var.index: some assigned value has finite bounds
    bool *varied;                 // by Var.index: some assigned value is not constant
    VEC(double) *constants;       // by Var.index: the constants assigned to the variable
} TrialFinder;

// Adds to the set `to` the inputs that an expression depends on.  `of` has the inputs of each variable: TrialFinder.data or .all.
void trial_add_inputs(TrialFinder *f, const Expr *e, const uint64_t *of, uint64_t *to);

// Each of these sets the fields of TrialFinder.t that its comment names:
void trial_find_groups(TrialFinder *f);            // input[].group
void trial_find_readings(TrialFinder *f);          // input[].reading, .readings, .rough and .scale
void trial_find_waits(TrialFinder *f);             // wait, stamp, stamped
void trial_find_counters(TrialFinder *f);          // limit, count
void trial_find_actuators(TrialFinder *f);         // actuator

#endif
