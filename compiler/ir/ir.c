// SPDX-License-Identifier: Apache-2.0
// The table of operations, and helpers for functions: append blocks and instructions, count uses.
#include "compiler/ir/ir.h"

#include <string.h>

const IrOpInfo ir_op_info[IR_OP_COUNT] = {
#define IR_OP(name, operands, types, narrow, effect, commutes, nan, meaning) \
    {#name, operands, IR_T_##types, IR_N_##narrow, effect, commutes, IR_NAN_##nan},
#include "compiler/ir/ops.def"
#undef IR_OP
};

bool ir_is_elementary(IrOp op)
{
    switch ((int)op) {
#define SM_ELEMENTARY(name, arguments, number) case IR_##name:
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
        return true;
    }
    return false;
}

// Whether a SAME operation may work on this type.
bool ir_op_allows_type(IrOp op, SmType type)
{
    unsigned narrow = ir_op_info[op].narrow;

    return type == SM_F64 || (type == SM_F32 && narrow & IR_N_F32) || ((type == SM_I32 || type == SM_I64) && narrow & IR_N_INT);
}

// Returns the operation of an operator; IR_OP_COUNT for unary plus, which has none.
IrOp ir_op_of_operator(SmOperator op)
{
    switch (op) {
    case SM_OP_OR: return IR_or;
    case SM_OP_AND: return IR_and;
    case SM_OP_EQ: return IR_eq;
    case SM_OP_NE: return IR_ne;
    case SM_OP_LT: return IR_lt;
    case SM_OP_LE: return IR_le;
    case SM_OP_GT: return IR_gt;
    case SM_OP_GE: return IR_ge;
    case SM_OP_ADD: return IR_add;
    case SM_OP_SUB: return IR_sub;
    case SM_OP_MUL: return IR_mul;
    case SM_OP_DIV: return IR_div;
    case SM_OP_NOT: return IR_not;
    case SM_OP_NEG: return IR_neg;
    case SM_OP_PLUS:
    case SM_OP_COUNT: break;
    }
    return IR_OP_COUNT;
}

// Appends an instruction to a block.
IrRef ir_emit(Arena *arena, IrFn *f, IrBlkRef b, IrIns ins)
{
    IrRef i = (IrRef)f->ins.n;

    vec_push(arena, &f->ins, ins);
    vec_push(arena, &f->blk.at[b].ins, i);
    return i;
}

// Appends an empty block to f, and returns its number.
IrBlkRef ir_add_block(Arena *arena, IrFn *f)
{
    IrBlk b = {.jump = {.kind = IR_RET, .cond = IR_NONE, .then = IR_NONE, .otherwise = IR_NONE}};

    vec_push(arena, &f->blk, b);
    return (IrBlkRef)(f->blk.n - 1);
}

static IrFn *copy_function(Arena *arena, const IrFn *f)
{
    IrFn *copy;

    if (!f)
        return NULL;
    copy = ARENA_NEW(arena, IrFn);
    for (size_t i = 0; i < f->ins.n; i++)
        vec_push(arena, &copy->ins, f->ins.at[i]);
    for (size_t b = 0; b < f->blk.n; b++) {
        IrBlk blk = {.jump = f->blk.at[b].jump};
        for (size_t p = 0; p < f->blk.at[b].ins.n; p++)
            vec_push(arena, &blk.ins, f->blk.at[b].ins.at[p]);
        vec_push(arena, &copy->blk, blk);
    }
    return copy;
}

// Returns a copy of m whose functions can be changed.  Everything else is shared with m.
IrMachine *ir_copy(Arena *arena, const IrMachine *m)
{
    IrMachine *copy = ARENA_NEW(arena, IrMachine);

    *copy = *m;
    copy->sample = copy_function(arena, m->sample);
    memset(&copy->state, 0, sizeof copy->state);
    for (size_t s = 0; s < m->state.n; s++) {
        IrState state = m->state.at[s];
        for (int k = 0; k < BLOCK_COUNT; k++)
            state.block[k] = copy_function(arena, state.block[k]);
        vec_push(arena, &copy->state, state);
    }
    return copy;
}

// Returns for each instruction the number of operands and jumps that use its result.
uint32_t *ir_count_uses(Arena *arena, const IrFn *f)
{
    uint32_t *uses = ARENA_ARRAY(arena, uint32_t, f->ins.n);

    for (size_t b = 0; b < f->blk.n; b++) {
        const IrBlk *blk = &f->blk.at[b];
        for (size_t k = 0; k < blk->ins.n; k++) {
            const IrIns *i = &f->ins.at[blk->ins.at[k]];
            if (ir_op_info[i->op].operands > 0)
                uses[i->a]++;
            if (ir_op_info[i->op].operands > 1)
                uses[i->b]++;
        }
        if (blk->jump.kind == IR_BR)
            uses[blk->jump.cond]++;
    }
    return uses;
}
