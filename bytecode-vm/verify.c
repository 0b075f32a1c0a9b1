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
    SmvmAt at;                // where in the image the walk stands
    SmvmAt entry;             // in the table of functions, of the function it is in
    SmvmAt start, end;        // that function
    SmvmAt far;               // how far a jump of the function has led
    SmvmAt sampled;           // windows that have their sample
    uint8_t stat;             // that the instruction asks for
    uint8_t known;            // HAS_X, HAS_Y
    bool over;                // control does not go on behind the last instruction
    SmvmIn in;
    SmvmMachine m;
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

    for (SmvmAt i = 0; i < c->end; i++) {
        if (i == SMVM_CRC_AT)
            i = (SmvmAt)(i + 4);
        crc = sm_crc32_byte(crc, smvm_u8(image, i));
    }
    return sm_crc32_end(crc) == smvm_uint(image, SMVM_CRC_AT, 4) || fail(c, SMVM_R_CRC, SMVM_CRC_AT);
}

static uint8_t version_of(uint8_t id)                 // 0: there is no such section
{
    switch (id) {
#define SMVM_SECTION(name, id_, version_, meaning) case id_: return version_;
#include "bytecode-vm/image.def"
#undef SMVM_SECTION
    default: return 0;
    }
}

// What stood before: an IO, a machine, of that its code, its initial values and its safe states.
enum { A_IO = 1, A_MACHINE = 2, A_CODE = 4, AN_INIT = 8, A_SAFE = 16 };

// Takes a known section into account: what it asks for must have stood before it, what it bars must not.
static bool add_section(uint8_t id, uint8_t *before)
{
    uint8_t asks = A_MACHINE, bars = 0, gives = 0;

    switch (id) {
    case SMVM_S_MACHINE:
        asks = *before & A_MACHINE ? A_CODE : 0;
        gives = A_MACHINE;
        break;
    case SMVM_S_CODE: bars = gives = A_CODE; break;
    case SMVM_S_INIT: bars = gives = AN_INIT; break;
    case SMVM_S_SAFE: bars = gives = A_SAFE; break;
    case SMVM_S_DEBUG: break;
    case SMVM_S_IO:
        asks = 0;
        bars = A_MACHINE | A_IO;
        gives = A_IO;
        break;
    default: return true;
    }
    if ((*before & asks) != asks || (*before & bars) != 0)
        return false;
    if (gives == A_MACHINE)
        *before &= (uint8_t)~(A_CODE | AN_INIT | A_SAFE);
    *before |= gives;
    return true;
}

