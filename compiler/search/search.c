// SPDX-License-Identifier: Apache-2.0
// The loop of a search: chooses a goal and a snapshot, solves for inputs, and runs.
#include "compiler/search/search.h"

#include <string.h>

#include "compiler/cover/flat_app.h"
#include "compiler/search/search_run.h"

enum {
    // X_PART: 1 / X_PART of the effort is for this purpose.  X_PERCENT: of a hundred attempts, so many are of this kind.
    SEARCH_PART = 2,          // choosing and simplifying scenarios, after the search
    FIRST_PART = 4,           // searching all goals, before shorter runs are searched
    GIVEN_PART = 2,           // running the caller's scenarios (SearchOptions.given); the last one that begins in time is run to its end
    MANY_CHANGES = 4,         // goals reached after more changes than this are searched again, for runs with fewer
    WAYS_PART = 8,            // simplifying a run to each state, at most
    SHORTER_PART = 8,         // searching runs with fewer changes, at most
    SHORTER_TIMES = 4,        // the search for shorter scenarios runs at most this multiple of the steps before it
    WALK_PERCENT = 20,        // random walks, without a goal
    WALK_LENGTH = 6,          // number of transitions of a walk
    SPECIAL_PART = 16,        // runs with special values (search_special.c) before all other attempts
    SPECIAL_PERCENT = 10,     // later: runs with special values from an entry
    SPECIAL_RUNS = 20,        // number of runs of each attempt with special values
    DEEP = 12,                // a snapshot after more changes than this is chosen less often
    ENTRY_PERCENT = 33,       // attempts for a goal that begin at an entry of its state instead of a snapshot of its pool
    EASY_STEPS = 4000,        // a goal on which more steps were spent is hard
    AROUND_PERCENT = 30,      // hard goal, and another state must store a variable: go through that state and back, again and again
    FOREIGN_PERCENT = 60,     // any goal, and another state must store a variable: walk from the entry where it is nearest to the wanted value
    COUNT_PERCENT = 50,       // hard goal, and its state must count a variable: make pulses of inputs
    REPAIR_PERCENT = 80,      // attempts that must wait in a state, and change what would end the wait (SearchOptions.stays); in an application,
                              // what other machines would store
    LEAD_PERCENT = 30,        // with SearchOptions.stays: attempts before which up to LEAD_STEPS steps pass
    LEAD_STEPS = 4,
    PULSE_PERCENT = 4         // any other hard goal: make pulses of inputs
};

