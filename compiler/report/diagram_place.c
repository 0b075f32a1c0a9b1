// SPDX-License-Identifier: Apache-2.0
// Horizontal positions of items, after Brandes and Köpf (2001).  Items are aligned in columns four times: from above and from below,
// preferring left and right.  Each alignment is as narrow as possible.  The final position is the mean of the two middle ones.
#include <string.h>

#include "compiler/report/diagram_layout.h"

enum { APART = 14 };              // minimum gap between neighbours in a layer

// One of the four alignments.  `mirrored`: left and right are exchanged, so that columns are always packed to the left.
typedef struct Columns {
    Layout *l;
    bool from_below, mirrored;
    const LayoutLink **above, **below;  // by item: the link to the layer above (below) that should be straight; or NULL
    uint32_t *root;               // by item: the item that represents its column
    uint32_t *next;               // by item: the next item in its column; the last is followed by the first
    int64_t *x;                   // by item: the x of its centre, once columns are placed
} Columns;

// ---- links that can be straight ----

// True for the inner parts of a long edge, and for all parts of an edge of the spine.
static bool should_be_straight(const Layout *l, const LayoutLink *k)
{
    return l->spine[k->edge] || (l->item.at[k->above].kind != ITEM_NODE && l->item.at[k->below].kind != ITEM_NODE);
}

// Returns, by item, the first link above (or below) that should be straight; NULL if no such link should be straight.
static const LayoutLink **find_straight_links(const Layout *l, const LayoutLinks *links)
{
    const LayoutLink **out = ARENA_ARRAY(l->arena, const LayoutLink *, l->item.n);

    for (size_t i = 0; i < l->item.n; i++)
        for (uint32_t k = links->first[i]; k < links->first[i + 1] && !out[i]; k++)
            if (should_be_straight(l, &l->link.at[links->at[k]]))
                out[i] = &l->link.at[links->at[k]];
    return out;
}

static int64_t position_in_layer(const Layout *l, uint32_t item) { return l->item.at[item].pos; }

// Marks links between layers y and y + 1 that cross a link that should be straight.  Two crossing links that should both be straight are
// not marked.
static void mark_conflicts(Layout *l, uint32_t y, const LayoutLink *const *above)
{
    const Layer *lower = &l->layer[y + 1];
    int64_t left = -1;
    uint32_t start = 0;

    for (uint32_t p = 0; p < lower->n; p++) {
        const LayoutLink *inner = above[lower->item[p]];
        int64_t right = l->layer[y].n;
        if (!inner && p + 1 < lower->n)
            continue;
        if (inner)
            right = position_in_layer(l, inner->above);
        for (; start <= p; start++)
            for (uint32_t k = l->above.first[lower->item[start]]; k < l->above.first[lower->item[start] + 1]; k++) {
                LayoutLink *link = &l->link.at[l->above.at[k]];
                const int64_t at = position_in_layer(l, link->above);
                link->crossed = link->crossed || ((at < left || at > right) && !should_be_straight(l, link));
            }
        left = right;
    }
}

// ---- columns ----

// Returns item k of a layer, counted from the right if mirrored.
static uint32_t item_in_layer(const Columns *c, const Layer *layer, uint32_t k)
{
    return layer->item[c->mirrored ? layer->n - 1 - k : k];
}

// Adds an item to the column of the neighbour at the other end of `link`.  Columns must not cross: *used is the position of the neighbour chosen
// last, and false is returned if this neighbour is not to the right of it.
static bool try_align(Columns *c, uint32_t item, const LayoutLink *link, int64_t *used)
{
    const uint32_t to = c->from_below ? link->below : link->above;
    const int64_t at = c->mirrored ? -position_in_layer(c->l, to) : position_in_layer(c->l, to);

    if (link->crossed || at <= *used)
        return false;
    c->next[to] = item;
    c->root[item] = c->root[to];
    c->next[item] = c->root[item];
    *used = at;
    return true;
}

