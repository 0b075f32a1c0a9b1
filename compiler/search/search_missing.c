// SPDX-License-Identifier: Apache-2.0
// Describes the goals that were not found: which condition blocked each, and by how much it missed.
//
// The nearest snapshot of a goal precedes the step with its smallest distance.  One step is run on a copy of it, and the first condition that
// then has the wrong value, in the decision that was not passed, is what blocked it.
#include "compiler/ir/eval.h"
#include "compiler/search/search_run.h"

// Returns a condition that keeps node n from having a value, which that condition would need to have in *wanted.
static uint32_t find_culprit(const SearchRun *k, const SearchDecision *x, uint32_t n, bool value, bool *wanted)
{
    const FlatNode *node = &x->d->node[n];

    if (node->kind == NODE_CONDITION) {
        *wanted = value;
        return node->a;
    }
    if (node->kind == NODE_NOT)
        return find_culprit(k, x, node->a, !value, wanted);
    return find_culprit(k, x, search_node_value(k, x, node->a) != value ? node->a : node->b, value, wanted);
}

// Returns by how much the numbers of a comparison must change for the other outcome; SEARCH_UNKNOWN: `ref` is no comparison of numbers.
static double find_miss(const SearchRun *k, uint32_t fn, IrRef ref)
{
    const IrFn *f = k->fn[fn].fn;
    double difference;

    while (f->ins.at[ref].op == IR_not || f->ins.at[ref].op == IR_cvt)
        ref = f->ins.at[ref].a;
    if (ir_op_info[f->ins.at[ref].op].types != IR_T_COMPARE)
        return SEARCH_UNKNOWN;
    difference = search_value_of(k, fn, f->ins.at[ref].a) - search_value_of(k, fn, f->ins.at[ref].b);
    return difference - difference != 0 ? SEARCH_UNKNOWN : difference < 0 ? -difference : difference;
}

// Runs the step after the nearest snapshot of a goal.  Returns false if the goal has no snapshot.
static bool run_nearest(SearchRun *k, const SearchGoal *g)
{
    uint32_t best = 0;

    if (g->pooled == 0 || k->r->steps >= k->effort)
        return false;
    for (uint32_t i = 1; i < g->pooled; i++)
        best = g->pool[i].distance < g->pool[best].distance ? i : best;
    search_load(k, g->pool[best].node, k->scratch);
    search_set_inputs(k, k->scratch, k->node.at[g->pool[best].node].at + 1);
    flat_step(k->plain, k->scratch);
    k->r->steps++;
    return true;
}

// Whether some run has reached this place: a condition, say, that was true.
static bool had_ever_value(const SearchRun *k, uint32_t place)
{
    const uint32_t g = k->goal_of[place];

    return g == SEARCH_NONE ? k->r->find[place].outcome != SEARCH_IMPOSSIBLE : k->goal[g].done;
}

// Stores which condition kept the search from a goal, whether it never had the needed value, and by how much it missed.
static void set_blocking_place(const SearchRun *k, SearchFind *f, uint32_t place, double missed_by)
{
    f->blocked_by = place;
    f->is_never = !had_ever_value(k, place);
    f->missed_by = missed_by;
}

// Returns the node next to n in its decision that keeps it from deciding, and the value that it would need; SEARCH_NONE: none.
static uint32_t find_masking(const SearchRun *k, const SearchDecision *x, uint32_t n, bool *needed)
{
    for (uint32_t up = n + 1; up < x->d->nodes; up++) {
        const FlatNode *node = &x->d->node[up];
        const bool joins = node->kind == NODE_AND || node->kind == NODE_OR;
        const uint32_t other = joins && node->a == n ? node->b : node->a;
        if (node->kind == NODE_CONDITION || (node->a != n && !(joins && node->b == n)))
            continue;
        *needed = node->kind == NODE_AND;
        if (joins && search_node_value(k, x, other) != *needed)
            return other;
        n = up;
    }
    return SEARCH_NONE;
}

