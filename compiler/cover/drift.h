// SPDX-License-Identifier: Apache-2.0
// By how much a function increases a variable such as a counter: at least and at most, on all its paths.
//
// The value of an integer variable is described as an increase of its value at the start of the function, or as a number, or as one of both.
// Only additions of whole numbers that are not negative are followed.  A sum saturates at the limit of its type, so a lower bound is never
// above that limit (drift_cap).
#ifndef SMC_DRIFT_H
#define SMC_DRIFT_H

#include "compiler/ir/ir.h"

// What is known about a value.
typedef struct Drift {
    bool any;                 // nothing is known: the value can be any
    bool is_relative;         // the value can be that at the function's start, plus by[0] to by[1]
    bool is_number;           // the value can be a number from number[0] to number[1]
    double by[2], number[2];
} Drift;

// What a function does to one variable.
typedef struct DriftPaths {
    Drift *of;                // by IrRef: the temporary's value, if it is a load of the variable or computed from one
    Drift *at_end;            // by block: the variable's value at the end of the block
    bool *reached;            // by block: the function's start leads to it
} DriftPaths;

DriftPaths drift_of_function(Arena *arena, const IrFn *f, uint32_t var);
// Returns what is known about a value that is one of two values.
Drift drift_join(Drift a, Drift b);
// Returns the variable's value where the function ends without a transition.  If each path ends in a transition, the result is neither
// relative nor a number.
Drift drift_at_returns(const IrFn *f, const DriftPaths *p);
// Returns the largest lower bound that a variable of this type can have; 0: variables of this type are not followed.
double drift_cap(SmType type);

// What is known about a variable when .step of a state runs, if it runs `steps` steps after the state began: from bound[0] + steps * each[0]
// to bound[1] + steps * each[1].  The lower bound is at most the cap.
typedef struct DriftInState {
    bool has_low, has_high;
    double bound[2], each[2];
} DriftInState;

#endif
