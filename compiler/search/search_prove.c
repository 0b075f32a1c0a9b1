// SPDX-License-Identifier: Apache-2.0
// Proves that goals are impossible, beyond what facts prove about single values (cover_find_impossible).
//
// 1. A state is unreachable if every transition to it from a reachable state is impossible.  All its places are then impossible.
// 2. The decisions on the path to a place, and its own conditions, compare values of one step.  Values that are compared with constants are
//    split into regions between these constants, and two values that are compared with each other into less, equal and greater.  If no
//    combination of regions takes the path, no step does.
//
// Both are sound: unknown values can be in any region, independently of each other.
#include <string.h>

#include "compiler/ir/eval.h"
#include "compiler/search/search_run.h"

enum { MOST_REGIONS = 40, MOST_GROUPS = 14 };
#define MOST_COMBINATIONS UINT32_C(400000)

// ---- values ----

// An expression over the values at the start of a function: equal numbers mean equal values.
typedef struct Value {
    IrOp op;
    SmType type;
    SmStat stat;
    uint32_t a, b, var;       // operands as values
    uint64_t bits;
} Value;

// A value that is compared with constants, or a pair of values that are compared with each other, and the regions in which the results of these
// comparisons stay the same.  All combinations of regions are enumerated.
typedef struct RegionGroup {
    uint32_t x, y;            // y SEARCH_NONE: x is compared with constants
    double constant[MOST_REGIONS];
    uint32_t constants;
    uint32_t region, regions; // index of the current region; number of regions
    double least, most;       // bounds of x
    bool whole, nan;          // x has only whole numbers; x can be NaN
} RegionGroup;

typedef struct Prover {
    SearchRun *k;
    uint32_t fn;
    VEC(Value) value;
    uint32_t *value_of;       // by IrRef
    RegionGroup group[MOST_GROUPS];
    uint32_t groups;
    bool fits;                // everything fits into the tables
} Prover;

static uint32_t add_value(Prover *p, Value v, bool is_unique)
{
    for (uint32_t i = 0; i < p->value.n && !is_unique; i++) {
        const Value *w = &p->value.at[i];
        if (w->op == v.op && w->type == v.type && w->stat == v.stat && w->a == v.a && w->b == v.b && w->var == v.var && w->bits == v.bits)
            return i;
    }
    vec_push(&p->k->work, &p->value, v);
    return p->value.n - 1;
}

// Numbers the values of a function.  A load that can follow a store to its variable has a number of its own.
static void number_values(Prover *p)
{
    const IrFn *f = p->k->fn[p->fn].fn;
    bool *stored = arena_alloc(&p->k->work, p->k->m->var.n);

    p->value.n = 0;
    p->value_of = ARENA_ARRAY(&p->k->work, uint32_t, f->ins.n + 1);
    for (uint32_t b = 0; b < f->blk.n; b++)
        for (uint32_t at = 0; at < f->blk.at[b].ins.n; at++) {
            const IrRef ref = f->blk.at[b].ins.at[at];
            const IrIns *i = &f->ins.at[ref];
            Value v = {i->op, i->type, i->stat, SEARCH_NONE, SEARCH_NONE, 0, i->op == IR_const ? i->bits : 0};
            if (i->op == IR_store)
                stored[i->var] = true;
            if (i->op == IR_load || i->op == IR_stat)
                v.var = i->var;
            if (i->a != IR_NONE && i->op != IR_load && i->op != IR_stat && i->op != IR_const)
                v.a = p->value_of[i->a];
            if (i->b != IR_NONE && i->op != IR_load && i->op != IR_stat && i->op != IR_const && i->op != IR_store && i->op != IR_sample)
                v.b = p->value_of[i->b];
            // A conversion to F64 changes no number.
            p->value_of[ref] = i->op == IR_cvt && (i->type == SM_F64 || i->type == f->ins.at[i->a].type)
                                   ? p->value_of[i->a] : add_value(p, v, i->op == IR_load && stored[i->var]);
        }
}

