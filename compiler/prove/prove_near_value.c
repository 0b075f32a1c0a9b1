// SPDX-License-Identifier: Apache-2.0
// The values of inputs that matter at a step: each comparison is solved for each input that it reads.
#include "compiler/prove/prove_near_parts.h"
#include "stdlib/convert.h"

enum {
    MOST_DEPTH = 12,          // of the recursion that solves an expression for an input
    MOST_VALUES = 120         // the most values that are listed for a step
};

// ---- comparisons ----

static bool is_relation(SmOperator op)
{
    return op == SM_OP_EQ || op == SM_OP_NE || op == SM_OP_LT || op == SM_OP_LE || op == SM_OP_GT || op == SM_OP_GE;
}

// Adds the number of samples of a window to the lengths of changes that are tried.
static void add_window(NearSearch *k, uint32_t samples)
{
    for (uint32_t i = 0; i < k->window.n; i++)
        if (k->window.at[i] == samples)
            return;
    if (samples > 2)
        vec_push(k->work, &k->window, samples);
}

// Marks the states that `e` names in comparisons `S == NAME`.  Of a requirement `never a after b`, the caller passes only b: a can come much later.
static void note_names(NearSearch *k, const Expr *e)
{
    const bool is_name = e->kind == EX_BINARY && e->op == SM_OP_EQ && e->arg[0]->kind == EX_VAR && e->arg[0]->var == k->p->s &&
                         e->arg[1]->kind == EX_NUMBER;

    if (is_name && e->arg[1]->number >= 1 && e->arg[1]->number <= k->p->state.n)
        k->is_named[(uint32_t)e->arg[1]->number] = true;
    for (uint32_t i = 0; i < e->n; i++)
        note_names(k, e->arg[i]);
}

// Adds a comparison that a change of inputs should turn to its other outcome.
static void add_leaf(NearSearch *k, const Expr *left, const Expr *right, uint32_t samples, uint32_t state)
{
    const NearLeaf l = {left, right, samples, state};

    vec_push(k->work, &k->leaf, l);
}

static bool is_run(const Expr *e) { return e->kind == EX_ROLL && (e->stat == SM_STAT_RUN_TIME || e->stat == SM_STAT_RUN_STEPS); }

// Returns how many samples in a row make `held` true: e compares their number, or their time, with a number.
static uint32_t samples_of_run(const NearSearch *k, const Expr *e)
{
    const double x = e->arg[1]->kind == EX_NUMBER ? e->arg[1]->number : 0;
    const double n = e->arg[0]->stat == SM_STAT_RUN_TIME ? x / (double)k->g->delta_t + 1 : x;

    return n >= 1 && n < SM_WINDOW_MAX ? (uint32_t)n : 1;
}

// Adds the comparisons in an expression; `samples`: for how many steps a change must last until a window shows it.
static void add_leaves(NearSearch *k, const Expr *e, const Windows *windows, uint32_t samples, uint32_t state)
{
    if (!e)
        return;
    if (e->kind == EX_ROLL) {
        const uint32_t size = windows->at[e->window].size;
        add_window(k, size);
        samples = size > samples ? size : samples;
    }
    if (e->kind == EX_BINARY && is_relation(e->op) && is_run(e->arg[0])) {
        const uint32_t run = samples_of_run(k, e);
        add_window(k, run);
        samples = run > samples ? run : samples;
    } else if (e->kind == EX_BINARY && is_relation(e->op)) {
        add_leaf(k, e->arg[0], e->arg[1], samples, state);
    }
    for (uint32_t i = 0; e->kind == EX_CHAIN && i + 1 < e->n; i++)
        add_leaf(k, e->arg[i], e->arg[i + 1], samples, state);
    if (e->kind == EX_VAR && e->var->type == SM_BOOL)
        add_leaf(k, e, NULL, samples, state);
    for (uint32_t i = 0; i < e->n; i++)
        add_leaves(k, e->arg[i], windows, samples, state);
}

