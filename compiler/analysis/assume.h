// SPDX-License-Identifier: Apache-2.0
// What follows from an assumption, such as that a sensor reads 0 or that two guards are true together.  The answers are computed
// from facts (compiler/facts).  So "impossible" is proved, and "possible" means only: not proved impossible.
//
//     const Env *env = facts_at_begin(a->facts, state, BLOCK_STEP);
//     env = assume_fact(a, env, pressure, fact_of_cell(SM_F64, 0));
//     if (!assume_guard(a, &env, guard, true)) …             // it cannot be true
#ifndef SMC_ASSUME_H
#define SMC_ASSUME_H

#include "compiler/analysis/analysis.h"

// Returns env with v limited to f (converted to v's type; never NaN).  For a constant local it returns env itself.
const Env *assume_fact(const Analysis *a, const Env *env, const Var *v, Fact f);

// Updates *env for the case that the guard is true (or false).  Returns false, and leaves *env as it was, if that is
// impossible.
bool assume_guard(const Analysis *a, const Env **env, const Expr *guard, bool holds);

// The possible values of an expression where the facts env are true; for a condition, as a bool.
Fact fact_of_expr(const Analysis *a, const Env *env, const Expr *e);

// Returns a copy of *a with facts that assume that every sensor always stays in its @range.  Without any @range, the same facts.
Analysis assume_ranges(const Analysis *a);

Fact fact_of_number(SmF64 x);                 // exactly this number
Fact fact_of_range(SmF64 lo, SmF64 hi);       // any number from lo to hi

#endif
