// SPDX-License-Identifier: Apache-2.0
// Prepares a machine of an image to run: finds its parts, computes the memory that it needs, lays out and initializes that memory.
#include <stddef.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/swap.h"
#include "stdlib/convert.h"
#include "stdlib/flash.h"

// ---- the image ----

// Returns the little-endian number of at most 4 bytes at `at`.
uint32_t smvm_uint(SmvmBytes image, SmvmAt at, uint8_t bytes)
{
    uint32_t v = 0;

    while (bytes-- > 0)
        v = v << 8 | smvm_u8(image, (SmvmAt)(at + bytes));
    return v;
}

// Reads the bits of a number of `bytes` bytes into memory, in the byte order of this computer.
void smvm_read_bits(SmvmBytes image, SmvmAt at, void *to, uint8_t bytes)
{
    uint8_t *p = (uint8_t *)to;

    for (uint8_t i = 0; i < bytes; i++)
        p[sm_roll_byte(i, bytes)] = smvm_u8(image, at++);
}

SMVM_NOINLINE static SmvmAt clamp_offset(uint32_t v) { return v > SMVM_NOWHERE ? SMVM_NOWHERE : (SmvmAt)v; }

SmvmAt smvm_read_offset(SmvmBytes image, SmvmAt at, uint8_t bytes) { return clamp_offset(smvm_uint(image, at, bytes)); }

// Returns the offset of the next `bytes` bytes and moves past them; 0: fewer are left.
SmvmAt smvm_skip(SmvmReader *r, uint8_t bytes)
{
    const SmvmAt at = r->at;

    if ((SmvmAt)(r->end - at) < bytes)
        return 0;
    r->at = (SmvmAt)(at + bytes);
    return at;
}

// Reads the next byte.  At the end returns SMVM_OP_FIRST, which no varint contains.
SMVM_NOINLINE static uint8_t next_byte(SmvmReader *r)
{
    return r->at < r->end ? smvm_u8(r->image, r->at++) : SMVM_OP_FIRST;
}

SmvmVarintStatus smvm_read_number(SmvmReader *r)
{
    SmvmVarintStatus found = SMVM_VARINT_OK;
    uint8_t more = 0, next = next_byte(r);
    SmvmAt v = 0, base = 0;

    if (next >= SMVM_OP_FIRST)
        return SMVM_VARINT_CUT_SHORT;
    if (next >= SMVM_VARINT_2) {
        more = 3;
        base = SMVM_VARINT_MID;
        next = (uint8_t)(next - SMVM_VARINT_2);
    } else if (next >= SMVM_VARINT_1) {
        more = 1;
        base = SMVM_VARINT_1;
        next = (uint8_t)(next - SMVM_VARINT_1);
    }
    for (v = next; more > 0; more--) {
        next = next_byte(r);
        if (next >= SMVM_OP_FIRST)
            return SMVM_VARINT_CUT_SHORT;
        if (v > SMVM_NOWHERE >> 7)
            found = SMVM_VARINT_TOO_LARGE;
        v = (SmvmAt)(v << 7 | next);
    }
    v = (SmvmAt)(v + base);
    if (v < base)
        found = SMVM_VARINT_TOO_LARGE;
    r->n = found == SMVM_VARINT_OK ? v : SMVM_NOWHERE;
    return found;
}

uint8_t smvm_shift(uint8_t type) { return smvm_type_shift(type); }

// Returns at << shift, which converts an offset in units of 1 << shift bytes; SMVM_NOWHERE if an SmvmAt cannot hold the result.
static SmvmAt scale_offset(SmvmAt at, uint8_t shift)
{
    for (; shift > 0; shift--)
        at = at > SMVM_NOWHERE / 2 ? SMVM_NOWHERE : (SmvmAt)(at + at);
    return at;
}

// ---- sections ----

