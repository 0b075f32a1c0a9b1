// SPDX-License-Identifier: Apache-2.0
// Ranks of states: how far down each stands.
#include <string.h>

#include "compiler/emit/report/layout.h"

// ---- which edges are stubs ----

enum {
    HUB_ABORT = 3,                // so many states that lead to an @abort state make all edges to it stubs
    HUB = 6,                      // to any other state
    LONGEST = 6                   // ranks that a line may cross
};

static void stub(Diagram *d, uint32_t edge)
{
    DiagramEdge *e = &d->edge.at[edge];

    e->form = EDGE_STUB;
    vec_push(d->a->arena, &d->node[e->to].stub_in, edge);
}

void layout_stub_hubs(Diagram *d)
{
    uint32_t *in = ARENA_ARRAY(d->a->arena, uint32_t, d->nodes);

    for (size_t e = 0; e < d->edge.n; e++)
        in[d->edge.at[e].to] += d->edge.at[e].form == EDGE_LINE;
    for (uint32_t e = 0; e < d->edge.n; e++) {
        const uint32_t to = d->edge.at[e].to;
        if (d->edge.at[e].form == EDGE_LINE && in[to] >= (d->node[to].state->is_abort ? HUB_ABORT : HUB))
            stub(d, e);
    }
}

// ---- circles ----

typedef struct Visit { uint32_t node, next; } Visit;      // next: its edges that have been followed

typedef struct Search {
    Layout *l;
    char *met;                    // 0 not yet, 1 on the way here, 2 done
    VEC(Visit) way;
} Search;

static void enter(Search *s, uint32_t node)
{
    Visit v = {node, 0};

    s->met[node] = 1;
    vec_push(s->l->arena, &s->way, v);
}

// In file order from the first state on.  An edge back to a state on the way there closes a circle.  The first state stays on top.
static void search_from(Search *s, uint32_t start)
{
    const Diagram *d = s->l->d;

    enter(s, start);
    while (s->way.n > 0) {
        Visit *v = &s->way.at[s->way.n - 1];
        const DiagramNode *n = &d->node[v->node];
        DiagramEdge *e = &d->edge.at[n->first_edge + v->next];
        if (v->next++ == n->edges) {
            s->met[v->node] = 2;
            s->way.n--;
        } else if (s->met[e->to] == 1 || e->to == 0)
            e->up = e->to != e->from;
        else if (s->met[e->to] == 0)
            enter(s, e->to);
    }
}

static void break_circles(Layout *l)
{
    Search s = {l, ARENA_ARRAY(l->arena, char, l->d->nodes), {NULL, 0, 0}};

    for (uint32_t n = 0; n < l->d->nodes; n++)
        if (s.met[n] == 0)
            search_from(&s, n);
}

// ---- ranks ----

// The upper and the lower end of a line.
static uint32_t upper(const DiagramEdge *e) { return e->up ? e->to : e->from; }
static uint32_t lower(const DiagramEdge *e) { return e->up ? e->from : e->to; }

// The lines at each node, wherever they lead.
typedef struct Ends { uint32_t *first, *edge; } Ends;

static Ends ends_of(const Layout *l, uint32_t (*end)(const DiagramEdge *e))
{
    const Diagram *d = l->d;
    Ends out = {ARENA_ARRAY(l->arena, uint32_t, d->nodes + 2), ARENA_ARRAY(l->arena, uint32_t, d->edge.n + 1)};

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

// Nodes so that every line leads from an earlier to a later one.
static uint32_t *downwards(const Layout *l, const Ends *out, const Ends *in)
{
    const Diagram *d = l->d;
    uint32_t *order = ARENA_ARRAY(l->arena, uint32_t, d->nodes), *waits = ARENA_ARRAY(l->arena, uint32_t, d->nodes), n = 0;

    for (uint32_t v = 0; v < d->nodes; v++)
        if ((waits[v] = in->first[v + 1] - in->first[v]) == 0)
            order[n++] = v;
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t k = out->first[order[i]]; k < out->first[order[i] + 1]; k++) {
            const uint32_t to = lower(&d->edge.at[out->edge[k]]);
            if (--waits[to] == 0)
                order[n++] = to;
        }
    return order;
}

static uint32_t lowest_above(const Layout *l, const Ends *in, uint32_t v)
{
    uint32_t rank = 0;

    for (uint32_t k = in->first[v]; k < in->first[v + 1]; k++) {
        const uint32_t r = l->rank[upper(&l->d->edge.at[in->edge[k]])] + 1;
        rank = r > rank ? r : rank;
    }
    return rank;
}

// The lowest rank that the lines out of v allow; of none, its own.
static uint32_t highest_below(const Layout *l, const Ends *out, uint32_t v)
{
    uint32_t rank = UINT32_MAX;

    for (uint32_t k = out->first[v]; k < out->first[v + 1]; k++) {
        const uint32_t r = l->rank[lower(&l->d->edge.at[out->edge[k]])] - 1;
        rank = r < rank ? r : rank;
    }
    return rank == UINT32_MAX ? l->rank[v] : rank;
}

// What has more lines out than in is better off as far down as it may be.
static void sink(Layout *l, const Ends *out, const Ends *in, const uint32_t *order)
{
    for (size_t i = l->d->nodes; i-- > 0;) {
        const uint32_t v = order[i], outs = out->first[v + 1] - out->first[v], ins = in->first[v + 1] - in->first[v];
        if (v != 0 && outs > ins)
            l->rank[v] = highest_below(l, out, v);
    }
}

// ---- parts that no line joins to the first state ----

