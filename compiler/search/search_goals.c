// SPDX-License-Identifier: Apache-2.0
// Goals, and how far each step is from reaching them.  The distance of a step is the number of decisions on the path to the goal that do not have
// the wanted outcome yet, plus a fraction for the first one of these: how far its operands are from that outcome.
#include <string.h>

#include "compiler/search/search_run.h"
#include "stdlib/f64.h"

// ---- sites ----

static void add_site(SearchRun *k, SearchGoal *g, SearchSite s) { vec_push(&k->work, &g->site, s); }

// Finds the counter of each place (Cover.single, Cover.shared).
static void find_counters(SearchRun *k)
{
    const Cover *c = k->c;

    k->is_open = arena_alloc(&k->work, k->r->finds);
    k->counter = ARENA_ARRAY(&k->work, uint32_t, k->r->finds);
    for (uint32_t i = 0; i < k->r->finds; i++)
        k->counter[i] = i;
    for (uint32_t i = 0; i < c->single.n; i++)
        for (uint32_t n = 0; n < 2; n++)
            k->counter[c->single.at[i] + 2 + n] = c->single.at[i] + n;
    for (uint32_t i = 0; i < c->shared.n; i++)
        for (uint32_t n = 0; n < c->shared.at[i].n; n++)
            k->counter[c->shared.at[i].to + n] = k->counter[c->shared.at[i].from + n];
}

// Gives a goal also the states and paths of another goal that is counted together with it.
static void share_sites(SearchRun *k)
{
    for (uint32_t i = 0; i < k->c->shared.n; i++)
        for (uint32_t n = 0; n < k->c->shared.at[i].n; n++) {
            const uint32_t from = k->goal_of[k->c->shared.at[i].from + n], to = k->goal_of[k->c->shared.at[i].to + n];
            const uint32_t sites = from == SEARCH_NONE || to == SEARCH_NONE || from == to ? 0 : k->goal[from].site.n;
            for (uint32_t s = 0; s < sites; s++)
                add_site(k, &k->goal[to], k->goal[from].site.at[s]);
        }
}

// Returns the path of the outcome of a decision.
static SearchPath path_to_outcome(SearchRun *k, uint32_t decision, bool value)
{
    const SearchPath outer = k->decision[decision].path;
    SearchElem *elem = arena_array(&k->work, outer.n + 1, sizeof *elem);

    elem[0] = (SearchElem){decision, value, true};
    for (uint32_t i = 0; i < outer.n; i++)
        elem[i + 1] = outer.elem[i];
    return (SearchPath){elem, outer.n + 1};
}

// Adds the path to a decision to the goals of its outcomes and of its conditions.
static void add_decision_sites(SearchRun *k, uint32_t n)
{
    const FlatDecision *d = k->decision[n].d;
    const uint32_t state = k->decision[n].state;

    for (uint32_t at = d->hit; at < d->hit + 2 + 2 * d->conditions; at++) {
        const uint32_t g = k->goal_of[at];
        const bool value = (at - d->hit) % 2 == 0;
        const uint32_t condition = at < d->hit + 2 || d->nodes == 1 ? SEARCH_NONE : (at - d->hit - 2) / 2;
        if (g != SEARCH_NONE)
            add_site(k, &k->goal[g], (SearchSite){state, path_to_outcome(k, n, value), condition, value});
    }
    for (uint32_t w = 0; w < d->fulls; w++)
        for (int v = 0; v < 2; v++) {
            const uint32_t g = k->goal_of[d->full[w].hit];
            if (g == SEARCH_NONE)
                continue;
            add_site(k, &k->goal[g], (SearchSite){state, path_to_outcome(k, n, v), d->conditions == 1 ? SEARCH_NONE : d->full[w].condition, v});
            k->goal[g].fill = k->m->window.at[d->full[w].window].size;
        }
}

// Adds the path to each statement of the list, and to each of its transitions, to their goals.
static void add_statement_sites(SearchRun *k, const Stmts *list, uint32_t state)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        const uint32_t place[2] = {k->c->probes.stmt[s->number], k->c->probes.transition[s->number]};
        for (int j = 0; j < 2; j++)
            if (place[j] && k->goal_of[place[j]] != SEARCH_NONE)
                add_site(k, &k->goal[k->goal_of[place[j]]], (SearchSite){state, k->path[s->number], SEARCH_NONE, true});
        for (const FlatFull *f = k->c->probes.full[s->number]; f && f->hit; f++)
            if (k->goal_of[f->hit] != SEARCH_NONE) {
                add_site(k, &k->goal[k->goal_of[f->hit]], (SearchSite){state, k->path[s->number], SEARCH_NONE, true});
                k->goal[k->goal_of[f->hit]].fill = k->m->window.at[f->window].size;
            }
        add_statement_sites(k, &s->then, state);
        add_statement_sites(k, &s->otherwise, state);
    }
}

