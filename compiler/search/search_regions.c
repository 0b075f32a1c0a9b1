// SPDX-License-Identifier: Apache-2.0
// Splits values into regions between the constants that they are compared with, and two values that are compared with each other into less,
// equal and greater.  Unknown values can be in any region, independently of each other.
#include <string.h>

#include "compiler/ir/eval.h"
#include "compiler/search/search_regions.h"

#define INFINITE (1e308 * 10)

// ---- values ----

// Returns the number of this value: that of an equal value, or a new number if no equal value has one, or `is_unique`.
static uint32_t add_value(Prover *p, Value v, bool is_unique)
{
    for (uint32_t i = 0; i < p->value.n && !is_unique; i++) {
        const Value *w = &p->value.at[i];
        if (w->op == v.op && w->type == v.type && (v.op != IR_stat || w->stat == v.stat) && w->a == v.a && w->b == v.b &&
            w->var == v.var && w->bits == v.bits)
            return i;
    }
    vec_push(&p->k->work, &p->value, v);
    return p->value.n - 1;
}

// Marks the variables that functions before `fn` in the same step store.
static void mark_stored_before(const Prover *p, bool *stored)
{
    const SearchRun *k = p->k;
    const uint32_t state = k->fn[p->fn].state;

    for (int b = 0; state != 0 && b < BLOCK_COUNT; b++) {
        const IrFn *f = k->m->state.at[state - 1].block[b];
        if (f == p->own.fn)
            return;
        for (uint32_t i = 0; f && i < f->ins.n; i++)
            if (f->ins.at[i].op == IR_store)
                stored[f->ins.at[i].var] = true;
    }
}

static bool has_operands(const IrIns *i) { return i->op != IR_load && i->op != IR_stat && i->op != IR_const; }

// Numbers the values of a function that begins when the variables of `before` can have been stored.  A load that can follow a store to its
// variable has a number of its own, and so has a statistic of a window before it has its sample.
static void number_function(Prover *p, RegionView *v, const bool *before, bool samples)
{
    bool *stored = arena_alloc(&p->k->work, p->k->m->var.n), *sampled = arena_alloc(&p->k->work, p->k->m->window.n + 1);

    v->value_of = ARENA_ARRAY(&p->k->work, uint32_t, v->fn->ins.n + 1);
    for (uint32_t b = 0; b < v->fn->blk.n; b++)
        for (uint32_t at = 0; at < v->fn->blk.at[b].ins.n; at++) {
            const IrRef ref = v->fn->blk.at[b].ins.at[at];
            const IrIns *i = &v->fn->ins.at[ref];
            Value x = {i->op, i->type, i->stat, SEARCH_NONE, SEARCH_NONE, 0, i->op == IR_const ? i->bits : 0};
            bool is_unique = i->op == IR_stat && samples && !sampled[i->var];
            if (i->op == IR_store)
                stored[i->var] = true;
            if (i->op == IR_sample)
                sampled[i->var] = true;
            if (i->op == IR_load || i->op == IR_stat)
                x.var = i->var;
            if (i->op == IR_load) {
                x.a = before[i->var] ? 0 : SEARCH_NONE;
                is_unique = stored[i->var];
            }
            if (i->a != IR_NONE && has_operands(i))
                x.a = v->value_of[i->a];
            if (i->b != IR_NONE && has_operands(i) && i->op != IR_store && i->op != IR_sample)
                x.b = v->value_of[i->b];
            // A conversion to F64 keeps the number, so it has the same value number as its operand.
            v->value_of[ref] = i->op == IR_cvt && (i->type == SM_F64 || i->type == v->fn->ins.at[i->a].type) ? v->value_of[i->a] : add_value(p, x, is_unique);
        }
}

// Gives temporaries with equal values equal numbers (value numbering), in the function and in the samples of its windows.
void region_number_values(Prover *p, uint32_t fn)
{
    bool *before = arena_alloc(&p->k->work, p->k->m->var.n);

    p->fn = fn;
    p->value.n = 0;
    p->own.fn = p->k->fn[fn].fn;
    p->sample.fn = p->k->m->sample;
    if (p->sample.fn)
        number_function(p, &p->sample, before, true);
    if (p->own.fn == p->sample.fn) {
        p->own = p->sample;
        return;
    }
    mark_stored_before(p, before);
    number_function(p, &p->own, before, false);
}

// Whether the value is a constant; sets *x.  A constant that is converted to F64 has no value of its own (number_function).
static bool constant_of(const Prover *p, uint32_t value, double *x)
{
    const Value *v = &p->value.at[value];

    if (v->op != IR_const)
        return false;
    *x = ir_number(v->type, v->bits);
    return true;
}

// ---- groups ----

// Sets the smallest and largest number that the group's value can be, and whether it can be NaN.
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

// NULL: there is no room for a new group; then p->fits is false.
static RegionGroup *find_or_add_group(Prover *p, uint32_t x, uint32_t y)
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

RegionGroup *region_group_of(Prover *p, uint32_t value) { return find_or_add_group(p, value, SEARCH_NONE); }

