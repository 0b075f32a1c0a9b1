// SPDX-License-Identifier: Apache-2.0
// The runs of given scripts as scenarios, from which a search can start.
#include <string.h>

#include "compiler/cli/cover_run.h"
#include "compiler/search/search.h"
#include "stdlib/convert.h"

enum { MOST_CHANGES = 32 };           // of a scenario: a generated script would repeat them

// An engine that passes everything on to another one, and records what is written.
typedef struct Recorder {
    Engine engine;
    Engine *inner;
    CoverRun *r;
    Scenario s;
    VEC(ScenarioChange) change;
    uint64_t *last;           // by variable: the cell of its last change
    bool *is_set;
    bool *writable;           // by variable: a search can set it
    uint64_t step;
    bool has_ended;           // the rest of the run is no scenario
} Recorder;

static void record_write(Recorder *k, const EngineWrite *w)
{
    const Program *p = k->r->p;
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
    vec_push(k->r->arena, &k->change, ((ScenarioChange){k->step, w->var, SCENARIO_HOLD, x, 0, 0}));
}

static EngineStatus recorder_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    Recorder *k = e->self;

    k->step++;
    for (uint32_t i = 0; i < n && !k->has_ended; i++)
        record_write(k, &write[i]);
    if (!k->has_ended)
        k->s.steps = k->step;
    return k->inner->step(k->inner, write, n, out);
}

static EngineStatus recorder_init(Engine *e, uint32_t state, EngineStep *out)
{
    Recorder *k = e->self;

    k->s.init_state = k->r->p->state.at[state - 1];
    return k->inner->init(k->inner, state, out);
}

static void recorder_close(Engine *e) { (void)e; }    // all its memory belongs to the arena

Engine *cover_open_recorder(CoverRun *r, Engine *inner, uint64_t delta_t)
{
    Recorder *k = ARENA_NEW(r->arena, Recorder);

    k->engine = *inner;
    k->engine.self = k;
    k->engine.init = recorder_init;
    k->engine.step = recorder_step;
    k->engine.close = recorder_close;
    k->inner = inner;
    k->r = r;
    k->s.delta_t = delta_t;
    k->last = ARENA_ARRAY(r->arena, uint64_t, r->p->var.n);
    k->is_set = arena_alloc(r->arena, r->p->var.n);
    k->writable = arena_alloc(r->arena, r->p->var.n);
    search_default_inputs(r->p, k->writable);
    return &k->engine;
}

void cover_keep_recorded(CoverRun *r, Engine *recorder)
{
    Recorder *k = recorder->self;

    while (k->change.n && k->change.at[k->change.n - 1].step > k->s.steps)
        k->change.n--;
    k->s.change = k->change.at;
    k->s.changes = k->change.n;
    if (k->s.steps)
        vec_push(r->arena, &r->recorded, k->s);
}
