// SPDX-License-Identifier: Apache-2.0
// Records what a machine does while the reference interpreter runs it: of each statement its last execution, with the values of its
// parts, and since when each condition has had its value.  The memory that this needs depends on the machine, not on the number of steps.
#ifndef SMC_WATCH_H
#define SMC_WATCH_H

#include "compiler/script/engine.h"
#include "compiler/script/ref.h"

typedef enum WatchKind {
    WATCH_AND, WATCH_OR, WATCH_NOT,   // their operands follow
    WATCH_LEAF,               // a condition, or a value that is no condition
    WATCH_OPERAND             // a part of the preceding leaf whose value explains that leaf
} WatchKind;

// An expression whose value is recorded.  The nodes of a statement are in preorder; node 0 is its guard, or the value that it stores.
typedef struct WatchNode {
    const Expr *e;
    WatchKind kind;
    uint8_t depth;            // 0: node 0
    uint32_t end;             // index after the last node of this expression
} WatchNode;

typedef struct WatchStmt WatchStmt;
struct WatchStmt {
    const Stmt *stmt;         // NULL: the machine has no statement with this number
    const State *state;
    BlockKind block;
    const WatchStmt *parent;  // the enclosing conditional; NULL: none
    bool in_else;             // it belongs to the `else` of the parent
    bool is_recorded;         // every execution is recorded; else only those from Watch.from on
    WatchNode *node;
    uint32_t nodes;
    uint32_t base;            // number of values of the enclosing guards, the outermost first
    uint64_t *value;          // values of the last execution: those of its guards, then those of its nodes, in the form that watch_number reads
    uint64_t step, g;         // of its last execution; step 0: it was never executed
    uint64_t *since, *since_g;        // by node: step and G since which, in successive steps, it was evaluated and had its present truth
};

// A transition that was taken.
typedef struct WatchPassage {
    uint64_t step, g;
    const WatchStmt *by;
    uint64_t *value;          // values of the guards, then of the nodes, as in WatchStmt
} WatchPassage;

typedef struct Watch Watch;
struct Watch {
    RefObserver observer;
    const Program *p;         // a machine
    const uint64_t *steps;    // how many steps have run before the current one: a step's number is one more
    uint64_t from;            // the first step in which every statement is recorded; 0: all steps
    uint64_t step, g;         // the last step of the machine, 0: none; and its G
    uint64_t previous;        // the machine's step before `step`; 0: none
    bool is_first;            // it is the first step of its state
    const State *state;       // the state that the step ran
    uint64_t entered, entered_g;      // the first step of that state
    uint64_t *last_run, *last_run_g;  // by State.number - 1: the last step that ran the state, 0: none
    WatchStmt *stmt;          // by Stmt.number
    WatchStmt **stored_by;    // by variable: the statement that stored it last; NULL: none
    WatchPassage *passage;    // the last transitions, a ring buffer with room for `passages_most`
    uint32_t passages_most;
    uint64_t passages;        // number of transitions taken
};

// Prepares to watch a machine.  passages_most: how many of its last transitions are remembered; 0: none.
Watch *watch_new(Arena *arena, const Program *p, const uint64_t *steps, uint32_t passages_most);
// Restricts a watch: only statements that store one of the n variables are recorded in every step, all others from step `from` on.
// Then only what one of these steps has stored, and the values in steps from `from` on, are known, and no `since`.
void watch_restrict(Watch *w, const Var *const *stored, size_t n, uint64_t from);
// Watches an engine of engine_ref_open for one machine.
void watch_attach(Watch *w, Engine *ref);

// Returns remembered transition number i, where 0 is the last one; NULL: fewer are remembered.
const WatchPassage *watch_passage(const Watch *w, uint32_t i);
// Returns the value of node i of a statement as a number, and whether it is true. value: of WatchStmt or WatchPassage.
double watch_number(const WatchStmt *s, const uint64_t *value, uint32_t i);
bool watch_truth(const WatchStmt *s, const uint64_t *value, uint32_t i);
// Whether a guard or stored value consists of conditions, so that it has a truth.
bool watch_is_decision(const WatchStmt *s);
// Whether e compares its operands.
bool watch_is_relation(const Expr *e);
// Whether two positions are the same.
bool watch_same_span(Span a, Span b);
// Whether e counts how long the condition of a call of held has been true: no part of the source has this value.
bool watch_is_run(const Expr *e);
// Whether e is a call of held: returns the statistic of its run, or NULL.
const Expr *watch_held_run(const Expr *e);

#endif
