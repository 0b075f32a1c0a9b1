// SPDX-License-Identifier: Apache-2.0
// Chooses few scenarios that together reach what was reached, and simplifies each: fewer changes, shorter times, rounder values.  Every
// candidate is run from its start on a machine with all probes, so what is stored as reached has been reached by a replay.
#include <stdlib.h>
#include <string.h>

#include "compiler/search/search_run.h"
#include "stdlib/convert.h"

enum {
    MANY_CHANGES = 6,         // a scenario with more is split, if it has several goals
    MOST_ENTERS = 64          // entered states that a replay records
};

typedef VEC(uint32_t) Set;            // goals, as indices into SearchRun.goal

typedef struct Candidate {
    Scenario s;
    bool *reached;            // by goal
    bool used;
} Candidate;

typedef struct Enter { uint32_t state; uint64_t step; } Enter;        // a state that is entered after a step

typedef struct Chooser {
    SearchRun *k;
    char *block;              // the state of the run, and the situation of the caller's goals
    const ScenarioChange **current;   // by input
    bool *covered;            // by goal: a chosen scenario reaches it
    bool *seen;               // by goal of the caller: reached in this run
    uint64_t limit;           // of steps, for all of this
    VEC(SearchScenario) chosen;
    uint32_t *input_of;       // by Var.index
    VEC(Enter) enters;        // of the last replay
} Chooser;

// ---- replaying ----

static bool is_reached(const Chooser *c, uint32_t goal)
{
    const SearchRun *k = c->k;
    const uint32_t place = k->goal[goal].place;

    return place < k->r->places ? k->judge->hits[k->counter[place]] > 0 : c->seen[place - k->r->places];
}

static void judge_watch(Chooser *c)
{
    SearchRun *k = c->k;
    const SearchWatch *w = k->o->watch;
    const uint64_t *cell = flat_cells(k->judge, c->block);

    for (uint32_t v = 0; v < k->p->var.n; v++)
        k->cell[v] = k->m->var_of[v] == IR_NONE ? k->p->var.at[v]->init : cell[k->m->var_of[v]];
    w->step(w->self, c->block + (k->judge->size + 7) / 8 * 8, k->cell, k->distance);
    for (uint32_t i = 0; i < w->goals; i++)
        if (k->distance[i] == 0 && !c->seen[i]) {
            c->seen[i] = true;
            k->judge->fresh++;
        }
}

static void set_change(Chooser *c, const ScenarioChange *x, uint64_t step)
{
    SearchRun *k = c->k;
    uint64_t *cell = flat_cells(k->judge, c->block);
    double value = x->a;

    switch (x->kind) {
    case SCENARIO_HOLD: break;
    case SCENARIO_ALTERNATE: value = (step - x->step) % 2 ? x->b : x->a; break;
    case SCENARIO_RAMP: value = x->a + x->b * (double)(step - x->step); break;
    case SCENARIO_COPY: value = sm_cell_to_f64(k->p->var.at[x->source]->type, cell[k->m->var_of[x->source]]); break;
    }
    cell[k->m->var_of[x->var]] = sm_cell_from_f64(k->p->var.at[x->var]->type, value);
}

static bool has_all(const Chooser *c, const Set *want)
{
    for (uint32_t i = 0; i < want->n; i++)
        if (!is_reached(c, want->at[i]))
            return false;
    return true;
}

