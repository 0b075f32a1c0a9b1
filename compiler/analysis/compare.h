// SPDX-License-Identifier: Apache-2.0
// What types decide of comparisons: for analyses that say why a guard comes out one way only.
#ifndef SMC_COMPARE_H
#define SMC_COMPARE_H

#include "compiler/analysis/analysis.h"

// Whether some comparison in e has been reported as decided by types, or as an equality with what a type cannot hold: then that
// is why a guard made of it always or never holds.
bool types_decide_in(const Analysis *a, const Expr *e);

// What an expression can be by its types alone, locals that nobody writes included.
Fact fact_of_types(const Analysis *a, const Expr *e);

#endif