static const SmvmSectionKind kinds[] SM_FLASH = {
#define SMVM_HOST_SECTION(name, id, version, meaning)
#if !SMVM_PARAMETERS
#define SMVM_PARAMETER_SECTION(name, id, version, meaning)
#endif
#define SMVM_SECTION(name, id, version, meaning) {id, version, KIND_##name},
#define KIND_IDENTITY 0, 0, 0, 0
#define KIND_DEBUG SMVM_HAS_MACHINE, 0, 0, offsetof(SmvmMachine, debug_at)
#define KIND_IO 0, SMVM_HAS_MACHINE | SMVM_HAS_IO, SMVM_HAS_IO, 0
#define KIND_AUTH 0, 0, 0, 0
#define KIND_PERMIT 0, 0, 0, 0
#define KIND_SAFE SMVM_HAS_MACHINE, SMVM_HAS_SAFE, SMVM_HAS_SAFE, offsetof(SmvmMachine, safe_at)
#define KIND_MACHINE SMVM_HAS_CODE, 0, SMVM_HAS_MACHINE, offsetof(SmvmMachine, machine_at)
#define KIND_CODE SMVM_HAS_MACHINE, SMVM_HAS_CODE, SMVM_HAS_CODE, offsetof(SmvmMachine, code_at)
#define KIND_INIT SMVM_HAS_MACHINE, SMVM_HAS_INIT, SMVM_HAS_INIT, offsetof(SmvmMachine, init_at)
#define KIND_PARAMETERS SMVM_HAS_MACHINE, SMVM_HAS_PARAMETERS, SMVM_HAS_PARAMETERS, offsetof(SmvmMachine, parameters_at)
#include "bytecode-vm/image.def"
#undef SMVM_SECTION
};

uint8_t smvm_section_count(SmvmBytes image) { return smvm_u8(image, SMVM_SECTIONS_AT); }

void smvm_read_section(SmvmBytes image, uint8_t index, SmvmSection *s)
{
    const SmvmAt at = (SmvmAt)(SMVM_HEADER + index * SMVM_SECTION_ENTRY);
    const SmvmSectionKind *k = kinds;

    s->id = smvm_u8(image, at);
    s->at = smvm_read_offset(image, (SmvmAt)(at + 2), 3);
    s->size = smvm_read_offset(image, (SmvmAt)(at + 5), 3);
    do {
        sm_flash_read(&s->kind, k, sizeof *k);
        if (s->kind.id == s->id && s->kind.version == smvm_u8(image, (SmvmAt)(at + 1)))
            return;
    } while (++k < kinds + sizeof kinds / sizeof *kinds);
    memset(&s->kind, 0, sizeof s->kind);
}

// Sets r to the first section of this id, in its known version.  Returns false if the image has no such section.
bool smvm_find_section(SmvmBytes image, uint8_t id, SmvmReader *r)
{
    SmvmSection s;

    for (uint8_t i = 0; i < smvm_section_count(image); i++) {
        smvm_read_section(image, i, &s);
        if (s.kind.id != id)
            continue;
        r->image = image;
        r->at = s.at;
        r->end = (SmvmAt)(s.at + s.size);
        return true;
    }
    return false;
}

// ---- machines ----

// The varints at the start of a MACHINE section, in order: the field of SmvmMachine for each, and the logarithm of its unit to base 2.
#define SMVM_NUMBER(field, shift) {offsetof(SmvmMachine, field), shift}
static const struct RecordField { uint8_t at, shift; } record[] SM_FLASH = {
    SMVM_NUMBER(sv_size, 3), SMVM_NUMBER(from, 3), SMVM_NUMBER(to, 3), SMVM_NUMBER(locals, 0), SMVM_NUMBER(windows, 0),
    SMVM_NUMBER(outputs, 0), SMVM_NUMBER(states, 0), SMVM_NUMBER(width, 0), SMVM_NUMBER(f32s, 0), SMVM_NUMBER(f64s, 0),
    SMVM_NUMBER(g, 3), SMVM_NUMBER(s, 2),
};

static SmvmAt *field_at(SmvmMachine *m, uint8_t at) { return (SmvmAt *)(void *)((uint8_t *)m + at); }

// Reads the varints of `record` into m.  Returns 0, or the rule that is broken.
static uint8_t read_numbers(SmvmMachine *m, SmvmReader *r)
{
    for (uint8_t i = 0; i < sizeof record / sizeof *record; i++) {
        struct RecordField f;
        SmvmAt n;
        if (smvm_read_number(r) == SMVM_VARINT_CUT_SHORT)
            return SMVM_R_RECORD;
        sm_flash_read(&f, &record[i], sizeof f);
        *field_at(m, f.at) = n = scale_offset(r->n, f.shift);
        if (n == SMVM_NOWHERE)
            return SMVM_R_RAM;
    }
    return m->states == 0 || m->width < 1 || m->width > 3 ? SMVM_R_STATES : 0;
}

// Sets *table to the current position, where a table of `count` entries begins, and skips the table.  Returns false if it is cut short.
static bool skip_table(SmvmReader *r, SmvmAt *table, SmvmAt count, uint8_t bytes)
{
    *table = r->at;
    for (; count > 0; count--)
        if (smvm_skip(r, bytes) == 0)
            return false;
    return true;
}

