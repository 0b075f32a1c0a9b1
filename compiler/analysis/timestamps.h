// SPDX-License-Identifier: Apache-2.0
// Finds the locals that contain a time: every assignment to them stores a constant or a time, and at least one a time.  A time is T, G or
// another such local, plus or minus other values.
#ifndef SMC_TIMESTAMPS_H
#define SMC_TIMESTAMPS_H

#include "compiler/sema/program.h"

typedef enum TimestampKind {
    TIMESTAMP_NONE,
    TIMESTAMP_COPY,           // an unchanged G or T, or a difference of two such times
    TIMESTAMP_SHIFTED         // a time plus something: a time in the future or in the past
} TimestampKind;

typedef struct Timestamps { const Program *p; uint8_t *of; } Timestamps;        // of[Var.index] is a TimestampKind

Timestamps timestamps_of(Arena *arena, const Program *p);

// How an expression depends on time, if it is a sum of variables and constants.
typedef struct TimeSum {
    bool linear;              // the expression contains only numbers and variables, added and scaled by constants
    bool time;                // the sum contains T or G
    bool stamp;               // the sum contains a local that stores a time (TIMESTAMP_COPY or TIMESTAMP_SHIFTED)
    bool shifted;             // the sum contains a local that stores a shifted time (TIMESTAMP_SHIFTED)
    bool other;               // the sum contains another variable
    bool scaled;              // the expression multiplies or divides a time
    SmF64 number;             // the sum of its constants
} TimeSum;

// Returns the expression e as a sum; `linear` is false if e is not a sum of variables and constants.
TimeSum time_sum_of(const Timestamps *m, const Expr *e);
// Returns the sum a - b.
TimeSum time_sum_difference(TimeSum a, TimeSum b);

#endif
