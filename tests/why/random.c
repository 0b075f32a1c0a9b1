// SPDX-License-Identifier: Apache-2.0
// Checks what a watch records in runs of random machines: the truth of each guard against the branch that the step executed, and each
// `since` against a search back through the whole run.
//     random SEED COUNT
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/script/watch.h"
#include "tests/diff/subject.h"

enum { STEPS = 60, NODES_MOST = 64 };

static struct { uint64_t guards, branches, changed; } met;

// Returns whether the first statement of a branch was executed in the step.
static bool was_executed(const Watch *w, const Stmts *branch) { return branch->n && w->stmt[branch->at[0]->number].step == w->step; }

static const char *check_guard(Arena *arena, const Watch *w, const WatchStmt *s, uint8_t (*truth)[NODES_MOST], uint64_t step, uint32_t stmts)
{
    const bool is_true = watch_truth(s, s->value, 0);

    if (was_executed(w, is_true ? &s->stmt->otherwise : &s->stmt->then) || ((is_true ? s->stmt->then.n : s->stmt->otherwise.n) && !was_executed(w, is_true ? &s->stmt->then : &s->stmt->otherwise)))
        return format_in(arena, "statement %lu: its guard was recorded as %d, but the step executed the other branch", (unsigned long)s->stmt->number, is_true);
    met.branches += was_executed(w, &s->stmt->then) || was_executed(w, &s->stmt->otherwise);
    for (uint32_t i = 0; i < s->nodes && i < NODES_MOST; i++) {
        const uint8_t now = (uint8_t)(1 + watch_truth(s, s->value, i));
        uint64_t since = step;
        truth[step * stmts + s->stmt->number][i] = now;
        while (since > 1 && truth[(since - 1) * stmts + s->stmt->number][i] == now)
            since--;
        if (s->since[i] != since)
            return format_in(arena, "statement %lu, node %lu: since step %" PRIu64 ", not %" PRIu64, (unsigned long)s->stmt->number, (unsigned long)i, s->since[i], since);
        met.changed += since > 1 && since < step;
    }
    met.guards++;
    return NULL;
}

static const char *run(Subject *s, Gen *g, Arena *arena)
{
    const Program *p = s->program;
    const uint32_t stmts = p->stmts + 1;
    uint8_t (*truth)[NODES_MOST] = arena_array(arena, (STEPS + 1) * (size_t)stmts, sizeof *truth);
    EngineWrite write[GEN_VARS_MAX];
    Engine *ref = engine_ref_open(arena, p);
    uint64_t steps = 0;
    Watch *w = watch_new(arena, p, &steps, 3);
    EngineStep out;
    const char *why = NULL;

    watch_attach(w, ref);
    engine_step_init(&out, arena, p);
    ref->init(ref, 1 + (uint32_t)(g->seed % p->state.n), &out);
    for (uint32_t k = 0; k < STEPS && !why; k++) {
        if (ref->step(ref, write, subject_writes(s, g, k, write), &out) != ENGINE_OK)
            continue;
        steps++;
        for (uint32_t i = 1; i < stmts && !why; i++)
            if (w->stmt[i].stmt && w->stmt[i].stmt->kind == ST_IF && w->stmt[i].step == steps)
                why = check_guard(arena, w, &w->stmt[i], truth, steps, stmts);
        if (!why && engine_ref_transition(ref) != (w->passages && watch_passage(w, 0)->step == steps ? watch_passage(w, 0)->by->stmt : NULL))
            why = "the transition was not recorded";
    }
    return why;
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1, count = argc > 2 ? strtoull(argv[2], NULL, 10) : 500;
    uint64_t failed = 0;

    for (uint64_t i = 0; i < count; i++) {
        Arena arena;
        Subject s;
        Gen *g;
        const char *why;
        diff_arena_init(&arena);
        g = gen_program(&arena, rng_mix(seed, i), STEPS);
        why = subject_compile(&s, g, &arena);
        if (!why)
            why = run(&s, g, &arena);
        if (why) {
            printf("seed %" PRIu64 ", program %" PRIu64 ": %s\n", seed, i, why);
            failed++;
        }
        subject_free(&s);
        arena_free(&arena);
    }
    if (met.guards < 10 * count || met.branches < count || met.changed < count) {
        printf("too little was met: %" PRIu64 " guards, %" PRIu64 " branches, %" PRIu64 " changes\n", met.guards, met.branches, met.changed);
        failed++;
    }
    printf("%" PRIu64 " passed, %" PRIu64 " failed\n", count - (failed < count ? failed : count), failed);
    return failed > 0;
}
