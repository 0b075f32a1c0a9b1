// SPDX-License-Identifier: Apache-2.0
// Searches for runs that violate a requirement, or that come to its premise (prove.h), with search.h.
#ifndef SMC_PROVE_GOAL_H
#define SMC_PROVE_GOAL_H

#include "compiler/cover/cover.h"
#include "compiler/script/monitor.h"
#include "compiler/search/search.h"

typedef enum GoalKind { GOAL_VIOLATION, GOAL_PREMISE } GoalKind;

typedef struct GoalSearch {
    const Requirements *all;
    size_t requirement;               // index into all->at
    GoalKind kind;
    uint64_t delta_t, seed;
    uint64_t effort;                  // at least 1: a step costs 1, and more if the requirement has long windows
    const State *init_state;
    const uint64_t *initial;          // by Var.index: the cells of parameters; NULL: those with which the machine was compiled
    bool usual_values;                // the search tries no special values (SearchSpecials)
    size_t memory;                    // as SearchOptions.memory
    const Scenario *given;            // `givens` runs from which the search can start
    uint32_t givens;
    bool assume_ranges;               // elements with @range that the machine does not assign have values in it, in each step
    bool (*go_on)(void *context);     // returns false to stop the search; or NULL
    void *context;
} GoalSearch;

typedef struct GoalFound {
    const Scenario *scenario;         // reaches the goal in its last step, which the reference interpreter has confirmed; NULL: not found
    bool premise_seen;                // some run has come to the premise
    const bool *tried;                // by state from 0: some run was in the state
    uint64_t steps;
    bool unconfirmed;                 // the search has found a scenario, and the reference interpreter does not agree
} GoalFound;

// Returns, by Var.index, whether the variable is an input: an element that the machine never stores, and not G or S.
const bool *goal_inputs(Arena *arena, const Program *p);
// `work` has the memory of the search: it is reset first.
GoalFound goal_search(Arena *arena, Arena *work, const Cover *c, const GoalSearch *g);
// Returns how much a step of a search costs, with the windows that a monitor judges.
uint64_t goal_cost_of_step(const Monitor *m);
// Runs a scenario on the reference interpreter.  Returns the first step that violates the requirement (GOAL_PREMISE: that could have violated
// it); 0: none.
uint64_t goal_confirm(Arena *arena, const GoalSearch *g, const Scenario *s);
// Returns a scenario that ends with the goal: as s, but with inputs in their ranges from the first step on if ranges are assumed.  NULL: the
// reference interpreter does not confirm it.
Scenario *goal_end_scenario(Arena *arena, const GoalSearch *g, const Scenario *s);

#endif
