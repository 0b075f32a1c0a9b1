// SPDX-License-Identifier: Apache-2.0
// Equal subtrees of environments as one subtree in memory, and the joins of subtrees that have been computed.  Facts that hold in
// thousands of states are then stored once, and compared and joined once.  Without it, memory and time grow with states times variables.
//
// Only the cost depends on the table: without one, equal subtrees may be different nodes.
#ifndef SMC_ENV_TABLE_H
#define SMC_ENV_TABLE_H

#include "compiler/facts/env.h"

enum { ENV_BITS = 3, ENV_CHILDREN = 1 << ENV_BITS };

struct Env {
    union {
        const Env *env;               // in an inner node
        const Fact *fact;             // in a leaf
    } child[ENV_CHILDREN];
};

typedef struct EnvTable EnvTable;

// A join of two nodes: `first` is the first variable below them, and their level.
typedef struct EnvJoin {
    const Env *a, *b;
    const FactLimits *widen;
    uint32_t first, level;
    const Env *joined;
} EnvJoin;

EnvTable *env_table_new(Arena *arena);
// Each returns the stored equal of its argument.  If there is none, stores a copy.
const Fact *env_table_intern_fact(EnvTable *t, Fact f);
const Env *env_table_intern_node(EnvTable *t, const Env *e);
// Looks up the join of j->a and j->b, and sets j->joined.  Returns whether it is known.
bool env_table_find_join(const EnvTable *t, EnvJoin *j);
void env_table_add_join(EnvTable *t, const EnvJoin *j);

#endif
