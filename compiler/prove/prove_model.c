// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_model.h"

#include <string.h>

#include "compiler/base/bitset.h"
#include "compiler/ir/build.h"
#include "compiler/ir/eval.h"

enum {
    TERMS_MOST = 12,          // ways in which a condition gets its value; of more, only the condition itself is used
    BRANCHES_MOST = 2 * TERMS_MOST,
    LITERALS_MOST = 12,       // conditions of a way
    STORES_MOST = 3,          // booleans that a block stores and that are split
    DEPTH_MOST = 40
};

#define TIME_LIMIT 18446744073709551616.0     // 2^64: above every time

// A rolling window of the machine or of the requirement.
typedef struct MadeWindow {
    uint32_t size, stats;
    bool is_boolean;                  // its samples are 0 or 1
    double longest;                   // of a run: the times from here on are not distinguished
    uint32_t var[SM_STAT_COUNT];      // by statistic that is read: the variable with its value
    uint32_t trues, falses;           // KEPT variables: how many samples since the last false one, and since the last true one; at most `size`
    uint32_t last;                    // KEPT variable: the newest sample; or IR_NONE
    const IrFn *sample;               // the sample function that contains it, and the operand of its sample
    IrRef operand;
} MadeWindow;

typedef struct ProveMaker {
    ProveModel *model;
    Arena *arena;
    const IrMachine *m;
    IrMachine judge;                  // the windows of the requirement, and their sample function
    uint32_t *window_of;              // by window of the requirements: index into `window`
    MadeWindow *window;               // those of the machine, then those of the requirement
    uint32_t windows, of_machine;
    IrFn *condition[3];               // a, b, c of the requirement; NULL: it has none
    uint32_t sampled;                 // variable: a step has run
    uint32_t seen, open, age, offset; // variables: what the requirement has seen (judge_leads_to)
    IrFn *f;                          // the step that is being made
    IrBlkRef b;                       // its current block
    VEC(ProveEnd) end;                // by block
    uint32_t vars;                    // capacity of model->var
} ProveMaker;

// ---- variables ----

static uint32_t add_var(ProveMaker *k, SmType type, ProveVarKind kind, Fact begin)
{
    const IrVar v = {.space = IR_LOCAL, .type = type, .writable = true, .hidden = true};
    ProveModel *p = k->model;

    if (p->ir->var.n == k->vars) {
        p->var = arena_grow(k->arena, p->var, k->vars * sizeof *p->var, (k->vars * 2 + 16) * sizeof *p->var);
        k->vars = k->vars * 2 + 16;
    }
    p->var[p->ir->var.n] = (ProveVar){.kind = kind, .begin = begin};
    vec_push(k->arena, &p->ir->var, v);
    return p->ir->var.n - 1;
}

static Fact exactly(double x) { return fact_of_cell(SM_F64, sm_bits(x)); }

static Fact whole_between(double lo, double hi)
{
    const Fact f = {lo, hi, true, false, false, false};

    return f;
}

static Fact fact_of_initial_value(const IrVar *v)
{
    const Parameter *p = v->parameter;
    Fact f = fact_of_type(v->type);

    if (!p)
        return fact_of_cell(v->type, v->init);
    if (p->lo > f.lo)
        f.lo = p->lo;
    if (p->hi < f.hi)
        f.hi = p->hi;
    return f;
}

static void add_machine_vars(ProveMaker *k)
{
    for (uint32_t v = 0; v < k->m->var.n; v++) {
        const IrVar *from = &k->m->var.at[v];
        const bool is_time = v == k->m->g || v == k->m->s || v == k->m->t;
        const bool is_local = from->space == IR_LOCAL && !from->outside;
        const ProveVarKind kind = is_time ? PROVE_TIME : is_local ? PROVE_KEPT : from->writable && !from->outside ? PROVE_OUTPUT : PROVE_INPUT;
        const uint32_t made = add_var(k, from->type, kind, is_local ? fact_of_initial_value(from) : fact_of_type(from->type));
        k->model->ir->var.at[made].space = from->space;
        k->model->ir->var.at[made].name = from->name;
        k->model->var[made].stored = from->writable;
    }
}

// ---- windows ----

// Returns the bool of which r is the number 0 or 1; IR_NONE if there is none.
static IrRef bool_of_number(const IrFn *f, IrRef r)
{
    const IrIns *i = &f->ins.at[r];

    if (i->op != IR_cvt || i->type != SM_F64 || f->ins.at[i->a].type != SM_BOOL)
        return IR_NONE;
    return ir_op_info[f->ins.at[i->a].op].types == IR_T_LOAD || f->ins.at[i->a].op == IR_not || f->ins.at[i->a].op == IR_and || f->ins.at[i->a].op == IR_or
            || ir_op_info[f->ins.at[i->a].op].types == IR_T_COMPARE || f->ins.at[i->a].op == IR_cvt ? i->a : IR_NONE;
}

// Returns the condition of a run.  Its event is 1 or 2 if the condition is true (build_windows.c).
static IrRef condition_of_run(const IrFn *f, const IrWindow *w, IrRef event)
{
    const IrIns *i = &f->ins.at[event];

    return bool_of_number(f, w->first && w->first->gap && i->op == IR_add ? i->a : event);
}

static bool is_run(uint32_t stats) { return (stats & SM_STATS_OF_RUNS) != 0; }

