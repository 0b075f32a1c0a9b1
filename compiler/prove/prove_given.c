// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_given.h"

#include "compiler/prove/prove_goal.h"
#include "compiler/search/scenario_record.h"

enum {
    STEPS_MOST = 1000000,     // the most steps of a script
    CHANGES_MOST = 1000000    // the most changes that are recorded: recorded data sets inputs in each row
};

bool prove_record_script(Arena *arena, Diags *diags, const Program *p, const Program *flown, const Script *s, ProveGiven *out)
{
    const ScriptOptions o = {.max_steps = STEPS_MOST, .is_compared = true};
    Engine *inner = engine_ref_open(arena, p);
    Engine *e = scenario_record_open(arena, p, inner, s->delta_t, goal_inputs(arena, p), CHANGES_MOST);
    const bool passed = script_run(arena, diags, s, &e, 1, &o).outcome == SCRIPT_PASSED;
    const Var *ended_by;

    *out = (ProveGiven){.name = s->src->name, .run = scenario_recorded(e)};
    out->ran = scenario_recorded_steps(e, &ended_by);
    out->ended_by = ended_by;
    out->run.init_state = flown->state.at[out->run.init_state->number - 1];
    inner->close(inner);
    return passed;
}

bool prove_uses_given(const ProveGiven *g, const State *init_state, uint64_t delta_t)
{
    return g->run.init_state == init_state && g->run.delta_t == delta_t && g->run.steps > 0;
}

typedef struct GivenJudge { Monitor *monitor; void *situation; GivenResult *result; } GivenJudge;

// Called after each step of a given run: judges the requirements, and stores the first violation of each.
static void judge_step(void *context, uint64_t step, const EngineStep *result)
{
    const GivenJudge *k = context;

    monitor_step(k->monitor, k->situation, result->cell);
    for (size_t i = 0; i < k->monitor->what->at.n; i++) {
        GivenResult *r = &k->result[i];
        r->premise_seen |= k->monitor->result[i] != MONITOR_IDLE;
        if (k->monitor->result[i] == MONITOR_VIOLATED && r->violated == 0)
            r->violated = step;
    }
}

const GivenResult *prove_judge_given(Arena *arena, const Requirements *all, const Scenario *s)
{
    GivenJudge k = {.monitor = monitor_new(arena, all, s->delta_t), .result = ARENA_ARRAY(arena, GivenResult, all->at.n + 1)};
    Engine *e = engine_ref_open(arena, all->program);

    k.situation = arena_alloc(arena, k.monitor->size);
    monitor_start(k.monitor, k.situation);
    scenario_run(arena, all->program, s, e, judge_step, &k);
    e->close(e);
    return k.result;
}
