// SPDX-License-Identifier: Apache-2.0
#include "compiler/facts/slot_env.h"

#include <string.h>

static size_t bytes_of(const SlotEnvs *s) { return sizeof(SlotEnv) + s->slots * sizeof(Fact); }

static SlotEnv *allocate(SlotEnvs *s)
{
    SlotEnv *e = s->unused;

    if (!e)
        return arena_alloc_unzeroed(s->arena, bytes_of(s));
    s->unused = e->next;
    return e;
}

SlotEnv *slot_env_new(SlotEnvs *s)
{
    SlotEnv *e = allocate(s);

    e->changed = 0;
    return e;
}

SlotEnv *slot_env_copy(SlotEnvs *s, const SlotEnv *e)
{
    SlotEnv *copy = allocate(s);

    memcpy(copy, e, bytes_of(s));
    return copy;
}

void slot_env_free(SlotEnvs *s, SlotEnv *e)
{
    e->next = s->unused;
    s->unused = e;
}

const Fact *slot_env_find(SlotEnvs *s, const SlotEnv *e, uint32_t slot)
{
    const uint64_t bit = UINT64_C(1) << slot;

    if (e->changed & bit)
        return &e->fact[slot];
    s->read |= bit;
    return &s->begin[slot];
}

void slot_env_set(SlotEnv *e, uint32_t slot, Fact fact)
{
    const uint64_t bit = UINT64_C(1) << slot;

    if (e->changed & bit && fact_equal(e->fact[slot], fact))
        return;
    e->changed |= bit;
    e->fact[slot] = fact;
}

void slot_env_join(SlotEnvs *s, SlotEnv *into, const SlotEnv *from)
{
    uint64_t rest = into->changed | from->changed;

    for (uint32_t slot = 0; rest; slot++, rest >>= 1)
        if (rest & 1) {
            const Fact *a = slot_env_find(s, into, slot), *b = slot_env_find(s, from, slot);
            Fact both;
            if (fact_equal(*a, *b))                   // the usual case: the slot was changed before the two paths separated
                continue;
            both = fact_join(*a, *b);
            if (!fact_equal(both, *a))
                slot_env_set(into, slot, both);
        }
}

bool slot_env_is_same(const SlotEnv *a, const SlotEnv *b, uint64_t set)
{
    uint64_t rest = a->changed & set;

    if (rest != (b->changed & set))
        return false;
    for (uint32_t slot = 0; rest; slot++, rest >>= 1)
        if (rest & 1 && !fact_is_same(&a->fact[slot], &b->fact[slot]))
            return false;
    return true;
}
