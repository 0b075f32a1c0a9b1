// SPDX-License-Identifier: Apache-2.0
// Facts about the runs of a search: they begin in one state, G advances by the same amount in each step, and no code outside the machine
// writes other variables than the inputs.  So an element that is no input keeps what the machine stores in it, as a local does.
//
// If each step of a state adds to a variable, and a transition out of this state needs a minimum time in the state, the variable has a lower bound
// after the transition.  The facts are computed for a changed machine, in which that transition stores max(variable, bound) in the variable.  That
// does not change its value, but makes the bound known.
//
// If a step of a state ends without a transition only up to some T, then T is at most delta_t more when the next step begins, and a multiple of
// delta_t.  So a guard that comes before a limit of time in the same step can be false because of it.
#ifndef SMC_RUN_FACTS_H
#define SMC_RUN_FACTS_H

#include "compiler/cover/cover.h"
#include "compiler/cover/drift.h"
#include "compiler/facts/fact.h"

typedef struct RunFacts RunFacts;

// How the runs begin.
typedef struct RunStart {
    uint32_t state;           // State.number
    bool any_elements;        // elements that the machine stores have any value before the first step; else they are 0
} RunStart;

// known: memory of the facts, used for nothing else.  They are computed several times, and each time the earlier ones are freed.
// `is_input`: by IR variable.
RunFacts *run_facts_new(Arena *arena, Arena *known, const IrMachine *m, const bool *is_input, uint64_t delta_t, RunStart start);
// Sets reason[place] to why no such run covers the place, as a text in `texts`; NULL: unknown.  What run_facts_drift returns
// afterwards can follow from delta_t, too.
void run_facts_exclude(RunFacts *r, const Cover *c, Arena *texts, const char **reason);
// What is known about a variable in .step of a state (State.number).
DriftInState run_facts_drift(RunFacts *r, uint32_t state, uint32_t var);
// What is known about T when .step of a state (State.number) begins: T is 0 in the first step, and grows by delta_t with each
// step that ends without a transition.
Fact run_facts_time(RunFacts *r, uint32_t state);

#endif
