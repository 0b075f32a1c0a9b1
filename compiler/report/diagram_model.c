// SPDX-License-Identifier: Apache-2.0
// A machine as a diagram: combines transitions into edges, and writes their guards as text.
#include "compiler/report/diagram_model.h"

#include "compiler/base/worklist.h"

// ---- reachability ----

// Whether t can be taken: its statement and the state that contains it are reachable. In a diagram of differences all transitions count as possible.
static bool is_possible(const Diagram *d, const Transition *t)
{
    return d->o->changes || (d->a->stmt[t->stmt->number].reached && d->node[t->from->number - 1].reached);
}

// Whether the section runs in a state that some run reaches.
static bool is_section_reached(const Diagram *d, const AllStates *all)
{
    for (size_t s = 0; s < d->states; s++)
        if (!all->excepted[s + 1] && d->node[s].reached)
            return true;
    return false;
}

// Whether some run can take one of the edge's transitions in one of its states.
static bool is_edge_possible(const Diagram *d, const DiagramEdge *e)
{
    for (size_t g = 0; g < e->guard.n; g++)
        for (size_t k = 0; k < e->guard.at[g].transition->copy.n; k++)
            if (is_possible(d, e->guard.at[g].transition->copy.at[k]))
                return true;
    return false;
}

// A state is reachable if it is the first, or if a possible transition leads to it from a reachable state.
static void find_reached_states(Diagram *d)
{
    const Transitions *all = &d->a->transition;
    Worklist waiting = worklist_new(d->a->arena, d->states);

    d->node[0].reached = true;
    worklist_add(&waiting, 0);
    while (waiting.n > 0) {
        const size_t s = worklist_next(&waiting);
        for (size_t t = d->first_of[s]; t < d->first_of[s + 1]; t++) {
            DiagramNode *to = &d->node[all->at[t].to->number - 1];
            if (to->reached || !is_possible(d, &all->at[t]))
                continue;
            to->reached = true;
            worklist_add(&waiting, to->state->number - 1);
        }
    }
    for (size_t n = 0; n < d->states && d->o->changes; n++)
        d->node[n].reached = true;
    for (size_t n = d->states; n < d->nodes; n++)
        d->node[n].reached = is_section_reached(d, d->node[n].all);
    for (size_t e = 0; e < d->edge.n; e++)
        d->edge.at[e].possible = is_edge_possible(d, &d->edge.at[e]);
}

// ---- guards ----

