// SPDX-License-Identifier: Apache-2.0
// The interpreter: every opcode, every way to load and store, every step rule of language.md 6, on images made by hand.
#include <math.h>
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"
#include "tests/test.h"
#include "tests/unit/vm_build.h"

// One machine whose state 1 has a step function under test.  Outputs: F64 at 16, bool at 24; inputs: F64 at 32 and 40; locals: U8 at 0,
// F32 at 4, RAW at 8.
enum { OUT, OUT_FLAG };
enum { IN_X = 32, IN_Y = 40, LOCAL_U8 = 0, LOCAL_F32 = 4, LOCAL_RAW = 8 };

typedef struct Machine {
    uint64_t sv[8];
    uint64_t memory[200];
    uint8_t image[4096];
    SmvmMachine m;
} Machine;

static void begin(Build *b)
{
    memset(b, 0, sizeof *b);
    b->sv_words = 8;
    b->locals = 16;
    b->states = 1;
    b->width = 1;
    b->s = 2;
    b->outputs = 2;
    b->output[OUT] = PLACE(F64, 16);
    b->output[OUT_FLAG] = PLACE(BOOL, 24);
    b->f32s = 2;
    b->f32[0] = 0x3e800000u;                          // 0.25
    b->f32[1] = 0x7fc00000u;
    b->f64s = 1;
    b->f64[0] = 0x3fb999999999999au;                  // 0.1
}

static void load_x(Build *b) { typed(b, SMVM_ldx_elem, SM_F64, IN_X); }
static void load_y(Build *b) { typed(b, SMVM_ldy_elem, SM_F64, IN_Y); }
static void put_out(Build *b) { code(b, SMVM_out, 1, OUT); }

static SmResult init(Machine *t, void *memory, uint32_t size, void *sv, uint32_t state)
{
    const SmvmVector v = {sv, sizeof t->sv, 0};

    return smvm_init(memory, size, &t->m, &v, state);
}

static bool open_machine(Machine *t, const Build *b, uint32_t state)
{
    SmvmVerdict v;
    uint32_t n = build_image(b, t->image);

    if (smvm_verify(t->image, n, &v) != 0) {
        printf("refused by rule %u at %u\n", v.rule, (unsigned)v.at);
        return false;
    }
    memset(t->sv, 0, sizeof t->sv);
    memset(t->memory, 0xa5, sizeof t->memory);
    return smvm_machine(t->image, 0, &t->m) && smvm_ram_size(&t->m) <= sizeof t->memory
        && init(t, t->memory, sizeof t->memory, t->sv, state) == SM_OK;
}

static double f64_at(const Machine *t, unsigned offset)
{
    double x;

    memcpy(&x, t->sv + offset / 8, sizeof x);
    return x;
}

static void set_f64(Machine *t, unsigned offset, double x) { memcpy(t->sv + offset / 8, &x, sizeof x); }

// S, which the images below have at 8 unless they say otherwise.
static uint32_t state_at(const Machine *t, unsigned offset)
{
    uint32_t s;

    memcpy(&s, (const uint8_t *)t->sv + offset, sizeof s);
    return s;
}

static uint32_t s_of(const Machine *t) { return state_at(t, 8); }
static void set_s(Machine *t, uint32_t s) { memcpy((uint8_t *)t->sv + 8, &s, sizeof s); }

// Runs a step function of the given instructions and `end`, with x and y as inputs.
static bool run(Machine *t, Build *b, double x, double y)
{
    end_function(b);                                  // sample
    end_function(b);                                  // entry: the code so far is the step's
    b->end[0] = b->end[1] = 0;
    code(b, SMVM_end, 0);
    end_function(b);
    end_function(b);
    if (!open_machine(t, b, 1))
        return false;
    set_f64(t, 32, x);
    set_f64(t, 40, y);
    t->sv[0] = 5;
    return smvm_step((SmVm *)t->memory, t->sv) == SM_OK;
}

