// SPDX-License-Identifier: Apache-2.0
// Proves an image safe before it runs: after this, neither image nor state vector can make the interpreter leave its memory,
// loop without bound or trap.  One walk over the sections, the tables and the code, which also counts the longest step.
//
// That code can be checked in one walk without remembering where instructions begin rests on the encoding: the bytes of an
// instruction behind its opcode are below 0x80, an opcode never is.  So a jump lands on an instruction if it lands on a byte
// from 0x80 in code that is itself found to be well formed.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/longest.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/crc32.h"

enum { HAS_X = 1, HAS_Y = 2 };                        // registers that hold a number

typedef struct Check {
    SmvmVerdict *v;
    SmvmMachine m;
    SmvmAt at;                // where in the image the walk stands
    SmvmAt start, end;        // the function it is in
    SmvmAt far;               // how far a jump of the function has led
    SmvmAt sampled;           // windows that have their sample
    uint8_t known;            // HAS_X, HAS_Y
    SmvmIn in;
    Longest way;
} Check;

SMVM_APART static bool fail(Check *c, uint8_t rule, SmvmAt at)
{
    if (c->v->rule == 0) {
        c->v->rule = rule;
        c->v->at = at;
    }
    return false;
}

// ---- the container ----

static bool check_header(Check *c, SmvmBytes image, uint32_t size)
{
    uint32_t length;

    if (size < SMVM_HEADER)
        return fail(c, SMVM_R_LENGTH, 0);
    if (smvm_u8(image, 0) != 's' || smvm_u8(image, 1) != 'm' || smvm_u8(image, 2) != 'b')
        return fail(c, SMVM_R_MAGIC, 0);
    if (smvm_u8(image, 3) != SMVM_FORMAT)
        return fail(c, SMVM_R_FORMAT, 3);
    length = smvm_u24(image, SMVM_LENGTH_AT);
    if (length > size || length > SMVM_IMAGE_MAX || length < SMVM_HEADER + (uint32_t)SMVM_ENTRY * smvm_sections(image))
        return fail(c, SMVM_R_LENGTH, SMVM_LENGTH_AT);
    c->end = (SmvmAt)length;
    return true;
}

static bool check_crc(Check *c, SmvmBytes image)
{
    uint32_t crc = SM_CRC32_START;

    for (SmvmAt i = 0; i < c->end; i++)
        if (i < SMVM_CRC_AT || i >= SMVM_CRC_AT + 4)
            crc = sm_crc32_byte(crc, smvm_u8(image, i));
    return sm_crc32_end(crc) == smvm_uint(image, SMVM_CRC_AT, 4) || fail(c, SMVM_R_CRC, SMVM_CRC_AT);
}

static bool is_known(const SmvmSection *s)
{
    switch (s->id) {
#define SMVM_SECTION(name, id_, version_, meaning) case id_: return s->version == (version_) || (id_) < SMVM_MUST_KNOW;
#include "bytecode-vm/image.def"
#undef SMVM_SECTION
    default: return s->id < SMVM_MUST_KNOW;
    }
}

// Sections in order, of ids known, in groups that each are MACHINE, CODE once, INIT at most once.
static bool check_sections(Check *c, SmvmBytes image)
{
    const uint8_t n = smvm_sections(image);
    uint32_t free_from = SMVM_HEADER + (uint32_t)n * SMVM_ENTRY;
    bool machine = false, code = true, init = true, pins = false;

    for (uint8_t i = 0; i < n; i++) {
        const SmvmAt entry = (SmvmAt)(SMVM_HEADER + i * SMVM_ENTRY);
        SmvmSection s = smvm_section(image, i);
        if (s.at < free_from || s.at > c->end || s.size > c->end - s.at)
            return fail(c, SMVM_R_SECTION, entry);
        free_from = s.at + s.size;
        if (!is_known(&s))
            return fail(c, SMVM_R_UNKNOWN, entry);
        if ((s.id == SMVM_S_MACHINE && !code) || (s.id == SMVM_S_CODE && code) || (s.id == SMVM_S_INIT && init)
            || (s.id == SMVM_S_DEBUG && s.version == SMVM_V_DEBUG && !machine)
            || (s.id == SMVM_S_IO && s.version == SMVM_V_IO && (machine || pins)))
            return fail(c, SMVM_R_GROUP, entry);
        pins = pins || (s.id == SMVM_S_IO && s.version == SMVM_V_IO);
        if (s.id == SMVM_S_MACHINE) {
            machine = true;
            code = init = false;
        }
        code = code || s.id == SMVM_S_CODE;
        init = init || s.id == SMVM_S_INIT;
    }
    return (machine && code) || fail(c, SMVM_R_GROUP, SMVM_SECTIONS_AT);
}