// Adds the transitions into and out of each state to the goals of entering and leaving it.
static void add_state_sites(SearchRun *k)
{
    for (uint32_t i = 0; i < k->exit.n; i++) {
        const SearchExit *x = &k->exit.at[i];
        const uint32_t entered = k->c->probes.entry[x->to - 1], left = k->c->probes.exit[x->from - 1];
        if (entered && k->goal_of[entered] != SEARCH_NONE)
            add_site(k, &k->goal[k->goal_of[entered]], (SearchSite){x->from, x->path, SEARCH_NONE, true});
        if (left && k->goal_of[left] != SEARCH_NONE)
            add_site(k, &k->goal[k->goal_of[left]], (SearchSite){x->from, x->path, SEARCH_NONE, true});
    }
}

// Links each decision on the goal's paths to the goal, so that a change of the decision's distance is noted for it.
static void add_edges(SearchRun *k, uint32_t goal)
{
    for (uint32_t s = 0; s < k->goal[goal].site.n; s++) {
        const SearchSite *site = &k->goal[goal].site.at[s];
        for (uint32_t e = 0; e < site->path.n; e++) {
            const SearchEdge edge = {goal, e, e == 0 ? site->condition : SEARCH_NONE,
                                     e == 0 && site->condition != SEARCH_NONE ? site->value : site->path.elem[e].value};
            vec_push(&k->work, &k->decision[site->path.elem[e].decision].edge, edge);
        }
    }
}