// Runs a scenario from its start.  Returns the step after which it has reached all of `want`; 0: it does not.  An empty `want` runs to the end.
static uint64_t replay(Chooser *c, const Scenario *s, const Set *want)
{
    SearchRun *k = c->k;
    const FlatState *run = (const FlatState *)(const void *)c->block;
    size_t next = 0;
    uint64_t fresh = 0;

    c->enters.n = 0;
    flat_clear_counts(k->judge);
    flat_start(k->judge, c->block, s->init_state->number);
    memset(c->current, 0, (k->inputs + 1) * sizeof *c->current);
    if (k->o->watch) {
        memset(c->seen, 0, k->o->watch->goals);
        k->o->watch->start(k->o->watch->self, c->block + (k->judge->size + 7) / 8 * 8);
    }
    for (uint64_t step = 1; step <= s->steps; step++) {
        flat_cells(k->judge, c->block)[k->m->g] = (step - 1) * s->delta_t;
        for (; next < s->changes && s->change[next].step <= step; next++) {
            c->current[c->input_of[s->change[next].var]] = &s->change[next];
            set_change(c, &s->change[next], step);
        }
        for (uint32_t i = 0; i < k->inputs; i++)
            if (c->current[i] && (c->current[i]->kind != SCENARIO_HOLD || k->input[i].forced))
                set_change(c, c->current[i], step);
        flat_step(k->judge, c->block);
        k->r->steps++;
        if (run->first && c->enters.n < MOST_ENTERS) {
            const Enter e = {run->state, step};
            vec_push(&k->work, &c->enters, e);
        }
        if (k->o->watch)
            judge_watch(c);
        if (want->n && k->judge->fresh != fresh) {
            fresh = k->judge->fresh;
            if (has_all(c, want))
                return step;
        }
        if (k->r->steps >= k->next_report)
            search_goes_on(k);
    }
    return want->n ? 0 : s->steps;
}

// ---- scenarios of nodes ----

static Scenario scenario_of(SearchRun *k, uint32_t node)
{
    Scenario s = {k->start, k->delta_t, k->node.at[node].at, NULL, 0};
    ScenarioChange *change;

    for (uint32_t n = node; n != SEARCH_NONE; n = k->node.at[n].parent)
        s.changes += k->node.at[n].turns;
    change = arena_array(&k->work, s.changes + 1, sizeof *change);
    s.change = change;
    change += s.changes;
    for (uint32_t n = node; k->node.at[n].parent != SEARCH_NONE; n = k->node.at[n].parent) {
        const SearchNode *x = &k->node.at[n];
        change -= x->turns;
        for (uint32_t i = 0; i < x->turns; i++) {
            const SearchSetting *t = &x->turn[i].setting;
            change[i] = (ScenarioChange){k->node.at[x->parent].at + 1, k->input[x->turn[i].input].var, t->kind, t->a, t->b, t->source};
        }
    }
    return s;
}

// ---- simplifying ----

static Scenario copy_scenario(SearchRun *k, const Scenario *s)
{
    Scenario out = *s;

    out.change = arena_copy(&k->work, s->change, (s->changes + 1) * sizeof *s->change);
    return out;
}

static bool has_effort(const Chooser *c) { return c->k->r->steps < c->limit && !c->k->r->stopped; }

// Replaces *s by `t` if that still reaches everything.
static bool accept(Chooser *c, Scenario *s, Scenario *t, const Set *want)
{
    const uint64_t end = replay(c, t, want);

    if (end == 0)
        return false;
    t->steps = end;
    while (t->changes && t->change[t->changes - 1].step > end)
        t->changes--;
    *s = *t;
    return true;
}

static void drop_changes(Chooser *c, Scenario *s, const Set *want)
{
    for (size_t i = s->changes; i-- > 0 && has_effort(c); ) {
        Scenario t = copy_scenario(c->k, s);
        ScenarioChange *change = (ScenarioChange *)t.change;
        if (i >= s->changes)
            continue;
        memmove(change + i, change + i + 1, (t.changes - i - 1) * sizeof *change);
        t.changes--;
        accept(c, s, &t, want);
    }
}

// Moves the changes from index i on, and the end, by `less` steps towards the start.
static Scenario move_changes(Chooser *c, const Scenario *s, size_t i, uint64_t less)
{
    Scenario t = copy_scenario(c->k, s);
    ScenarioChange *change = (ScenarioChange *)t.change;

    for (; i < t.changes; i++)
        change[i].step -= less;
    t.steps -= less;
    return t;
}

