// SPDX-License-Identifier: Apache-2.0
// Checks what smc cover calls impossible, by a method of its own: small random machines, all of whose situations are enumerated breadth first.
// Each situation is reached by replaying its inputs, on the reference's arithmetic (tests/diff/cover_model.c) and on the flat machine in lock
// step.  Inputs have one value on each side of each number in the machine, so no other value leads elsewhere.
//     exhaustive SEED COUNT [--print]
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/search/search.h"
#include "tests/diff/cover_model.h"
#include "tests/diff/subject.h"
#include "tests/heap.h"

// Every second machine has windows of at most WINDOW_MOST samples.  Then a situation also has the inputs of the steps before, and n is at most 2.
enum { SITUATIONS_MOST = 400, COMBINATIONS = 12, COMBINATIONS_OF_WINDOWS = 6, CELLS_MOST = 8, T_MOST = 50, WINDOW_MOST = 3 };

static struct { uint64_t machines, plain, whole, situations, places, impossible, timed, unreached, reached, missed; } met;

// ---- machines ----

// Whether the machine has windows, and counts without a limit; its step in ms, and how many units of time are 1 ms.
typedef struct Kind { bool windows, counts; unsigned step, ms; } Kind;
static Kind kind;

static const char *any_window(Arena *arena, Rng *r)
{
    static const char *const of_number[] = {"roll_min(n, 2) >= %u", "roll_max(n, 2) < %u", "roll_avg(n, 2) > %u", "roll_median(n, 3) == %u", "prev(n) > %u"};
    static const char *const of_condition[] = {"held(b, 20 ms)", "held(not b, 2 steps)", "roll_min(b, 3)", "roll_max(b, 3)", "roll_avg(b, 3) > 0.5", "roll_avg(b, 2) == 1",
                                               "held(n > %u, 10 ms)", "held(n <= %u, 3 steps)", "rising(b)", "falling(n >= %u)", "roll_min(n > %u, 2)", "roll_max(n == %u, 2)"};
    const bool number = rng_percent(r, 40);
    const unsigned which = rng_below(r, number ? sizeof of_number / sizeof *of_number : sizeof of_condition / sizeof *of_condition);

    return format_in(arena, number ? of_number[which] : of_condition[which], (unsigned)rng_below(r, 3));
}

static const char *any_atom(Arena *arena, Rng *r)
{
    static const char *const op[] = {"<", "<=", ">", ">=", "==", "!="};

    if (kind.windows && rng_percent(r, 50))
        return any_window(arena, r);
    switch (rng_below(r, 4)) {
    case 0:  return rng_percent(r, 50) ? "b" : "not b";
    case 1:  return format_in(arena, "n %s %u", op[rng_below(r, 6)], (unsigned)rng_below(r, 3));
    case 2:  return format_in(arena, "k %s %u", op[rng_below(r, 6)], (unsigned)rng_below(r, 5));
    default: return format_in(arena, "T %s %u ms", op[rng_below(r, 6)], (unsigned)rng_below(r, 5) * 10);
    }
}

// A window's argument beside the window: what one says about the other is what proofs are about.
static const char *any_relation(Arena *arena, Rng *r)
{
    static const char *const form[] = {"(%s) and %s", "(%s) and not (%s)", "not (%s) and %s", "(%s) or %s", "(%s) or not (%s)"};
    const char *const window = any_window(arena, r);
    const bool of_b = strstr(window, "b,") || strstr(window, "b)");

    return format_in(arena, form[rng_below(r, 5)], window, of_b ? "b" : format_in(arena, "n > %u", (unsigned)rng_below(r, 3)));
}

