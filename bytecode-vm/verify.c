// SPDX-License-Identifier: Apache-2.0
// Proves an image safe before it runs.  After that, neither image nor state vector can make the interpreter leave its memory, loop
// without bound or trap.  A single pass over sections, tables and code checks everything and computes the longest step.
//
// One pass suffices, without a record of where instructions begin, because of the encoding: the operand bytes after an opcode are
// below 0x80, and an opcode never is.  So a jump leads to an instruction if and only if it leads to a byte from 0x80 on, in code that
// is itself well formed.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/longest.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/crc32.h"
#include "stdlib/flash.h"

// ---- opcodes ----

enum {
    L = SMVM_SHAPE_L, E = SMVM_SHAPE_E, N = SMVM_SHAPE_N, F = SMVM_SHAPE_F, D = SMVM_SHAPE_D, O = SMVM_SHAPE_O, S = SMVM_SHAPE_S,
    K = SMVM_SHAPE_K, W = SMVM_SHAPE_W, T = SMVM_SHAPE_T, M = SMVM_SHAPE_M, J = SMVM_SHAPE_J, X = SMVM_SHAPE_X, Y = SMVM_SHAPE_Y,
    GX = SMVM_SHAPE_GX
};
#define GY SMVM_SHAPE_GY                              // GY, FY and Z are no enumerators, because their values may be too large for an int
#define FY SMVM_SHAPE_FY
#define Z SMVM_SHAPE_Z

// SMVM_PACK_OPERANDS converts the operand bits of a shape to one of SMVM_OPERAND_NONE to SMVM_OPERANDS_N_J (image.h).
#define SMVM_IS(what, number) ((uint16_t)((what) & SMVM_SHAPE_FOLLOWS) == (number))
#define SMVM_PACK_OPERANDS(s) \
    (SMVM_IS(s, L) ? SMVM_OPERAND_L : SMVM_IS(s, E) ? SMVM_OPERAND_E : SMVM_IS(s, N) ? SMVM_OPERAND_N : SMVM_IS(s, F) ? SMVM_OPERAND_F : \
     SMVM_IS(s, D) ? SMVM_OPERAND_D : SMVM_IS(s, O) ? SMVM_OPERAND_O : SMVM_IS(s, S) ? SMVM_OPERAND_S : SMVM_IS(s, K) ? SMVM_OPERAND_K : \
     SMVM_IS(s, W) ? SMVM_OPERAND_W : SMVM_IS(s, T) ? SMVM_OPERAND_T : SMVM_IS(s, M) ? SMVM_OPERAND_M : SMVM_IS(s, J) ? SMVM_OPERAND_J : \
     SMVM_IS(s, K | W) ? SMVM_OPERANDS_K_W : SMVM_IS(s, N | J) ? SMVM_OPERANDS_N_J : SMVM_OPERAND_NONE)

static const struct OpcodeRow { uint8_t first, last; uint16_t packed_shape; } rows[] SM_FLASH = {
#define SMVM_OP(name, first, last, shape, meaning) {first, last, (uint16_t)(SMVM_PACK_OPERANDS(shape) | (uint32_t)(shape) >> 12 << 4)},
#include "bytecode-vm/opcodes.def"
#undef SMVM_OP
};

enum {
#define SMVM_OP(name, first, last, shape, meaning) ROW_##name,
#include "bytecode-vm/opcodes.def"
#undef SMVM_OP
};

// The first row of each group of sixteen opcodes.  Rows ascend; the most frequent opcodes are in the first or second row of a group.
static const uint8_t first_row[] SM_FLASH = {ROW_ldx_local, ROW_ldx_elem, ROW_ldy_local, ROW_ldy_elem,
                                          ROW_st_local, ROW_jxy, ROW_jf, ROW_add};

uint16_t smvm_packed_shape(uint8_t opcode)
{
    struct OpcodeRow r;
    uint8_t row;

    sm_flash_read(&row, &first_row[opcode >> 4 & 7], 1);
    do
        sm_flash_read(&r, &rows[row++], sizeof r);
    while (opcode > r.last);                          // the last row ends with the last opcode
    return opcode < r.first ? 0 : r.packed_shape;
}

// ---- the pass ----

enum { HAS_X = 1, HAS_Y = 2 };       // bits of Verifier.defined: the register contains a number

