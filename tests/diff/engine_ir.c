// SPDX-License-Identifier: Apache-2.0
#include "tests/diff/engine_ir.h"

#include <stdlib.h>
#include <string.h>

#include "compiler/facts/facts.h"
#include "stdlib/convert.h"
#include "stdlib/elementary.h"
#include "stdlib/math.h"

typedef struct Samples {
    double *slot, *work;
    uint32_t n, count, next;
} Samples;

// A function with the facts about its temporaries, and their current values.
typedef struct Code {
    const IrFn *f;
    Fact *of;
    bool *reached;
    uint64_t *cell;
} Code;

typedef struct Ir {
    Engine engine;
    Arena *arena;
    const Program *p;
    const IrMachine *m;
    Code sample, (*code)[BLOCK_COUNT];
    uint32_t *of_var;                 // by variable of the IR: its index in the program
    uint64_t *cell;                   // by variable of the program
    uint8_t *stored;
    Samples *window;
    uint32_t state;
    bool first, ran;
    uint64_t start, last;
} Ir;

// ---- values ----

static double number(SmType type, uint64_t cell) { return type == SM_F64 ? sm_from_bits(cell) : sm_cell_to_f64(type, cell); }
static uint64_t f64_cell(double x) { return sm_is_nan(x) ? IR_NAN : sm_bits(x); }

static void fail(Ir *r, const char *what, const Code *c, IrRef ref)
{
    const IrIns *i = &c->f->ins.at[ref];
    const double x = number(i->type, c->cell[ref]);

    if (!r->engine.error)
        r->engine.error = format_in(r->arena, "%s %s: %.17g is %s (%.17g to %.17g%s%s%s%s)", ir_op_info[i->op].name,
                                    sm_type_info[i->type].spelling, x, what, c->of[ref].lo, c->of[ref].hi, c->of[ref].whole ? ", whole" : "",
                                    c->of[ref].f32 ? ", F32" : "", c->of[ref].nan ? ", NaN" : "", c->of[ref].minus_zero ? ", -0" : "");
}

static void check_fact(Ir *r, const Code *c, IrRef ref)
{
    const IrIns *i = &c->f->ins.at[ref];
    const double x = number(i->type, c->cell[ref]);
    const Fact f = c->of[ref];

    if (x != x) {
        if (!f.nan)
            fail(r, "against facts", c, ref);
        return;
    }
    if (f.round_trips && (i->type == SM_I64 || i->type == SM_U64) && sm_cell_from_f64(i->type, x) != c->cell[ref])
        fail(r, "changed by a conversion to F64 and back", c, ref);
    if (x < f.lo || x > f.hi || (f.whole && sm_trunc(x) != x) || (f.f32 && sm_from_f32(sm_round_f32(x)) != x)
        || (x == 0 && sm_bits(x) != 0 && !f.minus_zero))
        fail(r, "against facts", c, ref);
}

// ---- operations ----

static double f64_result(IrOp op, double a, double b)
{
    switch ((int)op) {
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
    }
    return 0;
}

static int64_t i64_result(IrOp op, int64_t a, int64_t b)
{
    switch ((int)op) {
    case IR_add: return a + b;
    case IR_sub: return a - b;
    case IR_mul: return a * b;
    case IR_neg: return -a;
    case IR_abs: return a == INT64_MIN ? INT64_MAX : a < 0 ? -a : a;
    case IR_sign: return a < 0 ? -1 : a > 0;
    case IR_min: return a < b ? a : b;
    case IR_max: return a > b ? a : b;
    }
    return 0;
}

static float f32_result(IrOp op, float a, float b)
{
    switch ((int)op) {
    case IR_add: return a + b;
    case IR_sub: return a - b;
    case IR_mul: return a * b;
    case IR_div: return a / b;
    case IR_neg: return -a;
    case IR_abs: return sm_f32_from_bits(sm_f32_bits(a) & 0x7fffffffu);
    }
    return 0;
}

static int64_t signed_of(SmType type, uint64_t cell) { return type == SM_I64 ? (int64_t)cell : (int64_t)sm_cell_to_f64(type, cell); }

