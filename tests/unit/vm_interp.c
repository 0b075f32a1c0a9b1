// SPDX-License-Identifier: Apache-2.0
// The interpreter: every opcode, every kind of operand, every step rule of language.md 6, on images made by hand.
#include <math.h>
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"
#include "tests/test.h"
#include "tests/unit/vm_build.h"

// One machine whose state 1 has a step function under test.  Operands:
enum {
    OUT, OUT_FLAG,                // outputs: F64 at 16, bool at 24
    G, S, X, Y,                   // inputs: F64 at 32 and 40
    LOCAL_U8, LOCAL_F32, TEMP, TIME,
    SEVEN, MINUS, SINGLE, DOUBLE, NAN_CONST, OPERANDS
};

typedef struct Machine {
    uint64_t sv[8];
    uint64_t memory[200];
    uint8_t image[4096];
    SmvmMachine m;
} Machine;

static void begin(Build *b)
{
    const uint32_t operand[OPERANDS] = {
        ELEMENT(F64, 16), ELEMENT(BOOL, 24), ELEMENT(U64, 0), ELEMENT(U32, 8), ELEMENT(F64, 32), ELEMENT(F64, 40),
        LOCAL(U8, 0), LOCAL(F32, 4), OPERAND(22, 0), OPERAND(23, 0),
        OPERAND(24, 7), OPERAND(24, 0x7ffff), OPERAND(25, 0), OPERAND(26, 0), OPERAND(25, 1)};

    memset(b, 0, sizeof *b);
    b->sv_words = 8;
    b->locals = 8;
    b->temps = 1;
    b->outputs = 2;
    b->states = 1;
    b->width = 1;
    b->operands = OPERANDS;
    memcpy(b->operand, operand, sizeof operand);
    b->f32s = 2;
    b->f32[0] = 0x3e800000u;                          // 0.25
    b->f32[1] = 0x7fc00000u;
    b->f64s = 1;
    b->f64[0] = 0x3fb999999999999au;                  // 0.1
}

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

static double f64_at(const Machine *t, unsigned offset) { return sm_from_bits(t->sv[offset / 8]); }
static void set_f64(Machine *t, unsigned offset, double x) { t->sv[offset / 8] = sm_bits(x); }

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

static double two(unsigned op, double x, double y)    // d = op x, y
{
    Machine t;
    Build b;

    begin(&b);
    code(&b, op, 3, OUT, X, Y);
    CHECK(run(&t, &b, x, y));
    CHECK(smvm_stored((SmVm *)t.memory, 0) && !smvm_stored((SmVm *)t.memory, 1));
    return f64_at(&t, 16);
}

static double one(unsigned op, double x)
{
    Machine t;
    Build b;

    begin(&b);
    code(&b, op, 2, OUT, X);
    CHECK(run(&t, &b, x, 0));
    return f64_at(&t, 16);
}

static bool same(double a, double b) { return sm_bits(a) == sm_bits(b); }

