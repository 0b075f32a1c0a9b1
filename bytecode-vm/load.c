// SPDX-License-Identifier: Apache-2.0
// From an image to a machine that can run: finds the parts, computes the memory needed, lays it out and fills it.
#include <stddef.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"
#include "stdlib/flash.h"

// ---- the image ----

uint32_t smvm_uint(SmvmBytes image, SmvmAt at, uint8_t bytes)
{
    uint32_t v = 0;

    while (bytes-- > 0)
        v = v << 8 | smvm_u8(image, (SmvmAt)(at + bytes));
    return v;
}

static bool is_little(void)                            // the least significant byte of a number is the first in memory, as in an image
{
    const uint16_t one = 1;

    return *(const uint8_t *)&one == 1;
}

void smvm_get(SmvmBytes image, SmvmAt at, void *to, uint8_t bytes)
{
    uint8_t *p = (uint8_t *)to;

    for (uint8_t i = 0; i < bytes; i++)
        p[is_little() ? i : bytes - 1 - i] = smvm_u8(image, at++);
}

SmvmAt smvm_at(SmvmBytes image, SmvmAt at, uint8_t bytes)
{
    const uint32_t v = smvm_uint(image, at, bytes);

    return v > SMVM_NOWHERE ? SMVM_NOWHERE : (SmvmAt)v;
}

uint32_t smvm_number(SmvmBytes image, SmvmAt *at, SmvmAt end)
{
    uint32_t from = 0, v = SMVM_OP_LEAST;
    uint8_t more = 0;

    if (*at < end)
        v = smvm_u8(image, (*at)++);
    if (v >= SMVM_OP_LEAST)
        return SMVM_NO_NUMBER;
    if (v >= SMVM_VARINT_2) {
        more = 3;
        from = SMVM_VARINT_MID;
        v -= SMVM_VARINT_2;
    } else if (v >= SMVM_VARINT_1) {
        more = 1;
        from = SMVM_VARINT_1;
        v -= SMVM_VARINT_1;
    }
    if ((SmvmAt)(end - *at) < more)
        return SMVM_NO_NUMBER;
    for (; more > 0; more--) {
        const uint8_t next = smvm_u8(image, (*at)++);
        if (next >= SMVM_OP_LEAST)
            return SMVM_NO_NUMBER;
        v = v << 7 | next;
    }
    return from + v;
}

uint8_t smvm_shift(uint8_t type) { return smvm_type_shift(type); }

// In units of 1 << shift; SMVM_NOWHERE where this target cannot hold it.
static SmvmAt scaled(uint32_t v, uint8_t shift)
{
    SmvmAt at = v > SMVM_NOWHERE ? SMVM_NOWHERE : (SmvmAt)v;

    for (; shift > 0; shift--)
        at = at > SMVM_NOWHERE / 2 ? SMVM_NOWHERE : (SmvmAt)(at + at);
    return at;
}

uint8_t smvm_sections(SmvmBytes image) { return smvm_u8(image, SMVM_SECTIONS_AT); }