// SplitMix64: every seed, 0 included, is as good as another.
uint64_t search_random(SearchRun *k)
{
    uint64_t z = k->random += UINT64_C(0x9e3779b97f4a7c15);

    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

// ---- goals ----

// Picks two random entries of a state, and returns, three times of four, the one after fewer changes.
static uint32_t pick_entry(SearchRun *k, uint32_t state)
{
    const SearchNear *pool = &k->entry[state * SEARCH_ENTRIES];
    const uint32_t a = pool[search_pick(k, k->entries[state])].node, b = pool[search_pick(k, k->entries[state])].node;

    return (k->node.at[b].depth < k->node.at[a].depth) == search_chance(k, 75) ? b : a;
}

// Returns an entry of a state that a goal can be reached in; SEARCH_NONE: none has been visited.
static uint32_t find_entry(SearchRun *k, const SearchGoal *g)
{
    uint32_t n = 0, out = SEARCH_NONE;

    for (uint32_t s = 0; s < g->site.n; s++) {
        const uint32_t state = g->site.at[s].state;
        if (state == 0 || k->entries[state - 1] == 0 || search_pick(k, ++n) != 0)
            continue;
        out = pick_entry(k, state - 1);
    }
    return out;
}

// Returns a snapshot that was taken when a state was entered, of a random state.
static uint32_t find_any_entry(SearchRun *k)
{
    const uint32_t states = k->p->state.n, first = search_pick(k, states);

    for (uint32_t i = 0; i < states; i++) {
        const uint32_t s = (first + i) % states;
        if (k->entries[s])
            return pick_entry(k, s);
    }
    return SEARCH_NONE;
}

// Whether a run can come nearer to the goal now: a snapshot near it exists, or a state where it can be reached has been visited.
static bool is_approachable(const SearchRun *k, const SearchGoal *g)
{
    if (g->pooled || g->site.n == 0)
        return true;
    for (uint32_t s = 0; s < g->site.n; s++)
        if (g->site.at[s].state == 0 || k->visited[g->site.at[s].state - 1])
            return true;
    return false;
}

// Chooses the open goal on which the fewest steps were spent.
static uint32_t choose_goal(SearchRun *k)
{
    uint32_t best = SEARCH_NONE;

    for (uint32_t g = 0; g < k->goals; g++)
        if (!k->goal[g].done && is_approachable(k, &k->goal[g]) && (best == SEARCH_NONE || k->goal[g].cost < k->goal[best].cost))
            best = g;
    return best;
}

// Picks a snapshot of a goal: of two that are both after many changes, the one after fewer.
static uint32_t pick_near(SearchRun *k, const SearchGoal *g)
{
    const uint32_t a = g->pool[search_pick(k, g->pooled)].node;
    uint32_t b;

    if (k->node.at[a].depth <= DEEP)
        return a;
    b = g->pool[search_pick(k, g->pooled)].node;
    return k->node.at[b].depth < k->node.at[a].depth ? b : a;
}

// Returns the snapshot from which the next attempt for this goal begins.
static uint32_t choose_node(SearchRun *k, const SearchGoal *g)
{
    uint32_t n = SEARCH_NONE;

    if (g->pooled == 0 || search_chance(k, ENTRY_PERCENT))
        n = find_entry(k, g);
    if (n == SEARCH_NONE && g->pooled)
        n = pick_near(k, g);
    return n == SEARCH_NONE ? find_any_entry(k) : n;
}

// ---- walks ----

// Returns a random transition out of a state.
static const SearchExit *choose_exit(SearchRun *k, uint32_t state)
{
    const SearchExit *out = NULL;
    uint32_t n = 0;

    for (uint32_t i = 0; i < k->exit.n; i++)
        if (k->exit.at[i].from == state && search_pick(k, ++n) == 0)
            out = &k->exit.at[i];
    return out;
}

// Goes from state to state by any transitions, so that entries with other stored values are found.
static void walk_from(SearchRun *k, uint32_t node)
{
    if (node == SEARCH_NONE)
        return;
    k->node.at[node].users++;
    for (uint32_t i = 0; i < WALK_LENGTH && search_goes_on(k); i++) {
        const SearchExit *x = choose_exit(k, k->node.at[node].state);
        uint32_t next;
        if (!x || !k->node.at[node].copy)
            break;
        {
            const uint64_t steps = search_solve_exit(k, node, x);
            next = search_run_segment(k, node, k->turn.at, k->turn.n, steps, SEARCH_NONE);
        }
        search_drop(k, node);
        node = next;
    }
    search_drop(k, node);
}

// Solves for changes of inputs that lead from a snapshot to a goal, and runs them.
static void attempt_goal_from(SearchRun *k, uint32_t node, uint32_t goal)
{
    const bool is_hard = !k->o->plain && k->goal[goal].cost > EASY_STEPS;
    const uint64_t steps = search_solve_goal(k, node, goal);

    if (k->o->stays && k->wait > 1 && search_chance(k, REPAIR_PERCENT))
        search_run_staying(k, node, goal);
    else if (k->o->place && k->wait > 1 && search_chance(k, REPAIR_PERCENT))
        search_run_guarding(k, node, goal);
    else if (is_hard && k->foreign != SEARCH_NONE && search_chance(k, AROUND_PERCENT))
        search_go_around(k, goal);
    else if (k->foreign != SEARCH_NONE && search_chance(k, FOREIGN_PERCENT))
        walk_from(k, search_find_nearest_entry(k, k->foreign, k->foreign_value, 0));
    else if (is_hard && search_chance(k, k->rounds > 1 ? COUNT_PERCENT : PULSE_PERCENT))
        search_run_pulses(k, node, goal);
    else
        search_run_segment(k, node, k->turn.at, k->turn.n, steps, goal);
}

// Makes one attempt to reach a goal, from a snapshot.  Sometimes lets a few steps pass first, so that the changes are the second value of an input,
// as an edge needs.
static void attempt_goal(SearchRun *k, uint32_t goal)
{
    const uint64_t before = k->r->steps;
    uint32_t node = choose_node(k, &k->goal[goal]);

    if (k->o->stays && search_chance(k, LEAD_PERCENT)) {
        node = search_run_segment(k, node, NULL, 0, 1 + search_pick(k, LEAD_STEPS), SEARCH_NONE);
        if (k->node.at[node].copy && !k->goal[goal].done)
            attempt_goal_from(k, node, goal);
        search_drop(k, node);
    } else {
        attempt_goal_from(k, node, goal);
    }
    k->goal[goal].cost += k->r->steps - before + 100;
}

// Makes a few short runs with special values from a node.
static void attempt_specials(SearchRun *k, uint32_t node)
{
    for (uint32_t i = 0; i < SPECIAL_RUNS && k->open && search_goes_on(k) && node != SEARCH_NONE && k->node.at[node].copy; i++)
        search_run_specials(k, node);
}

// Makes attempts until no goal is open, or so many steps have run.
static void search_until(SearchRun *k, uint64_t end)
{
    const bool specials = k->o->specials != SEARCH_NO_SPECIALS && k->inputs > 0;

    while (k->open && k->r->steps < end && search_goes_on(k)) {
        uint32_t goal;
        if (specials && search_chance(k, SPECIAL_PERCENT)) {
            attempt_specials(k, find_any_entry(k));
            continue;
        }
        goal = search_chance(k, WALK_PERCENT) ? SEARCH_NONE : choose_goal(k);
        if (goal == SEARCH_NONE)
            walk_from(k, find_any_entry(k));
        else
            attempt_goal(k, goal);
    }
}

// Searches for runs with fewer changes: first to goals that were reached after many, then to all.
static void search_shorter(SearchRun *k)
{
    static const uint32_t most[] = {MANY_CHANGES, 1};
    const uint64_t ways = k->effort / WAYS_PART, before = k->r->steps * SHORTER_TIMES;

    if (!k->o->plain)
        search_shorten_ways(k, k->r->steps + (ways < before ? ways : before));
    for (int i = 0; i < 2 && !k->o->plain; i++) {
        const uint64_t part = k->effort / SHORTER_PART, again = k->r->steps * SHORTER_TIMES, end = k->r->steps + (part < again ? part : again);
        while (k->r->steps < end && search_goes_on(k) && search_reopen(k, most[i]))
            search_until(k, end);
        search_close_again(k);
    }
}

// Runs the search: special values first, then the attempts for each goal, then shorter scenarios for what was found.
static void run_search(SearchRun *k)
{
    const bool specials = k->o->specials != SEARCH_NO_SPECIALS && k->inputs > 0;

    while (specials && k->open && k->r->steps < k->effort / SPECIAL_PART && search_goes_on(k))
        attempt_specials(k, k->root);
    if (!k->o->drafts) {
        search_until(k, k->effort / FIRST_PART);
        search_shorter(k);
    }
    search_until(k, k->effort);
}

// ---- beginning and end ----

FlatMachine *search_flat(const SearchRun *k, Arena *arena, const FlatProbes *probes)
{
    FlatMachine *f = flat_new(arena, k->m, probes);

    return k->o->place ? flat_app_join(f, k->o->place->app) : f;
}

static void begin_result(SearchRun *k)
{
    const SearchOptions *o = k->o;
    const Cover *c = k->c;
    const unsigned kinds = o->kinds ? o->kinds : SEARCH_KINDS;
    SearchResult *r = k->r = ARENA_NEW(k->arena, SearchResult);

    r->delta_t = k->delta_t = k->p->step ? k->p->step : o->delta_t ? o->delta_t : SEARCH_DELTA_T;
    r->places = c->place.n;
    r->finds = r->places + (o->watch ? o->watch->goals : 0);
    r->find = ARENA_ARRAY(k->arena, SearchFind, r->finds);
    for (uint32_t i = 1; i < r->finds; i++) {
        SearchFind *f = &r->find[i];
        const bool is_goal = i >= r->places || (!o->no_places && c->hits[i] == 0 && kinds >> c->place.at[i].kind & 1);
        f->nearest = SEARCH_UNKNOWN;
        f->reason = is_goal && i < r->places ? c->place.at[i].impossible : NULL;
        f->outcome = !is_goal ? SEARCH_NO_GOAL : f->reason ? SEARCH_IMPOSSIBLE : SEARCH_NOT_FOUND;
    }
}

void search_run_given(SearchRun *k, const Scenario *looped)
{
    const Scenario s = scenario_unroll(&k->work, looped);
    uint64_t at = 0;
    uint32_t node = k->root;

    k->node.at[node].users++;
    for (size_t c = 0; at < s.steps && search_goes_on(k) && k->node.at[node].copy; ) {
        const ScenarioLoop *l = scenario_loop_at(looped, at + 1);
        uint64_t end;
        uint32_t next;
        k->turn.n = 0;
        for (; c < s.changes && s.change[c].step <= at + 1; c++)
            search_add_change(k, &s.change[c]);
        end = c < s.changes && s.change[c].step <= s.steps ? s.change[c].step - 1 : s.steps;
        k->is_round = l && at + 1 >= l->from + l->period;
        next = search_run_exactly(k, node, k->turn.at, k->turn.n, end - at);
        search_drop(k, node);
        node = next;
        at = end;
    }
    k->is_round = false;
    search_drop(k, node);
}

// Runs scenarios of the caller, so that the snapshots along them are known.
static void run_given(SearchRun *k)
{
    for (uint32_t i = 0; i < k->o->givens && search_goes_on(k) && k->r->steps < k->stop_at / GIVEN_PART; i++)
        if (k->o->given[i].init_state == k->start && k->o->given[i].delta_t == k->delta_t)
            search_run_given(k, &k->o->given[i]);
}

SearchResult *search_run(Arena *arena, const Cover *c, const SearchOptions *o)
{
    SearchRun *k = ARENA_NEW(arena, SearchRun);

    arena_init_within(&k->work, arena);
    arena_init_within(&k->flats, arena);
    arena_init_within(&k->legs, arena);
    k->arena = arena;
    k->c = c;
    k->p = c->p;
    k->m = c->m;
    k->o = o;
    k->random = o->seed;
    k->effort = o->effort ? o->effort : SEARCH_EFFORT;
    k->stop_at = o->drafts ? k->effort : k->effort - k->effort / SEARCH_PART;
    k->memory = o->memory ? o->memory : SEARCH_MEMORY;
    k->start = o->init_state ? o->init_state : c->p->state.at[0];
    k->every = o->place ? o->place->every : 1;
    k->plain = search_flat(k, &k->work, NULL);
    begin_result(k);
    search_analyse_machine(k);
    search_make_goals(k);
    search_prove(k);
    search_begin_nodes(k);
    search_begin_solving(k);
    search_build_flat(k);
    search_begin_choosing(k);
    run_given(k);
    run_search(k);
    search_choose(k);
    search_describe_missing(k);
    arena_free(&k->flats);
    arena_free(&k->legs);
    arena_free(&k->work);
    return k->r;
}
