// SPDX-License-Identifier: Apache-2.0
// Runs scenarios on engines.
#include "compiler/search/search.h"
#include "stdlib/convert.h"

uint64_t scenario_cell(const Program *p, const ScenarioChange *c, uint64_t step, const uint64_t *cell)
{
    const SmType type = p->var.at[c->var]->type;
    double x = c->a;

    switch (c->kind) {
    case SCENARIO_HOLD: break;
    case SCENARIO_ALTERNATE: x = (step - c->step) % 2 ? c->b : c->a; break;
    case SCENARIO_RAMP: x = c->a + c->b * (double)(step - c->step); break;
    case SCENARIO_COPY: x = sm_cell_to_f64(p->var.at[c->source]->type, cell[c->source]); break;
    }
    return sm_cell_from_f64(type, x);
}

void search_default_inputs(const Program *p, bool *writable)
{
    for (uint32_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        writable[i] = v->kind == VAR_ELEMENT ? v != p->g && v != p->s && !v->written && v->read : v->kind == VAR_LOCAL && v->outside;
    }
}

EngineStatus scenario_run(Arena *arena, const Program *p, const Scenario *s, Engine *e, void (*after)(void *context, uint64_t step, const EngineStep *result),
                          void *context)
{
    const ScenarioChange **current = arena_array(arena, p->var.n, sizeof *current);
    EngineWrite *write = arena_array(arena, p->var.n + 1, sizeof *write);
    EngineStep result;
    size_t next = 0;

    engine_step_init(&result, arena, p);
    if (e->init(e, s->init_state->number, &result) != ENGINE_OK)
        return result.status;
    for (uint64_t step = 1; step <= s->steps; step++) {
        uint32_t n = 1;
        write[0] = (EngineWrite){p->g->index, (step - 1) * s->delta_t};
        for (; next < s->changes && s->change[next].step <= step; next++)
            current[s->change[next].var] = &s->change[next];
        for (uint32_t v = 0; v < p->var.n; v++)
            if (current[v])
                write[n++] = (EngineWrite){v, scenario_cell(p, current[v], step, result.cell)};
        if (e->step(e, write, n, &result) != ENGINE_OK)
            return result.status;
        if (after)
            after(context, step, &result);
    }
    return ENGINE_OK;
}
