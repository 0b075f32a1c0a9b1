// SPDX-License-Identifier: Apache-2.0
// What a proof explores: a machine and one requirement as functions of plain variables (prove.h).
//
// For each state, and for its first step and its later ones, one function contains the complete step: windows sample, .entry, .step and .exit
// run, and then the requirement is judged.  Rolling windows, and what the requirement has seen, are variables that the function loads and
// stores.  So only facts about variables are known between steps.
//
// Only what can influence the requirement is part of the functions (prove_make.h).
//
// Each block of a function is split into branches.  A branch adds one of several conditions, which exclude each other and of which one is
// always true.  They are the cases in which the conditions at the end of the block, and the booleans that it stores, get their values.
#ifndef SMC_PROVE_MODEL_H
#define SMC_PROVE_MODEL_H

#include "compiler/facts/facts.h"
#include "compiler/sema/requirements.h"

typedef enum ProveVarKind {
    PROVE_INPUT,              // an element that the machine does not assign: any value in each step
    PROVE_OUTPUT,             // an element that the machine assigns
    PROVE_KEPT,               // only the functions of the model change it, such as a local or a count of samples
    PROVE_CHOICE,             // any value of `begin` in each step, independent of the step before
    PROVE_TIME,               // G, S or T
    PROVE_DIFFERENCE,         // the difference of a pair of variables (ProvePair); no function reads or writes it
    PROVE_IRRELEVANT          // no function reads it, so nothing is known about it
} ProveVarKind;

typedef struct ProveVar {
    ProveVarKind kind;
    Fact begin;               // KEPT: the value in the first step; CHOICE: in each step
    bool stored;              // some function stores the variable
    bool relevant;            // the variable can influence the requirement or the next state
    bool few;                 // KEPT: it has few values, such as a flag or a count of samples
    const Window *window;     // the value of the variable follows from the samples of this window; or NULL
} ProveVar;

typedef struct ProveBranch {
    IrFn *fn;                 // a copy of the block as block 0, which ends with the condition of the branch
    IrBlkRef then;            // the block of the step that follows if the condition is true (block 1 of fn).  Block 2 of fn is never entered
} ProveBranch;

typedef enum ProveEnd { PROVE_END_NONE, PROVE_END_MET, PROVE_END_VIOLATED, PROVE_END_IMPOSSIBLE } ProveEnd;       // IMPOSSIBLE: no run comes here

typedef struct ProveBlock {
    ProveEnd end;             // how the step ends in this block; PROVE_END_NONE: another block follows
    VEC(ProveBranch) branch;
    uint64_t *live;           // set of variables that this block or a later one loads
} ProveBlock;

typedef struct ProveStep {
    IrFn *fn;
    ProveBlock *block;        // by block of fn
    IrBlkRef *order;          // the blocks that can be reached, each after all its predecessors
    uint32_t blocks;
} ProveStep;

// Which windows of the machine the model does not follow, among those that the requirement does not read: they have any possible value in each step.
// Then the model has more runs than the machine, but fewer variables.
typedef enum ProveLoosening {
    PROVE_EXACT,              // nothing is loosened
    PROVE_COMPARED,           // exact, with more variables: whether each sample is above a constant of the requirement (prove_threshold.c)
    PROVE_LOOSE_LONG,         // windows of more than two samples, and runs; the model still follows the windows of prev, rising and falling
    PROVE_LOOSE_UNLIKE,       // all but those that are like a window of the requirement: as long, and with one of its variables
    PROVE_LOOSE_ALL,
    PROVE_RELATED,            // as LOOSE_ALL, and the model has bounds of the differences of variables (prove_relate.h)
    PROVE_LOOSENINGS
} ProveLoosening;

// Two variables that are compared with each other, and the variable whose fact has the bounds of their difference x - y.
typedef struct ProvePair { uint32_t x, y, var; } ProvePair;

enum { PROVE_PAIRS = 15 };    // the most pairs of a model

typedef struct ProveModel {
    Arena *arena;
    const IrMachine *machine; // only the part that can influence the requirement (prove_slice)
    const Requirement *what;  // the requirement
    uint64_t delta_t;
    IrMachine *ir;            // has only variables: those of the machine, then those that only the model has
    ProveVar *var;            // by variable of ir
    uint32_t compared;        // number of windows of comparisons (PROVE_COMPARED)
    uint32_t loosened;        // number of windows that have any value because of the ProveLoosening
    ProvePair pair[PROVE_PAIRS];      // `pairs` of them
    uint32_t pairs;
    uint32_t next;            // variable: number of the state that follows; 0: no transition
    uint32_t premise;         // variable: whether the step could have violated the requirement
    ProveStep *(*step)[2];    // by State.number - 1, and whether it is the first step in the state; NULL until prove_model_step builds it
    struct ProveMaker *maker; // what prove_model_step needs to build `step`
} ProveModel;

// equal: as from prove_find_equal_windows; NULL: unknown.
ProveModel *prove_model_new(Arena *arena, const IrMachine *m, const Requirements *all, const Requirement *what, uint64_t delta_t, ProveLoosening loose,
                            const uint32_t *equal);
// Returns the function of a step, which is built at the first call.  state: State.number - 1.  If it is the number of states: the function judges the
// requirement without a step of the machine.
const ProveStep *prove_model_step(ProveModel *p, size_t state, bool first);

#endif
