// SPDX-License-Identifier: Apache-2.0
// narrow: moves F64 operations to the types of their inputs, where facts (the possible values, facts/facts.h) prove that the difference is
// not observable.
//   sums, products, …   of whole numbers whose results stay below 2^53 become operations on I32 or I64.  F64 is exact there, too.  Only the
//                       sign of a zero is lost, so it must not be observable (by a store to a float, a division, …)
//   abs, min, max       of large I64 that convert to F64 and back without a change become operations on I64
//   neg, abs            of an F32 become operations on F32
//   op, then to F32     an operation on F32 operands whose result is only converted to F32 becomes an operation on F32.  The intermediate
//                       rounding to F64 changes nothing, because F64 has more than twice the digits of F32, plus two
//   comparisons         see narrow_compare.c
//   conversions         of a number that is also available in a narrower type convert from that type.  There and back, they are removed
//                       where they change nothing
//   windows             store samples in the narrowest type that represents all of them
// Needs values (FACT_VALUES); invalidates use counts.  dce removes the operations that become unused.
#include "compiler/passes/narrow.h"

#include <string.h>

#include "compiler/passes/pass.h"
#include "stdlib/convert.h"

// Appends a new instruction to n->out.
IrRef narrow_emit(Narrow *n, IrIns i)
{
    vec_push(n->arena, &n->f->ins, i);
    vec_push(n->work, &n->out, (IrRef)(n->f->ins.n - 1));
    return (IrRef)(n->f->ins.n - 1);
}

static IrIns make_ins(IrOp op, SmType type, IrRef a, IrRef b, Span span)
{
    const IrIns i = {.op = op, .type = type, .a = a, .b = b, .span = span};

    return i;
}

IrRef narrow_const(Narrow *n, SmType type, double x, Span span)
{
    IrIns i = make_ins(IR_const, type, IR_NONE, IR_NONE, span);

    i.bits = sm_cell_from_f64(type, x);
    return narrow_emit(n, i);
}

// Whether r is a constant number, not NaN; sets *x.
bool narrow_is_const(const Narrow *n, IrRef r, double *x)
{
    const IrIns *i = narrow_ins(n, r);

    if (i->op != IR_const || i->type != SM_F64)
        return false;
    *x = sm_from_bits(i->bits);
    return !sm_is_nan(*x);
}

// ---- where the difference between -0 and 0 is observable ----

static void mark_zero_sign(Narrow *n, IrRef r, bool is_observable) { n->zero_sign_observable[r] |= is_observable; }

static bool can_be_zero(Fact a) { return a.lo <= 0 && a.hi >= 0; }

// Marks the operands of ref for which -0 instead of 0 would be observable.  Users are visited before their operands, so the mark of ref is
// already final.
static void mark_operand_zero_signs(Narrow *n, IrRef ref)
{
    const IrIns *i = narrow_ins(n, ref);
    const bool of_result = n->zero_sign_observable[ref];

    if (ir_op_info[i->op].operands == 2) {
        const Fact a = n->fact[i->a], b = n->fact[i->b];
        if (i->op == IR_add) {                            // only -0 + -0 is -0
            mark_zero_sign(n, i->a, of_result && b.minus_zero);
            mark_zero_sign(n, i->b, of_result && a.minus_zero);
        } else if (i->op == IR_sub) {                     // only -0 - 0 is -0
            mark_zero_sign(n, i->a, of_result && can_be_zero(b));
            mark_zero_sign(n, i->b, of_result && a.minus_zero);
        } else if (i->op == IR_div) {
            mark_zero_sign(n, i->a, of_result);
            mark_zero_sign(n, i->b, can_be_zero(b));
        } else if (ir_op_info[i->op].types == IR_T_SAME) {
            const bool in_number = i->op == IR_pow || i->op == IR_atan2;      // pow(-0, -1) is -inf, and atan2(-0, -1) is -pi
            mark_zero_sign(n, i->a, of_result || in_number);
            mark_zero_sign(n, i->b, of_result || in_number);
        }
    } else if (i->op == IR_store || i->op == IR_sample)
        mark_zero_sign(n, i->a, true);
    else if (ir_op_info[i->op].operands == 1)
        mark_zero_sign(n, i->a, of_result && ir_is_float(i->type) && i->op != IR_abs);
}

