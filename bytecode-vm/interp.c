// SPDX-License-Identifier: Apache-2.0
// The interpreter: one step of a machine (language.md 6).  It does not check again what the verifier has proved: operands exist, code
// ends, jumps lead to instructions, memory is large enough.
#include <stddef.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"

#if SM_F64_SOFT && SMVM_FETCH_AVR
// ---- on AVR: assembly does everything except windows ----

#include "bytecode-vm/interp_avr.h"

SmResult smvm_step_flash(SmVm *vm, void *sv);
SmResult smvm_step_eeprom(SmVm *vm, void *sv);
SmF64 smvm_load_flash(uint8_t type, const void *at);
SmF64 smvm_load_eeprom(uint8_t type, const void *at);
void smvm_store_flash(SmF64 x, uint8_t type, void *at);
void smvm_store_eeprom(SmF64 x, uint8_t type, void *at);
void smvm_add_sample(SmVm *vm, SmvmAt w);
SmF64 smvm_compute_statistic(SmVm *vm, uint8_t stat, SmvmAt w);
uint64_t smvm_call_function(uint64_t x, uint16_t n, const SmVm *vm);

#define SMVM_CHECK_OFFSET(member, at) typedef char smvm_offset_is_##at[offsetof(SmVm, member) == (at) ? 1 : -1]
SMVM_CHECK_OFFSET(image, VM_IMAGE);
SMVM_CHECK_OFFSET(start, VM_START);
SMVM_CHECK_OFFSET(next, VM_NEXT);
SMVM_CHECK_OFFSET(stored, VM_STORED);
SMVM_CHECK_OFFSET(code, VM_CODE);
SMVM_CHECK_OFFSET(local, VM_LOCAL);
SMVM_CHECK_OFFSET(state, VM_STATE);
SMVM_CHECK_OFFSET(tables.windows, VM_WINDOWS);
SMVM_CHECK_OFFSET(tables.outputs, VM_OUTPUTS);
SMVM_CHECK_OFFSET(tables.functions, VM_FUNCTIONS);
SMVM_CHECK_OFFSET(tables.f32s, VM_F32S);
SMVM_CHECK_OFFSET(tables.f64s, VM_F64S);
SMVM_CHECK_OFFSET(tables.more, VM_MORE);
SMVM_CHECK_OFFSET(tables.more_bytes, VM_MORE_BYTES);
SMVM_CHECK_OFFSET(tables.g, VM_G);
SMVM_CHECK_OFFSET(tables.s, VM_S);
SMVM_CHECK_OFFSET(tables.width, VM_WIDTH);
SMVM_CHECK_OFFSET(body, VM_BODY);
SMVM_CHECK_OFFSET(y, VM_Y);
typedef char smvm_step_results_agree[SM_OK == STEP_OK && SM_REFUSED == STEP_REFUSED ? 1 : -1];

#if SMVM_FETCH_AVR == 1
SmResult smvm_step(SmVm *vm, void *sv) { return smvm_step_flash(vm, sv); }
SmF64 smvm_load(uint8_t type, const void *at) { return smvm_load_flash(type, at); }
void smvm_store(SmF64 x, uint8_t type, void *at) { smvm_store_flash(x, type, at); }
#else
SmResult smvm_step(SmVm *vm, void *sv) { return smvm_step_eeprom(vm, sv); }
SmF64 smvm_load(uint8_t type, const void *at) { return smvm_load_eeprom(type, at); }
void smvm_store(SmF64 x, uint8_t type, void *at) { smvm_store_eeprom(x, type, at); }
#endif

// Adds a sample to window w.  The assembly has stored it in vm->y, converted to the window's type.
void smvm_add_sample(SmVm *vm, SmvmAt w)
{
    const uint32_t entry = smvm_window(vm->image, vm->tables.windows, w);

    const uint16_t kind = smvm_window_kind(entry);

    if ((kind & SM_ROLL_TYPE) == SM_ROLL_TIMES)
        sm_roll_sample_event(smvm_windows_of(vm)[w], smvm_window_size(entry), kind, sm_cell_load(SM_U64, vm->y), vm->next - 1);
    else
        sm_roll_sample_cell(smvm_windows_of(vm)[w], smvm_window_size(entry), kind, vm->y);
}