static double given(Build *b, double x, double y)     // OUT = X behind the instructions
{
    Machine t;

    put_out(b);
    CHECK(run(&t, b, x, y));
    CHECK(smvm_stored((SmVm *)t.memory, 0) && !smvm_stored((SmVm *)t.memory, 1));
    return f64_at(&t, 16);
}

static double two(unsigned op, double x, double y)
{
    Build b;

    begin(&b);
    load_x(&b);
    load_y(&b);
    code(&b, op, 0);
    return given(&b, x, y);
}

static double one(unsigned op, double x)
{
    Build b;

    begin(&b);
    load_x(&b);
    code(&b, op, 0);
    return given(&b, x, 0);
}

static double set(unsigned m, double x, double y)
{
    Build b;

    begin(&b);
    load_x(&b);
    load_y(&b);
    code(&b, SMVM_set, 1, m);
    return given(&b, x, y);
}

static bool same(double a, double b) { return memcmp(&a, &b, sizeof a) == 0; }

static void operations(void)
{
    CHECK(one(SMVM_neg, 1.5) == -1.5 && same(one(SMVM_neg, 0.0), -0.0));
    CHECK(one(SMVM_abs, -1.5) == 1.5);
    CHECK(one(SMVM_floor, -1.5) == -2);
    CHECK(one(SMVM_ceil, -1.5) == -1);
    CHECK(one(SMVM_trunc, -1.7) == -1);
    CHECK(one(SMVM_round, 2.5) == 3);
    CHECK(one(SMVM_sqrt, 2) == sqrt(2));
    CHECK(one(SMVM_sign, -3) == -1);
    CHECK(two(SMVM_add, 0.1, 0.2) == 0.1 + 0.2);
    CHECK(two(SMVM_sub, 1, 3) == -2);
    CHECK(two(SMVM_mul, 3, 4) == 12);
    CHECK(two(SMVM_div, 1, 0) == INFINITY);
    CHECK(two(SMVM_min, 1, 2) == 1 && same(two(SMVM_min, 0.0, -0.0), -0.0));
    CHECK(two(SMVM_max, 1, 2) == 2 && same(two(SMVM_max, -0.0, 0.0), 0.0));
    CHECK(two(SMVM_and, 2, 3) == 1 && two(SMVM_and, 2, 0) == 0 && two(SMVM_and, 0, 2) == 0);
    CHECK(two(SMVM_or, 0, 3) == 1 && two(SMVM_or, 3, 0) == 1 && two(SMVM_or, 0, 0) == 0);
}

static void relations(void)
{
    for (unsigned m = 1; m < 15; m++) {
        CHECK(set(m, 1, 2) == (m & 1) && set(m, 2, 2) == (m >> 1 & 1) && set(m, 3, 2) == (m >> 2 & 1));
        CHECK(set(m, -0.0, 0) == (m >> 1 & 1) && set(m, INFINITY, 2) == (m >> 2 & 1) && set(m, -INFINITY, -1e308) == (m & 1));
    }
}

// With 0/0, which X keeps, and 7.
static double with_nan(unsigned op, int numbers, unsigned m)
{
    Build b;

    begin(&b);
    load_x(&b);
    load_y(&b);
    code(&b, SMVM_div, 0);
    code(&b, SMVM_ldy_plus, 1, 7);
    code(&b, op, numbers, m);
    return given(&b, 0, 0);
}