// Reads a MACHINE section and finds its tables.  Returns 0, or the rule that is broken.  Does not check the contents of the tables.
static uint8_t read_machine(SmvmMachine *m)
{
    SmvmReader r = {m->image, m->machine_at, (SmvmAt)(m->machine_at + m->machine_size), 0};
    const SmvmAt layout = smvm_skip(&r, 4);
    const uint8_t rule = layout != 0 ? read_numbers(m, &r) : SMVM_R_RECORD;
    const uint8_t width = (uint8_t)m->width;

    if (rule != 0)
        return rule;
    m->layout = smvm_uint(m->image, layout, 4);
    return skip_table(&r, &m->windows_at, m->windows, SMVM_WINDOW_ENTRY) && skip_table(&r, &m->outputs_at, m->outputs, SMVM_LOCATION_BYTES)
           && skip_table(&r, &m->functions_at, m->states, (uint8_t)(3 * width)) && smvm_skip(&r, width) != 0
           && skip_table(&r, &m->f32s_at, m->f32s, 4) && skip_table(&r, &m->f64s_at, m->f64s, 8) && r.at == r.end ? 0 : SMVM_R_RECORD;
}

// Reads the properties of the machine that vm runs into *m, from its image, except those of the INIT, DEBUG and SAFE sections.
void smvm_reread_machine(const SmVm *vm, SmvmMachine *m)
{
    m->image = vm->image;
    m->machine_at = vm->machine;
    m->machine_size = (SmvmAt)(SMVM_NOWHERE - vm->machine);
    m->code_at = vm->code;
    read_machine(m);
}

// Sets the offsets and sizes of the sections of machine `number`: its MACHINE section and those after it, up to the next MACHINE section.
static void find_machine_sections(uint8_t number, SmvmMachine *m)
{
    bool inside = false;
    SmvmSection s;

    for (uint8_t i = 0; i < smvm_section_count(m->image); i++) {
        smvm_read_section(m->image, i, &s);
        if (s.kind.id == SMVM_S_MACHINE)
            inside = number-- == 0;
        if (inside && s.kind.part != 0) {
            field_at(m, s.kind.part)[0] = s.at;
            field_at(m, s.kind.part)[1] = s.size;
        }
    }
}

// Reads the properties of machine `number` into *m.  Returns 0, or the rule that its MACHINE section breaks; SMVM_R_GROUP: no such machine.
uint8_t smvm_read_machine(SmvmBytes image, uint8_t number, SmvmMachine *m)
{
    memset(m, 0, sizeof *m);
    m->image = image;
    find_machine_sections(number, m);
    return m->machine_at == 0 ? SMVM_R_GROUP : read_machine(m);
}

// Reads machine `number`, counted from 0.  Returns false if the image has no such machine.
bool smvm_machine(SmvmBytes image, uint32_t number, SmvmMachine *m)
{
    return number <= UINT8_MAX && smvm_read_machine(image, (uint8_t)number, m) != SMVM_R_GROUP;
}

// Whether state `state` (1 to m->states) is marked @safe.  True for every state of a machine that marks none.
bool smvm_state_is_safe(const SmvmMachine *m, uint32_t state)
{
    const SmvmAt bit = (SmvmAt)(state - 1);

    return m->safe_at == 0 || (smvm_u8(m->image, (SmvmAt)(m->safe_at + (bit >> 3))) >> (bit & 7) & 1) != 0;
}

// Reads the location at `at`, whose type number is not checked.
SmvmLocation smvm_location(SmvmBytes image, SmvmAt at)
{
    const uint8_t high = smvm_u8(image, (SmvmAt)(at + 2));
    SmvmLocation p;

    p.type = (SmType)(high & 0xf);
    p.offset = scale_offset(clamp_offset(smvm_uint(image, at, 2) | (uint32_t)(high & 0xf0) << 12), smvm_shift(high & 0xf));
    return p;
}

// Returns where output number `output`, counted from 0, is stored.
SmvmLocation smvm_output(const SmvmMachine *m, uint32_t output)
{
    return smvm_location(m->image, (SmvmAt)(m->outputs_at + SMVM_LOCATION_BYTES * (SmvmAt)output));
}

// ---- memory: SmVm, then pointers to the windows, windows, locals, and bits of the outputs from 64 on ----

static SmvmAt round_up_8(SmvmAt n) { return (SmvmAt)((n + 7u) & ~7u); }

static SmvmAt add_saturated(SmvmAt a, uint32_t b)     // a + b, or SMVM_NOWHERE if that is too large
{
    return b > (SmvmAt)(SMVM_NOWHERE - a) ? SMVM_NOWHERE : (SmvmAt)(a + b);
}

