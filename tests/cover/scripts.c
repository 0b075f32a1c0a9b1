// SPDX-License-Identifier: Apache-2.0
// Checks that a written script is its scenario: random scenarios of random machines are written, compiled and run on the reference
// interpreter, beside scenario_run.  All cells must be equal after each step, and every assert must pass.
//     scripts SEED COUNT [--print]
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/search/script_writer.h"
#include "compiler/search/search.h"
#include "stdlib/convert.h"
#include "tests/diff/subject.h"

enum { STEPS_MOST = 60, CHANGES_MOST = 12 };

// What has occurred, so that the test knows whether it was thorough.
static struct { uint64_t scripts, circles, asserts, kind[SCENARIO_COPY + 1], type[SM_TYPE_COUNT], written, loops, rounds; } met;

// ---- random scenarios ----

static bool can_be_set(const Program *p, const Var *v)
{
    return v != p->g && v != p->s && (v->kind == VAR_ELEMENT || (v->kind == VAR_LOCAL && v->outside && !v->is_constant));
}

static double any_value(Rng *r)
{
    static const double some[] = {0, 1, -1, 0.1, 0.2, 0.5, 2.5, 100, 255, 256, 65535, -128, 1e-3, 1e6, 4294967296.0, 9007199254740993.0, 1e19, -1e19, 1e300, 3e38,
                                  5e-324, -0.0, 1e39, -1e39};

    switch (rng_below(r, 4)) {
    case 0: return some[rng_below(r, sizeof some / sizeof *some)];
    case 1: return (double)rng_below(r, 2000) / 10 - 50;
    case 2: return (double)rng_below(r, 1000);
    default: {
        const uint64_t bits = rng_u64(r);
        double x;
        memcpy(&x, &bits, sizeof x);
        return x != x ? 1.0 / 0.3 : x;
    }
    }
}

static int compare_changes(const void *a, const void *b)
{
    const ScenarioChange *x = a, *y = b;

    return x->step != y->step ? (x->step < y->step ? -1 : 1) : x->var < y->var ? -1 : x->var > y->var;
}

// Repeats the changes of some steps, and removes what cannot be repeated.
static void add_loop(Arena *arena, const Program *p, Rng *r, Scenario *s)
{
    ScenarioChange *change = (ScenarioChange *)s->change;
    ScenarioLoop *loop = arena_array(arena, 1, sizeof *loop);
    size_t n = 0;

    loop->from = s->changes ? change[rng_below(r, (uint32_t)s->changes)].step : 1;
    loop->period = 1 + rng_below(r, 10);
    loop->to = loop->from + loop->period + 1 + rng_below(r, 40);
    for (size_t i = 0; i < s->changes; i++) {
        const bool is_in = change[i].step >= loop->from && change[i].step < loop->from + loop->period;
        if (is_in)
            change[i].kind = SCENARIO_HOLD;
        if (is_in ? !p->var.at[change[i].var]->written && !p->var.at[change[i].var]->parameter : change[i].step < loop->from || change[i].step >= loop->to)
            change[n++] = change[i];
    }
    s->changes = n;
    s->loop = loop;
    s->loops = 1;
}

static Scenario any_scenario(Arena *arena, const Program *p, Rng *r)
{
    static const uint64_t deltas[] = {1, 3, 10, 20, 1000, 250000};
    ScenarioChange *change = arena_array(arena, CHANGES_MOST, sizeof *change);
    Scenario s = {.init_state = p->state.at[rng_below(r, p->state.n)], .delta_t = p->step ? p->step : deltas[rng_below(r, 6)],
                  .steps = 1 + rng_below(r, STEPS_MOST), .change = change};
    uint32_t n = rng_below(r, CHANGES_MOST), k = 0;

    while (n--) {
        const uint32_t var = rng_below(r, p->var.n);
        if (can_be_set(p, p->var.at[var]))
            change[k++] = (ScenarioChange){1 + (rng_percent(r, 30) ? 0 : rng_below(r, (uint32_t)s.steps)), var, (ScenarioKind)rng_below(r, 4), any_value(r), any_value(r), rng_below(r, p->var.n)};
    }
    qsort(change, k, sizeof *change, compare_changes);
    for (uint32_t i = 0; i < k; i++) {
        const Var *source = p->var.at[change[i].source];
        if (i > 0 && change[i].step == change[i - 1].step && change[i].var == change[i - 1].var)
            continue;
        if (change[i].kind == SCENARIO_COPY && (source == p->g || source == p->s || source == p->t))
            change[i].kind = SCENARIO_HOLD;
        change[s.changes++] = change[i];
    }
    if (rng_percent(r, 40))
        add_loop(arena, p, r, &s);
    return s;
}

// ---- comparison ----

typedef struct Compared {
    Arena *arena;
    const Program *p;
    uint64_t *cell[STEPS_MOST];       // by step from 0, of scenario_run
    uint64_t steps;                   // of the script
    const char *wrong;
} Compared;

