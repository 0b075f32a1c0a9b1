// SPDX-License-Identifier: Apache-2.0
#ifndef SMC_EARLIER_GUARDS_H
#define SMC_EARLIER_GUARDS_H

#include "compiler/analysis/reach.h"

enum { LOOK_BACK = 16 };              // how many earlier guards a guard is compared with

// An earlier guard with the same outcome on every path to the current position.
typedef struct Before {
    const Stmt *stmt;
    bool holds;                       // the excluded outcome: that the guard is true
    bool left;                        // that outcome made a transition; false for enclosing guards, where the caller has to check
} Before;

typedef struct Befores {
    Before at[2 * LOOK_BACK];
    size_t n;
} Befores;

// The earlier guards of a guard that is evaluated inside `way`, at the current position of the walk.
Befores befores_of(const Structure *k, const Way *way);

// Whether no variable of e has been assigned since s was evaluated.
bool is_unchanged(const Structure *k, const Stmt *s, const Expr *e);

bool is_same(const Structure *k, const Expr *guard, const Before *b);
// An earlier guard with its excluded outcome wherever the guard is true: from their source form; from the facts too.
const Before *written_before(const Structure *k, const Expr *guard, const Befores *b);
const Before *the_one_before(const Structure *k, const Expr *guard, const Befores *b);

// Whether the guard states exactly the remaining cases: `p > 10: -> A` and then `p <= 10: -> B`.
bool is_the_rest(Structure *k, const Expr *guard, const Befores *b);

#endif