// Calls function n.  The assembly has stored Y in vm->y as an F64 if the function reads it.
uint64_t smvm_call_function(uint64_t x, uint16_t n, const SmVm *vm)
{
    SmF64 y;

    memcpy(&y, vm->y, sizeof y);
    return sm_bits(smvm_call((uint8_t)n, sm_from_bits(x), y));
}

// Returns a statistic of window w.
SmF64 smvm_compute_statistic(SmVm *vm, uint8_t stat, SmvmAt w)
{
    const uint32_t entry = smvm_window(vm->image, vm->tables.windows, w);

    return sm_roll_stat(smvm_windows_of(vm)[w], smvm_window_size(entry), smvm_window_kind(entry), (SmStat)stat);
}
#else
#include "bytecode-vm/number.h"
#include "bytecode-vm/step.h"

typedef struct Interpreter {
    SmVm *vm;
    uint8_t *sv, *locals;
    const SmvmTables *t;
#if SMVM_SPECIALIZE
    uint64_t stored;          // bits of those of the first 64 outputs that this step has stored; written to SmVm.stored at the step's end
#else
    Number x, y;
#endif
} Interpreter;

// For functions that are parts of instructions: inlined where each opcode has code of its own, otherwise shared.
#if SMVM_SPECIALIZE
#define INTERP_INLINE SMVM_INLINE
#else
#define INTERP_INLINE SMVM_NOINLINE static
#endif

// ---- access to the code ----

SMVM_INLINE uint8_t fetch_byte(SmvmBytes at) { return (uint8_t)SMVM_FETCH(at, 0); }

// Reads a varint of two or four bytes: b is its first byte, and the others start at `at`.
SMVM_RARE static uint32_t read_long_varint(SmvmBytes at, uint8_t b)
{
    uint32_t v;

    if (b < SMVM_VARINT_2)
        return SMVM_VARINT_1 + (uint32_t)((uint16_t)(b - SMVM_VARINT_1) << 7 | fetch_byte(at));
    v = b & 7;
    for (uint8_t i = 0; i < 3; i++)
        v = v << 7 | fetch_byte(at++);
    return SMVM_VARINT_MID + v;
}

#if SMVM_SPECIALIZE
SMVM_INLINE SmvmBytes image_at(SmvmBytes base, uintptr_t offset) { return (SmvmBytes)(base + offset); }

// Return the little-endian number at `at`: compilers turn each sum into one load.
SMVM_INLINE uint32_t fetch_u16(SmvmBytes at) { return fetch_byte(at) | (uint32_t)fetch_byte(at + 1) << 8; }
SMVM_INLINE uint32_t fetch_u32(SmvmBytes at) { return fetch_u16(at) | (uint32_t)fetch_byte(at + 2) << 16 | (uint32_t)fetch_byte(at + 3) << 24; }
SMVM_INLINE uint64_t fetch_u64(SmvmBytes at) { return fetch_u32(at) | (uint64_t)fetch_u32(at + 4) << 32; }
#endif

// Returns the bits of entry n of a table in the image, whose entries have 4 or 8 bytes.
SMVM_INLINE uint64_t read_entry(const Interpreter *r, SmvmAt table, uint32_t n, uint8_t bytes)
{
    const SmvmAt offset = (SmvmAt)(table + bytes * (SmvmAt)n);

#if SMVM_SPECIALIZE
    const SmvmBytes at = r->vm->image + offset;
    return bytes == 4 ? fetch_u32(at) : fetch_u64(at);
#else
    return smvm_cell(r->vm->image, offset, bytes);
#endif
}

// ---- loads and stores ----

SMVM_INLINE uint8_t *operand_address(uint8_t *base, uint8_t type, size_t at) { return base + (at << smvm_type_shift(type)); }

#if SMVM_SPECIALIZE
// Stores x as an element or local of this type, at an offset in units of the type's size.
SMVM_INLINE void store_at(const Number *x, uint8_t type, uint8_t *base, SmvmAt offset)
{
    switch (type) {
#define STORE_AT(K) case SMVM_KIND_##K: number_store(x, SMVM_KIND_##K, operand_address(base, SMVM_KIND_##K, offset)); break;
    SMVM_EACH_KIND(STORE_AT)
    }
}

