// SPDX-License-Identifier: Apache-2.0
// Narrow operations as C: random expressions of the IR on every type that it allows, compared with the result of stdlib for each
// operation.  Inputs for which a narrow operation differs from the one on F64 are not tested, since no pass narrows there.
//     typed [COUNT [SEED]]
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/device/engine_c.h"
#include "stdlib/convert.h"
#include "stdlib/elementary.h"
#include "stdlib/math.h"
#include "tests/heap.h"
#include "tests/test.h"

enum { INPUTS = 2 * SM_TYPE_COUNT, RESULTS = 12, STEPS = 60, DEPTH = 4, VAR_G = 0, VAR_S = 1, VAR_T = 2, VAR_IN = 3, VAR_OUT = VAR_IN + INPUTS };

static uint64_t seed = 1;

static uint32_t dice(uint32_t n)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(seed >> 33) % n;
}

typedef struct Subject {
    IrMachine m;
    Program p;
} Subject;

// ---- random cells ----

static uint64_t random_bits(void)
{
    const uint64_t high = dice(1u << 30), low = dice(1u << 30);

    return high << 34 ^ low << 4 ^ dice(16);
}

// Returns a mostly small value, so that sums and products fit; sometimes a limit.
static uint64_t random_cell(SmType t)
{
    static const double corner[] = { 0, 1, -1, 127, -128, 128, 255, 256, 32767, -32768, 32768, 65535, 65536, 16777216, 16777217,
                                     2147483647, -2147483648.0, 2147483648.0, 4294967295.0, 9007199254740991.0, 0.5, -0.5, 1e30 };

    switch (dice(8)) {
    case 0: return sm_cell_from_f64(t, corner[dice(sizeof corner / sizeof *corner)]);
    case 1: return t == SM_F32 || t == SM_F64 ? sm_cell_from_f64(t, (double)dice(1000000) / 7) : sm_cell_from_f64(t, (double)random_bits());
    case 2: return t == SM_F64 ? random_bits() : t == SM_F32 ? random_bits() >> 32 : sm_cell_from_f64(t, (double)dice(70000));
    case 3: return t == SM_F64 || t == SM_F32 ? sm_cell_from_f64(t, -0.0) : 0;
    case 4: return t == SM_F64 ? IR_NAN : t == SM_F32 ? 0x7fc00001u : 1;
    default: return sm_cell_from_f64(t, (double)dice(200) - 60);
    }
}

// ---- random expressions ----

static IrRef emit(Arena *a, IrFn *f, IrOp op, SmType type, IrRef x, IrRef y, uint32_t var, uint64_t bits)
{
    IrIns i = {.op = op, .type = type, .a = x, .b = y, .var = var, .bits = bits};

    return ir_emit(a, f, 0, i);
}

static IrRef random_value(Arena *a, IrFn *f, SmType type, unsigned depth);

static uint64_t read_cell(SmType t, uint64_t cell) { return t == SM_F64 || t == SM_F32 ? sm_cell_from_f64(t, sm_cell_to_f64(t, cell)) : cell; }

static IrRef random_leaf(Arena *a, IrFn *f, SmType type)
{
    if (dice(3) == 0)
        return emit(a, f, IR_const, type, IR_NONE, IR_NONE, 0, read_cell(type, random_cell(type)));
    return emit(a, f, IR_load, type, IR_NONE, IR_NONE, VAR_IN + 2 * (uint32_t)type + dice(2), 0);
}

static IrRef random_cvt(Arena *a, IrFn *f, SmType type, unsigned depth)
{
    SmType from = (SmType)dice(SM_TYPE_COUNT);

    return from == type && type != SM_F64 && type != SM_F32 ? random_leaf(a, f, type)
                                                            : emit(a, f, IR_cvt, type, random_value(a, f, from, depth), IR_NONE, 0, 0);
}

static IrRef random_truth(Arena *a, IrFn *f, unsigned depth)
{
    const SmType type = (SmType)dice(SM_TYPE_COUNT);
    const IrOp op = (IrOp)(IR_eq + dice(IR_not - IR_eq + 1));
    const SmType of = op >= IR_and ? SM_BOOL : type;
    const IrRef x = random_value(a, f, of, depth), y = op == IR_not ? IR_NONE : random_value(a, f, of, depth);

    return emit(a, f, op, SM_BOOL, x, y, 0, 0);
}

static IrRef random_same(Arena *a, IrFn *f, SmType type, unsigned depth)
{
    const IrOp op = (IrOp)(IR_add + dice(IR_max - IR_add + 1));
    IrRef x, y, r;

    if (!ir_op_allows_type(op, type))
        return random_leaf(a, f, type);
    x = random_value(a, f, type, depth);
    y = ir_op_info[op].operands > 1 ? random_value(a, f, type, depth) : IR_NONE;
    r = emit(a, f, op, type, x, y, 0, 0);
    return type == SM_F32 ? emit(a, f, IR_cvt, SM_F32, r, IR_NONE, 0, 0) : r;
}

