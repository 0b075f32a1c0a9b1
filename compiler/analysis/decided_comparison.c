// SPDX-License-Identifier: Apache-2.0
// Comparisons that types decide, whatever the values, and equalities with a value that the type cannot represent.  Facts decide
// guards too, but that is not a mistake in the comparison: see constant-guard.
#include "compiler/analysis/decided_comparison.h"

#include "compiler/analysis/assume.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

Fact fact_of_types(const Analysis *a, const Expr *e)
{
    return suppose_value(a, facts_begin_sample(a->facts), e);
}

// ---- operators ----

typedef enum Answer { SOMETIMES, NEVER, ALWAYS } Answer;

static IrOp op_of(SmOperator op)
{
    switch ((int)op) {
    case SM_OP_LT: return IR_lt;
    case SM_OP_LE: return IR_le;
    case SM_OP_GT: return IR_gt;
    case SM_OP_GE: return IR_ge;
    case SM_OP_EQ: return IR_eq;
    }
    return IR_ne;
}

static Answer answer_of(SmOperator op, Fact a, Fact b)
{
    const IrIns i = {.op = op_of(op), .type = SM_BOOL};
    const Fact f = fact_of_result(&i, &a, &b, SM_F64);

    return f.lo == 1 ? ALWAYS : f.hi == 0 ? NEVER : SOMETIMES;
}

// ---- the operands ----

typedef struct Side { const Expr *e; Fact fact; bool is_constant; } Side;

static Side side_of(const Analysis *a, const Expr *e)
{
    Side s = {.e = e, .is_constant = expr_is_constant(e)};

    s.fact = s.is_constant ? fact_of_number(expr_constant_value(e)) : e->kind == EX_VAR && e->var->written ? fact_of_type(e->var->type)
                                                                                                  : fact_of_types(a, e);
    s.is_constant |= s.fact.lo == s.fact.hi && !s.fact.nan;
    return s;
}

typedef struct Pair {
    Side a, b;                // b is the constant if one is
    SmOperator op;
    const Expr *whole;        // the comparison, or the chain that it is part of
    const Expr *within;       // the `and` that it is one operand of; or NULL
    Answer answer;
} Pair;

// An equality that the bounds alone would allow.  It is never true because the type has no such number.
static bool is_no_such_number(const Pair *p)
{
    return (p->op == SM_OP_EQ || p->op == SM_OP_NE) && p->b.is_constant && p->b.fact.lo >= p->a.fact.lo &&
           p->b.fact.lo <= p->a.fact.hi;
}

// Whole numbers of limited types.  Unbounded values are decided by arithmetic, if at all.
static bool is_bounded(Fact f) { return f.lo - f.lo == 0 && f.hi - f.hi == 0; }

static bool make_pair(const Analysis *a, Pair *p, const Expr *x, SmOperator op, const Expr *y)
{
    p->a = side_of(a, x);
    p->b = side_of(a, y);
    p->op = op;
    if (p->a.is_constant) {
        const Side was = p->a;
        p->a = p->b;
        p->b = was;
        p->op = relation_mirrored(op);
    }
    p->answer = p->a.is_constant || p->b.fact.nan ? SOMETIMES : answer_of(p->op, p->a.fact, p->b.fact);
    return p->answer != SOMETIMES && (is_bounded(p->a.fact) || is_no_such_number(p));
}

// ---- idioms ----

static bool is_upper(SmOperator op) { return op == SM_OP_LT || op == SM_OP_LE; }

// `n >= 0` in `n >= 0 and n <= 100`: the other operand bounds the same variable from the other side.
static bool is_half_of_range(const Pair *p)
{
    if (!p->within || p->a.e->kind != EX_VAR)
        return false;
    for (int k = 0; k < 2; k++) {
        const Expr *other = p->within->arg[k];
        if (other == p->whole || other->kind != EX_BINARY || sm_op_info[other->op].op_class != SM_CLASS_RELATION)
            continue;
        for (int side = 0; side < 2; side++)
            if (other->arg[side]->kind == EX_VAR && other->arg[side]->var == p->a.e->var &&
                is_upper(side ? relation_mirrored(other->op) : other->op) != is_upper(p->op))
                return true;
    }
    return false;
}

