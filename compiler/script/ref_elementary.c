// SPDX-License-Identifier: Apache-2.0
// The elementary functions of the reference, from the specification in docs/elementary.md: the same sequences of roundings as stdlib/elementary.h,
// written a second time.  Plain C on doubles.  Whole numbers and comparisons replace the operations on bits.
#include "compiler/script/ref.h"

#include <float.h>

// ---- powers of two ----

static bool is_nan(double x) { return x != x; }
static double make_nan(void) { double inf = DBL_MAX * 2; return inf - inf; }
static double make_infinity(void) { return DBL_MAX * 2; }
static bool is_infinite(double x) { return x > DBL_MAX || x < -DBL_MAX; }
static double magnitude(double x) { return ref_negative(x) ? -x : x; }

// Returns 2^n, n from -1022 to 1023.
static double two_to(int n)
{
    double base = n < 0 ? 0.5 : 2, x = 1;

    for (n = n < 0 ? -n : n; n > 0; n /= 2, base *= base)
        if (n % 2 == 1)
            x *= base;
    return x;
}

// Returns the exponent e of a finite x above 0: 2^e <= x < 2^(e + 1).
static int exponent_of(double x)
{
    int e = 0;

    if (x < two_to(-1022)) {
        x *= two_to(600);
        e = -600;
    }
    for (int step = 512; step > 0; step /= 2) {
        if (x >= two_to(step)) {
            x *= two_to(-step);
            e += step;
        } else if (x < two_to(1 - step)) {
            x *= two_to(step);
            e -= step;
        }
    }
    if (x < 1)
        e--;
    return e;
}

// Returns x truncated to 26 significant bits; a number below the normal ones to a multiple of 2^-1047.
static double first_bits(double x)
{
    const double size = magnitude(x);
    double whole;
    int e;

    if (x == 0 || is_nan(x) || is_infinite(x))
        return x;
    e = exponent_of(size);
    if (e < -1022)
        e = -1022;
    whole = e < 0 ? size * two_to(-e / 2) * two_to(-e - -e / 2) : size * two_to(-e);
    whole = (double)(int64_t)(whole * two_to(25)) / two_to(25);
    whole = e < 0 ? whole * two_to(-(-e / 2)) * two_to(e + -e / 2) : whole * two_to(e);
    return ref_negative(x) ? -whole : whole;
}

// ---- sums of two numbers (docs/elementary.md, Pairs) ----

// A number as the exact sum of two doubles: `big` is the sum rounded to a double, `small` the rest.
typedef struct Sum { double big, small; } Sum;

// Fast2Sum (Dekker): big + small is exactly a + b.  Requires |a| >= |b|, or a = 0.
static Sum sum_of(double a, double b)
{
    Sum s;

    s.big = a + b;
    s.small = (a - s.big) + b;
    return s;
}

// Returns x * x as a sum of two doubles, without rounding.
static Sum squared(double x)
{
    const double first = first_bits(x);
    const Sum s = {first * first, (x - first) * (x + first)};

    return s;
}

// Returns a / b with about twice the precision of a double.
static Sum quotient(Sum a, Sum b)
{
    const double inverse = 1 / b.big, first = first_bits(b.big), q = first_bits(a.big * inverse);
    const double rest = (a.big - q * first) - q * ((b.big - first) + b.small);
    const Sum s = {q, (rest + a.small) * inverse};

    return s;
}

// Returns the product of a and the constant first + second; `all` is this constant rounded to one double.
static Sum product(Sum a, double first, double second, double all)
{
    const double head = first_bits(a.big);
    const Sum s = {head * first, head * second + ((a.big - head) + a.small) * all};

    return s;
}

// Returns c[0] + c[1] z + ... + c[n - 1] z^(n - 1), n even: the sums of the even and of the odd powers, each by Horner's rule in z^2.
static double polynomial(const double *c, int n, double z)
{
    double part[2] = {0, 0};

    for (int parity = 0; parity < 2; parity++) {
        part[parity] = c[n - 2 + parity];
        for (int i = n - 4 + parity; i >= 0; i -= 2)
            part[parity] = part[parity] * (z * z) + c[i];
    }
    return part[0] + part[1] * z;
}

