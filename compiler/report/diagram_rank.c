// SPDX-License-Identifier: Apache-2.0
// Ranks of states: their vertical order.
#include <string.h>

#include "compiler/report/diagram_layout.h"

// ---- which edges are stubs ----

enum {
    HUB_ABORT = 3,                // with this many predecessors of an @abort state, all edges to it become stubs
    HUB = 6,                      // with this many predecessors of any other state, all edges to it become stubs
    LONGEST = 6                   // maximum number of ranks that a line can cross
};

// Draws the edge as a stub: a short arrow to the name of the target, with no line across the picture.
static void turn_into_stub(Diagram *d, uint32_t edge)
{
    DiagramEdge *e = &d->edge.at[edge];

    e->form = EDGE_STUB;
    vec_push(d->a->arena, &d->node[e->to].stub_in, edge);
}

static bool is_section_edge(const Diagram *d, const DiagramEdge *e) { return e->from >= d->states; }

// Turns edges to a state with many predecessors of one kind (a hub) into stubs: short arrows to the state's name instead of lines.  States
// and sections [all_states] are the two kinds, so one section has a line to the state that it goes to, however many states do as well.
static void stub_hubs_of(Diagram *d, bool sections)
{
    uint32_t *in = ARENA_ARRAY(d->a->arena, uint32_t, d->nodes);

    for (size_t e = 0; e < d->edge.n; e++)
        in[d->edge.at[e].to] += d->edge.at[e].form == EDGE_LINE && is_section_edge(d, &d->edge.at[e]) == sections;
    for (uint32_t e = 0; e < d->edge.n; e++) {
        const uint32_t to = d->edge.at[e].to;
        if (d->edge.at[e].form == EDGE_LINE && is_section_edge(d, &d->edge.at[e]) == sections &&
            in[to] >= (d->node[to].state->is_abort ? HUB_ABORT : HUB))
            turn_into_stub(d, e);
    }
}

void layout_stub_hubs(Diagram *d)
{
    stub_hubs_of(d, false);
    stub_hubs_of(d, true);
}

// ---- cycles ----

typedef struct SearchFrame { uint32_t node, next; } SearchFrame;  // next: number of its edges that have been followed

typedef struct BackEdgeSearch {
    Layout *l;
    char *state;                  // 0 not visited, 1 on the current path, 2 done
    VEC(SearchFrame) stack;      // the current path
} BackEdgeSearch;

// Puts a node on the current path of the depth-first search.
static void push_node(BackEdgeSearch *s, uint32_t node)
{
    SearchFrame v = {node, 0};

    s->state[node] = 1;
    vec_push(s->l->arena, &s->stack, v);
}

// Marks the edges that close cycles, by a depth-first search from `start` along the edges in file order.  An edge back to a state on the
// current path closes a cycle.  The first search begins at the first state, so every edge back to it closes a cycle, and it stays at the top.
static void search_cycles_from(BackEdgeSearch *s, uint32_t start)
{
    const Diagram *d = s->l->d;

    push_node(s, start);
    while (s->stack.n > 0) {
        SearchFrame *v = &s->stack.at[s->stack.n - 1];
        const DiagramNode *n = &d->node[v->node];
        DiagramEdge *e = &d->edge.at[n->first_edge + v->next];
        if (v->next++ == n->edges) {
            s->state[v->node] = 2;
            s->stack.n--;
        } else if (s->state[e->to] == 1 || e->to == 0)
            e->up = e->to != e->from;
        else if (s->state[e->to] == 0)
            push_node(s, e->to);
    }
}

// Depth-first search from each state. Edges that close a cycle or lead to the initial state are drawn upwards; all others point down.
static void break_cycles(Layout *l)
{
    BackEdgeSearch s = {l, ARENA_ARRAY(l->arena, char, l->d->nodes), {NULL, 0, 0}};

    for (uint32_t n = 0; n < l->d->nodes; n++)
        if (s.state[n] == 0)
            search_cycles_from(&s, n);
}

// ---- ranks ----

