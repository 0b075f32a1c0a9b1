// SPDX-License-Identifier: Apache-2.0
#ifndef SMC_EARLIER_GUARDS_H
#define SMC_EARLIER_GUARDS_H

#include "compiler/analysis/reach.h"

enum { EARLIER_MAX = 16 };            // how many earlier guards a guard is compared with

// An earlier guard with the same outcome on every path to the current position.
typedef struct EarlierGuard {
    const Stmt *stmt;
    bool holds;                       // the excluded outcome: that the guard is true
    bool leaves;                      // that outcome made a transition; false for enclosing guards, where the caller has to check
} EarlierGuard;

typedef struct EarlierGuards {
    EarlierGuard at[2 * EARLIER_MAX];
    size_t n;
} EarlierGuards;

// The earlier guards of a guard that is evaluated inside `branch`, at the current position of the walk.
EarlierGuards earlier_guards_of(const ReachWalk *k, const Branch *branch);

// Whether no variable of e has been assigned since s was evaluated.
bool is_unchanged(const ReachWalk *k, const Stmt *s, const Expr *e);

bool is_same_guard(const ReachWalk *k, const Expr *guard, const EarlierGuard *b);
// An earlier guard with its excluded outcome wherever the guard is true: from their source form; from the facts too.
const EarlierGuard *find_excluding_guard(const ReachWalk *k, const Expr *guard, const EarlierGuards *b);
const EarlierGuard *find_explaining_guard(const ReachWalk *k, const Expr *guard, const EarlierGuards *b);

// Whether the guard states exactly the remaining cases: `p > 10: -> A` and then `p <= 10: -> B`.
bool covers_remaining_cases(ReachWalk *k, const Expr *guard, const EarlierGuards *b);

#endif
