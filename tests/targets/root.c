// SPDX-License-Identifier: Apache-2.0
// The square root by an instruction of the target against that by integers: special numbers, every binade, random numbers, and numbers whose roots are
// nearest to halfway between two F64 values.  Fails if sm_sqrt uses no instruction here.
#include "tests/targets/root.h"

#include <stdio.h>

#include "stdlib/f64.h"
#include "stdlib/math.h"
#include "tests/unit/nearly_tie.h"

static unsigned long wrong, done;

static int is_nan(uint64_t x) { return (x & 0x7FFFFFFFFFFFFFFFu) > 0x7FF0000000000000u; }

static void check(uint64_t x)
{
    const uint64_t root = sm_bits(sm_sqrt(sm_from_bits(x))), expected = root_by_integers(x);

    done++;
    wrong += root != expected && !(is_nan(root) && is_nan(expected));
}

static void check_specials(void)
{
    static const uint64_t special[] = {
        0, 1, 2, 0xFFFFFFFFFFFFFu, 0x10000000000000u, 0x10000000000001u, 0x3FEFFFFFFFFFFFFFu, 0x3FF0000000000000u, 0x3FF0000000000001u,
        0x4000000000000000u, 0x7FEFFFFFFFFFFFFFu, 0x7FF0000000000000u, 0x7FF0000000000001u, 0x7FF8000000000000u, 0x7FFFFFFFFFFFFFFFu
    };

    for (size_t i = 0; i < sizeof special / sizeof *special; i++) {
        check(special[i]);
        check(special[i] | 0x8000000000000000u);
    }
}

static void check_random(void)
{
    uint64_t x = 0x9E3779B97F4A7C15u;

    for (uint64_t exponent = 0; exponent < 2047; exponent++)
        for (int i = 0; i < 8; i++) {
            x ^= x << 13, x ^= x >> 7, x ^= x << 17;
            check(exponent << 52 | x >> 12);
        }
}

// The root of (k^2 + k - c) 2^-104 is almost halfway between k 2^-52 and (k + 1) 2^-52.  That number has 106 bits of which the last 52 are 0.
static void check_nearly_ties(void)
{
    for (int c = -2000; c <= 2000; c += 2)
        for (uint64_t parity = 0; parity < 2; parity++) {
            const uint64_t k = solve_tie((uint64_t)(int64_t)c, parity), a = k >> 26, b = k & 0x3FFFFFFu;
            const uint64_t middle = 2 * a * b + (b * b >> 26), high = a * a + (middle >> 26), low = (middle & 0x3FFFFFFu) << 26 | (b * b & 0x3FFFFFFu);
            const uint64_t square = high + ((low + k - (uint64_t)(int64_t)c) >> 52);          // the number, times 2^52: from 2^52 to below 2^54
            check(square >> 53 != 0 ? 0x4000000000000000u | (square >> 1 & 0xFFFFFFFFFFFFFu) : 0x3FF0000000000000u | (square & 0xFFFFFFFFFFFFFu));
        }
}

static void put_line(const char *text)
{
    while (*text != '\0')
        putchar(*text++);
    putchar('\n');
}

int main(void)
{
#ifdef SM_SQRT_INSTRUCTION
    const int has_instruction = 1;
#else
    const int has_instruction = 0;
#endif

    check_specials();
    check_random();
    check_nearly_ties();
    put_line(!has_instruction ? "sm_sqrt uses no instruction of this processor" : wrong == 0 ? "all roots are equal" : "some roots differ");
    return !has_instruction || wrong != 0 || done < 20000;
}
