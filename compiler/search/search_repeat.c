// SPDX-License-Identifier: Apache-2.0
// Does the same again and again: some goals need a count, and each of its steps needs changes of inputs.
//
// A round is a list of segments.  Pulses are rounds in one state: changes that were found for a goal, and the values before them.  A way around
// leads through a state that stores a variable and back; it is repeated as often as the variable needs.  Later, scenarios show rounds as loops
// (search_rounds.c).
#include <string.h>

#include "compiler/search/search_run.h"
#include "stdlib/convert.h"

enum {
    MOST_LEGS = 24,           // segments of a round
    LEG_TRIES = 4,            // failed attempts to leave a state, after which a detour is given up
    MOST_ROUNDS = 2048,       // rounds that one attempt runs
    OWN_PERCENT = 33,         // of a hundred detours, so many are asked to go through the state of the goal
    SHARE = 16                // an attempt uses at most 1 / SHARE of the effort
};

// A segment that is repeated.
typedef struct SearchLeg { SearchTurn *turn; uint32_t turns; uint64_t steps; } SearchLeg;

typedef struct SearchRound { SearchLeg leg[MOST_LEGS]; uint32_t legs; uint64_t steps; } SearchRound;

// Adds the current changes of inputs, followed by a number of steps, as one leg of the round, which is repeated as a whole.
static void add_leg(SearchRun *k, Arena *arena, SearchRound *r, uint64_t steps)
{
    SearchLeg *l = &r->leg[r->legs++];

    l->turns = k->turn.n;
    l->turn = arena_array(arena, k->turn.n + 1, sizeof *l->turn);
    if (k->turn.n)
        memcpy(l->turn, k->turn.at, k->turn.n * sizeof *l->turn);
    l->steps = steps;
    r->steps += steps;
}

// Runs a round from a node, which the caller uses once.  Returns the node after it, which is used once instead.
static uint32_t run_round(SearchRun *k, uint32_t node, const SearchRound *r)
{
    for (uint32_t i = 0; i < r->legs && search_goes_on(k) && k->node.at[node].copy; i++) {
        const uint32_t next = search_run_exactly(k, node, r->leg[i].turn, r->leg[i].turns, r->leg[i].steps);
        search_drop(k, node);
        node = next;
    }
    return node;
}

// Runs rounds until the goal is reached, and drops the node.  is_first: no round was run before.
static void run_rounds(SearchRun *k, uint32_t node, const SearchRound *r, bool is_first, uint64_t rounds, uint32_t goal)
{
    const uint64_t share = k->effort / SHARE / (r->steps + 1) + 1;

    rounds = rounds < share ? rounds : share;
    for (uint64_t i = 0; i < rounds && i < MOST_ROUNDS && !k->goal[goal].done && search_goes_on(k) && k->node.at[node].copy; i++) {
        k->is_round = i > 0 || !is_first;
        node = run_round(k, node, r);
    }
    k->is_round = false;
    search_drop(k, node);
}

// ---- pulses ----

// Returns how many steps a pulse lasts: as long as a solution must last, or a random number.
static uint64_t choose_width(SearchRun *k)
{
    if (k->wait > 1 && k->wait < 4096 && search_chance(k, 30))
        return k->wait + 1;
    return search_chance(k, 50) ? 1 + search_pick(k, 3) : UINT64_C(1) << search_pick(k, 9);
}

// Replaces the value of each change by the one that its input has now.
static void undo_changes(SearchRun *k)
{
    for (uint32_t i = 0; i < k->turn.n; i++) {
        SearchTurn *t = &k->turn.at[i];
        const SearchInput *in = &k->input[t->input];
        double now = sm_cell_to_f64(in->type, flat_cells(k->plain, k->scratch)[in->at]);
        if (now == t->setting.a)
            now = in->type == SM_BOOL ? now == 0 : in->constant.at[search_pick(k, in->constant.n)];
        t->setting = (SearchSetting){.set = true, .kind = SCENARIO_HOLD, .a = now};
    }
}

void search_run_pulses(SearchRun *k, uint32_t node, uint32_t goal)
{
    const uint64_t high = choose_width(k), low = search_chance(k, 60) ? high : choose_width(k), count = k->rounds ? k->rounds + 2 : UINT64_C(1) << search_pick(k, 8);
    SearchRound *r = ARENA_NEW(&k->legs, SearchRound);

    if (k->turn.n > 0) {
        add_leg(k, &k->legs, r, high);
        undo_changes(k);
        add_leg(k, &k->legs, r, low);
        k->node.at[node].users++;
        run_rounds(k, node, r, true, count, goal);
    }
    arena_reset(&k->legs);
}

// ---- ways around ----

// Finds for each state how many transitions lead from it to `to`, at least.
static void find_distances(const SearchRun *k, uint32_t to, uint32_t *distance)
{
    memset(distance, 0xff, k->p->state.n * sizeof *distance);
    distance[to - 1] = 0;
    for (bool again = true; again; ) {
        again = false;
        for (uint32_t i = 0; i < k->exit.n; i++) {
            const SearchExit *x = &k->exit.at[i];
            const uint32_t place = k->c->probes.transition[x->stmt];
            if (distance[x->to - 1] == SEARCH_NONE || distance[x->from - 1] <= distance[x->to - 1] + 1 || k->r->find[place].outcome == SEARCH_IMPOSSIBLE)
                continue;
            distance[x->from - 1] = distance[x->to - 1] + 1;
            again = true;
        }
    }
}

