// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_make.h"

#include "compiler/ir/eval.h"

// ---- variables ----

uint32_t prove_add_var(ProveMaker *k, SmType type, ProveVarKind kind, Fact begin)
{
    const IrVar v = {.space = IR_LOCAL, .type = type, .writable = true, .hidden = true};
    ProveModel *p = k->model;

    if (p->ir->var.n == k->vars) {
        p->var = arena_grow(k->arena, p->var, k->vars * sizeof *p->var, (k->vars * 2 + 16) * sizeof *p->var);
        k->vars = k->vars * 2 + 16;
    }
    p->var[p->ir->var.n] = (ProveVar){.kind = kind, .begin = begin};
    vec_push(k->arena, &p->ir->var, v);
    return p->ir->var.n - 1;
}

Fact prove_fact_of_number(double x) { return fact_of_cell(SM_F64, sm_bits(x)); }

// ---- code ----

IrBlkRef prove_new_block(ProveMaker *k)
{
    vec_push(k->arena, &k->end, PROVE_END_NONE);
    return ir_add_block(k->arena, k->f);
}

IrRef prove_emit(ProveMaker *k, IrOp op, IrRef a, IrRef b)
{
    const bool is_bool = ir_op_info[op].types == IR_T_COMPARE || ir_op_info[op].types == IR_T_LOGIC;
    const IrIns i = {.op = op, .type = is_bool ? SM_BOOL : SM_F64, .a = a, .b = b};

    return ir_emit(k->arena, k->f, k->b, i);
}

IrRef prove_emit_number(ProveMaker *k, double x)
{
    const IrIns i = {.op = IR_const, .type = SM_F64, .a = IR_NONE, .b = IR_NONE, .bits = sm_bits(x)};

    return ir_emit(k->arena, k->f, k->b, i);
}

// Emits the value of a variable as an F64.
IrRef prove_emit_load(ProveMaker *k, uint32_t var)
{
    const SmType type = k->model->ir->var.at[var].type;
    const IrIns i = {.op = IR_load, .type = type, .a = IR_NONE, .b = IR_NONE, .var = var};
    const IrRef r = ir_emit(k->arena, k->f, k->b, i);

    return type == SM_F64 ? r : prove_emit(k, IR_cvt, r, IR_NONE);
}

void prove_emit_store(ProveMaker *k, uint32_t var, IrRef value)
{
    const IrIns i = {.op = IR_store, .type = SM_F64, .a = value, .b = IR_NONE, .var = var};

    k->model->var[var].stored = true;
    ir_emit(k->arena, k->f, k->b, i);
}

void prove_emit_set(ProveMaker *k, uint32_t var, double x) { prove_emit_store(k, var, prove_emit_number(k, x)); }

void prove_jump_from(ProveMaker *k, IrBlkRef from, IrBlkRef to)
{
    k->f->blk.at[from].jump = (IrJump){.kind = IR_JMP, .cond = IR_NONE, .then = to};
}

void prove_branch_from(ProveMaker *k, IrBlkRef from, IrRef cond, IrBlkRef then, IrBlkRef otherwise)
{
    k->f->blk.at[from].jump = (IrJump){.kind = IR_BR, .cond = cond, .then = then, .otherwise = otherwise};
}

// Ends the current block: continues in `then` if the variable is greater than x, else in `otherwise`.
void prove_branch_if_above(ProveMaker *k, uint32_t var, double x, IrBlkRef then, IrBlkRef otherwise)
{
    const IrRef value = prove_emit_load(k, var);

    prove_branch_from(k, k->b, prove_emit(k, IR_gt, value, prove_emit_number(k, x)), then, otherwise);
}

// ---- copies of functions ----

// Returns the temporary of the current block with the value of `r` of the function `from`.  `copy`: by temporary; IR_NONE: not emitted yet.
// `first`: index in k->same of window 0 of `from`.
IrRef prove_copy_value(ProveMaker *k, const IrFn *from, IrRef r, IrRef *copy, uint32_t first)
{
    IrIns i;

    if (r == IR_NONE || copy[r] != IR_NONE)
        return r == IR_NONE ? IR_NONE : copy[r];
    i = from->ins.at[r];
    i.a = prove_copy_value(k, from, i.a, copy, first);
    i.b = prove_copy_value(k, from, i.b, copy, first);
    if (i.op == IR_stat)
        i = (IrIns){.op = IR_load, .type = SM_F64, .a = IR_NONE, .b = IR_NONE, .var = k->window[k->same[first + i.var]].var[i.stat]};
    if (i.op == IR_store)
        k->model->var[i.var].stored = true;
    return copy[r] = ir_emit(k->arena, k->f, k->b, i);
}

IrRef *prove_new_copies(ProveMaker *k, const IrFn *from)
{
    IrRef *copy = ARENA_ARRAY(k->arena, IrRef, from->ins.n + 1);

    for (uint32_t r = 0; r < from->ins.n; r++)
        copy[r] = IR_NONE;
    return copy;
}

// Copies the instructions of a block to the current block.
void prove_copy_block(ProveMaker *k, const IrFn *from, const IrBlk *b, IrRef *copy)
{
    for (uint32_t n = 0; n < b->ins.n; n++)
        prove_copy_value(k, from, b->ins.at[n], copy, 0);
}
