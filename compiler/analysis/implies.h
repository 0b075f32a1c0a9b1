// SPDX-License-Identifier: Apache-2.0
// What follows from one guard for another by how they are written: that x > 20 and ready implies x > 10, that a > b + 5 implies
// a > b.  Facts know bounds of single variables; this knows relations between expressions, whatever their values are.
#ifndef SMC_IMPLIES_H
#define SMC_IMPLIES_H

#include "compiler/analysis/analysis.h"

// Whether y holds wherever x does, as long as no variable of y is assigned between the two.  No is "not as far as can be seen".
bool guard_implies(const Analysis *a, const Expr *x, const Expr *y);
// Whether the two never hold together.
bool guard_excludes(const Analysis *a, const Expr *x, const Expr *y);
// Whether x never, or always, holds by itself: a > b and a < b, x <= x.
bool guard_never(const Analysis *a, const Expr *x);
bool guard_always(const Analysis *a, const Expr *x);

#endif
