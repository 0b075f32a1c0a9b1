// SPDX-License-Identifier: Apache-2.0
#ifndef SMC_BEFORE_H
#define SMC_BEFORE_H

#include "compiler/analysis/structure.h"

enum { LOOK_BACK = 16 };              // earlier guards that one is compared with

// One that decided before: it held, or did not, on every way that gets here.
typedef struct Before {
    const Stmt *stmt;
    bool holds;                       // what is excluded here: that it holds
    bool left;                        // where it is so, a transition has been made; of guards around it: to be asked
} Before;

typedef struct Befores {
    Before at[2 * LOOK_BACK];
    size_t n;
} Befores;

// Of a guard that is asked on `way`, now.
Befores befores_of(const Structure *k, const Way *way);

// Whether no variable of e has been assigned since s decided.
bool is_unchanged(const Structure *k, const Stmt *s, const Expr *e);

bool is_same(const Structure *k, const Expr *guard, const Before *b);
// One that has been so wherever the guard holds: as they are written; by what values can be, too.
const Before *written_before(const Structure *k, const Expr *guard, const Befores *b);
const Before *the_one_before(const Structure *k, const Expr *guard, const Befores *b);

// Whether the guard just says in full what they have left over: `p > 10: -> A` and then `p <= 10: -> B`.
bool is_the_rest(Structure *k, const Expr *guard, const Befores *b);

#endif