// ---- the machine's tables ----

static bool check_windows(Check *c)
{
    for (SmvmAt w = 0; w < c->m.windows; w++) {
        uint32_t entry = smvm_window(c->m.image, c->m.windows_at, w);
        uint32_t size = entry & SMVM_WINDOW_SIZE_MASK, kind = entry >> SMVM_WINDOW_SIZE_BITS;
        if (size < 1 || size > SM_WINDOW_MAX || !sm_roll_is_kind(kind))
            return fail(c, SMVM_R_WINDOW, (SmvmAt)(c->m.windows_at + w * SMVM_WINDOW_ENTRY));
    }
    return true;
}

static bool is_inside(uint32_t offset, uint8_t bytes, SmvmAt from, SmvmAt to)
{
    return offset >= from && offset < to && bytes <= to - offset;
}

static bool overlap(uint32_t a, uint8_t bytes, uint32_t b, uint8_t others) { return a < b + others && b < a + bytes; }

static bool check_outputs(Check *c)
{
    const SmvmMachine *m = &c->m;

    for (SmvmAt i = 0; i < m->outputs; i++) {
        const SmvmPlace p = smvm_output(m, i);
        const SmvmAt at = (SmvmAt)(m->outputs_at + SMVM_PLACE * i);
        const uint8_t bytes = (uint8_t)(1u << smvm_type_shift(p.type));
        if (p.type >= SM_TYPE_COUNT || !is_inside(p.offset, bytes, m->from, m->to))
            return fail(c, SMVM_R_OUTPUTS, at);
        if (overlap(p.offset, bytes, m->g, 8) || overlap(p.offset, bytes, m->s, 4))
            return fail(c, SMVM_R_PROTECTED, at);
    }
    return true;
}

static bool check_vector(Check *c)
{
    const SmvmMachine *m = &c->m;

    if (m->from > m->to || m->to > m->sv_size)
        return fail(c, SMVM_R_SPAN, m->machine_at);
    if (!is_inside(m->g, 8, m->from, m->to) || !is_inside(m->s, 4, m->from, m->to))
        return fail(c, SMVM_R_TIME_STATE, m->machine_at);
    return overlap(m->g, 8, m->s, 4) ? fail(c, SMVM_R_PROTECTED, m->machine_at) : check_outputs(c);
}

static bool check_init(Check *c)
{
    const SmvmAt end = (SmvmAt)(c->m.init_at + c->m.init_size);

    for (SmvmAt at = c->m.init_at; at < end;) {
        SmvmPlace p;
        uint8_t bytes;
        if ((SmvmAt)(end - at) < SMVM_PLACE)
            return fail(c, SMVM_R_INIT, at);
        p = smvm_place(c->m.image, at);
        bytes = (uint8_t)(1u << smvm_type_shift(p.type));
        if (p.type >= SM_TYPE_COUNT || !is_inside(p.offset, bytes, 0, c->m.locals)
            || (SmvmAt)(end - at) < SMVM_PLACE + (SmvmAt)bytes)
            return fail(c, SMVM_R_INIT, at);
        at = (SmvmAt)(at + SMVM_PLACE + bytes);
    }
    return true;
}

// ---- instructions ----