static void describe_culprit(SearchRun *k, SearchFind *f, const SearchDecision *x, uint32_t n, bool value)
{
    bool wanted = value;
    const uint32_t c = find_culprit(k, x, n, value, &wanted);

    set_blocking_place(k, f, x->d->nodes == 1 ? x->d->hit + !wanted : x->d->hit + 2 + 2 * c + !wanted, find_miss(k, x->fn, x->d->condition[c]));
}

// Describes a goal whose condition has to decide with a value.
static void describe_condition(SearchRun *k, const SearchGoal *g, SearchFind *f, const SearchDecision *x)
{
    uint32_t n = 0, masking;
    bool needed = false;

    while (x->d->node[n].kind != NODE_CONDITION || x->d->node[n].a != g->best_condition)
        n++;
    masking = find_masking(k, x, n, &needed);
    if (search_node_value(k, x, n) != g->best_elem.value || masking == SEARCH_NONE)
        describe_culprit(k, f, x, n, g->best_elem.value);
    else
        describe_culprit(k, f, x, masking, needed);
}

// Describes a goal by a decision that never had the outcome that it needs, or not together with the rest.
static void describe_decision(SearchRun *k, const SearchGoal *g, SearchFind *f)
{
    const SearchDecision *x = &k->decision[g->best_elem.decision];
    const uint32_t root = x->d->nodes - 1;

    set_blocking_place(k, f, g->best_condition == SEARCH_NONE ? x->d->hit + !g->best_elem.value : g->place, SEARCH_UNKNOWN);
    if (!run_nearest(k, g))
        return;
    if (g->best_condition != SEARCH_NONE)
        describe_condition(k, g, f, x);
    else if (search_node_value(k, x, root) != g->best_elem.value)
        describe_culprit(k, f, x, root, g->best_elem.value);
}

// Returns the nearest goal among the transitions that lead from visited states towards a state that no run was in; SEARCH_NONE: none.
static uint32_t find_frontier(SearchRun *k, uint32_t state)
{
    bool *seen = arena_alloc(&k->work, k->p->state.n + 1);
    uint32_t best = SEARCH_NONE;

    seen[state] = true;
    for (bool again = true; again && best == SEARCH_NONE; ) {
        again = false;
        for (uint32_t i = 0; i < k->exit.n; i++) {
            const SearchExit *x = &k->exit.at[i];
            const uint32_t place = k->c->probes.transition[x->stmt], g = place ? k->goal_of[place] : SEARCH_NONE;
            if (!seen[x->to])
                continue;
            if (!k->visited[x->from - 1]) {
                again |= !seen[x->from];
                seen[x->from] = true;
            } else if (g != SEARCH_NONE && !k->goal[g].done && (best == SEARCH_NONE || k->goal[g].best < k->goal[best].best)) {
                best = g;
            }
        }
    }
    return best;
}

// Describes how near the search came to a goal that it did not find, and what was missing.
static void describe_goal(SearchRun *k, uint32_t goal)
{
    const SearchGoal *g = &k->goal[goal];
    SearchFind *f = &k->r->find[g->place];
    const SearchGoal *from = g;

    f->nearest = g->best >= SEARCH_UNKNOWN ? SEARCH_UNKNOWN : g->best / (1 + g->best);
    for (uint32_t s = 0; s < g->site.n; s++)
        f->is_state_reached |= g->site.at[s].state == 0 || k->visited[g->site.at[s].state - 1];
    if (g->place >= k->r->places)
        return;
    if (!f->is_state_reached && g->site.n) {
        const uint32_t frontier = find_frontier(k, g->site.at[0].state);
        from = frontier == SEARCH_NONE ? g : &k->goal[frontier];
    }
    if (from->best < SEARCH_UNKNOWN)
        describe_decision(k, from, f);
    else
        set_blocking_place(k, f, from->place, SEARCH_UNKNOWN);
}

void search_describe_missing(SearchRun *k)
{
    for (uint32_t g = 0; g < k->goals; g++)
        if (k->r->find[k->goal[g].place].outcome == SEARCH_NOT_FOUND)
            describe_goal(k, g);
}
