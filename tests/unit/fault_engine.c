// SPDX-License-Identifier: Apache-2.0
// The readings of faulty sensors, value by value; what the script sees; copies of a run (arena_save, arena_restore).
#include "compiler/whatif/fault_engine.h"

#include <string.h>

#include "compiler/script/ref.h"
#include "tests/test.h"
#include "tests/unit/host.h"

enum { STEPS = 8, BEGIN = 4 };        // the fault begins in step 4

static Var time_var, x_var, b_var;
static Program program;
static Var *vars[3];

// A machine that has no code: it stores nothing, and its cells are what was written last.
static EngineStatus plain_init(Engine *e, uint32_t state, EngineStep *out)
{
    (void)e, (void)state;
    memset(out->cell, 0, 3 * sizeof *out->cell);
    return ENGINE_OK;
}

static EngineStatus plain_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    (void)e;
    for (uint32_t i = 0; i < n; i++)
        out->cell[write[i].var] = write[i].cell;
    return ENGINE_OK;
}

static void plain_close(Engine *e) { (void)e; }

static void make_program(SmType type)
{
    x_var = (Var){.kind = VAR_ELEMENT, .type = type, .index = 1};
    b_var = (Var){.kind = VAR_ELEMENT, .type = SM_BOOL, .index = 2};
    time_var = (Var){.kind = VAR_ELEMENT, .type = SM_U64};
    vars[0] = &time_var, vars[1] = &x_var, vars[2] = &b_var;
    memset(&program, 0, sizeof program);
    program.var.at = vars;
    program.var.n = 3;
    program.g = &time_var;
}

// Runs a fault of input `input` with the true values 10, 20, 30 ... of x and true, false, true ... of b.  Stores the readings, as numbers.
static void run_fault(Arena *a, SmType type, uint32_t input, FaultKind kind, double *reading)
{
    const FaultInput in[] = {{.var = &x_var, .has_range = true, .lo = -100, .hi = 100}, {.var = &b_var}};
    const FaultSizes sizes = {0.05, 0.02, 2, 3, 7};
    const Fault fault = {input, kind};
    Engine plain = {"plain", &program, NULL, NULL, plain_init, plain_step, plain_close, NULL};
    FaultEngine *e;
    EngineStep out;

    make_program(type);
    engine_step_init(&out, a, &program);
    e = fault_engine_open(a, &plain, in, 2, &sizes, 5);
    fault_engine(e)->init(fault_engine(e), 1, &out);
    for (uint32_t k = 1; k <= STEPS; k++) {
        const EngineWrite write[] = {{1, ref_convert(type, 10 * k)}, {2, k % 2}};
        const Var *v = input ? &b_var : &x_var;
        if (k == BEGIN)
            fault_engine_begin(e, &fault, 1);
        fault_engine(e)->step(fault_engine(e), write, 2, &out);
        reading[k - 1] = ref_read(v->type, out.cell[v->index]);
        CHECK(out.outside && out.outside[1] == write[0].cell && out.outside[2] == write[1].cell);
        CHECK(fault_engine_true_cell(e, 0) == write[0].cell);
        CHECK(k >= BEGIN || !fault_engine_differs(e));
    }
}

static bool reads(Arena *a, SmType type, uint32_t input, FaultKind kind, const double *expected)
{
    double reading[STEPS];

    run_fault(a, type, input, kind, reading);
    return memcmp(reading, expected, sizeof reading) == 0;
}

#define READS(type, input, kind, ...) CHECK(reads(a, type, input, kind, (const double[STEPS]){__VA_ARGS__}))

static void test_numbers(Arena *a)
{
    READS(SM_F64, 0, FAULT_STUCK,   10, 20, 30, 30, 30, 30, 30, 30);
    READS(SM_F64, 0, FAULT_DEAD,    10, 20, 30, 0, 0, 0, 0, 0);
    READS(SM_F32, 0, FAULT_NAN,     10, 20, 30, 0, 0, 0, 0, 0);
    READS(SM_F64, 0, FAULT_LOW,     10, 20, 30, -100, -100, -100, -100, -100);
    READS(SM_F64, 0, FAULT_HIGH,    10, 20, 30, 100, 100, 100, 100, 100);
    READS(SM_F64, 0, FAULT_BELOW,   10, 20, 30, 30, 40, 50, 60, 70);
    READS(SM_F64, 0, FAULT_ABOVE,   10, 20, 30, 50, 60, 70, 80, 90);
    READS(SM_F64, 0, FAULT_LATE,    10, 20, 30, 20, 30, 40, 50, 60);
    READS(SM_F64, 0, FAULT_DROPPED, 10, 20, 30, 30, 30, 30, 70, 80);
    READS(SM_U8,  0, FAULT_LOW,     10, 20, 30, 0, 0, 0, 0, 0);           // saturates, as an input of a script does
    READS(SM_I8,  0, FAULT_ABOVE,   10, 20, 30, 50, 60, 70, 80, 90);
}

static void test_bools(Arena *a)
{
    READS(SM_F64, 1, FAULT_STUCK,   1, 0, 1, 1, 1, 1, 1, 1);
    READS(SM_F64, 1, FAULT_DEAD,    1, 0, 1, 0, 0, 0, 0, 0);
    READS(SM_F64, 1, FAULT_HIGH,    1, 0, 1, 1, 1, 1, 1, 1);
    READS(SM_F64, 1, FAULT_LATE,    1, 0, 1, 0, 1, 0, 1, 0);
    READS(SM_F64, 1, FAULT_DROPPED, 1, 0, 1, 1, 1, 1, 1, 0);
    READS(SM_F64, 1, FAULT_FLIPPED, 1, 0, 1, 1, 0, 1, 0, 1);
}

// The noise of a fault is that of the call after those of the script, so that a script can have the same (language.md 8.50, 8.51).
static void test_noise(Arena *a)
{
    ScriptRandom call[6];
    ScriptRandoms calls = {call, 6, 6};
    double reading[STEPS];
    RefRandom r;

    for (int i = 0; i < 6; i++)
        call[i] = (ScriptRandom){.is_noise = true, .a = 4};               // 2 % of -100 to 100
    ref_random_init(&r, a, &calls, 7);
    run_fault(a, SM_F64, 0, FAULT_NOISY, reading);
    for (uint32_t k = 1; k <= STEPS; k++) {
        const double x = 10.0 * k;
        r.step = k;
        CHECK(reading[k - 1] == (k < BEGIN ? x : x + ref_random_value(&r, 5)));
    }
}

// A copy of an arena restores bytes at their addresses, also after the arena has grown.
static void test_copy(Arena *into)
{
    Arena a;
    ArenaCopy copy;
    char *p, *q;

    arena_init(&a, into->alloc, into->context, into->oom);
    p = arena_alloc(&a, 100);
    memset(p, 1, 100);
    arena_save(&a, into, &copy);
    for (int round = 0; round < 3; round++) {
        memset(p, 2, 100);
        for (int i = 0; i < 100; i++)
            memset(arena_alloc(&a, 5000), 3, 5000);
        arena_restore(&a, &copy);
        CHECK(p[0] == 1 && p[99] == 1);
        q = arena_alloc(&a, 5000);
        CHECK(q[0] == 0 && q[4999] == 0);
        arena_restore(&a, &copy);
    }
    arena_free(&a);
}

int main(void)
{
    Arena a;

    arena_init(&a, heap_alloc, NULL, &host_oom);
    host_check(setjmp(host_oom));
    test_numbers(&a);
    test_bools(&a);
    test_noise(&a);
    test_copy(&a);
    arena_free(&a);
    return test_end("fault_engine");
}
