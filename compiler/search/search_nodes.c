// SPDX-License-Identifier: Apache-2.0
// States that have been reached, as snapshots, and runs that begin at one.
//
// A snapshot is one block of memory: the state of the flat machine, the situation of the caller's goals, and how each input is set.
#include <string.h>

#include "compiler/cover/flat_app.h"
#include "compiler/search/search_run.h"
#include "stdlib/convert.h"

enum {
    REPORT_STEPS = 100000,    // after each so many steps, the caller is asked whether to go on
    LEAP_AFTER = 64,          // after this many steps in a state, only every LEAP_EVERY-th step measures distances
    LEAP_EVERY = 32,
    STAY_PERCENT = 10,        // of a hundred segments, so many are not shortened at transitions: some counters only count while states alternate
    STALE_STEPS = 2000000,    // after this many steps without progress, few segments measure distances
    // Bytes that the memory limit assumes for a node, a turn and a setting, on every computer: so it has the same effect everywhere.  They are more
    // than the structs need, because an array that grows also needs its old memory.
    NODE_BYTES = 192,
    TURN_BYTES = 64,
    SETTING_BYTES = 48
};

static size_t round_up(size_t n) { return (n + 7) / 8 * 8; }

// ---- memory ----

// Freed memory is reused, and never returned to the arena: `used` counts the most that was in use at one time.
static bool has_room(const SearchRun *k) { return k->free.n > 0 || k->used + k->nominal <= k->memory; }

// Whether a node with this many changes fits in the memory limit.
static bool has_room_for_node(const SearchRun *k, uint32_t turns)
{
    const size_t node = k->free_node == SEARCH_NONE ? NODE_BYTES : 0, turn = turns && !k->free_turn[turns] ? turns * TURN_BYTES : 0;

    return k->used + node + turn <= k->memory;
}

// Returns memory for a snapshot, from the free list if possible.
static char *allocate_block(SearchRun *k)
{
    if (k->free.n)
        return k->free.at[--k->free.n];
    k->used += k->nominal;
    return arena_alloc_unzeroed(&k->work, k->block);
}

// Arrays of turns of one length are in a list when they are free; the first turn of each points to the next array.
static SearchTurn *allocate_turns(SearchRun *k, uint32_t n)
{
    SearchTurn *t = k->free_turn[n];

    if (n == 0)
        return NULL;
    if (t) {
        memcpy(&k->free_turn[n], t, sizeof(void *));
        return t;
    }
    k->used += n * TURN_BYTES;
    return arena_array(&k->work, n, sizeof *t);
}

// Puts an array of n changes on the free list of arrays of that length.
static void free_turns(SearchRun *k, SearchTurn *t, uint32_t n)
{
    if (n == 0)
        return;
    memcpy(t, &k->free_turn[n], sizeof(void *));
    k->free_turn[n] = t;
}

static uint32_t allocate_node(SearchRun *k)
{
    const uint32_t n = k->free_node;
    const SearchNode none = {.parent = SEARCH_NONE};

    if (n != SEARCH_NONE) {
        k->free_node = k->node.at[n].parent;
        return n;
    }
    k->used += NODE_BYTES;
    vec_push(&k->work, &k->node, none);
    return k->node.n - 1;
}

// Frees a node that nothing needs, and then its parents.
static void free_unneeded(SearchRun *k, uint32_t n)
{
    while (n != SEARCH_NONE && k->node.at[n].users == 0 && k->node.at[n].followers == 0) {
        const uint32_t parent = k->node.at[n].parent;
        free_turns(k, k->node.at[n].turn, k->node.at[n].turns);
        k->node.at[n] = (SearchNode){.parent = k->free_node};
        k->free_node = n;
        if (parent != SEARCH_NONE)
            k->node.at[parent].followers--;
        n = parent;
    }
}

static void use_node(SearchRun *k, uint32_t n) { k->node.at[n].users++; }

