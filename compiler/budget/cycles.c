// SPDX-License-Identifier: Apache-2.0
// Tracks what X and Y contain from one instruction to the next.  The target of a jump always reloads X, so nothing has to be
// known about other paths (opcodes.def).
#include "compiler/budget/cycles.h"

#include "bytecode-vm/smvm.h"

static const uint16_t row_cycles[CYCLES_ROWS][4] = {
#define CYCLES_ROW(name, ...) {__VA_ARGS__},
#define CYCLES_WINDOW(name, ...)
#define CYCLES_STACK(bytes)
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
};
static const uint16_t window_cycles[CYCLES_WINDOW_ROWS][2 * CYCLES_KEYS] = {
#define CYCLES_ROW(name, ...)
#define CYCLES_WINDOW(name, ...) {__VA_ARGS__},
#define CYCLES_STACK(bytes)
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
};

uint32_t cycles_stack(void)
{
    return 0
#define CYCLES_ROW(name, ...)
#define CYCLES_WINDOW(name, ...)
#define CYCLES_STACK(bytes) + (bytes)
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
        ;
}

uint32_t cycles_row(CyclesChip chip, CyclesRow row, bool whole) { return row_cycles[row][2 * chip + !whole]; }

uint32_t cycles_window(CyclesWindow row, uint8_t type, uint32_t slots)
{
    const unsigned key = type == SM_F32 ? 4 : type == SM_F64 ? 5 : smvm_type_shift(type);

    return window_cycles[row][2 * key] + window_cycles[row][2 * key + 1] * slots;
}

// ---- contents of registers ----

static const CyclesReg any = {false, true, UINT32_MAX};

static CyclesReg whole(bool is_signed, uint64_t most)         // unknown if it has more than 32 bits
{
    const CyclesReg r = {true, is_signed, (uint32_t)most};

    return most <= INT32_MAX + (uint64_t)is_signed ? r : any;
}

static CyclesReg of_type(uint8_t type)
{
    switch (type) {
    case SM_I8: case SM_I16: case SM_I32: return whole(true, UINT32_C(1) << ((8u << smvm_type_shift(type)) - 1));
    case SM_U8: return whole(false, UINT8_MAX);
    case SM_U16: return whole(false, UINT16_MAX);
    case SM_BOOL: return whole(false, 1);
    default: return any;
    }
}

// The result of X and another number; unknown if it does not fit.
static CyclesReg of_two(uint8_t op, const CyclesReg *x, const CyclesReg *y)
{
    const uint64_t most = x->most > y->most ? x->most : y->most;
    const bool is_signed = x->signed_ || y->signed_;

    if (op == SMVM_and || op == SMVM_or)
        return whole(false, 1);
    if (!x->whole || !y->whole)
        return any;
    switch (op) {
    case SMVM_add: return whole(is_signed, (uint64_t)x->most + y->most + is_signed);
    case SMVM_sub: return whole(true, (uint64_t)x->most + y->most + 1);
    case SMVM_mul: return !is_signed && most <= INT16_MAX ? whole(false, (uint64_t)x->most * y->most) : any;
    case SMVM_min: case SMVM_max: return whole(is_signed, most);
    default: return any;
    }
}

static CyclesReg of_one(uint8_t op, const CyclesReg *x)
{
    if (!x->whole || op == SMVM_neg || op == SMVM_sqrt || x->most > INT32_MAX)
        return any;
    return op == SMVM_abs ? whole(false, x->most) : op == SMVM_sign ? whole(x->signed_, 1) : *x;
}

// ---- instructions ----

uint32_t cycles_begin(Cycles *c, CyclesChip chip, const SmvmMachine *m)
{
    c->chip = chip;
    c->m = m;
    c->x = c->y = any;
    return cycles_row(chip, CYCLES_step, true) + (m->outputs > 64 ? (m->outputs - 57) / 8 * cycles_row(chip, CYCLES_more, true) : 0);
}

static uint32_t row(const Cycles *c, CyclesRow r, bool is_whole) { return cycles_row(c->chip, r, is_whole); }

static uint32_t window_of(const Cycles *c, uint32_t window, CyclesWindow plain, CyclesWindow sorted)
{
    const uint32_t entry = smvm_window(c->m->image, c->m->windows_at, (SmvmAt)window), kind = entry >> SMVM_WINDOW_SIZE_BITS;
    const bool has_median = kind >> 4 >> SM_STAT_MEDIAN & 1u;

    return cycles_window(has_median ? sorted : plain, (uint8_t)(kind & SM_ROLL_TYPE), entry & SMVM_WINDOW_SIZE_MASK);
}

