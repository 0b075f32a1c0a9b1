// SPDX-License-Identifier: Apache-2.0
// The guards that apply where a statement or an expression is: enclosing guards, guards of earlier transitions, and the other
// side of an `and` or `or`.  For conclusions that facts about single variables do not support.
#ifndef SMC_GUARDS_KNOWN_H
#define SMC_GUARDS_KNOWN_H

#include "compiler/analysis/analysis.h"

typedef struct KnownGuard KnownGuard;
struct KnownGuard {
    const Expr *guard;            // is true, or false; NULL: `assigned` was or may have been executed since the outer entries
    bool holds;
    const Stmt *assigned;
    const KnownGuard *outer;
};

// Calls f for every statement of a block, with the guards known there.
typedef void KnownGuardsStmt(void *context, const Stmt *stmt, const KnownGuard *known);
void guards_known_each_stmt(Analysis *a, const Stmts *block, KnownGuardsStmt *f, void *context);

// Calls f for every expression in e that `wanted` selects, with the guards known there.
typedef void KnownGuardsExpr(void *context, const Expr *e, const KnownGuard *known);
void guards_known_each_expr(Analysis *a, const Expr *e, const KnownGuard *known, bool (*wanted)(const Expr *e), KnownGuardsExpr *f,
                            void *context);

// Whether the guards imply that d is not 0.
bool guards_exclude_zero(const Analysis *a, const KnownGuard *known, const Expr *d);

#endif