// Sections in order, of ids known, in groups that each are MACHINE, CODE once, INIT and SAFE at most once.
static bool check_sections(Check *c, SmvmBytes image)
{
    SmvmAt entry = SMVM_HEADER, free_from = (SmvmAt)(SMVM_HEADER + SMVM_ENTRY * smvm_sections(image));
    uint8_t before = 0;

    for (uint8_t i = 0; i < smvm_sections(image); i++, entry = (SmvmAt)(entry + SMVM_ENTRY)) {
        const SmvmSection s = smvm_section(image, i);
        const bool known = s.version != 0 && s.version == version_of(s.id);
        if (s.at < free_from || s.at > c->end || s.size > (SmvmAt)(c->end - s.at))
            return fail(c, SMVM_R_SECTION, entry);
        free_from = (SmvmAt)(s.at + s.size);
        if (!known && s.id >= SMVM_MUST_KNOW)
            return fail(c, SMVM_R_UNKNOWN, entry);
        if (known && !add_section(s.id, &before))
            return fail(c, SMVM_R_GROUP, entry);
    }
    return (before & (A_MACHINE | A_CODE)) == (A_MACHINE | A_CODE) || fail(c, SMVM_R_GROUP, SMVM_SECTIONS_AT);
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

SMVM_APART static bool is_inside(SmvmAt offset, uint8_t bytes, SmvmAt from, SmvmAt to)
{
    return offset >= from && offset < to && bytes <= (SmvmAt)(to - offset);
}

// Of what is inside, so that no end is beyond what an SmvmAt holds.
SMVM_APART static bool overlap(SmvmAt a, uint8_t bytes, SmvmAt b, uint8_t others)
{
    return a < (SmvmAt)(b + others) && b < (SmvmAt)(a + bytes);
}

SMVM_APART static uint8_t size_of(SmType type) { return (uint8_t)(1u << smvm_shift((uint8_t)type)); }

static bool check_outputs(Check *c)
{
    const SmvmMachine *m = &c->m;

    for (SmvmAt i = 0; i < m->outputs; i++) {
        const SmvmPlace p = smvm_output(m, i);
        const SmvmAt at = (SmvmAt)(m->outputs_at + SMVM_PLACE * i);
        const uint8_t bytes = size_of(p.type);
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
        bytes = size_of(p.type);
        if (p.type >= SM_TYPE_COUNT || !is_inside(p.offset, bytes, 0, c->m.locals)
            || (SmvmAt)(end - at) < SMVM_PLACE + (SmvmAt)bytes)
            return fail(c, SMVM_R_INIT, at);
        at = (SmvmAt)(at + SMVM_PLACE + bytes);
    }
    return true;
}

// ---- instructions ----

// Whether a jump may lead to an instruction: the registers hold nothing there.
static bool is_target(uint8_t op)
{
    return op < SMVM_addi || op == SMVM_goto || op == SMVM_end || op == SMVM_jmp;
}

static bool check_jump(Check *c, SmvmAt at, SmvmAt distance)
{
    uint8_t op;

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

static bool check_sample(Check *c, SmvmAt at, SmvmAt w)
{
    return (c->in == SMVM_IN_SAMPLE && w == c->sampled++ && c->far <= at) || fail(c, SMVM_R_SAMPLE, at);
}

static bool check_sampled(Check *c, SmvmAt at)        // where a function ends
{
    return c->in != SMVM_IN_SAMPLE || c->sampled == c->m.windows || fail(c, SMVM_R_SAMPLE, at);
}

static bool check_stat(Check *c, SmvmAt at, SmvmAt w)
{
    const uint16_t kind = (uint16_t)(smvm_window(c->m.image, c->m.windows_at, w) >> 16);

    if ((kind >> (SMVM_WINDOW_SIZE_BITS - 16) & (unsigned)SM_ROLL_AVG << c->stat) == 0)
        return fail(c, SMVM_R_WINDOW_USED, at);
    return w < c->sampled || fail(c, SMVM_R_SAMPLE, at);
}

// The bits of a shape that say what follows.
enum { AN_L, AN_E, AN_N, AN_F, A_D, AN_O, AN_S, A_K, A_W, A_T, AN_M, A_J, FOLLOWS };
typedef char verify_bits_are_those_of_shapes[1 << A_J == SMVM_SHAPE_J && (1 << FOLLOWS) - 1 == SMVM_SHAPE_FOLLOWS ? 1 : -1];

// A number that follows an opcode: it is one from `from` up to before `end`.
SMVM_APART static bool check_operand(Check *c, uint8_t op, uint8_t follows)
{
    const SmvmMachine *m = &c->m;
    const uint8_t shift = smvm_shift(op & 0xf);
    const SmvmAt at = c->at;
    const uint32_t v = smvm_number(m->image, &c->at, c->end);
    const SmvmAt n = v < SMVM_NOWHERE ? (SmvmAt)v : SMVM_NOWHERE;
    SmvmAt from = 0, end;
    uint8_t rule = SMVM_R_OPERAND;

    if (v == SMVM_NO_NUMBER)
        return fail(c, SMVM_R_TRUNCATED, c->at);
    switch (follows) {
    case AN_L: end = m->locals >> shift; break;
    case AN_E:
        from = m->from >> shift;
        end = m->to >> shift;
        break;
    case AN_F: end = m->f32s; break;
    case A_D: end = m->f64s; break;
    case AN_O: end = m->outputs; break;
    case AN_S:
        from = 1;
        end = (SmvmAt)(c->in == SMVM_IN_ENTRY || c->in == SMVM_IN_STEP ? m->states + 1u : 0);
        rule = SMVM_R_GOTO;
        break;
    case A_K:
        end = SM_STAT_COUNT;
        c->stat = (uint8_t)n;
        break;
    case A_W:
        end = m->windows;
        rule = SMVM_R_WINDOW_USED;
        break;
    case A_T: end = SM_TYPE_COUNT; break;
    case AN_M:
        from = 1;
        end = 15;
        break;
    case A_J: return check_jump(c, at, n);
    default: return true;                             // N
    }
    if (n < from || n >= end)
        return fail(c, rule, at);
    if (follows != A_W)
        return true;
    return op == SMVM_sample ? check_sample(c, at, n) : check_stat(c, at, n);
}

// The registers that an instruction needs, and what it leaves in them.
static bool check_registers(Check *c, uint32_t shape)
{
    if ((shape & SMVM_SHAPE_X && !(c->known & HAS_X)) || (shape & SMVM_SHAPE_Y && !(c->known & HAS_Y)))
        return fail(c, SMVM_R_REGISTER, (SmvmAt)(c->at - 1));
    if (shape & SMVM_SHAPE_FY)
        c->known &= (uint8_t)~HAS_Y;
    if (shape & SMVM_SHAPE_GX)
        c->known |= HAS_X;
    if (shape & SMVM_SHAPE_GY)
        c->known |= HAS_Y;
    if (shape & SMVM_SHAPE_Z)
        c->known = 0;
    return true;
}

static bool check_instruction(Check *c, uint8_t op)
{
    const uint32_t shape = smvm_shape(op);
    const SmvmAt at = (SmvmAt)(c->at - 1);
    uint16_t follows = shape & SMVM_SHAPE_FOLLOWS;

    if (shape == 0)
        return fail(c, SMVM_R_OPCODE, at);
    if (!check_registers(c, shape))
        return false;
    for (uint8_t i = 0; follows != 0; i++, follows >>= 1)
        if (follows & 1 && !check_operand(c, op, i))
            return false;
    c->over = (shape & SMVM_SHAPE_Z) != 0;
    return op != SMVM_end || check_sampled(c, at);
}

static bool check_function(Check *c)
{
    c->at = c->far = c->start;
    c->known = 0;
    c->over = true;
    longest_begin(&c->way);
    while (c->at < c->end) {
        uint8_t op;
        longest_arrive(&c->way, c->at);
        op = smvm_u8(c->m.image, c->at++);
        if (!check_instruction(c, op))
            return false;
        if (c->over)
            longest_leave(&c->way, op);
    }
    longest_end(&c->way, c->in);
    return check_sampled(c, c->at) && (c->over || fail(c, SMVM_R_FALLS_OUT, c->at));
}

// Checks the function whose end is the next entry.
static bool check_next(Check *c)
{
    const SmvmAt size = smvm_at(c->m.image, c->entry, (uint8_t)c->m.width);

    c->end = (SmvmAt)(c->m.code_at + size);
    if (size > c->m.code_size || c->end < c->start)
        return fail(c, SMVM_R_FUNCTIONS, c->entry);
    if (!check_function(c))
        return false;
    c->start = c->end;
    return true;
}

// The sample function; then for each state entry, step and exit.
static bool check_code(Check *c)
{
    c->start = c->m.code_at;
    c->sampled = 0;
    c->in = SMVM_IN_SAMPLE;
    for (c->entry = c->m.functions_at; c->entry < c->m.f32s_at; c->entry = (SmvmAt)(c->entry + c->m.width)) {
        if (!check_next(c))
            return false;
        c->in = c->in == SMVM_IN_EXIT ? SMVM_IN_ENTRY : (SmvmIn)(c->in + 1);
    }
    return c->start == c->m.code_at + c->m.code_size || fail(c, SMVM_R_FUNCTIONS, (SmvmAt)(c->entry - c->m.width));
}

// ---- the whole ----

static bool check_safe(Check *c)
{
    uint8_t any = 0, last = 0;

    for (SmvmAt i = 0; i < c->m.safe_size; i++)
        any |= last = smvm_u8(c->m.image, (SmvmAt)(c->m.safe_at + i));
    return c->m.safe_at == 0 || (c->m.safe_size == (SmvmAt)(c->m.states + 7) >> 3 && any != 0 && last >> (((c->m.states - 1) & 7) + 1) == 0)
        || fail(c, SMVM_R_SAFE, c->m.safe_at);
}

static bool check_machine(Check *c)
{
    if (!check_windows(c) || !check_vector(c) || !check_init(c) || !check_safe(c))
        return false;
    if (smvm_ram_size(&c->m) > SMVM_RAM_MAX || c->m.sv_size > SMVM_RAM_MAX)
        return fail(c, SMVM_R_RAM, c->m.windows_at);
    memset(&c->way, 0, sizeof c->way);
    return check_code(c);
}

// There are at most as many as sections, 255: asking for each by its number stays linear in practice and bound.
static bool check_machines(Check *c, SmvmBytes image)
{
    uint8_t rule;

    for (; (rule = smvm_look(image, (uint8_t)c->v->machine, &c->m)) != SMVM_R_GROUP; c->v->machine++) {
        uint32_t longest;
        if (rule != 0)
            return fail(c, rule, c->m.machine_at);
        if (!check_machine(c))
            return false;
        longest = longest_step(&c->way);
        c->v->longest = longest > c->v->longest ? longest : c->v->longest;
    }
    c->v->machine = 0;
    return true;
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

SMVM_APART static bool check_pins(Check *c, SmvmBytes image)
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
    (void)(check_header(&c, image, size) && check_crc(&c, image) && check_sections(&c, image) && check_pins(&c, image)
           && check_machines(&c, image));
    return v->rule;
}