// In a chain, a comparison that is always true is an idiom (0 <= x <= 100); one that is never true is a mistake.
static bool is_habit(const Pair *p)
{
    return p->answer == ALWAYS && (p->whole->kind == EX_CHAIN || is_half_of_range(p));
}

// ---- reports ----

static const char *how_often(const Pair *p) { return p->answer == NEVER ? "never" : "always"; }

static void report_no_such_number(const Analysis *a, const Pair *p)
{
    const SmF64 x = sm_from_bits(sm_bits(p->b.fact.lo));
    const char *number = const_text(a->arena, x);
    Diag *d;

    if (p->a.fact.whole) {
        diag_report(a->diags, DIAG_equals_fraction, p->whole->span, how_often(p), source_text(a->arena, p->a.e->span), number);
        return;
    }
    d = diag_report(a->diags, DIAG_equals_no_f32, p->whole->span, how_often(p), source_text(a->arena, p->a.e->span), number);
    diag_label(a->diags, d, DIAG_label_nearest_f32, const_text(a->arena, sm_from_f32(sm_round_f32(x))));
}

// For a whole-number variable the message shows the bounds of its type, for other expressions their possible values.
static void report_decided(const Analysis *a, const Pair *p)
{
    const Expr *e = p->a.e;
    const SmF64 zero = sm_from_i32(0);                        // adding it turns -0 into 0
    const char *lo = const_text(a->arena, sm_add(p->a.fact.lo, zero)), *hi = const_text(a->arena, sm_add(p->a.fact.hi, zero));

    if (e->kind == EX_VAR) {
        if (sm_type_info[e->var->type].kind != SM_KIND_BOOL) {
            const SmType t = e->var->type;
            lo = const_text(a->arena, sm_cell_to_f64(t, sm_cell_from_f64(t, p->a.fact.lo)));
            hi = const_text(a->arena, sm_cell_to_f64(t, sm_cell_from_f64(t, p->a.fact.hi)));
        }
        diag_report(a->diags, p->answer == NEVER ? DIAG_never_holds : DIAG_always_holds, p->whole->span, e->var->name->text,
                    sm_type_info[e->var->type].spelling, lo, hi);
        return;
    }
    diag_report(a->diags, DIAG_types_decide, p->whole->span, how_often(p), source_text(a->arena, e->span), lo, hi);
}

static bool look_at_pair(const Analysis *a, Pair *p, bool report)
{
    if (is_habit(p))
        return false;
    if (report && is_no_such_number(p))
        report_no_such_number(a, p);
    else if (report)
        report_decided(a, p);
    return true;
}

// ---- expressions ----

typedef struct Look { const Analysis *a; bool report; bool found; } Look;

static void look_at_comparison(Look *k, const Expr *e, const Expr *within)
{
    const uint32_t pairs = e->kind == EX_CHAIN ? e->n - 1 : 1;

    for (uint32_t i = 0; i < pairs; i++) {
        Pair p = {.whole = e, .within = within};
        if (make_pair(k->a, &p, e->arg[i], e->kind == EX_CHAIN ? expr_ops(e)[i] : e->op, e->arg[i + 1]))
            k->found |= look_at_pair(k->a, &p, k->report);
    }
}

static bool compares(const Expr *e) { return e->kind == EX_CHAIN || (e->kind == EX_BINARY && is_comparison(e->op)); }

// Recursion depth equals the nesting of expressions, which AST_DEPTH_MAX bounds.
static void look_within(Look *k, const Expr *e, const Expr *within)
{
    const Expr *both = e->kind == EX_BINARY && e->op == SM_OP_AND ? e : NULL;

    if (compares(e))
        look_at_comparison(k, e, within);
    for (uint32_t i = 0; i < e->n; i++)
        look_within(k, e->arg[i], both);
}

bool types_decide_in(const Analysis *a, const Expr *e)
{
    Look k = {a, false, false};

    look_within(&k, e, NULL);
    return k.found;
}

static void look_at_stmt(const Stmt *stmt, void *context)
{
    if (stmt->operators & COMPARISONS)
        look_within(context, stmt->value, NULL);
}

void analyse_decided_comparison(Analysis *a)
{
    Look k = {a, true, false};

    for (size_t i = 0; i < a->p->var.n; i++)
        if (a->p->var.at[i]->init_value)
            look_within(&k, a->p->var.at[i]->init_value, NULL);
    each_stmt(a->p, look_at_stmt, &k);
}
