// SPDX-License-Identifier: Apache-2.0
// The order of items within their layers.  Sweeps down and up move each item near the average position of its neighbours in the previous
// layer.  Then neighbours are swapped if that saves crossings.
#include <stdlib.h>
#include <string.h>

#include "compiler/report/diagram_layout.h"

enum { SWEEPS = 24, PATIENCE = 6 };       // maximum number of sweeps; maximum number of consecutive sweeps without improvement

// ---- initial order ----

// Appends items to the order of their layers, depth first down the links, so that connected items are next to each other.
static void append_connected(Layout *l, bool *visited, uint32_t start)
{
    VEC(uint32_t) waiting = {NULL, 0, 0};

    vec_push(l->arena, &waiting, start);
    while (waiting.n > 0) {
        const uint32_t i = waiting.at[--waiting.n];
        Layer *layer;
        if (visited[i])
            continue;
        visited[i] = true;
        layer = &l->layer[l->item.at[i].layer];
        l->item.at[i].pos = layer->n;
        layer->item[layer->n++] = i;
        for (uint32_t k = l->below.first[i + 1]; k-- > l->below.first[i];)
            vec_push(l->arena, &waiting, l->link.at[l->below.at[k]].below);
    }
}

// The first order of all layers: depth first from each state with no link from above, so that connected items lie side by side.
static void set_initial_order(Layout *l)
{
    bool *visited = ARENA_ARRAY(l->arena, bool, l->item.n);

    for (uint32_t i = 0; i < l->d->nodes; i++)
        if (!visited[i] && l->above.first[i] == l->above.first[i + 1])
            append_connected(l, visited, i);
}

// ---- crossings ----

// Counts pairs of links whose ends are in different order above and below, with a Fenwick tree over the lower layer.
uint64_t layout_count_crossings(const Layout *l, uint32_t layer)
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

// Returns the number of crossings between all layers, after sorting the links by the current order.
static uint64_t all_crossings(Layout *l)
{
    uint64_t sum = 0;

    layout_sort_links(l);
    for (uint32_t y = 0; y + 1 < l->layers; y++)
        sum += layout_count_crossings(l, y);
    return sum;
}

// ---- sweeps ----

typedef struct OrderKey { int64_t at; uint32_t pos, item; } OrderKey;

static int compare_keys(const void *a, const void *b)
{
    const OrderKey *x = a, *y = b;

    return x->at != y->at ? (x->at < y->at ? -1 : 1) : (x->pos > y->pos) - (x->pos < y->pos);
}

// Returns the average position of an item's neighbours above (or below), in 1024ths; its own position if it has none.
static int64_t mean_neighbour_position(const Layout *l, uint32_t item, bool down)
{
    const LayoutLinks *links = down ? &l->above : &l->below;
    const uint32_t first = links->first[item], n = links->first[item + 1] - first;
    int64_t sum = 0;

    for (uint32_t k = first; k < first + n; k++) {
        const LayoutLink *link = &l->link.at[links->at[k]];
        sum += l->item.at[down ? link->above : link->below].pos;
    }
    return n ? sum * 1024 / n : (int64_t)l->item.at[item].pos * 1024;
}

// Sorts a layer by the mean positions of neighbours.
static void sort_layer(Layout *l, Layer *layer, bool down, OrderKey *key)
{
    for (uint32_t p = 0; p < layer->n; p++)
        key[p] = (OrderKey){mean_neighbour_position(l, layer->item[p], down), p, layer->item[p]};
    if (layer->n > 1)
        qsort(key, layer->n, sizeof *key, compare_keys);
    for (uint32_t p = 0; p < layer->n; p++) {
        layer->item[p] = key[p].item;
        l->item.at[key[p].item].pos = p;
    }
}

// ---- swaps ----

enum { DEGREE = 32 };             // items with more links are not swapped: comparing two takes the product of their numbers of links

// Returns the number of crossings that swapping i with its right neighbour j would save on one side.
static int64_t crossings_saved(const Layout *l, const LayoutLinks *links, bool down, uint32_t i, uint32_t j)
{
    int64_t sum = 0;

    for (uint32_t a = links->first[i]; a < links->first[i + 1]; a++)
        for (uint32_t b = links->first[j]; b < links->first[j + 1]; b++) {
            const LayoutLink *x = &l->link.at[links->at[a]], *y = &l->link.at[links->at[b]];
            const uint32_t p = l->item.at[down ? x->below : x->above].pos, q = l->item.at[down ? y->below : y->above].pos;
            sum += (p > q) - (p < q);
        }
    return sum;
}

// Whether item i has few enough links (DEGREE) to be swapped.
static bool has_few_links(const Layout *l, uint32_t i)
{
    return l->above.first[i + 1] - l->above.first[i] <= DEGREE && l->below.first[i + 1] - l->below.first[i] <= DEGREE;
}

// One pass that exchanges adjacent items of a layer wherever fewer links cross afterwards; items with many links stay.
static void swap_neighbours(Layout *l)
{
    for (uint32_t y = 0; y < l->layers; y++)
        for (uint32_t p = 0; p + 1 < l->layer[y].n; p++) {
            uint32_t *pair = l->layer[y].item + p, i = pair[0], j = pair[1];
            if (!has_few_links(l, i) || !has_few_links(l, j) ||
                crossings_saved(l, &l->above, false, i, j) + crossings_saved(l, &l->below, true, i, j) <= 0)
                continue;
            pair[0] = j;
            pair[1] = i;
            l->item.at[j].pos = p;
            l->item.at[i].pos = p + 1;
        }
}

// ---- the best order ----

// Stores the position of each item in its layer in `pos`, by item.
static void save_order(const Layout *l, uint32_t *pos)
{
    for (size_t i = 0; i < l->item.n; i++)
        pos[i] = l->item.at[i].pos;
}

static void restore_order(Layout *l, const uint32_t *pos)
{
    for (uint32_t i = 0; i < l->item.n; i++) {
        l->item.at[i].pos = pos[i];
        l->layer[l->item.at[i].layer].item[pos[i]] = i;
    }
}

void layout_order_items(Layout *l)
{
    uint32_t *best = ARENA_ARRAY(l->arena, uint32_t, l->item.n), idle = 0;
    OrderKey *key = ARENA_ARRAY(l->arena, OrderKey, l->item.n);
    uint64_t fewest;

    l->sums = ARENA_ARRAY(l->arena, uint64_t, l->item.n + 1);
    set_initial_order(l);
    fewest = all_crossings(l);
    save_order(l, best);
    for (int s = 0; s < SWEEPS && idle < PATIENCE && fewest > 0; s++) {
        const bool down = s % 2 == 0;
        uint64_t n;
        for (uint32_t i = 1; i < l->layers; i++)
            sort_layer(l, &l->layer[down ? i : l->layers - 1 - i], down, key);
        swap_neighbours(l);
        swap_neighbours(l);
        idle++;
        if ((n = all_crossings(l)) < fewest) {
            fewest = n;
            idle = 0;
            save_order(l, best);
        }
    }
    restore_order(l, best);
    layout_sort_links(l);
    l->d->crossings = fewest;
}
