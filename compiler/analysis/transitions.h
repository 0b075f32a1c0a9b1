// SPDX-License-Identifier: Apache-2.0
// A machine's transitions, each with the conditions it stands under: what graphs, the abort matrix and analyses start from.
#ifndef SMC_TRANSITIONS_H
#define SMC_TRANSITIONS_H

#include "compiler/sema/program.h"

typedef struct Condition Condition;
struct Condition {
    const Stmt *stmt;             // the conditional
    bool holds;                   // whether its guard must hold (then) or must not (else)
    const Condition *outer;       // the one around it; NULL: none
};

typedef struct Transition {
    const State *from, *to;
    BlockKind block;              // of `from`: BLOCK_ENTRY or BLOCK_STEP
    const Stmt *stmt;
    const Condition *when;        // innermost first; NULL: it stands alone
    uint32_t number;              // its place in the list
} Transition;

typedef VEC(Transition) Transitions;

// A statement and where it stands.
typedef struct StmtPlace {
    const Stmt *stmt;
    const State *state;
    BlockKind block;
    const Condition *when;        // innermost first; NULL: it stands alone
} StmtPlace;

// Calls f for every statement in file order, a conditional before what is in it.
void each_place(Arena *arena, const Program *p, void (*f)(const StmtPlace *place, void *context), void *context);

// In file order.  That an earlier one of the block was not taken is no condition here.
Transitions transitions_of(Arena *arena, const Program *p);

// By state, from 0: where its transitions begin in the list of all, for they stand together; one more for the end.
size_t *transitions_by_state(Arena *arena, const Program *p, const Transitions *all);

// An expression as its author wrote it, on one line.
const char *source_text(Arena *arena, Span span);
enum { CONDITIONS_SHOWN = 4 };
// "pressure > 800 and not (valveOpen)", outermost first; "" of NULL.  Of more than a few, the innermost with "… and" before them.
const char *condition_text(Arena *arena, const Condition *when);
// In less room: "else" stands for those that must not hold, and of all at most `most` are shown, 1 to CONDITIONS_SHOWN.
const char *condition_brief(Arena *arena, const Condition *when, size_t most);

#endif
