// SPDX-License-Identifier: Apache-2.0
#include "compiler/facts/env.h"

enum { BITS = 3, KIDS = 1 << BITS };

struct Env {
    union {
        const Env *env;               // in an inner node
        const Fact *fact;             // in a leaf
    } kid[KIDS];
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

static unsigned digit(const EnvShape *s, uint32_t var, unsigned level)
{
    return is_root(s, level) ? env_is_private(&s->m->var.at[var]) : var >> (level * BITS) & (KIDS - 1u);
}

Fact env_get(const EnvShape *s, const Env *e, uint32_t var)
{
    const Fact *fact;

    for (unsigned level = s->levels - 1; e && level > 0; level--)
        e = e->kid[digit(s, var, level)].env;
    fact = e ? e->kid[digit(s, var, 0)].fact : NULL;
    return fact ? *fact : fact_of_type(s->m->var.at[var].type);
}

static Env *copy(const EnvShape *s, const Env *e)
{
    Env *n = ARENA_NEW(s->arena, Env);

    if (e)
        *n = *e;
    return n;
}

static const Fact *keep(const EnvShape *s, Fact fact, SmType type)
{
    Fact *f;

    if (fact_equal(fact, fact_of_type(type)))
        return NULL;
    f = ARENA_NEW(s->arena, Fact);
    *f = fact;
    return f;
}

static const Env *set(const EnvShape *s, const Env *e, uint32_t var, const Fact *fact, unsigned level)
{
    Env *n = copy(s, e);
    const unsigned k = digit(s, var, level);

    if (level == 0)
        n->kid[k].fact = fact;
    else
        n->kid[k].env = set(s, n->kid[k].env, var, fact, level - 1);
    return n;
}

const Env *env_set(const EnvShape *s, const Env *e, uint32_t var, Fact fact)
{
    return fact_equal(env_get(s, e, var), fact) ? e : set(s, e, var, keep(s, fact, s->m->var.at[var].type), s->levels - 1);
}

static const Fact *join_facts(const EnvShape *s, const Fact *a, const Fact *b, uint32_t var, const FactLimits *widen)
{
    SmType type;
    Fact r;

    if (a == b || !a || !b)                // past the last variable both are NULL, so `var` is valid below
        return a && b ? a : NULL;
    type = s->m->var.at[var].type;
    r = fact_join(*a, *b);
    if (fact_equal(r, *a))
        return a;
    return keep(s, widen ? fact_widen(*a, r, type, widen) : r, type);
}

static const Env *join(const EnvShape *s, const Env *a, const Env *b, uint32_t first, unsigned level, const FactLimits *widen)
{
    Env both;
    bool same = true, empty = true;

    if (a == b || !a || !b)
        return a && b ? a : NULL;
    for (uint32_t k = 0; k < KIDS; k++) {
        const uint32_t at = is_root(s, level) ? 0 : first | k << (level * BITS);
        if (level == 0)
            both.kid[k].fact = join_facts(s, a->kid[k].fact, b->kid[k].fact, at, widen);
        else
            both.kid[k].env = join(s, a->kid[k].env, b->kid[k].env, at, level - 1, widen);
        same &= level == 0 ? both.kid[k].fact == a->kid[k].fact : both.kid[k].env == a->kid[k].env;
        empty &= level == 0 ? both.kid[k].fact == NULL : both.kid[k].env == NULL;
    }
    return same ? a : empty ? NULL : copy(s, &both);
}

const Env *env_join(const EnvShape *s, const Env *a, const Env *b, const FactLimits *widen)
{
    return join(s, a, b, 0, s->levels - 1, widen);
}

const Env *env_begin(const EnvShape *s, const Env *e, const Env *outside)
{
    Env *n;

    if (!e || !e->kid[1].env)
        return outside;
    n = copy(s, outside);
    n->kid[1] = e->kid[1];
    return n;
}