// The state of the pass over an image.  The check_ functions return 0, or the number of the rule that is broken at `where`.
typedef struct Verifier {
    SmvmReader in;            // reads the image: the current position, and the end of the current function
    SmvmAt where;             // offset of the data being checked
    SmvmAt furthest_target;   // offset of the furthest target of the function's jumps so far
    SmvmAt windows_sampled;   // how many windows the sample function has sampled so far
    uint8_t stat;             // the statistic that the current instruction reads
    uint8_t defined;          // the registers that contain a number: HAS_X, HAS_Y
    bool is_ended;            // control cannot continue after the last instruction
    uint8_t kind;             // kind of the current function (SmvmFunctionKind)
    SmvmMachine m;                   // the machine that is checked
#if SMVM_PARAMETERS
    SmvmAt read_only_from, read_only_to;      // the part of the locals that no code writes, from the first parameter to the last
#endif
    LongestPath longest;
} Verifier;

// ---- the container ----

// Checks the head of the image and its section table.  Like all check functions here, returns 0, or the rule that is broken.
static uint8_t check_header(Verifier *c, uint32_t size)
{
    const SmvmBytes image = c->in.image;

    if (size < SMVM_HEADER)
        return SMVM_R_LENGTH;
    if (smvm_u24(image, 0) != SMVM_MAGIC)
        return SMVM_R_MAGIC;
    c->where = 3;
    if (smvm_u8(image, 3) != SMVM_FORMAT)
        return SMVM_R_FORMAT;
    c->where = SMVM_LENGTH_AT;
    c->in.end = smvm_read_offset(image, SMVM_LENGTH_AT, 3);
    if (c->in.end > size || c->in.end > SMVM_IMAGE_MAX || c->in.end < SMVM_HEADER + (SmvmAt)SMVM_SECTION_ENTRY * smvm_section_count(image))
        return SMVM_R_LENGTH;
    return 0;
}

static uint8_t check_crc(Verifier *c)
{
    uint32_t crc = SM_CRC32_START;

    c->where = SMVM_CRC_AT;
    for (SmvmAt i = 0; i < c->in.end; i++)
        if ((SmvmAt)(i - SMVM_CRC_AT) >= 4)
            crc = sm_crc32_byte(crc, smvm_u8(c->in.image, i));
    return sm_crc32_end(crc) == smvm_uint(c->in.image, SMVM_CRC_AT, 4) ? 0 : SMVM_R_CRC;
}

// Checks the section table: sections in the order of their offsets, with known ids, in groups of one MACHINE, one CODE, at most one INIT
// and at most one SAFE.
SMVM_NOINLINE static uint8_t check_sections(Verifier *c)
{
    const uint8_t n = smvm_section_count(c->in.image);
    SmvmAt free_from = (SmvmAt)(SMVM_HEADER + SMVM_SECTION_ENTRY * n);
    uint8_t before = SMVM_HAS_CODE;                   // as if a complete machine preceded the first

    c->where = SMVM_HEADER;
    for (uint8_t i = 0; i < n; i++, c->where = (SmvmAt)(c->where + SMVM_SECTION_ENTRY)) {
        SmvmSection s;
        smvm_read_section(c->in.image, i, &s);
        if (s.at < free_from || s.at > c->in.end || s.size > (SmvmAt)(c->in.end - s.at))
            return SMVM_R_SECTION;
        free_from = (SmvmAt)(s.at + s.size);
        if (s.kind.id == 0 && s.id >= SMVM_MUST_KNOW)
            return SMVM_R_UNKNOWN;
        if ((s.kind.requires & ~before) != 0 || (s.kind.forbids & before) != 0)
            return SMVM_R_GROUP;
        if (s.kind.provides == SMVM_HAS_MACHINE)
            before &= SMVM_HAS_IO;
        before |= s.kind.provides;
    }
    c->where = SMVM_SECTIONS_AT;
    return (~before & (SMVM_HAS_MACHINE | SMVM_HAS_CODE)) != 0 ? SMVM_R_GROUP : 0;
}

// ---- the machine's tables ----