static IrRef random_value(Arena *a, IrFn *f, SmType type, unsigned depth)
{
    if (depth == 0 || dice(5) == 0)
        return random_leaf(a, f, type);
    if (dice(3) == 0)
        return random_cvt(a, f, type, depth - 1);
    return type == SM_BOOL ? random_truth(a, f, depth - 1) : random_same(a, f, type, depth - 1);
}

// Adds a variable: a local for results, which can have any number, or an element for an input, which can be NaN.
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

static IrFn *random_function(Arena *a, Subject *s)
{
    IrFn *f = ARENA_NEW(a, IrFn);

    ir_add_block(a, f);
    for (uint32_t i = 0; i < RESULTS; i++) {
        const SmType type = s->m.var.at[VAR_OUT + i].type;
        IrRef x = random_value(a, f, type, DEPTH);
        if (type == SM_F64 || type == SM_F32)         // these stores never store a NaN
            x = emit(a, f, IR_cvt, type, x, IR_NONE, 0, 0);
        emit(a, f, IR_store, type, x, IR_NONE, VAR_OUT + i, 0);
    }
    f->blk.at[0].jump.kind = IR_RET;
    return f;
}

static void subject_init(Arena *a, StrPool *strings, Subject *s)
{
    IrState st = { .name = str_c(strings, "Only") };

    memset(s, 0, sizeof *s);
    s->m.name = s->m.sv_name = s->p.name = str_c(strings, "typed");
    s->m.sv_size = 16 + 8 * INPUTS;
    add_var(a, strings, s, "G", IR_ELEMENT, SM_U64, 0);
    add_var(a, strings, s, "S", IR_ELEMENT, SM_U32, 8);
    add_var(a, strings, s, "T", IR_TIME, SM_U64, 0);
    for (uint32_t i = 0; i < INPUTS; i++)
        add_var(a, strings, s, format_in(a, "in%u", (unsigned)i), IR_ELEMENT, (SmType)(i / 2), 16 + 8 * i);
    for (uint32_t i = 0; i < RESULTS; i++)
        add_var(a, strings, s, format_in(a, "out%u", (unsigned)i), IR_LOCAL, (SmType)dice(SM_TYPE_COUNT), 0);
    s->m.g = VAR_G;
    s->m.s = VAR_S;
    s->m.t = VAR_T;
    st.block[BLOCK_STEP] = random_function(a, s);
    vec_push(a, &s->m.state, st);
}

// ---- expected results ----

typedef struct Walk {
    const IrFn *f;
    uint64_t *cell;               // by temporary; an F64 or F32 may be NaN
    uint64_t var[VAR_OUT + RESULTS];
    bool fit;                     // no narrow operation has received a forbidden input
} Walk;

static SmF64 number(const Walk *w, IrRef r)
{
    const SmType t = w->f->ins.at[r].type;

    return t == SM_F64 ? sm_from_bits(w->cell[r]) : t == SM_F32 ? sm_from_f32(sm_f32_from_bits((uint32_t)w->cell[r]))
                                                                : sm_cell_to_f64(t, w->cell[r]);
}

static const double two_53 = 9007199254740992.0;

static bool is_exact(double x) { return sm_abs(x) <= two_53 && sm_trunc(x) == x; }

static SmF64 operate(IrOp op, SmF64 a, SmF64 b)
{
    switch (op) {
    case IR_add: return sm_add(a, b);
    case IR_sub: return sm_sub(a, b);
    case IR_mul: return sm_mul(a, b);
    case IR_div: return sm_div(a, b);
    case IR_neg: return sm_neg(a);
    case IR_abs: return sm_abs(a);
    case IR_floor: return sm_floor(a);
    case IR_ceil: return sm_ceil(a);
    case IR_trunc: return sm_trunc(a);
    case IR_round: return sm_round(a);
    case IR_sqrt: return sm_sqrt(a);
    case IR_sign: return sm_sign(a);
    case IR_min: return sm_min(a, b);
    case IR_max: return sm_max(a, b);
#define SM_ELEMENTARY(name, arguments, number) case IR_##name: return CALL_##arguments(name);
#define CALL_1(name) sm_##name(a)
#define CALL_2(name) sm_##name(a, b)
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
    case IR_eq: return sm_eq(a, b);
    case IR_ne: return !sm_eq(a, b);
    case IR_lt: return sm_lt(a, b);
    case IR_le: return sm_le(a, b);
    case IR_gt: return sm_lt(b, a);
    case IR_ge: return sm_le(b, a);
    case IR_and: return a != 0 && b != 0;
    case IR_or: return a != 0 || b != 0;
    case IR_not: return a == 0;
    case IR_const: case IR_load: case IR_store: case IR_cvt: case IR_stat: case IR_sample: case IR_OP_COUNT: break;
    }
    return 0;
}

