// SPDX-License-Identifier: Apache-2.0
// What is known about the unit of a value, and whether two values can be compared (language.md 2.29 to 2.36).
//
// A number in a program can be a plain number, a conversion (the 0.3048 in `feet * 0.3048`) or a constant with a unit that is not written (the
// period in `speed * 0.02`).  So a value remembers the numbers that were multiplied with it and added to it:
//     value = factor * x + shift, with x in `unit`
// Two values certainly differ only if no such number can explain the difference.
#ifndef SMC_QUANTITY_H
#define SMC_QUANTITY_H

#include "compiler/sema/measure.h"

typedef enum QuantityKind {
    QUANTITY_UNKNOWN,             // no unit, or computed from values without one: can be anything
    QUANTITY_NUMBER,              // computed from numbers alone: its value is `factor`
    QUANTITY_PLAIN,               // certainly a plain number, such as a bool, a sign or an exponential; can be added to and compared with anything
    QUANTITY_UNIT                 // has the unit `unit`
} QuantityKind;

typedef struct Quantity {
    QuantityKind kind;
    Measure unit;
    double factor, shift;         // see above; QUANTITY_NUMBER: `factor` is the value, NaN if not known
    bool scaled;                  // QUANTITY_UNIT: the value has been multiplied with a number other than 1 and -1
    bool constant;                // QUANTITY_UNIT: the value never changes
    bool zero_unknown;                  // QUANTITY_UNIT: a temperature of which it is not known whether it counts from the zero of degC or of K
} Quantity;

Quantity quantity_of_kind(QuantityKind kind);
Quantity quantity_of_number(double x);
Quantity quantity_of_unit(const Measure *unit);

Quantity quantity_negated(Quantity a);
Quantity quantity_product(const Quantity *a, const Quantity *b, double power);     // a times b to the power 1 or -1
// Returns a + b, or a - b, whose units fit each other.
Quantity quantity_sum(const Quantity *a, const Quantity *b, bool minus);
Quantity quantity_power(const Quantity *a, double power);
// Returns one of several values that fit each other, of which a and b are two: the result of min(a, b).
Quantity quantity_one_of(const Quantity *a, const Quantity *b);

typedef enum QuantityFit {
    QUANTITY_FITS,
    QUANTITY_MAY_DIFFER,          // the units differ, unless a number in one of the values has a unit that is not written
    QUANTITY_DIFFERS
} QuantityFit;

typedef enum QuantityUse { QUANTITY_COMPARED, QUANTITY_ADDED, QUANTITY_SUBTRACTED } QuantityUse;

// Judges a and b, which are compared, added, or b subtracted from a.  An assignment compares.
QuantityFit quantity_fit(const Quantity *a, const Quantity *b, QuantityUse use);

#endif
