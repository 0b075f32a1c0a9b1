// SPDX-License-Identifier: Apache-2.0
// Variables that carry what a machine has seen from one step to the next: where the machine sets them, resets them, and decides with them.
#ifndef SMC_CARRIED_H
#define SMC_CARRIED_H

#include "compiler/analysis/analysis.h"

typedef enum CarriedKind {
    CARRIED_NONE,
    CARRIED_LATCH,                // a bool that conditions set: every assignment is a constant, and it begins false
    CARRIED_EXTREME,              // v = max(v, …) or v = min(v, …), and assignments that do not read v
    CARRIED_COUNT,                // v = v + constant, and constants
    CARRIED_STAMP                 // v = G, and constants
} CarriedKind;

// An assignment to a carried variable.
typedef struct CarriedStore {
    const Stmt *stmt;
    const Stmts *list;            // the statements that contain it
    const State *state;
    BlockKind block;
    bool resets;                  // it discards what the variable carried
    bool certain;                 // it belongs to every run of its block, or to a list that always ends in a transition
} CarriedStore;

typedef struct Carried {
    CarriedKind kind;
    VEC(CarriedStore) store;
    VEC(const Stmt *) guard;      // conditionals that read it
    VEC(const State *) guard_state;   // the state of each
    uint32_t resets;
    bool unclear;                 // some reset is not certain
} Carried;

typedef struct CarriedTable {
    Analysis *a;
    Carried *of;                  // by Var.index
    size_t *first;                // transitions_by_state
} CarriedTable;

CarriedTable carried_of(Analysis *a);

// Whether the state sets the variable: some assignment of it is no reset.
bool carried_is_set_in(const Carried *c, const State *s);

// Marks (by State.number - 1) the states that follow `from`, itself not unless it follows, along transitions on which the variable is not
// reset.  v: an index in CarriedTable.of.
void carried_mark_reached(const CarriedTable *t, size_t v, const State *from, bool *mark);

#endif