// ---- integers ----

// Whether the number of temporary r is also available as a temporary of an integer type or bool, or as a constant.
bool narrow_has_integer(const Narrow *n, IrRef r)
{
    const Fact f = n->fact[r];
    double x;

    if (narrow_is_const(n, r, &x) && f.whole && fact_within(f, -FACT_EXACT, FACT_EXACT) && !f.minus_zero)
        return true;                                  // a constant that I64 represents
    return n->narrow[r] != IR_NONE && narrow_ins(n, n->narrow[r])->type != SM_F32;
}

static bool fits_i32(const Narrow *n, IrRef r) { return r == IR_NONE || fact_within(n->fact[r], INT32_MIN, INT32_MAX); }

// Returns I32 if r, a and b fit (IR_NONE is ignored), else I64.
SmType narrow_common_integer(const Narrow *n, IrRef r, IrRef a, IrRef b)
{
    return fits_i32(n, r) && fits_i32(n, a) && fits_i32(n, b) ? SM_I32 : SM_I64;
}

// Returns r's number as I32 or I64; `type` must be able to represent it.
IrRef narrow_get_integer(Narrow *n, IrRef r, SmType type)
{
    IrRef *made = type == SM_I32 ? &n->as_i32[r] : &n->as_i64[r];
    const Span span = narrow_ins(n, r)->span;
    double x;

    if (*made != IR_NONE)
        return *made;
    if (narrow_is_const(n, r, &x))
        *made = narrow_const(n, type, x, span);
    else if (narrow_ins(n, n->narrow[r])->type == type)
        *made = n->narrow[r];
    else
        *made = narrow_emit(n, make_ins(IR_cvt, type, n->narrow[r], IR_NONE, span));
    return *made;
}

// Emits i, which computes ref's number in a narrower type, and changes ref into a conversion of the result of i to F64.
static void replace_by_narrow(Narrow *n, IrRef ref, IrIns i)
{
    n->narrow[ref] = narrow_emit(n, i);
    *narrow_ins(n, ref) = make_ins(IR_cvt, SM_F64, n->narrow[ref], IR_NONE, i.span);
}

// Moves an operation on whole numbers to I32 or I64, if its result is a whole number below 2^53.  A result of 2^53 is not allowed, because
// it may be the rounding of a larger number: 1 + 2^53 is 2^53 on F64, but not on I64.
static void narrow_to_integer(Narrow *n, IrRef ref)
{
    IrIns i = *narrow_ins(n, ref);
    const bool two = ir_op_info[i.op].operands == 2;
    const Fact result = n->fact[ref];

    if (!(ir_op_info[i.op].narrow & IR_N_INT) || i.type != SM_F64 || !narrow_has_integer(n, i.a) || (two && !narrow_has_integer(n, i.b)))
        return;
    if (!result.whole || !fact_within(result, -FACT_EXACT + 1, FACT_EXACT - 1) || (result.minus_zero && n->zero_sign_observable[ref]))
        return;
    i.type = narrow_common_integer(n, ref, i.a, two ? i.b : IR_NONE);
    i.a = narrow_get_integer(n, i.a, i.type);
    if (two)
        i.b = narrow_get_integer(n, i.b, i.type);
    replace_by_narrow(n, ref, i);
}

// ---- large integers ----

bool narrow_same_round_trip(const Narrow *n, IrRef a, IrRef b)
{
    return n->round_trips[a] && n->round_trips[b] && narrow_ins(n, n->wide[a])->type == narrow_ins(n, n->wide[b])->type;
}

