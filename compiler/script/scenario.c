// SPDX-License-Identifier: Apache-2.0
// Runs scenarios on engines.
#include "compiler/script/scenario.h"

#include "compiler/base/arena.h"
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

size_t scenario_times(const Scenario *s)
{
    size_t n = 0;

    for (size_t i = 0; i < s->changes; i++)
        n += i == 0 || s->change[i].step != s->change[i - 1].step;
    return n;
}

const ScenarioLoop *scenario_loop_at(const Scenario *s, uint64_t step)
{
    for (size_t i = 0; i < s->loops; i++)
        if (step >= s->loop[i].from && step < s->loop[i].from + s->loop[i].period)
            return &s->loop[i];
    return NULL;
}

// Returns the last step of the scenario in which a loop is active.
static uint64_t end_of_loop(const Scenario *s, const ScenarioLoop *l) { return l->to <= s->steps ? l->to - 1 : s->steps; }

// Copies the changes of all rounds of a loop, whose changes are the first n of `body`, and returns their number.  to NULL: only counts them.
static size_t unroll(const Scenario *s, const ScenarioLoop *l, const ScenarioChange *body, size_t n, ScenarioChange *to)
{
    const uint64_t end = end_of_loop(s, l);
    size_t out = 0;

    for (uint64_t begin = 0; l->from + begin <= end; begin += l->period)
        for (size_t i = 0; i < n && body[i].step + begin <= end; i++, out++)
            if (to) {
                to[out] = body[i];
                to[out].step += begin;
            }
    return out;
}

static size_t unroll_loops(const Scenario *s, ScenarioChange *to)
{
    size_t out = 0;

    for (size_t i = 0, n; i < s->changes; i += n) {
        const ScenarioLoop *l = scenario_loop_at(s, s->change[i].step);
        for (n = 1; l && i + n < s->changes && scenario_loop_at(s, s->change[i + n].step) == l; n++) { }
        if (l)
            out += unroll(s, l, &s->change[i], n, to ? to + out : NULL);
        else if (to)
            to[out++] = s->change[i];
        else
            out++;
    }
    return out;
}

Scenario scenario_unroll(Arena *arena, const Scenario *s)
{
    Scenario out = *s;
    ScenarioChange *change;

    if (s->loops == 0)
        return out;
    out.loops = 0;
    out.changes = unroll_loops(s, NULL);
    out.change = change = arena_array(arena, out.changes + 1, sizeof *change);
    unroll_loops(s, change);
    return out;
}

EngineStatus scenario_run(Arena *arena, const Program *p, const Scenario *looped, Engine *e,
                          void (*after)(void *context, uint64_t step, const EngineStep *result), void *context)
{
    const Scenario unrolled = scenario_unroll(arena, looped), *s = &unrolled;
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