// Returns the text for a transition without a guard: it depends on the transitions before it in the block.
static const char *unguarded_text(const Analysis *a, const Transition *t)
{
    const Transition *before = t->number > 0 ? &a->transition.at[t->number - 1] : NULL;

    return before && before->from == t->from && before->block == t->block &&
           written_section(a->p, before->stmt->span) == written_section(a->p, t->stmt->span) ? "otherwise" : "always";
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

// Adds transition w to edge e. A transition of [all_states] has one copy for each state, and is possible when any copy is reachable.
static void add_guard(const Analysis *a, DiagramEdge *e, const WrittenTransition *w)
{
    const Transition *t = w->copy.at[0];
    DiagramGuard g = {.transition = w, .text = guard_text(a, t, 0), .line = fit_guard(a, t)};

    for (size_t k = 0; k < w->copy.n; k++)
        g.possible = g.possible || !a->stmt || a->stmt[w->copy.at[k]->stmt->number].reached;
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

// Returns the edge of a transition of node `from`, and adds it if the diagram lacks it.  last[s] is 1 + the index of the edge from the current
// node to state s.  A number not above the current node's first edge is left over from an earlier node: there is no such edge yet.
static DiagramEdge *find_or_add_edge(Diagram *d, size_t *last, uint32_t from, const WrittenTransition *t)
{
    const uint32_t to = t->copy.at[0]->to->number - 1;

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

// Whether the transition starts at the node: the same [all_states] section, or the same state and no section.
static bool is_of_node(const WrittenTransition *t, const DiagramNode *n)
{
    return t->all == n->all && (t->all || t->copy.at[0]->from == n->state);
}

// Combines transitions into edges.  Written transitions have the order of the nodes.
static void add_edges(Diagram *d)
{
    const WrittenTransitions written = written_transitions(d->a->arena, d->a->p, &d->a->transition);
    size_t *last = ARENA_ARRAY(d->a->arena, size_t, d->nodes), next = 0;

    for (uint32_t n = 0; n < d->nodes; n++) {
        d->node[n].first_edge = (uint32_t)d->edge.n;
        for (; next < written.n && is_of_node(&written.at[next], &d->node[n]); next++)
            add_guard(d->a, find_or_add_edge(d, last, n, &written.at[next]), &written.at[next]);
    }
}

// ---- counts ----

// A flight log shows that the machine went from one state to another, but not by which transition.  Then counts are by pair of states.  Two edges
// share a count if a state has a transition of its own to a state to which [all_states] also leads.
typedef struct PairCount {
    uint32_t from, to;            // State.number
    uint32_t edge;                // index in Diagram.edge of the first edge with a transition between the two states
    bool shared;                  // another edge has the same pair of states
    uint64_t taken;
} PairCount;

typedef struct PairCounts {
    VEC(PairCount) list;          // by `from`, in any order of `to`
    uint32_t *of;                 // by Transition.number: index in `list`
} PairCounts;

// The index of the edge that draws each transition, by the number of the transition.
static const uint32_t *edges_of_transitions(const Diagram *d)
{
    uint32_t *of = ARENA_ARRAY(d->a->arena, uint32_t, d->a->transition.n);

    for (uint32_t e = 0; e < d->edge.n; e++)
        for (size_t g = 0; g < d->edge.at[e].guard.n; g++) {
            const WrittenTransition *t = d->edge.at[e].guard.at[g].transition;
            for (size_t k = 0; k < t->copy.n; k++)
                of[t->copy.at[k]->number] = e;
        }
    return of;
}

// Transitions are sorted by their states, so last[to] is 1 + the index of the newest pair that ends at `to`.
static PairCounts count_pairs(const Diagram *d, const uint32_t *edge)
{
    const Transitions *all = &d->a->transition;
    PairCounts p = {{NULL, 0, 0}, ARENA_ARRAY(d->a->arena, uint32_t, all->n)};
    uint32_t *last = ARENA_ARRAY(d->a->arena, uint32_t, d->states + 1u);

    for (size_t i = 0; i < all->n; i++) {
        const Transition *t = &all->at[i];
        const PairCount pair = {t->from->number, t->to->number, edge[i], false, 0};
        PairCount *at;
        if (last[pair.to] == 0 || p.list.at[last[pair.to] - 1].from != pair.from) {
            vec_push(d->a->arena, &p.list, pair);
            last[pair.to] = p.list.n;
        }
        p.of[i] = last[pair.to] - 1;
        at = &p.list.at[p.of[i]];
        at->shared = at->shared || at->edge != edge[i];
        at->taken += d->o->counts->transition[i];
    }
    return p;
}

// Sets the counts of all edges and of their transitions, if it is known which transition was taken.
static void count_transitions(Diagram *d)
{
    for (uint32_t e = 0; e < d->edge.n; e++)
        for (size_t g = 0; g < d->edge.at[e].guard.n; g++) {
            DiagramGuard *guard = &d->edge.at[e].guard.at[g];
            for (size_t k = 0; k < guard->transition->copy.n; k++)
                guard->taken += d->o->counts->transition[guard->transition->copy.at[k]->number];
            d->edge.at[e].taken += guard->taken;
        }
}

// Sets the counts of all edges.  Each edge counts a pair once, however many of its transitions have it.
static void count_pairs_of_edges(Diagram *d)
{
    const uint32_t *edge = edges_of_transitions(d);
    const PairCounts p = count_pairs(d, edge);
    uint32_t *counted = ARENA_ARRAY(d->a->arena, uint32_t, d->edge.n + 1u);       // by edge: 1 + the index of the pair that was last added to it

    for (size_t i = 0; i < d->a->transition.n; i++) {
        const PairCount *pair = &p.list.at[p.of[i]];
        DiagramEdge *e = &d->edge.at[edge[i]];
        if (counted[edge[i]] == p.of[i] + 1)
            continue;
        counted[edge[i]] = p.of[i] + 1;
        *(pair->shared ? &e->shared : &e->taken) += pair->taken;
    }
}

// Sets how often each edge was taken: from counts for pairs of states where the options give these, else from counts for each transition.
static void count_edges(Diagram *d)
{
    if (d->o->counts->by_pair)
        count_pairs_of_edges(d);
    else
        count_transitions(d);
}

uint64_t diagram_times_taken(const DiagramEdge *e) { return e->taken + e->shared; }

// The count of a pair of states is that of the first transition from one to the other.
uint64_t diagram_times_taken_in(const Diagram *d, const DiagramEdge *e, const State *from)
{
    const Transitions *all = &d->a->transition;
    const Transition *copy = NULL;
    uint64_t sum = 0;

    for (size_t k = 0; k < e->guard.at[0].transition->copy.n && !copy; k++)
        if (e->guard.at[0].transition->copy.at[k]->from == from)
            copy = e->guard.at[0].transition->copy.at[k];
    if (!copy || !d->o->counts)
        return 0;
    for (size_t g = 0; g < e->guard.n && !d->o->counts->by_pair; g++)
        for (size_t k = 0; k < e->guard.at[g].transition->copy.n; k++)
            if (e->guard.at[g].transition->copy.at[k]->from == from)
                sum += d->o->counts->transition[e->guard.at[g].transition->copy.at[k]->number];
    if (!d->o->counts->by_pair)
        return sum;
    for (size_t i = d->first_of[from->number - 1]; i < d->first_of[from->number]; i++)
        sum += all->at[i].to == copy->to ? d->o->counts->transition[i] : 0;
    return sum;
}

uint64_t diagram_times_entered(const Diagram *d, const DiagramNode *n)
{
    uint64_t sum = 0;

    if (!d->o->counts)
        return 0;
    if (n->state)
        return d->o->counts->state[n->state->number - 1];
    for (size_t s = 0; s < d->states; s++)
        sum += n->all->excepted[s + 1] ? 0 : d->o->counts->state[s];
    return sum;
}

// Returns what was counted in words: "taken 3 times".
const char *diagram_count_text(const Diagram *d, const char *done, uint64_t count)
{
    return count == 0 ? format_in(d->a->arena, "never %s", done)
         : count == 1 ? format_in(d->a->arena, "%s once", done)
                      : format_in(d->a->arena, "%s %llu times", done, (unsigned long long)count);
}

// An edge stands for all transitions from one state to another.  If the edge was taken, but some of its transitions never were, returns the
// lines of the latter as ", never by lines 24 and 30".  Otherwise, or if only pairs of states were counted (by_pair), returns "".
const char *diagram_unused_lines(const Diagram *d, const DiagramEdge *e)
{
    size_t unused = 0, n = 0;
    Buf out;

    for (size_t g = 0; g < e->guard.n; g++)
        unused += e->guard.at[g].taken == 0;
    if (d->o->counts->by_pair || unused == 0 || unused == e->guard.n)
        return "";
    buf_init(&out, d->a->arena);
    buf_printf(&out, ", never by line%s ", unused == 1 ? "" : "s");
    for (size_t g = 0; g < e->guard.n; g++)
        if (e->guard.at[g].taken == 0) {
            const Span at = e->guard.at[g].transition->copy.at[0]->stmt->span;
            buf_printf(&out, "%s%lu", n == 0 ? "" : n + 1 < unused ? ", " : " and ", (unsigned long)source_position(at.src, at.at).line);
            n++;
        }
    return buf_text(&out);
}

const char *diagram_times_taken_text(const Diagram *d, const DiagramEdge *e)
{
    const unsigned long long least = e->taken, most = diagram_times_taken(e);
    const char *text = e->shared == 0 ? diagram_count_text(d, "taken", most)
                     : least == 0     ? format_in(d->a->arena, most == 1 ? "taken at most once" : "taken at most %llu times", most)
                                      : format_in(d->a->arena, "taken %llu to %llu times", least, most);

    return e->guard.n > 1 ? format_in(d->a->arena, "together: %s%s", text, diagram_unused_lines(d, e)) : text;
}

// Adds the count below the last guard of an edge.
static void add_count(const Diagram *d, DiagramEdge *e)
{
    const char *text = diagram_times_taken_text(d, e);
    const DiagramLine line = {text, diagram_text_width(text, GUARD_SIZE, false)};

    vec_push(d->a->arena, &e->guard.at[e->guard.n - 1].line, line);
}

// ---- changes ----

static const char *change_sign(DiagramChange c)
{
    return c == DIAGRAM_ADDED ? "+ " : c == DIAGRAM_REMOVED ? "\xe2\x88\x92 " : c == DIAGRAM_CHANGED ? "~ " : "";
}

// Precedes the lines of a guard with the sign of its change, and adds its earlier condition.
static void show_change(Diagram *d, DiagramGuard *g)
{
    const uint32_t number = g->transition->copy.at[0]->number;
    const char *was = d->o->changes->was[number];
    DiagramLine *first = &g->line.at[0];

    g->change = d->o->changes->transition[number];
    first->text = format_in(d->a->arena, "%s%s", change_sign(g->change), first->text);
    first->w = diagram_text_width(first->text, GUARD_SIZE, false);
    if (was) {
        const DiagramLines lines = diagram_text_wrap(d->a->arena, format_in(d->a->arena, "was %s", was), GUARD_SIZE, GUARD_W, GUARD_LINES);
        for (size_t i = 0; i < lines.n; i++)
            vec_push(d->a->arena, &g->line, lines.at[i]);
    }
}

// For a diagram of differences: marks states and transitions as added, removed or changed. An edge with transitions of different marks counts as
// changed.
static void show_changes(Diagram *d)
{
    for (size_t n = 0; n < d->states; n++) {
        DiagramNode *node = &d->node[n];
        node->change = d->o->changes->state[n];
        node->name = format_in(d->a->arena, "%s%s", change_sign(node->change), node->name);
        node->name_w = diagram_text_width(node->name, NAME_SIZE, true);
    }
    for (size_t e = 0; e < d->edge.n; e++) {
        DiagramEdge *edge = &d->edge.at[e];
        for (size_t g = 0; g < edge->guard.n; g++) {
            show_change(d, &edge->guard.at[g]);
            edge->change = g == 0 || edge->guard.at[g].change == edge->change ? edge->guard.at[g].change : DIAGRAM_CHANGED;
        }
    }
}

// ---- the whole diagram ----

enum { NAME_W = 220, SECTION_NAME_W = 320 };       // maximum width of the name of a state, and of a section [all_states]

// Adds a node for each state and each section [all_states].
static void add_nodes(Diagram *d)
{
    const Program *p = d->a->p;

    d->states = p->state.n;
    d->nodes = d->states + p->all_states.n;
    d->node = ARENA_ARRAY(d->a->arena, DiagramNode, d->nodes);
    for (size_t i = 0; i < d->nodes; i++) {
        DiagramNode *n = &d->node[i];
        n->state = i < d->states ? p->state.at[i] : NULL;
        n->all = i < d->states ? NULL : p->all_states.at[i - d->states];
        n->title = n->state ? n->state->name->text : written_section_name(d->a->arena, p, n->all, "");
        n->name = diagram_text_truncate(d->a->arena, n->title, NAME_SIZE, true, n->state ? NAME_W : SECTION_NAME_W);
        n->name_w = diagram_text_width(n->name, NAME_SIZE, true);
    }
}

// Removes the nodes of sections that have nothing to show: no transitions and no actions.
static void remove_empty_sections(Diagram *d)
{
    size_t kept = d->states;

    for (size_t n = d->states; n < d->nodes; n++) {
        const DiagramNode *from = &d->node[n];
        if (from->edges == 0 && from->action.n == 0)
            continue;
        for (uint32_t e = from->first_edge; e < from->first_edge + from->edges; e++)
            d->edge.at[e].from = (uint32_t)kept;
        d->node[kept++] = *from;
    }
    d->nodes = kept;
}

// Builds the diagram of the machine of `a`, without positions.
Diagram *diagram_build(const Analysis *a, const DiagramOptions *o)
{
    Diagram *d = ARENA_NEW(a->arena, Diagram);

    d->a = a;
    d->o = o;
    add_nodes(d);
    d->first_of = transitions_by_state(a->arena, a->p, &a->transition);
    diagram_add_actions(d);
    add_edges(d);
    remove_empty_sections(d);
    find_reached_states(d);
    if (o->changes)
        show_changes(d);
    if (o->counts)
        count_edges(d);
    for (size_t e = 0; e < d->edge.n; e++) {
        if (o->counts)
            add_count(d, &d->edge.at[e]);
        size_label(&d->edge.at[e]);
    }
    if (o->findings)
        diagram_attach_findings(d, o->findings);
    return d;
}
