// SPDX-License-Identifier: Apache-2.0
// Proves an image safe before it runs: after this, neither image nor state vector can make the interpreter leave its memory,
// loop without bound or trap.  One walk over the sections, the tables and the code, which also counts the longest step.
//
// That code can be checked in one walk without remembering where instructions begin rests on the encoding: the bytes of an
// instruction behind its opcode are below 0x80, an opcode never is.  So a jump lands on an instruction if it lands on a byte
// from 0x80 in code that is itself found to be well formed.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/crc32.h"

// The longest way through a function, in instructions: the number on arriving at the next instruction, and at each target
// still ahead.  Jumps only go forward, so when the walk comes to a target all jumps to it have been seen.
typedef struct Longest {
    struct { uint32_t at, cost; } join[SMVM_JOINS];   // the nearest target last
    uint8_t joins;
    bool live;                // some way leads to the next instruction
    bool sum;                 // too many targets: every instruction counts
    uint32_t cost;            // the longest way to the next instruction
    uint32_t ends, leaves;    // the longest that ends with `end`, with `goto`; 0: none does
} Longest;

#define NONE UINT32_MAX                               // no operand

typedef struct Check {
    SmvmVerdict *v;
    SmvmMachine m;
    uint32_t at;              // where in the image the walk stands
    uint32_t start, end;      // the function it is in
    uint32_t far;             // how far a jump of the function has led
    uint32_t sampled;         // windows that have their sample
    uint32_t held, holds;     // accumulators: the operand that the instruction before wrote, that this one writes; or NONE
    enum { IN_SAMPLE, IN_ENTRY, IN_STEP, IN_EXIT } in;
    Longest way;
} Check;

static bool fail(Check *c, uint8_t rule, uint32_t at)
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
    if (size < SMVM_HEADER)
        return fail(c, SMVM_R_LENGTH, 0);
    if (smvm_u8(image, 0) != 's' || smvm_u8(image, 1) != 'm' || smvm_u8(image, 2) != 'b')
        return fail(c, SMVM_R_MAGIC, 0);
    if (smvm_u8(image, 3) != SMVM_FORMAT)
        return fail(c, SMVM_R_FORMAT, 3);
    c->end = smvm_u24(image, SMVM_LENGTH_AT);
    if (c->end > size || c->end > SMVM_IMAGE_MAX || c->end < SMVM_HEADER + (uint32_t)SMVM_ENTRY * smvm_sections(image))
        return fail(c, SMVM_R_LENGTH, SMVM_LENGTH_AT);
    return true;
}

static bool check_crc(Check *c, SmvmBytes image)
{
    uint32_t crc = SM_CRC32_START;

    for (uint32_t i = 0; i < c->end; i++)
        if (i < SMVM_CRC_AT || i >= SMVM_CRC_AT + 4)
            crc = sm_crc32_byte(crc, smvm_u8(image, i));
    return sm_crc32_end(crc) == smvm_uint(image, SMVM_CRC_AT, 4) || fail(c, SMVM_R_CRC, SMVM_CRC_AT);
}

static bool is_known(const SmvmSection *s)
{
    switch (s->id) {
#define SMVM_SECTION(name, id_, version_, meaning) case id_: return s->version == (version_) || (id_) < SMVM_MUST_KNOW;
#define SMVM_OPERAND(name, number, meaning)
#include "bytecode-vm/image.def"
#undef SMVM_SECTION
#undef SMVM_OPERAND
    default: return s->id < SMVM_MUST_KNOW;
    }
}

