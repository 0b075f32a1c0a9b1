// SPDX-License-Identifier: Apache-2.0
// Which locals hold moments: every assignment to them is the time, plus or minus something, or a plain number.
#ifndef SMC_MOMENTS_H
#define SMC_MOMENTS_H

#include "compiler/sema/program.h"

typedef enum Moment {
    MOMENT_NONE,
    MOMENT_COPY,              // of G or T, just as it was, or a difference of two such
    MOMENT_SHIFTED            // something was added: a time to come, or one that is long past
} Moment;

typedef struct Moments { const Program *p; uint8_t *of; } Moments;        // by Var.index

Moments moments_of(Arena *arena, const Program *p);

// An expression as a sum: what it says of time.
typedef struct TimeSum {
    bool linear;              // it is nothing but a sum of numbers and variables, scaled by constants
    bool time;                // T or G is in it
    bool moment;              // a local that holds a moment is
    bool shifted;             // one that has been shifted is
    bool other;               // another variable is
    bool scaled;              // time is multiplied or divided
    SmF64 number;             // the sum of its constants
} TimeSum;

TimeSum time_sum(const Moments *m, const Expr *e);
// a - b
TimeSum time_difference(TimeSum a, TimeSum b);

#endif
