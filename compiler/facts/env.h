// SPDX-License-Identifier: Apache-2.0
// Facts about a machine's variables at one program point, as a persistent tree: an update copies one path and shares the rest.
// Thousands of blocks and states share subtrees, and the cost of joining two trees depends only on how much they differ.  A variable
// without an entry is known only by its type.  NULL is the empty tree.
#ifndef SMC_ENV_H
#define SMC_ENV_H

#include "compiler/facts/fact.h"

typedef struct Env Env;

typedef struct EnvShape {
    Arena *arena;
    const IrMachine *m;
    unsigned levels;                  // number of levels of the tree; the leaves are level 0
    struct EnvTable *unique;          // stores equal subtrees only once; NULL: equal subtrees may be stored several times
} EnvShape;

EnvShape env_shape(Arena *arena, const IrMachine *m);

Fact env_get(const EnvShape *s, const Env *e, uint32_t var);
const Env *env_set(const EnvShape *s, const Env *e, uint32_t var, Fact fact);
// Returns the join: the facts that are true on both of two paths with the facts a and b.  Returns `a` itself if b adds no values.
// `widen`: bounds that exceed those of a are widened to these limits; NULL: no widening.
const Env *env_join(const EnvShape *s, const Env *a, const Env *b, const FactLimits *widen);

bool env_is_private(const IrVar *v);                          // whether v is a local that only the machine itself writes
// Returns an environment with the facts of e for private variables, and the facts of `shared` for all other variables.
const Env *env_replace_shared(const EnvShape *s, const Env *e, const Env *shared);

#endif