static void not_a_number(void)
{
    Build b;

    for (unsigned m = 1; m < 15; m++)
        CHECK(with_nan(SMVM_set, 1, m) == (m >> 3));
    CHECK(with_nan(SMVM_and, 0, 0) == 0 && with_nan(SMVM_or, 0, 0) == 1);
    CHECK(same(with_nan(SMVM_add, 0, 0), 0.0));       // stored as 0
    CHECK(one(SMVM_abs, NAN) == 0 && set(2, NAN, 0) == 1);           // read as 0
    begin(&b);
    code(&b, SMVM_ldx_f32, 1, 1);                     // a constant NaN stays one, and is not true
    code(&b, SMVM_ldy_plus, 1, 1);
    code(&b, SMVM_and, 0);
    CHECK(given(&b, 0, 0) == 0);
    begin(&b);
    code(&b, SMVM_ldx_f32, 1, 1);
    code(&b, SMVM_ldy_f32, 1, 1);
    code(&b, SMVM_set, 1, SMVM_UNORDERED);
    CHECK(given(&b, 0, 0) == 1);
    begin(&b);
    code(&b, SMVM_ldx_f32, 1, 1);                     // and so does one in a local that keeps what it is given
    typed(&b, SMVM_st_local, SMVM_RAW, LOCAL_RAW);
    typed(&b, SMVM_ldx_local, SMVM_RAW, LOCAL_RAW);
    typed(&b, SMVM_ldy_local, SMVM_RAW, LOCAL_RAW);
    code(&b, SMVM_set, 1, SMVM_UNORDERED);
    CHECK(given(&b, 0, 0) == 1);
}

// What a load gives: in X, and as much in Y.
static double value(unsigned op, int numbers, unsigned n, double in)
{
    double x, y;
    Build b;

    begin(&b);
    code(&b, op, numbers, n);
    x = given(&b, in, 0);
    begin(&b);
    code(&b, SMVM_ldx_plus, 1, 0);
    code(&b, op + 0x20, numbers, n);
    code(&b, SMVM_add, 0);
    y = given(&b, in, 0);
    CHECK(x == y);
    return x;
}

static void loads(void)
{
    Build b;
    Machine t;

    CHECK(value(SMVM_ldx_elem + SM_F64, 1, 4, 3.5) == 3.5 && value(SMVM_ldx_elem + SM_U64, 1, 0, 0) == 5);
    CHECK(value(SMVM_ldx_elem + SM_U32, 1, 2, 0) == 1 && value(SMVM_ldx_time, 0, 0, 0) == 0);
    CHECK(value(SMVM_ldx_plus, 1, 7, 0) == 7 && value(SMVM_ldx_minus, 1, 0, 0) == -1 && value(SMVM_ldx_minus, 1, 0x1000c5f, 0) == -0x1000c60);
    CHECK(value(SMVM_ldx_f32, 1, 0, 0) == 0.25 && value(SMVM_ldx_f64, 1, 0, 0) == 0.1);
    for (unsigned i = 0; i < 7; i++) {
        static const uint32_t n[] = {95, 96, 97, 3167, 3168, 3169, 0x1000c5f};      // varints of one, two and four bytes
        CHECK(value(SMVM_ldx_plus, 1, n[i], 0) == n[i] && value(SMVM_ldx_minus, 1, n[i], 0) == -1.0 - n[i]);
        begin(&b);
        load_x(&b);
        code(&b, SMVM_addi, 1, n[i]);
        CHECK(given(&b, 0.5, 0) == 0.5 + n[i]);
        begin(&b);
        load_x(&b);
        code(&b, SMVM_subi, 1, n[i]);
        CHECK(given(&b, 7, 0) == 7.0 - n[i]);
    }
    begin(&b);
    load_x(&b);
    typed(&b, SMVM_st_local, SM_U8, LOCAL_U8);        // saturates in the local
    typed(&b, SMVM_ldx_local, SM_U8, LOCAL_U8);
    CHECK(given(&b, 300, 0) == 255);
    begin(&b);
    load_x(&b);
    code(&b, SMVM_out, 1, OUT_FLAG);
    CHECK(run(&t, &b, -0.5, 0) && *(uint8_t *)&t.sv[3] == 1 && smvm_stored((SmVm *)t.memory, 1) && !smvm_stored((SmVm *)t.memory, 0));
}

