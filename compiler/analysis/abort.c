// SPDX-License-Identifier: Apache-2.0
// The abort matrix: for each state its paths to @abort states.
#include "compiler/analysis/abort.h"

static size_t at(const State *s) { return s->number - 1u; }

// ---- paths ----

static AbortWay way_of(Analysis *a, const AbortBound *b, const Transition *t)
{
    AbortWay w = {.first = t, .guard = condition_text(a->arena, t->when)};

    w.steps = abort_one_more(b->steps[at(t->to)]);
    w.possible = a->stmt[t->stmt->number].reached;
    return w;
}

static void add_ways(Analysis *a, AbortMatrix *x, const AbortBound *b)
{
    for (size_t i = 0; i < a->transition.n; i++) {
        const Transition *t = &a->transition.at[i];
        if (b->bound[at(t->to)] && !t->from->is_abort && t->from != t->to)
            vec_push(a->arena, &x->row[at(t->from)].way, way_of(a, b, t));
    }
}

// ---- verdicts ----

bool abort_is_sure(const AbortWay *w) { return w->possible && w->steps != ABORT_NOT_BOUNDED; }

static uint32_t worst_steps(const AbortRow *r)
{
    uint32_t worst = 0;

    for (size_t w = 0; w < r->way.n; w++)
        if (abort_is_sure(&r->way.at[w]) && r->way.at[w].steps > worst)
            worst = r->way.at[w].steps;
    return worst;
}

static bool has_way(const AbortRow *r)
{
    for (size_t w = 0; w < r->way.n; w++)
        if (r->way.at[w].possible)
            return true;
    return false;
}

static AbortVerdict verdict_of(const Analysis *a, const AbortRow *r)
{
    if (r->state->is_abort)
        return ABORT_ITSELF;
    if (!facts_may_reach(a->facts, at(r->state), BLOCK_ENTRY))
        return ABORT_UNREACHED;
    if (r->steps == 0)
        return has_way(r) ? ABORT_LATER : ABORT_NO_PATH;
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
    add_ways(a, &x, &b);
    if (x.declared)
        abort_ask(t, &x, &b);
    for (size_t s = 0; s < x.n; s++) {
        x.row[s].steps = worst_steps(&x.row[s]);
        x.row[s].verdict = verdict_of(a, &x.row[s]);
    }
    return x;
}

const State *abort_onward(const AbortMatrix *x, const State *s) { return x->row[at(s)].onward; }
