// SPDX-License-Identifier: Apache-2.0
// A *wish* (SearchWish) bounds the value that an input should get so that a condition becomes true or false.  The wishes are found by solving
// the condition for the inputs that it reads: through arithmetic with the values of the other operands, through
// windows as if their samples were all equal, and through variables by one of the statements that store them.  One step has run on a copy of the
// snapshot, so that the frame has the value of every temporary.
#include "compiler/search/search_wish.h"
#include "stdlib/convert.h"

enum {
    MOST_DEPTH = 12,          // of the recursion through operands and stores
    SPIKE_PERCENT = 15        // of a hundred solutions for an average, so many change only its newest sample
};

typedef enum Rel { REL_GE, REL_GT, REL_LE, REL_LT, REL_EQ, REL_NE } Rel;

static void add_wishes_for_truth(SearchRun *k, uint32_t fn, IrRef ref, bool truth, int depth);
static void add_wishes_for_number(SearchRun *k, uint32_t fn, IrRef ref, Rel rel, double x, int depth);


static bool satisfies(double a, Rel rel, double b)
{
    switch (rel) {
    case REL_GE: return a >= b;
    case REL_GT: return a > b;
    case REL_LE: return a <= b;
    case REL_LT: return a < b;
    case REL_EQ: return a == b;
    case REL_NE: return a != b;
    }
    return false;
}

// Returns the relation of b to a if `rel` is that of a to b.
static Rel swap_sides(Rel rel)
{
    static const Rel flipped[] = {REL_LE, REL_LT, REL_GE, REL_GT, REL_EQ, REL_NE};

    return flipped[rel];
}

static bool is_finite(double x) { return x - x == 0; }

void search_wait_for(SearchRun *k, double steps)
{
    if (steps > 0 && steps < (double)k->effort / 4 && (double)k->wait < steps)
        k->wait = (uint64_t)steps + ((double)(uint64_t)steps < steps);
}

// ---- inputs ----

static void add_wish_for_input(SearchRun *k, uint32_t input, Rel rel, double x)
{
    SearchWish *w = &k->wish[input];
    const double now = sm_cell_to_f64(k->input[input].type, flat_cells(k->plain, k->scratch)[k->input[input].at]);

    if (!is_finite(x))
        return;
    w->needed |= !satisfies(now, rel, x);
    if (rel == REL_NE) {
        w->differs = true;
        w->other = x;
        return;
    }
    if ((rel == REL_GE || rel == REL_GT || rel == REL_EQ) && x >= w->lo) {
        w->above = rel == REL_GT || (w->above && x == w->lo);
        w->lo = x;
    }
    if ((rel == REL_LE || rel == REL_LT || rel == REL_EQ) && x <= w->hi) {
        w->below = rel == REL_LT || (w->below && x == w->hi);
        w->hi = x;
    }
}

// Waits until T or G (`var`) satisfies `var rel x`; two steps are enough for it to differ from x.
static void wait_for_time(SearchRun *k, uint32_t var, Rel rel, double x)
{
    const double now = (double)flat_cells(k->plain, k->scratch)[var], step = (double)k->delta_t;

    if (rel == REL_GE || rel == REL_GT || rel == REL_EQ)
        search_wait_for(k, (x - now) / step + 1 + (rel == REL_GT));
    else if (rel == REL_NE)
        search_wait_for(k, 2);
}

// ---- variables ----

// Wishes for the outcomes of all decisions on a path, the last one first.  A wish is a value of an input that the search then tries.
static void add_wishes_for_path(SearchRun *k, SearchPath path, int depth)
{
    for (uint32_t e = path.n; e-- > 0; ) {
        const SearchDecision *d = &k->decision[path.elem[e].decision];
        add_wishes_for_truth(k, d->fn, d->d->value, path.elem[e].value, depth);
    }
}

