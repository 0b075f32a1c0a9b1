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