// Moves abs, min and max of I64s that round-trip to I64.  The results round-trip, too: abs of -2^63 is 2^63 on F64 and the largest I64 on I64,
// which convert to each other.
static void narrow_to_round_trip(Narrow *n, IrRef ref)
{
    IrIns i = *narrow_ins(n, ref);

    if (i.type != SM_F64 || (i.op != IR_abs && i.op != IR_min && i.op != IR_max))
        return;
    if (!narrow_same_round_trip(n, i.a, i.op == IR_abs ? i.a : i.b) || narrow_ins(n, n->wide[i.a])->type != SM_I64)
        return;
    i.type = SM_I64;
    i.a = n->wide[i.a];
    if (i.op != IR_abs)
        i.b = n->wide[i.b];
    n->wide[ref] = narrow_emit(n, i);
    n->round_trips[ref] = true;
    *narrow_ins(n, ref) = make_ins(IR_cvt, SM_F64, n->wide[ref], IR_NONE, i.span);
}

// ---- F32 ----

// Moves neg and abs of an F32 to F32.  Their results are exact there, so every user gets the same number.
static void narrow_neg_or_abs(Narrow *n, IrRef ref)
{
    IrIns i = *narrow_ins(n, ref);

    if ((i.op != IR_neg && i.op != IR_abs) || i.type != SM_F64 || n->narrow[i.a] == IR_NONE || narrow_ins(n, n->narrow[i.a])->type != SM_F32)
        return;
    i.type = SM_F32;
    i.a = n->narrow[i.a];
    replace_by_narrow(n, ref, i);
}

// Whether r's number is available as an F32.  Sets *is_variable if r is not a constant.
static bool match_f32_operand(const Narrow *n, IrRef r, bool *is_variable)
{
    double x;

    if (narrow_is_const(n, r, &x))
        return n->fact[r].f32;
    *is_variable = true;
    return n->narrow[r] != IR_NONE && narrow_ins(n, n->narrow[r])->type == SM_F32;
}

static IrRef emit_f32_operand(Narrow *n, IrRef r)
{
    double x;

    return narrow_is_const(n, r, &x) ? narrow_const(n, SM_F32, x, narrow_ins(n, r)->span) : n->narrow[r];
}

// Narrows an operation on F32 operands whose only user is `cvt`, a conversion to F32.
static void narrow_to_f32(Narrow *n, IrRef cvt)
{
    const IrRef r = narrow_ins(n, cvt)->a;
    IrIns i = *narrow_ins(n, r);
    const bool two = ir_op_info[i.op].operands == 2;
    bool is_variable = false;
    IrRef f32;

    if (!(ir_op_info[i.op].narrow & IR_N_F32) || i.type != SM_F64 || n->uses[r] != 1 || !match_f32_operand(n, i.a, &is_variable)
        || (two && !match_f32_operand(n, i.b, &is_variable)) || !is_variable)
        return;
    i.type = SM_F32;
    i.a = emit_f32_operand(n, i.a);
    if (two)
        i.b = emit_f32_operand(n, i.b);
    f32 = narrow_emit(n, i);
    narrow_ins(n, cvt)->a = f32;
}

// ---- conversions ----

// Removes a conversion whose operand already exists in its type, or makes it convert from the narrower form of its operand.
static void narrow_conversion(Narrow *n, IrRef ref)
{
    IrIns *i = narrow_ins(n, ref);
    const bool from_f64 = narrow_ins(n, i->a)->type == SM_F64;
    IrRef from = from_f64 ? n->narrow[i->a] : IR_NONE, back = from_f64 && n->round_trips[i->a] ? n->wide[i->a] : from;
    SmType type;

    if (back != IR_NONE && narrow_ins(n, back)->type == i->type) {
        n->same[ref] = back;
        return;
    }
    if (from != IR_NONE)
        i->a = from;
    else if (i->type == SM_F32)
        narrow_to_f32(n, ref);                            // adds instructions, so i may be a dangling pointer from here on
    if (narrow_ins(n, ref)->type != SM_F64)
        return;
    from = narrow_ins(n, ref)->a;                         // a conversion to F64: its operand is the same number in a narrower type
    type = narrow_ins(n, from)->type;
    if (type == SM_F64)
        return;
    if (sm_type_info[type].bytes < 8 || fact_within(n->fact[ref], -FACT_EXACT + 1, FACT_EXACT - 1))
        n->narrow[ref] = from;
    else {
        n->wide[ref] = from;
        n->round_trips[ref] = from < n->temps && n->fact[from].round_trips;
    }
}

