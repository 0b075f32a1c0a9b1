// SPDX-License-Identifier: Apache-2.0
// The inputs that a value depends on are a set with a bit for each input.  The sets propagate through variables to a fixed
// point: `data` through values alone, `all` also through the guards of assignments.
#include "compiler/analysis/trial_inputs.h"

#include <string.h>

#include "compiler/analysis/input_deps.h"

// ---- dependencies ----

typedef struct Sum { const uint64_t *of; size_t words; uint64_t *to; } Sum;

static void add_bits(Expr *e, void *context)
{
    Sum *s = context;

    if (e->kind == EX_VAR && !e->var->is_constant)
        for (size_t w = 0; w < s->words; w++)
            s->to[w] |= s->of[e->var->index * s->words + w];
}

void trial_add_bits(Finder *f, const Expr *e, const uint64_t *of, uint64_t *to)
{
    Sum s = {of, f->words, to};

    expr_walk((Expr *)e, add_bits, &s);
}

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
    trial_add_bits(f, at->stmt->value, f->data, f->bits);
    s->more |= merge(f, f->data + to, f->bits);
    trial_add_bits(f, at->stmt->value, f->all, f->bits);
    for (const Condition *when = at->when; when; when = when->outer)
        trial_add_bits(f, when->stmt->value, f->all, f->bits);
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

// ---- comparisons ----

static void note_computed(Expr *e, void *context)
{
    bool *computed = context;

    *computed |= e->kind == EX_VAR && e->var->written;
}

static void note_comparison(Expr *e, void *context)
{
    Finder *f = context;

    if (e->kind == EX_CHAIN || (e->kind == EX_BINARY && is_comparison(e->op)))
        for (uint32_t i = 1; i < e->n; i++)
            vec_push(f->arena, &f->comparison, ((Comparison){e->arg[i - 1], e->arg[i], e->kind == EX_CHAIN ? expr_ops(e)[i - 1] : e->op, f->state}));
    if (e->kind == EX_CALL && e->n > 1)
        for (uint32_t i = 1; i < e->n; i++)
            vec_push(f->arena, &f->comparison, ((Comparison){e->arg[0], e->arg[i], SM_OP_COUNT, f->state}));
    if (e->kind == EX_ROLL)
        expr_walk(e->arg[0], note_computed, &f->t->computed[f->t->a->m->window_of[e->window]]);
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
        const double x = expr_constant_value(at->stmt->value);
        f->zeroed[at->stmt->var->index] |= x == 0;
        vec_push(f->arena, &f->given[at->stmt->var->index], x);
    }
}

// ---- dependencies of states ----

static void note_relevant(const StmtPlace *at, void *context)
{
    Finder *f = context;
    bool *relevant = f->t->state[at->state->number - 1].relevant;

    if (!at->stmt->value)
        return;
    memset(f->bits, 0, f->words * sizeof *f->bits);
    trial_add_bits(f, at->stmt->value, f->all, f->bits);
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
    trial_find_groups(&f);
    trial_find_readings(&f);
    trial_find_waits(&f);
    trial_find_counters(&f);
    trial_find_actuators(&f);
    for (size_t s = 0; s < f.p->state.n; s++)
        t->state[s].relevant = ARENA_ARRAY(f.arena, bool, t->inputs + 1);
    each_place(f.arena, f.p, note_relevant, &f);
    for (size_t s = 0; s < f.p->state.n; s++)
        for (uint32_t i = 0; i < t->inputs; i++)
            t->state[s].relevant[t->input[i].group] |= t->state[s].relevant[i];        // the first input of a group moves the whole group
}