// ---- exp ----

static const double exp_c[12] = {
    0x1.0000000000000p-1, 0x1.5555555555555p-3, 0x1.5555555555557p-5, 0x1.1111111111113p-7,
    0x1.6c16c16c15a6bp-10, 0x1.a01a01a0188dcp-13, 0x1.a01a01a9e84ccp-16, 0x1.71de3a5ec3102p-19,
    0x1.27e4d41cdb611p-22, 0x1.ae641b6b5eee4p-26, 0x1.1f7f20fc91dc7p-29, 0x1.61d9881430183p-33
};

// Returns exp(big + small): reduces the argument by multiples of ln 2 and evaluates a polynomial.
static double exp_of_sum(double big, double small)
{
    const double turns = big * 0x1.71547652b82fep+0;
    const double k = (double)(int32_t)(turns + (ref_negative(big) ? -0.5 : 0.5));
    const Sum r = sum_of(big - k * 0x1.62e42fefa3800p-1, small - k * 0x1.ef35793c76730p-45), one = sum_of(1, r.big);
    const double y = one.big + (one.small + (r.small * one.big + r.big * r.big * polynomial(exp_c, 12, r.big)));
    const int half = (int)k / 2;

    return y * two_to(half) * two_to((int)k - half);
}

double ref_exp(double x)
{
    return is_nan(x) ? x : x > 710 ? make_infinity() : x < -746 ? 0 : exp_of_sum(x, 0);
}

// ---- log, log10, pow ----

static const double log_c[8] = {
    0x1.999999999999ap-2, 0x1.2492492492523p-2, 0x1.c71c71c6ea423p-3, 0x1.745d177ae0e90p-3,
    0x1.3b1395b5f08cdp-3, 0x1.1118cd53af741p-3, 0x1.df7bbec160c99p-4, 0x1.e038702fa10fcp-4
};

// Returns s (base + (z + z_rest) (first + second + w)), as docs/elementary.md, Pairs, specifies.
static Sum series(Sum s, double z, double z_rest, double base, double first, double second, double w)
{
    const double p = first_bits(first + w), p_rest = (first - p) + (second + w), head = first_bits(z);
    const double zp = head * p, zp_rest = head * p_rest + ((z - head) + z_rest) * (p + p_rest);
    const double q = first_bits(base + zp), q_rest = ((base - q) + zp) + zp_rest;
    const Sum result = {s.big * q, s.big * q_rest + s.small * (q + q_rest)};

    return result;
}

// Returns ln m, where x = m 2^e with m from sqrt(1/2), rounded up, to sqrt 2; sets *e.
static Sum log_of_mantissa(double x, double *e)
{
    int exponent = exponent_of(x);
    double m = exponent < -1022 ? x * two_to(600) * two_to(-exponent - 600) : exponent == 1023 ? x / 2 * two_to(-1022) : x * two_to(-exponent);
    double z, w, z_rest;
    Sum s, numerator, denominator;

    if (m >= 2 * 0x1.6a09e667f3bcdp-1) {
        m /= 2;
        exponent++;
    }
    *e = exponent;
    numerator.big = m - 1;
    numerator.small = 0;
    denominator.big = m + 1;
    denominator.small = m - (denominator.big - 1);
    s = quotient(numerator, denominator);
    z = s.big * s.big;
    z_rest = s.small * ((s.big + s.big) + s.small);
    w = (z + z_rest) * polynomial(log_c, 8, z + z_rest);
    return series(s, z, z_rest, 2, 0x1.5555555555555p-1, 0x1.5555555555555p-55, w);
}

// Whether the logarithm of x is special, because x is not a positive finite number; *y is then the result.
static bool is_simple_log(double x, double *y)
{
    *y = is_nan(x) ? x : x == 0 ? -make_infinity() : x < 0 ? make_nan() : x;
    return !(x > 0 && x <= DBL_MAX);
}