// Whether each sample of a run is known from its condition: with a gap, G must not advance by more than that.
static bool is_exact_run(const ProveMaker *k, const IrWindow *w) { return !w->first || w->first->gap == 0 || k->model->delta_t <= w->first->gap; }

// Whether the value of a statistic follows from variables that the samples change.
static bool is_exact(const MadeWindow *w, SmStat stat)
{
    switch (stat) {
    case SM_STAT_RUN_STEPS: case SM_STAT_RUN_TIME: return w->operand != IR_NONE;
    case SM_STAT_NEWEST: return true;
    case SM_STAT_OLDEST: return w->size == 2;
    case SM_STAT_MIN: case SM_STAT_MAX: return w->is_boolean;
    default: return false;
    }
}

static Fact fact_of_choice(const ProveMaker *k, const MadeWindow *w, SmStat stat, Fact sample)
{
    if (stat == SM_STAT_ELAPSED) {
        const IrIns *event = &w->sample->ins.at[w->operand];
        const bool each_step = event->op == IR_const && event->bits == sm_bits(1.0);
        return whole_between(0, each_step ? (double)k->model->delta_t * (w->size - 1) : TIME_LIMIT);
    }
    return fact_of_stat(stat, sample);
}

static void add_window_vars(ProveMaker *k, MadeWindow *w, Fact sample)
{
    for (int s = 0; s < SM_STAT_COUNT; s++)
        if (w->stats >> s & 1)
            w->var[s] = is_exact(w, (SmStat)s) ? add_var(k, SM_F64, PROVE_KEPT, exactly(0)) : add_var(k, SM_F64, PROVE_CHOICE, fact_of_choice(k, w, (SmStat)s, sample));
    w->last = w->stats >> SM_STAT_NEWEST & 1 ? w->var[SM_STAT_NEWEST] : w->stats >> SM_STAT_OLDEST & 1 && w->size == 2 ? add_var(k, SM_F64, PROVE_KEPT, exactly(0)) : IR_NONE;
    if (w->is_boolean) {              // before the first sample nothing has been false, and nothing true
        w->trues = add_var(k, SM_F64, PROVE_KEPT, exactly(is_run(w->stats) ? 0 : w->size));
        w->falses = is_run(w->stats) ? w->trues : add_var(k, SM_F64, PROVE_KEPT, exactly(w->size));
        k->model->var[w->trues].few = k->model->var[w->falses].few = true;
        for (int stat = 0; stat < SM_STAT_COUNT; stat++)
            if (w->stats >> stat & 1)
                k->model->var[w->var[stat]].few = true;
        if (w->last != IR_NONE)
            k->model->var[w->last].few = true;
    }
}

// Finds the operands of the samples of a sample function, whose windows begin at `first`.
static void find_samples(ProveMaker *k, const IrMachine *m, uint32_t first)
{
    for (uint32_t n = 0; m->sample && n < m->sample->blk.at[0].ins.n; n++) {
        const IrIns *i = &m->sample->ins.at[m->sample->blk.at[0].ins.at[n]];
        MadeWindow *w;
        if (i->op != IR_sample)
            continue;
        w = &k->window[first + i->var];
        w->sample = m->sample;
        w->operand = i->a;
        if (is_run(w->stats)) {
            w->operand = is_exact_run(k, &m->window.at[i->var]) ? condition_of_run(m->sample, &m->window.at[i->var], i->a) : IR_NONE;
            w->is_boolean = w->operand != IR_NONE;
        } else if (!(w->stats & SM_STATS_OF_TIMES) && bool_of_number(m->sample, i->a) != IR_NONE) {
            w->is_boolean = true;
            w->operand = bool_of_number(m->sample, i->a);
        }
    }
}

// Raises w->longest where a function compares the time of a run with a number.
static void find_longest(ProveMaker *k, const IrFn *f, uint32_t first)
{
    for (uint32_t r = 0; f && r < f->ins.n; r++) {
        const IrIns *i = &f->ins.at[r];
        for (int side = 0; side < 2; side++) {
            const IrRef operand = side ? i->b : i->a;
            const IrIns *from = operand == IR_NONE ? NULL : &f->ins.at[operand];
            MadeWindow *w;
            double limit = TIME_LIMIT;
            if (!from || from->op != IR_stat || from->stat != SM_STAT_RUN_TIME)
                continue;
            w = &k->window[first + from->var];
            if (i->op == IR_ge && side == 0 && f->ins.at[i->b].op == IR_const)
                limit = ir_number(f->ins.at[i->b].type, f->ins.at[i->b].bits);
            if (limit > w->longest)
                w->longest = limit;
        }
    }
}

static void not_stored(Expr *e, void *context)
{
    bool *all = context;

    *all = *all && (e->kind != EX_VAR || !e->var->written) && e->kind != EX_ROLL;
}

// Returns the window of the machine that has the same samples, because both sample what no step changes; IR_NONE if there is none.
static uint32_t same_window(const ProveMaker *k, const Window *w)
{
    bool constant = true;

    expr_walk(w->sample, not_stored, &constant);
    for (uint32_t n = 0; constant && n < k->m->window.n; n++) {
        const Window *of = k->m->window.at[n].first;
        const uint32_t stat = 1u << w->stat, stats = k->m->window.at[n].stats;
        if (of && of->size == w->size && of->gap == w->gap && is_run(stat) == is_run(stats) && ir_stores_times(&k->m->window.at[n]) == ((stat & SM_STATS_OF_TIMES) != 0)
            && expr_equal(of->sample, w->sample, NULL))
            return n;
    }
    return IR_NONE;
}

