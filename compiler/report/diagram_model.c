// SPDX-License-Identifier: Apache-2.0
// A machine as a diagram: combines transitions into edges, and writes their guards as text.
#include "compiler/report/diagram_model.h"

#include "compiler/base/worklist.h"

// ---- reachability ----

// A state is reachable if it is the first, or if a possible transition leads to it from a reachable state.
static void find_reached_states(Diagram *d)
{
    Worklist waiting = worklist_new(d->a->arena, d->nodes);

    d->node[0].reached = true;
    worklist_add(&waiting, 0);
    while (waiting.n > 0) {
        const DiagramNode *n = &d->node[worklist_next(&waiting)];
        for (uint32_t e = n->first_edge; e < n->first_edge + n->edges; e++) {
            const DiagramEdge *edge = &d->edge.at[e];
            if (!edge->possible || d->node[edge->to].reached)
                continue;
            d->node[edge->to].reached = true;
            worklist_add(&waiting, edge->to);
        }
    }
    for (size_t e = 0; e < d->edge.n; e++)
        d->edge.at[e].possible = d->edge.at[e].possible && d->node[d->edge.at[e].from].reached;
}

// ---- guards ----

// Returns the text for a transition without a guard: it depends on the transitions before it in the block.
static const char *unguarded_text(const Analysis *a, const Transition *t)
{
    const Transition *before = t->number > 0 ? &a->transition.at[t->number - 1] : NULL;

    return before && before->from == t->from && before->block == t->block ? "otherwise" : "always";
}

// Returns the whole guard as text if `most` is 0, otherwise condition_brief(…, most): only its innermost conditions.
static const char *guard_text(const Analysis *a, const Transition *t, size_t most)
{
    const char *text = !t->when ? unguarded_text(a, t) : most ? condition_brief(a->arena, t->when, most) : condition_text(a->arena, t->when);

    if (t->block != BLOCK_ENTRY)
        return text;
    return t->when ? format_in(a->arena, "on entry, %s", text) : "on entry";
}

// Breaks guard_text into the lines of a label.
static DiagramLines wrap_guard(const Analysis *a, const Transition *t, size_t most)
{
    return diagram_text_wrap(a->arena, guard_text(a, t, most), GUARD_SIZE, GUARD_W, GUARD_LINES);
}

// Returns the guard in lines that fit.  Of an else-if chain the last condition matters most, so the outer ones are omitted first, until
// the text fits.  A plain else has only negated conditions and is not shortened.
static DiagramLines fit_guard(const Analysis *a, const Transition *t)
{
    DiagramLines line = wrap_guard(a, t, 0);

    if (!t->when || !t->when->holds)
        return line;
    for (size_t most = CONDITIONS_SHOWN; diagram_text_is_truncated(&line) && most > 0; most--)
        line = wrap_guard(a, t, most);
    return diagram_text_is_truncated(&line) ? wrap_guard(a, t, CONDITIONS_SHOWN) : line;
}

static void add_guard(const Analysis *a, DiagramEdge *e, const Transition *t)
{
    const DiagramGuard g = {t, guard_text(a, t, 0), fit_guard(a, t), a->stmt[t->stmt->number].reached, {NULL, 0, 0}, 0};

    e->possible = e->possible || g.possible;
    vec_push(a->arena, &e->guard, g);
}

// Computes the size of the label from the lines of all its guards.
static void size_label(DiagramEdge *e)
{
    for (size_t g = 0; g < e->guard.n; g++) {
        const DiagramLines *line = &e->guard.at[g].line;
        e->label.h += (int32_t)line->n * GUARD_LINE + (g ? GUARD_GAP : 0);
        for (size_t i = 0; i < line->n; i++)
            if (line->at[i].w > e->label.w)
                e->label.w = line->at[i].w;
    }
}

// ---- edges ----