static void operations(void)
{
    CHECK(one(SMVM_mov, 1.5) == 1.5);
    CHECK(one(SMVM_neg, 1.5) == -1.5 && same(one(SMVM_neg, 0.0), -0.0));
    CHECK(one(SMVM_abs, -1.5) == 1.5);
    CHECK(one(SMVM_floor, -1.5) == -2);
    CHECK(one(SMVM_ceil, -1.5) == -1);
    CHECK(one(SMVM_trunc, -1.7) == -1);
    CHECK(one(SMVM_round, 2.5) == 3);
    CHECK(one(SMVM_sqrt, 2) == sqrt(2));
    CHECK(one(SMVM_sign, -3) == -1);
    CHECK(one(SMVM_truth, 1e-300) == 1 && one(SMVM_truth, -0.0) == 0);
    CHECK(one(SMVM_not, 0) == 1 && one(SMVM_not, -2) == 0);
    CHECK(two(SMVM_add, 0.1, 0.2) == 0.1 + 0.2);
    CHECK(two(SMVM_sub, 1, 3) == -2);
    CHECK(two(SMVM_mul, 3, 4) == 12);
    CHECK(two(SMVM_div, 1, 0) == INFINITY);
    CHECK(two(SMVM_min, 1, 2) == 1 && same(two(SMVM_min, 0.0, -0.0), -0.0));
    CHECK(two(SMVM_max, 1, 2) == 2 && same(two(SMVM_max, -0.0, 0.0), 0.0));
    CHECK(two(SMVM_eq, 1, 1) == 1 && two(SMVM_eq, 1, 2) == 0);
    CHECK(two(SMVM_ne, 1, 1) == 0 && two(SMVM_ne, 1, 2) == 1);
    CHECK(two(SMVM_lt, 1, 2) == 1 && two(SMVM_lt, 2, 2) == 0);
    CHECK(two(SMVM_le, 2, 2) == 1 && two(SMVM_le, 3, 2) == 0);
    CHECK(two(SMVM_and, 2, 3) == 1 && two(SMVM_and, 2, 0) == 0 && two(SMVM_and, 0, 2) == 0);
    CHECK(two(SMVM_or, 0, 3) == 1 && two(SMVM_or, 3, 0) == 1 && two(SMVM_or, 0, 0) == 0);
}

// d = op NaN, 1 with a NaN that is computed: it stays one in a temp.
static double with_nan(unsigned op)
{
    Machine t;
    Build b;

    begin(&b);
    code(&b, SMVM_div, 3, TEMP, X, X);                // 0/0
    code(&b, op, 3, OUT, TEMP, SEVEN);
    CHECK(run(&t, &b, 0, 0));
    return f64_at(&t, 16);
}

static void not_a_number(void)
{
    Machine t;
    Build b;

    CHECK(with_nan(SMVM_eq) == 0 && with_nan(SMVM_ne) == 1 && with_nan(SMVM_lt) == 0 && with_nan(SMVM_le) == 0);
    CHECK(with_nan(SMVM_and) == 0 && with_nan(SMVM_or) == 1);
    CHECK(same(with_nan(SMVM_add), 0.0));             // stored as 0
    CHECK(one(SMVM_mov, NAN) == 0 && one(SMVM_not, NAN) == 1);       // read as 0
    begin(&b);
    code(&b, SMVM_not, 2, OUT, NAN_CONST);            // a constant NaN stays one, and is not true
    CHECK(run(&t, &b, 0, 0) && f64_at(&t, 16) == 1);
    begin(&b);
    code(&b, SMVM_eq, 3, OUT, NAN_CONST, NAN_CONST);
    CHECK(run(&t, &b, 0, 0) && f64_at(&t, 16) == 0);
}

// The value that operand `x` gives.
static double value(uint32_t x, double in)
{
    Machine t;
    Build b;

    begin(&b);
    code(&b, SMVM_mov, 2, OUT, x);
    CHECK(run(&t, &b, in, 0));
    return f64_at(&t, 16);
}

static void operand_kinds(void)
{
    Machine t;
    Build b;

    CHECK(value(X, 3.5) == 3.5 && value(G, 0) == 5 && value(S, 0) == 1 && value(TIME, 0) == 0);
    CHECK(value(SEVEN, 0) == 7 && value(MINUS, 0) == -1 && value(SINGLE, 0) == 0.25 && value(DOUBLE, 0) == 0.1);
    begin(&b);
    code(&b, SMVM_mov, 2, LOCAL_U8, X);               // saturates in the local
    code(&b, SMVM_mov, 2, OUT, LOCAL_U8);
    CHECK(run(&t, &b, 300, 0) && f64_at(&t, 16) == 255);
    begin(&b);
    code(&b, SMVM_mov, 2, LOCAL_F32, DOUBLE);         // rounds
    code(&b, SMVM_mov, 2, OUT, LOCAL_F32);
    CHECK(run(&t, &b, 0, 0) && f64_at(&t, 16) == (double)0.1f);
    begin(&b);
    code(&b, SMVM_mov, 2, OUT_FLAG, X);
    CHECK(run(&t, &b, -0.5, 0) && *(uint8_t *)&t.sv[3] == 1 && smvm_stored((SmVm *)t.memory, 1));
}