static void merge_windows(ProveMaker *k, const Requirements *all)
{
    Program program = *k->m->program;
    Builder b = {.arena = k->arena, .p = &program, .m = &k->judge, .var = (uint32_t *)k->m->var_of};

    program.window = all->window;
    build_windows(&b);
    k->of_machine = k->m->window.n;
    k->windows = k->m->window.n + k->judge.window.n;
    k->window = ARENA_ARRAY(k->arena, MadeWindow, k->windows + 1u);
    for (uint32_t n = 0; n < k->windows; n++) {
        const IrWindow *from = n < k->of_machine ? &k->m->window.at[n] : &k->judge.window.at[n - k->of_machine];
        k->window[n] = (MadeWindow){.size = from->size, .stats = from->stats, .operand = IR_NONE};
    }
    k->window_of = ARENA_ARRAY(k->arena, uint32_t, all->window.n + 1u);
    for (uint32_t n = 0; n < all->window.n; n++) {
        const uint32_t same = same_window(k, &all->window.at[n]);
        k->window_of[n] = same == IR_NONE ? k->of_machine + b.window[n] : same;
        k->window[k->window_of[n]].stats |= 1u << all->window.at[n].stat;
    }
}

static void add_windows(ProveMaker *k)
{
    IrMachine judge = *k->m;
    FactMachine *of_machine = facts_of_machine(k->arena, k->m), *of_judge;

    judge.window = k->judge.window;
    judge.sample = k->judge.sample;
    judge.state.n = 0;
    of_judge = facts_of_machine(k->arena, &judge);
    find_samples(k, k->m, 0);
    find_samples(k, &judge, k->of_machine);
    for (size_t s = 0; s < k->m->state.n; s++)
        for (int block = 0; block < BLOCK_COUNT; block++)
            find_longest(k, k->m->state.at[s].block[block], 0);
    find_longest(k, k->m->sample, 0);
    find_longest(k, k->judge.sample, k->of_machine);
    for (int c = 0; c < 3; c++)
        find_longest(k, k->condition[c], 0);
    for (uint32_t n = 0; n < k->windows; n++)
        add_window_vars(k, &k->window[n], n < k->of_machine ? facts_of_window(of_machine, n) : facts_of_window(of_judge, n - k->of_machine));
}

// ---- code ----

static IrBlkRef new_block(ProveMaker *k)
{
    vec_push(k->arena, &k->end, PROVE_END_NONE);
    return ir_add_block(k->arena, k->f);
}

static IrRef emit(ProveMaker *k, IrOp op, IrRef a, IrRef b)
{
    const bool is_bool = ir_op_info[op].types == IR_T_COMPARE || ir_op_info[op].types == IR_T_LOGIC;
    const IrIns i = {.op = op, .type = is_bool ? SM_BOOL : SM_F64, .a = a, .b = b};

    return ir_emit(k->arena, k->f, k->b, i);
}

static IrRef emit_number(ProveMaker *k, double x)
{
    const IrIns i = {.op = IR_const, .type = SM_F64, .a = IR_NONE, .b = IR_NONE, .bits = sm_bits(x)};

    return ir_emit(k->arena, k->f, k->b, i);
}

// Emits the value of a variable as an F64.
static IrRef emit_load(ProveMaker *k, uint32_t var)
{
    const SmType type = k->model->ir->var.at[var].type;
    const IrIns i = {.op = IR_load, .type = type, .a = IR_NONE, .b = IR_NONE, .var = var};
    const IrRef r = ir_emit(k->arena, k->f, k->b, i);

    return type == SM_F64 ? r : emit(k, IR_cvt, r, IR_NONE);
}

static void emit_store(ProveMaker *k, uint32_t var, IrRef value)
{
    const IrIns i = {.op = IR_store, .type = SM_F64, .a = value, .b = IR_NONE, .var = var};

    k->model->var[var].stored = true;
    ir_emit(k->arena, k->f, k->b, i);
}

static void emit_set(ProveMaker *k, uint32_t var, double x) { emit_store(k, var, emit_number(k, x)); }

static void jump_from(ProveMaker *k, IrBlkRef from, IrBlkRef to)
{
    k->f->blk.at[from].jump = (IrJump){.kind = IR_JMP, .cond = IR_NONE, .then = to};
}

static void branch_from(ProveMaker *k, IrBlkRef from, IrRef cond, IrBlkRef then, IrBlkRef otherwise)
{
    k->f->blk.at[from].jump = (IrJump){.kind = IR_BR, .cond = cond, .then = then, .otherwise = otherwise};
}

// Ends the current block: continues in `then` if the variable is greater than x, else in `otherwise`.
static void branch_if_above(ProveMaker *k, uint32_t var, double x, IrBlkRef then, IrBlkRef otherwise)
{
    const IrRef value = emit_load(k, var);

    branch_from(k, k->b, emit(k, IR_gt, value, emit_number(k, x)), then, otherwise);
}

// ---- copies of functions ----

