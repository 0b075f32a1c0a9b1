// SPDX-License-Identifier: Apache-2.0
// When a mutant differs from its machine.  While the changed statements have the same effect, both are in the same state.  So the mutant first
// differs in one of several *cases*, each a list of conditions at a statement of the unchanged machine:
//
//     if p > 100: -> Abort           `>` changed to `>=`:   the case is at this statement, p >= 100 and not (p > 100)
//
// If no run of the machine reaches a case, the mutant is equivalent.  A probe makes a case a statement of the machine, which facts can exclude
// and a search can reach.
#ifndef SMC_MUTANT_CASES_H
#define SMC_MUTANT_CASES_H

#include "compiler/cover/mutant.h"

typedef struct MutantCase {
    Stmt *stmt;               // the case is a path to this statement, before it is executed
    const Expr *const *when;  // all of these n are true
    uint32_t n;
    uint32_t certain;         // the mutant differs only if the first `certain` conditions are true; the others make a difference likely
    uint32_t probe;           // Stmt.number of its probe
} MutantCase;

typedef struct MutantCases {
    VEC(MutantCase) at;
    bool unknown;             // the mutant can differ in other ways
} MutantCases;

// step: mutant_step.
MutantCases mutant_cases_list(Arena *arena, const Program *p, const MutantEdit *edit, uint64_t step);

// ---- mutant_probe.c ----

typedef struct SavedStmts { Stmts *list, was; } SavedStmts;

typedef struct MutantProbes {
    Program program;          // p with the probes: it shares the states of p
    VEC(SavedStmts) saved;
} MutantProbes;

// Inserts a probe for each case before its statement, and sets MutantCase.probe.  A probe stores a variable in itself, inside conditionals with the
// conditions.  for_facts: only with those that are `certain`, and in the form about which facts know most.  Returns NULL if the program stores no
// variable.
MutantProbes *mutant_probes_insert(Arena *arena, const Program *p, MutantCases *cases, bool for_facts);
// Removes the probes from the states of p.
void mutant_probes_remove(MutantProbes *b);

#endif