// Returns ln x as a sum of two doubles; x is positive and finite.
static Sum log_sum(double x)
{
    double e;
    const Sum m = log_of_mantissa(x, &e);
    Sum s = sum_of(e * 0x1.62e42fefa3800p-1, m.big);

    s.small = s.small + (m.small + e * 0x1.ef35793c76730p-45);
    return s;
}

double ref_log(double x)
{
    double y;
    Sum s;

    if (is_simple_log(x, &y))
        return y;
    s = log_sum(x);
    return s.big + s.small;
}

double ref_log10(double x)
{
    double y, e;
    Sum m, s;

    if (is_simple_log(x, &y))
        return y;
    m = log_of_mantissa(x, &e);
    m = product(m, 0x1.bcb7b10000000p-2, 0x1.49b9438ca9aaep-28, 0x1.bcb7b1526e50ep-2);
    s = sum_of(e * 0x1.34413509f7800p-2, m.big);
    return s.big + (s.small + (m.small + e * 0x1.fef311f12b358p-46));
}

// Returns x^y = exp(y ln x) for positive x.
static double pow_of_positive(double x, double y)
{
    const Sum rough = log_sum(x), log = sum_of(rough.big, rough.small);
    const double head = first_bits(log.big), y_head = first_bits(y);
    Sum s;

    if (y * log.big > 710)
        return make_infinity();
    if (y * log.big < -746)
        return 0;
    s = sum_of(y_head * head, y_head * ((log.big - head) + log.small) + (y - y_head) * log.big);
    return exp_of_sum(s.big, s.small);
}

// is_whole: whether y is a whole number or infinite.  is_odd: whether y is an odd whole number; from 2^53 on every double is even.
static bool is_whole(double y) { return magnitude(y) >= two_to(52) || (double)(int64_t)y == y; }
static bool is_odd(double y) { return magnitude(y) < two_to(53) && is_whole(y) && (int64_t)y % 2 != 0; }

double ref_pow(double x, double y)
{
    const double size = magnitude(x);
    double z;

    if (y == 0 || x == 1 || (x == -1 && is_infinite(y)))
        return 1;
    if (is_nan(x) || is_nan(y))
        return make_nan();
    if (is_infinite(y) || x == 0 || is_infinite(x))
        z = (size > 1) == (y > 0) ? make_infinity() : 0;
    else if (x < 0 && !is_whole(y))
        return make_nan();
    else
        z = pow_of_positive(size, y);
    return ref_negative(x) && is_odd(y) ? -z : z;
}

// ---- sin, cos, tan ----

enum { TURN_DIGITS = 39 };    // number of entries of the table with 2 / pi below
static const uint32_t turn_digit[TURN_DIGITS] = {
    0x00000000, 0x00000000, 0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041,
    0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e,
    0xe88235f5, 0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b,
    0x1ff897ff, 0xde05980f, 0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d,
    0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046,
};

// Multiplies mantissa by the 192 bits of turn_digit from bit `first` on, modulo 2^192: product[0] has the highest of 12 digits of 16 bits.
static void multiply_turns(uint64_t mantissa, int first, uint32_t product[12])
{
    uint32_t window[12];

    for (int i = 0; i < 12; i++) {
        window[i] = 0;
        for (int b = first + 16 * i; b < first + 16 * i + 16; b++)
            window[i] = window[i] * 2 + (turn_digit[b / 32] >> (31 - b % 32) & 1);
        product[i] = 0;
    }
    for (int j = 0; j < 4; j++) {
        const uint32_t digit = (uint32_t)(mantissa >> 16 * j & 0xffff);
        uint32_t carry = 0;
        for (int i = 11; i - j >= 0; i--) {
            const uint64_t sum = (uint64_t)digit * window[i] + product[i - j] + carry;
            product[i - j] = (uint32_t)(sum & 0xffff);
            carry = (uint32_t)(sum >> 16);
        }
    }
}

