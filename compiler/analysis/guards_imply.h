// SPDX-License-Identifier: Apache-2.0
// Finds out whether one guard implies or excludes another, by comparing their expressions: `x > 20 and ready` implies `x > 10`, and
// `a > b + 5` implies `a > b`.  The results are true for any values of the variables and do not use facts.
#ifndef SMC_GUARDS_IMPLY_H
#define SMC_GUARDS_IMPLY_H

#include "compiler/analysis/analysis.h"

// Whether y is true whenever x is, as long as no variable of y is assigned between their evaluations.  False means "not proved".
bool guard_implies(const Analysis *a, const Expr *x, const Expr *y);
// Whether x and y are never true together.  False means "not proved".
bool guard_excludes(const Analysis *a, const Expr *x, const Expr *y);
// Whether x is never true (`a > b and a < b`), or always true (`x <= x`), whatever its variables contain.  False means "not proved".
bool guard_is_never_true(const Analysis *a, const Expr *x);
bool guard_is_always_true(const Analysis *a, const Expr *x);

#endif
