// SPDX-License-Identifier: Apache-2.0
// The steps of given runs at which inputs are changed.  Each run is made twice: to choose its steps, and to store the states before them.
#include <string.h>

#include "compiler/prove/prove_near_parts.h"

enum {
    MOST_STEPS = 300,         // the most steps that are chosen, in all given runs together
    MOST_ALIKE = 3,           // the most transitions between the same two states that are chosen; one in each given run
    MOST_CHANGES = 4,         // how often a change of the same comparison of the requirement is chosen
    MOST_WINDOWS = 4,         // how many sizes of windows are tried as the distance of a step before a transition
    RANKS = 4,
    UNWANTED = RANKS          // the rank of a step that is not chosen
};
#define MOST_MEMORY ((size_t)64 << 20)        // bytes of all snapshots

// The first replay of a given run, which chooses steps.
typedef struct Look {
    NearSearch *k;
    uint8_t *rank;            // by step: UNWANTED, or the rank; a smaller one replaces a greater one
    uint64_t steps;           // steps of the given run
    uint64_t entered;         // the first step since the current state was entered
    uint8_t *alike, *met;     // by from * states + to: number of such transitions that are chosen in all runs; whether this run has chosen one
    uint8_t *changes;         // by comparison of the requirement: number of its changes that are chosen in all runs
    int8_t *was;              // by comparison of the requirement: -1, 0 or 1 if its left side was below, equal to or above its right side in the last
                              // step; 2: unknown
} Look;

// Marks a step as one where changes are tried; a smaller rank is tried earlier.
static void want(Look *l, uint64_t step, uint32_t rank)
{
    if (step >= 1 && step <= l->steps && rank < l->rank[step])
        l->rank[step] = (uint8_t)rank;
}

// Marks the step of a transition, unless enough transitions of the same kind are marked; one that the requirement names comes first.
static void want_transition(Look *l, uint64_t step, uint32_t from, uint32_t to)
{
    NearSearch *k = l->k;
    const size_t pair = (from - 1) * k->p->state.n + (to - 1);
    const uint32_t rank = k->is_named[from] || k->is_named[to] ? 0 : 2;

    if (l->met[pair] || l->alike[pair] >= MOST_ALIKE)
        return;
    l->met[pair] = 1;
    l->alike[pair]++;
    want(l, step, rank);
    want(l, step - 1, rank);
    want(l, step + 1, rank);
    want(l, (l->entered + step) / 2, rank + 1);
    // For an `after`, steps before every such transition are chosen: what a change there leads to differs from run to run.
    for (uint32_t i = 0; (l->alike[pair] == 1 || k->what->kind == REQUIREMENT_AFTER) && i < k->window.n && i < MOST_WINDOWS; i++)
        for (uint32_t more = 0; more < 2 && k->window.at[i] + more <= step; more++)
            want(l, step + 1 - k->window.at[i] - more, i < k->required_windows ? rank : rank + 1);
}

// Wants the steps at which a comparison of the requirement changes.
static void want_changes(Look *l, uint64_t step)
{
    NearSearch *k = l->k;

    for (uint32_t i = 0; i < k->required; i++) {
        const NearLeaf *leaf = &k->leaf.at[i];
        const double a = near_value_of(k, leaf->left), b = leaf->right ? near_value_of(k, leaf->right) : 0;
        const int8_t now = a < b ? -1 : a > b ? 1 : a == b ? 0 : 2;
        if (l->was[i] != 2 && now != l->was[i] && l->changes[i] < MOST_CHANGES) {
            l->changes[i]++;
            want(l, step, 1);
            want(l, step + 1, 1);
        }
        l->was[i] = now;
    }
}