SmvmSection smvm_section(SmvmBytes image, uint8_t index)
{
    const SmvmAt at = (SmvmAt)(SMVM_HEADER + index * SMVM_ENTRY);
    SmvmSection s;

    s.id = smvm_u8(image, at);
    s.version = smvm_u8(image, (SmvmAt)(at + 1));
    s.at = smvm_at(image, (SmvmAt)(at + 2), 3);
    s.size = smvm_at(image, (SmvmAt)(at + 5), 3);
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
    uint32_t v;
    SmvmAt at;

    if (r->rule != 0)
        return 0;
    v = smvm_number(r->image, &r->at, r->end);
    at = scaled(v, shift);
    if (at == SMVM_NOWHERE)
        r->rule = v == SMVM_NO_NUMBER ? SMVM_R_RECORD : SMVM_R_RAM;
    return at;
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

// The numbers of a record, in their order: where each goes, and in units of 1 << what it counts.
#define SMVM_NUMBER(field, shift) {offsetof(SmvmMachine, field), shift}
static const struct Field { uint8_t at, shift; } record[] SM_FLASH = {
    SMVM_NUMBER(sv_size, 3), SMVM_NUMBER(from, 3), SMVM_NUMBER(to, 3), SMVM_NUMBER(locals, 0), SMVM_NUMBER(windows, 0),
    SMVM_NUMBER(outputs, 0), SMVM_NUMBER(states, 0), SMVM_NUMBER(width, 0), SMVM_NUMBER(f32s, 0), SMVM_NUMBER(f64s, 0),
    SMVM_NUMBER(g, 3), SMVM_NUMBER(s, 2),
};

static void read_numbers(SmvmMachine *m, Reader *r)
{
    for (uint8_t i = 0; i < sizeof record / sizeof *record; i++) {
        struct Field f;
        sm_flash_get(&f, &record[i], sizeof f);
        *(SmvmAt *)(void *)((uint8_t *)m + f.at) = read_number(r, f.shift);
    }
    if (r->rule == 0 && (m->states == 0 || m->width < 1 || m->width > 3))
        r->rule = SMVM_R_STATES;
}

uint8_t smvm_read_machine(SmvmMachine *m, SmvmAt at, SmvmAt size)
{
    Reader r = {m->image, at, (SmvmAt)(at + size), 0};

    m->machine_at = at;
    if (size < 4)
        return SMVM_R_RECORD;
    m->layout = smvm_uint(m->image, at, 4);
    r.at = (SmvmAt)(at + 4);
    read_numbers(m, &r);
    if (r.rule != 0)
        return r.rule;
    if (m->states > size / 3)                         // so that three times as many can be counted
        return SMVM_R_RECORD;
    m->windows_at = find_table(&r, m->windows, SMVM_WINDOW_ENTRY);
    m->outputs_at = find_table(&r, m->outputs, SMVM_PLACE);
    m->functions_at = find_table(&r, (SmvmAt)(3 * m->states + 1), (uint8_t)m->width);
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
    if (s->id == SMVM_S_CODE) {
        m->code_at = s->at;
        m->code_size = s->size;
    } else if (s->id == SMVM_S_INIT) {
        m->init_at = s->at;
        m->init_size = s->size;
    } else if (s->id == SMVM_S_DEBUG && s->version == SMVM_V_DEBUG) {
        m->debug_at = s->at;
        m->debug_size = s->size;
    } else if (s->id == SMVM_S_SAFE && s->version == SMVM_V_SAFE) {
        m->safe_at = s->at;
        m->safe_size = s->size;
    }
}

uint8_t smvm_look(SmvmBytes image, uint8_t number, SmvmMachine *m)
{
    uint8_t rule = SMVM_R_GROUP;
    bool inside = false;

    memset(m, 0, sizeof *m);
    m->image = image;
    for (uint8_t i = 0; i < smvm_sections(image); i++) {
        const SmvmSection s = smvm_section(image, i);
        if (s.id == SMVM_S_MACHINE) {
            inside = number-- == 0;
            if (inside)
                rule = smvm_read_machine(m, s.at, s.size);
        } else if (inside)
            take_section(m, &s);
    }
    return rule;
}

bool smvm_machine(SmvmBytes image, uint32_t number, SmvmMachine *m)
{
    return number <= UINT8_MAX && smvm_look(image, (uint8_t)number, m) != SMVM_R_GROUP;
}

bool smvm_state_is_safe(const SmvmMachine *m, uint32_t state)
{
    const SmvmAt bit = (SmvmAt)(state - 1);

    return m->safe_at == 0 || (smvm_u8(m->image, (SmvmAt)(m->safe_at + (bit >> 3))) >> (bit & 7) & 1) != 0;
}

SmvmPlace smvm_place(SmvmBytes image, SmvmAt at)
{
    const uint8_t high = smvm_u8(image, (SmvmAt)(at + 2));
    SmvmPlace p;

    p.type = (SmType)(high & 0xf);
    p.offset = scaled(smvm_uint(image, at, 2) | (uint32_t)(high & 0xf0) << 12, smvm_shift(high & 0xf));
    return p;
}

SmvmPlace smvm_output(const SmvmMachine *m, uint32_t output)
{
    return smvm_place(m->image, (SmvmAt)(m->outputs_at + SMVM_PLACE * (SmvmAt)output));
}

// ---- memory: SmVm, then where the windows are, windows, locals, and bits of the outputs from 64 on ----

static SmvmAt up8(SmvmAt n) { return (SmvmAt)((n + 7u) & ~7u); }

static SmvmAt plus(SmvmAt a, uint32_t b)              // a sum that sticks at the end
{
    return b > (SmvmAt)(SMVM_NOWHERE - a) ? SMVM_NOWHERE : (SmvmAt)(a + b);
}

static SmvmAt plus_window(const SmvmMachine *m, SmvmAt w, SmvmAt n)
{
    const uint32_t entry = smvm_window(m->image, m->windows_at, w);

    return plus(n, 8 * sm_roll_words(entry & SMVM_WINDOW_SIZE_MASK, entry >> SMVM_WINDOW_SIZE_BITS));
}

static SmvmAt stored_bytes(const SmvmMachine *m) { return (SmvmAt)(m->outputs > 64 ? (m->outputs - 64u + 7) >> 3 : 0); }

static SmvmAt windows_start(const SmvmMachine *m)
{
    return (SmvmAt)(up8(sizeof(SmVm)) + up8((SmvmAt)(m->windows * sizeof(uint64_t *))));
}

SmvmAt smvm_ram_size(const SmvmMachine *m)
{
    SmvmAt n = windows_start(m);

    for (SmvmAt w = 0; w < m->windows; w++)
        n = plus_window(m, w, n);
    return plus(plus(n, m->locals), stored_bytes(m));
}

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
    t->width = (uint8_t)m->width;
    t->more = (SmvmAt)(vm->local + m->locals);
    t->more_bytes = stored_bytes(m);
    t->g = m->g;
    t->s = m->s;
}

