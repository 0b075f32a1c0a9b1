// SPDX-License-Identifier: Apache-2.0
// What a watch has recorded, in words: for smc why and for the reports of failed scripts.
#ifndef SMC_WHY_WORDS_H
#define SMC_WHY_WORDS_H

#include "compiler/base/buf.h"
#include "compiler/script/watch.h"

typedef struct WhyWords {
    Arena *arena;
    const Watch *w;
    const RefWindows *windows;        // the windows of the machine after its last step
} WhyWords;

// Returns the source of an expression or statement on one line, in backticks, cut to a readable length.
const char *why_quote(Arena *arena, Span span);
// Returns a position as "vent.sm:10".
const char *why_place(Arena *arena, Span span);
const char *why_step(Arena *arena, uint64_t step, uint64_t g);        // returns "step 12 (G = 110)"
// Appends a cell of a variable: a number, true or false, or the name of a state.
void why_append_cell(const Var *v, uint64_t cell, Buf *out);
// Appends the recorded value of node `node`; value: of WatchStmt or WatchPassage.
void why_append_value(const WatchStmt *s, const uint64_t *value, uint32_t node, Buf *out);
// Sets *x to the value of an operand of a condition in the last execution of s.  Returns false if it was not recorded.
bool why_operand(const WatchStmt *s, const Expr *e, double *x);
// Appends the operands of a leaf with their values, as in "pressure = 700, x = 3"; for any other node, the operands of all its leaves.
void why_append_operands(const WhyWords *words, const WatchStmt *s, const uint64_t *value, uint32_t node, Buf *out);
// Appends what a false leaf of the last step lacks, as in ", needs more than 125 more"; nothing if there is no such number.
void why_append_need(const WhyWords *words, const WatchStmt *s, uint32_t node, Buf *out);
// Returns a leaf of the last step with its truth, its operands and what it lacks: "`p > 825` was false since step 1 (G = 0): p = 700, needs
// more than 125 more".  `since`: with the step since which it had this value.
const char *why_condition(const WhyWords *words, const WatchStmt *s, uint32_t node, bool since);
// Returns the outermost of s and the conditionals around it that the last step did not execute; NULL: it executed s.
const WatchStmt *why_obstacle(const Watch *w, const WatchStmt *s);
// Whether the guard around an obstacle (from why_obstacle) is the reason why the obstacle was not executed; otherwise an earlier transition is.
bool why_is_blocked(const WatchStmt *obstacle);
// Returns why a transition was taken: "`p > 825` was true: p = 850", for each guard around it.  "" if no guard is around it.
const char *why_guards(const WhyWords *words, const WatchStmt *s, const uint64_t *value);
// Returns what a statement has stored: "`x = y + 1` stored 3: y = 2".
const char *why_store(const WhyWords *words, const WatchStmt *s);

#endif
