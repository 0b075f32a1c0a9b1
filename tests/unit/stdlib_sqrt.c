// SPDX-License-Identifier: Apache-2.0
// The square root where the processor has none: every binade, random numbers, and those whose roots are nearest to halfway between two F64
// values, against the definition of rounding in exact integers; a million random bit patterns against the C library.
#include <math.h>
#include <string.h>

#include "stdlib/f64.h"
#undef SM_SQRT_INSTRUCTION
#include "stdlib/math.h"
#include "tests/test.h"
#include "tests/unit/nearly_tie.h"
#include "tests/unit/random.h"

// Whether k is nearest to the square root of n * 2^44, an integer: above (k - 1/2)^2 and below (k + 1/2)^2.
static bool is_nearest_root(uint64_t n, uint64_t k)
{
    const uint64_t a = k >> 32, b = k & 0xFFFFFFFFu, middle = a * b;                  // k^2 = a^2 2^64 + middle 2^33 + b^2
    const uint64_t low = b * b, square_low = low + (middle << 33), square_high = a * a + (middle >> 31) + (square_low < low);
    const uint64_t n_low = n << 44, n_high = n >> 20, rest = n_low - square_low;
    const uint64_t rest_high = n_high - square_high - (n_low < square_low);           // the rest has 128 bits

    return (rest_high == 0 && rest <= k) || (rest_high == UINT64_MAX && rest > (uint64_t)0 - k);
}

static void test_sqrt_digits(void)
{
    static const uint64_t step = 0x100, first = (uint64_t)1 << 60;

    for (uint64_t n = first; n < 4 * first; n += first / 4099 / step * step)
        CHECK(is_nearest_root(n, sm_sqrt_digits(n)));
    for (int i = 0; i < 1000000; i++) {
        const uint64_t n = first + random_u64() % (3 * first) / step * step;
        CHECK(is_nearest_root(n, sm_sqrt_digits(n)));
    }
    CHECK(sm_sqrt_digits(first) == first >> 8 && sm_sqrt_digits(4 * first - 2 * step) == (first >> 7) - 1);
}

// The root of (k^2 + k - c) 2^-104 is almost halfway between k 2^-52 and (k + 1) 2^-52: above it exactly if c is negative.
static void test_nearly_ties(void)
{
    int tried[2] = {0, 0};

    for (int c = -20000; c <= 20000; c += 2)
        for (uint64_t parity = 0; parity < 2; parity++) {
            const uint64_t k = solve_tie((uint64_t)(int64_t)c, parity), nearest = k + (c < 0);
            const bool odd = k > 6369051672525772u;                                    // sqrt(2) 2^52: the square is from 2 to 4
            const uint64_t low = k * k + k - (uint64_t)(int64_t)c;
            const double root = (double)k / 4503599627370496.0;
            if (odd && (low >> 52 & 1) != 0)
                continue;                                                              // not an F64
            // The lowest 12 bits of the quotient by 2^52 are exact; the others follow from a product that is rounded.
            const uint64_t about = (uint64_t)(root * root * 4503599627370496.0) & ~(uint64_t)1;
            const uint64_t digits = about + (uint64_t)((int64_t)(((low >> 52) - about) << 52) >> 52);
            CHECK(is_nearest_root(digits << 8, nearest) && sm_sqrt_digits(digits << 8) == nearest);
            for (int exponent = -1020; exponent <= 1020; exponent += 60) {
                const SmF64 x = ldexp((double)digits, exponent - 52);
                CHECK(sm_sqrt(x) == ldexp((double)nearest, exponent / 2 - 52) && sqrt(x) == sm_sqrt(x));
            }
            tried[odd]++;
        }
    CHECK(tried[0] > 1000 && tried[1] > 1000);
}

static void test_all_binades(void)
{
    for (uint64_t exponent = 0; exponent < 0x7FF; exponent++)
        for (int i = 0; i < 500; i++) {
            const SmF64 x = sm_from_bits(exponent << 52 | (exponent == 0 ? random_u64() >> 12 >> i % 52 : random_u64() >> 12));
            int power;
            const double f = frexp(x, &power);                                         // from 1/2 to 1, or 0
            const int shift = power % 2 != 0 ? 1 : 2;
            if (x == 0)
                continue;
            CHECK(is_nearest_root((uint64_t)ldexp(f, 60 + shift), (uint64_t)ldexp(sm_sqrt(x), 52 - (power - shift) / 2)));
        }
}

static void test_against_libm(void)
{
    static const uint64_t special[] = {0, 1, 0x8000000000000000u, 0x8000000000000001u, 0x7FEFFFFFFFFFFFFFu, 0x7FF0000000000000u, 0x7FF0000000000001u,
                                       0xFFEFFFFFFFFFFFFFu, 0xFFF0000000000000u, 0xFFF8000000000000u, 0x0010000000000000u, 0x000FFFFFFFFFFFFFu};

    for (int i = 0; i < 1000000; i++) {
        const SmF64 x = sm_from_bits((size_t)i < sizeof special / sizeof *special ? special[i] : random_f64_bits());
        const SmF64 root = sm_sqrt(x), expected = sqrt(x);
        CHECK(sm_bits(root) == sm_bits(expected) || (root != root && expected != expected));
    }
}

// Every upper half of the argument, with the smallest and the largest lower half: what is left of the argument after the upper half enters the
// result linearly, so the errors of all others are between the errors of these two.
static void test_all_upper_halves(void)
{
    for (uint64_t high = (uint64_t)1 << 30; high < (uint64_t)1 << 32; high++) {
        const uint64_t n = high << 30, last = n + (1u << 30) - 0x100;
        CHECK(is_nearest_root(n, sm_sqrt_digits(n)) && is_nearest_root(last, sm_sqrt_digits(last)));
    }
}

// With the argument `all`, also runs the test that takes a minute.
int main(int argc, char **argv)
{
    if (argc > 1 && strcmp(argv[1], "all") == 0)
        test_all_upper_halves();
    test_sqrt_digits();
    test_nearly_ties();
    test_all_binades();
    test_against_libm();
    return test_end("stdlib_sqrt");
}
