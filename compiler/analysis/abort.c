// SPDX-License-Identifier: Apache-2.0
// Builds the abort matrix: for each state, its paths to @abort states.  A state is called *bound* (on its way to an @abort state) if a run
// that leaves it can only end in an @abort state: it has transitions to other states, and each leads to an @abort state or a bound state.
#include "compiler/analysis/abort.h"

static size_t state_index(const State *s) { return s->number - 1u; }

static uint32_t add_one_step(uint32_t steps) { return steps == ABORT_NOT_BOUNDED ? steps : steps + 1; }

// ---- bound states ----
// The search runs backwards from the @abort states and visits each transition once.

typedef struct BoundSearch {
    Analysis *a;
    AbortBound out;
    uint32_t *unbound;            // by state: number of transitions out of the state whose target is not yet known to be bound
    bool *may_wait;               // by state: the machine may stay in the state for more than a step
    uint32_t *first, *into;       // the transitions into a state are into[first[i]] … into[first[i + 1] - 1], as indices in
                                  // Analysis.transition; i is the state's index
    VEC(const State *) found;     // the @abort states and the states found to be bound, in the order in which the search visits them
} BoundSearch;

// Whether the transition can be taken and its target is not the state that contains it.
static bool leads_elsewhere(const BoundSearch *b, const Transition *t) { return b->a->stmt[t->stmt->number].reached && t->to != t->from; }

// Fills in `first` and `into`, by counting sort.
static void sort_by_target(BoundSearch *b)
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
        b->into[next[state_index(list->at[i].to)]++] = (uint32_t)i;
}

// Called for each reachable function.  Clears b->may_wait of a state whose .entry or .step always ends in a transition: the machine
// leaves the state in its first step.
static void clear_may_wait_if_left_at_once(Analysis *a, const ReachableFn *r, void *context)
{
    BoundSearch *b = context;
    bool may_return = false;

    (void)a;
    for (size_t k = 0; k < r->fn->blk.n; k++)
        may_return |= r->flow.reached[k] && r->fn->blk.at[k].jump.kind == IR_RET;
    if (r->block != BLOCK_EXIT && !may_return)
        b->may_wait[state_index(r->state)] = false;
}

// Marks s as bound: every path from it ends in an @abort state.  `steps`: the most steps of such a path.
static void add_bound_state(BoundSearch *b, const State *s, uint32_t steps)
{
    b->out.bound[state_index(s)] = true;
    b->out.steps[state_index(s)] = steps;
    vec_push(b->a->arena, &b->found, s);
}

// Called once for each state `to` that is bound or an @abort state: subtracts 1 from `unbound` of a state for each of its transitions to `to`.
// A state becomes bound when its `unbound` becomes 0.
static void visit_transitions_into(BoundSearch *b, const State *to)
{
    for (uint32_t k = b->first[state_index(to)]; k < b->first[to->number]; k++) {
        const Transition *t = &b->a->transition.at[b->into[k]];
        const size_t from = state_index(t->from);
        const State **longest = &b->out.next[from];
        if (!leads_elsewhere(b, t) || t->from->is_abort)
            continue;
        if (!*longest || b->out.steps[state_index(to)] > b->out.steps[state_index(*longest)])
            *longest = to;
        if (--b->unbound[from] == 0)
            add_bound_state(b, t->from, b->may_wait[from] ? ABORT_NOT_BOUNDED : add_one_step(b->out.steps[state_index(*longest)]));
    }
}

// Finds the states from which every path leads to an @abort state, and the most steps of these paths; ABORT_NOT_BOUNDED if the machine may wait
// in a state on a path.
AbortBound abort_find_bound(Analysis *a)
{
    const size_t n = a->p->state.n;
    BoundSearch b = {.a = a};

    b.out = (AbortBound){ARENA_ARRAY(a->arena, bool, n), ARENA_ARRAY(a->arena, uint32_t, n), ARENA_ARRAY(a->arena, const State *, n)};
    b.unbound = ARENA_ARRAY(a->arena, uint32_t, n);
    b.may_wait = ARENA_ARRAY(a->arena, bool, n);
    for (size_t s = 0; s < n; s++)
        b.may_wait[s] = true;
    each_reachable_fn(a, clear_may_wait_if_left_at_once, &b);
    for (size_t i = 0; i < a->transition.n; i++) {
        const Transition *t = &a->transition.at[i];
        if (t->to == t->from)
            b.may_wait[state_index(t->from)] = true;
        else if (leads_elsewhere(&b, t))
            b.unbound[state_index(t->from)]++;
    }
    sort_by_target(&b);
    for (size_t s = 0; s < n; s++)
        if (a->p->state.at[s]->is_abort)
            add_bound_state(&b, a->p->state.at[s], 0);
    for (size_t k = 0; k < b.found.n; k++)
        visit_transitions_into(&b, b.found.at[k]);
    return b.out;
}

// ---- the matrix ----

bool abort_is_bounded(const AbortPath *p) { return p->possible && p->steps != ABORT_NOT_BOUNDED; }

// Sums up a row of the abort table: whether the state can abort, by itself or by a command, or why not.
static AbortVerdict abort_verdict_of(const Analysis *a, const AbortRow *r)
{
    bool possible = false;

    if (r->state->is_abort)
        return ABORT_ITSELF;
    if (!facts_may_reach(a->facts, state_index(r->state), BLOCK_ENTRY))
        return ABORT_UNREACHED;
    for (size_t k = 0; k < r->path.n; k++)
        possible |= r->path.at[k].possible;
    if (r->steps == 0)
        return possible ? ABORT_LATER : ABORT_NO_PATH;
    return r->by_command ? ABORT_BY_COMMAND : r->single || r->blind ? ABORT_ONE_SENSOR : ABORT_OK;
}

AbortMatrix abort_build_matrix(Trials *t)
{
    Analysis *a = t->a;
    AbortMatrix x = {false, ARENA_ARRAY(a->arena, AbortRow, a->p->state.n), a->p->state.n, NULL};
    const AbortBound b = abort_find_bound(a);

    for (size_t s = 0; s < x.n; s++) {
        x.row[s].state = a->p->state.at[s];
        x.row[s].next = b.bound[s] ? b.next[s] : NULL;
        x.declared |= x.row[s].state->is_abort;
    }
    for (size_t i = 0; i < a->transition.n; i++) {
        const Transition *first = &a->transition.at[i];
        AbortPath path = {.first = first, .guard = condition_text(a->arena, first->when)};
        if (!b.bound[state_index(first->to)] || first->from->is_abort || first->from == first->to)
            continue;
        path.steps = add_one_step(b.steps[state_index(first->to)]);
        path.possible = a->stmt[first->stmt->number].reached;
        vec_push(a->arena, &x.row[state_index(first->from)].path, path);
    }
    if (x.declared)
        abort_run_trials(t, &x, &b);
    for (size_t s = 0; s < x.n; s++) {
        AbortRow *r = &x.row[s];
        for (size_t k = 0; k < r->path.n; k++)
            if (abort_is_bounded(&r->path.at[k]) && r->path.at[k].steps > r->steps)
                r->steps = r->path.at[k].steps;
        r->verdict = abort_verdict_of(a, r);
    }
    return x;
}

// Returns the state after s on the longest path to an @abort state.
const State *abort_next_state(const AbortMatrix *x, const State *s) { return x->row[state_index(s)].next; }