// Shortens the time before each change, as far as halving finds.
static void shorten_waits(Chooser *c, Scenario *s, const Set *want)
{
    for (size_t i = 0; i < s->changes && has_effort(c); i++) {
        const uint64_t before = i ? s->change[i - 1].step : 1;
        uint64_t gap = s->change[i].step - before, least = 0;
        if (gap == 0)
            continue;
        while (least < gap && has_effort(c) && i < s->changes) {
            const uint64_t middle = least + (gap - least) / 2;
            Scenario t = move_changes(c, s, i, s->change[i].step - before - middle);
            bool clash = false;
            for (size_t j = 0; j < t.changes; j++)
                for (size_t n = 0; n < j; n++)
                    clash |= t.change[j].var == t.change[n].var && t.change[j].step == t.change[n].step;
            if (!clash && accept(c, s, &t, want))
                gap = middle;
            else
                least = middle + 1;
        }
    }
}

static bool try_change(Chooser *c, Scenario *s, size_t i, ScenarioChange x, const Set *want)
{
    Scenario t = copy_scenario(c->k, s);

    ((ScenarioChange *)t.change)[i] = x;
    return accept(c, s, &t, want);
}

static void prefer_holds(Chooser *c, Scenario *s, const Set *want)
{
    for (size_t i = 0; i < s->changes && has_effort(c); i++)
        if (s->change[i].kind != SCENARIO_HOLD) {
            ScenarioChange x = s->change[i];
            x.kind = SCENARIO_HOLD;
            if (x.kind == SCENARIO_COPY)
                x.a = 1;
            if (!try_change(c, s, i, x, want) && i < s->changes) {
                x.a = s->change[i].kind == SCENARIO_COPY ? 0 : s->change[i].b;
                try_change(c, s, i, x, want);
            }
        }
}

static double whole(double x) { return x < -9e15 || x > 9e15 ? x : (double)(int64_t)(x + (x < 0 ? -0.5 : 0.5)); }

// Rounds the values of holds to few digits, and prefers values within the range.
static void round_values(Chooser *c, Scenario *s, const Set *want)
{
    static const double unit[] = {1e6, 1e5, 1e4, 1e3, 500, 100, 50, 10, 5, 1};
    static const double per[] = {2, 10, 20, 100, 1000, 10000};

    for (size_t i = 0; i < s->changes && has_effort(c); i++) {
        const SearchInput *in = &c->k->input[c->input_of[s->change[i].var]];
        ScenarioChange x = s->change[i];
        const double a = x.a, size = a < 0 ? -a : a;
        bool done = x.kind != SCENARIO_HOLD || in->type == SM_BOOL;
        if (!done && in->range && (a < in->range->lo || a > in->range->hi)) {
            x.a = a < in->range->lo ? in->range->lo : in->range->hi;
            done = try_change(c, s, i, x, want);
        }
        for (size_t u = 0; !done && i < s->changes && u < sizeof unit / sizeof *unit + sizeof per / sizeof *per; u++) {
            const bool is_part = u >= sizeof unit / sizeof *unit;
            const double f = is_part ? per[u - sizeof unit / sizeof *unit] : unit[u];
            if ((!is_part && f > 2 * size) || (is_part && !ir_is_float(in->type)))
                continue;
            x.a = is_part ? whole(a * f) / f : whole(a / f) * f;
            done = x.a == a;
            if (!done && (!in->range || (x.a >= in->range->lo && x.a <= in->range->hi)))
                done = try_change(c, s, i, x, want);
        }
    }
}

// ---- shorter beginnings ----

// Returns the entry of a state with the fewest changes; SEARCH_NONE: none is left.
static uint32_t find_simplest(const SearchRun *k, uint32_t state)
{
    uint32_t best = SEARCH_NONE;

    for (uint32_t i = 0; i < k->entries[state - 1]; i++) {
        const uint32_t n = k->entry[(state - 1) * SEARCH_ENTRIES + i].node;
        if (best == SEARCH_NONE || k->node.at[n].depth < k->node.at[best].depth || (k->node.at[n].depth == k->node.at[best].depth && k->node.at[n].at < k->node.at[best].at))
            best = n;
    }
    return best;
}

// Returns the last change of a variable at or before a step; NULL: none.
static const ScenarioChange *change_at(const Scenario *s, uint32_t var, uint64_t step)
{
    const ScenarioChange *out = NULL;

    for (size_t i = 0; i < s->changes && s->change[i].step <= step; i++)
        out = s->change[i].var == var ? &s->change[i] : out;
    return out;
}

