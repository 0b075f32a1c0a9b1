// SPDX-License-Identifier: Apache-2.0
// Computes boxes and paths from the order and x of items: the distance between layers, the stubs beside a state, and the ports (the points
// where edges meet a state).
#include "compiler/report/diagram_layout.h"

enum {                            // lengths in pixels
    MARGIN = 16,                  // around the whole picture
    NODE_SIDE = 16, NODE_LEAST = 76,          // space beside the name in a state's box; least width of the box
    PORT = 14,                    // minimum distance between two ports of a state
    START_H = 26,                 // height of the mark above the first state
    STUB_AT = 26, STUB_SIDE = 8,  // distance from the state to a stub's name; space on both sides of the name
    STUB_GAP = 6, STUB_TEXT = 6,  // distance between two stubs; between a stub's name and its guards
    FROM_AT = 28,                 // distance from the text "from 5 states" to the state
    GAP = 18, GAP_MOST = 70       // least and greatest distance between layers
};

// ---- beside a state ----

// Whether the edge is drawn beside its state: a stub (a short arrow to the other state's name) or a loop.
static bool is_drawn_beside_state(const DiagramEdge *e) { return e->form != EDGE_LINE; }

// Width of the box with the target's name at the end of a stub; 0 for a loop, which has no such box.
static int32_t stub_name_width(const Diagram *d, const DiagramEdge *e)
{
    return e->form == EDGE_LOOP ? 0 : d->node[e->to].name_w * GUARD_SIZE / NAME_SIZE + 1 + 2 * STUB_SIDE;
}

static int32_t stub_height(const DiagramEdge *e) { return e->label.h > STUB_H ? e->label.h : STUB_H; }

typedef struct StubRows { int32_t name_w, label_w, h; } StubRows;

// The widest name, the widest label and the total height of the loops and stubs beside state n.
static StubRows measure_stub_columns(const Diagram *d, const DiagramNode *n)
{
    StubRows r = {0, 0, -STUB_GAP};

    for (uint32_t k = 0; k < n->edges; k++) {
        const DiagramEdge *e = &d->edge.at[n->first_edge + k];
        if (!is_drawn_beside_state(e))
            continue;
        r.name_w = stub_name_width(d, e) > r.name_w ? stub_name_width(d, e) : r.name_w;
        r.label_w = e->label.w + diagram_mark_width(e) > r.label_w ? e->label.w + diagram_mark_width(e) : r.label_w;
        r.h += stub_height(e) + STUB_GAP;
    }
    return r;
}

// Returns the width of a state's box: enough for its name, its actions and `lines` ports. It is even.
static int32_t node_width(const DiagramNode *n, uint32_t lines)
{
    const int32_t name = n->name_w + 2 * NODE_SIDE, actions = n->action.n ? n->action_w + 2 * ACTION_SIDE : 0;
    const int32_t text = name > actions ? name : actions, ports = (int32_t)(lines + 1) * PORT, w = text > ports ? text : ports;

    return ((w > NODE_LEAST ? w : NODE_LEAST) + 1) & ~1;
}

// Sets the width of the state's box in n->box, and the size with everything beside it in `out`.
void layout_size_node(Diagram *d, uint32_t node, uint32_t lines, LayoutItem *out)
{
    DiagramNode *n = &d->node[node];
    const StubRows r = measure_stub_columns(d, n);

    n->box.w = node_width(n, lines);
    n->box.h = NAME_H + (n->action.n ? (int32_t)n->action.n * GUARD_LINE + ACTION_BOTTOM : 0);
    out->left = out->right = n->box.w / 2;
    out->h = n->box.h;
    if (n->all) {
        out->right += 2 * STACK;
        out->h += 4 * STACK;                  // the box is in the middle of the height
    }
    if (r.h > out->h)
        out->h = r.h;
    if (r.h > 0)
        out->right += STUB_AT + r.name_w + STUB_TEXT + r.label_w;
    if (n->from)
        out->left += FROM_AT + n->from_w;
}

// Places the loops and stubs of state n in rows to the right of its box, centred on it; the labels start at a common x.
static void place_stubs(Diagram *d, const DiagramNode *n)
{
    const StubRows r = measure_stub_columns(d, n);
    int32_t y = n->box.y + (n->box.h - r.h) / 2;

    for (uint32_t k = 0; k < n->edges; k++) {
        DiagramEdge *e = &d->edge.at[n->first_edge + k];
        if (!is_drawn_beside_state(e))
            continue;
        e->name = (Box){n->box.x + n->box.w + STUB_AT, y + (stub_height(e) - STUB_H) / 2, stub_name_width(d, e), STUB_H};
        e->label.x = e->name.x + r.name_w + STUB_TEXT;
        e->label.y = y + (stub_height(e) - e->label.h) / 2;
        y += stub_height(e) + STUB_GAP;
    }
}

// ---- ports: the points where edges meet a state ----

// Places each port as near to the other end of its edge as the state's width allows, and at least PORT from the next.
static void spread_ports(const Layout *l, const LayoutItem *i, const LayoutLinks *links, uint32_t item, bool below, int32_t *port)
{
    const uint32_t first = links->first[item], n = links->first[item + 1] - first;
    const int32_t half = l->d->node[i->ref].box.w / 2 - PORT / 2 - 2;

    for (uint32_t k = 0; k < n; k++) {
        const LayoutLink *link = &l->link.at[links->at[first + k]];
        const int32_t to = l->item.at[below ? link->below : link->above].x, low = i->x - half + (int32_t)k * PORT;
        int32_t x = to < low ? to < i->x - half ? low : low : to;
        if (k > 0 && x < port[links->at[first + k - 1]] + PORT)
            x = port[links->at[first + k - 1]] + PORT;
        port[links->at[first + k]] = x;
    }
    for (uint32_t k = n; k-- > 0;) {
        const int32_t high = i->x + half - (int32_t)(n - 1 - k) * PORT;
        int32_t *x = &port[links->at[first + k]];
        if (*x > high)
            *x = high;
    }
}

