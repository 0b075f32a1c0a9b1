// SPDX-License-Identifier: Apache-2.0
// Which variables are compared with each other: those that a condition of the requirement compares, and what is stored in them as it is, or as the
// maximum or the minimum of others.
#include "compiler/ir/comparison.h"
#include "compiler/prove/prove_make.h"

enum { LEAVES_MOST = 6 };     // the most variables that are related: 6 variables make PROVE_PAIRS (15) pairs

typedef struct Leaves { uint32_t at[LEAVES_MOST], n; } Leaves;

// Whether the difference to another variable can be known: 64-bit integers are rounded before they are compared.
static bool is_number(const ProveModel *p, uint32_t v)
{
    const SmType type = p->ir->var.at[v].type;

    return type != SM_BOOL && (sm_type_info[type].bytes < 8 || type == SM_F64) && p->var[v].kind != PROVE_TIME && p->var[v].kind != PROVE_IRRELEVANT;
}

// Adds a number that a comparison reads, unless it is in the list.
static void add_leaf(const ProveMaker *k, Leaves *l, uint32_t v)
{
    if (v == IR_NONE || !is_number(k->model, v))
        return;
    for (uint32_t n = 0; n < l->n; n++)
        if (l->at[n] == v)
            return;
    if (l->n < LEAVES_MOST)
        l->at[l->n++] = v;
}

// Adds the variables of which r is computed, if it has the scale of each of them.
static void add_leaves(const ProveMaker *k, Leaves *l, const IrFn *f, IrRef r)
{
    const IrIns *i = r == IR_NONE ? NULL : &f->ins.at[r];

    if (!i || i->op == IR_const)
        return;
    if (i->op == IR_load)
        add_leaf(k, l, i->var);
    else if (i->op == IR_stat) {
        const MadeWindow *w = &k->window[k->same[i->var]];
        if (w->used)
            add_leaf(k, l, w->var[i->stat]);
    } else if (i->op == IR_cvt || i->op == IR_min || i->op == IR_max || i->op == IR_add || i->op == IR_sub || i->op == IR_abs || i->op == IR_neg) {
        add_leaves(k, l, f, i->a);
        add_leaves(k, l, f, i->b);
    }
}

// Adds what the functions of the machine store in the variable.
static void add_stored(const ProveMaker *k, Leaves *l, uint32_t v)
{
    for (size_t s = 0; s < k->m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            const IrFn *f = k->m->state.at[s].block[b];
            for (uint32_t r = 0; f && r < f->ins.n; r++)
                if (f->ins.at[r].op == IR_store && f->ins.at[r].var == v)
                    add_leaves(k, l, f, f->ins.at[r].a);
        }
    for (uint32_t n = 0; n < k->windows; n++)
        if (k->window[n].used && k->window[n].stats >> SM_STAT_OLDEST & 1 && k->window[n].var[SM_STAT_OLDEST] == v)
            add_leaf(k, l, k->window[n].last);
}

// Adds two variables whose difference the proof keeps track of.
static void add_pair(ProveMaker *k, uint32_t x, uint32_t y)
{
    ProveModel *p = k->model;

    for (uint32_t n = 0; n < p->pairs; n++)
        if ((p->pair[n].x == x && p->pair[n].y == y) || (p->pair[n].x == y && p->pair[n].y == x))
            return;
    if (p->pairs < PROVE_PAIRS)
        p->pair[p->pairs++] = (ProvePair){x, y, prove_add_var(k, SM_F64, PROVE_DIFFERENCE, fact_of_type(SM_F64))};
}

void prove_add_pairs(ProveMaker *k)
{
    for (int c = 0; c < 3; c++) {
        const IrFn *f = k->condition[c];
        for (uint32_t r = 0; f && r < f->ins.n; r++) {
            Leaves l = {.n = 0};
            if (!ir_is_comparison(f->ins.at[r].op))
                continue;
            add_leaves(k, &l, f, f->ins.at[r].a);
            add_leaves(k, &l, f, f->ins.at[r].b);
            for (uint32_t n = 0; l.n > 1 && n < l.n; n++)
                add_stored(k, &l, l.at[n]);
            for (uint32_t x = 0; x < l.n; x++)
                for (uint32_t y = x + 1; y < l.n; y++)
                    add_pair(k, l.at[x], l.at[y]);
        }
    }
}
