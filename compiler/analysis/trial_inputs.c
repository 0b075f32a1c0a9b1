// SPDX-License-Identifier: Apache-2.0
// Finds the inputs of a machine, and for each variable the set of inputs that its value depends on.  The sets propagate through
// assignments to a fixed point: those in `data` only through assigned values, those in `all` also through the guards around assignments.
#include "compiler/analysis/trial_inputs.h"

#include <string.h>

#include "compiler/analysis/input_deps.h"
#include "stdlib/math.h"

// ---- dependencies ----

void trial_add_inputs(TrialFinder *f, const Expr *e, const uint64_t *of, uint64_t *to)
{
    for (uint32_t i = 0; i < e->n; i++)
        trial_add_inputs(f, e->arg[i], of, to);
    if (e->kind == EX_VAR && !e->var->is_constant)
        bitset_merge(to, of + e->var->index * f->words, f->words);
}

typedef struct InputPropagation { TrialFinder *f; bool grew; } InputPropagation;

// Adds to the sets of an assigned variable the inputs of the assigned value and of the guards.
static void propagate_store(const StmtLocation *at, void *context)
{
    InputPropagation *s = context;
    TrialFinder *f = s->f;
    const size_t to = at->stmt->kind == ST_ASSIGN ? at->stmt->var->index * f->words : 0;

    if (at->stmt->kind != ST_ASSIGN)
        return;
    memset(f->bits, 0, f->words * sizeof *f->bits);
    trial_add_inputs(f, at->stmt->value, f->data, f->bits);
    s->grew |= bitset_merge(f->data + to, f->bits, f->words);
    trial_add_inputs(f, at->stmt->value, f->all, f->bits);
    for (const Condition *when = at->when; when; when = when->outer)
        trial_add_inputs(f, when->stmt->value, f->all, f->bits);
    s->grew |= bitset_merge(f->all + to, f->bits, f->words);
}

// ---- inputs of the machine ----

static bool is_input(const TrialFinder *f, const Var *v)
{
    return v->kind == VAR_ELEMENT && !v->written && v->read && v != f->p->g && v != f->p->s && f->t->a->m->var_of[v->index] != IR_NONE;
}

static void list_inputs(TrialFinder *f)
{
    Trials *t = f->t;
    const InputDepsTable *deps = input_deps_of(t->a);

    t->input = ARENA_ARRAY(f->arena, TrialInput, f->p->var.n + 1);
    f->input_of = ARENA_ARRAY(f->arena, uint32_t, f->p->var.n);
    for (size_t v = 0; v < f->p->var.n; v++) {
        const Var *var = f->p->var.at[v];
        TrialInput *i;
        f->input_of[v] = IR_NONE;
        if (!is_input(f, var))
            continue;
        f->input_of[v] = t->inputs;
        i = &t->input[t->inputs];
        *i = (TrialInput){.v = var, .var = t->a->m->var_of[v], .command = !is_sensor(deps, var), .group = t->inputs};
        t->inputs++;
        i->lo = var->range ? var->range->lo : fact_of_type(var->type).lo;
        i->hi = var->range ? var->range->hi : fact_of_type(var->type).hi;
    }
    f->words = bitset_words(t->inputs);
    f->data = ARENA_ARRAY(f->arena, uint64_t, f->p->var.n * f->words);
    f->all = ARENA_ARRAY(f->arena, uint64_t, f->p->var.n * f->words);
    f->bits = ARENA_ARRAY(f->arena, uint64_t, f->words);
    for (size_t v = 0; v < f->p->var.n; v++)
        if (f->input_of[v] != IR_NONE) {
            bitset_add(f->data + v * f->words, f->input_of[v]);
            bitset_add(f->all + v * f->words, f->input_of[v]);
        }
}

// ---- comparisons ----

// Sets *computed if e is a variable that the machine writes.
static void mark_if_written(Expr *e, void *context)
{
    bool *is_written = context;

    *is_written |= e->kind == EX_VAR && e->var->written;
}

// Records the time that `held` compares the length of a run with.
static void record_run_time(TrialFinder *f, Comparison pair)
{
    if (pair.a->kind == EX_ROLL && pair.a->stat == SM_STAT_RUN_TIME && expr_is_constant(pair.b))
        f->t->run_time = sm_max(f->t->run_time, expr_constant_value(pair.b));
}

