// SPDX-License-Identifier: Apache-2.0
// Chooses few scenarios that together reach what was reached.  Every scenario is run from its start, so what is stored as reached has been
// reached by a replay.  The search has reserved the effort of one replay for each; simplifying uses what is left.
#include <stdlib.h>
#include <string.h>

#include "compiler/search/search_choose.h"

enum {
    MANY_CHANGES = 2,         // a scenario with more changes is split, if it is for several goals
    LONG_CHANGES = 12,        // a scenario with more changes is simplified for one of its goals first, which can show shorter runs to the other goals
    SIMPLE_CHANGES = 1,       // of the scenarios with no more changes, the fewest are chosen that together reach what all of them do
    FEW_CHANGES = 2,          // a scenario with more changes is simplified again, at most IMPROVED_ROUNDS times
    IMPROVED_ROUNDS = 3,
    IMPROVED_PART = 2,        // this part of the remaining effort (1 / n) is for the scenario with most changes
    WAYS_PART = 4,            // at most this part of the effort of choosing (1 / n) is for runs to each state
    WAY_SHARE = 4,            // one of them can use this part of what is left for them (1 / n)
    SIMPLIFY_PART = 4,        // (n - 1) / n of the effort that is left then is for simplifying each run alone
    GATHER_PART = 4,          // this part of the effort that is left after choosing (1 / n) is for fewer times of changes
    LEAST_SHARE = 16          // each scenario has at least this part of the remaining effort (1 / n)
};