// Every type, as element and as local: what is stored in it can be read back, and nothing beside it is touched.
static void types(void)
{
    static const double expected[SM_TYPE_COUNT] = {-128, -300, -300, -300, 0, 0, 0, 0, -300.5, -300.5, 1};

    for (unsigned type = 0; type < SM_TYPE_COUNT; type++)
        for (int local = 0; local < 2; local++) {
            Machine t;
            Build b;
            begin(&b);
            b.operand[OUT_FLAG] = OPERAND(type, 48u >> smvm_type_shift(type));
            b.operand[LOCAL_U8] = OPERAND(11 + type, 0);
            code(&b, SMVM_mov, 2, local ? LOCAL_U8 : OUT_FLAG, X);
            code(&b, SMVM_mov, 2, OUT, local ? LOCAL_U8 : OUT_FLAG);
            CHECK(run(&t, &b, -300.5, 0));
            CHECK(f64_at(&t, 16) == expected[type]);
            CHECK(t.sv[7] == 0 && t.sv[5] == 0 && (sm_type_info[type].bytes == 8 || t.sv[6] >> 8 * sm_type_info[type].bytes == 0));
        }
}

// An accumulator of each type gives what a local of that type does; one of none what a temp does.
static void accumulators(void)
{
    static const double in[] = {-300.5, 300.5, 0.1, -0.0, 1e300, NAN, 3, 5000000000};

    for (unsigned type = 0; type <= SM_TYPE_COUNT; type++)
        for (unsigned i = 0; i < sizeof in / sizeof *in; i++) {
            double out[2];
            for (int acc = 0; acc < 2; acc++) {
                Machine t;
                Build b;
                begin(&b);
                b.locals = 16;
                b.operand[LOCAL_F32] = LOCAL(F32, 8);
                b.operand[SINGLE] = acc ? OPERAND(27, type) : type == SM_TYPE_COUNT ? OPERAND(22, 0) : OPERAND(11 + type, 0);
                code(&b, SMVM_div, 3, TEMP, X, X);    // (so that a NaN comes that is not stored)
                code(&b, i == 5 ? SMVM_mov : SMVM_add, i == 5 ? 2 : 3, SINGLE, i == 5 ? TEMP : X, Y);
                code(&b, SMVM_ne, 3, LOCAL_F32, SINGLE, SINGLE);
                code(&b, i == 5 ? SMVM_mov : SMVM_add, i == 5 ? 2 : 3, SINGLE, i == 5 ? TEMP : X, Y);
                code(&b, SMVM_add, 3, OUT, SINGLE, LOCAL_F32);
                CHECK(run(&t, &b, i == 5 ? 0 : in[i], -0.0));
                out[acc] = f64_at(&t, 16);
            }
            CHECK(same(out[0], out[1]));
        }
}

