// SPDX-License-Identifier: Apache-2.0
// Evaluates IR operations on known operands, with the functions of stdlib and never with the host's operators, so that the result cannot
// differ from that of the engines.
//
// In these functions the value of a temporary of any type is a number, an F64: a bool is 0 or 1, and an I64 or U64 beyond 2^53 is rounded.
// A const stores its number as a bit cell of its type (stdlib/convert.h).
#ifndef SMC_IR_EVAL_H
#define SMC_IR_EVAL_H

#include "compiler/ir/ir.h"
#include "stdlib/f64.h"

// Returns the number that a cell (the bits of a value of this type, as a uint64_t) represents.  An F64 cell can be NaN, although a load
// would read it as 0.
SmF64 ir_number(SmType type, uint64_t cell);

// The inverse of ir_number.  x is a number that `type` represents, or the F64 result of an operation narrowed to `type` (IrNarrow).
uint64_t ir_cell(SmType type, SmF64 x);

// Returns x converted to `type` (language.md 2): saturated, truncated if the type is an integer; NaN becomes 0.
SmF64 ir_convert(SmType type, SmF64 x);

// Returns the number that an operation on `a` and `b` produces.  If `op` has fewer operands, the others are ignored.  `type` is the type of
// the result, used only by cvt.  A narrowed operation (IrNarrow) produces the same number as on F64, which ir_cell then rounds.
// Returns 0 for const, load, store, stat and sample, whose values do not depend on operands.
SmF64 ir_eval(IrOp op, SmType type, SmF64 a, SmF64 b);

// Whether one operand of `op` decides the result, whatever the other is: false of `and`, true of `or`.  The result is that operand.
static inline bool ir_decides(IrOp op, bool operand) { return (op == IR_and && !operand) || (op == IR_or && operand); }

#endif