static bool constant_of(const Prover *p, uint32_t value, double *x)
{
    const Value *v = &p->value.at[value];

    if (v->op == IR_cvt)
        return v->type == SM_F64 && constant_of(p, v->a, x);
    if (v->op != IR_const)
        return false;
    *x = ir_number(v->type, v->bits);
    return true;
}

// ---- groups ----

static void set_limits(const Prover *p, RegionGroup *g)
{
    const Value *v = &p->value.at[g->x];
    const bool boolean = v->type == SM_BOOL;

    g->least = -1e308;
    g->most = 1e308;
    g->nan = v->op != IR_load && !boolean;
    if (boolean || (v->op == IR_load && ir_is_integer(v->type))) {
        const unsigned bits = 8u * sm_type_info[v->type].bytes;
        double size = 1;
        for (unsigned i = 0; i < bits; i++)
            size *= 2;
        g->whole = true;
        g->least = boolean || sm_type_info[v->type].kind == SM_KIND_UNSIGNED ? 0 : -size / 2;
        g->most = boolean ? 1 : sm_type_info[v->type].kind == SM_KIND_UNSIGNED ? size : size / 2;
    }
}

static RegionGroup *find_group(Prover *p, uint32_t x, uint32_t y)
{
    for (uint32_t i = 0; i < p->groups; i++)
        if (p->group[i].x == x && p->group[i].y == y)
            return &p->group[i];
    if (p->groups == MOST_GROUPS) {
        p->fits = false;
        return NULL;
    }
    p->group[p->groups] = (RegionGroup){.x = x, .y = y};
    set_limits(p, &p->group[p->groups]);
    return &p->group[p->groups++];
}

static void add_constant(Prover *p, uint32_t x, double c)
{
    RegionGroup *g = find_group(p, x, SEARCH_NONE);
    uint32_t at = 0;

    if (!g || !(c - c == 0))
        return;
    while (at < g->constants && g->constant[at] < c)
        at++;
    if (at < g->constants && g->constant[at] == c)
        return;
    if (2 * g->constants + 4 > MOST_REGIONS) {
        p->fits = false;
        return;
    }
    memmove(g->constant + at + 1, g->constant + at, (g->constants - at) * sizeof *g->constant);
    g->constant[at] = c;
    g->constants++;
}

// What a comparison, or any other truth, compares: a value with a constant, or two values.
typedef struct Leaf { IrOp op; uint32_t x, y; double c; bool swapped; } Leaf;

static Leaf leaf_of(const Prover *p, IrRef ref)
{
    const IrIns *i = &p->k->fn[p->fn].fn->ins.at[ref];
    Leaf l = {IR_ne, p->value_of[ref], SEARCH_NONE, 0, false};
    double c;

    if (ir_op_info[i->op].types != IR_T_COMPARE)
        return l;
    l.op = i->op;
    l.x = p->value_of[i->a];
    if (constant_of(p, p->value_of[i->b], &c)) {
        l.c = c;
    } else if (constant_of(p, l.x, &c)) {
        l.c = c;
        l.x = p->value_of[i->b];
        l.swapped = true;
    } else {
        l.y = p->value_of[i->b];
        if (l.y < l.x) {
            const uint32_t t = l.x;
            l.x = l.y;
            l.y = t;
            l.swapped = true;
        }
    }
    return l;
}

static void add_groups(Prover *p, IrRef ref)
{
    const IrIns *i = &p->k->fn[p->fn].fn->ins.at[ref];

    if (i->op == IR_and || i->op == IR_or || i->op == IR_not) {
        add_groups(p, i->a);
        if (i->op != IR_not)
            add_groups(p, i->b);
    } else if (i->op != IR_const) {
        const Leaf l = leaf_of(p, ref);
        if (l.y == SEARCH_NONE)
            add_constant(p, l.x, l.c);
        else
            find_group(p, l.x, l.y);
    }
}

// ---- regions ----

// Regions of constants c0 < c1: below c0, c0, between, c1, above, and NaN.  Of a pair: less, equal, greater, unordered.
static uint32_t count_regions(const RegionGroup *g) { return g->y == SEARCH_NONE ? 2 * g->constants + 1 + g->nan : 4; }

static bool is_whole(double x) { return x < -4e15 || x > 4e15 || x == (double)(int64_t)x; }

