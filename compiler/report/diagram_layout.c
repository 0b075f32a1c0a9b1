// SPDX-License-Identifier: Apache-2.0
// The stages of a layout, and the items that they place.
#include "compiler/report/diagram_layout.h"

// ---- layers ----

enum {
    LABELS_W = 700,               // width of labels, in pixels, for which a band of labels gets one layer
    NODES_W = 900,                // width of states, in pixels, for which a band of states gets one layer
    ROWS = 8,                     // maximum number of layers of a band
    LABEL_SIDE = 10, BEND_SIDE = 7            // space on each side of a label's text, and of an edge that crosses a layer
};

// The states of a rank, or the labels between a rank and the next.  They occupy `rows` layers, the first of which is `layer`.
typedef struct Band {
    int64_t load;                 // total width of its states or labels
    uint32_t rows, layer;
    int64_t row_load[ROWS];       // by layer of the band: width of what is in it so far
} Band;

typedef struct Bands {
    Band *rank, *gap;             // bands of states, by rank; bands of labels, by the rank above them
    uint32_t *gap_of;             // by edge: index in `gap` of the band that has its label
} Bands;

static uint32_t top_rank(const Layout *l, const DiagramEdge *e) { return l->rank[e->up ? e->to : e->from]; }
static uint32_t bottom_rank(const Layout *l, const DiagramEdge *e) { return l->rank[e->up ? e->from : e->to]; }

static int32_t label_width_with_margins(const DiagramEdge *e) { return e->label.w + 2 * LABEL_SIDE + diagram_mark_width(e); }

// Returns the gap with the least load among those between an edge's ends; if several are equal, the one nearest to the edge's start.
static uint32_t find_least_filled_gap(const Layout *l, const Bands *b, const DiagramEdge *e)
{
    const uint32_t top = top_rank(l, e), n = bottom_rank(l, e) - top;
    uint32_t best = e->up ? top + n - 1 : top;

    for (uint32_t i = 0; i < n; i++) {
        const uint32_t gap = e->up ? top + n - 1 - i : top + i;
        if (b->gap[gap].load < b->gap[best].load)
            best = gap;
    }
    return best;
}

// Chooses a gap for the label of each edge.  Edges that cross only one gap come first, because they have no choice.
static void assign_gaps(const Layout *l, Bands *b)
{
    for (int is_long = 0; is_long < 2; is_long++)         // first the edges that cross only one gap
        for (size_t e = 0; e < l->d->edge.n; e++) {
            const DiagramEdge *edge = &l->d->edge.at[e];
            if (edge->form != EDGE_LINE || (bottom_rank(l, edge) - top_rank(l, edge) > 1) != is_long)
                continue;
            b->gap_of[e] = find_least_filled_gap(l, b, edge);
            b->gap[b->gap_of[e]].load += label_width_with_margins(edge);
        }
}

// Gives a band as many layers as its total width requires, at most ROWS.  `most`: the width of one layer.
static void create_band_layers(Layout *l, Band *band, int64_t most)
{
    const int64_t rows = (band->load + most - 1) / most;

    band->rows = (uint32_t)(rows > ROWS ? ROWS : rows);
    band->layer = l->layers;
    l->layers += band->rows;
}

// Returns the least filled layer of a band and adds `room` to its width.
static uint32_t choose_layer(Band *band, int32_t room)
{
    uint32_t best = 0;

    for (uint32_t r = 1; r < band->rows; r++)
        if (band->row_load[r] < band->row_load[best])
            best = r;
    band->row_load[best] += room;
    return band->layer + best;
}

// ---- items ----

// Adds an item to a layer and returns its number.  `ref`: the node or edge that it stands for.
static uint32_t add_item(Layout *l, ItemKind kind, uint32_t ref, uint32_t layer)
{
    LayoutItem i = {kind, ref, layer, 0, BEND_SIDE, BEND_SIDE, 0, 0};

    if (kind == ITEM_LABEL) {
        i.left = l->d->edge.at[ref].label.w / 2 + LABEL_SIDE;
        i.right = i.left + diagram_mark_width(&l->d->edge.at[ref]);
        i.h = l->d->edge.at[ref].label.h + 4;
    }
    l->layer[layer].n++;
    vec_push(l->arena, &l->item, i);
    return (uint32_t)l->item.n - 1;
}

// Adds the items of nodes and their widths to the bands.  Their layers are not known yet.
static void add_node_items(Layout *l, Bands *b)
{
    uint32_t *above = ARENA_ARRAY(l->arena, uint32_t, l->d->nodes), *below = ARENA_ARRAY(l->arena, uint32_t, l->d->nodes);

    for (size_t e = 0; e < l->d->edge.n; e++) {
        const DiagramEdge *edge = &l->d->edge.at[e];
        if (edge->form != EDGE_LINE)
            continue;
        below[edge->up ? edge->to : edge->from]++;
        above[edge->up ? edge->from : edge->to]++;
    }
    for (uint32_t n = 0; n < l->d->nodes; n++) {
        LayoutItem i = {ITEM_NODE, n, 0, 0, 0, 0, 0, 0};
        layout_size_node(l->d, n, above[n] > below[n] ? above[n] : below[n], &i);
        b->rank[l->rank[n]].load += i.left + i.right;
        vec_push(l->arena, &l->item, i);
    }
}