// Chooses a store to a variable that steps of the current state can execute, if there is one.
static const SearchStore *choose_store(SearchRun *k, uint32_t var)
{
    const SearchVar *v = &k->var[var];
    const SearchStore *out = NULL;
    uint32_t n = 0;

    for (uint32_t i = 0; i < v->store.n; i++)
        if (v->store.at[i].state == k->site_state && k->fn[v->store.at[i].fn].is_step && search_pick(k, ++n) == 0)
            out = &v->store.at[i];
    return out;
}

// Returns by how much a store changes its variable, if its value is the variable plus or minus something; else 0.
static double increment_of(const SearchRun *k, const SearchStore *s, uint32_t var)
{
    const IrFn *f = k->fn[s->fn].fn;
    IrRef ref = s->value;
    const IrIns *i = &f->ins.at[ref];

    for (; i->op == IR_cvt; i = &f->ins.at[ref])
        ref = i->a;
    if (i->op != IR_add && i->op != IR_sub)
        return 0;
    for (int side = 0; side < 2; side++) {
        IrRef of = side ? i->b : i->a, other = side ? i->a : i->b;
        while (f->ins.at[of].op == IR_cvt)
            of = f->ins.at[of].a;
        if (f->ins.at[of].op == IR_load && f->ins.at[of].var == var && (side == 0 || i->op == IR_add))
            return i->op == IR_sub ? -search_value_of(k, s->fn, other) : search_value_of(k, s->fn, other);
    }
    return 0;
}

static void add_wishes_for_var(SearchRun *k, uint32_t var, Rel rel, double x, int depth)
{
    const SearchStore *s = choose_store(k, var);
    const double now = sm_cell_to_f64(k->m->var.at[var].type, flat_cells(k->plain, k->scratch)[var]);
    double step;

    if (satisfies(now, rel, x))
        return;
    if (!s) {
        k->foreign = var;
        k->foreign_value = x;
        return;
    }
    add_wishes_for_path(k, k->path[s->stmt], depth + 1);
    step = increment_of(k, s, var);
    if (step != 0) {
        const double rounds = (x - now) / step;
        if (rounds > (double)k->rounds && rounds < 1e6)
            k->rounds = (uint64_t)rounds + 1;
        search_wait_for(k, rounds + 1);
        return;
    }
    add_wishes_for_number(k, s->fn, s->value, rel, x, depth + 1);
    if (k->fn[s->fn].handle[s->value] & HANDLE_VAR && search_chance(k, 50))
        search_wait_for(k, 1u << search_pick(k, 10));
}

// ---- windows ----

static void add_wishes_for_event(SearchRun *k, uint32_t fn, IrRef sample, SmStat stat, Rel rel, double x, int depth)
{
    const bool more = rel == REL_GE || rel == REL_GT || (rel == REL_EQ && x > 0) || (rel == REL_NE && x <= 0);

    add_wishes_for_truth(k, fn, sample, more, depth + 1);
    if (more)
        search_wait_for(k, stat == SM_STAT_RUN_TIME ? x / (double)k->delta_t + 2 : x + 2);
}

// Adds noise, or a slope, to the inputs of what a window samples.
static void add_wishes_for_movement(SearchRun *k, uint32_t fn, IrRef sample, double amplitude, double slope, bool is_needed)
{
    const IrFn *f = k->fn[fn].fn;
    const IrIns *i = &f->ins.at[sample];

    if (i->op == IR_load && k->var[i->var].input != SEARCH_NONE) {
        SearchWish *w = &k->wish[k->var[i->var].input];
        w->needed |= is_needed;
        w->vary = amplitude;
        w->slope = slope;
        return;
    }
    if (i->op == IR_const || i->op == IR_load || i->op == IR_stat)
        return;
    if (i->b != IR_NONE && (k->fn[fn].handle[i->b] & HANDLE_INPUT) && (!(k->fn[fn].handle[i->a] & HANDLE_INPUT) || search_chance(k, 50)))
        add_wishes_for_movement(k, fn, i->b, amplitude, slope, is_needed);
    else if (i->a != IR_NONE)
        add_wishes_for_movement(k, fn, i->a, amplitude, slope, is_needed);
}

