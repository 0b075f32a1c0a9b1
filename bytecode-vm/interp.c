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
    SmvmBytes image;
    const SmvmTables *t;
    SmvmAt at, entry, payload;                     // in the code; of the operand that was looked up last
    union { uint64_t cell; SmF64 number; } acc;    // the accumulator, as it would lie in memory
} Run;

SMVM_APART static SmvmAt long_next(Run *r, uint8_t first)        // a varint of two or four bytes
{
    uint32_t b = first;

    if (b < SMVM_VARINT_2)
        return (SmvmAt)(SMVM_VARINT_1 + ((b - SMVM_VARINT_1) << 7 | smvm_u8(r->image, r->at++)));
    b -= SMVM_VARINT_2;
    for (uint8_t i = 0; i < 3; i++)
        b = b << 7 | smvm_u8(r->image, r->at++);
    return (SmvmAt)(SMVM_VARINT_MID + b);
}

// The next varint: it numbers or measures something in this image, so an SmvmAt holds it.
static SmvmAt next(Run *r)
{
    uint8_t b = smvm_u8(r->image, r->at++);

    return b < SMVM_VARINT_1 ? b : long_next(r, b);
}

// ---- operands ----

// Finds an entry of the table of operands; gives its kind.  The payload is whole where it says where something lies in memory or in a
// table; integer() looks again.
static uint8_t look_up(Run *r, SmvmAt index)
{
    SmvmAt at = (SmvmAt)(r->t->operands + index + index + index);
    uint8_t low = smvm_u8(r->image, at), mid = smvm_u8(r->image, at + 1), high = smvm_u8(r->image, at + 2);

    r->entry = at;
    r->payload = (SmvmAt)((SmvmAt)(mid | (SmvmAt)high << 8) << (8 - SMVM_KIND_BITS) | (SmvmAt)(low >> SMVM_KIND_BITS));
    return low & ((1u << SMVM_KIND_BITS) - 1u);
}

static SmF64 integer(const Run *r)                    // its payload again, with its sign
{
    SmvmAt at = r->entry;
    int32_t v = smvm_u8(r->image, at + 1) | (int32_t)smvm_u8(r->image, at + 2) << 8;

    if (v > SMVM_INT_MOST >> (8 - SMVM_KIND_BITS))
        v -= SMVM_PAYLOADS >> (8 - SMVM_KIND_BITS);
    return sm_from_i32(v * (1 << (8 - SMVM_KIND_BITS)) + (smvm_u8(r->image, at) >> SMVM_KIND_BITS));
}

SMVM_APART static SmF64 constant(const Run *r, uint8_t kind)
{
    switch (kind) {
    case SMVM_K_TIME: return sm_from_u64(r->vm->next - r->vm->start);
    case SMVM_K_F32: return sm_from_f32(sm_f32_from_bits(smvm_uint(r->image, r->t->f32s + (SmvmAt)(4 * r->payload), 4)));
    default: return sm_from_bits(smvm_cell(r->image, r->t->f64s + (SmvmAt)(8 * r->payload), 8));
    }
}

static uint8_t *placed(uint8_t *base, uint8_t type, SmvmAt at) { return base + (SmvmAt)(at << smvm_type_shift(type)); }
static uint8_t *locals(const Run *r) { return (uint8_t *)r->vm + r->vm->local; }
static SmF64 *temp(const Run *r, SmvmAt at) { return (SmF64 *)(void *)((uint8_t *)r->vm + r->t->temps) + at; }

static SmF64 get(Run *r)
{
    uint8_t kind = look_up(r, next(r));

    if (kind < SMVM_K_LOCAL)
        return sm_load((SmType)kind, placed(r->sv, kind, r->payload));
    if (kind == SMVM_K_TEMP)
        return *temp(r, r->payload);
    if (kind == SMVM_K_ACC)
        return r->payload == SMVM_RAW ? r->acc.number : sm_load((SmType)r->payload, &r->acc);
    if (kind > SMVM_K_TEMP)
        return kind == SMVM_K_INT ? integer(r) : constant(r, kind);
    kind = (uint8_t)(kind - SMVM_K_LOCAL);
    return sm_load((SmType)kind, placed(locals(r), kind, r->payload));
}

static void note(Run *r, SmvmAt output)               // that it is written
{
    uint8_t *bits = r->vm->stored;

    if (output >= 64) {
        bits = (uint8_t *)r->vm + r->t->more;
        output = (SmvmAt)(output - 64);
    }
    bits[output >> 3] = (uint8_t)(bits[output >> 3] | 1u << (output & 7u));
}

