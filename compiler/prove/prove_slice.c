// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_make.h"

// What is known about one function of the machine.
typedef struct SliceFn {
    const IrFn *from;
    bool *needed;             // by instruction: the requirement or the next state depends on its value or effect
    bool *decides;            // by block: the branch at its end leads to different effects
    IrBlkRef *target;         // by block: the first block with an effect from here on.  A branch whose edges have the same target decides nothing
} SliceFn;

typedef struct Slicer {
    ProveMaker *k;
    SliceFn *fn;              // by state, then by function of the state
    bool *relevant;           // by variable: it can influence the requirement or the next state
    bool grown;               // a variable became relevant in this pass over the functions, so another pass is needed
} Slicer;

// ---- what a value needs ----

static void need_window(Slicer *s, uint32_t window);

// Marks what a value is computed from; a variable that it loads becomes relevant.
static void need_value(Slicer *s, const IrFn *f, IrRef r, bool *needed, uint32_t first)
{
    const IrIns *i = r == IR_NONE ? NULL : &f->ins.at[r];

    if (!i || needed[r])
        return;
    needed[r] = true;
    need_value(s, f, i->a, needed, first);
    need_value(s, f, i->b, needed, first);
    if (i->op == IR_stat)
        need_window(s, s->k->same[first + i->var]);
    if (i->op != IR_load || s->relevant[i->var])
        return;
    s->relevant[i->var] = true;
    s->grown = true;
}

// Marks a window as needed, and what its samples are computed from if the model follows them; then the windows of comparisons of its samples.
static void need_window(Slicer *s, uint32_t window)
{
    MadeWindow *w = &s->k->window[window];

    if (w->used)
        return;
    w->used = true;
    if (prove_follows_samples(w))
        need_value(s, w->sample, w->operand, ARENA_ARRAY(s->k->arena, bool, w->sample->ins.n), w->first);
    for (uint32_t n = s->k->of_both; n < s->k->windows; n++)
        if (s->k->window[n].base == window)
            need_window(s, n);
}

// ---- functions ----

static bool is_end(const IrJump *j) { return j->kind == IR_RET || j->kind == IR_GOTO; }

// Returns the last block that only ends the function, in the same way; b if no such block is after it.
static IrBlkRef find_equal_end(const SliceFn *f, IrBlkRef b)
{
    const IrJump *j = &f->from->blk.at[b].jump;

    for (IrBlkRef other = f->from->blk.n - 1; other > b; other--) {
        const IrJump *of = &f->from->blk.at[other].jump;
        if (is_end(of) && f->target[other] == other && !f->decides[other] && of->kind == j->kind && (j->kind == IR_RET || of->state == j->state))
            return other;
    }
    return b;
}

// Marks what block b needs.  Its successors have been visited: control only moves forward.
static void need_block(Slicer *s, SliceFn *f, IrBlkRef b)
{
    const IrBlk *of = &f->from->blk.at[b];
    const IrJump *j = &of->jump;
    bool stores = false;

    for (uint32_t n = 0; n < of->ins.n; n++) {
        const IrIns *i = &f->from->ins.at[of->ins.at[n]];
        if (i->op != IR_store || !s->relevant[i->var])
            continue;
        stores = true;
        need_value(s, f->from, of->ins.at[n], f->needed, 0);
    }
    if (is_end(j)) {
        f->target[b] = b;
        f->decides[b] = stores;               // an end with an effect has a target of its own
        if (!stores)
            f->target[b] = find_equal_end(f, b);
        return;
    }
    f->decides[b] = j->kind == IR_BR && f->target[j->then] != f->target[j->otherwise];
    if (f->decides[b])
        need_value(s, f->from, j->cond, f->needed, 0);
    f->target[b] = stores || f->decides[b] ? b : f->target[j->then];
}

// Returns the function without what the requirement does not depend on; NULL if nothing is left.
static IrFn *sliced_function(const Slicer *s, const SliceFn *f)
{
    IrFn *to;

    if (!f->from || (f->from->blk.at[f->target[0]].jump.kind == IR_RET && !f->decides[f->target[0]]))
        return NULL;
    to = ARENA_NEW(s->k->arena, IrFn);
    to->ins.at = arena_copy(s->k->arena, f->from->ins.at, f->from->ins.n * sizeof *to->ins.at);
    to->ins.n = to->ins.cap = f->from->ins.n;
    for (IrRef r = 0; r < to->ins.n; r++)
        if (!f->needed[r])
            to->ins.at[r] = (IrIns){.op = IR_const, .type = SM_F64, .a = IR_NONE, .b = IR_NONE};
    for (IrBlkRef b = 0; b < f->from->blk.n; b++) {
        const IrBlk *of = &f->from->blk.at[b];
        const IrBlkRef made = ir_add_block(s->k->arena, to);
        IrBlk *block = &to->blk.at[made];
        for (uint32_t n = 0; n < of->ins.n; n++)
            if (f->needed[of->ins.at[n]])
                vec_push(s->k->arena, &block->ins, of->ins.at[n]);
        block->jump = of->jump;
        if (is_end(&of->jump))
            continue;
        block->jump.then = f->target[of->jump.then];
        if (of->jump.kind == IR_BR && f->decides[b])
            block->jump.otherwise = f->target[of->jump.otherwise];
        else
            block->jump.kind = IR_JMP;
    }
    return to;
}

// ---- the machine ----

static void new_functions(Slicer *s)
{
    const IrMachine *m = s->k->m;
    Arena *arena = s->k->arena;

    s->fn = arena_array(arena, m->state.n * BLOCK_COUNT, sizeof *s->fn);
    for (size_t n = 0; n < m->state.n * BLOCK_COUNT; n++) {
        const IrFn *from = m->state.at[n / BLOCK_COUNT].block[n % BLOCK_COUNT];
        if (from)
            s->fn[n] = (SliceFn){from, ARENA_ARRAY(arena, bool, from->ins.n + 1), ARENA_ARRAY(arena, bool, from->blk.n),
                                 ARENA_ARRAY(arena, IrBlkRef, from->blk.n)};
    }
}

// Marks what the requirement's own conditions read.
static void need_requirement(Slicer *s)
{
    ProveMaker *k = s->k;

    for (int c = 0; c < 3; c++)
        if (k->condition[c])
            need_value(s, k->condition[c], k->condition[c]->blk.at[0].jump.cond, ARENA_ARRAY(k->arena, bool, k->condition[c]->ins.n), 0);
    s->relevant[k->m->t] |= k->model->what->kind == REQUIREMENT_LEADS_TO;
}

const bool *prove_slice(ProveMaker *k)
{
    Slicer s = {.k = k, .relevant = ARENA_ARRAY(k->arena, bool, k->m->var.n)};
    IrMachine *sliced = ARENA_NEW(k->arena, IrMachine);

    new_functions(&s);
    need_requirement(&s);
    do {
        s.grown = false;
        for (size_t n = 0; n < k->m->state.n * BLOCK_COUNT; n++)
            for (IrBlkRef b = s.fn[n].from ? s.fn[n].from->blk.n : 0; b-- > 0;)
                need_block(&s, &s.fn[n], b);
    } while (s.grown);
    *sliced = *k->m;
    sliced->state.at = arena_copy(k->arena, k->m->state.at, k->m->state.n * sizeof *sliced->state.at);
    for (size_t n = 0; n < k->m->state.n * BLOCK_COUNT; n++)
        sliced->state.at[n / BLOCK_COUNT].block[n % BLOCK_COUNT] = sliced_function(&s, &s.fn[n]);
    k->m = sliced;
    return s.relevant;
}