static void store_step(void *context, uint64_t step, const EngineStep *result)
{
    Compared *c = context;

    c->cell[step - 1] = arena_copy(c->arena, result->cell, c->p->var.n * sizeof *result->cell);
}

static void compare_step(void *context, const ScriptStep *step)
{
    Compared *c = context;

    c->steps++;
    for (uint32_t i = 0; i < c->p->var.n && !c->wrong && step->number <= STEPS_MOST && c->cell[step->number - 1]; i++)
        if (step->cell[i] != c->cell[step->number - 1][i])
            c->wrong = format_in(c->arena, "step %" PRIu64 ": %s is %" PRIx64 ", but %" PRIx64 " in the scenario", step->number, c->p->var.at[i]->name->text,
                                 step->cell[i], c->cell[step->number - 1][i]);
}

static const char *messages(const Session *s, Arena *arena)
{
    const DiagStyle style = {false, 3};
    Buf why;

    buf_init(&why, arena);
    diags_render_text(&s->diags, &style, &why);
    return buf_text(&why);
}

static void count(Arena *arena, const Program *p, const Scenario *s)
{
    met.scripts++;
    met.loops += s->loops;
    met.rounds += scenario_unroll(arena, s).changes - s->changes;
    for (size_t i = 0; i < s->changes; i++) {
        met.kind[s->change[i].kind]++;
        met.type[p->var.at[s->change[i].var]->type]++;
        met.written += p->var.at[s->change[i].var]->written;
    }
}

static const char *test_scenario(Subject *subject, const Scenario *s, Arena *arena, const char **text)
{
    const Program *p = subject->program;
    const char *comment[] = {"A random scenario."};
    Engine *ref = engine_ref_open(arena, p);
    const ScriptPage page = {.p = p, .scenario = s, .engine = ref, .comment = comment, .comments = 1};
    Compared c = {.arena = arena, .p = p};
    ScriptOptions options = {.max_steps = 1000, .after_step = compare_step, .context = &c};
    ScriptResult r;
    const Script *script;
    Buf out;

    buf_init(&out, arena);
    if (!script_write(arena, &page, &out)) {
        met.circles++;
        return NULL;
    }
    *text = buf_text(&out);
    script = session_script(&subject->session, source_new(&subject->session.arena, "random.ss", buf_text(&out), out.n), p);
    if (!script)
        return messages(&subject->session, arena);
    scenario_run(arena, p, s, ref, store_step, &c);
    r = script_run(arena, &subject->session.diags, script, &ref, 1, &options);
    count(arena, p, s);
    met.asserts += r.asserts_passed;
    if (c.wrong)
        return c.wrong;
    if (r.outcome != SCRIPT_PASSED)
        return messages(&subject->session, arena);
    return c.steps == s->steps ? NULL : format_in(arena, "%" PRIu64 " steps, but %" PRIu64 " in the scenario", c.steps, s->steps);
}

static const char *test_program(uint64_t seed, Arena *arena, Subject *s, const char **text)
{
    Gen *g = gen_program(arena, seed, STEPS_MOST);
    Rng r = {rng_mix(seed, 5)};
    const char *error = subject_compile(s, g, arena);

    *text = "";
    for (int i = 0; i < 5 && !error; i++) {
        const Scenario scenario = any_scenario(arena, s->program, &r);
        error = test_scenario(s, &scenario, arena, text);
    }
    return error;
}

static bool was_thorough(uint64_t programs)
{
    bool good = met.scripts >= 4 * programs && met.circles * 20 < met.scripts && met.asserts > 10 * met.scripts && met.written > programs / 2 &&
                met.loops > programs / 2 && met.rounds > programs / 2;

    for (int kind = 0; kind <= SCENARIO_COPY; kind++)
        good = good && met.kind[kind] > programs;
    for (int type = 0; type < SM_TYPE_COUNT; type++)
        good = good && met.type[type] >= programs / 10;
    if (!good)
        printf("not thorough: %" PRIu64 " scripts, %" PRIu64 " circles, %" PRIu64 " asserts, %" PRIu64 " stored inputs, %" PRIu64 " loops, %" PRIu64 " changes made again\n", met.scripts,
               met.circles, met.asserts, met.written, met.loops, met.rounds);
    return good;
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1, programs = argc > 2 ? strtoull(argv[2], NULL, 10) : 200;
    uint64_t passed = 0, failed = 0;

    for (uint64_t i = seed; i < seed + programs; i++) {
        Arena arena;
        Subject s;
        const char *wrong, *text;

        diff_arena_init(&arena);
        wrong = test_program(i, &arena, &s, &text);
        passed += !wrong;
        failed += wrong != NULL;
        if (wrong || argc > 3)
            printf("seed %" PRIu64 ": %s\n%s", i, wrong ? wrong : "passed", text);
        subject_free(&s);
        arena_free(&arena);
    }
    failed += !was_thorough(programs);
    printf("scripts of scenarios: %" PRIu64 " passed, %" PRIu64 " failed\n", passed, failed);
    return failed > 0;
}
