// SPDX-License-Identifier: Apache-2.0
// Searches for inputs with which a mutant behaves differently from the machine: both run in lockstep under the same random scenario, until S
// or an element that the machine stores differs.  Values come from the numbers with which the machine compares its inputs, and
// durations from those with which it compares T.  Situations that are new are stored, and later runs begin at them.
#ifndef SMC_MUTANT_SEARCH_H
#define SMC_MUTANT_SEARCH_H

#include "compiler/cover/flat.h"
#include "compiler/script/scenario.h"

typedef struct MutantSearch MutantSearch;

// What a search is for.
typedef struct MutantTarget {
    FlatMachine *mutant;
    const State *state;       // the state that contains the change, in which most runs begin; or NULL
    const double *around;     // numbers that the change concerns, `arounds` of them, which are tried more often as inputs
    uint32_t arounds;
    const Scenario *from;     // a scenario after which the mutant is likely to differ from the machine; or NULL
} MutantTarget;

// delta_t: by how much G advances in a step.  `given`: scenarios with this delta_t; searches also begin at situations that they reach.  `start`:
// the states in which scenarios can begin.  The arguments must outlive the result.
MutantSearch *mutant_search_new(Arena *arena, const Program *p, FlatMachine *original, uint64_t delta_t, const State *const *start, uint32_t starts,
                                const Scenario *given, uint32_t givens);
// Returns a scenario in whose last step the mutant differs from the machine, allocated in `out`; NULL: none was found in `steps` steps.  *what
// receives the variable that differs; NULL: S.
const Scenario *mutant_search_run(MutantSearch *k, Arena *out, Arena *work, const MutantTarget *t, uint64_t steps, const Var **what);

#endif
