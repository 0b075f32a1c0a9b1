// SPDX-License-Identifier: Apache-2.0
// Which inputs a value depends on is a bit for each input, spread through variables until nothing is added: `data` through values
// alone, `all` through the guards of assignments too.
//
// The readings of an input: where the two sides of a comparison are equal, what the comparison decides changes.  That reading is found
// by a secant, for most comparisons are of straight lines.  One reading from each interval between them, and zero, is enough to make
// every comparison come out both ways.
#include "compiler/analysis/trial_inputs.h"

#include <stdlib.h>
#include <string.h>

#include "compiler/analysis/sensors.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

enum {
    ROOTS = 16,                   // of one input
    COMPARED_MOST = 400           // comparisons that are compared with each other
};

typedef struct Comparison { const Expr *left, *right; SmOperator op; uint32_t state; } Comparison;      // state: its number

typedef struct Finder {
    Trials *t;
    Arena *arena;
    const Program *p;
    size_t words;                 // of 64 bits, one for each input
    uint64_t *data, *all;         // by Var.index
    uint32_t *input_of;           // by Var.index; IR_NONE
    uint32_t *parent;             // by Var.index: sensors and what is made of them, joined by what they are combined with
    VEC(Comparison) comparison;
    VEC(const Stmt *) assign;     // every assignment, in file order
    VEC(uint32_t) assign_state;   // the number of its state
    double *value, *kept;         // by Var.index; the same, as it was before
    uint32_t state;               // number of the state whose statements are looked at
    uint64_t *bits;               // for one expression
    bool *read;                   // by Var.index: a guard or another value reads it
    bool *zeroed;                 // by Var.index: some assignment switches it off
    bool *bounded;                // by Var.index: some assignment is of a bounded number
    bool *varied;                 // by Var.index: some assignment is no constant
    VEC(double) *given;           // by Var.index: the constants that it is given
} Finder;

// ---- what depends on what ----

typedef struct Sum { const uint64_t *of; size_t words; uint64_t *to; } Sum;

static void add_bits(Expr *e, void *context)
{
    Sum *s = context;

    if (e->kind == EX_VAR && !e->var->is_constant)
        for (size_t w = 0; w < s->words; w++)
            s->to[w] |= s->of[e->var->index * s->words + w];
}

static void bits_of(Finder *f, const Expr *e, const uint64_t *of, uint64_t *to)
{
    Sum s = {of, f->words, to};

    expr_walk((Expr *)e, add_bits, &s);
}

static bool has_bit(const uint64_t *bits, uint32_t i) { return bits[i / 64] >> i % 64 & 1; }

typedef struct Spread { Finder *f; bool more; } Spread;

static bool merge(const Finder *f, uint64_t *into, const uint64_t *bits)
{
    bool more = false;

    for (size_t w = 0; w < f->words; w++) {
        more |= (bits[w] & ~into[w]) != 0;
        into[w] |= bits[w];
    }
    return more;
}

static void spread_store(const StmtPlace *at, void *context)
{
    Spread *s = context;
    Finder *f = s->f;
    const size_t to = at->stmt->kind == ST_ASSIGN ? at->stmt->var->index * f->words : 0;

    if (at->stmt->kind != ST_ASSIGN)
        return;
    memset(f->bits, 0, f->words * sizeof *f->bits);
    bits_of(f, at->stmt->value, f->data, f->bits);
    s->more |= merge(f, f->data + to, f->bits);
    bits_of(f, at->stmt->value, f->all, f->bits);
    for (const Condition *when = at->when; when; when = when->outer)
        bits_of(f, when->stmt->value, f->all, f->bits);
    s->more |= merge(f, f->all + to, f->bits);
}

static void spread(Finder *f)
{
    Spread s = {f, true};

    for (int round = 0; s.more && round < 16; round++) {
        s.more = false;
        each_place(f->arena, f->p, spread_store, &s);
    }
}

// ---- the inputs ----

static bool is_input(const Finder *f, const Var *v)
{
    return v->kind == VAR_ELEMENT && !v->written && v->read && v != f->p->g && v != f->p->s && f->t->a->m->var_of[v->index] != IR_NONE;
}

