// SPDX-License-Identifier: Apache-2.0
// Translates expressions to straight-line IR (language.md 3).  In the language every value is an F64.  In the IR comparisons, logic and
// bool variables produce a bool, which is converted to F64 where a number is needed.  The results are the same, because true is 1 and false
// is 0 in the language.  The recursion depth is the depth of the tree, which AST_DEPTH_MAX bounds.
#include <stddef.h>

#include "compiler/ir/build.h"
#include "stdlib/convert.h"

// Appends an instruction to the current block.
IrRef build_emit(Builder *b, const IrIns *ins)
{
    vec_push(b->arena, &b->f->ins, *ins);
    b->f->ins.at[b->f->ins.n - 1].stmt = b->stmt;
    return b->f->blk.at[b->b].ins.n++, (IrRef)(b->f->ins.n - 1);
}

static IrRef emit_op(Builder *b, IrOp op, SmType type, IrRef x, IrRef y, Span span)
{
    IrIns i = {.op = op, .type = type, .a = x, .b = y, .span = span};

    return build_emit(b, &i);
}

static IrRef emit_const(Builder *b, SmType type, uint64_t bits, Span span)
{
    IrIns i = {.op = IR_const, .type = type, .a = IR_NONE, .b = IR_NONE, .bits = bits, .span = span};

    return build_emit(b, &i);
}

static IrRef build_conversion(Builder *b, IrRef value, SmType to, Span span)
{
    return b->f->ins.at[value].type == to ? value : emit_op(b, IR_cvt, to, value, IR_NONE, span);
}

static IrRef build_value(Builder *b, const Expr *e);

// Notes that a temporary has the value of a condition.
static IrRef note_condition(Builder *b, const Expr *e, uint32_t link, IrRef ref)
{
    const IrNote note = {e, link, NULL, ref};

    if (b->notes)
        vec_push(b->arena, b->notes, note);
    return ref;
}

IrRef build_as_f64(Builder *b, const Expr *e)
{
    return build_conversion(b, build_value(b, e), SM_F64, e->span);
}

IrRef build_as_bool(Builder *b, const Expr *e)
{
    return note_condition(b, e, 0, build_conversion(b, build_value(b, e), SM_BOOL, e->span));
}

// Appends the evaluation of an expression, and the conversion to `type` that a store to a variable of this type requires.
IrRef build_for_store(Builder *b, const Expr *e, SmType type)
{
    IrRef value = build_value(b, e);

    if (b->f->ins.at[value].type == type && type == SM_BOOL)
        return value;
    return emit_op(b, IR_cvt, type, build_conversion(b, value, SM_F64, e->span), IR_NONE, e->span);  // also F64 to F64: NaN becomes 0
}

static IrRef build_var(Builder *b, const Expr *e)
{
    const Var *v = e->var;
    IrIns i = {.op = IR_load, .type = v->type, .a = IR_NONE, .b = IR_NONE, .var = b->var[v->index], .span = e->span};
    IrRef value;

    if (i.var == IR_NONE)                             // a local that is a constant
        return v->type == SM_BOOL ? emit_const(b, SM_BOOL, v->init, e->span)
                                  : emit_const(b, SM_F64, sm_bits(sm_cell_to_f64(v->type, v->init)), e->span);
    value = build_emit(b, &i);
    return v->type == SM_BOOL ? value : build_conversion(b, value, SM_F64, e->span);
}

// ---- operators ----

static IrRef build_binary(Builder *b, const Expr *e)
{
    IrOp op = ir_op_of_operator(e->op);
    bool logic = ir_op_info[op].types == IR_T_LOGIC;
    IrRef x = logic ? build_as_bool(b, e->arg[0]) : build_as_f64(b, e->arg[0]);
    IrRef y = logic ? build_as_bool(b, e->arg[1]) : build_as_f64(b, e->arg[1]);

    return emit_op(b, op, ir_op_info[op].types == IR_T_SAME ? SM_F64 : SM_BOOL, x, y, e->span);
}

// Builds a chain of comparisons: `a < b <= c` means `a < b and b <= c`, with b evaluated once.
static IrRef build_chain(Builder *b, const Expr *e)
{
    IrRef left = build_as_f64(b, e->arg[0]), all = IR_NONE;

    for (uint32_t k = 1; k < e->n; k++) {
        IrRef right = build_as_f64(b, e->arg[k]);
        IrRef is_true = note_condition(b, e, k, emit_op(b, ir_op_of_operator(expr_ops(e)[k - 1]), SM_BOOL, left, right, e->span));
        all = all == IR_NONE ? is_true : emit_op(b, IR_and, SM_BOOL, all, is_true, e->span);
        left = right;
    }
    return all;
}

