// SPDX-License-Identifier: Apache-2.0
// Measures the cycles of each instruction on an emulated ATmega328P.  It compares a machine with the instruction to the same machine without it,
// on random and on special operands, and takes the maximum.  It makes no assumption about the implementation of the interpreter.
//   run_cycles ELF ELF OPERANDS SEED                the VM for images in flash and in EEPROM: prints the rows of avr_cycles.def
//   run_cycles ELF ELF OPERANDS SEED check          compares that table with measurements: never above it, never far below
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "compiler/budget/cycles.h"
#include "stdlib/convert.h"
#include "stdlib/roll.h"
#include "tests/avr/mailbox.h"
#include "tests/avr/sim.h"
#include "tests/unit/vm_build.h"

// Percent by which a measurement of few operands can be below a row that was measured with many.  A larger difference means that the row is out
// of date.
enum { FAR_BELOW = 40 };

// The state vector of every machine here: G, S, the operands that X, Y and typed loads read, and the destination of stores.
enum { AT_X = 16, AT_X_WHOLE = 24, AT_Y = 32, AT_Y_WHOLE = 40, AT_TYPED = 48, AT_OUT = 56, SV_WORDS = 8 };
enum { WHOLE, ANY };          // the values of X and Y; ANY: at least one is not a whole number of 32 bits

typedef struct Probe {
    Sim sim;
    VmBox *box;
    uint64_t seed, state, g;
    unsigned operands;
    uint64_t cycles[4000];    // cycles of the machine without the instruction, by operand
    uint32_t most;
} Probe;

typedef struct Seen { uint32_t stack, call_stack, row[CYCLES_ROWS][2], window[CYCLES_WINDOW_ROWS][CYCLES_SAMPLE_KINDS][2]; } Seen;

static uint64_t next(Probe *p)
{
    p->state ^= p->state >> 12;
    p->state ^= p->state << 25;
    p->state ^= p->state >> 27;
    return p->state * 0x2545F4914F6CDD1Du;
}

static void die(const char *what)
{
    fprintf(stderr, "run_cycles: %s\n", what);
    exit(1);
}

// ---- operands ----

// Returns a number as machines have them: near the last one, near a limit of a type, with few digits, subnormal, or any.
static uint64_t real(Probe *p)
{
    static const double special[] = {0, -0.0, 1, -1, 0.1, 3, 255, 256, 65535, 65536, 2147483647, -2147483648.0, 4294967295.0, 9007199254740993.0,
                                     1e300, 5e-324, 2.2e-308, 1e19, -129};
    const uint64_t r = next(p);
    SmF64 x = sm_from_bits(r);
    double d;

    switch (r >> 60) {
    case 0: case 1: d = special[r % (sizeof special / sizeof *special)]; memcpy(&x, &d, 8); break;
    case 2: x = sm_from_bits(r & 0x800FFFFFFFFFFFFFu); break;                                     // subnormal
    case 3: break;
    case 4: case 5: x = sm_from_i32((int32_t)r); break;
    case 6: case 7: x = sm_div(sm_from_i32((int32_t)(r % 200000)), sm_from_i32(100)); break;
    default: x = sm_from_bits((r & 0x801FFFFFFFFFFFFFu) | (uint64_t)(1023 - 8 + (r >> 53 & 31)) << 52);
    }
    return sm_is_nan(x) ? 0 : sm_bits(x);
}

// Returns a whole number of 32 bits.  `small`: the result of the operation on two of them is also such a number.
static int32_t whole(Probe *p, bool small, unsigned op)
{
    const uint64_t r = next(p);
    const int32_t x = r % 4 == 0 ? (int32_t)(r >> 32) : r % 4 == 1 ? (int32_t)(r >> 48) : (int32_t)(r >> 32 & 0x7F);

    return !small ? x : op == SMVM_mul ? x & 0x7FFF : x / 4;
}

static void write(Probe *p, SmType type, uint32_t offset, uint64_t cell) { sm_cell_store(type, sim_ram(&p->sim) + p->box->sv + offset, cell); }

// The samples of a window: any values; values that are slow to compare, as of sensors at rest; values that move every sample in a sorted window;
// or values whose sum cancels.
typedef enum Run { ANYTHING, ALIKE, RISING, FALLING, CANCELLING, RUNS } Run;