// Adds an item to the column of the neighbour to which its link should be straight, otherwise of its median neighbour.  Of two medians the
// left one is tried first.  A neighbour that should itself be aligned with another item is skipped.
static void align_item(Columns *c, uint32_t item, int64_t *used)
{
    const Layout *l = c->l;
    const LayoutLinks *links = c->from_below ? &l->below : &l->above;
    const uint32_t first = links->first[item], n = links->first[item + 1] - first;
    const LayoutLink *inner = (c->from_below ? c->below : c->above)[item];

    if (inner && try_align(c, item, inner, used))
        return;
    for (uint32_t k = 0; k < 2 && n > 0; k++) {
        const uint32_t m = (k == 0) != c->mirrored ? (n - 1) / 2 : n / 2;
        const LayoutLink *link = &l->link.at[links->at[first + m]], *theirs = c->from_below ? c->above[link->below] : c->below[link->above];
        if ((!theirs || theirs == link) && try_align(c, item, link, used))
            return;
    }
}

// Joins items of consecutive layers into vertical columns; each item starts as a column of its own. `from_below` selects the direction of the pass.
static void align_columns(Columns *c)
{
    const uint32_t n = c->l->layers;

    for (uint32_t i = 0; i < c->l->item.n; i++)
        c->root[i] = c->next[i] = i;
    for (uint32_t i = 1; i < n; i++) {
        const Layer *layer = &c->l->layer[c->from_below ? n - 1 - i : i];
        int64_t used = INT32_MIN;
        for (uint32_t k = 0; k < layer->n; k++)
            align_item(c, item_in_layer(c, layer, k), &used);
    }
}

// ---- distances ----

// A constraint on two columns with neighbours in a layer: column `from` must be at least `apart` left of column `to`.
typedef struct Separation { uint32_t from, to; int64_t apart; } Separation;

typedef struct Separations {
    uint32_t *first;              // by column: the separations in which it is `from` are at[first[c]] … at[first[c + 1] - 1]
    Separation *at;
} Separations;

// Width of the item from its centre to its right or left edge, as the current pass sees it: a mirrored pass exchanges the sides.
static int32_t half_width(const Columns *c, uint32_t item, bool right)
{
    const LayoutItem *i = &c->l->item.at[item];

    return right != c->mirrored ? i->right : i->left;
}

// Returns the separation that items k and k + 1 of a layer require of their columns.
static Separation separation_at(const Columns *c, const Layer *layer, uint32_t k)
{
    const uint32_t a = item_in_layer(c, layer, k), b = item_in_layer(c, layer, k + 1);
    Separation s = {c->root[a], c->root[b], (int64_t)half_width(c, a, true) + half_width(c, b, false) + APART};

    return s;
}

// Returns the separations of all neighbours, sorted by the left column with a counting sort.
static Separations find_separations(const Columns *c)
{
    const Layout *l = c->l;
    Separations s = {ARENA_ARRAY(l->arena, uint32_t, l->item.n + 2), ARENA_ARRAY(l->arena, Separation, l->item.n + 1)};

    for (uint32_t y = 0; y < l->layers; y++)
        for (uint32_t k = 0; k + 1 < l->layer[y].n; k++)
            s.first[separation_at(c, &l->layer[y], k).from + 2]++;
    for (size_t i = 2; i < l->item.n + 2; i++)
        s.first[i] += s.first[i - 1];
    for (uint32_t y = 0; y < l->layers; y++)
        for (uint32_t k = 0; k + 1 < l->layer[y].n; k++) {
            const Separation step = separation_at(c, &l->layer[y], k);
            s.at[s.first[step.from + 1]++] = step;
        }
    return s;
}

// Columns in topological order: each after those that must be left of it.
static uint32_t *sort_columns(const Columns *c, const Separations *s, uint32_t *n)
{
    const size_t items = c->l->item.n;
    uint32_t *order = ARENA_ARRAY(c->l->arena, uint32_t, items), *waits = ARENA_ARRAY(c->l->arena, uint32_t, items);

    for (uint32_t k = 0; k < s->first[items]; k++)
        waits[s->at[k].to]++;
    *n = 0;
    for (uint32_t i = 0; i < items; i++)
        if (c->root[i] == i && waits[i] == 0)
            order[(*n)++] = i;
    for (uint32_t i = 0; i < *n; i++)
        for (uint32_t k = s->first[order[i]]; k < s->first[order[i] + 1]; k++)
            if (--waits[s->at[k].to] == 0)
                order[(*n)++] = s->at[k].to;
    return order;
}

