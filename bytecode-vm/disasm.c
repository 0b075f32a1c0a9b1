// SPDX-License-Identifier: Apache-2.0
// Disassembles an image that the verifier accepts, as text for people.  Runs on hosts only.  Each instruction is one line: offset in the
// code, opcode, operands, and the number of the source line if one begins there.
//
//     TankVentControl.step:
//        7  ldx     tankPressure                    tank.sm:22
//        9  jxn     x <= 775, 17
//       13  ldx     1                               tank.sm:23
//       15  out     valveOpen
//
// Conditions are written as in the language.  `not x < y` is also true if one of them is NaN.  `x <> y` means less or greater; `x <=> y`
// means that neither is NaN.
#include <string.h>

#include "bytecode-vm/disasm.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

// ---- the machine ----

static void print_property(DisasmOutput *o, const char *what, uint64_t v, const char *unit)
{
    smvm_print(o, "    ");
    smvm_print(o, what);
    smvm_print_padding(o, 20);
    smvm_print_unsigned(o, v);
    smvm_print(o, unit);
}

static void print_window(DisasmOutput *o, uint32_t w)
{
    static const char *const stat[] = {" average", " median", " smallest", " largest", " range", " oldest", " newest", " change", " elapsed",
                                       " run-steps", " run-time"};
    uint32_t entry = smvm_window(o->m->image, o->m->windows_at, w), kind = entry >> SMVM_WINDOW_SIZE_BITS;
    const SmvmLocation number = {SM_I8, w};
    const SmvmName name = smvm_name_of(o->m, SMVM_IS_SAMPLE, &number);

    smvm_print(o, "    w");
    smvm_print_unsigned(o, w);
    smvm_print_padding(o, 20);
    smvm_print_unsigned(o, entry & SMVM_WINDOW_SIZE_MASK);
    smvm_print(o, " ");
    smvm_print(o, sm_type_info[kind & SM_ROLL_TYPE].spelling);
    smvm_print(o, " samples:");
    for (uint32_t i = 0; i < SM_STAT_COUNT; i++)
        if (kind & (uint32_t)SM_ROLL_AVG << i)
            smvm_print(o, stat[i]);
    smvm_print(o, name.size > 0 ? " of " : "");
    smvm_print_name(o, name);
    smvm_print(o, "\n");
}

static void print_element(DisasmOutput *o, const char *what, const SmvmLocation *p)
{
    SmvmName n = smvm_name_of(o->m, SMVM_IS_ELEMENT, p);

    smvm_print(o, "    ");
    smvm_print(o, what);
    smvm_print_padding(o, 20);
    smvm_print_location(o, "", p);
    smvm_print(o, n.size > 0 ? " " : "");
    smvm_print_name(o, n);
    smvm_print(o, "\n");
}

static void print_elements(DisasmOutput *o)
{
    SmvmLocation g = {SM_U64, 0}, s = {SM_U32, 0}, p;

    g.offset = o->m->g;
    s.offset = o->m->s;
    for (uint32_t i = 0; i < o->m->outputs; i++) {
        p = smvm_output(o->m, i);
        print_element(o, "output", &p);
    }
    print_element(o, "G", &g);
    print_element(o, "S", &s);
}

static void print_initial_values(DisasmOutput *o)
{
    const SmvmMachine *m = o->m;

    for (uint32_t at = m->init_at; at < m->init_at + m->init_size;) {
        SmvmLocation p = smvm_location(m->image, at);
        uint8_t bytes = (uint8_t)(1u << smvm_type_shift(p.type));
        smvm_print(o, "    initial value");
        smvm_print_padding(o, 20);
        smvm_print_location(o, "local ", &p);
        smvm_print(o, " = 0x");
        smvm_print_hex(o, smvm_cell(m->image, at + SMVM_LOCATION_BYTES, bytes), (uint8_t)(2 * bytes));
        smvm_print(o, "\n");
        at += (uint32_t)SMVM_LOCATION_BYTES + bytes;
    }
}

// Prints the location and the name of each parameter, and the bits of the ends of its range, of its default and of its value, in hexadecimal.
static void print_parameters(DisasmOutput *o)
{
    static const char *const before[] = {" from 0x", " to 0x", ", default 0x", ", value 0x"};
    SmvmReader r = smvm_parameters(o->m);
    SmvmParameterEntry p;

    while (smvm_read_parameter(&r, &p)) {
        const SmvmName name = {p.name[0], p.size[0]};
        smvm_print(o, "    parameter");
        smvm_print_padding(o, 20);
        smvm_print_location(o, "local ", &p.location);
        smvm_print(o, " ");
        smvm_print_name(o, name);
        for (uint8_t i = 0; i < SMVM_PARAMETER_NUMBERS; i++) {
            smvm_print(o, before[i]);
            smvm_print_hex(o, smvm_cell(o->m->image, smvm_parameter_number(&p, i), p.bytes), (uint8_t)(2 * p.bytes));
        }
        smvm_print(o, "\n");
    }
}

static void print_marked_states(DisasmOutput *o, const char *what, uint8_t section)
{
    bool any = false;

    for (uint32_t s = 1; s <= o->m->states; s++) {
        if (section == SMVM_S_SAFE ? o->m->safe_at == 0 || !smvm_state_is_safe(o->m, s) : !smvm_is_marked(o->m, section, s))
            continue;
        smvm_print(o, any ? " " : what);
        smvm_print_unsigned(o, s);
        any = true;
    }
    smvm_print(o, any ? "\n" : "");
}