// Returns the temporary of the current block with the value of `r` of the function `from`.  `copy`: by temporary; IR_NONE: not emitted yet.
// `first`: index in k->window of window 0 of `from`.
static IrRef copy_value(ProveMaker *k, const IrFn *from, IrRef r, IrRef *copy, uint32_t first)
{
    IrIns i;

    if (r == IR_NONE || copy[r] != IR_NONE)
        return r == IR_NONE ? IR_NONE : copy[r];
    i = from->ins.at[r];
    i.a = copy_value(k, from, i.a, copy, first);
    i.b = copy_value(k, from, i.b, copy, first);
    if (i.op == IR_stat)
        i = (IrIns){.op = IR_load, .type = SM_F64, .a = IR_NONE, .b = IR_NONE, .var = k->window[first + i.var].var[i.stat]};
    if (i.op == IR_store)
        k->model->var[i.var].stored = true;
    return copy[r] = ir_emit(k->arena, k->f, k->b, i);
}

static IrRef *new_copies(ProveMaker *k, const IrFn *from)
{
    IrRef *copy = ARENA_ARRAY(k->arena, IrRef, from->ins.n + 1);

    for (uint32_t r = 0; r < from->ins.n; r++)
        copy[r] = IR_NONE;
    return copy;
}

// Copies the instructions of a block to the current block.
static void copy_block(ProveMaker *k, const IrFn *from, const IrBlk *b, IrRef *copy)
{
    for (uint32_t n = 0; n < b->ins.n; n++)
        copy_value(k, from, b->ins.at[n], copy, 0);
}

// Copies a function of the machine, and continues after it: in block `ret` where it ends, in block `go` after its transitions.
// Returns its first block.
static IrBlkRef copy_function(ProveMaker *k, const IrFn *from, IrBlkRef ret, IrBlkRef go)
{
    IrRef *copy;
    IrBlkRef first;

    if (!from)
        return ret;
    copy = new_copies(k, from);
    first = k->f->blk.n;
    for (uint32_t b = 0; b < from->blk.n; b++)
        new_block(k);
    for (uint32_t b = 0; b < from->blk.n; b++) {
        const IrJump *j = &from->blk.at[b].jump;
        k->b = first + b;
        copy_block(k, from, &from->blk.at[b], copy);
        if (j->kind == IR_GOTO)
            emit_set(k, k->model->next, j->state);
        if (j->kind == IR_BR)
            branch_from(k, k->b, copy[j->cond], first + j->then, first + j->otherwise);
        else
            jump_from(k, k->b, j->kind == IR_JMP ? first + j->then : j->kind == IR_GOTO ? go : ret);
    }
    return first;
}

// ---- samples ----

// Emits what a sample that is true, or false, changes in the variables of a window of booleans, and continues in block `next`.
static void sample_boolean(ProveMaker *k, const MadeWindow *w, bool value, IrBlkRef next)
{
    const uint32_t counts = value ? w->trues : w->falses, ends = value ? w->falses : w->trues;
    const IrRef more = emit(k, IR_min, emit(k, IR_add, emit_load(k, counts), emit_number(k, 1)), emit_number(k, w->size));

    emit_store(k, counts, more);
    emit_set(k, ends, 0);
    for (int s = SM_STAT_MIN; s <= SM_STAT_MAX; s++)
        if (w->stats >> s & 1) {
            const bool all = s == SM_STAT_MIN ? value : !value;       // all samples may be equal: then they decide
            if (!all) {
                emit_set(k, w->var[s], value);
                continue;
            }
            const IrRef full = emit(k, IR_ge, emit_load(k, counts), emit_number(k, w->size));
            const IrBlkRef equal = new_block(k), other = new_block(k), join = new_block(k);
            branch_from(k, k->b, full, equal, other);
            k->b = equal;
            emit_set(k, w->var[s], value);
            jump_from(k, k->b, join);
            k->b = other;
            emit_set(k, w->var[s], !value);
            jump_from(k, k->b, join);
            k->b = join;
        }
    jump_from(k, k->b, next);
}

// The same for a run.
static void sample_run(ProveMaker *k, const MadeWindow *w, bool value, IrBlkRef next)
{
    const uint32_t time = w->stats >> SM_STAT_RUN_TIME & 1 ? w->var[SM_STAT_RUN_TIME] : IR_NONE;
    const uint32_t steps = w->stats >> SM_STAT_RUN_STEPS & 1 ? w->var[SM_STAT_RUN_STEPS] : IR_NONE;

    if (value && time != IR_NONE) {
        const IrBlkRef more = new_block(k), first = new_block(k), join = new_block(k);
        branch_if_above(k, w->trues, 0, more, first);
        k->b = more;
        emit_store(k, time, emit(k, IR_min, emit(k, IR_add, emit_load(k, time), emit_number(k, (double)k->model->delta_t)), emit_number(k, w->longest)));
        jump_from(k, k->b, join);
        k->b = first;
        emit_set(k, time, 0);
        jump_from(k, k->b, join);
        k->b = join;
    } else if (time != IR_NONE) {
        emit_set(k, time, 0);
    }
    if (value)
        emit_store(k, w->trues, emit(k, IR_min, emit(k, IR_add, emit_load(k, w->trues), emit_number(k, 1)), emit_number(k, w->size)));
    else
        emit_set(k, w->trues, 0);
    if (steps != IR_NONE)
        emit_store(k, steps, emit_load(k, w->trues));
    jump_from(k, k->b, next);
}

