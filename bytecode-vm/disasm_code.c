// SPDX-License-Identifier: Apache-2.0
// Disassembles the functions of a machine.
#include "bytecode-vm/disasm.h"
#include "stdlib/convert.h"

static void print_right_aligned(DisasmOutput *o, uint32_t v, uint32_t width)  // prints v right-aligned in `width` columns
{
    for (uint32_t least = 10, i = 1; i < width; i++, least *= 10)
        if (v < least)
            smvm_print(o, " ");
    smvm_print_unsigned(o, v);
}

// Prints the opcode's name without the suffix for the kind of its operand: ldx, not ldx_local.
static void print_mnemonic(DisasmOutput *o, uint8_t op)
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
        smvm_print(o, t);
    }
}

// Prints the relation in the low four bits of m, the sum of the outcomes it accepts: 1 less, 2 equal, 4 greater, 8 unordered (NaN).
static void print_relation(DisasmOutput *o, uint32_t m)
{
    static const char *const before[] = {"never x ? ", "x < ", "x == ", "x <= ", "x > ", "x <> ", "x >= ", "x <=> ", "not x <=> ",
                                         "not x >= ", "not x <> ", "not x > ", "not x <= ", "x != ", "not x < ", "always x ? "};

    smvm_print(o, before[m & 15u]);
}

static void print_variable_of(DisasmOutput *o, uint8_t op, SmvmVariable is, uint32_t index)
{
    SmvmLocation p;

    p.type = (SmType)(op & 15u);
    p.offset = index << smvm_type_shift(op & 15u);
    smvm_print_variable(o, is, &p);
}

static void print_output(DisasmOutput *o, uint32_t index)
{
    SmvmLocation p = smvm_output(o->m, index);

    smvm_print_variable(o, SMVM_IS_ELEMENT, &p);
}

static void print_whole_number(DisasmOutput *o, uint8_t op, uint32_t n)
{
    if (smvm_shape(op) & SMVM_SHAPE_J)
        print_relation(o, op);
    smvm_print_signed(o, op == SMVM_ldx_minus || op == SMVM_ldy_minus ? -1 - (int32_t)n : (int32_t)n);
}

static void print_jump(DisasmOutput *o, uint8_t op, uint32_t target)
{
    if (smvm_shape(op) & SMVM_SHAPE_Y) {
        print_relation(o, op);
        smvm_print(o, "y, ");
    }
    smvm_print_unsigned(o, target);
}

static void print_statistic(DisasmOutput *o, uint32_t k)
{
    static const char *const stat[] = {"average", "median", "smallest", "largest", "range", "oldest", "newest", "change", "elapsed", "run-steps",
                                       "run-time"};

    smvm_print(o, stat[k % SM_STAT_COUNT]);
}

static void print_function(DisasmOutput *o, uint32_t n)
{
    static const char *const name[SMVM_FN_MAX] = {
#define SM_ELEMENTARY(name, arguments, number) [number] = #name,
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
    };

    smvm_print(o, name[n % SMVM_FN_MAX]);
}

// Prints one operand.  `letter` is its bit in the shape, SMVM_SHAPE_L and so on; v is its value, for a jump the offset of the target.
static void print_operand(DisasmOutput *o, uint8_t op, uint32_t letter, uint32_t v)
{
    switch (letter) {
    case SMVM_SHAPE_L: print_variable_of(o, op, SMVM_IS_LOCAL, v); break;
    case SMVM_SHAPE_E: print_variable_of(o, op, SMVM_IS_ELEMENT, v); break;
    case SMVM_SHAPE_N:
        if (op == SMVM_fn)
            print_function(o, v);
        else
            print_whole_number(o, op, v);
        break;
    case SMVM_SHAPE_F: smvm_print_f64(o, sm_from_f32(sm_f32_from_bits(smvm_uint(o->m->image, o->m->f32s_at + 4 * v, 4)))); break;
    case SMVM_SHAPE_D: smvm_print_f64(o, sm_from_bits(smvm_cell(o->m->image, o->m->f64s_at + 8 * v, 8))); break;
    case SMVM_SHAPE_O: print_output(o, v); break;
    case SMVM_SHAPE_S: smvm_print_state(o, v); break;
    case SMVM_SHAPE_K: print_statistic(o, v); break;
    case SMVM_SHAPE_W: smvm_print(o, "w"); smvm_print_unsigned(o, v); break;
    case SMVM_SHAPE_T: smvm_print(o, smvm_type_name(v)); break;
    case SMVM_SHAPE_M: print_relation(o, v); smvm_print(o, "y"); break;
    default: print_jump(o, op, v); break;
    }
}

static void print_source_line(DisasmOutput *o, uint32_t code)    // prints the source line that begins at this offset in the code, if any
{
    uint32_t line = 0;

    for (; o->more_lines && o->lines.code <= code; o->more_lines = smvm_next_line(o->m, &o->lines))
        if (o->lines.code == code)
            line = o->lines.line;
    if (line == 0)
        return;
    smvm_print_padding(o, 48);
    smvm_print_name(o, smvm_name(o->m, SMVM_NAME_SOURCE));
    smvm_print(o, ":");
    smvm_print_unsigned(o, line);
}

static SmvmAt print_instruction(DisasmOutput *o, SmvmAt at)      // returns the offset of the next instruction
{
    uint8_t op = smvm_u8(o->m->image, at);
    uint32_t start = (uint32_t)at++ - o->m->code_at, shape = smvm_shape(op) & SMVM_SHAPE_FOLLOWS, v = 0;
    const char *between = "";

    print_right_aligned(o, start, 6);
    smvm_print(o, "  ");
    print_mnemonic(o, op);
    if (shape != 0 || op == SMVM_ldx_time || op == SMVM_ldy_time)
        smvm_print_padding(o, 16);
    if (op == SMVM_ldx_time || op == SMVM_ldy_time)
        print_variable_of(o, op, SMVM_IS_TIME, 0);
    for (uint32_t letter = 1; letter <= shape; letter <<= 1)
        if ((shape & letter) != 0) {
            smvm_read_varint(o->m->image, &at, (SmvmAt)(o->m->code_at + o->m->code_size), &v);
            smvm_print(o, between);
            print_operand(o, op, letter, letter == SMVM_SHAPE_J ? at - o->m->code_at + v : v);
            between = ", ";
        }
    print_source_line(o, start);
    smvm_print(o, "\n");
    return at;
}

void smvm_print_function(DisasmOutput *o, uint32_t index)
{
    static const char *const block[] = {".entry", ".step", ".exit"};
    SmvmAt at = (SmvmAt)(o->m->code_at + (index == 0 ? 0 : smvm_function_end(o->m, index - 1)));
    const SmvmAt end = (SmvmAt)(o->m->code_at + smvm_function_end(o->m, index));

    if (at == end)
        return;
    smvm_print(o, "\n");
    if (index == 0)
        smvm_print(o, "sample");
    else
        smvm_print_state(o, (index + 2) / 3);
    smvm_print(o, index == 0 ? ":\n" : block[(index - 1) % 3]);
    smvm_print(o, index == 0 ? "" : ":\n");
    while (at < end)
        at = print_instruction(o, at);
}
