// SPDX-License-Identifier: Apache-2.0
// Control flow that no source can express: random forward graphs of blocks, for which emitted C needs nested conditionals and gotos.  Each
// machine is one graph.  The test follows the graph itself to compute the result that its C must have.  One run of the compiler builds all
// machines.
//     flow [COUNT [SEED]]
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/device/engine_c.h"
#include "tests/heap.h"
#include "tests/test.h"

enum { BLOCKS_MAX = 14, BITS = 6, STATES = 3 };

static uint64_t seed = 1;

static uint32_t dice(uint32_t n)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(seed >> 33) % n;
}

// ---- a machine whose first state's step is a random graph ----

enum { VAR_G, VAR_S, VAR_T, VAR_COUNT, VAR_TRUTH, VAR_TRACE, VAR_LAST };      // the variables, in order, followed by the bits of the input

typedef struct Subject {
    IrMachine m;
    Program p;
} Subject;

static void add_var(Arena *a, StrPool *strings, Subject *s, const char *name, IrSpace space, SmType type, uint32_t offset)
{
    IrVar v = { .space = space, .name = str_c(strings, name), .type = type, .offset = offset, .writable = space == IR_LOCAL };
    Var *pv = ARENA_NEW(a, Var);

    pv->kind = space == IR_ELEMENT ? VAR_ELEMENT : VAR_LOCAL;
    pv->name = v.name;
    pv->type = type;
    vec_push(a, &s->m.var, v);
    vec_push(a, &s->p.var, pv);
}

static IrRef emit(Arena *a, IrFn *f, IrBlkRef b, IrOp op, SmType type, IrRef x, IrRef y, uint32_t var, uint64_t bits)
{
    IrIns i = {.op = op, .type = type, .a = x, .b = y, .var = var, .bits = bits};

    return ir_emit(a, f, b, i);
}

static uint64_t f64(double x) { uint64_t u; memcpy(&u, &x, sizeof u); return u; }

// Adds trace = trace * 3 + the number of the block, so that each path has its own result.
static void add_trace(Arena *a, IrFn *f, IrBlkRef b)
{
    const IrRef old = emit(a, f, b, IR_load, SM_F64, IR_NONE, IR_NONE, VAR_TRACE, 0);
    const IrRef three = emit(a, f, b, IR_const, SM_F64, IR_NONE, IR_NONE, 0, f64(3));
    const IrRef number = emit(a, f, b, IR_const, SM_F64, IR_NONE, IR_NONE, 0, f64(b + 1));
    const IrRef product = emit(a, f, b, IR_mul, SM_F64, old, three, 0, 0);
    const IrRef sum = emit(a, f, b, IR_add, SM_F64, product, number, 0, 0);

    emit(a, f, b, IR_store, SM_F64, sum, IR_NONE, VAR_TRACE, 0);
    if (dice(3) == 0)                 // a value that is used after a store: C needs a variable for it
        emit(a, f, b, IR_store, SM_F64, old, IR_NONE, VAR_LAST, 0);
}

// Adds count = count + 1: a branch that C can express without a jump.
static void add_count(Arena *a, IrFn *f, IrBlkRef b)
{
    const IrRef old = emit(a, f, b, IR_load, SM_U64, IR_NONE, IR_NONE, VAR_COUNT, 0);
    const IrRef number = emit(a, f, b, IR_cvt, SM_F64, old, IR_NONE, 0, 0);
    const IrRef one = emit(a, f, b, IR_const, SM_F64, IR_NONE, IR_NONE, 0, f64(1));
    const IrRef sum = emit(a, f, b, IR_add, SM_F64, number, one, 0, 0);

    emit(a, f, b, IR_store, SM_U64, emit(a, f, b, IR_cvt, SM_U64, sum, IR_NONE, 0, 0), IR_NONE, VAR_COUNT, 0);
}