// Returns the bit of `output` if it is one of the first 64 outputs.  Otherwise sets the output's bit in memory, and returns 0.
SMVM_INLINE uint64_t mark_output_stored(const Interpreter *r, uintptr_t output)
{
    uint8_t *more;

    if (!SMVM_UNLIKELY(output >= 64))
        return (uint64_t)1 << output;
    more = (uint8_t *)r->vm + r->t->more + (output - 64) / 8;
    *more = (uint8_t)(*more | 1u << (output & 7));
    return 0;
}

#else
SMVM_INLINE void store_at(const Number *x, uint8_t type, uint8_t *base, SmvmAt offset) { number_store(x, type, operand_address(base, type, offset)); }

// Sets the bit of an output that this step stores.
INTERP_INLINE void mark_output_stored(const Interpreter *r, SmvmAt output)
{
    uint8_t *bits = r->vm->stored;

    if (output >= 64) {
        bits = (uint8_t *)r->vm + r->t->more;
        output = (SmvmAt)(output - 64);
    }
    bits[output >> 3] = (uint8_t)(bits[output >> 3] | 1u << (output & 7));
}

INTERP_INLINE void store_output(const Interpreter *r, SmvmAt output, const Number *x)
{
    const SmvmBytes at = r->vm->image + (SmvmAt)(r->t->outputs + SMVM_LOCATION_BYTES * output);
    const uint8_t high = fetch_byte(at + 2);
    SmvmAt offset = (SmvmAt)(fetch_byte(at) | (uint16_t)fetch_byte(at + 1) << 8);

    if (sizeof offset > 2)
        offset = (SmvmAt)(offset | (uint32_t)(high & 0xf0) << 12);
    mark_output_stored(r, output);
    store_at(x, high & 0xf, r->sv, offset);
}
#endif

// Converts x to the value that a local of this type would store.
SMVM_NOINLINE static void convert_as_local(Number *x, uint8_t type)
{
    uint64_t cell = 0;

    store_at(x, type, (uint8_t *)&cell, 0);
    number_load(x, type, (uint8_t *)&cell);
}

// ---- for code outside the interpreter, so that the flash of a chip contains only one copy ----

SmF64 smvm_load(uint8_t type, const void *at)
{
    Number x;

    number_load(&x, type, (const uint8_t *)at);
    return number_f64(&x);
}

void smvm_store(SmF64 x, uint8_t type, void *at) { number_store_real(x, type, (uint8_t *)at); }

// ---- windows ----

// Adds x to the rolling window w: for a window of times an event (0, 1 or 2, see stdlib/roll.h) at the current time, else a value.
void smvm_sample(const SmVm *vm, uint64_t *w, uint32_t n, uint32_t kind, SmF64 x)
{
    if ((kind & SM_ROLL_TYPE) == SM_ROLL_TIMES)
        sm_roll_sample_event(w, n, kind, sm_to_u64(x), vm->next - 1);
    else
        sm_roll_sample(w, n, kind, x);
}
SmF64 smvm_statistic(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat) { return sm_roll_stat(w, n, kind, stat); }

SMVM_NOINLINE static void push_sample(const Interpreter *r, SmvmAt w, const Number *x)
{
    const uint32_t entry = (uint32_t)read_entry(r, r->t->windows, w, SMVM_WINDOW_ENTRY);

    smvm_sample(r->vm, smvm_windows_of(r->vm)[w], smvm_window_size(entry), smvm_window_kind(entry), number_f64(x));
}

SMVM_NOINLINE static void read_statistic(const Interpreter *r, uint8_t stat, SmvmAt w, Number *x)
{
    const uint32_t entry = (uint32_t)read_entry(r, r->t->windows, w, SMVM_WINDOW_ENTRY);
    const uint32_t n = smvm_window_size(entry), kind = smvm_window_kind(entry);

    number_set_real(x, smvm_statistic(smvm_windows_of(r->vm)[w], n, kind, (SmStat)stat));
}

// ---- instructions ----

// Returns elementary function n of x, or of x and y. y is undefined if the function has one argument.
SMVM_NOINLINE static SmF64 call_function(uint8_t n, const Number *x, const Number *y)
{
    const SmF64 a = number_f64(x);

    return smvm_call(n, a, n >= SMVM_FN_OF_TWO ? number_f64(y) : a);
}