// Returns n plus the bytes of window w.
static SmvmAt add_window_bytes(const SmvmMachine *m, SmvmAt w, SmvmAt n)
{
    const uint32_t entry = smvm_window(m->image, m->windows_at, w);

    return add_saturated(n, sm_roll_bytes(smvm_window_size(entry), smvm_window_kind(entry)));
}

SMVM_NOINLINE static SmvmAt stored_bits_bytes(const SmvmMachine *m) { return (SmvmAt)(m->outputs > 64 ? (m->outputs - 64u + 7) >> 3 : 0); }

// Returns where the windows begin in a machine's memory: after the SmVm and the table of pointers to windows.
static SmvmAt windows_start(const SmvmMachine *m)
{
    return (SmvmAt)(round_up_8(sizeof(SmVm)) + round_up_8((SmvmAt)(m->windows * sizeof(uint64_t *))));
}

// Returns the bytes of memory that smvm_init needs for m.
SmvmAt smvm_ram_size(const SmvmMachine *m)
{
    SmvmAt n = windows_start(m);

    for (SmvmAt w = 0; w < m->windows; w++)
        n = add_window_bytes(m, w, n);
    return add_saturated(add_saturated(n, m->locals), stored_bits_bytes(m));
}

SmvmParts smvm_parts(SmVm *vm, const SmvmMachine *m)
{
    SmvmParts p;

    p.window = smvm_windows_of(vm);
    p.local = (uint8_t *)vm + vm->local;
    p.stored = p.local + m->locals;
    p.stored_bytes = stored_bits_bytes(m);
    return p;
}

typedef char load_tables_are_part_of_a_machine[offsetof(SmvmMachine, width) - offsetof(SmvmMachine, windows_at) == offsetof(SmvmTables, width) &&
                                               offsetof(SmvmMachine, locals) - offsetof(SmvmMachine, windows_at) == offsetof(SmvmTables, more)
                                               ? 1 : -1];

// Copies to *t the offsets of m's tables and elements that a step needs; vm is the memory in which m runs.
void smvm_tables(const SmvmMachine *m, const SmVm *vm, SmvmTables *t)
{
    memcpy(t, (const uint8_t *)m + offsetof(SmvmMachine, windows_at), offsetof(SmvmTables, width));
    t->width = (uint8_t)m->width;
    t->more = (SmvmAt)(vm->local + m->locals);
    t->more_bytes = stored_bits_bytes(m);
}

// Sets the pointers to the windows, and vm->local to the offset after the last window, where the locals begin.
static void set_window_pointers(SmVm *vm, const SmvmMachine *m)
{
    uint64_t **window = smvm_parts(vm, m).window;
    SmvmAt at = windows_start(m);

    for (SmvmAt w = 0; w < m->windows; w++) {
        window[w] = (uint64_t *)(void *)((uint8_t *)vm + at);
        at = add_window_bytes(m, w, at);
    }
    vm->local = at;
}

// Writes the initial values that the image lists to the machine's locals.
static void set_locals(SmVm *vm, const SmvmMachine *m)
{
    SmvmAt at = m->init_at;

    while (at < m->init_at + m->init_size) {
        SmvmLocation p = smvm_location(m->image, at);
        uint8_t bytes = (uint8_t)(1u << smvm_shift((uint8_t)p.type));
        uint8_t *to = (uint8_t *)vm + vm->local + p.offset;
        smvm_read_bits(m->image, (SmvmAt)(at + SMVM_LOCATION_BYTES), to, bytes);
        if (p.type == SM_BOOL)
            *to = *to != 0;
        at = (SmvmAt)(at + SMVM_LOCATION_BYTES + bytes);
    }
}

#if SMVM_PARAMETERS
// Reads the next entry of PARAMETERS.  Returns false at the end, or if the entry is not complete.
bool smvm_read_parameter(SmvmReader *r, SmvmParameterEntry *p)
{
    const SmvmAt location = smvm_skip(r, SMVM_LOCATION_BYTES);

    if (location == 0)
        return false;
    p->location = smvm_location(r->image, location);
    p->bytes = (uint8_t)(1u << smvm_shift((uint8_t)p->location.type));
    p->numbers = smvm_skip(r, (uint8_t)(SMVM_PARAMETER_NUMBERS * p->bytes));
    for (uint8_t i = 0; i < 2; i++) {
        if (p->numbers == 0 || smvm_read_number(r) != SMVM_VARINT_OK || (SmvmAt)(r->end - r->at) <= r->n)
            return false;
        p->name[i] = r->at;
        p->size[i] = r->n;
        r->at = (SmvmAt)(r->at + r->n + 1);
    }
    return true;
}

