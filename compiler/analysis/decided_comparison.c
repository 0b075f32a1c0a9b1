// SPDX-License-Identifier: Apache-2.0
// Reports comparisons with the same result for all values of the operands' types, such as `u8 < 300`, and equalities with a value that
// the type cannot represent.  If only the facts about its variables decide a guard, constant_guard.c reports it.
#include "compiler/analysis/decided_comparison.h"

#include "compiler/analysis/assume.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

// Returns the possible values of an expression by types alone.
Fact fact_of_types(const Analysis *a, const Expr *e)
{
    return fact_of_expr(a, facts_at_begin_of_sample(a->facts), e);
}

// ---- the operands ----

typedef struct Operand { const Expr *e; Fact fact; bool is_constant; } Operand;

// Returns the operand e with its possible values by types alone.
static Operand operand_of(const Analysis *a, const Expr *e)
{
    Operand s = {.e = e, .is_constant = expr_is_constant(e)};

    s.fact = s.is_constant ? fact_of_number(expr_constant_value(e)) : e->kind == EX_VAR && e->var->written ? fact_of_type(e->var->type)
                                                                                                  : fact_of_types(a, e);
    s.is_constant |= s.fact.lo == s.fact.hi && !s.fact.nan;
    return s;
}

typedef struct TypedComparison {
    Operand a, b;             // the operands; if one operand is a constant, it is b
    SmOperator op;
    const Expr *whole;        // the expression that is the comparison, or the chain of comparisons (as a < b < c) that contains it
    const Expr *within;       // the `and` of which `whole` is an operand; or NULL
    Truth truth;
} TypedComparison;

// Called if the types decide p.  Whether p is an equality with a number within the bounds of the other operand, which the type of that
// operand cannot represent.
static bool is_equality_with_unrepresentable(const TypedComparison *p)
{
    return (p->op == SM_OP_EQ || p->op == SM_OP_NE) && p->b.is_constant && p->b.fact.lo >= p->a.fact.lo &&
           p->b.fact.lo <= p->a.fact.hi;
}

// Whether both bounds are finite (the difference of an infinity and itself is NaN).
static bool is_bounded(Fact f) { return f.lo - f.lo == 0 && f.hi - f.hi == 0; }

// Fills in the operands, operator and result of *p for the comparison c.  Returns whether the result is the same for all values of the
// operands' types.
static bool find_decision_by_types(const Analysis *a, const Comparison *c, TypedComparison *p)
{
    Fact result;

    p->a = operand_of(a, c->a);
    p->b = operand_of(a, c->b);
    p->op = c->op;
    if (p->a.is_constant) {
        const Operand was = p->a;
        p->a = p->b;
        p->b = was;
        p->op = comparison_swapped(c->op);
    }
    if (p->a.is_constant || p->b.fact.nan)
        return false;
    result = fact_of_comparison(p->op, p->a.fact, p->b.fact);
    p->truth = result.lo == 1 ? ALWAYS : result.hi == 0 ? NEVER : SOMETIMES;
    return p->truth != SOMETIMES && (is_bounded(p->a.fact) || is_equality_with_unrepresentable(p));
}

// ---- ranges ----

static bool is_upper_bound(SmOperator op) { return op == SM_OP_LT || op == SM_OP_LE; }

// Whether the comparison is one half of a range check, as `n >= 0` in `n >= 0 and n <= 100`: the other operand of the `and` bounds the
// same variable from the other side.
static bool is_half_of_range(const TypedComparison *p)
{
    if (!p->within || p->a.e->kind != EX_VAR)
        return false;
    for (int k = 0; k < 2; k++) {
        const Expr *other = p->within->arg[k];
        if (other == p->whole || other->kind != EX_BINARY || sm_op_info[other->op].op_class != SM_CLASS_RELATION)
            continue;
        for (int side = 0; side < 2; side++)
            if (other->arg[side]->kind == EX_VAR && other->arg[side]->var == p->a.e->var &&
                is_upper_bound(side ? comparison_swapped(other->op) : other->op) != is_upper_bound(p->op))
                return true;
    }
    return false;
}