#if SMVM_SPECIALIZE
SMVM_INLINE void load_f32(SmvmBytes at, Number *x) { number_set_real(x, sm_from_f32(sm_f32_from_bits(fetch_u32(at)))); }
SMVM_INLINE void load_f64(SmvmBytes at, Number *x) { number_set_real(x, sm_from_bits(fetch_u64(at))); }
#else
SMVM_NOINLINE static void load_f32(const Interpreter *r, uint32_t n, Number *x)
{
    number_set_real(x, sm_from_f32(sm_f32_from_bits((uint32_t)read_entry(r, r->t->f32s, n, 4))));
}

SMVM_NOINLINE static void load_f64(const Interpreter *r, uint32_t n, Number *x)
{
    number_set_real(x, sm_from_bits(read_entry(r, r->t->f64s, n, 8)));
}
#endif

INTERP_INLINE void load_time(const Interpreter *r, Number *x)
{
    const uint64_t time = r->vm->next - r->vm->start;

    number_load(x, SM_U64, (const uint8_t *)&time);
}

#if SMVM_SPECIALIZE
// ---- instructions: each opcode has code of its own (interp.def) ----

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-crossjumping", "no-tree-tail-merge")           // these optimisations would merge the jumps between instructions
#endif

// Reads the varint at *at and moves past it.
SMVM_INLINE uintptr_t read_varint(SmvmBytes *at)
{
    const uint8_t b = fetch_byte((*at)++);

    if (b < SMVM_VARINT_1)
        return b;
    if (SMVM_LIKELY(b < SMVM_VARINT_2))
        return SMVM_VARINT_1 + ((uintptr_t)(b - SMVM_VARINT_1) << 7) + fetch_byte((*at)++);
    *at += 3;
    return read_long_varint(*at - 3, b);
}

// Ends a function.  Returns the target state of its transition, or 0 if it made no transition.
SMVM_INLINE SmvmAt finish_function(Interpreter *r, uint64_t stored, uintptr_t to)
{
    r->stored = stored;
    return (SmvmAt)to;
}

// READ_… reads the operands of an instruction and `next`, the opcode after them.  A byte with its top bit set is an opcode.  So if the byte
// after n bytes, where n is the number of operands, has its top bit set, each operand is one byte.
#define READ_NONE next = fetch_byte(at++)
#define READ_N                                                                                                                  \
    next = fetch_byte(at + 1);                                                                                                  \
    if (SMVM_LIKELY(next >= SMVM_OP_FIRST)) {                                                                                   \
        n = fetch_byte(at);                                                                                                     \
        at += 2;                                                                                                                \
    } else {                                                                                                                    \
        n = read_varint(&at);                                                                                                   \
        READ_NONE;                                                                                                              \
    }
#define READ_NJ                                                                                                                 \
    next = fetch_byte(at + 2);                                                                                                  \
    if (SMVM_LIKELY(next >= SMVM_OP_FIRST)) {                                                                                   \
        n = fetch_byte(at);                                                                                                     \
        j = fetch_byte(at + 1);                                                                                                 \
        at += 3;                                                                                                                \
    } else {                                                                                                                    \
        n = read_varint(&at);                                                                                                   \
        j = read_varint(&at);                                                                                                   \
        READ_NONE;                                                                                                              \
    }
#define READ_END (void)0      // no opcode follows: the function ends, and perhaps the image

// Jumps to the instruction that starts `bytes` after the end of this one.
#define JUMP(bytes) at += (SmvmAt)(bytes); next = fetch_byte(at - 1)
#define JUMP_IF(condition, bytes) if (condition) { JUMP(bytes); NEXT; }    // each opcode has this branch for itself, which CPUs predict better

// CPUs predict a branch better than a jump to a computed address.  So an instruction tests for the most frequent successors first.
// FUSE: if the next instruction is this operation, runs it here. GO_IF_NEXT: if the next instruction is this one, jumps to its code.
#define FUSE(op) if (next == SMVM_##op) { SMVM_ON_INSTRUCTION; READ_NONE; number_compute(&x, SMVM_##op, &y); GO_IF_NEXT(out); NEXT; }
#define FUSE_ARITHMETIC FUSE(mul) FUSE(add) FUSE(sub) FUSE(div)