// Emits what a sample changes in the newest and in the oldest sample, and continues in block `next`.  In the first step they are the same.
static void sample_ends(ProveMaker *k, const MadeWindow *w, IrRef value, IrBlkRef next)
{
    const uint32_t oldest = w->stats >> SM_STAT_OLDEST & 1 && w->size == 2 ? w->var[SM_STAT_OLDEST] : IR_NONE;
    IrBlkRef first;

    if (oldest != IR_NONE)
        emit_store(k, oldest, emit_load(k, w->last));
    if (w->last != IR_NONE)
        emit_store(k, w->last, value);
    if (oldest == IR_NONE) {
        jump_from(k, k->b, next);
        return;
    }
    first = new_block(k);
    branch_if_above(k, k->sampled, 0, next, first);
    k->b = first;
    emit_store(k, oldest, emit_load(k, w->last));
    jump_from(k, k->b, next);
}

// Emits the sample of a window of booleans whose value is known, and continues in block `next`.
static void sample_known(ProveMaker *k, const MadeWindow *w, bool value, IrBlkRef next)
{
    IrBlkRef ends;

    if (is_run(w->stats)) {
        sample_run(k, w, value, next);
        return;
    }
    ends = new_block(k);
    sample_boolean(k, w, value, ends);
    k->b = ends;
    sample_ends(k, w, emit_number(k, value), next);
}

// Emits the sample of a window, and makes the block after it the current one.
static void sample_window(ProveMaker *k, const MadeWindow *w, uint32_t first)
{
    IrBlkRef next, yes, no;
    IrRef value;

    if (w->operand == IR_NONE || (!w->is_boolean && (w->stats & SM_STATS_OF_TIMES)))
        return;                                   // its statistics are choices
    value = copy_value(k, w->sample, w->operand, new_copies(k, w->sample), first);
    next = new_block(k);
    if (w->is_boolean) {
        yes = new_block(k);
        no = new_block(k);
        branch_from(k, k->b, value, yes, no);
        k->b = yes;
        sample_known(k, w, true, next);
        k->b = no;
        sample_known(k, w, false, next);
    } else {
        sample_ends(k, w, emit(k, IR_cvt, value, IR_NONE), next);
    }
    k->b = next;
}

// ---- the requirement ----

// Copies condition a, b or c (0, 1, 2) of the requirement to the current block, and continues in one of two blocks.
static void judge_condition(ProveMaker *k, int condition, IrBlkRef then, IrBlkRef otherwise)
{
    const IrFn *from = k->condition[condition];
    IrRef *copy = new_copies(k, from);

    copy_block(k, from, &from->blk.at[0], copy);
    branch_from(k, k->b, copy[from->blk.at[0].jump.cond], then, otherwise);
}

// Makes block b the current one.  There, the step could have violated the requirement.
static void begin_premise(ProveMaker *k, IrBlkRef b)
{
    k->b = b;
    emit_set(k, k->model->premise, 1);
}

// never a; always b; always a implies b
static void judge_each_step(ProveMaker *k, IrBlkRef met, IrBlkRef violated)
{
    const Requirement *r = k->model->what;
    const IrBlkRef premise = new_block(k);

    if (r->kind == REQUIREMENT_ALWAYS && r->a)
        judge_condition(k, 0, premise, met);
    else
        jump_from(k, k->b, premise);
    begin_premise(k, premise);
    if (r->kind == REQUIREMENT_NEVER)
        judge_condition(k, 0, violated, met);
    else
        judge_condition(k, 1, met, violated);
}

// never a before b: `seen` is whether an earlier step had b.
static void judge_before(ProveMaker *k, IrBlkRef met, IrBlkRef violated)
{
    const IrBlkRef premise = new_block(k), update = new_block(k), first = new_block(k);

    judge_condition(k, 0, premise, update);
    begin_premise(k, premise);
    branch_if_above(k, k->seen, 0, update, violated);
    k->b = update;
    judge_condition(k, 1, first, met);
    k->b = first;
    emit_set(k, k->seen, 1);
    jump_from(k, first, met);
}

// never a after b without c: `seen` is whether an earlier step had b, `open` whether no step since the last one with b had c.
static void judge_after(ProveMaker *k, IrBlkRef met, IrBlkRef violated)
{
    const IrBlkRef had_b = new_block(k), premise = new_block(k), update = new_block(k), with_b = new_block(k), without = new_block(k), with_c = new_block(k);

    judge_condition(k, 0, had_b, update);
    k->b = had_b;
    branch_if_above(k, k->seen, 0, premise, update);
    begin_premise(k, premise);
    branch_if_above(k, k->open, 0, violated, update);
    k->b = update;
    judge_condition(k, 1, with_b, without);
    k->b = with_b;
    emit_set(k, k->seen, 1);
    emit_set(k, k->open, 1);
    jump_from(k, with_b, met);
    k->b = without;
    judge_condition(k, 2, with_c, met);
    k->b = with_c;
    emit_set(k, k->open, 0);
    jump_from(k, with_c, met);
}

