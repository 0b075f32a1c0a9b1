// SPDX-License-Identifier: Apache-2.0
// From an image to a machine that can run: finds the parts, computes the memory needed, lays it out and fills it.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"

// ---- the image ----

uint32_t smvm_uint(SmvmBytes image, SmvmAt at, uint8_t bytes)
{
    uint32_t v = 0;

    while (bytes-- > 0)
        v = v << 8 | smvm_u8(image, (SmvmAt)(at + bytes));
    return v;
}

// As many digits of 7 bits behind the first.
static bool read_digits(SmvmBytes image, SmvmAt *at, SmvmAt end, uint32_t v, uint8_t more, uint32_t *value)
{
    if ((SmvmAt)(end - *at) < more)
        return false;
    for (; more > 0; more--) {
        uint8_t next = smvm_u8(image, (*at)++);
        if (next >= SMVM_OP_LEAST)
            return false;
        v = v << 7 | next;
    }
    *value = v;
    return true;
}

bool smvm_varint(SmvmBytes image, SmvmAt *at, SmvmAt end, uint32_t *value)
{
    uint8_t b, more = 0;
    uint32_t v = 0;

    if (*at >= end)
        return false;
    b = smvm_u8(image, (*at)++);
    if (b >= SMVM_OP_LEAST)
        return false;
    if (b >= SMVM_VARINT_2) {
        more = 3;
        v = SMVM_VARINT_MID;
        b = (uint8_t)(b - SMVM_VARINT_2);
    } else if (b >= SMVM_VARINT_1) {
        more = 1;
        v = SMVM_VARINT_1;
        b = (uint8_t)(b - SMVM_VARINT_1);
    }
    return read_digits(image, at, end, b, more, value) && (*value += v, true);
}

uint8_t smvm_sections(SmvmBytes image) { return smvm_u8(image, SMVM_SECTIONS_AT); }

SmvmSection smvm_section(SmvmBytes image, uint8_t index)
{
    const SmvmAt at = (SmvmAt)(SMVM_HEADER + index * SMVM_ENTRY);
    SmvmSection s;

    s.id = smvm_u8(image, at);
    s.version = smvm_u8(image, (SmvmAt)(at + 1));
    s.at = smvm_u24(image, (SmvmAt)(at + 2));
    s.size = smvm_u24(image, (SmvmAt)(at + 5));
    return s;
}

// Reads the numbers and tables of a MACHINE section one behind the other; after the first that is wrong gives 0.
typedef struct Reader {
    SmvmBytes image;
    SmvmAt at, end;
    uint8_t rule;             // that is broken
} Reader;

static SmvmAt read_number(Reader *r, uint8_t shift)              // in units of 1 << shift
{
    uint32_t v = 0;

    if (r->rule == 0 && !smvm_varint(r->image, &r->at, r->end, &v))
        r->rule = SMVM_R_RECORD;
    if (r->rule == 0 && v > (uint32_t)(SmvmAt)-1 >> shift)
        r->rule = SMVM_R_RAM;
    return (SmvmAt)(r->rule == 0 ? v << shift : 0);
}

static SmvmAt find_table(Reader *r, SmvmAt count, uint8_t bytes)
{
    SmvmAt at = r->at;

    if (count > (SmvmAt)(r->end - at) / bytes)
        r->rule = SMVM_R_RECORD;
    else
        r->at = (SmvmAt)(at + count * bytes);
    return at;
}

static void read_numbers(SmvmMachine *m, Reader *r)
{
    SmvmAt width;

    m->sv_size = read_number(r, 3);
    m->from = read_number(r, 3);
    m->to = read_number(r, 3);
    m->locals = read_number(r, 0);
    m->windows = read_number(r, 0);
    m->outputs = read_number(r, 0);
    m->states = read_number(r, 0);
    width = read_number(r, 0);
    m->f32s = read_number(r, 0);
    m->f64s = read_number(r, 0);
    m->g = read_number(r, 3);
    m->s = read_number(r, 2);
    if (r->rule == 0 && (m->states == 0 || width < 1 || width > 3))
        r->rule = SMVM_R_STATES;
    m->width = (uint8_t)width;
}