// Returns the 32 bits of the number whose digits are product[], from bit `first` on; bits after the last are 0.
static uint32_t bits_from(const uint32_t product[12], int first)
{
    uint32_t bits = 0;

    for (int b = first; b < first + 32; b++)
        bits = bits * 2 + (b < 192 ? product[b / 16] >> (15 - b % 16) & 1 : 0);
    return bits;
}

// Sets *r to x - k pi/2 for the whole k nearest to x 2/pi; returns k modulo 4.
static int reduce(double x, Sum *r)
{
    const double size = magnitude(x);
    uint32_t product_digit[12], flip;
    double part[4];
    Sum s;
    int e, k, from = 2;

    r->big = x;
    r->small = 0;
    if (size < 0x1.921fb54442d18p-1)
        return 0;
    e = exponent_of(size);
    multiply_turns((uint64_t)(e >= 52 ? size * two_to(52 - e) : size * two_to(52 - e)), e + 10, product_digit);
    k = (int)(product_digit[0] >> 14);
    flip = product_digit[0] >> 13 & 1 ? 0xffffffff : 0;
    if ((bits_from(product_digit, 2) ^ flip) == 0)
        from = 34;
    for (int i = 0; i < 4; i++) {
        // The two lowest bits, which the specification shifts in as zeros before it flips all bits, are beyond the 160 bits used here.
        part[i] = (double)(bits_from(product_digit, from + 32 * i) ^ flip) * two_to(-(from - 2) - 32 * (i + 1));
    }
    s = sum_of(part[0], part[1]);
    s.small = s.small + (part[2] + part[3]);
    s = product(s, 0x1.921fb50000000p+0, 0x1.110b4611a6263p-26, 0x1.921fb54442d18p+0);
    *r = sum_of(s.big, s.small);
    if ((flip != 0) != (x < 0)) {
        r->big = -r->big;
        r->small = -r->small;
    }
    k += flip != 0;
    return (x < 0 ? 8 - k : k) % 4;
}

static const double sin_c[8] = {
    -0x1.5555555555555p-3, 0x1.1111111111111p-7, -0x1.a01a01a01a019p-13, 0x1.71de3a556c2c9p-19,
    -0x1.ae64567e732e7p-26, 0x1.61245fb516b06p-33, -0x1.ae7c53deed862p-41, 0x1.9242c4cc3855ep-49
};
static const double cos_c[6] = {
    0x1.5555555555555p-5, -0x1.6c16c16c16967p-10, 0x1.a01a019f4ec88p-16, -0x1.27e4fa17f5b80p-22,
    0x1.1eeb6902cbf33p-29, -0x1.907db3eeba61fp-37
};

static const double tan_c[6] = {
    0x1.1111111111111p-7, -0x1.a01a01a019ed6p-13, 0x1.71de3a550cc07p-19, -0x1.ae64553439e50p-26,
    0x1.61225b4f8da28p-33, -0x1.ab9408a23ca6ap-41
};

static Sum sin_series(Sum r)
{
    const double first = first_bits(r.big);
    const Sum s = {first, (r.big - first) + r.small};
    const double z = s.big * s.big, z_rest = s.small * ((s.big + s.big) + s.small), v = z + z_rest;

    return series(s, z, z_rest, 1, -0x1.5555555555555p-3, -0x1.5555555555555p-57, v * polynomial(tan_c, 6, v));
}

// Returns sin r for |r| up to pi/4, as a sum of two doubles.
static Sum sin_sum(Sum r)
{
    const double z = r.big * r.big;
    const Sum s = {r.big, r.small * (1 - z * 0.5) + r.big * z * polynomial(sin_c, 8, z)};

    return s;
}