// Takes away one user of a node; without users it loses its snapshot, and without followers too it is freed.
static void drop_node(SearchRun *k, uint32_t n)
{
    SearchNode *x = &k->node.at[n];

    if (--x->users > 0)
        return;
    if (x->copy)
        vec_push(&k->work, &k->free, x->copy);
    x->copy = NULL;
    free_unneeded(k, n);
}

// ---- eviction ----

// Removes an entry from the pool of the state that has most: the one after most changes and steps.  Returns false if no state has two entries.
static bool evict_entry(SearchRun *k)
{
    uint32_t state = 0, worst = 0;
    SearchNear *pool;

    for (uint32_t s = 1; s < k->p->state.n; s++)
        state = k->entries[s] > k->entries[state] ? s : state;
    if (k->entries[state] < 2)
        return false;
    pool = &k->entry[state * SEARCH_ENTRIES];
    for (uint32_t i = 1; i < k->entries[state]; i++) {
        const SearchNode *x = &k->node.at[pool[i].node], *y = &k->node.at[pool[worst].node];
        worst = x->depth != y->depth ? x->depth > y->depth ? i : worst : x->at > y->at ? i : worst;
    }
    drop_node(k, pool[worst].node);
    pool[worst] = pool[--k->entries[state]];
    return true;
}

// Returns the index of the snapshot in the goal's pool that is farthest from the goal.
static uint32_t find_farthest(const SearchGoal *g)
{
    uint32_t at = 0;

    for (uint32_t i = 1; i < g->pooled; i++)
        at = g->pool[i].distance > g->pool[at].distance ? i : at;
    return at;
}

// Removes the farthest snapshot of the goal that has most.
static bool evict_near(SearchRun *k)
{
    SearchGoal *g = NULL;
    uint32_t at;

    for (uint32_t i = 0; i < k->goals; i++)
        g = k->goal[i].pooled > 1 && (!g || k->goal[i].pooled > g->pooled) ? &k->goal[i] : g;
    if (!g)
        return false;
    at = find_farthest(g);
    drop_node(k, g->pool[at].node);
    g->pool[at] = g->pool[--g->pooled];
    return true;
}

// Evicts snapshots until a node with its copy fits, or nothing more can be evicted.
static void make_room(SearchRun *k, uint32_t turns)
{
    if (has_room(k) && has_room_for_node(k, turns))
        return;
    k->r->memory_reached = true;
    while (!(has_room(k) && has_room_for_node(k, turns)) && (evict_entry(k) || evict_near(k))) { }
}

// ---- inputs ----

void search_apply(SearchRun *k, char *block, uint64_t at, const SearchTurn *turn, uint32_t turns)
{
    SearchSetting *s = search_settings(k, block);

    for (uint32_t i = 0; i < turns; i++) {
        s[turn[i].input] = turn[i].setting;
        s[turn[i].input].since = at + 1;
    }
}

// Sets input i before step `step`.
static void set_input(SearchRun *k, char *block, uint32_t i, uint64_t step)
{
    const SearchSetting *s = &search_settings(k, block)[i];
    uint64_t *cell = flat_cells(k->plain, block);
    double x = s->a;

    switch (s->kind) {
    case SCENARIO_HOLD: break;
    case SCENARIO_ALTERNATE: x = (step - s->since) % 2 ? s->b : s->a; break;
    case SCENARIO_RAMP: x = s->a + s->b * (double)(step - s->since); break;
    case SCENARIO_COPY: x = sm_cell_to_f64(k->p->var.at[s->source]->type, cell[k->m->var_of[s->source]]); break;
    }
    cell[k->input[i].at] = sm_cell_from_f64(k->input[i].type, x);
}

void search_set_inputs(SearchRun *k, char *block, uint64_t step)
{
    for (uint32_t i = 0; i < k->inputs; i++)
        if (search_settings(k, block)[i].set)
            set_input(k, block, i, step);
    flat_cells(k->plain, block)[k->m->g] = (step - 1) * k->delta_t;
}

