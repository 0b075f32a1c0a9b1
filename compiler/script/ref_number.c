// SPDX-License-Identifier: Apache-2.0
// Numbers of the reference: conversion of cells to doubles and back, and the pure builtins.  Plain C on doubles, without bit
// manipulation: the other implementations work on bits, this one compares and calculates, and so they check each other.  Only an
// F32 or F64 is copied with memcpy, because its cell has the bits of the C type.
#include "compiler/script/ref.h"

#include <float.h>
#include <string.h>

static bool is_nan(double x) { return x != x; }
static bool is_infinite(double x) { return x > DBL_MAX || x < -DBL_MAX; }
static double make_nan(void) { double inf = DBL_MAX * 2; return inf - inf; }

// Whether a condition with this value is true: not zero and not NaN.
bool ref_true(double x) { return x != 0 && !is_nan(x); }

// Whether x is below zero or -0; false for NaN.
bool ref_negative(double x) { return x < 0 || (x == 0 && 1 / x < 0); }

// ---- cells to doubles ----

static double read_signed(uint64_t cell, unsigned bits)
{
    uint64_t half = (uint64_t)1 << (bits - 1);        // as a cell, the smallest number of the type: -2^(bits - 1)

    if (cell < half)
        return (double)cell;
    return -(double)(half - (cell - half));           // -(2^bits - cell)
}

static double read_f32(uint64_t cell)
{
    uint32_t bits = (uint32_t)cell;
    float f;

    memcpy(&f, &bits, sizeof f);
    return f;
}

static double read_f64(uint64_t cell)
{
    double d;

    memcpy(&d, &cell, sizeof d);
    return d;
}

// Returns the value of a cell as an F64; a stored NaN reads as 0.
double ref_read(SmType type, uint64_t cell)
{
    const SmTypeInfo *info = &sm_type_info[type];
    double x = 0;

    switch (info->kind) {
    case SM_KIND_SIGNED: x = read_signed(cell, info->bytes * 8u); break;
    case SM_KIND_UNSIGNED: x = (double)cell; break;
    case SM_KIND_FLOAT: x = type == SM_F32 ? read_f32(cell) : read_f64(cell); break;
    case SM_KIND_BOOL: x = cell != 0; break;
    }
    return is_nan(x) ? 0 : x;
}

// ---- doubles to cells ----

static double power_of_two(unsigned n)
{
    return n < 64 ? (double)((uint64_t)1 << n) : 18446744073709551616.0;          // n <= 64
}

// Converts x to a signed integer of this many bits: truncated, and saturated; NaN becomes 0.  A C cast truncates, but is undefined outside
// the integer's range.
static uint64_t to_signed(double x, unsigned bits)
{
    uint64_t half = (uint64_t)1 << (bits - 1);
    double limit = power_of_two(bits - 1);            // the smallest number that is too large; -limit is the smallest that fits

    if (is_nan(x))
        return 0;
    if (x >= limit)
        return half - 1;
    if (x <= -limit)
        return half;
    if (x > -1)
        return (uint64_t)x;
    return half + (half - (uint64_t)-x);              // 2^bits - |x|, the two's complement
}

// Converts x to an unsigned integer of this many bits: truncated, and saturated; NaN becomes 0.
static uint64_t to_unsigned(double x, unsigned bits)
{
    if (is_nan(x) || x <= 0)
        return 0;
    if (x >= power_of_two(bits))
        return UINT64_MAX >> (64 - bits);
    return (uint64_t)x;
}

// Converts x to a cell of F32.  A C cast rounds to nearest even if the result is in range.  FLT_MAX plus half a unit in the last place is out of
// range, and becomes infinity.
static uint64_t to_f32(double x)
{
    const double limit = 0x1.ffffffp127;              // 2^128 - 2^103; FLT_MAX is 2^128 - 2^104
    float inf = FLT_MAX * 2, f;
    uint32_t bits;

    if (x >= limit)
        f = inf;
    else if (x <= -limit)
        f = -inf;
    else
        f = (float)x;
    memcpy(&bits, &f, sizeof bits);
    return bits;
}