static const char *any_condition(Arena *arena, Rng *r, int depth)
{
    static const char *const counted[] = {"k >= %u and T > %u ms", "k > %u and T >= %u ms", "k >= %u or T < %u ms", "not (k < %u) and T > %u ms"};

    if (kind.windows && rng_percent(r, 40))
        return any_relation(arena, r);
    if (kind.counts && rng_percent(r, 50))
        return format_in(arena, counted[rng_below(r, 4)], (unsigned)rng_below(r, 5), (unsigned)rng_below(r, 4) * 10);
    if (depth == 0 || rng_percent(r, 40))
        return any_atom(arena, r);
    return format_in(arena, rng_percent(r, 80) ? "(%s) %s (%s)" : "not ((%s) %s (%s))", any_condition(arena, r, depth - 1), rng_percent(r, 50) ? "and" : "or",
                     any_condition(arena, r, depth - 1));
}

static void print_statement(Arena *arena, Rng *r, uint32_t states, int depth, Buf *out)
{
    if (kind.counts && rng_percent(r, 30)) {
        buf_str(out, "    k = k + 1\n");
        return;
    }
    switch (rng_below(r, 6)) {
    case 0:  buf_str(out, "    k < 3: k = k + 1\n"); return;
    case 1:  buf_str(out, rng_percent(r, 50) ? "    k = n\n" : "    k = 0\n"); return;
    case 2:  buf_printf(out, "    out = %s\n", any_condition(arena, r, 1)); return;
    case 3:
        if (depth > 0) {
            buf_printf(out, "    %s {\n", any_condition(arena, r, 1));
            print_statement(arena, r, states, depth - 1, out);
            buf_str(out, "    }\n");
            return;
        }
        break;
    default: break;
    }
    buf_printf(out, "    %s: -> S%u\n", any_condition(arena, r, 2), (unsigned)rng_below(r, states) + 1);
}

// Chooses the step and the unit of time, with random numbers of their own.  Limits of time are multiples of 10 ms, and those of windows whole steps.
static void choose_time(Rng r)
{
    static const unsigned step[] = {10, 10, 10, 7, 25, 40};

    kind.step = kind.windows ? 10 : step[rng_below(&r, sizeof step / sizeof *step)];
    kind.ms = rng_percent(&r, 25) ? 1000 : 1;
}

static const Source *any_machine(Session *s, Rng *r, Rng time, Buf *out)
{
    const uint32_t states = 2 + rng_below(r, 3);

    kind.windows = rng_percent(r, 50);
    kind.counts = rng_percent(r, 30);
    choose_time(time);
    buf_printf(out, "[options]\ntime_unit %s\nstep %u ms\n", kind.ms == 1 ? "ms" : "us", kind.step);
    buf_str(out, "[state_vector]\nU64 G\nU32 S\nbool b @read_only\nU8 n @read_only\nbool out\n");
    buf_str(out, rng_percent(r, 50) ? "U8 k\n" : "[local]\nU8 k = 0\n");
    for (uint32_t i = 1; i <= states; i++) {
        buf_printf(out, "[S%u]\n", (unsigned)i);
        if (i == 1 || rng_percent(r, 40))
            buf_str(out, ".entry\n    k = 0\n");
        buf_str(out, ".step\n");
        for (uint32_t n = 1 + rng_below(r, 3); n > 0; n--)
            print_statement(&s->arena, r, states, 1, out);
    }
    return source_new(&s->arena, "small.sm", buf_text(out), out->n);
}

// ---- enumeration ----

typedef struct Situation {
    uint32_t before, input;           // the situation from which a step with these inputs leads here
    uint32_t depth;                   // steps from the start
    uint32_t start;                   // State.number of the start
    uint64_t cell[CELLS_MOST];        // without G and inputs
    uint64_t history;                 // of a machine with windows: the inputs of the last steps, as many as have run
    uint32_t next;
    bool first;
} Situation;

typedef struct Enumeration {
    Arena *arena;
    const Program *p;
    Engine *engine[2];                // the model, the flat machine
    EngineStep answer[2];
    uint32_t b, n;                    // Var.index of the inputs
    Situation *at;
    uint32_t count;
} Enumeration;

static void step_both(Enumeration *e, uint32_t step, uint32_t input)
{
    const EngineWrite write[] = {{e->p->g->index, step * e->p->step}, {e->b, input & 1}, {e->n, input >> 1}};

    for (int i = 0; i < 2; i++)
        if (e->engine[i]->step(e->engine[i], write, 3, &e->answer[i]) != ENGINE_OK)
            abort();
}