// Ends the current block: continues in `then` if more than `x` has passed since the requirement is open.  Both `age` and T + `offset` are this
// time.  Facts about `age` are exact while it has few values.  Facts about T + `offset` have the bounds of T in the state.
static void branch_if_older(ProveMaker *k, double x, IrBlkRef then, IrBlkRef otherwise)
{
    const IrRef age = emit(k, IR_gt, emit_load(k, k->age), emit_number(k, x));
    const IrRef sum = emit(k, IR_add, emit_load(k, k->model->machine->t), emit_load(k, k->offset));

    branch_from(k, k->b, emit(k, IR_and, age, emit(k, IR_gt, sum, emit_number(k, x))), then, otherwise);
}

// Ends the current block: stores what an open requirement needs in the next step, which begins delta_t later, in this state or with T = 0 in
// another one.
static void stay_open(ProveMaker *k, IrBlkRef met)
{
    const double delta = (double)k->model->delta_t;
    const IrBlkRef leaves = new_block(k);

    emit_store(k, k->age, emit(k, IR_add, emit_load(k, k->age), emit_number(k, delta)));
    branch_if_above(k, k->model->next, 0, leaves, met);
    k->b = leaves;
    emit_store(k, k->offset, emit(k, IR_add, emit(k, IR_add, emit_load(k, k->offset), emit_load(k, k->model->machine->t)), emit_number(k, delta)));
    jump_from(k, leaves, met);
}

// always a leads to b within t
static void judge_leads_to(ProveMaker *k, IrBlkRef met, IrBlkRef violated)
{
    const double within = (double)k->model->what->within, delta = (double)k->model->delta_t;
    const IrBlkRef closed = new_block(k), opens = new_block(k), is_open = new_block(k), has_b = new_block(k), closes = new_block(k), waits = new_block(k),
                   stays = new_block(k);

    branch_if_above(k, k->open, 0, is_open, closed);
    k->b = closed;
    judge_condition(k, 0, opens, met);
    begin_premise(k, opens);
    emit_set(k, k->open, 1);
    emit_set(k, k->age, 0);
    emit_store(k, k->offset, emit(k, IR_sub, emit_number(k, 0), emit_load(k, k->model->machine->t)));
    jump_from(k, opens, is_open);
    k->b = is_open;
    judge_condition(k, 1, has_b, waits);
    k->b = has_b;
    branch_if_older(k, within, violated, closes);
    k->b = closes;
    emit_set(k, k->open, 0);
    emit_set(k, k->age, 0);
    emit_set(k, k->offset, 0);
    jump_from(k, closes, met);
    k->b = waits;
    branch_if_older(k, within - delta, violated, stays);
    k->b = stays;
    stay_open(k, met);
}

// Emits the judgement of the step, and its two ends.
static void judge_requirement(ProveMaker *k)
{
    const IrBlkRef start = k->b, met = new_block(k), violated = new_block(k);

    k->end.at[met] = PROVE_END_MET;
    k->end.at[violated] = PROVE_END_VIOLATED;
    k->b = met;
    emit_set(k, k->sampled, 1);
    k->b = start;
    switch (k->model->what->kind) {
    case REQUIREMENT_NEVER:
    case REQUIREMENT_ALWAYS: judge_each_step(k, met, violated); break;
    case REQUIREMENT_BEFORE: judge_before(k, met, violated); break;
    case REQUIREMENT_AFTER: judge_after(k, met, violated); break;
    case REQUIREMENT_LEADS_TO: judge_leads_to(k, met, violated); break;
    }
}

// ---- branches ----

typedef struct ProveLiteral { IrRef ref; bool value; } ProveLiteral;

// A conjunction: conditions with their values.
typedef struct ProveTerm {
    ProveLiteral at[LITERALS_MOST];
    uint32_t n;
    ProveLiteral stored[STORES_MOST];         // by ProveStores entry below `stores`: the variable's number in `ref`, and its value
    uint32_t stores;
} ProveTerm;

typedef struct ProveTerms { ProveTerm at[BRANCHES_MOST]; uint32_t n; } ProveTerms;

// Appends the terms of `more`.  Returns false if they are too many.
static bool append_terms(ProveTerms *to, const ProveTerms *more)
{
    if (to->n + more->n > TERMS_MOST)
        return false;
    memcpy(to->at + to->n, more->at, more->n * sizeof *more->at);
    to->n += more->n;
    return true;
}

// Replaces each term by those of `term and r == value`, which exclude each other.  Returns false if they are too many.
static bool split_condition(const IrFn *f, ProveTerms *in, IrRef r, bool value, unsigned depth)
{
    const IrIns *i = &f->ins.at[r];
    ProveTerms other;

    if (depth == 0)
        return false;
    if (i->op == IR_not)
        return split_condition(f, in, i->a, !value, depth - 1);
    if (i->op != IR_and && i->op != IR_or) {
        for (uint32_t n = 0; n < in->n; n++) {
            ProveTerm *t = &in->at[n];
            if (t->n == LITERALS_MOST)
                return false;
            t->at[t->n++] = (ProveLiteral){r, value};
        }
        return true;
    }
    if ((i->op == IR_and) == value)
        return split_condition(f, in, i->a, value, depth - 1) && split_condition(f, in, i->b, value, depth - 1);
    other = *in;
    return split_condition(f, in, i->a, value, depth - 1) && split_condition(f, &other, i->a, !value, depth - 1)
        && split_condition(f, &other, i->b, value, depth - 1) && append_terms(in, &other);
}

