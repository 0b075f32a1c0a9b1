// SPDX-License-Identifier: Apache-2.0
#include "compiler/search/scenario_record.h"

#include "compiler/search/search.h"
#include "stdlib/convert.h"

typedef struct ScenarioRecorder {
    Engine engine;
    Engine *inner;
    Arena *arena;
    Scenario s;
    VEC(ScenarioChange) change;
    uint64_t *last;           // by Var.index: the value that the run last wrote to the variable
    bool *is_set;             // by Var.index: the run has written to it
    const bool *writable;     // by Var.index: a search can set the variable
    size_t most;              // the most changes that are recorded
    uint64_t step;
    bool has_ended;           // nothing more is recorded: a scenario cannot express the rest of the run
    const Var *ended_by;      // the variable of the write that ended it
} ScenarioRecorder;

// Ends the recording at a step that a scenario cannot express; `by`: the variable whose write is the reason.
static void end_scenario(ScenarioRecorder *k, const Var *by)
{
    k->has_ended = true;
    k->ended_by = by;
}

// Records a write of the script as a change of an input; writes of G must follow the period of the steps.
static void record_write(ScenarioRecorder *k, const EngineWrite *w)
{
    const Program *p = k->engine.program;
    const Var *var = p->var.at[w->var];
    const double x = sm_cell_to_f64(var->type, w->cell);

    if (var == p->g) {
        if (w->cell != (k->step - 1) * k->s.delta_t)
            end_scenario(k, var);
        return;
    }
    if (k->is_set[w->var] && k->last[w->var] == w->cell)
        return;
    if (!k->writable[w->var] || k->change.n == k->most || sm_cell_from_f64(var->type, x) != w->cell) {
        end_scenario(k, var);
        return;
    }
    k->is_set[w->var] = true;
    k->last[w->var] = w->cell;
    vec_push(k->arena, &k->change, ((ScenarioChange){k->step, w->var, SCENARIO_HOLD, x, 0, 0}));
}

static EngineStatus recorder_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    ScenarioRecorder *k = e->self;

    k->step++;
    for (uint32_t i = 0; i < n && !k->has_ended; i++)
        record_write(k, &write[i]);
    if (!k->has_ended)
        k->s.steps = k->step;
    return k->inner->step(k->inner, write, n, out);
}

static EngineStatus recorder_init(Engine *e, uint32_t state, EngineStep *out)
{
    ScenarioRecorder *k = e->self;

    k->s.init_state = e->program->state.at[state - 1];
    return k->inner->init(k->inner, state, out);
}

static void recorder_close(Engine *e) { (void)e; }    // all its memory belongs to the arena

Engine *scenario_record_open(Arena *arena, const Program *p, Engine *inner, uint64_t delta_t, const bool *writable, size_t most)
{
    ScenarioRecorder *k = ARENA_NEW(arena, ScenarioRecorder);

    k->engine = *inner;
    k->engine.inside = inner;
    k->engine.self = k;
    k->engine.init = recorder_init;
    k->engine.step = recorder_step;
    k->engine.close = recorder_close;
    k->inner = inner;
    k->arena = arena;
    k->s.delta_t = delta_t;
    k->last = ARENA_ARRAY(arena, uint64_t, p->var.n);
    k->is_set = arena_alloc(arena, p->var.n);
    k->writable = writable;
    k->most = most;
    return &k->engine;
}

Scenario scenario_recorded(Engine *recorder)
{
    ScenarioRecorder *k = recorder->self;

    while (k->change.n && k->change.at[k->change.n - 1].step > k->s.steps)
        k->change.n--;
    k->s.change = k->change.at;
    k->s.changes = k->change.n;
    return k->s;
}

uint64_t scenario_recorded_steps(const Engine *recorder, const Var **ended_by)
{
    const ScenarioRecorder *k = recorder->self;

    *ended_by = k->ended_by;
    return k->step;
}