static void add_truth(Arena *a, IrFn *f, IrBlkRef b)
{
    const IrRef truth = emit(a, f, b, IR_const, SM_BOOL, IR_NONE, IR_NONE, 0, dice(2));

    emit(a, f, b, IR_store, SM_BOOL, truth, IR_NONE, VAR_TRUTH, 0);
}

// Adds a condition that reads bit k of the input.  Each bit is a separate element: to extract it from a number would need arithmetic.
static IrRef add_condition(Arena *a, IrFn *f, IrBlkRef b, uint32_t bit)
{
    const IrRef x = emit(a, f, b, IR_load, SM_BOOL, IR_NONE, IR_NONE, VAR_LAST + 1 + bit, 0);

    return dice(2) ? x : emit(a, f, b, IR_not, SM_BOOL, x, IR_NONE, 0, 0);
}

static void add_jump(Arena *a, IrFn *f, IrBlkRef b, uint32_t blocks)
{
    IrJump *j = &f->blk.at[b].jump;
    const uint32_t left = blocks - 1 - b, kind = left == 0 ? 8 + dice(2) : dice(10);

    j->kind = kind < 6 ? IR_BR : kind < 8 ? IR_JMP : kind == 8 ? IR_RET : IR_GOTO;
    j->state = 1 + dice(STATES);
    if (left == 0)
        return;
    j->then = b + 1 + dice(dice(2) || left < 3 ? left : 3);
    j->otherwise = b + 1 + dice(dice(2) || left < 3 ? left : 3);
    if (j->kind == IR_BR)
        j->cond = add_condition(a, f, b, dice(BITS));
}

static IrFn *random_function(Arena *a)
{
    IrFn *f = ARENA_NEW(a, IrFn);
    const uint32_t blocks = 1 + dice(BLOCKS_MAX);

    for (uint32_t b = 0; b < blocks; b++)
        ir_add_block(a, f);
    for (uint32_t b = 0; b < blocks; b++) {
        if (dice(2))
            add_trace(a, f, b);
        else if (dice(2))
            add_count(a, f, b);
        else if (dice(3))
            add_truth(a, f, b);
        add_jump(a, f, b, blocks);
    }
    return f;
}

static void subject_init(Arena *a, StrPool *strings, Subject *s)
{
    static const char *const state[STATES] = { "Graph", "Second", "Third" };

    memset(s, 0, sizeof *s);
    s->m.name = s->m.sv_name = s->p.name = str_c(strings, "graph");
    s->m.sv_size = 24;
    add_var(a, strings, s, "G", IR_ELEMENT, SM_U64, 0);
    add_var(a, strings, s, "S", IR_ELEMENT, SM_U32, 8);
    add_var(a, strings, s, "T", IR_TIME, SM_U64, 0);
    add_var(a, strings, s, "count", IR_LOCAL, SM_U64, 0);
    add_var(a, strings, s, "truth", IR_LOCAL, SM_BOOL, 0);
    add_var(a, strings, s, "trace", IR_LOCAL, SM_F64, 0);
    add_var(a, strings, s, "last", IR_LOCAL, SM_F64, 0);
    for (uint32_t i = 0; i < BITS; i++)
        add_var(a, strings, s, format_in(a, "bit%u", i), IR_ELEMENT, SM_BOOL, 16 + i);
    s->m.g = VAR_G;
    s->m.s = VAR_S;
    s->m.t = VAR_T;
    for (int i = 0; i < STATES; i++) {
        IrState st = { .name = str_c(strings, state[i]), .block = { NULL, i == 0 ? random_function(a) : NULL, NULL } };
        vec_push(a, &s->m.state, st);
    }
}

// ---- expected results ----

typedef struct Outcome { double trace, last; uint32_t state; uint64_t count, truth; } Outcome;

