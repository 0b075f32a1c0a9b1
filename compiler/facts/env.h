// SPDX-License-Identifier: Apache-2.0
// Facts about a machine's variables at one program point, as a persistent tree.  Thousands of blocks and states share their common
// subtrees, and joining two trees costs only their difference.  A variable without an entry is known only by its type.  NULL is the
// empty tree.
#ifndef SMC_ENV_H
#define SMC_ENV_H

#include "compiler/facts/fact.h"

typedef struct Env Env;

typedef struct EnvShape {
    Arena *arena;
    const IrMachine *m;
    unsigned levels;                  // of the tree
} EnvShape;

EnvShape env_shape(Arena *arena, const IrMachine *m);

Fact env_get(const EnvShape *s, const Env *e, uint32_t var);
const Env *env_set(const EnvShape *s, const Env *e, uint32_t var, Fact fact);
// The facts that are true in both.  Returns `a` itself if b adds nothing.  `widen`: limits for widening bounds beyond those of a; NULL
// for a plain join.
const Env *env_join(const EnvShape *s, const Env *a, const Env *b, const FactLimits *widen);

bool env_is_private(const IrVar *v);                          // whether v is a local that only the machine itself writes
// The facts of e for private variables, and those of `others` for all other variables.
const Env *env_begin(const EnvShape *s, const Env *e, const Env *others);

#endif
