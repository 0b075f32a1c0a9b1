// SPDX-License-Identifier: Apache-2.0
// Numbers where no `double` is an IEEE binary64 (EmitCOptions.soft): an F64 is an SmF64, the bits of one, and expressions on it are
// calls of the functions of sm_soft.h.  C's own arithmetic on floats is not used either, for nobody promises its rounding there: an
// F32 is computed on as an F64, which gives the same number.  Integers are as ever.
#include "compiler/emit/c/emit_c.h"
#include "compiler/emit/c/fn.h"
#include "soft_text.h"
#include "stdlib/convert.h"

static const IrIns *ins(const CFn *fn, IrRef r) { return &fn->f->ins.at[r]; }
static void put(CFn *fn, const char *text) { buf_str(&fn->line, text); }

bool c_is_soft(const CFn *fn, SmType t) { return fn->u->soft && sm_type_info[t].kind == SM_KIND_FLOAT; }

// ---- conversions ----

static const char *const from_integer[SM_TYPE_COUNT] = {
    [SM_I8] = "sm_from_i32", [SM_I16] = "sm_from_i32", [SM_I32] = "sm_from_i32", [SM_I64] = "sm_from_i64",
    [SM_U8] = "sm_from_i32", [SM_U16] = "sm_from_i32", [SM_U32] = "sm_from_u32", [SM_U64] = "sm_from_u64", [SM_F32] = "sm_from_f32",
};

static const char *const cut[SM_TYPE_COUNT] = {
    [SM_I8] = "(int8_t)sm_cut_i32(", [SM_I16] = "(int16_t)sm_cut_i32(", [SM_I32] = "sm_cut_i32(", [SM_I64] = "sm_cut_i64(",
    [SM_U8] = "(uint8_t)sm_cut_i32(", [SM_U16] = "(uint16_t)sm_cut_i32(", [SM_U32] = "sm_cut_u32(", [SM_U64] = "sm_cut_u64(",
};

static bool is_arithmetic(IrOp op) { return op == IR_add || op == IR_sub || op == IR_mul || op == IR_div; }

static void put_arithmetic(CFn *fn, const IrIns *i)
{
    put(fn, i->op == IR_add ? "sm_add(" : i->op == IR_sub ? "sm_sub(" : i->op == IR_mul ? "sm_mul(" : "sm_div(");
    put_double(fn, i->a, PREC_ANY);
    put(fn, ", ");
    put_double(fn, i->b, PREC_ANY);
    put(fn, ")");
}

void soft_put_number(CFn *fn, IrRef r)
{
    const IrIns *i = ins(fn, r);

    if (i->type == SM_F32 && is_arithmetic(i->op) && fn->ins[r].how == C_INLINE) {
        put_arithmetic(fn, i);
        return;
    }
    put(fn, from_integer[i->type]);
    put(fn, "(");
    put_value(fn, r, PREC_ANY);
    put(fn, ")");
}

void soft_put_cast(CFn *fn, SmType to, IrRef r)
{
    put(fn, to == SM_F32 ? "sm_round_f32(" : cut[to]);
    put_double(fn, r, PREC_ANY);
    put(fn, ")");
}

// ---- arithmetic ----

void soft_put_binary(CFn *fn, const IrIns *i)
{
    put(fn, i->type == SM_F32 ? "sm_round_f32(" : "");
    put_arithmetic(fn, i);
    put(fn, i->type == SM_F32 ? ")" : "");
}

void soft_put_compare(CFn *fn, const IrIns *i, bool negated)
{
    const bool equality = i->op == IR_eq || i->op == IR_ne, swap = i->op == IR_gt || i->op == IR_ge;

    put(fn, negated != (i->op == IR_ne) ? "!" : "");
    put(fn, equality ? "sm_eq(" : i->op == IR_lt || i->op == IR_gt ? "sm_lt(" : "sm_le(");
    put_double(fn, swap ? i->b : i->a, PREC_ANY);
    put(fn, ", ");
    put_double(fn, swap ? i->a : i->b, PREC_ANY);
    put(fn, ")");
}

void soft_put_not_zero(CFn *fn, IrRef r, bool negated)
{
    put(fn, negated ? "!sm_to_bool(" : "sm_to_bool(");
    put_double(fn, r, PREC_ANY);
    put(fn, ")");
}

// ---- the files that go with it ----

static void put_lines(const char *const *line, Buf *out)
{
    for (; *line; line++)
        buf_str(out, *line);
}

void put_soft_library(Buf *out)
{
    buf_str(out, "#define SM_F64_SOFT 1\n");
    put_lines(soft_header, out);
    put_lines(soft_code, out);
}

static void put_file_title(const char *what, Buf *out)
{
    buf_printf(out, "// Numbers for emitted C where no `double` is an IEEE binary64: %s.  Made by smc from its stdlib: change that, not this file.\n", what);
}

void emit_c_soft_library(Buf *header, Buf *code, Buf *assembly)
{
    put_file_title("what may be done with them", header);
    buf_str(header, "#ifndef SM_F64_H              // else smc's own stdlib/f64.h has been included, as by its Arduino library, and has all of this\n");
    buf_str(header, "#ifndef SM_F64_SOFT\n#define SM_F64_SOFT 1\n#endif\n");
    put_lines(soft_header, header);
    buf_str(header, "#endif\n");
    put_file_title("portable C", code);
    buf_str(code, "#include \"sm_soft.h\"\n\n");
    put_lines(soft_code, code);
    put_file_title("assembly for AVR, nothing elsewhere", assembly);
    put_lines(soft_assembly, assembly);
}