// Runs a given run and marks the steps at which a change could violate the requirement.
static void look_at(Look *l, uint32_t given)
{
    NearSearch *k = l->k;
    const Scenario *s = &k->g->given[given];
    const size_t places = (size_t)s->steps + 2;       // entries by number of the step, from 1, and one more
    size_t next = 0;
    MonitorResult last = MONITOR_IDLE;

    l->steps = s->steps;
    l->entered = 1;
    l->rank = arena_alloc(k->work, places);
    memset(l->rank, UNWANTED, places);
    memset(l->met, 0, (size_t)k->p->state.n * k->p->state.n);
    memset(l->was, 2, k->required + 1);
    k->trace[given] = arena_array(k->work, places, sizeof **k->trace);
    near_begin(k, s);
    for (uint64_t step = 1; step <= s->steps && k->steps < k->limit; step++) {
        const uint32_t from = near_state(k);
        MonitorResult now;
        next = near_set_inputs(k, s, next, step);
        now = near_run_step(k, step);
        k->trace[given][step] = near_trace(k);
        if (now != MONITOR_IDLE && last == MONITOR_IDLE)
            want(l, step, 1);
        last = now;
        want_changes(l, step);
        if (near_state(k) != from) {
            want_transition(l, step, from, near_state(k));
            l->entered = step + 1;
        }
    }
}

// Stores a snapshot of the machine at each step that is marked.
static void store_steps(NearSearch *k, const Look *l, uint32_t given)
{
    const Scenario *s = &k->g->given[given];
    size_t next = 0;
    uint64_t last = 0;

    for (uint64_t step = 1; step <= s->steps; step++)
        last = l->rank[step] != UNWANTED ? step : last;
    near_begin(k, s);
    for (uint64_t step = 1; step <= last && k->steps < k->limit; step++) {
        if (l->rank[step] != UNWANTED) {
            const NearStep one = {given, l->rank[step], step, next, arena_copy(k->work, k->block, k->size)};
            vec_push(k->work, &k->step, one);
        }
        next = near_set_inputs(k, s, next, step);
        near_run_step(k, step);
    }
}

// Makes steps unwanted, those with the greatest rank first, until the others fit.
static void choose_steps(Look *look, uint32_t givens, size_t most)
{
    size_t n = 0;

    for (uint32_t rank = 0; rank < RANKS; rank++)
        for (uint32_t i = 0; i < givens; i++)
            for (uint64_t step = 1; step <= look[i].steps; step++)
                if (look[i].rank[step] == rank && n++ >= most)
                    look[i].rank[step] = UNWANTED;
}

static bool is_before(const NearStep *a, const NearStep *b)
{
    return a->rank != b->rank ? a->rank < b->rank : a->step != b->step ? a->step < b->step : a->given < b->given;
}

// Sorts by rank.  Of equal ones, an early step comes first: what it shows is a short run.
static void sort_steps(NearSearch *k)
{
    for (uint32_t n = 1; n < k->step.n; n++) {
        const NearStep one = k->step.at[n];
        uint32_t at = n;
        for (; at > 0 && is_before(&one, &k->step.at[at - 1]); at--)
            k->step.at[at] = k->step.at[at - 1];
        k->step.at[at] = one;
    }
}

void near_find_steps(NearSearch *k)
{
    const uint32_t givens = k->g->givens;
    const size_t pairs = (size_t)k->p->state.n * k->p->state.n, room = MOST_MEMORY / k->size + 1;
    Look *look = arena_array(k->work, givens + 1, sizeof *look), l = {.k = k};

    k->trace = arena_array(k->work, givens + 1, sizeof *k->trace);
    l.alike = arena_alloc(k->work, pairs);
    l.met = arena_alloc(k->work, pairs);
    l.changes = arena_alloc(k->work, k->required + 1);
    l.was = arena_alloc(k->work, k->required + 1);
    for (uint32_t i = 0; i < givens; i++) {
        look_at(&l, i);
        look[i] = l;
    }
    choose_steps(look, givens, room < MOST_STEPS ? room : MOST_STEPS);
    for (uint32_t i = 0; i < givens; i++)
        store_steps(k, &look[i], i);
    sort_steps(k);
}
