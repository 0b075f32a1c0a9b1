// SPDX-License-Identifier: Apache-2.0
// The nesting of a function's basic blocks.  Control only moves forward, so block order is a topological order and each analysis needs one
// pass.  A block with one predecessor is written inside the arm of the conditional that leads there.  A join block is written after the
// whole code of the block that dominates it.
#include "compiler/emit/c/fn.h"

// Returns the nearest block that dominates both a and b.
static uint32_t nearest_common_dominator(const CDominators *t, uint32_t a, uint32_t b)
{
    while (a != b) {
        if (t->depth[a] < t->depth[b]) {
            const uint32_t swap = a;
            a = b;
            b = swap;
        }
        if (t->depth[a] > t->depth[b])
            a = t->depth[t->shortcut[a]] >= t->depth[b] ? t->shortcut[a] : t->parent[a];
        else if (t->shortcut[a] != t->shortcut[b])
            a = t->shortcut[a], b = t->shortcut[b];
        else
            a = t->parent[a], b = t->parent[b];
    }
    return a;
}

// Adds block x below its immediate dominator.  A skip pointer leads 1, 3, 7 … levels up, as in a skew-binary list.
static void add_to_dominator_tree(CDominators *t, uint32_t x, uint32_t parent)
{
    const uint32_t s = t->shortcut[parent], ss = t->shortcut[s];

    t->parent[x] = parent;
    t->depth[x] = t->depth[parent] + 1;
    t->shortcut[x] = t->depth[parent] - t->depth[s] == t->depth[s] - t->depth[ss] ? ss : parent;
}

// Whether block a dominates block b.
bool flow_dominates(const CFlow *w, uint32_t a, uint32_t b) { return nearest_common_dominator(&w->dominators, a, b) == a; }

// Whether any instruction of the block does more than compute a value.
static bool has_effect(const IrFn *f, const IrBlk *b)
{
    for (size_t i = 0; i < b->ins.n; i++)
        if (ir_op_info[f->ins.at[b->ins.at[i]].op].effect)
            return true;
    return false;
}

// Fills CFlow.then and CFlow.other: the successors of each block, where empty blocks are skipped and a branch on a constant has one successor.
static void find_successors(CFn *fn)
{
    CFlow *w = &fn->flow;
    const uint32_t end = w->n - 1;
    uint32_t *skip_to = ARENA_ARRAY(fn->u->arena, uint32_t, w->n);      // by block: the block itself, or the next one that is not empty

    skip_to[end] = end;
    w->then[end] = w->other[end] = IR_NONE;
    for (uint32_t b = end; b-- > 0;) {
        const IrBlk *blk = &fn->f->blk.at[b];
        const IrJump *j = &blk->jump;
        w->then[b] = w->other[b] = IR_NONE;
        switch (j->kind) {
        case IR_RET: w->then[b] = end; break;
        case IR_JMP: w->then[b] = skip_to[j->then]; break;
        case IR_GOTO: break;
        case IR_BR:
            w->then[b] = skip_to[j->then];
            w->other[b] = skip_to[j->otherwise];
            if (c_is_const(fn, j->cond) && c_ins(fn, j->cond)->bits == 0)
                w->then[b] = w->other[b];
            if (c_is_const(fn, j->cond) || w->then[b] == w->other[b])
                w->other[b] = IR_NONE;
            break;
        }
        skip_to[b] = w->then[b] != IR_NONE && w->other[b] == IR_NONE && !has_effect(fn->f, blk) ? w->then[b] : b;
    }
}

// Records the edge from block `from` to block `to`, and updates the immediate dominator of `to`.
static void record_edge(CFlow *w, CDominators *t, uint32_t from, uint32_t to)
{
    if (to == IR_NONE)
        return;
    t->parent[to] = w->reached[to] ? nearest_common_dominator(t, t->parent[to], from) : from;
    w->reached[to] = true;
    w->preds[to]++;
}

static void find_dominators(CFlow *w, CDominators *t)
{
    w->reached[0] = true;
    for (uint32_t b = 0; b < w->n; b++) {
        if (!w->reached[b])
            continue;
        if (b > 0)
            add_to_dominator_tree(t, b, t->parent[b]);
        record_edge(w, t, b, w->then[b]);
        record_edge(w, t, b, w->other[b]);
    }
}

// Fills CFlow.kid and CFlow.sibling: for each block, the list of join blocks that it immediately dominates.
static void list_join_blocks(CFlow *w, const CDominators *t)
{
    for (uint32_t b = 0; b < w->n; b++)
        w->kid[b] = w->sibling[b] = IR_NONE;
    for (uint32_t b = w->n; b-- > 1;) {
        if (w->reached[b] && w->preds[b] > 1) {
            w->sibling[b] = w->kid[t->parent[b]];
            w->kid[t->parent[b]] = b;
        }
    }
}

// Fills CFlow.falls.  An edge leaves the set of blocks that b dominates if it leads from one of them to a block whose immediate dominator is
// above b in the tree.
static void find_blocks_that_fall_out(Arena *arena, CFlow *w, const CDominators *t)
{
    uint32_t *highest = ARENA_ARRAY(arena, uint32_t, w->n);       // by block: least depth of an immediate dominator that such an edge reaches

    for (uint32_t b = 0; b < w->n; b++)
        highest[b] = UINT32_MAX;
    for (uint32_t b = w->n; b-- > 0;) {
        const uint32_t to[2] = { w->then[b], w->other[b] };
        if (!w->reached[b])
            continue;
        for (int i = 0; i < 2; i++)
            if (to[i] != IR_NONE && t->depth[t->parent[to[i]]] < highest[b])
                highest[b] = t->depth[t->parent[to[i]]];
        w->falls[b] = highest[b] < t->depth[b];
        if (b > 0 && highest[b] < highest[t->parent[b]])
            highest[t->parent[b]] = highest[b];
    }
}

// Computes fn->flow, the nesting of the blocks in C.
void flow_build(CFn *fn)
{
    Arena *a = fn->u->arena;
    CFlow *w = &fn->flow;
    CDominators t;

    w->n = (uint32_t)fn->f->blk.n + 1;
    w->then = ARENA_ARRAY(a, uint32_t, w->n);
    w->other = ARENA_ARRAY(a, uint32_t, w->n);
    w->reached = ARENA_ARRAY(a, bool, w->n);
    w->preds = ARENA_ARRAY(a, uint32_t, w->n);
    w->kid = ARENA_ARRAY(a, uint32_t, w->n);
    w->sibling = ARENA_ARRAY(a, uint32_t, w->n);
    w->falls = ARENA_ARRAY(a, bool, w->n);
    t.parent = ARENA_ARRAY(a, uint32_t, w->n);
    t.shortcut = ARENA_ARRAY(a, uint32_t, w->n);
    t.depth = ARENA_ARRAY(a, uint32_t, w->n);
    find_successors(fn);
    find_dominators(w, &t);
    list_join_blocks(w, &t);
    find_blocks_that_fall_out(a, w, &t);
    w->dominators = t;
}
