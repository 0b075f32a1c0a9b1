// SPDX-License-Identifier: Apache-2.0
// Literals to F64: known hard cases, and many random ones against the C library's strtod in the "C" locale.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/syntax/number.h"
#include "tests/test.h"
#include "tests/unit/random.h"

static uint64_t bits_of(const char *text)
{
    SmF64 x = sm_from_bits(1);

    return number_to_f64(text, strlen(text), &x) ? sm_bits(x) : 0x7ff0000000000000u;
}

static void check_as_strtod(const char *text)
{
    double x = strtod(text, NULL);
    uint64_t expected = sm_bits(x), found = bits_of(text);

    if (found != expected)
        fprintf(stderr, "%s: %016llx, not %016llx\n", text, (unsigned long long)found, (unsigned long long)expected);
    CHECK(found == expected);
}

static void test_known(void)
{
    static const char *const texts[] = {
        "0", "5", "007.5", ".5", "5.", "1e3", "2.5E-3", "0.1", "1e22", "1e23", "123456789012345678", "9007199254740993",
        "9007199254740992.999999999999999999", "9007199254740993.0000000000000000000000000000000000000001",
        "1.7976931348623157e308", "1.7976931348623158e308", "1.7976931348623159e308", "1e309", "1e400", "1e99999999999999999999",
        "2.2250738585072011e-308", "2.2250738585072012e-308", "2.2250738585072014e-308", "4.9e-324", "2.5e-324", "2.4e-324",
        "2.4703282292062327208e-324", "2.4703282292062328e-324", "1e-400", "1e-99999999999999999999", "0e99999999999",
        "6.9294956446009195e15", "3.7455744005952583e15", "18446744073709551615", "18446744073709551616", "1e15", "123e-15"};

    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        check_as_strtod(texts[i]);
    CHECK(bits_of("1_000.2_5") == bits_of("1000.25"));
    CHECK(bits_of("1e1_0") == bits_of("1e10"));
    CHECK(bits_of("1e309") == 0x7ff0000000000000u);
    CHECK(bits_of("1.797693134862315807e308") == 0x7fefffffffffffffu);
    CHECK(bits_of("1.797693134862315808e308") == 0x7ff0000000000000u);
}

static void test_hex(void)
{
    static const char *const texts[] = {"0x0", "0x1F", "0xabcDEF", "0xffffffffffffffff", "0x1fffffffffffff",
                                        "0x20000000000001", "0x20000000000003", "0x200000000000010000000000000001",
                                        "0x20000000000001000000000000000000", "0x000000000000000000000000000001"};

    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        check_as_strtod(texts[i]);
    CHECK(bits_of("0xFF_FF") == bits_of("65535"));
}

// Numbers exactly half-way between two neighbours, and a little above.  If long double has only the precision of double, these are the
// neighbours themselves.
static void test_halves(void)
{
    char text[1600];

    for (int i = 0; i < 2000; i++) {
        double x = ldexp((double)(random_u64() >> 11), (int)(random_u64() % 2000) - 1100);
        long double half = ((long double)x + (long double)nextafter(x, INFINITY)) / 2;
        if (!(nextafter(x, INFINITY) < INFINITY))
            continue;
        snprintf(text, sizeof text - 1, "%.1100Lf", half);
        check_as_strtod(text);
        strcat(text, "1");
        check_as_strtod(text);
    }
}

static void test_random_digits(void)
{
    char text[64];

    for (int i = 0; i < 100000; i++) {
        int n = 0, digits = 1 + (int)(random_u64() % 25), point = (int)(random_u64() % 26);
        for (int k = 0; k < digits; k++) {
            if (k == point)
                text[n++] = '.';
            text[n++] = (char)('0' + random_u64() % 10);
        }
        snprintf(text + n, sizeof text - (size_t)n, "e%d", (int)(random_u64() % 700) - 360);
        check_as_strtod(text);
    }
}

// 17 digits of an F64 reproduce it; so do 16 and 18 digits, correctly rounded.
static void test_round_trip(void)
{
    char text[64];

    for (int i = 0; i < 100000; i++) {
        uint64_t bits = random_f64_bits() & 0x7fffffffffffffffu;
        double x = sm_from_bits(bits);
        if (!(x < INFINITY))
            continue;
        snprintf(text, sizeof text, "%.16e", x);
        CHECK(bits_of(text) == bits);
        snprintf(text, sizeof text, "%.*e", (int)(random_u64() % 30), x);
        check_as_strtod(text);
    }
}

// Insignificant digits are dropped, and a flag tells whether one of them was not zero: a zero followed by them is not a trailing zero.
static void test_far_digits(void)
{
    static char text[3000];
    static const char *const first[] = {"1.", "10000000000000000000000000000000000000000000000000000000.", "0.5", "9007199254740993."};

    for (size_t i = 0; i < sizeof first / sizeof *first; i++)
        for (size_t zeros = 760; zeros < 900; zeros++) {
            const size_t n = strlen(first[i]);
            strcpy(text, first[i]);
            memset(text + n, '0', zeros);
            strcpy(text + n + zeros, "1");
            check_as_strtod(text);
            strcpy(text + n + zeros, "0");
            check_as_strtod(text);
        }
}

// A number of a million digits is read in linear time.
static void test_long(void)
{
    enum { N = 1000000 };
    char *text = malloc(N + 16);
    SmF64 x;

    memset(text, '0', N);
    text[0] = '1';
    strcpy(text + N, "e-999999");
    CHECK(number_to_f64(text, strlen(text), &x) && sm_bits(x) == sm_bits(1.0));
    memset(text, '0', N);
    text[1] = '.';
    strcpy(text + N, "25e999998");
    CHECK(number_to_f64(text, strlen(text), &x) && sm_bits(x) == sm_bits(0.25));
    memset(text, '9', N);
    CHECK(!number_to_f64(text, N, &x));
    free(text);
}

int main(void)
{
    test_known();
    test_hex();
    test_halves();
    test_random_digits();
    test_round_trip();
    test_far_digits();
    test_long();
    return test_end("number");
}
