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

// Returns env with v limited to f (converted to v's type; never NaN).
const Env *assume_fact(const Analysis *a, const Env *env, const Var *v, Fact f)
{
    const uint32_t var = a->m->var_of[v->index];

    f.nan = false;
    return var == IR_NONE ? env : env_set(&a->facts->shape, env, var, fact_convert(f, v->type));
}

// ---- guards ----

typedef struct GuardFacts {
    const IrFn *f;
    bool holds;                   // the assumed value of the guard
    bool possible;                // the guard can have this value
    const Env *env;               // the facts if the guard has this value
} GuardFacts;

// Called for both ends of the guard's function (ir_build_guard): block 1 is the end for a true guard.
static void record_result(void *context, const IrJump *end, const Env *env)
{
    GuardFacts *out = context;

    if (out->holds == (end == &out->f->blk.at[1].jump)) {
        out->env = env;
        out->possible = true;
    }
}

// Computes the facts of the guard twice; the second time begins with the results of the first.  An operand of `and` can restrict a variable
// of an earlier operand: in `p > q and q > 5`, p > 5 follows only the second time.
bool assume_guard(const Analysis *a, const Env **env, const Expr *guard, bool holds)
{
    GuardFacts out = {.f = ir_build_guard(a->arena, a->m, guard), .holds = holds, .env = *env};
    const FactEnds ends = {record_result, &out, .all = true};

    for (int pass = 0; pass < 2; pass++) {
        out.possible = false;
        facts_flow(a->facts, out.f, out.env, &ends);
        if (!out.possible)
            return false;
    }
    *env = out.env;
    return true;
}

// Returns the possible values of an expression if the facts env are true; for a condition, as the fact of a bool.
Fact fact_of_expr(const Analysis *a, const Env *env, const Expr *e)
{
    const IrFn *f;
    const IrIns *cond;

    if (e->kind == EX_VAR && a->m->var_of[e->var->index] != IR_NONE)       // a shortcut for the most frequent case
        return env_get(&a->facts->shape, env, a->m->var_of[e->var->index]);
    f = ir_build_guard(a->arena, a->m, e);
    cond = &f->ins.at[f->blk.at[0].jump.cond];
    return facts_of_function(a->facts, f, env).of[cond->op == IR_cvt ? cond->a : f->blk.at[0].jump.cond];
}

// ---- sensors ----

// Returns a copy of *a whose facts assume that every sensor always stays in its @range.
Analysis assume_ranges(const Analysis *a)
{
    Analysis out = *a;
    const Env *env = NULL;

    for (size_t i = 0; i < a->p->var.n; i++) {
        const Var *v = a->p->var.at[i];
        if (v->range && !v->written)
            env = assume_fact(a, env, v, fact_of_range(v->range->lo, v->range->hi));
    }
    if (env)
        out.facts = facts_assuming(a->arena, a->m, env);
    return out;
}