typedef struct Case {
    unsigned op, n, number[2];
    unsigned outputs;
    bool x_whole, y_whole;
    bool small;
    bool late;                // T is beyond 32 bits
    Run run;
    SmType type;              // of the window's samples
} Case;

// Returns sample i of a run.  Neighbours differ at most in their last byte.
static uint64_t in_run(const Case *c, unsigned i)
{
    const uint32_t k = c->run == RISING ? i % 27 : c->run == FALLING ? 26 - i % 27 : 0;
    const uint32_t single = 0x40490F00u + k;
    SmF64 x = sm_from_i32((int32_t)(100 + k));
    float f;

    memcpy(&f, &single, sizeof f);
    if (c->type == SM_F32)
        x = sm_from_f32(f);
    else if (c->type == SM_F64)
        x = sm_from_bits(0x400921FB54442D00u + k);
    return sm_bits(c->run == CANCELLING && i % 2 != 0 ? sm_neg(x) : x);
}

// Returns a number from -limit to limit that uses all 53 bits.
static uint64_t usual(Probe *p, int32_t limit)
{
    return sm_bits(sm_mul(sm_div(sm_from_i64((int64_t)next(p)), sm_from_bits(0x43E0000000000000u)), sm_from_i32(limit)));
}

static void write_operands(Probe *p, const Case *c, unsigned i)
{
    uint64_t x = real(p), y = next(p) % 4 == 0 ? x ^ (next(p) % 3 << 63) ^ next(p) % 4 : real(p), t = next(p) % 2 ? real(p) : next(p);

    if (c->op == SMVM_fn && i % 4 != 0) {             // arguments for which the function needs its full computation
        x = usual(p, c->number[0] == SMVM_FN_asin || c->number[0] == SMVM_FN_acos ? 1 : i % 4 == 1 ? 3 : 700);
        y = usual(p, 100);
        x = i % 8 == 1 ? x : x & 0x7FFFFFFFFFFFFFFFu;
    }
    write(p, SM_F64, AT_X, c->run == ANYTHING ? x : in_run(c, i));
    write(p, SM_F64, AT_Y, y);
    write(p, SM_I32, AT_X_WHOLE, (uint32_t)whole(p, c->small, c->op));
    write(p, SM_I32, AT_Y_WHOLE, (uint32_t)whole(p, c->small, c->op));
    write(p, SM_U64, AT_TYPED, t);
}

// ---- images ----

static Build blank(void)
{
    Build b;

    memset(&b, 0, sizeof b);
    b.sv_words = SV_WORDS;
    b.locals = 16;
    b.width = 2;
    b.s = 2;
    b.f32s = 1;
    b.f32[0] = 0x3dcccccdu;
    b.f64s = 1;
    b.f64[0] = 0x3fb999999999999au;
    b.outputs = 11;
    for (unsigned t = 0; t < 256; t++)                // again behind the 64th, for a machine that has so many
        b.output[t] = PLACE_OF(t % 64 % 11, AT_OUT >> smvm_type_shift(t % 64 % 11));
    end_function(&b);                                 // no samples
    return b;
}

static void load_operands(Build *b, bool x_whole, bool y_whole)
{
    typed(b, SMVM_ldx_elem, x_whole ? SM_I32 : SM_F64, x_whole ? AT_X_WHOLE : AT_X);
    typed(b, SMVM_ldy_elem, y_whole ? SM_I32 : SM_F64, y_whole ? AT_Y_WHOLE : AT_Y);
}

static void put_image(Probe *p, const Build *b)
{
    static uint8_t image[0x4000];

    memset(image, 0, sizeof image);
    if (build_image(b, image) > p->box->image_size)
        die("an image is too large");
    if (p->box->image < 0x8000)
        memcpy(sim_flash(&p->sim) + p->box->image, image, p->box->image_size);
    else
        sim_eeprom(&p->sim, image, p->box->image_size);
}

static void ask(Probe *p, uint8_t what)
{
    p->box->what = what;
    if (!sim_until_ready(&p->sim) || p->box->result != SM_OK)
        die(what == VM_INIT ? "a machine does not start" : "a step is refused");
}

static void start(Probe *p, uint8_t state, uint64_t g)
{
    p->box->begins = state;
    memset(sim_ram(&p->sim) + p->box->sv, 0, p->box->sv_size);
    ask(p, VM_INIT);
    p->g = g;
}

static uint32_t step(Probe *p)
{
    write(p, SM_U64, 0, p->g++);
    ask(p, VM_STEP);
    return (uint32_t)p->sim.cycles;
}

