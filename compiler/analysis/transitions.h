// SPDX-License-Identifier: Apache-2.0
// Lists a machine's transitions, each with the conditions around it, for graphs, the abort matrix and the analyses.
#ifndef SMC_TRANSITIONS_H
#define SMC_TRANSITIONS_H

#include "compiler/sema/program.h"

typedef struct Condition Condition;
struct Condition {
    const Stmt *stmt;             // the conditional
    bool holds;                   // whether the conditional's guard must be true (then) or false (else)
    const Condition *outer;       // the condition around `stmt`; NULL: none
};

typedef struct Transition {
    const State *from, *to;
    BlockKind block;              // the block of `from` that contains the transition: BLOCK_ENTRY or BLOCK_STEP
    const Stmt *stmt;
    const Condition *when;        // innermost first; NULL: unconditional
    uint32_t number;              // the transition's index in Transitions
} Transition;

typedef VEC(Transition) Transitions;

// A statement and its position.
typedef struct StmtLocation {
    const Stmt *stmt;
    const State *state;
    BlockKind block;
    const Condition *when;        // innermost first; NULL: unconditional
} StmtLocation;

// Calls f for every statement in file order.  A conditional comes before the statements inside it.
void each_stmt_location(Arena *arena, const Program *p, void (*f)(const StmtLocation *at, void *context), void *context);

// Returns all transitions in file order.  `when` does not include the condition that no earlier transition of the block was taken.
Transitions transitions_of(Arena *arena, const Program *p);

// Returns for each state (from 0) the index of its first transition in `all`, where the transitions of a state are adjacent.  The last
// entry, after those of the states, is the length of `all`.
size_t *transitions_by_state(Arena *arena, const Program *p, const Transitions *all);

// Returns the source of an expression on one line, without comments.
const char *source_text(Arena *arena, Span span);
enum { CONDITIONS_SHOWN = 4 };        // the most conditions that condition_text and condition_brief show
// Returns a condition and its outer conditions as text, outermost first: "pressure > 800 and not (valveOpen)"; "" for NULL.  If there are
// more than CONDITIONS_SHOWN, the text is "… and" and the innermost conditions.
const char *condition_text(Arena *arena, const Condition *when);
// Returns a shorter text: "else" replaces conditions that must be false, and at most `most` (1 to CONDITIONS_SHOWN) are shown.
const char *condition_brief(Arena *arena, const Condition *when, size_t most);

#endif