// ---- snapshots ----

// Describes what the machine has stored: states that differ in it are worth a snapshot each.  Of large numbers only the magnitude counts.
static uint64_t key_of(const SearchRun *k, const char *block)
{
    const uint64_t *cell = flat_cells(k->plain, (char *)block);
    uint64_t h = ((const FlatState *)(const void *)block)->state;

    for (uint32_t i = 0; i < k->output.n; i++) {
        const Var *v = k->p->var.at[k->output.at[i]];
        double x = sm_cell_to_f64(v->type, cell[k->m->var_of[v->index]]);
        if (x > 16 || x < -16)
            x = 1e6 + (double)(int64_t)(1000 * search_near(x)) * (x < 0 ? -1 : 1);
        h = (h ^ (uint64_t)(int64_t)(4 * x)) * UINT64_C(0x9e3779b97f4a7c15);
        h ^= h >> 29;
    }
    return k->o->place ? flat_app_hash(k->plain, block, h) : h;
}

// The segment that is running.
typedef struct Segment {
    uint32_t from;            // the node where it begins
    const SearchTurn *turn;   // `turns` changes of inputs before its first step
    uint32_t turns;
    bool is_exact;            // all steps run, even if a goal is reached: the segment is part of a given run
} Segment;

// Returns the number of changes of inputs from the start of the run to the end of a segment, without those of repeated rounds.
static uint32_t depth_after(const SearchRun *k, const Segment *g)
{
    return g->from == SEARCH_NONE ? 0 : k->node.at[g->from].depth + (k->is_round ? 0 : g->turns);
}

// Adds the current step of a segment as a node with one user.  Without room for its copy it has none, so it only shows how a goal was reached.
static uint32_t add_node(SearchRun *k, const Segment *g)
{
    const FlatState *s = (const FlatState *)(const void *)k->now;
    SearchNode n = {.parent = g->from, .users = 1, .at = k->at, .turns = g->turns, .state = s->state, .key = key_of(k, k->now)};
    uint32_t at;

    make_room(k, g->turns);
    n.depth = depth_after(k, g);
    n.turn = allocate_turns(k, g->turns);
    if (g->turns)
        memcpy(n.turn, g->turn, g->turns * sizeof *g->turn);
    if (has_room(k)) {
        n.copy = allocate_block(k);
        memcpy(n.copy, k->now, k->block);
    }
    at = allocate_node(k);
    k->node.at[at] = n;
    if (g->from != SEARCH_NONE)
        k->node.at[g->from].followers++;
    return at;
}

void search_load(SearchRun *k, uint32_t node, char *to) { memcpy(to, k->node.at[node].copy, k->block); }

// ---- pools ----

// Whether a snapshot with so many changes and steps is simpler than a node.
static bool is_simpler(const SearchRun *k, uint32_t depth, uint64_t at, uint32_t node)
{
    const SearchNode *n = &k->node.at[node];

    return depth != n->depth ? depth < n->depth : at < n->at;
}

// Returns where among the entries of its state a snapshot with this key belongs; SEARCH_NONE: one that is as good is there.
static uint32_t find_place_of_entry(SearchRun *k, uint32_t state, uint64_t key, uint32_t depth, uint64_t at)
{
    const SearchNear *pool = &k->entry[(state - 1) * SEARCH_ENTRIES];
    const uint32_t n = k->entries[state - 1];
    uint32_t i = 0;

    while (i < n && k->node.at[pool[i].node].key != key)
        i++;
    if (i < n)
        return is_simpler(k, depth, at, pool[i].node) || search_chance(k, 2) ? i : SEARCH_NONE;
    return i < SEARCH_ENTRIES ? i : k->is_way || search_chance(k, 25) ? search_pick(k, SEARCH_ENTRIES) : SEARCH_NONE;
}

