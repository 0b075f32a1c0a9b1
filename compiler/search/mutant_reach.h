// SPDX-License-Identifier: Apache-2.0
// Decides about mutants that no script notices and for which random runs have shown no difference (mutate.h).  A search (search.h) has the cases
// in which such a mutant differs (mutant_cases.h) as its goals:
//
// - It proves that all of them are impossible as long as only inputs change.  Then the mutant is equivalent on this condition.
// - It reaches one of them.  Random runs continue from there, until a difference is visible.
// - Else nothing is known about the mutant.
#ifndef SMC_MUTANT_REACH_H
#define SMC_MUTANT_REACH_H

#include "compiler/cover/mutate.h"

#define MUTANT_REACH_EFFORT UINT64_C(6000000)         // default of `effort`

// Decides about the next mutant, with at most `effort` steps to reach a case from each state in which a script starts, and `steps` after it until a
// difference is visible.  Returns false if no mutant is left.
bool mutant_reach_next(Mutation *u, uint64_t effort, uint64_t steps);

#endif
