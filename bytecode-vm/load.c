// SPDX-License-Identifier: Apache-2.0
// From an image to a machine that can run: finds the parts, computes the memory needed, lays it out and fills it.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"

// ---- the image ----

bool smvm_varint(SmvmBytes image, uint32_t *at, uint32_t end, uint32_t *value)
{
    uint32_t b, more = 0, base = 0;

    if (*at >= end)
        return false;
    b = smvm_u8(image, (*at)++);
    if (b >= SMVM_OP_LEAST)
        return false;
    if (b >= SMVM_VARINT_2) {
        more = 3;
        base = SMVM_VARINT_MID;
        b -= SMVM_VARINT_2;
    } else if (b >= SMVM_VARINT_1) {
        more = 1;
        base = SMVM_VARINT_1;
        b -= SMVM_VARINT_1;
    }
    if (end - *at < more)
        return false;
    for (; more > 0; more--) {
        uint8_t next = smvm_u8(image, (*at)++);
        if (next >= SMVM_OP_LEAST)
            return false;
        b = b << 7 | next;
    }
    *value = base + b;
    return true;
}

uint8_t smvm_sections(SmvmBytes image) { return smvm_u8(image, SMVM_SECTIONS_AT); }

SmvmSection smvm_section(SmvmBytes image, uint32_t index)
{
    uint32_t at = SMVM_HEADER + index * SMVM_ENTRY;
    SmvmSection s;

    s.id = smvm_u8(image, at);
    s.version = smvm_u8(image, at + 1);
    s.at = smvm_u24(image, at + 2);
    s.size = smvm_u24(image, at + 5);
    return s;
}

// Places a table of count entries at *at; false if it does not end before `end`.
static bool place(uint32_t *table, uint32_t *at, uint32_t end, uint32_t count, uint32_t bytes)
{
    *table = *at;
    if (count > (end - *at) / bytes)
        return false;
    *at += count * bytes;
    return true;
}

uint8_t smvm_read_machine(SmvmMachine *m, uint32_t at, uint32_t size)
{
    uint32_t end = at + size, width = 0;
    uint32_t *const number[] = {&m->sv_size, &m->locals, &m->temps, &m->windows, &m->outputs, &m->operands,
                                &m->states, &width, &m->f32s, &m->f64s};

    if (size < 4)
        return SMVM_R_RECORD;
    m->machine_at = at;
    m->layout = smvm_uint(m->image, at, 4);
    at += 4;
    for (uint8_t i = 0; i < sizeof number / sizeof number[0]; i++)
        if (!smvm_varint(m->image, &at, end, number[i]))
            return SMVM_R_RECORD;
    if (m->states == 0 || width < 1 || width > 3)
        return SMVM_R_STATES;
    m->sv_size *= 8;
    m->width = (uint8_t)width;
    if (!place(&m->windows_at, &at, end, m->windows, SMVM_WINDOW_ENTRY) || !place(&m->operands_at, &at, end, m->operands, 3)
        || !place(&m->functions_at, &at, end, 3 * m->states + 1, width) || !place(&m->f32s_at, &at, end, m->f32s, 4)
        || !place(&m->f64s_at, &at, end, m->f64s, 8))
        return SMVM_R_RECORD;
    return at == end ? 0 : SMVM_R_RECORD;
}

void smvm_again(const SmVm *vm, SmvmMachine *m)
{
    m->image = vm->image;
    m->code_at = vm->code;
    smvm_read_machine(m, vm->machine, UINT32_MAX - vm->machine);
}

// A machine's sections stand behind its MACHINE, before the next one.
static void take_section(SmvmMachine *m, const SmvmSection *s)
{
    if (s->id == SMVM_S_CODE) {
        m->code_at = s->at;
        m->code_size = s->size;
    } else if (s->id == SMVM_S_INIT) {
        m->init_at = s->at;
        m->init_size = s->size;
    } else if (s->id == SMVM_S_DEBUG && s->version == SMVM_V_DEBUG) {
        m->debug_at = s->at;
        m->debug_size = s->size;
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
            smvm_read_machine(m, s.at, s.size);
        else if (machines == number + 1)
            take_section(m, &s);
    }
    return machines > number;
}

SmvmOperand smvm_operand_at(SmvmBytes image, uint32_t at)
{
    uint32_t entry = smvm_u24(image, at);
    SmvmOperand o;

    o.kind = entry & ((1u << SMVM_KIND_BITS) - 1u);
    o.payload = entry >> SMVM_KIND_BITS;
    o.type = SM_F64;
    if (o.kind < SMVM_K_LOCAL)
        o.type = (SmType)o.kind;
    else if (o.kind < SMVM_K_TEMP)
        o.type = (SmType)(o.kind - SMVM_K_LOCAL);
    else if (o.kind == SMVM_K_ACC && o.payload < SMVM_RAW)
        o.type = (SmType)o.payload;
    o.offset = o.payload << smvm_type_shift(o.type);
    return o;
}

