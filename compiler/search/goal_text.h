// SPDX-License-Identifier: Apache-2.0
// The goals of a search in words, for the comments and the names of generated scripts.
#ifndef SMC_GOAL_TEXT_H
#define SMC_GOAL_TEXT_H

#include "compiler/cover/cover.h"

typedef struct GoalTexts GoalTexts;

// Lists the transitions and statements of c's machine, from which the functions below take their words.  A `place` is an index into c->place.
// p: the machine, or the application of which it is machine number `machine`; its name then begins each sentence.
GoalTexts *goal_texts_new(Arena *arena, const Cover *c, const Program *p, size_t machine);
// Returns what a run does when it covers a coverage point: "Fill -> Abort, taken because pressure > 825."  Of an application:
// "vent: Fill -> Abort, taken because pressure > 825."
const char *goal_sentence(const GoalTexts *t, uint32_t place);
// Returns the name of the goal's script, without ending and in lower case, unique among all places: "tank-3-fill-to-abort".
const char *goal_file_stem(const GoalTexts *t, uint32_t place);
// Returns text in lower case, with a '-' for each run of other characters than letters and digits.
const char *goal_name_part(Arena *arena, const char *text);

#endif