static void narrow_result(Ir *r, const Code *c, IrRef ref, double x)
{
    const IrIns *i = &c->f->ins.at[ref];
    const uint64_t a = c->cell[i->a], b = i->b == IR_NONE ? 0 : c->cell[i->b];

    if (i->type == SM_F32) {
        const float y = f32_result(i->op, sm_f32_from_bits((uint32_t)a), sm_f32_from_bits((uint32_t)b));
        c->cell[ref] = sm_f32_bits(y);
        if (y == y ? sm_f32_bits(y) != sm_f32_bits(sm_round_f32(x)) : x == x)
            fail(r, "not what F64 gives", c, ref);
    } else {
        const int64_t y = i64_result(i->op, signed_of(i->type, a), signed_of(i->type, b));
        const bool rounds = i->op == IR_add || i->op == IR_sub || i->op == IR_mul;
        c->cell[ref] = i->type == SM_I64 ? (uint64_t)y : sm_cell_from_f64(i->type, (double)y);
        if (number(i->type, c->cell[ref]) != x || sm_cell_from_f64(i->type, x) != c->cell[ref] || signed_of(i->type, c->cell[ref]) != y
            || (rounds && (y > INT64_C(9007199254740992) || y < -INT64_C(9007199254740992))))
            fail(r, "not what F64 gives", c, ref);
    }
}

static bool compares(IrOp op, double a, double b)
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

// Compares two integers in their own type: -1, 0, 1.
static int order(SmType type, uint64_t a, uint64_t b)
{
    const unsigned unused = 64 - 8u * sm_type_info[type].bytes;

    if (sm_type_info[type].kind == SM_KIND_SIGNED) {
        const int64_t x = (int64_t)(a << unused), y = (int64_t)(b << unused);
        return x < y ? -1 : x > y;
    }
    return a < b ? -1 : a > b;
}

static void compare_result(Ir *r, const Code *c, IrRef ref)
{
    const IrIns *i = &c->f->ins.at[ref];
    const SmType type = c->f->ins.at[i->a].type;
    const uint64_t a = c->cell[i->a], b = c->cell[i->b];

    c->cell[ref] = compares(i->op, number(type, a), number(type, b));
    if (sm_type_info[type].kind != SM_KIND_FLOAT && c->cell[ref] != compares(i->op, order(type, a, b), 0))
        fail(r, "not what F64 gives", c, ref);
}

// ---- windows: as plainly as can be ----

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return x < y ? -1 : x > y ? 1 : (int)(sm_bits(y) >> 63) - (int)(sm_bits(x) >> 63);
}

static double pairs(const double *x, uint32_t n)
{
    uint32_t half = 1;

    if (n == 1)
        return x[0];
    while (half * 2 < n)
        half *= 2;
    return sm_add(pairs(x, half), pairs(x + half, n - half));
}

static double statistic(const Samples *w, SmStat stat)
{
    double *x = w->work, a, b, d;

    if (stat >= SM_STAT_OLDEST) {
        a = w->slot[w->count < w->n ? 0 : w->next], b = w->slot[(w->next + w->n - 1) % w->n];
        return stat == SM_STAT_OLDEST ? a : stat == SM_STAT_NEWEST ? b : w->count < 2 ? 0 : sm_sub(b, a);
    }
    memcpy(x, w->slot, w->count * sizeof *x);
    if (stat == SM_STAT_AVG)
        return sm_div(pairs(x, w->count), sm_from_u32(w->count));
    qsort(x, w->count, sizeof *x, by_size);
    a = x[0], b = x[w->count - 1];
    if (stat == SM_STAT_MIN || stat == SM_STAT_MAX)
        return stat == SM_STAT_MIN ? a : b;
    if (stat == SM_STAT_RANGE)
        return a == b ? 0 : b - a;
    a = x[(w->count - 1) / 2], b = x[w->count / 2], d = b - a;
    return a == b ? a : d - d == 0 ? a + d / 2 : a / 2 + b / 2;
}

