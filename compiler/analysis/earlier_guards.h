// SPDX-License-Identifier: Apache-2.0
#ifndef SMC_EARLIER_GUARDS_H
#define SMC_EARLIER_GUARDS_H

#include "compiler/analysis/reach.h"

enum { EARLIER_MAX = 16 };            // how many earlier guards a guard is compared with

// An earlier guard that has the same outcome (true or false) on every path to the current position.  The other outcome is excluded.
typedef struct EarlierGuard {
    const Stmt *stmt;
    bool holds;                       // the excluded outcome
    bool leaves;                      // the excluded outcome leaves the state; false for enclosing guards, where it may or may not
} EarlierGuard;

typedef struct EarlierGuards {
    EarlierGuard at[2 * EARLIER_MAX];
    size_t n;
} EarlierGuards;

// The earlier guards of a guard that is evaluated inside `branch`, at the current position of the walk.
EarlierGuards earlier_guards_of(const ReachWalk *k, const Branch *branch);

// Whether no variable of e has been assigned since s was evaluated.
bool is_unchanged(const ReachWalk *k, const Stmt *s, const Expr *e);

// Whether b is the same expression as `guard`, and must be false here.
bool is_same_guard(const ReachWalk *k, const Expr *guard, const EarlierGuard *b);
// Returns an earlier guard that has its excluded outcome whenever `guard` is true, so `guard` is never true; or NULL.  The first
// function compares only the source of the two guards, the second also uses facts.
const EarlierGuard *find_excluding_guard(const ReachWalk *k, const Expr *guard, const EarlierGuards *b);
const EarlierGuard *find_explaining_guard(const ReachWalk *k, const Expr *guard, const EarlierGuards *b);

// Whether the guard is true in exactly the cases that earlier guards leave: `p <= 10: -> B` after `p > 10: -> A`.
bool covers_remaining_cases(ReachWalk *k, const Expr *guard, const EarlierGuards *b);

#endif
