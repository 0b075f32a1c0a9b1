// SPDX-License-Identifier: Apache-2.0
// Numbers of the reference, compared with values computed by hand, and with stdlib, which uses another method.
#include "compiler/script/ref.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "stdlib/convert.h"
#include "stdlib/elementary.h"
#include "stdlib/math.h"
#include "tests/elementary/arguments.h"
#include "tests/test.h"

static uint64_t random_state = 88172645463325252u;

static uint64_t next_random(void)                     // xorshift
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    return random_state ^= random_state << 17;
}

// Returns random bits, a number near a power of two, or a small number in eighths.
static double random_number(void)
{
    uint64_t r = next_random();

    switch (r % 4) {
    case 0: return sm_from_bits(next_random());
    case 1:             // 2^-70 … 2^69, plus a small number
        return sm_from_bits((next_random() % 140 + 953) << 52) * (r & 8 ? 1 : -1) + (double)(int)(next_random() % 7) - 3;
    case 2: return ((double)(next_random() % 1200) - 600) / 8;
    default: return (double)(int64_t)next_random() / 16;
    }
}

static bool same(double a, double b) { return sm_bits(a) == sm_bits(b) || (a != a && b != b); }

static void check_conversions(void)
{
    CHECK(ref_convert(SM_U8, 300) == 255 && ref_convert(SM_U8, -0.5) == 0 && ref_convert(SM_U8, 255.9) == 255);
    CHECK(ref_convert(SM_I8, 127.9) == 127 && ref_convert(SM_I8, -1) == 0xff && ref_convert(SM_I8, -1e9) == 0x80);
    CHECK(ref_convert(SM_I8, -128.9) == 0x80 && ref_convert(SM_I8, -127.9) == 0x81 && ref_convert(SM_I8, -0.9) == 0);
    CHECK(ref_convert(SM_I64, INFINITY) == INT64_MAX && ref_convert(SM_I64, -INFINITY) == (uint64_t)INT64_MAX + 1);
    CHECK(ref_convert(SM_I64, 9223372036854774784.0) == 9223372036854774784u);
    CHECK(ref_convert(SM_U64, 18446744073709549568.0) == 18446744073709549568u && ref_convert(SM_U64, 1e30) == UINT64_MAX);
    for (int t = 0; t < SM_TYPE_COUNT; t++)
        CHECK(ref_convert((SmType)t, NAN) == 0);
    CHECK(ref_convert(SM_BOOL, 1e-300) == 1 && ref_convert(SM_BOOL, -INFINITY) == 1 && ref_convert(SM_BOOL, -0.0) == 0);
    CHECK(ref_convert(SM_F32, 1e300) == 0x7f800000 && ref_convert(SM_F32, -0.0) == 0x80000000);
    CHECK(ref_convert(SM_F32, 3.4028235677973362e38) == 0x7f7fffff && ref_convert(SM_F32, 3.4028235677973366e38) == 0x7f800000);
    CHECK(ref_convert(SM_F32, 1.0 + 0x1p-24) == 0x3f800000 && ref_convert(SM_F32, 1.0 + 0x3p-24) == 0x3f800002);
    CHECK(ref_convert(SM_F32, 0x1p-149) == 1 && ref_convert(SM_F32, 0x1p-150) == 0);
}

static void check_reads(void)
{
    CHECK(ref_read(SM_I8, 0xff) == -1 && ref_read(SM_I8, 0x80) == -128 && ref_read(SM_U8, 0xff) == 255);
    CHECK(ref_read(SM_U64, 9007199254740993u) == 9007199254740992.0 && ref_read(SM_U64, UINT64_MAX) == 18446744073709551616.0);
    CHECK(ref_read(SM_I64, (uint64_t)-9007199254740993) == -9007199254740992.0);
    CHECK(same(ref_read(SM_F64, 0x7ff8000000000000u), 0) && same(ref_read(SM_F32, 0xffc00000u), 0));
    CHECK(ref_read(SM_BOOL, 7) == 1);
}

static double pure(SmBuiltin fn, double x) { return ref_pure(fn, &x); }

static void check_builtins(void)
{
    double zeros[] = {-0.0, 0.0};

    CHECK(same(ref_list(SM_FN_min, zeros, 2), -0.0) && same(ref_list(SM_FN_max, zeros, 2), 0.0));
    CHECK(same(pure(SM_FN_round, -0.3), -0.0) && same(pure(SM_FN_ceil, -0.3), -0.0));
    CHECK(pure(SM_FN_round, 2.5) == 3 && pure(SM_FN_round, -2.5) == -3);
    CHECK(pure(SM_FN_floor, -2.5) == -3 && pure(SM_FN_trunc, -2.5) == -2 && pure(SM_FN_ceil, -2.5) == -2);
    CHECK(same(pure(SM_FN_round, 0x1.fffffffffffffp-2), 0));              // just below a half
    CHECK(pure(SM_FN_sqrt, 2) == 0x1.6a09e667f3bcdp+0 && pure(SM_FN_sqrt, 0x1p-1074) == 0x1p-537);
    CHECK(isnan(pure(SM_FN_sqrt, -1)) && same(pure(SM_FN_sqrt, -0.0), -0.0) && pure(SM_FN_sqrt, INFINITY) == INFINITY);
    CHECK(pure(SM_FN_sign, -7) == -1 && same(pure(SM_FN_sign, -0.0), -0.0) && same(pure(SM_FN_abs, -0.0), 0));
}

static void compare_with_stdlib(void)
{
    double a[3] = {random_number(), random_number(), random_number()};

    for (int t = 0; t < SM_TYPE_COUNT; t++) {
        uint64_t cell = sm_cell_from_f64((SmType)t, a[0]);
        CHECK(ref_convert((SmType)t, a[0]) == cell);
        CHECK(same(ref_read((SmType)t, cell), sm_cell_to_f64((SmType)t, cell)));
    }
#define CALL_1(f) f(a[0])
#define CALL_2(f) f(a[0], a[1])
#define CALL_3(f) f(a[0], a[1], a[2])
#define SM_PURE(name, arguments, usage, units, sentence) CHECK(same(ref_pure(SM_FN_##name, a), CALL_##arguments(sm_##name)));
#define SM_COMPOSED(name, arguments, usage, units, steps, sentence) SM_PURE(name, arguments, usage, units, sentence)
#include "stdlib/builtins.def"
}

// Arguments for which the elementary functions are difficult.
static void compare_elementary(void)
{
    uint64_t state = 1;
    double a[3] = {0, 0, 0};

    for (unsigned i = 0; i < 40000; i++) {
#define FN(name, arguments, stdlib, reference) \
        pick_arguments(FN_##name, &state, i, FN_##name == FN_atan2 ? &a[1] : &a[0], FN_##name == FN_atan2 ? &a[0] : &a[1]); \
        CHECK(same(ref_pure(SM_FN_##name, a), CALL_##arguments(sm_##name)));
#include "tests/elementary/functions.def"
#undef FN
    }
}

int main(void)
{
    check_conversions();
    check_reads();
    check_builtins();
    for (int i = 0; i < 100000; i++)
        compare_with_stdlib();
    compare_elementary();
    return test_end("ref_number");
}
