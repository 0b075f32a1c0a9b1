// SPDX-License-Identifier: Apache-2.0
// What types and constants decide: values that their variable cannot hold, comparisons that come out one way only, divisions
// by zero, and waiting for one exact moment.
#include "compiler/analysis/analysis.h"

#include "stdlib/convert.h"
#include "stdlib/math.h"

typedef struct Values {
    Arena *arena;
    Diags *diags;
    const Program *p;
} Values;

// ---- storing ----

static void report_stored(Values *k, DiagCode code, Span span, const Var *v, SmF64 stored, SmF64 x)
{
    diag_report(k->diags, code, span, v->name->text, sm_type_info[v->type].spelling, const_text(k->arena, stored),
                const_text(k->arena, x));
}

static void check_stored(Values *k, const Var *v, const Expr *value)
{
    SmKind kind = sm_type_info[v->type].kind;
    SmF64 x, stored;
    bool finite, whole;

    if (kind == SM_KIND_BOOL || !expr_is_constant(value))
        return;
    x = const_eval(value);
    stored = sm_cell_to_f64(v->type, sm_cell_from_f64(v->type, x));
    finite = sm_eq(sm_sub(stored, stored), sm_from_i32(0));
    whole = kind != SM_KIND_FLOAT;
    if (sm_is_nan(x))
        diag_report(k->diags, DIAG_stores_nan, value->span, v->name->text);
    else if (whole && !sm_eq(x, stored) && sm_eq(sm_trunc(x), stored))
        report_stored(k, DIAG_stores_whole, value->span, v, stored, x);
    else if (!sm_eq(x, stored) && (whole || !finite))
        report_stored(k, DIAG_stores_limit, value->span, v, stored, x);
}

// ---- comparing ----

// The smallest and largest value of a variable that is a whole number.
typedef struct Limits { SmF64 lo, hi; } Limits;

static bool limits_of(const Expr *e, Limits *l)
{
    SmKind kind;

    if (e->kind != EX_VAR || e->var->is_constant)
        return false;
    kind = sm_type_info[e->var->type].kind;
    l->lo = sm_cell_to_f64(e->var->type, sm_cell_from_f64(e->var->type, sm_div(sm_from_i32(-1), sm_from_i32(0))));
    l->hi = sm_cell_to_f64(e->var->type, sm_cell_from_f64(e->var->type, sm_div(sm_from_i32(1), sm_from_i32(0))));
    if (kind == SM_KIND_BOOL)
        l->lo = sm_from_i32(0);
    return kind != SM_KIND_FLOAT;
}

typedef enum Answer { SOMETIMES, NEVER, ALWAYS } Answer;

static Answer decide(bool always, bool never)
{
    return always ? ALWAYS : never ? NEVER : SOMETIMES;
}

// variable op constant
static Answer compare(const Limits *l, SmOperator op, SmF64 c)
{
    bool outside = sm_lt(c, l->lo) || sm_lt(l->hi, c) || !sm_eq(sm_trunc(c), c);

    if (sm_is_nan(c))
        return SOMETIMES;
    switch ((int)op) {
    case SM_OP_LT: return decide(sm_lt(l->hi, c), sm_le(c, l->lo));
    case SM_OP_LE: return decide(sm_le(l->hi, c), sm_lt(c, l->lo));
    case SM_OP_GT: return decide(sm_lt(c, l->lo), sm_le(l->hi, c));
    case SM_OP_GE: return decide(sm_le(c, l->lo), sm_lt(l->hi, c));
    case SM_OP_EQ: return decide(false, outside);
    case SM_OP_NE: return decide(outside, false);
    }
    return SOMETIMES;
}

static SmOperator mirrored(SmOperator op)
{
    switch ((int)op) {
    case SM_OP_LT: return SM_OP_GT;
    case SM_OP_LE: return SM_OP_GE;
    case SM_OP_GT: return SM_OP_LT;
    case SM_OP_GE: return SM_OP_LE;
    }
    return op;
}

static void report_decided(Values *k, const Expr *whole, const Var *v, const Limits *l, Answer answer)
{
    diag_report(k->diags, answer == NEVER ? DIAG_never_holds : DIAG_always_holds, whole->span, v->name->text,
                sm_type_info[v->type].spelling, const_text(k->arena, l->lo), const_text(k->arena, l->hi));
}

// In a chain what always holds is a habit (0 <= x <= 100), what never holds a mistake.
static void check_pair(Values *k, const Expr *whole, const Expr *a, SmOperator op, const Expr *b)
{
    Limits l;
    Answer answer;

    if (!limits_of(a, &l) || !expr_is_constant(b))
        return;
    answer = compare(&l, op, const_eval(b));
    if (answer == NEVER || (answer == ALWAYS && whole->kind == EX_BINARY))
        report_decided(k, whole, a->var, &l, answer);
}

// A step comes when it comes: one exact moment is easily missed.  0 is none: a state begins there.
static void check_moment(Values *k, const Expr *whole, const Expr *a, const Expr *b)
{
    if (whole->op != SM_OP_EQ || a->kind != EX_VAR || (a->var != k->p->t && a->var != k->p->g) || !expr_is_constant(b))
        return;
    if (!sm_eq(const_eval(b), sm_from_i32(0)))
        diag_report(k->diags, DIAG_exact_moment, whole->span, a->var->report_name->text, const_text(k->arena, const_eval(b)));
}

static bool is_comparison(SmOperator op)
{
    return sm_op_info[op].op_class == SM_CLASS_RELATION || sm_op_info[op].op_class == SM_CLASS_EQUALITY;
}

static void check_binary(Values *k, const Expr *e)
{
    if (is_comparison(e->op)) {
        check_pair(k, e, e->arg[0], e->op, e->arg[1]);
        check_pair(k, e, e->arg[1], mirrored(e->op), e->arg[0]);
        check_moment(k, e, e->arg[0], e->arg[1]);
        check_moment(k, e, e->arg[1], e->arg[0]);
    } else if (e->op == SM_OP_DIV && expr_is_constant(e->arg[1]) && sm_eq(const_eval(e->arg[1]), sm_from_i32(0)))
        diag_report(k->diags, DIAG_division_by_zero, e->arg[1]->span);
}

static void check_chain(Values *k, const Expr *e)
{
    for (uint32_t i = 0; i + 1 < e->n; i++) {
        check_pair(k, e, e->arg[i], e->ops[i], e->arg[i + 1]);
        check_pair(k, e, e->arg[i + 1], mirrored(e->ops[i]), e->arg[i]);
    }
}

// ---- all of it ----

static void look_at_expr(Expr *e, void *context)
{
    if (e->kind == EX_BINARY)
        check_binary(context, e);
    else if (e->kind == EX_CHAIN)
        check_chain(context, e);
}

static void look_at_stmt(const Stmt *stmt, void *context)
{
    if (stmt->value)
        expr_walk(stmt->value, look_at_expr, context);
    if (stmt->kind == ST_ASSIGN)
        check_stored(context, stmt->var, stmt->value);
}

void analyse_values(Analysis *a)
{
    const Program *p = a->p;
    Values k = {a->arena, a->diags, p};

    for (size_t i = 0; i < p->var.n; i++)
        if (p->var.at[i]->init_value) {
            expr_walk(p->var.at[i]->init_value, look_at_expr, &k);
            check_stored(&k, p->var.at[i], p->var.at[i]->init_value);
        }
    each_stmt(p, look_at_stmt, &k);
}
