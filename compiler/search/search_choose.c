// SPDX-License-Identifier: Apache-2.0
// Chooses few scenarios that together reach what was reached.  Every scenario is run from its start, so what is stored as reached has been
// reached by a replay.  The search has reserved the effort of one replay for each; simplifying uses what is left.
#include <stdlib.h>
#include <string.h>

#include "compiler/search/search_choose.h"

enum {
    MANY_CHANGES = 2,         // a scenario with more changes is split, if it is for several goals
    LONG_CHANGES = 12,        // a scenario with more changes is simplified for one of its goals first, which can show shorter runs to the other goals
    FEW_CHANGES = 2,          // a scenario with more changes is simplified again, at most IMPROVED_ROUNDS times
    IMPROVED_ROUNDS = 3,
    IMPROVED_PART = 2,        // this part of the remaining effort (1 / n) is for the scenario with most changes
    LEAST_SHARE = 16          // each scenario has at least this part of the remaining effort (1 / n)
};

// A run that reached a goal, as a scenario that can be chosen.
typedef struct Candidate {
    Scenario s;
    uint32_t end;             // State.number of the state after its last step
    uint8_t *reached;         // set of the goals that its replay has reached, one bit for each
    bool used;                // it has been chosen
} Candidate;

static bool is_in_set(const uint8_t *set, uint32_t i) { return set[i / 8] >> i % 8 & 1; }

