// SPDX-License-Identifier: Apache-2.0
#include "compiler/facts/env_table.h"

#include <string.h>

enum { BITS = ENV_BITS, CHILDREN = ENV_CHILDREN };

bool env_is_private(const IrVar *v) { return v->space == IR_LOCAL && !v->outside; }

// With more variables than this, environments have so many nodes that looking up an equal node is faster than storing and joining copies.
enum { UNIQUE_FROM = 64 };

static unsigned levels_for(uint32_t n)
{
    unsigned levels = 1;

    while ((n - 1) >> (levels * BITS))
        levels++;
    return levels;
}

EnvShape env_shape_of_types(Arena *arena, const SmType *type, uint32_t n)
{
    return (EnvShape){arena, type, NULL, levels_for(n), NULL};
}

EnvShape env_shape(Arena *arena, const IrMachine *m)
{
    SmType *type = ARENA_ARRAY(arena, SmType, m->var.n);
    bool *is_private = ARENA_ARRAY(arena, bool, m->var.n);

    for (uint32_t v = 0; v < m->var.n; v++) {
        type[v] = m->var.at[v].type;
        is_private[v] = env_is_private(&m->var.at[v]);
    }
    // One more level: the root separates private variables from the others.
    return (EnvShape){arena, type, is_private, levels_for((uint32_t)m->var.n) + 1, m->var.n > UNIQUE_FROM ? env_table_new(arena) : NULL};
}

static bool is_root(const EnvShape *s, unsigned level) { return s->is_private && level == s->levels - 1; }

// Returns which child of a node on this level contains the variable.  A root that separates variables has two children: child 1 contains
// the private variables (locals that only the machine writes), child 0 the others.
static unsigned child_index(const EnvShape *s, uint32_t var, unsigned level)
{
    return is_root(s, level) ? s->is_private[var] : var >> (level * BITS) & (CHILDREN - 1u);
}

const Fact *env_find(const EnvShape *s, const Env *e, uint32_t var)
{
    for (unsigned level = s->levels - 1; e && level > 0; level--)
        e = e->child[child_index(s, var, level)].env;
    return e ? e->child[var & (CHILDREN - 1u)].fact : NULL;
}

Fact env_get(const EnvShape *s, const Env *e, uint32_t var)
{
    const Fact *fact = env_find(s, e, var);

    return fact ? *fact : fact_of_type(s->type[var]);
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
    return fact_equal(env_get(s, e, var), fact) ? e : set_below(s, e, var, new_fact(s, fact, s->type[var]), s->levels - 1);
}

static const Fact *join_facts(const EnvShape *s, const Fact *a, const Fact *b, uint32_t var, const FactLimits *widen)
{
    const SmType type = s->type[var];
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

// ---- all variables ----

// Returns the node of this level for the facts from variable `first` on; NULL if it is empty.
static const Env *node_of_facts(const EnvShape *s, const Fact *const *fact, uint32_t n, uint32_t first, unsigned level)
{
    Env e;
    bool any = false;

    for (uint32_t k = 0; k < CHILDREN; k++) {
        const uint32_t at = first | k << (level * BITS);
        if (level == 0)
            e.child[k].fact = at < n ? fact[at] : NULL;
        else
            e.child[k].env = at < n ? node_of_facts(s, fact, n, at, level - 1) : NULL;
        any |= level == 0 ? e.child[k].fact != NULL : e.child[k].env != NULL;
    }
    return any ? new_node(s, &e) : NULL;
}

const Env *env_of_facts(const EnvShape *s, const Fact *const *fact, uint32_t n)
{
    return node_of_facts(s, fact, n, 0, s->levels - 1);
}

static void each_difference_below(const Env *from, const Env *to, uint32_t first, unsigned level, EnvVisitFn *visit, void *context)
{
    static const Env empty;

    if (from == to)
        return;
    from = from ? from : &empty;
    to = to ? to : &empty;
    for (uint32_t k = 0; k < CHILDREN; k++) {
        const uint32_t at = first | k << (level * BITS);
        if (level > 0)
            each_difference_below(from->child[k].env, to->child[k].env, at, level - 1, visit, context);
        else if (from->child[k].fact != to->child[k].fact)
            visit(context, at, to->child[k].fact);
    }
}

void env_each_difference(const EnvShape *s, const Env *from, const Env *to, EnvVisitFn *visit, void *context)
{
    each_difference_below(from, to, 0, s->levels - 1, visit, context);
}
