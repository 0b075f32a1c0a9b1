// SPDX-License-Identifier: Apache-2.0
// Writes conversions.  A C cast is used where it has the same result: where the value cannot be NaN, saturate or lose more than its fraction.
// Otherwise functions of stdlib are called.
#include "compiler/emit/c/fn.h"
#include "stdlib/convert.h"

static unsigned bit_width(SmType t) { return sm_type_info[t].bytes * 8u; }
static bool is_signed(SmType t) { return sm_type_info[t].kind == SM_KIND_SIGNED; }

// Whether r is a conversion of an integer to an integer type that can represent all its values, and is written as a subexpression.
bool c_is_widening(const CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);

    return !c_is_const(fn, r) && fn->ins[r].form == C_SUBEXPRESSION && i->op == IR_cvt && ir_is_integer(i->type) &&
           ir_is_integer(c_ins(fn, i->a)->type) && ir_integer_contains(i->type, c_ins(fn, i->a)->type);
}

// Writes r as the value of an assignment or an argument, where C converts it implicitly to the type of r.
void c_write_assigned(CFn *fn, IrRef r)
{
    while (c_is_widening(fn, r))
        r = c_ins(fn, r)->a;
    c_write_value(fn, r, PREC_ANY);
}

// ---- parts of conversions ----

static const char *const to_helper[SM_TYPE_COUNT] = {
    [SM_I8] = "sm_to_i8", [SM_I16] = "sm_to_i16", [SM_I32] = "sm_to_i32", [SM_I64] = "sm_to_i64", [SM_U8] = "sm_to_u8",
    [SM_U16] = "sm_to_u16", [SM_U32] = "sm_to_u32", [SM_U64] = "sm_to_u64", [SM_F32] = "sm_to_f32", [SM_F64] = "sm_to_f64",
    [SM_BOOL] = "sm_to_bool",
};

// Writes the bool r as `r ? 1 : 0`, with literals of type `to`.
static void write_bool_as_number(CFn *fn, IrRef r, SmType to, int prec)
{
    const bool opened = c_open_parens(fn, PREC_ANY, prec);

    c_write_condition(fn, r, false, PREC_OR);
    c_write(fn, to == SM_F64 && fn->u->soft ? " ? sm_from_bits(0x3FF0000000000000u /* 1.0 */) : sm_from_bits(0 /* 0.0 */)" : to == SM_F64
            ? " ? 1.0 : 0.0" : to == SM_F32 ? " ? 1.0f : 0.0f" : to == SM_I64 ? " ? INT64_C(1) : 0" :
        to == SM_I32 ? " ? INT32_C(1) : 0" : " ? 1 : 0");
    c_close_parens(fn, opened);
}

// Whether r is a load of an F32 element that is written as a subexpression.  c_write_float_load can write such a load as a double.
static bool is_f32_load_subexpression(const CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);

    return i->op == IR_load && i->type == SM_F32 && fn->u->m->var.at[i->var].space == IR_ELEMENT && fn->ins[r].form == C_SUBEXPRESSION;
}

// Whether a double can represent every value of integer r exactly.  Facts store bounds as doubles: a bound of 2^53 can be a rounded 2^53 + 1.
static bool is_exact_as_double(const CFn *fn, IrRef r) { return fact_within(fn->ins[r].fact, -FACT_EXACT + 1, FACT_EXACT - 1); }