uint8_t smvm_read_machine(SmvmMachine *m, SmvmAt at, SmvmAt size)
{
    Reader r = {m->image, at, (SmvmAt)(at + size), 0};

    if (size < 4)
        return SMVM_R_RECORD;
    m->machine_at = at;
    m->layout = smvm_uint(m->image, at, 4);
    r.at = (SmvmAt)(at + 4);
    read_numbers(m, &r);
    if (r.rule != 0)
        return r.rule;
    if (m->states > size / 3)                         // so that three times as many can be counted
        return SMVM_R_RECORD;
    m->windows_at = find_table(&r, m->windows, SMVM_WINDOW_ENTRY);
    m->outputs_at = find_table(&r, m->outputs, SMVM_PLACE);
    m->functions_at = find_table(&r, (SmvmAt)(3 * m->states + 1), m->width);
    m->f32s_at = find_table(&r, m->f32s, 4);
    m->f64s_at = find_table(&r, m->f64s, 8);
    return r.rule == 0 && r.at != r.end ? SMVM_R_RECORD : r.rule;
}

void smvm_again(const SmVm *vm, SmvmMachine *m)
{
    m->image = vm->image;
    m->code_at = vm->code;
    smvm_read_machine(m, vm->machine, (SmvmAt)((SmvmAt)-1 - vm->machine));
}

// A machine's sections stand behind its MACHINE, before the next one.
static void take_section(SmvmMachine *m, const SmvmSection *s)
{
    const SmvmAt at = (SmvmAt)s->at, size = (SmvmAt)s->size;

    if (s->id == SMVM_S_CODE) {
        m->code_at = at;
        m->code_size = size;
    } else if (s->id == SMVM_S_INIT) {
        m->init_at = at;
        m->init_size = size;
    } else if (s->id == SMVM_S_DEBUG && s->version == SMVM_V_DEBUG) {
        m->debug_at = at;
        m->debug_size = size;
    }
}

bool smvm_machine(SmvmBytes image, uint32_t number, SmvmMachine *m)
{
    uint32_t machines = 0;

    memset(m, 0, sizeof *m);
    m->image = image;
    for (uint8_t i = 0; i < smvm_sections(image); i++) {
        SmvmSection s = smvm_section(image, i);
        if (s.id == SMVM_S_MACHINE && machines++ == number)
            smvm_read_machine(m, (SmvmAt)s.at, (SmvmAt)s.size);
        else if (machines == number + 1)
            take_section(m, &s);
    }
    return machines > number;
}

SmvmPlace smvm_place(SmvmBytes image, SmvmAt at)
{
    const uint8_t high = smvm_u8(image, (SmvmAt)(at + 2));
    SmvmPlace p;

    p.type = (SmType)(high & 0xf);
    p.offset = (smvm_uint(image, at, 2) | (uint32_t)(high & 0xf0) << 12) << smvm_type_shift(p.type);
    return p;
}

SmvmPlace smvm_output(const SmvmMachine *m, uint32_t output)
{
    return smvm_place(m->image, (SmvmAt)(m->outputs_at + SMVM_PLACE * (SmvmAt)output));
}

// ---- memory: SmVm, then where the windows are, windows, locals, and bits of the outputs from 64 on ----

static uint32_t up8(uint32_t n) { return (n + 7) / 8 * 8; }

static uint32_t plus(uint32_t a, uint32_t b) { return a > UINT32_MAX - b ? UINT32_MAX : a + b; }     // a sum that sticks at the end

static uint32_t window_bytes(const SmvmMachine *m, SmvmAt w)
{
    const uint32_t entry = smvm_window(m->image, m->windows_at, w);

    return 8 * sm_roll_words(entry & SMVM_WINDOW_SIZE_MASK, entry >> SMVM_WINDOW_SIZE_BITS);
}

static uint32_t stored_bytes(const SmvmMachine *m) { return m->outputs > 64 ? (m->outputs - 64u + 7) / 8 : 0; }

static uint32_t windows_start(const SmvmMachine *m) { return up8(sizeof(SmVm)) + up8(m->windows * (uint32_t)sizeof(uint64_t *)); }

static uint32_t locals_start(const SmvmMachine *m)
{
    uint32_t n = windows_start(m);

    for (SmvmAt w = 0; w < m->windows; w++)
        n = plus(n, window_bytes(m, w));
    return n;
}

uint32_t smvm_ram_size(const SmvmMachine *m) { return plus(plus(locals_start(m), m->locals), stored_bytes(m)); }

SmvmParts smvm_parts(SmVm *vm, const SmvmMachine *m)
{
    SmvmParts p;

    p.window = smvm_windows_of(vm);
    p.local = (uint8_t *)vm + vm->local;
    p.stored = p.local + m->locals;
    p.stored_bytes = stored_bytes(m);
    return p;
}