static void put(Run *r, SmvmAt index, SmF64 x)
{
    uint8_t kind = look_up(r, index);

    if (kind < SMVM_K_LOCAL) {
        note(r, index);
        sm_store((SmType)kind, placed(r->sv, kind, r->payload), x);
    } else if (kind == SMVM_K_TEMP)
        *temp(r, r->payload) = x;
    else if (kind != SMVM_K_ACC) {
        kind = (uint8_t)(kind - SMVM_K_LOCAL);
        sm_store((SmType)kind, placed(locals(r), kind, r->payload), x);
    } else if (r->payload == SMVM_RAW)
        r->acc.number = x;
    else
        sm_store((SmType)r->payload, &r->acc, x);
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

// The condition of a jump on two operands; its opposite has the number behind it.
static bool holds(uint8_t op, SmF64 x, SmF64 y)
{
    const bool opposite = ((op - SMVM_jeq) & 1) != 0;

    if (op < SMVM_jlt)
        return sm_eq(x, y) != opposite;
    return (op < SMVM_jle ? sm_lt(x, y) : sm_le(x, y)) != opposite;
}

static void jump_if(Run *r, bool condition)
{
    SmvmAt distance = next(r);

    if (condition)
        r->at = (SmvmAt)(r->at + distance);
}

void smvm_sample(uint64_t *w, uint32_t n, uint32_t kind, SmF64 x) { sm_roll_sample(w, n, kind, x); }
SmF64 smvm_statistic(const uint64_t *w, uint32_t n, uint32_t kind, SmStat stat) { return sm_roll_stat(w, n, kind, stat); }

static uint64_t *words_of(const Run *r, SmvmAt w) { return smvm_windows_of(r->vm)[w]; }

static void push(const Run *r, SmvmAt w, SmF64 x)
{
    uint32_t entry = smvm_window(r->image, r->t->windows, w);

    smvm_sample(words_of(r, w), entry & SMVM_WINDOW_SIZE_MASK, entry >> SMVM_WINDOW_SIZE_BITS, x);
}

static SmF64 statistic(const Run *r, SmvmAt w, SmStat stat)
{
    uint32_t entry = smvm_window(r->image, r->t->windows, w);

    return smvm_statistic(words_of(r, w), entry & SMVM_WINDOW_SIZE_MASK, entry >> SMVM_WINDOW_SIZE_BITS, stat);
}

static void window(Run *r, uint8_t op)
{
    SmvmAt a = next(r);

    if (op == SMVM_sample)
        push(r, a, get(r));
    else
        put(r, a, statistic(r, next(r), (SmStat)(op - SMVM_avg)));
}

static void compute(Run *r, uint8_t op)
{
    SmvmAt d = next(r);
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

// Where function `index` ends (image.h).
static SmvmAt end_of(const Run *r, SmvmAt index)
{
    SmvmAt at = (SmvmAt)(r->t->functions + index), end;

    for (uint8_t i = 1; i < r->t->width; i++)
        at = (SmvmAt)(at + index);
    end = smvm_u8(r->image, at);
    for (uint8_t i = 1; i < r->t->width; i++)
        end = (SmvmAt)(end + ((SmvmAt)smvm_u8(r->image, at + i) << 8 * i));
    return end;
}

// Runs a function; gives the state that it goes to, or 0.
static SmvmAt run(Run *r, SmvmAt function)
{
    SmvmAt start = function == 0 ? 0 : end_of(r, (SmvmAt)(function - 1));

    if (start == end_of(r, function))
        return 0;
    r->at = (SmvmAt)(r->vm->code + start);
    for (;;) {
        uint8_t op = smvm_u8(r->image, r->at++);
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

static void clear_stored(Run *r)
{
    memset(r->vm->stored, 0, sizeof r->vm->stored);
    if (r->t->more_bytes != 0)
        memset((uint8_t *)r->vm + r->t->more, 0, r->t->more_bytes);
}

static SmResult one_step(Run *r)
{
    SmVm *vm = r->vm;
    SmvmAt block = (SmvmAt)(3 * vm->state - 2), to = 0;        // the functions of the state: entry, step, exit

    if (!smvm_begin(vm, r->sv + r->t->g, r->sv + r->t->s))
        return SM_REFUSED;
    clear_stored(r);
    run(r, 0);
    if (vm->first)
        to = run(r, block);
    if (to == 0)
        to = run(r, (SmvmAt)(block + 1));
    if (to != 0) {
        run(r, (SmvmAt)(block + 2));
        vm->state = to;
    }
    vm->first = to != 0;
    return SM_OK;
}

SmResult smvm_step(SmVm *vm, void *sv)
{
    Run r;
#if SMVM_KEEP_TABLES
    r.t = &vm->tables;
#else
    SmvmTables tables;
    SmvmMachine m;

    smvm_again(vm, &m);
    smvm_tables(&m, vm, &tables);
    r.t = &tables;
#endif
    r.vm = vm;
    r.sv = (uint8_t *)sv;
    r.image = vm->image;
    r.at = 0;
    r.acc.cell = 0;
    return one_step(&r);
}
