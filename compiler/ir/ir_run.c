// SPDX-License-Identifier: Apache-2.0
// Executes IR on doubles.  ir_run_new flattens each function: the instructions of a block become adjacent, so that a block is a range.
#include "compiler/ir/ir_run.h"

#include <string.h>

#include "compiler/ir/eval.h"
#include "stdlib/convert.h"
#include "stdlib/roll.h"

// An instruction of a flattened function; fields as in IrIns.
typedef struct IrRunOp {
    IrOp op : 8;
    SmType type : 8;                  // cvt, store: the type to which the number is converted
    SmStat stat : 8;
    IrRef to, a, b;                   // indices in IrRun.temp: of the result, of the operands
    uint32_t var;
    uint32_t stmt;
    SmF64 number;                     // const: the value
} IrRunOp;

typedef struct IrRunBlk { uint32_t first, end; IrJump jump; } IrRunBlk;

struct IrRunFn {
    IrRunOp *op;
    IrRunBlk *blk;
};

// ---- flattening functions ----

// Flattens a function; returns NULL if f is NULL.  Raises *temps to the number of temporaries of f, if that is larger.
static IrRunFn *flatten_function(Arena *arena, const IrFn *f, size_t *temps)
{
    IrRunFn *out;
    uint32_t n = 0;

    if (!f)
        return NULL;
    out = ARENA_NEW(arena, IrRunFn);
    out->op = ARENA_ARRAY(arena, IrRunOp, f->ins.n + 1);
    out->blk = ARENA_ARRAY(arena, IrRunBlk, f->blk.n);
    for (size_t b = 0; b < f->blk.n; b++) {
        out->blk[b].first = n;
        for (size_t k = 0; k < f->blk.at[b].ins.n; k++) {
            IrRef ref = f->blk.at[b].ins.at[k];
            const IrIns *i = &f->ins.at[ref];
            IrRunOp op = {i->op, i->type, i->stat, ref, i->a, i->b, i->var, i->stmt, 0};
            if (i->op == IR_const)
                op.number = ir_number(i->type, i->bits);
            out->op[n++] = op;
        }
        out->blk[b].end = n;
        out->blk[b].jump = f->blk.at[b].jump;
    }
    if (f->ins.n > *temps)
        *temps = f->ins.n;
    return out;
}

// Computes the size of a situation and the offsets of its parts.  A rolling window stores its samples as F64, because every sample is
// exactly an F64.
static void lay_out_situation(Arena *arena, IrRun *r)
{
    const IrMachine *m = r->m;

    r->vars = (sizeof(IrSituation) + 7) / 8 * 8;
    r->writers = r->vars + m->var.n * sizeof(double);
    r->windows = (r->writers + m->var.n * sizeof(uint32_t) + 7) / 8 * 8;
    r->size = r->windows;
    r->window_at = ARENA_ARRAY(arena, size_t, m->window.n + 1);
    r->window_kind = ARENA_ARRAY(arena, uint32_t, m->window.n + 1);
    for (size_t w = 0; w < m->window.n; w++) {
        r->window_kind[w] = sm_roll_kind(SM_F64, m->window.at[w].stats);
        r->window_at[w] = r->size;
        r->size += sm_roll_words(m->window.at[w].size, r->window_kind[w]) * sizeof(uint64_t);
    }
}

