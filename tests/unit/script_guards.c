// SPDX-License-Identifier: Apache-2.0
// Random scripts with guards by time, inner conditionals, `else` and `state NAME`, each compared with an equivalent script without them (clause
// 8.39 to 8.47).  Every value after every step, the result, and the number of passed asserts must be equal.
//
// In the equivalent script, each conditional has a variable that is true if the conditional is taken in this step:
//     at 30 { x = 1 }            true: c1 = G == 30
//     else: x = 2                c1: x = 1
//                                not c1: x = 2
#include <string.h>

#include "compiler/script/engine_ref.h"
#include "compiler/script/script.h"
#include "compiler/session.h"
#include "tests/test.h"
#include "tests/unit/host.h"
#include "tests/unit/random.h"

enum { SCRIPTS = 300, STEPS = 60, DELTA = 10, DEEPEST = 4, MOST = 60 };

static const char machine[] =
    "[state_vector]\nU64 G\nU32 S\nF64 x\nF64 y\nF64 z\n"
    "[Fill]\n.step\nx = x + 1\nT > 100: -> Burn\n[Burn]\n.step\ny = y - x / 4\nT > 50 and y < 0: -> Fill\n";

typedef struct Writer {
    Buf *short_form, *by_hand;
    unsigned conditionals;
    unsigned used[6];         // how often each kind of guard was written
} Writer;

static uint32_t pick(uint32_t n) { return (uint32_t)(random_u64() >> 32) % n; }

static unsigned pick_time(void) { return pick(STEPS) * DELTA; }

// Writes a guard, and the same one as an expression without guards by time.
static void write_guard(Writer *w, Buf *hand)
{
    static const char *const condition[] = {"x > 5", "x < y", "z == 3", "T < 40", "not (y > 2)"};
    static const char *const state[] = {"Fill", "Burn"};
    const unsigned kind = pick(6), a = pick_time(), b = a + 1 + pick(200), period = (1 + pick(12)) * DELTA;
    const char *const c = condition[pick(5)], *const in = state[pick(2)];

    w->used[kind]++;
    switch (kind) {
    case 0: buf_printf(w->short_form, "at %u", a), buf_printf(hand, "G == %u", a); break;
    case 1: buf_printf(w->short_form, "from %u ms to %u.0", a, b), buf_printf(hand, "G >= %u and G < %u", a, b); break;
    case 2: buf_printf(w->short_form, "after %u", a), buf_printf(hand, "G >= %u", a); break;
    case 3: buf_printf(w->short_form, "every %u", period), buf_printf(hand, "G - %u * floor(G / %u) == 0", period, period); break;
    case 4: buf_printf(w->short_form, "state %s and %s", in, c), buf_printf(hand, "S == %s and %s", in, c); break;
    default: buf_str(w->short_form, c), buf_str(hand, c); break;
    }
}

// Writes a statement that runs if `path` is true.  `path` replaces the conditionals around the statement.
static void write_statement(Writer *w, const char *path)
{
    static const char *const target[] = {"x", "y", "z"};
    static const char *const value[] = {"x + 1", "y - 2", "z * 0.5 + 3", "G / 10", "7 - x", "7"};
    Buf text;

    buf_init(&text, w->by_hand->arena);
    if (pick(4) == 0)
        buf_printf(&text, "@assert %s < 1e6 or y == y", target[pick(3)]);
    else
        buf_printf(&text, "%s = %s", target[pick(3)], value[pick(6)]);
    buf_printf(w->short_form, "%s\n", buf_text(&text));
    buf_printf(w->by_hand, "%s: %s\n", path, buf_text(&text));
}

static void write_conditional(Writer *w, const char *path, unsigned depth);

static void write_body(Writer *w, const char *path, unsigned depth)
{
    buf_str(w->short_form, " {\n");
    for (uint32_t n = 1 + pick(3); n > 0; n--)
        if (depth < DEEPEST && w->conditionals < MOST && pick(3) == 0)
            write_conditional(w, path, depth + 1);
        else
            write_statement(w, path);
    buf_str(w->short_form, "}\n");
}