// Returns the edge of a transition, and adds it if the diagram lacks it.  last[s] is 1 + the index of the edge from the current state to
// state s.  A number not above the current state's first edge is left over from an earlier state: there is no such edge yet.
static DiagramEdge *find_or_add_edge(Diagram *d, size_t *last, const Transition *t)
{
    const uint32_t from = t->from->number - 1, to = t->to->number - 1;

    if (last[to] <= d->node[from].first_edge) {
        DiagramEdge e = {0};
        e.from = from;
        e.to = to;
        e.form = from == to ? EDGE_LOOP : EDGE_LINE;
        vec_push(d->a->arena, &d->edge, e);
        d->node[from].edges++;
        last[to] = d->edge.n;
    }
    return &d->edge.at[last[to] - 1];
}

// Combines transitions into edges.  Transitions are sorted by source state.
static void add_edges(Diagram *d)
{
    size_t *last = ARENA_ARRAY(d->a->arena, size_t, d->nodes), next = 0;

    for (size_t s = 0; s < d->nodes; s++) {
        d->node[s].first_edge = (uint32_t)d->edge.n;
        for (; next < d->a->transition.n && d->a->transition.at[next].from == d->node[s].state; next++)
            add_guard(d->a, find_or_add_edge(d, last, &d->a->transition.at[next]), &d->a->transition.at[next]);
    }
}

// ---- counts ----

uint64_t diagram_times_taken(const Diagram *d, const DiagramEdge *e)
{
    uint64_t sum = 0;

    for (size_t g = 0; d->o->counts && g < e->guard.n; g++)
        sum += d->o->counts->transition[e->guard.at[g].transition->number];
    return sum;
}

uint64_t diagram_times_entered(const Diagram *d, const DiagramNode *n)
{
    return d->o->counts ? d->o->counts->state[n->state->number - 1] : 0;
}

// Returns what was counted in words: "taken 3 times".
const char *diagram_count_text(const Diagram *d, const char *done, uint64_t count)
{
    return count == 0 ? format_in(d->a->arena, "never %s", done)
         : count == 1 ? format_in(d->a->arena, "%s once", done)
                      : format_in(d->a->arena, "%s %llu times", done, (unsigned long long)count);
}

// If several transitions lead from one state to another, a run does not record which it took.
const char *diagram_times_taken_text(const Diagram *d, const DiagramEdge *e)
{
    const char *text = diagram_count_text(d, "taken", diagram_times_taken(d, e));

    return e->guard.n > 1 ? format_in(d->a->arena, "together: %s", text) : text;
}

// Adds the count below the last guard of an edge.
static void add_count(const Diagram *d, DiagramEdge *e)
{
    const char *text = diagram_times_taken_text(d, e);
    const DiagramLine line = {text, diagram_text_width(text, GUARD_SIZE, false)};

    vec_push(d->a->arena, &e->guard.at[e->guard.n - 1].line, line);
}

// ---- the whole diagram ----

enum { NAME_W = 220 };

// Builds the diagram of the machine of `a`, without positions.
Diagram *diagram_build(const Analysis *a, const DiagramOptions *o)
{
    Diagram *d = ARENA_NEW(a->arena, Diagram);

    d->a = a;
    d->o = o;
    d->nodes = a->p->state.n;
    d->node = ARENA_ARRAY(a->arena, DiagramNode, d->nodes);
    for (size_t s = 0; s < d->nodes; s++) {
        DiagramNode *n = &d->node[s];
        n->state = a->p->state.at[s];
        n->name = diagram_text_truncate(a->arena, n->state->name->text, NAME_SIZE, true, NAME_W);
        n->name_w = diagram_text_width(n->name, NAME_SIZE, true);
    }
    diagram_add_actions(d);
    add_edges(d);
    find_reached_states(d);
    for (size_t e = 0; e < d->edge.n; e++) {
        if (o->counts)
            add_count(d, &d->edge.at[e]);
        size_label(&d->edge.at[e]);
    }
    if (o->findings)
        diagram_attach_findings(d, o->findings);
    return d;
}
