// SPDX-License-Identifier: Apache-2.0
// Writes numbers for chips where `double` is not an IEEE binary64 (EmitCOptions.soft).  An F64 is an SmF64, the bits of a binary64, and operations
// on it are calls of the functions of sm_soft.h.  C's arithmetic on float is not used either, because its rounding is not guaranteed there: an
// F32 is computed as an F64 and rounded after each operation, which produces the same F32.  Integers are not affected.
#include "compiler/emit/c/emit_c.h"
#include "compiler/emit/c/fn.h"
#include "compiler/ir/comparison.h"
#include "soft_text.h"
#include "stdlib/convert.h"

// Whether t is a float type and its values are SmF64 in emitted C.
bool c_is_soft(const CFn *fn, SmType t) { return fn->u->soft && sm_type_info[t].kind == SM_KIND_FLOAT; }

// ---- conversions ----

static const char *const to_f64_helper[SM_TYPE_COUNT] = {
    [SM_I8] = "sm_from_i32", [SM_I16] = "sm_from_i32", [SM_I32] = "sm_from_i32", [SM_I64] = "sm_from_i64",
    [SM_U8] = "sm_from_i32", [SM_U16] = "sm_from_i32", [SM_U32] = "sm_from_u32", [SM_U64] = "sm_from_u64", [SM_F32] = "sm_from_f32",
};

static const char *const truncation_helper[SM_TYPE_COUNT] = {
    [SM_I8] = "(int8_t)sm_truncate_i32(", [SM_I16] = "(int16_t)sm_truncate_i32(", [SM_I32] = "sm_truncate_i32(", [SM_I64] = "sm_truncate_i64(",
    [SM_U8] = "(uint8_t)sm_truncate_i32(", [SM_U16] = "(uint16_t)sm_truncate_i32(", [SM_U32] = "sm_truncate_u32(", [SM_U64] = "sm_truncate_u64(",
};

static void write_arithmetic_call(CFn *fn, const IrIns *i)
{
    c_write(fn, i->op == IR_add ? "sm_add(" : i->op == IR_sub ? "sm_sub(" : i->op == IR_mul ? "sm_mul(" : "sm_div(");
    c_write_double(fn, i->a, PREC_ANY);
    c_write(fn, ", ");
    c_write_double(fn, i->b, PREC_ANY);
    c_write(fn, ")");
}

// Writes an integer or F32 that is not a constant as an SmF64.
void soft_write_to_f64(CFn *fn, IrRef r)
{
    c_write(fn, to_f64_helper[c_ins(fn, r)->type]);
    c_write(fn, "(");
    c_write_value(fn, r, PREC_ANY);
    c_write(fn, ")");
}

// Writes a float that is in range as an integer, or any number as an F32.
void soft_write_cast(CFn *fn, SmType to, IrRef r)
{
    if (to != SM_F32 && c_try_write_whole_median(fn, to, r))
        return;
    c_write(fn, to == SM_F32 ? "sm_round_f32(" : truncation_helper[to]);
    c_write_double(fn, r, PREC_ANY);
    c_write(fn, ")");
}

// ---- arithmetic ----

// Writes the add, sub, mul or div of two floats.
void soft_write_binary(CFn *fn, const IrIns *i)
{
    c_write(fn, i->type == SM_F32 ? "sm_round_f32(" : "");
    write_arithmetic_call(fn, i);
    c_write(fn, i->type == SM_F32 ? ")" : "");
}

void soft_write_compare(CFn *fn, const IrIns *i, bool negated)
{
    const bool equality = ir_is_equality(i->op), swap = i->op == IR_gt || i->op == IR_ge;

    c_write(fn, negated != (i->op == IR_ne) ? "!" : "");
    c_write(fn, equality ? "sm_eq(" : i->op == IR_lt || i->op == IR_gt ? "sm_lt(" : "sm_le(");
    c_write_double(fn, swap ? i->b : i->a, PREC_ANY);
    c_write(fn, ", ");
    c_write_double(fn, swap ? i->a : i->b, PREC_ANY);
    c_write(fn, ")");
}

// ---- comparisons that read only some bytes ----

