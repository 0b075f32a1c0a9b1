// SPDX-License-Identifier: Apache-2.0
// What is known about a value: an interval that contains it, and a few properties.  Bounds are computed with the language's own
// operations, which round.  Rounding is monotonic, so the computed bounds are bounds of the rounded results.  Facts come only from types
// and code; declarations such as @range are not used.
#ifndef SMC_FACT_H
#define SMC_FACT_H

#include <stdbool.h>

#include "compiler/ir/ir.h"
#include "stdlib/types.h"

typedef struct Fact {
    double lo, hi;            // bounds, inclusive; may be infinite.  lo > hi: the value is never a number, only NaN
    bool whole;               // if the value is a number, it is whole, and therefore finite
    bool f32;                 // if the value is a number, F32 represents it exactly; F32 has infinities, too
    bool nan;                 // the value may be NaN
    bool minus_zero;          // the value may be -0
    bool round_trips;         // an I64 or U64: converting it to F64 and back does not change it.  Means nothing for other types
} Fact;

// F64 represents every whole number of at most this magnitude, and the sum of two such numbers is exact if it is within it, too.
#define FACT_EXACT 9007199254740992.0     // 2^53

Fact fact_of_type(SmType type);                       // every value that a load of this type can produce; never NaN
Fact fact_of_cell(SmType type, uint64_t bits);        // the fact of exactly the number that these bits encode in this type
Fact fact_of_bool(bool may_be_false, bool may_be_true);

// Returns the fact about the result of instruction i if its operands have the facts *a and *b.  Facts of operands that i does not have are
// ignored.  i must not be a load or a statistic.
Fact fact_of_result(const IrIns *i, const Fact *a, const Fact *b, SmType type_of_a);
// Returns the fact about a value with the fact a, converted to type `to`.
Fact fact_convert(Fact a, SmType to);
// Returns the fact about a statistic of a rolling window whose samples have the fact `sample`.  When a statistic is computed, its window is
// never empty.
Fact fact_of_stat(SmStat stat, Fact sample);

// Narrows the facts of both operands, which are numbers, to the values for which `*a op *b` is true.
void fact_bound_by_comparison(Fact *a, IrOp op, Fact *b);

Fact fact_join(Fact a, Fact b);                       // returns what is known if either a or b is true
Fact fact_meet(Fact a, Fact b);                       // returns what is known if both a and b are true; a if they contradict each other
static inline bool fact_equal(Fact a, Fact b)
{
    return a.lo == b.lo && a.hi == b.hi && a.whole == b.whole && a.f32 == b.f32 && a.nan == b.nan && a.minus_zero == b.minus_zero
        && a.round_trips == b.round_trips;
}
bool fact_is_same(const Fact *a, const Fact *b);      // whether *a and *b have the same bits: unlike fact_equal, distinguishes the bounds 0 and -0

typedef struct FactLimits {
    const double *at;         // the numbers at which widening stops, in ascending order
    size_t n;
} FactLimits;
// Widens a fact that has grown from `before` to `now`: each bound that grew moves outward to the next limit, or to the type's bound if
// there is no limit beyond it.  So a bound can grow only as often as there are limits.
Fact fact_widen(Fact before, Fact now, SmType type, const FactLimits *limits);

bool fact_is_number(Fact a, double *x);               // whether a is exactly one number, which *x receives; +0 and -0 count as two
bool fact_within(Fact a, double lo, double hi);       // whether a is always a number within these bounds
bool fact_fits(Fact a, SmType type);                  // whether a is always a number in the type's range: conversion never saturates

double fact_next_above(Fact a, double x);                  // the next number above x that a value with fact a can have
double fact_next_below(Fact a, double x);                  // the next number below x that a value with fact a can have

#endif