static uint8_t check_windows(Verifier *c)
{
    for (c->where = c->m.windows_at; c->where < c->m.outputs_at; c->where = (SmvmAt)(c->where + SMVM_WINDOW_ENTRY)) {
        const uint32_t entry = smvm_uint(c->in.image, c->where, SMVM_WINDOW_ENTRY);
        if (smvm_window_size(entry) - 1 >= SM_WINDOW_MAX || !sm_roll_is_kind(smvm_window_kind(entry)))
            return SMVM_R_WINDOW;
    }
    return 0;
}

// Whether `bytes` bytes at `offset` are inside from … to - 1.
SMVM_NOINLINE static bool is_range_inside(SmvmAt offset, uint8_t bytes, SmvmAt from, SmvmAt to)
{
    return offset >= from && offset < to && bytes <= (SmvmAt)(to - offset);
}

// Whether two ranges share a byte.  Both must be inside the state vector, so that their ends do not exceed an SmvmAt.
SMVM_NOINLINE static bool is_overlapping(SmvmAt a, uint8_t bytes, SmvmAt b, uint8_t others)
{
    return a < (SmvmAt)(b + others) && b < (SmvmAt)(a + bytes);
}

SMVM_NOINLINE static uint8_t type_size(SmType type) { return (uint8_t)(1u << smvm_shift((uint8_t)type)); }

// Reads the location at `where` into *p.  Returns false if its type does not exist or if it is not wholly inside from … to - 1.
SMVM_NOINLINE static bool read_location_inside(const Verifier *c, SmvmLocation *p, SmvmAt from, SmvmAt to)
{
    *p = smvm_location(c->in.image, c->where);
    return p->type < SM_TYPE_COUNT && is_range_inside(p->offset, type_size(p->type), from, to);
}

static uint8_t check_outputs(Verifier *c)
{
    const SmvmMachine *m = &c->m;
    SmvmLocation p;

    for (c->where = m->outputs_at; c->where < m->functions_at; c->where = (SmvmAt)(c->where + SMVM_LOCATION_BYTES)) {
        if (!read_location_inside(c, &p, m->from, m->to))
            return SMVM_R_OUTPUTS;
        if (is_overlapping(p.offset, type_size(p.type), m->g, 8) || is_overlapping(p.offset, type_size(p.type), m->s, 4))
            return SMVM_R_PROTECTED;
    }
    return 0;
}

static uint8_t check_vector(Verifier *c)
{
    const SmvmMachine *m = &c->m;

    c->where = m->machine_at;
    if (m->from > m->to || m->to > m->sv_size)
        return SMVM_R_SPAN;
    if (!is_range_inside(m->g, 8, m->from, m->to) || !is_range_inside(m->s, 4, m->from, m->to))
        return SMVM_R_TIME_STATE;
    return is_overlapping(m->g, 8, m->s, 4) ? SMVM_R_PROTECTED : check_outputs(c);
}

static uint8_t check_init(Verifier *c)
{
    SmvmAt left = c->m.init_size, bytes;
    SmvmLocation p;

    for (c->where = c->m.init_at; left > 0; c->where = (SmvmAt)(c->where + bytes)) {
        if (left < SMVM_LOCATION_BYTES || !read_location_inside(c, &p, 0, c->m.locals) ||
            left < (bytes = (SmvmAt)(SMVM_LOCATION_BYTES + type_size(p.type))))
            return SMVM_R_INIT;
        left = (SmvmAt)(left - bytes);
    }
    return 0;
}

// Checks SAFE: it has a bit for each state, at least one bit is set, and none beyond the last state.
static uint8_t check_safe(Verifier *c)
{
    SmvmAt left = c->m.safe_size, at = c->m.safe_at;
    uint8_t any = 0, last = 0;

    c->where = at;
    if (at == 0)
        return 0;
    if (left != (SmvmAt)(c->m.states + 7) >> 3)
        return SMVM_R_SAFE;
    for (; left > 0; left--)
        any |= last = smvm_u8(c->in.image, at++);
    return any == 0 || last >> (((uint8_t)c->m.states - 1) & 7) > 1 ? SMVM_R_SAFE : 0;
}

// ---- parameters ----

#if SMVM_PARAMETERS