static void lay_out(SmVm *vm, const SmvmMachine *m)
{
    uint64_t **window = smvm_parts(vm, m).window;
    SmvmAt at = windows_start(m);

    for (SmvmAt w = 0; w < m->windows; w++) {
        window[w] = (uint64_t *)(void *)((uint8_t *)vm + at);
        at = plus_window(m, w, at);
    }
    vm->local = at;
}

static void set_locals(SmVm *vm, const SmvmMachine *m)
{
    SmvmAt at = m->init_at;

    while (at < m->init_at + m->init_size) {
        SmvmPlace p = smvm_place(m->image, at);
        uint8_t bytes = (uint8_t)(1u << smvm_shift((uint8_t)p.type));
        uint8_t *to = (uint8_t *)vm + vm->local + p.offset;
        smvm_get(m->image, (SmvmAt)(at + SMVM_PLACE), to, bytes);
        if (p.type == SM_BOOL)
            *to = *to != 0;
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

// ---- opcodes ----

enum {
    L = SMVM_SHAPE_L, E = SMVM_SHAPE_E, N = SMVM_SHAPE_N, F = SMVM_SHAPE_F, D = SMVM_SHAPE_D, O = SMVM_SHAPE_O, S = SMVM_SHAPE_S,
    K = SMVM_SHAPE_K, W = SMVM_SHAPE_W, T = SMVM_SHAPE_T, M = SMVM_SHAPE_M, J = SMVM_SHAPE_J, X = SMVM_SHAPE_X, Y = SMVM_SHAPE_Y,
    GX = SMVM_SHAPE_GX
};
#define GY SMVM_SHAPE_GY                              // these are beyond what an int may hold
#define FY SMVM_SHAPE_FY
#define Z SMVM_SHAPE_Z

// The shape as three bytes: five for each row.
static const struct Row { uint8_t first, last, shape[3]; } rows[] SM_FLASH = {
#define SMVM_BYTE(shape, shift) (uint8_t)((uint32_t)(shape) >> (shift))
#define SMVM_OP(name, first, last, shape, meaning) \
    {first, last, {SMVM_BYTE(shape, 0), SMVM_BYTE(shape, 8), SMVM_BYTE((shape) | SMVM_SHAPE_OP, 16)}},
#include "bytecode-vm/opcodes.def"
#undef SMVM_OP
};

enum {
#define SMVM_OP(name, first, last, shape, meaning) ROW_##name,
#include "bytecode-vm/opcodes.def"
#undef SMVM_OP
};

// Where the rows of sixteen opcodes begin, which ascend: most looked for are the first or second there.
static const uint8_t row_of[] SM_FLASH = {ROW_ldx_local, ROW_ldx_elem, ROW_ldy_local, ROW_ldy_elem,
                                          ROW_st_local, ROW_jxy, ROW_jf, ROW_add};

uint32_t smvm_shape(uint8_t opcode)
{
    struct Row r;
    uint8_t row;

    sm_flash_get(&row, &row_of[opcode >> 4 & 7], 1);
    do
        sm_flash_get(&r, &rows[row++], sizeof r);
    while (opcode > r.last);                          // the last row ends with the last opcode
    return opcode < r.first ? 0 : (uint32_t)r.shape[2] << 16 | (uint32_t)r.shape[1] << 8 | r.shape[0];
}
