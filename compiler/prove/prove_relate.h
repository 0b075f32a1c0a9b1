// SPDX-License-Identifier: Apache-2.0
// What is known about two variables together: bounds of their difference (ProvePair).
//
// The difference of two numbers is the real number, not the one that a subtraction rounds to; of equal infinities it is 0.  So a < b if and only if
// their difference is below 0.  The bounds say nothing of a NaN: they are about the steps in which both values are numbers.
//
// A difference changes where a value is stored.  Where the value is the maximum, the minimum, or the sum of others, its difference to a third value follows
// from theirs: max(x, y) - y is at least 0, and x + 0.2 - x is 0.2, but for a rounding.
#ifndef SMC_PROVE_RELATE_H
#define SMC_PROVE_RELATE_H

#include "compiler/prove/prove_model.h"

typedef struct ProveFlow {
    const ProveModel *p;
    const EnvShape *shape;
    const IrFn *f;            // the function of a branch (ProveBranch.fn)
    const Fact *of;           // by temporary of its block 0: what is known about it
    uint32_t *holder;         // memory for prove_relate: one entry more than f has temporaries
    const Env *begin;         // what is known where the block begins
} ProveFlow;

// Computes what is known about the pairs of the model at the end of the block, and adds that to *end, the facts about variables there.  Returns false
// if the differences contradict the condition of the branch: no run takes it.
bool prove_relate(const ProveFlow *flow, const Env **end);

// Returns the bounds of the difference of two variables of which only these facts are known.
Fact prove_difference(Fact a, Fact b);

#endif
