// SPDX-License-Identifier: Apache-2.0
// The interpreter: every opcode, every form of load and store, on handmade images.
#include <math.h>

#include "stdlib/convert.h"
#include "stdlib/elementary.h"
#include "tests/unit/vm_machine.h"

static double compute_of_two(unsigned op, double x, double y)
{
    Build b;

    begin(&b);
    load_x(&b);
    load_y(&b);
    code(&b, op, 0);
    return given(&b, x, y);
}

static double compute_of_one(unsigned op, double x)
{
    Build b;

    begin(&b);
    load_x(&b);
    code(&b, op, 0);
    return given(&b, x, 0);
}

static double compute_relation(unsigned m, double x, double y)
{
    Build b;

    begin(&b);
    load_x(&b);
    load_y(&b);
    code(&b, SMVM_set, 1, m);
    return given(&b, x, y);
}

static void test_operations_compute(void)
{
    CHECK(compute_of_one(SMVM_neg, 1.5) == -1.5 && same(compute_of_one(SMVM_neg, 0.0), -0.0));
    CHECK(compute_of_one(SMVM_abs, -1.5) == 1.5);
    CHECK(compute_of_one(SMVM_floor, -1.5) == -2);
    CHECK(compute_of_one(SMVM_ceil, -1.5) == -1);
    CHECK(compute_of_one(SMVM_trunc, -1.7) == -1);
    CHECK(compute_of_one(SMVM_round, 2.5) == 3);
    CHECK(compute_of_one(SMVM_sqrt, 2) == sqrt(2));
    CHECK(compute_of_one(SMVM_sign, -3) == -1);
    CHECK(compute_of_two(SMVM_add, 0.1, 0.2) == 0.1 + 0.2);
    CHECK(compute_of_two(SMVM_sub, 1, 3) == -2);
    CHECK(compute_of_two(SMVM_mul, 3, 4) == 12);
    CHECK(compute_of_two(SMVM_div, 1, 0) == INFINITY);
    CHECK(compute_of_two(SMVM_min, 1, 2) == 1 && same(compute_of_two(SMVM_min, 0.0, -0.0), -0.0));
    CHECK(compute_of_two(SMVM_max, 1, 2) == 2 && same(compute_of_two(SMVM_max, -0.0, 0.0), 0.0));
    CHECK(compute_of_two(SMVM_and, 2, 3) == 1 && compute_of_two(SMVM_and, 2, 0) == 0 && compute_of_two(SMVM_and, 0, 2) == 0);
    CHECK(compute_of_two(SMVM_or, 0, 3) == 1 && compute_of_two(SMVM_or, 3, 0) == 1 && compute_of_two(SMVM_or, 0, 0) == 0);
}

// Every elementary function, and afterwards the values that both registers can still have.
static double compute_function(uint8_t op, unsigned n, double x, double y)
{
    Build b;

    begin(&b);
    load_x(&b);
    load_y(&b);
    code(&b, op, 1, n);
    return given(&b, x, y);
}

static void test_functions_compute(void)
{
#define ONE(name) CHECK(same(compute_function(SMVM_fn, SMVM_FN_##name, 0.7, 3), sm_##name(0.7)) && same(compute_function(SMVM_fn, SMVM_FN_##name, 0.9, 3), sm_##name(0.9)));
#define TWO(name) CHECK(same(compute_function(SMVM_fn, SMVM_FN_##name, 0.7, -3), sm_##name(0.7, -3)) && same(compute_function(SMVM_fn, SMVM_FN_##name, -2, 5), sm_##name(-2, 5)));
#define CHECK_1(name) ONE(name)
#define CHECK_2(name) TWO(name)
#define SM_ELEMENTARY(name, arguments, number) CHECK_##arguments(name)
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
}

static void test_relations_compare(void)
{
    for (unsigned m = 1; m < 15; m++) {
        CHECK(compute_relation(m, 1, 2) == (m & 1) && compute_relation(m, 2, 2) == (m >> 1 & 1) && compute_relation(m, 3, 2) == (m >> 2 & 1));
        CHECK(compute_relation(m, -0.0, 0) == (m >> 1 & 1) && compute_relation(m, INFINITY, 2) == (m >> 2 & 1) && compute_relation(m, -INFINITY, -1e308) == (m & 1));
    }
}

// Computes an operation with X a NaN (0/0) and Y 7.
static double compute_with_nan(unsigned op, int numbers, unsigned m)
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

