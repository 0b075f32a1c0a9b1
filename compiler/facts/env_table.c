// SPDX-License-Identifier: Apache-2.0
#include "compiler/facts/env_table.h"

#include <string.h>

// A hash table with open addressing: `room` slots, a power of two, of which `n` are used, at most half.
typedef struct HashSlots {
    const void **at;
    uint32_t *hash;
    size_t n, room;
} HashSlots;

struct EnvTable {
    Arena *arena;
    HashSlots facts, nodes;
    EnvJoin *join;            // a cache of joins, by hash: a new join replaces an old one in the same entry
    size_t joins;             // number of entries of `join`; 0 or a power of two
};

enum {
    FIRST_ROOM = 64,
    MOST_JOINS = 1 << 16      // entries of the cache of joins: with more, clearing their memory costs more than they save
};

EnvTable *env_table_new(Arena *arena)
{
    EnvTable *t = ARENA_NEW(arena, EnvTable);

    t->arena = arena;
    return t;
}

// ---- hashes ----

static uint32_t hash_word(uint64_t hash, uint64_t word)
{
    word ^= word >> 32 ^ hash;                        // the low half of most F64 is 0
    return (uint32_t)(word * UINT64_C(0x9E3779B97F4A7C15) >> 32);
}

static uint64_t bits_of(double x)
{
    uint64_t u;

    memcpy(&u, &x, sizeof u);
    return u;
}

static uint32_t hash_fact(const Fact *f)
{
    return hash_word(hash_word(f->whole + 2u * f->f32 + 4u * f->nan + 8u * f->minus_zero + 16u * f->round_trips, bits_of(f->lo)), bits_of(f->hi));
}

static uint32_t hash_node(const Env *e)
{
    uint32_t hash = 0;

    for (int k = 0; k < ENV_CHILDREN; k++)
        hash = hash_word(hash, (uint64_t)(uintptr_t)e->child[k].env);
    return hash;
}

// ---- slots ----

// Adds an item at the first free slot from its hash on.
static void add_to_slot(HashSlots *s, const void *item, uint32_t hash)
{
    size_t i = hash & (s->room - 1);

    while (s->at[i])
        i = (i + 1) & (s->room - 1);
    s->at[i] = item;
    s->hash[i] = hash;
    s->n++;
}

static void add_item(EnvTable *t, HashSlots *s, const void *item, uint32_t hash)
{
    if (2 * s->n >= s->room) {
        const HashSlots old = *s;
        s->n = 0;
        s->room = old.room ? 2 * old.room : FIRST_ROOM;
        s->at = ARENA_ARRAY(t->arena, const void *, s->room);
        s->hash = ARENA_ARRAY(t->arena, uint32_t, s->room);
        for (size_t i = 0; i < old.room; i++)
            if (old.at[i])
                add_to_slot(s, old.at[i], old.hash[i]);
    }
    add_to_slot(s, item, hash);
}

const Fact *env_table_intern_fact(EnvTable *t, Fact f)
{
    const uint32_t hash = hash_fact(&f);
    const HashSlots *s = &t->facts;
    Fact *added;

    for (size_t i = hash & (s->room - 1); s->room && s->at[i]; i = (i + 1) & (s->room - 1))
        if (s->hash[i] == hash && fact_is_same(s->at[i], &f))
            return s->at[i];
    added = ARENA_NEW(t->arena, Fact);
    *added = f;
    add_item(t, &t->facts, added, hash);
    return added;
}

const Env *env_table_intern_node(EnvTable *t, const Env *e)
{
    const uint32_t hash = hash_node(e);
    const HashSlots *s = &t->nodes;
    Env *added;

    for (size_t i = hash & (s->room - 1); s->room && s->at[i]; i = (i + 1) & (s->room - 1))
        if (s->hash[i] == hash && memcmp(s->at[i], e, sizeof *e) == 0)
            return s->at[i];
    added = ARENA_NEW(t->arena, Env);
    *added = *e;
    add_item(t, &t->nodes, added, hash);
    return added;
}

// ---- joins ----

// Returns the slot of the cache of joins that belongs to j.  Joins with the same hash overwrite each other.
static EnvJoin *join_slot(const EnvTable *t, const EnvJoin *j)
{
    const uint32_t hash = hash_word(hash_word(j->first + j->level + j->side, (uint64_t)(uintptr_t)j->a), (uint64_t)(uintptr_t)j->b);

    return &t->join[hash & (t->joins - 1)];
}

// Looks up the join that j describes.  If it is stored, sets j->joined and returns true.
bool env_table_find_join(const EnvTable *t, EnvJoin *j)
{
    const EnvJoin *known = t->joins ? join_slot(t, j) : NULL;

    if (!known || known->a != j->a || known->b != j->b || known->widen != j->widen || known->first != j->first || known->level != j->level ||
        known->side != j->side)
        return false;
    j->joined = known->joined;
    return true;
}

void env_table_add_join(EnvTable *t, const EnvJoin *j)
{
    if (t->joins < t->nodes.room && t->joins < MOST_JOINS) {
        t->joins = t->nodes.room;
        t->join = ARENA_ARRAY(t->arena, EnvJoin, t->joins);
    }
    if (t->joins)
        *join_slot(t, j) = *j;
}
