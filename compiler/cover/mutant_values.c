// SPDX-License-Identifier: Apache-2.0
#include "compiler/cover/mutant_values.h"

#include "stdlib/convert.h"

typedef struct ValueLists {
    Arena *arena;
    const Program *p;
    uint64_t delta_t;
    MutantValues *out;
} ValueLists;

static void add_number(Arena *arena, MutantNumbers *list, double x)
{
    for (uint32_t i = 0; i < list->n; i++)
        if (list->at[i] == x)
            return;
    if (x - x == 0)
        vec_push(arena, list, x);
}

// On which inputs each variable depends through assignments and windows, as a set: bit i stands for MutantValues.input[i], i < 64.
typedef struct Origins {
    ValueLists *k;
    uint64_t *of;             // by Var.index: the set of the variable
    uint64_t found;           // the set of the current expression
    Stmt *stmt;               // the statement whose expressions are visited
    bool changed;             // a set has grown in this round
} Origins;

static void add_origin(Expr *e, void *context)
{
    Origins *o = context;

    if (e->kind == EX_VAR)
        o->found |= o->of[e->var->index];
    if (e->kind == EX_ROLL)
        expr_walk(o->k->p->window.at[e->window].sample, add_origin, o);
}

static uint64_t origins_of(Origins *o, Expr *e)
{
    o->found = 0;
    expr_walk(e, add_origin, o);
    return o->found;
}

static void add_values_of(Origins *o, Expr *a, Expr *b)
{
    const uint64_t from = origins_of(o, a);

    if (!expr_is_constant(b) || b->kind == EX_ROLL)
        return;
    for (uint32_t i = 0; i < o->k->out->input.n && i < 64; i++)
        if (from >> i & 1)
            add_number(o->k->arena, &o->k->out->input.at[i].value, expr_constant_value(b));
}

static void collect_values(Expr *e, void *context)
{
    Origins *o = context;

    if (e->kind == EX_NUMBER)
        add_number(o->k->arena, &o->k->out->number, e->number);
    if (e->kind == EX_VAR && e->var->is_constant)
        add_number(o->k->arena, &o->k->out->number, sm_cell_to_f64(e->var->type, e->var->init));
    for (uint32_t i = 0; (e->kind == EX_CHAIN || (e->kind == EX_BINARY && e->op >= SM_OP_EQ && e->op <= SM_OP_GE)) && i + 1 < e->n; i++) {
        add_values_of(o, e->arg[i], e->arg[i + 1]);
        add_values_of(o, e->arg[i + 1], e->arg[i]);
    }
}

static void each_statement(const Stmts *list, void (*f)(Stmt *s, void *context), void *context)
{
    for (size_t i = 0; i < list->n; i++) {
        f(list->at[i], context);
        each_statement(&list->at[i]->then, f, context);
        each_statement(&list->at[i]->otherwise, f, context);
    }
}

static void each_statement_of(const Program *p, void (*f)(Stmt *s, void *context), void *context)
{
    for (size_t s = 0; s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            each_statement(&p->state.at[s]->block[b], f, context);
}

static void spread_origins(Stmt *s, void *context)
{
    Origins *o = context;
    uint64_t from;

    if (s->kind != ST_ASSIGN)
        return;
    from = origins_of(o, s->value);
    o->changed = o->changed || (from & ~o->of[s->var->index]);
    o->of[s->var->index] |= from;
}

static void collect_values_of_statement(Stmt *s, void *context)
{
    if (s->value)
        expr_walk(s->value, collect_values, context);
}

// Adds the values just below and just above each value of the list, and the middle of each two values.
static void add_neighbours(Arena *arena, MutantNumbers *list, SmType type)
{
    const uint32_t n = list->n;
    const bool is_float = type == SM_F32 || type == SM_F64;

    for (uint32_t i = 0; i < n; i++) {
        const double x = list->at[i], size = x < 0 ? -x : x, by = is_float ? 0.001 * (size > 1 ? size : 1) : 1;
        add_number(arena, list, x + by);
        add_number(arena, list, x - by);
        add_number(arena, list, x * 1.05);
        add_number(arena, list, x * 0.95);
        for (uint32_t other = 0; other < i; other++)
            add_number(arena, list, (x + list->at[other]) / 2);
    }
}

static void list_inputs(ValueLists *k)
{
    for (uint32_t i = 0; i < k->p->var.n; i++) {
        const Var *v = k->p->var.at[i];
        const bool is_input = v->kind == VAR_ELEMENT ? v != k->p->g && v != k->p->s && !v->written && v->read
            : v->kind == VAR_LOCAL && v->outside && !v->parameter;
        const MutantInput in = {.var = i, .type = v->type, .is_stored = v->kind == VAR_ELEMENT && v->written};
        if (is_input || (in.is_stored && v != k->p->s && v != k->p->g))
            vec_push(k->arena, &k->out->input, in);
        k->out->readings += is_input;
        if (v->kind == VAR_ELEMENT && v->written)
            vec_push(k->arena, &k->out->output, i);
    }
}

static void list_values(ValueLists *k)
{
    Origins o = {.k = k, .of = ARENA_ARRAY(k->arena, uint64_t, k->p->var.n)};

    for (uint32_t i = 0; i < k->out->input.n && i < 64; i++)
        o.of[k->out->input.at[i].var] |= UINT64_C(1) << i;
    do {
        o.changed = false;
        each_statement_of(k->p, spread_origins, &o);
    } while (o.changed);
    each_statement_of(k->p, collect_values_of_statement, &o);
    for (size_t i = 0; i < k->p->window.n; i++)
        expr_walk(k->p->window.at[i].sample, collect_values, &o);
    for (uint32_t i = 0; i < k->out->input.n; i++) {
        MutantInput *in = &k->out->input.at[i];
        if (in->type != SM_BOOL) {
            add_neighbours(k->arena, &in->value, in->type);
            add_number(k->arena, &in->value, 0);
        } else {
            in->value.n = 0;
            add_number(k->arena, &in->value, 0);
            add_number(k->arena, &in->value, 1);
        }
    }
}

static void add_hold(ValueLists *k, double steps)
{
    for (int by = -1; by <= 1; by++)
        if (steps + by >= 1 && steps + by <= (double)MUTANT_HOLD_MOST)
            vec_push(k->arena, &k->out->hold, (uint64_t)(steps + by));
}

static void list_durations(ValueLists *k)
{
    for (uint32_t i = 0; i < k->out->number.n; i++) {
        add_hold(k, k->out->number.at[i] / (double)k->delta_t);
        add_hold(k, k->out->number.at[i]);
    }
    for (size_t i = 0; i < k->p->window.n; i++)
        add_hold(k, k->p->window.at[i].size);
    add_hold(k, 2);
}

void mutant_values_list(Arena *arena, const Program *p, uint64_t delta_t, MutantValues *out)
{
    ValueLists k = {arena, p, delta_t, out};

    list_inputs(&k);
    list_values(&k);
    list_durations(&k);
}