// Joins the way to a node and what `s` does after step `after`, where it enters the same state.
static Scenario join_at(Chooser *c, uint32_t node, const Scenario *s, uint64_t after)
{
    SearchRun *k = c->k;
    Scenario t = scenario_of(k, node);
    const uint64_t begin = t.steps + 1;
    ScenarioChange *change = arena_array(&k->work, t.changes + s->changes + k->inputs + 1, sizeof *change);
    size_t n = t.changes;

    memcpy(change, t.change, n * sizeof *change);
    for (uint32_t i = 0; i < k->inputs; i++) {
        const ScenarioChange *now = change_at(s, k->input[i].var, after + 1), *was = change_at(&t, k->input[i].var, begin);
        ScenarioChange x = now ? *now : (ScenarioChange){0, k->input[i].var, SCENARIO_HOLD, 0, 0, 0};
        if ((!now && !was) || (now && was && now->kind == SCENARIO_HOLD && was->kind == SCENARIO_HOLD && now->a == was->a))
            continue;
        x.step = begin;
        change[n++] = x;
    }
    for (size_t i = 0; i < s->changes; i++)
        if (s->change[i].step > after + 1) {
            change[n] = s->change[i];
            change[n++].step += begin - (after + 1);
        }
    t.change = change;
    t.changes = n;
    t.steps = begin + s->steps - (after + 1);
    return t;
}

// Replaces the beginning of a scenario, up to where it enters a state, by the simplest known way to that state.
static void simplify_beginning(Chooser *c, Scenario *s, const Set *want)
{
    const Scenario from = *s;
    uint32_t *state;
    uint64_t *step;
    uint32_t n;

    replay(c, s, want);
    n = c->enters.n;
    state = ARENA_ARRAY(&c->k->work, uint32_t, n + 1);
    step = ARENA_ARRAY(&c->k->work, uint64_t, n + 1);
    for (uint32_t i = 0; i < n; i++) {
        state[i] = c->enters.at[i].state;
        step[i] = c->enters.at[i].step;
    }
    for (uint32_t i = n; i-- > 0 && has_effort(c); ) {
        const uint32_t node = find_simplest(c->k, state[i]);
        Scenario t;
        if (node == SEARCH_NONE || step[i] + 1 > from.steps)
            continue;
        t = join_at(c, node, &from, step[i]);
        if (c->k->node.at[node].depth < from.changes && accept(c, s, &t, want))
            return;
    }
}

static void simplify(Chooser *c, Scenario *s, const Set *want)
{
    drop_changes(c, s, want);
    if (s->changes > 2)
        simplify_beginning(c, s, want);
    drop_changes(c, s, want);
    shorten_waits(c, s, want);
    prefer_holds(c, s, want);
    drop_changes(c, s, want);
    round_values(c, s, want);
}

// ---- choosing ----

static int compare_goals(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;

    return x < y ? -1 : x > y;
}

// Stores a scenario, for all goals that its last replay has reached and that no earlier one reaches.
static void store_chosen(Chooser *c, const Scenario *s)
{
    SearchRun *k = c->k;
    uint32_t *goal = ARENA_ARRAY(k->arena, uint32_t, k->goals);
    SearchScenario out = {*s, goal, 0, NULL};

    for (uint32_t i = 0; i < k->goals; i++) {
        SearchFind *f = &k->r->find[k->goal[i].place];
        if (c->covered[i] || !is_reached(c, i))
            continue;
        c->covered[i] = true;
        goal[out.goals++] = k->goal[i].place;
        f->outcome = SEARCH_REACHED;
        f->scenario = c->chosen.n;
    }
    qsort(goal, out.goals, sizeof *goal, compare_goals);
    out.scenario.change = arena_copy(k->arena, s->change, (s->changes + 1) * sizeof *s->change);
    out.end = k->p->state.at[((const FlatState *)(const void *)c->block)->state - 1];
    if (out.goals)
        vec_push(k->arena, &c->chosen, out);
}