// ---- one instruction ----

static void put_state(Build *b, const Case *c, bool with)
{
    end_function(b);                                  // .entry
    load_operands(b, c->x_whole, c->y_whole);
    if (with)
        code(b, c->op, (int)c->n, c->number[0], c->number[1]);
    code(b, SMVM_end, 0);
    end_function(b);
    end_function(b);                                  // .exit
}

static void run_operands(Probe *p, const Case *c, uint8_t state, uint32_t *most)
{
    p->state = p->seed;                               // fewer operands are the first of more operands
    start(p, state, 0);
    step(p);
    if (c->late)
        p->g = UINT64_C(1) << 40;
    for (unsigned i = 0; i < p->operands; i++) {
        write_operands(p, c, i);
        if (state == 1)
            p->cycles[i] = step(p);
        else {
            const uint64_t cycles = step(p) - p->cycles[i];
            *most = *most > cycles ? *most : (uint32_t)cycles;
        }
    }
}

static uint32_t measure(Probe *p, const Case *c)
{
    Build b = blank();
    uint32_t most = 0;

    b.states = 2;
    b.outputs = c->outputs;
    put_state(&b, c, false);
    put_state(&b, c, true);
    put_image(p, &b);
    run_operands(p, c, 1, &most);
    run_operands(p, c, 2, &most);
    return most;
}

static uint32_t larger(uint32_t a, uint32_t b) { return a > b ? a : b; }
static void raise(uint32_t *most, uint32_t n) { *most = larger(*most, n); }

// Measures both columns of a row: with whole numbers as operands and result, and with any numbers.
static void measure_row(Probe *p, Seen *seen, CyclesRow row, Case c)
{
    for (unsigned kinds = 0; kinds < 4; kinds++) {
        c.x_whole = kinds % 2 == 0;
        c.y_whole = kinds < 2;
        raise(&seen->row[row][ANY], measure(p, &c));
    }
    c.x_whole = c.y_whole = c.small = true;
    raise(&seen->row[row][WHOLE], measure(p, &c));
    raise(&seen->row[row][ANY], seen->row[row][WHOLE]);
}

static void measure_op(Probe *p, Seen *seen, CyclesRow row, unsigned op, unsigned n, unsigned a, unsigned b)
{
    const Case c = {.op = op, .n = n, .number = {a, b}, .outputs = op == SMVM_out && a > 63 ? 128 : 11};

    measure_row(p, seen, row, c);
}

// ---- rows ----

static void measure_types(Probe *p, Seen *seen)
{
    for (unsigned t = 0; t <= SMVM_RAW; t++) {
        const CyclesRow load = (CyclesRow)(CYCLES_load_I8 + t), store = (CyclesRow)(CYCLES_store_I8 + t);
        const unsigned shift = t == SMVM_RAW ? 3 : smvm_type_shift(t);
        measure_op(p, seen, store, SMVM_st_local + t, 1, 8u >> shift, 0);
        measure_op(p, seen, load, SMVM_ldx_local + t, 1, 8u >> shift, 0);
        measure_op(p, seen, load, SMVM_ldy_local + t, 1, 8u >> shift, 0);
        if (t < SMVM_RAW) {
            measure_op(p, seen, load, SMVM_ldx_elem + t, 1, (unsigned)AT_TYPED >> shift, 0);
            measure_op(p, seen, load, SMVM_ldy_elem + t, 1, (unsigned)AT_TYPED >> shift, 0);
            measure_op(p, seen, CYCLES_cvt, SMVM_cvt, 1, t, 0);
        }
    }
}

// The cycles of a store to an output, minus those of a store to a local of its type.
static void measure_outputs(Probe *p, Seen *seen, CyclesRow row, unsigned first)
{
    Seen out;

    memset(&out, 0, sizeof out);
    for (unsigned t = 0; t < SMVM_RAW; t++) {
        const CyclesRow store = (CyclesRow)(CYCLES_store_I8 + t);
        measure_op(p, &out, store, SMVM_out, 1, first + t, 0);
        for (int kind = WHOLE; kind <= ANY; kind++)
            raise(&seen->row[row][kind], out.row[store][kind] > seen->row[store][kind] ? out.row[store][kind] - seen->row[store][kind] : 0);
    }
    raise(&seen->row[row][ANY], seen->row[row][WHOLE]);
}

