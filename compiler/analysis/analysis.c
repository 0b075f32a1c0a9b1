// SPDX-License-Identifier: Apache-2.0
// Runs all analyses; what they share.
#include "compiler/analysis/analysis.h"

void analyse_program(Arena *arena, Diags *diags, const Program *p)
{
    analyse_reach(arena, diags, p);
    analyse_unused(arena, diags, p);
    analyse_values(arena, diags, p);
}

// As deep as conditionals nest: AST_DEPTH_MAX bounds it.
static void each_in(const Stmts *stmts, void (*f)(const Stmt *stmt, void *context), void *context)
{
    for (size_t i = 0; i < stmts->n; i++) {
        f(stmts->at[i], context);
        each_in(&stmts->at[i]->then, f, context);
        each_in(&stmts->at[i]->otherwise, f, context);
    }
}

void each_stmt(const Program *p, void (*f)(const Stmt *stmt, void *context), void *context)
{
    for (size_t i = 0; i < p->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            each_in(&p->state.at[i]->block[b], f, context);
}