// The next varint.  One that is too large for anything in this image becomes the largest, which is too large as well.
static bool take(Check *c, SmvmAt *value)
{
    uint32_t v;

    if (!smvm_varint(c->m.image, &c->at, c->end, &v))
        return fail(c, SMVM_R_TRUNCATED, c->at);
    *value = v > (SmvmAt)-1 ? (SmvmAt)-1 : (SmvmAt)v;
    return true;
}

static bool check_below(Check *c, SmvmAt from, SmvmAt end)       // a number from `from` up to before `end`
{
    SmvmAt at = c->at, n;

    return take(c, &n) && ((n >= from && n < end) || fail(c, SMVM_R_OPERAND, at));
}

static bool check_local(Check *c, uint8_t type)
{
    return check_below(c, 0, (SmvmAt)(c->m.locals >> smvm_type_shift(type)));
}

static bool check_element(Check *c, uint8_t type)
{
    return check_below(c, (SmvmAt)(c->m.from >> smvm_type_shift(type)), (SmvmAt)(c->m.to >> smvm_type_shift(type)));
}

static bool check_number(Check *c)                    // any
{
    SmvmAt n;

    return take(c, &n);
}

// What ldx_ or ldy_ loads.
static bool check_load(Check *c, uint8_t op)
{
    const uint8_t type = op & 0xf;

    if (op & 0x10)
        return type == (SMVM_ldx_time & 0xf) || check_element(c, type);
    switch (type) {
    case SMVM_ldx_plus & 0xf: case SMVM_ldx_minus & 0xf: return check_number(c);
    case SMVM_ldx_f32 & 0xf: return check_below(c, 0, c->m.f32s);
    case SMVM_ldx_f64 & 0xf: return check_below(c, 0, c->m.f64s);
    default: return check_local(c, type);
    }
}

static bool check_window(Check *c, SmvmAt *w)
{
    const SmvmAt at = c->at;

    return take(c, w) && (*w < c->m.windows || fail(c, SMVM_R_WINDOW_USED, at));
}

static bool check_stat(Check *c)
{
    const SmvmAt at = c->at;
    SmvmAt stat, w;

    if (!take(c, &stat) || !(stat < SM_STAT_COUNT || fail(c, SMVM_R_OPERAND, at)) || !check_window(c, &w))
        return false;
    if (!(smvm_window(c->m.image, c->m.windows_at, w) >> SMVM_WINDOW_SIZE_BITS & (uint32_t)SM_ROLL_AVG << stat))
        return fail(c, SMVM_R_WINDOW_USED, at);
    return w < c->sampled || fail(c, SMVM_R_SAMPLE, at);
}

static bool check_sample(Check *c)
{
    const SmvmAt at = c->at;
    SmvmAt w;

    return check_window(c, &w) && ((c->in == SMVM_IN_SAMPLE && w == c->sampled++ && c->far <= at) || fail(c, SMVM_R_SAMPLE, at));
}

static bool check_goto(Check *c)
{
    const SmvmAt at = c->at;
    SmvmAt state;

    if (!take(c, &state))
        return false;
    return (state >= 1 && state <= c->m.states && (c->in == SMVM_IN_ENTRY || c->in == SMVM_IN_STEP)) || fail(c, SMVM_R_GOTO, at);
}

// Whether a jump may lead to an instruction: the registers hold nothing there.
static bool is_target(uint8_t op)
{
    return op < SMVM_addi || op == SMVM_goto || op == SMVM_end || op == SMVM_jmp;
}

static bool check_jump(Check *c)
{
    const SmvmAt at = c->at;
    SmvmAt distance;
    uint8_t op;

    if (!take(c, &distance))
        return false;
    if (distance >= (SmvmAt)(c->end - c->at) || (op = smvm_u8(c->m.image, (SmvmAt)(c->at + distance))) < SMVM_OP_LEAST)
        return fail(c, SMVM_R_JUMP, at);
    if (!is_target(op))
        return fail(c, SMVM_R_REGISTER, at);
    distance = (SmvmAt)(c->at + distance);
    if (distance > c->far)
        c->far = distance;
    longest_jump(&c->way, distance);
    return true;
}

