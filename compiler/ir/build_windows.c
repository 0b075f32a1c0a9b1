// SPDX-License-Identifier: Apache-2.0
// Builds rolling windows, which store the last samples of an expression.  In the source, every roll call has its own window.  In the IR,
// calls of the same size whose sample expressions have the same shape share a window (language.md 7).  Also builds the function that
// samples every window.
#include <string.h>

#include "compiler/ir/build.h"
#include "stdlib/convert.h"

// ---- shape ----
// The shape of an expression is everything that expr_equal compares.  For a roll call inside the sample of another, the hash mixes its
// statistic and the number of its IR window.  That window exists already, because inner roll calls come first in Program.window.

static uint64_t mix_hash(uint64_t hash, uint64_t x)
{
    hash = (hash ^ x) * UINT64_C(0x9e3779b97f4a7c15);
    return hash ^ hash >> 29;
}

static uint64_t hash_shape(const Builder *b, const Expr *e)
{
    uint64_t h = mix_hash((uint64_t)e->kind, e->n);

    switch (e->kind) {
    case EX_NUMBER: h = mix_hash(h, sm_bits(e->number)); break;
    case EX_VAR: h = mix_hash(h, e->var->index); break;
    case EX_UNARY:
    case EX_BINARY: h = mix_hash(h, (uint64_t)e->op); break;
    case EX_CHAIN:
        for (uint32_t k = 0; k + 1 < e->n; k++)
            h = mix_hash(h, (uint64_t)expr_ops(e)[k]);
        break;
    case EX_EVERY: case EX_AT: case EX_RANDOM: break;                       // not reached: only scripts have these
    case EX_CALL: h = mix_hash(h, (uint64_t)e->fn); break;
    case EX_ROLL: return mix_hash(mix_hash(h, (uint64_t)e->stat), b->window[e->window]);
    }
    for (uint32_t k = 0; k < e->n; k++)
        h = mix_hash(h, hash_shape(b, e->arg[k]));
    return h;
}

// ---- sharing ----

// A slot of an open-addressing hash table; empty if `first` is NULL.
typedef struct SharedWindow { const Window *first; uint32_t index; } SharedWindow;

// Returns the kind of a window: 0 stores samples, 1 times, 2 the run of `held`.  Only windows of the same kind can be shared.
static int kind_of(const Window *w)
{
    const uint32_t stat = 1u << w->stat;

    return stat & SM_STATS_OF_RUNS ? 2 : stat & SM_STATS_OF_TIMES ? 1 : 0;
}

// Returns the slot of the window with the same kind, size and sample expression as w, or the empty slot where w is to be added.
static SharedWindow *find_shared_window(const Builder *b, SharedWindow *table, size_t cap, const Window *w)
{
    size_t at = (size_t)mix_hash(hash_shape(b, w->sample), w->size) & (cap - 1);

    while (table[at].first && (table[at].first->size != w->size || kind_of(table[at].first) != kind_of(w) || table[at].first->gap != w->gap ||
                               !expr_equal(table[at].first->sample, w->sample, b->window)))
        at = (at + 1) & (cap - 1);
    return &table[at];
}

// Builds the event of a run: 0 if its condition is false, 1 if it is true, and 2 if G has also advanced by more than the gap.
static IrRef build_event(Builder *b, const Window *w)
{
    IrIns elapsed = {.op = IR_stat, .type = SM_F64, .a = IR_NONE, .b = IR_NONE, .var = b->window[w->clock], .stat = SM_STAT_ELAPSED, .span = w->span};
    IrIns gap = {.op = IR_const, .type = SM_F64, .a = IR_NONE, .b = IR_NONE, .bits = sm_bits(sm_from_u64(w->gap)), .span = w->span};
    IrIns longer = {.op = IR_gt, .type = SM_BOOL, .span = w->span}, begins = {.op = IR_and, .type = SM_BOOL, .span = w->span};
    IrIns one = {.op = IR_cvt, .type = SM_F64, .b = IR_NONE, .span = w->span}, two = one, sum = {.op = IR_add, .type = SM_F64, .span = w->span};

    begins.a = one.a = build_as_bool(b, w->sample);
    longer.a = build_emit(b, &elapsed);
    longer.b = build_emit(b, &gap);
    begins.b = build_emit(b, &longer);
    two.a = build_emit(b, &begins);
    sum.a = build_emit(b, &one);
    sum.b = build_emit(b, &two);
    return build_emit(b, &sum);
}

// Determines which roll calls share a window, and builds the sample function.
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
    for (uint32_t k = 0; k < list->n; k++) {
        const Window *w = &list->at[k];
        SharedWindow *slot = find_shared_window(b, table, cap, w);
        if (!slot->first) {                       // the first window of its size and shape: add an IR window, and code that samples it
            IrWindow window = {kind_of(w) ? SM_U64 : SM_F64, w->size, 0, w};
            IrIns sample = {.op = IR_sample, .type = SM_F64, .b = IR_NONE, .var = (uint32_t)b->m->window.n, .span = w->span};
            slot->first = w;
            slot->index = sample.var;
            vec_push(b->arena, &b->m->window, window);
            sample.a = w->gap ? build_event(b, w) : build_as_f64(b, w->sample);
            build_emit(b, &sample);
        }
        b->window[k] = slot->index;
        b->m->window.at[slot->index].stats |= 1u << w->stat;
    }
    b->m->sample = build_end_function(b);
}
