// SPDX-License-Identifier: Apache-2.0
// How near a step was to taking a transition, and in which step of a run each transition was nearest.
//
// The approach level comes first: how many of the statements from the outermost guard to the transition the step did not execute.  Then the
// fewest conditions that must change, so that the executed guards lead to it, and last the sum of their gaps, each scaled to below 1.
#ifndef SMC_WHY_NEAR_H
#define SMC_WHY_NEAR_H

#include "compiler/script/watch.h"

typedef struct WhyDistance {      // compared in this order; all 0: the transition was taken
    uint32_t level;               // the approach level
    uint32_t conditions;          // the fewest conditions that must change
    double gap;                   // the sum of their scaled gaps
} WhyDistance;

// When a run was nearest to taking a transition, and when it took the transition.
typedef struct WhyNear {
    uint64_t step, g;         // number and G of the first step with the smallest distance; 0: no step could take the transition
    WhyDistance distance;     // the distance in that step
    uint64_t taken, taken_g;  // number and G of the last step that took the transition; 0: none
} WhyNear;

// Returns the distance of the last step of a watch, which ran the state of transition t.
WhyDistance why_distance(const Watch *w, const WatchStmt *t);
// Whether a is smaller than b.
bool why_is_nearer(const WhyDistance *a, const WhyDistance *b);
// Whether the last step of a watch could have taken transition t: it ran the state and the block (entry, step or exit) that contain t.
bool why_could_take(const Watch *w, const WatchStmt *t);
// Sets *gap to the difference of the two sides of comparison `leaf`, an index in s->node, in the last execution of s; for a chain of comparisons,
// to the sum of the differences that must change.  Returns false if the leaf is no comparison of numbers.
bool why_gap(const WatchStmt *s, uint32_t leaf, double *gap);
// Updates the entries of `near`, which are by Stmt.number, after a step.
void why_note_near(const Watch *w, WhyNear *near);

#endif