// ---- builtins ----

// Appends one operation of a function such as median (list.h); v: the temporaries of the list's values and of the earlier operations.
static IrRef build_list_step(Builder *b, const ListStep *s, const IrRef *v, Span span)
{
    static const IrOp op_of[] = {[LIST_MIN] = IR_min, [LIST_MAX] = IR_max, [LIST_ADD] = IR_add, [LIST_SUB] = IR_sub, [LIST_DIV] = IR_div};

    switch (s->op) {
    case LIST_NUMBER: return emit_const(b, SM_F64, sm_bits(s->number), span);
    case LIST_NEG: return emit_op(b, IR_neg, SM_F64, v[s->a], IR_NONE, span);
    case LIST_LT: return build_conversion(b, emit_op(b, IR_lt, SM_BOOL, v[s->a], v[s->b], span), SM_F64, span);
    default: return emit_op(b, op_of[s->op], SM_F64, v[s->a], v[s->b], span);
    }
}

// Builds a call of min, max, median or average, whose arguments have been built.
static IrRef build_list(Builder *b, const Expr *e, const IrRef *argument)
{
    IrRef *const v = b->list_value;
    const uint32_t steps = list_steps(e->fn, e->n, b->list_step);

    for (uint32_t i = 0; i < e->n; i++)
        v[i] = argument[i];
    for (uint32_t i = 0; i < steps; i++)
        v[e->n + i] = build_list_step(b, &b->list_step[i], v, e->span);
    return v[e->n + steps - 1];
}

// Builds a call of a builtin: one operation, or several for a composed one (SM_COMPOSED in builtins.def).
static IrRef build_call(Builder *b, const Expr *e)
{
    enum { MOST_VALUES = SM_LIST_MAX };               // v[]: the arguments, then the results of the operations of a composed function
    IrRef v[MOST_VALUES];
    uint32_t n = 0;

    while (n < e->n) {
        v[n] = build_as_f64(b, e->arg[n]);
        n++;
    }
    switch (e->fn) {
#define STEP1(name, x) v[n++] = emit_op(b, IR_##name, SM_F64, v[x], IR_NONE, e->span);
#define STEP2(name, x, y) v[n++] = emit_op(b, IR_##name, SM_F64, v[x], v[y], e->span);
#define SM_PURE(name, arguments, usage, units, sentence) \
    case SM_FN_##name: v[n++] = emit_op(b, IR_##name, SM_F64, v[0], arguments > 1 ? v[1] : IR_NONE, e->span); break;
#define SM_COMPOSED(name, arguments, usage, units, steps, sentence) \
    case SM_FN_##name: steps break;
#define SM_LIST(name, units, sentence) case SM_FN_##name: return build_list(b, e, v);
#define SM_ROLL(name, stat, sentence) case SM_FN_##name:
#define SM_SAMPLED(name, arguments, usage, sentence) case SM_FN_##name:
#include "stdlib/builtins.def"
#undef STEP1
#undef STEP2
    case SM_FN_COUNT: break;                          // not reached: roll calls are EX_ROLL, not EX_CALL
    }
    return v[n - 1];
}

static IrRef build_any(Builder *b, const Expr *e)
{
    IrIns stat = {.op = IR_stat, .type = SM_F64, .a = IR_NONE, .b = IR_NONE, .span = e->span};
    IrRef value;

    switch (e->kind) {
    case EX_NUMBER: return emit_const(b, SM_F64, sm_bits(e->number), e->span);
    case EX_VAR: return build_var(b, e);
    case EX_UNARY:
        if (e->op == SM_OP_NOT)
            return emit_op(b, IR_not, SM_BOOL, build_as_bool(b, e->arg[0]), IR_NONE, e->span);
        value = build_as_f64(b, e->arg[0]);
        return e->op == SM_OP_NEG ? emit_op(b, IR_neg, SM_F64, value, IR_NONE, e->span) : value;
    case EX_BINARY: return build_binary(b, e);
    case EX_CHAIN: return build_chain(b, e);
    case EX_CALL: return build_call(b, e);
    case EX_ROLL:
        stat.var = b->window[e->window];
        stat.stat = e->stat;
        return build_emit(b, &stat);
    case EX_EVERY: case EX_AT: case EX_RANDOM: break;                       // not reached: only scripts have these
    }
    return IR_NONE;
}

static IrRef build_value(Builder *b, const Expr *e)
{
    IrRef value = build_any(b, e);

    return b->f->ins.at[value].type == SM_BOOL ? note_condition(b, e, 0, value) : value;
}