static bool is_stored_later(const IrFn *f, const IrBlk *b, uint32_t at)
{
    for (uint32_t n = at + 1; n < b->ins.n; n++)
        if (f->ins.at[b->ins.at[n]].op == IR_store && f->ins.at[b->ins.at[n]].var == f->ins.at[b->ins.at[at]].var)
            return true;
    return false;
}

// Splits the terms by the values of the booleans that the block stores last, unless they are constants.
static void split_stores(const IrFn *f, const IrBlk *b, ProveTerms *terms)
{
    uint32_t stores = 0;

    for (uint32_t n = 0; n < b->ins.n && stores < STORES_MOST; n++) {
        const IrIns *i = &f->ins.at[b->ins.at[n]];
        ProveTerms with[2];
        bool split = i->op == IR_store && i->type == SM_BOOL && f->ins.at[i->a].op != IR_const && !is_stored_later(f, b, n);
        for (int value = 0; split && value < 2; value++) {
            with[value] = *terms;
            split = split_condition(f, &with[value], i->a, value, DEPTH_MOST);
            for (uint32_t t = 0; split && t < with[value].n; t++)
                with[value].at[t].stored[with[value].at[t].stores++] = (ProveLiteral){i->var, value};
        }
        if (!split || !append_terms(&with[0], &with[1]))
            continue;
        *terms = with[0];
        stores++;
    }
}

// Appends an instruction to the block of a branch.
static IrRef emit_in(ProveMaker *k, IrFn *f, IrOp op, IrRef a, IrRef b, uint32_t var)
{
    const IrIns i = {.op = op, .type = SM_BOOL, .a = a, .b = b, .var = var};

    return ir_emit(k->arena, f, 0, i);
}

static void emit_literal(ProveMaker *k, IrFn *f, IrRef *all, IrRef r, bool value)
{
    const IrRef literal = value ? r : emit_in(k, f, IR_not, r, IR_NONE, 0);

    *all = *all == IR_NONE ? literal : emit_in(k, f, IR_and, *all, literal, 0);
}

// Adds a branch: the block with the condition that is the conjunction of the term.
static void add_branch(ProveMaker *k, ProveBlock *to, const IrFn *f, const IrBlk *b, const ProveTerm *t, IrBlkRef then)
{
    ProveBranch branch = {.fn = ARENA_NEW(k->arena, IrFn), .then = then};
    IrFn *fn = branch.fn;
    IrRef all = IR_NONE;

    fn->ins.n = fn->ins.cap = f->ins.n;
    fn->ins.at = arena_copy(k->arena, f->ins.at, f->ins.n * sizeof *f->ins.at);
    for (int n = 0; n < 3; n++)
        ir_add_block(k->arena, fn);
    for (uint32_t n = 0; n < b->ins.n; n++)
        vec_push(k->arena, &fn->blk.at[0].ins, b->ins.at[n]);
    for (uint32_t n = 0; n < t->n; n++)
        emit_literal(k, fn, &all, t->at[n].ref, t->at[n].value);
    for (uint32_t n = 0; n < t->stores; n++)
        emit_literal(k, fn, &all, emit_in(k, fn, IR_load, IR_NONE, IR_NONE, t->stored[n].ref), t->stored[n].value);
    if (all != IR_NONE)
        fn->blk.at[0].jump = (IrJump){.kind = IR_BR, .cond = all, .then = 1, .otherwise = 2};
    else
        fn->blk.at[0].jump = (IrJump){.kind = IR_JMP, .cond = IR_NONE, .then = 1};
    vec_push(k->arena, &to->branch, branch);
}

// Adds the branches of a block that ends in a branch on a condition: those with the condition true, then those with it false.
static void add_both_edges(ProveMaker *k, ProveBlock *to, const IrFn *f, const IrBlk *b, const ProveTerms *terms)
{
    ProveTerms with[2] = {*terms, *terms};
    const bool split = split_condition(f, &with[0], b->jump.cond, false, DEPTH_MOST) && split_condition(f, &with[1], b->jump.cond, true, DEPTH_MOST);

    for (int value = 1; value >= 0; value--) {
        if (!split) {
            const ProveTerm whole = {.at = {{b->jump.cond, value}}, .n = 1};
            with[value] = (ProveTerms){.at = {whole}, .n = 1};
        }
        for (uint32_t t = 0; t < with[value].n; t++)
            add_branch(k, to, f, b, &with[value].at[t], value ? b->jump.then : b->jump.otherwise);
    }
}

static void split_block(ProveMaker *k, ProveBlock *to, const IrFn *f, const IrBlk *b)
{
    ProveTerms terms = {.n = 1};

    split_stores(f, b, &terms);
    if (b->jump.kind == IR_BR) {
        add_both_edges(k, to, f, b, &terms);
        return;
    }
    for (uint32_t t = 0; t < terms.n; t++)
        add_branch(k, to, f, b, &terms.at[t], b->jump.kind == IR_JMP ? b->jump.then : IR_NONE);
}

// ---- a step ----

// Appends the blocks that can be reached from b, each before its predecessors.
static void order_blocks(const IrFn *f, IrBlkRef b, bool *visited, ProveStep *s)
{
    const IrJump *j = &f->blk.at[b].jump;

    if (visited[b])
        return;
    visited[b] = true;
    if (j->kind == IR_JMP || j->kind == IR_BR)
        order_blocks(f, j->then, visited, s);
    if (j->kind == IR_BR)
        order_blocks(f, j->otherwise, visited, s);
    s->order[s->blocks++] = b;
}

