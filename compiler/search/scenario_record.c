// SPDX-License-Identifier: Apache-2.0
#include "compiler/search/scenario_record.h"

#include "compiler/search/search.h"
#include "stdlib/convert.h"

enum { MOST_CHANGES = 32 };

typedef struct ScenarioRecorder {
    Engine engine;
    Engine *inner;
    Arena *arena;
    Scenario s;
    VEC(ScenarioChange) change;
    uint64_t *last;           // by variable: the cell of its last change
    bool *is_set;
    bool *writable;           // by variable: a search can set it
    uint64_t step;
    bool has_ended;           // the rest of the run is no scenario
} ScenarioRecorder;

static void record_write(ScenarioRecorder *k, const EngineWrite *w)
{
    const Program *p = k->engine.program;
    const double x = sm_cell_to_f64(p->var.at[w->var]->type, w->cell);

    if (p->var.at[w->var] == p->g) {
        k->has_ended |= w->cell != (k->step - 1) * k->s.delta_t;
        return;
    }
    if (k->is_set[w->var] && k->last[w->var] == w->cell)
        return;
    k->has_ended |= !k->writable[w->var] || k->change.n == MOST_CHANGES || x != x;
    if (k->has_ended)
        return;
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

Engine *scenario_record_open(Arena *arena, const Program *p, Engine *inner, uint64_t delta_t)
{
    ScenarioRecorder *k = ARENA_NEW(arena, ScenarioRecorder);

    k->engine = *inner;
    k->engine.self = k;
    k->engine.init = recorder_init;
    k->engine.step = recorder_step;
    k->engine.close = recorder_close;
    k->inner = inner;
    k->arena = arena;
    k->s.delta_t = delta_t;
    k->last = ARENA_ARRAY(arena, uint64_t, p->var.n);
    k->is_set = arena_alloc(arena, p->var.n);
    k->writable = arena_alloc(arena, p->var.n);
    search_default_inputs(p, k->writable);
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
