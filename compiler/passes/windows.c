// SPDX-License-Identifier: Apache-2.0
// windows: drops statistics of rolling windows that no code reads.  A window without statistics is dropped, with the computation of its
// sample.  This may leave a window that this sample reads without statistics, so the sample function is walked backwards.  A window whose
// samples are all of a type narrower than F64 stores them in that type.  Needs no facts; invalidates use counts and values.
#include "compiler/passes/pass.h"

// Adds the statistics that a function reads to `wanted`, by window a set of 1 << SmStat.
static void collect_read_stats(const IrFn *f, uint32_t *wanted)
{
    for (size_t b = 0; f && b < f->blk.n; b++)
        for (size_t i = 0; i < f->blk.at[b].ins.n; i++) {
            const IrIns *ins = &f->ins.at[f->blk.at[b].ins.at[i]];
            if (ins->op == IR_stat)
                wanted[ins->var] |= 1u << ins->stat;
        }
}

// Whether a window can store its samples in this type.  I64 and U64 are excluded, because a sample is rounded to F64.
static bool is_window_type(SmType t) { return t != SM_I64 && t != SM_U64; }

// Makes a window store its samples in the type that they have before their conversion to F64.  With or without it, a NaN becomes 0.
static void choose_window_type(IrMachine *m, IrFn *f, IrIns *sample)
{
    const IrIns *x = &f->ins.at[sample->a];
    IrWindow *w = &m->window.at[sample->var];

    if (ir_stores_times(w))
        return;
    if (x->op == IR_cvt && x->type == SM_F64 && is_window_type(f->ins.at[x->a].type))
        sample->a = x->a;
    if (w->type == SM_F64 && is_window_type(f->ins.at[sample->a].type))
        w->type = f->ins.at[sample->a].type;
}

// Drops from the sample function all code that no window with statistics in `wanted` needs.  Adds to `wanted` the statistics that the
// samples of those windows read.
static void drop_unused_samples(Arena *arena, IrMachine *m, uint32_t *wanted)
{
    IrFn *f = m->sample;
    IrBlk *blk = &f->blk.at[0];
    bool *used = ARENA_ARRAY(arena, bool, f->ins.n);
    uint32_t kept = blk->ins.n, n = 0;

    for (size_t i = blk->ins.n; i-- > 0;) {
        IrIns *ins = &f->ins.at[blk->ins.at[i]];
        if (ins->op == IR_sample ? wanted[ins->var] == 0 : !used[blk->ins.at[i]])
            continue;
        if (ins->op == IR_sample)
            choose_window_type(m, f, ins);
        if (ir_op_info[ins->op].operands > 0)
            used[ins->a] = true;
        if (ir_op_info[ins->op].operands > 1)
            used[ins->b] = true;
        if (ins->op == IR_stat)
            wanted[ins->var] |= 1u << ins->stat;
        blk->ins.at[--kept] = blk->ins.at[i];
    }
    while (kept < blk->ins.n)
        blk->ins.at[n++] = blk->ins.at[kept++];
    blk->ins.n = n;
}

static void renumber_windows(IrFn *f, const uint32_t *number)
{
    for (size_t b = 0; f && b < f->blk.n; b++)
        for (size_t i = 0; i < f->blk.at[b].ins.n; i++) {
            IrIns *ins = &f->ins.at[f->blk.at[b].ins.at[i]];
            if (ins->op == IR_stat || ins->op == IR_sample)
                ins->var = number[ins->var];
        }
}

static void remove_unused_windows(Arena *arena, IrMachine *m, const uint32_t *wanted)
{
    uint32_t *number = ARENA_ARRAY(arena, uint32_t, m->window.n);
    uint32_t n = 0;

    for (size_t w = 0; w < m->window.n; w++)
        if (wanted[w]) {
            number[w] = n;
            m->window.at[n] = m->window.at[w];
            m->window.at[n++].stats = wanted[w];
        }
    m->window.n = n;
    renumber_windows(m->sample, number);
    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            renumber_windows(m->state.at[s].block[k], number);
    if (n == 0)
        m->sample = NULL;
}

// The pass `windows`: removes unused windows and statistics, and stores samples in their own type.
void pass_windows(Arena *arena, IrMachine *m, FactMachine *values)
{
    uint32_t *wanted = ARENA_ARRAY(arena, uint32_t, m->window.n);

    (void)values;
    if (m->window.n == 0)
        return;
    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            collect_read_stats(m->state.at[s].block[k], wanted);
    drop_unused_samples(arena, m, wanted);
    remove_unused_windows(arena, m, wanted);
}