// Computes the x of both ends of every link: top[k] where link k leaves the upper item, bottom[k] where it enters the lower one.
static void find_ports(const Layout *l, int32_t *top, int32_t *bottom)
{
    for (uint32_t i = 0; i < l->item.n; i++) {
        const LayoutItem *item = &l->item.at[i];
        if (item->kind == ITEM_NODE) {
            spread_ports(l, item, &l->above, i, false, bottom);
            spread_ports(l, item, &l->below, i, true, top);
        }
    }
    for (uint32_t k = 0; k < l->link.n; k++) {
        const LayoutItem *above = &l->item.at[l->link.at[k].above], *below = &l->item.at[l->link.at[k].below];
        if (above->kind != ITEM_NODE)
            top[k] = above->x;
        if (below->kind != ITEM_NODE)
            bottom[k] = below->x;
    }
}

// ---- layers from top to bottom ----

// Sets the y and height of each layer. The gap below a layer grows with the longest horizontal distance of its links, so that they do not get too
// flat. `top`, `bottom`: x of both ends of each link.
static void place_layers(Layout *l, const int32_t *top, const int32_t *bottom)
{
    int32_t *far = ARENA_ARRAY(l->arena, int32_t, l->layers), y = MARGIN + START_H;

    for (uint32_t k = 0; k < l->link.n; k++) {
        const uint32_t layer = l->item.at[l->link.at[k].above].layer;
        const int32_t dx = top[k] > bottom[k] ? top[k] - bottom[k] : bottom[k] - top[k];
        far[layer] = dx > far[layer] ? dx : far[layer];
    }
    for (uint32_t i = 0; i < l->layers; i++) {
        Layer *layer = &l->layer[i];
        int32_t gap;
        for (uint32_t p = 0; p < layer->n; p++)
            if (l->item.at[layer->item[p]].h > layer->h)
                layer->h = l->item.at[layer->item[p]].h;
        layer->y = y;
        gap = far[i] / 8 > GAP_MOST - GAP ? GAP_MOST : GAP + far[i] / 8;
        y += layer->h + gap;
        vec_push(l->arena, &l->d->cut, y - gap / 2);
    }
}

// Shifts all items to begin at the left margin, sets the boxes of states and labels, and sets the size of the picture.
static void set_item_boxes(Layout *l)
{
    int32_t left = INT32_MAX, right = INT32_MIN;
    const Layer *last = &l->layer[l->layers - 1];

    for (uint32_t i = 0; i < l->item.n; i++) {
        const LayoutItem *item = &l->item.at[i];
        left = item->x - item->left < left ? item->x - item->left : left;
        right = item->x + item->right > right ? item->x + item->right : right;
    }
    for (uint32_t i = 0; i < l->item.n; i++) {
        LayoutItem *item = &l->item.at[i];
        const int32_t middle = l->layer[item->layer].y + l->layer[item->layer].h / 2;
        Box *box = item->kind == ITEM_NODE ? &l->d->node[item->ref].box : &l->d->edge.at[item->ref].label;
        item->x += MARGIN - left;
        if (item->kind == ITEM_BEND)
            continue;
        box->x = item->x - box->w / 2;
        box->y = middle - box->h / 2;
        if (item->kind == ITEM_NODE)
            place_stubs(l->d, &l->d->node[item->ref]);
    }
    l->d->w = right - left + 2 * MARGIN;
    l->d->h = last->y + last->h + MARGIN;
}

// ---- paths ----

static void add_point(Layout *l, DiagramEdge *e, int32_t x, int32_t y)
{
    Point p = {x, y};

    vec_push(l->arena, &e->path, p);
}

// Computes the path of an edge from top to bottom: out of the upper state, through each layer, into the lower state.
static void route_down(Layout *l, DiagramEdge *e, uint32_t first, uint32_t end, const int32_t *top, const int32_t *bottom)
{
    for (uint32_t k = first; k < end; k++) {
        const LayoutItem *above = &l->item.at[l->link.at[k].above], *below = &l->item.at[l->link.at[k].below];
        const Layer *from = &l->layer[above->layer], *to = &l->layer[below->layer];
        if (k == first) {
            add_point(l, e, top[k], l->d->node[above->ref].box.y + l->d->node[above->ref].box.h);
            add_point(l, e, top[k], from->y + from->h);
        }
        add_point(l, e, bottom[k], to->y);
        add_point(l, e, bottom[k], k + 1 < end ? to->y + to->h : l->d->node[below->ref].box.y);
    }
}

static void reverse_path(DiagramEdge *e)
{
    for (size_t i = 0; i < e->path.n / 2; i++) {
        const Point p = e->path.at[i];
        e->path.at[i] = e->path.at[e->path.n - 1 - i];
        e->path.at[e->path.n - 1 - i] = p;
    }
}

void layout_route_edges(Layout *l)
{
    int32_t *top = ARENA_ARRAY(l->arena, int32_t, l->link.n + 1), *bottom = ARENA_ARRAY(l->arena, int32_t, l->link.n + 1);

    find_ports(l, top, bottom);
    place_layers(l, top, bottom);
    set_item_boxes(l);
    find_ports(l, top, bottom);               // again, because all items have been shifted by the same distance
    for (uint32_t e = 0; e < l->d->edge.n; e++) {
        DiagramEdge *edge = &l->d->edge.at[e];
        route_down(l, edge, l->first_link[e], l->first_link[e + 1], top, bottom);
        if (edge->up)
            reverse_path(edge);
    }
}