// Whether number `a` of a parameter is at most number `b`.  Of floats -0 is below 0, and NaN is beyond the infinities of its sign.
SMVM_NOINLINE static bool is_at_most(const Verifier *c, const SmvmParameterEntry *p, uint8_t a, uint8_t b)
{
    const uint8_t type = (uint8_t)p->location.type;
    const uint8_t sign = type < SM_U8 || type == SM_F32 || type == SM_F64 ? 0x80 : 0;
    const SmvmAt at_a = smvm_parameter_number(p, a), at_b = smvm_parameter_number(p, b);
    uint8_t flip = sign;
    bool reversed = false;            // both numbers are negative floats: the one with the larger magnitude is the smaller number

    for (uint8_t i = p->bytes; i-- > 0; flip = 0) {
        const uint8_t x = smvm_u8(c->in.image, (SmvmAt)(at_a + i)) ^ flip, y = smvm_u8(c->in.image, (SmvmAt)(at_b + i)) ^ flip;
        if (flip != 0 && type >= SM_F32)
            reversed = x < 0x80 && y < 0x80;
        if (x != y)
            return (x < y) != reversed;
    }
    return true;
}

// Whether an end of a range is a number that its type has: a bool is 0 or 1, and a float finite.
static bool is_valid_end(const Verifier *c, const SmvmParameterEntry *p, uint8_t which)
{
    const SmvmAt end = smvm_parameter_number(p, (uint8_t)(which + 1));
    const uint8_t type = (uint8_t)p->location.type, top = smvm_u8(c->in.image, (SmvmAt)(end - 1));
    const uint8_t exponent = type == SM_F64 ? 0xf0 : 0x80;            // bits of the exponent in the byte below the most significant one

    if (type == SM_BOOL)
        return top <= 1;
    return (type != SM_F32 && type != SM_F64) || (top & 0x7f) != 0x7f || (smvm_u8(c->in.image, (SmvmAt)(end - 2)) & exponent) != exponent;
}

// Checks the range, the default and the value of a parameter.
static bool check_parameter_values(const Verifier *c, const SmvmParameterEntry *p)
{
    for (uint8_t i = SMVM_PARAMETER_DEFAULT; i < SMVM_PARAMETER_NUMBERS; i++)
        if (!is_at_most(c, p, SMVM_PARAMETER_LOWEST, i) || !is_at_most(c, p, i, SMVM_PARAMETER_HIGHEST))
            return false;
    return is_valid_end(c, p, SMVM_PARAMETER_LOWEST) && is_valid_end(c, p, SMVM_PARAMETER_HIGHEST);
}

// Checks PARAMETERS, and sets c->read_only_from and c->read_only_to to the part of the locals that contains the parameters.
SMVM_NOINLINE static uint8_t check_parameters(Verifier *c)
{
    SmvmReader r = smvm_parameters(&c->m);
    SmvmParameterEntry p;

    c->read_only_from = c->read_only_to = 0;
    while ((c->where = r.at) < r.end) {
        if (!smvm_read_parameter(&r, &p) || p.location.type >= SM_TYPE_COUNT || p.size[0] == 0 ||
            !is_range_inside(p.location.offset, p.bytes, c->read_only_to, c->m.locals))
            return SMVM_R_PARAMETERS;
        if (c->read_only_to == 0)
            c->read_only_from = p.location.offset;
        c->read_only_to = (SmvmAt)(p.location.offset + p.bytes);
        if (!check_parameter_values(c, &p))
            return SMVM_R_VALUE;
    }
    return 0;
}

// Whether a store of this type to the local at this offset, in units of its size, changes a parameter.
static bool is_store_to_parameter(const Verifier *c, uint8_t op, SmvmAt n)
{
    const uint8_t shift = smvm_shift(op & 0xf);
    const SmvmAt at = (SmvmAt)(n << shift);

    return op >= SMVM_st_local && op < SMVM_out && at < c->read_only_to && (SmvmAt)(at + (1u << shift)) > c->read_only_from;
}
#endif

// ---- instructions ----

// Whether an instruction may be the target of a jump.  It must read no register, because none is defined there, and must define X or end
// the path.  The opcodes below addi are the loads of X.
static bool may_be_jump_target(uint8_t op)
{
    return op < SMVM_addi || op == SMVM_goto || op == SMVM_end || op == SMVM_jmp;
}

