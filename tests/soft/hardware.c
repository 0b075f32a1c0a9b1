// SPDX-License-Identifier: Apache-2.0
// The same operations with the computer's own double.  They are the expected results.
#include <math.h>

#include "tests/soft/cells.h"

static uint64_t hard(double x)
{
    uint64_t u;

    memcpy(&u, &x, sizeof u);
    return x != x ? 0x7FF8000000000000u : u;
}

static double of_bits(uint64_t a)
{
    double x;

    memcpy(&x, &a, sizeof x);
    return x;
}

static uint64_t hard_min(double x, double y)
{
    if (x != x || y != y)
        return hard(x + y);
    return hard(x < y || (x == y && signbit(x)) ? x : y);
}

static uint64_t hard_max(double x, double y)
{
    if (x != x || y != y)
        return hard(x + y);
    return hard(x > y || (x == y && !signbit(x)) ? x : y);
}

static int64_t hard_clip(double x, int64_t lo, int64_t hi)
{
    if (x != x)
        return 0;
    return x <= (double)lo ? lo : x >= (double)hi ? hi : (int64_t)x;
}

static int64_t hard_to_i64(double x)
{
    return x >= 9223372036854775808.0 ? INT64_MAX : x < -9223372036854775808.0 ? INT64_MIN : x != x ? 0 : (int64_t)x;
}

static uint64_t hard_to_u64(double x)
{
    return x >= 18446744073709551616.0 ? UINT64_MAX : x > 0 ? (uint64_t)x : 0;
}

// Whether x is beyond the limit whose upper half is n: above a positive limit, or below a negative one.  NaN counts as 0.
static bool hard_beyond(double x, uint32_t n)
{
    const double y = of_bits((uint64_t)n << 32);

    x = x != x ? 0 : x;
    return signbit(y) ? x < y : x > y;
}

static bool hard_reaches(double x, uint32_t n) { return hard_beyond(x, n) || x == of_bits((uint64_t)n << 32); }
static bool hard_beyond_f32(float x, float y) { return x == x && (signbit(y) ? x < y : x > y); }
static bool hard_reaches_f32(float x, float y) { return hard_beyond_f32(x, y) || x == y; }

// Their sum, if no sample but 0 is too small beside the largest; otherwise 0.
static uint64_t hard_sum_f32(uint64_t a, uint64_t b)
{
    uint32_t key[CELL_SAMPLES];
    const uint8_t n = cell_samples(a, b, key);
    double sum = 0, x;
    int most = -125, e;

    for (int pass = 0; pass < 2; pass++)
        for (uint8_t i = 0; i < n; i++) {
            x = (double)f32_of(key[i] >> 31 != 0 ? key[i] ^ 0x7FFFFFFFu : key[i]);
            if (x - x != 0)
                return 0;
            frexp(x, &e);
            e = x == 0 ? most : e < -125 ? -125 : e;       // subnormal numbers have the exponent of the smallest normal ones
            if (most - e > 15 && pass == 1)
                return 0;
            most = e > most ? e : most;
            sum += pass == 1 ? x : 0;
        }
    return sum == 0 ? 0 : hard(sum);
}

uint64_t hard_result(SoftOp op, uint64_t a, uint64_t b)
{
    const double x = of_bits(a), y = of_bits(b);

    switch (op) {
#define OP(name, operands, soft, hardware) case SOFT_##name: return (uint64_t)(hardware);
#include "tests/soft/ops.def"
#undef OP
    case SOFT_OPS: break;
    }
    return 0;
}

const char *soft_name(SoftOp op)
{
    static const char *const name[] = {
#define OP(name, operands, soft, hardware) #name,
#include "tests/soft/ops.def"
#undef OP
    };
    return name[op];
}

int soft_operands(SoftOp op)
{
    static const int n[] = {
#define OP(name, operands, soft, hardware) operands,
#include "tests/soft/ops.def"
#undef OP
    };
    return n[op];
}