// ---- reports ----

static const char *never_or_always(const TypedComparison *p) { return p->truth == NEVER ? "never" : "always"; }

static void report_equality_with_unrepresentable(const Analysis *a, const TypedComparison *p)
{
    const SmF64 x = sm_from_bits(sm_bits(p->b.fact.lo));
    const char *number = const_text(a->arena, x);
    Diag *d;

    if (p->a.fact.whole) {
        diag_report(a->diags, DIAG_equals_fraction, p->whole->span, never_or_always(p), source_text(a->arena, p->a.e->span), number);
        return;
    }
    d = diag_report(a->diags, DIAG_equals_no_f32, p->whole->span, never_or_always(p), source_text(a->arena, p->a.e->span), number);
    diag_label(a->diags, d, DIAG_label_nearest_f32, const_text(a->arena, sm_from_f32(sm_round_f32(x))));
}

// Reports a comparison that types decide.  The diagnostic shows the bounds of a variable's type, or the possible values of another
// expression.
static void report_decided_by_types(const Analysis *a, const TypedComparison *p)
{
    const Expr *e = p->a.e;
    const SmF64 zero = sm_from_i32(0);                        // adding `zero` turns -0 into 0
    const char *lo = const_text(a->arena, sm_add(p->a.fact.lo, zero)), *hi = const_text(a->arena, sm_add(p->a.fact.hi, zero));

    if (e->kind == EX_VAR && !e->var->parameter) {
        if (sm_type_info[e->var->type].kind != SM_KIND_BOOL) {
            const SmType t = e->var->type;
            lo = const_text(a->arena, sm_cell_to_f64(t, sm_cell_from_f64(t, p->a.fact.lo)));
            hi = const_text(a->arena, sm_cell_to_f64(t, sm_cell_from_f64(t, p->a.fact.hi)));
        }
        diag_report(a->diags, p->truth == NEVER ? DIAG_never_holds : DIAG_always_holds, p->whole->span, e->var->name->text,
                    sm_type_info[e->var->type].spelling, lo, hi);
        return;
    }
    diag_report(a->diags, DIAG_types_decide, p->whole->span, never_or_always(p), source_text(a->arena, e->span), lo, hi);
}

// ---- expressions ----

// Returns whether types decide some comparison in e (decided_comparison.h), and reports each such comparison if `report`.  `within`: the
// `and` whose operand e is; or NULL.
// Recursion depth equals the nesting of expressions, which AST_DEPTH_MAX bounds.
static bool check_comparisons(const Analysis *a, const Expr *e, const Expr *within, bool report)
{
    const Expr *both = e->kind == EX_BINARY && e->op == SM_OP_AND ? e : NULL;
    bool found = false;

    for (uint32_t i = 0; i < comparison_count(e); i++) {
        const Comparison c = comparison_at(e, i);
        TypedComparison p = {.whole = e, .within = within};
        if (!find_decision_by_types(a, &c, &p))
            continue;
        if (p.truth == ALWAYS && (e->kind == EX_CHAIN || is_half_of_range(&p)))       // usual style, not a mistake: 0 <= x <= 100
            continue;
        found = true;
        if (report && is_equality_with_unrepresentable(&p))
            report_equality_with_unrepresentable(a, &p);
        else if (report)
            report_decided_by_types(a, &p);
    }
    for (uint32_t i = 0; i < e->n; i++)
        found |= check_comparisons(a, e->arg[i], both, report);
    return found;
}

bool has_comparison_decided_by_types(const Analysis *a, const Expr *e) { return check_comparisons(a, e, NULL, false); }

static void check_stmt(const Stmt *stmt, void *context)
{
    if (stmt->operators & COMPARISONS)
        check_comparisons(context, stmt->value, NULL, true);
}

void analyse_decided_comparison(Analysis *a)
{
    for (size_t i = 0; i < a->p->var.n; i++)
        if (a->p->var.at[i]->init_value)
            check_comparisons(a, a->p->var.at[i]->init_value, NULL, true);
    each_stmt(a->p, check_stmt, a);
}
