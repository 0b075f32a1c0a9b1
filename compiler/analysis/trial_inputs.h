// SPDX-License-Identifier: Apache-2.0
// The basis of trials: the inputs of a machine and the readings that its conditions distinguish, the outputs that drive
// something, and the times that it waits for.
#ifndef SMC_TRIAL_INPUTS_H
#define SMC_TRIAL_INPUTS_H

#include "compiler/analysis/trial.h"

// Fills in input, state[].relevant, actuator, wait, limit and count. run, state and var of the trials must exist.
void trial_find_inputs(Trials *t);

// ---- parts of trial_find_inputs ----

typedef struct Comparison { const Expr *left, *right; SmOperator op; uint32_t state; } Comparison;      // state: its number

typedef struct Finder {
    Trials *t;
    Arena *arena;
    const Program *p;
    size_t words;                 // words of 64 bits, with one bit for each input
    uint64_t *data, *all;         // by Var.index
    uint32_t *input_of;           // by Var.index; IR_NONE
    uint32_t *parent;             // by Var.index: union-find over sensors and values computed from them, joined if they are combined
    VEC(Comparison) comparison;
    VEC(const Stmt *) assign;     // every assignment, in file order
    VEC(uint32_t) assign_state;   // the number of its state
    double *value, *kept;         // by Var.index; a saved copy of it
    uint32_t state;               // number of the state whose statements are visited
    uint64_t *bits;               // for one expression
    bool *read;                   // by Var.index: a guard or another value reads it
    bool *zeroed;                 // by Var.index: some assignment sets it to 0
    bool *bounded;                // by Var.index: some assigned value is bounded
    bool *varied;                 // by Var.index: some assigned value is not constant
    VEC(double) *given;           // by Var.index: the constants assigned to it
} Finder;

static inline bool has_bit(const uint64_t *bits, uint32_t i) { return bits[i / 64] >> i % 64 & 1; }
// Adds the inputs that an expression depends on.  `of` has those of each variable (data or all of Finder).
void trial_add_bits(Finder *f, const Expr *e, const uint64_t *of, uint64_t *to);

void trial_find_groups(Finder *f);            // input[].group
void trial_find_readings(Finder *f);          // input[].reading and the fields after it
void trial_find_waits(Finder *f);             // wait, stamped
void trial_find_counters(Finder *f);          // limit, count
void trial_find_actuators(Finder *f);         // actuator

#endif
