// SPDX-License-Identifier: Apache-2.0
// What is known about a value: a set of numbers that contains it.  Bounds are computed with the language's own operations.  These
// are monotonic, so the bounds also hold after rounding.  Only types and code are evidence; declarations are not.
#ifndef SMC_FACT_H
#define SMC_FACT_H

#include <stdbool.h>

#include "compiler/ir/ir.h"
#include "stdlib/types.h"

typedef struct Fact {
    double lo, hi;            // bounds, inclusive; may be infinite.  lo > hi: the value is never a number
    bool whole;               // every number is whole, so finite
    bool f32;                 // every number is an F32 exactly (infinities are)
    bool nan;                 // it may be NaN
    bool minus_zero;          // it may be -0
} Fact;

// Whole numbers up to here are exact in F64, and so are their sums.
#define FACT_EXACT 9007199254740992.0     // 2^53

Fact fact_of_type(SmType type);                       // every value that a variable of the type can hold; a loaded value is never NaN
Fact fact_of_cell(SmType type, uint64_t bits);        // one number
Fact fact_of_bool(bool may_be_false, bool may_be_true);

// The result of instruction i when its operands have facts *a and *b.  Facts of operands that i does not have are ignored.
// Not for loads and statistics.
Fact fact_of_result(const IrIns *i, const Fact *a, const Fact *b, SmType type_of_a);
// The result of converting a to `to`.
Fact fact_convert(Fact a, SmType to);
// The result of a statistic of a window whose samples have the fact `sample`.  A window is never empty when a statistic is computed.
Fact fact_of_stat(SmStat stat, Fact sample);

Fact fact_join(Fact a, Fact b);                       // of a value that satisfies a or b
Fact fact_meet(Fact a, Fact b);                       // of a value that satisfies both; returns a if no number does
bool fact_equal(Fact a, Fact b);

typedef struct FactLimits {
    const double *at;
    size_t n;
} FactLimits;
// Widening, where `before` has grown to `now`.  Each bound that grew moves to the next limit, or to the type's bound, so that growth
// ends.
Fact fact_widen(Fact before, Fact now, SmType type, const FactLimits *limits);

bool fact_is_number(Fact a, double *x);               // whether a is exactly one number; +0 and -0 count as two
bool fact_within(Fact a, double lo, double hi);       // whether a is always a number within these bounds
bool fact_fits(Fact a, SmType type);                  // whether a is always a number in the type's range: conversion never saturates

double fact_above(Fact a, double x);                  // the smallest number above x that is whole if a is whole
double fact_below(Fact a, double x);                  // the largest number below x that is whole if a is whole

#endif
