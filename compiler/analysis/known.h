// SPDX-License-Identifier: Apache-2.0
// What guards say where a statement or an expression stands: those around it, those of transitions before it, and the other
// side of an `and` or `or`.  For what facts of single variables cannot tell.
#ifndef SMC_KNOWN_H
#define SMC_KNOWN_H

#include "compiler/analysis/analysis.h"

typedef struct Known Known;
struct Known {
    const Expr *guard;            // holds, or does not; NULL: `assigned` was or may have been executed since what is further out
    bool holds;
    const Stmt *assigned;
    const Known *outer;
};

// Calls f for every statement of a block, with what is known there.
typedef void KnownStmt(void *context, const Stmt *stmt, const Known *known);
void known_each(Analysis *a, const Stmts *block, KnownStmt *f, void *context);

// Calls f for every expression in e that `wanted` picks, with what is known there.
typedef void KnownExpr(void *context, const Expr *e, const Known *known);
void known_within(Analysis *a, const Expr *e, const Known *known, bool (*wanted)(const Expr *e), KnownExpr *f, void *context);

// Whether it follows that d is not 0.
bool known_not_zero(const Analysis *a, const Known *known, const Expr *d);

#endif