// Registers keep what they hold: X beside stores and a load of Y, Y beside operations.
static void registers(void)
{
    Build b;

    begin(&b);
    load_x(&b);
    typed(&b, SMVM_st_local, SM_U8, LOCAL_U8);
    load_y(&b);
    code(&b, SMVM_mul, 0);                            // 300.5 * 2
    code(&b, SMVM_add, 0);                            // + 2
    code(&b, SMVM_addi, 1, 1);
    code(&b, SMVM_sub, 0);                            // - 2
    CHECK(given(&b, 300.5, 2) == 602);
}

// Every type, as element and as local: what is stored in it can be read back, and nothing beside it is touched; cvt gives the same.
static void types(void)
{
    static const double expected[SM_TYPE_COUNT] = {-128, -300, -300, -300, 0, 0, 0, 0, -300.5, -300.5, 1};

    for (unsigned type = 0; type < SM_TYPE_COUNT; type++)
        for (int how = 0; how < 3; how++) {
            const size_t bytes = sm_type_info[type].bytes;
            Machine t;
            Build b;
            begin(&b);
            b.output[OUT_FLAG] = PLACE_OF(type, 48u >> smvm_type_shift(type));
            load_x(&b);
            if (how == 0)
                code(&b, SMVM_out, 1, OUT_FLAG);
            else if (how == 1)
                typed(&b, SMVM_st_local, type, 8);
            else
                code(&b, SMVM_cvt, 1, type);
            if (how < 2)
                typed(&b, how == 0 ? SMVM_ldx_elem : SMVM_ldx_local, type, how == 0 ? 48 : 8);
            put_out(&b);
            CHECK(run(&t, &b, -300.5, 0));
            CHECK(f64_at(&t, 16) == expected[type]);
            CHECK(t.sv[7] == 0 && t.sv[5] == 0 && memcmp((uint8_t *)&t.sv[6] + bytes, (const uint8_t[8]){0}, 8 - bytes) == 0);
        }
}

// cvt of a type gives what a local of that type does, whatever X is.
static void conversions(void)
{
    static const double in[] = {-300.5, 300.5, 0.1, -0.0, 1e300, -1e300, 3, 5000000000, -1, 255, 256, 65535, 65536, 2147483647, 2147483648.0};

    for (unsigned type = 0; type < SM_TYPE_COUNT; type++)
        for (unsigned i = 0; i <= sizeof in / sizeof *in; i++) {
            double out[2];
            for (int local = 0; local < 2; local++) {
                Build b;
                begin(&b);
                load_x(&b);
                if (i == sizeof in / sizeof *in) {
                    load_y(&b);
                    code(&b, SMVM_div, 0);            // a NaN
                }
                if (local) {
                    typed(&b, SMVM_st_local, type, 8);
                    typed(&b, SMVM_ldx_local, type, 8);
                } else
                    code(&b, SMVM_cvt, 1, type);
                out[local] = given(&b, i == sizeof in / sizeof *in ? 0 : in[i], 0);
            }
            CHECK(same(out[0], out[1]));
        }
}

