// SPDX-License-Identifier: Apache-2.0
#include "compiler/facts/env.h"

enum { BITS = 3, CHILDREN = 1 << BITS };

struct Env {
    union {
        const Env *env;               // in an inner node
        const Fact *fact;             // in a leaf
    } child[CHILDREN];
};

bool env_is_private(const IrVar *v) { return v->space == IR_LOCAL && !v->outside; }

EnvShape env_shape(Arena *arena, const IrMachine *m)
{
    EnvShape s = {arena, m, 1};

    while ((m->var.n - 1) >> (s.levels * BITS))
        s.levels++;
    s.levels++;                                       // the root separates private variables from the others
    return s;
}

static bool is_root(const EnvShape *s, unsigned level) { return level == s->levels - 1; }

// Which child of a node on this level contains the variable.  The root has two: 1 has the private variables, 0 the others.
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

// A copy of e that may be changed; an empty node if e is NULL.
static Env *copy_node(const EnvShape *s, const Env *e)
{
    Env *n = ARENA_NEW(s->arena, Env);

    if (e)
        *n = *e;
    return n;
}

// A copy of the fact for a leaf; NULL if it only states the variable's type.
static const Fact *new_fact(const EnvShape *s, Fact fact, SmType type)
{
    Fact *f;

    if (fact_equal(fact, fact_of_type(type)))
        return NULL;
    f = ARENA_NEW(s->arena, Fact);
    *f = fact;
    return f;
}

// Returns a copy of the node e, which is on this level, with the variable's fact replaced.
static const Env *set_below(const EnvShape *s, const Env *e, uint32_t var, const Fact *fact, unsigned level)
{
    Env *n = copy_node(s, e);
    const unsigned k = child_index(s, var, level);

    if (level == 0)
        n->child[k].fact = fact;
    else
        n->child[k].env = set_below(s, n->child[k].env, var, fact, level - 1);
    return n;
}

const Env *env_set(const EnvShape *s, const Env *e, uint32_t var, Fact fact)
{
    return fact_equal(env_get(s, e, var), fact) ? e : set_below(s, e, var, new_fact(s, fact, s->m->var.at[var].type), s->levels - 1);
}

static const Fact *join_facts(const EnvShape *s, const Fact *a, const Fact *b, uint32_t var, const FactLimits *widen)
{
    SmType type;
    Fact r;

    if (a == b || !a || !b)                // where a leaf has more slots than there are variables, both are NULL
        return a && b ? a : NULL;
    type = s->m->var.at[var].type;
    r = fact_join(*a, *b);
    if (fact_equal(r, *a))
        return a;
    return new_fact(s, widen ? fact_widen(*a, r, type, widen) : r, type);
}

// `first`: the first variable below the two nodes.
static const Env *join_nodes(const EnvShape *s, const Env *a, const Env *b, uint32_t first, unsigned level, const FactLimits *widen)
{
    Env both;
    bool same = true, empty = true;

    if (a == b || !a || !b)
        return a && b ? a : NULL;
    for (uint32_t k = 0; k < CHILDREN; k++) {
        const uint32_t at = is_root(s, level) ? 0 : first | k << (level * BITS);
        if (level == 0)
            both.child[k].fact = join_facts(s, a->child[k].fact, b->child[k].fact, at, widen);
        else
            both.child[k].env = join_nodes(s, a->child[k].env, b->child[k].env, at, level - 1, widen);
        same &= level == 0 ? both.child[k].fact == a->child[k].fact : both.child[k].env == a->child[k].env;
        empty &= level == 0 ? both.child[k].fact == NULL : both.child[k].env == NULL;
    }
    return same ? a : empty ? NULL : copy_node(s, &both);
}

const Env *env_join(const EnvShape *s, const Env *a, const Env *b, const FactLimits *widen)
{
    return join_nodes(s, a, b, 0, s->levels - 1, widen);
}

const Env *env_replace_shared(const EnvShape *s, const Env *e, const Env *shared)
{
    Env *n;

    if (!e || !e->child[1].env)
        return shared;
    n = copy_node(s, shared);
    n->child[1] = e->child[1];
    return n;
}
