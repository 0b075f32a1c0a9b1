// SPDX-License-Identifier: Apache-2.0
// Finds the states that are bound for an @abort state: those with transitions, all of which lead to bound or @abort states.
// The search runs backwards from the @abort states and visits each transition once.
#include "compiler/analysis/abort.h"

typedef struct Search {
    Analysis *a;
    AbortBound out;
    uint32_t *ways;               // by state: transitions out of it whose target is not yet known to be bound
    bool *waits;                  // by state: the machine may stay in it for more than a step
    uint32_t *first, *into;       // transitions by target: into[first[target]] … into[first[target + 1]], numbers in the list
    VEC(const State *) found;     // states found to be bound whose incoming transitions are not yet visited
} Search;

static size_t at(const State *s) { return s->number - 1u; }

// A transition from a state to itself does not lead to another state.
static bool leads_on(const Search *b, const Transition *t) { return b->a->stmt[t->stmt->number].reached && t->to != t->from; }

// ---- the graph ----

static void sort_by_target(Search *b)
{
    const Transitions *list = &b->a->transition;
    const size_t n = b->a->p->state.n;
    uint32_t *next = ARENA_ARRAY(b->a->arena, uint32_t, n + 1);

    b->first = ARENA_ARRAY(b->a->arena, uint32_t, n + 1);
    b->into = ARENA_ARRAY(b->a->arena, uint32_t, list->n + 1);
    for (size_t i = 0; i < list->n; i++)
        b->first[list->at[i].to->number]++;
    for (size_t s = 0; s < n; s++)
        next[s + 1] = b->first[s + 1] += b->first[s];
    for (size_t i = 0; i < list->n; i++)
        b->into[next[at(list->at[i].to)]++] = (uint32_t)i;
}

static void count_ways(Search *b)
{
    for (size_t i = 0; i < b->a->transition.n; i++) {
        const Transition *t = &b->a->transition.at[i];
        if (t->to == t->from)
            b->waits[at(t->from)] = true;
        else if (leads_on(b, t))
            b->ways[at(t->from)]++;
    }
}

static bool may_end_in_place(const FlowPlace *place)
{
    for (size_t k = 0; k < place->f->blk.n; k++)
        if (place->flow.reached[k] && place->f->blk.at[k].jump.kind == IR_RET)
            return true;
    return false;
}

// A state is always left by the end of its first step if one of its blocks can end only in transitions.
static void note_ends(Analysis *a, const FlowPlace *place, void *context)
{
    Search *b = context;

    (void)a;
    if (place->block != BLOCK_EXIT && !may_end_in_place(place))
        b->waits[at(place->state)] = false;
}

// ---- backward search ----

static void found_bound(Search *b, const State *s, uint32_t steps)
{
    b->out.bound[at(s)] = true;
    b->out.steps[at(s)] = steps;
    vec_push(b->a->arena, &b->found, s);
}

uint32_t abort_one_more(uint32_t steps) { return steps == ABORT_NOT_BOUNDED ? steps : steps + 1; }

static void found_way(Search *b, const State *from, const State *to)
{
    const State **longest = &b->out.onward[at(from)];

    if (!*longest || b->out.steps[at(to)] > b->out.steps[at(*longest)])
        *longest = to;
    if (--b->ways[at(from)] == 0)
        found_bound(b, from, b->waits[at(from)] ? ABORT_NOT_BOUNDED : abort_one_more(b->out.steps[at(*longest)]));
}

static void look_back(Search *b, const State *to)
{
    for (uint32_t k = b->first[at(to)]; k < b->first[to->number]; k++) {
        const Transition *t = &b->a->transition.at[b->into[k]];
        if (leads_on(b, t) && !t->from->is_abort)
            found_way(b, t->from, to);
    }
}

AbortBound abort_bound(Analysis *a)
{
    const size_t n = a->p->state.n;
    Search b = {a, {ARENA_ARRAY(a->arena, bool, n), ARENA_ARRAY(a->arena, uint32_t, n), ARENA_ARRAY(a->arena, const State *, n)},
                ARENA_ARRAY(a->arena, uint32_t, n), ARENA_ARRAY(a->arena, bool, n), NULL, NULL, {NULL, 0, 0}};

    for (size_t s = 0; s < n; s++)
        b.waits[s] = true;
    each_flow(a, note_ends, &b);
    count_ways(&b);
    sort_by_target(&b);
    for (size_t s = 0; s < n; s++)
        if (a->p->state.at[s]->is_abort)
            found_bound(&b, a->p->state.at[s], 0);
    for (size_t k = 0; k < b.found.n; k++)
        look_back(&b, b.found.at[k]);
    return b.out;
}