// Writes r converted to `to` as a C cast, or as a call where a cast would be wrong.  `to` must be able to represent r, truncated or rounded.
static void write_cast(CFn *fn, SmType to, IrRef r, int prec)
{
    const SmType from = c_ins(fn, r)->type;
    bool opened;

    if (c_is_soft(fn, from) || (c_is_soft(fn, to) && bit_width(from) > 16)) {
        soft_write_cast(fn, to, r);
        return;
    }
    if (to == SM_F64 && ir_is_integer(from) && bit_width(from) == 64 && !is_exact_as_double(fn, r)) {  // a C cast may not round correctly (f64.h)
        buf_printf(&fn->line, "%s(", helper_require(fn->u, from == SM_I64 ? "sm_from_i64" : "sm_from_u64"));
        c_write_value(fn, r, PREC_ANY);
        c_write(fn, ")");
        return;
    }
    opened = c_open_parens(fn, PREC_UNARY, prec);
    buf_printf(&fn->line, "(%s)", c_type_of(fn->u, to));
    c_write_value(fn, r, PREC_PRIMARY);
    c_close_parens(fn, opened);
}

// Writes the value, whatever its type, as a double.
void c_write_double(CFn *fn, IrRef r, int prec)
{
    const IrIns *i = c_ins(fn, r);

    if (c_is_const(fn, r) && i->type != SM_F64)
        c_write_constant(fn, r, SM_F64, sm_bits(sm_cell_to_f64(i->type, c_ins(fn, r)->bits)));
    else if (is_f32_load_subexpression(fn, r))
        c_write_float_load(fn, r, SM_F64);
    else if (i->type == SM_F64)
        c_write_value(fn, r, prec);
    else if (i->type == SM_BOOL)
        write_bool_as_number(fn, r, SM_F64, prec);
    else if (fn->u->soft)
        soft_write_to_f64(fn, r);
    else
        write_cast(fn, SM_F64, r, prec);
}

// Writes `helper(r)`, with r as a double.
static void write_call_on_double(CFn *fn, const char *helper, IrRef r)
{
    c_write(fn, helper_require(fn->u, helper));
    c_write(fn, "(");
    c_write_double(fn, r, PREC_ANY);
    c_write(fn, ")");
}

// Writes `r != 0`, or `r == 0` if negated, for a number r that is never NaN.
void c_write_nonzero_test(CFn *fn, IrRef r, bool negated, int prec)
{
    const SmType type = c_ins(fn, r)->type;
    bool opened;

    if (c_is_soft(fn, type)) {
        soft_write_nonzero_test(fn, r, negated);
        return;
    }
    opened = c_open_parens(fn, PREC_EQ, prec);
    c_write_value(fn, r, PREC_REL);
    c_write(fn, negated ? " == " : " != ");
    c_write(fn, type == SM_F64 ? "0.0" : type == SM_F32 ? "0.0f" : "0");
    c_close_parens(fn, opened);
}

// ---- integer to integer ----

static const char *const type_min[SM_TYPE_COUNT] = {
    [SM_I8] = "INT8_MIN", [SM_I16] = "INT16_MIN", [SM_I32] = "INT32_MIN", [SM_I64] = "INT64_MIN",
    [SM_U8] = "0", [SM_U16] = "0", [SM_U32] = "0", [SM_U64] = "0",
};
static const char *const type_max[SM_TYPE_COUNT] = {
    [SM_I8] = "INT8_MAX", [SM_I16] = "INT16_MAX", [SM_I32] = "INT32_MAX", [SM_I64] = "INT64_MAX",
    [SM_U8] = "UINT8_MAX", [SM_U16] = "UINT16_MAX", [SM_U32] = "UINT32_MAX", [SM_U64] = "UINT64_MAX",
};

// Returns the type in which a value is clamped: I32 if that can represent all values of `from`, otherwise I64.
static SmType clamping_type(SmType from) { return ir_integer_contains(SM_I32, from) ? SM_I32 : SM_I64; }