// Returns by how much a sample has to change in each step, so that a window changes by more, or by less, than x.
static double choose_slope(SearchRun *k, uint32_t size, double x, bool more)
{
    const double exact = size > 1 ? x / (size - 1) : x;

    if (x == 0)
        return more ? 1 : -1;
    if (more == (x > 0))
        return exact * (search_chance(k, 50) ? 1.25 : 2);
    return exact * (search_chance(k, 50) ? 0.75 : 0.25);
}

// Returns the operation whose value a window samples, in the function of all samples.
static IrRef find_sampled(const SearchRun *k, uint32_t window)
{
    const IrFn *f = k->m->sample;

    for (uint32_t i = 0; i < f->ins.n; i++)
        if (f->ins.at[i].op == IR_sample && f->ins.at[i].var == window)
            return f->ins.at[i].a;
    return IR_NONE;
}

// Adds wishes for what a window samples, so that its statistic is in the relation `rel` to x.
static void add_wishes_for_window(SearchRun *k, uint32_t fn, IrRef ref, Rel rel, double x, int depth)
{
    const uint32_t window = k->fn[fn].fn->ins.at[ref].var;
    const SmStat stat = k->fn[fn].fn->ins.at[ref].stat;
    const bool is_satisfied = satisfies(search_value_of(k, fn, ref), rel, x);
    const uint32_t size = k->m->window.at[window].size;
    const IrRef sample = find_sampled(k, window);
    const bool more = rel == REL_GE || rel == REL_GT;

    switch (stat) {
    case SM_STAT_RUN_STEPS: case SM_STAT_RUN_TIME:
        add_wishes_for_event(k, 0, sample, stat, rel, x, depth);
        return;
    case SM_STAT_ELAPSED: return;
    case SM_STAT_RANGE:
        if (more || rel == REL_NE)
            add_wishes_for_movement(k, 0, sample, (x > 0 ? 2 * x : 1), 0, true);
        else
            search_wait_for(k, size + 1);
        return;
    case SM_STAT_CHANGE:
        if (rel == REL_EQ || rel == REL_NE)
            add_wishes_for_movement(k, 0, sample, 0, rel == REL_EQ ? 0 : 1, true);
        else
            add_wishes_for_movement(k, 0, sample, 0, choose_slope(k, size, x, more), !is_satisfied);
        search_wait_for(k, size + 1);
        return;
    default: break;
    }
    if (stat == SM_STAT_AVG && search_chance(k, SPIKE_PERCENT)) {
        const double average = search_value_of(k, fn, ref), newest = search_value_of(k, 0, sample);
        add_wishes_for_number(k, 0, sample, rel, newest + (x - average) * size, depth + 1);
        return;
    }
    add_wishes_for_number(k, 0, sample, rel, x, depth + 1);
    if (stat != SM_STAT_NEWEST)
        search_wait_for(k, size + 1);
}

// ---- expressions ----

// Chooses the operand of a binary operation to solve for; the other one has its current value.
static bool choose_second(SearchRun *k, uint32_t fn, const IrIns *i)
{
    static const uint8_t weight[16] = {0, 9, 3, 9, 2, 9, 3, 9, 6, 9, 6, 9, 6, 9, 6, 9};
    const uint32_t a = weight[k->fn[fn].handle[i->a] & 15], b = weight[k->fn[fn].handle[i->b] & 15];

    return a + b > 0 && search_pick(k, a + b) >= a;
}

static void add_wishes_for_sum(SearchRun *k, uint32_t fn, const IrIns *i, Rel rel, double x, int depth)
{
    if (!choose_second(k, fn, i))
        add_wishes_for_number(k, fn, i->a, rel, i->op == IR_add ? x - search_value_of(k, fn, i->b) : x + search_value_of(k, fn, i->b), depth);
    else if (i->op == IR_add)
        add_wishes_for_number(k, fn, i->b, rel, x - search_value_of(k, fn, i->a), depth);
    else
        add_wishes_for_number(k, fn, i->b, swap_sides(rel), search_value_of(k, fn, i->a) - x, depth);
}