static void healthy_range(TrialInput *i)
{
    const Fact type = fact_of_type(i->v->type);

    i->lo = i->v->range ? i->v->range->lo : type.lo;
    i->hi = i->v->range ? i->v->range->hi : type.hi;
}

static void list_inputs(Finder *f)
{
    Trials *t = f->t;
    const Sensors *sensors = sensors_of(t->a);

    t->input = ARENA_ARRAY(f->arena, TrialInput, f->p->var.n + 1);
    f->input_of = ARENA_ARRAY(f->arena, uint32_t, f->p->var.n);
    for (size_t v = 0; v < f->p->var.n; v++) {
        const Var *var = f->p->var.at[v];
        f->input_of[v] = IR_NONE;
        if (!is_input(f, var))
            continue;
        f->input_of[v] = t->inputs;
        t->input[t->inputs] = (TrialInput){.v = var, .var = t->a->m->var_of[v], .command = !is_sensor(sensors, var), .group = t->inputs};
        healthy_range(&t->input[t->inputs++]);
    }
    f->words = t->inputs / 64 + 1;
    f->data = ARENA_ARRAY(f->arena, uint64_t, f->p->var.n * f->words);
    f->all = ARENA_ARRAY(f->arena, uint64_t, f->p->var.n * f->words);
    f->bits = ARENA_ARRAY(f->arena, uint64_t, f->words);
    for (size_t v = 0; v < f->p->var.n; v++)
        if (f->input_of[v] != IR_NONE)
            f->data[v * f->words + f->input_of[v] / 64] = f->all[v * f->words + f->input_of[v] / 64] = UINT64_C(1) << f->input_of[v] % 64;
}

// ---- groups ----

static uint32_t root_of(Finder *f, uint32_t v)
{
    while (f->parent[v] != v)
        v = f->parent[v] = f->parent[f->parent[v]];
    return v;
}

static uint32_t join(Finder *f, uint32_t a, uint32_t b)
{
    if (a == IR_NONE || b == IR_NONE)
        return a == IR_NONE ? b : a;
    f->parent[root_of(f, b)] = root_of(f, a);
    return a;
}

static bool is_sum(const Expr *e)
{
    return (e->kind == EX_BINARY && (e->op == SM_OP_ADD || e->op == SM_OP_SUB)) || e->kind == EX_ROLL ||
           (e->kind == EX_UNARY && e->op == SM_OP_NEG) || e->kind == EX_CALL;
}

static bool is_scaled(const Expr *e)
{
    return e->kind == EX_BINARY && (e->op == SM_OP_MUL || e->op == SM_OP_DIV) && (expr_is_constant(e->arg[0]) || expr_is_constant(e->arg[1]));
}

// The quantity that an expression is of, as a variable of that quantity; IR_NONE: none that is known.  Joins what is compared.
static uint32_t quantity(Finder *f, const Expr *e)
{
    const bool compared = e->kind == EX_CHAIN || (e->kind == EX_BINARY && is_comparison(e->op));
    uint32_t all = IR_NONE;

    if (e->kind == EX_VAR)
        return e->var->type != SM_BOOL && !e->var->is_constant && e->var->kind != VAR_TIME && e->var != f->p->g && e->var != f->p->s &&
               (e->var->kind == VAR_LOCAL || e->var->written || (f->input_of[e->var->index] != IR_NONE && !f->t->input[f->input_of[e->var->index]].command))
               ? e->var->index : IR_NONE;
    for (uint32_t i = 0; i < e->n; i++) {
        const uint32_t q = quantity(f, e->arg[i]);
        if (compared || is_sum(e) || is_scaled(e))
            all = join(f, all, q);
    }
    return compared ? IR_NONE : all;
}

static void join_places(const StmtPlace *at, void *context)
{
    Finder *f = context;
    uint32_t q;

    if (!at->stmt->value)
        return;
    q = quantity(f, at->stmt->value);
    if (at->stmt->kind == ST_ASSIGN && at->stmt->var->type != SM_BOOL)
        join(f, at->stmt->var->index, q);
}

