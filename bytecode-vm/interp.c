// SPDX-License-Identifier: Apache-2.0
// The interpreter: one step of a machine (language.md 6).  It checks nothing that the verifier has decided: operands exist,
// code ends, jumps land on instructions, memory is there.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "bytecode-vm/step.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

// Where the interpreter stands in the code.
typedef struct Run {
    SmVm *vm;
    uint8_t *sv;
    SmvmMachine m;
    SmvmParts parts;
    uint32_t at;
    union { uint64_t cell; SmF64 number; } acc;    // the accumulator, as it would lie in memory
} Run;

static uint32_t next(Run *r)                          // the next varint
{
    SmvmBytes image = r->m.image;
    uint32_t b = smvm_u8(image, r->at++);

    if (b < SMVM_VARINT_1)
        return b;
    if (b < SMVM_VARINT_2)
        return SMVM_VARINT_1 + ((b - SMVM_VARINT_1) << 7 | smvm_u8(image, r->at++));
    b -= SMVM_VARINT_2;
    for (uint8_t i = 0; i < 3; i++)
        b = b << 7 | smvm_u8(image, r->at++);
    return SMVM_VARINT_MID + b;
}

// ---- operands ----

static SmF64 constant(const Run *r, uint8_t kind, uint32_t payload)
{
    switch (kind) {
    case SMVM_K_TIME: return sm_from_u64(r->vm->next - r->vm->start);
    case SMVM_K_INT: return sm_from_i32((int32_t)payload - (payload > (uint32_t)SMVM_INT_MOST ? SMVM_PAYLOADS : 0));
    case SMVM_K_F32: return sm_from_f32(sm_f32_from_bits(smvm_uint(r->m.image, r->m.f32s_at + 4 * payload, 4)));
    default: return sm_from_bits(smvm_cell(r->m.image, r->m.f64s_at + 8 * payload, 8));
    }
}

// Where an operand lies that can be written, and its type or SMVM_RAW; NULL for others.
static void *memory_of(Run *r, uint8_t kind, uint32_t payload, uint8_t *type)
{
    uint8_t *base = r->sv;

    *type = SMVM_RAW;
    if (kind == SMVM_K_TEMP)
        return &r->parts.temp[payload];
    if (kind == SMVM_K_ACC) {
        *type = (uint8_t)payload;
        return &r->acc;
    }
    if (kind > SMVM_K_TEMP)
        return NULL;
    if (kind >= SMVM_K_LOCAL) {
        kind = (uint8_t)(kind - SMVM_K_LOCAL);
        base = r->parts.local;
    }
    *type = kind;
    return base + ((size_t)payload << smvm_type_shift(kind));
}

static void *operand(Run *r, uint32_t index, uint8_t *kind, uint32_t *payload, uint8_t *type)
{
    uint32_t entry = smvm_u24(r->m.image, r->m.operands_at + 3 * index);

    *kind = entry & ((1u << SMVM_KIND_BITS) - 1u);
    *payload = entry >> SMVM_KIND_BITS;
    return memory_of(r, *kind, *payload, type);
}

static SmF64 get(Run *r)
{
    uint8_t kind, type;
    uint32_t payload;
    const void *p = operand(r, next(r), &kind, &payload, &type);

    if (p == NULL)
        return constant(r, kind, payload);
    return type == SMVM_RAW ? *(const SmF64 *)p : sm_load((SmType)type, p);
}

static void note(Run *r, uint32_t output)             // that it is written
{
    uint8_t *bits = r->vm->stored;

    if (output >= 64) {
        bits = r->parts.stored;
        output -= 64;
    }
    bits[output >> 3] = (uint8_t)(bits[output >> 3] | 1u << (output & 7u));
}

static void put(Run *r, uint32_t index, SmF64 x)
{
    uint8_t kind, type;
    uint32_t payload;
    void *p = operand(r, index, &kind, &payload, &type);

    if (kind < SMVM_K_LOCAL)
        note(r, index);
    if (type == SMVM_RAW)
        *(SmF64 *)p = x;
    else
        sm_store((SmType)type, p, x);
}

// ---- operations ----

static SmF64 number(bool b) { return sm_from_i32(b); }

static SmF64 of_one(uint8_t op, SmF64 x)
{
    switch (op) {
    case SMVM_neg: return sm_neg(x);
    case SMVM_abs: return sm_abs(x);
    case SMVM_floor: return sm_floor(x);
    case SMVM_ceil: return sm_ceil(x);
    case SMVM_trunc: return sm_trunc(x);
    case SMVM_round: return sm_round(x);
    case SMVM_sqrt: return sm_sqrt(x);
    case SMVM_sign: return sm_sign(x);
    case SMVM_truth: return number(sm_to_bool(x));
    case SMVM_not: return number(!sm_to_bool(x));
    default: return x;                                // mov
    }
}

