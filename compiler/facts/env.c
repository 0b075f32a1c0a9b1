// SPDX-License-Identifier: Apache-2.0
#include "compiler/facts/env_table.h"

#include <string.h>

enum { BITS = ENV_BITS, CHILDREN = ENV_CHILDREN };

// Whether v is a local that only the machine itself writes.
bool env_is_private(const IrVar *v) { return v->space == IR_LOCAL && !v->outside; }

// Returns how many levels a tree needs for n variables, BITS bits of the index on each level.
static unsigned levels_for(uint32_t n)
{
    unsigned levels = 1;

    while ((n - 1) >> (levels * BITS))
        levels++;
    return levels;
}

EnvShape env_shape_of_types(Arena *arena, const SmType *type, uint32_t n)
{
    return (EnvShape){arena, type, NULL, NULL, {{NULL, 0}, {type, levels_for(n)}}, NULL};
}

EnvShape env_shape(Arena *arena, const IrMachine *m)
{
    SmType *type = ARENA_ARRAY(arena, SmType, m->var.n), *of_side[2];
    bool *is_private = ARENA_ARRAY(arena, bool, m->var.n);
    uint32_t *place = ARENA_ARRAY(arena, uint32_t, m->var.n), n[2] = {0, 0};
    EnvShape s = {arena, type, is_private, place, {{NULL, 0}, {NULL, 0}}, env_table_new(arena)};

    of_side[0] = ARENA_ARRAY(arena, SmType, m->var.n);
    of_side[1] = ARENA_ARRAY(arena, SmType, m->var.n);
    for (uint32_t v = 0; v < m->var.n; v++) {
        const int side = env_is_private(&m->var.at[v]);
        is_private[v] = side;
        place[v] = n[side]++;
        type[v] = of_side[side][place[v]] = m->var.at[v].type;
    }
    for (int side = 0; side < 2; side++)
        s.side[side] = (EnvSide){of_side[side], levels_for(n[side] ? n[side] : 1)};
    return s;
}

static unsigned side_of(const EnvShape *s, uint32_t var) { return s->is_private ? s->is_private[var] : 1; }
static uint32_t place_of(const EnvShape *s, uint32_t var) { return s->place ? s->place[var] : var; }

// Returns the index of the child of a node on this level below which the leaf entry `place` is.
static unsigned child_index(uint32_t place, unsigned level) { return place >> (level * BITS) & (CHILDREN - 1u); }

// Returns the stored fact about the variable; NULL if it is known only by its type.
const Fact *env_find(const EnvShape *s, const Env *e, uint32_t var)
{
    const uint32_t place = place_of(s, var);
    const unsigned side = side_of(s, var);

    if (e && s->is_private)
        e = e->child[side].env;
    for (unsigned level = s->side[side].levels - 1; e && level > 0; level--)
        e = e->child[child_index(place, level)].env;
    return e ? e->child[child_index(place, 0)].fact : NULL;
}

// Returns the fact about the variable: the stored fact, or else what its type says.
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

// Returns a copy of the node e, which is on level `level`, with the fact of the variable at this place replaced.
static const Env *copy_with_fact(const EnvShape *s, const Env *e, uint32_t place, const Fact *fact, unsigned level)
{
    static const Env empty;
    Env n = e ? *e : empty;
    const unsigned k = child_index(place, level);

    if (level == 0)
        n.child[k].fact = fact;
    else
        n.child[k].env = copy_with_fact(s, n.child[k].env, place, fact, level - 1);
    return new_node(s, &n);
}

// Returns e with another fact about the variable; e itself does not change.
const Env *env_set(const EnvShape *s, const Env *e, uint32_t var, Fact fact)
{
    static const Env empty;
    const unsigned side = side_of(s, var), top = s->side[side].levels - 1;
    const Fact *copy;
    Env root;

    if (fact_equal(env_get(s, e, var), fact))
        return e;
    copy = new_fact(s, fact, s->type[var]);
    if (!s->is_private)
        return copy_with_fact(s, e, place_of(s, var), copy, top);
    root = e ? *e : empty;
    root.child[side].env = copy_with_fact(s, root.child[side].env, place_of(s, var), copy, top);
    return new_node(s, &root);
}