// Where a wrong index would fall on something else: ten outputs, two of each constant, G and S not at the start, a vector of which
// only a part is named.
static void wide(void)
{
    Machine t;
    SmVm *vm = (SmVm *)t.memory;
    Build b;

    begin(&b);
    for (uint32_t i = 0; i < 10; i++)
        b.output[i] = PLACE_OF(SM_U8, 8 + i);
    b.outputs = 10;
    b.from = 1;
    b.to = 7;
    b.g = 5;
    b.s = 13;
    b.f32[1] = 0x40a00000u;                           // 5
    b.f64[1] = 0x4018000000000000u;                   // 6
    b.f64s = 2;
    end_function(&b);
    end_function(&b);
    code(&b, SMVM_ldx_minus, 1, 0x3ffff);
    typed(&b, SMVM_st_local, SM_I8, 7);
    typed(&b, SMVM_st_local, SM_BOOL, 6);
    code(&b, SMVM_ldx_f32, 1, 1);
    code(&b, SMVM_out, 1, 8);
    code(&b, SMVM_ldx_f64, 1, 1);
    code(&b, SMVM_out, 1, 1);
    code(&b, SMVM_ldx_plus, 1, 0x3ffff);
    code(&b, SMVM_out, 1, 2);
    code(&b, SMVM_ldy_plus, 1, 0x3ffff);
    code(&b, SMVM_set, 1, SMVM_EQUAL);
    code(&b, SMVM_out, 1, 9);
    typed(&b, SMVM_ldx_local, SM_BOOL, 6);
    typed(&b, SMVM_ldy_local, SM_I8, 7);
    code(&b, SMVM_sub, 0);
    code(&b, SMVM_out, 1, 3);
    code(&b, SMVM_jxn - 1 + SMVM_EQUAL, 2, 130, 0);
    code(&b, SMVM_ldx_plus, 1, 130);
    code(&b, SMVM_jxn - 1 + SMVM_EQUAL, 2, 130, 3);
    code(&b, SMVM_neg, 0);
    code(&b, SMVM_out, 1, 4);
    code(&b, SMVM_end, 0);
    end_function(&b);
    end_function(&b);
    CHECK(open_machine(&t, &b, 1));
    CHECK(state_at(&t, 52) == 1);
    t.sv[5] = 77;
    CHECK(smvm_step(vm, t.sv) == SM_OK && smvm_time(vm) == 0);
    CHECK(memcmp(t.sv + 1, (const uint8_t[]){0, 6, 255, 129, 0, 0, 0, 0, 5, 1, 0, 0}, 12) == 0);
    for (uint32_t i = 0; i < 10; i++)
        CHECK(smvm_stored(vm, i) == (i == 9 || i == 8 || (i >= 1 && i <= 3)));
    CHECK(memcmp(smvm_locals(vm), (const uint8_t[]){0, 0, 0, 0, 0, 0, 1, 128}, 8) == 0);
}

// A step that stores nothing leaves no trace of what the one before stored; a jump of two bytes' distance.
static void second_step(void)
{
    Machine t;
    SmVm *vm = (SmVm *)t.memory;
    Build b;

    begin(&b);
    end_function(&b);
    end_function(&b);
    code(&b, SMVM_ldx_time, 0);
    code(&b, SMVM_jt, 1, 4 * 50);
    for (int i = 0; i < 50; i++) {
        code(&b, SMVM_ldx_plus, 1, 7);
        put_out(&b);
    }
    code(&b, SMVM_end, 0);
    end_function(&b);
    end_function(&b);
    CHECK(open_machine(&t, &b, 1));
    CHECK(smvm_step(vm, t.sv) == SM_OK && smvm_stored(vm, 0));
    set_f64(&t, 16, 3);
    t.sv[0] = 1;
    CHECK(smvm_step(vm, t.sv) == SM_OK && !smvm_stored(vm, 0) && !smvm_stored(vm, 1) && f64_at(&t, 16) == 3);
}

static uint32_t up8(size_t n) { return (uint32_t)((n + 7) / 8 * 8); }

static void memory_needed(void)
{
    Machine t;
    Build b;

    begin(&b);
    b.windows = 2;
    b.window[0] = WINDOW(3, 1u << SM_STAT_AVG);
    b.window[1] = WINDOW(5, 1u << SM_STAT_MEDIAN);
    load_x(&b);
    code(&b, SMVM_sample, 1, 0);
    code(&b, SMVM_sample, 1, 1);
    code(&b, SMVM_end, 0);
    for (int i = 0; i < 4; i++)
        end_function(&b);
    CHECK(open_machine(&t, &b, 1));
    CHECK(smvm_ram_size(&t.m) == up8(sizeof(SmVm)) + up8(2 * sizeof(uint64_t *)) + 8 * (1 + 3) + 8 * (1 + 2 * 5) + 16);
}

