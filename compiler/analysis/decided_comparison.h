// SPDX-License-Identifier: Apache-2.0
// Comparisons that have the same result for all values of their operands' types ("decided by types").  Other analyses use these functions
// to find out why a guard always has the same result.
#ifndef SMC_DECIDED_COMPARISON_H
#define SMC_DECIDED_COMPARISON_H

#include "compiler/analysis/analysis.h"

typedef enum Truth { SOMETIMES, NEVER, ALWAYS } Truth;        // how often a guard or a comparison is true

// Whether some comparison in e is reported as decided by types, or as an equality with a value that the type cannot represent.  If so,
// this comparison is the reason why a guard that contains it is always or never true.
bool has_comparison_decided_by_types(const Analysis *a, const Expr *e);

// Returns the possible values of an expression by types alone.  A local that is never written has only its initial value.
Fact fact_of_types(const Analysis *a, const Expr *e);

#endif