// Return the node at the upper, and at the lower end of an edge.
static uint32_t upper_end(const DiagramEdge *e) { return e->up ? e->to : e->from; }
static uint32_t lower_end(const DiagramEdge *e) { return e->up ? e->from : e->to; }

// By node, the edges whose upper (or lower) end the node is.  Only edges that are drawn as lines (EDGE_LINE) count.
typedef struct EdgesByEnd { uint32_t *first, *edge; } EdgesByEnd;

// Groups edges by the node that `end` returns, with a counting sort.
static EdgesByEnd sort_edges_by_end(const Layout *l, uint32_t (*end)(const DiagramEdge *e))
{
    const Diagram *d = l->d;
    EdgesByEnd out = {ARENA_ARRAY(l->arena, uint32_t, d->nodes + 2), ARENA_ARRAY(l->arena, uint32_t, d->edge.n + 1)};

    for (size_t e = 0; e < d->edge.n; e++)
        if (d->edge.at[e].form == EDGE_LINE)
            out.first[end(&d->edge.at[e]) + 2]++;
    for (size_t n = 2; n < d->nodes + 2; n++)
        out.first[n] += out.first[n - 1];
    for (uint32_t e = 0; e < d->edge.n; e++)
        if (d->edge.at[e].form == EDGE_LINE)
            out.edge[out.first[end(&d->edge.at[e]) + 1]++] = e;
    return out;
}

// Returns the nodes in topological order: every edge leads from an earlier to a later node.
static uint32_t *sort_topologically(const Layout *l, const EdgesByEnd *out, const EdgesByEnd *in)
{
    const Diagram *d = l->d;
    uint32_t *order = ARENA_ARRAY(l->arena, uint32_t, d->nodes), *waits = ARENA_ARRAY(l->arena, uint32_t, d->nodes), n = 0;

    for (uint32_t v = 0; v < d->nodes; v++)
        if ((waits[v] = in->first[v + 1] - in->first[v]) == 0)
            order[n++] = v;
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t k = out->first[order[i]]; k < out->first[order[i] + 1]; k++) {
            const uint32_t to = lower_end(&d->edge.at[out->edge[k]]);
            if (--waits[to] == 0)
                order[n++] = to;
        }
    return order;
}

// Returns the rank directly below the lowest predecessor of v; 0 if it has none.
static uint32_t rank_below_predecessors(const Layout *l, const EdgesByEnd *in, uint32_t v)
{
    uint32_t rank = 0;

    for (uint32_t k = in->first[v]; k < in->first[v + 1]; k++) {
        const uint32_t r = l->rank[upper_end(&l->d->edge.at[in->edge[k]])] + 1;
        rank = r > rank ? r : rank;
    }
    return rank;
}

// Returns the rank directly above the nearest successor of v; its current rank if it has no successors.
static uint32_t rank_above_successors(const Layout *l, const EdgesByEnd *out, uint32_t v)
{
    uint32_t rank = UINT32_MAX;

    for (uint32_t k = out->first[v]; k < out->first[v + 1]; k++) {
        const uint32_t r = l->rank[lower_end(&l->d->edge.at[out->edge[k]])] - 1;
        rank = r < rank ? r : rank;
    }
    return rank == UINT32_MAX ? l->rank[v] : rank;
}

// Returns how many of a state's predecessors are states.  A section [all_states] moves with the state that it goes to.
static uint32_t count_incoming_states(const Layout *l, const EdgesByEnd *in, uint32_t v)
{
    uint32_t n = 0;

    for (uint32_t k = in->first[v]; k < in->first[v + 1]; k++)
        n += !is_section_edge(l->d, &l->d->edge.at[in->edge[k]]);
    return n;
}

// Moves each node with more outgoing than incoming edges as far down as possible: that makes edges shorter in total.
static void move_nodes_down(Layout *l, const EdgesByEnd *out, const EdgesByEnd *in, const uint32_t *order)
{
    for (size_t i = l->d->nodes; i-- > 0;) {
        const uint32_t v = order[i], outs = out->first[v + 1] - out->first[v], ins = count_incoming_states(l, in, v);
        if (v != 0 && outs > ins)
            l->rank[v] = rank_above_successors(l, out, v);
    }
}