// Adds a node to the entries of its state, in place of one with the same key if that took longer.
static void add_entry(SearchRun *k, uint32_t n, uint32_t at)
{
    const uint32_t state = k->node.at[n].state;
    SearchNear *pool = &k->entry[(state - 1) * SEARCH_ENTRIES];

    if (at == SEARCH_NONE || !k->node.at[n].copy)
        return;
    use_node(k, n);
    if (at < k->entries[state - 1])
        drop_node(k, pool[at].node);
    else
        at = k->entries[state - 1]++;             // eviction can have shortened the pool
    pool[at] = (SearchNear){n, 0};
}

// Stores a snapshot of the state that the run has just entered, if the state's table has room or the snapshot is better than one there.
static void store_entry(SearchRun *k, const Segment *seg)
{
    const FlatState *s = (const FlatState *)(const void *)k->now;
    const uint32_t at = find_place_of_entry(k, s->state, key_of(k, k->now), depth_after(k, seg), k->at);
    uint32_t n;

    if (at == SEARCH_NONE)
        return;
    n = add_node(k, seg);
    add_entry(k, n, at);
    drop_node(k, n);
}

// Whether a snapshot at this distance is worth having.
static bool is_wanted(const SearchGoal *g, double distance)
{
    double worst = 0;

    for (uint32_t i = 0; i < g->pooled; i++) {
        if (g->pool[i].distance == distance)
            return false;
        worst = g->pool[i].distance > worst ? g->pool[i].distance : worst;
    }
    return g->pooled < SEARCH_POOL || distance < worst;
}

// Adds node n, whose run came within `distance` of the goal, to the goal's pool.  A full pool drops its farthest node.
static void add_to_pool(SearchRun *k, uint32_t goal, uint32_t n, double distance)
{
    SearchGoal *g = &k->goal[goal];
    uint32_t at = 0;

    if (!is_wanted(g, distance))
        return;
    use_node(k, n);
    if (g->pooled < SEARCH_POOL) {
        at = g->pooled++;
    } else {
        at = find_farthest(g);
        drop_node(k, g->pool[at].node);
    }
    g->pool[at] = (SearchNear){n, distance};
    k->progress = k->r->steps;
}

// ---- goals ----

// Closes a goal: no further attempt searches for it.
static void close_goal(SearchRun *k, SearchGoal *g)
{
    g->done = true;
    k->open--;
    k->done_since++;
    for (uint32_t i = 0; i < g->pooled; i++)
        drop_node(k, g->pool[i].node);
    g->pooled = 0;
}

// Stores the node at which a goal was reached, in place of an earlier one, and closes the goal.
static void finish_goal(SearchRun *k, uint32_t goal, uint32_t node)
{
    SearchGoal *g = &k->goal[goal];
    const uint32_t before = g->found;

    g->found = node;
    k->node.at[node].followers++;         // so that it is not freed before search_choose replays it
    if (before != SEARCH_NONE) {
        k->node.at[before].followers--;
        free_unneeded(k, before);
    }
    close_goal(k, g);
}

bool search_reopen(SearchRun *k, uint32_t changes)
{
    bool any = false;

    for (uint32_t i = 0; i < k->goals; i++) {
        SearchGoal *g = &k->goal[i];
        if (!g->done || g->found == SEARCH_NONE || k->node.at[g->found].depth <= changes)
            continue;
        g->done = false;
        g->run_best = SEARCH_UNKNOWN;
        k->open++;
        any = true;
    }
    if (any)
        search_build_flat(k);
    return any;
}

void search_close_again(SearchRun *k)
{
    for (uint32_t i = 0; i < k->goals; i++)
        if (!k->goal[i].done && k->goal[i].found != SEARCH_NONE)
            close_goal(k, &k->goal[i]);
    search_build_flat(k);
}

// Whether the run has reached the goal: its counter is above 0, or the caller's distance for it is 0.
static bool is_reached(const SearchRun *k, const SearchGoal *g)
{
    return g->place < k->r->places ? k->running->hits[k->counter[g->place]] > 0 : k->o->watch && k->distance[g->place - k->r->places] == 0;
}

