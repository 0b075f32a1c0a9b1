// SPDX-License-Identifier: Apache-2.0
// Operands for which arithmetic is likely to be wrong: a fixed list, and random ones near ties, limits of ranges, and each other.
#include "tests/soft/soft.h"

enum { SPECIALS_MAX = 3000 };

static uint64_t special[SPECIALS_MAX];
static size_t specials;

static void put(uint64_t a)
{
    if (specials + 2 > SPECIALS_MAX)
        return;
    special[specials++] = a;
    special[specials++] = a ^ 0x8000000000000000u;
}

// Each of these exponents with each of these fractions: limits of ranges, of integers and of binary32, and ties of their rounding.
static const uint16_t exponent[] = {
    0, 1, 2, 52, 53, 54, 511, 512, 872, 873, 874, 895, 896, 897, 898, 960, 969, 970, 971, 1021, 1022, 1023, 1024, 1025, 1030, 1031, 1038, 1039,
    1053, 1054, 1055, 1074, 1075, 1076, 1077, 1085, 1086, 1087, 1150, 1151, 1152, 1534, 1535, 2044, 2045, 2046, 2047,
};
static const uint64_t fraction[] = {
    0, 1, 2, 3, 0x000FFFFFFFFFFFFFu, 0x000FFFFFFFFFFFFEu, 0x0008000000000000u, 0x0007FFFFFFFFFFFFu, 0x0008000000000001u, 0x000FFFFFE0000000u,
    0x000FFFFFF0000000u, 0x0000000010000000u, 0x0000000020000000u, 0x0000000030000000u, 0x000000000FFFFFFFu, 0x0000000010000001u,
    0x00000000FFFFFFFFu, 0x0005555555555555u, 0x000AAAAAAAAAAAAAu, 0x0003243F6A8885A3u, 0x000FFFFFFFE00000u, 0x000E000000000000u,
};

size_t soft_specials(const uint64_t **list)
{
    if (specials == 0)
        for (size_t e = 0; e < sizeof exponent / sizeof *exponent; e++)
            for (size_t f = 0; f < sizeof fraction / sizeof *fraction; f++)
                put((uint64_t)exponent[e] << 52 | fraction[f]);
    *list = special;
    return specials;
}

static uint64_t next(uint64_t *state)                  // xorshift64*
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return *state * 0x2545F4914F6CDD1Du;
}

// Returns a fraction: any, one with few digits at either end, or one with long runs of equal digits.
static uint64_t random_fraction(uint64_t *state)
{
    const uint64_t r = next(state), any = next(state) >> 12;
    const unsigned n = (unsigned)(r >> 8) % 53;

    switch (r & 7) {
    case 0: return any >> n;
    case 1: return any >> n << n;
    case 2: return (any >> n << n) + (r >> 32 & 3) - 1;
    case 3: return ((uint64_t)1 << n) - 1;
    case 4: return (0x000FFFFFFFFFFFFFu << n) ^ (any & any >> 7 & 1);
    default: return any;
    }
}

static uint64_t random_number(uint64_t *state, uint64_t least, uint64_t count)
{
    return (next(state) & 0x8000000000000000u) | ((random_fraction(state) & 0x000FFFFFFFFFFFFFu) + ((least + next(state) % count) << 52));
}

// Returns an exponent that matches that of a: near it for sums; for products and quotients, one where the result leaves the range.
static uint64_t beside(SoftOp op, uint64_t *state, uint64_t a)
{
    const int64_t e = (int64_t)(a >> 52 & 0x7FF), off = (int64_t)(next(state) % 128) - 64, r = (int64_t)(next(state) % 4);
    int64_t want = e + off;

    if (op == SOFT_mul)
        want = r == 0 ? 1023 - e + off : r == 1 ? 3069 - e + off : want;
    else if (op == SOFT_div)
        want = r == 0 ? e + 1023 + off : r == 1 ? e - 1023 + off : want;
    want = want < 0 ? 0 : want > 2046 ? 2046 : want;
    return random_number(state, (uint64_t)want, 1);
}

// Returns operands whose result depends on a digit far below the others: a power of two minus a number that hardly reaches its last digit, or
// results near the smallest number.
static uint64_t far_below(SoftOp op, uint64_t *state, uint64_t *a)
{
    const int64_t e = (int64_t)(*a >> 52 & 0x7FF);
    int64_t want = e - 49 - (int64_t)(next(state) % 9);

    if (op == SOFT_mul || op == SOFT_div)
        want = op == SOFT_mul ? 974 - e + (int64_t)(next(state) % 8) - 7 : e + 1023 + 46 + (int64_t)(next(state) % 8);
    else
        *a = *a >> 52 << 52;
    want = want < 0 ? 0 : want > 2046 ? 2046 : want;
    return random_number(state, (uint64_t)want, 1);
}

void soft_random(SoftOp op, uint64_t *state, uint64_t *a, uint64_t *b)
{
    const uint64_t r = next(state);

    if (op >= SOFT_from_i32) {                         // integers and binary32 numbers of all lengths
        *a = next(state) >> (r >> 8 & 63);
        *a = r & 1 ? *a : r & 2 ? ~*a + 1 : random_fraction(state) << (r >> 16 & 15);
        *b = 0;
        return;
    }
    *a = (r & 15) == 0 ? next(state) : (r & 15) < 8 ? random_number(state, 0, 2047) : random_number(state, 1023 - 40, 120);
    *b = (r >> 4 & 15) == 0 ? next(state) : beside(op, state, *a);
    if ((r >> 8 & 7) == 1)
        *b = far_below(op, state, a);
    if ((r >> 8 & 7) == 0)                             // the same operand, or nearly
        *b = (*a ^ (r & 0x8000000000000000u)) + (r >> 16 & 3) - 1;
}
