// SPDX-License-Identifier: Apache-2.0
// Runs scenarios: from their start, or from a snapshot (search_marks.c).  Each step that runs counts as effort.
#include <string.h>

#include "compiler/search/search_choose.h"
#include "stdlib/convert.h"

enum { MOST_ENTERS = 4096 };          // entered states that a replay records

bool chooser_has_reached(const Chooser *c, uint32_t goal)
{
    const SearchRun *k = c->k;
    const uint32_t place = k->goal[goal].place;

    return place < k->r->places ? c->f->hits[k->counter[place]] > 0 : c->seen[place - k->r->places];
}

void chooser_set_reached(Chooser *c, uint32_t goal)
{
    const uint32_t place = c->k->goal[goal].place;

    if (place < c->k->r->places)
        c->f->hits[c->k->counter[place]] = 1;
    else
        c->seen[place - c->k->r->places] = true;
}

uint32_t chooser_end_state(const Chooser *c) { return ((const FlatState *)(const void *)c->block)->state; }

bool chooser_has_effort(const Chooser *c) { return c->k->r->steps < c->limit && !c->k->r->stopped; }

// Lets the caller judge its own goals after this step of the replay, and marks those that are reached.
static void judge_watch(Chooser *c)
{
    SearchRun *k = c->k;
    const SearchWatch *w = k->o->watch;
    const uint64_t *cell = flat_cells(c->f, c->block);

    for (uint32_t v = 0; v < k->p->var.n; v++)
        k->cell[v] = k->m->var_of[v] == IR_NONE ? k->p->var.at[v]->init : cell[k->m->var_of[v]];
    w->step(w->self, c->block + (c->f->size + 7) / 8 * 8, k->cell, k->distance);
    for (uint32_t i = 0; i < w->goals; i++)
        if (k->distance[i] == 0 && !c->seen[i]) {
            c->seen[i] = true;
            c->f->fresh++;
        }
}

// Sets an input as a change of the scenario says, for this step.
static void set_change(Chooser *c, const ScenarioChange *x, uint64_t step)
{
    SearchRun *k = c->k;
    uint64_t *cell = flat_cells(c->f, c->block);
    double value = x->a;

    switch (x->kind) {
    case SCENARIO_HOLD: break;
    case SCENARIO_ALTERNATE: value = (step - x->step) % 2 ? x->b : x->a; break;
    case SCENARIO_RAMP: value = x->a + x->b * (double)(step - x->step); break;
    case SCENARIO_COPY: value = sm_cell_to_f64(k->p->var.at[x->source]->type, cell[k->m->var_of[x->source]]); break;
    }
    cell[k->m->var_of[x->var]] = sm_cell_from_f64(k->p->var.at[x->var]->type, value);
}

// Whether the last replay has reached all wanted goals.
static bool has_reached_all(const Chooser *c, const GoalSet *want)
{
    for (uint32_t i = 0; i < want->n; i++)
        if (!chooser_has_reached(c, want->at[i]))
            return false;
    return true;
}

// Starts the replay of a scenario at its first state, with all counters at 0.
static void begin_replay(Chooser *c, const Scenario *s)
{
    SearchRun *k = c->k;
    const SearchEnter start = {s->init_state->number, 0};

    c->enters.n = 0;
    vec_push(&k->work, &c->enters, start);
    flat_clear_counts(c->f);
    search_start(c->k, c->f, c->block, s->init_state->number);
    memset(c->current, 0, (k->inputs + 1) * sizeof *c->current);
    if (k->o->watch) {
        memset(c->seen, 0, k->o->watch->goals);
        k->o->watch->start(k->o->watch->self, c->block + (c->f->size + 7) / 8 * 8);
    }
}

// Whether a change is due before step `step`.
static bool is_due(const Chooser *c, const ScenarioChange *x, const SearchAnchor *anchor, uint64_t step)
{
    if (!anchor)
        return x->step <= step;
    return anchor->enter < c->enters.n - 1 || (anchor->enter == c->enters.n - 1 && step - c->enters.at[anchor->enter].step >= anchor->wait);
}

// Makes the changes that are due, and sets what follows a pattern.  Returns the index of the next change.
static size_t make_changes(Chooser *c, Scenario *s, const SearchAnchor *anchor, size_t next, uint64_t step)
{
    for (; next < s->changes && is_due(c, &s->change[next], anchor ? &anchor[next] : NULL, step); next++) {
        if (anchor)
            ((ScenarioChange *)s->change)[next].step = step;
        c->current[c->input_of[s->change[next].var]] = &s->change[next];
        set_change(c, &s->change[next], step);
    }
    for (uint32_t i = 0; i < c->k->inputs; i++)
        if (c->current[i] && (c->current[i]->kind != SCENARIO_HOLD || c->k->input[i].forced))
            set_change(c, c->current[i], step);
    return next;
}

// Whether a replay waits for what will not happen: no change is due at a fixed step, and nothing has happened for longer than in the known scenario.
static bool is_stuck(const Chooser *c, const Scenario *s, const SearchAnchor *anchor, size_t next, uint64_t waited)
{
    return c->marks->is_known && waited > c->marks->patience[chooser_end_state(c) - 1] && (anchor || next == s->changes);
}

// Runs the steps of a scenario after `at`, until all of `want` is reached, and takes snapshots if `marks`.
static uint64_t run_scenario(Chooser *c, Scenario *s, const GoalSet *want, const SearchAnchor *anchor, uint64_t at, size_t next, bool marks)
{
    SearchRun *k = c->k;
    FlatMachine *f = c->f;
    const FlatState *run = (const FlatState *)(const void *)c->block;
    uint64_t fresh = f->fresh, event = at;

    for (uint64_t step = at + 1; step <= s->steps && k->r->steps < k->effort; step++) {
        const size_t before = next;
        flat_cells(f, c->block)[k->m->g] = (step - 1) * s->delta_t;
        if (marks && (event == step - 1 || (next < s->changes && is_due(c, &s->change[next], anchor ? &anchor[next] : NULL, step))))
            chooser_mark(c, step - 1, want);
        next = make_changes(c, s, anchor, next, step);
        flat_step(f, c->block);
        k->r->steps++;
        if (f->moved && c->enters.n < MOST_ENTERS) {
            const SearchEnter e = {run->state, step};
            vec_push(&k->work, &c->enters, e);
        }
        event = f->moved || next != before ? step : event;
        if (k->o->watch)
            judge_watch(c);
        if (want->n && f->fresh != fresh) {
            fresh = f->fresh;
            if (has_reached_all(c, want))
                return step;
        }
        if (k->r->steps >= k->next_report)
            search_goes_on(k);
        if (want->n == 0 && step == s->steps)
            return step;
        if (marks && is_stuck(c, s, anchor, next, step - event))
            return 0;
    }
    return 0;
}

uint64_t chooser_replay(Chooser *c, FlatMachine *f, Scenario *looped, const GoalSet *want, const SearchAnchor *anchor)
{
    const bool marks = f == c->wanted && want->n;
    Scenario *s = looped, unrolled;
    size_t next = 0;
    uint64_t at;

    if (s->loops) {
        arena_reset(&c->unrolled);
        unrolled = scenario_unroll(&c->unrolled, looped);
        s = &unrolled;
    }
    c->f = f;
    at = marks ? chooser_resume(c, s, want, &next) : 0;
    if (at == 0)
        begin_replay(c, s);
    return run_scenario(c, s, want, anchor, at, next, marks);
}
