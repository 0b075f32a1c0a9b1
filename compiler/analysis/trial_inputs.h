// SPDX-License-Identifier: Apache-2.0
// What trials need to know about a machine: its inputs and the readings that its conditions distinguish, the outputs that drive
// something, and the times that it waits for.
#ifndef SMC_TRIAL_INPUTS_H
#define SMC_TRIAL_INPUTS_H

#include "compiler/analysis/trial.h"
#include "compiler/base/bitset.h"

// Fills in input, state[].relevant, actuator, wait, limit and count. run, state and var of the trials must exist.
void trial_find_inputs(Trials *t);

// ---- parts of trial_find_inputs ----

// `pair.op` is SM_OP_COUNT for two arguments of a call.
typedef struct TrialComparison { Comparison pair; uint32_t state; } TrialComparison;          // state: its number

typedef struct TrialFinder {
    Trials *t;
    Arena *arena;
    const Program *p;
    size_t words;                 // of a set of inputs (bitset.h)
    uint64_t *data, *all;         // by Var.index, sets: the inputs that its values depend on; with those that guards depend on
    uint32_t *input_of;           // by Var.index; IR_NONE
    uint32_t *parent;             // by Var.index: union-find over sensors and values computed from them, joined if they are combined
    VEC(TrialComparison) comparison;
    VEC(const Stmt *) assign;     // every assignment, in file order
    VEC(uint32_t) assign_state;   // the number of its state
    double *value, *saved;        // by Var.index: the current values while readings are searched; a copy of them
    uint32_t state;               // number of the state whose statements are visited
    uint64_t *bits;               // a set of inputs, for one expression
    bool *read;                   // by Var.index: a guard or another value reads it
    bool *zeroed;                 // by Var.index: some assignment sets it to 0
    bool *bounded;                // by Var.index: some assigned value is bounded
    bool *varied;                 // by Var.index: some assigned value is not constant
    VEC(double) *constants;       // by Var.index: the constants assigned to it
} TrialFinder;

// Adds the inputs that an expression depends on.  `of` has those of each variable (data or all of TrialFinder).
void trial_add_inputs(TrialFinder *f, const Expr *e, const uint64_t *of, uint64_t *to);

void trial_find_groups(TrialFinder *f);            // input[].group
void trial_find_readings(TrialFinder *f);          // input[].reading and the fields after it
void trial_find_waits(TrialFinder *f);             // wait, stamped
void trial_find_counters(TrialFinder *f);          // limit, count
void trial_find_actuators(TrialFinder *f);         // actuator

#endif