static void walk_operation(Walk *w, const IrIns *i, uint64_t *out)
{
    const SmType of = w->f->ins.at[i->a].type;
    const SmF64 a = number(w, i->a), b = i->b != IR_NONE ? number(w, i->b) : 0, x = operate(i->op, a, b);
    const bool integers = of != SM_F64 && of != SM_F32 && of != SM_BOOL;

    if (integers && !(is_exact(a) && is_exact(b)))
        w->fit = false;
    if (integers && i->type == of && !(is_exact(x) && sm_abs(x) < two_53 && sm_cell_to_f64(of, sm_cell_from_f64(of, x)) == x))
        w->fit = false;
    *out = i->type == SM_F64 ? sm_bits(x) : i->type == SM_F32 ? sm_f32_bits(sm_round_f32(x)) : sm_cell_from_f64(i->type, x);
}

static void walk(Walk *w)
{
    for (size_t p = 0; p < w->f->blk.at[0].ins.n; p++) {
        const IrRef r = w->f->blk.at[0].ins.at[p];
        const IrIns *i = &w->f->ins.at[r];
        switch (i->op) {
        case IR_const: w->cell[r] = i->bits; break;
        case IR_load: w->cell[r] = read_cell(i->type, w->var[i->var]); break;
        case IR_store: w->var[i->var] = w->cell[i->a]; break;
        case IR_cvt: w->cell[r] = sm_cell_from_f64(i->type, number(w, i->a)); break;
        default: walk_operation(w, i, &w->cell[r]); break;
        }
    }
}

static unsigned compared;

static void complain(Arena *a, const Subject *s, uint32_t i, uint64_t got, uint64_t want)
{
    static bool done;
    Buf text;

    CHECK(got == want);
    if (done)
        return;
    done = true;
    buf_init(&text, a);
    ir_print(&s->m, &text);
    fprintf(stderr, "%sout%u is %llx, not %llx\n", buf_text(&text), (unsigned)(i - VAR_OUT), (unsigned long long)got, (unsigned long long)want);
}

static void try_input(Arena *a, const Subject *s, Engine *e, unsigned step)
{
    EngineWrite write[INPUTS + 1] = { { VAR_G, step } };
    EngineStep got;
    Walk w = { s->m.state.at[0].block[BLOCK_STEP], NULL, { 0 }, true };

    w.cell = ARENA_ARRAY(a, uint64_t, w.f->ins.n);
    for (uint32_t i = 0; i < INPUTS; i++) {
        write[i + 1].var = VAR_IN + i;
        w.var[VAR_IN + i] = write[i + 1].cell = random_cell((SmType)(i / 2));
    }
    walk(&w);
    if (!w.fit)
        return;
    engine_step_init(&got, a, &s->p);
    CHECK(e->step(e, write, INPUTS + 1, &got) == ENGINE_OK);
    for (uint32_t i = VAR_OUT; i < VAR_OUT + RESULTS; i++, compared++)
        if (got.cell[i] != w.var[i])
            complain(a, s, i, got.cell[i], w.var[i]);
}

static void try_one(Arena *a, const Subject *s, const Program *p, Engine *e)
{
    EngineStep got;

    engine_step_init(&got, a, p);
    CHECK(e->init(e, 1, &got) == ENGINE_OK);
    for (unsigned step = 0; step < STEPS; step++)
        try_input(a, s, e, step);
}

// `soft`: the C computes its numbers in software.
static void try_all(Arena *a, const Subject *s, const Program *const *p, const IrMachine *const *m, size_t count, bool soft)
{
    const char *error = "";
    EngineCBatch *batch = engine_c_batch_open(a, p, m, count, soft, &error);

    CHECK(batch != NULL);
    compared = 0;
    if (!batch)
        fprintf(stderr, "%s\n", error);
    for (size_t i = 0; batch && i < count; i++)
        try_one(a, &s[i], p[i], engine_c_batch_engine(batch, i));
    if (batch)
        engine_c_batch_close(batch);
    CHECK(!batch || compared > count * STEPS);
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
    const char *error;

    seed = argc > 2 ? (uint64_t)atoi(argv[2]) : 1;
    if (setjmp(oom))
        return 3;
    arena_init(&arena, heap_alloc, NULL, &oom);
    str_pool_init(&strings, &arena);
    s = ARENA_ARRAY(&arena, Subject, count);
    p = ARENA_ARRAY(&arena, const Program *, count);
    m = ARENA_ARRAY(&arena, const IrMachine *, count);
    for (size_t i = 0; i < count; i++) {
        const char *wrong;
        subject_init(&arena, &strings, &s[i]);
        p[i] = &s[i].p;
        m[i] = &s[i].m;
        wrong = ir_verify(&arena, m[i]);
        CHECK(wrong == NULL);
        if (wrong)
            fprintf(stderr, "%s\n", wrong);
    }
    if (!engine_c_present(&arena, &error)) {
        arena_free(&arena);
        puts("typed: no C compiler\n0 passed, 0 failed, 1 skipped");
        return 0;
    }
    try_all(&arena, s, p, m, count, false);
    try_all(&arena, s, p, m, count, true);
    arena_free(&arena);
    return test_end("typed");
}