static uint8_t check_jump(Verifier *c)
{
    SmvmAt to = c->in.n;
    uint8_t op;

    if (to >= (SmvmAt)(c->in.end - c->in.at))
        return SMVM_R_JUMP;
    to = (SmvmAt)(to + c->in.at);
    if ((op = smvm_u8(c->in.image, to)) < SMVM_OP_FIRST)
        return SMVM_R_JUMP;
    if (!may_be_jump_target(op))
        return SMVM_R_REGISTER;
    if (to > c->furthest_target)
        c->furthest_target = to;
    longest_jump(&c->longest, to);
    return 0;
}

// Checks the window operand, just read, of `sample` or `stat`.
static uint8_t check_window(Verifier *c, uint8_t op)
{
    const SmvmAt w = c->in.n;

    if (op == SMVM_sample)
        return c->kind == SMVM_SAMPLE_FUNCTION && w == c->windows_sampled++ && c->furthest_target <= c->where ? 0 : SMVM_R_SAMPLE;
    if ((smvm_window_kind(smvm_window(c->in.image, c->m.windows_at, w)) & (unsigned)SM_ROLL_AVG << c->stat) == 0)
        return SMVM_R_WINDOW_USED;
    return w < c->windows_sampled ? 0 : SMVM_R_SAMPLE;
}

// At the end of a function: the sample function must have sampled every window.
static uint8_t check_all_sampled(const Verifier *c)
{
    return c->kind != SMVM_SAMPLE_FUNCTION || c->windows_sampled == c->m.windows ? 0 : SMVM_R_SAMPLE;
}

// The valid range of each operand, indexed by SMVM_OPERAND_L to SMVM_OPERAND_M: its first value (`from`), the number of its values
// (`below`), and the rule that another value breaks.  `below` is the offset of a field of SmvmMachine, or a number with bit CONSTANT set.
#define FIELD(field) offsetof(SmvmMachine, field)
enum { CONSTANT = 0x80, RELATION_SETS = 14 };         // a set of relations is 1 to 14: neither empty nor all four
static const struct OperandLimit { uint8_t below, from, rule; } limits[] SM_FLASH = {
    {0, 0, 0}, {FIELD(locals), 0, SMVM_R_OPERAND}, {FIELD(to), 0, SMVM_R_OPERAND}, {0, 0, 0}, {FIELD(f32s), 0, SMVM_R_OPERAND},
    {FIELD(f64s), 0, SMVM_R_OPERAND}, {FIELD(outputs), 0, SMVM_R_OPERAND}, {FIELD(states), 1, SMVM_R_GOTO},
    {CONSTANT | SM_STAT_COUNT, 0, SMVM_R_OPERAND},
    {FIELD(windows), 0, SMVM_R_WINDOW_USED}, {CONSTANT | SM_TYPE_COUNT, 0, SMVM_R_OPERAND}, {CONSTANT | RELATION_SETS, 1, SMVM_R_OPERAND},
};

// Checks the number, just read, of the function that `fn` calls.
static uint8_t check_call(const Verifier *c)
{
    static const uint32_t known SM_FLASH = SMVM_FUNCTIONS & (0
#define SM_ELEMENTARY(name, arguments, number) | UINT32_C(1) << (number)
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
        );
    uint32_t set;

    sm_flash_read(&set, &known, sizeof set);
    return c->in.n < SMVM_FN_MAX && (set >> c->in.n & 1) != 0 ? 0 : SMVM_R_FUNCTION;
}

// Whether the instruction, whose operands are next, also reads Y: the call of a function of two arguments.
static bool is_call_of_two(const Verifier *c, uint8_t op)
{
    return op == SMVM_fn && c->in.at < c->in.end && smvm_u8(c->in.image, c->in.at) >= SMVM_FN_OF_TWO;
}

