// SPDX-License-Identifier: Apache-2.0
// The common declarations of this folder's programs, on hosts and on chips, which compare soft binary64 with the computer's own.
#ifndef SOFT_TEST_H
#define SOFT_TEST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

typedef enum SoftOp {
#define OP(name, operands, soft, hardware) SOFT_##name,
#include "tests/soft/ops.def"
#undef OP
    SOFT_OPS
} SoftOp;

static inline uint32_t f32_bits(float v) { uint32_t u; memcpy(&u, &v, sizeof u); return u; }
static inline float f32_of(uint64_t a) { const uint32_t u = (uint32_t)a; float v; memcpy(&v, &u, sizeof v); return v; }

uint64_t soft_result(SoftOp op, uint64_t a, uint64_t b);      // subject.c
uint64_t hard_result(SoftOp op, uint64_t a, uint64_t b);      // hardware.c; a NaN is 0x7FF8000000000000
const char *soft_name(SoftOp op);                             // hardware.c
int soft_operands(SoftOp op);

static inline bool soft_same(uint64_t soft, uint64_t hard, SoftOp op)
{
    // A NaN that an operation selects or copies keeps its bits.
    const bool as_it_is = op >= SOFT_min && op <= SOFT_round;

    return soft == hard || (as_it_is && hard == 0x7FF8000000000000u && soft << 1 > 0xFFE0000000000000u);
}

// Operands for which errors are likely (vectors.c).
size_t soft_specials(const uint64_t **list);                  // about 2000
void soft_random(SoftOp op, uint64_t *state, uint64_t *a, uint64_t *b);

#endif