SmvmOperand smvm_operand(const SmvmMachine *m, uint32_t index)
{
    return smvm_operand_at(m->image, m->operands_at + 3 * index);
}

// ---- memory: SmVm, then where the windows are, temps, windows, locals, and bits of the outputs from 64 on ----

static uint32_t up8(uint32_t n) { return (n + 7) / 8 * 8; }

static uint32_t plus(uint32_t a, uint32_t b) { return a > UINT32_MAX - b ? UINT32_MAX : a + b; }     // a sum that sticks at the end

static uint32_t window_bytes(const SmvmMachine *m, uint32_t w)
{
    uint32_t entry = smvm_window(m->image, m->windows_at, w);

    return 8 * sm_roll_words(entry & SMVM_WINDOW_SIZE_MASK, entry >> SMVM_WINDOW_SIZE_BITS);
}

static uint32_t stored_bytes(const SmvmMachine *m) { return m->outputs > 64 ? (m->outputs - 64 + 7) / 8 : 0; }

static uint32_t temps_start(const SmvmMachine *m) { return up8(sizeof(SmVm)) + up8(m->windows * (uint32_t)sizeof(uint64_t *)); }
static uint32_t windows_start(const SmvmMachine *m) { return plus(temps_start(m), m->temps * (uint32_t)sizeof(SmF64)); }

static uint32_t locals_start(const SmvmMachine *m)
{
    uint32_t n = windows_start(m);

    for (uint32_t w = 0; w < m->windows; w++)
        n = plus(n, window_bytes(m, w));
    return n;
}

uint32_t smvm_ram_size(const SmvmMachine *m) { return plus(plus(locals_start(m), m->locals), stored_bytes(m)); }

SmvmParts smvm_parts(SmVm *vm, const SmvmMachine *m)
{
    SmvmParts p;

    p.window = smvm_windows_of(vm);
    p.temp = (SmF64 *)(void *)((uint8_t *)vm + temps_start(m));
    p.local = (uint8_t *)vm + vm->local;
    p.stored = p.local + m->locals;
    p.stored_bytes = stored_bytes(m);
    return p;
}

void smvm_tables(const SmvmMachine *m, const SmVm *vm, SmvmTables *t)
{
    t->windows = (SmvmAt)m->windows_at;
    t->operands = (SmvmAt)m->operands_at;
    t->functions = (SmvmAt)m->functions_at;
    t->f32s = (SmvmAt)m->f32s_at;
    t->f64s = (SmvmAt)m->f64s_at;
    t->width = m->width;
    t->temps = (SmvmAt)temps_start(m);
    t->more = (SmvmAt)(vm->local + m->locals);
    t->more_bytes = (SmvmAt)stored_bytes(m);
    t->g = (SmvmAt)smvm_operand(m, m->outputs).offset;
    t->s = (SmvmAt)smvm_operand(m, m->outputs + 1).offset;
}

static void lay_out(SmVm *vm, const SmvmMachine *m)
{
    uint64_t **window = smvm_parts(vm, m).window;
    uint32_t at = windows_start(m);

    for (uint32_t w = 0; w < m->windows; w++) {
        window[w] = (uint64_t *)(void *)((uint8_t *)vm + at);
        at += window_bytes(m, w);
    }
    vm->local = (SmvmAt)at;
}

static void set_locals(SmVm *vm, const SmvmMachine *m)
{
    uint32_t at = m->init_at;

    while (at < m->init_at + m->init_size) {
        SmvmOperand o = smvm_operand_at(m->image, at);
        uint8_t bytes = (uint8_t)(1u << smvm_type_shift(o.type));
        sm_cell_store(o.type, (uint8_t *)vm + vm->local + o.offset, smvm_cell(m->image, at + 3, bytes));
        at += 3u + bytes;
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
    vm->machine = (SmvmAt)m->machine_at;
    vm->code = (SmvmAt)m->code_at;
    lay_out(vm, m);
    set_locals(vm, m);
#if SMVM_KEEP_TABLES
    smvm_tables(m, vm, &vm->tables);
#endif
    vm->state = (SmvmAt)state;
    vm->first = true;
    sm_cell_store(SM_U32, (uint8_t *)sv->at + smvm_operand(m, m->outputs + 1).offset, state);
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
