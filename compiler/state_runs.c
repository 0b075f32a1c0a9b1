// SPDX-License-Identifier: Apache-2.0
#include "compiler/state_runs.h"

#include "compiler/search/search.h"

// The search ends after STEPS_MAX steps, of a machine with many statements after fewer: about STATEMENTS_MAX divided by the number of its statements.
enum { STEPS_MAX = 400000, STEPS_MIN = 20000, STATEMENTS_MAX = 120000000, MEMORY_MAX = 64 << 20 };

AnalysisRuns state_runs_find(Arena *arena, const Program *p, uint64_t delta_t, const uint64_t *parameter, uint32_t share)
{
    const uint64_t steps = STATEMENTS_MAX / (p->stmts + 1u);
    const SearchOptions o = {.seed = 1, .delta_t = delta_t, .kinds = 1u << COVER_STATE, .memory = MEMORY_MAX, .stays = true,
                             .drafts = true, .initial = parameter,
                             .effort = (steps > STEPS_MAX ? STEPS_MAX : steps < STEPS_MIN ? STEPS_MIN : steps) / share};
    Cover *c = cover_new(arena, p);
    const SearchResult *found;
    Scenario *run;

    for (uint32_t i = 1; i < c->place.n; i++)
        c->hits[i] = c->place.at[i].kind == COVER_STATE && !c->place.at[i].value;        // that a state is left is no goal
    found = search_run(arena, c, &o);
    run = ARENA_ARRAY(arena, Scenario, found->chosens + 1u);
    for (uint32_t i = 0; i < found->chosens; i++)
        run[i] = scenario_unroll(arena, &found->chosen[i].scenario);
    return (AnalysisRuns){run, found->chosens};
}
