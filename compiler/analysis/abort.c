// SPDX-License-Identifier: Apache-2.0
// The abort matrix: for each state its paths to @abort states.  A state is bound for an @abort state if it has transitions and
// all of them lead to bound or @abort states.
#include "compiler/analysis/abort.h"

static size_t index_of(const State *s) { return s->number - 1u; }

static uint32_t one_step_more(uint32_t steps) { return steps == ABORT_NOT_BOUNDED ? steps : steps + 1; }

// ---- bound states ----
// The search runs backwards from the @abort states and visits each transition once.

typedef struct BoundSearch {
    Analysis *a;
    AbortBound out;
    uint32_t *unbound;            // by state: transitions out of it whose target is not yet known to be bound
    bool *waits;                  // by state: the machine may stay in it for more than a step
    uint32_t *first, *into;       // transitions by target: into[first[target]] … into[first[target + 1]], numbers in the list
    VEC(const State *) found;     // states found to be bound; those whose incoming transitions are not yet visited come last
} BoundSearch;

// A transition from a state to itself does not lead to another state.
static bool leads_on(const BoundSearch *b, const Transition *t) { return b->a->stmt[t->stmt->number].reached && t->to != t->from; }

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
        b->into[next[index_of(list->at[i].to)]++] = (uint32_t)i;
}

// A state is always left by the end of its first step if one of its blocks can end only in transitions.
static void find_waiting_state(Analysis *a, const ReachableFn *r, void *context)
{
    BoundSearch *b = context;
    bool may_return = false;

    (void)a;
    for (size_t k = 0; k < r->fn->blk.n; k++)
        may_return |= r->flow.reached[k] && r->fn->blk.at[k].jump.kind == IR_RET;
    if (r->block != BLOCK_EXIT && !may_return)
        b->waits[index_of(r->state)] = false;
}

static void add_bound_state(BoundSearch *b, const State *s, uint32_t steps)
{
    b->out.bound[index_of(s)] = true;
    b->out.steps[index_of(s)] = steps;
    vec_push(b->a->arena, &b->found, s);
}

static void visit_transitions_into(BoundSearch *b, const State *to)
{
    for (uint32_t k = b->first[index_of(to)]; k < b->first[to->number]; k++) {
        const Transition *t = &b->a->transition.at[b->into[k]];
        const size_t from = index_of(t->from);
        const State **longest = &b->out.onward[from];
        if (!leads_on(b, t) || t->from->is_abort)
            continue;
        if (!*longest || b->out.steps[index_of(to)] > b->out.steps[index_of(*longest)])
            *longest = to;
        if (--b->unbound[from] == 0)
            add_bound_state(b, t->from, b->waits[from] ? ABORT_NOT_BOUNDED : one_step_more(b->out.steps[index_of(*longest)]));
    }
}

AbortBound abort_bound(Analysis *a)
{
    const size_t n = a->p->state.n;
    BoundSearch b = {.a = a};

    b.out = (AbortBound){ARENA_ARRAY(a->arena, bool, n), ARENA_ARRAY(a->arena, uint32_t, n), ARENA_ARRAY(a->arena, const State *, n)};
    b.unbound = ARENA_ARRAY(a->arena, uint32_t, n);
    b.waits = ARENA_ARRAY(a->arena, bool, n);
    for (size_t s = 0; s < n; s++)
        b.waits[s] = true;
    each_reachable_fn(a, find_waiting_state, &b);
    for (size_t i = 0; i < a->transition.n; i++) {
        const Transition *t = &a->transition.at[i];
        if (t->to == t->from)
            b.waits[index_of(t->from)] = true;
        else if (leads_on(&b, t))
            b.unbound[index_of(t->from)]++;
    }
    sort_by_target(&b);
    for (size_t s = 0; s < n; s++)
        if (a->p->state.at[s]->is_abort)
            add_bound_state(&b, a->p->state.at[s], 0);
    for (size_t k = 0; k < b.found.n; k++)
        visit_transitions_into(&b, b.found.at[k]);
    return b.out;
}

// ---- paths ----

bool abort_is_sure(const AbortPath *p) { return p->possible && p->steps != ABORT_NOT_BOUNDED; }

static void find_paths(Analysis *a, AbortMatrix *x, const AbortBound *b)
{
    for (size_t i = 0; i < a->transition.n; i++) {
        const Transition *t = &a->transition.at[i];
        AbortPath path = {.first = t, .guard = condition_text(a->arena, t->when)};
        if (!b->bound[index_of(t->to)] || t->from->is_abort || t->from == t->to)
            continue;
        path.steps = one_step_more(b->steps[index_of(t->to)]);
        path.possible = a->stmt[t->stmt->number].reached;
        vec_push(a->arena, &x->row[index_of(t->from)].path, path);
    }
}

// ---- verdicts ----

static AbortVerdict verdict_of(const Analysis *a, const AbortRow *r)
{
    bool possible = false;

    if (r->state->is_abort)
        return ABORT_ITSELF;
    if (!facts_may_reach(a->facts, index_of(r->state), BLOCK_ENTRY))
        return ABORT_UNREACHED;
    for (size_t k = 0; k < r->path.n; k++)
        possible |= r->path.at[k].possible;
    if (r->steps == 0)
        return possible ? ABORT_LATER : ABORT_NO_PATH;
    return r->by_command ? ABORT_BY_COMMAND : r->single || r->blind ? ABORT_ONE_SENSOR : ABORT_OK;
}

// ---- entry points ----

AbortMatrix abort_matrix(Trials *t)
{
    Analysis *a = t->a;
    AbortMatrix x = {false, ARENA_ARRAY(a->arena, AbortRow, a->p->state.n), a->p->state.n, NULL};
    const AbortBound b = abort_bound(a);

    for (size_t s = 0; s < x.n; s++) {
        x.row[s].state = a->p->state.at[s];
        x.row[s].onward = b.bound[s] ? b.onward[s] : NULL;
        x.declared |= x.row[s].state->is_abort;
    }
    find_paths(a, &x, &b);
    if (x.declared)
        abort_run_trials(t, &x, &b);
    for (size_t s = 0; s < x.n; s++) {
        AbortRow *r = &x.row[s];
        for (size_t k = 0; k < r->path.n; k++)
            if (abort_is_sure(&r->path.at[k]) && r->path.at[k].steps > r->steps)
                r->steps = r->path.at[k].steps;
        r->verdict = verdict_of(a, r);
    }
    return x;
}

const State *abort_onward(const AbortMatrix *x, const State *s) { return x->row[index_of(s)].onward; }
