// SPDX-License-Identifier: Apache-2.0
// What a mutant changes in the checked program, for the files of mutation (mutate.h).
#ifndef SMC_MUTANT_H
#define SMC_MUTANT_H

#include "compiler/cover/mutate.h"

// What one copy of a mutant changes, and to what.
struct MutantEdit {
    enum { EDIT_NUMBER, EDIT_OPERATOR, EDIT_LINK, EDIT_DROP_NOT, EDIT_GUARD, EDIT_TARGET, EDIT_DELETE, EDIT_INITIAL } kind;
    Expr *e;                  // NUMBER, OPERATOR, LINK, DROP_NOT
    Stmt *stmt;               // the statement that contains it; NULL: INITIAL, or part of what a window samples
    Var *var;                 // INITIAL
    uint32_t link;            // LINK: which operator of the chain
    SmOperator op;            // OPERATOR, LINK: the new operator
    double number;            // NUMBER, GUARD, INITIAL: the new number
    State *target;            // TARGET
    const MutantEdit *next;
};

// ---- mutant_initial.c ----

// Whether no run reads the initial value of a local, from whatever state it starts.
bool mutant_initial_is_unread(const Program *p, const Var *v);

// ---- mutant_equal.c ----

// Returns the step by which G advances, for mutants that differ only between two steps: the @step of the machine, or the
// delta_t of all its scripts if they agree.  0: unknown.
uint64_t mutant_step(const Program *p, const Script *const *script, uint32_t scripts);
// Whether it is proved that the machine behaves as before with these edits, from whatever state it starts and whatever its inputs are.
// Statements of p are changed during the call.
bool mutant_is_equivalent(Arena *work, const Program *p, const MutantEdit *edit, uint64_t step);

#endif