// Prepares a machine for running.
IrRun *ir_run_new(Arena *arena, const IrMachine *m)
{
    IrRun *r = ARENA_NEW(arena, IrRun);
    size_t temps = 1;

    r->m = m;
    lay_out_situation(arena, r);
    r->sample = flatten_function(arena, m->sample, &temps);
    r->block = arena_array(arena, m->state.n, sizeof *r->block);
    for (size_t s = 0; s < m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            r->block[s][b] = flatten_function(arena, m->state.at[s].block[b], &temps);
    r->temp = ARENA_ARRAY(arena, double, temps);
    r->initial = ARENA_ARRAY(arena, double, m->var.n + 1);
    for (size_t v = 0; v < m->var.n; v++)
        if (m->var.at[v].space == IR_LOCAL)
            r->initial[v] = ir_convert(m->var.at[v].type, sm_cell_to_f64(m->var.at[v].type, m->var.at[v].init));
    return r;
}

// ---- a situation ----

// Returns the values of all variables, indexed by IR variable.
double *ir_run_vars(const IrRun *r, void *situation) { return (double *)(void *)((char *)situation + r->vars); }

static uint32_t *writers_of(const IrRun *r, void *situation) { return (uint32_t *)(void *)((char *)situation + r->writers); }

// Returns for each IR variable the Stmt.number of the last assignment to it; 0: none was executed.
const uint32_t *ir_run_writers(const IrRun *r, const void *situation)
{
    return (const uint32_t *)(const void *)((const char *)situation + r->writers);
}

static uint64_t *window_of(const IrRun *r, void *situation, uint32_t w)
{
    return (uint64_t *)(void *)((char *)situation + r->window_at[w]);
}

// Initialises a situation: elements 0, locals at `initial`, windows empty, no step has run.
void ir_run_start(const IrRun *r, void *situation, uint32_t state)
{
    IrSituation *s = situation;
    double *var = ir_run_vars(r, situation);

    memset(situation, 0, r->size);
    s->state = state;
    s->first = true;
    memcpy(var, r->initial, r->m->var.n * sizeof *var);
    var[r->m->s] = state;
}

// ---- running ----

// Appends an entry to IrTrace.at, unless it equals the last entry or belongs to no statement (Stmt.number 0: entry 0 or 1).
static void record_event(IrTrace *trace, uint32_t entry)
{
    if (trace && entry > 1 && (trace->n == 0 || trace->at[trace->n - 1] != entry))
        trace->at[trace->n++] = entry;
}

// Runs a function to its end.  Returns the number of the target state, or 0 if it ends without a transition.
static uint32_t run_function(IrRun *r, const IrRunFn *f, void *situation, IrTrace *trace)
{
    double *var = ir_run_vars(r, situation), *temp = r->temp;
    const IrRunBlk *b = f->blk;

    for (;;) {
        r->work += b->end - b->first + 1u;
        for (const IrRunOp *op = f->op + b->first, *end = f->op + b->end; op < end; op++)
            switch (op->op) {
            case IR_load: temp[op->to] = var[op->var]; break;
            case IR_store:
                var[op->var] = ir_convert(op->type, temp[op->a]);
                writers_of(r, situation)[op->var] = op->stmt;
                record_event(trace, op->stmt << 1);
                break;
            case IR_stat:
                temp[op->to] = sm_roll_stat(window_of(r, situation, op->var), r->m->window.at[op->var].size,
                                            r->window_kind[op->var], op->stat);
                break;
            case IR_sample:
                if (ir_stores_times(&r->m->window.at[op->var]))
                    sm_roll_sample_event(window_of(r, situation, op->var), r->m->window.at[op->var].size, r->window_kind[op->var],
                                         sm_to_u64(temp[op->a]), sm_to_u64(var[r->m->g]));
                else
                    sm_roll_sample(window_of(r, situation, op->var), r->m->window.at[op->var].size, r->window_kind[op->var],
                               temp[op->a]);
                break;
            case IR_const: temp[op->to] = op->number; break;
            default:
                temp[op->to] = ir_eval(op->op, op->type, temp[op->a], op->b == IR_NONE ? 0 : temp[op->b]);
            }
        switch (b->jump.kind) {
        case IR_RET: return 0;
        case IR_JMP: b = f->blk + b->jump.then; break;
        case IR_GOTO:
            record_event(trace, b->jump.stmt << 1);
            if (trace)
                trace->transition = b->jump.stmt;
            return b->jump.state;
        case IR_BR:
            record_event(trace, b->jump.stmt << 1 | (temp[b->jump.cond] != 0));
            b = f->blk + (temp[b->jump.cond] != 0 && (b->jump.stmt != r->refused || r->refused == 0) ? b->jump.then : b->jump.otherwise);
            break;
        }
    }
}

// Runs one step.  Returns false and leaves the situation unchanged if G forbids the step (language.md 6.3).
bool ir_run_step(IrRun *r, void *situation, IrTrace *trace)
{
    IrSituation *s = situation;
    double *var = ir_run_vars(r, situation);
    IrRunFn *const *block = r->block[s->state - 1u];
    const double g = var[r->m->g];
    uint32_t to = 0;

    if (trace)
        trace->n = trace->transition = 0;
    if (s->ran && g <= s->last_g)
        return false;
    s->last_g = g;
    if (s->first) {
        var[r->m->s] = s->state;
        s->start = g;
    }
    var[r->m->t] = g - s->start;
    if (r->sample)
        run_function(r, r->sample, situation, NULL);
    if (s->first && block[BLOCK_ENTRY])
        to = run_function(r, block[BLOCK_ENTRY], situation, trace);
    if (to == 0 && block[BLOCK_STEP])
        to = run_function(r, block[BLOCK_STEP], situation, trace);
    if (to != 0 && block[BLOCK_EXIT])
        run_function(r, block[BLOCK_EXIT], situation, trace);
    s->ran = true;
    s->first = to != 0;
    if (to != 0)
        s->state = to;
    return true;
}

// Samples every window n times, at times that are dt apart and end with the last step.  `inputs` may be NULL; it is called before each sample to
// set the inputs.
void ir_run_fill_windows(IrRun *r, void *situation, uint32_t n, double dt, void (*inputs)(void *context, double *vars, uint32_t sample),
                         void *context)
{
    const IrSituation *s = situation;

    for (uint32_t k = 0; r->sample && k < n; k++) {
        const double g = sm_max(s->last_g - (n - 1.0 - k) * dt, 0);
        ir_run_vars(r, situation)[r->m->g] = g;
        ir_run_vars(r, situation)[r->m->t] = sm_max(g - s->start, 0);
        if (inputs)
            inputs(context, ir_run_vars(r, situation), k);
        run_function(r, r->sample, situation, NULL);
    }
}

void ir_run_copy_window(const IrRun *r, void *to, const void *from, uint32_t window)
{
    const size_t at = r->window_at[window];
    const size_t size = sm_roll_words(r->m->window.at[window].size, r->window_kind[window]) * sizeof(uint64_t);

    memcpy((char *)to + at, (const char *)from + at, size);
}

void ir_run_clear_windows(const IrRun *r, void *situation)
{
    memset((char *)situation + r->windows, 0, r->size - r->windows);
}