// Creates the layers of all bands, now that their widths are known, and chooses a layer for each node.
static void assign_layers(Layout *l, Bands *b)
{
    for (uint32_t r = 0; r < l->ranks; r++) {
        create_band_layers(l, &b->rank[r], NODES_W);
        create_band_layers(l, &b->gap[r], LABELS_W);
    }
    l->layer = ARENA_ARRAY(l->arena, Layer, l->layers);
    for (uint32_t n = 0; n < l->d->nodes; n++) {
        LayoutItem *i = &l->item.at[n];
        i->layer = choose_layer(&b->rank[l->rank[n]], i->left + i->right);
        l->layer[i->layer].n++;
    }
}

// Adds an item in each layer between an edge's ends, and the links between them.  `label`: the layer of its label.
static void add_edge_items(Layout *l, uint32_t edge, uint32_t label)
{
    const DiagramEdge *e = &l->d->edge.at[edge];
    const uint32_t bottom = e->up ? e->from : e->to;
    uint32_t above = e->up ? e->to : e->from;

    for (uint32_t layer = l->item.at[above].layer + 1; layer <= l->item.at[bottom].layer; layer++) {
        LayoutLink link = {above, bottom, edge, false};
        if (layer < l->item.at[bottom].layer)
            link.below = add_item(l, layer == label ? ITEM_LABEL : ITEM_BEND, edge, layer);
        above = link.below;
        vec_push(l->arena, &l->link, link);
    }
}

void layout_create_items(Layout *l)
{
    Bands b = {ARENA_ARRAY(l->arena, Band, l->ranks), ARENA_ARRAY(l->arena, Band, l->ranks),
               ARENA_ARRAY(l->arena, uint32_t, l->d->edge.n + 1)};

    add_node_items(l, &b);
    assign_gaps(l, &b);
    assign_layers(l, &b);
    l->first_link = ARENA_ARRAY(l->arena, uint32_t, l->d->edge.n + 1);
    for (uint32_t e = 0; e < l->d->edge.n; e++) {
        const DiagramEdge *edge = &l->d->edge.at[e];
        l->first_link[e] = (uint32_t)l->link.n;
        if (edge->form == EDGE_LINE)
            add_edge_items(l, e, choose_layer(&b.gap[b.gap_of[e]], label_width_with_margins(edge)));
    }
    l->first_link[l->d->edge.n] = (uint32_t)l->link.n;
    for (uint32_t i = 0; i < l->layers; i++) {
        l->layer[i].item = ARENA_ARRAY(l->arena, uint32_t, l->layer[i].n);
        l->layer[i].n = 0;        // layout_order_items adds them again, in their order
    }
}

// ---- links: the parts of edges between two layers ----

// Computes LayoutLinks.first of both directions: counts the links of each item, then forms prefix sums.
static void compute_first_links(const Layout *l, uint32_t *above, uint32_t *below)
{
    for (size_t k = 0; k < l->link.n; k++) {
        above[l->link.at[k].below + 1]++;
        below[l->link.at[k].above + 1]++;
    }
    for (size_t i = 0; i < l->item.n; i++) {
        above[i + 1] += above[i];
        below[i + 1] += below[i];
    }
}

// Copies the links in `from` to the lists of the items at their other ends.  It visits items in the order of the layers, so each list becomes
// sorted by that order.
static void sort_links_by_end(const Layout *l, const LayoutLinks *from, bool down, uint32_t *next, uint32_t *to)
{
    for (uint32_t y = 0; y < l->layers; y++)
        for (uint32_t p = 0; p < l->layer[y].n; p++) {
            const uint32_t i = l->layer[y].item[p];
            for (uint32_t k = from->first[i]; k < from->first[i + 1]; k++) {
                const LayoutLink *link = &l->link.at[from->at[k]];
                to[next[down ? link->below : link->above]++] = from->at[k];
            }
        }
}

// Lists each item's links to the layer above and to the layer below, as ranges of one array: those of item i begin at first[i], and end before
// first[i + 1].
static void build_link_lists(Layout *l)
{
    uint32_t *next = ARENA_ARRAY(l->arena, uint32_t, l->item.n + 1);

    l->above.first = ARENA_ARRAY(l->arena, uint32_t, l->item.n + 1);
    l->below.first = ARENA_ARRAY(l->arena, uint32_t, l->item.n + 1);
    l->above.at = ARENA_ARRAY(l->arena, uint32_t, l->link.n + 1);
    l->below.at = ARENA_ARRAY(l->arena, uint32_t, l->link.n + 1);
    compute_first_links(l, l->above.first, l->below.first);
    for (size_t i = 0; i < l->item.n; i++)
        next[i] = l->below.first[i];
    for (uint32_t k = 0; k < l->link.n; k++)
        l->below.at[next[l->link.at[k].above]++] = k;
    l->next = next;
}

// Sorts `above` and `below` by the current order.
void layout_sort_links(Layout *l)
{
    for (size_t i = 0; i < l->item.n; i++)
        l->next[i] = l->above.first[i];
    sort_links_by_end(l, &l->below, true, l->next, l->above.at);
    for (size_t i = 0; i < l->item.n; i++)
        l->next[i] = l->below.first[i];
    sort_links_by_end(l, &l->above, false, l->next, l->below.at);
}

// ---- the whole layout ----

// Runs all stages: fills in the boxes and paths of the diagram.
void layout_diagram(Diagram *d)
{
    Layout *l = ARENA_NEW(d->a->arena, Layout);

    l->arena = d->a->arena;
    l->d = d;
    layout_stub_hubs(d);
    layout_assign_ranks(l);
    layout_create_items(l);
    build_link_lists(l);
    layout_order_items(l);
    layout_place_items(l);
    layout_route_edges(l);
}