static bool is_empty(const RegionGroup *g)
{
    const uint32_t r = g->region, i = r / 2;
    double lo, hi;

    if (g->y != SEARCH_NONE || r > 2 * g->constants)
        return false;
    if (r % 2 == 1)
        return g->constant[i] < g->least || g->constant[i] > g->most || (g->whole && !is_whole(g->constant[i]));
    lo = i == 0 ? g->least - 1 : g->constant[i - 1];
    hi = i == g->constants ? g->most + 1 : g->constant[i];
    if (lo >= g->most || hi <= g->least)
        return true;
    return g->whole && lo > -4e15 && hi < 4e15 && is_whole(lo) && lo + 1 >= hi;
}

// Compares the current region with constant c: -1, 0, 1; 2: unordered.
static int compare_region(const RegionGroup *g, double c)
{
    uint32_t i = 0;

    if (g->region > 2 * g->constants)
        return 2;
    while (g->constant[i] != c)
        i++;
    return g->region < 2 * i + 1 ? -1 : g->region > 2 * i + 1;
}

static bool judge_order(IrOp op, int order)
{
    switch (op) {
    case IR_lt: return order == -1;
    case IR_le: return order == -1 || order == 0;
    case IR_gt: return order == 1;
    case IR_ge: return order == 1 || order == 0;
    case IR_eq: return order == 0;
    default: return order != 0;
    }
}

static bool truth_of(Prover *p, IrRef ref)
{
    const IrIns *i = &p->k->fn[p->fn].fn->ins.at[ref];
    Leaf l;
    RegionGroup *g;
    int order;

    switch (i->op) {
    case IR_and: return truth_of(p, i->a) && truth_of(p, i->b);
    case IR_or: return truth_of(p, i->a) || truth_of(p, i->b);
    case IR_not: return !truth_of(p, i->a);
    case IR_const: return ir_number(i->type, i->bits) != 0;
    default: break;
    }
    l = leaf_of(p, ref);
    g = find_group(p, l.x, l.y);
    if (l.y == SEARCH_NONE)
        order = compare_region(g, l.c);
    else
        order = (int)g->region == 3 ? 2 : (int)g->region - 1;
    if (ir_op_info[i->op].types != IR_T_COMPARE)
        return order != 0 && order != 2;          // NaN is false
    return judge_order(l.op, l.swapped && order != 2 ? -order : order);
}

// ---- sites ----

static bool node_truth(Prover *p, const FlatDecision *d, uint32_t n)
{
    const FlatNode *node = &d->node[n];

    switch (node->kind) {
    case NODE_CONDITION: return truth_of(p, d->condition[node->a]);
    case NODE_NOT: return !node_truth(p, d, node->a);
    case NODE_AND: return node_truth(p, d, node->a) && node_truth(p, d, node->b);
    default: return node_truth(p, d, node->a) || node_truth(p, d, node->b);
    }
}

// Whether a condition has the value and decides, in the current combination.
static bool condition_decides(Prover *p, const FlatDecision *d, uint32_t condition, bool value)
{
    uint32_t n = 0;

    while (d->node[n].kind != NODE_CONDITION || d->node[n].a != condition)
        n++;
    if (node_truth(p, d, n) != value)
        return false;
    for (uint32_t up = n + 1; up < d->nodes; up++) {
        const FlatNode *node = &d->node[up];
        const bool joins = node->kind == NODE_AND || node->kind == NODE_OR;
        if (node->kind == NODE_CONDITION || (node->a != n && !(joins && node->b == n)))
            continue;
        if (joins && node_truth(p, d, node->a == n ? node->b : node->a) != (node->kind == NODE_AND))
            return false;
        n = up;
    }
    return true;
}

static bool can_take_path(Prover *p, const SearchSite *site)
{
    for (uint32_t e = site->path.n; e-- > 0; ) {
        const FlatDecision *d = p->k->decision[site->path.elem[e].decision].d;
        if (!site->path.elem[e].is_certain)
            continue;
        if (e == 0 && site->condition != SEARCH_NONE ? !condition_decides(p, d, site->condition, site->value)
                                                     : node_truth(p, d, d->nodes - 1) != site->path.elem[e].value)
            return false;
    }
    return true;
}

