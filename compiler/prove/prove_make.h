// SPDX-License-Identifier: Apache-2.0
// How a model (ProveModel) is built.  Only files of this folder include it.
//
//     prove_emit.c      variables and instructions of the function of a step that is being built
//     prove_window.c    rolling windows as variables, and their samples
//     prove_threshold.c the samples of windows compared with constants, as windows of booleans
//     prove_slice.c     removes from the machine what cannot influence the requirement
//     prove_judge.c     the judgement of the requirement at the end of a step
//     prove_branch.c    the branches of a block
//     prove_pair.c      pairs of variables that are compared with each other
#ifndef SMC_PROVE_MAKE_H
#define SMC_PROVE_MAKE_H

#include "compiler/prove/prove_model.h"

// A rolling window of the machine or of the requirement, or one of booleans whose samples are comparisons of another window's samples.
typedef struct MadeWindow {
    uint32_t size, stats;             // size: in samples; stats: 1u << SmStat of each statistic that is read
    bool used;                        // a relevant value reads it (prove_slice)
    bool is_boolean;                  // its samples are 0 or 1
    double longest;                   // of a run: times from this one on are not distinguished
    uint32_t var[SM_STAT_COUNT];      // by statistic that is read: the model's variable with its value
    uint32_t trues, falses;           // variables of kind KEPT: number of samples since the last false (true) one; at most `size`
    uint32_t last;                    // variable of kind KEPT with the newest sample; or IR_NONE
    const IrFn *sample;               // the function that samples the window
    IrRef operand;                    // temporary of `sample`: the value that is sampled; IR_NONE: the model does not follow it
    uint32_t first;                   // index in ProveMaker.same of window 0 of `sample`
    const Window *of;                 // one of the calls in the source that read the window
    uint32_t base;                    // of comparisons (prove_threshold.c): the window whose samples are compared; else IR_NONE
    uint32_t outcome;                 // of comparisons: once `is_sampled`, the variable with the sample of the current step
    bool is_sampled;                  // the function that is being built already contains the window's sample
    Fact samples;                     // what is known about each sample
} MadeWindow;

typedef struct ProveMaker {
    ProveModel *model;
    Arena *arena;
    const IrMachine *m;               // the machine; after prove_slice, the part of it that can influence the requirement
    IrMachine judge;                  // the windows of the requirements, and the function that samples them
    const uint32_t *equal;            // by window of the requirements: as from prove_find_equal_windows; or NULL
    uint32_t *window_of;              // by window of the requirements: index into `window`
    uint32_t *same;                   // by index into `window`: itself, or the window of the machine that has the same samples
    MadeWindow *window;               // `windows` of them: `of_machine` of the machine, then those of the requirement, then those of comparisons
    uint32_t windows, of_machine;
    uint32_t of_both;                 // number of windows of the machine and of the requirement
    IrFn *condition[3];               // a, b, c of the requirement; NULL: it has none
    uint32_t sampled;                 // variable: whether an earlier step has run
    uint32_t seen, open, age, offset; // variables that carry the state of the requirement from step to step (prove_judge.c)
    IrFn *f;                          // the function of a step that is being built
    IrBlkRef b;                       // the block of `f` to which instructions are appended
    VEC(ProveEnd) end;                // by block of `f`: how a step ends there
    uint32_t vars;                    // allocated length of model->var
} ProveMaker;

// ---- variables and instructions ----

uint32_t prove_add_var(ProveMaker *k, SmType type, ProveVarKind kind, Fact begin);
Fact prove_fact_of_number(double x);

IrBlkRef prove_new_block(ProveMaker *k);
// These append to the current block, and return the temporary with the value.
IrRef prove_emit(ProveMaker *k, IrOp op, IrRef a, IrRef b);
IrRef prove_emit_number(ProveMaker *k, double x);
IrRef prove_emit_load(ProveMaker *k, uint32_t var);       // the value is converted to F64
void prove_emit_store(ProveMaker *k, uint32_t var, IrRef value);
void prove_emit_set(ProveMaker *k, uint32_t var, double x);

void prove_jump_from(ProveMaker *k, IrBlkRef from, IrBlkRef to);
void prove_branch_from(ProveMaker *k, IrBlkRef from, IrRef cond, IrBlkRef then, IrBlkRef otherwise);
// Ends the current block: continues in `then` if the variable is greater than x, else in `otherwise`.
void prove_branch_if_above(ProveMaker *k, uint32_t var, double x, IrBlkRef then, IrBlkRef otherwise);

// Returns the temporary of the current block with the value of `r` of the function `from`.  `copy`: by temporary; IR_NONE: not emitted yet.
// `first`: index in k->same of window 0 of `from`.
IrRef prove_copy_value(ProveMaker *k, const IrFn *from, IrRef r, IrRef *copy, uint32_t first);
IrRef *prove_new_copies(ProveMaker *k, const IrFn *from);         // an array `copy` in which nothing is emitted yet
// Copies the instructions of a block to the current block.
void prove_copy_block(ProveMaker *k, const IrFn *from, const IrBlk *b, IrRef *copy);

// ---- windows ----

void prove_merge_windows(ProveMaker *k, const Requirements *all);
// Decides of which windows the model follows the samples exactly.  `loose`: of which windows of the machine it does not, unless the requirement
// reads them.
void prove_find_samples(ProveMaker *k, ProveLoosening loose);
// Whether a variable follows the samples of the window.  If not, each of its statistics has any possible value in each step.
bool prove_follows_samples(const MadeWindow *w);
void prove_add_windows(ProveMaker *k);
// Adds windows of booleans: whether the samples of other windows are above constants of the requirement.
void prove_compare_samples(ProveMaker *k);
// Returns a window of comparisons that has already sampled, in this step, the same value that w will sample; NULL: none.
const MadeWindow *prove_find_outcome(const ProveMaker *k, const MadeWindow *w);
// Emits the condition that the minimum and the maximum of the window w->base agree with w, the window of comparisons of its samples.
void prove_agree_with_comparison(ProveMaker *k, const MadeWindow *w);
// Emits the sampling of the windows `from` to `to` - 1, and of windows that compare their samples.  The block after it becomes the current one.
void prove_sample_windows(ProveMaker *k, uint32_t from, uint32_t to);

// ---- the slice ----

// Replaces k->m by a machine with the same variables, windows, states and transitions, whose functions contain only what can influence
// the requirement or the next state: what it reads, the stores to that, the branches that decide whether they run, what these read, and so
// on.  Sets MadeWindow.used.  Returns for each variable whether it is relevant: no function of the slice loads or stores another.
const bool *prove_slice(ProveMaker *k);

// ---- the requirement, and branches ----

// Emits the judgement of the step: it ends in a block where the requirement is met, or in one where it is violated.
void prove_judge_requirement(ProveMaker *k);
// Adds the pairs of variables (ProvePair) about whose differences a proof computes facts.
void prove_add_pairs(ProveMaker *k);
// Appends the branches (ProveBranch) of block b of f to `to`.
void prove_split_block(ProveMaker *k, ProveBlock *to, const IrFn *f, const IrBlk *b);

#endif