void smvm_tables(const SmvmMachine *m, const SmVm *vm, SmvmTables *t)
{
    t->windows = m->windows_at;
    t->outputs = m->outputs_at;
    t->functions = m->functions_at;
    t->f32s = m->f32s_at;
    t->f64s = m->f64s_at;
    t->width = m->width;
    t->more = (SmvmAt)(vm->local + m->locals);
    t->more_bytes = (SmvmAt)stored_bytes(m);
    t->g = m->g;
    t->s = m->s;
}

static void lay_out(SmVm *vm, const SmvmMachine *m)
{
    uint64_t **window = smvm_parts(vm, m).window;
    uint32_t at = windows_start(m);

    for (SmvmAt w = 0; w < m->windows; w++) {
        window[w] = (uint64_t *)(void *)((uint8_t *)vm + at);
        at += window_bytes(m, w);
    }
    vm->local = (SmvmAt)at;
}

static void set_locals(SmVm *vm, const SmvmMachine *m)
{
    SmvmAt at = m->init_at;

    while (at < m->init_at + m->init_size) {
        SmvmPlace p = smvm_place(m->image, at);
        uint8_t bytes = (uint8_t)(1u << smvm_type_shift(p.type));
        sm_cell_store(p.type, (uint8_t *)vm + vm->local + p.offset, smvm_cell(m->image, (SmvmAt)(at + SMVM_PLACE), bytes));
        at = (SmvmAt)(at + SMVM_PLACE + bytes);
    }
}

// As the strictest of what lies in there asks for: 8 on most targets, 1 on some.
static bool is_aligned(const void *p)
{
    struct Strict { char c; union { uint64_t time; SmF64 number; void *pointer; } at; };

    return (uintptr_t)p % offsetof(struct Strict, at) == 0;
}

SmResult smvm_init(void *memory, uint32_t size, const SmvmMachine *m, const SmvmVector *sv, uint32_t state)
{
    SmVm *vm = memory;

    if (sv->layout != m->layout || sv->size != m->sv_size)
        return SM_E_LAYOUT;
    if (state < 1 || state > m->states)
        return SM_E_ARGUMENT;
    if (!is_aligned(memory) || !is_aligned(sv->at))
        return SM_E_ALIGNMENT;
    if (size < smvm_ram_size(m))
        return SM_E_MEMORY;
    memset(memory, 0, (size_t)smvm_ram_size(m));
    vm->image = m->image;
    vm->machine = m->machine_at;
    vm->code = m->code_at;
    lay_out(vm, m);
    set_locals(vm, m);
#if SMVM_KEEP_TABLES
    smvm_tables(m, vm, &vm->tables);
#endif
    vm->state = (SmvmAt)state;
    vm->first = true;
    sm_cell_store(SM_U32, (uint8_t *)sv->at + m->s, state);
    return SM_OK;
}

// ---- looking at it ----

uint32_t smvm_state(const SmVm *vm) { return vm->state; }
uint64_t smvm_time(const SmVm *vm) { return vm->next - vm->start; }
bool smvm_stored_state(const SmVm *vm) { return vm->entered; }
void *smvm_locals(SmVm *vm) { return (uint8_t *)vm + vm->local; }

bool smvm_stored(const SmVm *vm, uint32_t output)
{
    const uint8_t *bits = vm->stored;
    SmvmMachine m;

    if (output >= 64) {
        smvm_again(vm, &m);
        bits = (const uint8_t *)vm + vm->local + m.locals;
        output -= 64;
    }
    return (bits[output >> 3] >> (output & 7) & 1) != 0;
}

uint32_t smvm_shape(uint8_t opcode)
{
    enum {
        L = SMVM_SHAPE_L, E = SMVM_SHAPE_E, N = SMVM_SHAPE_N, F = SMVM_SHAPE_F, D = SMVM_SHAPE_D, O = SMVM_SHAPE_O, S = SMVM_SHAPE_S,
        K = SMVM_SHAPE_K, W = SMVM_SHAPE_W, T = SMVM_SHAPE_T, M = SMVM_SHAPE_M, J = SMVM_SHAPE_J, X = SMVM_SHAPE_X, Y = SMVM_SHAPE_Y,
        GX = SMVM_SHAPE_GX
    };
    const uint32_t GY = SMVM_SHAPE_GY, FY = SMVM_SHAPE_FY, Z = SMVM_SHAPE_Z;

#define SMVM_OP(name, first, last, shape, meaning) \
    if (opcode >= (first) && (uint8_t)(opcode - (first)) <= (last) - (first)) \
        return SMVM_SHAPE_OP | (uint32_t)(shape);
#include "bytecode-vm/opcodes.def"
#undef SMVM_OP
    return 0;
}