static void start_both(Enumeration *e, uint32_t state)
{
    for (int i = 0; i < 2; i++)
        e->engine[i]->init(e->engine[i], state, &e->answer[i]);
}

// Runs the inputs that lead to a situation.
static void replay(Enumeration *e, const Situation *s)
{
    uint32_t input[SITUATIONS_MOST], depth = s->depth;

    for (const Situation *at = s; at->depth > 0; at = &e->at[at->before])
        input[at->depth - 1] = at->input;
    start_both(e, s->start);
    for (uint32_t i = 0; i < depth; i++)
        step_both(e, i, input[i]);
}

static void fill(const Enumeration *e, Situation *s)
{
    const EngineStep *a = &e->answer[0];

    s->next = a->next_state;
    s->first = a->next_is_first;
    for (uint32_t i = 0; i < e->p->var.n; i++) {
        const Var *v = e->p->var.at[i];
        const bool counts = v != e->p->g && v != e->p->s && i != e->b && i != e->n && !(v == e->p->t && s->first);
        s->cell[i] = !counts ? 0 : v == e->p->t && a->cell[i] > T_MOST * kind.ms ? T_MOST * kind.ms : a->cell[i];
    }
}

static bool add(Enumeration *e, const Situation *s)
{
    for (uint32_t i = 0; i < e->count; i++)
        if (e->at[i].next == s->next && e->at[i].first == s->first && e->at[i].history == s->history && memcmp(e->at[i].cell, s->cell, sizeof s->cell) == 0)
            return true;
    if (e->count == SITUATIONS_MOST)
        return false;
    e->at[e->count++] = *s;
    return true;
}

// Enumerates what starts in the first `starts` states.  Returns whether all situations have been enumerated.
static bool enumerate(Enumeration *e, uint32_t starts)
{
    bool is_whole = true;

    e->count = 0;
    for (uint32_t state = 1; state <= starts; state++) {
        Situation s = {.start = state};
        start_both(e, state);
        fill(e, &s);
        add(e, &s);
    }
    for (uint32_t i = 0; i < e->count; i++)
        for (uint32_t input = 0; input < (kind.windows ? COMBINATIONS_OF_WINDOWS : COMBINATIONS); input++) {
            Situation s = {.before = i, .input = input, .depth = e->at[i].depth + 1, .start = e->at[i].start};
            replay(e, &e->at[i]);
            step_both(e, e->at[i].depth, input);
            fill(e, &s);
            if (kind.windows)
                s.history = (e->at[i].history << 8 | (input + 1)) & ((UINT64_C(1) << 8 * (WINDOW_MOST - 1)) - 1);
            is_whole = add(e, &s) && is_whole;
        }
    return is_whole;
}

// ---- comparison ----

static const char *place_text(Arena *arena, const Cover *c, uint32_t i)
{
    return format_in(arena, "%s at byte %lu (%d)", cover_kind_name[c->place.at[i].kind], (unsigned long)c->place.at[i].span.at, c->place.at[i].value);
}

static const char *compare(Arena *arena, const Cover *run, const SearchResult *found, bool is_whole)
{
    if (found->refuted)
        return format_in(arena, "%u goals that are proved impossible are reached by the search", (unsigned)found->refuted);
    for (uint32_t i = 1; i < run->place.n; i++) {
        met.places++;
        met.impossible += found->find[i].outcome == SEARCH_IMPOSSIBLE;
        met.timed += found->find[i].outcome == SEARCH_IMPOSSIBLE && strstr(found->find[i].reason, "delta_t");
        met.reached += found->find[i].outcome == SEARCH_REACHED;
        met.unreached += is_whole && run->hits[i] == 0 && found->find[i].outcome == SEARCH_NOT_FOUND;
        met.missed += run->hits[i] > 0 && found->find[i].outcome == SEARCH_NOT_FOUND;
        if (found->find[i].outcome == SEARCH_IMPOSSIBLE && run->hits[i] > 0)
            return format_in(arena, "%s is impossible (%s), but a run covers it", place_text(arena, run, i), found->find[i].reason);
        if (is_whole && found->find[i].outcome == SEARCH_REACHED && run->hits[i] == 0)
            return format_in(arena, "%s is reached by the search, but by no situation", place_text(arena, run, i));
    }
    return NULL;
}