static void spread(const Layout *l, const Ends *out, const Ends *in, uint32_t *part, uint32_t start)
{
    VEC(uint32_t) waiting = {NULL, 0, 0};

    part[start] = start;
    vec_push(l->arena, &waiting, start);
    while (waiting.n > 0) {
        const uint32_t v = waiting.at[--waiting.n];
        for (int side = 0; side < 2; side++) {
            const Ends *ends = side ? in : out;
            for (uint32_t k = ends->first[v]; k < ends->first[v + 1]; k++) {
                const DiagramEdge *e = &l->d->edge.at[ends->edge[k]];
                const uint32_t to = side ? upper(e) : lower(e);
                if (part[to] == UINT32_MAX) {
                    part[to] = start;
                    vec_push(l->arena, &waiting, to);
                }
            }
        }
    }
}

enum { ROW = 4 };                 // single states that stand side by side

// Each part ends where the first one ends; states that stand alone come below, some to a rank.
static void settle_parts(Layout *l, const Ends *out, const Ends *in)
{
    const size_t n = l->d->nodes;
    uint32_t *part = ARENA_ARRAY(l->arena, uint32_t, n), *last = ARENA_ARRAY(l->arena, uint32_t, n), alone = 0, end = 0;

    memset(part, 0xFF, n * sizeof *part);
    for (uint32_t v = 0; v < n; v++)
        if (part[v] == UINT32_MAX)
            spread(l, out, in, part, v);
    for (uint32_t v = 0; v < n; v++)
        if (l->rank[v] > last[part[v]])
            last[part[v]] = l->rank[v];
    for (uint32_t v = 0; v < n; v++)
        end = last[v] > end ? last[v] : end;
    for (uint32_t v = 0; v < n; v++)
        if (part[v] != 0 && last[part[v]] > 0)
            l->rank[v] += end - last[part[v]];
        else if (part[v] != 0)
            l->rank[v] = end + (last[0] > 0) + alone++ / ROW;
    l->ranks = 0;
    for (uint32_t v = 0; v < n; v++)
        l->ranks = l->rank[v] >= l->ranks ? l->rank[v] + 1 : l->ranks;
}

// ---- the spine ----

// How many lines the longest way downwards has that begins at each state.  Only transitions that can be made count.
static uint32_t *longest_ways(const Layout *l, const Ends *out, const uint32_t *order)
{
    uint32_t *way = ARENA_ARRAY(l->arena, uint32_t, l->d->nodes);

    for (size_t i = l->d->nodes; i-- > 0;)
        for (uint32_t k = out->first[order[i]]; k < out->first[order[i] + 1]; k++) {
            const DiagramEdge *e = &l->d->edge.at[out->edge[k]];
            if (!e->up && e->possible && way[e->to] + 1 > way[order[i]])
                way[order[i]] = way[e->to] + 1;
        }
    return way;
}

// The line with which the longest way from v goes on; UINT32_MAX: v is its end.
static uint32_t next_of(const Layout *l, const Ends *out, const uint32_t *way, uint32_t v)
{
    for (uint32_t k = out->first[v]; k < out->first[v + 1]; k++) {
        const DiagramEdge *e = &l->d->edge.at[out->edge[k]];
        if (e->form == EDGE_LINE && !e->up && e->possible && way[e->to] + 1 == way[v])
            return out->edge[k];
    }
    return UINT32_MAX;
}

// The longest way from the first state, then from each other as far as none was before.
static void find_spine(Layout *l, const Ends *out, const uint32_t *order)
{
    const uint32_t *way = longest_ways(l, out, order);
    bool *taken = ARENA_ARRAY(l->arena, bool, l->d->nodes), *done = ARENA_ARRAY(l->arena, bool, l->d->nodes);

    l->spine = ARENA_ARRAY(l->arena, bool, l->d->edge.n + 1);
    for (size_t i = 0; i <= l->d->nodes; i++) {
        uint32_t v = i == 0 ? 0 : order[i - 1], e;
        while (!done[v] && (e = next_of(l, out, way, v)) != UINT32_MAX) {
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

// What stands beside a state to which stubs lead.
static void name_origins(Diagram *d)
{
    for (size_t i = 0; i < d->nodes; i++) {
        DiagramNode *n = &d->node[i];
        if (n->stub_in.n == 1)
            n->from = format_in(d->a->arena, "from %s", d->node[d->edge.at[n->stub_in.at[0]].from].name);
        else if (n->stub_in.n > 1)
            n->from = format_in(d->a->arena, "from %lu states", (unsigned long)n->stub_in.n);
        if (n->from)
            n->from_w = text_width(n->from, GUARD_SIZE, false);
    }
}

// A state that leads to itself and has stubs shows that as one of them.
static void join_loops(Diagram *d)
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

void layout_rank(Layout *l)
{
    Ends out, in;
    uint32_t *order;

    break_circles(l);
    out = ends_of(l, upper);
    in = ends_of(l, lower);
    order = downwards(l, &out, &in);
    l->rank = ARENA_ARRAY(l->arena, uint32_t, l->d->nodes);
    for (size_t i = 0; i < l->d->nodes; i++)
        l->rank[order[i]] = lowest_above(l, &in, order[i]);
    sink(l, &out, &in, order);
    settle_parts(l, &out, &in);
    for (uint32_t e = 0; e < l->d->edge.n; e++) {
        const DiagramEdge *edge = &l->d->edge.at[e];
        if (edge->form == EDGE_LINE && l->rank[lower(edge)] - l->rank[upper(edge)] > LONGEST)
            stub(l->d, e);
    }
    find_spine(l, &out, order);
    name_origins(l->d);
    join_loops(l->d);
}
