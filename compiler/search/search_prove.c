// SPDX-License-Identifier: Apache-2.0
// Proves that goals are impossible, beyond what facts prove about single values (cover_find_impossible).
//
// 1. Facts about the runs of this search (run_facts.h) exclude it.
// 2. A state is unreachable if every transition to it from a reachable state is impossible.  All its places are then impossible.
// 3. The decisions on the path to a place, and its own conditions, compare values of one step.  Values that are compared with constants are
//    split into regions between these constants, and two values that are compared with each other into less, equal and greater.  If no
//    combination of regions takes the path, no step does.  Unknown values can be in any region, independently of each other, except for the
//    relations of search_lemmas.c.
#include "compiler/search/search_regions.h"

// ---- sites ----

// Returns the truth of a part of a decision in the current combination of regions.
static bool node_truth(Prover *p, const FlatDecision *d, uint32_t n)
{
    const FlatNode *node = &d->node[n];

    switch (node->kind) {
    case NODE_CONDITION: return region_truth(p, &p->own, d->condition[node->a]);
    case NODE_NOT: return !node_truth(p, d, node->a);
    case NODE_AND: return node_truth(p, d, node->a) && node_truth(p, d, node->b);
    default: return node_truth(p, d, node->a) || node_truth(p, d, node->b);
    }
}

// Whether a condition has the value and decides, in the current combination.
static bool condition_decides(Prover *p, const FlatDecision *d, uint32_t condition, bool value)
{
    uint32_t n = 0;

    while (d->node[n].kind != NODE_CONDITION || d->node[n].a != condition)
        n++;
    if (node_truth(p, d, n) != value)
        return false;
    for (uint32_t up = n + 1; up < d->nodes; up++) {
        const FlatNode *node = &d->node[up];
        const bool joins = node->kind == NODE_AND || node->kind == NODE_OR;
        if (node->kind == NODE_CONDITION || (node->a != n && !(joins && node->b == n)))
            continue;
        if (joins && node_truth(p, d, node->a == n ? node->b : node->a) != (node->kind == NODE_AND))
            return false;
        n = up;
    }
    return true;
}

// Whether the current combination of regions takes the path to a goal: every decision that is certain has the outcome that it needs.
static bool takes_path(Prover *p, const SearchSite *site)
{
    for (uint32_t e = site->path.n; e-- > 0; ) {
        const FlatDecision *d = p->k->decision[site->path.elem[e].decision].d;
        if (!site->path.elem[e].is_certain)
            continue;
        if (e == 0 && site->condition != SEARCH_NONE ? !condition_decides(p, d, site->condition, site->value)
                                                     : node_truth(p, d, d->nodes - 1) != site->path.elem[e].value)
            return false;
    }
    return true;
}

// Adds what the conditions on the path of a site compare.  Returns false if it is too much.
static bool add_path(Prover *p, const SearchSite *site)
{
    p->groups = p->lemmas = 0;
    p->fits = true;
    for (uint32_t e = 0; e < site->path.n; e++) {
        const SearchDecision *d = &p->k->decision[site->path.elem[e].decision];
        if (d->fn != p->fn)
            return false;
        for (uint32_t c = 0; c < d->d->conditions; c++)
            region_add_condition(p, &p->own, d->d->condition[c]);
    }
    return p->fits;
}

// Whether any consistent combination of regions takes the path to a goal.  If no combination does, the goal cannot be reached there.
static bool has_combination(Prover *p, const SearchSite *site)
{
    do
        if (takes_path(p, site) && region_is_consistent(p))
            return true;
    while (region_next(p));
    return false;
}

// Whether no step takes the path of a site.  Without room for the lemmas, tries without them.
static bool is_excluded(Prover *p, const SearchSite *site)
{
    if (site->path.n == 0)
        return false;
    if (p->k->decision[site->path.elem[0].decision].fn != p->fn || !p->own.value_of)
        region_number_values(p, p->k->decision[site->path.elem[0].decision].fn);
    if (!add_path(p, site))
        return false;
    region_find_lemmas(p);
    if (!p->fits || region_combinations(p) > MOST_COMBINATIONS) {
        add_path(p, site);
        if (region_combinations(p) > MOST_COMBINATIONS)
            return false;
    }
    return !has_combination(p, site);
}

// ---- states ----

