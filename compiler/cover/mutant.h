// SPDX-License-Identifier: Apache-2.0
// What a mutant changes in the checked program, for the files of mutation (mutate.h).
#ifndef SMC_MUTANT_H
#define SMC_MUTANT_H

#include "compiler/cover/mutant_runs.h"
#include "compiler/cover/mutant_search.h"
#include "compiler/cover/mutate.h"

// A change of one expression, statement or initial value.  A mutant of [all_states] has one for each copy of the code.
struct MutantEdit {           // the names in front of ":" are values of `kind`
    enum { EDIT_NUMBER, EDIT_OPERATOR, EDIT_LINK, EDIT_DROP_UNARY, EDIT_GUARD, EDIT_TARGET, EDIT_DELETE, EDIT_INITIAL } kind;
    Expr *e;                  // NUMBER, OPERATOR, LINK, DROP_UNARY: the changed expression
    Stmt *stmt;               // the statement that is or contains what is changed; NULL: INITIAL, or the expression that a window samples
    Var *var;                 // INITIAL: the local
    uint32_t link;            // LINK: index of the operator in the chain
    SmOperator op;            // OPERATOR, LINK: the new operator
    double number;            // NUMBER, GUARD, INITIAL: the new number
    State *target;            // TARGET: the new target
    const MutantEdit *next;   // the edit of the next copy; NULL: none
};

// The work on all mutants of a machine.
struct Mutation {
    Arena *arena, work;       // `work` is emptied before every mutant
    const Program *p;
    MutantRuns *runs;
    uint64_t step;            // by how much G advances in each step, from mutant_step; 0: unknown
    uint32_t scripts;
    VEC(Mutant) mutant;
    uint32_t next, next_search, next_reach;   // indices in `mutant` of the next one to run; to search for; to decide about (mutant_reach.h)
    MutantSearch *search;     // NULL: no search has begun
    const Scenario *given;    // the runs of the scripts from which searches start, `givens` of them; set with `search`
    uint32_t givens;
    const State **start;      // the states in which scenarios can begin, `starts` of them
    uint32_t starts;
    const char *original;     // the IR of the unchanged machine as text; NULL: not printed yet
    uint64_t *initial;        // by Var.index: the initial value in the unchanged machine
    // While mutants are listed, the position of the current expression:
    const State *state;
    Stmt *stmt;               // NULL: the expression is in no statement
    MutantDanger danger;      // what its value can affect
    bool *hazard;             // by Var.index: the variable is a hazard
    bool *leads_to_hazard;    // by State.number - 1: the state switches a hazard on
    MutantDanger *of_local, *of_window;       // by Var.index; by index of the window: the most dangerous use of the value
};

// ---- mutate.c ----

// By how much G grows in each step of a search.
uint64_t mutation_delta_t(const Mutation *u);
// Searches a scenario that shows a mutant, also from the situations of the scenario `from`, if that is not NULL.
void mutation_search_from(Mutation *u, Mutant *m, const Scenario *from, uint64_t steps);

// Returns the number in the initial value of a local: -50 has 50.  NULL: the value is not written as a number with or without a sign.
Expr *mutant_initial_number(const Var *v);

// ---- mutate_list.c ----

// Lists all mutants, in the order of the source.
void mutation_list_all(Mutation *u);

// ---- mutant_hazards.c ----

// Whether the variable is an output that no state marked @safe or @abort switches on.  Without such marks none is.
bool mutant_is_hazard(const Program *p, const Var *v);
// Whether the state switches one of the hazards on; hazard: by Var.index.
bool mutant_state_has_hazard(const Program *p, const State *s, const bool *hazard);

// ---- mutant_initial.c ----

// Whether no run reads the initial value of a local, from whatever state it starts.
bool mutant_initial_is_unread(const Program *p, const Var *v);
// Whether no run that starts in one of these states reads it.
bool mutant_initial_is_unread_from(Arena *work, const Program *p, const Var *v, const State *const *start, uint32_t starts);
// Whether only the machine writes the local, and only its statements read it.
bool mutant_initial_is_own(const Program *p, const Var *v);

// ---- mutant_cases.c ----

// Returns the step by which G advances, for mutants that differ only between two steps: the @step of the machine, or the
// delta_t of all its scripts if they agree.  0: unknown.
uint64_t mutant_step(const Program *p, const Script *const *script, uint32_t scripts);

// ---- mutant_equal.c ----

// Whether it is proved that the machine behaves as before with these edits, from whatever state it starts and whatever its inputs are.
// Statements of p are changed during the call.
bool mutant_is_equivalent(Arena *work, const Program *p, const MutantEdit *edit, uint64_t step);

#endif