static SmF64 of_two(uint8_t op, SmF64 x, SmF64 y)
{
    switch (op) {
    case SMVM_add: return sm_add(x, y);
    case SMVM_sub: return sm_sub(x, y);
    case SMVM_mul: return sm_mul(x, y);
    case SMVM_div: return sm_div(x, y);
    case SMVM_min: return sm_min(x, y);
    case SMVM_max: return sm_max(x, y);
    case SMVM_eq: return number(sm_eq(x, y));
    case SMVM_ne: return number(!sm_eq(x, y));
    case SMVM_lt: return number(sm_lt(x, y));
    case SMVM_le: return number(sm_le(x, y));
    case SMVM_and: return number(sm_to_bool(x) && sm_to_bool(y));
    default: return number(sm_to_bool(x) || sm_to_bool(y));
    }
}

static bool holds(uint8_t op, SmF64 x, SmF64 y)       // the condition of a jump on two operands
{
    switch (op) {
    case SMVM_jeq: return sm_eq(x, y);
    case SMVM_jne: return !sm_eq(x, y);
    case SMVM_jlt: return sm_lt(x, y);
    case SMVM_jnlt: return !sm_lt(x, y);
    case SMVM_jle: return sm_le(x, y);
    default: return !sm_le(x, y);
    }
}

static void jump_if(Run *r, bool condition)
{
    uint32_t distance = next(r);

    if (condition)
        r->at += distance;
}

void smvm_sample(uint64_t *w, uint32_t n, uint32_t kind, SmF64 x) { sm_roll_sample(w, n, kind, x); }
SmF64 smvm_statistic(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat) { return sm_roll_stat(w, n, kind, stat); }

static void push(const Run *r, uint32_t w, SmF64 x)
{
    uint32_t entry = smvm_window(r->m.image, r->m.windows_at, w);

    smvm_sample(r->parts.window[w], entry & SMVM_WINDOW_SIZE_MASK, entry >> SMVM_WINDOW_SIZE_BITS, x);
}

static SmF64 statistic(const Run *r, uint32_t w, SmStat stat)
{
    uint32_t entry = smvm_window(r->m.image, r->m.windows_at, w);

    return smvm_statistic(r->parts.window[w], entry & SMVM_WINDOW_SIZE_MASK, entry >> SMVM_WINDOW_SIZE_BITS, stat);
}

static void window(Run *r, uint8_t op)
{
    uint32_t a = next(r);

    if (op == SMVM_sample)
        push(r, a, get(r));
    else
        put(r, a, statistic(r, next(r), (SmStat)(op - SMVM_avg)));
}

static void compute(Run *r, uint8_t op)
{
    uint32_t d = next(r);
    SmF64 x = get(r);

    put(r, d, op < SMVM_add ? of_one(op, x) : of_two(op, x, get(r)));
}

static void jump(Run *r, uint8_t op)
{
    SmF64 x = get(r);

    if (op < SMVM_jeq)
        jump_if(r, sm_to_bool(x) == (op == SMVM_jt));
    else {
        SmF64 y = get(r);
        jump_if(r, holds(op, x, y));
    }
}

// Runs a function; gives the state that it goes to, or 0.
static uint32_t run(Run *r, uint32_t function)
{
    uint32_t start = function == 0 ? 0 : smvm_function_end(&r->m, function - 1);

    if (start == smvm_function_end(&r->m, function))
        return 0;
    r->at = r->m.code_at + start;
    for (;;) {
        uint8_t op = smvm_u8(r->m.image, r->at++);
        if (op >= SMVM_avg)
            window(r, op);
        else if (op >= SMVM_mov)
            compute(r, op);
        else if (op > SMVM_jmp)
            jump(r, op);
        else if (op == SMVM_jmp)
            jump_if(r, true);
        else
            return op == SMVM_goto ? next(r) : 0;
    }
}

// ---- the step ----

static uint8_t *element(const Run *r, uint32_t operand) { return r->sv + smvm_operand(&r->m, operand).offset; }

static void clear_stored(Run *r)
{
    memset(r->vm->stored, 0, sizeof r->vm->stored);
    memset(r->parts.stored, 0, (size_t)r->parts.stored_bytes);
}

SmResult smvm_step(SmVm *vm, void *sv)
{
    uint32_t block = 3 * (uint32_t)vm->state - 2, to = 0;      // the functions of the state: entry, step, exit
    Run r;

    memset(&r, 0, sizeof r);
    r.vm = vm;
    r.sv = (uint8_t *)sv;
    smvm_again(vm, &r.m);
    r.parts = smvm_parts(vm, &r.m);
    if (!smvm_begin(vm, element(&r, r.m.outputs), element(&r, r.m.outputs + 1)))
        return SM_REFUSED;
    clear_stored(&r);
    run(&r, 0);
    if (vm->first)
        to = run(&r, block);
    if (to == 0)
        to = run(&r, block + 1);
    if (to != 0) {
        run(&r, block + 2);
        vm->state = (SmvmAt)to;
    }
    vm->first = to != 0;
    return SM_OK;
}
