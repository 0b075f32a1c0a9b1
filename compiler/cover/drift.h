// SPDX-License-Identifier: Apache-2.0
// How a function changes a variable that is counted up: by how much at least and at most, on all paths.
//
// The value of an integer variable is described relative to what it was when the function began, or as a number, or as either.  Only additions
// of whole numbers that are not negative are followed.  A sum saturates at the limit of its type, so a lower bound is never above DRIFT_CAP
// or that limit (drift_cap).
#ifndef SMC_DRIFT_H
#define SMC_DRIFT_H

#include "compiler/ir/ir.h"

typedef struct Drift {
    bool any;                 // nothing is known
    bool is_relative, is_number;      // the value can be what it was, plus `by`; it can be a number within `number`
    double by[2], number[2];  // least and most
} Drift;

// What a function does to one variable.
typedef struct DriftPaths {
    Drift *of;                // by IrRef: what a load of the variable returns; a temporary computed from one
    Drift *at_end;            // by block: at its end
    bool *reached;            // by block
} DriftPaths;

DriftPaths drift_of_function(Arena *arena, const IrFn *f, uint32_t var);
// What is true of either of two values.
Drift drift_join(Drift a, Drift b);
// The values at the ends without a transition; neither relative nor a number if each end is a transition.
Drift drift_at_returns(const IrFn *f, const DriftPaths *p);
// The largest lower bound of a variable of this type; 0: it is not followed.
double drift_cap(SmType type);

// What is known about a variable when .step of a state runs, if it runs `steps` steps after the state began: from bound[0] + steps * each[0]
// to bound[1] + steps * each[1].  The lower bound is at most the cap.
typedef struct DriftInState {
    bool has_low, has_high;
    double bound[2], each[2];
} DriftInState;

#endif