static void measure_jumps(Probe *p, Seen *seen)
{
    static const unsigned near[] = {1, 2, 3, 17, 64, 90, 95}, middle[] = {96, 255, 256, 1000, 3167}, wide[] = {3168, 40000, 65535}, widest[] = {65536, 100000, 16000000};

    measure_op(p, seen, CYCLES_jmp, SMVM_jmp, 1, 0, 0);
    measure_op(p, seen, CYCLES_jf, SMVM_jf, 1, 0, 0);
    measure_op(p, seen, CYCLES_jt, SMVM_jt, 1, 0, 0);
    for (unsigned m = 2; m <= 5; m += 3) {            // equal; not
        measure_op(p, seen, CYCLES_set, SMVM_set, 1, m, 0);
        measure_op(p, seen, CYCLES_jxy, SMVM_jxy - 1 + m, 1, 0, 0);
        for (unsigned i = 0; i < sizeof near / sizeof *near; i++)
            measure_op(p, seen, CYCLES_jxn, SMVM_jxn - 1 + m, 2, near[i], 0);
        for (unsigned i = 0; i < sizeof middle / sizeof *middle; i++)
            measure_op(p, seen, CYCLES_jxn_2, SMVM_jxn - 1 + m, 2, middle[i], 0);
        for (unsigned i = 0; i < sizeof wide / sizeof *wide; i++)
            measure_op(p, seen, CYCLES_jxn_4, SMVM_jxn - 1 + m, 2, wide[i], 0);
        for (unsigned i = 0; i < sizeof widest / sizeof *widest; i++)
            measure_op(p, seen, CYCLES_jxn_wide, SMVM_jxn - 1 + m, 2, widest[i], 0);
    }
}

static void measure_others(Probe *p, Seen *seen)
{
    static const unsigned number[] = {0, 1, 95};
    const Case late = {.op = SMVM_ldx_time, .outputs = 11, .late = true}, late_y = {.op = SMVM_ldy_time, .outputs = 11, .late = true};

    for (unsigned i = 0; i < sizeof number / sizeof *number; i++) {
        for (unsigned y = 0; y <= 0x20; y += 0x20) {
            measure_op(p, seen, CYCLES_number, SMVM_ldx_plus + y, 1, number[i], 0);
            measure_op(p, seen, CYCLES_number, SMVM_ldx_minus + y, 1, number[i], 0);
        }
        measure_op(p, seen, CYCLES_addi, SMVM_addi, 1, number[i], 0);
        measure_op(p, seen, CYCLES_addi, SMVM_subi, 1, number[i], 0);
    }
    for (unsigned y = 0; y <= 0x20; y += 0x20) {
        measure_op(p, seen, CYCLES_f32, SMVM_ldx_f32 + y, 1, 0, 0);
        measure_op(p, seen, CYCLES_f64, SMVM_ldx_f64 + y, 1, 0, 0);
    }
    measure_row(p, seen, CYCLES_time, late);
    measure_row(p, seen, CYCLES_time, late_y);
    for (unsigned op = SMVM_add; op <= SMVM_sign; op++)
        measure_op(p, seen, (CyclesRow)(CYCLES_add + op - SMVM_add), op, 0, 0, 0);
}

// The calls of elementary functions, whose rows are in the order of stdlib/elementary.def.
static void measure_calls(Probe *p, Seen *seen)
{
    static const unsigned number[] = {
#define SM_ELEMENTARY(name, arguments, number) number,
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
    };

    for (unsigned i = 0; i < sizeof number / sizeof *number; i++)
        measure_op(p, seen, (CyclesRow)(CYCLES_exp + i), SMVM_fn, 1, number[i], 0);
}

// A varint of two or four bytes instead of one.
static void measure_varints(Probe *p, Seen *seen)
{
    Seen s;

    memset(&s, 0, sizeof s);
    measure_op(p, &s, CYCLES_number, SMVM_ldx_plus, 1, 5, 0);
    measure_op(p, &s, CYCLES_varint_2, SMVM_ldx_plus, 1, 3000, 0);
    measure_op(p, &s, CYCLES_varint_4, SMVM_ldx_plus, 1, 3000000, 0);
    for (int kind = WHOLE; kind <= ANY; kind++) {
        seen->row[CYCLES_varint_2][kind] = s.row[CYCLES_varint_2][kind] - s.row[CYCLES_number][kind];
        seen->row[CYCLES_varint_4][kind] = s.row[CYCLES_varint_4][kind] - s.row[CYCLES_number][kind];
    }
}

