// SPDX-License-Identifier: Apache-2.0
// Records what a machine does while the reference interpreter runs it: the last execution of each statement, with the values of its
// subexpressions, and since when each condition has had its value.  The memory needed depends on the machine, not on the number of steps.
#ifndef SMC_WATCH_H
#define SMC_WATCH_H

#include "compiler/script/engine.h"
#include "compiler/script/ref.h"

typedef enum WatchKind {
    WATCH_AND, WATCH_OR, WATCH_NOT,   // nodes of conditions; the nodes of their operands follow
    WATCH_LEAF,               // a condition without and, or, not; or a value that is no condition
    WATCH_OPERAND             // an operand in the preceding leaf, such as a variable, whose value explains that leaf
} WatchKind;

// An expression whose value is recorded.  The nodes of a statement are in preorder; node 0 is its guard, or the value that it stores.
typedef struct WatchNode {
    const Expr *e;
    WatchKind kind;
    uint8_t depth;            // depth below node 0, which has depth 0
    uint32_t end;             // 1 + the index of the last node of this expression
} WatchNode;

typedef struct WatchStmt WatchStmt;
struct WatchStmt {
    const Stmt *stmt;         // NULL: the machine has no statement with this number
    const State *state;
    BlockKind block;
    const WatchStmt *parent;  // the enclosing conditional; NULL: none
    bool in_else;             // the statement is in the `else` of the parent
    bool is_recorded;         // every execution is recorded; else only those from Watch.from on
    WatchNode *node;
    uint32_t nodes;
    uint32_t base;            // number of entries of `value` that belong to the enclosing guards
    uint64_t *value;          // of the last execution: the values of the enclosing guards, the outermost first, then of `node`; see watch_number
    uint64_t step, g;         // number and G of the step that executed it last; step 0: it was never executed
    uint64_t *since, *since_g;        // by node: number and G of the step since which every step evaluated it with the same truth
};

// A transition that the machine has taken.
typedef struct WatchPassage {
    uint64_t step, g;         // number and G of the step that took it
    const WatchStmt *by;      // the transition's statement
    uint64_t *value;          // values of the guards, then of the nodes, as in WatchStmt
} WatchPassage;

typedef struct Watch Watch;
struct Watch {
    RefObserver observer;
    const Program *p;         // the machine that is watched
    const uint64_t *steps;    // the run's counter of completed steps: the number of the current step is one more
    uint64_t from;            // number of the first step in which every statement is recorded; 0: all steps
    uint64_t step, g;         // number and G of the machine's last step; step 0: none
    uint64_t previous;        // number of the machine's step before `step`; 0: none
    bool is_first;            // step `step` is the first of its state
    const State *state;       // the state that step `step` ran
    uint64_t entered, entered_g;      // number and G of the first step since `state` was entered
    uint64_t *last_run, *last_run_g;  // by State.number - 1: number and G of the last step that ran the state; 0: none
    WatchStmt *stmt;          // by Stmt.number: its record
    WatchStmt **stored_by;    // by Var.index: the statement that stored the variable last; NULL: none
    WatchPassage *passage;    // the last transitions that were taken: a ring buffer
    uint32_t passages_most;   // capacity of `passage`
    uint64_t passages;        // number of transitions taken so far
};

// Prepares to watch a machine.  passages_most: how many of its last transitions are remembered; 0: none.
Watch *watch_new(Arena *arena, const Program *p, const uint64_t *steps, uint32_t passages_most);
// Restricts a watch: only statements that store one of the n variables are recorded in every step, all others from step `from` on.
// Then `value` is known for these statements and for executions from step `from` on, and `since` is not known.
void watch_restrict(Watch *w, const Var *const *stored, size_t n, uint64_t from);
// Watches an engine of engine_ref_open for one machine.
void watch_attach(Watch *w, Engine *ref);

// Returns remembered transition number i, where 0 is the last one; NULL: fewer are remembered.
const WatchPassage *watch_passage(const Watch *w, uint32_t i);
// Returns the value of node i of a statement as a number, and whether it is true. value: of WatchStmt or WatchPassage.
double watch_number(const WatchStmt *s, const uint64_t *value, uint32_t i);
bool watch_truth(const WatchStmt *s, const uint64_t *value, uint32_t i);
// Whether the expression of a statement is a condition: a guard, or a stored value that is true or false.
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