// Varints of two and four bytes as operand numbers.
static void many_operands(void)
{
    static uint8_t image[64 * 1024];
    static const uint32_t wanted[] = {95, 96, 97, 3167, 3168, 3169, 19999};
    const uint8_t id[] = {0x81, 0x82};

    for (unsigned k = 0; k < 7; k++) {
        uint32_t size[2], n = 12 + 16;
        uint8_t *p;
        static Build b;
        Machine t;
        SmvmVerdict v;
        begin(&b);
        code(&b, SMVM_mov, 2, OUT, wanted[k]);
        code(&b, SMVM_end, 0);
        p = image + n;
        put_bytes(&p, 0, 4);
        for (unsigned i = 0; i < 10; i++)
            p += put_number(p, ((const uint32_t[]){8, 8, 1, 0, 2, 20000, 1, 1, 2, 1})[i]);
        for (uint32_t i = 0; i < 20000; i++)
            put_bytes(&p, i < OPERANDS ? b.operand[i] : OPERAND(24, i + 3), 3);
        put_bytes(&p, (uint32_t)b.size << 24 | (uint32_t)b.size << 16, 4);   // sample, entry empty
        put_bytes(&p, b.f32[0], 4);
        put_bytes(&p, b.f32[1], 4);
        put_bytes(&p, b.f64[0], 8);
        size[0] = (uint32_t)(p - image) - n;
        size[1] = b.size;
        memcpy(p, b.code, b.size);
        n = put_header(image, 2, id, size);
        CHECK(smvm_verify(image, n, &v) == 0);
        CHECK(smvm_machine(image, 0, &t.m) && init(&t, t.memory, sizeof t.memory, memset(t.sv, 0, sizeof t.sv), 1) == SM_OK);
        CHECK(smvm_step((SmVm *)t.memory, t.sv) == SM_OK && f64_at(&t, 16) == wanted[k] + 3);
    }
}

// Where a wrong index would fall on something else: ten outputs, two of each constant, the ends of the whole numbers, G and S
// not at the start.
static void wide(void)
{
    enum { LOCAL_I8 = 12, LOCAL_BOOL, INT_MOST, INT_LEAST, SECOND_F32, SECOND_F64 };
    Machine t;
    SmVm *vm = (SmVm *)t.memory;
    Build b;

    begin(&b);
    for (uint32_t i = 0; i < 10; i++)
        b.operand[i] = ELEMENT(U8, i);
    b.outputs = 10;
    b.operand[10] = ELEMENT(U64, 40);
    b.operand[11] = ELEMENT(U32, 52);
    b.operand[LOCAL_I8] = LOCAL(I8, 7);
    b.operand[LOCAL_BOOL] = LOCAL(BOOL, 6);
    b.operand[INT_MOST] = OPERAND(24, 0x3ffff);
    b.operand[INT_LEAST] = OPERAND(24, 0x40000);
    b.operand[SECOND_F32] = OPERAND(25, 1);
    b.operand[SECOND_F64] = OPERAND(26, 1);
    b.operands = 18;
    b.f32[1] = 0x40a00000u;                           // 5
    b.f64[1] = 0x4018000000000000u;                   // 6
    b.f64s = 2;
    end_function(&b);
    end_function(&b);
    code(&b, SMVM_mov, 2, LOCAL_I8, INT_LEAST);
    code(&b, SMVM_mov, 2, LOCAL_BOOL, INT_LEAST);
    code(&b, SMVM_eq, 3, 9, INT_MOST, INT_MOST);
    code(&b, SMVM_mov, 2, 8, SECOND_F32);
    code(&b, SMVM_mov, 2, 1, SECOND_F64);
    code(&b, SMVM_mov, 2, 2, INT_MOST);
    code(&b, SMVM_sub, 3, 3, LOCAL_BOOL, LOCAL_I8);
    code(&b, SMVM_jeq, 3, INT_LEAST, INT_MOST, 4);
    code(&b, SMVM_neg, 2, 4, LOCAL_I8);
    code(&b, SMVM_end, 0);
    code(&b, SMVM_end, 0);
    end_function(&b);
    end_function(&b);
    CHECK(open_machine(&t, &b, 1));
    CHECK(((uint32_t *)t.sv)[13] == 1);
    t.sv[5] = 77;
    CHECK(smvm_step(vm, t.sv) == SM_OK && smvm_time(vm) == 0);
    CHECK(memcmp(t.sv, (const uint8_t[]){0, 6, 255, 129, 128, 0, 0, 0, 5, 1, 0, 0}, 12) == 0);
    for (uint32_t i = 0; i < 10; i++)
        CHECK(smvm_stored(vm, i) == (i == 9 || i == 8 || (i >= 1 && i <= 4)));
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
    code(&b, SMVM_jt, 2, TIME, 3 * 50);
    for (int i = 0; i < 50; i++)
        code(&b, SMVM_mov, 2, OUT, SEVEN);
    code(&b, SMVM_mov, 2, TEMP, SEVEN);
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
    code(&b, SMVM_sample, 2, 0, X);
    code(&b, SMVM_sample, 2, 1, X);
    code(&b, SMVM_end, 0);
    for (int i = 0; i < 4; i++)
        end_function(&b);
    CHECK(open_machine(&t, &b, 1));
    CHECK(smvm_ram_size(&t.m) == up8(sizeof(SmVm)) + up8(2 * sizeof(uint64_t *)) + 8
                               + 8 * (2 + 3 + 2) + 8 * (1 + 2 * 5) + 8);
}