// Chooses an exit of a state that is on a shortest path, and now and then any that leads there.
static const SearchExit *choose_exit_towards(SearchRun *k, uint32_t from, const uint32_t *distance)
{
    const bool is_any = search_chance(k, 15);
    const SearchExit *out = NULL;
    uint32_t least = SEARCH_NONE, n = 0;

    for (uint32_t i = 0; i < k->exit.n; i++) {
        const SearchExit *x = &k->exit.at[i];
        if (x->from != from || distance[x->to - 1] == SEARCH_NONE || (!is_any && distance[x->to - 1] > least))
            continue;
        n = !is_any && distance[x->to - 1] < least ? 0 : n;
        least = distance[x->to - 1] < least ? distance[x->to - 1] : least;
        if (search_pick(k, ++n) == 0)
            out = x;
    }
    return out;
}

// Goes from a node towards a state, by one transition or more, and adds the legs.  The caller uses the node once.  Returns the node that was
// reached, used once instead, or SEARCH_NONE.
static uint32_t go_to_state(SearchRun *k, uint32_t node, uint32_t to, SearchRound *r)
{
    uint32_t *distance = arena_array(&k->legs, k->p->state.n, sizeof *distance), tries = LEG_TRIES;
    const uint64_t most = k->r->steps + k->effort / SHARE;

    find_distances(k, to, distance);
    while (tries > 0 && r->legs < MOST_LEGS && k->node.at[node].copy && search_goes_on(k) && k->r->steps < most) {
        const uint32_t state = k->node.at[node].state;
        const SearchExit *x = choose_exit_towards(k, state, distance);
        uint32_t next;
        uint64_t steps;
        if (!x)
            break;
        steps = search_solve_exit(k, node, x);
        next = search_run_exactly(k, node, k->turn.at, k->turn.n, steps);
        if (k->node.at[next].state == state || distance[k->node.at[next].state - 1] == SEARCH_NONE) {
            search_drop(k, next);
            tries--;
            continue;
        }
        add_leg(k, &k->legs, r, steps);
        search_drop(k, node);
        node = next;
        tries = LEG_TRIES;
        if (k->node.at[node].state == to)
            return node;
    }
    search_drop(k, node);
    return SEARCH_NONE;
}

uint32_t search_find_nearest_entry(SearchRun *k, uint32_t var, double wanted, uint32_t state)
{
    double least = SEARCH_UNKNOWN;
    uint32_t best = SEARCH_NONE, n = 0;

    for (uint32_t s = state ? state - 1 : 0; s < (state ? state : k->p->state.n); s++)
        for (uint32_t i = 0; i < k->entries[s]; i++) {
            const uint32_t node = k->entry[s * SEARCH_ENTRIES + i].node;
            const double x = sm_cell_to_f64(k->m->var.at[var].type, flat_cells(k->plain, k->node.at[node].copy)[var]) - wanted;
            const double distance = x < 0 ? -x : x;
            if (distance > least || (distance == least && search_pick(k, ++n) != 0))
                continue;
            n = distance < least ? 1 : n;
            least = distance;
            best = node;
        }
    return best;
}

// Chooses a state that stores a variable: often the preferred one, if it does.
static uint32_t choose_storing_state(SearchRun *k, uint32_t var, uint32_t preferred)
{
    uint32_t n = 0, out = 0;

    for (uint32_t i = 0; i < k->var[var].store.n; i++)
        if (k->var[var].store.at[i].state == preferred && preferred != 0 && search_chance(k, 50))
            return preferred;
    for (uint32_t i = 0; i < k->var[var].store.n; i++)
        if (k->var[var].store.at[i].state && search_pick(k, ++n) == 0)
            out = k->var[var].store.at[i].state;
    return out;
}

// Returns the value of a variable in the snapshot of a node.
static double value_at(const SearchRun *k, uint32_t node, uint32_t var)
{
    return sm_cell_to_f64(k->m->var.at[var].type, flat_cells(k->plain, k->node.at[node].copy)[var]);
}

void search_go_around(SearchRun *k, uint32_t goal)
{
    // A detour through another state may lose the count on every path back to the goal.
    const uint32_t own = search_chance(k, OWN_PERCENT) ? k->site_state : 0;
    const uint32_t var = k->foreign, to = choose_storing_state(k, var, own);
    const double wanted = k->foreign_value;
    uint32_t node = search_find_nearest_entry(k, var, wanted, own), from;
    SearchRound *r = ARENA_NEW(&k->legs, SearchRound);
    double was;

    if (node != SEARCH_NONE && to) {
        was = value_at(k, node, var);
        from = k->node.at[node].state;
        k->node.at[node].users++;
            node = go_to_state(k, node, to, r);
        if (node != SEARCH_NONE && from != to)
            node = go_to_state(k, node, from, r);
        if (node != SEARCH_NONE && k->node.at[node].copy) {
            const double change = value_at(k, node, var) - was, rounds = change != 0 ? (wanted - was) / change + 1 : 0;
            run_rounds(k, node, r, false, rounds < 0 ? 0 : rounds > (double)MOST_ROUNDS ? MOST_ROUNDS : (uint64_t)rounds, goal);
        } else if (node != SEARCH_NONE) {
            search_drop(k, node);
        }
    }
    arena_reset(&k->legs);
}