// Adds a constant with which value x is compared: it splits the numbers into one more region.
static void add_constant(Prover *p, uint32_t x, double c)
{
    RegionGroup *g = find_or_add_group(p, x, SEARCH_NONE);
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
// `x op y`, or with y SEARCH_NONE `x op c`; swapped: the operands are in the other order.
typedef struct Leaf { IrOp op; uint32_t x, y; double c; bool swapped; } Leaf;

// Returns a condition as a comparison of two values, or of a value with a constant.
static Leaf leaf_of(const Prover *p, const RegionView *v, IrRef ref)
{
    const IrIns *i = &v->fn->ins.at[ref];
    Leaf l = {IR_ne, v->value_of[ref], SEARCH_NONE, 0, false};
    double c;

    if (ir_op_info[i->op].types != IR_T_COMPARE) {
        while (v->fn->ins.at[ref].op == IR_cvt && v->fn->ins.at[ref].type == SM_BOOL)        // true if the number is not 0
            ref = v->fn->ins.at[ref].a;
        l.x = v->value_of[ref];
        return l;
    }
    l.op = i->op;
    l.x = v->value_of[i->a];
    if (constant_of(p, v->value_of[i->b], &c)) {
        l.c = c;
    } else if (constant_of(p, l.x, &c)) {
        l.c = c;
        l.x = v->value_of[i->b];
        l.swapped = true;
    } else {
        l.y = v->value_of[i->b];
        if (l.y < l.x) {
            const uint32_t t = l.x;
            l.x = l.y;
            l.y = t;
            l.swapped = true;
        }
    }
    return l;
}

void region_add_condition(Prover *p, const RegionView *v, IrRef ref)
{
    const IrIns *i = &v->fn->ins.at[ref];

    if (i->op == IR_and || i->op == IR_or || i->op == IR_not) {
        region_add_condition(p, v, i->a);
        if (i->op != IR_not)
            region_add_condition(p, v, i->b);
    } else if (i->op != IR_const) {
        const Leaf l = leaf_of(p, v, ref);
        if (l.y == SEARCH_NONE)
            add_constant(p, l.x, l.c);
        else
            find_or_add_group(p, l.x, l.y);
    }
}

// ---- regions ----

// Regions of constants c0 < c1: below c0, c0, between, c1, above, and NaN.  Of a pair: less, equal, greater, unordered.
static uint32_t count_regions(const RegionGroup *g) { return g->y == SEARCH_NONE ? 2 * g->constants + 1 + g->nan : 4; }

static bool is_whole(double x) { return x < -4e15 || x > 4e15 || x == (double)(int64_t)x; }

// Whether the group's current region contains no number that its value can have.
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

// Returns the result of a comparison, given the order of its operands: -1, 0 or 1; any other order is that of a NaN.
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

bool region_truth(Prover *p, const RegionView *v, IrRef ref)
{
    const IrIns *i = &v->fn->ins.at[ref];
    Leaf l;
    RegionGroup *g;
    int order;

    switch (i->op) {
    case IR_and: return region_truth(p, v, i->a) && region_truth(p, v, i->b);
    case IR_or: return region_truth(p, v, i->a) || region_truth(p, v, i->b);
    case IR_not: return !region_truth(p, v, i->a);
    case IR_const: return ir_number(i->type, i->bits) != 0;
    default: break;
    }
    l = leaf_of(p, v, ref);
    g = find_or_add_group(p, l.x, l.y);
    if (l.y == SEARCH_NONE)
        order = compare_region(g, l.c);
    else
        order = (int)g->region == 3 ? 2 : (int)g->region - 1;
    if (ir_op_info[i->op].types != IR_T_COMPARE)
        return order != 0 && order != 2;          // no comparison: true if not 0, and false for NaN
    return judge_order(l.op, l.swapped && order != 2 ? -order : order);
}

bool region_bounds(const RegionGroup *g, double bound[2], bool inside[2])
{
    const uint32_t r = g->region, i = r / 2;

    if (g->y != SEARCH_NONE || r > 2 * g->constants)
        return false;
    inside[0] = inside[1] = r % 2 == 1;
    bound[0] = r % 2 == 1 ? g->constant[i] : i == 0 ? -INFINITE : g->constant[i - 1];
    bound[1] = i == g->constants ? INFINITE : g->constant[i];
    if (bound[0] < g->least) {
        bound[0] = g->least;
        inside[0] = true;
    }
    if (bound[1] > g->most) {
        bound[1] = g->most;
        inside[1] = true;
    }
    return true;
}

// ---- combinations ----

// Sets the group to its first region that is not empty.
static void begin_regions(RegionGroup *g)
{
    for (g->region = 0; g->region < g->regions && is_empty(g); )
        g->region++;
}

double region_combinations(Prover *p)
{
    double combinations = 1;

    for (uint32_t i = 0; i < p->groups; i++) {
        RegionGroup *g = &p->group[i];
        g->regions = count_regions(g);
        combinations *= g->regions;
        begin_regions(g);
    }
    return combinations;
}

bool region_next(Prover *p)
{
    for (uint32_t i = 0; i < p->groups; i++) {
        RegionGroup *g = &p->group[i];
        do
            g->region++;
        while (g->region < g->regions && is_empty(g));
        if (g->region < g->regions)
            return true;
        begin_regions(g);
    }
    return false;
}