// ---- joins ----

// Joins two facts about one variable, and widens the result if `widen` is given.
static const Fact *join_facts(const EnvShape *s, const Fact *a, const Fact *b, SmType type, const FactLimits *widen)
{
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

// Joins the leaves j->a and j->b. Children beyond the last variable are NULL.
static const Env *join_leaves(const EnvShape *s, const EnvJoin *j)
{
    Env both;

    for (uint32_t k = 0; k < CHILDREN; k++) {
        const Fact *of_a = j->a->child[k].fact, *of_b = j->b->child[k].fact;
        if (!of_a || !of_b)
            both.child[k].fact = NULL;
        else
            both.child[k].fact = of_a == of_b ? of_a : join_facts(s, of_a, of_b, s->side[j->side].type[j->first | k], j->widen);
    }
    return node_of_children(s, &both, j->a);
}

static const Env *join_nodes(const EnvShape *s, EnvJoin j);

// Joins the subtrees of j->a and j->b, child by child.
static const Env *join_inner_nodes(const EnvShape *s, const EnvJoin *j)
{
    Env both;

    for (uint32_t k = 0; k < CHILDREN; k++) {
        const Env *of_a = j->a->child[k].env, *of_b = j->b->child[k].env;
        const uint32_t at = j->first | k << (j->level * BITS);
        if (!of_a || !of_b)
            both.child[k].env = NULL;
        else
            both.child[k].env = of_a == of_b ? of_a : join_nodes(s, (EnvJoin){of_a, of_b, j->widen, at, j->level - 1u, j->side, NULL});
    }
    return node_of_children(s, &both, j->a);
}

// Joins two different nodes on one level.
static const Env *join_nodes(const EnvShape *s, EnvJoin j)
{
    if (s->unique && env_table_find_join(s->unique, &j))
        return j.joined;
    j.joined = j.level == 0 ? join_leaves(s, &j) : join_inner_nodes(s, &j);
    if (s->unique)
        env_table_add_join(s->unique, &j);
    return j.joined;
}

// Joins the trees a and b of one side (1: private variables, 0: the others).
static const Env *join_sides(const EnvShape *s, const Env *a, const Env *b, unsigned side, const FactLimits *widen)
{
    if (a == b || !a || !b)
        return a && b ? a : NULL;
    return join_nodes(s, (EnvJoin){a, b, widen, 0, s->side[side].levels - 1u, side, NULL});
}

// Returns the join: the facts that are true on both of two paths with the facts a and b.
const Env *env_join(const EnvShape *s, const Env *a, const Env *b, const FactLimits *widen)
{
    Env both = {{{NULL}}};

    if (!s->is_private || a == b || !a || !b)
        return join_sides(s, a, b, 1, widen);
    for (unsigned side = 0; side < 2; side++)
        both.child[side].env = join_sides(s, a->child[side].env, b->child[side].env, side, widen);
    if (both.child[0].env == a->child[0].env && both.child[1].env == a->child[1].env)
        return a;
    return both.child[0].env || both.child[1].env ? new_node(s, &both) : NULL;
}

// Returns an environment with the facts of e for private variables, and the facts of `shared` for all other variables.
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

// Returns a node of this level with the facts about the variables from `first` on; NULL if no variable below it has a fact.
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

// Returns the environment with the facts *fact[v] for the variables below n; NULL: only the type is known.
const Env *env_of_facts(const EnvShape *s, const Fact *const *fact, uint32_t n)
{
    return node_of_facts(s, fact, n, 0, s->side[1].levels - 1);
}

// Calls `visit` for each variable below this node whose fact differs between the two trees.  `first`: the first variable of the node.
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

// Calls `visit` for each variable about which `to` has another fact than `from`.
void env_each_difference(const EnvShape *s, const Env *from, const Env *to, EnvVisitFn *visit, void *context)
{
    each_difference_below(from, to, 0, s->side[1].levels - 1, visit, context);
}