// Reserves the steps of the replay of the current run.  Returns false if too few are left: the search ends, without what it cannot replay.
static bool reserve_replay(SearchRun *k)
{
    if (k->r->steps + k->reserve + k->at > k->effort) {
        k->stop_at = k->r->steps;
        return false;
    }
    k->reserve += k->at;
    k->stop_at = k->effort - k->reserve < k->stop_at ? k->effort - k->reserve : k->stop_at;
    return true;
}

// Finishes the goals that the last step has reached.
static void finish_reached(SearchRun *k, const Segment *seg)
{
    uint32_t node = SEARCH_NONE;
    bool is_worse = false;                // a goal is reached again, and with no fewer changes than before

    for (uint32_t g = 0; g < k->goals; g++) {
        if (k->goal[g].done || !is_reached(k, &k->goal[g]))
            continue;
        if (k->goal[g].found != SEARCH_NONE && k->node.at[k->goal[g].found].depth <= depth_after(k, seg)) {
            is_worse = true;
            continue;
        }
        if (node == SEARCH_NONE && !reserve_replay(k))
            return;
        if (node == SEARCH_NONE)
            node = add_node(k, seg);
        finish_goal(k, g, node);
    }
    if (is_worse)
        flat_clear_counts(k->running);
    if (node == SEARCH_NONE)
        return;
    add_entry(k, node, find_place_of_entry(k, k->node.at[node].state, k->node.at[node].key, k->node.at[node].depth, k->at));
    drop_node(k, node);
}

// Lets the caller judge its own goals after this step (SearchOptions.watch).
static void judge_watch(SearchRun *k, bool is_rerun)
{
    const SearchWatch *w = k->o->watch;
    const uint64_t *cell = flat_cells(k->plain, k->now);

    for (uint32_t v = 0; v < k->p->var.n; v++)
        k->cell[v] = k->m->var_of[v] == IR_NONE ? k->p->var.at[v]->init : cell[k->m->var_of[v]];
    w->step(w->self, k->now + round_up(k->plain->size), k->cell, k->distance);
    for (uint32_t i = 0; i < w->goals && !is_rerun; i++) {
        const uint32_t g = k->goal_of[k->r->places + i];
        SearchGoal *goal = g == SEARCH_NONE ? NULL : &k->goal[g];
        if (!goal || goal->done || k->distance[i] >= SEARCH_UNKNOWN)
            continue;
        if (k->distance[i] == 0)
            k->running->fresh++;
        if (k->distance[i] < goal->best)
            goal->best = k->distance[i];
        if (k->distance[i] < goal->run_best) {
            goal->run_best = k->distance[i];
            goal->run_step = k->at;
            if (!goal->touched)
                vec_push(&k->work, &k->touched, g);
            goal->touched = true;
        }
    }
}

// ---- running ----

// Finds the inputs whose value has to be set before each step.
static void find_active(SearchRun *k)
{
    const SearchSetting *s = search_settings(k, k->now);

    k->active.n = 0;
    for (uint32_t i = 0; i < k->inputs; i++)
        if (s[i].set && (s[i].kind != SCENARIO_HOLD || k->input[i].forced))
            vec_push(&k->work, &k->active, i);
}

// Runs one step: sets the inputs that must be set in each step, and the time.
static void run_step(SearchRun *k, FlatMachine *f)
{
    for (uint32_t i = 0; i < k->active.n; i++)
        set_input(k, k->now, k->active.at[i], k->at + 1);
    flat_cells(f, k->now)[k->m->g] = k->at * k->delta_t;
    flat_step(f, k->now);
    k->at++;
    k->r->steps++;
    if (k->o->watch)
        judge_watch(k, f == k->plain);
}

// Loads the snapshot where a segment begins, and sets its changed inputs.
static void begin_run(SearchRun *k, const Segment *seg)
{
    search_load(k, seg->from, k->now);
    k->at = k->node.at[seg->from].at;
    search_apply(k, k->now, k->at, seg->turn, seg->turns);
    search_set_inputs(k, k->now, k->at + 1);
    find_active(k);
}

