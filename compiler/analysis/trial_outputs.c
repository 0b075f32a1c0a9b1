// SPDX-License-Identifier: Apache-2.0
// Finds the machine's counters, and its outputs that drive something, such as a valve.
#include "compiler/analysis/trial_inputs.h"
#include "stdlib/math.h"

// ---- counters ----

// Whether the value of e does not change in a trial: it consists of constants and parameters.
static bool is_fixed(const Expr *e)
{
    bool fixed = expr_is_constant(e) || (e->kind == EX_VAR && e->var->parameter) || ((e->kind == EX_UNARY || e->kind == EX_BINARY) && e->n > 0);

    for (uint32_t i = 0; i < e->n && fixed; i++)
        fixed = is_fixed(e->arg[i]);
    return fixed;
}

// Whether the statement adds a fixed number to its own variable, or subtracts one.
static bool is_increment(const Stmt *s)
{
    const Expr *e = s->value;

    return e->kind == EX_BINARY && (e->op == SM_OP_ADD || e->op == SM_OP_SUB) &&
           ((e->arg[0]->kind == EX_VAR && e->arg[0]->var == s->var && is_fixed(e->arg[1])) ||
            (e->op == SM_OP_ADD && e->arg[1]->kind == EX_VAR && e->arg[1]->var == s->var && is_fixed(e->arg[0])));
}

// Whether every assignment to v stores a fixed value or adds one to v, and at least one adds.
static bool is_counter(const TrialFinder *f, const Var *v)
{
    bool counts = false;

    for (size_t i = 0; i < f->assign.n; i++)
        if (f->assign.at[i]->var == v) {
            if (!is_increment(f->assign.at[i]) && !is_fixed(f->assign.at[i]->value))
                return false;
            counts |= is_increment(f->assign.at[i]);
        }
    return counts;
}

// Returns the fixed values that v is compared with, followed by a NaN.
static double *limits_of(TrialFinder *f, const Var *v)
{
    VEC(double) limit = {NULL, 0, 0};

    for (size_t c = 0; c < f->comparison.n; c++)
        for (int side = 0; side < 2; side++) {
            const Comparison pair = f->comparison.at[c].pair;
            const Expr *e = side ? pair.b : pair.a, *to = side ? pair.a : pair.b;
            if (e->kind == EX_VAR && e->var == v && is_fixed(to))
                vec_push(f->arena, &limit, expr_eval(to, f->value));
        }
    f->t->count += limit.n;
    vec_push(f->arena, &limit, sm_from_bits(UINT64_C(0x7FF8000000000000)));
    return limit.at;
}

void trial_find_counters(TrialFinder *f)
{
    for (size_t v = 0; v < f->p->var.n; v++) {
        const Var *var = f->p->var.at[v];
        if (var->written && var->type != SM_BOOL && f->t->a->m->var_of[v] != IR_NONE && is_counter(f, var))
            f->t->limit[f->t->a->m->var_of[v]] = limits_of(f, var);
    }
}

// ---- actuators ----

static int count_distinct_nonzero(const double *at, uint32_t n)
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

// Whether the values assigned to v are codes, such as the number of a mode: several different constants of an integer type that differ by
// less than 100.  Levels of an output, such as percentages, differ by more or reach 100.
static bool is_code(const TrialFinder *f, uint32_t v)
{
    double least = 0, most = 0;

    for (uint32_t i = 0; i < f->constants[v].n; i++) {
        least = sm_min(least, f->constants[v].at[i]);
        most = sm_max(most, f->constants[v].at[i]);
    }
    return count_distinct_nonzero(f->constants[v].at, f->constants[v].n) >= 2 && most - least < 100 && most != 100 &&
           sm_type_info[f->p->var.at[v]->type].kind != SM_KIND_FLOAT;
}

// Whether v counts events: every assignment adds a constant to v or sets v to 0.
static bool is_event_count(const TrialFinder *f, const Var *v)
{
    bool counts = false;

    for (size_t i = 0; i < f->assign.n; i++) {
        const Stmt *s = f->assign.at[i];
        if (s->var != v)
            continue;
        if (!(is_increment(s) && s->value->op == SM_OP_ADD) && !(expr_is_constant(s->value) && expr_constant_value(s->value) == 0))
            return false;
        counts |= is_increment(s);
    }
    return counts;
}

// Whether v is an estimate computed from sensors: its values have no bounds, and no constant except 0 is assigned to it.
static bool is_estimate(const TrialFinder *f, const Var *v)
{
    bool from_sensors = false;

    for (size_t w = 0; w < f->words; w++)
        from_sensors |= f->data[v->index * f->words + w] != 0;
    return from_sensors && !f->bounded[v->index] && count_distinct_nonzero(f->constants[v->index].at, f->constants[v->index].n) == 0;
}

// Whether v is assumed to be an output that drives something, such as a valve: a bool element that the machine writes, or a number that
// some assignment sets to 0 (off).  A number is not an output if it is a code, a count or an estimate (see above), or if the machine reads
// it back and only assigns constants to it, because then it is a mode of the machine.
static bool is_actuator(const TrialFinder *f, const Var *v)
{
    if (v->kind != VAR_ELEMENT || !v->written)
        return false;
    if (v->type == SM_BOOL)
        return true;
    if ((f->read[v->index] && !f->varied[v->index]) || is_event_count(f, v))
        return false;
    return f->zeroed[v->index] && !is_estimate(f, v) && !(is_code(f, v->index) && !f->varied[v->index]);
}

// For an assignment `v = local`, copies the properties of the local's values to v: whether they vary, whether they can be 0, and which
// constants they can be.
static void copy_properties_of_local(const StmtLocation *at, void *context)
{
    TrialFinder *f = context;
    const Var *from = at->stmt->kind == ST_ASSIGN && at->stmt->value->kind == EX_VAR ? at->stmt->value->var : NULL;
    const uint32_t to = from ? at->stmt->var->index : 0;

    if (!from || from->kind != VAR_LOCAL || from->is_constant || from->index == to)
        return;
    f->varied[to] |= f->varied[from->index];
    f->zeroed[to] |= f->zeroed[from->index];
    for (uint32_t i = 0; i < f->constants[from->index].n; i++)
        vec_push(f->arena, &f->constants[to], f->constants[from->index].at[i]);
}

// Records whether an assigned value is bounded, and whether its lower bound is 0: then the assignment can switch the output off.
static void record_bounds(const StmtLocation *at, void *context)
{
    TrialFinder *f = context;
    const Stmt *stmt = at->stmt;
    const Fact value = f->t->a->stmt[stmt->number].value;

    if (stmt->kind != ST_ASSIGN || !f->t->a->stmt[stmt->number].reached)
        return;
    if (!expr_is_constant(stmt->value) && value.lo > -1e6 && value.hi < 1e6)
        f->bounded[stmt->var->index] = true;
    if (f->varied[stmt->var->index] && value.lo == 0 && value.hi > 0 && value.hi < 1e9)
        f->zeroed[stmt->var->index] = true;
}

void trial_find_actuators(TrialFinder *f)
{
    each_stmt_location(f->arena, f->p, copy_properties_of_local, f);
    each_stmt_location(f->arena, f->p, record_bounds, f);
    for (size_t v = 0; v < f->p->var.n; v++)
        if (is_actuator(f, f->p->var.at[v]) && f->t->a->m->var_of[v] != IR_NONE)
            f->t->actuator[f->t->a->m->var_of[v]] = true;
}