static void take_sample(Ir *r, const Code *c, const IrIns *i)
{
    Samples *w = &r->window[i->var];
    const double x = sm_to_f64(number(c->f->ins.at[i->a].type, c->cell[i->a]));

    w->slot[w->next] = x;
    w->next = (w->next + 1) % w->n;
    w->count += w->count < w->n;
    if (sm_bits(number(r->m->window.at[i->var].type, sm_cell_from_f64(r->m->window.at[i->var].type, x))) != sm_bits(x) && !r->engine.error)
        r->engine.error = format_in(r->arena, "sample %.17g is not exactly of the window's type", x);
}

// ---- functions ----

static void store(Ir *r, uint32_t var, uint64_t cell)
{
    r->cell[var] = cell;
    r->stored[var] |= r->p->var.at[var]->kind == VAR_ELEMENT;
}

static void compute(Ir *r, const Code *c, IrRef ref)
{
    const IrIns *i = &c->f->ins.at[ref];
    const double a = i->a == IR_NONE ? 0 : number(c->f->ins.at[i->a].type, c->cell[i->a]);
    const double b = i->b == IR_NONE ? 0 : number(c->f->ins.at[i->b].type, c->cell[i->b]);

    switch (ir_op_info[i->op].types) {
    case IR_T_CONST: c->cell[ref] = i->bits; break;
    case IR_T_CONVERT: c->cell[ref] = sm_cell_from_f64(i->type, a); break;
    case IR_T_COMPARE: compare_result(r, c, ref); break;
    case IR_T_LOGIC: c->cell[ref] = i->op == IR_not ? a == 0 : i->op == IR_and ? a != 0 && b != 0 : a != 0 || b != 0; break;
    case IR_T_STORE: store(r, r->of_var[i->var], c->cell[i->a]); return;
    case IR_T_SAMPLE: take_sample(r, c, i); return;
    case IR_T_STAT: c->cell[ref] = f64_cell(statistic(&r->window[i->var], i->stat)); break;
    case IR_T_LOAD:
        c->cell[ref] = r->cell[r->of_var[i->var]];
        if (sm_type_info[i->type].bytes < 8 || i->type == SM_F64)       // NaN and odd truths as they read
            c->cell[ref] = sm_cell_from_f64(i->type, number(i->type, c->cell[ref]));
        break;
    case IR_T_SAME:
        if (i->type == SM_F64)
            c->cell[ref] = f64_cell(f64_result(i->op, a, b));
        else
            narrow_result(r, c, ref, f64_result(i->op, a, b));
        break;
    }
    check_fact(r, c, ref);
}

// Runs a function.  Returns the state to which it transfers control, or 0.
static uint32_t run(Ir *r, const Code *c)
{
    IrBlkRef b = 0;

    while (c->f) {
        const IrBlk *blk = &c->f->blk.at[b];
        if (!c->reached[b] && !r->engine.error)
            r->engine.error = "a block that facts call unreachable";
        if (r->engine.error)
            return 0;
        for (size_t k = 0; k < blk->ins.n; k++)
            compute(r, c, blk->ins.at[k]);
        if (blk->jump.kind == IR_RET || blk->jump.kind == IR_GOTO)
            return blk->jump.kind == IR_GOTO ? blk->jump.state : 0;
        b = blk->jump.kind == IR_JMP || c->cell[blk->jump.cond] ? blk->jump.then : blk->jump.otherwise;
    }
    return 0;
}

// ---- the engine ----

static EngineStatus answer(const Ir *r, EngineStatus status, EngineStep *out)
{
    out->status = r->engine.error ? ENGINE_BROKEN : status;
    out->next_state = r->state;
    out->next_is_first = r->first;
    memcpy(out->cell, r->cell, r->p->var.n * sizeof *r->cell);
    memcpy(out->stored, r->stored, r->p->var.n);
    return out->status;
}

static void run_state(Ir *r)
{
    const Code *code = r->code[r->state - 1];
    uint32_t to = r->first ? run(r, &code[BLOCK_ENTRY]) : 0;

    r->first = false;
    if (!to)
        to = run(r, &code[BLOCK_STEP]);
    if (!to)
        return;
    run(r, &code[BLOCK_EXIT]);
    r->state = to;
    r->first = true;
}

