// SPDX-License-Identifier: Apache-2.0
// Whether two states have the same code after the optimiser: the same blocks, instructions and jumps, where temporaries, variables, windows and
// states correspond to each other one to one.
#include "compiler/diff/diff_part.h"

typedef struct CodeMatch {
    const ProgramDiff *d;
    const IrMachine *a, *b;
    uint32_t *var;                // by index of a variable of a: that of the matching variable of b; IR_NONE: none
    uint32_t *window, *window_back;           // window: by window of a, the matching one of b; window_back: the reverse; IR_NONE: not matched yet
    Arena *arena;
} CodeMatch;

// Returns an array of n + 1 elements, all IR_NONE.
static uint32_t *new_table(Arena *arena, size_t n)
{
    uint32_t *at = ARENA_ARRAY(arena, uint32_t, n + 1);

    for (size_t i = 0; i <= n; i++)
        at[i] = IR_NONE;
    return at;
}

// Prepares the comparison of IR: which variable of the new machine corresponds to each of the old one; windows are matched when they are met.
static CodeMatch new_code_match(const ProgramDiff *d)
{
    CodeMatch m = {.d = d, .a = d->old.ir, .b = d->new.ir, .arena = d->arena};

    m.var = new_table(d->arena, m.a->var.n);
    m.window = new_table(d->arena, m.a->window.n);
    m.window_back = new_table(d->arena, m.b->window.n);
    for (size_t i = 0; i < d->old.p->var.n; i++) {
        const Var *to = d->var_of[i];
        if (m.a->var_of[i] != IR_NONE && to)
            m.var[m.a->var_of[i]] = m.b->var_of[to->index];
    }
    return m;
}

// Whether windows a (old) and b (new) correspond: they have the same form, and neither corresponds to another one. same_samples compares what they
// store.
static bool same_window(CodeMatch *m, uint32_t a, uint32_t b)
{
    const IrWindow *x = &m->a->window.at[a], *y = &m->b->window.at[b];

    if (m->window[a] == IR_NONE && m->window_back[b] == IR_NONE) {
        m->window[a] = b;
        m->window_back[b] = a;
    }
    return m->window[a] == b && x->type == y->type && x->size == y->size && x->stats == y->stats;
}

// Whether variable a of the old machine corresponds to b of the new one, and has the same type and kind of memory.
static bool same_var(const CodeMatch *m, uint32_t a, uint32_t b)
{
    const IrVar *x = &m->a->var.at[a], *y = &m->b->var.at[b];

    return m->var[a] == b && x->type == y->type && x->space == y->space;
}

// Code that reads S depends on the numbers of states.
static bool reads_number(const CodeMatch *m, const IrIns *i) { return i->op == IR_load && i->var == m->a->s; }

// Whether every matched state has the same number in both machines.
static bool keeps_numbers(const ProgramDiff *d)
{
    for (uint32_t s = 1; s <= d->old.p->state.n; s++)
        if (d->state_of[s] && d->state_of[s] != s)
            return false;
    return true;
}

// Whether two instructions are equal. ref: by instruction of the old function, the corresponding one of the new.
static bool same_instruction(CodeMatch *m, const uint32_t *ref, const IrIns *x, const IrIns *y)
{
    if (x->op != y->op || x->type != y->type || x->stat != y->stat || (x->a == IR_NONE) != (y->a == IR_NONE) ||
        (x->b == IR_NONE) != (y->b == IR_NONE))
        return false;
    if ((x->a != IR_NONE && ref[x->a] != y->a) || (x->b != IR_NONE && ref[x->b] != y->b))
        return false;
    if (x->op == IR_const)
        return x->bits == y->bits;
    if (x->op == IR_load || x->op == IR_store)
        return same_var(m, x->var, y->var) && (!reads_number(m, x) || keeps_numbers(m->d));
    if (x->op == IR_stat || x->op == IR_sample)
        return same_window(m, x->var, y->var);
    return true;
}

// Whether two blocks end in the same way. ref: by instruction of the old function, the corresponding one of the new.
static bool same_jump(const CodeMatch *m, const uint32_t *ref, const IrJump *x, const IrJump *y)
{
    if (x->kind != y->kind)
        return false;
    switch (x->kind) {
    case IR_RET: return true;
    case IR_JMP: return x->then == y->then;
    case IR_BR: return x->then == y->then && x->otherwise == y->otherwise && ref[x->cond] == y->cond;
    case IR_GOTO: return m->d->state_of[x->state] == y->state;
    }
    return false;
}

// Whether two functions have equal blocks, instruction by instruction. Both can be NULL.
static bool same_function(CodeMatch *m, const IrFn *f, const IrFn *g)
{
    uint32_t *ref;

    if (!f || !g || f->blk.n != g->blk.n)
        return f == NULL && g == NULL;
    ref = new_table(m->arena, f->ins.n);
    for (size_t b = 0; b < f->blk.n; b++) {
        const IrBlk *x = &f->blk.at[b], *y = &g->blk.at[b];
        if (x->ins.n != y->ins.n)
            return false;
        for (size_t i = 0; i < x->ins.n; i++) {
            if (!same_instruction(m, ref, &f->ins.at[x->ins.at[i]], &g->ins.at[y->ins.at[i]]))
                return false;
            ref[x->ins.at[i]] = y->ins.at[i];
        }
        if (!same_jump(m, ref, &x->jump, &y->jump))
            return false;
    }
    return true;
}

// Whether two states run the same IR.  If they read windows, the functions that store the samples must be equal, too.
bool diff_same_code(const ProgramDiff *d, const State *old, const State *new)
{
    CodeMatch m = new_code_match(d);
    const IrState *x = &m.a->state.at[old->number - 1], *y = &m.b->state.at[new->number - 1];
    bool reads_windows = false;

    for (int b = 0; b < BLOCK_COUNT; b++) {
        if (!same_function(&m, x->block[b], y->block[b]))
            return false;
        for (size_t i = 0; x->block[b] && i < x->block[b]->ins.n; i++)
            reads_windows |= x->block[b]->ins.at[i].op == IR_stat;
    }
    return !reads_windows || same_function(&m, m.a->sample, m.b->sample);
}