// The families of interp.def.
#define AT_N(base, K) operand_address(base, SMVM_KIND_##K, n)
#define LDX_LOCAL(K) RUN(ldx_local_##K, SMVM_ldx_local + SMVM_KIND_##K, N, number_load(&x, SMVM_KIND_##K, AT_N(locals, K)))
#define LDY_LOCAL(K) RUN(ldy_local_##K, SMVM_ldy_local + SMVM_KIND_##K, N, number_load(&y, SMVM_KIND_##K, AT_N(locals, K)); FUSE_ARITHMETIC)
#define LDX_ELEM(K) RUN(ldx_elem_##K, SMVM_ldx_elem + SMVM_KIND_##K, N, number_load(&x, SMVM_KIND_##K, AT_N(sv, K)))
#define LDY_ELEM(K) RUN(ldy_elem_##K, SMVM_ldy_elem + SMVM_KIND_##K, N, number_load(&y, SMVM_KIND_##K, AT_N(sv, K)); FUSE_ARITHMETIC)
#define ST_LOCAL(K) RUN(st_local_##K, SMVM_st_local + SMVM_KIND_##K, N, number_store(&x, SMVM_KIND_##K, AT_N(locals, K)))
#define JXY(M) RUN(jxy_##M, SMVM_jxy + (M) - 1, N, JUMP_IF(number_is_related(&x, &y, M), n))
#define JXN(M) RUN(jxn_##M, SMVM_jxn + (M) - 1, NJ, number_set_integer(&z, (int32_t)n); JUMP_IF(number_is_related(&x, &z, M), j))

// Sets n and j to the offset and the type of output n (SMVM_LOCATION_BYTES).
#define READ_LOCATION                                                                                                           \
    n *= SMVM_LOCATION_BYTES;                                                                                                   \
    j = fetch_byte(image_at(outputs, n + 2));                                                                                       \
    n = fetch_u16(image_at(outputs, n));                                                                                      \
    if (SMVM_UNLIKELY(j > 0xf)) {                                                                                               \
        n |= (j & 0xf0) << 12;                                                                                                  \
        j &= 0xf;                                                                                                               \
    }
// STORE_OUTPUT stores X in the element of type j at offset n.
#if SMVM_COMPUTED_GOTO
#pragma GCC diagnostic ignored "-Wpedantic"
#define NEXT goto *label[next]
#define GO_IF_NEXT(name) if (next == SMVM_##name) goto name##_
#define STORE_OUTPUT goto *store_label[j]
#define STORE_LABEL(K) &&store_##K##_,
#define STORE_TYPE(K) store_##K##_: number_store(&x, SMVM_KIND_##K, AT_N(sv, K)); NEXT;
#else
#define NEXT continue
#define GO_IF_NEXT(name) (void)0
#define STORE_OUTPUT store_at(&x, (uint8_t)j, sv, (SmvmAt)n)
#endif

// Runs a function's code from `at` to `end` or `goto`.  Returns the target state of its transition, or 0 if it made no transition.
static SmvmAt run_code(Interpreter *r, SmvmBytes at)
{
    uint8_t *const sv = r->sv, *const locals = r->locals;
    const SmvmBytes outputs = r->vm->image + r->t->outputs, f32s = r->vm->image + r->t->f32s, f64s = r->vm->image + r->t->f64s;
    uint64_t stored = r->stored;
    Number x, y, z;           // z: a second operand that must not overwrite Y
    Number passed;            // a copy of X for functions that are not inlined: so that X itself need not be in memory
    uintptr_t n = 0, j, next;     // operands and opcode, as wide as an address, so that address computations need no conversion
#if SMVM_COMPUTED_GOTO
    static const void *const label[] = {
#define RUN(name, opcode, read, ...) [opcode] = &&name##_,
#include "bytecode-vm/interp.def"
#undef RUN
    };
    static const void *const store_label[] = {SMVM_EACH_TYPE(STORE_LABEL)};
#endif

    number_set_integer(&x, 0);
    number_set_integer(&y, 0);
    READ_NONE;
#if SMVM_COMPUTED_GOTO
    NEXT;
#define RUN(name, opcode, read, ...) name##_: SMVM_ON_INSTRUCTION; READ_##read; __VA_ARGS__; NEXT;
#include "bytecode-vm/interp.def"
#undef RUN
    SMVM_EACH_TYPE(STORE_TYPE)
#else
    for (;;)
        switch (next) {
#define RUN(name, opcode, read, ...) case opcode: SMVM_ON_INSTRUCTION; READ_##read; __VA_ARGS__; NEXT;
#include "bytecode-vm/interp.def"
#undef RUN
        }
#endif
}
#else
// ---- instructions: opcodes share code, for small chips ----