// Whether a jump leads over `OUT = 7`; with X or Y as they are, or X a NaN.
static bool jumps(unsigned op, int numbers, unsigned n, double x, double y, bool nan)
{
    Machine t;
    Build b;

    begin(&b);
    load_x(&b);
    load_y(&b);
    if (nan) {
        code(&b, SMVM_ldy_f32, 1, 1);
        code(&b, SMVM_add, 0);
        load_y(&b);
    }
    if (numbers == 1)
        code(&b, op, 1, 4);
    else
        code(&b, op, 2, n, 4);
    code(&b, SMVM_ldx_plus, 1, 7);
    put_out(&b);
    CHECK(run(&t, &b, x, y));
    return f64_at(&t, 16) != 7;
}

static void jumping(void)
{
    CHECK(jumps(SMVM_jmp, 1, 0, 0, 0, false));
    CHECK(jumps(SMVM_jt, 1, 0, 1, 0, false) && !jumps(SMVM_jt, 1, 0, 0, 1, false) && !jumps(SMVM_jt, 1, 0, 0, 0, true));
    CHECK(!jumps(SMVM_jf, 1, 0, 1, 0, false) && jumps(SMVM_jf, 1, 0, 0, 1, false) && jumps(SMVM_jf, 1, 0, 0, 0, true));
    for (unsigned m = 1; m < 15; m++)
        for (unsigned k = 0; k < 4; k++) {
            const double x = k == 0 ? 6.5 : k == 1 ? 7 : 7.5;
            CHECK(jumps(SMVM_jxy - 1 + m, 1, 0, x, 7, k == 3) == (m >> k & 1));
            CHECK(jumps(SMVM_jxn - 1 + m, 2, 7, x, 0, k == 3) == (m >> k & 1));
        }
    CHECK(jumps(SMVM_jxn - 1 + SMVM_EQUAL, 2, 0x1000c5f, 0x1000c5f, 0, false));
}

// What lies behind a jump that is not taken finds both registers as they were.
static void chains(void)
{
    Machine t;
    Build b;

    begin(&b);
    load_x(&b);
    load_y(&b);
    code(&b, SMVM_jxn - 1 + SMVM_EQUAL, 2, 7, 5);
    code(&b, SMVM_jxy - 1 + SMVM_GREATER, 1, 3);
    code(&b, SMVM_add, 0);
    put_out(&b);
    CHECK(run(&t, &b, 2.5, 4) && f64_at(&t, 16) == 6.5);
}

// Samples 4, 1, 3, 2 through a window of three, and the statistic after each.
static void windows(void)
{
    static const double in[] = {4, 1, 3, 2};
    static const double expected[SM_STAT_COUNT][4] = {{4, 2.5, 8.0 / 3, 2}, {4, 2.5, 3, 2}, {4, 1, 1, 1}, {4, 4, 4, 3}, {0, 3, 3, 2}};

    for (unsigned s = 0; s < SM_STAT_COUNT; s++) {
        Machine t;
        Build b;
        begin(&b);
        b.windows = 1;
        b.window[0] = WINDOW(3, 1u << s);
        load_x(&b);
        code(&b, SMVM_sample, 1, 0);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        code(&b, SMVM_stat, 2, s, 0);
        put_out(&b);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        CHECK(open_machine(&t, &b, 1));
        for (unsigned i = 0; i < 4; i++) {
            t.sv[0] = i + 1;
            set_f64(&t, 32, in[i]);
            CHECK(smvm_step((SmVm *)t.memory, t.sv) == SM_OK && f64_at(&t, 16) == expected[s][i]);
        }
    }
}

