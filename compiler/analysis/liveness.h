// SPDX-License-Identifier: Apache-2.0
// Liveness analysis: which variables have values that may still be read.  It goes backward through every function and, for locals,
// backward over the transitions between states.
//
// The analysis assumes that other code reads all elements at the end of each step.  Rolling windows read the variables that they sample
// when the next step begins.  Every path counts, even if its guards are never true.
#ifndef SMC_LIVENESS_H
#define SMC_LIVENESS_H

#include "compiler/analysis/analysis.h"

typedef struct Liveness Liveness;

Liveness *liveness_of(Analysis *a);

// Calls f for each store, in a reachable state, whose value is never read.
typedef struct DeadStore {
    size_t state;                 // State.number - 1
    BlockKind block;
    const IrFn *f;
    IrBlkRef blk;                 // the store is at blk's ins.at[at]
    size_t at;
    const IrIns *store;
} DeadStore;
void each_dead_store(Liveness *l, void (*f)(Analysis *a, const DeadStore *dead, void *context), void *context);

#endif
