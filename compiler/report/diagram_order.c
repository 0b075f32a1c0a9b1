// SPDX-License-Identifier: Apache-2.0
// The order of items within their layers.  Sweeps down and up move each item near the average position of its neighbours in the previous
// layer.  Then neighbours are swapped if that saves crossings.
#include <stdlib.h>
#include <string.h>

#include "compiler/report/diagram_layout.h"

enum { SWEEPS = 24, PATIENCE = 6 };       // maximum number of sweeps; maximum without improvement

// ---- initial order ----

static void append(Layout *l, uint32_t item)
{
    Layer *layer = &l->layer[l->item.at[item].layer];

    l->item.at[item].pos = layer->n;
    layer->item[layer->n++] = item;
}

// Appends connected items next to each other: depth first, down the links.
static void walk(Layout *l, bool *met, uint32_t start)
{
    VEC(uint32_t) waiting = {NULL, 0, 0};

    vec_push(l->arena, &waiting, start);
    while (waiting.n > 0) {
        const uint32_t i = waiting.at[--waiting.n];
        if (met[i])
            continue;
        met[i] = true;
        append(l, i);
        for (uint32_t k = l->below.first[i + 1]; k-- > l->below.first[i];)
            vec_push(l->arena, &waiting, l->link.at[l->below.at[k]].below);
    }
}

static void first_order(Layout *l)
{
    bool *met = ARENA_ARRAY(l->arena, bool, l->item.n);

    for (uint32_t i = 0; i < l->d->nodes; i++)
        if (!met[i] && l->above.first[i] == l->above.first[i + 1])
            walk(l, met, i);
}

// ---- crossings ----

// Counts pairs of links whose ends are in different order above and below, with a Fenwick tree over the lower layer.
uint64_t layout_crossings(const Layout *l, uint32_t layer)
{
    const Layer *upper = &l->layer[layer];
    const uint32_t n = l->layer[layer + 1].n;
    uint64_t crossings = 0, seen = 0;

    memset(l->sums, 0, (n + 1) * sizeof *l->sums);
    for (uint32_t p = 0; p < upper->n; p++) {
        const uint32_t i = upper->item[p];
        for (uint32_t k = l->below.first[i]; k < l->below.first[i + 1]; k++, seen++) {
            const uint32_t pos = l->item.at[l->link.at[l->below.at[k]].below].pos;
            uint64_t before = 0;
            for (uint32_t s = pos + 1; s > 0; s -= s & (~s + 1))
                before += l->sums[s];
            for (uint32_t s = pos + 1; s <= n; s += s & (~s + 1))
                l->sums[s]++;
            crossings += seen - before;
        }
    }
    return crossings;
}

static uint64_t all_crossings(Layout *l)
{
    uint64_t sum = 0;

    layout_sort_links(l);
    for (uint32_t y = 0; y + 1 < l->layers; y++)
        sum += layout_crossings(l, y);
    return sum;
}

// ---- sweeps ----

typedef struct Key { int64_t at; uint32_t pos, item; } Key;

static int by_key(const void *a, const void *b)
{
    const Key *x = a, *y = b;

    return x->at != y->at ? (x->at < y->at ? -1 : 1) : (x->pos > y->pos) - (x->pos < y->pos);
}

// The average position of an item's neighbours above (or below), in 1024ths; its own position if it has none.
static int64_t middle(const Layout *l, uint32_t item, bool down)
{
    const Links *links = down ? &l->above : &l->below;
    const uint32_t first = links->first[item], n = links->first[item + 1] - first;
    int64_t sum = 0;

    for (uint32_t k = first; k < first + n; k++) {
        const Link *link = &l->link.at[links->at[k]];
        sum += l->item.at[down ? link->above : link->below].pos;
    }
    return n ? sum * 1024 / n : (int64_t)l->item.at[item].pos * 1024;
}

static void sort_layer(Layout *l, Layer *layer, bool down, Key *key)
{
    for (uint32_t p = 0; p < layer->n; p++)
        key[p] = (Key){middle(l, layer->item[p], down), p, layer->item[p]};
    if (layer->n > 1)
        qsort(key, layer->n, sizeof *key, by_key);
    for (uint32_t p = 0; p < layer->n; p++) {
        layer->item[p] = key[p].item;
        l->item.at[key[p].item].pos = p;
    }
}

static void sweep(Layout *l, bool down, Key *key)
{
    for (uint32_t i = 1; i < l->layers; i++)
        sort_layer(l, &l->layer[down ? i : l->layers - 1 - i], down, key);
}

// ---- swaps ----

enum { DEGREE = 32 };             // items with more links are not swapped: comparing two takes the product of their numbers of links

// The number of crossings that swapping i with its right neighbour j would save on one side.
static int64_t gain(const Layout *l, const Links *links, bool down, uint32_t i, uint32_t j)
{
    int64_t sum = 0;

    for (uint32_t a = links->first[i]; a < links->first[i + 1]; a++)
        for (uint32_t b = links->first[j]; b < links->first[j + 1]; b++) {
            const Link *x = &l->link.at[links->at[a]], *y = &l->link.at[links->at[b]];
            const uint32_t p = l->item.at[down ? x->below : x->above].pos, q = l->item.at[down ? y->below : y->above].pos;
            sum += (p > q) - (p < q);
        }
    return sum;
}

static bool has_few(const Layout *l, uint32_t i)
{
    return l->above.first[i + 1] - l->above.first[i] <= DEGREE && l->below.first[i + 1] - l->below.first[i] <= DEGREE;
}

static void swap_pass(Layout *l)
{
    for (uint32_t y = 0; y < l->layers; y++)
        for (uint32_t p = 0; p + 1 < l->layer[y].n; p++) {
            uint32_t *pair = l->layer[y].item + p, i = pair[0], j = pair[1];
            if (!has_few(l, i) || !has_few(l, j) || gain(l, &l->above, false, i, j) + gain(l, &l->below, true, i, j) <= 0)
                continue;
            pair[0] = j;
            pair[1] = i;
            l->item.at[j].pos = p;
            l->item.at[i].pos = p + 1;
        }
}

// ---- the best order ----

static void keep(const Layout *l, uint32_t *pos)
{
    for (size_t i = 0; i < l->item.n; i++)
        pos[i] = l->item.at[i].pos;
}

static void restore(Layout *l, const uint32_t *pos)
{
    for (uint32_t i = 0; i < l->item.n; i++) {
        l->item.at[i].pos = pos[i];
        l->layer[l->item.at[i].layer].item[pos[i]] = i;
    }
}

void layout_order(Layout *l)
{
    uint32_t *best = ARENA_ARRAY(l->arena, uint32_t, l->item.n), idle = 0;
    Key *key = ARENA_ARRAY(l->arena, Key, l->item.n);
    uint64_t fewest;

    l->sums = ARENA_ARRAY(l->arena, uint64_t, l->item.n + 1);
    first_order(l);
    fewest = all_crossings(l);
    keep(l, best);
    for (int s = 0; s < SWEEPS && idle < PATIENCE && fewest > 0; s++) {
        uint64_t n;
        sweep(l, s % 2 == 0, key);
        swap_pass(l);
        swap_pass(l);
        idle++;
        if ((n = all_crossings(l)) < fewest) {
            fewest = n;
            idle = 0;
            keep(l, best);
        }
    }
    restore(l, best);
    layout_sort_links(l);
    l->d->crossings = fewest;
}
