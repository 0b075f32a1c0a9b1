// SPDX-License-Identifier: Apache-2.0
// Checks that the elementary functions have the same bits with the computer's double and with soft numbers.
//   bits [N [SEED]]      every special argument, each pair of those, and N random arguments for each function
#include <stdio.h>
#include <stdlib.h>

#include "tests/elementary/arguments.h"

uint64_t bits_native(Function f, uint64_t a, uint64_t b);
uint64_t bits_soft(Function f, uint64_t a, uint64_t b);

static const char *const name[] = {
#define FN(name, arguments, stdlib, reference) #name,
#include "tests/elementary/functions.def"
#undef FN
};
static unsigned long tried, wrong;

static bool is_nan(uint64_t u) { return u << 1 > 0xFFE0000000000000u; }

static void compare(Function f, uint64_t a, uint64_t b)
{
    const uint64_t native = bits_native(f, a, b), soft = bits_soft(f, a, b);

    tried++;
    if (native != soft && !(is_nan(native) && is_nan(soft)) && wrong++ < 20)
        printf("%s(%016llx, %016llx): %016llx native, %016llx soft\n", name[f], (unsigned long long)a, (unsigned long long)b,
               (unsigned long long)native, (unsigned long long)soft);
}

static const uint64_t special[] = {
    0, 1, 0x000FFFFFFFFFFFFF, 0x0010000000000000, 0x0010000000000001, 0x3BF0000000000000, 0x3BEFFFFFFFFFFFFF, 0x3E30000000000000,
    0x3E40000000000000, 0x3E3FFFFFFFFFFFFF, 0x3FC0000000000000, 0x3FBFFFFFFFFFFFFF, 0x3FD8000000000000, 0x3FE0000000000000, 0x3FE6A09E667F3BCC,
    0x3FE6A09E667F3BCD, 0x3FE7000000000000, 0x3FE921FB54442D17, 0x3FE921FB54442D18, 0x3FE921FB54442D19, 0x3FEFFFFFFFFFFFFF, 0x3FF0000000000000,
    0x3FF0000000000001, 0x3FF6A09E667F3BCD, 0x3FF921FB54442D18, 0x4000000000000000, 0x4002D97C7F3321D2, 0x4008000000000000, 0x400921FB54442D18,
    0x4024000000000000, 0x40862E42FEFA39EF, 0x40862E42FEFA39F0, 0x4086300000000000, 0x40874910D52D3051, 0x40874910D52D3052, 0x4087500000000000,
    0x4330000000000000, 0x4330000000000001, 0x433FFFFFFFFFFFFF, 0x4340000000000000, 0x4340000000000001, 0x43F0000000000000, 0x43F0000000000001,
    0x5F30000000000000, 0x26F0000000000000, 0x7FE0000000000000, 0x7FEFFFFFFFFFFFFF, 0x7FF0000000000000, 0x7FF8000000000000, 0x7FF0000000000001,
};

int main(int argc, char **argv)
{
    enum { SPECIALS = sizeof special / sizeof *special };
    const unsigned long n = argc > 1 ? strtoul(argv[1], NULL, 10) : 4000;
    uint64_t state = argc > 2 ? strtoul(argv[2], NULL, 10) : 1;
    int passed = 0, failed = 0;

    for (int f = 0; f < FUNCTIONS; f++) {
        const unsigned long wrong_before = wrong, tried_before = tried;
        double x, y;
        for (int i = 0; i < 4 * SPECIALS; i++)
            for (int k = 0; k < SPECIALS; k++)
                compare((Function)f, special[i % SPECIALS] | (uint64_t)(i & 1) << 63, special[k] | (uint64_t)(i / 2 & 1) << 63);
        for (unsigned long i = 0; i < n; i++) {
            pick_arguments((Function)f, &state, (unsigned)i, &x, &y);
            uint64_t a, b;
            memcpy(&a, &x, sizeof a);
            memcpy(&b, &y, sizeof b);
            compare((Function)f, a, b);
        }
        passed += wrong == wrong_before && tried > tried_before + n;
        failed += !(wrong == wrong_before && tried > tried_before + n);
    }
    printf("elementary: %d passed, %d failed\n", passed, failed);
    return failed != 0 || passed != FUNCTIONS;
}