// Whether `op x, y` jumps over `OUT = 7`.
static bool jumps(unsigned op, int operands, double x, double y)
{
    Machine t;
    Build b;

    begin(&b);
    if (operands == 0)
        code(&b, op, 1, 3);
    else if (operands == 1)
        code(&b, op, 2, X, 3);
    else
        code(&b, op, 3, X, Y, 3);
    code(&b, SMVM_mov, 2, OUT, SEVEN);
    CHECK(run(&t, &b, x, y));
    return f64_at(&t, 16) != 7;
}

// The same where x is a NaN in a temp.
static bool jumps_nan(unsigned op, int operands)
{
    Machine t;
    Build b;

    begin(&b);
    code(&b, SMVM_div, 3, TEMP, X, X);
    if (operands == 1)
        code(&b, op, 2, TEMP, 3);
    else
        code(&b, op, 3, TEMP, Y, 3);
    code(&b, SMVM_mov, 2, OUT, SEVEN);
    CHECK(run(&t, &b, 0, 0));
    return f64_at(&t, 16) != 7;
}

static void jumping(void)
{
    CHECK(jumps(SMVM_jmp, 0, 0, 0));
    CHECK(jumps(SMVM_jt, 1, 1, 0) && !jumps(SMVM_jt, 1, 0, 0) && !jumps_nan(SMVM_jt, 1));
    CHECK(!jumps(SMVM_jf, 1, 1, 0) && jumps(SMVM_jf, 1, 0, 0) && jumps_nan(SMVM_jf, 1));
    CHECK(jumps(SMVM_jeq, 2, 1, 1) && !jumps(SMVM_jeq, 2, 1, 2) && !jumps_nan(SMVM_jeq, 2));
    CHECK(!jumps(SMVM_jne, 2, 1, 1) && jumps(SMVM_jne, 2, 1, 2) && jumps_nan(SMVM_jne, 2));
    CHECK(jumps(SMVM_jlt, 2, 1, 2) && !jumps(SMVM_jlt, 2, 2, 2) && !jumps_nan(SMVM_jlt, 2));
    CHECK(!jumps(SMVM_jnlt, 2, 1, 2) && jumps(SMVM_jnlt, 2, 2, 2) && jumps_nan(SMVM_jnlt, 2));
    CHECK(jumps(SMVM_jle, 2, 2, 2) && !jumps(SMVM_jle, 2, 3, 2) && !jumps_nan(SMVM_jle, 2));
    CHECK(!jumps(SMVM_jnle, 2, 2, 2) && jumps(SMVM_jnle, 2, 3, 2) && jumps_nan(SMVM_jnle, 2));
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
        code(&b, SMVM_sample, 2, 0, X);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        code(&b, SMVM_avg + s, 2, OUT, 0);
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
        {SM_U32, 4294967295, 4294967295}, {SM_F32, 1e300, INFINITY}, {SM_F32, 0.1, 0.1f}, {SM_F32, -0.0, -0.0}, {SM_BOOL, -7, 1},
        {SM_F64, 0.1, 0.1}
    };

    for (unsigned i = 0; i < sizeof row / sizeof *row; i++) {
        Machine t;
        Build b;
        begin(&b);
        b.windows = 1;
        b.window[0] = WINDOW_OF(row[i].type, 1, 1u << SM_STAT_MAX);
        code(&b, SMVM_sample, 2, 0, X);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        code(&b, SMVM_highest, 2, OUT, 0);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        CHECK(open_machine(&t, &b, 1));
        t.sv[0] = 1;
        set_f64(&t, 32, row[i].in);
        CHECK(smvm_step((SmVm *)t.memory, t.sv) == SM_OK && sm_bits(f64_at(&t, 16)) == sm_bits(row[i].out));
    }
}