static void add_wishes_for_product(SearchRun *k, uint32_t fn, const IrIns *i, Rel rel, double x, int depth)
{
    const bool second = choose_second(k, fn, i);
    const double other = search_value_of(k, fn, second ? i->a : i->b);

    if (other != 0)
        add_wishes_for_number(k, fn, second ? i->b : i->a, other < 0 ? swap_sides(rel) : rel, x / other, depth);
    else if (k->fn[fn].handle[second ? i->a : i->b])
        add_wishes_for_number(k, fn, second ? i->a : i->b, REL_NE, 0, depth);
}

static void add_wishes_for_quotient(SearchRun *k, uint32_t fn, const IrIns *i, Rel rel, double x, int depth)
{
    const double a = search_value_of(k, fn, i->a), b = search_value_of(k, fn, i->b);

    if (!choose_second(k, fn, i))
        add_wishes_for_number(k, fn, i->a, b < 0 ? swap_sides(rel) : rel, x * b, depth);
    else if (x != 0)
        add_wishes_for_number(k, fn, i->b, (a < 0) == (x < 0) ? swap_sides(rel) : rel, a / x, depth);
}

static void add_wishes_for_magnitude(SearchRun *k, uint32_t fn, const IrIns *i, Rel rel, double x, int depth)
{
    const bool negative = search_value_of(k, fn, i->a) < 0 ? search_chance(k, 70) : search_chance(k, 30);

    if (rel == REL_LE || rel == REL_LT) {
        add_wishes_for_number(k, fn, i->a, rel, x, depth);
        add_wishes_for_number(k, fn, i->a, swap_sides(rel), -x, depth);
    } else if (negative) {
        add_wishes_for_number(k, fn, i->a, swap_sides(rel), -x, depth);
    } else {
        add_wishes_for_number(k, fn, i->a, rel, x, depth);
    }
}

// min and max.
static void add_wishes_for_extreme(SearchRun *k, uint32_t fn, const IrIns *i, Rel rel, double x, int depth)
{
    const bool is_min = i->op == IR_min, both = is_min == (rel == REL_GE || rel == REL_GT);

    if (rel == REL_EQ || rel == REL_NE) {
        const bool second = choose_second(k, fn, i);
        add_wishes_for_number(k, fn, second ? i->b : i->a, rel, x, depth);
        if (rel == REL_EQ)
            add_wishes_for_number(k, fn, second ? i->a : i->b, is_min ? REL_GE : REL_LE, x, depth);
        return;
    }
    if (both || satisfies(search_value_of(k, fn, i->a), rel, x) < satisfies(search_value_of(k, fn, i->b), rel, x)) {
        add_wishes_for_number(k, fn, i->b, rel, x, depth);
        if (both)
            add_wishes_for_number(k, fn, i->a, rel, x, depth);
    } else if (satisfies(search_value_of(k, fn, i->a), rel, x) && search_chance(k, 70)) {
        add_wishes_for_number(k, fn, i->a, rel, x, depth);
    } else {
        add_wishes_for_number(k, fn, choose_second(k, fn, i) ? i->b : i->a, rel, x, depth);
    }
}

static void add_wishes_for_load(SearchRun *k, uint32_t var, Rel rel, double x, int depth)
{
    if (k->var[var].input != SEARCH_NONE)
        add_wish_for_input(k, k->var[var].input, rel, x);
    else if (var == k->m->t || var == k->m->g)
        wait_for_time(k, var, rel, x);
    else if (var != k->m->s)
        add_wishes_for_var(k, var, rel, x, depth);
}

