// SPDX-License-Identifier: Apache-2.0
// Checks smc diff on random machines:
//   a machine has the same behaviour as itself, in another layout, with additions written out, and with other names and another order of states;
//   a machine and a mutant of it never have the same behaviour if a run with random inputs shows a difference.
//     random SEED COUNT
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/cover/mutate.h"
#include "compiler/diff/diff.h"
#include "compiler/script/engine_ref.h"
#include "stdlib/convert.h"
#include "tests/diff/subject.h"

enum { STEPS = 60, MUTANTS = 6 };

typedef struct Counts { uint64_t same, reordered, uncertain, mutants, different, found, equal; } Counts;

static Counts count;

// Compares two compiled machines.
static ProgramDiff *compare(Arena *arena, Subject *a, Subject *b)
{
    const DiffSide old = {.p = a->program, .ir = session_ir(&a->session, a->program, 2)}, new = {.p = b->program, .ir = session_ir(&b->session, b->program, 2)};

    return diff_programs(arena, &old, &new);
}

static const char *differences(Arena *arena, const char *what, const ProgramDiff *d)
{
    Buf out;

    buf_init(&out, arena);
    buf_printf(&out, "%s\n", what);
    diff_write_text(d, &out);
    return buf_text(&out);
}

// ---- the same machine in another form ----

// Returns NULL if the changed program has the same behaviour for smc diff.
static const char *test_form(Arena *arena, Subject *a, Gen *g, const char *what)
{
    Subject b;
    const char *wrong = subject_compile(&b, g, arena);

    if (!wrong) {
        const ProgramDiff *d = compare(arena, a, &b);
        wrong = diff_is_same(d) ? NULL : differences(arena, what, d);
        count.same += wrong == NULL;
    }
    subject_free(&b);
    return wrong;
}

// Gives every local and every state another name.
static void rename_all(Gen *g)
{
    for (size_t i = 0; i < g->var.n; i++)
        if (g->var.at[i]->is_local)
            g->var.at[i]->name = format_in(g->arena, "zv%lu", (unsigned long)i);
    for (size_t i = 0; i < g->state.n; i++)
        g->state.at[i]->name = format_in(g->arena, "Zs%lu", (unsigned long)i);
}

// Reverses the order of the states after the first one.
static void reorder(Gen *g)
{
    for (size_t i = 1, k = g->state.n - 1u; i < k; i++, k--) {
        GState *s = g->state.at[i];
        g->state.at[i] = g->state.at[k];
        g->state.at[k] = s;
    }
}

static const char *test_forms(Arena *arena, Subject *a, uint64_t seed)
{
    const char *wrong = NULL;
    Gen *g = gen_program(arena, seed, STEPS);
    bool reads_s = a->program->s->read;

    wrong = test_form(arena, a, g, "itself");
    for (int c = 0; c < CHANGE_COUNT && !wrong; c++)
        if (c == CHANGE_LAYOUT || (c == CHANGE_BY_HAND && g->additions)) {
            gen_change(g, (GChange)c);
            wrong = test_form(arena, a, g, gen_change_name[c]);
            gen_change_back(g);
        }
    if (wrong)
        return wrong;
    rename_all(g);
    wrong = test_form(arena, a, g, "renamed");
    g = gen_program(arena, seed, STEPS);
    reorder(g);
    if (!wrong && !reads_s && g->rule.n == 0 && (wrong = test_form(arena, a, g, "reordered")) == NULL)
        count.reordered++;
    return wrong;
}

// ---- mutants ----

// Compiles the machine of `a` after an edit.  Returns false if the edit is no valid program.
static bool compile_mutant(Subject *b, Subject *a, Gen *g, const Mutant *m)
{
    const Source *src = a->program->src;
    MachineInput in = {0};
    Map *written;
    Buf text, sv;

    session_init(&b->session, a->session.arena.alloc, a->session.arena.context, a->session.arena.oom);
    buf_init(&text, &b->session.arena);
    buf_init(&sv, &b->session.arena);
    buf_put(&text, src->text, m->span.at);
    buf_str(&text, m->text);
    buf_put(&text, src->text + m->span.at + m->span.len, src->len - m->span.at - m->span.len);
    in.sm = source_new(&b->session.arena, src->name, buf_text(&text), text.n);
    if (g->with_sv) {
        gen_print_sv(g, &sv);
        in.sv = source_new(&b->session.arena, "bus.sv", buf_text(&sv), sv.n);
    }
    in.written_outside = written = ARENA_NEW(&b->session.arena, Map);
    written->arena = &b->session.arena;
    for (size_t i = 0; i < g->var.n; i++)
        if (g->var.at[i]->is_local && g->var.at[i]->outside)
            map_put(written, str_c(&b->session.strings, g->var.at[i]->name), written);
    b->program = session_program(&b->session, &in);
    return b->program != NULL;
}

