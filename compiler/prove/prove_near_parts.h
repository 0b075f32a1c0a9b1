// SPDX-License-Identifier: Apache-2.0
// The parts of a search close to given runs.  Only files of this folder include it.
//
//     prove_near.c        runs with changed inputs
//     prove_near_step.c   the steps at which inputs are changed
//     prove_near_value.c  the values that they are given
//     prove_near_shorten.c  fewer changes
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

typedef struct NearStore { uint32_t state; const Var *var; const Expr *value; } NearStore;

typedef struct NearValue {
    uint32_t var;             // index into Program.var
    uint64_t cell;
    uint32_t samples;         // as NearLeaf.samples
    bool is_required;         // a comparison of the requirement has it
} NearValue;

// A step of a given run at which inputs are changed.
typedef struct NearStep {
    uint32_t given, rank;     // a smaller rank is tried first
    uint64_t step;
    size_t change;            // the first change of the given run that is not made before
    char *snapshot;           // the state before the step, and then the situation of the monitor
} NearStep;

// What a given run has after each of its steps: a difference lasts if another run has the same state there, and something else stored.
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
    char *block;              // the state of the current run, and the situation of the monitor
    size_t size;              // of both
    uint64_t *cell;           // by Var.index, of the current run
    const ScenarioChange **current;   // by Var.index, of near_shorten: the last change; NULL: none
    VEC(NearLeaf) leaf;       // comparisons, those of the requirement first
    uint32_t required;        // how many these are
    VEC(NearStore) store;
    bool *is_named;           // by State.number: the requirement names the state
    VEC(uint32_t) window;     // sizes of windows, above 2, without repetition; those of the requirement first
    uint32_t required_windows;        // how many these are
    VEC(NearStep) step;       // in the order in which they are tried
    NearTrace **trace;        // by given run, and by step from 1
    VEC(NearValue) value;     // of the current step
    uint64_t steps, limit;    // steps that have run; the most steps until the current phase ends
    VEC(uint64_t) lasted;     // hashes of differences that have been run to their end
    bool premise_seen;
} NearSearch;

// Finds all comparisons of the requirement and of the machine.
void near_find_leaves(NearSearch *k);
// Lists the values that matter at a step, whose inputs and other variables are in k->cell before it runs.
void near_list_values(NearSearch *k, uint32_t state);
// The value of e in k->cell; NaN if it depends on more.
double near_value_of(const NearSearch *k, const Expr *e);
// Lists the steps that matter, of all given runs.
void near_find_steps(NearSearch *k);

// Runs.
void near_open(NearSearch *k, Arena *work, const IrMachine *m, const GoalSearch *g);      // resets `work`; sets the limit to the effort
void near_begin(NearSearch *k, const Scenario *s);
// Makes the changes up to `step`, from number `next` on.  Returns the number of the first one that is not made.
size_t near_set_inputs(NearSearch *k, const Scenario *s, size_t next, uint64_t step);
MonitorResult near_run_step(NearSearch *k, uint64_t step);
void near_read_cells(NearSearch *k);          // copies the variables of the current run to k->cell
NearTrace near_trace(const NearSearch *k);    // of k->cell
static inline uint32_t near_state(const NearSearch *k) { return ((const FlatState *)(const void *)k->block)->state; }

#endif
