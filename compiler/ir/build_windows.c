// SPDX-License-Identifier: Apache-2.0
// Builds rolling windows, which store the last samples of an expression.  In the source, every roll call has its own window.  Here, calls
// of the same size whose sample expressions have the same shape share a window (language.md 7).  Also builds the function that samples
// every window.
#include <string.h>

#include "compiler/ir/build.h"
#include "stdlib/convert.h"

// ---- shape ----
// A hash of everything that expr_equal compares.  An inner roll call is hashed as its shared window and its statistic.  Its window is
// already known, because inner roll calls precede the outer one.

static uint64_t mix_hash(uint64_t hash, uint64_t x)
{
    hash = (hash ^ x) * UINT64_C(0x9e3779b97f4a7c15);
    return hash ^ hash >> 29;
}

// The hash of an expression without its arguments.
static uint64_t hash_node(const Builder *b, const Expr *e)
{
    uint64_t h = mix_hash((uint64_t)e->kind, e->n);

    switch (e->kind) {
    case EX_NUMBER: return mix_hash(h, sm_bits(e->number));
    case EX_VAR: return mix_hash(h, e->var->index);
    case EX_UNARY:
    case EX_BINARY: return mix_hash(h, (uint64_t)e->op);
    case EX_CHAIN:
        for (uint32_t k = 0; k + 1 < e->n; k++)
            h = mix_hash(h, (uint64_t)expr_ops(e)[k]);
        return h;
    case EX_CALL: return mix_hash(h, (uint64_t)e->fn);
    case EX_ROLL: return mix_hash(mix_hash(h, (uint64_t)e->stat), b->window[e->window]);
    }
    return h;
}

static uint64_t hash_shape(const Builder *b, const Expr *e)
{
    uint64_t h = hash_node(b, e);

    for (uint32_t k = 0; e->kind != EX_ROLL && k < e->n; k++)
        h = mix_hash(h, hash_shape(b, e->arg[k]));
    return h;
}

// ---- sharing ----

// A slot of an open-addressing hash table; empty if `first` is NULL.
typedef struct SharedWindow { const Window *first; uint32_t index; } SharedWindow;

// The slot of the window with the same size and sample expression as w, or the empty slot where it would be added.
static SharedWindow *find_shared_window(const Builder *b, SharedWindow *table, size_t cap, const Window *w)
{
    size_t at = (size_t)mix_hash(hash_shape(b, w->sample), w->size) & (cap - 1);

    while (table[at].first && (table[at].first->size != w->size || !expr_equal(table[at].first->sample, w->sample, b->window)))
        at = (at + 1) & (cap - 1);
    return &table[at];
}

static void build_sample(Builder *b, const Window *w, uint32_t index)
{
    IrIns i = {.op = IR_sample, .type = SM_F64, .b = IR_NONE, .var = index, .span = w->span};

    i.a = build_as_f64(b, w->sample);
    build_emit(b, &i);
}

// Sets the IR window of program window `number`.  The first window of its shape adds a new IR window and samples it.
static void build_window(Builder *b, const Window *w, SharedWindow *slot, uint32_t number)
{
    if (!slot->first) {
        IrWindow window = {SM_F64, w->size, 0};
        slot->first = w;
        slot->index = (uint32_t)b->m->window.n;
        vec_push(b->arena, &b->m->window, window);
        build_sample(b, w, slot->index);
    }
    b->window[number] = slot->index;
    b->m->window.at[slot->index].stats |= 1u << w->stat;
}

void build_windows(Builder *b)
{
    const Windows *list = &b->p->window;
    SharedWindow *table;
    size_t cap = 16;

    if (list->n == 0)
        return;
    while (cap < list->n * 2)
        cap *= 2;
    table = ARENA_ARRAY(b->arena, SharedWindow, cap);
    b->window = ARENA_ARRAY(b->arena, uint32_t, list->n);
    build_begin_function(b);
    for (uint32_t w = 0; w < list->n; w++)
        build_window(b, &list->at[w], find_shared_window(b, table, cap, &list->at[w]), w);
    b->m->sample = build_end_function(b);
}