// ---- connected components without the first state ----

// Stores `start` as the component of every node that is connected to it, whatever the direction of edges.
static void mark_component(const Layout *l, const EdgesByEnd *out, const EdgesByEnd *in, uint32_t *component, uint32_t start)
{
    VEC(uint32_t) waiting = {NULL, 0, 0};

    component[start] = start;
    vec_push(l->arena, &waiting, start);
    while (waiting.n > 0) {
        const uint32_t v = waiting.at[--waiting.n];
        for (int side = 0; side < 2; side++) {
            const EdgesByEnd *ends = side ? in : out;
            for (uint32_t k = ends->first[v]; k < ends->first[v + 1]; k++) {
                const DiagramEdge *e = &l->d->edge.at[ends->edge[k]];
                const uint32_t to = side ? upper_end(e) : lower_end(e);
                if (component[to] == UINT32_MAX) {
                    component[to] = start;
                    vec_push(l->arena, &waiting, to);
                }
            }
        }
    }
}

enum { ROW = 4 };                 // maximum number of isolated states in a rank

// Moves every component except the first state's down, so that it ends at the lowest rank in use.  Isolated states follow, ROW to a rank.
static void place_components(Layout *l, const EdgesByEnd *out, const EdgesByEnd *in)
{
    const size_t n = l->d->nodes;
    uint32_t *component = ARENA_ARRAY(l->arena, uint32_t, n), *last = ARENA_ARRAY(l->arena, uint32_t, n), alone = 0, end = 0;

    memset(component, 0xFF, n * sizeof *component);
    for (uint32_t v = 0; v < n; v++)
        if (component[v] == UINT32_MAX)
            mark_component(l, out, in, component, v);
    for (uint32_t v = 0; v < n; v++)
        if (l->rank[v] > last[component[v]])
            last[component[v]] = l->rank[v];
    for (uint32_t v = 0; v < n; v++)
        end = last[v] > end ? last[v] : end;
    for (uint32_t v = 0; v < n; v++)
        if (component[v] != 0 && last[component[v]] > 0)
            l->rank[v] += end - last[component[v]];
        else if (component[v] != 0)
            l->rank[v] = end + (last[0] > 0) + alone++ / ROW;
    l->ranks = 0;
    for (uint32_t v = 0; v < n; v++)
        l->ranks = l->rank[v] >= l->ranks ? l->rank[v] + 1 : l->ranks;
}

// ---- the spine ----

// Whether the spine can contain an edge: a possible one that leads down to a state that is not an @abort state.
static bool continues_path(const Layout *l, const DiagramEdge *e)
{
    return e->form == EDGE_LINE && !e->up && e->possible && !l->d->node[e->to].state->is_abort;
}

// Returns, by state, the number of edges on the longest downward path from it.
static uint32_t *find_longest_paths(const Layout *l, const EdgesByEnd *out, const uint32_t *order)
{
    uint32_t *longest = ARENA_ARRAY(l->arena, uint32_t, l->d->nodes);

    for (size_t i = l->d->nodes; i-- > 0;)
        for (uint32_t k = out->first[order[i]]; k < out->first[order[i] + 1]; k++) {
            const DiagramEdge *e = &l->d->edge.at[out->edge[k]];
            if (continues_path(l, e) && longest[e->to] + 1 > longest[order[i]])
                longest[order[i]] = longest[e->to] + 1;
        }
    return longest;
}

// Returns the first edge of the longest path from v; UINT32_MAX if v is its end.
static uint32_t next_on_longest_path(const Layout *l, const EdgesByEnd *out, const uint32_t *longest, uint32_t v)
{
    for (uint32_t k = out->first[v]; k < out->first[v + 1]; k++) {
        const DiagramEdge *e = &l->d->edge.at[out->edge[k]];
        if (continues_path(l, e) && longest[e->to] + 1 == longest[v])
            return out->edge[k];
    }
    return UINT32_MAX;
}