SmvmReader smvm_parameters(const SmvmMachine *m)
{
    const SmvmReader r = {m->image, m->parameters_at, (SmvmAt)(m->parameters_at + m->parameters_size), 0};

    return r;
}

// Stores in the local of each parameter the value that the image has for this parameter.
static void set_parameters(SmVm *vm, const SmvmMachine *m)
{
    SmvmReader r = smvm_parameters(m);
    SmvmParameterEntry p;

    while (smvm_read_parameter(&r, &p))
        smvm_read_bits(m->image, smvm_parameter_number(&p, SMVM_PARAMETER_VALUE), (uint8_t *)vm + vm->local + p.location.offset, p.bytes);
}
#endif

// Whether p is aligned for every type of data stored there: a multiple of 8 on most targets, any address on some.
static bool is_aligned(const void *p)
{
    struct Strict { char c; union { uint64_t time; SmF64 number; void *pointer; } at; };

    return (uintptr_t)p % offsetof(struct Strict, at) == 0;
}

// Starts a machine without an access to the state vector; smvm_write_state, or smvm_swap_continue, stores S later.
SmResult smvm_prepare(void *memory, uint32_t size, const SmvmMachine *m, const SmvmVector *sv, uint32_t state)
{
    SmVm *vm = memory;
    SmvmAt bytes;

    if (sv->layout != m->layout || sv->size != m->sv_size)
        return SM_E_LAYOUT;
    if (state < 1 || state > m->states)
        return SM_E_ARGUMENT;
    if (!is_aligned(memory) || !is_aligned(sv->at))
        return SM_E_ALIGNMENT;
    bytes = smvm_ram_size(m);
    if (size < bytes)
        return SM_E_MEMORY;
    memset(memory, 0, (size_t)bytes);
    vm->image = m->image;
    vm->machine = m->machine_at;
    vm->code = m->code_at;
    set_window_pointers(vm, m);
    set_locals(vm, m);
#if SMVM_PARAMETERS
    set_parameters(vm, m);
#endif
#if SMVM_KEEP_TABLES
    smvm_tables(m, vm, &vm->tables);
#endif
    vm->state = (SmvmAt)state;
    vm->first = true;
    return SM_OK;
}

SmResult smvm_init(void *memory, uint32_t size, const SmvmMachine *m, const SmvmVector *sv, uint32_t state)
{
    const SmResult r = smvm_prepare(memory, size, m, sv, state);

    if (r == SM_OK)
        sm_cell_store(SM_U32, (uint8_t *)sv->at + m->s, state);
    return r;
}

// ---- reading its state ----

// Returns the state that the next step runs.
uint32_t smvm_state(const SmVm *vm) { return vm->state; }

// Returns T: the time since the first step of the state (language.md 6).
uint64_t smvm_time(const SmVm *vm) { return vm->next - vm->start; }

// Whether the last step stored S.
bool smvm_stored_state(const SmVm *vm) { return vm->entered; }

// Returns the locals, at the offsets that the code and the debug section use.
void *smvm_locals(SmVm *vm) { return (uint8_t *)vm + vm->local; }

// Whether the last step stored this output, 0 to m.outputs - 1.
bool smvm_stored(const SmVm *vm, uint32_t output)
{
    const uint8_t *bits = vm->stored;

    if (output >= 64) {
#if SMVM_KEEP_TABLES
        bits = (const uint8_t *)vm + vm->tables.more;
#else
        SmvmMachine m;
        smvm_reread_machine(vm, &m);
        bits = (const uint8_t *)vm + vm->local + m.locals;
#endif
        output -= 64;
    }
    return (bits[output >> 3] >> (output & 7) & 1) != 0;
}

// ---- opcodes ----

typedef char load_shape_bits_are_in_the_order_of_operands[SMVM_SHAPE_L == 1 << SMVM_OPERAND_L >> 1 && SMVM_SHAPE_J == 1 << SMVM_OPERAND_J >> 1
                                                          ? 1 : -1];

// Returns the SMVM_SHAPE_ bits of an opcode; 0: there is no such opcode.
uint32_t smvm_shape(uint8_t opcode)
{
    const uint16_t packed = smvm_packed_shape(opcode);
    const uint8_t what = packed & 0xf;
    const uint16_t follows = what == SMVM_OPERANDS_K_W ? SMVM_SHAPE_K | SMVM_SHAPE_W : what == SMVM_OPERANDS_N_J ? SMVM_SHAPE_N | SMVM_SHAPE_J
                                                                                                     : (uint16_t)(1u << what >> 1);

    return follows | (uint32_t)(packed >> 4) << 12;
}