static int compare_touched(const SearchRun *k, uint32_t a, uint32_t b)
{
    const uint64_t x = k->goal[a].run_step, y = k->goal[b].run_step;

    return x < y ? -1 : x > y;
}

// Sorts the goals that came nearer in this run: the one that came nearest in the earliest step comes first.
static void sort_touched(SearchRun *k)
{
    for (uint32_t i = 1; i < k->touched.n; i++)
        for (uint32_t j = i; j > 0 && compare_touched(k, k->touched.at[j], k->touched.at[j - 1]) < 0; j--) {
            const uint32_t t = k->touched.at[j];
            k->touched.at[j] = k->touched.at[j - 1];
            k->touched.at[j - 1] = t;
        }
}

// Removes from `touched` the goals for which a snapshot of this segment would be no better than those of their pools.
static void select_touched(SearchRun *k)
{
    uint32_t kept = 0;

    for (uint32_t i = 0; i < k->touched.n; i++) {
        SearchGoal *g = &k->goal[k->touched.at[i]];
        g->touched = false;
        if (!g->done && is_wanted(g, g->run_best))
            k->touched.at[kept++] = k->touched.at[i];
        else
            g->run_best = SEARCH_UNKNOWN;
    }
    k->touched.n = kept;
    sort_touched(k);
}

// Stores a snapshot before each step that came near to a goal, by running the segment again.
static void store_near(SearchRun *k, const Segment *seg)
{
    uint32_t n = SEARCH_NONE;

    select_touched(k);
    if (k->touched.n == 0)
        return;
    begin_run(k, seg);
    for (uint32_t i = 0; i < k->touched.n; i++) {
        SearchGoal *g = &k->goal[k->touched.at[i]];
        if (n != SEARCH_NONE && k->at + 1 < g->run_step) {
            drop_node(k, n);
            n = SEARCH_NONE;
        }
        while (k->at + 1 < g->run_step && k->r->steps < k->stop_at)
            run_step(k, k->plain);
        if (n == SEARCH_NONE && k->at + 1 == g->run_step) {
            n = k->at == k->node.at[seg->from].at ? seg->from : add_node(k, seg);
            k->node.at[n].users += n == seg->from;
        }
        if (n != SEARCH_NONE && k->node.at[n].copy)
            add_to_pool(k, k->touched.at[i], n, g->run_best);
        g->run_best = SEARCH_UNKNOWN;
    }
    if (n != SEARCH_NONE)
        drop_node(k, n);
    k->touched.n = 0;
}

bool search_goes_on(SearchRun *k)
{
    if (k->r->steps >= k->next_report && !k->r->stopped) {
        const SearchProgress p = {k->goals, k->goals - k->open, k->open, k->r->steps, k->effort};
        k->r->stopped = k->o->go_on && !k->o->go_on(k->o->context, &p);
        k->next_report = k->r->steps + REPORT_STEPS;
    }
    return !k->r->stopped && k->r->steps < k->stop_at;
}

// Whether a step measures distances.  The first steps in a state and the last ones of a segment do; a long wait between them, for a timer or
// for a window to fill, runs on the machine without watched decisions, which still counts what is reached and sees transitions.
static bool is_measured(uint64_t since, uint64_t left) { return since < LEAP_AFTER || since % LEAP_EVERY == 0 || left < 2; }