// The registers that an instruction needs, and what it leaves in them; opcodes.def says the same, and a test that it does.
SMVM_APART static bool check_registers(Check *c, uint8_t needs, uint8_t gives)
{
    if ((c->known & needs) != needs)
        return fail(c, SMVM_R_REGISTER, (SmvmAt)(c->at - 1));
    c->known = gives;
    return true;
}

static bool no_opcode(Check *c) { return fail(c, SMVM_R_OPCODE, (SmvmAt)(c->at - 1)); }

// 0x80 … 0xbf
static bool check_first(Check *c, uint8_t op)
{
    const uint8_t type = op & 0xf;

    switch (op) {
    case SMVM_stat: return check_registers(c, 0, HAS_X) && check_stat(c);
    case SMVM_addi: case SMVM_subi: return check_registers(c, HAS_X, c->known) && check_number(c);
    case SMVM_cvt: return check_registers(c, HAS_X, c->known) && check_below(c, 0, SM_TYPE_COUNT);
    case SMVM_set: return check_registers(c, HAS_X | HAS_Y, c->known) && check_below(c, 1, 15);
    default: break;
    }
    if (op & 0x10 && type >= SM_TYPE_COUNT && type != (SMVM_ldx_time & 0xf))
        return no_opcode(c);
    return check_registers(c, 0, op & 0x20 ? c->known | HAS_Y : HAS_X) && check_load(c, op);
}

// 0xc0 … 0xcf
static bool check_store(Check *c, uint8_t op)
{
    switch (op) {
    case SMVM_goto: return check_registers(c, 0, 0) && check_goto(c);
    case SMVM_end:
        return check_registers(c, 0, 0)
            && (c->in != SMVM_IN_SAMPLE || c->sampled == c->m.windows || fail(c, SMVM_R_SAMPLE, (SmvmAt)(c->at - 1)));
    case SMVM_out: return check_registers(c, HAS_X, HAS_X) && check_below(c, 0, c->m.outputs);
    case SMVM_sample: return check_registers(c, HAS_X, HAS_X) && check_sample(c);
    default: return check_registers(c, HAS_X, HAS_X) && check_local(c, op & 0xf);
    }
}

// 0xd0 … 0xef
static bool check_jumps(Check *c, uint8_t op)
{
    if (op < SMVM_jxy)
        return no_opcode(c);
    if (op == SMVM_jmp)
        return check_registers(c, 0, 0) && check_jump(c);
    return check_registers(c, op < SMVM_jmp ? HAS_X | HAS_Y : HAS_X, c->known) && (op < SMVM_jxn || op == SMVM_jt || check_number(c))
        && check_jump(c);
}

static bool does_not_go_on(uint8_t op) { return op == SMVM_end || op == SMVM_goto || op == SMVM_jmp; }

static bool check_instruction(Check *c, uint8_t op)
{
    if (op < SMVM_st_local)
        return op < SMVM_OP_LEAST ? no_opcode(c) : check_first(c, op);
    if (op < SMVM_jxy - 1)
        return check_store(c, op);
    return op < SMVM_add ? check_jumps(c, op) : check_registers(c, op < SMVM_neg ? HAS_X | HAS_Y : HAS_X, c->known);
}

static bool check_function(Check *c, SmvmAt end)
{
    uint8_t op = SMVM_end;

    c->at = c->far = c->start;
    c->known = 0;
    c->end = end;
    longest_begin(&c->way);
    while (c->at < c->end) {
        longest_arrive(&c->way, c->at);
        op = smvm_u8(c->m.image, c->at++);
        if (!check_instruction(c, op))
            return false;
        if (does_not_go_on(op))
            longest_leave(&c->way, op);
    }
    longest_end(&c->way, c->in);
    if (c->in == SMVM_IN_SAMPLE && c->sampled != c->m.windows)
        return fail(c, SMVM_R_SAMPLE, c->at);
    return does_not_go_on(op) || fail(c, SMVM_R_FALLS_OUT, c->at);
}

