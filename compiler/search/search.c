// SPDX-License-Identifier: Apache-2.0
#include "compiler/search/search.h"

#include <string.h>

#include "compiler/ir/eval.h"

typedef struct SearchRun {
    Arena *arena;
    const Cover *c;
    const SearchOptions *o;
    FlatMachine *flat;
    void *run;
    bool *writable;
    VEC(SearchScenario) chosen;
    SearchResult *r;
    uint64_t random;
    uint64_t *cell;           // by Var.index
    double *distance;
    void *situation;
} SearchRun;

static uint64_t next_random(SearchRun *k)
{
    uint64_t z = k->random += UINT64_C(0x9e3779b97f4a7c15);

    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

static void run_steps(SearchRun *k, const Scenario *s)
{
    const Program *p = k->c->p;
    const SearchWatch *w = k->o->watch;

    flat_start(k->flat, k->run, s->init_state->number);
    if (w)
        w->start(w->self, k->situation);
    for (uint64_t step = 1; step <= s->steps; step++) {
        flat_cells(k->flat, k->run)[k->flat->m->g] = (step - 1) * s->delta_t;
        for (size_t i = 0; i < s->changes; i++)
            if (s->change[i].step <= step)
                flat_cells(k->flat, k->run)[k->flat->m->var_of[s->change[i].var]] = scenario_cell(p, &s->change[i], step, k->cell);
        flat_step(k->flat, k->run);
        k->r->steps++;
        for (size_t v = 0; w && v < p->var.n; v++) {
            const uint32_t at = k->flat->m->var_of[v];
            k->cell[v] = at == IR_NONE ? p->var.at[v]->init : flat_cells(k->flat, k->run)[at];
        }
        if (!w)
            continue;
        w->step(w->self, k->situation, k->cell, k->distance);
        for (uint32_t i = 0; i < w->goals; i++) {
            SearchFind *f = &k->r->find[k->r->places + i];
            f->nearest = k->distance[i] < f->nearest ? k->distance[i] : f->nearest;
        }
    }
}

static void store_found(SearchRun *k, const Scenario *s)
{
    VEC(uint32_t) goal = {NULL, 0, 0};

    for (uint32_t i = 1; i < k->r->finds; i++) {
        SearchFind *f = &k->r->find[i];
        if (f->outcome == SEARCH_NOT_FOUND && (i < k->r->places ? k->flat->hits[i] > 0 : f->nearest == 0)) {
            f->outcome = SEARCH_REACHED;
            f->scenario = k->chosen.n;
            vec_push(k->arena, &goal, i);
        }
    }
    if (goal.n) {
        const SearchScenario found = {*s, goal.at, goal.n, k->c->p->state.at[((FlatState *)k->run)->state - 1]};
        vec_push(k->arena, &k->chosen, found);
    }
}

static void try_scenario(SearchRun *k, const double *value, uint32_t values)
{
    const Program *p = k->c->p;
    const uint64_t step_at[3] = {1, 2 + next_random(k) % 100, 200 + next_random(k) % 1000};
    VEC(ScenarioChange) change = {NULL, 0, 0};
    Scenario s = {k->o->init_state ? k->o->init_state : p->state.at[0], k->r->delta_t, 2000, NULL, 0};

    for (int part = 0; part < 3; part++)
        for (uint32_t v = 0; v < p->var.n; v++)
            if (k->writable[v] && k->flat->m->var_of[v] != IR_NONE && next_random(k) % 3) {
                const double x = value[next_random(k) % values] + (double)(next_random(k) % 3) - 1;
                const ScenarioChange one = {step_at[part], v, SCENARIO_HOLD, x, 0, 0};
                vec_push(k->arena, &change, one);
            }
    s.change = change.at;
    s.changes = change.n;
    run_steps(k, &s);
    store_found(k, &s);
}

SearchResult *search_run(Arena *arena, const Cover *c, const SearchOptions *o)
{
    SearchRun k = {.arena = arena, .c = c, .o = o, .random = o->seed};
    const uint64_t effort = o->effort ? o->effort : SEARCH_EFFORT;
    const unsigned kinds = o->kinds ? o->kinds : SEARCH_KINDS;
    SearchResult *r = k.r = ARENA_NEW(arena, SearchResult);
    VEC(double) value = {NULL, 0, 0};
    uint32_t left = 0;

    k.flat = flat_new(arena, c->m, &c->probes);
    k.run = arena_alloc(arena, k.flat->size);
    k.cell = ARENA_ARRAY(arena, uint64_t, c->p->var.n);
    k.writable = arena_alloc(arena, c->p->var.n);
    if (o->writable)
        memcpy(k.writable, o->writable, c->p->var.n);
    else
        search_default_inputs(c->p, k.writable);
    r->delta_t = c->p->step ? c->p->step : o->delta_t ? o->delta_t : SEARCH_DELTA_T;
    r->places = c->place.n;
    r->finds = r->places + (o->watch ? o->watch->goals : 0);
    r->find = ARENA_ARRAY(arena, SearchFind, r->finds);
    for (uint32_t i = 1; i < r->finds; i++) {
        const bool goal = i >= r->places || (!o->no_places && c->hits[i] == 0 && kinds >> c->place.at[i].kind & 1);
        r->find[i].nearest = SEARCH_UNKNOWN;
        r->find[i].outcome = !goal ? SEARCH_NO_GOAL : i < r->places && c->place.at[i].impossible ? SEARCH_IMPOSSIBLE : SEARCH_NOT_FOUND;
        r->find[i].reason = i < r->places ? c->place.at[i].impossible : NULL;
        left += r->find[i].outcome == SEARCH_NOT_FOUND;
    }
    if (o->watch) {
        k.distance = ARENA_ARRAY(arena, double, o->watch->goals);
        k.situation = arena_alloc(arena, o->watch->size);
    }
    vec_push(arena, &value, 0);
    vec_push(arena, &value, 1);
    for (uint32_t i = 0; i < o->hints; i++)
        vec_push(arena, &value, o->hint[i].value);
    for (size_t s = 0; s <= c->m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            const IrFn *f = s < c->m->state.n ? c->m->state.at[s].block[b] : b ? NULL : c->m->sample;
            for (uint32_t i = 0; f && i < f->ins.n; i++)
                if (f->ins.at[i].op == IR_const)
                    vec_push(arena, &value, ir_number(f->ins.at[i].type, f->ins.at[i].bits));
        }
    while (left && r->steps < effort / 20 && !r->stopped) {
        const SearchProgress p = {left, 0, left, r->steps, effort};
        try_scenario(&k, value.at, value.n);
        r->stopped = o->go_on && !o->go_on(o->context, &p);
    }
    r->chosen = k.chosen.at;
    r->chosens = k.chosen.n;
    return r;
}