Scenario chooser_scenario_of(SearchRun *k, Arena *arena, uint32_t node)
{
    Scenario s = {.init_state = k->start, .delta_t = k->delta_t, .steps = k->node.at[node].at};
    ScenarioChange *change;

    for (uint32_t n = node; n != SEARCH_NONE; n = k->node.at[n].parent)
        s.changes += k->node.at[n].turns;
    change = arena_array(arena, s.changes + 1, sizeof *change);
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

// ---- storing ----

static int compare_goals(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;

    return x < y ? -1 : x > y;
}

// Copies a chosen scenario to the memory of the result.
static void store_scenario(Chooser *c, SearchScenario *out, Scenario *s)
{
    chooser_join_equal(c, s);
    out->scenario = *s;
    out->scenario.change = arena_copy(c->k->arena, s->change, (s->changes + 1) * sizeof *s->change);
    if (s->loops)
        out->scenario.loop = arena_copy(c->k->arena, s->loop, s->loops * sizeof *s->loop);
}

// Stores a scenario, for all goals of a set that no earlier one reaches.
static void store_chosen(Chooser *c, Scenario *s, uint32_t end, const uint8_t *reached)
{
    SearchRun *k = c->k;
    uint32_t *goal = ARENA_ARRAY(k->arena, uint32_t, k->goals);
    SearchScenario out = {.goal = goal, .end = k->p->state.at[end - 1]};

    for (uint32_t i = 0; i < k->goals; i++) {
        SearchFind *f = &k->r->find[k->goal[i].place];
        if (c->covered[i] || !is_in_set(reached, i))
            continue;
        c->covered[i] = true;
        goal[out.goals++] = k->goal[i].place;
        k->r->refuted += f->outcome == SEARCH_IMPOSSIBLE;
        f->outcome = SEARCH_REACHED;
        f->scenario = c->chosen.n;
    }
    qsort(goal, out.goals, sizeof *goal, compare_goals);
    store_scenario(c, &out, s);
    if (out.goals)
        vec_push(k->arena, &c->chosen, out);
}

// Returns the set of goals that the last replay has reached, one bit for each.
static uint8_t *reached_set(const Chooser *c)
{
    uint8_t *set = arena_alloc(&c->k->work, c->k->goals / 8 + 1);

    for (uint32_t i = 0; i < c->k->goals; i++)
        if (chooser_has_reached(c, i))
            set[i / 8] |= (uint8_t)(1 << i % 8);
    return set;
}

// ---- simplifying ----

// Returns the goals of a set that no chosen scenario reaches.
static GoalSet find_unreached(Chooser *c, const uint32_t *goal, uint32_t n)
{
    GoalSet out = {NULL, 0, 0};

    for (uint32_t i = 0; i < n; i++)
        if (!c->covered[goal[i]])
            vec_push(&c->k->work, &out, goal[i]);
    return out;
}

// Builds the machine with the probes of some goals only: it is faster than that with all of them.
static void build_wanted(Chooser *c, const GoalSet *want)
{
    SearchRun *k = c->k;

    memset(k->is_open, 0, k->r->finds);
    for (uint32_t i = 0; i < want->n; i++)
        k->is_open[k->counter[k->goal[want->at[i]].place]] = true;
    arena_reset(&c->flats);
    c->wanted = search_new_flat(k, &c->flats);
    chooser_forget_marks(c);
}

// Returns a list of goals as a set, one bit for each.
static uint8_t *set_of(const Chooser *c, const GoalSet *goals)
{
    uint8_t *set = arena_alloc(&c->k->work, c->k->goals / 8 + 1);

    for (uint32_t i = 0; i < goals->n; i++)
        set[goals->at[i] / 8] |= (uint8_t)(1 << goals->at[i] % 8);
    return set;
}

// Sets the limit for simplifying a scenario.  Its part of the remaining effort is the part that its goals are of all goals without a scenario, and
// at least 1 / LEAST_SHARE.
static void share_effort(Chooser *c, uint32_t goals)
{
    SearchRun *k = c->k;
    const uint64_t left = k->effort - k->r->steps;
    uint64_t open = 0, share;

    for (uint32_t g = 0; g < k->goals; g++)
        open += k->goal[g].done && !c->covered[g];
    share = open ? left / open * goals : left;
    c->limit = k->r->steps + (share > left / LEAST_SHARE ? share : left / LEAST_SHARE);
}

// Returns the goal of a set that was found after the fewest steps.
static GoalSet find_first(Chooser *c, const GoalSet *want)
{
    const SearchRun *k = c->k;
    GoalSet out = {NULL, 0, 0};
    uint32_t first = want->at[0];

    for (uint32_t i = 1; i < want->n; i++)
        if (k->node.at[k->goal[want->at[i]].found].at < k->node.at[k->goal[first].found].at)
            first = want->at[i];
    vec_push(&c->k->work, &out, first);
    return out;
}

// Simplifies a scenario for its goals, splits it while that leaves many changes, and stores what results.  Without effort, it is stored as it is.
static void choose_scenario(Chooser *c, const Candidate *from, const GoalSet *want)
{
    const GoalSet all = {NULL, 0, 0};
    uint32_t half;
    Candidate x = *from;
    GoalSet part, left;

    while (x.s.changes > LONG_CHANGES && want->n > 1 && c->k->r->steps < c->k->effort) {
        part = find_first(c, want);
        choose_scenario(c, &x, &part);
        left = find_unreached(c, want->at, want->n);
        want = &left;
    }
    if (want->n == 0)
        return;
    half = want->n / 2;
    share_effort(c, want->n);
    build_wanted(c, want);
    if (chooser_simplify(c, &x.s, want)) {
        x.reached = set_of(c, want);
        x.end = c->end;
    }
    if (x.s.changes > MANY_CHANGES && want->n > 1 && c->k->r->steps < c->k->effort) {
        part = find_unreached(c, want->at, half);
        choose_scenario(c, &x, &part);
        part = find_unreached(c, want->at + half, want->n - half);
        choose_scenario(c, &x, &part);
        return;
    }
    if (chooser_replay(c, c->k->judge, &x.s, &all, NULL)) {
        x.reached = reached_set(c);
        chooser_keep_ways(c, &x.s);
    }
    store_chosen(c, &x.s, x.end, x.reached);
}

// ---- once more ----

// Returns the scenario with most changes that was not tried yet; NULL: none has many.
static SearchScenario *find_longest(const Chooser *c, const bool *tried)
{
    SearchScenario *out = NULL;

    for (uint32_t i = 0; i < c->chosen.n; i++)
        if (!tried[i] && c->chosen.at[i].scenario.changes > FEW_CHANGES && (!out || c->chosen.at[i].scenario.changes > out->scenario.changes))
            out = &c->chosen.at[i];
    return out;
}

// Simplifies a chosen scenario for the same goals.  Returns whether it has fewer changes now.
static bool simplify_chosen(Chooser *c, SearchScenario *x)
{
    SearchRun *k = c->k;
    GoalSet want = {NULL, 0, 0};
    const GoalSet all = {NULL, 0, 0};
    Scenario s = x->scenario;

    for (uint32_t i = 0; i < x->goals; i++)
        vec_push(&k->work, &want, k->goal_of[x->goal[i]]);
    c->limit = k->r->steps + (k->effort - k->r->steps) / IMPROVED_PART;
    build_wanted(c, &want);
    if (!chooser_simplify(c, &s, &want) || s.changes >= x->scenario.changes)
        return false;
    x->end = k->p->state.at[c->end - 1];
    if (chooser_replay(c, k->judge, &s, &all, NULL))
        chooser_keep_ways(c, &s);
    store_scenario(c, x, &s);
    return true;
}

// Simplifies the scenarios with most changes again: more effort is left now, and shorter ways that other scenarios have shown are known.
static void improve_longest(Chooser *c)
{
    SearchRun *k = c->k;
    bool *tried = arena_alloc(&k->work, c->chosen.n + 1), any = true;

    for (int round = 0; round < IMPROVED_ROUNDS && any; round++) {
        SearchScenario *x;
        any = false;
        memset(tried, 0, c->chosen.n + 1);
        while ((x = find_longest(c, tried)) != NULL && k->r->steps < k->effort && !k->r->stopped) {
            tried[x - c->chosen.at] = true;
            any |= simplify_chosen(c, x);
        }
    }
}

// ---- choosing ----

// Replays the run to each goal that was found.
static Candidate *make_candidates(Chooser *c, uint32_t *n)
{
    SearchRun *k = c->k;
    Candidate *all = arena_array(&k->work, k->goals + 1, sizeof *all);
    bool *known = arena_alloc(&k->work, k->node.n);
    const GoalSet nothing = {NULL, 0, 0};

    for (uint32_t g = 0; g < k->goals; g++) {
        const uint32_t node = k->goal[g].found;
        Candidate *x = &all[*n];
        if (node == SEARCH_NONE || known[node])
            continue;
        known[node] = true;
        x->s = chooser_scenario_of(k, &k->work, node);
        chooser_replay(c, k->judge, &x->s, &nothing, NULL);
        x->reached = reached_set(c);
        x->end = chooser_end_state(c);
        ++*n;
    }
    return all;
}

// Chooses the candidate that reaches most goals that are left for its number of changes.
static Candidate *choose_best(const Chooser *c, Candidate *all, uint32_t n, GoalSet *want)
{
    Candidate *best = NULL;
    size_t most = 0;

    for (uint32_t i = 0; i < n; i++) {
        size_t new = 0;
        if (all[i].used)
            continue;
        for (uint32_t g = 0; g < c->k->goals; g++)
            new += is_in_set(all[i].reached, g) && !c->covered[g];
        if (new > 0 && (!best || new * (4 + best->s.changes) > most * (4 + all[i].s.changes))) {
            best = &all[i];
            most = new;
        }
    }
    want->n = 0;
    for (uint32_t g = 0; best && g < c->k->goals; g++)
        if (is_in_set(best->reached, g) && !c->covered[g])
            vec_push(&c->k->work, want, g);
    return best;
}

// Sets up the chooser of scenarios: its arenas, and nothing covered or chosen yet.
static void begin_chooser(Chooser *c)
{
    SearchRun *k = c->k;

    arena_init_within(&c->flats, &k->work);
    arena_init_within(&c->tries, &k->work);
    arena_init_within(&c->unrolled, &k->work);
    k->judge = flat_new(&k->work, k->m, &k->c->probes);
    c->covered = arena_alloc(&k->work, k->goals + 1);
    c->block = arena_alloc(&k->work, k->block);
    c->current = arena_array(&k->work, k->inputs + 1, sizeof *c->current);
    c->seen = arena_alloc(&k->work, k->o->watch ? k->o->watch->goals + 1 : 1);
    c->way = arena_array(&k->work, k->p->state.n, sizeof *c->way);
    chooser_begin_marks(c);
    c->input_of = ARENA_ARRAY(&k->work, uint32_t, k->p->var.n);
    for (uint32_t i = 0; i < k->inputs; i++)
        c->input_of[k->input[i].var] = i;
}

void search_choose(SearchRun *k)
{
    Chooser c = {.k = k};
    Candidate *all, *best;
    uint32_t n = 0;
    GoalSet want = {NULL, 0, 0};
    const uint64_t full = k->effort;

    // Reserves one step for each goal that was not found: search_describe_missing needs it.
    if (k->effort - k->r->steps > k->reserve + k->open)
        k->effort -= k->open;
    k->stop_at = k->effort;
    begin_chooser(&c);
    all = make_candidates(&c, &n);
    while ((best = choose_best(&c, all, n, &want)) != NULL) {
        best->used = true;
        if (!k->o->drafts)
            choose_scenario(&c, best, &want);
        if (find_unreached(&c, want.at, want.n).n)     // the simplified scenarios can reach less than `best` does
            store_chosen(&c, &best->s, best->end, best->reached);
    }
    if (!k->o->drafts)
        improve_longest(&c);
    k->r->chosen = c.chosen.at;
    k->r->chosens = c.chosen.n;
    k->effort = full;
}