// Writes integer r clamped to the limits of `to` and of the clamping type.
static void write_clamped(CFn *fn, IrRef r, SmType to, int prec)
{
    const SmType from = c_ins(fn, r)->type, in = clamping_type(from);
    const bool opened = c_open_parens(fn, PREC_UNARY, prec);

    c_write(fn, "(");
    c_write(fn, c_type_of(fn->u, to));
    c_write(fn, ")");
    c_write(fn, helper_require(fn->u, from == SM_U64 ? "sm_clip_u64" : in == SM_I32 ? "sm_clip_i32" : "sm_clip_i64"));
    c_write(fn, "(");
    c_write_assigned(fn, r);
    if (from != SM_U64)
        buf_printf(&fn->line, ", %s", is_signed(to) && bit_width(to) > bit_width(in) ? type_min[in] : type_min[to]);
    buf_printf(&fn->line, ", %s)", from == SM_U64 || ir_integer_contains(in, to) ? type_max[to] : type_max[in]);
    c_close_parens(fn, opened);
}

// Whether the conversion of integer r to `to` must round it to an F64 first, because an F64 cannot represent all its values.
static bool converts_through_double(const CFn *fn, IrRef r, SmType to)
{
    return bit_width(to) == 64 && bit_width(c_ins(fn, r)->type) == 64 && !is_exact_as_double(fn, r);
}

static void write_integer_to_integer(CFn *fn, IrRef r, SmType to, int prec)
{
    const SmType from = c_ins(fn, r)->type;

    if (converts_through_double(fn, r, to))
        write_call_on_double(fn, to_helper[to], r);
    else if (from == to)
        c_write_value(fn, r, prec);
    else if (ir_integer_contains(to, from) || fact_fits(fn->ins[r].fact, to))
        write_cast(fn, to, r, prec);
    else
        write_clamped(fn, r, to, prec);
}

// ---- float to integer ----

// Whether every value of x, truncated to a whole number, is in the range of integer type `to`.
static bool fits_when_truncated(Fact x, SmType to)
{
    const Fact t = fact_of_type(to);

    return bit_width(to) == 64 ? fact_fits(x, to) : !x.nan && x.lo > t.lo - 1 && x.hi < t.hi + 1;
}

// The F64 quotient of two integers, to be truncated.  C's 32-bit division x / d has the same result: a quotient that is not whole differs from
// every whole number by at least 1/d, so the nearest F64 is not whole either.  `x * 2^-k` counts as the division by 2^k.
typedef struct Quotient {
    IrRef x;                  // an integer that an I32 can represent
    double d;                 // a whole number from 2 to 2^31 - 1
} Quotient;

// If i is `x / d`, or `x * (1 / d)` where d is a power of two, and d is valid for a Quotient, stores d and returns true.
static bool match_divisor(const CFn *fn, const IrIns *i, double *d)
{
    if (!fact_is_number(fn->ins[i->b].fact, d) || (i->op != IR_div && i->op != IR_mul))
        return false;
    if (i->op == IR_mul)
        *d = 1 / *d;
    return *d >= 2 && *d <= 2147483647.0 && (double)(int32_t)*d == *d && (i->op == IR_div || ((int32_t)*d & ((int32_t)*d - 1)) == 0);
}

// If r is a quotient that a 32-bit division can compute, and is written as a subexpression, fills *q and returns true.
static bool match_quotient(const CFn *fn, IrRef r, Quotient *q)
{
    const IrIns *i = c_ins(fn, r), *a;

    if (c_is_const(fn, r) || fn->ins[r].form != C_SUBEXPRESSION || i->type != SM_F64 || (i->op != IR_div && i->op != IR_mul))
        return false;
    a = c_ins(fn, i->a);
    if (c_is_const(fn, i->a) || fn->ins[i->a].form != C_SUBEXPRESSION || a->op != IR_cvt || !c_is_const(fn, i->b))
        return false;
    q->x = a->a;
    return ir_is_integer(c_ins(fn, q->x)->type) && ir_integer_contains(SM_I32, c_ins(fn, q->x)->type) && match_divisor(fn, i, &q->d);
}

static void write_quotient(CFn *fn, const Quotient *q, int prec)
{
    const bool opened = c_open_parens(fn, PREC_MUL, prec);

    if (c_ins(fn, q->x)->type != SM_I32)
        write_cast(fn, SM_I32, q->x, PREC_MUL);
    else
        c_write_value(fn, q->x, PREC_MUL);
    buf_printf(&fn->line, " / %ld", (long)q->d);
    c_close_parens(fn, opened);
}

