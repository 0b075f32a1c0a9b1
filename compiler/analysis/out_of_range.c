// SPDX-License-Identifier: Apache-2.0
// Reports stored values that do not fit the type of their variable: constants, and computed values that never fit.
#include "compiler/analysis/analysis.h"

#include "stdlib/convert.h"
#include "stdlib/math.h"

static bool is_finite(SmF64 x) { return sm_eq(sm_sub(x, x), sm_from_i32(0)); }

// ---- constants ----

static void report_stored_value(Analysis *a, DiagCode code, Span span, const Var *v, SmF64 stored, SmF64 x)
{
    diag_report(a->diags, code, span, v->name->text, sm_type_info[v->type].spelling, const_text(a->arena, stored),
                const_text(a->arena, x));
}

// Reports a constant that the variable's type cannot store as it is.
static void check_constant(Analysis *a, const Var *v, const Expr *value)
{
    const bool whole = sm_type_info[v->type].kind != SM_KIND_FLOAT;
    const SmF64 x = expr_constant_value(value), stored = sm_cell_to_f64(v->type, sm_cell_from_f64(v->type, x));

    if (sm_is_nan(x))
        diag_report(a->diags, DIAG_stores_nan, value->span, v->name->text);
    else if (whole && !sm_eq(x, stored) && sm_eq(sm_trunc(x), stored))
        report_stored_value(a, DIAG_stores_whole, value->span, v, stored, x);
    else if (!sm_eq(x, stored) && (whole || !is_finite(stored)))
        report_stored_value(a, DIAG_stores_limit, value->span, v, stored, x);
}

// ---- computed values ----

// Whether all values of f are above the largest value of the type, or all are below the smallest.  A value that only loses its fraction
// fits.
static bool never_fits(Fact f, SmType type)
{
    const Fact t = fact_of_type(type);
    Fact stored;

    if (f.lo >= t.lo && f.hi <= t.hi && type != SM_F32)
        return false;
    stored = fact_convert(f, type);
    if (f.nan || f.lo > f.hi || stored.lo != stored.hi)
        return false;
    if (type == SM_F32)
        return !is_finite(stored.lo) && is_finite(stored.lo > 0 ? f.lo : f.hi);
    return sm_trunc(f.lo) > t.hi || sm_trunc(f.hi) < t.lo;
}

static void check_computed(Analysis *a, const Stmt *stmt)
{
    const StmtFact *fact = &a->stmt[stmt->number];
    const SmType type = stmt->var->type;
    const char *lo, *bounds;
    SmF64 stored;

    if (!fact->reached || !never_fits(fact->value, type))
        return;
    stored = sm_cell_to_f64(type, sm_cell_from_f64(type, fact->value.lo));
    lo = const_text(a->arena, fact->value.lo);
    bounds = fact->value.lo == fact->value.hi ? lo : format_in(a->arena, "from %s to %s", lo, const_text(a->arena, fact->value.hi));
    diag_report(a->diags, DIAG_always_saturates, stmt->value->span, stmt->var->name->text, sm_type_info[type].spelling,
                const_text(a->arena, stored), bounds);
}

// ---- entry points ----

static void check_stmt(const Stmt *stmt, void *context)
{
    if (stmt->kind != ST_ASSIGN || sm_type_info[stmt->var->type].kind == SM_KIND_BOOL)
        return;
    if (!stmt->varies && expr_is_constant(stmt->value))
        check_constant(context, stmt->var, stmt->value);
    else
        check_computed(context, stmt);
}

void analyse_out_of_range(Analysis *a)
{
    const Program *p = a->p;

    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (v->init_value && sm_type_info[v->type].kind != SM_KIND_BOOL)
            check_constant(a, v, v->init_value);
    }
    each_stmt(p, check_stmt, a);
}