// ---- a step ----

// Measures the first step of a state with these functions.  Those that are not empty contain only `op`.
static uint32_t first_step(Probe *p, unsigned outputs, unsigned sample, unsigned entry, unsigned step_op, unsigned exit_op)
{
    const unsigned op[] = {sample, entry, step_op, exit_op};
    Build b = blank();

    b.states = 1;
    b.outputs = outputs;
    b.ends = 0;
    for (unsigned i = 0; i < 4; i++) {
        if (op[i])
            code(&b, op[i], op[i] == SMVM_goto, 1u);
        end_function(&b);
    }
    put_image(p, &b);
    start(p, 1, 0);
    return step(p);
}

static void measure_step(Probe *p, Seen *seen)
{
    const uint32_t empty = first_step(p, 11, 0, 0, 0, 0), all = first_step(p, 11, SMVM_end, SMVM_end, SMVM_end, 0);
    const uint32_t ends = first_step(p, 11, 0, 0, SMVM_end, 0), goes = first_step(p, 11, 0, 0, SMVM_goto, 0);
    const uint32_t exits = first_step(p, 11, 0, 0, SMVM_goto, SMVM_end);
    uint32_t function = (all - empty + 2) / 3;

    raise(&function, ends - empty);
    raise(&function, exits - goes);
    for (int kind = WHOLE; kind <= ANY; kind++) {
        seen->row[CYCLES_step][kind] = empty;
        seen->row[CYCLES_end][kind] = function;
        seen->row[CYCLES_goto][kind] = goes - empty;
        seen->row[CYCLES_more][kind] = larger(first_step(p, 72, 0, 0, 0, 0) - empty, (first_step(p, 224, 0, 0, 0, 0) - empty + 19) / 20);
    }
}

// ---- windows ----

static const uint8_t key_type[CYCLES_SAMPLE_KINDS][3] = {{SM_U8, SM_I8, SM_BOOL}, {SM_U16, SM_I16, SM_I16}, {SM_U32, SM_I32, SM_I32}, {SM_U64, SM_I64, SM_I64},
                                                 {SM_F32, SM_F32, SM_F32}, {SM_F64, SM_F64, SM_F64}};

// The maximum cycles of a sample of a full window of this kind, or of reading a statistic of it.
static uint32_t window_use_cycles(Probe *p, SmType type, unsigned n, unsigned stats, bool samples, unsigned stat)
{
    Build b = blank();
    uint32_t most = 0;

    b.states = 2;
    b.windows = 1;
    b.window[0] = (uint32_t)n | sm_roll_kind(type, stats) << SMVM_WINDOW_SIZE_BITS;
    for (unsigned s = 0; s < 2; s++) {
        end_function(&b);
        load_operands(&b, false, false);
        if (!samples)
            code(&b, SMVM_sample, 1, 0u);
        typed(&b, SMVM_ldx_elem, SM_F64, AT_X);
        if (s == 1 && samples)
            code(&b, SMVM_sample, 1, 0u);
        else if (s == 1)
            code(&b, SMVM_stat, 2, stat, 0u);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
    }
    put_image(p, &b);
    for (Run run = ANYTHING; run < RUNS; run++) {
        const Case c = {.outputs = 11, .run = run, .type = type};
        run_operands(p, &c, 1, &most);
        run_operands(p, &c, 2, &most);
    }
    return most;
}

// The maximum cycles of a row for windows of n samples of a type.
static uint32_t window_cycles(Probe *p, SmType type, unsigned n, CyclesWindow row)
{
    static const unsigned stat[][2] = {{0, 0}, {0, 0}, {SM_STAT_AVG, SM_STAT_AVG}, {SM_STAT_MIN, SM_STAT_MAX}, {SM_STAT_RANGE, SM_STAT_RANGE},
                                       {SM_STAT_MIN, SM_STAT_MAX}, {SM_STAT_RANGE, SM_STAT_RANGE}, {SM_STAT_MEDIAN, SM_STAT_MEDIAN}};
    const bool sorted = row == CYCLES_sample_sorted || row >= CYCLES_extreme_sorted, samples = row <= CYCLES_sample_sorted;
    const unsigned all = (1u << SM_STAT_OLDEST) - 1, stats = sorted ? all : all & ~(1u << SM_STAT_MEDIAN);
    uint32_t most = 0;

    for (unsigned which = 0; which < (samples ? 1u : 2u); which++)
        raise(&most, window_use_cycles(p, type, n, stats, samples, stat[row][which]));
    return most;
}

