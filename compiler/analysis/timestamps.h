// SPDX-License-Identifier: Apache-2.0
// Which locals contain a time: every assignment to them is the time, plus or minus something, or a plain number.
#ifndef SMC_TIMESTAMPS_H
#define SMC_TIMESTAMPS_H

#include "compiler/sema/program.h"

typedef enum TimestampKind {
    TIMESTAMP_NONE,
    TIMESTAMP_COPY,           // of G or T, unchanged, or a difference of two such copies
    TIMESTAMP_SHIFTED         // something was added: a time in the future, or one that is long past
} TimestampKind;

typedef struct Timestamps { const Program *p; uint8_t *of; } Timestamps;        // by Var.index

Timestamps timestamps_of(Arena *arena, const Program *p);

// An expression as a sum: how it depends on time.
typedef struct TimeSum {
    bool linear;              // it contains only numbers and variables, added and scaled by constants
    bool time;                // it contains T or G
    bool stamp;               // it contains a local with a time
    bool shifted;             // it contains a shifted one
    bool other;               // it contains another variable
    bool scaled;              // time is multiplied or divided
    SmF64 number;             // the sum of its constants
} TimeSum;

TimeSum time_sum(const Timestamps *m, const Expr *e);
// a - b
TimeSum time_difference(TimeSum a, TimeSum b);

#endif