static bool next_combination(Prover *p)
{
    for (uint32_t i = 0; i < p->groups; i++) {
        RegionGroup *g = &p->group[i];
        do
            g->region++;
        while (g->region < g->regions && is_empty(g));
        if (g->region < g->regions)
            return true;
        for (g->region = 0; g->region < g->regions && is_empty(g); )
            g->region++;
    }
    return false;
}

// Whether no step takes the path of a site.
static bool is_excluded(Prover *p, const SearchSite *site)
{
    double combinations = 1;

    if (site->path.n == 0)
        return false;
    if (p->k->decision[site->path.elem[0].decision].fn != p->fn || !p->value_of) {
        p->fn = p->k->decision[site->path.elem[0].decision].fn;
        number_values(p);
    }
    p->groups = 0;
    p->fits = true;
    for (uint32_t e = 0; e < site->path.n; e++) {
        const SearchDecision *d = &p->k->decision[site->path.elem[e].decision];
        if (d->fn != p->fn)
            return false;
        for (uint32_t c = 0; c < d->d->conditions; c++)
            add_groups(p, d->d->condition[c]);
    }
    for (uint32_t i = 0; i < p->groups; i++) {
        RegionGroup *g = &p->group[i];
        g->regions = count_regions(g);
        combinations *= g->regions;
        while (g->region < g->regions && is_empty(g))
            g->region++;
    }
    if (!p->fits || combinations > MOST_COMBINATIONS)
        return false;
    do
        if (can_take_path(p, site))
            return false;
    while (next_combination(p));
    return true;
}

// ---- states ----

static void find_reachable(const SearchRun *k, bool *reachable)
{
    reachable[k->start->number - 1] = true;
    for (bool again = true; again; ) {
        again = false;
        for (uint32_t i = 0; i < k->exit.n; i++) {
            const SearchExit *x = &k->exit.at[i];
            const uint32_t place = k->c->probes.transition[x->stmt];
            if (!reachable[x->from - 1] || reachable[x->to - 1] || (k->r->find[place].outcome == SEARCH_IMPOSSIBLE))
                continue;
            reachable[x->to - 1] = again = true;
        }
    }
}

// ---- goals ----

static void mark_impossible(SearchRun *k, SearchGoal *g, const char *reason)
{
    SearchFind *f = &k->r->find[g->place];

    f->outcome = SEARCH_IMPOSSIBLE;
    f->reason = reason;
    g->done = true;
    k->open--;
}

static void prove_paths(SearchRun *k)
{
    Prover *p = ARENA_NEW(&k->work, Prover);

    p->k = k;
    for (uint32_t i = 0; i < k->goals; i++) {
        SearchGoal *g = &k->goal[i];
        bool excluded = g->site.n > 0 && g->place < k->r->places && !g->done;
        for (uint32_t s = 0; s < g->site.n && excluded; s++)
            excluded = is_excluded(p, &g->site.at[s]);
        if (excluded && k->c->place.at[g->place].kind != COVER_STATE)
            mark_impossible(k, g, "the conditions before it and beside it exclude it");
    }
}

static void prove_states(SearchRun *k)
{
    bool *reachable = arena_alloc(&k->work, k->p->state.n);

    find_reachable(k, reachable);
    for (uint32_t i = 0; i < k->goals; i++) {
        SearchGoal *g = &k->goal[i];
        const CoverPlace *place = g->place < k->r->places ? &k->c->place.at[g->place] : NULL;
        bool excluded = place && g->site.n > 0 && !g->done;
        if (!place || g->done)
            continue;
        for (uint32_t s = 0; s < g->site.n && excluded; s++)
            excluded = g->site.at[s].state != 0 && !reachable[g->site.at[s].state - 1];
        if (excluded || (place->kind == COVER_STATE && !reachable[place->from->number - 1]))
            mark_impossible(k, g, "no run enters its state");
    }
}

void search_prove(SearchRun *k)
{
    prove_paths(k);
    prove_states(k);
}