static void add_loads(const IrFn *f, const IrBlk *b, uint64_t *live)
{
    for (uint32_t n = 0; n < b->ins.n; n++)
        if (f->ins.at[b->ins.at[n]].op == IR_load)
            bitset_add(live, f->ins.at[b->ins.at[n]].var);
}

// Splits the blocks of the step into branches, and finds the variables that are live in each.
static ProveStep *finish_step(ProveMaker *k)
{
    ProveStep *s = ARENA_NEW(k->arena, ProveStep);
    const size_t words = bitset_words(k->model->ir->var.n);

    s->fn = k->f;
    s->block = ARENA_ARRAY(k->arena, ProveBlock, k->f->blk.n);
    s->order = ARENA_ARRAY(k->arena, IrBlkRef, k->f->blk.n);
    order_blocks(k->f, 0, ARENA_ARRAY(k->arena, bool, k->f->blk.n), s);
    for (uint32_t n = 0; n < s->blocks; n++) {
        const IrBlk *b = &k->f->blk.at[s->order[n]];
        ProveBlock *to = &s->block[s->order[n]];
        to->end = k->end.at[s->order[n]];
        to->live = ARENA_ARRAY(k->arena, uint64_t, words);
        split_block(k, to, k->f, b);
        add_loads(k->f, b, to->live);
        if (b->jump.kind == IR_JMP || b->jump.kind == IR_BR)
            bitset_merge(to->live, s->block[b->jump.then].live, words);
        if (b->jump.kind == IR_BR)
            bitset_merge(to->live, s->block[b->jump.otherwise].live, words);
    }
    for (uint32_t n = 0; n < s->blocks / 2; n++) {
        const IrBlkRef swap = s->order[n];
        s->order[n] = s->order[s->blocks - 1 - n];
        s->order[s->blocks - 1 - n] = swap;
    }
    return s;
}

// Emits the samples of the machine and its functions, and makes the block after them the current one.
static void run_machine(ProveMaker *k, const IrState *s, bool first)
{
    IrBlkRef judge, leave, step, sampled;

    for (uint32_t w = 0; w < k->of_machine; w++)
        sample_window(k, &k->window[w], 0);
    sampled = k->b;
    judge = new_block(k);
    leave = copy_function(k, s->block[BLOCK_EXIT], judge, judge);
    step = copy_function(k, s->block[BLOCK_STEP], judge, leave);
    jump_from(k, sampled, first ? copy_function(k, s->block[BLOCK_ENTRY], step, leave) : step);
    k->b = judge;
}

static ProveStep *make_step(ProveMaker *k, size_t state, bool first)
{
    k->f = ARENA_NEW(k->arena, IrFn);
    k->end.n = 0;
    k->b = new_block(k);
    if (state < k->m->state.n)
        run_machine(k, &k->m->state.at[state], first);
    for (uint32_t w = k->of_machine; w < k->windows; w++)
        sample_window(k, &k->window[w], k->of_machine);
    judge_requirement(k);
    return finish_step(k);
}

const ProveStep *prove_model_step(ProveModel *p, size_t state, bool first)
{
    ProveStep **s = &p->step[state][first];

    if (!*s)
        *s = make_step(p->maker, state, first);
    return *s;
}

// ---- the model ----

static void build_conditions(ProveMaker *k)
{
    const Requirement *r = k->model->what;
    const IrMachine named = {.program = k->m->program, .var_of = k->m->var_of, .window_of = k->window_of};
    const Expr *const of[3] = {r->a, r->b, r->c};

    for (int c = 0; c < 3; c++)
        k->condition[c] = of[c] ? ir_build_guard(k->arena, &named, of[c]) : NULL;
}

ProveModel *prove_model_new(Arena *arena, const IrMachine *m, const Requirements *all, const Requirement *what, uint64_t delta_t)
{
    ProveModel *p = ARENA_NEW(arena, ProveModel);
    ProveMaker *k = ARENA_NEW(arena, ProveMaker);

    *p = (ProveModel){.arena = arena, .machine = m, .what = what, .delta_t = delta_t, .ir = ARENA_NEW(arena, IrMachine), .maker = k};
    p->step = arena_array(arena, m->state.n + 1, sizeof *p->step);
    k->model = p;
    k->arena = arena;
    k->m = m;
    p->ir->g = m->g;
    p->ir->s = m->s;
    p->ir->t = m->t;
    add_machine_vars(k);
    merge_windows(k, all);
    build_conditions(k);
    add_windows(k);
    p->next = add_var(k, SM_F64, PROVE_CHOICE, exactly(0));
    p->premise = add_var(k, SM_F64, PROVE_CHOICE, exactly(0));
    k->sampled = add_var(k, SM_F64, PROVE_KEPT, exactly(0));
    k->seen = add_var(k, SM_F64, PROVE_KEPT, exactly(0));
    k->open = add_var(k, SM_F64, PROVE_KEPT, exactly(0));
    k->age = add_var(k, SM_F64, PROVE_KEPT, exactly(0));
    k->offset = add_var(k, SM_F64, PROVE_KEPT, exactly(0));
    p->var[k->sampled].few = p->var[k->seen].few = p->var[k->open].few = true;
    return p;
}
