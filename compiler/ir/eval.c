// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/eval.h"

#include "compiler/ir/comparison.h"
#include "stdlib/convert.h"
#include "stdlib/elementary.h"
#include "stdlib/math.h"

// Returns the number that a cell (the bits of a value of this type) represents.  An F64 cell can be NaN, although a load would read it as 0.
SmF64 ir_number(SmType type, uint64_t cell) { return type == SM_F64 ? sm_from_bits(cell) : sm_cell_to_f64(type, cell); }

// The inverse of ir_number.  A NaN of type F32 becomes 0: users of an F32 operation read only the F32 conversion of its result, which is 0 for a NaN.
uint64_t ir_cell(SmType type, SmF64 x)
{
    if (type == SM_F64)
        return sm_is_nan(x) ? IR_NAN : sm_bits(x);
    return sm_cell_from_f64(type, x);
}

// Returns x converted to `type` (language.md 2): saturated, truncated if the type is an integer; NaN becomes 0.
SmF64 ir_convert(SmType type, SmF64 x)
{
    if (type == SM_F64)
        return sm_is_nan(x) ? sm_from_i32(0) : x;
    if (type == SM_BOOL)
        return sm_from_bool(sm_to_bool(x));
    return sm_cell_to_f64(type, sm_cell_from_f64(type, x));
}

// Returns the number that an operation on `a` and `b` produces.
SmF64 ir_eval(IrOp op, SmType type, SmF64 a, SmF64 b)
{
    switch (op) {
    case IR_cvt: return ir_convert(type, a);
#define CALL_1(name) sm_##name(a)
#define CALL_2(name) sm_##name(a, b)
#define EVAL_SAME(name, operands) case IR_##name: return CALL_##operands(name);
#define EVAL_CONST(name, operands)
#define EVAL_CONVERT(name, operands)
#define EVAL_COMPARE(name, operands)
#define EVAL_LOGIC(name, operands)
#define EVAL_LOAD(name, operands)
#define EVAL_STORE(name, operands)
#define EVAL_SAMPLE(name, operands)
#define EVAL_STAT(name, operands)
#define IR_OP(name, operands, types, narrow, effect, commutes, nan, meaning) EVAL_##types(name, operands)
#include "compiler/ir/ops.def"
#undef IR_OP
    case IR_eq: case IR_ne: case IR_lt: case IR_le: case IR_gt: case IR_ge: return sm_from_bool(ir_compare(op, a, b));
    case IR_and: return sm_from_bool(sm_to_bool(a) && sm_to_bool(b));
    case IR_or: return sm_from_bool(sm_to_bool(a) || sm_to_bool(b));
    case IR_not: return sm_from_bool(!sm_to_bool(a));
    case IR_const: case IR_load: case IR_store: case IR_stat: case IR_sample: case IR_OP_COUNT: break;
    }
    return sm_from_i32(0);
}
