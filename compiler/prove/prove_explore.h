// SPDX-License-Identifier: Apache-2.0
// Explores what can be true when a step of a machine begins (prove.h), and whether a step can violate the requirement.
//
// A node, an abstract state, is a state of the machine, whether its first step is next, the values of some variables, the *keys*, and facts about
// all other variables.  Nodes are added until the steps from all of them lead to known nodes only.  Facts of a node that keep growing are widened;
// then the steps are explored once more from the facts found, which makes them tighter.
//
// If there are too many nodes, the variable with the most values is no longer a key, and the exploration begins again.
#ifndef SMC_PROVE_EXPLORE_H
#define SMC_PROVE_EXPLORE_H

#include "compiler/prove/prove.h"
#include "compiler/prove/prove_model.h"

typedef struct ProveLimits {
    uint32_t nodes;           // limit on nodes: when it is reached, the exploration begins again with one key less
    uint64_t visits;          // limit on visits of branches, one for each path to a block: when it is reached, the exploration gives up
    size_t memory;            // bytes of the exploration; 0: no limit
    bool (*go_on)(void *context);     // returns false to stop the exploration; or NULL
    void *context;
} ProveLimits;

typedef struct ProveExplored {
    bool closed;              // the exploration is complete: the following fields are true of every run
    bool violated, premise;   // the facts allow a step that violates the requirement; a step with the premise of it
    uint32_t nodes;
    uint32_t wide[PROVE_WIDES];       // `wides` variables: those with too many values to be keys, or with most values when the exploration gave up
    uint32_t wides;
    uint64_t visits;
    Fact *after;              // [state * variables + variable]: the facts after a step in the state that does not violate the requirement
    bool *reached;            // by state from 0: a step that does not violate the requirement can run in the state
    bool *entered;            // by state from 0: a step can run in the state before the requirement is violated
} ProveExplored;

// `assumed`: a set of 1u << ProveAssumption.  `fine`: all variables that change are keys; otherwise only those with few values.
// `work`: memory of the exploration, which is reset first.
ProveExplored prove_explore(Arena *arena, Arena *work, ProveModel *p, const State *init_state, unsigned assumed, bool fine,
                            const ProveLimits *limits);

// Whether some values of the variables violate the requirement, whatever the machine does.
bool prove_can_violate(Arena *arena, ProveModel *p);

#endif
