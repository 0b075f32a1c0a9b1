// SPDX-License-Identifier: Apache-2.0
// The code of a machine as text.
#include "bytecode-vm/disasm.h"
#include "stdlib/convert.h"

static void right(Out *o, uint32_t v, uint32_t width)            // right-aligned in `width` columns
{
    for (uint32_t least = 10, i = 1; i < width; i++, least *= 10)
        if (v < least)
            smvm_text(o, " ");
    smvm_text_number(o, v);
}

// The name of the opcode without its suffix for the operand's place: ldx, not ldx_local.
static void mnemonic(Out *o, uint8_t op)
{
    static const struct { uint8_t last; const char *name; } ops[] = {
#define SMVM_OP(name, first, last, shape, meaning) {last, #name},
#include "bytecode-vm/opcodes.def"
#undef SMVM_OP
    };
    char t[2] = "";
    size_t i = 0;

    while (ops[i].last < op)
        i++;
    for (const char *p = ops[i].name; *p != '\0' && *p != '_'; p++) {
        t[0] = *p;
        smvm_text(o, t);
    }
}

static void relation(Out *o, uint32_t m)
{
    static const char *const before[] = {"never x ? ", "x < ", "x == ", "x <= ", "x > ", "x <> ", "x >= ", "x <=> ", "not x <=> ",
                                         "not x >= ", "not x <> ", "not x > ", "not x <= ", "x != ", "not x < ", "always x ? "};

    smvm_text(o, before[m & 15u]);
}

static void variable_of(Out *o, uint8_t op, SmvmVariable is, uint32_t index)
{
    SmvmPlace p;

    p.type = (SmType)(op & 15u);
    p.offset = index << smvm_type_shift(op & 15u);
    smvm_text_variable(o, is, &p);
}

static void output(Out *o, uint32_t index)
{
    SmvmPlace p = smvm_output(o->m, index);

    smvm_text_variable(o, SMVM_IS_ELEMENT, &p);
}

static void whole_number(Out *o, uint8_t op, uint32_t n)
{
    if (smvm_shape(op) & SMVM_SHAPE_J)
        relation(o, op);
    smvm_text_whole(o, op == SMVM_ldx_minus || op == SMVM_ldy_minus ? -1 - (int32_t)n : (int32_t)n);
}

static void jump(Out *o, uint8_t op, uint32_t target)
{
    if (smvm_shape(op) & SMVM_SHAPE_Y) {
        relation(o, op);
        smvm_text(o, "y, ");
    }
    smvm_text_number(o, target);
}

static void statistic(Out *o, uint32_t k)
{
    static const char *const stat[] = {"average", "median", "smallest", "largest", "range"};

    smvm_text(o, stat[k % SM_STAT_COUNT]);
}

// One operand: its bit in the shape, and its number.  For a jump the number is already the target.
static void follows(Out *o, uint8_t op, uint32_t letter, uint32_t v)
{
    switch (letter) {
    case SMVM_SHAPE_L: variable_of(o, op, SMVM_IS_LOCAL, v); break;
    case SMVM_SHAPE_E: variable_of(o, op, SMVM_IS_ELEMENT, v); break;
    case SMVM_SHAPE_N: whole_number(o, op, v); break;
    case SMVM_SHAPE_F: smvm_text_f64(o, sm_from_f32(sm_f32_from_bits(smvm_uint(o->m->image, o->m->f32s_at + 4 * v, 4)))); break;
    case SMVM_SHAPE_D: smvm_text_f64(o, sm_from_bits(smvm_cell(o->m->image, o->m->f64s_at + 8 * v, 8))); break;
    case SMVM_SHAPE_O: output(o, v); break;
    case SMVM_SHAPE_S: smvm_text_state(o, v); break;
    case SMVM_SHAPE_K: statistic(o, v); break;
    case SMVM_SHAPE_W: smvm_text(o, "w"); smvm_text_number(o, v); break;
    case SMVM_SHAPE_T: smvm_text(o, smvm_type_name(v)); break;
    case SMVM_SHAPE_M: relation(o, v); smvm_text(o, "y"); break;
    default: jump(o, op, v); break;
    }
}

static void source_line(Out *o, uint32_t code)                   // the line that begins at this offset, if any
{
    uint32_t line = 0;

    for (; o->more_lines && o->lines.code <= code; o->more_lines = smvm_next_line(o->m, &o->lines))
        if (o->lines.code == code)
            line = o->lines.line;
    if (line == 0)
        return;
    smvm_text_pad(o, 48);
    smvm_text_name(o, smvm_name(o->m, SMVM_NAME_SOURCE));
    smvm_text(o, ":");
    smvm_text_number(o, line);
}

static SmvmAt instruction(Out *o, SmvmAt at)                     // returns where the next one is
{
    uint8_t op = smvm_u8(o->m->image, at);
    uint32_t start = (uint32_t)at++ - o->m->code_at, shape = smvm_shape(op) & SMVM_SHAPE_FOLLOWS, v = 0;
    const char *between = "";

    right(o, start, 6);
    smvm_text(o, "  ");
    mnemonic(o, op);
    if (shape != 0 || op == SMVM_ldx_time || op == SMVM_ldy_time)
        smvm_text_pad(o, 16);
    if (op == SMVM_ldx_time || op == SMVM_ldy_time)
        variable_of(o, op, SMVM_IS_TIME, 0);
    for (uint32_t letter = 1; letter <= shape; letter <<= 1)
        if ((shape & letter) != 0) {
            smvm_varint(o->m->image, &at, (SmvmAt)(o->m->code_at + o->m->code_size), &v);
            smvm_text(o, between);
            follows(o, op, letter, letter == SMVM_SHAPE_J ? at - o->m->code_at + v : v);
            between = ", ";
        }
    source_line(o, start);
    smvm_text(o, "\n");
    return at;
}

void smvm_text_function(Out *o, uint32_t index)
{
    static const char *const block[] = {".entry", ".step", ".exit"};
    SmvmAt at = (SmvmAt)(o->m->code_at + (index == 0 ? 0 : smvm_function_end(o->m, index - 1)));
    const SmvmAt end = (SmvmAt)(o->m->code_at + smvm_function_end(o->m, index));

    if (at == end)
        return;
    smvm_text(o, "\n");
    if (index == 0)
        smvm_text(o, "sample");
    else
        smvm_text_state(o, (index + 2) / 3);
    smvm_text(o, index == 0 ? ":\n" : block[(index - 1) % 3]);
    smvm_text(o, index == 0 ? "" : ":\n");
    while (at < end)
        at = instruction(o, at);
}