// A comparison of a variable with a constant.
typedef struct ByteCompare {
    IrRef operand;            // the operand that is the variable's value: `load`, or the conversion of `load` from F32 to F64
    IrRef load, constant;
    IrOp op;                  // the comparison, written with the variable as left operand
} ByteCompare;

// If numbers are soft and i compares a variable with a constant by < <= > or >=, fills *l and returns true.
static bool match_constant_compare(const CFn *fn, const IrIns *i, ByteCompare *l)
{
    const bool swap = c_is_const(fn, i->a);

    if (!fn->u->soft || ir_is_equality(i->op))
        return false;
    l->operand = l->load = swap ? i->b : i->a;
    l->constant = swap ? i->a : i->b;
    l->op = swap ? ir_swapped_comparison(i->op) : i->op;
    if (c_ins(fn, l->operand)->op == IR_cvt && c_ins(fn, l->operand)->type == SM_F64 && c_ins(fn, c_ins(fn, l->operand)->a)->type == SM_F32)
        l->load = c_ins(fn, l->operand)->a;
    return c_ins(fn, l->load)->op == IR_load && c_is_const(fn, l->constant) && !c_is_const(fn, l->operand);
}

// Returns the constant of the comparison.
static double constant_value(const CFn *fn, const ByteCompare *l)
{
    return sm_cell_to_f64(c_ins(fn, l->constant)->type, c_ins(fn, l->constant)->bits);
}

// Whether the upper 32 bits of an F64 variable do not decide the comparison, because the constant has bits in the lower half.  Also true if the
// constant is not finite, if the variable is not a float, or if it is an F32 and the constant is not an F32 number.
static bool needs_lower_half(const CFn *fn, const ByteCompare *l)
{
    const double x = constant_value(fn, l);
    const SmType t = c_ins(fn, l->load)->type;

    return (t != SM_F64 && t != SM_F32) || (sm_bits(x) & 0xffffffffu) != 0 || !(x - x == 0) || (t == SM_F32 && (double)sm_round_f32(x) != x);
}

bool soft_compares_bytes(const CFn *fn, const IrIns *i, IrRef x)
{
    ByteCompare l;

    return match_constant_compare(fn, i, &l) && x == l.operand && !needs_lower_half(fn, &l);
}

// Writes the address of the value that l compares: of the C variable of the operand's temporary, or of the struct member that is loaded.  For an
// F32, writes the value instead.
static void write_address_of_compared(CFn *fn, const ByteCompare *l)
{
    const IrRef r = fn->ins[l->operand].variable ? l->operand : l->load;

    c_write(fn, c_ins(fn, r)->type != SM_F32 ? "&" : "");
    if (fn->ins[r].variable)
        c_write(fn, fn->ins[r].variable);
    else
        c_write_member(fn, c_ins(fn, r)->var);
}

// Writes a comparison of a float as a call of sm_soft_beyond or sm_soft_reaches, which compare away from zero, in the direction of the sign of the
// constant: x > 5 is beyond 5, x >= 5 reaches 5, x < 5 is the negation of that; x < -5 is beyond -5.  For 0 only sm_soft_beyond is used.
static void write_float_compare(CFn *fn, const ByteCompare *l, bool negated)
{
    const double x = constant_value(fn, l);
    const bool less = l->op == IR_lt || l->op == IR_le, strict = l->op == IR_lt || l->op == IR_gt;
    const bool negative = x == 0 ? less == strict : x < 0, out = less == negative;
    const IrRef at = fn->ins[l->operand].variable ? l->operand : l->load;
    const bool is_f32 = c_ins(fn, at)->type == SM_F32;
    const uint32_t n = is_f32 ? sm_f32_bits(sm_round_f32(x)) : (uint32_t)(sm_bits(x) >> 32);
    const char *name = remark_constant_name(fn->u, c_ins(fn, l->constant)->span);

    buf_printf(&fn->line, "%s%s%s(", negated == out ? "!" : "", strict == out ? "sm_soft_beyond" : "sm_soft_reaches", is_f32 ? "_f32" : "");
    write_address_of_compared(fn, l);
    buf_printf(&fn->line, ", 0x%08lXu /* ", (unsigned long)((n & 0x7FFFFFFFu) | (negative ? 0x80000000u : 0)));
    literal_write_finite(&fn->line, x);
    buf_printf(&fn->line, "%s%s */)", *name ? ", " : "", name);
}

