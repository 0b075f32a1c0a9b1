// SPDX-License-Identifier: Apache-2.0
// What the files of the pass `narrow` share.
#ifndef SMC_NARROW_H
#define SMC_NARROW_H

#include "compiler/facts/facts.h"
#include "compiler/ir/ir.h"

// One function being narrowed.  Tables are by temporary of the function as it was; those made on the way are behind them.
typedef struct Narrow {
    Arena *arena;
    IrFn *f;
    const Fact *of;
    uint32_t *uses;
    IrRef *same;              // another that has the same value, or itself
    IrRef *narrow;            // of an F64: one of a narrower type that is exactly the same number, or IR_NONE
    IrRef *wide;              // likewise one of I64 or U64, whose conversion may have rounded it
    IrRef *as_i32, *as_i64;   // the same number in that type, once somebody has asked
    bool *zero_sign;          // somebody can tell its -0 from 0
    VEC(IrRef) out;           // the block as it becomes
} Narrow;

static inline IrIns *narrow_ins(const Narrow *n, IrRef r) { return &n->f->ins.at[r]; }

IrRef narrow_emit(Narrow *n, IrIns i);                           // a new instruction, here
IrRef narrow_const(Narrow *n, SmType type, double x, Span span);
bool narrow_is_const(const Narrow *n, IrRef r, double *x);       // a number, not NaN

bool narrow_has_integer(const Narrow *n, IrRef r);               // whether r's number exists as an integer (or bool)
IrRef narrow_integer(Narrow *n, IrRef r, SmType type);           // it, in I32 or I64, which must hold it
SmType narrow_common(const Narrow *n, IrRef r, IrRef a, IrRef b);      // I32 if it holds all three (IR_NONE: none), else I64

void narrow_compare(Narrow *n, IrRef ref);

#endif