SMVM_INLINE SmvmBytes skip_varint(SmvmBytes at, uint8_t b)      // returns the end of the varint whose first byte b precedes `at`
{
    return b < SMVM_VARINT_1 ? at : b < SMVM_VARINT_2 ? at + 1 : at + 3;
}

// Runs an opcode from SMVM_add on: an operation without operand bytes.
SMVM_NOINLINE static void run_operation(Interpreter *r, uint8_t op)
{
    if (op == SMVM_and)
        number_set_integer(&r->x, number_is_true(&r->x) && number_is_true(&r->y));
    else if (op == SMVM_or)
        number_set_integer(&r->x, number_is_true(&r->x) || number_is_true(&r->y));
    else
        number_compute(&r->x, op, &r->y);
}

static uint8_t relation_of_x_to_y(const Interpreter *r) { return number_relation(&r->x, &r->y); }
static bool is_x_related_to_y(const Interpreter *r, uint8_t m) { return (relation_of_x_to_y(r) & m) != 0; }

// Runs the loads of constants (ldx_plus, ldx_minus, ldx_f32, ldx_f64 and the four that load Y), addi and subi.  Bit 5 of a load selects Y.
SMVM_NOINLINE static void load_number(Interpreter *r, uint8_t op, uint32_t n)
{
    Number *x = op & 0x20 ? &r->y : &r->x, y;

    switch (op & 0x1f) {
    case SMVM_ldx_plus & 0x1f: number_set_integer(x, (int32_t)n); break;
    case SMVM_ldx_minus & 0x1f: number_set_integer(x, -1 - (int32_t)n); break;
    case SMVM_ldx_f32 & 0x1f: load_f32(r, n, x); break;
    case SMVM_ldx_f64 & 0x1f: load_f64(r, n, x); break;
    default:
        number_set_integer(&y, (int32_t)n);
        number_compute(x, op == SMVM_addi ? SMVM_add : SMVM_sub, &y);
    }
}

// Runs a load of anything but T, or addi or subi.  Bit 4 of a load's opcode selects the state vector instead of the locals.
SMVM_NOINLINE static void load_register(Interpreter *r, uint8_t op, uint32_t n)
{
    const uint8_t type = op & 0xf;

    if (type > SMVM_RAW)
        load_number(r, op, n);
    else
        number_load(op & 0x20 ? &r->y : &r->x, type, operand_address(op & 0x10 ? r->sv : r->locals, type, (SmvmAt)n));
}

// Runs st_local, out, set, cvt, fn or sample.
SMVM_NOINLINE static void run_store_or_convert(Interpreter *r, uint8_t op, uint32_t n)
{
    const uint8_t type = op & 0xf;

    switch (op) {
    case SMVM_out: store_output(r, (SmvmAt)n, &r->x); break;
    case SMVM_set: number_set_integer(&r->x, is_x_related_to_y(r, (uint8_t)n)); break;
    case SMVM_cvt: convert_as_local(&r->x, (uint8_t)n); break;
    case SMVM_fn: number_set_real(&r->x, call_function((uint8_t)n, &r->x, &r->y)); break;
    case SMVM_sample: push_sample(r, (SmvmAt)n, &r->x); break;
    default: number_store(&r->x, type, operand_address(r->locals, type, (SmvmAt)n));
    }
}

SMVM_NOINLINE static bool is_jump_taken(const Interpreter *r, uint8_t op)  // op: a jxy, jmp, jf or jt
{
    switch (op) {
    case SMVM_jmp: return true;
    case SMVM_jf: return !number_is_true(&r->x);
    case SMVM_jt: return number_is_true(&r->x);
    default: return is_x_related_to_y(r, op & 0xf);
    }
}