static void find_reachable(const SearchRun *k, bool *reachable)
{
    reachable[k->start->number - 1] = true;
    for (bool again = true; again; ) {
        again = false;
        for (uint32_t i = 0; i < k->exit.n; i++) {
            const SearchExit *x = &k->exit.at[i];
            const uint32_t place = k->c->probes.transition[x->stmt];
            if (!reachable[x->from - 1] || reachable[x->to - 1] || (k->r->find[place].outcome == SEARCH_IMPOSSIBLE))
                continue;
            reachable[x->to - 1] = again = true;
        }
    }
}

// ---- goals ----

// Closes a goal as impossible, with the reason as a sentence.
static void mark_impossible(SearchRun *k, SearchGoal *g, const char *reason)
{
    SearchFind *f = &k->r->find[g->place];

    f->outcome = SEARCH_IMPOSSIBLE;
    f->reason = reason;
    g->done = true;
    k->open--;
}

static RunFacts *facts_of_runs(SearchRun *k, Arena *known)
{
    bool *is_input = arena_alloc(&k->work, k->m->var.n);

    for (uint32_t i = 0; i < k->inputs; i++)
        is_input[k->input[i].at] = true;
    for (uint32_t v = 0; v < k->p->var.n && k->o->place; v++)
        if (k->o->place->foreign[v])
            is_input[k->m->var_of[v]] = true;
    return run_facts_new(&k->work, known, k->m, is_input, k->delta_t * k->every, (RunStart){k->start->number, k->o->any_elements});
}

// Marks the goals that facts about all runs exclude.
static void prove_by_facts(SearchRun *k, RunFacts *facts)
{
    const char **reason = arena_array(&k->work, k->r->places, sizeof *reason);

    run_facts_exclude(facts, k->c, k->arena, reason);
    for (uint32_t i = 0; i < k->goals; i++) {
        SearchGoal *g = &k->goal[i];
        if (g->place < k->r->places && !g->done && reason[g->place])
            mark_impossible(k, g, reason[g->place]);
    }
}

// Marks the goals none of whose paths any combination of regions takes.
static void prove_paths(SearchRun *k, RunFacts *facts)
{
    const char *const counted = format_in(k->arena, "what is counted before it takes longer, if only inputs change, and delta_t is %lu", (unsigned long)(k->delta_t * k->every));
    Prover *p = ARENA_NEW(&k->work, Prover);

    p->k = k;
    p->facts = facts;
    for (uint32_t i = 0; i < k->goals; i++) {
        SearchGoal *g = &k->goal[i];
        bool excluded = g->site.n > 0 && g->place < k->r->places && !g->done;
        p->counted = false;
        for (uint32_t s = 0; s < g->site.n && excluded; s++)
            excluded = is_excluded(p, &g->site.at[s]);
        if (excluded && k->c->place.at[g->place].kind != COVER_STATE)
            mark_impossible(k, g, p->counted ? counted : "the conditions before it and beside it exclude it");
    }
}

// Marks the goals in states that no transition leads to.
static void prove_states(SearchRun *k)
{
    bool *reachable = arena_alloc(&k->work, k->p->state.n);

    find_reachable(k, reachable);
    for (uint32_t i = 0; i < k->goals; i++) {
        SearchGoal *g = &k->goal[i];
        const CoverPlace *place = g->place < k->r->places ? &k->c->place.at[g->place] : NULL;
        bool excluded = place && g->site.n > 0 && !g->done && place->kind != COVER_STATE;       // a run can begin in a state
        if (!place || g->done)
            continue;
        for (uint32_t s = 0; s < g->site.n && excluded; s++)
            excluded = g->site.at[s].state != 0 && !reachable[g->site.at[s].state - 1];
        if (excluded || (place->kind == COVER_STATE && !reachable[place->from->number - 1]))
            mark_impossible(k, g, "no run enters its state");
    }
}

// Whether an open goal is no state.  Facts and regions prove nothing about states directly.
static bool has_goal_in_states(const SearchRun *k)
{
    for (uint32_t i = 0; i < k->goals; i++)
        if (!k->goal[i].done && k->goal[i].place < k->r->places && k->c->place.at[k->goal[i].place].kind != COVER_STATE)
            return true;
    return false;
}

void search_prove(SearchRun *k)
{
    if (k->o->no_places)
        return;
    if (has_goal_in_states(k)) {
        const bool no_facts = k->o->place && k->o->place->no_facts;
        Arena known;
        RunFacts *facts;
        arena_init_within(&known, k->arena);
        facts = no_facts ? NULL : facts_of_runs(k, &known);
        prove_paths(k, facts);
        if (facts)
            prove_by_facts(k, facts);
        arena_free_into(&known, &k->work);
    }
    prove_states(k);
}
