// SPDX-License-Identifier: Apache-2.0
// Conditions of ways as formulas over sums of atoms, without `not`: inside way.c and way_formula.c only.
#ifndef SMC_WAY_FORMULA_H
#define SMC_WAY_FORMULA_H

#include "compiler/analysis/way.h"

typedef enum WayKind { WAY_ALWAYS, WAY_NEVER, WAY_AND, WAY_OR, WAY_BOUND } WayKind;

struct WayFormula {
    WayKind kind;
    const WayFormula *a, *b;      // AND, OR
    WaySum sum;                   // BOUND: its first term is taken once, its number is 0
    SmOperator op;                // BOUND: sum op limit
    double limit;
};

WaySum way_unknown(Way *w, bool whole);
WaySum way_sum(Way *w, const Expr *e);                // its value now
bool way_subtract(WaySum *a, const WaySum *b);        // false, with *a spoilt, if that has too many terms
const WayValue *way_assigned(const Way *w, const Var *v);     // NULL: not on this way
bool way_sum_is_whole(const Way *w, const WaySum *s);

const WayFormula *way_never(void);
const WayFormula *way_or(Way *w, const WayFormula *a, const WayFormula *b);
const WayFormula *way_formula(Way *w, const Expr *e, bool holds);     // what it takes for e to come out so now

// Whether all that w demands, and `also` unless it is NULL, can hold together.  True as well if that takes too long to tell.
bool way_decide(const Way *w, const WayFormula *also);

#endif