static EngineStatus ir_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    Ir *r = e->self;
    uint64_t g;

    for (uint32_t k = 0; k < n; k++)
        r->cell[write[k].var] = write[k].cell;
    memset(r->stored, 0, r->p->var.n);
    g = r->cell[r->p->g->index];
    if (g == UINT64_MAX || (r->ran && g <= r->last))
        return answer(r, ENGINE_REFUSED, out);
    r->ran = true;
    r->last = g;
    if (r->first) {
        store(r, r->p->s->index, r->state);
        r->start = g;
    }
    r->cell[r->p->t->index] = g - r->start;
    run(r, &r->sample);
    run_state(r);
    return answer(r, ENGINE_OK, out);
}

static EngineStatus ir_init(Engine *e, uint32_t state, EngineStep *out)
{
    Ir *r = e->self;

    for (size_t v = 0; v < r->p->var.n; v++)
        r->cell[v] = r->p->var.at[v]->kind == VAR_LOCAL ? r->p->var.at[v]->init : 0;
    memset(r->stored, 0, r->p->var.n);
    for (size_t w = 0; w < r->m->window.n; w++)
        r->window[w].count = r->window[w].next = 0;
    r->state = state;
    r->cell[r->p->s->index] = state;
    r->first = true;
    r->ran = false;
    return answer(r, ENGINE_OK, out);
}

static void ir_close(Engine *e) { (void)e; }

static void open_code(Ir *r, FactMachine *fm, Code *c, const IrFn *f, const Env *begin)
{
    if (!f)
        return;
    const FactFlow flow = facts_of_function(fm, f, begin);
    c->f = f;
    c->of = ARENA_ARRAY(r->arena, Fact, f->ins.n);
    c->reached = ARENA_ARRAY(r->arena, bool, f->blk.n);
    c->cell = ARENA_ARRAY(r->arena, uint64_t, f->ins.n);
    if (f->ins.n > 0)
        memcpy(c->of, flow.of, f->ins.n * sizeof *c->of);
    memcpy(c->reached, flow.reached, f->blk.n * sizeof *c->reached);
}

static void open_functions(Ir *r)
{
    FactMachine *fm = facts_of_machine(r->arena, r->m);

    r->code = arena_array(r->arena, r->m->state.n, sizeof *r->code);
    open_code(r, fm, &r->sample, r->m->sample, facts_at_begin_of_sample(fm));
    for (size_t s = 0; s < r->m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            open_code(r, fm, &r->code[s][b], r->m->state.at[s].block[b], facts_at_begin(fm, s, b));
}

static void open_variables(Ir *r)
{
    r->of_var = ARENA_ARRAY(r->arena, uint32_t, r->m->var.n);
    for (size_t v = 0; v < r->m->var.n; v++)
        for (uint32_t k = 0; k < r->p->var.n; k++)
            if (strcmp(r->p->var.at[k]->name->text, r->m->var.at[v].name->text) == 0)
                r->of_var[v] = k;
    r->cell = ARENA_ARRAY(r->arena, uint64_t, r->p->var.n);
    r->stored = arena_alloc(r->arena, r->p->var.n);
    r->window = ARENA_ARRAY(r->arena, Samples, r->m->window.n);
    for (size_t w = 0; w < r->m->window.n; w++) {
        r->window[w].n = r->m->window.at[w].size;
        r->window[w].slot = ARENA_ARRAY(r->arena, double, r->window[w].n);
        r->window[w].work = ARENA_ARRAY(r->arena, double, r->window[w].n);
    }
}

Engine *engine_ir_open(Arena *arena, const Program *p, const IrMachine *m)
{
    Ir *r = ARENA_NEW(arena, Ir);

    r->arena = arena;
    r->p = p;
    r->m = m;
    open_functions(r);
    open_variables(r);
    r->engine.name = "ir";
    r->engine.program = p;
    r->engine.self = r;
    r->engine.init = ir_init;
    r->engine.step = ir_step;
    r->engine.close = ir_close;
    return &r->engine;
}
