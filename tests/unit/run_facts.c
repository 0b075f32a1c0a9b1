// SPDX-License-Identifier: Apache-2.0
// How long a state lasts at most (run_facts_time): bounds that are known, for several delta_t, and random runs, which stay within each bound and attain
// most of them.
#include <stdlib.h>
#include <string.h>

#include "compiler/cover/run_facts.h"
#include "compiler/session.h"
#include "tests/test.h"
#include "tests/unit/host.h"

#define NONE 18446744073709551616.0     // nothing is known: T is any U64
#define P53 (UINT64_C(1) << 53)

typedef struct Case {
    const char *step;         // the statements of .step in state A, which every run begins in; a transition leads to A or B
    const char *unit;         // time_unit of the machine
    uint64_t delta_t;
    double most;              // what is known about T in A
    bool is_attained;         // random runs attain it
} Case;

static const Case row[] = {
    {"T > 30: -> B", "ms", 10, 40, true},
    {"T >= 30: -> B", "ms", 10, 30, true},
    {"T > 30: -> B", "ms", 7, 35, true},
    {"T >= 28: -> B", "ms", 7, 28, true},
    {"T > 25.5: -> B", "ms", 10, 30, true},
    {"T > 30: -> B", "ms", 100, 100, true},
    {"T >= 30: -> B", "ms", 30, 30, true},
    {"T > 30: -> B", "ms", 30, 60, true},
    {"T > 30: -> B", "ms", 1, 31, true},
    {"-> B", "ms", 10, 0, true},                                            // no step ends without a transition
    {"T > 30: -> A", "ms", 10, 40, true},                                   // T is 0 again
    {"go: -> A\n    T > 30: -> B", "ms", 10, 40, true},
    {"go and T > 90: -> B\n    not go and T > 30: -> B", "ms", 10, NONE, false},    // that one of them is true is no fact about T
    {"go {\n        T > 90: -> B\n    } else {\n        T > 30: -> B\n    }", "ms", 10, 100, true},
    {"go {\n        T > 30: -> B\n    } else {\n        T > 90: -> B\n    }", "ms", 10, 100, true},
    {"T > 90: -> B\n    T > 30: -> B", "ms", 10, 40, true},
    {"T > 30 and go: -> B", "ms", 10, NONE, false},
    {"T > 30 or go: -> B", "ms", 10, 40, true},
    {"T > n: -> B", "ms", 10, 260, false},
    {"T < 30: -> B", "ms", 10, NONE, false},
    {"T != 20: k = 1\n    T == 20: -> B", "ms", 10, NONE, false},
    {"T > 30: k = 1", "ms", 10, NONE, false},
    {"k = min(k + 1, 100)\n    k > 3: -> B", "ms", 10, NONE, false},
    {"T > 30 ms: -> B", "us", 10000, 40000, true},
    {"T > 1500 us: -> B", "us", 1000, 2000, true},
    {"T > 2 min: -> B", "s", 1, 121, true},
    {"T > 30: -> B", "ms", P53 - 40, 9007199254740952.0, false},            // the sum is exact below 2^53
    {"T > 30: -> B", "ms", P53, NONE, false},
    {"T > 30: -> B", "ms", UINT64_C(1) << 62, NONE, false},
    {"T > 4503599627370496: -> B", "ms", P53 / 2, NONE, false},
    {"T >= 4503599627370496: -> B", "ms", P53 / 2, 4503599627370496.0, false},
    {"T > 18446744073709549568: -> B", "ms", 10, NONE, false},
};

static IrMachine *load(Session *s, const char *text, const Program **p)
{
    MachineInput in = {NULL, NULL, NULL, NULL};

    session_init(s, heap_alloc, NULL, &host_oom);
    in.sm = source_new(&s->arena, "row", text, strlen(text));
    *p = session_program(s, &in);
    return *p ? ir_build(&s->arena, *p) : NULL;
}

// Returns the largest T of a step in state 1.
static double most_in_random_runs(Session *s, const IrMachine *m, const bool *is_input, uint64_t delta_t)
{
    FlatMachine *f = flat_new(&s->arena, m, NULL);
    char *run = arena_alloc(&s->arena, f->size);
    uint32_t random = 1;
    uint64_t most = 0;

    flat_start(f, run, 1);
    for (uint64_t step = 0; step < 20000; step++) {
        uint64_t *cell = flat_cells(f, run);
        for (uint32_t v = 0; v < m->var.n; v++)
            if (is_input[v] && (random = random * 1664525 + 1013904223) >> 28 == 0)
                cell[v] = m->var.at[v].type == SM_BOOL ? random >> 27 & 1 : random >> 20 & 255;
        cell[m->g] = step * delta_t;
        flat_step(f, run);
        cell = flat_cells(f, run);
        if (cell[m->s] == 1 && cell[m->t] > most)
            most = cell[m->t];
    }
    return (double)most;
}

