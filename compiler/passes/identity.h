// SPDX-License-Identifier: Apache-2.0
// What identity.c and algebra.c share: the pass `identity`.
#ifndef SMC_PASSES_IDENTITY_H
#define SMC_PASSES_IDENTITY_H

#include "compiler/ir/ir.h"
#include "stdlib/f64.h"

typedef struct Identity {
    IrFn *f;
    IrRef *same;          // by instruction: the temporary that has the same value, itself if there is none
    bool *never_nan;      // by instruction: certainly a number, or no float at all
} Identity;

static inline const IrIns *identity_at(const Identity *d, IrRef ref) { return &d->f->ins.at[ref]; }

SmF64 identity_number(const IrIns *constant);         // as an F64; NaN stays NaN
// Whether ref is a constant of any type that is this number, told by its bits as an F64: 0 and -0 are two.
bool identity_is(const Identity *d, IrRef ref, SmF64 number);
bool identity_is_integer(SmType type);

// Makes another operation of it that gives the same and costs less, or leaves it alone.
void algebra_rewrite(const Identity *d, IrIns *i);

#endif