// Runs both machines with the same inputs.  Returns whether a state or an element differs after some step.
static bool runs_differ(Arena *arena, const Subject *a, const Subject *b, const Gen *g)
{
    EngineWrite write[GEN_VARS_MAX];
    Engine *e = engine_ref_open(arena, a->program), *f = engine_ref_open(arena, b->program);
    EngineStep x, y;

    engine_step_init(&x, arena, a->program);
    engine_step_init(&y, arena, b->program);
    e->init(e, 1, &x);
    f->init(f, 1, &y);
    for (uint32_t k = 0; k < STEPS; k++) {
        const uint32_t n = subject_writes(a, g, k, write);
        x.status = e->step(e, write, n, &x);
        y.status = f->step(f, write, n, &y);
        if (x.status != y.status || x.next_state != y.next_state)
            return true;
        for (size_t i = 0; i < a->program->var.n; i++) {
            const Var *v = a->program->var.at[i];
            if (v->kind == VAR_ELEMENT && x.cell[i] != y.cell[i])
                return true;
        }
    }
    return false;
}

static const char *test_mutants(Arena *arena, Subject *a, Gen *g)
{
    Mutation *u = mutation_new(arena, a->program, 0, NULL, 0, NULL, STEPS);
    uint32_t n;
    const Mutant *list = mutation_list(u, &n);
    const char *wrong = NULL;
    Rng rng = {rng_mix(g->seed, 77)};

    for (uint32_t i = 0; i < MUTANTS && n > 0 && !wrong; i++) {
        const Mutant *m = &list[rng_below(&rng, n)];
        Subject b;
        if (compile_mutant(&b, a, g, m)) {
            const ProgramDiff *d = compare(arena, a, &b);
            const bool same = diff_is_same(d), differs = runs_differ(arena, a, &b, g);
            count.mutants++;
            count.different += differs;
            count.found += differs && !same;
            count.equal += same;
            if (differs && same)
                wrong = format_in(arena, "a run differs, but smc diff reports the same behaviour: %.*s at %lu becomes %s\n%s", (int)m->span.len,
                                  a->program->src->text + m->span.at, (unsigned long)source_position(m->span.src, m->span.at).line, m->text, a->program->src->text);
        }
        subject_free(&b);
    }
    mutation_end(u);
    return wrong;
}

// ---- the campaign ----

static const char *test_program(Arena *arena, uint64_t seed)
{
    Gen *g = gen_program(arena, seed, STEPS);
    Subject a;
    const char *wrong = subject_compile(&a, g, arena);

    if (!wrong)
        wrong = test_forms(arena, &a, seed);
    if (!wrong)
        wrong = test_mutants(arena, &a, g);
    subject_free(&a);
    return wrong;
}

// A campaign that compared nothing has failed.  The shares are about half of what 150 programs reach.
static bool was_thorough(uint64_t programs)
{
    const bool good = count.same >= 2 * programs && count.mutants >= 3 * programs && count.different * 20 >= count.mutants && count.equal > programs / 20;

    printf("%" PRIu64 " forms with the same behaviour, %" PRIu64 " reordered; %" PRIu64 " mutants: %" PRIu64 " differ in a run, all of them found; %" PRIu64 " have the same behaviour\n",
           count.same, count.reordered, count.mutants, count.different, count.equal);
    return good;
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1, programs = argc > 2 ? strtoull(argv[2], NULL, 10) : 100;
    uint64_t passed = 0, failed = 0;

    for (uint64_t i = seed; i < seed + programs; i++) {
        Arena arena;
        const char *wrong;
        diff_arena_init(&arena);
        wrong = test_program(&arena, i);
        passed += !wrong;
        failed += wrong != NULL;
        if (wrong)
            printf("seed %" PRIu64 ": %s\n", i, wrong);
        arena_free(&arena);
    }
    if (!was_thorough(programs)) {
        puts("too little was compared");
        failed++;
    }
    printf("%" PRIu64 " passed, %" PRIu64 " failed\n", passed, failed);
    return failed > 0;
}
