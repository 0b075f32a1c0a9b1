// SPDX-License-Identifier: Apache-2.0
// Goals for scripts that show which transitions a machine does not take.  Of two states A and B without a transition from A to B, it makes the
// condition that leads to B from a third state true while the machine stays in A.
//
// A condition with windows or samples is not chosen, because it depends on more than the variables, nor is one that reads only G, S and T.
#ifndef SMC_MUST_NOT_H
#define SMC_MUST_NOT_H

#include "compiler/analysis/transitions.h"
#include "compiler/search/search.h"

typedef struct MustNot {
    const State *in, *to;     // A and B
    const Transition *other;  // a transition to B from another state than A
} MustNot;

typedef struct MustNots {
    VEC(MustNot) at;
    const Program *p;
    SearchWatch watch;        // for search_run.  Goal i is at.at[i]: the condition of `other` was true in a step in A, and the next step is in A, too
} MustNots;

MustNots *must_not_list(Arena *arena, const Program *p);

// Returns how far `e` is from being true (or false, without `wanted`) with these values of the variables (cell: by Var.index): 0 if
// it is, else above 0.  e has no windows.
double must_not_distance(const Expr *e, bool wanted, const uint64_t *cell);

#endif
