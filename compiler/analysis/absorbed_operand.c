// SPDX-License-Identifier: Apache-2.0
// Reports an equality that an inequality beside it makes superfluous: in `code == A or code != B` the first operand is true only where the second
// one is, so it changes nothing.  Mostly `==` was meant twice, or `and` in place of `or`.
#include "compiler/analysis/analysis.h"

enum { OPERANDS_MAX = 16 };       // operands of a chain that are compared with each other

typedef struct AbsorbCheck { Diags *diags; Arena *arena; const uint32_t *window_of; bool only_or; } AbsorbCheck;

// An operand `of == number`, or != if `differs`.
typedef struct Equality { const Expr *whole, *of; SmF64 number; bool differs; } Equality;

// Describes e if it compares something with a constant by == or !=.
static bool read_equality(const Expr *e, Equality *out)
{
    int constant;

    if (e->kind != EX_BINARY || (e->op != SM_OP_EQ && e->op != SM_OP_NE))
        return false;
    constant = expr_is_constant(e->arg[1]) ? 1 : 0;
    if (!expr_is_constant(e->arg[constant]) || expr_is_constant(e->arg[1 - constant]))
        return false;
    *out = (Equality){e, e->arg[1 - constant], expr_constant_value(e->arg[constant]), e->op == SM_OP_NE};
    return true;
}

// Whether the text of e is within that of a chain: a definition that is used there may overlap with its neighbours as intended.
static bool is_written_in(const Expr *e, const Expr *chain)
{
    return e->span.src == chain->span.src && e->span.at >= chain->span.at && e->span.at + e->span.len <= chain->span.at + chain->span.len;
}

typedef struct Equalities { Equality at[OPERANDS_MAX]; uint32_t n; } Equalities;

static void list_equalities(Equalities *l, const Expr *e, const Expr *chain)
{
    if (e->kind == EX_BINARY && e->op == chain->op) {
        list_equalities(l, e->arg[0], chain);
        list_equalities(l, e->arg[1], chain);
    } else if (l->n < OPERANDS_MAX && is_written_in(e, chain) && read_equality(e, &l->at[l->n]) &&
               is_written_in(l->at[l->n].of, e)) {
        l->n++;
    }
}

// Checks a chain of `and` or `or`.  The operand that has no effect is the equality in a chain of `or`, the inequality in one of `and`.
static void check_chain(const AbsorbCheck *k, const Expr *e)
{
    Equalities l = {.n = 0};

    list_equalities(&l, e, e);
    for (uint32_t i = 0; i < l.n; i++)
        for (uint32_t j = 0; j < l.n; j++) {
            const Equality *x = &l.at[i], *by = &l.at[j];
            if (x->differs == by->differs || x->differs != (e->op == SM_OP_AND) || sm_eq(x->number, by->number) ||
                !expr_equal(x->of, by->of, k->window_of))
                continue;
            diag_label(k->diags, diag_report(k->diags, DIAG_absorbed_operand, x->whole->span, source_text(k->arena, x->whole->span)),
                       e->op == SM_OP_OR ? DIAG_label_absorbed_or : DIAG_label_absorbed_and, source_text(k->arena, by->whole->span));
            return;
        }
}

// Checks an expression and its operands.  chain: the operator of the chain that e belongs to; else SM_OP_NOT.
static void check_expr(const AbsorbCheck *k, const Expr *e, SmOperator chain)
{
    const bool is_logic = e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR);

    if (is_logic && e->op != chain && !(k->only_or && e->op == SM_OP_AND))
        check_chain(k, e);
    for (uint32_t i = 0; i < e->n; i++)
        check_expr(k, e->arg[i], is_logic ? e->op : SM_OP_NOT);
}

// An assert with a superfluous inequality in a chain of `and` tests what it seems to.
void analyse_absorbed_condition(Arena *arena, Diags *diags, const Expr *condition)
{
    const AbsorbCheck k = {diags, arena, NULL, true};

    check_expr(&k, condition, SM_OP_NOT);
}

static void check_stmt(const Stmt *s, void *context)
{
    if (s->value)
        check_expr(context, s->value, SM_OP_NOT);
}

void analyse_absorbed_operand(Analysis *a)
{
    AbsorbCheck k = {a->diags, a->arena, a->m->window_of, false};

    if (a->p->operators & EQUALITIES)
        each_stmt(a->p, check_stmt, &k);
}
