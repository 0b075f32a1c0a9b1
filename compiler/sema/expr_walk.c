// SPDX-License-Identifier: Apache-2.0
// Visits an expression and everything in it.
#include "compiler/sema/program.h"

void expr_walk(Expr *e, void (*f)(Expr *e, void *context), void *context)
{
    for (uint32_t i = 0; i < e->n; i++)        // as deep as the tree: AST_DEPTH_MAX bounds it
        expr_walk(e->arg[i], f, context);
    f(e, context);
}