// Writes a comparison of a U64 variable with n, which has at most 32 bits, as a call of sm_soft_exceeds or sm_soft_elapsed_exceeds.
static void write_integer_compare(CFn *fn, const ByteCompare *l, uint64_t n, bool negated)
{
    const bool less = l->op == IR_lt || l->op == IR_le, exact = l->op == IR_gt || l->op == IR_le;
    const char *name = remark_constant_name(fn->u, c_ins(fn, l->constant)->span);
    const bool is_time = fn->u->m->var.at[c_ins(fn, l->load)->var].space == IR_TIME;

    c_write(fn, negated != less ? "!" : "");
    c_write(fn, is_time ? "sm_soft_elapsed_exceeds(&m->start_, &" : "sm_soft_exceeds(&");
    c_write_member(fn, is_time ? fn->u->m->g : c_ins(fn, l->load)->var);
    fn->uses_m = fn->uses_m || is_time;
    buf_printf(&fn->line, ", %lu%s%s%s)", (unsigned long)(exact ? n : n - 1), *name && exact ? " /* " : "", exact ? name : "",
               *name && exact ? " */" : "");
}

// Whether write_integer_compare can write the comparison.
static bool can_compare_integer_bytes(const CFn *fn, const ByteCompare *l)
{
    const bool exact = l->op == IR_gt || l->op == IR_le;
    const uint64_t n = c_ins(fn, l->constant)->bits;

    return c_ins(fn, l->load)->type == SM_U64 && c_ins(fn, l->constant)->type == SM_U64 && n <= UINT32_MAX && (exact || n > 0) &&
           fn->ins[l->load].form == C_SUBEXPRESSION;
}

// If i compares a variable with a constant and some bytes of the variable decide the result, writes a call that reads only those and returns
// true.
bool soft_try_write_byte_compare(CFn *fn, const IrIns *i, bool negated)
{
    ByteCompare l;

    if (!match_constant_compare(fn, i, &l))
        return false;
    if (can_compare_integer_bytes(fn, &l))
        write_integer_compare(fn, &l, c_ins(fn, l.constant)->bits, negated);
    else if (!needs_lower_half(fn, &l))
        write_float_compare(fn, &l, negated);
    else
        return false;
    return true;
}

// Writes `r != 0`, or `r == 0` if negated, for a float r that is never NaN.
void soft_write_nonzero_test(CFn *fn, IrRef r, bool negated)
{
    c_write(fn, negated ? "!sm_to_bool(" : "sm_to_bool(");
    c_write_double(fn, r, PREC_ANY);
    c_write(fn, ")");
}

// ---- the library files ----

static void write_lines(const char *const *line, Buf *out)
{
    for (; *line; line++)
        buf_str(out, *line);
}

// Writes the declarations and functions of soft numbers, to be part of the same translation unit.
void c_write_soft_library(Buf *out)
{
    buf_str(out, "#define SM_F64_SOFT 1\n");
    write_lines(soft_header, out);
    write_lines(soft_cells, out);
    write_lines(soft_code, out);
}

static void write_file_title(const char *what, Buf *out)
{
    buf_printf(out, "// Soft binary64 for emitted C, where `double` is not an IEEE binary64: %s.  Generated by smc from its stdlib: edit that, not this file.\n", what);
}

void emit_c_soft_library(Buf *header, Buf *code, Buf *assembly)
{
    write_file_title("declarations", header);
    buf_str(header, "#ifndef SM_F64_H              // otherwise stdlib/f64.h, which declares all of this, has been included, as by smc's Arduino library\n");
    buf_str(header, "#ifndef SM_F64_SOFT\n#define SM_F64_SOFT 1\n#endif\n");
    write_lines(soft_header, header);
    buf_str(header, "#endif\n");
    write_lines(soft_cells, header);
    write_file_title("portable C", code);
    buf_str(code, "#include \"sm_soft.h\"\n\n");
    write_lines(soft_code, code);
    write_file_title("assembly for AVR, nothing elsewhere", assembly);
    write_lines(soft_assembly, assembly);
}
