// SPDX-License-Identifier: Apache-2.0
// An image as text, for people; on hosts.  It prints whatever the verifier accepts.  One line an instruction: offset in the
// code, opcode, what it works on; where a line of the source begins, its number behind.
//
//     TankVentControl.step:
//        7  ldx     tankPressure                    tank.sm:22
//        9  jxn     x <= 775, 17
//       13  ldx     1                               tank.sm:23
//       15  out     valveOpen
//
// Conditions are written as the language has them.  `not x < y` also holds where one of them is NaN; `x <> y` is less or greater, and
// `x <=> y` neither of them NaN.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

typedef struct Out {
    SmvmWrite write;
    void *context;
    const SmvmMachine *m;
    uint32_t column;
    SmvmLines lines;
    bool more_lines;
} Out;

enum { NAME_MOST = 250 };

// ---- text ----

static void text(Out *o, const char *s)
{
    size_t n = 0;

    while (s[n])
        n++;
    o->write(o->context, s, n);
    o->column = n > 0 && s[n - 1] == '\n' ? 0 : o->column + (uint32_t)n;
}

static void pad(Out *o, uint32_t column)
{
    do
        text(o, " ");
    while (o->column < column);
}

static void number(Out *o, uint64_t v)
{
    char digits[21], *p = digits + 20;

    *p = '\0';
    do
        *--p = (char)('0' + v % 10);
    while ((v /= 10) != 0);
    text(o, p);
}

static void right(Out *o, uint32_t v, uint32_t width)            // to the right end of so many columns
{
    for (uint32_t least = 10, i = 1; i < width; i++, least *= 10)
        if (v < least)
            text(o, " ");
    number(o, v);
}

static void hex(Out *o, uint64_t v, uint8_t digits)
{
    char t[2] = "";

    while (digits-- > 0) {
        t[0] = "0123456789abcdef"[v >> 4 * digits & 15];
        text(o, t);
    }
}

// Cut where it is longer than any sane one: the listing's length is in proportion to the image's.
static void name(Out *o, SmvmName n)
{
    char t[2] = "";

    for (uint32_t i = 0; i < n.size && i < NAME_MOST; i++) {
        t[0] = (char)smvm_u8(o->m->image, n.at + i);
        text(o, t[0] >= ' ' && t[0] <= '~' ? t : "?");
    }
}

// ---- numbers and variables ----

static void whole(Out *o, int32_t v)
{
    if (v < 0)
        text(o, "-");
    number(o, v < 0 ? 0u - (uint32_t)v : (uint32_t)v);
}

// m / 10^places, with a point.
static void decimal(Out *o, uint64_t m, uint8_t places)
{
    uint64_t unit = 1;

    for (uint8_t i = 0; i < places; i++)
        unit *= 10;
    number(o, m / unit);
    if (places == 0)
        return;
    text(o, ".");
    for (m %= unit; unit > 10 && m < unit / 10; unit /= 10)
        text(o, "0");
    number(o, m);
}

// The decimal of at most 15 places whose nearest F64 is x >= 0, if there is one.  Dividing one exact number by another rounds
// as reading the decimal does.
static bool short_decimal(Out *o, SmF64 x)
{
    const SmF64 ten = sm_from_i32(10), limit = sm_from_u64((uint64_t)1 << 53);
    SmF64 unit = sm_from_i32(1);

    for (uint8_t places = 0; places <= 15 && sm_lt(sm_mul(x, unit), limit); places++) {
        SmF64 m = sm_round(sm_mul(x, unit));
        if (sm_eq(sm_div(m, unit), x)) {
            decimal(o, sm_to_u64(m), places);
            return true;
        }
        unit = sm_mul(unit, ten);
    }
    return false;
}

// A number as a decimal where a short one says it, else as C99's %a has it.
static void f64(Out *o, SmF64 x)
{
    uint64_t bits = sm_bits(x), fraction = bits & 0xfffffffffffffu;
    int32_t exponent = (int32_t)(bits >> 52 & 0x7ff);
    uint8_t digits = 13;

    if (bits >> 63 && !sm_is_nan(x))
        text(o, "-");
    if (exponent == 0x7ff) {
        text(o, fraction != 0 ? "nan" : "inf");
        return;
    }
    if (short_decimal(o, sm_abs(x)))
        return;
    for (; digits > 0 && (fraction & 15u) == 0; digits--)
        fraction >>= 4;
    text(o, exponent == 0 ? "0x0" : "0x1");
    if (digits > 0)
        text(o, ".");
    hex(o, fraction, digits);
    text(o, "p");
    if (exponent > 1022)
        text(o, "+");
    whole(o, exponent == 0 ? -1022 : exponent - 1023);
}