// ---- the step: two states whose functions write down that they ran ----

enum { L1 = OPERANDS };

// Each function does OUT = 10 * OUT + n; entry of 1 goes to 2 if X, step of 1 goes to 2 if Y; 2 goes to itself if Y.
static void put_trace(Build *b, unsigned digit, uint32_t condition, unsigned target)
{
    code(b, SMVM_mul, 3, OUT, OUT, L1);
    code(b, SMVM_add, 3, OUT, OUT, L1 + digit);
    if (target != 0) {
        code(b, SMVM_jf, 2, condition, 2);
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
    b.operand[L1] = OPERAND(24, 10);
    for (uint32_t i = 1; i <= 6; i++)
        b.operand[L1 + i] = OPERAND(24, i);
    b.operands = OPERANDS + 7;
    end_function(&b);
    put_trace(&b, 1, X, 2);
    put_trace(&b, 2, Y, 2);
    put_trace(&b, 3, 0, 0);
    put_trace(&b, 4, 0, 0);
    put_trace(&b, 5, Y, 2);
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
    CHECK(smvm_state(vm) == 1 && smvm_time(vm) == 0 && (uint32_t)t.sv[1] == 1);
    t.sv[1] = 99;
    CHECK(step(&t, 7, 0, 0) == 12);                   // entry, step
    CHECK((uint32_t)t.sv[1] == 1 && smvm_stored_state(vm) && smvm_time(vm) == 0);
    t.sv[1] = 99;
    CHECK(step(&t, 10, 1, 0) == 2 && smvm_time(vm) == 3);            // no entry any more
    CHECK((uint32_t)t.sv[1] == 99 && !smvm_stored_state(vm));        // S from outside stays, and changes no state
    CHECK(step(&t, 12, 0, 1) == 23);                  // step goes, exit
    CHECK(smvm_state(vm) == 2 && smvm_time(vm) == 5 && (uint32_t)t.sv[1] == 99);
    CHECK(step(&t, 20, 0, 1) == 456 && smvm_time(vm) == 0 && (uint32_t)t.sv[1] == 2);    // to itself: exit…
    CHECK(smvm_state(vm) == 2);
    CHECK(step(&t, 21, 0, 0) == 45 && smvm_time(vm) == 0);           // …and a first step again
    two_states(&t);
    CHECK(step(&t, 0, 1, 1) == 13 && smvm_state(vm) == 2);           // entry goes: no step; G may be 0
    CHECK(init(&t, t.memory, sizeof t.memory, t.sv, 2) == SM_OK && (uint32_t)t.sv[1] == 2);
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
    memcpy(b.init, (const uint8_t[]){15, 0, 0, 200, 19, 0, 0, 0, 0, 0, 0}, 11);
        b.init[4] = (uint8_t)LOCAL(F32, 4);
    b.init[5] = (uint8_t)(LOCAL(F32, 4) >> 8);
    memcpy(b.init + 7, (const uint8_t[]){0, 0, 0x80, 0x3e}, 4);
    code(&b, SMVM_add, 3, OUT, LOCAL_U8, LOCAL_F32);
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
    not_a_number();
    operand_kinds();
    types();
    accumulators();
    many_operands();
    jumping();
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