// Whether two expressions are the same but for the variables in them.  Variables at the same position measure the same quantity.
static bool is_alike(Finder *f, const Expr *a, const Expr *b, bool join_them)
{
    bool alike = a->kind == b->kind && a->op == b->op && a->fn == b->fn && a->stat == b->stat && a->n == b->n;

    if (!alike || expr_is_constant(a) != expr_is_constant(b))
        return false;
    if (expr_is_constant(a))
        return const_eval(a) == const_eval(b);
    if (a->kind == EX_VAR) {
        const uint32_t x = quantity(f, a), y = quantity(f, b);
        if (x == IR_NONE || y == IR_NONE)
            return a->var == b->var;
        if (join_them)
            join(f, x, y);
        return true;
    }
    for (uint32_t i = 0; i < a->n && alike; i++)
        alike = is_alike(f, a->arg[i], b->arg[i], join_them);
    return alike;
}

// Sensors that one state compares in the same way are taken to measure the same quantity.
static void join_alike(Finder *f)
{
    const size_t n = f->comparison.n < COMPARED_MOST ? f->comparison.n : COMPARED_MOST;

    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < i; k++) {
            const Comparison a = f->comparison.at[i], b = f->comparison.at[k];
            if (a.op == b.op && a.state == b.state && is_alike(f, a.left, b.left, false) && is_alike(f, a.right, b.right, false)) {
                is_alike(f, a.left, b.left, true);
                is_alike(f, a.right, b.right, true);
            }
        }
}

// Two of one quantity have ranges that are mostly the same, as far as they are given.
static bool same_range(const TrialInput *a, const TrialInput *b)
{
    const double wide = sm_max(a->hi - a->lo, b->hi - b->lo);

    return !a->v->range || !b->v->range || sm_min(a->hi, b->hi) - sm_max(a->lo, b->lo) >= 0.8 * wide;
}

static void find_groups(Finder *f)
{
    Trials *t = f->t;

    f->parent = ARENA_ARRAY(f->arena, uint32_t, f->p->var.n);
    for (uint32_t v = 0; v < f->p->var.n; v++)
        f->parent[v] = v;
    each_place(f->arena, f->p, join_places, f);
    join_alike(f);
    for (uint32_t i = 0; i < t->inputs; i++)
        for (uint32_t k = 0; k < i && t->input[i].group == i; k++)
            if (!t->input[i].command && !t->input[k].command && same_range(&t->input[i], &t->input[k]) &&
                root_of(f, t->input[i].v->index) == root_of(f, t->input[k].v->index))
                t->input[i].group = t->input[k].group;
}

// ---- comparisons ----

static void note_comparison(Expr *e, void *context)
{
    Finder *f = context;

    if (e->kind == EX_CHAIN || (e->kind == EX_BINARY && is_comparison(e->op)))
        for (uint32_t i = 1; i < e->n; i++)
            vec_push(f->arena, &f->comparison, ((Comparison){e->arg[i - 1], e->arg[i], e->kind == EX_CHAIN ? expr_ops(e)[i - 1] : e->op, f->state}));
    if (e->kind == EX_CALL && e->n > 1)
        for (uint32_t i = 1; i < e->n; i++)
            vec_push(f->arena, &f->comparison, ((Comparison){e->arg[0], e->arg[i], SM_OP_COUNT, f->state}));
    if (e->kind == EX_VAR)
        f->read[e->var->index] = true;
}

static void note_place(const StmtPlace *at, void *context)
{
    Finder *f = context;

    f->state = at->state->number;
    if (at->stmt->value)
        expr_walk(at->stmt->value, note_comparison, f);
    if (at->stmt->kind != ST_ASSIGN)
        return;
    vec_push(f->arena, &f->assign, at->stmt);
    vec_push(f->arena, &f->assign_state, at->state->number);
    if (!expr_is_constant(at->stmt->value)) {
        f->varied[at->stmt->var->index] |= at->stmt->value->kind != EX_VAR || at->stmt->value->var->kind != VAR_LOCAL;
    } else {
        const double x = const_eval(at->stmt->value);
        f->zeroed[at->stmt->var->index] |= x == 0;
        vec_push(f->arena, &f->given[at->stmt->var->index], x);
    }
}