// Reads and checks one operand; `what` is SMVM_OPERAND_L to SMVM_OPERAND_J.
SMVM_NOINLINE static uint8_t check_operand(Verifier *c, uint8_t op, uint8_t what)
{
    const SmvmMachine *m = &c->m;
    struct OperandLimit l;
    SmvmAt from, end;

    c->where = c->in.at;
    if (smvm_read_number(&c->in) == SMVM_VARINT_CUT_SHORT) {
        c->where = c->in.at;
        return SMVM_R_TRUNCATED;
    }
    if (what == SMVM_OPERAND_N)
        return op != SMVM_fn ? 0 : check_call(c);
    if (what == SMVM_OPERAND_J)
        return check_jump(c);
    sm_flash_read(&l, &limits[what], sizeof l);
    from = l.from;
    end = l.below & CONSTANT ? l.below & (CONSTANT - 1) : *(const SmvmAt *)(const void *)((const uint8_t *)m + l.below);
    if (what <= SMVM_OPERAND_E) {
        const uint8_t shift = smvm_shift(op & 0xf);
        if (what == SMVM_OPERAND_E)
            from = m->from;
        end = (SmvmAt)(end - from) >> shift;
        from = from >> shift;
    }
    if ((SmvmAt)(c->in.n - from) >= end || (what == SMVM_OPERAND_S && c->kind != SMVM_ENTRY_FUNCTION && c->kind != SMVM_STEP_FUNCTION))
        return l.rule;
#if SMVM_PARAMETERS
    if (what == SMVM_OPERAND_L && is_store_to_parameter(c, op, c->in.n))
        return SMVM_R_READ_ONLY;
#endif
    if (what == SMVM_OPERAND_K)
        c->stat = (uint8_t)c->in.n;
    return what == SMVM_OPERAND_W ? check_window(c, op) : 0;
}

// Checks all operands of an instruction; `follow` is SMVM_OPERAND_NONE to SMVM_OPERANDS_N_J.
static uint8_t check_operands(Verifier *c, uint8_t op, uint8_t follow)
{
    uint8_t rule = 0;

    if (follow == SMVM_OPERANDS_K_W) {
        rule = check_operand(c, op, SMVM_OPERAND_K);
        follow = SMVM_OPERAND_W;
    } else if (follow == SMVM_OPERANDS_N_J) {
        rule = check_operand(c, op, SMVM_OPERAND_N);
        follow = SMVM_OPERAND_J;
    }
    return rule != 0 || follow == SMVM_OPERAND_NONE ? rule : check_operand(c, op, follow);
}

// The bits of a packed shape above the operands: whether an instruction reads and writes X, makes Y undefined, and ends the path.
enum { READS = SMVM_SHAPE_X >> 8, WRITES = SMVM_SHAPE_GX >> 8, CLOBBERS_Y = (int)(SMVM_SHAPE_FY >> 8), ENDS_FLOW = (int)(SMVM_SHAPE_Z >> 8) };
typedef char verify_register_bits_match_packed_shapes[READS == HAS_X << 4 && READS << 1 == SMVM_SHAPE_Y >> 8 && WRITES == HAS_X << 6 &&
                                                 (int)(SMVM_SHAPE_GY >> 8) == HAS_Y << 6 ? 1 : -1];

// Checks an instruction with its operands, and updates c->defined by its effect on X and Y. Returns 0, or the rule that is broken.
static uint8_t check_instruction(Verifier *c, uint8_t op)
{
    const uint16_t shape = smvm_packed_shape(op);
    uint8_t rule;

    if (shape == 0)
        return SMVM_R_OPCODE;
    if (((uint8_t)shape >> 4 & (HAS_X | HAS_Y) & ~c->defined) != 0)
        return SMVM_R_REGISTER;
    if (is_call_of_two(c, op) && (c->defined & HAS_Y) == 0)
        return SMVM_R_REGISTER;
    if (shape & CLOBBERS_Y)
        c->defined &= HAS_X;
    c->defined = (uint8_t)(c->defined | (uint8_t)shape >> 6);
    c->is_ended = (shape & ENDS_FLOW) != 0;
    if (c->is_ended)
        c->defined = 0;
    if ((rule = check_operands(c, op, shape & 0xf)) != 0)
        return rule;
    return op == SMVM_end ? check_all_sampled(c) : 0;
}

// Checks the instructions of one function.  Returns 0, or the rule that is broken.
static uint8_t check_function(Verifier *c)
{
    uint8_t rule;

    c->furthest_target = c->in.at;
    c->defined = 0;
    c->is_ended = true;
    longest_begin(&c->longest);
    while ((c->where = c->in.at) < c->in.end) {
        const uint8_t op = smvm_u8(c->in.image, c->in.at++);
        longest_at_instruction(&c->longest, c->where);
        if ((rule = check_instruction(c, op)) != 0)
            return rule;
        if (c->is_ended)
            longest_after_terminator(&c->longest, op);
    }
    longest_end(&c->longest, (SmvmFunctionKind)c->kind);
    rule = check_all_sampled(c);
    return rule == 0 && !c->is_ended ? SMVM_R_FALLS_OUT : rule;
}

