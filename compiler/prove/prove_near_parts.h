// SPDX-License-Identifier: Apache-2.0
// The parts of a search close to given runs (prove_near.h).  Only files of this folder include it.
//
//     prove_near.c        runs with changed inputs
//     prove_near_step.c   the steps at which inputs are changed
//     prove_near_value.c  the values that they are given
//     prove_near_shorten.c  removes changes and waits that a violation does not need
#ifndef SMC_PROVE_NEAR_PARTS_H
#define SMC_PROVE_NEAR_PARTS_H

#include "compiler/cover/flat.h"
#include "compiler/prove/prove_near.h"

// What a comparison compares, in the code of a state or in the requirement.
typedef struct NearLeaf {
    const Expr *left, *right; // right: NULL if left is a variable that is true or false
    uint32_t samples;         // size of the longest window that samples the input; 1: no window samples it
    uint32_t state;           // number of the state; 0: the requirement
} NearLeaf;

typedef struct NearStore { uint32_t state; const Var *var; const Expr *value; } NearStore;       // `var = value` in the code of a state

// A value that is tried for an input.
typedef struct NearValue {
    uint32_t var;             // index into Program.var
    uint64_t cell;            // the value, as the variable stores it
    uint32_t samples;         // size of the longest window that samples the input (NearLeaf.samples)
    bool is_required;         // the value comes from a comparison of the requirement
} NearValue;

// A step of a given run at which inputs are changed.
typedef struct NearStep {
    uint32_t given, rank;     // given: index of the run; steps with a smaller rank are tried first
    uint64_t step;
    size_t change;            // index of the run's first change at or after the step
    char *snapshot;           // the machine's state before the step, then the memory (situation) of the monitor
} NearStep;

// What a given run has after a step: its state, and a hash of what the machine has stored.  A variant that then has the same state, but another
// hash, can still lead to a violation later.
typedef struct NearTrace { uint32_t state; uint64_t stored; } NearTrace;

typedef struct NearSearch {
    Arena *work;
    const GoalSearch *g;
    const Program *p;
    const IrMachine *m;
    const Requirement *what;
    const bool *input;        // by Var.index
    FlatMachine *f;
    Monitor *monitor;
    char *block;              // the machine's state in the current run, then the memory (situation) of the monitor
    size_t size;              // bytes of `block`
    uint64_t *cell;           // by Var.index: the variables of the current run
    const ScenarioChange **current;   // near_shorten, by Var.index: the last change that was made; NULL: none
    VEC(NearLeaf) leaf;       // comparisons, those of the requirement first
    uint32_t required;        // how many of `leaf` are of the requirement
    VEC(NearStore) store;
    bool *is_named;           // by State.number: the requirement names the state
    VEC(uint32_t) window;     // sizes of windows in samples, above 2, without repetition; those of the requirement first
    uint32_t required_windows;        // how many of `window` are of the requirement
    VEC(NearStep) step;       // in the order in which they are tried
    NearTrace **trace;        // by given run, and by step from 1
    VEC(NearValue) value;     // the values that are tried at the current step
    uint64_t steps, limit;    // steps that have run; the number at which the current phase ends
    VEC(uint64_t) lasted;     // hashes of differences from a given run; for each, one variant has run on (`lasts`)
    bool premise_seen;
} NearSearch;

// Finds all comparisons of the requirement and of the machine.
void near_find_leaves(NearSearch *k);
// Lists in k->value the values that matter at a step in `state`.  k->cell has the variables as they are before that step.
void near_list_values(NearSearch *k, uint32_t state);
// The value of e in k->cell; NaN if it depends on more.
double near_value_of(const NearSearch *k, const Expr *e);
// Lists the steps that matter, of all given runs.
void near_find_steps(NearSearch *k);

// Running a scenario, step by step.
void near_open(NearSearch *k, Arena *work, const IrMachine *m, const GoalSearch *g);      // resets `work`; sets the limit to the effort
void near_begin(NearSearch *k, const Scenario *s);
// Makes the changes up to `step`, from number `next` on.  Returns the number of the first one that is not made.
size_t near_set_inputs(NearSearch *k, const Scenario *s, size_t next, uint64_t step);
MonitorResult near_run_step(NearSearch *k, uint64_t step);
void near_read_cells(NearSearch *k);          // copies the variables of the current run to k->cell
NearTrace near_trace(const NearSearch *k);    // the trace of a run whose variables are in k->cell
static inline uint32_t near_state(const NearSearch *k) { return ((const FlatState *)(const void *)k->block)->state; }

#endif
