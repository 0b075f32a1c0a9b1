// SPDX-License-Identifier: Apache-2.0
#ifndef SMC_EARLIER_GUARDS_H
#define SMC_EARLIER_GUARDS_H

#include "compiler/analysis/reach.h"

enum { EARLIER_MAX = 16 };            // how many earlier guards a guard is compared with

// An earlier guard that has the same outcome (true or false) on every path to the current position.  The other outcome is excluded.
typedef struct EarlierGuard {
    const Stmt *stmt;
    bool holds;               // the excluded outcome
    bool leaves;                      // the branch of the excluded outcome leaves the state; false for enclosing guards
} EarlierGuard;

typedef struct EarlierGuards {
    EarlierGuard at[2 * EARLIER_MAX];
    size_t n;
} EarlierGuards;

// Returns the earlier guards of a guard that is evaluated inside `branch`, at the current position of the walk.
EarlierGuards earlier_guards_of(const ReachWalk *k, const Branch *branch);

// Whether no variable of e has been assigned since s was evaluated.
bool is_unchanged(const ReachWalk *k, const Stmt *s, const Expr *e);

// Whether the guard of b is the same expression as `guard`, and is false on every path to the current position.
bool is_same_guard(const ReachWalk *k, const Expr *guard, const EarlierGuard *b);
// Both return an earlier guard whose outcome on every path to here contradicts `guard`, so that `guard` is never true; or NULL.
// find_excluding_guard only compares the two expressions, find_explaining_guard also uses facts.
const EarlierGuard *find_excluding_guard(const ReachWalk *k, const Expr *guard, const EarlierGuards *b);
const EarlierGuard *find_explaining_guard(const ReachWalk *k, const Expr *guard, const EarlierGuards *b);

// For a guard that is always true at its position: whether it describes exactly the cases that earlier guards leave, as `p <= 10: -> B`
// after `p > 10: -> A`.
bool covers_remaining_cases(ReachWalk *k, const Expr *guard, const EarlierGuards *b);

#endif
