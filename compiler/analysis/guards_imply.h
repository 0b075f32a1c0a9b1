// SPDX-License-Identifier: Apache-2.0
// Whether one guard implies or excludes another, found by comparing their expressions: `x > 20 and ready` implies `x > 10`, and
// `a > b + 5` implies `a > b`.  Facts, in contrast, are bounds of single variables.  The results are true for any values.
#ifndef SMC_GUARDS_IMPLY_H
#define SMC_GUARDS_IMPLY_H

#include "compiler/analysis/analysis.h"

// Whether y is true wherever x is, as long as no variable of y is assigned between the two.  False means "not proved".
bool guard_implies(const Analysis *a, const Expr *x, const Expr *y);
// Whether x and y are never true together.  False means "not proved".
bool guard_excludes(const Analysis *a, const Expr *x, const Expr *y);
// Whether x is never (or always) true whatever its variables contain, as `a > b and a < b` (or `x <= x`).  False means "not proved".
bool guard_is_never_true(const Analysis *a, const Expr *x);
bool guard_is_always_true(const Analysis *a, const Expr *x);

#endif