// Records the comparisons in e, the variables that it reads, and windows over variables that the machine writes.
static void record_uses_in_expr(Expr *e, void *context)
{
    TrialFinder *f = context;

    for (uint32_t i = 0; i < comparison_count(e); i++)
        vec_push(f->arena, &f->comparison, ((TrialComparison){comparison_at(e, i), f->state}));
    for (uint32_t i = 0; i < comparison_count(e); i++)
        record_run_time(f, comparison_at(e, i));
    for (uint32_t i = 1; e->kind == EX_CALL && i < e->n; i++)
        vec_push(f->arena, &f->comparison, ((TrialComparison){{e->arg[0], e->arg[i], SM_OP_COUNT}, f->state}));
    if (e->kind == EX_ROLL)
        expr_walk(e->arg[0], mark_if_written, &f->t->samples_written[f->t->a->m->window_of[e->window]]);
    if (e->kind == EX_VAR)
        f->read[e->var->index] = true;
}

// Records what a statement reads, and if it is an assignment, what it assigns.
static void record_uses_in_stmt(const StmtLocation *at, void *context)
{
    TrialFinder *f = context;

    f->state = at->state->number;
    if (at->stmt->value)
        expr_walk(at->stmt->value, record_uses_in_expr, f);
    if (at->stmt->kind != ST_ASSIGN)
        return;
    vec_push(f->arena, &f->assign, at->stmt);
    vec_push(f->arena, &f->assign_state, at->state->number);
    if (!expr_is_constant(at->stmt->value)) {
        f->varied[at->stmt->var->index] |= at->stmt->value->kind != EX_VAR || at->stmt->value->var->kind != VAR_LOCAL;
    } else {
        const double x = expr_constant_value(at->stmt->value);
        f->zeroed[at->stmt->var->index] |= x == 0;
        vec_push(f->arena, &f->constants[at->stmt->var->index], x);
    }
}

// ---- dependencies of states ----

// Marks the inputs that a statement of a state depends on as relevant for the state.
static void record_relevant_inputs(const StmtLocation *at, void *context)
{
    TrialFinder *f = context;
    bool *relevant = f->t->state[at->state->number - 1].relevant;

    if (!at->stmt->value)
        return;
    memset(f->bits, 0, f->words * sizeof *f->bits);
    trial_add_inputs(f, at->stmt->value, f->all, f->bits);
    for (uint32_t i = 0; i < f->t->inputs; i++)
        relevant[i] |= bitset_has(f->bits, i);
}

void trial_find_inputs(Trials *t)
{
    TrialFinder f = {.t = t, .arena = t->a->arena, .p = t->a->p};
    InputPropagation propagation = {&f, true};
    const size_t n = f.p->var.n;

    f.read = ARENA_ARRAY(f.arena, bool, n);
    f.zeroed = ARENA_ARRAY(f.arena, bool, n);
    f.bounded = ARENA_ARRAY(f.arena, bool, n);
    f.varied = ARENA_ARRAY(f.arena, bool, n);
    f.constants = arena_array(f.arena, n, sizeof *f.constants);
    f.value = ARENA_ARRAY(f.arena, double, n);
    f.saved = ARENA_ARRAY(f.arena, double, n);
    list_inputs(&f);
    for (int round = 0; propagation.grew && round < 16; round++) {
        propagation.grew = false;
        each_stmt_location(f.arena, f.p, propagate_store, &propagation);
    }
    each_stmt_location(f.arena, f.p, record_uses_in_stmt, &f);
    trial_find_groups(&f);
    trial_find_readings(&f);
    trial_find_waits(&f);
    trial_find_counters(&f);
    trial_find_actuators(&f);
    for (size_t s = 0; s < f.p->state.n; s++)
        t->state[s].relevant = ARENA_ARRAY(f.arena, bool, t->inputs + 1);
    each_stmt_location(f.arena, f.p, record_relevant_inputs, &f);
    for (size_t s = 0; s < f.p->state.n; s++)
        for (uint32_t i = 0; i < t->inputs; i++)
            t->state[s].relevant[t->input[i].group] |= t->state[s].relevant[i];        // the first input of a group represents the group
}