// A sample that is not of the window's type becomes what storing it leaves, here in the largest of windows of one sample.
static void narrow_windows(void)
{
    static const struct { SmType type; double in, out; } row[] = {
        {SM_I8, 300, 127}, {SM_I8, -2.9, -2}, {SM_U8, -1, 0}, {SM_I16, -1e9, -32768}, {SM_U16, 65535.5, 65535}, {SM_I32, 1e300, 2147483647},
        {SM_U32, 4294967295, 4294967295}, {SM_F32, 1e300, INFINITY}, {SM_F32, 0.1, 0x1.99999ap-4}, {SM_F32, -0.0, -0.0}, {SM_BOOL, -7, 1},
        {SM_F64, 0.1, 0.1}
    };

    for (unsigned i = 0; i < sizeof row / sizeof *row; i++) {
        Machine t;
        Build b;
        begin(&b);
        b.windows = 1;
        b.window[0] = WINDOW_OF(row[i].type, 1, 1u << SM_STAT_MAX);
        load_x(&b);
        code(&b, SMVM_sample, 1, 0);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        code(&b, SMVM_stat, 2, SM_STAT_MAX, 0);
        put_out(&b);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        CHECK(open_machine(&t, &b, 1));
        t.sv[0] = 1;
        set_f64(&t, 32, row[i].in);
        CHECK(smvm_step((SmVm *)t.memory, t.sv) == SM_OK && same(f64_at(&t, 16), row[i].out));
    }
}

// ---- the step: two states whose functions write down that they ran ----

// Each function does OUT = 10 * OUT + n; entry of 1 goes to 2 if X, step of 1 goes to 2 if Y; 2 goes to itself if Y.
static void put_trace(Build *b, unsigned digit, unsigned condition, unsigned target)
{
    typed(b, SMVM_ldx_elem, SM_F64, 16);
    code(b, SMVM_ldy_plus, 1, 10);
    code(b, SMVM_mul, 0);
    code(b, SMVM_addi, 1, digit);
    put_out(b);
    if (target != 0) {
        typed(b, SMVM_ldx_elem, SM_F64, condition);
        code(b, SMVM_jf, 1, 2);
        code(b, SMVM_goto, 1, target);
    }
    code(b, SMVM_end, 0);
    end_function(b);
}

static void two_states(Machine *t)
{
    Build b;

    begin(&b);
    b.states = 2;
    end_function(&b);
    put_trace(&b, 1, IN_X, 2);
    put_trace(&b, 2, IN_Y, 2);
    put_trace(&b, 3, 0, 0);
    put_trace(&b, 4, 0, 0);
    put_trace(&b, 5, IN_Y, 2);
    put_trace(&b, 6, 0, 0);
    CHECK(open_machine(t, &b, 1));
}

static double step(Machine *t, uint64_t g, double x, double y)
{
    set_f64(t, 16, 0);
    set_f64(t, 32, x);
    set_f64(t, 40, y);
    t->sv[0] = g;
    CHECK(smvm_step((SmVm *)t->memory, t->sv) == SM_OK);
    return f64_at(t, 16);
}

static void steps(void)
{
    Machine t;
    SmVm *vm = (SmVm *)t.memory;

    two_states(&t);
    CHECK(smvm_state(vm) == 1 && smvm_time(vm) == 0 && s_of(&t) == 1);
    set_s(&t, 99);
    CHECK(step(&t, 7, 0, 0) == 12);                   // entry, step
    CHECK(s_of(&t) == 1 && smvm_stored_state(vm) && smvm_time(vm) == 0);
    set_s(&t, 99);
    CHECK(step(&t, 10, 1, 0) == 2 && smvm_time(vm) == 3);            // no entry any more
    CHECK(s_of(&t) == 99 && !smvm_stored_state(vm));        // S from outside stays, and changes no state
    CHECK(step(&t, 12, 0, 1) == 23);                  // step goes, exit
    CHECK(smvm_state(vm) == 2 && smvm_time(vm) == 5 && s_of(&t) == 99);
    CHECK(step(&t, 20, 0, 1) == 456 && smvm_time(vm) == 0 && s_of(&t) == 2);    // to itself: exit…
    CHECK(smvm_state(vm) == 2);
    CHECK(step(&t, 21, 0, 0) == 45 && smvm_time(vm) == 0);           // …and a first step again
    two_states(&t);
    CHECK(step(&t, 0, 1, 1) == 13 && smvm_state(vm) == 2);           // entry goes: no step; G may be 0
    CHECK(init(&t, t.memory, sizeof t.memory, t.sv, 2) == SM_OK && s_of(&t) == 2);
    CHECK(step(&t, 0, 0, 0) == 45);
}