// Sections in order, of ids known, in groups that each are MACHINE, CODE once, INIT at most once.
static bool check_sections(Check *c, SmvmBytes image)
{
    uint32_t n = smvm_sections(image), free_from = SMVM_HEADER + n * SMVM_ENTRY, i;
    bool machine = false, code = true, init = true, pins = false;

    for (i = 0; i < n; i++) {
        const uint32_t entry = SMVM_HEADER + i * SMVM_ENTRY;
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
    for (uint32_t w = 0; w < c->m.windows; w++) {
        uint32_t entry = smvm_window(c->m.image, c->m.windows_at, w);
        uint32_t size = entry & SMVM_WINDOW_SIZE_MASK, kind = entry >> SMVM_WINDOW_SIZE_BITS;
        if (size < 1 || size > SM_WINDOW_MAX || !sm_roll_is_kind(kind))
            return fail(c, SMVM_R_WINDOW, c->m.windows_at + w * SMVM_WINDOW_ENTRY);
    }
    return true;
}

static bool fits(const SmvmOperand *o, uint32_t space)           // an element or local in so many bytes
{
    uint32_t size = 1u << smvm_type_shift(o->type);

    return space >= size && o->offset <= space - size;
}

static bool operand_exists(const SmvmMachine *m, const SmvmOperand *o)
{
    switch (o->kind) {
    case SMVM_K_TEMP: return o->payload < m->temps;
    case SMVM_K_TIME: return o->payload == 0;
    case SMVM_K_INT: return true;
    case SMVM_K_F32: return o->payload < m->f32s;
    case SMVM_K_F64: return o->payload < m->f64s;
    case SMVM_K_ACC: return o->payload <= SMVM_RAW;
    default: return fits(o, o->kind < SMVM_K_LOCAL ? m->sv_size : m->locals);
    }
}

static bool overlap(const SmvmOperand *a, const SmvmOperand *b)
{
    return a->offset < b->offset + (1u << smvm_type_shift(b->type)) && b->offset < a->offset + (1u << smvm_type_shift(a->type));
}

static bool check_operands(Check *c)
{
    SmvmMachine *m = &c->m;
    SmvmOperand g, s;

    if (m->operands < 2 || m->outputs > m->operands - 2)
        return fail(c, SMVM_R_TIME_STATE, m->operands_at);
    g = smvm_operand(m, m->outputs);
    s = smvm_operand(m, m->outputs + 1);
    for (uint32_t i = 0; i < m->operands; i++) {
        SmvmOperand o = smvm_operand(m, i);
        uint32_t at = m->operands_at + 3 * i;
        if (o.kind >= SMVM_KINDS)
            return fail(c, SMVM_R_OPERAND_KIND, at);
        if (!operand_exists(m, &o))
            return fail(c, SMVM_R_OPERAND_AT, at);
        if (i < m->outputs && o.kind >= SMVM_K_LOCAL)
            return fail(c, SMVM_R_OUTPUTS, at);
        if (i < m->outputs && (overlap(&o, &g) || overlap(&o, &s)))
            return fail(c, SMVM_R_PROTECTED, at);
    }
    if (g.kind != SM_U64 || s.kind != SM_U32)
        return fail(c, SMVM_R_TIME_STATE, m->operands_at + 3 * m->outputs);
    return !overlap(&g, &s) || fail(c, SMVM_R_PROTECTED, m->operands_at + 3 * m->outputs);
}

static bool check_init(Check *c)
{
    uint32_t at = c->m.init_at, end = at + c->m.init_size, entry;

    while (at < end) {
        SmvmOperand o;
        entry = at;
        if (end - at < 3)
            return fail(c, SMVM_R_INIT, entry);
        o = smvm_operand_at(c->m.image, at);
        at += 3;
        if (o.kind < SMVM_K_LOCAL || o.kind >= SMVM_K_TEMP || !fits(&o, c->m.locals) || end - at < 1u << smvm_type_shift(o.type))
            return fail(c, SMVM_R_INIT, entry);
        at += 1u << smvm_type_shift(o.type);
    }
    return true;
}

// ---- the longest way ----

static uint32_t larger(uint32_t a, uint32_t b) { return a > b ? a : b; }

static void arrive(Longest *w, uint32_t at)                      // at an instruction
{
    while (w->joins > 0 && w->join[w->joins - 1].at == at) {
        w->joins--;
        w->cost = larger(w->live ? w->cost : 0, w->join[w->joins].cost);
        w->live = true;
    }
    if (w->live)
        w->cost++;
}

static void add_up_all(Longest *w)                               // from here on
{
    for (uint8_t i = 0; i < w->joins; i++)
        w->cost = larger(w->cost, w->join[i].cost);
    w->joins = 0;
    w->live = w->sum = true;
}

static void jump_to(Longest *w, uint32_t at)
{
    uint8_t i = w->joins;

    if (!w->live || w->sum)
        return;
    while (i > 0 && w->join[i - 1].at < at)
        i--;
    if (i > 0 && w->join[i - 1].at == at) {
        w->join[i - 1].cost = larger(w->join[i - 1].cost, w->cost);
    } else if (w->joins == SMVM_JOINS) {
        add_up_all(w);
    } else {
        memmove(&w->join[i + 1], &w->join[i], (size_t)(w->joins - i) * sizeof w->join[0]);
        w->join[i].at = at;
        w->join[i].cost = w->cost;
        w->joins++;
    }
}

static void leave(Longest *w, uint8_t op)                        // control does not go on
{
    if (w->live && op == SMVM_end)
        w->ends = larger(w->ends, w->cost);
    if (w->live && op == SMVM_goto)
        w->leaves = larger(w->leaves, w->cost);
    w->live = w->sum;
}

// ---- instructions ----

uint8_t smvm_shape(uint8_t opcode)
{
    enum { D = SMVM_SHAPE_D, W = SMVM_SHAPE_W, X = SMVM_SHAPE_X, Y = SMVM_SHAPE_Y, S = SMVM_SHAPE_S, J = SMVM_SHAPE_J, E = SMVM_SHAPE_E };

    switch (opcode) {
#define SMVM_OP(name, number, shape, meaning) case number: return (shape);
#include "bytecode-vm/opcodes.def"
#undef SMVM_OP
    default: return 0;
    }
}

static bool take(Check *c, uint32_t *value)
{
    return smvm_varint(c->m.image, &c->at, c->end, value) || fail(c, SMVM_R_TRUNCATED, c->at);
}

static bool is_acc(const SmvmMachine *m, uint32_t operand)
{
    return operand < m->operands && smvm_operand(m, operand).kind == SMVM_K_ACC;
}

static bool check_read(Check *c)
{
    uint32_t at = c->at, operand;

    if (!take(c, &operand))
        return false;
    if (operand >= c->m.operands)
        return fail(c, SMVM_R_OPERAND, at);
    return !is_acc(&c->m, operand) || operand == c->held || fail(c, SMVM_R_ACC, at);
}

static bool check_write(Check *c)
{
    uint32_t at = c->at, operand;
    uint8_t kind;

    if (!take(c, &operand))
        return false;
    if (operand >= c->m.operands)
        return fail(c, SMVM_R_OPERAND, at);
    kind = smvm_operand(&c->m, operand).kind;
    if (kind == SMVM_K_ACC)
        c->holds = operand;
    return operand < c->m.outputs || (kind >= SMVM_K_LOCAL && kind <= SMVM_K_TEMP) || kind == SMVM_K_ACC || fail(c, SMVM_R_WRITE, at);
}

static bool check_window_used(Check *c, uint8_t op)
{
    uint32_t at = c->at, w, kind;

    if (!take(c, &w))
        return false;
    if (w >= c->m.windows)
        return fail(c, SMVM_R_WINDOW_USED, at);
    if (op == SMVM_sample)
        return (c->in == IN_SAMPLE && w == c->sampled++ && c->far <= c->at) || fail(c, SMVM_R_SAMPLE, at);
    kind = smvm_window(c->m.image, c->m.windows_at, w) >> SMVM_WINDOW_SIZE_BITS;
    if (!(kind & (uint32_t)SM_ROLL_AVG << (op - SMVM_avg)))
        return fail(c, SMVM_R_WINDOW_USED, at);
    return w < c->sampled || fail(c, SMVM_R_SAMPLE, at);
}

static bool check_goto(Check *c)
{
    uint32_t at = c->at, state;

    if (!take(c, &state))
        return false;
    return (state >= 1 && state <= c->m.states && (c->in == IN_ENTRY || c->in == IN_STEP)) || fail(c, SMVM_R_GOTO, at);
}

// Whether the instruction at `at`, if there is one, reads an accumulator.
static bool reads_acc(const Check *c, uint32_t at)
{
    uint8_t shape = smvm_shape(smvm_u8(c->m.image, at++)), read = shape & (SMVM_SHAPE_X | SMVM_SHAPE_Y);
    uint32_t number;

    for (uint8_t part = SMVM_SHAPE_D; part <= SMVM_SHAPE_Y; part = (uint8_t)(part << 1)) {
        if (!(shape & part))
            continue;
        if (!smvm_varint(c->m.image, &at, c->end, &number))
            return false;
        if ((read & part) && is_acc(&c->m, number))
            return true;
    }
    return false;
}

static bool check_jump(Check *c)
{
    uint32_t at = c->at, distance;

    if (!take(c, &distance))
        return false;
    if (distance >= c->end - c->at || smvm_u8(c->m.image, c->at + distance) < SMVM_OP_LEAST)
        return fail(c, SMVM_R_JUMP, at);
    if (reads_acc(c, c->at + distance))
        return fail(c, SMVM_R_ACC, at);
    c->far = larger(c->far, c->at + distance);
    jump_to(&c->way, c->at + distance);
    return true;
}

static bool check_instruction(Check *c, uint8_t *shape)
{
    uint32_t at = c->at++;
    uint8_t op = smvm_u8(c->m.image, at);

    *shape = smvm_shape(op);
    if (*shape == 0)
        return fail(c, SMVM_R_OPCODE, at);
    arrive(&c->way, at);
    c->held = c->holds;
    c->holds = NONE;
    if (((*shape & SMVM_SHAPE_D) && !check_write(c)) || ((*shape & SMVM_SHAPE_W) && !check_window_used(c, op))
        || ((*shape & SMVM_SHAPE_X) && !check_read(c)) || ((*shape & SMVM_SHAPE_Y) && !check_read(c))
        || ((*shape & SMVM_SHAPE_S) && !check_goto(c)) || ((*shape & SMVM_SHAPE_J) && !check_jump(c)))
        return false;
    if (*shape & SMVM_SHAPE_E)
        leave(&c->way, op);
    return op != SMVM_end || c->in != IN_SAMPLE || c->sampled == c->m.windows || fail(c, SMVM_R_SAMPLE, at);
}

static bool check_function(Check *c, uint32_t end)
{
    uint8_t shape = SMVM_SHAPE_E;

    c->at = c->far = c->start;
    c->holds = NONE;
    c->end = end;
    memset(&c->way, 0, sizeof c->way);
    c->way.live = true;
    while (c->at < c->end)
        if (!check_instruction(c, &shape))
            return false;
    if (c->in == IN_SAMPLE && c->sampled != c->m.windows)
        return fail(c, SMVM_R_SAMPLE, c->at);
    return (shape & SMVM_SHAPE_E) != 0 || fail(c, SMVM_R_FALLS_OUT, c->at);
}

// Checks the function whose end is entry `index`, and goes on to the next.
static bool check_next(Check *c, uint32_t index)
{
    uint32_t size = smvm_function_end(&c->m, index);

    if (size > c->m.code_size || c->m.code_at + size < c->start)
        return fail(c, SMVM_R_FUNCTIONS, c->m.functions_at + index * c->m.width);
    if (!check_function(c, c->m.code_at + size))
        return false;
    c->start = c->end;
    return true;
}

// A step is: sample; entry if it is the first; step unless entry left; exit if either did.
static bool check_state(Check *c, uint32_t state, uint32_t *longest)
{
    uint32_t left, ended;

    c->in = IN_ENTRY;
    if (!check_next(c, 3 * state - 2))
        return false;
    left = c->way.leaves;
    ended = c->way.ends;
    c->in = IN_STEP;
    if (!check_next(c, 3 * state - 1))
        return false;
    if (c->way.leaves != 0)
        left = larger(left, ended + c->way.leaves);
    ended += c->way.ends;
    c->in = IN_EXIT;
    if (!check_next(c, 3 * state))
        return false;
    *longest = larger(*longest, larger(ended, left == 0 ? 0 : left + c->way.ends));
    return true;
}

static bool check_code(Check *c, uint32_t *longest)
{
    uint32_t sample;

    c->start = c->m.code_at;
    c->sampled = 0;
    c->in = IN_SAMPLE;
    *longest = 0;
    if (!check_next(c, 0))
        return false;
    sample = c->way.ends;
    for (uint32_t s = 1; s <= c->m.states; s++)
        if (!check_state(c, s, longest))
            return false;
    *longest += sample;
    return c->start == c->m.code_at + c->m.code_size || fail(c, SMVM_R_FUNCTIONS, c->m.functions_at + 3 * c->m.states * c->m.width);
}

// ---- the whole ----

static bool check_machine(Check *c, SmvmBytes image, uint32_t *longest)
{
    uint8_t rule = 0;

    for (uint32_t i = 0, machines = 0; i < smvm_sections(image); i++) {
        SmvmSection s = smvm_section(image, i);
        if (s.id != SMVM_S_MACHINE || machines++ != c->v->machine)
            continue;
        memset(&c->m, 0, sizeof c->m);
        c->m.image = image;
        rule = smvm_read_machine(&c->m, s.at, s.size);
        if (rule != 0)
            return fail(c, rule, s.at);
    }
    smvm_machine(image, c->v->machine, &c->m);
    if (!check_windows(c) || !check_operands(c) || !check_init(c))
        return false;
    if (smvm_ram_size(&c->m) > SMVM_RAM_MAX || c->m.sv_size > SMVM_RAM_MAX)
        return fail(c, SMVM_R_RAM, c->m.windows_at);
    return check_code(c, longest);
}

uint32_t smvm_longest_step(const SmvmMachine *m)
{
    SmvmVerdict v;
    Check c;
    uint32_t longest = 0;

    memset(&v, 0, sizeof v);
    memset(&c, 0, sizeof c);
    c.v = &v;
    c.m = *m;
    check_code(&c, &longest);
    return longest;
}

static bool check_pins(Check *c, SmvmBytes image)
{
    uint32_t at;
    uint8_t rule = smvm_check_pins(image, &at);

    return rule == 0 || fail(c, rule, at);
}

uint8_t smvm_verify(SmvmBytes image, uint32_t size, SmvmVerdict *v)
{
    Check c;
    uint32_t longest;

    memset(v, 0, sizeof *v);
    memset(&c, 0, sizeof c);
    c.v = v;
    if (!check_header(&c, image, size) || !check_crc(&c, image) || !check_sections(&c, image) || !check_pins(&c, image))
        return v->rule;
    // The number of machines is at most that of sections, 255: asking for each by its number stays linear in practice and bound.
    while (smvm_machine(image, v->machine, &c.m)) {
        if (!check_machine(&c, image, &longest))
            return v->rule;
        v->longest = larger(v->longest, longest);
        v->machine++;
    }
    v->machine = 0;
    return 0;
}