static const char *type_name(uint32_t type) { return type < SM_TYPE_COUNT ? sm_type_info[type].spelling : "RAW"; }

static void place(Out *o, const char *space, const SmvmPlace *p)
{
    text(o, space);
    text(o, type_name(p->type));
    text(o, "@");
    number(o, p->offset);
}

static void variable(Out *o, SmvmVariable is, const SmvmPlace *p)
{
    SmvmName n = smvm_name_of(o->m, is, p);

    if (n.size > 0)
        name(o, n);
    else if (is == SMVM_IS_TIME)
        text(o, "T");
    else
        place(o, is == SMVM_IS_LOCAL ? "local " : "", p);
}

static void state(Out *o, uint32_t s)
{
    SmvmName n = smvm_state_name(o->m, s);

    if (n.size > 0) {
        name(o, n);
    } else {
        text(o, "state ");
        number(o, s);
    }
}

// ---- instructions ----

// The opcode by its name, up to what says where its operand is: ldx, not ldx_local.
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
        text(o, t);
    }
}

static void relation(Out *o, uint32_t m)
{
    static const char *const before[] = {"never x ? ", "x < ", "x == ", "x <= ", "x > ", "x <> ", "x >= ", "x <=> ", "not x <=> ",
                                         "not x >= ", "not x <> ", "not x > ", "not x <= ", "x != ", "not x < ", "always x ? "};

    text(o, before[m & 15u]);
}

static void variable_of(Out *o, uint8_t op, SmvmVariable is, uint32_t index)
{
    SmvmPlace p;

    p.type = (SmType)(op & 15u);
    p.offset = index << smvm_type_shift(op & 15u);
    variable(o, is, &p);
}

static void output(Out *o, uint32_t index)
{
    SmvmPlace p = smvm_output(o->m, index);

    variable(o, SMVM_IS_ELEMENT, &p);
}

static void whole_number(Out *o, uint8_t op, uint32_t n)
{
    if (smvm_shape(op) & SMVM_SHAPE_J)
        relation(o, op);
    whole(o, op == SMVM_ldx_minus || op == SMVM_ldy_minus ? -1 - (int32_t)n : (int32_t)n);
}

static void jump(Out *o, uint8_t op, uint32_t target)
{
    if (smvm_shape(op) & SMVM_SHAPE_Y) {
        relation(o, op);
        text(o, "y, ");
    }
    number(o, target);
}

static void statistic(Out *o, uint32_t k)
{
    static const char *const stat[] = {"average", "median", "smallest", "largest", "range"};

    text(o, stat[k % SM_STAT_COUNT]);
}

// One of what follows an opcode: its letter in the shape, and its number; a jump's already where it leads.
static void follows(Out *o, uint8_t op, uint32_t letter, uint32_t v)
{
    switch (letter) {
    case SMVM_SHAPE_L: variable_of(o, op, SMVM_IS_LOCAL, v); break;
    case SMVM_SHAPE_E: variable_of(o, op, SMVM_IS_ELEMENT, v); break;
    case SMVM_SHAPE_N: whole_number(o, op, v); break;
    case SMVM_SHAPE_F: f64(o, sm_from_f32(sm_f32_from_bits(smvm_uint(o->m->image, o->m->f32s_at + 4 * v, 4)))); break;
    case SMVM_SHAPE_D: f64(o, sm_from_bits(smvm_cell(o->m->image, o->m->f64s_at + 8 * v, 8))); break;
    case SMVM_SHAPE_O: output(o, v); break;
    case SMVM_SHAPE_S: state(o, v); break;
    case SMVM_SHAPE_K: statistic(o, v); break;
    case SMVM_SHAPE_W: text(o, "w"); number(o, v); break;
    case SMVM_SHAPE_T: text(o, type_name(v)); break;
    case SMVM_SHAPE_M: relation(o, v); text(o, "y"); break;
    default: jump(o, op, v); break;
    }
}

static void source_line(Out *o, uint32_t code)                   // if one begins at this offset
{
    uint32_t line = 0;

    for (; o->more_lines && o->lines.code <= code; o->more_lines = smvm_next_line(o->m, &o->lines))
        if (o->lines.code == code)
            line = o->lines.line;
    if (line == 0)
        return;
    pad(o, 48);
    name(o, smvm_name(o->m, SMVM_NAME_SOURCE));
    text(o, ":");
    number(o, line);
}