// Runs a function's code from `at` to `end` or `goto`.  Returns the target state of its transition, or 0 if it made no transition.
SMVM_NOINLINE static SmvmAt run_code(Interpreter *r, SmvmBytes at)
{
    for (;;) {
        const uint8_t op = fetch_byte(at++);
        uint8_t b;
        uint32_t n;
        SMVM_ON_INSTRUCTION;
        if (op >= SMVM_add) {
            run_operation(r, op);
            continue;
        }
        if (op == SMVM_end)
            return 0;
        if ((op & (uint8_t)~0x20) == SMVM_ldx_time) {
            load_time(r, op == SMVM_ldx_time ? &r->x : &r->y);
            continue;
        }
        n = b = fetch_byte(at++);
        if (b >= SMVM_VARINT_1) {
            n = read_long_varint(at, b);
            at = skip_varint(at, b);
        }
        if (op >= SMVM_jxy) {
            bool jump;
            if (op >= SMVM_jxn && op < SMVM_jt) {
                jump = (number_relation_to(&r->x, (int32_t)n) & op) != 0;
                n = b = fetch_byte(at++);
                if (b >= SMVM_VARINT_1) {
                    n = read_long_varint(at, b);
                    at = skip_varint(at, b);
                }
            } else
                jump = is_jump_taken(r, op);
            if (jump)
                at += (SmvmAt)n;
        } else if (op == SMVM_goto)
            return (SmvmAt)n;
        else if (op == SMVM_stat) {
            b = fetch_byte(at++);
            read_statistic(r, (uint8_t)n, b < SMVM_VARINT_1 ? b : (SmvmAt)read_long_varint(at, b), &r->x);
            at = skip_varint(at, b);
        } else if (op < SMVM_cvt)
            load_register(r, op, n);
        else
            run_store_or_convert(r, op, n);
    }
}
#endif

static SmvmAt read_function_end(const Interpreter *r, SmvmBytes at)  // reads the entry at `at` of the table of functions (image.h)
{
#if SMVM_SPECIALIZE
    const uint8_t width = r->t->width;

    return (SmvmAt)(width == 1 ? fetch_byte(at) : width == 2 ? fetch_u16(at) : fetch_u16(at) | (uint32_t)fetch_byte(at + 2) << 16);
#else
    SmvmAt end = fetch_byte(at);

    for (uint8_t i = 1; i < r->t->width; i++)
        end = (SmvmAt)(end | (SmvmAt)fetch_byte(at + i) << 8 * i);
    return end;
#endif
}

// Runs a function by its number (smvm_function_end).  Returns the target state of its transition, or 0 if it made no transition.
static SmvmAt run_function(Interpreter *r, SmvmAt function)
{
    SmvmBytes at = r->vm->image + r->t->functions;
    SmvmAt start = 0;

    if (function > 0) {
        at += (SmvmAt)(r->t->width * (SmvmAt)(function - 1));
        start = read_function_end(r, at);
        at += r->t->width;
    }
    return start == read_function_end(r, at) ? 0 : run_code(r, r->vm->image + (SmvmAt)(r->vm->code + start));
}

// ---- the step ----

// Forgets which outputs the previous step stored.
static void clear_stored_bits(Interpreter *r)
{
#if SMVM_SPECIALIZE
    r->stored = 0;
#else
    memset(r->vm->stored, 0, sizeof r->vm->stored);
#endif
    if (r->t->more_bytes != 0)
        memset((uint8_t *)r->vm + r->t->more, 0, r->t->more_bytes);
}

static SmResult run_step(Interpreter *r)
{
    SmVm *vm = r->vm;
    SmvmAt block = (SmvmAt)(3 * vm->state - 2), to = 0;        // the state's functions: entry, step, exit

    if (!smvm_advance(vm, r->sv + r->t->g))
        return SM_REFUSED;
    smvm_enter(vm, r->sv + r->t->s);
    clear_stored_bits(r);
    run_function(r, 0);
    if (vm->first)
        to = run_function(r, block);
    if (to == 0)
        to = run_function(r, (SmvmAt)(block + 1));
    if (to != 0) {
        run_function(r, (SmvmAt)(block + 2));
        vm->state = to;
    }
    vm->first = to != 0;
#if SMVM_SPECIALIZE
    smvm_store_bits(vm->stored, r->stored);
#endif
    return SM_OK;
}

SmResult smvm_step(SmVm *vm, void *sv)
{
    Interpreter r;
#if SMVM_KEEP_TABLES
    r.t = &vm->tables;
#else
    SmvmTables tables;
    SmvmMachine m;

    smvm_reread_machine(vm, &m);
    smvm_tables(&m, vm, &tables);
    r.t = &tables;
#endif
    r.vm = vm;
    r.sv = (uint8_t *)sv;
    r.locals = (uint8_t *)vm + vm->local;
    return run_step(&r);
}
#endif
