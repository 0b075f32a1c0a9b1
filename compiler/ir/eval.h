// SPDX-License-Identifier: Apache-2.0
// The value of an IR operation on known operands.  It is computed with the functions of stdlib and never with the host's operators, so it
// cannot disagree with the engines.
//
// A temporary has one number, an F64, whatever its type: a bool is 0 or 1, and an I64 or U64 beyond 2^53 is rounded.  In a const the number
// is stored as a cell of the type (stdlib/convert.h).
#ifndef SMC_IR_EVAL_H
#define SMC_IR_EVAL_H

#include "compiler/ir/ir.h"
#include "stdlib/f64.h"

// The number of a cell.  The cell of an F64 may be NaN; a load would read it as 0.
SmF64 ir_number(SmType type, uint64_t cell);

// The cell of a number that `type` represents, or that a narrowed operation has on F64 (IrNarrow): ir_number's inverse.
uint64_t ir_cell(SmType type, SmF64 x);

// The number left when x is converted to `type`: saturated, without its fraction, NaN as 0 (language.md 2).
SmF64 ir_convert(SmType type, SmF64 x);

// The number that an operation on `a` and `b` produces; the operands that `op` does not have are ignored.  `type` is the type of the result,
// which only cvt needs.  A narrowed operation produces the same number as on F64, rounded by ir_cell.
// const, load, store, stat and sample have no value of their own here: 0.
SmF64 ir_eval(IrOp op, SmType type, SmF64 a, SmF64 b);

// Whether one operand of `op` decides the result, whatever the other is: false of `and`, true of `or`.  The result is that operand.
static inline bool ir_decides(IrOp op, bool operand) { return (op == IR_and && !operand) || (op == IR_or && operand); }

#endif