// Returns cos r for |r| up to pi/4, as a sum of two doubles.
static Sum cos_sum(Sum r)
{
    const Sum square = squared(r.big);
    const double z = square.big + square.small;
    Sum s = sum_of(1, -(square.big * 0.5));

    s.small = (s.small - (square.small * 0.5 + r.big * r.small)) + z * z * polynomial(cos_c, 6, z);
    return s;
}

// Returns sin(r + k pi/2).
static double sin_of(Sum r, int k)
{
    const Sum s = k % 2 ? cos_sum(r) : sin_sum(r);

    return k % 4 >= 2 ? -(s.big + s.small) : s.big + s.small;
}

static bool is_tiny(double x) { return magnitude(x) < two_to(-27); }

double ref_sin(double x)
{
    Sum r;
    int k;

    if (is_nan(x) || is_infinite(x))
        return make_nan();
    if (is_tiny(x))
        return x;
    k = reduce(x, &r);
    return sin_of(r, k);
}

double ref_cos(double x)
{
    Sum r;
    int k;

    if (is_nan(x) || is_infinite(x))
        return make_nan();
    k = reduce(x, &r);
    return sin_of(r, k + 1);
}

double ref_tan(double x)
{
    Sum r, s, c;
    int k;

    if (is_nan(x) || is_infinite(x))
        return make_nan();
    if (is_tiny(x))
        return x;
    k = reduce(x, &r);
    s = sin_series(r);
    c = cos_sum(r);
    s = sum_of(s.big, s.small);
    c = sum_of(c.big, c.small);
    r = k % 2 ? quotient(c, s) : quotient(s, c);
    return k % 2 ? -(r.big + r.small) : r.big + r.small;
}

// ---- asin, acos, atan, atan2, hypot ----

