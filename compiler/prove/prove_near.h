// SPDX-License-Identifier: Apache-2.0
// Searches close to given runs: for a violation that differs from the run of a script in one or two inputs, for some steps.
//
// It runs before the general search, and always tries the same:
//
//   - at the steps that matter: those of transitions, those before and after them, the middle of each visit of a state, those from which a window
//     is filled when a transition is made, and those at which a condition of the requirement changes;
//   - inputs with the values that matter: those at which a comparison of the requirement, or of the current state, changes, and their
//     neighbours in the input's type; the ends of ranges; and the other value of a bool;
//   - for one step, for as long as a window, and for the rest of the visit.
//
// The run then goes on with the inputs of the script.
#ifndef SMC_PROVE_NEAR_H
#define SMC_PROVE_NEAR_H

#include "compiler/ir/ir.h"
#include "compiler/prove/prove_goal.h"

enum { NEAR_INPUTS = 2 };     // the most inputs that differ from the given run

typedef struct NearTurn { const Var *var; double value; } NearTurn;

typedef struct NearFound {
    const Scenario *scenario;         // violates the requirement in its last step, confirmed by the reference interpreter; NULL: not found
    uint32_t given;                   // index of the run to which it is close
    NearTurn turn[NEAR_INPUTS];       // the `turns` inputs that differ, and their values
    uint32_t turns;
    uint64_t from, to;                // the first and the last step with these values
    bool premise_seen;                // some run could have violated the requirement
    uint64_t steps;                   // steps that have run
} NearFound;

// g->given are the given runs, and g->effort limits the steps.  `work` is memory for the search, which resets it first.
NearFound near_search(Arena *arena, Arena *work, const IrMachine *m, const GoalSearch *g);
// Returns a run with fewer changes and shorter waits that violates the requirement, too, confirmed by the reference interpreter, or the same one.
// g->effort limits the steps, and *steps receives how many have run.
const Scenario *near_shorten(Arena *arena, Arena *work, const IrMachine *m, const GoalSearch *g, const Scenario *s, uint64_t *steps);

#endif
