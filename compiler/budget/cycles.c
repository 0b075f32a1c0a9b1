// SPDX-License-Identifier: Apache-2.0
// Tracks what the registers X and Y (opcodes.def) contain, in the order of the image.  The target of a jump always reloads X before it
// reads it, so what X contains on the path of the jump does not matter.
#include "compiler/budget/cycles.h"

#include "bytecode-vm/smvm.h"

static const uint32_t row_cycles[CYCLES_ROWS][4] = {
#define CYCLES_ROW(name, ...) {__VA_ARGS__},
#define CYCLES_WINDOW(name, ...)
#define CYCLES_STACK(bytes, with_calls)
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
};
static const uint16_t window_cycles[CYCLES_WINDOW_ROWS][2 * CYCLES_SAMPLE_KINDS] = {
#define CYCLES_ROW(name, ...)
#define CYCLES_WINDOW(name, ...) {__VA_ARGS__},
#define CYCLES_STACK(bytes, with_calls)
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
};

// Returns the bytes of stack that a step uses: the largest measured value.  `calls`: the step calls elementary functions.
uint32_t cycles_stack_bytes(bool calls)
{
    return 0
#define CYCLES_ROW(name, ...)
#define CYCLES_WINDOW(name, ...)
#define CYCLES_STACK(bytes, with_calls) + (calls ? (with_calls) : (bytes))
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
        ;
}

uint32_t cycles_in_row(CyclesChip chip, CyclesRow row, bool whole) { return row_cycles[row][2 * chip + !whole]; }

// Returns the cycles of a window operation, from the table: a fixed part, and one for each of the `slots` samples. type: of the samples.
uint32_t cycles_of_window_row(CyclesWindow row, uint8_t type, uint32_t slots)
{
    const unsigned key = type == SM_F32 ? 4 : type == SM_F64 ? 5 : smvm_type_shift(type);

    return window_cycles[row][2 * key] + window_cycles[row][2 * key + 1] * slots;
}

// ---- contents of registers ----

static const CyclesReg any_value = {false, true, UINT32_MAX};

// Describes a register that contains a whole number of magnitude `most` or less. If that needs more than 32 bits, the result is any_value (unknown).
static CyclesReg reg_of_whole(bool is_signed, uint64_t most)
{
    const CyclesReg r = {true, is_signed, (uint32_t)most};

    return most <= INT32_MAX + (uint64_t)is_signed ? r : any_value;
}

// Describes a register after a load from a variable of this type.
static CyclesReg reg_of_type(uint8_t type)
{
    switch (type) {
    case SM_I8: case SM_I16: case SM_I32: return reg_of_whole(true, UINT32_C(1) << ((8u << smvm_type_shift(type)) - 1));
    case SM_U8: return reg_of_whole(false, UINT8_MAX);
    case SM_U16: return reg_of_whole(false, UINT16_MAX);
    case SM_BOOL: return reg_of_whole(false, 1);
    default: return any_value;
    }
}

// Describes register X after an operation on X and Y. If a whole result may need more than 32 bits, the result is any_value (unknown).
static CyclesReg reg_of_binary(uint8_t op, const CyclesReg *x, const CyclesReg *y)
{
    const uint64_t most = x->most > y->most ? x->most : y->most;
    const bool is_signed = x->signed_ || y->signed_;

    if (op == SMVM_and || op == SMVM_or)
        return reg_of_whole(false, 1);
    if (!x->whole || !y->whole)
        return any_value;
    switch (op) {
    case SMVM_add: return reg_of_whole(is_signed, (uint64_t)x->most + y->most + is_signed);
    case SMVM_sub: return reg_of_whole(true, (uint64_t)x->most + y->most + 1);
    case SMVM_mul: return !is_signed && most <= INT16_MAX ? reg_of_whole(false, (uint64_t)x->most * y->most) : any_value;
    case SMVM_min: case SMVM_max: return reg_of_whole(is_signed, most);
    default: return any_value;
    }
}

// Describes register X after an operation on X alone.
static CyclesReg reg_of_unary(uint8_t op, const CyclesReg *x)
{
    if (!x->whole || op == SMVM_neg || op == SMVM_sqrt || x->most > INT32_MAX)
        return any_value;
    return op == SMVM_abs ? reg_of_whole(false, x->most) : op == SMVM_sign ? reg_of_whole(x->signed_, 1) : *x;
}

// ---- instructions ----