// Adds the comparisons and the stores in the code of a state.
static void add_code(NearSearch *k, const Stmts *list, uint32_t state)
{
    for (uint32_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        const NearStore store = {state, s->var, s->value};
        if (s->kind != ST_TRANSITION)
            add_leaves(k, s->value, &k->p->window, 1, state);
        if (s->kind == ST_ASSIGN)
            vec_push(k->work, &k->store, store);
        add_code(k, &s->then, state);
        add_code(k, &s->otherwise, state);
    }
}

void near_find_leaves(NearSearch *k)
{
    const Expr *const part[] = {k->what->a, k->what->b, k->what->c};

    k->is_named = ARENA_ARRAY(k->work, bool, k->p->state.n + 1);
    for (int i = 0; i < 3; i++) {
        add_leaves(k, part[i], &k->g->all->window, 1, 0);
        if (part[i] && (k->what->kind != REQUIREMENT_AFTER || i == 1))
            note_names(k, part[i]);
    }
    k->required = k->leaf.n;
    k->required_windows = k->window.n;
    for (uint32_t s = 0; s < k->p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            add_code(k, &k->p->state.at[s]->block[b], s + 1);
}

// ---- values ----

// Whether an expression has no window and no random number, so that its value follows from the variables.
static bool is_evaluable(const Expr *e)
{
    if (e->kind == EX_ROLL || e->kind == EX_RANDOM)
        return false;
    for (uint32_t i = 0; i < e->n; i++)
        if (!is_evaluable(e->arg[i]))
            return false;
    return true;
}

double near_value_of(const NearSearch *k, const Expr *e)
{
    return is_evaluable(e) ? ref_eval(e, k->cell, NULL) : sm_from_bits(UINT64_C(0x7ff8000000000000));
}

// Adds a value of an input to those that are tried, unless the input has it already or its @range excludes it.
static void add_cell(NearSearch *k, const Var *v, uint64_t cell, uint32_t samples, bool is_required)
{
    const NearValue value = {v->index, cell, samples, is_required};
    const double x = sm_cell_to_f64(v->type, cell);

    if (k->m->var_of[v->index] == IR_NONE || cell == k->cell[v->index] || k->value.n == MOST_VALUES ||
        (k->g->assume_ranges && v->range && (x < v->range->lo || x > v->range->hi)))
        return;
    for (uint32_t i = 0; i < k->value.n; i++)
        if (k->value.at[i].var == v->index && k->value.at[i].cell == cell) {
            k->value.at[i].is_required |= is_required;
            k->value.at[i].samples = samples > k->value.at[i].samples ? samples : k->value.at[i].samples;
            return;
        }
    vec_push(k->work, &k->value, value);
}

// Returns the next value of the type above the one in `cell`, or below it.
static uint64_t neighbour_value(SmType type, uint64_t cell, bool above)
{
    const uint64_t sign = UINT64_C(1) << (8 * sm_type_info[type].bytes - 1);
    const double x = sm_cell_to_f64(type, cell);

    if (sm_type_info[type].kind != SM_KIND_FLOAT)
        return sm_cell_from_f64(type, above ? x + 1 : x - 1);
    if (x == 0)
        return above ? 1 : sign | 1;
    return (x > 0) == above ? cell + 1 : cell - 1;
}

// Adds to the values that are tried: the number x that an input should have, and its neighbours above and below in the type of the input; for a bool,
// the value that it does not have now.  Adds nothing if x is not finite.
static void add_input(NearSearch *k, const Var *v, double x, uint32_t samples, bool is_required)
{
    const uint64_t cell = sm_cell_from_f64(v->type, x);

    if (x - x != 0)
        return;
    if (v->type == SM_BOOL) {
        add_cell(k, v, k->cell[v->index] == 0, samples, is_required);
        return;
    }
    add_cell(k, v, cell, samples, is_required);
    add_cell(k, v, neighbour_value(v->type, cell, true), samples, is_required);
    add_cell(k, v, neighbour_value(v->type, cell, false), samples, is_required);
}

// ---- solutions ----

// The comparison that is being solved for its inputs, with the fields that its values get (NearValue).
typedef struct Solution { NearSearch *k; uint32_t state, samples; bool is_required; } Solution;

static void solve_for_inputs(const Solution *s, const Expr *e, double target, int depth);

// Adds values of inputs that make the variable have the target value: it is an input itself, or the state stores an expression to it.
static void solve_variable(const Solution *s, const Var *v, double target, int depth)
{
    NearSearch *k = s->k;

    if (k->input[v->index])
        add_input(k, v, target, s->samples, s->is_required);
    for (uint32_t i = 0; v->written && i < k->store.n; i++)
        if (k->store.at[i].var == v && k->store.at[i].state == s->state)
            solve_for_inputs(s, k->store.at[i].value, target, depth + 1);
}

// Solves `a op b = target` for a and for b, with the other operand as it is now.
static void solve_binary(const Solution *s, const Expr *e, double target, int depth)
{
    const double a = near_value_of(s->k, e->arg[0]), b = near_value_of(s->k, e->arg[1]);
    double for_a, for_b;

    switch (e->op) {
    case SM_OP_ADD: for_a = target - b; for_b = target - a; break;
    case SM_OP_SUB: for_a = target + b; for_b = a - target; break;
    case SM_OP_MUL: for_a = target / b; for_b = target / a; break;
    case SM_OP_DIV: for_a = target * b; for_b = a / target; break;
    default: return;
    }
    solve_for_inputs(s, e->arg[0], for_a, depth + 1);
    solve_for_inputs(s, e->arg[1], for_b, depth + 1);
}

static void solve_average(const Solution *s, const Expr *e, double target, int depth)
{
    for (uint32_t i = 0; i < e->n; i++) {
        double rest = target * e->n;
        for (uint32_t other = 0; other < e->n; other++)
            rest -= other == i ? 0 : near_value_of(s->k, e->arg[other]);
        solve_for_inputs(s, e->arg[i], rest, depth + 1);
    }
}

static void solve_call(const Solution *s, const Expr *e, double target, int depth)
{
    if (e->fn == SM_FN_average) {
        solve_average(s, e, target, depth);
        return;
    }
    for (uint32_t i = 0; i < e->n; i++) {
        solve_for_inputs(s, e->arg[i], target, depth + 1);
        if (e->fn == SM_FN_abs)
            solve_for_inputs(s, e->arg[i], -target, depth + 1);
    }
}

// Gives each input in e, one at a time, the value with which e has the value `target`.  A function that is not known is solved as if it returned its
// argument: what it needs is often close.
static void solve_for_inputs(const Solution *s, const Expr *e, double target, int depth)
{
    if (target - target != 0 || depth > MOST_DEPTH)
        return;
    switch (e->kind) {
    case EX_VAR: solve_variable(s, e->var, target, depth); break;
    case EX_UNARY: solve_for_inputs(s, e->arg[0], e->op == SM_OP_NEG ? -target : target, depth + 1); break;
    case EX_BINARY: solve_binary(s, e, target, depth); break;
    case EX_CALL: solve_call(s, e, target, depth); break;
    case EX_ROLL:
        if (e->stat <= SM_STAT_NEWEST && e->stat != SM_STAT_RANGE)
            solve_for_inputs(s, e->arg[0], target, depth + 1);
        break;
    default: break;
    }
}

// Adds both ends of the input's @range.
static void add_range(NearSearch *k, const Var *v)
{
    if (k->input[v->index] && v->range && v->read) {
        add_cell(k, v, sm_cell_from_f64(v->type, v->range->lo), 1, false);
        add_cell(k, v, sm_cell_from_f64(v->type, v->range->hi), 1, false);
    }
}

void near_list_values(NearSearch *k, uint32_t state)
{
    k->value.n = 0;
    for (uint32_t i = 0; i < k->leaf.n; i++) {
        const NearLeaf *l = &k->leaf.at[i];
        const Solution s = {k, state, l->samples, i < k->required};
        if (l->state != 0 && l->state != state)
            continue;
        if (!l->right) {
            solve_for_inputs(&s, l->left, 1, 0);
            continue;
        }
        solve_for_inputs(&s, l->left, near_value_of(k, l->right), 0);
        solve_for_inputs(&s, l->right, near_value_of(k, l->left), 0);
    }
    for (uint32_t v = 0; v < k->p->var.n; v++)
        add_range(k, k->p->var.at[v]);
}
