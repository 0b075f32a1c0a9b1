// SPDX-License-Identifier: Apache-2.0
// Which variables have values that may still be read: backward over every function, and for locals over the states.
//
// Other code reads the elements at the end of each step.  Windows read what they sample when the next step begins.  Guards are
// not evaluated: every path counts.
#ifndef SMC_LIVENESS_H
#define SMC_LIVENESS_H

#include "compiler/analysis/analysis.h"

typedef struct Liveness Liveness;

Liveness *liveness_of(Analysis *a);

// Calls f for each store, in a reachable state, whose value is never read.
typedef struct DeadStore {
    size_t state;                 // from 0
    BlockKind block;
    const IrFn *f;
    IrBlkRef blk;                 // the store is at blk's ins.at[at]
    size_t at;
    const IrIns *store;
} DeadStore;
void each_dead_store(Liveness *l, void (*f)(Analysis *a, const DeadStore *dead, void *context), void *context);

#endif
