// SPDX-License-Identifier: Apache-2.0
// The guards whose values are known where a statement or an expression is evaluated: enclosing guards, guards of earlier transitions,
// and the other operand of an `and` or `or`.  They show relations of several variables, which facts cannot express.
#ifndef SMC_GUARDS_KNOWN_H
#define SMC_GUARDS_KNOWN_H

#include "compiler/analysis/analysis.h"

typedef struct KnownGuard KnownGuard;
struct KnownGuard {               // an entry of a list, innermost first: a guard, or an assignment
    const Expr *guard;            // the guard; NULL: the entry is an assignment
    bool holds;                   // the known value of the guard
    const Stmt *assigned;         // the assignment, which was or may have been executed after the guards of the outer entries were evaluated
    const KnownGuard *outer;      // the next entry; NULL: none
};

// Calls f for every statement of a block, with the guards that are known at the statement.
typedef void KnownGuardsStmt(void *context, const Stmt *stmt, const KnownGuard *known);
void guards_known_each_stmt(Analysis *a, const Stmts *block, KnownGuardsStmt *f, void *context);

// Calls f for every expression in e that `wanted` selects, with the guards that are known at that expression.
typedef void KnownGuardsExpr(void *context, const Expr *e, const KnownGuard *known);
void guards_known_each_expr(Analysis *a, const Expr *e, const KnownGuard *known, bool (*wanted)(const Expr *e), KnownGuardsExpr *f,
                            void *context);

// Whether the types of the variables in d, and the known guards, prove that d is not 0.
bool guards_exclude_zero(const Analysis *a, const KnownGuard *known, const Expr *d);

#endif