static bool *mark_inputs(Session *s, const Program *p, const IrMachine *m)
{
    bool *is_input = arena_alloc(&s->arena, m->var.n);

    for (uint32_t i = 0; i < p->var.n; i++)
        if (p->var.at[i]->kind == VAR_ELEMENT && p->var.at[i] != p->g && p->var.at[i] != p->s && p->var.at[i]->name->text[0] != 'k')
            is_input[m->var_of[i]] = m->var_of[i] != IR_NONE;
    return is_input;
}

static void check_row(const Case *c)
{
    char text[1000];
    Session s;
    Arena known;
    const Program *p;
    const IrMachine *m;
    RunFacts *r;
    bool *is_input;
    Fact time;

    host_check(setjmp(host_oom));
    snprintf(text, sizeof text, "[options]\ntime_unit %s\n[state_vector]\nU64 G\nU32 S\nbool go @read_only\nU8 n @read_only\nU8 k\n[A]\n.step\n    %s\n[B]\n.step\n    -> A\n",
             c->unit, c->step);
    m = load(&s, text, &p);
    test_count(m != NULL, text);
    if (!m)
        return;
    is_input = mark_inputs(&s, p, m);
    arena_init_within(&known, &s.arena);
    r = run_facts_new(&s.arena, &known, m, is_input, c->delta_t, (RunStart){1, false});
    time = run_facts_time(r, 1);
    test_count(time.lo == 0 && time.hi == c->most && time.whole, text);
    if (c->delta_t < P53 / 32768) {
        const double most = most_in_random_runs(&s, m, is_input, c->delta_t);
        test_count(most <= c->most && (most == c->most || !c->is_attained), text);
    }
    session_free(&s);
}

// A function with two ends, which no source has: the greater T counts, and it is that of the first end.
static void check_many_ends(void)
{
    static const char text[] =
        "machine \"ends\"\nvector \"ends\" size 16 hash 0x00000000\nelement U64 G at 0 is G\nelement U32 S at 8 is S\nelement bool go at 12\ntime U64 T\n\n"
        "state A\nstep {\nb0:\n    %0 = load U64 T\n    %1 = cvt F64 %0\n    %2 = load bool go\n    br %2, b1, b3\n"
        "b1:\n    %3 = const F64 90\n    %4 = gt F64 %1, %3\n    br %4, b5, b2\nb2:\n    ret\n"
        "b3:\n    %5 = const F64 30\n    %6 = gt F64 %1, %5\n    br %6, b5, b4\nb4:\n    ret\nb5:\n    goto A\n}\n";
    const char *error;
    Session s;
    Arena known;
    IrMachine *m;
    bool *is_input;

    host_check(setjmp(host_oom));
    session_init(&s, heap_alloc, NULL, &host_oom);
    m = ir_read(&s.arena, &s.strings, text, strlen(text), &error);
    test_count(m != NULL, error);
    if (!m)
        return;
    is_input = arena_alloc(&s.arena, m->var.n);
    for (uint32_t v = 0; v < m->var.n; v++)
        is_input[v] = m->var.at[v].type == SM_BOOL;
    arena_init_within(&known, &s.arena);
    CHECK(run_facts_time(run_facts_new(&s.arena, &known, m, is_input, 10, (RunStart){1, false}), 1).hi == 100);
    session_free(&s);
}

// Runs that begin in the second state never enter the first.
static void check_start(void)
{
    static const char text[] = "[state_vector]\nU64 G\nU32 S\n[A]\n.step\n    T > 30: -> A\n[B]\n.step\n    T > 50: -> B\n";
    const Program *p;
    Session s;
    Arena known;
    const IrMachine *m;
    RunFacts *r;

    host_check(setjmp(host_oom));
    m = load(&s, text, &p);
    arena_init_within(&known, &s.arena);
    r = run_facts_new(&s.arena, &known, m, mark_inputs(&s, p, m), 10, (RunStart){2, false});
    CHECK(run_facts_time(r, 1).hi == NONE && run_facts_time(r, 2).hi == 60);
    session_free(&s);
}

int main(void)
{
    check_start();
    check_many_ends();
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        check_row(&row[i]);
    return test_end("run_facts");
}