// Adds wishes so that a temporary is in the relation `rel` to x.
static void add_wishes_for_number(SearchRun *k, uint32_t fn, IrRef ref, Rel rel, double x, int depth)
{
    const IrIns *i = &k->fn[fn].fn->ins.at[ref];

    if (depth > MOST_DEPTH || k->fn[fn].handle[ref] == 0)
        return;
    switch (i->op) {
    case IR_load: add_wishes_for_load(k, i->var, rel, x, depth); break;
    case IR_stat: add_wishes_for_window(k, fn, ref, rel, x, depth); break;
    case IR_add: case IR_sub: add_wishes_for_sum(k, fn, i, rel, x, depth); break;
    case IR_mul: add_wishes_for_product(k, fn, i, rel, x, depth); break;
    case IR_div: add_wishes_for_quotient(k, fn, i, rel, x, depth); break;
    case IR_neg: add_wishes_for_number(k, fn, i->a, swap_sides(rel), -x, depth); break;
    case IR_abs: add_wishes_for_magnitude(k, fn, i, rel, x, depth); break;
    case IR_min: case IR_max: add_wishes_for_extreme(k, fn, i, rel, x, depth); break;
    case IR_sqrt: add_wishes_for_number(k, fn, i->a, rel, x * x, depth); break;
    case IR_hypot: add_wishes_for_number(k, fn, choose_second(k, fn, i) ? i->b : i->a, rel, x, depth); break;
    case IR_sign: add_wishes_for_number(k, fn, i->a, rel, 0, depth); break;
    case IR_eq: case IR_ne: case IR_lt: case IR_le: case IR_gt: case IR_ge: case IR_and: case IR_or: case IR_not:
        add_wishes_for_truth(k, fn, ref, satisfies(1, rel, x), depth);
        break;
    default:
        if (i->a != IR_NONE)
            add_wishes_for_number(k, fn, i->a, rel, x, depth);
        break;
    }
}

static Rel relation_of(IrOp op, bool truth)
{
    switch (op) {
    case IR_lt: return truth ? REL_LT : REL_GE;
    case IR_le: return truth ? REL_LE : REL_GT;
    case IR_gt: return truth ? REL_GT : REL_LE;
    case IR_ge: return truth ? REL_GE : REL_LT;
    case IR_eq: return truth ? REL_EQ : REL_NE;
    default: return truth ? REL_NE : REL_EQ;
    }
}

// If a comparison compares an input with an output, adds the wish that the input follows the output, as a feedback does.
static void add_wishes_for_copy(SearchRun *k, uint32_t fn, IrRef a, IrRef b)
{
    const IrFn *f = k->fn[fn].fn;

    while (f->ins.at[a].op == IR_cvt)
        a = f->ins.at[a].a;
    while (f->ins.at[b].op == IR_cvt)
        b = f->ins.at[b].a;
    if (f->ins.at[a].op != IR_load || f->ins.at[b].op != IR_load || k->var[f->ins.at[a].var].input == SEARCH_NONE ||
        k->var[f->ins.at[b].var].store.n == 0)
        return;
    for (uint32_t i = 0; i < k->output.n; i++)
        if (k->m->var_of[k->output.at[i]] == f->ins.at[b].var)
            k->wish[k->var[f->ins.at[a].var].input].copies = k->output.at[i];
}

// If a comparison compares a value with its own last one, adds the wish that it changes in each step, as a counter does.
static bool add_wishes_for_going_on(SearchRun *k, uint32_t fn, const IrIns *i)
{
    const IrFn *f = k->fn[fn].fn;

    for (int side = 0; side < 2; side++) {
        const IrIns *last = &f->ins.at[side ? i->b : i->a];
        if (last->op == IR_stat && (last->stat == SM_STAT_OLDEST || last->stat == SM_STAT_NEWEST)) {
            add_wishes_for_movement(k, 0, find_sampled(k, last->var), 0, 1, true);
            return true;
        }
    }
    return false;
}

static void add_wishes_for_comparison(SearchRun *k, uint32_t fn, const IrIns *i, bool truth, int depth)
{
    const Rel rel = relation_of(i->op, truth);
    const bool second = choose_second(k, fn, i);

    if (rel == REL_EQ && search_chance(k, 40)) {
        add_wishes_for_copy(k, fn, i->a, i->b);
        add_wishes_for_copy(k, fn, i->b, i->a);
    }
    if (rel == REL_NE && k->is_lasting && add_wishes_for_going_on(k, fn, i))
        return;
    if (second)
        add_wishes_for_number(k, fn, i->b, swap_sides(rel), search_value_of(k, fn, i->a), depth);
    else
        add_wishes_for_number(k, fn, i->a, rel, search_value_of(k, fn, i->b), depth);
}