static uint64_t to_f64(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

// Returns the cell of a variable of `type` after x is stored in it.
uint64_t ref_convert(SmType type, double x)
{
    const SmTypeInfo *info = &sm_type_info[type];

    switch (info->kind) {
    case SM_KIND_SIGNED: return to_signed(x, info->bytes * 8u);
    case SM_KIND_UNSIGNED: return to_unsigned(x, info->bytes * 8u);
    case SM_KIND_FLOAT:
        if (is_nan(x))
            return 0;
        return type == SM_F32 ? to_f32(x) : to_f64(x);
    case SM_KIND_BOOL: return ref_true(x);
    }
    return 0;
}

// ---- pure builtins ----

// Returns `zero` with the sign of x.
static double copy_sign_to_zero(double zero, double x) { return ref_negative(x) ? -zero : zero; }

static double ref_trunc(double x)
{
    double whole;

    if (is_nan(x) || x >= power_of_two(52) || x <= -power_of_two(52))
        return x;                                     // doubles from 2^52 on have no fraction
    whole = (double)(int64_t)x;
    return whole == 0 ? copy_sign_to_zero(0.0, x) : whole;
}

static double ref_floor(double x) { double t = ref_trunc(x); return t > x ? t - 1 : t; }
static double ref_ceil(double x) { return -ref_floor(-x); }

static double ref_round(double x)
{
    double t = ref_trunc(x), fraction = x - t;        // exact; for an infinity NaN, with which both comparisons below are false

    if (fraction >= 0.5)
        return t + 1;
    if (fraction <= -0.5)
        return t - 1;
    return t;
}

static double ref_abs(double x) { return ref_negative(x) ? -x : x; }

static double ref_sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : x; }

static double ref_min(double a, double b)
{
    if (is_nan(a) || is_nan(b))
        return make_nan();
    if (a == b)
        return ref_negative(a) ? a : b;               // of two zeros -0 is the smaller
    return a < b ? a : b;
}

static double ref_max(double a, double b) { return -ref_min(-a, -b); }

// An unsigned integer of 128 bits.
typedef struct Wide { uint64_t high, low; } Wide;

static Wide multiply_wide(uint64_t a, uint64_t b)           // long multiplication in halves of 32 bits; a, b < 2^54
{
    uint64_t a1 = a >> 32, a0 = a & 0xffffffff, b1 = b >> 32, b0 = b & 0xffffffff;
    uint64_t middle = a1 * b0 + a0 * b1 + (a0 * b0 >> 32);
    Wide w = {a1 * b1 + (middle >> 32), middle << 32 | (a0 * b0 & 0xffffffff)};

    return w;
}

static bool is_at_most(Wide a, Wide b) { return a.high < b.high || (a.high == b.high && a.low <= b.low); }

// Returns the square root of f (1 <= f < 4), rounded: k / 2^52 for the integer k nearest to the root of f * 2^104.  Bisection finds
// k.  The root is never half-way between k and k + 1.  It is nearer to k + 1 exactly if f * 2^104, an integer, is above k * (k + 1), which is (k +
// 1/2)^2 minus a quarter.
static double sqrt_of_1_to_4(double f)
{
    uint64_t n = (uint64_t)(f * power_of_two(52)), low = (uint64_t)1 << 52, high = low * 2;
    Wide wanted = {n >> 12, n << 52};

    while (high - low > 1) {
        uint64_t middle = low + (high - low) / 2;
        if (is_at_most(multiply_wide(middle, middle), wanted))
            low = middle;
        else
            high = middle;
    }
    return (double)(is_at_most(wanted, multiply_wide(low, low + 1)) ? low : low + 1) / power_of_two(52);
}

static double ref_sqrt(double x)
{
    double scale = 1;

    if (x < 0)
        return make_nan();
    if (x == 0 || is_nan(x) || is_infinite(x))
        return x;
    for (; x >= 4; x /= 4)                            // exact, like every multiplication or division by a power of two below
        scale *= 2;
    for (; x < 1; x *= 4)
        scale /= 2;
    return sqrt_of_1_to_4(x) * scale;
}

static double ref_clamp(double x, double lo, double hi) { return ref_min(ref_max(x, lo), hi); }

double ref_list(SmBuiltin fn, double *x, uint32_t n)
{
    double extreme = x[0];
    bool nan = false;

    for (uint32_t i = 1; i < n; i++)
        extreme = fn == SM_FN_min ? ref_min(extreme, x[i]) : ref_max(extreme, x[i]);
    if (fn != SM_FN_average && fn != SM_FN_median)
        return extreme;
    for (uint32_t i = 0; i < n; i++)
        nan |= is_nan(x[i]);
    return nan ? make_nan() : fn == SM_FN_average ? ref_average(x, n) : ref_median(x, n);
}

#define CALL_1(f) f(arg[0])
#define CALL_2(f) f(arg[0], arg[1])
#define CALL_3(f) f(arg[0], arg[1], arg[2])

// Returns the result of a builtin that depends on its arguments alone.
double ref_pure(SmBuiltin fn, const double *arg)
{
    switch (fn) {
#define SM_PURE(name, arguments, usage, units, sentence) case SM_FN_##name: return CALL_##arguments(ref_##name);
#define SM_COMPOSED(name, arguments, usage, units, steps, sentence) SM_PURE(name, arguments, usage, units, sentence)
#define SM_LIST(name, units, sentence) case SM_FN_##name:
#define SM_ROLL(name, stat, sentence) case SM_FN_##name:
#define SM_SAMPLED(name, arguments, usage, sentence) case SM_FN_##name:
#include "stdlib/builtins.def"
    case SM_FN_COUNT: break;                          // ref_list, or a rolling statistic, which is an EX_ROLL and never a call
    }
    return make_nan();
}