static const char *test_machine(uint64_t seed, Arena *arena, Session *s, const char **text)
{
    Rng r = {rng_mix(seed, 3)};
    Buf out;
    MachineInput in = {0};
    Enumeration e = {.arena = arena};
    Cover *fresh, *run;
    const char *wrong;
    bool is_whole;

    buf_init(&out, arena);
    in.sm = any_machine(s, &r, (Rng){rng_mix(seed, 4)}, &out);
    *text = buf_text(&out);
    if ((e.p = session_program(s, &in)) == NULL)
        return "does not compile";
    fresh = cover_new(arena, e.p);
    run = cover_new(arena, e.p);
    cover_settle(fresh);
    e.engine[0] = cover_model_open(arena, e.p, run);
    e.engine[1] = cover_open_engine(run);
    for (int i = 0; i < 2; i++)
        engine_step_init(&e.answer[i], arena, e.p);
    e.b = ((const Var *)map_find(&e.p->by_name, str_c(&s->strings, "b")))->index;
    e.n = ((const Var *)map_find(&e.p->by_name, str_c(&s->strings, "n")))->index;
    e.at = arena_array(arena, SITUATIONS_MOST, sizeof *e.at);
    is_whole = enumerate(&e, 1) && !kind.windows;   // a search starts in the first state; other values have other averages
    cover_settle(run);
    met.machines++;
    met.plain += !kind.windows && !kind.counts;
    met.whole += is_whole && !kind.counts;
    met.situations += e.count;
    if ((wrong = cover_model_compare(e.engine[0], run, arena)) != NULL)
        return wrong;
    wrong = compare(arena, run, search_run(arena, fresh, &(SearchOptions){.seed = seed, .effort = 200000}), is_whole);
    enumerate(&e, e.p->state.n);                    // facts know of no start
    for (uint32_t i = 1; i < run->place.n && !wrong; i++)
        if (fresh->place.at[i].impossible && run->hits[i] > 0)
            wrong = format_in(arena, "%s is impossible (%s), but a run covers it", place_text(arena, run, i), fresh->place.at[i].impossible);
    return wrong;
}

static bool was_thorough(uint64_t count)
{
    const bool good = met.whole * 10 >= met.plain * 8 && met.plain * 4 > count && met.situations > 10 * count && met.impossible > count / 4 && met.timed > count / 20 && met.reached > count;

    printf("%" PRIu64 " machines, %" PRIu64 " without windows and counts, of which %" PRIu64 " enumerated; %" PRIu64 " situations; of %" PRIu64 " places %" PRIu64 " impossible, %" PRIu64
           " of them because of delta_t, %" PRIu64 " neither reached nor proved, %" PRIu64 " missed by the search\n", met.machines, met.plain, met.whole, met.situations, met.places, met.impossible, met.timed, met.unreached,
           met.missed);
    return good;
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1, count = argc > 2 ? strtoull(argv[2], NULL, 10) : 200;
    static jmp_buf oom;
    static uint64_t passed, failed;

    if (setjmp(oom))
        return 3;
    for (uint64_t i = seed; i < seed + count; i++) {
        Arena arena;
        Session s;
        const char *wrong, *text = "";

        diff_arena_init(&arena);
        session_init(&s, heap_alloc, NULL, &oom);
        wrong = test_machine(i, &arena, &s, &text);
        passed += !wrong;
        failed += wrong != NULL;
        if (wrong || argc > 3)
            printf("seed %" PRIu64 ": %s\n%s", i, wrong ? wrong : "passed", text);
        session_free(&s);
        arena_free(&arena);
    }
    failed += !was_thorough(count);
    printf("impossible goals: %" PRIu64 " passed, %" PRIu64 " failed\n", passed, failed);
    return failed > 0;
}
