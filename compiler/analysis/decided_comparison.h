// SPDX-License-Identifier: Apache-2.0
// Comparisons that have the same result for all values of their operands' types ("decided by types").  Other analyses use this to
// explain why a guard always has the same result.
#ifndef SMC_DECIDED_COMPARISON_H
#define SMC_DECIDED_COMPARISON_H

#include "compiler/analysis/analysis.h"

typedef enum Truth { SOMETIMES, NEVER, ALWAYS } Truth;        // of a guard or a comparison

// Whether some comparison in e has been reported as decided by types, or as an equality with a value that the type cannot
// represent.  Then that is the reason why a guard with this comparison is always or never true.
bool has_comparison_decided_by_types(const Analysis *a, const Expr *e);

// The possible values of an expression by its types alone, including locals that are never written.
Fact fact_of_types(const Analysis *a, const Expr *e);

#endif
