// SPDX-License-Identifier: Apache-2.0
// Declarations that the files of the pass `identity` share: identity.c and algebra.c.
#ifndef SMC_PASSES_IDENTITY_H
#define SMC_PASSES_IDENTITY_H

#include "compiler/ir/ir.h"
#include "stdlib/f64.h"

typedef struct Identity {
    IrFn *f;
    IrRef *same;          // by instruction: an earlier temporary with the same value, or itself
    bool *never_nan;      // by instruction: its result is certainly not NaN, or is not a float
} Identity;

static inline const IrIns *identity_at(const Identity *d, IrRef ref) { return &d->f->ins.at[ref]; }

// Whether ref is a constant, of any type, with this value.  Compares the bits as F64, so 0 and -0 differ.
bool identity_is_const(const Identity *d, IrRef ref, SmF64 number);
bool identity_is_integer(SmType type);

// Replaces i with a cheaper operation that has the same result, if there is one.
void identity_rewrite_cheaper(const Identity *d, IrIns *i);

#endif
