// SPDX-License-Identifier: Apache-2.0
// What would follow if something were so: a sensor that reads 0, two guards that hold at once.  Asked of the same facts as
// everything else (compiler/facts), so an answer "impossible" is certain, and "possible" may be too careful.
//
//     const Env *env = facts_begin(a->facts, state, BLOCK_STEP);
//     env = suppose(a, env, pressure, fact_of_cell(SM_F64, 0));
//     if (!suppose_guard(a, &env, guard, true)) …             // it cannot hold
#ifndef SMC_WHATIF_H
#define SMC_WHATIF_H

#include "compiler/analysis/analysis.h"

// env, and v is within f (converted to v's type; never NaN).  Of a constant local: env itself.
const Env *suppose(const Analysis *a, const Env *env, const Var *v, Fact f);

// *env, and the guard holds (or does not).  False, with *env as it was, if that is impossible.
bool suppose_guard(const Analysis *a, const Env **env, const Expr *guard, bool holds);
// *env, and all conditions are as they must be.
bool suppose_condition(const Analysis *a, const Env **env, const Condition *when);

// What an expression can be there; of one that is true or false, as a bool.
Fact suppose_value(const Analysis *a, const Env *env, const Expr *e);

// The analysis of a machine whose sensors stay in their @range for ever, with its locals; a itself if there is no @range.
Analysis suppose_ranges(const Analysis *a);

Fact fact_of_number(SmF64 x);                 // one number
Fact fact_of_range(SmF64 lo, SmF64 hi);       // anything between

#endif