static uint32_t instruction(Out *o, uint32_t at)                 // gives where the next one is
{
    uint8_t op = smvm_u8(o->m->image, at);
    uint32_t start = at++ - o->m->code_at, shape = smvm_shape(op) & SMVM_SHAPE_FOLLOWS, v = 0;
    const char *between = "";

    right(o, start, 6);
    text(o, "  ");
    mnemonic(o, op);
    if (shape != 0 || op == SMVM_ldx_time || op == SMVM_ldy_time)
        pad(o, 16);
    if (op == SMVM_ldx_time || op == SMVM_ldy_time)
        variable_of(o, op, SMVM_IS_TIME, 0);
    for (uint32_t letter = 1; letter <= shape; letter <<= 1)
        if ((shape & letter) != 0) {
            smvm_varint(o->m->image, &at, o->m->code_at + o->m->code_size, &v);
            text(o, between);
            follows(o, op, letter, letter == SMVM_SHAPE_J ? at - o->m->code_at + v : v);
            between = ", ";
        }
    source_line(o, start);
    text(o, "\n");
    return at;
}

static void function(Out *o, uint32_t index)
{
    static const char *const block[] = {".entry", ".step", ".exit"};
    uint32_t at = o->m->code_at + (index == 0 ? 0 : smvm_function_end(o->m, index - 1));
    uint32_t end = o->m->code_at + smvm_function_end(o->m, index);

    if (at == end)
        return;
    text(o, "\n");
    if (index == 0)
        text(o, "sample");
    else
        state(o, (index + 2) / 3);
    text(o, index == 0 ? ":\n" : block[(index - 1) % 3]);
    text(o, index == 0 ? "" : ":\n");
    while (at < end)
        at = instruction(o, at);
}

// ---- the machine and the image ----

static void line(Out *o, const char *what, uint64_t v, const char *unit)
{
    text(o, "    ");
    text(o, what);
    pad(o, 20);
    number(o, v);
    text(o, unit);
}

static void window(Out *o, uint32_t w)
{
    static const char *const stat[] = {" average", " median", " smallest", " largest", " range"};
    uint32_t entry = smvm_window(o->m->image, o->m->windows_at, w), kind = entry >> SMVM_WINDOW_SIZE_BITS;

    text(o, "    w");
    number(o, w);
    pad(o, 20);
    number(o, entry & SMVM_WINDOW_SIZE_MASK);
    text(o, " ");
    text(o, sm_type_info[kind & SM_ROLL_TYPE].spelling);
    text(o, " samples:");
    for (uint32_t i = 0; i < SM_STAT_COUNT; i++)
        if (kind & (uint32_t)SM_ROLL_AVG << i)
            text(o, stat[i]);
    text(o, "\n");
}

static void element(Out *o, const char *what, const SmvmPlace *p)
{
    SmvmName n = smvm_name_of(o->m, SMVM_IS_ELEMENT, p);

    text(o, "    ");
    text(o, what);
    pad(o, 20);
    place(o, "", p);
    text(o, n.size > 0 ? " " : "");
    name(o, n);
    text(o, "\n");
}

static void elements(Out *o)
{
    SmvmPlace g = {SM_U64, 0}, s = {SM_U32, 0}, p;

    g.offset = o->m->g;
    s.offset = o->m->s;
    for (uint32_t i = 0; i < o->m->outputs; i++) {
        p = smvm_output(o->m, i);
        element(o, "output", &p);
    }
    element(o, "G", &g);
    element(o, "S", &s);
}

static void initial_values(Out *o)
{
    const SmvmMachine *m = o->m;

    for (uint32_t at = m->init_at; at < m->init_at + m->init_size;) {
        SmvmPlace p = smvm_place(m->image, at);
        uint8_t bytes = (uint8_t)(1u << smvm_type_shift(p.type));
        text(o, "    initial value");
        pad(o, 20);
        place(o, "local ", &p);
        text(o, " = 0x");
        hex(o, smvm_cell(m->image, at + SMVM_PLACE, bytes), (uint8_t)(2 * bytes));
        text(o, "\n");
        at += (uint32_t)SMVM_PLACE + bytes;
    }
}