// Checks the function whose end is entry `index`, and goes on to the next.
static bool check_next(Check *c, SmvmIn in, SmvmAt index)
{
    const uint32_t size = smvm_function_end(&c->m, index);

    c->in = in;
    if (size > c->m.code_size || c->m.code_at + size < c->start)
        return fail(c, SMVM_R_FUNCTIONS, (SmvmAt)(c->m.functions_at + index * c->m.width));
    if (!check_function(c, (SmvmAt)(c->m.code_at + size)))
        return false;
    c->start = c->end;
    return true;
}

static bool check_code(Check *c)
{
    const SmvmAt last = (SmvmAt)(3 * c->m.states);

    c->start = c->m.code_at;
    c->sampled = 0;
    if (!check_next(c, SMVM_IN_SAMPLE, 0))
        return false;
    for (SmvmAt i = 0; i < last; i = (SmvmAt)(i + 3))
        if (!check_next(c, SMVM_IN_ENTRY, (SmvmAt)(i + 1)) || !check_next(c, SMVM_IN_STEP, (SmvmAt)(i + 2))
            || !check_next(c, SMVM_IN_EXIT, (SmvmAt)(i + 3)))
            return false;
    return c->start == c->m.code_at + c->m.code_size || fail(c, SMVM_R_FUNCTIONS, (SmvmAt)(c->m.functions_at + last * c->m.width));
}

// ---- the whole ----

static bool check_machine(Check *c, SmvmBytes image)
{
    uint8_t rule = 0;

    for (uint8_t i = 0, machines = 0; i < smvm_sections(image); i++) {
        SmvmSection s = smvm_section(image, i);
        if (s.id != SMVM_S_MACHINE || machines++ != c->v->machine)
            continue;
        memset(&c->m, 0, sizeof c->m);
        c->m.image = image;
        rule = smvm_read_machine(&c->m, (SmvmAt)s.at, (SmvmAt)s.size);
        if (rule != 0)
            return fail(c, rule, (SmvmAt)s.at);
    }
    smvm_machine(image, c->v->machine, &c->m);
    if (!check_windows(c) || !check_vector(c) || !check_init(c))
        return false;
    if (smvm_ram_size(&c->m) > SMVM_RAM_MAX || c->m.sv_size > SMVM_RAM_MAX)
        return fail(c, SMVM_R_RAM, c->m.windows_at);
    memset(&c->way, 0, sizeof c->way);
    return check_code(c);
}

uint32_t smvm_longest_step(const SmvmMachine *m)
{
    SmvmVerdict v;
    Check c;

    if (!SMVM_LONGEST)
        return 0;
    memset(&v, 0, sizeof v);
    memset(&c, 0, sizeof c);
    c.v = &v;
    c.m = *m;
    check_code(&c);
    return longest_step(&c.way);
}

static bool check_pins(Check *c, SmvmBytes image)
{
    SmvmAt at;
    uint8_t rule = smvm_check_pins(image, &at);

    return rule == 0 || fail(c, rule, at);
}

uint8_t smvm_verify(SmvmBytes image, uint32_t size, SmvmVerdict *v)
{
    Check c;

    memset(v, 0, sizeof *v);
    memset(&c, 0, sizeof c);
    c.v = v;
    if (!check_header(&c, image, size) || !check_crc(&c, image) || !check_sections(&c, image) || !check_pins(&c, image))
        return v->rule;
    // The number of machines is at most that of sections, 255: asking for each by its number stays linear in practice and bound.
    while (smvm_machine(image, v->machine, &c.m)) {
        uint32_t longest;
        if (!check_machine(&c, image))
            return v->rule;
        longest = longest_step(&c.way);
        v->longest = longest > v->longest ? longest : v->longest;
        v->machine++;
    }
    v->machine = 0;
    return 0;
}
