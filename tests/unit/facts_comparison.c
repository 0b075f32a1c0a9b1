// SPDX-License-Identifier: Apache-2.0
// What a comparison of two variables says about them where it is true and where it is false, also if one of them can be NaN: for all facts and values of a
// small set, the values that lead to an edge are within the facts on that edge.
#include <stdlib.h>

#include "compiler/facts/env.h"
#include "compiler/facts/facts.h"
#include "compiler/ir/eval.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"
#include "tests/heap.h"
#include "tests/test.h"

enum { VALUES = 6, OPS = 6, LEFT = 0, RIGHT = 1 };

typedef struct Edges { const IrFn *f; const FactMachine *fm; bool reached[2]; Fact fact[2][2]; } Edges;    // by outcome, and by variable

static void note_edge(void *context, const IrJump *end, const Env *env)
{
    Edges *e = context;
    const int outcome = end == &e->f->blk.at[1].jump;

    e->reached[outcome] = true;
    for (uint32_t v = 0; v < 2; v++)
        e->fact[outcome][v] = env_get(&e->fm->shape, env, v);
}

static bool contains(Fact f, double x) { return x != x ? f.nan : x >= f.lo && x <= f.hi; }

// Returns a function that compares the two variables; or, if `of` is no load, this function of them with a constant.
static IrFn *new_comparison(Arena *arena, IrOp op, IrOp of, double constant)
{
    const bool is_plain = of == IR_load;
    const IrIns load[2] = {{.op = IR_load, .type = SM_F64, .a = IR_NONE, .b = IR_NONE, .var = LEFT}, {.op = IR_load, .type = SM_F64, .a = IR_NONE, .b = IR_NONE, .var = RIGHT}};
    IrFn *f = ARENA_NEW(arena, IrFn);

    for (int b = 0; b < 3; b++)
        ir_add_block(arena, f);
    ir_emit(arena, f, 0, load[0]);
    ir_emit(arena, f, 0, load[1]);
    if (!is_plain) {
        ir_emit(arena, f, 0, (IrIns){.op = of, .type = SM_F64, .a = 0, .b = of == IR_abs || of == IR_neg ? IR_NONE : 1});
        ir_emit(arena, f, 0, (IrIns){.op = IR_const, .type = SM_F64, .a = IR_NONE, .b = IR_NONE, .bits = sm_bits(constant)});
    }
    ir_emit(arena, f, 0, (IrIns){.op = op, .type = SM_BOOL, .a = is_plain ? 0 : 2, .b = is_plain ? 1 : 3});
    f->blk.at[0].jump = (IrJump){.kind = IR_BR, .cond = f->ins.n - 1, .then = 1, .otherwise = 2};
    f->blk.at[1].jump = f->blk.at[2].jump = (IrJump){.kind = IR_RET};
    return f;
}

static bool compare(IrOp op, double a, double b)
{
    switch ((int)op) {
    case IR_eq: return a == b;
    case IR_ne: return a != b;
    case IR_lt: return a < b;
    case IR_le: return a <= b;
    case IR_gt: return a > b;
    default: return a >= b;
    }
}

// Returns the fact that two of the values bound; `nan`: it can be NaN, too.
static Fact new_fact(const double *value, int lo, int hi, bool nan) { return (Fact){.lo = value[lo], .hi = value[hi], .nan = nan, .minus_zero = true}; }

static double compute(IrOp of, double a, double b)
{
    switch ((int)of) {
    case IR_max: return sm_max(a, b);
    case IR_min: return sm_min(a, b);
    case IR_abs: return sm_abs(a);
    default: return -a;
    }
}

static struct { unsigned long edges, tighter; } met;

// Tests one comparison with all facts and all values.
static void test_comparison(Arena *arena, const double *value, IrOp op, IrOp of, double constant)
{
    IrMachine *m = ARENA_NEW(arena, IrMachine);
    IrFn *f = new_comparison(arena, op, of, constant);
    FactMachine *fm;

    for (int v = 0; v < 2; v++)
        vec_push(arena, &m->var, ((IrVar){.type = SM_F64, .space = IR_ELEMENT, .writable = false}));
    m->g = m->s = m->t = IR_NONE;
    fm = facts_of_machine(arena, m);
    for (int n = 0; n < 5 * 5 * 5 * 5 * 4; n++) {
        const int lo[2] = {n / 4 % 5, n / 100 % 5}, hi[2] = {n / 20 % 5, n / 500 % 5};
        Edges e = {.f = f, .fm = fm, .reached = {false, false}};
        const FactEnds ends = {.visit = note_edge, .context = &e, .all = true};
        const Env *env = NULL;
        Fact from[2];
        if (lo[0] > hi[0] || lo[1] > hi[1])
            continue;
        for (uint32_t v = 0; v < 2; v++)
            env = env_set(&fm->shape, env, v, from[v] = new_fact(value, lo[v], hi[v], n >> v & 1));
        facts_flow(fm, f, env, &ends);
        for (int a = 0; a < VALUES; a++)
            for (int b = 0; b < VALUES; b++)
                if (contains(from[0], value[a]) && contains(from[1], value[b])) {
                    const int outcome = of == IR_load ? compare(op, value[a], value[b]) : compare(op, compute(of, value[a], value[b]), constant);
                    CHECK(e.reached[outcome] && contains(e.fact[outcome][0], value[a]) && contains(e.fact[outcome][1], value[b]));
                    met.edges++;
                }
        for (int outcome = 0; outcome < 2; outcome++)
            for (int v = 0; v < 2; v++)
                met.tighter += e.reached[outcome] && (e.fact[outcome][v].nan || of != IR_load) && (e.fact[outcome][v].lo > from[v].lo || e.fact[outcome][v].hi < from[v].hi);
    }
}

static void test_all(Arena *arena)
{
    static const IrOp op[OPS] = {IR_eq, IR_ne, IR_lt, IR_le, IR_gt, IR_ge}, of[] = {IR_max, IR_min, IR_abs, IR_neg};
    double value[VALUES] = {-1, 0, 0.5, 1, 2};
    unsigned long plain;

    value[VALUES - 1] = value[1] / value[1];
    for (int o = 0; o < OPS; o++)
        test_comparison(arena, value, op[o], IR_load, 0);
    plain = met.tighter;
    for (int o = 0; o < OPS; o++)
        for (size_t k = 0; k < sizeof of / sizeof *of; k++)
            for (int c = 0; c < VALUES - 1; c++)
                test_comparison(arena, value, op[o], of[k], value[c]);
    printf("%lu pairs of values; tighter facts: %lu about a value that can be NaN, %lu about an operand\n", met.edges, plain, met.tighter - plain);
    CHECK(met.edges > 200000);
    CHECK(plain > 500);       // such as a >= 1 or NaN where a < 1 is false
    CHECK(met.tighter - plain > 10000);   // such as a < 1 where max(a, b) < 1
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
    test_all(&arena);
    arena_free(&arena);
    return test_end("facts_comparison");
}