static void test_nan_in_operations(void)
{
    Build b;

    for (unsigned m = 1; m < 15; m++)
        CHECK(compute_with_nan(SMVM_set, 1, m) == (m >> 3));
    CHECK(compute_with_nan(SMVM_and, 0, 0) == 0 && compute_with_nan(SMVM_or, 0, 0) == 1);
    CHECK(same(compute_with_nan(SMVM_add, 0, 0), 0.0));       // a NaN is stored as 0
    CHECK(compute_of_one(SMVM_abs, NAN) == 0 && compute_relation(2, NAN, 0) == 1);           // a NaN is read as 0
    begin(&b);
    code(&b, SMVM_ldx_f32, 1, 1);                     // a constant NaN is not converted, and is not true
    code(&b, SMVM_ldy_plus, 1, 1);
    code(&b, SMVM_and, 0);
    CHECK(given(&b, 0, 0) == 0);
    begin(&b);
    code(&b, SMVM_ldx_f32, 1, 1);
    code(&b, SMVM_ldy_f32, 1, 1);
    code(&b, SMVM_set, 1, SMVM_UNORDERED);
    CHECK(given(&b, 0, 0) == 1);
    begin(&b);
    code(&b, SMVM_ldx_f32, 1, 1);                     // the same for a NaN in a local that stores the value unchanged
    typed(&b, SMVM_st_local, SMVM_RAW, LOCAL_RAW);
    typed(&b, SMVM_ldx_local, SMVM_RAW, LOCAL_RAW);
    typed(&b, SMVM_ldy_local, SMVM_RAW, LOCAL_RAW);
    code(&b, SMVM_set, 1, SMVM_UNORDERED);
    CHECK(given(&b, 0, 0) == 1);
}

// Returns the result of a load to X, after checking that Y gets the same.
static double load_value(unsigned op, int numbers, unsigned n, double in)
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

static void test_loads_read(void)
{
    Build b;
    Machine t;

    CHECK(load_value(SMVM_ldx_elem + SM_F64, 1, 4, 3.5) == 3.5 && load_value(SMVM_ldx_elem + SM_U64, 1, 0, 0) == 5);
    CHECK(load_value(SMVM_ldx_elem + SM_U32, 1, 2, 0) == 1 && load_value(SMVM_ldx_time, 0, 0, 0) == 0);
    CHECK(load_value(SMVM_ldx_plus, 1, 7, 0) == 7 && load_value(SMVM_ldx_minus, 1, 0, 0) == -1 && load_value(SMVM_ldx_minus, 1, 0x1000c5f, 0) == -0x1000c60);
    CHECK(load_value(SMVM_ldx_f32, 1, 0, 0) == 0.25 && load_value(SMVM_ldx_f64, 1, 0, 0) == 0.1);
    for (unsigned i = 0; i < 7; i++) {
        static const uint32_t n[] = {95, 96, 97, 3167, 3168, 3169, 0x1000c5f};      // varints of one, two and four bytes
        CHECK(load_value(SMVM_ldx_plus, 1, n[i], 0) == n[i] && load_value(SMVM_ldx_minus, 1, n[i], 0) == -1.0 - n[i]);
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

// Stores, and loads of Y, do not change X.  Operations do not change Y.
static void test_registers_keep_values(void)
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

// A value stored to an element or a local of each type can be read back, and no neighbour changes; cvt has the same result.
static void test_types_store_and_load(void)
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

// cvt to a type has the same result as a store to a local of that type, for any X.
static void test_cvt_is_a_store(void)
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

// A wrong index selects a wrong item: ten outputs, two constants of each type, G and S not at the start, and a vector of which the machine uses
// only a part.
static void test_indices_select_the_right_thing(void)
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

// Whether a jump over `OUT = 7` is taken.  X and Y are the arguments; or X is a NaN.
static bool jump_is_taken(unsigned op, int numbers, unsigned n, double x, double y, bool nan)
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

static void test_jumps_are_taken(void)
{
    CHECK(jump_is_taken(SMVM_jmp, 1, 0, 0, 0, false));
    CHECK(jump_is_taken(SMVM_jt, 1, 0, 1, 0, false) && !jump_is_taken(SMVM_jt, 1, 0, 0, 1, false) && !jump_is_taken(SMVM_jt, 1, 0, 0, 0, true));
    CHECK(!jump_is_taken(SMVM_jf, 1, 0, 1, 0, false) && jump_is_taken(SMVM_jf, 1, 0, 0, 1, false) && jump_is_taken(SMVM_jf, 1, 0, 0, 0, true));
    for (unsigned m = 1; m < 15; m++)
        for (unsigned k = 0; k < 4; k++) {
            const double x = k == 0 ? 6.5 : k == 1 ? 7 : 7.5;
            CHECK(jump_is_taken(SMVM_jxy - 1 + m, 1, 0, x, 7, k == 3) == (m >> k & 1));
            CHECK(jump_is_taken(SMVM_jxn - 1 + m, 2, 7, x, 0, k == 3) == (m >> k & 1));
        }
    CHECK(jump_is_taken(SMVM_jxn - 1 + SMVM_EQUAL, 2, 0x1000c5f, 0x1000c5f, 0, false));
}

// After a jump that is not taken, both registers are unchanged.
static void test_jump_not_taken_keeps_registers(void)
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

int main(void)
{
    test_operations_compute();
    test_functions_compute();
    test_relations_compare();
    test_nan_in_operations();
    test_loads_read();
    test_registers_keep_values();
    test_types_store_and_load();
    test_cvt_is_a_store();
    test_jumps_are_taken();
    test_jump_not_taken_keeps_registers();
    test_indices_select_the_right_thing();
    return test_end("vm_interp");
}
