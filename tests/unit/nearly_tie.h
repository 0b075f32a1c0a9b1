// SPDX-License-Identifier: Apache-2.0
// Numbers whose square roots are nearest to halfway between two F64 values, for tests of the square root.
#ifndef SMC_TEST_NEARLY_TIE_H
#define SMC_TEST_NEARLY_TIE_H

#include <stdint.h>

// Returns the k from 2^52 to 2^53 for which k^2 + k - c is divisible by 2^52; c must be even.  There is one even k and one odd k, of which
// `k` selects one.  Each step of Newton's method doubles the number of bits for which the condition is true.
static uint64_t solve_tie(uint64_t c, uint64_t k)
{
    for (int bits = 1; bits < 64; bits *= 2) {
        uint64_t inverse = 1;
        for (int i = 0; i < 6; i++)
            inverse *= 2 - (2 * k + 1) * inverse;
        k -= (k * k + k - c) * inverse;
    }
    return (k & (((uint64_t)1 << 52) - 1)) | (uint64_t)1 << 52;
}

#endif