// ---- readings ----

// Makes the assignments of one state, or of all, once each in file order.
static void assign(Finder *f, uint32_t state)
{
    for (size_t i = 0; i < f->assign.n; i++)
        if (state == 0 || f->assign_state.at[i] == state)
            f->value[f->assign.at[i]->var->index] = expr_eval(f->assign.at[i]->value, f->value);
}

// The values that variables have once every assignment has been made, while the inputs read this.
static void compute(Finder *f)
{
    for (size_t v = 0; v < f->p->var.n; v++)
        if (f->p->var.at[v]->kind == VAR_LOCAL)
            f->value[v] = sm_cell_to_f64(f->p->var.at[v]->type, f->p->var.at[v]->init);
    assign(f, 0);
}

typedef struct Roots { double at[ROOTS]; uint32_t n; } Roots;

static void add_root(Roots *r, double x)
{
    if (!(x > -1e15 && x < 1e15))
        return;
    for (uint32_t i = 0; i < r->n; i++)
        if (sm_abs(r->at[i] - x) <= 1e-9 * sm_abs(x))
            return;
    if (r->n < ROOTS)
        r->at[r->n++] = x;
}

static double difference(const Finder *f, size_t c)
{
    return expr_eval(f->comparison.at[c].left, f->value) - expr_eval(f->comparison.at[c].right, f->value);
}

// Which assignments are repeated for a reading: another state, or an earlier step, can have stored its value long ago.
typedef enum Remembered { NOTHING, OTHER_STATES, EVERYTHING, REMEMBERED } Remembered;

static void find_differences(Finder *f, Remembered remembered, double *d)
{
    for (size_t c = 0; c < f->comparison.n; c++) {
        if (remembered == OTHER_STATES && (c == 0 || f->comparison.at[c].state != f->comparison.at[c - 1].state)) {
            memcpy(f->value, f->kept, f->p->var.n * sizeof *f->value);
            assign(f, f->comparison.at[c].state);
        }
        d[c] = difference(f, c);
    }
}

// set: gives the variable, or the group, that is varied the reading x.
static void find_roots(Finder *f, void (*set)(Finder *f, uint32_t which, double x), uint32_t which, uint32_t bit, Remembered remembered, Roots *out)
{
    static const double at[] = {-1e5, -40, 0, 1, 90, 3000, 1e5};
    enum { POINTS = sizeof at / sizeof *at };
    const size_t n = f->comparison.n;
    double *d = ARENA_ARRAY(f->arena, double, n * POINTS + 1);

    set(f, which, at[0]);
    compute(f);
    for (size_t k = 0; k < POINTS; k++) {
        set(f, which, at[k]);
        if (remembered == NOTHING)
            compute(f);
        memcpy(f->kept, f->value, f->p->var.n * sizeof *f->value);
        find_differences(f, remembered, d + k * n);
        memcpy(f->value, f->kept, f->p->var.n * sizeof *f->value);
    }
    for (size_t c = 0; c < n; c++) {
        memset(f->bits, 0, f->words * sizeof *f->bits);
        if (bit != IR_NONE) {
            bits_of(f, f->comparison.at[c].left, f->data, f->bits);
            bits_of(f, f->comparison.at[c].right, f->data, f->bits);
        }
        for (size_t k = 1; k < POINTS && (bit == IR_NONE || has_bit(f->bits, bit)); k++) {
            const double d0 = d[(k - 1) * n + c], d1 = d[k * n + c];
            if (d0 != d1)
                add_root(out, at[k - 1] - d0 * (at[k] - at[k - 1]) / (d1 - d0));
        }
    }
}

static void set_alone(Finder *f, uint32_t input, double x)
{
    for (uint32_t i = 0; i < f->t->inputs; i++)
        f->value[f->t->input[i].v->index] = 0;
    f->value[f->p->g->index] = f->value[f->p->t->index] = 0;
    f->value[f->t->input[input].v->index] = x;
}

static void set_group(Finder *f, uint32_t input, double x)
{
    set_alone(f, input, x);
    for (uint32_t i = 0; i < f->t->inputs; i++)
        if (f->t->input[i].group == f->t->input[input].group)
            f->value[f->t->input[i].v->index] = x;
}