static void refused(void)
{
    Machine t;
    SmVm *vm = (SmVm *)t.memory;
    uint64_t before[8], memory[200];

    two_states(&t);
    step(&t, 7, 0, 0);
    for (unsigned i = 0; i < 3; i++) {
        t.sv[0] = ((const uint64_t[]){7, 6, UINT64_MAX})[i];
        set_f64(&t, 40, 1);
        memcpy(before, t.sv, sizeof before);
        memcpy(memory, t.memory, sizeof memory);
        CHECK(smvm_step(vm, t.sv) == SM_REFUSED);
        CHECK(memcmp(before, t.sv, sizeof before) == 0 && memcmp(memory, t.memory, sizeof memory) == 0);
    }
    CHECK(step(&t, UINT64_MAX - 1, 0, 0) == 2 && smvm_time(vm) == UINT64_MAX - 8);
    two_states(&t);
    t.sv[0] = UINT64_MAX;
    CHECK(smvm_step(vm, t.sv) == SM_REFUSED);
}

static void starting(void)
{
    Machine t;
    Build b;
    uint8_t *odd = (uint8_t *)t.memory + 1;
    uint32_t need;

    begin(&b);
    b.init_size = 3 + 1 + 3 + 4;
    memcpy(b.init, (const uint8_t[]){0, 0, SM_U8, 200, 1, 0, SM_F32, 0, 0, 0x80, 0x3e}, 11);
    typed(&b, SMVM_ldx_local, SM_U8, LOCAL_U8);
    typed(&b, SMVM_ldy_local, SM_F32, LOCAL_F32);
    code(&b, SMVM_add, 0);
    put_out(&b);
    CHECK(run(&t, &b, 0, 0) && f64_at(&t, 16) == 200.25);
    need = smvm_ram_size(&t.m);
    CHECK(init(&t, t.memory, need, t.sv, 1) == SM_OK);
    CHECK(init(&t, t.memory, need - 1, t.sv, 1) == SM_E_MEMORY);
    CHECK(init(&t, odd, sizeof t.memory - 8, t.sv, 1) == SM_E_ALIGNMENT);
    CHECK(init(&t, t.memory, need, (uint8_t *)t.sv + 4, 1) == SM_E_ALIGNMENT);
    CHECK(init(&t, t.memory, need, t.sv, 0) == SM_E_ARGUMENT);
    CHECK(init(&t, t.memory, need, t.sv, 2) == SM_E_ARGUMENT);
    CHECK(smvm_init(t.memory, need, &t.m, &(SmvmVector){t.sv, 64, 1}, 1) == SM_E_LAYOUT);
    CHECK(smvm_init(t.memory, need, &t.m, &(SmvmVector){t.sv, 56, 0}, 1) == SM_E_LAYOUT);
    CHECK(!smvm_machine(t.image, 1, &t.m));
}

int main(void)
{
    operations();
    relations();
    not_a_number();
    loads();
    registers();
    types();
    conversions();
    jumping();
    chains();
    wide();
    second_step();
    memory_needed();
    windows();
    narrow_windows();
    steps();
    refused();
    starting();
    return test_end("vm_interp");
}