// Places columns as far left as possible.  Then columns with free space on their right move right, close to their neighbours.
static void place_columns(Columns *c)
{
    const Separations s = find_separations(c);
    uint32_t n, *order = sort_columns(c, &s, &n);

    for (uint32_t i = 0; i < n; i++)
        for (uint32_t k = s.first[order[i]]; k < s.first[order[i] + 1]; k++) {
            const Separation *step = &s.at[k];
            if (c->x[step->from] + step->apart > c->x[step->to])
                c->x[step->to] = c->x[step->from] + step->apart;
        }
    for (uint32_t i = n; i-- > 0;) {
        int64_t room = INT64_MAX;
        for (uint32_t k = s.first[order[i]]; k < s.first[order[i] + 1]; k++)
            if (c->x[s.at[k].to] - s.at[k].apart < room)
                room = c->x[s.at[k].to] - s.at[k].apart;
        if (room != INT64_MAX)
            c->x[order[i]] = room;
    }
    for (uint32_t i = 0; i < c->l->item.n; i++)
        c->x[i] = c->x[c->root[i]];
}

// ---- combining the four ----

typedef struct Extent { int64_t low, high; } Extent;

// The smallest and largest x that any item covers.
static Extent columns_extent(const Columns *c)
{
    Extent e = {INT64_MAX, INT64_MIN};

    for (uint32_t i = 0; i < c->l->item.n; i++) {
        const int64_t low = c->x[i] - half_width(c, i, false), high = c->x[i] + half_width(c, i, true);
        e.low = low < e.low ? low : e.low;
        e.high = high > e.high ? high : e.high;
    }
    return e;
}

// Undoes the mirroring.  Aligns the left edge of the alignment with that of the narrowest, or its right edge if it was mirrored.
static void shift_to_narrowest(Columns *c, int64_t width)
{
    const Extent e = columns_extent(c);

    for (uint32_t i = 0; i < c->l->item.n; i++)
        c->x[i] = c->mirrored ? width - (c->x[i] - e.low) : c->x[i] - e.low;
}

// Returns the mean of the second and third largest of four values.
static int32_t mean_of_middle_two(int64_t a, int64_t b, int64_t c, int64_t d)
{
    int64_t low = a, high = a;

    low = b < low ? b : low;
    low = c < low ? c : low;
    low = d < low ? d : low;
    high = b > high ? b : high;
    high = c > high ? c : high;
    high = d > high ? d : high;
    return (int32_t)((a + b + c + d - low - high) / 2);
}

void layout_place_items(Layout *l)
{
    const size_t n = l->item.n;
    int64_t *x[4], narrowest = INT64_MAX;
    Columns c = {l, false, false, find_straight_links(l, &l->above), find_straight_links(l, &l->below),
                 ARENA_ARRAY(l->arena, uint32_t, n), ARENA_ARRAY(l->arena, uint32_t, n), NULL};

    for (uint32_t y = 0; y + 1 < l->layers; y++)
        mark_conflicts(l, y, c.above);
    for (int k = 0; k < 4; k++) {
        Extent e;
        c.from_below = k & 1;
        c.mirrored = k & 2;
        c.x = x[k] = ARENA_ARRAY(l->arena, int64_t, n);
        align_columns(&c);
        place_columns(&c);
        e = columns_extent(&c);
        narrowest = e.high - e.low < narrowest ? e.high - e.low : narrowest;
    }
    for (int k = 0; k < 4; k++) {
        c.mirrored = k & 2;
        c.x = x[k];
        shift_to_narrowest(&c, narrowest);
    }
    for (size_t i = 0; i < n; i++)
        l->item.at[i].x = mean_of_middle_two(x[0][i], x[1][i], x[2][i], x[3][i]);
}