void search_make_goals(SearchRun *k)
{
    const SearchResult *r = k->r;
    uint32_t nodes = 1;

    k->goal = arena_array(&k->work, r->finds, sizeof *k->goal);
    k->goal_of = ARENA_ARRAY(&k->work, uint32_t, r->finds);
    memset(k->goal_of, 0xff, r->finds * sizeof *k->goal_of);
    for (uint32_t i = 1; i < r->finds; i++)
        if (r->find[i].outcome == SEARCH_NOT_FOUND) {
            k->goal[k->goals] = (SearchGoal){.place = i, .best = SEARCH_UNKNOWN, .found = SEARCH_NONE, .run_best = SEARCH_UNKNOWN};
            k->goal_of[i] = k->goals++;
        }
    k->open = k->goals;
    find_counters(k);
    for (uint32_t d = 0; d < k->decisions; d++) {
        add_decision_sites(k, d);
        nodes = k->decision[d].d->nodes > nodes ? k->decision[d].d->nodes : nodes;
    }
    for (size_t s = 0; s < k->p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            add_statement_sites(k, &k->p->state.at[s]->block[b], k->p->state.at[s]->number);
    add_state_sites(k);
    share_sites(k);
    for (uint32_t g = 0; g < k->goals; g++)
        add_edges(k, g);
    for (int v = 0; v < 2; v++)
        k->cost[v] = ARENA_ARRAY(&k->work, double, nodes);
}

// ---- distances ----

// Returns the binary logarithm of 1 + |difference|, linear between powers of two and scaled to below 1: the same bits on every computer.
double search_near(double difference)
{
    const double x = difference < 0 ? 1 - difference : 1 + difference;
    uint64_t bits;

    if (!(x >= 1) || x > 1e300)
        return 0.999;
    memcpy(&bits, &x, sizeof bits);
    return ((double)(bits >> 52) - 1023 + (double)(bits & 0xfffffffffffffu) / 4503599627370496.0) / 1100;
}

// Sets out[0] and out[1] to the distance of a bool from being false and from being true, by the values of the last step.
static void find_costs_of_truth(const double *frame, const IrFn *f, const uint32_t *slot, IrRef ref, double out[2])
{
    const IrIns *i = &f->ins.at[ref];
    double a[2], b[2];
    const bool value = frame[slot[ref]] != 0;

    switch (i->op) {
    case IR_not:
        find_costs_of_truth(frame, f, slot, i->a, a);
        out[0] = a[1];
        out[1] = a[0];
        return;
    case IR_and:
    case IR_or:
        find_costs_of_truth(frame, f, slot, i->a, a);
        find_costs_of_truth(frame, f, slot, i->b, b);
        out[i->op == IR_and] = a[i->op == IR_and] + b[i->op == IR_and];
        out[i->op != IR_and] = a[i->op != IR_and] < b[i->op != IR_and] ? a[i->op != IR_and] : b[i->op != IR_and];
        return;
    default: break;
    }
    out[value] = 0;
    out[!value] = 0.5;
    if (ir_op_info[i->op].types == IR_T_COMPARE)
        out[!value] = 0.0001 + search_near(frame[slot[i->a]] - frame[slot[i->b]]);
    else if (f->ins.at[ref].type != SM_BOOL)
        out[!value] = 0.0001 + search_near(frame[slot[ref]]);
}

// Computes for each node of a decision how far it is from being false and from being true.
static void find_costs(SearchRun *k, const SearchDecision *x)
{
    const FlatDecision *d = x->d;
    const uint32_t *slot = k->plain->fn[x->fn].slot;

    for (uint32_t n = 0; n < d->nodes; n++) {
        const FlatNode *node = &d->node[n];
        double out[2];
        const bool all = node->kind == NODE_AND;          // the value that the node has only if both operands have it
        switch (node->kind) {
        case NODE_CONDITION: find_costs_of_truth(k->flat->frame, d->fn, slot, d->condition[node->a], out); break;
        case NODE_NOT:
            out[0] = k->cost[1][node->a];
            out[1] = k->cost[0][node->a];
            break;
        default:
            out[all] = k->cost[all][node->a] + k->cost[all][node->b];
            out[!all] = k->cost[!all][node->a] < k->cost[!all][node->b] ? k->cost[!all][node->a] : k->cost[!all][node->b];
            break;
        }
        k->cost[0][n] = out[0];
        k->cost[1][n] = out[1];
    }
}

// Returns how far a condition is from deciding with `value`: the distance of its own value, plus those of the other operands of the enclosing
// `and` and `or`, which must not decide.
static double find_cost_of_condition(const SearchRun *k, const FlatDecision *d, uint32_t condition, bool value)
{
    uint32_t n = 0;
    double sum;

    while (d->node[n].kind != NODE_CONDITION || d->node[n].a != condition)
        n++;
    sum = k->cost[value][n];
    for (uint32_t up = n + 1; up < d->nodes; up++) {
        const FlatNode *node = &d->node[up];
        const bool is_operator = node->kind == NODE_AND || node->kind == NODE_OR;
        if (node->kind == NODE_CONDITION || (node->a != n && !(is_operator && node->b == n)))
            continue;
        if (is_operator)
            sum += k->cost[node->kind == NODE_AND][node->a == n ? node->b : node->a];
        n = up;
    }
    return sum;
}

// Whether a number on which the decision's distance depends has changed since the distance was last computed; remembers the numbers.
static bool operands_changed(const SearchRun *k, SearchDecision *x)
{
    bool changed = !x->is_known;

    for (uint32_t i = 0; i < x->operands; i++) {
        const double now = k->flat->frame[x->operand[i]];
        changed |= now != x->last[i];
        x->last[i] = now;
    }
    x->is_known = true;
    return changed;
}

// Notes that the current run came this near to a goal, if it is the smallest distance of the run.
static void note_distance(SearchRun *k, uint32_t g, double distance)
{
    SearchGoal *goal = &k->goal[g];

    if (distance >= goal->run_best)
        return;
    goal->run_best = distance;
    goal->run_step = k->at + 1;
    if (!goal->touched) {
        goal->touched = true;
        vec_push(&k->work, &k->touched, g);
    }
}

// Called for each watched decision that a step makes: computes its distances, and notes them for the goals whose paths contain it.
static void measure_goals(void *watcher, uint32_t kept)
{
    SearchRun *k = watcher;
    SearchDecision *x = &k->decision[k->kept[kept]];
    const uint32_t root = x->d->nodes - 1;

    if (!operands_changed(k, x))
        return;
    find_costs(k, x);
    for (uint32_t i = 0; i < x->edge.n; i++) {
        const SearchEdge *e = &x->edge.at[i];
        double cost;
        if (k->goal[e->goal].done)
            continue;
        cost = e->condition == SEARCH_NONE ? k->cost[e->value][root] : find_cost_of_condition(k, x->d, e->condition, e->value);
        if (cost == 0 && e->level > 0)
            continue;
        note_distance(k, e->goal, e->level + cost / (1 + cost));
        if (k->goal[e->goal].run_best < k->goal[e->goal].best) {
            k->goal[e->goal].best = k->goal[e->goal].run_best;
            k->goal[e->goal].best_elem = (SearchElem){k->kept[kept], e->value, true};
            k->goal[e->goal].best_condition = e->condition;
        }
    }
}

// ---- the machine with probes ----

static uint32_t open_counter(const SearchRun *k, uint32_t place) { return place && k->is_open[place] ? place : 0; }

static const uint32_t *open_counters(SearchRun *k, Arena *arena, const uint32_t *place, uint32_t n)
{
    uint32_t *out = ARENA_ARRAY(arena, uint32_t, n);

    for (uint32_t i = 0; i < n; i++)
        out[i] = open_counter(k, place[i]);
    return out;
}

// Whether an open goal needs a counter of the decision.  The callers then have all its outcomes counted.
static bool is_open(const SearchRun *k, const FlatDecision *d)
{
    for (uint32_t i = 0; i < 2 + 2 * d->conditions; i++)
        if (open_counter(k, d->hit + i))
            return true;
    for (uint32_t w = 0; w < d->fulls; w++)
        if (open_counter(k, d->full[w].hit))
            return true;
    return false;
}

// Removes the edges of goals that are done.  Returns whether some are left.
static bool remove_done_edges(const SearchRun *k, SearchDecision *x)
{
    uint32_t n = 0;

    for (uint32_t i = 0; i < x->edge.n; i++)
        if (!k->goal[x->edge.at[i].goal].done)
            x->edge.at[n++] = x->edge.at[i];
    x->edge.n = n;
    return n > 0;
}

// Adds the probes of what is open, outside decisions.
static FlatProbes *add_open_probes(SearchRun *k, Arena *arena)
{
    const uint32_t stmts = k->p->stmts + 1, states = k->p->state.n;
    FlatProbes *p = ARENA_NEW(arena, FlatProbes);
    const FlatFull **full = arena_array(arena, stmts, sizeof *full);

    for (uint32_t s = 0; s < stmts; s++)
        for (const FlatFull *f = k->c->probes.full[s]; f && f->hit; f++)
            if (open_counter(k, f->hit))
                full[s] = k->c->probes.full[s];
    p->stmt = open_counters(k, arena, k->c->probes.stmt, stmts);
    p->transition = open_counters(k, arena, k->c->probes.transition, stmts);
    p->entry = open_counters(k, arena, k->c->probes.entry, states);
    p->exit = open_counters(k, arena, k->c->probes.exit, states);
    p->full = full;
    p->counters = k->c->probes.counters;
    return p;
}

FlatMachine *search_new_flat(SearchRun *k, Arena *arena)
{
    FlatProbes *p = add_open_probes(k, arena);
    FlatDecision *kept = arena_array(arena, k->decisions + 1, sizeof *kept);

    p->decision = kept;
    for (uint32_t d = 0; d < k->decisions; d++)
        if (is_open(k, k->decision[d].d))
            kept[p->decisions++] = *k->decision[d].d;
    return search_flat(k, arena, p);
}

void search_build_flat(SearchRun *k)
{
    FlatProbes *p, *quiet;
    FlatDecision *kept;
    bool *watched;

    memset(k->is_open, 0, k->r->finds);
    for (uint32_t g = 0; g < k->goals; g++)
        if (!k->goal[g].done)
            k->is_open[k->counter[k->goal[g].place]] = true;
    arena_reset(&k->flats);
    p = add_open_probes(k, &k->flats);
    kept = arena_array(&k->flats, k->decisions + 1, sizeof *kept);
    watched = arena_alloc(&k->flats, k->decisions + 1);
    k->kept = ARENA_ARRAY(&k->flats, uint32_t, k->decisions + 1);
    for (uint32_t d = 0; d < k->decisions; d++) {
        const bool edge = remove_done_edges(k, &k->decision[d]);
        if (!edge && !is_open(k, k->decision[d].d))
            continue;
        k->kept[p->decisions] = d;
        watched[p->decisions] = edge;
        kept[p->decisions++] = *k->decision[d].d;
        k->decision[d].is_known = false;
    }
    p->decision = kept;
    p->watched = watched;
    k->flat = search_flat(k, &k->flats, p);
    k->flat->watch = measure_goals;
    k->flat->watcher = k;
    quiet = ARENA_NEW(&k->flats, FlatProbes);
    *quiet = *p;
    quiet->watched = NULL;
    k->quiet = search_flat(k, &k->flats, quiet);
    k->running = k->flat;
    k->done_since = 0;
}
