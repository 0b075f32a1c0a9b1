// SPDX-License-Identifier: Apache-2.0
// Facts of a machine's variables at one place: a persistent tree, so that thousands of blocks and states share what they have in
// common and joining two costs what differs.  A variable that is in none is only known by its type.  NULL is an empty one.
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
// What holds in both.  Gives `a` itself if b adds nothing; with limits, bounds beyond those of a are widened (else NULL).
const Env *env_join(const EnvShape *s, const Env *a, const Env *b, const FactLimits *widen);

bool env_is_private(const IrVar *v);                          // a local that nobody beside the machine writes
// What e tells of those, and `outside` of all others.
const Env *env_begin(const EnvShape *s, const Env *e, const Env *outside);

#endif
