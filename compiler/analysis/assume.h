// SPDX-License-Identifier: Apache-2.0
// Computes what follows from an assumption, such as that a sensor reads 0 or that two guards are true together.  The results come from
// facts (compiler/facts): "impossible" is proved, and "possible" only means "not proved impossible".
//
//     const Env *env = facts_at_begin(a->facts, state, BLOCK_STEP);
//     env = assume_fact(a, env, pressure, fact_of_cell(SM_F64, 0));
//     if (!assume_guard(a, &env, guard, true)) …             // the guard cannot be true
#ifndef SMC_ASSUME_H
#define SMC_ASSUME_H

#include "compiler/analysis/analysis.h"

// Returns env with v limited to f (converted to v's type; never NaN).  For a constant local it returns env itself.
const Env *assume_fact(const Analysis *a, const Env *env, const Var *v, Fact f);

// Updates *env for the case that the guard is true (`holds`) or false.  Returns false, and does not change *env, if that case is
// impossible.
bool assume_guard(const Analysis *a, const Env **env, const Expr *guard, bool holds);

// Returns the possible values of an expression if the facts env are true; for a condition, as the fact of a bool.
Fact fact_of_expr(const Analysis *a, const Env *env, const Expr *e);

// Returns a copy of *a whose facts assume that every sensor always stays in its @range.  If no sensor has a @range, the facts of *a.
Analysis assume_ranges(const Analysis *a);

Fact fact_of_number(SmF64 x);                 // the fact of a value that is exactly x
Fact fact_of_range(SmF64 lo, SmF64 hi);       // the fact of a value that is any number from lo to hi

#endif
