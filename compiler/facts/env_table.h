// SPDX-License-Identifier: Apache-2.0
// A table that stores equal subtrees of environments only once, and remembers the joins of subtrees.  So facts that are true in thousands
// of states are stored once, and compared and joined once.  Without the table, memory and time grow with states times variables.
//
// The table affects only the cost, not the facts.
#ifndef SMC_ENV_TABLE_H
#define SMC_ENV_TABLE_H

#include "compiler/facts/env.h"

enum { ENV_BITS = 3, ENV_CHILDREN = 1 << ENV_BITS };

struct Env {
    union {
        const Env *env;               // in an inner node: a child
        const Fact *fact;             // in a leaf: the fact about a variable
    } child[ENV_CHILDREN];
};

typedef struct EnvTable EnvTable;

// The join of the nodes a and b, with the result in `joined`.  Both are subtrees on level `level`, whose first leaf entry has index `first`.  An
// environment has two trees (EnvShape): 1 of the private variables, 0 of the others; `side` selects one.
typedef struct EnvJoin {
    const Env *a, *b;
    const FactLimits *widen;
    uint32_t first;
    uint32_t level, side;
    const Env *joined;
} EnvJoin;

EnvTable *env_table_new(Arena *arena);
// Each returns the stored fact or node that equals its argument.  If the table contains no equal one, stores a copy first.
const Fact *env_table_intern_fact(EnvTable *t, Fact f);
const Env *env_table_intern_node(EnvTable *t, const Env *e);
// Looks up the join that j describes.  If it is stored, sets j->joined and returns true.
bool env_table_find_join(const EnvTable *t, EnvJoin *j);
void env_table_add_join(EnvTable *t, const EnvJoin *j);

#endif