static void raise_row(Seen *seen, CyclesRow row, uint32_t cycles)
{
    raise(&seen->row[row][WHOLE], cycles);
    raise(&seen->row[row][ANY], cycles);
}

// Windows whose cost does not depend on their size: the oldest and the newest sample, their difference, and windows of times.
static void measure_times(Probe *p, Seen *seen)
{
    enum { SIZE = 5, TIMES = 1 << SM_STAT_ELAPSED, ENDS = 1 << SM_STAT_OLDEST | 1 << SM_STAT_NEWEST | 1 << SM_STAT_CHANGE };

    for (unsigned key = 0; key < CYCLES_SAMPLE_KINDS; key++)
        for (unsigned stat = SM_STAT_OLDEST; stat <= SM_STAT_CHANGE; stat++)
            raise_row(seen, CYCLES_change, window_use_cycles(p, (SmType)key_type[key][0], SIZE, ENDS, false, stat));
    for (unsigned stat = SM_STAT_ELAPSED; stat <= SM_STAT_RUN_TIME; stat++)
        raise_row(seen, CYCLES_times, window_use_cycles(p, SM_U64, SIZE, stat == SM_STAT_ELAPSED ? TIMES : SM_STATS_OF_RUNS, false, stat));
    raise_row(seen, CYCLES_event, window_use_cycles(p, SM_U64, SIZE, TIMES, true, 0));
    raise_row(seen, CYCLES_event, window_use_cycles(p, SM_U64, SIZE, SM_STATS_OF_RUNS, true, 0));
}

static uint32_t window_of_types(Probe *p, const uint8_t type[3], unsigned n, CyclesWindow row)
{
    uint32_t most = 0;

    for (unsigned i = 0; i < 3; i++)
        if (i == 0 || type[i] != type[i - 1])
            raise(&most, window_cycles(p, (SmType)type[i], n, row));
    return most;
}

// Computes a straight line that is above the cost of every size.
static void measure_windows(Probe *p, Seen *seen)
{
    enum { FEW = 3, MIDDLE = 8, MANY = 16 };

    for (unsigned row = 0; row < CYCLES_WINDOW_ROWS; row++)
        for (unsigned key = 0; key < CYCLES_SAMPLE_KINDS; key++) {
            const uint32_t few = window_of_types(p, key_type[key], FEW, (CyclesWindow)row);
            const uint32_t middle = window_of_types(p, key_type[key], MIDDLE, (CyclesWindow)row);
            const uint32_t many = window_of_types(p, key_type[key], MANY, (CyclesWindow)row);
            const uint32_t each = many > few ? (many - few + MANY - FEW - 1) / (MANY - FEW) : 0;
            uint32_t base = few > FEW * each ? few - FEW * each : 0;
            raise(&base, middle > MIDDLE * each ? middle - MIDDLE * each : 0);
            raise(&base, many > MANY * each ? many - MANY * each : 0);
            seen->window[row][key][0] = base;
            seen->window[row][key][1] = each;
        }
}

// ---- all of it ----

static void open_chip(Probe *p, const char *elf, unsigned operands, uint64_t seed)
{
    memset(p, 0, sizeof *p);
    if (!sim_open(&p->sim, elf) || !sim_until_ready(&p->sim))
        exit(1);
    p->box = sim_mailbox(&p->sim);
    sim_paint(&p->sim, p->box->free);
    p->operands = operands < sizeof p->cycles / sizeof *p->cycles ? operands : sizeof p->cycles / sizeof *p->cycles;
    p->seed = seed * 0x9E3779B97F4A7C15u | 1;
}

static void measure_all(Probe *p, Seen *seen)
{
    const unsigned operands = p->operands;

    memset(seen, 0, sizeof *seen);
    measure_step(p, seen);
    measure_types(p, seen);
    measure_outputs(p, seen, CYCLES_out, 0);
    measure_outputs(p, seen, CYCLES_out_far, 64);
    measure_jumps(p, seen);
    measure_others(p, seen);
    measure_varints(p, seen);
    p->operands = 30 + p->operands / 20;               // so that the largest window is full for some steps
    measure_windows(p, seen);
    measure_times(p, seen);
    seen->stack = sim_deepest(&p->sim, p->box->free);
    p->operands = operands;
    measure_calls(p, seen);
    seen->call_stack = sim_deepest(&p->sim, p->box->free);
}

