// SPDX-License-Identifier: Apache-2.0
// Places every state, guard and edge of a diagram, in layers after Sugiyama, Tagawa and Toda (1981), in whole pixels.
//
//   rank    assigns every state a rank; edges lead from a rank to a later one, and edges that close a cycle are reversed
//   items   ranks become layers, with layers for guards between them; a long edge has an item in every layer that it crosses
//   order   the order within each layer, for few crossings
//   place   x, for straight lines (Brandes and Köpf, 2001); then y
//   route   the points where edges leave a state, bend and arrive
//
// Guards get places in layers as states do, so nothing overlaps.  Edges bend only between layers, where there are no items.  Edges that would form a
// tangle of lines become stubs: edges to a state with many predecessors, and edges across many ranks.  Every stage is linear in the number
// of items, times a bounded number of sweeps.
#ifndef SMC_DIAGRAM_LAYOUT_H
#define SMC_DIAGRAM_LAYOUT_H

#include "compiler/report/diagram_model.h"

typedef enum ItemKind {
    ITEM_NODE,                    // a state with the stubs beside it
    ITEM_LABEL,                   // the guards of an edge
    ITEM_BEND                     // the crossing of an edge through a layer
} ItemKind;

typedef struct LayoutItem {
    ItemKind kind;
    uint32_t ref;                 // ITEM_NODE: index in Diagram.node; otherwise index in Diagram.edge
    uint32_t layer, pos;          // pos: its position in the layer
    int32_t left, right, h;       // left, right: how far the item extends from x; h: its height, centred in its layer
    int32_t x;                    // horizontal position, in pixels
} LayoutItem;

// A part of an edge, from an item to one in the next layer.
typedef struct LayoutLink {
    uint32_t above, below;        // the two items that the link connects
    uint32_t edge;                // index in Diagram.edge
    bool crossed;                 // the link crosses one that should be straight, so this link is not drawn straight
} LayoutLink;

typedef struct Layer {
    uint32_t *item;               // the items of the layer, from left to right
    uint32_t n;
    int32_t y, h;                 // y of its upper edge; height
} Layer;

// The links of each item, ordered by the items at their other ends.
typedef struct LayoutLinks {
    uint32_t *first;              // by item: its links are at[first[i]] … at[first[i + 1] - 1]
    uint32_t *at;                 // indices in Layout.link
} LayoutLinks;

typedef struct Layout {
    Arena *arena;
    Diagram *d;
    uint32_t *rank;               // by index in Diagram.node: its rank, from 0 at the top
    uint32_t ranks;
    bool *spine;                  // by edge: it is part of the spine (diagram_rank.c) and should be straight from end to end
    VEC(LayoutItem) item;         // first the nodes, then the other items
    VEC(LayoutLink) link;         // the links of an edge are consecutive, from top to bottom
    uint32_t *first_link;         // by edge: index of its first link; then one more entry, the number of links
    Layer *layer;
    uint32_t layers;
    LayoutLinks above, below;     // links of each item to the layer above it, and to the layer below it
    uint32_t *next;               // by item: temporary memory of layout_sort_links
    uint64_t *sums;               // temporary memory of layout_count_crossings
} Layout;

// Runs all stages: fills in the boxes and paths of the diagram.
//
// An edge's path starts and ends at its states.  Its points are joined by alternating vertical lines and curves, with a vertical line first
// and last.  The label is on one of the vertical lines, between its points.
void layout_diagram(Diagram *d);

enum { NAME_H = 34, ACTION_SIDE = 13, ACTION_BOTTOM = 8 };   // in a state's box: height of the name; space beside and below the actions
enum { STACK = 3 };               // distance of each of the two boxes behind that of [all_states], to the right and upwards

// ---- the stages ----

void layout_stub_hubs(Diagram *d);        // before rank: edges to states with many predecessors become stubs
void layout_assign_ranks(Layout *l);              // sets `rank` and DiagramEdge.up; edges across many ranks become stubs
// Sets the size of a state's box, and in `out` that of its item.  lines: the most edges that meet its upper or its lower side.
void layout_size_node(Diagram *d, uint32_t node, uint32_t lines, LayoutItem *out);
void layout_create_items(Layout *l);
void layout_order_items(Layout *l);
void layout_sort_links(Layout *l);        // sorts `above` and `below` by the current order
uint64_t layout_count_crossings(const Layout *l, uint32_t layer);       // counts crossings between this layer and the next
void layout_place_items(Layout *l);
void layout_route_edges(Layout *l);

#endif