static const double atan_c[8] = {
    -0x1.5555555555555p-2, 0x1.9999999999956p-3, -0x1.24924924854e7p-3, 0x1.c71c71a8d71eep-4,
    -0x1.745d05ebfb2e7p-4, 0x1.3b0e48255dd35p-4, -0x1.1020e41b47ea9p-4, 0x1.b6178fe602a5bp-5
};
static const double arc[4][2] = {
    {0, 0},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

// Returns the angle of the point (x, y), or with `left` of (-x, y).  x and y are at least 0.
static double angle_of_point(Sum y, Sum x, bool left)
{
    const bool steep = y.big > x.big;
    const Sum a = steep ? x : y, b = steep ? y : x;
    const double step[4] = {0, 0.25, 0.5, 1};
    const int i = a.big < b.big * 0.125 ? 0 : a.big < b.big * 0.375 ? 1 : a.big < b.big * 0.71875 ? 2 : 3;
    const double sign = steep != left ? -1 : 1, z_base = steep ? 0x1.921fb54442d18p+0 : left ? 0x1.921fb54442d18p+1 : 0;
    const double z_rest = steep ? 0x1.1a62633145c07p-54 : left ? 0x1.1a62633145c07p-53 : 0;
    Sum numerator, denominator, t, first, second;
    double z, square;

    numerator.big = a.big - step[i] * b.big;
    numerator.small = a.small - step[i] * b.small;
    denominator = sum_of(b.big, step[i] * a.big);
    denominator.small = denominator.small + (b.small + step[i] * a.small);
    t = quotient(numerator, denominator);
    z = t.big + t.small;
    square = z * z;
    t.small = t.small + z * square * polynomial(atan_c, 8, square);
    first = sum_of(z_base, sign * arc[i][0]);
    second = sum_of(first.big, sign * t.big);
    return second.big + (second.small + (first.small + (z_rest + sign * (arc[i][1] + t.small))));
}

static double copy_sign(double y, double x) { return ref_negative(x) ? -y : y; }
static Sum single_sum(double x) { const Sum s = {x, 0}; return s; }

double ref_atan(double x)
{
    if (is_nan(x) || is_tiny(x))
        return x;
    if (magnitude(x) > two_to(64))
        return copy_sign(0x1.921fb54442d18p+0, x);
    return copy_sign(angle_of_point(single_sum(magnitude(x)), single_sum(1), false), x);
}

// Returns the power of two by which two numbers are multiplied so that products of them are in range; `larger`: the larger of the two.
static double scale_of(double larger) { return larger > two_to(500) ? two_to(-600) : larger < two_to(-400) ? two_to(600) : 1; }

double ref_atan2(double y, double x)
{
    double a = magnitude(y), b = magnitude(x), scale;

    if (is_nan(x) || is_nan(y))
        return make_nan();
    if (is_infinite(x) || is_infinite(y)) {
        a = is_infinite(y);
        b = is_infinite(x);
    } else if (a == b) {
        a = a == 0 ? 0 : 1;
        b = 1;
    }
    scale = scale_of(a > b ? a : b);
    if (a * scale <= b * scale * two_to(-64))
        return copy_sign(ref_negative(x) ? 0x1.921fb54442d18p+1 : a / b, y);
    if (b * scale <= a * scale * two_to(-64))
        return copy_sign(0x1.921fb54442d18p+0, y);
    return copy_sign(angle_of_point(single_sum(a * scale), single_sum(b * scale), ref_negative(x)), y);
}

// Returns the square root as a sum of two doubles, by Newton's method.
static Sum square_root(Sum x)
{
    const int e = x.big == 0 ? 0 : exponent_of(x.big);
    double y, rest;
    Sum root, square;

    // The estimate is linear in x between powers of two: the bits of the estimate are 0x5FE6EB0000000000 minus half of the bits of x.
    if (x.big == 0)
        return single_sum(0);
    {
        const double mantissa = x.big * two_to(-e);            // 1 <= mantissa < 2
        const int64_t half = ((int64_t)(e + 1023) * ((int64_t)1 << 52) + (int64_t)((mantissa - 1) * two_to(52))) / 2;
        const int64_t bits = 0x5fe6eb0000000000 - half;
        y = (1 + (double)(bits % ((int64_t)1 << 52)) / two_to(52)) * two_to((int)(bits / ((int64_t)1 << 52)) - 1023);
    }
    for (int i = 0; i < 3; i++)
        y = y * (1.5 - x.big * 0.5 * y * y);
    root.big = x.big * y;
    square = squared(root.big);
    rest = ((x.big - square.big) - square.small) + x.small;
    root.small = rest * (y * 0.5);
    return root;
}

// Returns sqrt(1 - x^2), for x from 0 to 1, as a sum of two doubles.
static Sum other_leg(double x)
{
    const Sum sum = sum_of(1, x), difference = sum_of(1, -x);
    const double head = first_bits(sum.big), head2 = first_bits(difference.big);
    double small = head * (difference.big - head2) + (sum.big - head) * difference.big;

    small = small + (sum.small * difference.big + sum.big * difference.small);
    return square_root(sum_of(head * head2, small));
}

double ref_asin(double x)
{
    if (magnitude(x) > 1)
        return make_nan();
    if (is_nan(x) || is_tiny(x))
        return x;
    return copy_sign(angle_of_point(single_sum(magnitude(x)), other_leg(magnitude(x)), false), x);
}

double ref_acos(double x)
{
    if (is_nan(x) || magnitude(x) > 1)
        return make_nan();
    return angle_of_point(other_leg(magnitude(x)), single_sum(magnitude(x)), x < 0);
}

double ref_hypot(double x, double y)
{
    double a = magnitude(x), b = magnitude(y), scale;
    Sum p, q, sum;

    if (is_infinite(x) || is_infinite(y))
        return make_infinity();
    if (is_nan(x) || is_nan(y))
        return make_nan();
    if (a < b) {
        scale = a;
        a = b;
        b = scale;
    }
    if (b <= a * two_to(-28))
        return a;
    scale = scale_of(a);
    p = squared(a * scale);
    q = squared(b * scale);
    sum = sum_of(p.big, q.big);
    sum = sum_of(sum.big, sum.small + (p.small + q.small));
    p = square_root(sum);
    return (p.big + p.small) / scale;
}