static const char *const row_name[] = {
#define CYCLES_ROW(name, ...) #name,
#define CYCLES_WINDOW(name, ...)
#define CYCLES_STACK(bytes, with_calls)
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
};
static const char *const window_name[] = {
#define CYCLES_ROW(name, ...)
#define CYCLES_WINDOW(name, ...) #name,
#define CYCLES_STACK(bytes, with_calls)
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
};

// Adds a margin for windows, which have too many operands to test all.
static uint32_t with_room(uint32_t cycles) { return cycles + (cycles + 31) / 32; }

// Returns the row for a measurement, with a margin for functions, samples and times.
static uint32_t row_of(unsigned row, uint32_t cycles) { return row >= CYCLES_exp || row == CYCLES_change || row == CYCLES_times || row == CYCLES_event ? with_room(cycles) : cycles; }

static void print_rows(const Seen *flash, const Seen *eeprom)
{
    printf("CYCLES_STACK(%u, %u)\n", larger(flash->stack, eeprom->stack), larger(flash->call_stack, eeprom->call_stack));
    for (unsigned r = 0; r < CYCLES_ROWS; r++)
        printf("CYCLES_ROW(%s,%*s%6u,%6u,%6u,%6u)\n", row_name[r], (int)(12 - strlen(row_name[r])), "", row_of(r, flash->row[r][WHOLE]),
               row_of(r, flash->row[r][ANY]), row_of(r, eeprom->row[r][WHOLE]), row_of(r, eeprom->row[r][ANY]));
    for (unsigned r = 0; r < CYCLES_WINDOW_ROWS; r++) {
        printf("CYCLES_WINDOW(%s,%*s", window_name[r], (int)(15 - strlen(window_name[r])), "");
        for (unsigned key = 0; key < CYCLES_SAMPLE_KINDS; key++)
            printf("%6u,%4u%s", with_room(larger(flash->window[r][key][0], eeprom->window[r][key][0])),
                   with_room(larger(flash->window[r][key][1], eeprom->window[r][key][1])), key + 1 < CYCLES_SAMPLE_KINDS ? "," : ")\n");
    }
}

static unsigned passed, failed;

static void hold(const char *name, uint32_t seen, uint32_t row)
{
    if (seen <= row && seen * 100 >= row * (100 - FAR_BELOW))
        passed++;
    else if (failed++ < 20)
        printf("%s: %u cycles measured, %u in the table\n", name, seen, row);
}

static void check_rows(const Seen *s, CyclesChip chip)
{
    if (s->stack > cycles_stack_bytes(false))
        hold("stack", s->stack, cycles_stack_bytes(false));
    if (s->call_stack > cycles_stack_bytes(true))
        hold("stack of calls", s->call_stack, cycles_stack_bytes(true));
    for (unsigned r = 0; r < CYCLES_ROWS; r++)
        for (int kind = WHOLE; kind <= ANY; kind++)
            hold(row_name[r], s->row[r][kind], cycles_in_row(chip, (CyclesRow)r, kind == WHOLE));
    for (unsigned r = 0; r < CYCLES_WINDOW_ROWS && chip == CYCLES_EEPROM; r++)
        for (unsigned key = 0; key < CYCLES_SAMPLE_KINDS; key++)
            hold(window_name[r], s->window[r][key][0] + 16 * s->window[r][key][1], cycles_of_window_row((CyclesWindow)r, key_type[key][0], 16));
}

int main(int argc, char **argv)
{
    static Probe flash, eeprom;
    static Seen of_flash, of_eeprom;

    if (argc < 5)
        return 1;
    open_chip(&flash, argv[1], (unsigned)atoi(argv[3]), strtoull(argv[4], NULL, 10));
    measure_all(&flash, &of_flash);
    open_chip(&eeprom, argv[2], (unsigned)atoi(argv[3]), strtoull(argv[4], NULL, 10));
    measure_all(&eeprom, &of_eeprom);
    if (argc == 5) {
        print_rows(&of_flash, &of_eeprom);
        return 0;
    }
    check_rows(&of_flash, CYCLES_FLASH);
    check_rows(&of_eeprom, CYCLES_EEPROM);
    printf("cycles: %u passed, %u failed\n", passed, failed);
    return failed != 0 || passed == 0;
}