// G and T are the same as long as the machine has only begun; a time that was stored is 0.
static void set_time(Finder *f, uint32_t which, double x)
{
    (void)which;
    for (uint32_t i = 0; i < f->t->inputs; i++)
        f->value[f->t->input[i].v->index] = 0;
    f->value[f->p->g->index] = f->value[f->p->t->index] = x;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

static void add_reading(TrialInput *i, double x)
{
    const SmType type = i->v->type;

    x = sm_cell_to_f64(type, sm_cell_from_f64(type, x));
    for (uint32_t k = 0; k < i->readings; k++)
        if (i->reading[k] == x)
            return;
    i->reading[i->readings++] = x;
}

static void find_readings(Finder *f, uint32_t input)
{
    TrialInput *i = &f->t->input[input];
    const bool whole = sm_type_info[i->v->type].kind != SM_KIND_FLOAT;
    Roots r = {{0}, 0};

    i->reading = ARENA_ARRAY(f->arena, double, 3 * ROOTS + 16);
    find_roots(f, set_alone, input, input, NOTHING, &r);
    if (i->v->type == SM_BOOL)
        r.n = 0;
    else
        for (int remembered = 0; remembered < REMEMBERED; remembered++)
            find_roots(f, set_group, input, input, (Remembered)remembered, &r);
    qsort(r.at, r.n, sizeof *r.at, ascending);
    i->rough = !i->v->range && r.n == 0;
    i->scale = i->v->range ? i->hi - i->lo : r.n > 1 ? r.at[r.n - 1] - r.at[0] : r.n == 1 && r.at[0] != 0 ? sm_abs(r.at[0]) : 1;
    if (i->v->range) {
        add_reading(i, i->lo);
        add_reading(i, i->hi);
        add_reading(i, (i->lo + i->hi) / 2);
    }
    for (uint32_t k = 0; k < r.n; k++) {
        if (k == 0)
            add_reading(i, r.at[0] - 0.5 * i->scale - 1);
        if (whole || i->command)
            add_reading(i, r.at[k]);
        add_reading(i, k + 1 < r.n ? (r.at[k] + r.at[k + 1]) / 2 : r.at[k] + 0.5 * i->scale + 1);
    }
    add_reading(i, 0);
    if (i->v->type == SM_BOOL || r.n == 0)
        add_reading(i, 1);
    if (!i->v->range && r.n > 0) {
        add_reading(i, r.at[0] - 20 * i->scale - 20);
        add_reading(i, r.at[r.n - 1] + 20 * i->scale + 20);
    }
    if (i->rough && i->v->type != SM_BOOL)
        for (double x = 30; x < 1e5; x *= 30)
            add_reading(i, x);
    qsort(i->reading, i->readings, sizeof *i->reading, ascending);
}

static void find_waits(Finder *f)
{
    Roots r = {{0}, 0};
    Trials *t = f->t;

    find_roots(f, set_time, 0, IR_NONE, NOTHING, &r);
    find_roots(f, set_time, 0, IR_NONE, EVERYTHING, &r);
    qsort(r.at, r.n, sizeof *r.at, ascending);
    t->wait = ARENA_ARRAY(f->arena, double, ROOTS);
    for (uint32_t k = 0; k < r.n; k++)
        if (r.at[k] > 0 && r.at[k] < 1e12)
            t->wait[t->waits++] = sm_ceil(r.at[k]);
}

typedef struct Stamp { const Var *g; bool found; } Stamp;

static void look_for_time(Expr *e, void *context)
{
    Stamp *s = context;

    s->found |= e->kind == EX_VAR && e->var == s->g;
}

// Whether some local holds a time.
static bool stamps_time(Finder *f)
{
    Stamp s = {f->p->g, false};

    for (size_t i = 0; i < f->assign.n; i++)
        expr_walk(f->assign.at[i]->value, look_for_time, &s);
    return s.found;
}

// ---- counters ----

static bool is_count(const Stmt *s)
{
    const Expr *e = s->value;

    return e->kind == EX_BINARY && (e->op == SM_OP_ADD || e->op == SM_OP_SUB) &&
           ((e->arg[0]->kind == EX_VAR && e->arg[0]->var == s->var && expr_is_constant(e->arg[1])) ||
            (e->op == SM_OP_ADD && e->arg[1]->kind == EX_VAR && e->arg[1]->var == s->var && expr_is_constant(e->arg[0])));
}

// Whether every assignment to v sets a constant or counts, and one counts.
static bool is_counter(const Finder *f, const Var *v)
{
    bool counts = false;

    for (size_t i = 0; i < f->assign.n; i++)
        if (f->assign.at[i]->var == v) {
            if (!is_count(f->assign.at[i]) && !expr_is_constant(f->assign.at[i]->value))
                return false;
            counts |= is_count(f->assign.at[i]);
        }
    return counts;
}

static double *limits_of(Finder *f, const Var *v)
{
    VEC(double) limit = {NULL, 0, 0};

    for (size_t c = 0; c < f->comparison.n; c++)
        for (int side = 0; side < 2; side++) {
            const Expr *e = side ? f->comparison.at[c].right : f->comparison.at[c].left;
            const Expr *to = side ? f->comparison.at[c].left : f->comparison.at[c].right;
            if (e->kind == EX_VAR && e->var == v && expr_is_constant(to))
                vec_push(f->arena, &limit, const_eval(to));
        }
    f->t->count += limit.n;
    vec_push(f->arena, &limit, sm_from_bits(UINT64_C(0x7FF8000000000000)));
    return limit.at;
}

static void find_counters(Finder *f)
{
    for (size_t v = 0; v < f->p->var.n; v++) {
        const Var *var = f->p->var.at[v];
        if (var->written && var->type != SM_BOOL && f->t->a->m->var_of[v] != IR_NONE && is_counter(f, var))
            f->t->limit[f->t->a->m->var_of[v]] = limits_of(f, var);
    }
}

// ---- actuators ----

static int distinct(const double *at, uint32_t n)
{
    int count = 0;

    for (uint32_t i = 0; i < n; i++) {
        bool again = at[i] == 0;
        for (uint32_t k = 0; k < i; k++)
            again |= at[k] == at[i];
        count += !again;
    }
    return count;
}

// Percent lie far apart, codes close together or without zero.
static bool is_code(const Finder *f, uint32_t v)
{
    double least = 0, most = 0;

    for (uint32_t i = 0; i < f->given[v].n; i++) {
        least = sm_min(least, f->given[v].at[i]);
        most = sm_max(most, f->given[v].at[i]);
    }
    return distinct(f->given[v].at, f->given[v].n) >= 2 && most - least < 100 && sm_type_info[f->p->var.at[v]->type].kind != SM_KIND_FLOAT &&
           most != 100;
}

// How many there have been: it goes up by a constant, and back to 0.
static bool only_counts(const Finder *f, const Var *v)
{
    bool counts = false;

    for (size_t i = 0; i < f->assign.n; i++) {
        const Stmt *s = f->assign.at[i];
        if (s->var != v)
            continue;
        if (!(is_count(s) && s->value->op == SM_OP_ADD) && !(expr_is_constant(s->value) && const_eval(s->value) == 0))
            return false;
        counts |= is_count(s);
    }
    return counts;
}

// A value made of sensors drives something only where it is bounded, or where it is given levels too: an estimate is not.
static bool is_estimate(const Finder *f, const Var *v)
{
    bool made_of_sensors = false;

    for (size_t w = 0; w < f->words; w++)
        made_of_sensors |= f->data[v->index * f->words + w] != 0;
    return made_of_sensors && !f->bounded[v->index] && distinct(f->given[v->index].at, f->given[v->index].n) == 0;
}

// A bool that the machine writes; a number that is off at rest: an assignment, or the lower end of what it can be, makes it 0.  One that
// the machine compares is a value of its own: a code, a count, an estimate.
static bool is_actuator(const Finder *f, const Var *v)
{
    if (v->kind != VAR_ELEMENT || !v->written)
        return false;
    if (v->type == SM_BOOL)
        return true;
    if ((f->read[v->index] && !f->varied[v->index]) || only_counts(f, v))
        return false;
    return f->zeroed[v->index] && !is_estimate(f, v) && !(is_code(f, v->index) && !f->varied[v->index]);
}

// A copy of a local is what the local is.
static void note_copy(const StmtPlace *at, void *context)
{
    Finder *f = context;
    const Var *from = at->stmt->kind == ST_ASSIGN && at->stmt->value->kind == EX_VAR ? at->stmt->value->var : NULL;
    const uint32_t to = from ? at->stmt->var->index : 0;

    if (!from || from->kind != VAR_LOCAL || from->is_constant || from->index == to)
        return;
    f->varied[to] |= f->varied[from->index];
    f->zeroed[to] |= f->zeroed[from->index];
    for (uint32_t i = 0; i < f->given[from->index].n; i++)
        vec_push(f->arena, &f->given[to], f->given[from->index].at[i]);
}

// A value that is clamped to 0 at its lower end switches off, too.
static void note_lower_end(const StmtPlace *at, void *context)
{
    Finder *f = context;
    const StmtFact *fact = &f->t->a->stmt[at->stmt->number];

    if (at->stmt->kind == ST_ASSIGN && fact->reached && !expr_is_constant(at->stmt->value) && fact->value.lo > -1e6 && fact->value.hi < 1e6)
        f->bounded[at->stmt->var->index] = true;
    if (at->stmt->kind == ST_ASSIGN && f->varied[at->stmt->var->index] && fact->reached && fact->value.lo == 0 && fact->value.hi > 0 && fact->value.hi < 1e9)
        f->zeroed[at->stmt->var->index] = true;
}

static void find_actuators(Finder *f)
{
    each_place(f->arena, f->p, note_copy, f);
    each_place(f->arena, f->p, note_lower_end, f);
    for (size_t v = 0; v < f->p->var.n; v++)
        if (is_actuator(f, f->p->var.at[v]) && f->t->a->m->var_of[v] != IR_NONE)
            f->t->actuator[f->t->a->m->var_of[v]] = true;
}

// ---- what states depend on ----

static void note_relevant(const StmtPlace *at, void *context)
{
    Finder *f = context;
    bool *relevant = f->t->state[at->state->number - 1].relevant;

    if (!at->stmt->value)
        return;
    memset(f->bits, 0, f->words * sizeof *f->bits);
    bits_of(f, at->stmt->value, f->all, f->bits);
    for (uint32_t i = 0; i < f->t->inputs; i++)
        relevant[i] |= has_bit(f->bits, i);
}

void trial_find_inputs(Trials *t)
{
    Finder f = {.t = t, .arena = t->a->arena, .p = t->a->p};
    const size_t n = f.p->var.n;

    f.read = ARENA_ARRAY(f.arena, bool, n);
    f.zeroed = ARENA_ARRAY(f.arena, bool, n);
    f.bounded = ARENA_ARRAY(f.arena, bool, n);
    f.varied = ARENA_ARRAY(f.arena, bool, n);
    f.given = arena_array(f.arena, n, sizeof *f.given);
    f.value = ARENA_ARRAY(f.arena, double, n);
    f.kept = ARENA_ARRAY(f.arena, double, n);
    list_inputs(&f);
    spread(&f);
    each_place(f.arena, f.p, note_place, &f);
    find_groups(&f);
    for (uint32_t i = 0; i < t->inputs; i++)
        find_readings(&f, i);
    for (uint32_t i = 0; i < t->inputs; i++)
        if (t->input[i].group != i)
            t->input[i].scale = t->input[t->input[i].group].scale;
    find_waits(&f);
    t->stamped = stamps_time(&f);
    find_counters(&f);
    find_actuators(&f);
    for (size_t s = 0; s < f.p->state.n; s++)
        t->state[s].relevant = ARENA_ARRAY(f.arena, bool, t->inputs + 1);
    each_place(f.arena, f.p, note_relevant, &f);
    for (size_t s = 0; s < f.p->state.n; s++)
        for (uint32_t i = 0; i < t->inputs; i++)
            t->state[s].relevant[t->input[i].group] |= t->state[s].relevant[i];        // a group is moved by its first
}
