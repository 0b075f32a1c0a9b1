// SPDX-License-Identifier: Apache-2.0
#include "compiler/search/mutant_reach.h"

#include "compiler/cover/mutant_cases.h"
#include "compiler/search/search.h"

// The search for the cases of a mutant.
typedef struct MutantReach {
    Mutation *u;
    const MutantCases *cases;
    Cover *cover;             // of the machine with probes
    bool is_excluded;         // all cases are impossible, from every start so far
} MutantReach;

// Makes the probes the only places that are not covered.
static void choose_goals(MutantReach *r)
{
    for (uint32_t i = 1; i < r->cover->place.n; i++)
        r->cover->hits[i] = 1;
    for (uint32_t i = 0; i < r->cases->at.n; i++)
        r->cover->hits[r->cover->probes.stmt[r->cases->at.at[i].probe]] = 0;
}

// Returns a scenario from this start whose last step reaches a case; NULL: none was found.
static const Scenario *search_from(MutantReach *r, const State *start, uint64_t effort)
{
    const SearchOptions o = {.seed = 1, .effort = effort, .delta_t = mutation_delta_t(r->u), .init_state = start, .any_elements = true,
                             .kinds = 1u << COVER_STATEMENT, .given = r->u->given, .givens = r->u->givens};
    const SearchResult *result = search_run(&r->u->work, r->cover, &o);
    const Scenario *found = NULL;

    for (uint32_t i = 0; i < r->cases->at.n && !found; i++) {
        const MutantCase *c = &r->cases->at.at[i];
        const SearchFind *f = &result->find[r->cover->probes.stmt[c->probe]];
        r->is_excluded = r->is_excluded && f->outcome == SEARCH_IMPOSSIBLE && c->certain == c->n;
        if (f->outcome == SEARCH_REACHED)
            found = &result->chosen[f->scenario].scenario;
    }
    return found;
}

static void mark_equivalent(Mutant *m)
{
    m->verdict = MUTANT_EQUIVALENT;
    m->if_only_inputs_change = true;
}

static void decide_mutant(Mutation *u, Mutant *m, uint64_t effort, uint64_t steps)
{
    MutantCases cases = mutant_cases_list(&u->work, u->p, m->edit, u->step);
    MutantProbes *probes;
    const Scenario *found = NULL;
    MutantReach r = {.u = u, .cases = &cases, .is_excluded = true};

    if (m->edit->kind == EDIT_INITIAL && mutant_initial_is_unread_from(&u->work, u->p, m->edit->var, u->start, u->starts)) {
        mark_equivalent(m);
        return;
    }
    if (cases.at.n == 0 || (probes = mutant_probes_insert(&u->work, u->p, &cases, false)) == NULL)
        return;
    r.cover = cover_new(&u->work, &probes->program);
    choose_goals(&r);
    for (uint32_t i = 0; i < u->starts && !found; i++)
        found = search_from(&r, u->start[i], effort);
    mutant_probes_remove(probes);
    if (found) {
        mutation_search_from(u, m, found, steps);
    } else if (r.is_excluded && !cases.unknown && u->step) {
        mark_equivalent(m);
    }
}

bool mutant_reach_next(Mutation *u, uint64_t effort, uint64_t steps)
{
    while (u->next_reach < u->mutant.n && u->mutant.at[u->next_reach].verdict != MUTANT_UNNOTICED)
        u->next_reach++;
    if (u->next_reach == u->mutant.n)
        return false;
    arena_reset(&u->work);
    decide_mutant(u, &u->mutant.at[u->next_reach++], effort, steps);
    return true;
}
