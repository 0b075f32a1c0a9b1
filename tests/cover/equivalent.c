// SPDX-License-Identifier: Apache-2.0
// Mutants that smc mutate calls equivalent, against the machine: random programs run in lockstep with each of their equivalent mutants, and
// every element and the state must be the same after each step.  In a program that declares a step, G advances by it.  A mutant that is equivalent
// only if nothing but inputs changes (mutant_reach.h) starts in the first state, and what the machine stores is written only before the first step.
//     equivalent [COUNT [SEED]]
#include <stdio.h>
#include <stdlib.h>

#include "compiler/search/mutant_reach.h"
#include "compiler/search/search.h"
#include "tests/diff/subject.h"

enum { STEPS = 300, ROUNDS = 4, REACH_EFFORT = 2000 };

static unsigned long compared, on_condition, failed, mutants;

// writable: by Var.index; NULL: all.
static void write_inputs(const FlatMachine *f, void *state, const Subject *s, const EngineWrite *write, uint32_t n, const bool *writable)
{
    for (uint32_t i = 0; i < n; i++) {
        const uint32_t at = f->m->var_of[s->program->var.at[write[i].var]->index];
        if (at != IR_NONE && (!writable || writable[write[i].var]))
            flat_cells(f, state)[at] = write[i].cell;
    }
}

// Returns by Var.index what is written if only inputs change: in the first step, elements that the machine stores, too.
static bool *list_inputs(Arena *arena, const Program *p, bool is_first)
{
    bool *writable = arena_alloc(arena, p->var.n);

    search_default_inputs(p, writable);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        writable[i] = v == p->g || writable[i] || (is_first && v->kind == VAR_ELEMENT && v != p->s);
    }
    return writable;
}

// Returns the first variable that differs, or NULL.
static const char *find_difference(const Program *p, const FlatMachine *a, void *of_a, const FlatMachine *b, void *of_b)
{
    const FlatState *x = of_a, *y = of_b;

    if (x->state != y->state || x->first != y->first)
        return "the next state";
    for (size_t i = 0; i < p->var.n; i++)
        if (p->var.at[i]->kind == VAR_ELEMENT && flat_cells(a, of_a)[a->m->var_of[i]] != flat_cells(b, of_b)[b->m->var_of[i]])
            return p->var.at[i]->name->text;
    return NULL;
}

// Runs machine and mutant.  Returns what differs, or NULL.
static const char *run_together(const Gen *g, const Subject *s, FlatMachine *a, FlatMachine *b, Arena *arena, uint32_t round, bool only_inputs)
{
    const bool *first = only_inputs ? list_inputs(arena, s->program, true) : NULL, *later = only_inputs ? list_inputs(arena, s->program, false) : NULL;
    void *of_a = arena_alloc(arena, a->size), *of_b = arena_alloc(arena, b->size);
    EngineWrite write[GEN_VARS_MAX + 1];
    Rng rng = {rng_mix(g->seed, round)};
    uint32_t state = g->first_state;
    const char *what = NULL;

    flat_start(a, of_a, only_inputs ? 1 : gen_state_number(g, state));
    flat_start(b, of_b, only_inputs ? 1 : gen_state_number(g, state));
    for (uint32_t k = 0; k < g->steps && !what; k++) {
        const uint32_t n = subject_writes(s, g, k, write);
        if (!only_inputs && gen_restarts(g, k, &state)) {
            flat_start(a, of_a, gen_state_number(g, state));
            flat_start(b, of_b, gen_state_number(g, state));
        }
        for (uint32_t i = 0; i < n; i++) {
            const Var *v = s->program->var.at[write[i].var];
            if (v == s->program->g && s->program->step)
                write[i].cell = (k + 1) * s->program->step;
            if (round > 0 && v != s->program->g && v != s->program->s && !v->parameter && rng_percent(&rng, 70))
                write[i].cell = gen_cell(&rng, v->type, round % 2);
        }
        write_inputs(a, of_a, s, write, n, k ? later : first);
        write_inputs(b, of_b, s, write, n, k ? later : first);
        if (flat_step(a, of_a) != flat_step(b, of_b))
            return "a step is refused";
        what = find_difference(s->program, a, of_a, b, of_b);
    }
    return what;
}

// Each round has other inputs.
static void check_mutant(const Gen *g, const Subject *s, Mutation *u, FlatMachine *original, const Mutant *m)
{
    Arena arena;
    const char *what = NULL;

    diff_arena_init(&arena);
    FlatMachine *mutant = mutation_build(u, &arena, m);
    for (uint32_t round = 0; round < ROUNDS && !what; round++)
        what = run_together(g, s, original, mutant, &arena, round, m->if_only_inputs_change);
    compared++;
    on_condition += m->if_only_inputs_change;
    if (what) {
        failed++;
        printf("seed %llu: byte %lu+%lu to '%s' is called equivalent, but %s differs: %.*s\n", (unsigned long long)g->seed, (unsigned long)m->span.at,
               (unsigned long)m->span.len, m->text, what, 60, m->span.src->text + (m->span.at > 30 ? m->span.at - 30 : 0));
    }
    arena_free(&arena);
}

static void check_program(uint64_t seed)
{
    Arena arena;
    Subject s;

    diff_arena_init(&arena);
    Gen *g = gen_program(&arena, seed, STEPS);
    gen_plan_time(g);
    if (subject_compile(&s, g, &arena) == NULL) {
        Mutation *u = mutation_new(&s.session.arena, s.program, 0, NULL, 0, NULL, STEPS);
        FlatMachine *original = flat_new(&s.session.arena, ir_build(&s.session.arena, s.program), NULL);
        uint32_t n;
        while (mutation_run_next(u))
            ;
        while (mutant_reach_next(u, REACH_EFFORT, 1))
            ;
        const Mutant *m = mutation_list(u, &n);
        mutants += n;
        for (uint32_t i = 0; i < n; i++)
            if (m[i].verdict == MUTANT_EQUIVALENT)
                check_mutant(g, &s, u, original, &m[i]);
        mutation_end(u);
    }
    subject_free(&s);
    arena_free(&arena);
}

int main(int argc, char **argv)
{
    const uint64_t count = argc > 1 ? strtoull(argv[1], NULL, 10) : 40, first = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;

    for (uint64_t seed = first; seed < first + count; seed++)
        check_program(seed);
    printf("equivalent mutants: %lu passed, %lu failed (of %lu mutants; %lu if only inputs change)\n", compared - failed, failed, mutants, on_condition);
    return failed || compared == 0 || on_condition == 0;
}
