// SPDX-License-Identifier: Apache-2.0
// The transitions between the states of a machine, for explanations.
#ifndef SMC_WHY_PATHS_H
#define SMC_WHY_PATHS_H

#include "compiler/script/watch.h"

typedef struct WhyPath { const State **at; size_t n; } WhyPath;

// Returns the first transition from one state to another in the order of the file; NULL: none.
const WatchStmt *why_find_transition(const Watch *w, const State *from, const State *to);
// Returns the states of the shortest sequence of transitions, with both ends; n is 0 if no such sequence exists.  The states differ.
WhyPath why_shortest_path(Arena *arena, const Watch *w, const State *from, const State *to);
const char *why_path_text(Arena *arena, const WhyPath *path);         // returns the path as text: "Fill -> Vent -> Idle"

#endif
