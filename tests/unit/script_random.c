// SPDX-License-Identifier: Apache-2.0
// Random numbers of scripts, clause 8.48 to 8.53.  An implementation written from the clauses alone must return the same values: for calls in
// definitions and elsewhere, whether a step evaluates them or not.
#include <string.h>

#include "compiler/script/engine_ref.h"
#include "compiler/script/script.h"
#include "compiler/session.h"
#include "tests/test.h"
#include "tests/unit/host.h"

enum { STEPS = 200, CALLS = 6 };

static const char machine[] = "[state_vector]\nU64 G\nU32 S\nF64 a\nF64 b\nF64 c\nF64 d\nF64 e\nF64 f\n[A]\n.step\na = a\nb = b\nc = c\nd = d\ne = e\nf = f\n";

// Calls 1 and 2 are those of the definitions, in the order of the text.
static const char script[] =
    "[options]\ndelta_t 7\nseed 12345\n"
    "[all_states]\ntrue {\n  c = random(-3, 5)\n  a = noise(2)\n}\n"                       // 3, 4
    "[define]\nn = noise(0.5)\nr = random(10, 1e9) + n\n"                                  // 1, 2
    "[all_states]\n"
    "every 21 {\n  d = r\n  d = r\n}\n"
    "true: e = n\n"
    "G > 700 and random(0, 1) < 0.25: b = 1\n"                                              // 5
    "else: b = 0\n"
    "from 140 to 150: f = noise(1)\n"                                                       // 6
    "at 1393 {\n  @assert a == a and e == n\n  @stop\n}\n";

// ---- the clauses, with whole numbers modulo 2^64 in the simplest way ----

typedef struct Stream { uint64_t state, c; } Stream;

static Stream begin(uint64_t n, uint64_t seed)
{
    Stream s = {0, 2 * n + 1};

    s.state = (s.c + seed) * UINT64_C(6364136223846793005) + s.c;
    return s;
}

static uint64_t next(Stream *s)
{
    const uint64_t mixed = (((s->state / 262144) ^ s->state) / 134217728) % 4294967296u;
    uint64_t x = mixed;

    for (uint64_t i = 0; i < s->state / (UINT64_C(1) << 59); i++)
        x = x / 2 + (x % 2) * 2147483648u;
    s->state = s->state * UINT64_C(6364136223846793005) + s->c;
    return x;
}

typedef struct Expected { double uniform, noise; } Expected;       // uniform: from 0 to 1; noise: with sigma 1

static Expected expected[CALLS + 1][STEPS + 1];

static void fill_expected(uint64_t seed)
{
    for (uint64_t n = 1; n <= CALLS; n++) {
        Stream s = begin(n, seed);
        for (int k = 1; k <= STEPS; k++) {
            uint64_t sum = 0;
            for (int i = 0; i < 12; i++) {
                const uint64_t u = next(&s);
                sum += u;
                if (i == 0)
                    expected[n][k].uniform = (double)u / 4294967296.0;
            }
            expected[n][k].noise = (double)sum / 4294967296.0 - 6;
        }
    }
}

// ---- the run ----

static size_t compared, wrong;
static double last_d, last_f;

static double value_of(const Program *p, const ScriptStep *step, const char *name)
{
    double x = 0;

    for (size_t i = 0; i < p->var.n; i++)
        if (strcmp(p->var.at[i]->name->text, name) == 0)
            memcpy(&x, &step->cell[p->var.at[i]->index], sizeof x);
    return x;
}

static void expect_value(const Program *p, const ScriptStep *step, const char *name, double x)
{
    compared++;
    wrong += value_of(p, step, name) != x;
}

static void compare_step(void *context, const ScriptStep *step)
{
    const Program *p = context;
    const uint64_t k = step->number;
    double scaled;

    expect_value(p, step, "a", 2 * expected[4][k].noise);
    scaled = 8 * expected[3][k].uniform;
    expect_value(p, step, "c", -3 + scaled);
    expect_value(p, step, "e", 0.5 * expected[1][k].noise);
    expect_value(p, step, "b", step->g > 700 && expected[5][k].uniform < 0.25);
    if (step->g % 21 == 0) {
        scaled = (1e9 - 10) * expected[2][k].uniform;
        scaled = 10 + scaled;
        last_d = scaled + 0.5 * expected[1][k].noise;
    }
    if (step->g >= 140 && step->g < 150)
        last_f = expected[6][k].noise;
    expect_value(p, step, "d", last_d);
    expect_value(p, step, "f", last_f);
}

static void run_with(const uint64_t *seed, uint64_t shown)
{
    Session s;
    MachineInput in = {0};
    const Program *p;
    const Script *ss;
    Engine *engine;
    ScriptResult r;

    session_init(&s, heap_alloc, NULL, &host_oom);
    in.sm = source_new(&s.arena, "m.sm", machine, strlen(machine));
    p = session_program(&s, &in);
    ss = session_script(&s, source_new(&s.arena, "m.ss", script, strlen(script)), p);
    CHECK(ss && ss->random.n == CALLS);
    if (ss) {
        const ScriptOptions o = {.max_steps = 1000, .seed = seed, .after_step = compare_step, .context = (void *)(uintptr_t)p};
        last_d = last_f = 0;
        fill_expected(shown);
        engine = engine_ref_open(&s.arena, p);
        r = script_run(&s.arena, &s.diags, ss, &engine, 1, &o);
        CHECK(r.outcome == SCRIPT_PASSED && r.steps == STEPS && r.is_random && r.seed == shown);
    }
    session_free(&s);
}

// The numbers that the authors of PCG32 publish for the seed 42 and the stream 54.
static void check_published_numbers(void)
{
    Stream s = begin(54, 42);

    CHECK(next(&s) == 0xa15c02b7u);
    CHECK(next(&s) == 0x7b47f409u);
    CHECK(next(&s) == 0xba1d3330u);
}

int main(void)
{
    const uint64_t other = UINT64_C(1) << 53;

    host_check(setjmp(host_oom));
    check_published_numbers();
    run_with(NULL, 12345);
    run_with(&other, other);
    CHECK(compared == 2 * STEPS * 6 && wrong == 0);
    return test_end("script_random");
}
