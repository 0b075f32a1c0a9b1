// SPDX-License-Identifier: Apache-2.0
// What one guard implies about another because of how they are written: x > 20 and ready implies x > 10; also a > b + 5 implies
// a > b.  Facts are bounds of single variables.  This module handles relations between expressions, for any values.
#ifndef SMC_GUARDS_IMPLY_H
#define SMC_GUARDS_IMPLY_H

#include "compiler/analysis/analysis.h"

// Whether y is true wherever x is, as long as no variable of y is assigned between the two.  False means "not proved".
bool guard_implies(const Analysis *a, const Expr *x, const Expr *y);
// Whether the two are never true together.
bool guard_excludes(const Analysis *a, const Expr *x, const Expr *y);
// Whether x is never, or always, true because of its form: a > b and a < b, x <= x.
bool guard_is_never_true(const Analysis *a, const Expr *x);
bool guard_is_always_true(const Analysis *a, const Expr *x);

#endif