static void machine(Out *o, uint32_t index)
{
    const SmvmMachine *m = o->m;

    text(o, "\nmachine ");
    number(o, index + 1);
    text(o, " ");
    name(o, smvm_name(m, SMVM_NAME_MACHINE));
    text(o, "\n");
    line(o, "state vector", m->sv_size, " bytes, layout ");
    hex(o, m->layout, 8);
    text(o, "; of these it names ");
    number(o, m->from);
    text(o, " to ");
    number(o, m->to);
    text(o, "\n");
    line(o, "states", m->states, "\n");
    line(o, "memory", smvm_ram_size(m), " bytes on this machine, of these ");
    number(o, m->locals);
    text(o, " for locals\n");
    line(o, "longest step", smvm_longest_step(m), " instructions\n");
    elements(o);
    initial_values(o);
    for (uint32_t w = 0; w < m->windows; w++)
        window(o, w);
    memset(&o->lines, 0, sizeof o->lines);
    o->more_lines = smvm_next_line(m, &o->lines);
    for (uint32_t f = 0; f <= 3 * m->states; f++)
        function(o, f);
}

// ---- pins ----

static void real(Out *o, const char *before, SmF64 x)
{
    text(o, before);
    if (sm_eq(sm_trunc(x), x) && sm_le(sm_abs(x), sm_from_i32(INT32_MAX))) {
        text(o, sm_lt(x, sm_from_i32(0)) ? "-" : "");
        number(o, sm_cut_u32(sm_abs(x)));
    } else {
        text(o, "0x");
        hex(o, sm_bits(x), 16);
    }
}

static void pin(Out *o, const SmvmPin *p)
{
    text(o, p->kind & 2 ? "    digital " : "    analog ");
    text(o, p->kind & 1 ? "o " : "i ");
    number(o, p->pin);
    pad(o, 20);
    text(o, sm_type_info[p->type].spelling);
    text(o, " at ");
    number(o, p->offset);
    if (!sm_eq(p->scale, sm_from_i32(1)))
        real(o, " @scale ", p->scale);
    if (!sm_eq(p->zero, sm_from_i32(0)))
        real(o, " @offset ", p->zero);
    if (!sm_eq(p->safe, sm_from_i32(0)))
        real(o, " @safe ", p->safe);
    text(o, p->flags & 1 ? " @inverted" : "");
    text(o, p->flags & 2 ? " @pull_up" : p->flags & 4 ? " @pull_down" : "");
    if (p->hold)
        real(o, " @hold ", sm_from_u32(p->hold));
    text(o, "\n");
}

static void pins(Out *o, SmvmBytes image)
{
    SmvmPins all;
    SmvmPin p;

    if (!smvm_pins(image, &all))
        return;
    text(o, "\npins\n");
    line(o, "state vector", 8 * all.sv_size, " bytes, layout ");
    hex(o, all.layout, 8);
    text(o, "\n");
    while (smvm_next_pin(&all, &p))
        pin(o, &p);
}

static const char *section_name(uint8_t id)
{
    switch (id) {
#define SMVM_SECTION(name, id_, version, meaning) case id_: return #name;
#include "bytecode-vm/image.def"
#undef SMVM_SECTION
    default: return "unknown";
    }
}

static void sections(Out *o, SmvmBytes image)
{
    for (uint8_t i = 0; i < smvm_sections(image); i++) {
        SmvmSection s = smvm_section(image, i);
        text(o, "    section ");
        hex(o, s.id, 2);
        text(o, " ");
        text(o, section_name(s.id));
        pad(o, 26);
        number(o, s.size);
        text(o, " bytes at ");
        number(o, s.at);
        if (s.id == SMVM_S_IDENTITY && s.size == 8) {
            text(o, ": ");
            hex(o, smvm_cell(image, s.at, 8), 16);
        }
        text(o, "\n");
    }
}

void smvm_disasm(SmvmBytes image, SmvmWrite write, void *context)
{
    SmvmMachine m;
    Out o;

    memset(&o, 0, sizeof o);
    o.write = write;
    o.context = context;
    o.m = &m;
    text(&o, "image of ");
    number(&o, smvm_u24(image, SMVM_LENGTH_AT));
    text(&o, " bytes, format 2, crc ");
    hex(&o, smvm_uint(image, SMVM_CRC_AT, 4), 8);
    text(&o, "\n");
    sections(&o, image);
    pins(&o, image);
    for (uint32_t i = 0; smvm_machine(image, i, &m); i++)
        machine(&o, i);
}

const char *smvm_rule_text(uint8_t rule)
{
    switch (rule) {
#define SMVM_RULE(number, name, sentence) case number: return sentence;
#include "bytecode-vm/rules.def"
#undef SMVM_RULE
    default: return "";
    }
}