// ---- functions ----

static void narrow_instruction(Narrow *n, IrRef ref)
{
    IrIns *i = narrow_ins(n, ref);

    if (ir_op_info[i->op].operands > 0)
        i->a = n->same[i->a];
    if (ir_op_info[i->op].operands > 1)
        i->b = n->same[i->b];
    if (i->op == IR_cvt)
        narrow_conversion(n, ref);
    else if (i->op == IR_sample && narrow_ins(n, i->a)->type == SM_F64 && n->narrow[i->a] != IR_NONE)
        i->a = n->narrow[i->a];
    else if (ir_op_info[i->op].types == IR_T_COMPARE)
        narrow_compare(n, ref);
    else if (ir_op_info[i->op].types == IR_T_SAME) {
        narrow_neg_or_abs(n, ref);
        narrow_to_integer(n, ref);
        narrow_to_round_trip(n, ref);
    }
    vec_push(n->work, &n->out, ref);
}

static void narrow_block(Narrow *n, IrBlk *blk)
{
    n->out.n = 0;
    for (size_t k = blk->ins.n; k-- > 0;)
        mark_operand_zero_signs(n, blk->ins.at[k]);
    for (size_t k = 0; k < blk->ins.n; k++)
        narrow_instruction(n, blk->ins.at[k]);
    if (blk->jump.kind == IR_BR)
        blk->jump.cond = n->same[blk->jump.cond];
    if (n->out.n > blk->ins.cap) {
        blk->ins.at = ARENA_ARRAY(n->arena, IrRef, n->out.n);
        blk->ins.cap = n->out.n;
    }
    if (n->out.n)
        memcpy(blk->ins.at, n->out.at, n->out.n * sizeof *n->out.at);
    blk->ins.n = n->out.n;
}

// Returns a table of `count` temporaries, all IR_NONE.
static IrRef *new_empty_refs(Arena *arena, size_t count)
{
    IrRef *r = ARENA_ARRAY(arena, IrRef, count);

    memset(r, 0xff, count * sizeof *r);
    return r;
}

static void narrow_function(Arena *arena, Arena *work, IrFn *f, FactFlow flow)
{
    const size_t temps = f->ins.n;
    Narrow n = {.arena = arena, .work = work, .f = f, .temps = temps, .fact = flow.of, .uses = ir_count_uses(work, f)};

    n.same = ARENA_ARRAY(work, IrRef, temps);
    for (size_t r = 0; r < temps; r++)
        n.same[r] = (IrRef)r;
    n.narrow = new_empty_refs(work, temps);
    n.wide = new_empty_refs(work, temps);
    n.round_trips = ARENA_ARRAY(work, bool, temps);
    n.as_i32 = new_empty_refs(work, temps);
    n.as_i64 = new_empty_refs(work, temps);
    n.zero_sign_observable = ARENA_ARRAY(work, bool, temps);
    for (size_t b = 0; b < f->blk.n; b++)
        if (flow.reached[b])
            narrow_block(&n, &f->blk.at[b]);
}

// ---- windows ----

// Returns the smallest type that holds every sample with this fact.
static SmType narrowest_window_type(Fact sample)
{
    static const SmType whole[] = {SM_U8, SM_I8, SM_U16, SM_I16, SM_I32, SM_U32};

    for (size_t t = 0; sample.whole && !sample.minus_zero && t < sizeof whole / sizeof *whole; t++)
        if (fact_fits(sample, whole[t]))
            return whole[t];
    return sample.f32 ? SM_F32 : SM_F64;
}

// The pass `narrow`: moves arithmetic from F64 to narrower types where the result is the same bit for bit.
void pass_narrow(Arena *arena, IrMachine *m, FactMachine *values)
{
    for (uint32_t w = 0; w < m->window.n; w++)
        if (!ir_stores_times(&m->window.at[w]))
            m->window.at[w].type = narrowest_window_type(facts_of_window(values, w));
    pass_on_each_function(arena, m, values, narrow_function);
}
