// SPDX-License-Identifier: Apache-2.0
// A way through several states in successive steps, while the inputs stay as they are: what must hold for it to be taken.
// Where facts know each variable's bounds alone, a way knows sums of variables too (`p > limit + 2`), remembers what was assigned
// on it, and takes statistics of windows for what they settle on when their input no longer changes.
//
//     Way w = way_begin(a);
//     way_step(&w, there, true);
//     way_step(&w, back, true);
//     if (way_possible(&w)) …
//
// "Impossible" can be trusted as far as rounding goes; "possible" means that nothing was found against it.
#ifndef SMC_WAY_H
#define SMC_WAY_H

#include "compiler/analysis/analysis.h"

enum { WAY_TERMS = 4 };

// A sum of multiples of atoms, and a number.
typedef struct WayTerm { uint32_t atom; double times; } WayTerm;
typedef struct WaySum { unsigned n; WayTerm term[WAY_TERMS]; double constant; } WaySum;

// What a value is made of: a variable as it was when the way began, an expression that is looked at as a whole, or (neither)
// something that nothing is known of.
typedef struct WayAtom { const Var *var; const Expr *expr; bool whole; Fact fact; } WayAtom;

typedef struct WayFormula WayFormula;

// What a variable holds now.
typedef struct WayValue {
    const Var *var;
    WaySum sum;
    const WayFormula *yes, *no;   // of a bool: what it takes to be true, to be false; NULL: as `sum` says
} WayValue;

typedef struct Way {
    const Analysis *a;
    VEC(WayAtom) atom;
    VEC(WayValue) assigned;
    VEC(const WayFormula *) demand;
    bool alone;                   // passing a transition demands nothing
} Way;

Way way_begin(const Analysis *a);

// The step in which t is made; its state's first if `first`: T is 0 and .entry has run.  Then .exit.
void way_step(Way *w, const Transition *t, bool first);
// The same for t's own conditions alone: that no earlier transition was made in the step is not demanded.
void way_step_alone(Way *w, const Transition *t);

bool way_possible(const Way *w);
// Whether the step that begins now, its state's first, surely finds t's conditions fulfilled.  Not if it has none.
bool way_forces(const Way *w, const Transition *t);

// How v has changed since the way began: true if by a known number other than 0.
bool way_counts(const Way *w, const Var *v);

#endif