static uint32_t statistic(const Cycles *c, uint32_t stat, uint32_t window)
{
    switch (stat) {
    case SM_STAT_AVG: return window_of(c, window, CYCLES_avg, CYCLES_avg);
    case SM_STAT_MEDIAN: return window_of(c, window, CYCLES_median, CYCLES_median);
    case SM_STAT_RANGE: return window_of(c, window, CYCLES_range, CYCLES_range_sorted);
    default: return window_of(c, window, CYCLES_extreme, CYCLES_extreme_sorted);
    }
}

static uint32_t load(Cycles *c, uint8_t op, const uint32_t *number)
{
    CyclesReg *to = op & 0x20 ? &c->y : &c->x;
    const uint8_t type = op & 0xf;

    *to = type <= SMVM_RAW ? of_type(type) : any;
    switch (op & (uint8_t)~0x20) {
    case SMVM_ldx_plus: *to = whole(false, number[0]); return row(c, CYCLES_number, true);
    case SMVM_ldx_minus: *to = whole(true, number[0] + UINT64_C(1)); return row(c, CYCLES_number, true);
    case SMVM_ldx_f32: return row(c, CYCLES_f32, false);
    case SMVM_ldx_f64: return row(c, CYCLES_f64, false);
    case SMVM_ldx_time: return row(c, CYCLES_time, false);
    default: return row(c, (CyclesRow)(CYCLES_load_I8 + type), false);
    }
}

static uint32_t store(Cycles *c, uint8_t type) { return row(c, (CyclesRow)(CYCLES_store_I8 + type), c->x.whole); }

static uint32_t output(Cycles *c, uint32_t n)
{
    return row(c, n < 64 ? CYCLES_out : CYCLES_out_far, c->x.whole) + store(c, (uint8_t)smvm_output(c->m, (SmvmAt)n).type);
}

static uint32_t add_number(Cycles *c, uint8_t op, uint32_t n)
{
    const CyclesReg y = whole(false, n);

    c->x = of_two(op == SMVM_addi ? SMVM_add : SMVM_sub, &c->x, &y);
    return row(c, CYCLES_addi, c->x.whole);
}

static uint32_t compute(Cycles *c, uint8_t op)
{
    const bool two = op < SMVM_neg, truth = op == SMVM_and || op == SMVM_or, whole_before = c->x.whole && (!two || c->y.whole);

    c->x = two ? of_two(op, &c->x, &c->y) : of_one(op, &c->x);
    return row(c, (CyclesRow)(CYCLES_add + op - SMVM_add), truth ? whole_before : c->x.whole);
}

static uint32_t jump(const Cycles *c, uint8_t op, const uint32_t *number)
{
    if (op == SMVM_jmp || op == SMVM_jf || op == SMVM_jt)
        return row(c, op == SMVM_jmp ? CYCLES_jmp : op == SMVM_jf ? CYCLES_jf : CYCLES_jt, c->x.whole);
    if (op < SMVM_jmp)
        return row(c, CYCLES_jxy, c->x.whole && c->y.whole);
    if (number[0] > UINT16_MAX)
        return row(c, CYCLES_jxn_wide, c->x.whole);
    return row(c, number[0] >= SMVM_VARINT_MID ? CYCLES_jxn_4 : number[0] >= SMVM_VARINT_1 ? CYCLES_jxn_2 : CYCLES_jxn, c->x.whole);
}

static uint32_t by_opcode(Cycles *c, uint8_t op, const uint32_t *number)
{
    uint32_t cycles;

    if (op >= SMVM_add)
        return compute(c, op);
    if (op >= SMVM_jxy)
        return jump(c, op, number);
    switch (op) {
    case SMVM_stat: c->x = any; return statistic(c, number[0], number[1]);
    case SMVM_addi: case SMVM_subi: return add_number(c, op, number[0]);
    case SMVM_cvt: cycles = row(c, CYCLES_cvt, c->x.whole); c->x = of_type((uint8_t)number[0]); return cycles;
    case SMVM_set: cycles = row(c, CYCLES_set, c->x.whole && c->y.whole); c->x = whole(false, 1); return cycles;
    case SMVM_out: return output(c, number[0]);
    case SMVM_goto: return row(c, CYCLES_end, true) + row(c, CYCLES_goto, true);
    case SMVM_end: return row(c, CYCLES_end, true);
    case SMVM_sample: return window_of(c, number[0], CYCLES_sample, CYCLES_sample_sorted);
    default: return op >= SMVM_st_local ? store(c, op & 0xf) : load(c, op, number);
    }
}

uint32_t cycles_of(Cycles *c, uint8_t op, const uint32_t number[2], unsigned numbers)
{
    const bool compares = op >= SMVM_jxn && op < SMVM_jt;          // their first number is part of their row
    uint32_t cycles = by_opcode(c, op, number);

    for (unsigned i = compares; i < numbers; i++)
        if (number[i] >= SMVM_VARINT_MID)
            cycles += row(c, CYCLES_varint_4, true);
        else if (number[i] >= SMVM_VARINT_1)
            cycles += row(c, CYCLES_varint_2, true);
    return cycles;
}
