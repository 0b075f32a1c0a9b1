// SPDX-License-Identifier: Apache-2.0
// empty: removes functions of states that do nothing, and hidden locals that no function accesses.
// Needs no facts.  Invalidates values (FACT_VALUES), because it renumbers variables.
#include "compiler/passes/pass.h"

static bool accesses_variable(const IrIns *i) { return i->op == IR_load || i->op == IR_store; }

// Marks the variables that a function loads or stores.
static void mark_accessed(const IrFn *f, bool *accessed)
{
    for (size_t b = 0; f && b < f->blk.n; b++)
        for (size_t p = 0; p < f->blk.at[b].ins.n; p++)
            if (accesses_variable(&f->ins.at[f->blk.at[b].ins.at[p]]))
                accessed[f->ins.at[f->blk.at[b].ins.at[p]].var] = true;
}

static void renumber_variables(IrFn *f, const uint32_t *number)
{
    for (size_t b = 0; f && b < f->blk.n; b++)
        for (size_t p = 0; p < f->blk.at[b].ins.n; p++)
            if (accesses_variable(&f->ins.at[f->blk.at[b].ins.at[p]]))
                f->ins.at[f->blk.at[b].ins.at[p]].var = number[f->ins.at[f->blk.at[b].ins.at[p]].var];
}

// Removes hidden locals (those that no code outside the machine reads) that no function accesses.  Renumbers the other variables.
static void remove_unused_locals(Arena *arena, IrMachine *m)
{
    bool *accessed = ARENA_ARRAY(arena, bool, m->var.n);
    uint32_t *number = ARENA_ARRAY(arena, uint32_t, m->var.n), n = 0;

    mark_accessed(m->sample, accessed);
    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            mark_accessed(m->state.at[s].block[k], accessed);
    for (size_t v = 0; v < m->var.n; v++)
        if (accessed[v] || !m->var.at[v].hidden) {
            number[v] = n;
            m->var.at[n++] = m->var.at[v];
        }
    if (n == m->var.n)
        return;
    m->var.n = n;
    m->g = number[m->g];
    m->s = number[m->s];
    m->t = number[m->t];
    renumber_variables(m->sample, number);
    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            renumber_variables(m->state.at[s].block[k], number);
}

// The pass `empty`: removes functions that do nothing and hidden locals that are not used.
void pass_empty(Arena *arena, IrMachine *m, FactMachine *values)
{
    (void)values;
    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++) {
            const IrFn *f = m->state.at[s].block[k];
            if (f && f->blk.n == 1 && f->blk.at[0].ins.n == 0 && f->blk.at[0].jump.kind == IR_RET)
                m->state.at[s].block[k] = NULL;
        }
    remove_unused_locals(arena, m);
}
