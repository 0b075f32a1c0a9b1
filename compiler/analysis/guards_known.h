// SPDX-License-Identifier: Apache-2.0
// The guards that apply where a statement or an expression is: enclosing guards, guards of earlier transitions, and the other
// side of an `and` or `or`.  For conclusions that facts about single variables do not support.
#ifndef SMC_GUARDS_KNOWN_H
#define SMC_GUARDS_KNOWN_H

#include "compiler/analysis/analysis.h"

typedef struct Known Known;
struct Known {
    const Expr *guard;            // is true, or false; NULL: `assigned` was or may have been executed since the outer entries
    bool holds;
    const Stmt *assigned;
    const Known *outer;
};

// Calls f for every statement of a block, with the guards known there.
typedef void KnownStmt(void *context, const Stmt *stmt, const Known *known);
void known_each(Analysis *a, const Stmts *block, KnownStmt *f, void *context);

// Calls f for every expression in e that `wanted` selects, with the guards known there.
typedef void KnownExpr(void *context, const Expr *e, const Known *known);
void known_within(Analysis *a, const Expr *e, const Known *known, bool (*wanted)(const Expr *e), KnownExpr *f, void *context);

// Whether the guards imply that d is not 0.
bool known_not_zero(const Analysis *a, const Known *known, const Expr *d);

#endif
