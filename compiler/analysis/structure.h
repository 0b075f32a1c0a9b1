// SPDX-License-Identifier: Apache-2.0
// What the analysis of structure shares: dead.c walks the statements, guards.c judges each guard on the way, reach.c tells of
// states.  One cause, one finding: what a finding, or a switch set on purpose, explains is not told again.
#ifndef SMC_STRUCTURE_H
#define SMC_STRUCTURE_H

#include "compiler/analysis/analysis.h"

// Why something is never executed.
typedef enum Cause {
    CAUSE_TOLD,                   // a finding says so, here or in another analysis
    CAUSE_SWITCH,                 // a guard of constants: on purpose
    CAUSE_NEVER                   // a guard that never holds: told at the state to which it leads, or else at the guard
} Cause;

typedef struct Dead {
    Cause cause;
    const Stmt *stmt;             // NEVER: the conditional
    const Stmt *earlier;          // NEVER: one whose guard has held where this one would; or NULL
    Diag *told;                   // TOLD, here: to which the states that become unreachable are added
    bool folded;                  // NEVER: told at the state
} Dead;

// The conditionals around a statement, within its block.
typedef struct Way Way;
struct Way {
    const Stmt *stmt;
    bool holds;
    const Way *outer;
    uint32_t depth;
};

typedef struct Wrote {            // to be undone
    uint32_t var, was;
} Wrote;

enum { STORED_INITIAL = 1, STORED_OTHER = 2 };    // what a local begins with; something else

typedef struct Structure {
    Analysis *a;
    const State *state;           // at which the walk is
    BlockKind block;
    VEC(Dead) dead;
    uint32_t *why;                // by Stmt.number of a transition that is never made: 1 + index in `dead`; 0: it may be made
    VEC(const Way *) left;        // arms of this block that have ended in a transition
    uint32_t *order, passed;      // by Stmt.number: when it was walked over; how many were
    uint32_t *written;            // by Program.var: when this block wrote it last; 0: never
    VEC(Wrote) log;
    uint8_t *stored;              // by Program.var: what is stored in locals of the machine's own, STORED_…
    uint32_t *stamp, stamps;      // by Program.var: in the guard that is looked at
    size_t explained;             // conditionals so far of which an arm is dead and explained
} Structure;

// dead.c: all statements of the states that facts reach.
void find_dead(Structure *k);

// guards.c: which arms of a conditional may be executed, and what explains it if one may not.
typedef struct Verdict {
    bool then, otherwise;
    uint32_t dead;                // 1 + index in Structure.dead; 0: guards before this one cover everything, as was meant
} Verdict;
Verdict judge(Structure *k, const Stmt *s, const Way *way);
void report_never(Structure *k, const Dead *d);                   // at the guard
void note_never(Structure *k, Diag *to, const Dead *d);           // as a note
uint32_t dead_of(Structure *k, Cause cause, const Stmt *stmt, const Stmt *earlier, Diag *told);

#endif