// Checks the functions in the order of their table: the sample function; then entry, step and exit of each state.
static uint8_t check_code(Verifier *c)
{
    SmvmAt entry, size;
    uint8_t rule;

    c->in.at = c->m.code_at;
    c->windows_sampled = 0;
    c->kind = SMVM_SAMPLE_FUNCTION;
    for (entry = c->m.functions_at; entry < c->m.f32s_at; entry = (SmvmAt)(entry + c->m.width)) {
        c->where = entry;
        size = smvm_read_offset(c->in.image, entry, (uint8_t)c->m.width);
        c->in.end = (SmvmAt)(c->m.code_at + size);
        if (size > c->m.code_size || c->in.end < c->in.at)
            return SMVM_R_FUNCTIONS;
        if ((rule = check_function(c)) != 0)
            return rule;
        c->kind = c->kind == SMVM_EXIT_FUNCTION ? SMVM_ENTRY_FUNCTION : (uint8_t)(c->kind + 1);
    }
    c->where = (SmvmAt)(entry - c->m.width);
    return c->in.at == (SmvmAt)(c->m.code_at + c->m.code_size) ? 0 : SMVM_R_FUNCTIONS;
}

// ---- the whole image ----

// Checks one machine of the image: its tables, then its code.  Returns 0, or the rule that is broken.
static uint8_t check_machine(Verifier *c)
{
    uint8_t rule;

    if ((rule = check_windows(c)) != 0 || (rule = check_vector(c)) != 0 || (rule = check_init(c)) != 0 || (rule = check_safe(c)) != 0)
        return rule;
#if SMVM_PARAMETERS
    if ((rule = check_parameters(c)) != 0)
        return rule;
#endif
    c->where = c->m.windows_at;
    if (smvm_ram_size(&c->m) > SMVM_RAM_MAX || c->m.sv_size > SMVM_RAM_MAX)
        return SMVM_R_RAM;
    memset(&c->longest, 0, sizeof c->longest);
    return check_code(c);
}

// Checks every machine and computes the longest step of all.  An image has at most 255 sections, so at most 255 machines are searched for.
static uint8_t check_machines(Verifier *c, SmvmVerdict *v)
{
    uint8_t rule;

    for (; (rule = smvm_read_machine(c->in.image, (uint8_t)v->machine, &c->m)) != SMVM_R_GROUP; v->machine++) {
        uint32_t longest;
        c->where = c->m.machine_at;
        if (rule != 0 || (rule = check_machine(c)) != 0)
            return rule;
        longest = longest_step(&c->longest);
        v->longest = longest > v->longest ? longest : v->longest;
    }
    v->machine = 0;
    return 0;
}

// Returns the number of instructions in the longest step; 0 if the VM is compiled without this count (SMVM_LONGEST).
uint32_t smvm_longest_step(const SmvmMachine *m)
{
    Verifier c;

    if (!SMVM_LONGEST)
        return 0;
    memset(&c, 0, sizeof c);
    c.in.image = m->image;
    c.m = *m;
    check_code(&c);
    return longest_step(&c.longest);
}

// Checks the whole image.  Returns 0, or the rule that is broken.
static uint8_t check_image(Verifier *c, uint32_t size, SmvmVerdict *v)
{
    uint8_t rule;

    if ((rule = check_header(c, size)) != 0 || (rule = check_crc(c)) != 0 || (rule = check_sections(c)) != 0
        || (rule = smvm_check_pins(c->in.image, &c->where)) != 0)
        return rule;
    return check_machines(c, v);
}

// Checks an image within the first `size` bytes; it may be shorter than that.  Returns v->rule, 0 if no rule is broken.
uint8_t smvm_verify(SmvmBytes image, uint32_t size, SmvmVerdict *v)
{
    Verifier c;

    memset(v, 0, sizeof *v);
    memset(&c, 0, sizeof c);
    c.in.image = image;
    if ((v->rule = check_image(&c, size, v)) != 0)
        v->at = c.where;
    return v->rule;
}
