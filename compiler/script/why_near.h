// SPDX-License-Identifier: Apache-2.0
// How near a step was to taking a transition, and in which step of a run each transition was nearest.
//
// The approach level comes first: how many of the statements from the outermost guard to the transition the step did not execute.  Then the
// fewest conditions that must change, so that the executed guards lead to it, and last the sum of their gaps, each scaled to below 1.
#ifndef SMC_WHY_NEAR_H
#define SMC_WHY_NEAR_H

#include "compiler/script/watch.h"

typedef struct WhyDistance {
    uint32_t level, conditions;
    double gap;
} WhyDistance;

// A transition in a run.
typedef struct WhyNear {
    uint64_t step, g;         // the first of the steps that were nearest to taking it, and its G; 0: no step could take it
    WhyDistance distance;     // in that step
    uint64_t taken, taken_g;  // the last step that took it, and its G; 0: none
} WhyNear;

// Returns the distance of the last step of a watch, which ran the state of transition t.
WhyDistance why_distance(const Watch *w, const WatchStmt *t);
// Whether a is smaller than b.
bool why_is_nearer(const WhyDistance *a, const WhyDistance *b);
// Whether the last step of a watch could have taken transition t: it ran its state, and its block.
bool why_could_take(const Watch *w, const WatchStmt *t);
// Sets *gap to the difference of the sides of a comparison in the last execution of s.  A chain of comparisons has the sum of those that have
// to change.  Returns false if there is no such number.
bool why_gap(const WatchStmt *s, uint32_t leaf, double *gap);
// Updates near, by Stmt.number, after a step.
void why_note_near(const Watch *w, WhyNear *near);

#endif
