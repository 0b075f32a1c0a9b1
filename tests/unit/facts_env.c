// SPDX-License-Identifier: Apache-2.0
// Environments of facts.  With and without unique subtrees, random updates and joins give the same facts.  With unique subtrees, equal
// environments are the same object, and a join that was computed before is found.
#include <stdlib.h>
#include <string.h>

#include "compiler/facts/env_table.h"
#include "tests/heap.h"
#include "tests/test.h"
#include "tests/unit/random.h"

enum { VARS = 100, ENVS = 40, ROUNDS = 4000 };

static IrMachine *machine(Arena *arena)
{
    IrMachine *m = ARENA_NEW(arena, IrMachine);

    for (uint32_t i = 0; i < VARS; i++) {
        IrVar v = {0};
        v.space = i % 3 ? IR_LOCAL : IR_ELEMENT;
        v.type = SM_I16;
        vec_push(arena, &m->var, v);
    }
    return m;
}

// Returns one of a few facts, so that subtrees are often equal.
static Fact random_fact(void)
{
    return fact_of_cell(SM_I16, random_u64() >> 40 & 7);
}

static bool is_same(const EnvShape *s, const Env *a, const EnvShape *t, const Env *b)
{
    for (uint32_t v = 0; v < VARS; v++)
        if (!fact_equal(env_get(s, a, v), env_get(t, b, v)))
            return false;
    return true;
}

// Builds two environments in the same way, and compares all their facts.
static void test_same_facts(Arena *arena)
{
    const IrMachine *m = machine(arena);
    EnvShape plain = env_shape(arena, m), unique = plain;
    const Env *a[ENVS] = {NULL}, *b[ENVS] = {NULL};
    size_t differ = 0;

    plain.unique = NULL;
    unique.unique = env_table_new(arena);
    for (int n = 0; n < ROUNDS; n++) {
        const unsigned i = random_u64() >> 40 & 31, k = random_u64() >> 40 & 31;
        if (n % 3) {
            const uint32_t v = (uint32_t)(random_u64() >> 40) % VARS;
            const Fact f = random_fact();
            a[i] = env_set(&plain, a[k], v, f);
            b[i] = env_set(&unique, b[k], v, f);
        } else if (n % 2) {
            a[i] = env_join(&plain, a[i], a[k], NULL);
            b[i] = env_join(&unique, b[i], b[k], NULL);
        } else {
            a[i] = env_replace_shared(&plain, a[i], a[k]);
            b[i] = env_replace_shared(&unique, b[i], b[k]);
        }
        differ += !is_same(&plain, a[i], &unique, b[i]);
    }
    CHECK(differ == 0);
}

// The same facts, set in another order, are the same environment; so are two joins of the same pair.
static void test_unique(Arena *arena)
{
    const IrMachine *m = machine(arena);
    EnvShape s = env_shape(arena, m);
    const Env *up = NULL, *down = NULL, *other = NULL;

    CHECK(s.unique != NULL);                    // with this many variables, subtrees are unique
    for (uint32_t v = 0; v < VARS; v++) {
        up = env_set(&s, up, v, fact_of_cell(SM_I16, v & 7));
        down = env_set(&s, down, VARS - 1 - v, fact_of_cell(SM_I16, (VARS - 1 - v) & 7));
        other = env_set(&s, other, v, fact_of_cell(SM_I16, v & 3));
    }
    CHECK(up == down && up != other);
    CHECK(env_join(&s, up, other, NULL) == env_join(&s, down, other, NULL) && env_join(&s, up, other, NULL) != up);
}

int main(void)
{
    static Arena arena;
    jmp_buf oom;

    if (setjmp(oom)) {
        puts("out of memory: 0 passed, 1 failed");
        return 1;
    }
    arena_init(&arena, heap_alloc, NULL, &oom);
    test_same_facts(&arena);
    test_unique(&arena);
    arena_free(&arena);
    return test_end("facts_env");
}