// A run that reached a goal, as a scenario that can be chosen.
typedef struct Candidate {
    Scenario s;
    uint32_t end;             // State.number of the state after its last step
    uint8_t *reached;         // set of the goals that its replay has reached, one bit for each
    uint32_t node;            // the node of the search where its run ends
    bool simple;              // it was simplified for the goals that were found at this node
    bool used;                // it has been chosen, or others reach its goals with fewer changes
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

// Returns the goals that a chosen scenario is for.
static GoalSet goals_of(Chooser *c, const SearchScenario *x)
{
    GoalSet out = {NULL, 0, 0};

    for (uint32_t i = 0; i < x->goals; i++)
        vec_push(&c->k->work, &out, c->k->goal_of[x->goal[i]]);
    return out;
}

// Simplifies a chosen scenario for the same goals.  Returns whether it has fewer changes now.
static bool simplify_chosen(Chooser *c, SearchScenario *x)
{
    SearchRun *k = c->k;
    const GoalSet want = goals_of(c, x), all = {NULL, 0, 0};
    Scenario s = x->scenario;

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

// Lets inputs change at fewer times in the chosen scenarios.  In one for a goal of the caller each input changes where its effect is seen: a person
// reads it to find out what went wrong.
static void gather_chosen(Chooser *c)
{
    SearchRun *k = c->k;

    for (uint32_t i = 0; i < c->chosen.n && !k->o->watch && k->r->steps < k->effort && !k->r->stopped; i++) {
        SearchScenario *x = &c->chosen.at[i];
        const GoalSet want = goals_of(c, x);
        Scenario s = x->scenario;
        c->limit = k->r->steps + (k->effort - k->r->steps) / (c->chosen.n - i);
        if (scenario_times(&s) < 2)
            continue;
        build_wanted(c, &want);
        chooser_gather(c, &s, &want);
        if (scenario_times(&s) >= scenario_times(&x->scenario))
            continue;
        x->end = k->p->state.at[c->end - 1];
        store_scenario(c, x, &s);
    }
}

// ---- paths to states ----

// Returns the goals of entering a state that were reached, those after the fewest changes first.
static GoalSet list_state_goals(const SearchRun *k)
{
    GoalSet out = {NULL, 0, 0};

    for (uint32_t g = 0; g < k->goals; g++) {
        const SearchGoal *x = &k->goal[g];
        uint32_t at = out.n;
        if (x->found == SEARCH_NONE || x->place >= k->r->places || k->c->place.at[x->place].kind != COVER_STATE)
            continue;
        vec_push(&((SearchRun *)k)->work, &out, g);
        for (; at > 0 && k->node.at[k->goal[out.at[at - 1]].found].depth > k->node.at[x->found].depth; at--)
            out.at[at] = out.at[at - 1];
        out.at[at] = g;
    }
    return out;
}

// Simplifies a run to each state: the runs to all other goals can begin with one of them.
static void simplify_ways(Chooser *c, uint64_t end)
{
    SearchRun *k = c->k;
    const GoalSet states = list_state_goals(k), all = {NULL, 0, 0};

    for (uint32_t i = 0; i < states.n && k->r->steps < end && !k->r->stopped; i++) {
        const SearchGoal *g = &k->goal[states.at[i]];
        const Scenario *known = &c->way[k->c->place.at[g->place].from->number - 1];
        GoalSet want = {NULL, 0, 0};
        Scenario s;
        if (k->node.at[g->found].depth <= FEW_CHANGES || (known->init_state && known->changes <= k->node.at[g->found].depth))
            continue;
        s = chooser_scenario_of(k, &k->work, g->found);
        vec_push(&k->work, &want, states.at[i]);
        c->limit = k->r->steps + (end - k->r->steps) / WAY_SHARE;
        build_wanted(c, &want);
        if (chooser_simplify(c, &s, &want) && chooser_replay(c, k->judge, &s, &all, NULL))
            chooser_keep_ways(c, &s);
    }
}

void search_shorten_ways(SearchRun *k, uint64_t end)
{
    Chooser *c = k->chooser;

    simplify_ways(c, end);
    search_reopen(k, 0);
    k->is_way = true;
    for (uint32_t i = 0; i < k->p->state.n && search_goes_on(k); i++)
        if (c->way[i].init_state)
            search_run_given(k, &c->way[i]);
    k->is_way = false;
    search_close_again(k);
}

// ---- choosing ----

// Lists the runs to goals that were found.
static Candidate *list_candidates(Chooser *c, uint32_t *n)
{
    SearchRun *k = c->k;
    Candidate *all = arena_array(&k->work, k->goals + 1, sizeof *all);
    bool *known = arena_alloc(&k->work, k->node.n);

    for (uint32_t g = 0; g < k->goals; g++) {
        const uint32_t node = k->goal[g].found;
        Candidate *x = &all[*n];
        if (node == SEARCH_NONE || known[node])
            continue;
        known[node] = true;
        x->node = node;
        x->s = chooser_scenario_of(k, &k->work, node);
        ++*n;
    }
    return all;
}

// Returns how many steps the replays of all candidates take.
static uint64_t steps_of(const Candidate *all, uint32_t n)
{
    uint64_t steps = 0;

    for (uint32_t i = 0; i < n; i++)
        steps += all[i].s.steps;
    return steps;
}

// Replays the candidates that are neither simplified nor superfluous, to find which goals they reach.
static void replay_candidates(Chooser *c, Candidate *all, uint32_t n)
{
    const GoalSet nothing = {NULL, 0, 0};

    for (uint32_t i = 0; i < n; i++) {
        Candidate *x = &all[i];
        if (x->simple || x->used)
            continue;
        chooser_replay(c, c->k->judge, &x->s, &nothing, NULL);
        x->reached = reached_set(c);
        x->end = chooser_end_state(c);
    }
}

static int compare_changes(const void *a, const void *b)
{
    const Candidate *x = *(Candidate *const *)a, *y = *(Candidate *const *)b;

    if (x->s.changes != y->s.changes)
        return x->s.changes < y->s.changes ? -1 : 1;
    return x->s.steps != y->s.steps ? (x->s.steps < y->s.steps ? -1 : 1) : x->node < y->node ? -1 : x->node > y->node;
}

// Returns the candidates, those with the fewest changes first.
static Candidate **order_candidates(Chooser *c, Candidate *all, uint32_t n)
{
    Candidate **order = arena_array(&c->k->work, n + 1, sizeof *order);

    for (uint32_t i = 0; i < n; i++)
        order[i] = &all[i];
    qsort(order, n, sizeof *order, compare_changes);
    return order;
}

// Returns the goals that were found at the candidate's node and that no simplified candidate reaches.
static GoalSet find_own_goals(Chooser *c, const Candidate *x, const uint8_t *shown)
{
    GoalSet out = {NULL, 0, 0};

    for (uint32_t g = 0; g < c->k->goals; g++)
        if (c->k->goal[g].found == x->node && !is_in_set(shown, g))
            vec_push(&c->k->work, &out, g);
    return out;
}

// Simplifies each candidate for the goals that only its run has been found for, those with the fewest changes first: the others can then begin as
// they do.  A candidate that is simplified, or superfluous, needs no replay, so the steps that are reserved for it are added to the effort.
static void simplify_candidates(Chooser *c, Candidate *all, uint32_t n)
{
    SearchRun *k = c->k;
    const GoalSet nothing = {NULL, 0, 0};
    const uint64_t rest = (k->effort - k->r->steps) / SIMPLIFY_PART;
    Candidate **order = order_candidates(c, all, n);
    uint8_t *shown = arena_alloc(&k->work, k->goals / 8 + 1);

    for (uint32_t i = 0; i < n && k->r->steps + rest < k->effort && !k->r->stopped; i++) {
        Candidate *x = order[i];
        const GoalSet want = find_own_goals(c, x, shown);
        const uint64_t reserved = x->s.steps;
        x->used = want.n == 0;
        c->limit = k->r->steps + (k->effort - rest - k->r->steps) / (n - i);
        if (!x->used) {
            build_wanted(c, &want);
            x->simple = chooser_simplify(c, &x->s, &want);
        }
        k->effort += x->used || x->simple ? reserved : 0;
        if (!x->simple)
            continue;
        x->end = c->end;
        x->reached = set_of(c, &want);
        if (chooser_replay(c, k->judge, &x->s, &nothing, NULL)) {
            x->reached = reached_set(c);
            chooser_keep_ways(c, &x->s);
        }
        for (uint32_t b = 0; b < k->goals / 8 + 1; b++)
            shown[b] |= x->reached[b];
    }
}

// Chooses the candidate that reaches most goals that are left for its number of changes.  is_simple: only among simplified ones with few changes.
static Candidate *choose_best(const Chooser *c, Candidate *all, uint32_t n, bool is_simple, GoalSet *want)
{
    Candidate *best = NULL;
    size_t most = 0;

    for (uint32_t i = 0; i < n; i++) {
        size_t new = 0;
        if (all[i].used || (is_simple && (!all[i].simple || all[i].s.changes > SIMPLE_CHANGES)))
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

// Stores the simplified candidates that reach new goals: first few of those with few changes, which together reach what all of them do.  Then those
// with the fewest changes, so that a goal is reached by one of the simplest runs to it.
static void choose_simple(Chooser *c, Candidate *all, uint32_t n)
{
    GoalSet want = {NULL, 0, 0};
    Candidate *x, **order = order_candidates(c, all, n);

    while ((x = choose_best(c, all, n, true, &want)) != NULL) {
        x->used = true;
        store_chosen(c, &x->s, x->end, x->reached);
    }
    for (uint32_t i = 0; i < n; i++)
        if (order[i]->simple && !order[i]->used) {
            order[i]->used = true;
            store_chosen(c, &order[i]->s, order[i]->end, order[i]->reached);
        }
}

void search_begin_choosing(SearchRun *k)
{
    Chooser *c = k->chooser = ARENA_NEW(&k->work, Chooser);

    c->k = k;
    arena_init_within(&c->flats, &k->work);
    arena_init_within(&c->tries, &k->work);
    arena_init_within(&c->unrolled, &k->work);
    k->judge = search_flat(k, &k->work, &k->c->probes);
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

// Simplifies the candidates, and runs to states before that.  The steps of a replay of each candidate stay reserved.
static void simplify_in_part(Chooser *c, Candidate *all, uint32_t n)
{
    SearchRun *k = c->k;
    const uint64_t full = k->effort, left = full - k->r->steps, reserved = steps_of(all, n);

    k->effort -= reserved < left ? reserved : left;
    simplify_ways(c, k->r->steps + (k->effort - k->r->steps) / WAYS_PART);
    simplify_candidates(c, all, n);
    k->effort = full;
}

void search_choose(SearchRun *k)
{
    Chooser *c = k->chooser;
    Candidate *all, *best;
    uint32_t n = 0;
    GoalSet want = {NULL, 0, 0};
    const uint64_t full = k->effort;

    // Reserves one step for each goal that was not found: search_describe_missing needs it.
    if (k->effort - k->r->steps > k->reserve + k->open)
        k->effort -= k->open;
    k->stop_at = k->effort;
    all = list_candidates(c, &n);
    if (!k->o->drafts) {
        simplify_in_part(c, all, n);
        choose_simple(c, all, n);
    }
    replay_candidates(c, all, n);
    while ((best = choose_best(c, all, n, false, &want)) != NULL) {
        best->used = true;
        if (!k->o->drafts)
            choose_scenario(c, best, &want);
        if (find_unreached(c, want.at, want.n).n)     // the simplified scenarios can reach less than `best` does
            store_chosen(c, &best->s, best->end, best->reached);
    }
    if (!k->o->drafts) {
        const uint64_t end = k->effort, part = (end - (k->r->steps < end ? k->r->steps : end)) / GATHER_PART;
        k->effort -= part;
        improve_longest(c);
        k->effort = end;
        gather_chosen(c);
    }
    k->r->chosen = c->chosen.at;
    k->r->chosens = c->chosen.n;
    k->effort = full;
}
