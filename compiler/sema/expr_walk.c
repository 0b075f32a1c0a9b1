// SPDX-License-Identifier: Apache-2.0
// Visits an expression and all its subexpressions; compares two expressions.  AST_DEPTH_MAX bounds the recursion depth.
#include "compiler/sema/program.h"

#include <string.h>

#include "stdlib/f64.h"

void expr_walk(Expr *e, void (*f)(Expr *e, void *context), void *context)
{
    for (uint32_t i = 0; i < e->n; i++)
        expr_walk(e->arg[i], f, context);
    f(e, context);
}

static bool same_node(const Expr *a, const Expr *b, const uint32_t *window_of)
{
    if (a->kind != b->kind || a->n != b->n)
        return false;
    switch (a->kind) {
    case EX_NUMBER: return sm_bits(a->number) == sm_bits(b->number);
    case EX_VAR: return a->var == b->var;
    case EX_UNARY:
    case EX_BINARY: return a->op == b->op;
    case EX_CHAIN: return memcmp(expr_ops(a), expr_ops(b), (a->n - 1) * sizeof(SmOperator)) == 0;
    case EX_CALL: return a->fn == b->fn;
    case EX_ROLL: return a->stat == b->stat && window_of[a->window] == window_of[b->window];
    }
    return false;
}

bool expr_equal(const Expr *a, const Expr *b, const uint32_t *window_of)
{
    if (!same_node(a, b, window_of))
        return false;
    for (uint32_t i = 0; a->kind != EX_ROLL && i < a->n; i++)
        if (!expr_equal(a->arg[i], b->arg[i], window_of))
            return false;
    return true;
}