static void write_conditional(Writer *w, const char *path, unsigned depth)
{
    const unsigned n = ++w->conditionals;
    Buf guard;

    buf_init(&guard, w->by_hand->arena);
    write_guard(w, &guard);
    buf_printf(w->by_hand, "%s: c%u = %s\n", path, n, buf_text(&guard));
    write_body(w, format_in(w->by_hand->arena, "%s and c%u", path, n), depth);
    if (pick(2))
        return;
    buf_str(w->short_form, "else");
    path = format_in(w->by_hand->arena, "%s and not c%u", path, n);
    if (w->conditionals < MOST && pick(2)) {
        buf_str(w->short_form, " if ");
        write_conditional(w, path, depth);
    } else {
        write_body(w, path, depth);
    }
}

// ---- runs ----

static void add_to_hash(void *context, const ScriptStep *step)
{
    uint64_t *hash = context;

    for (int i = 0; i < 6; i++)           // the elements and T
        *hash = (*hash ^ step->cell[i]) * UINT64_C(1099511628211) + step->state->number;
}

static ScriptResult run_text(Session *s, const Program *p, const Buf *text, uint64_t *hash)
{
    const Script *ss = session_script(s, source_new(&s->arena, "m.ss", buf_text(text), text->n), p);
    const ScriptOptions o = {.max_steps = STEPS + 1, .after_step = add_to_hash, .context = hash};
    Engine *engine = engine_ref_open(&s->arena, p);
    ScriptResult none = {.outcome = SCRIPT_BROKEN};

    CHECK(ss != NULL);
    return ss ? script_run(&s->arena, &s->diags, ss, &engine, 1, &o) : none;
}

static void compare_random_script(unsigned used[6])
{
    static const char head[] = "[options]\ndelta_t 10\n";
    Session s;
    Buf a, body, b;
    Writer w = {&a, &body, 0, {0}};
    MachineInput in = {0};
    ScriptResult ra, rb;
    uint64_t ha = 1, hb = 1;
    const Program *p;

    session_init(&s, heap_alloc, NULL, &host_oom);
    in.sm = source_new(&s.arena, "m.sm", machine, strlen(machine));
    p = session_program(&s, &in);
    buf_init(&a, &s.arena);
    buf_init(&body, &s.arena);
    buf_init(&b, &s.arena);
    buf_printf(&a, "%s[all_states]\n", head);
    buf_str(&body, "[all_states]\n");
    for (int i = 0; i < 3; i++)
        write_conditional(&w, "true", 0);
    buf_str(&a, "[Burn]\n");
    buf_str(&body, "[Burn]\n");
    write_conditional(&w, "true", 0);
    buf_printf(&a, "[all_states]\nat %u: @stop\n", (STEPS - 1) * DELTA);
    buf_printf(&body, "[all_states]\nG == %u: @stop\n", (STEPS - 1) * DELTA);
    buf_printf(&b, "%s[local]\n", head);
    for (unsigned i = 1; i <= w.conditionals; i++)
        buf_printf(&b, "bool c%u = false\n", i);
    buf_put(&b, buf_text(&body), body.n);
    ra = run_text(&s, p, &a, &ha);
    rb = run_text(&s, p, &b, &hb);
    CHECK(ra.outcome == rb.outcome && ra.steps == rb.steps && ra.asserts_passed == rb.asserts_passed && ha == hb);
    for (int i = 0; i < 6; i++)
        used[i] += w.used[i];
    session_free(&s);
}

int main(void)
{
    unsigned used[6] = {0};

    host_check(setjmp(host_oom));
    for (int i = 0; i < SCRIPTS; i++)
        compare_random_script(used);
    for (int i = 0; i < 6; i++)
        CHECK(used[i] > SCRIPTS);
    return test_end("script_guards");
}
