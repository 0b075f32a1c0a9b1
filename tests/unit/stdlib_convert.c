// SPDX-License-Identifier: Apache-2.0
// Conversions: every row of language.md 2 as a table, then random bit patterns compared with a second conversion, which separates the bits of
// the number and uses only integers.
#include "stdlib/convert.h"
#include "tests/test.h"
#include "tests/unit/random.h"

#define INF sm_from_bits(0x7FF0000000000000u)
#define NINF sm_from_bits(0xFFF0000000000000u)
#define NAN_ sm_from_bits(0x7FF8000000000000u)
#define NNAN sm_from_bits(0xFFF8000000000001u)
#define SNAN sm_from_bits(0x7FF0000000000001u)

typedef struct Row { SmType type; SmF64 from; uint64_t cell; } Row;

static void test_integer_rows(void)
{
    const Row row[] = {
        { SM_I8, NAN_, 0 }, { SM_I16, NNAN, 0 }, { SM_I32, SNAN, 0 }, { SM_I64, NAN_, 0 },
        { SM_U8, NNAN, 0 }, { SM_U16, NAN_, 0 }, { SM_U32, NNAN, 0 }, { SM_U64, SNAN, 0 },
        { SM_I8, 127.9, 127 }, { SM_I8, 128, 127 }, { SM_I8, -128.9, 0x80 }, { SM_I8, -129, 0x80 },
        { SM_I8, -127.9, 0x81 },
        { SM_I8, -0.5, 0 }, { SM_I8, -1, 0xff }, { SM_I8, INF, 127 }, { SM_I8, NINF, 0x80 }, { SM_I8, 1e300, 127 },
        { SM_I16, 32767.5, 0x7fff }, { SM_I16, 32768, 0x7fff }, { SM_I16, -32769, 0x8000 }, { SM_I16, -1.9, 0xffff },
        { SM_I16, INF, 0x7fff }, { SM_I16, NINF, 0x8000 }, { SM_I16, -0.0, 0 },
        { SM_I32, 2147483647.9, 0x7fffffff }, { SM_I32, 2147483648.0, 0x7fffffff },
        { SM_I32, -2147483648.9, 0x80000000 },
        { SM_I32, -2147483649.0, 0x80000000 }, { SM_I32, -2147483647.9, 0x80000001 }, { SM_I32, INF, 0x7fffffff },
        { SM_I32, NINF, 0x80000000 }, { SM_I32, -5e-324, 0 },
        { SM_I64, 9223372036854774784.0, 9223372036854774784u },
        { SM_I64, 9223372036854775808.0, 0x7fffffffffffffffu },
        { SM_I64, -9223372036854775808.0, 0x8000000000000000u },
        { SM_I64, -9223372036854777856.0, 0x8000000000000000u },
        { SM_I64, -9223372036854774784.0, 0x8000000000000400u }, { SM_I64, INF, 0x7fffffffffffffffu },
        { SM_I64, NINF, 0x8000000000000000u },
        { SM_I64, -2.9, 0xfffffffffffffffeu },
        { SM_U8, 300, 255 }, { SM_U8, 255.9, 255 }, { SM_U8, 256, 255 }, { SM_U8, -0.5, 0 }, { SM_U8, -1, 0 },
        { SM_U8, INF, 255 },
        { SM_U8, NINF, 0 }, { SM_U8, 254.99, 254 },
        { SM_U16, 65535.9, 65535 }, { SM_U16, 65536, 65535 }, { SM_U16, -1e9, 0 }, { SM_U16, INF, 65535 },
        { SM_U16, NINF, 0 },
        { SM_U32, 4294967295.9, 0xffffffff }, { SM_U32, 4294967296.0, 0xffffffff },
        { SM_U32, 4294967294.9, 0xfffffffe },
        { SM_U32, -0.9, 0 }, { SM_U32, -1, 0 }, { SM_U32, INF, 0xffffffff }, { SM_U32, NINF, 0 },
        { SM_U32, 3e9, 3000000000u },
        { SM_U64, 18446744073709549568.0, 18446744073709549568u },
        { SM_U64, 18446744073709551616.0, 0xffffffffffffffffu },
        { SM_U64, -0.9, 0 }, { SM_U64, -1, 0 }, { SM_U64, INF, 0xffffffffffffffffu }, { SM_U64, NINF, 0 },
        { SM_U64, 1.5e19, 15000000000000000000u },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        CHECK(sm_cell_from_f64(row[i].type, row[i].from) == row[i].cell);
}

static void test_other_rows(void)
{
    const Row row[] = {
        { SM_F32, NAN_, 0 }, { SM_F32, NNAN, 0 }, { SM_F32, INF, 0x7f800000 }, { SM_F32, NINF, 0xff800000 },
        { SM_F32, -0.0, 0x80000000 },
        { SM_F32, 1e39, 0x7f800000 }, { SM_F32, -1e300, 0xff800000 }, { SM_F32, 3.4028234663852886e38, 0x7f7fffff },
        { SM_F32, 3.4028235677973362e38, 0x7f7fffff },
        { SM_F32, 3.4028235677973366e38, 0x7f800000 },     // half a step above FLT_MAX; the row before is just below that
        { SM_F32, 1.000000059604644775390625, 0x3f800000 },
        { SM_F32, 1.000000178813934326171875, 0x3f800002 },   // ties to even
        { SM_F32, 1.401298464324817e-45, 1 }, { SM_F32, -1e-45, 0x80000001 }, { SM_F32, 7.006492321624085e-46, 0 },
        { SM_F32, -1e-300, 0x80000000 },
        { SM_F64, NAN_, 0 }, { SM_F64, SNAN, 0 }, { SM_F64, NINF, 0xFFF0000000000000u },
        { SM_F64, -0.0, 0x8000000000000000u },
        { SM_F64, 5e-324, 1 }, { SM_F64, 0.1, 0x3FB999999999999Au },
        { SM_BOOL, NAN_, 0 }, { SM_BOOL, NNAN, 0 }, { SM_BOOL, 0, 0 }, { SM_BOOL, -0.0, 0 }, { SM_BOOL, 1e-300, 1 },
        { SM_BOOL, -5e-324, 1 },
        { SM_BOOL, INF, 1 }, { SM_BOOL, NINF, 1 }, { SM_BOOL, -3, 1 }, { SM_BOOL, 0.5, 1 },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        CHECK(sm_cell_from_f64(row[i].type, row[i].from) == row[i].cell);
}

static void test_reading_rows(void)
{
    const Row row[] = {
        { SM_I8, -1, 0xff }, { SM_I8, 127, 0x7f }, { SM_I16, -32768, 0x8000 }, { SM_I32, -1, 0xffffffff },
        { SM_I64, -1, 0xffffffffffffffffu },
        { SM_I64, 9007199254740992.0, 9007199254740993u },
        { SM_I64, 9007199254740996.0, 9007199254740995u },     // ties to even above 2^53
        { SM_I64, -9223372036854775808.0, 0x8000000000000000u },
        { SM_I64, 9223372036854775808.0, 0x7fffffffffffffffu },
        { SM_U8, 255, 0xff }, { SM_U16, 65535, 0xffff }, { SM_U32, 4294967295.0, 0xffffffff },
        { SM_U64, 18446744073709551616.0, 0xffffffffffffffffu },
        { SM_U64, 18446744073709549568.0, 18446744073709550591u },
        { SM_U64, 18446744073709551616.0, 18446744073709550592u },
        { SM_F32, 0, 0x7fc00000 }, { SM_F32, 0, 0xff800001 }, { SM_F32, -0.0, 0x80000000 },
        { SM_F32, 1.401298464324817e-45, 1 }, { SM_F32, NINF, 0xff800000 },
        { SM_F64, 0, 0x7FF8000000000000u }, { SM_F64, 0, 0xFFF0000000000001u }, { SM_F64, -0.0, 0x8000000000000000u },
        { SM_BOOL, 0, 0 }, { SM_BOOL, 1, 1 }, { SM_BOOL, 1, 0x80 }, { SM_BOOL, 1, 2 },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        CHECK(sm_bits(sm_cell_to_f64(row[i].type, row[i].cell)) == sm_bits(row[i].from));
}

// ---- the second conversion ----

// Returns the whole part of |x|, at most 2^64 - 1; sets *over if it is larger.
static uint64_t whole_part(uint64_t bits, bool *over)
{
    const int exponent = (int)(bits >> 52 & 0x7FF) - 1075;
    const uint64_t mantissa = (bits & 0xFFFFFFFFFFFFFu) | 0x10000000000000u;
    *over = exponent > 11;
    if (*over || exponent < -52)
        return 0;
    return exponent < 0 ? mantissa >> -exponent : mantissa << exponent;
}

static uint64_t expected_integer(SmType type, uint64_t bits)
{
    const unsigned width = 8u * sm_type_info[type].bytes;
    const bool is_signed = sm_type_info[type].kind == SM_KIND_SIGNED, negative = bits >> 63 != 0;
    const uint64_t mask = ~(uint64_t)0 >> (64 - width), most = is_signed ? mask >> 1 : mask, least = is_signed ? most + 1 : 0;
    bool over;
    const uint64_t whole = whole_part(bits, &over);
    if ((bits << 1) > 0xFFE0000000000000u)
        return 0;
    if (negative)
        return (over || whole > least ? 0 - least : 0 - whole) & mask;
    return over || whole > most ? most : whole;
}

static uint64_t expected_f32(uint64_t bits)
{
    const uint64_t sign = bits >> 63 << 31;
    const int exponent = (int)(bits >> 52 & 0x7FF) - 1023;
    uint64_t m = (bits & 0xFFFFFFFFFFFFFu) | 0x10000000000000u, rest;
    int shift = 29, biased = exponent + 127;
    if (exponent == 1024)
        return (bits & 0xFFFFFFFFFFFFFu) != 0 ? 0 : sign | 0x7f800000u;
    if (biased < 1) {
        shift += 1 - biased;
        biased = 1;
    }
    if (shift > 55)
        return sign;
    rest = m & (((uint64_t)1 << shift) - 1);
    m >>= shift;
    if (rest > (uint64_t)1 << (shift - 1) || (rest == (uint64_t)1 << (shift - 1) && (m & 1) != 0))
        m++;
    m += (uint64_t)(biased - 1) << 23;        // the implicit leading 1 adds the missing one
    return sign | (m >= 0x7f800000u ? 0x7f800000u : m);
}

static uint64_t expected_f64_of(uint64_t magnitude, bool negative)
{
    unsigned top = 63, drop;
    uint64_t m;
    if (magnitude == 0)
        return 0;
    while (magnitude >> top == 0)
        top--;
    drop = top > 52 ? top - 52 : 0;
    m = top > 52 ? magnitude >> drop : magnitude << (52 - top);
    if (drop > 0) {
        const uint64_t rest = magnitude << (64 - drop), half = 0x8000000000000000u;
        m += rest > half || (rest == half && (m & 1) != 0);
    }
    return (uint64_t)negative << 63 | (m + ((uint64_t)(top + 1022) << 52));
}

static uint64_t expected_f64_of_signed(uint64_t u, unsigned width)
{
    const uint64_t mask = ((uint64_t)1 << width) - 1;
    const bool negative = (u >> (width - 1) & 1) != 0;
    return expected_f64_of((negative ? 0 - u : u) & mask, negative);
}

static void test_random_storing(void)
{
    for (int i = 0; i < 1000000; i++) {
        const uint64_t bits = random_f64_bits();
        const SmF64 x = sm_from_bits(bits);
        const bool nan = (bits << 1) > 0xFFE0000000000000u;
        for (int type = SM_I8; type <= SM_U64; type++)
            CHECK(sm_cell_from_f64((SmType)type, x) == expected_integer((SmType)type, bits));
        CHECK(sm_cell_from_f64(SM_F32, x) == expected_f32(bits));
        CHECK(sm_cell_from_f64(SM_F64, x) == (nan ? 0 : bits));
        CHECK(sm_cell_from_f64(SM_BOOL, x) == (!nan && (bits << 1) != 0));
    }
}

static void test_random_reading(void)
{
    for (int i = 0; i < 1000000; i++) {
        const uint64_t r = random_u64() >> (random_u64() % 64), u = i % 3 == 0 ? ~r : r;
        const bool negative = u >> 63 != 0;
        CHECK(sm_bits(sm_cell_to_f64(SM_U64, u)) == expected_f64_of(u, false));
        CHECK(sm_bits(sm_cell_to_f64(SM_I64, u)) == expected_f64_of(negative ? 0 - u : u, negative));
        CHECK(sm_bits(sm_cell_to_f64(SM_U32, u)) == expected_f64_of(u & 0xffffffffu, false));
        CHECK(sm_bits(sm_cell_to_f64(SM_I32, u)) == expected_f64_of_signed(u, 32));
        CHECK(sm_bits(sm_cell_to_f64(SM_I16, u)) == expected_f64_of_signed(u, 16));
        CHECK(sm_bits(sm_cell_to_f64(SM_I8, u)) == expected_f64_of_signed(u, 8));
        const bool nan = (u & 0x7fffffffu) > 0x7f800000u;
        CHECK(sm_cell_from_f64(SM_F32, sm_cell_to_f64(SM_F32, u)) == (nan ? 0 : u & 0xffffffffu));
    }
}

// The result of a conversion is converted again in a register.  It must not have more digits than a double.
static void test_digits_of_wide_integers(void)
{
    SmF64 (*const volatile from_i64)(int64_t) = sm_from_i64, (*const volatile from_u64)(uint64_t) = sm_from_u64;

    for (int i = 0; i < 100000; i++) {
        const uint64_t u = random_u64() >> (2 + random_u64() % 10);
        CHECK((uint64_t)sm_truncate_i64(from_i64((int64_t)u)) == expected_integer(SM_I64, expected_f64_of(u, false)));
        CHECK(sm_truncate_u64(from_u64(u)) == expected_integer(SM_U64, expected_f64_of(u, false)));
        CHECK((uint64_t)sm_truncate_i64(from_i64(-(int64_t)u)) == 0 - expected_integer(SM_I64, expected_f64_of(u, false)));
    }
}

// A store of each type, at any alignment, leaves its neighbours unchanged; the loaded value is that of a cell.
static void test_stores_keep_neighbours(void)
{
    for (int i = 0; i < 200000; i++) {
        const SmType type = (SmType)(random_u64() % SM_TYPE_COUNT);
        const size_t at = 1 + random_u64() % 8, size = sm_type_info[type].bytes;
        const SmF64 x = sm_from_bits(random_f64_bits());
        uint8_t memory[24];
        memset(memory, 0xA5, sizeof memory);
        sm_store(type, memory + at, x);
        CHECK(sm_cell_load(type, memory + at) == sm_cell_from_f64(type, x));
        CHECK(sm_bits(sm_load(type, memory + at)) == sm_bits(sm_cell_to_f64(type, sm_cell_from_f64(type, x))));
        CHECK(memory[at - 1] == 0xA5 && memory[at + size] == 0xA5);
    }
}

static void test_bool_bytes(void)
{
    uint8_t byte = 0x80;
    CHECK(sm_cell_load(SM_BOOL, &byte) == 1);
    CHECK(sm_bits(sm_load(SM_BOOL, &byte)) == sm_bits(1.0));
    sm_cell_store(SM_BOOL, &byte, 0x40);
    CHECK(byte == 1);
    sm_cell_store(SM_BOOL, &byte, 0);
    CHECK(byte == 0);
}

static void test_values(void)
{
    CHECK(sm_to_f32(-0.0) == 0 && sm_f32_bits(sm_to_f32(-0.0)) == 0x80000000u);
    CHECK(sm_bits(sm_read_f32(sm_f32_from_bits(0x7fc00001u))) == 0);
    CHECK(sm_bits(sm_read_f64(NNAN)) == 0 && sm_bits(sm_to_f64(NAN_)) == 0);
    CHECK(sm_bits(sm_from_i8(INT8_MIN)) == sm_bits(-128.0) && sm_bits(sm_from_i16(INT16_MIN)) == sm_bits(-32768.0));
    CHECK(sm_bits(sm_from_u8(255)) == sm_bits(255.0) && sm_bits(sm_from_u16(65535)) == sm_bits(65535.0));
    CHECK(sm_bits(sm_from_bool(true)) == sm_bits(1.0) && sm_bits(sm_from_bool(false)) == 0);
    CHECK(sm_bits(sm_neg(0.0)) == 0x8000000000000000u && sm_bits(sm_neg(NAN_)) == 0xFFF8000000000000u);
}

int main(void)
{
    test_integer_rows();
    test_other_rows();
    test_reading_rows();
    test_random_storing();
    test_random_reading();
    test_digits_of_wide_integers();
    test_stores_keep_neighbours();
    test_bool_bytes();
    test_values();
    return test_end("stdlib_convert");
}