// Opcodes that load Y differ by this bit from those that load X.  The low four bits of loads and stores are a type (opcodes.def).
enum { OPCODE_LOADS_Y = SMVM_ldy_local - SMVM_ldx_local, OPCODE_TYPE = 0xf };

// Prepares c for the first instruction.  Returns the cost, in cycles, of a step besides the functions that it runs.
uint32_t cycles_begin(Cycles *c, CyclesChip chip, const SmvmMachine *m)
{
    c->chip = chip;
    c->m = m;
    c->x = c->y = any_value;
    // the row `step` covers 64 outputs; the row `more` is the cost of each further eight or part of eight
    return cycles_in_row(chip, CYCLES_step, true) + (m->outputs > 64 ? (m->outputs - 57) / 8 * cycles_in_row(chip, CYCLES_more, true) : 0);
}

static uint32_t row_cost(const Cycles *c, CyclesRow r, bool is_whole) { return cycles_in_row(c->chip, r, is_whole); }

// Returns the cost of an instruction on this window: the row `plain`, or `sorted` if the window has a median.
static uint32_t cycles_of_window(const Cycles *c, uint32_t window, CyclesWindow plain, CyclesWindow sorted)
{
    const uint32_t entry = smvm_window(c->m->image, c->m->windows_at, (SmvmAt)window), kind = entry >> SMVM_WINDOW_SIZE_BITS;
    const bool has_median = (kind & SM_ROLL_MEDIAN) != 0;

    return cycles_of_window_row(has_median ? sorted : plain, (uint8_t)(kind & SM_ROLL_TYPE), entry & SMVM_WINDOW_SIZE_MASK);
}

// Whether a window stores times of changes, not samples.
static bool stores_times(const Cycles *c, uint32_t window)
{
    return (smvm_window(c->m->image, c->m->windows_at, (SmvmAt)window) >> SMVM_WINDOW_SIZE_BITS & SM_ROLL_TYPE) == SM_ROLL_TIMES;
}

// Returns the cycles of reading a statistic of a window.
static uint32_t cycles_of_statistic(const Cycles *c, uint32_t stat, uint32_t window)
{
    switch (stat) {
    case SM_STAT_ELAPSED: case SM_STAT_RUN_STEPS: case SM_STAT_RUN_TIME: return row_cost(c, CYCLES_times, true);
    case SM_STAT_OLDEST: case SM_STAT_NEWEST: case SM_STAT_CHANGE: return row_cost(c, CYCLES_change, true);
    case SM_STAT_AVG: return cycles_of_window(c, window, CYCLES_avg, CYCLES_avg);
    case SM_STAT_MEDIAN: return cycles_of_window(c, window, CYCLES_median, CYCLES_median);
    case SM_STAT_RANGE: return cycles_of_window(c, window, CYCLES_range, CYCLES_range_sorted);
    default: return cycles_of_window(c, window, CYCLES_extreme, CYCLES_extreme_sorted);
    }
}

// Returns the cycles of a load.  `number`: its operands.
static uint32_t cycles_of_load(Cycles *c, uint8_t op, const uint32_t *number)
{
    CyclesReg *to = op & OPCODE_LOADS_Y ? &c->y : &c->x;
    const uint8_t type = op & OPCODE_TYPE;

    *to = type <= SMVM_RAW ? reg_of_type(type) : any_value;
    switch (op & (uint8_t)~OPCODE_LOADS_Y) {
    case SMVM_ldx_plus: *to = reg_of_whole(false, number[0]); return row_cost(c, CYCLES_number, true);
    case SMVM_ldx_minus: *to = reg_of_whole(true, number[0] + UINT64_C(1)); return row_cost(c, CYCLES_number, true);
    case SMVM_ldx_f32: return row_cost(c, CYCLES_f32, false);
    case SMVM_ldx_f64: return row_cost(c, CYCLES_f64, false);
    case SMVM_ldx_time: return row_cost(c, CYCLES_time, false);
    default: return row_cost(c, (CyclesRow)(CYCLES_load_I8 + type), false);
    }
}

static uint32_t cycles_of_store(Cycles *c, uint8_t type) { return row_cost(c, (CyclesRow)(CYCLES_store_I8 + type), c->x.whole); }