// Runs the steps of a segment.
static void run_steps(SearchRun *k, const Segment *seg, uint64_t left, uint32_t goal, bool measures)
{
    const FlatState *s = (const FlatState *)(void *)k->now;
    const bool stays = seg->is_exact || search_chance(k, STAY_PERCENT);
    uint64_t since = 0;

    for (; left-- > 0 && k->r->steps < k->stop_at; since++) {
        FlatMachine *f = k->running = measures && is_measured(since, left) ? k->flat : k->quiet;
        const uint64_t fresh = f->fresh;
        run_step(k, f);
        if (f->fresh != fresh) {
            finish_reached(k, seg);
            if (goal != SEARCH_NONE && k->goal[goal].done)
                return;
        }
        if (f->moved) {
            k->visited[s->state - 1] = true;
            store_entry(k, seg);
            left = left > 256 && !stays && search_chance(k, 80) ? 256 : left;
            since = 0;
        }
        if (k->r->steps >= k->next_report && !search_goes_on(k))
            return;
    }
}

// Runs a segment, stores the snapshots that are worth it, and returns the node at its end (search_run_segment).
static uint32_t run_segment(SearchRun *k, const Segment *seg, uint64_t steps, uint32_t goal)
{
    uint32_t node;

    k->node.at[seg->from].users++;
    begin_run(k, seg);
    for (uint32_t d = 0; d < k->decisions; d++)
        k->decision[d].is_known = false;
    run_steps(k, seg, steps, goal, seg->is_exact || !(k->r->steps - k->progress > STALE_STEPS && search_chance(k, 85)));
    node = goal == SEARCH_NONE ? add_node(k, seg) : SEARCH_NONE;
    store_near(k, seg);
    drop_node(k, seg->from);
    if (k->done_since > k->open / 8)
        search_build_flat(k);
    return node;
}

uint32_t search_run_segment(SearchRun *k, uint32_t from, const SearchTurn *turn, uint32_t turns, uint64_t steps, uint32_t goal)
{
    const Segment seg = {from, turn, turns, false};

    return run_segment(k, &seg, steps, goal);
}

uint32_t search_run_exactly(SearchRun *k, uint32_t from, const SearchTurn *turn, uint32_t turns, uint64_t steps)
{
    const Segment seg = {from, turn, turns, true};

    return run_segment(k, &seg, steps, SEARCH_NONE);
}

void search_drop(SearchRun *k, uint32_t node) { drop_node(k, node); }

// ---- the first node ----

void search_start(const SearchRun *k, FlatMachine *f, char *block, uint32_t state)
{
    flat_start(f, block, state);
    for (uint32_t v = 0; v < k->p->var.n && k->o->initial; v++)
        if (k->p->var.at[v]->parameter && k->m->var_of[v] != IR_NONE)
            flat_cells(f, block)[k->m->var_of[v]] = k->o->initial[v];
}

void search_begin_nodes(SearchRun *k)
{
    const size_t machine = round_up(k->plain->size), situation = k->o->watch ? round_up(k->o->watch->size) : 0;
    const Segment seg = {SEARCH_NONE, NULL, 0, false};

    k->settings = machine + situation;
    k->block = k->settings + round_up((k->inputs + 1) * sizeof(SearchSetting));
    k->nominal = k->settings + (k->inputs + 1) * SETTING_BYTES;
    k->free_node = SEARCH_NONE;
    k->free_turn = arena_array(&k->work, k->inputs + 1, sizeof *k->free_turn);
    k->now = arena_alloc(&k->work, k->block);
    k->scratch = arena_alloc(&k->work, k->block);
    k->entry = arena_array(&k->work, k->p->state.n * SEARCH_ENTRIES, sizeof *k->entry);
    k->entries = ARENA_ARRAY(&k->work, uint32_t, k->p->state.n);
    k->visited = arena_alloc(&k->work, k->p->state.n);
    k->cell = ARENA_ARRAY(&k->work, uint64_t, k->p->var.n);
    k->distance = ARENA_ARRAY(&k->work, double, k->o->watch ? k->o->watch->goals : 1);
    search_start(k, k->plain, k->now, k->start->number);
    if (k->o->watch)
        k->o->watch->start(k->o->watch->self, k->now + machine);
    k->root = add_node(k, &seg);
    k->visited[k->start->number - 1] = true;
    add_entry(k, k->root, 0);                  // the use that add_node counted is never ended, so the root stays
}
