// SPDX-License-Identifier: Apache-2.0
// Declarations that the files of the pass `narrow` share.
#ifndef SMC_NARROW_H
#define SMC_NARROW_H

#include "compiler/facts/facts.h"
#include "compiler/ir/ir.h"

// One function being narrowed.  The tables are indexed by the original temporaries of the function.  New temporaries have higher
// numbers and no entries.
typedef struct Narrow {
    Arena *arena, *work;      // memory for what stays in the function; for tables
    IrFn *f;
    size_t temps;             // number of original temporaries
    const Fact *fact;         // possible values of each temporary
    uint32_t *uses;           // number of users of each temporary
    IrRef *same;              // an earlier temporary with the same value, or the temporary itself
    IrRef *narrow;            // for an F64: a temporary of a narrower type with exactly the same number, or IR_NONE
    IrRef *wide;              // for an F64: the I64 or U64 from which it was converted, perhaps with rounding; IR_NONE: none
    bool *round_trips;        // for an F64 with `wide`: it converts back to that I64 or U64
    IrRef *as_i32, *as_i64;   // the same number in that type, once narrow_get_integer has created it
    bool *zero_sign_observable;  // whether a user of the temporary could distinguish -0 from 0
    VEC(IrRef) out;           // the new instruction list of the block
} Narrow;

static inline IrIns *narrow_ins(const Narrow *n, IrRef r) { return &n->f->ins.at[r]; }

IrRef narrow_emit(Narrow *n, IrIns i);                           // appends a new instruction to n->out
IrRef narrow_const(Narrow *n, SmType type, double x, Span span);
bool narrow_is_const(const Narrow *n, IrRef r, double *x);       // whether r is a constant number, not NaN; sets *x

bool narrow_has_integer(const Narrow *n, IrRef r);               // whether r's number exists as an integer (or bool)
IrRef narrow_get_integer(Narrow *n, IrRef r, SmType type);       // returns r's number as I32 or I64; `type` must be able to represent it
SmType narrow_common_integer(const Narrow *n, IrRef r, IrRef a, IrRef b);  // returns I32 if r, a and b fit it (IR_NONE is ignored), else I64

// Whether the F64s a and b were converted from integers of one type, I64 or U64, to which they convert back.
bool narrow_same_round_trip(const Narrow *n, IrRef a, IrRef b);

void narrow_compare(Narrow *n, IrRef ref);

#endif
