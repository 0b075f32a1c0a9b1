// SPDX-License-Identifier: Apache-2.0
// Shared by the files that find code and states which no run reaches: dead_code.c walks the statements, constant_guard.c judges each guard
// on this walk, reach.c reports states.  One cause produces one finding: consequences of a finding, or of an intentional switch,
// are not reported again.
#ifndef SMC_REACH_H
#define SMC_REACH_H

#include "compiler/analysis/analysis.h"

// Why a statement is never executed.
typedef enum DeadCause {
    CAUSE_REPORTED,               // explained by a finding, of this analysis or another one
    CAUSE_SWITCH,                 // a guard that constants alone decide, which is intentional
    CAUSE_NEVER                   // a guard that is never true: reported at the state to which the guard leads, or else at the guard
} DeadCause;

typedef struct DeadCode {
    DeadCause cause;
    const Stmt *stmt;             // NEVER: the conditional whose guard is never true
    const Stmt *earlier;          // NEVER: an earlier conditional whose guard makes the guard of `stmt` never true; or NULL
    Diag *finding;                // REPORTED by this analysis: the finding whose notes name the states that become unreachable; or NULL
    bool at_state;                // NEVER: a state is reported instead of the guard
} DeadCode;

// A branch of a conditional.  `outer` is the branch around it in the same block (.entry, .step or .exit), or NULL.
typedef struct Branch Branch;
struct Branch {
    const Stmt *stmt;             // the conditional
    bool holds;                   // whether the conditional's guard is true in this branch
    const Branch *outer;
    uint32_t depth;
};

typedef struct WriteUndo {
    uint32_t var, was;            // Var.index; the earlier value of ReachWalk.written[var]
} WriteUndo;

enum { STORED_INITIAL = 1, STORED_OTHER = 2 };    // a local's initial value; any other value

typedef struct ReachWalk {
    Analysis *a;
    const State *state;           // the state that the walk is in
    BlockKind block;
    VEC(DeadCode) dead;
    uint32_t *dead_by;            // by Stmt.number of a transition: 1 + index in `dead` of why it is never taken; 0: it may be taken
    VEC(const Branch *) leaving;  // branches of this block that ended in a transition
    uint32_t *order, passed;      // by Stmt.number: the statement's position in the order of the walk; number of statements visited so far
    uint32_t *written;            // by Program.var: position in the walk of the last write to the variable in this block; 0: not written
    VEC(WriteUndo) undo;          // the changes of `written`, so that they can be undone
    uint8_t *stored;              // by Program.var: which values the machine stores in the local: a set of STORED_…
    uint32_t *marked, mark;       // by Program.var: equal to `mark` if the current guard reads the variable
    size_t explained;             // how many conditionals walked so far have an entry in `dead`
} ReachWalk;

// dead_code.c: walks all statements of the states that are reachable according to the facts.
void walk_statements(ReachWalk *k);
// Whether some path through these statements ends in a transition.
bool has_transition(const Stmts *stmts);

// constant_guard.c: which branches of a conditional may be executed, and the cause if one may not.
typedef struct GuardVerdict {
    bool then, otherwise;
    uint32_t dead;                // 1 + index in ReachWalk.dead; 0: earlier guards cover all other cases, as intended
} GuardVerdict;
GuardVerdict judge_guard(ReachWalk *k, const Stmt *s, const Branch *branch);
void report_never_true(ReachWalk *k, const DeadCode *d);                   // reports a guard that is never true
void note_never_true(ReachWalk *k, Diag *to, const DeadCode *d);           // adds a note about a guard that is never true to the finding `to`
// Adds an entry to ReachWalk.dead.  Returns 1 + its index.
uint32_t add_dead_code(ReachWalk *k, DeadCause cause, const Stmt *stmt, const Stmt *earlier, Diag *finding);

#endif