// The spine is the longest path from the first state, then the longest path from each other state up to a state that is already on the
// spine.
static void find_spine(Layout *l, const EdgesByEnd *out, const uint32_t *order)
{
    const uint32_t *longest = find_longest_paths(l, out, order);
    bool *taken = ARENA_ARRAY(l->arena, bool, l->d->nodes), *done = ARENA_ARRAY(l->arena, bool, l->d->nodes);

    l->spine = ARENA_ARRAY(l->arena, bool, l->d->edge.n + 1);
    for (size_t i = 0; i <= l->d->nodes; i++) {
        uint32_t v = i == 0 ? 0 : order[i - 1], e;
        while (!done[v] && (e = next_on_longest_path(l, out, longest, v)) != UINT32_MAX) {
            const uint32_t to = l->d->edge.at[e].to;
            done[v] = true;
            if (taken[to])
                break;
            l->spine[e] = taken[to] = true;
            v = to;
        }
    }
}

// ---- stubs ----

// Returns the number of states from which the stubs to a state come.  `seen`: by state, 1 + the last node for which the state was counted.
static size_t count_origins(const Diagram *d, uint32_t node, uint32_t *seen)
{
    size_t count = 0;

    for (size_t i = 0; i < d->node[node].stub_in.n; i++) {
        const uint32_t from = d->edge.at[d->node[node].stub_in.at[i]].from;
        const bool *excepted = from < d->states ? NULL : d->node[from].all->excepted;
        for (uint32_t s = excepted ? 0 : from; s < (excepted ? d->states : from + 1); s++)
            if (seen[s] != node + 1 && !(excepted && excepted[s + 1])) {
                seen[s] = node + 1;
                count++;
            }
    }
    return count;
}

// Sets the text beside each state to which stubs lead: where they come from. A stub is an edge drawn as a short arrow beside its source.
static void set_origin_texts(Diagram *d)
{
    uint32_t *seen = ARENA_ARRAY(d->a->arena, uint32_t, d->states);

    for (uint32_t i = 0; i < d->nodes; i++) {
        DiagramNode *n = &d->node[i];
        if (n->stub_in.n == 1)
            n->from = format_in(d->a->arena, "from %s", d->node[d->edge.at[n->stub_in.at[0]].from].name);
        else if (n->stub_in.n > 1)
            n->from = format_in(d->a->arena, "from %lu states", (unsigned long)count_origins(d, i, seen));
        if (n->from)
            n->from_w = diagram_text_width(n->from, GUARD_SIZE, false);
    }
}

// A state that has stubs shows its edge to itself as one more stub, instead of as a loop.
static void turn_loops_into_stubs(Diagram *d)
{
    for (size_t i = 0; i < d->nodes; i++) {
        const DiagramNode *n = &d->node[i];
        DiagramEdge *loop = NULL;
        bool stubs = false;
        for (uint32_t e = n->first_edge; e < n->first_edge + n->edges; e++) {
            if (d->edge.at[e].form == EDGE_LOOP)
                loop = &d->edge.at[e];
            stubs = stubs || d->edge.at[e].form == EDGE_STUB;
        }
        if (loop && stubs)
            loop->form = EDGE_STUB;
    }
}

// Sets `rank` and DiagramEdge.up; edges across many ranks become stubs.
void layout_assign_ranks(Layout *l)
{
    EdgesByEnd out, in;
    uint32_t *order;

    break_cycles(l);
    out = sort_edges_by_end(l, upper_end);
    in = sort_edges_by_end(l, lower_end);
    order = sort_topologically(l, &out, &in);
    l->rank = ARENA_ARRAY(l->arena, uint32_t, l->d->nodes);
    for (size_t i = 0; i < l->d->nodes; i++)
        l->rank[order[i]] = rank_below_predecessors(l, &in, order[i]);
    move_nodes_down(l, &out, &in, order);
    place_components(l, &out, &in);
    for (uint32_t e = 0; e < l->d->edge.n; e++) {
        const DiagramEdge *edge = &l->d->edge.at[e];
        if (edge->form == EDGE_LINE && l->rank[lower_end(edge)] - l->rank[upper_end(edge)] > LONGEST)
            turn_into_stub(l->d, e);
    }
    find_spine(l, &out, order);
    set_origin_texts(l->d);
    turn_loops_into_stubs(l->d);
}