// Returns the goals of a set that no chosen scenario reaches.
static Set find_left(Chooser *c, const uint32_t *goal, uint32_t n)
{
    Set out = {NULL, 0, 0};

    for (uint32_t i = 0; i < n; i++)
        if (!c->covered[goal[i]])
            vec_push(&c->k->work, &out, goal[i]);
    return out;
}

// Simplifies a scenario for its goals, and splits it while that leaves many changes.
static void choose_scenario(Chooser *c, const Scenario *from, const Set *want)
{
    const uint32_t half = want->n / 2;
    Scenario s = copy_scenario(c->k, from);
    const uint64_t end = want->n ? replay(c, &s, want) : 0;
    Set part;

    if (end == 0)
        return;
    s.steps = end;
    while (s.changes && s.change[s.changes - 1].step > end)
        s.changes--;
    if (has_effort(c))
        simplify(c, &s, want);
    if (s.changes > MANY_CHANGES && want->n > 1 && has_effort(c)) {
        part = find_left(c, want->at, half);
        choose_scenario(c, &s, &part);
        part = find_left(c, want->at + half, want->n - half);
        choose_scenario(c, &s, &part);
        return;
    }
    replay(c, &s, want);
    store_chosen(c, &s);
}

static Candidate *make_candidates(Chooser *c, uint32_t *n)
{
    SearchRun *k = c->k;
    Candidate *all = arena_array(&k->work, k->goals + 1, sizeof *all);
    bool *known = arena_alloc(&k->work, k->node.n);
    const Set nothing = {NULL, 0, 0};

    for (uint32_t g = 0; g < k->goals; g++) {
        const uint32_t node = k->goal[g].found;
        Candidate *x = &all[*n];
        if (node == SEARCH_NONE || known[node])
            continue;
        known[node] = true;
        x->s = scenario_of(k, node);
        x->reached = arena_alloc(&k->work, k->goals);
        replay(c, &x->s, &nothing);
        for (uint32_t i = 0; i < k->goals; i++)
            x->reached[i] = is_reached(c, i);
        ++*n;
    }
    return all;
}

// Chooses the candidate that reaches most goals that are left for its number of changes.
static Candidate *choose_best(const Chooser *c, Candidate *all, uint32_t n, Set *want)
{
    Candidate *best = NULL;
    uint32_t most = 0;

    for (uint32_t i = 0; i < n; i++) {
        uint32_t new = 0;
        if (all[i].used)
            continue;
        for (uint32_t g = 0; g < c->k->goals; g++)
            new += all[i].reached[g] && !c->covered[g];
        if (new > 0 && (!best || new * (4 + best->s.changes) > most * (4 + all[i].s.changes))) {
            best = &all[i];
            most = new;
        }
    }
    want->n = 0;
    for (uint32_t g = 0; best && g < c->k->goals; g++)
        if (best->reached[g] && !c->covered[g])
            vec_push(&c->k->work, want, g);
    return best;
}

void search_choose(SearchRun *k)
{
    Chooser c = {.k = k, .limit = k->r->steps + k->effort / 3};
    Candidate *all, *best;
    uint32_t n = 0;

    k->judge = flat_new(&k->work, k->m, &k->c->probes);
    c.covered = arena_alloc(&k->work, k->goals + 1);
    c.block = arena_alloc(&k->work, k->block);
    c.current = arena_array(&k->work, k->inputs + 1, sizeof *c.current);
    c.seen = arena_alloc(&k->work, k->o->watch ? k->o->watch->goals + 1 : 1);
    c.input_of = ARENA_ARRAY(&k->work, uint32_t, k->p->var.n);
    for (uint32_t i = 0; i < k->inputs; i++)
        c.input_of[k->input[i].var] = i;
    all = make_candidates(&c, &n);
    for (;;) {
        Set want = {NULL, 0, 0};
        best = choose_best(&c, all, n, &want);
        if (!best)
            break;
        best->used = true;
        choose_scenario(&c, &best->s, &want);
    }
    k->r->chosen = c.chosen.at;
    k->r->chosens = c.chosen.n;
}
