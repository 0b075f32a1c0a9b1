// SPDX-License-Identifier: Apache-2.0
// Facts about a machine's variables at one program point, as a persistent tree: an update copies one path and shares the rest.
// Thousands of blocks and states share subtrees, and the cost of joining two trees depends only on how much they differ.  A variable
// without an entry is known only by its type.  NULL is the empty tree.
#ifndef SMC_ENV_H
#define SMC_ENV_H

#include "compiler/facts/fact.h"

typedef struct Env Env;

typedef struct EnvSide {              // one of the two groups of variables: private ones, or all others.  A place is an index in the group
    const SmType *type;               // by place: the variable's type
    unsigned levels;                  // number of levels of the tree of the group; the leaves are level 0
} EnvSide;

// The variables whose facts an environment can contain, numbered from 0.  If private variables are separated from the others, the root has
// a tree for each of the two sides: child 1 contains the private variables (env_is_private), child 0 the others.
typedef struct EnvShape {
    Arena *arena;
    const SmType *type;               // by variable: its type
    const bool *is_private;           // by variable; NULL: not separated, all variables are on side 1
    const uint32_t *place;            // by variable: its index in its side's arrays; NULL: equal to the variable's number
    EnvSide side[2];
    struct EnvTable *unique;          // stores equal subtrees only once; NULL: equal subtrees may be stored several times
} EnvShape;

EnvShape env_shape(Arena *arena, const IrMachine *m);     // returns the shape of environments of all variables of a machine
// Returns the shape of environments of n variables (at least 1) of these types.
EnvShape env_shape_of_types(Arena *arena, const SmType *type, uint32_t n);

Fact env_get(const EnvShape *s, const Env *e, uint32_t var);         // returns the stored fact about the variable, or else what its type says
// Returns the stored fact about the variable; NULL if it is known only by its type.
const Fact *env_find(const EnvShape *s, const Env *e, uint32_t var);
const Env *env_set(const EnvShape *s, const Env *e, uint32_t var, Fact fact);
// Returns the join: the facts that are true on both of two paths with the facts a and b.  Returns `a` itself if b adds no values.
// `widen`: bounds that exceed those of a are widened to these limits; NULL: no widening.
const Env *env_join(const EnvShape *s, const Env *a, const Env *b, const FactLimits *widen);

// Returns the environment with the facts *fact[v] for the variables below n; NULL: only the type is known.  Does not copy the facts.
const Env *env_of_facts(const EnvShape *s, const Fact *const *fact, uint32_t n);
// Calls `visit` for each variable for which `from` and `to` do not share one stored fact, which is so wherever the facts differ.  `fact` is the
// fact in `to`; NULL: known only by its type.
// The cost depends only on how much the trees differ.  The variables of the shape must not be separated.
typedef void EnvVisitFn(void *context, uint32_t var, const Fact *fact);
void env_each_difference(const EnvShape *s, const Env *from, const Env *to, EnvVisitFn *visit, void *context);

bool env_is_private(const IrVar *v);                          // whether v is a local that only the machine itself writes
// Returns an environment with the facts of e for private variables, and the facts of `shared` for all other variables.
const Env *env_replace_shared(const EnvShape *s, const Env *e, const Env *shared);

#endif
