// SPDX-License-Identifier: Apache-2.0
// Gives every state, guard and line of a diagram its place: the layers of Sugiyama, Tagawa and Toda (1981), in whole pixels.
//
//   rank    every state gets a rank; edges lead from a rank to a later one, those that close a circle are turned round
//   items   ranks become layers, with layers for guards between them; a long edge has an item in every layer that it crosses
//   order   the order within each layer, for few crossings
//   place   x, for straight lines (Brandes and Köpf, 2001); then y
//   route   where lines leave, bend and arrive
//
// Guards are items like states, so nothing can lie on anything else; lines bend between layers only, where nothing stands.
// What would be a tangle of lines is a stub: edges to a state that many lead to, and edges across many ranks.
// Every stage is linear in items, times a bounded number of sweeps.
#ifndef SMC_LAYOUT_H
#define SMC_LAYOUT_H

#include "compiler/emit/report/diagram.h"

typedef enum ItemKind {
    ITEM_NODE,                    // a state with the stubs beside it
    ITEM_LABEL,                   // the guards of an edge
    ITEM_BEND                     // where an edge crosses a layer
} ItemKind;

typedef struct Item {
    ItemKind kind;
    uint32_t ref;                 // NODE: Diagram.node; else Diagram.edge
    uint32_t layer, pos;          // pos: its place in the layer's order
    int32_t left, right, h;       // how far it reaches from its x; h: centred in its layer
    int32_t x;
} Item;

// From an item to one in the next layer.
typedef struct Link {
    uint32_t above, below;        // items
    uint32_t edge;
    bool crossed;                 // by the straight part of a longer edge: it will not be straight itself
} Link;

typedef struct Layer {
    uint32_t *item;               // in order
    uint32_t n;
    int32_t y, h;
} Layer;

// The links of each item, in the order of the items at their other ends.
typedef struct Links {
    uint32_t *first;              // by item: at[first[i]] … at[first[i + 1] - 1]
    uint32_t *at;
} Links;

typedef struct Layout {
    Arena *arena;
    Diagram *d;
    uint32_t *rank;               // by node
    uint32_t ranks;
    bool *spine;                  // by edge: it should be straight, from end to end
    VEC(Item) item;               // first the nodes, then the others
    VEC(Link) link;               // of an edge one after the other, downwards
    uint32_t *first_link;         // by edge, and the end of the last one
    Layer *layer;
    uint32_t layers;
    Links above, below;
    uint32_t *next;               // by item: for layout_sort_links
    uint64_t *sums;               // for layout_crossings
} Layout;

// The whole: fills in the boxes and ways of the diagram.
//
// An edge's way begins and ends at its states.  Its points are joined by a vertical line, a curve, a vertical line … a vertical
// line; the line on which the label stands has it between its points.
void layout_diagram(Diagram *d);

// ---- the stages ----

void layout_stub_hubs(Diagram *d);        // before rank: edges to states that many lead to
void layout_rank(Layout *l);              // `rank`, DiagramEdge.up; edges across many ranks become stubs
void layout_size_node(Diagram *d, uint32_t node, uint32_t lines, Item *out);
void layout_items(Layout *l);
void layout_order(Layout *l);
void layout_sort_links(Layout *l);        // `above` and `below`, for the order there is
uint64_t layout_crossings(const Layout *l, uint32_t layer);       // between a layer and the next
void layout_place(Layout *l);
void layout_route(Layout *l);

#endif