// Writes float r truncated to an I32.  The truncated value must be in the range of I32.
static void write_truncated_i32(CFn *fn, IrRef r, int prec)
{
    Quotient q;

    if (match_quotient(fn, r, &q))
        write_quotient(fn, &q, prec);
    else
        write_cast(fn, SM_I32, r, prec);
}

// Writes float r converted to integer type `to`.
static void write_truncated(CFn *fn, IrRef r, SmType to, int prec)
{
    const Fact x = fn->ins[r].fact;
    const bool fits = fits_when_truncated(x, to), in_i32 = fits_when_truncated(x, SM_I32);
    Quotient q;
    bool opened;

    if ((!fits && !(bit_width(to) < 32 && in_i32)) || (fits && !match_quotient(fn, r, &q))) {
        if (fits)
            write_cast(fn, to, r, prec);
        else
            write_call_on_double(fn, to_helper[to], r);
        return;
    }
    opened = c_open_parens(fn, to == SM_I32 ? PREC_MUL : PREC_UNARY, prec);
    if (to != SM_I32)
        buf_printf(&fn->line, "(%s)", c_type_of(fn->u, to));
    if (!fits)
        buf_printf(&fn->line, "%s(", helper_require(fn->u, "sm_clip_i32"));
    write_truncated_i32(fn, r, !fits ? PREC_ANY : to == SM_I32 ? PREC_MUL : PREC_PRIMARY);
    if (!fits)
        buf_printf(&fn->line, ", %s, %s)", type_min[to], type_max[to]);
    c_close_parens(fn, opened);
}

// ---- all conversions ----

static void write_to_float(CFn *fn, IrRef r, SmType to, int prec)
{
    const SmType from = c_ins(fn, r)->type;
    const bool nan = ir_is_float(from) && fn->ins[r].fact.nan;

    if (from == to && !nan)
        c_write_value(fn, r, prec);
    else if (to == SM_F64 && nan)
        write_call_on_double(fn, "sm_to_f64", r);
    else if (to == SM_F64)
        c_write_double(fn, r, prec);
    else if (from == SM_F32) {
        c_write(fn, helper_require(fn->u, "sm_no_nan_f32"));
        c_write(fn, "(");
        c_write_value(fn, r, PREC_ANY);
        c_write(fn, ")");
    } else if (nan)
        write_call_on_double(fn, "sm_to_f32", r);
    else if (from == SM_F64 || bit_width(from) < 64 || fn->u->soft)
        write_cast(fn, SM_F32, r, prec);
    else {
        c_write(fn, "(float)");               // rounded twice, since the language converts through F64
        write_cast(fn, SM_F64, r, PREC_UNARY);
    }
}

static void write_to_bool(CFn *fn, IrRef r, int prec)
{
    if (fn->ins[r].fact.nan)
        write_call_on_double(fn, "sm_to_bool", r);
    else
        c_write_nonzero_test(fn, r, false, prec);
}

// Writes the conversion i of the language: a NaN becomes 0, and integers saturate.
void c_write_conversion(CFn *fn, const IrIns *i, int prec)
{
    const SmType from = c_ins(fn, i->a)->type, to = i->type;

    if (from == SM_F64 && c_try_write_count(fn, i->a, to))
        return;
    if (from == SM_BOOL && to == SM_BOOL)
        c_write_value(fn, i->a, prec);
    else if (from == SM_BOOL)
        write_bool_as_number(fn, i->a, to, prec);
    else if (to == SM_BOOL)
        write_to_bool(fn, i->a, prec);
    else if (ir_is_float(to))
        write_to_float(fn, i->a, to, prec);
    else if (ir_is_integer(from))
        write_integer_to_integer(fn, i->a, to, prec);
    else
        write_truncated(fn, i->a, to, prec);
}
