// SPDX-License-Identifier: Apache-2.0
// Repeatable random numbers and bit patterns of F64 for unit tests.
#ifndef SM_TEST_RANDOM_H
#define SM_TEST_RANDOM_H

#include <stdint.h>

static uint64_t random_state = 0x9E3779B97F4A7C15u;

static inline uint64_t random_u64(void)      // xorshift64*
{
    random_state ^= random_state >> 12;
    random_state ^= random_state << 25;
    random_state ^= random_state >> 27;
    return random_state * 0x2545F4914F6CDD1Du;
}

// Bits of an F64, hard ones among them: any pattern, exponents near those of integers, few mantissa bits, specials.
static inline uint64_t random_f64_bits(void)
{
    static const uint64_t special[] = {
        0x0000000000000000u, 0x3FF0000000000000u, 0x3FE0000000000000u, 0x7FF0000000000000u, 0x7FF8000000000000u,
        0x7FF0000000000001u, 0x0000000000000001u, 0x000FFFFFFFFFFFFFu, 0x0010000000000000u, 0x7FEFFFFFFFFFFFFFu,
        0x43F0000000000000u, 0x43E0000000000000u, 0x41F0000000000000u, 0x41E0000000000000u, 0x47EFFFFFE0000000u,
        0x47EFFFFFF0000000u, 0x380FFFFFF0000000u, 0x36A0000000000000u, 0x3690000000000000u, 0x4330000000000000u,
    };
    const uint64_t r = random_u64(), sign = r & 0x8000000000000000u;
    switch (r & 7) {
    case 0: return random_u64();
    case 1: return special[(r >> 8) % (sizeof special / sizeof *special)] ^ sign;
    case 2: return (special[(r >> 8) % (sizeof special / sizeof *special)] + (r >> 20 & 7) - 4) ^ sign;
    case 3: return sign | (1023 - 4 + (r >> 8) % 140) << 52 | (random_u64() >> 12 & random_u64() & random_u64());
    case 4: return sign | (1023 - 160 + (r >> 8) % 300) << 52 | random_u64() >> 12;
    case 5: return sign | random_u64() >> 12;
    default: return sign | (1023 - 2 + (r >> 8) % 70) << 52 | random_u64() >> 12;
    }
}

#endif