static void walk_block(const IrFn *f, const IrBlk *b, Outcome *o)
{
    const double before = o->trace;

    for (size_t p = 0; p < b->ins.n; p++) {
        const IrIns *i = &f->ins.at[b->ins.at[p]];
        if (i->op == IR_store && i->var == VAR_LAST)
            o->last = before;
        else if (i->op == IR_store && i->var == VAR_COUNT)
            o->count++;
        else if (i->op == IR_store && i->var == VAR_TRUTH)
            o->truth = f->ins.at[i->a].bits;
        else if (i->op == IR_store)
            o->trace = before * 3 + (double)(b - f->blk.at + 1);
    }
}

static bool holds(const IrFn *f, IrRef cond, uint32_t bits)
{
    const IrIns *i = &f->ins.at[cond];

    return i->op == IR_not ? !holds(f, i->a, bits) : (bits >> (i->var - VAR_LAST - 1) & 1u) != 0;
}

static Outcome walk(const IrFn *f, uint32_t bits)
{
    Outcome o = { 0, 0, 1, 0, 0 };
    IrBlkRef b = 0;

    for (;;) {
        const IrJump *j = &f->blk.at[b].jump;
        walk_block(f, &f->blk.at[b], &o);
        if (j->kind == IR_GOTO)
            o.state = j->state;
        if (j->kind == IR_RET || j->kind == IR_GOTO)
            return o;
        b = j->kind == IR_JMP || holds(f, j->cond, bits) ? j->then : j->otherwise;
    }
}

static void try_inputs(Arena *a, const Subject *s, Engine *e, uint32_t bits)
{
    const Outcome want = walk(s->m.state.at[0].block[BLOCK_STEP], bits);
    EngineWrite write[BITS];
    EngineStep got;

    engine_step_init(&got, a, &s->p);
    for (uint32_t i = 0; i < BITS; i++) {
        write[i].var = VAR_LAST + 1 + i;
        write[i].cell = bits >> i & 1u;
    }
    CHECK(e->init(e, 1, &got) == ENGINE_OK);
    CHECK(e->step(e, write, BITS, &got) == ENGINE_OK);
    CHECK(got.next_state == want.state);
    CHECK(got.cell[VAR_TRACE] == f64(want.trace));
    CHECK(got.cell[VAR_LAST] == f64(want.last));
    CHECK(got.cell[VAR_COUNT] == want.count && got.cell[VAR_TRUTH] == want.truth);
}

int main(int argc, char **argv)
{
    const size_t count = argc > 1 ? (size_t)atoi(argv[1]) : 300;
    Arena arena;
    jmp_buf oom;
    StrPool strings;
    Subject *s;
    const Program **p;
    const IrMachine **m;
    const char *error = "";
    EngineCBatch *batch;

    seed = argc > 2 ? (uint64_t)atoi(argv[2]) : 1;
    if (setjmp(oom))
        return 3;
    arena_init(&arena, heap_alloc, NULL, &oom);
    str_pool_init(&strings, &arena);
    s = ARENA_ARRAY(&arena, Subject, count);
    p = ARENA_ARRAY(&arena, const Program *, count);
    m = ARENA_ARRAY(&arena, const IrMachine *, count);
    for (size_t i = 0; i < count; i++) {
        subject_init(&arena, &strings, &s[i]);
        p[i] = &s[i].p;
        m[i] = &s[i].m;
    }
    if (!engine_c_present(&arena, &error)) {
        arena_free(&arena);
        puts("flow: no C compiler\n0 passed, 0 failed, 1 skipped");
        return 0;
    }
    batch = engine_c_batch_open(&arena, p, m, count, false, &error);
    CHECK(batch != NULL);
    if (!batch)
        fprintf(stderr, "%s\n", error);
    for (size_t i = 0; batch && i < count; i++)
        for (uint32_t bits = 0; bits < 1u << BITS; bits++)
            try_inputs(&arena, &s[i], engine_c_batch_engine(batch, i), bits);
    if (batch)
        engine_c_batch_close(batch);
    arena_free(&arena);
    return test_end("flow");
}