// Adds wishes so that temporary a or b gets the value `truth`.  Prefers the one that has this value already.
static void add_wishes_for_either(SearchRun *k, uint32_t fn, IrRef a, IrRef b, bool truth, int depth)
{
    const bool has_a = (search_value_of(k, fn, a) != 0) == truth, has_b = (search_value_of(k, fn, b) != 0) == truth;
    const bool second = has_a == has_b || search_chance(k, 30) ? search_chance(k, 50) : has_b;

    add_wishes_for_truth(k, fn, second ? b : a, truth, depth);
}

// Adds wishes so that temporary `ref` of the function gets the value `truth`.
static void add_wishes_for_truth(SearchRun *k, uint32_t fn, IrRef ref, bool truth, int depth)
{
    const IrIns *i = &k->fn[fn].fn->ins.at[ref];

    if (depth > MOST_DEPTH || k->fn[fn].handle[ref] == 0)
        return;
    if (i->op == IR_not) {
        add_wishes_for_truth(k, fn, i->a, !truth, depth);
    } else if (i->op == IR_cvt) {
        add_wishes_for_truth(k, fn, i->a, truth, depth);
    } else if (i->op == IR_and || i->op == IR_or) {
        if (truth == (i->op == IR_and)) {
            add_wishes_for_truth(k, fn, i->a, truth, depth);
            add_wishes_for_truth(k, fn, i->b, truth, depth);
        } else {
            add_wishes_for_either(k, fn, i->a, i->b, truth, depth);
        }
    } else if (ir_op_info[i->op].types == IR_T_COMPARE) {
        add_wishes_for_comparison(k, fn, i, truth, depth);
    } else {
        add_wishes_for_number(k, fn, ref, truth ? REL_NE : REL_EQ, 0, depth);
    }
}

// ---- decisions ----

bool search_node_value(const SearchRun *k, const SearchDecision *x, uint32_t n)
{
    const FlatNode *node = &x->d->node[n];

    switch (node->kind) {
    case NODE_CONDITION: return search_value_of(k, x->fn, x->d->condition[node->a]) != 0;
    case NODE_NOT: return !search_node_value(k, x, node->a);
    case NODE_AND: return search_node_value(k, x, node->a) && search_node_value(k, x, node->b);
    default: return search_node_value(k, x, node->a) || search_node_value(k, x, node->b);
    }
}

void search_wish_node(SearchRun *k, const SearchDecision *x, uint32_t n, bool value)
{
    const FlatNode *node = &x->d->node[n];

    if (node->kind == NODE_CONDITION) {
        add_wishes_for_truth(k, x->fn, x->d->condition[node->a], value, 0);
    } else if (node->kind == NODE_NOT) {
        search_wish_node(k, x, node->a, !value);
    } else if (value == (node->kind == NODE_AND)) {
        search_wish_node(k, x, node->a, value);
        search_wish_node(k, x, node->b, value);
    } else {
        const bool has_a = search_node_value(k, x, node->a) == value, has_b = search_node_value(k, x, node->b) == value;
        search_wish_node(k, x, (has_a == has_b || search_chance(k, 30) ? search_chance(k, 50) : has_b) ? node->b : node->a, value);
    }
}

void search_wish_condition(SearchRun *k, const SearchDecision *x, uint32_t condition, bool value)
{
    const FlatDecision *d = x->d;
    uint32_t n = 0;

    while (d->node[n].kind != NODE_CONDITION || d->node[n].a != condition)
        n++;
    search_wish_node(k, x, n, value);
    for (uint32_t up = n + 1; up < d->nodes; up++) {
        const FlatNode *node = &d->node[up];
        const bool joins = node->kind == NODE_AND || node->kind == NODE_OR;
        if (node->kind == NODE_CONDITION || (node->a != n && !(joins && node->b == n)))
            continue;
        if (joins)
            search_wish_node(k, x, node->a == n ? node->b : node->a, node->kind == NODE_AND);
        n = up;
    }
}
