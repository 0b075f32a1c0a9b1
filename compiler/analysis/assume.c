// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/assume.h"

Fact fact_of_number(SmF64 x) { return fact_of_cell(SM_F64, sm_bits(x)); }

Fact fact_of_range(SmF64 lo, SmF64 hi)
{
    Fact f = fact_of_type(SM_F64);

    f.lo = fact_of_number(lo).lo;
    f.hi = fact_of_number(hi).hi;
    return f;
}

const Env *suppose(const Analysis *a, const Env *env, const Var *v, Fact f)
{
    const uint32_t var = a->m->var_of[v->index];

    f.nan = false;
    return var == IR_NONE ? env : env_set(&a->facts->shape, env, var, fact_convert(f, v->type));
}

// ---- guards ----

typedef struct Answer {
    const IrFn *f;
    const Env *env[2];            // the facts where the guard is false, and where it is true
    bool possible[2];
} Answer;

static void note_answer(void *context, const IrJump *end, const Env *env)
{
    Answer *out = context;
    const bool holds = end == &out->f->blk.at[1].jump;

    out->env[holds] = env;
    out->possible[holds] = true;
}

static Answer ask(const Analysis *a, const IrFn *f, const Env *env)
{
    Answer out = {f, {NULL, NULL}, {false, false}};
    const FactEnds ends = {note_answer, &out};

    facts_flow(a->facts, f, env, &ends);
    return out;
}

// Evaluates the guard twice: for `p > 20 and p < 10`, the second pass starts from what the first half leaves possible.
static bool suppose_function(const Analysis *a, const Env **env, const IrFn *f, bool holds)
{
    Answer first = ask(a, f, *env), second;

    if (!first.possible[holds])
        return false;
    second = ask(a, f, first.env[holds]);
    if (!second.possible[holds])
        return false;
    *env = second.env[holds];
    return true;
}

bool suppose_guard(const Analysis *a, const Env **env, const Expr *guard, bool holds)
{
    return suppose_function(a, env, ir_build_guard(a->arena, a->m, guard), holds);
}

// The function of a statement is built once, because what-if questions are frequent.
static const IrFn *function_of(const Analysis *a, const Stmt *stmt)
{
    if (!a->asked[stmt->number])
        a->asked[0] = a->asked[stmt->number] = ir_build_guard(a->arena, a->m, stmt->value);
    return a->asked[stmt->number];
}

bool suppose_condition(const Analysis *a, const Env **env, const Condition *when)
{
    const Env *was = *env;

    for (; when; when = when->outer)
        if (!suppose_function(a, env, function_of(a, when->stmt), when->holds)) {
            *env = was;
            return false;
        }
    return true;
}

static Fact value_of(const Analysis *a, const Env *env, const IrFn *f)
{
    const FactFlow flow = facts_of_function(a->facts, f, env);
    const IrIns *cond = &f->ins.at[f->blk.at[0].jump.cond];

    return flow.of[cond->op == IR_cvt ? cond->a : f->blk.at[0].jump.cond];
}

Fact suppose_value(const Analysis *a, const Env *env, const Expr *e)
{
    if (e->kind == EX_VAR && a->m->var_of[e->var->index] != IR_NONE)       // the most frequent case, which needs no function
        return env_get(&a->facts->shape, env, a->m->var_of[e->var->index]);
    return value_of(a, env, ir_build_guard(a->arena, a->m, e));
}

// ---- sensors ----

Analysis suppose_ranges(const Analysis *a)
{
    Analysis out = *a;
    const Env *env = NULL;

    for (size_t i = 0; i < a->p->var.n; i++) {
        const Var *v = a->p->var.at[i];
        if (v->range && !v->written)
            env = suppose(a, env, v, fact_of_range(v->range->lo, v->range->hi));
    }
    if (env)
        out.facts = facts_assuming(a->arena, a->m, env);
    return out;
}