static void print_machine(DisasmOutput *o, uint32_t index)
{
    const SmvmMachine *m = o->m;

    smvm_print(o, "\nmachine ");
    smvm_print_unsigned(o, index + 1);
    smvm_print(o, " ");
    smvm_print_name(o, smvm_name(m, SMVM_NAME_MACHINE));
    smvm_print(o, "\n");
    print_property(o, "state vector", m->sv_size, " bytes, layout ");
    smvm_print_hex(o, m->layout, 8);
    smvm_print(o, "; of these it names ");
    smvm_print_unsigned(o, m->from);
    smvm_print(o, " to ");
    smvm_print_unsigned(o, m->to);
    smvm_print(o, "\n");
    print_property(o, "states", m->states, "\n");
    print_marked_states(o, "    safe states     ", SMVM_S_SAFE);
    print_marked_states(o, "    swap states     ", SMVM_S_SWAP);
    print_marked_states(o, "    abort states    ", SMVM_S_ABORT);
    print_property(o, "memory", smvm_ram_size_64(m), " bytes on a 64-bit computer, of these ");
    smvm_print_unsigned(o, m->locals);
    smvm_print(o, " for locals\n");
    print_property(o, "longest step", smvm_longest_step(m), " instructions\n");
    print_elements(o);
    print_initial_values(o);
    print_parameters(o);
    for (uint32_t w = 0; w < m->windows; w++)
        print_window(o, w);
    memset(&o->lines, 0, sizeof o->lines);
    o->more_lines = smvm_next_line(m, &o->lines);
    for (uint32_t f = 0; f <= 3 * m->states; f++)
        smvm_print_function(o, f);
}

// ---- pins ----

static void print_real(DisasmOutput *o, const char *before, SmF64 x)
{
    smvm_print(o, before);
    if (sm_eq(sm_trunc(x), x) && sm_le(sm_abs(x), sm_from_i32(INT32_MAX))) {
        smvm_print(o, sm_lt(x, sm_from_i32(0)) ? "-" : "");
        smvm_print_unsigned(o, sm_truncate_u32(sm_abs(x)));
    } else {
        smvm_print(o, "0x");
        smvm_print_hex(o, sm_bits(x), 16);
    }
}

static void print_pin(DisasmOutput *o, const SmvmPin *p)
{
    smvm_print(o, p->kind & 2 ? "    digital " : "    analog ");
    smvm_print(o, p->kind & 1 ? "o " : "i ");
    smvm_print_unsigned(o, p->pin);
    smvm_print_padding(o, 20);
    smvm_print(o, sm_type_info[p->type].spelling);
    smvm_print(o, " at ");
    smvm_print_unsigned(o, p->offset);
    if (!sm_eq(p->scale, sm_from_i32(1)))
        print_real(o, " @scale ", p->scale);
    if (!sm_eq(p->zero, sm_from_i32(0)))
        print_real(o, " @offset ", p->zero);
    if (!sm_eq(p->safe, sm_from_i32(0)))
        print_real(o, " @safe ", p->safe);
    smvm_print(o, p->flags & 1 ? " @inverted" : "");
    smvm_print(o, p->flags & 2 ? " @pull_up" : p->flags & 4 ? " @pull_down" : "");
    if (p->hold)
        print_real(o, " @hold ", sm_from_u32(p->hold));
    smvm_print(o, "\n");
}

static void print_pins(DisasmOutput *o, SmvmBytes image)
{
    SmvmPins all;
    SmvmPin p;

    if (!smvm_pins(image, &all))
        return;
    smvm_print(o, "\npins\n");
    print_property(o, "state vector", 8 * all.sv_size, " bytes, layout ");
    smvm_print_hex(o, all.layout, 8);
    smvm_print(o, "\n");
    while (smvm_next_pin(&all, &p))
        print_pin(o, &p);
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

static void print_sections(DisasmOutput *o, SmvmBytes image)
{
    for (uint8_t i = 0; i < smvm_section_count(image); i++) {
        SmvmSection s;
        smvm_read_section(image, i, &s);
        smvm_print(o, "    section ");
        smvm_print_hex(o, s.id, 2);
        smvm_print(o, " ");
        smvm_print(o, section_name(s.id));
        smvm_print_padding(o, 26);
        smvm_print_unsigned(o, s.size);
        smvm_print(o, " bytes at ");
        smvm_print_unsigned(o, s.at);
        if (s.id == SMVM_S_IDENTITY && s.size == 8) {
            smvm_print(o, ": ");
            smvm_print_hex(o, smvm_cell(image, s.at, 8), 16);
        }
        smvm_print(o, "\n");
    }
}

// Disassembles an image that the verifier accepts.
void smvm_disasm(SmvmBytes image, SmvmWrite write, void *context)
{
    SmvmMachine m;
    DisasmOutput o;

    memset(&o, 0, sizeof o);
    o.write = write;
    o.context = context;
    o.m = &m;
    smvm_print(&o, "image of ");
    smvm_print_unsigned(&o, smvm_u24(image, SMVM_LENGTH_AT));
    smvm_print(&o, " bytes, format 2, crc ");
    smvm_print_hex(&o, smvm_uint(image, SMVM_CRC_AT, 4), 8);
    smvm_print(&o, "\n");
    print_sections(&o, image);
    print_pins(&o, image);
    for (uint32_t i = 0; smvm_machine(image, i, &m); i++)
        print_machine(&o, i);
}

// Returns the sentence of a rule; "" if there is no such rule.
const char *smvm_rule_text(uint8_t rule)
{
    switch (rule) {
#define SMVM_RULE(number, name, sentence) case number: return sentence;
#include "bytecode-vm/rules.def"
#undef SMVM_RULE
    default: return "";
    }
}
