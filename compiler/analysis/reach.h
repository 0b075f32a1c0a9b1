// SPDX-License-Identifier: Apache-2.0
// Shared by the analysis of structure: dead_code.c walks the statements, constant_guard.c judges each guard that the walk meets, reach.c
// reports states.  One cause produces one finding: consequences of a finding, or of an intentional switch, are not reported
// again.
#ifndef SMC_REACH_H
#define SMC_REACH_H

#include "compiler/analysis/analysis.h"

// Why something is never executed.
typedef enum Cause {
    CAUSE_TOLD,                   // explained by a finding, here or in another analysis
    CAUSE_SWITCH,                 // a guard of constants: intentional
    CAUSE_NEVER                   // a guard that is never true: reported at the state to which it leads, or else at the guard
} Cause;

typedef struct Dead {
    Cause cause;
    const Stmt *stmt;             // NEVER: the conditional
    const Stmt *earlier;          // NEVER: an earlier conditional whose guard is true whenever this one is; or NULL
    Diag *told;                   // TOLD, here: the finding to which states that become unreachable are added
    bool folded;                  // NEVER: reported at the state
} Dead;

// The conditionals around a statement, within its block.
typedef struct Way Way;
struct Way {
    const Stmt *stmt;
    bool holds;
    const Way *outer;
    uint32_t depth;
};

typedef struct Wrote {            // for undoing
    uint32_t var, was;
} Wrote;

enum { STORED_INITIAL = 1, STORED_OTHER = 2 };    // the initial value of the local; any other value

typedef struct Structure {
    Analysis *a;
    const State *state;           // the state that the walk is in
    BlockKind block;
    VEC(Dead) dead;
    uint32_t *why;                // by Stmt.number of a transition that is never taken: 1 + index in `dead`; 0: it may be taken
    VEC(const Way *) left;        // branches of this block that ended in a transition
    uint32_t *order, passed;      // by Stmt.number: its position in the walk; how many statements the walk has passed
    uint32_t *written;            // by Program.var: the position of its last write in this block; 0: never
    VEC(Wrote) log;
    uint8_t *stored;              // by Program.var: which values the machine stores in its locals, STORED_…
    uint32_t *stamp, stamps;      // by Program.var: equal to `stamps` if the current guard reads it
    size_t explained;             // how many conditionals so far have a dead branch that is explained
} Structure;

// Walks all statements of the states that are reachable according to the facts.
void find_dead(Structure *k);

// constant_guard.c: which branches of a conditional may be executed, and the cause if one may not.
typedef struct Verdict {
    bool then, otherwise;
    uint32_t dead;                // 1 + index in Structure.dead; 0: earlier guards cover all other cases, as intended
} Verdict;
Verdict judge(Structure *k, const Stmt *s, const Way *way);
void report_never(Structure *k, const Dead *d);                   // at the guard
void note_never(Structure *k, Diag *to, const Dead *d);           // as a note
uint32_t dead_of(Structure *k, Cause cause, const Stmt *stmt, const Stmt *earlier, Diag *told);

#endif