// Returns the cycles of an operation on the registers, and sets c->x to what X then contains.
static uint32_t cycles_of_operation(Cycles *c, uint8_t op)
{
    const bool is_binary = op < SMVM_neg;              // opcodes from SMVM_neg on have the operand X alone
    const bool is_logic = op == SMVM_and || op == SMVM_or, whole_before = c->x.whole && (!is_binary || c->y.whole);

    c->x = is_binary ? reg_of_binary(op, &c->x, &c->y) : reg_of_unary(op, &c->x);
    return row_cost(c, (CyclesRow)(CYCLES_add + op - SMVM_add), is_logic ? whole_before : c->x.whole);
}

// Returns the cycles of a jump that is taken.  `number`: its operands.
static uint32_t cycles_of_jump(const Cycles *c, uint8_t op, const uint32_t *number)
{
    if (op == SMVM_jmp || op == SMVM_jf || op == SMVM_jt)
        return row_cost(c, op == SMVM_jmp ? CYCLES_jmp : op == SMVM_jf ? CYCLES_jf : CYCLES_jt, c->x.whole);
    if (op < SMVM_jmp)                                // a jxy: the cost is the same for all sets of relations
        return row_cost(c, CYCLES_jxy, c->x.whole && c->y.whole);
    if (number[0] > UINT16_MAX)
        return row_cost(c, CYCLES_jxn_wide, c->x.whole);
    return row_cost(c, number[0] >= SMVM_VARINT_MID ? CYCLES_jxn_4 : number[0] >= SMVM_VARINT_1 ? CYCLES_jxn_2 : CYCLES_jxn, c->x.whole);
}

// Returns the row of avr_cycles.def for the elementary function with number n.
static CyclesRow row_of_function(uint32_t n)
{
    static const uint8_t row[SMVM_FN_MAX] = {
#define SM_ELEMENTARY(name, arguments, number) [number] = CYCLES_##name,
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
    };

    return (CyclesRow)row[n % SMVM_FN_MAX];
}

// Returns the cycles of an instruction, without those of decoding operands of several bytes.
static uint32_t cycles_of_opcode(Cycles *c, uint8_t op, const uint32_t *number)
{
    const CyclesReg constant = reg_of_whole(false, number[0]);
    uint32_t cycles;

    if (op >= SMVM_add)
        return cycles_of_operation(c, op);
    if (op >= SMVM_jxy)
        return cycles_of_jump(c, op, number);
    switch (op) {
    case SMVM_stat: c->x = any_value; return cycles_of_statistic(c, number[0], number[1]);
    case SMVM_addi: case SMVM_subi:
        c->x = reg_of_binary(op == SMVM_addi ? SMVM_add : SMVM_sub, &c->x, &constant);
        return row_cost(c, CYCLES_addi, c->x.whole);
    case SMVM_fn: c->x = c->y = any_value; return row_cost(c, row_of_function(number[0]), false);
    case SMVM_cvt: cycles = row_cost(c, CYCLES_cvt, c->x.whole); c->x = reg_of_type((uint8_t)number[0]); return cycles;
    case SMVM_set: cycles = row_cost(c, CYCLES_set, c->x.whole && c->y.whole); c->x = reg_of_whole(false, 1); return cycles;
    case SMVM_out:
        return row_cost(c, number[0] < 64 ? CYCLES_out : CYCLES_out_far, c->x.whole)
             + cycles_of_store(c, (uint8_t)smvm_output(c->m, (SmvmAt)number[0]).type);
    case SMVM_goto: return row_cost(c, CYCLES_end, true) + row_cost(c, CYCLES_goto, true);
    case SMVM_end: return row_cost(c, CYCLES_end, true);
    case SMVM_sample: return stores_times(c, number[0])
                             ? row_cost(c, CYCLES_event, true) : cycles_of_window(c, number[0], CYCLES_sample, CYCLES_sample_sorted);
    default: return op >= SMVM_st_local ? cycles_of_store(c, op & OPCODE_TYPE) : cycles_of_load(c, op, number);
    }
}

// Returns the cycles of the next instruction in the order of the image, and updates the registers.  `number`: its operands.
uint32_t cycles_of_ins(Cycles *c, uint8_t op, const uint32_t number[2], unsigned numbers)
{
    const bool compares = op >= SMVM_jxn && op < SMVM_jt;          // jxn: the size of its first number selects its row
    uint32_t cycles = cycles_of_opcode(c, op, number);

    for (unsigned i = compares; i < numbers; i++)
        if (number[i] >= SMVM_VARINT_MID)
            cycles += row_cost(c, CYCLES_varint_4, true);
        else if (number[i] >= SMVM_VARINT_1)
            cycles += row_cost(c, CYCLES_varint_2, true);
    return cycles;
}
