// SPDX-License-Identifier: Apache-2.0
// What is known of a value: a set of numbers that it cannot leave.  Bounds are computed with the language's own operations,
// which are monotonic, so they hold after rounding too.  Only what types and code prove counts, nothing that is declared.
#ifndef SMC_FACT_H
#define SMC_FACT_H

#include <stdbool.h>

#include "compiler/ir/ir.h"
#include "stdlib/types.h"

typedef struct Fact {
    double lo, hi;            // no number is below lo or above hi; may be infinite.  lo > hi: it is no number at all
    bool whole;               // every number is whole, so finite
    bool f32;                 // every number is an F32 exactly (infinities are)
    bool nan;                 // it may be NaN
    bool minus_zero;          // it may be -0
} Fact;

// Whole numbers up to here are exact in F64, and so are their sums.
#define FACT_EXACT 9007199254740992.0     // 2^53

Fact fact_of_type(SmType type);                       // all that a variable of the type can hold; a loaded one is never NaN
Fact fact_of_cell(SmType type, uint64_t bits);        // one number
Fact fact_of_bool(bool may_be_false, bool may_be_true);

// What operation i gives when its operands have these facts (those it has not are ignored).  Not of loads and statistics.
Fact fact_of_result(const IrIns *i, const Fact *a, const Fact *b, SmType type_of_a);
// What conversion to `to` makes of a.
Fact fact_convert(Fact a, SmType to);
// What a statistic of a window with such samples gives; it is never empty when it is asked.
Fact fact_of_stat(SmStat stat, Fact sample);

Fact fact_join(Fact a, Fact b);                       // of a value that is one or the other
Fact fact_meet(Fact a, Fact b);                       // of a value that is both; a where that leaves nothing
bool fact_equal(Fact a, Fact b);

typedef struct FactLimits {
    const double *at;
    size_t n;
} FactLimits;
// What `before` has grown to: bounds that grew go on to the next limit, or to the type's own, so that growth ends.
Fact fact_widen(Fact before, Fact now, SmType type, const FactLimits *limits);

bool fact_is_number(Fact a, double *x);               // whether it is one number; zeros of either sign are two
bool fact_within(Fact a, double lo, double hi);       // a number, in these bounds
bool fact_fits(Fact a, SmType type);                  // a number in the type's range: converting to it saturates nothing

double fact_above(Fact a, double x);                  // the smallest number that a value with a's kind can have above x
double fact_below(Fact a, double x);                  // the largest below x

#endif
