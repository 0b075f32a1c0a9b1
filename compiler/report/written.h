// SPDX-License-Identifier: Apache-2.0
// A machine as its author wrote it.  A program has a copy of each statement of [all_states] in every state where the section runs
// (Source.copy_of).  Reports and diagrams show such a statement once, with the functions below.
#ifndef SMC_WRITTEN_H
#define SMC_WRITTEN_H

#include "compiler/analysis/transitions.h"

// ---- sections [all_states] ----

const AllStates *written_section(const Program *p, Span span);    // returns the section that contains the statement; NULL: it is in a state itself
// Returns "all states except Abort and Safe", or "the states Fill and Hold" if many are excepted and few are not. `mark` is on both sides of each
// name of a state: "^" in texts with markup (doc.h), or "".
const char *written_section_name(Arena *arena, const Program *p, const AllStates *all, const char *mark);
Stmts written_section_stmts(const Program *p, const AllStates *all);      // the section's statements, as copied into the first state that runs them
const State *written_first_state(const Program *p, const AllStates *all);      // the first state where the section runs; NULL: none

// ---- states ----

Stmts written_own_stmts(const State *s, BlockKind block);         // the statements of the block without those of [all_states]
Span written_state_range(const State *s);                         // the state's part of the source: from its header to its last statement

// ---- transitions ----

typedef struct WrittenTransition {
    const AllStates *all;             // the section that contains the transition; NULL: it is in a state itself
    VEC(const Transition *) copy;     // one for each state where it can be taken, in file order; at least one
} WrittenTransition;

typedef VEC(WrittenTransition) WrittenTransitions;

// Returns each transition once: those of the states in file order, then those of [all_states] in file order.
WrittenTransitions written_transitions(Arena *arena, const Program *p, const Transitions *all);

#endif
