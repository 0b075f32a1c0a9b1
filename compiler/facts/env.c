// SPDX-License-Identifier: Apache-2.0
#include "compiler/facts/env_table.h"

#include <string.h>

enum { BITS = ENV_BITS, CHILDREN = ENV_CHILDREN };

bool env_is_private(const IrVar *v) { return v->space == IR_LOCAL && !v->outside; }

// With more variables than this, environments have so many nodes that looking up an equal node is faster than storing and joining copies.
enum { UNIQUE_FROM = 64 };

EnvShape env_shape(Arena *arena, const IrMachine *m)
{
    EnvShape s = {arena, m, 1, m->var.n > UNIQUE_FROM ? env_table_new(arena) : NULL};

    while ((m->var.n - 1) >> (s.levels * BITS))
        s.levels++;
    s.levels++;                                       // the root separates private variables from the others
    return s;
}

static bool is_root(const EnvShape *s, unsigned level) { return level == s->levels - 1; }

// Returns which child of a node on this level contains the variable.  The root has two children: child 1 contains the private variables
// (locals that only the machine writes), child 0 the others.
static unsigned child_index(const EnvShape *s, uint32_t var, unsigned level)
{
    return is_root(s, level) ? env_is_private(&s->m->var.at[var]) : var >> (level * BITS) & (CHILDREN - 1u);
}

Fact env_get(const EnvShape *s, const Env *e, uint32_t var)
{
    const Fact *fact;

    for (unsigned level = s->levels - 1; e && level > 0; level--)
        e = e->child[child_index(s, var, level)].env;
    fact = e ? e->child[child_index(s, var, 0)].fact : NULL;
    return fact ? *fact : fact_of_type(s->m->var.at[var].type);
}

// Returns a node in the arena that is equal to *e.
static const Env *new_node(const EnvShape *s, const Env *e)
{
    return s->unique ? env_table_intern_node(s->unique, e) : arena_copy(s->arena, e, sizeof *e);
}

// Returns a copy of the fact for a leaf; NULL if the fact says no more than the variable's type.
static const Fact *new_fact(const EnvShape *s, Fact fact, SmType type)
{
    if (fact_equal(fact, fact_of_type(type)))
        return NULL;
    return s->unique ? env_table_intern_fact(s->unique, fact) : arena_copy(s->arena, &fact, sizeof fact);
}

// Returns a copy of the node e, which is on level `level`, with the variable's fact replaced.
static const Env *set_below(const EnvShape *s, const Env *e, uint32_t var, const Fact *fact, unsigned level)
{
    static const Env empty;
    Env n = e ? *e : empty;
    const unsigned k = child_index(s, var, level);

    if (level == 0)
        n.child[k].fact = fact;
    else
        n.child[k].env = set_below(s, n.child[k].env, var, fact, level - 1);
    return new_node(s, &n);
}

const Env *env_set(const EnvShape *s, const Env *e, uint32_t var, Fact fact)
{
    return fact_equal(env_get(s, e, var), fact) ? e : set_below(s, e, var, new_fact(s, fact, s->m->var.at[var].type), s->levels - 1);
}

static const Fact *join_facts(const EnvShape *s, const Fact *a, const Fact *b, uint32_t var, const FactLimits *widen)
{
    const SmType type = s->m->var.at[var].type;
    const Fact r = fact_join(*a, *b);

    if (fact_equal(r, *a))
        return a;
    return new_fact(s, widen ? fact_widen(*a, r, type, widen) : r, type);
}

// Returns a node with the children of *joined: `a` itself if it has the same children, NULL if all children are NULL.
static const Env *node_of_children(const EnvShape *s, const Env *joined, const Env *a)
{
    static const Env empty;

    if (memcmp(joined, a, sizeof *a) == 0)
        return a;
    return memcmp(joined, &empty, sizeof empty) == 0 ? NULL : new_node(s, joined);
}

// Joins two leaves.  `first`: the first variable below them.  Slots beyond the last variable are NULL.
static const Env *join_leaves(const EnvShape *s, const Env *a, const Env *b, uint32_t first, const FactLimits *widen)
{
    Env both;

    for (uint32_t k = 0; k < CHILDREN; k++) {
        const Fact *of_a = a->child[k].fact, *of_b = b->child[k].fact;
        both.child[k].fact = !of_a || !of_b ? NULL : of_a == of_b ? of_a : join_facts(s, of_a, of_b, first | k, widen);
    }
    return node_of_children(s, &both, a);
}

static const Env *join_nodes(const EnvShape *s, const Env *a, const Env *b, uint32_t first, unsigned level, const FactLimits *widen);

static const Env *join_inner_nodes(const EnvShape *s, const Env *a, const Env *b, uint32_t first, unsigned level, const FactLimits *widen)
{
    const unsigned shift = is_root(s, level) ? 32 : level * BITS;
    Env both;

    for (uint32_t k = 0; k < CHILDREN; k++) {
        const Env *of_a = a->child[k].env, *of_b = b->child[k].env;
        const uint32_t at = shift < 32 ? first | k << shift : 0;
        both.child[k].env = !of_a || !of_b ? NULL : of_a == of_b ? of_a : join_nodes(s, of_a, of_b, at, level - 1, widen);
    }
    return node_of_children(s, &both, a);
}

// Joins two different nodes on one level.
static const Env *join_nodes(const EnvShape *s, const Env *a, const Env *b, uint32_t first, unsigned level, const FactLimits *widen)
{
    EnvJoin j = {a, b, widen, first, level, NULL};

    if (s->unique && env_table_find_join(s->unique, &j))
        return j.joined;
    j.joined = level == 0 ? join_leaves(s, a, b, first, widen) : join_inner_nodes(s, a, b, first, level, widen);
    if (s->unique)
        env_table_add_join(s->unique, &j);
    return j.joined;
}

const Env *env_join(const EnvShape *s, const Env *a, const Env *b, const FactLimits *widen)
{
    if (a == b || !a || !b)
        return a && b ? a : NULL;
    return join_nodes(s, a, b, 0, s->levels - 1, widen);
}

const Env *env_replace_shared(const EnvShape *s, const Env *e, const Env *shared)
{
    static const Env empty;
    Env n = shared ? *shared : empty;

    if (!e || !e->child[1].env)
        return shared;
    n.child[1] = e->child[1];
    return new_node(s, &n);
}
