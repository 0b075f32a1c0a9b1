// SPDX-License-Identifier: Apache-2.0
// The elementary functions (language.md 3.34 to 3.41): exp, log, log10, pow, sin, cos, tan, asin, acos, atan, atan2, hypot.
//
// Each is one fixed sequence of binary64 operations, each rounded, and of operations on integers: no fused multiply-add, no libm.  So a result has
// the same bits on every target.  No function calls itself, and every loop has a constant number of iterations.
// docs/elementary.md specifies the sequences step by step.  Errors are below 1 ulp (tests/elementary/precision.c).
//
// A number that needs more than 53 bits is a pair, an unevaluated sum hi + lo with |lo| far below |hi|.  Products are exact where
// both factors have at most 26 significant bits; sm_head makes such factors.  tests/elementary/coefficients.py computes all constants.
//
// Lines `// snippet of emitted C: NAME` divide this file into the snippets that emitted C can contain; f64.h explains them.
#ifndef SM_ELEMENTARY_H
#define SM_ELEMENTARY_H

#include "stdlib/f64.h"
#include "stdlib/flash.h"
#include "stdlib/math.h"

// snippet of emitted C: SmPair
// The number hi + lo.
typedef struct SmPair { SmF64 hi, lo; } SmPair;
// snippet of emitted C: sm_head
// x truncated to 26 significant bits.
static inline SmF64 sm_head(SmF64 x) { return sm_from_bits(sm_bits(x) & 0xFFFFFFFFF8000000u); }
// snippet of emitted C: sm_scale
// x * 2^n, where 2^n is a normal number.
static inline SmF64 sm_scale(SmF64 x, int n) { return sm_mul(x, sm_from_bits((uint64_t)(n + 1023) << 52)); }
// snippet of emitted C: sm_f64_constant
// The F64 whose bits are in a table.
static inline SmF64 sm_f64_constant(const uint64_t *at)
{
    uint64_t u;
    sm_flash_read(&u, at, sizeof u);
    return sm_from_bits(u);
}
// snippet of emitted C: sm_join
// a + b as a pair whose hi is the rounded sum.  a must be 0 or |a| at least |b|.
static inline SmPair sm_join(SmF64 a, SmF64 b)
{
    SmPair sum;
    sum.hi = sm_add(a, b);
    sum.lo = sm_add(sm_sub(a, sum.hi), b);
    return sum;
}
// snippet of emitted C: sm_square
// x * x as a pair; hi is exact, lo rounded.
static inline SmPair sm_square(SmF64 x)
{
    const SmF64 head = sm_head(x);
    SmPair z;
    z.hi = sm_mul(head, head);
    z.lo = sm_mul(sm_sub(x, head), sm_add(x, head));
    return z;
}
// snippet of emitted C: sm_pair_mul
// x * c.  c.hi must have at most 26 significant bits; `c_rounded` is c as one number.
static inline SmPair sm_pair_mul(SmPair x, SmPair c, SmF64 c_rounded)
{
    const SmF64 head = sm_head(x.hi);
    SmPair product;
    product.hi = sm_mul(head, c.hi);
    product.lo = sm_add(sm_mul(head, c.lo), sm_mul(sm_add(sm_sub(x.hi, head), x.lo), c_rounded));
    return product;
}
// snippet of emitted C: sm_pair_div
// a / b.  The quotient's hi has at most 26 significant bits.
static inline SmPair sm_pair_div(SmPair a, SmPair b)
{
    const SmF64 inverse = sm_div(sm_from_i32(1), b.hi), head = sm_head(b.hi);
    SmF64 rest;
    SmPair q;
    q.hi = sm_head(sm_mul(a.hi, inverse));
    rest = sm_sub(sm_sub(a.hi, sm_mul(q.hi, head)), sm_mul(q.hi, sm_add(sm_sub(b.hi, head), b.lo)));
    q.lo = sm_mul(sm_add(rest, a.lo), inverse);
    return q;
}
// snippet of emitted C: sm_polynomial
// c[0] + c[1] z + … + c[n - 1] z^(n - 1), for an even n.
static inline SmF64 sm_polynomial(const uint64_t *c, unsigned n, SmF64 z)
{
    const SmF64 square = sm_mul(z, z);
    SmF64 odd = sm_f64_constant(&c[n - 1]), even = sm_f64_constant(&c[n - 2]);
    for (n -= 2; n > 0; n -= 2) {
        odd = sm_add(sm_mul(odd, square), sm_f64_constant(&c[n - 1]));
        even = sm_add(sm_mul(even, square), sm_f64_constant(&c[n - 2]));
    }
    return sm_add(even, sm_mul(odd, z));
}
// snippet of emitted C: sm_exp_table
// (e^r - 1 - r) / r^2, for |r| up to ln 2 / 2
static const uint64_t sm_exp_table[12] SM_FLASH = {
    0x3FE0000000000000u, 0x3FC5555555555555u, 0x3FA5555555555557u, 0x3F81111111111113u,
    0x3F56C16C16C15A6Bu, 0x3F2A01A01A0188DCu, 0x3EFA01A01A9E84CCu, 0x3EC71DE3A5EC3102u,
    0x3E927E4D41CDB611u, 0x3E5AE641B6B5EEE4u, 0x3E21F7F20FC91DC7u, 0x3DE61D9881430183u,
};
// snippet of emitted C: sm_exp_pair
// e^(x.hi + x.lo), for |x.hi| up to 746.
static inline SmF64 sm_exp_pair(SmPair x)
{
    const SmF64 turns = sm_mul(x.hi, sm_from_bits(0x3FF71547652B82FEu));                      // x / ln 2
    const SmF64 half = sm_from_bits((sm_bits(x.hi) & 0x8000000000000000u) | 0x3FE0000000000000u);
    const int k = (int)sm_truncate_i32(sm_add(turns, half));
    const SmF64 whole = sm_from_i32(k);
    const SmF64 rest = sm_sub(x.hi, sm_mul(whole, sm_from_bits(0x3FE62E42FEFA3800u)));        // exact: ln 2 in 42 bits
    const SmPair r = sm_join(rest, sm_sub(x.lo, sm_mul(whole, sm_from_bits(0x3D2EF35793C76730u))));
    const SmPair sum = sm_join(sm_from_i32(1), r.hi);
    const SmF64 bent = sm_mul(sm_mul(r.hi, r.hi), sm_polynomial(sm_exp_table, 12, r.hi));
    const SmF64 y = sm_add(sum.hi, sm_add(sum.lo, sm_add(sm_mul(r.lo, sum.hi), bent)));
    return sm_scale(sm_scale(y, k / 2), k - k / 2);                                           // in two steps, because 2^k need not be a normal number
}
// snippet of emitted C: sm_exp
static inline SmF64 sm_exp(SmF64 x)
{
    SmPair pair;
    if (sm_is_nan(x))
        return x;
    if (sm_lt(sm_from_i32(710), x))
        return sm_from_bits(0x7FF0000000000000u);
    if (sm_lt(x, sm_from_i32(-746)))
        return sm_from_i32(0);
    pair.hi = x;
    pair.lo = sm_from_i32(0);
    return sm_exp_pair(pair);
}
// snippet of emitted C: sm_log_table
// (ln((1 + s) / (1 - s)) / s - 2 - 2/3 z) / z^2, where z = s^2, for |s| up to (sqrt 2 - 1) / (sqrt 2 + 1)
static const uint64_t sm_log_table[8] SM_FLASH = {
    0x3FD999999999999Au, 0x3FD2492492492523u, 0x3FCC71C71C6EA423u, 0x3FC745D177AE0E90u,
    0x3FC3B1395B5F08CDu, 0x3FC1118CD53AF741u, 0x3FBDF7BBEC160C99u, 0x3FBE038702FA10FCu,
};
// snippet of emitted C: sm_series
// s (a + z (c + w)), with a relative error below 2^-63 if w is small.  s.hi must have at most 26 significant bits, and z.hi at most 52.
static inline SmPair sm_series(SmPair s, SmPair z, SmF64 a, SmPair c, SmF64 w)
{
    const SmF64 head = sm_head(z.hi);
    SmPair p, q, product;
    // p is c + w, whose first part has 26 bits; then z becomes z p
    p.hi = sm_head(sm_add(c.hi, w));
    p.lo = sm_add(sm_sub(c.hi, p.hi), sm_add(c.lo, w));
    z.lo = sm_add(sm_mul(head, p.lo), sm_mul(sm_add(sm_sub(z.hi, head), z.lo), sm_add(p.hi, p.lo)));
    z.hi = sm_mul(head, p.hi);
    // q is a + z, whose first part has 26 bits; the result is s q
    q.hi = sm_head(sm_add(a, z.hi));
    q.lo = sm_add(sm_add(sm_sub(a, q.hi), z.hi), z.lo);
    product.hi = sm_mul(s.hi, q.hi);
    product.lo = sm_add(sm_mul(s.hi, q.lo), sm_mul(s.lo, sm_add(q.hi, q.lo)));
    return product;
}
// snippet of emitted C: sm_log_mantissa
// For a finite x above 0: the pair is ln m and *e the exponent, where x = m * 2^e and m is from sqrt(1/2) to sqrt(2).
static inline SmPair sm_log_mantissa(SmF64 x, SmF64 *e)
{
    const uint64_t root_half = 0x3FE6A09E667F3BCDu;
    int subnormal = 0, exponent;
    SmF64 m, w;
    SmPair f, t, s, z, third;
    if (sm_bits(x) < 0x0010000000000000u) {
        x = sm_scale(x, 54);
        subnormal = 54;
    }
    exponent = (int)((sm_bits(x) - root_half + 0x3FF0000000000000u) >> 52) - 1023;
    m = sm_from_bits(sm_bits(x) - (uint64_t)(int64_t)exponent * 0x0010000000000000u);
    *e = sm_from_i32(exponent - subnormal);
    // s = (m - 1) / (m + 1); ln m = s (2 + z (2/3 + w)), where z = s^2
    f.hi = sm_sub(m, sm_from_i32(1));
    f.lo = sm_from_i32(0);
    t.hi = sm_add(m, sm_from_i32(1));
    t.lo = sm_sub(m, sm_sub(t.hi, sm_from_i32(1)));
    s = sm_pair_div(f, t);
    z.hi = sm_mul(s.hi, s.hi);                                                                // exact
    z.lo = sm_mul(s.lo, sm_add(sm_add(s.hi, s.hi), s.lo));
    x = sm_add(z.hi, z.lo);
    w = sm_mul(x, sm_polynomial(sm_log_table, 8, x));
    third.hi = sm_from_bits(0x3FE5555555555555u);
    third.lo = sm_from_bits(0x3C85555555555555u);
    return sm_series(s, z, sm_from_i32(2), third, w);
}
// snippet of emitted C: sm_log_special
// Whether the logarithm of x is simple: NaN below 0, -infinity of 0, x itself for infinity and NaN.  *y is it.
static inline bool sm_log_special(SmF64 x, SmF64 *y)
{
    if (sm_lt(sm_from_i32(0), x) && sm_bits(x) != 0x7FF0000000000000u)
        return false;
    *y = sm_eq(x, sm_from_i32(0)) ? sm_from_bits(0xFFF0000000000000u) : sm_lt(x, sm_from_i32(0)) ? sm_from_bits(0x7FF8000000000000u) : x;
    return true;
}
// snippet of emitted C: sm_log_pair
// ln x of a finite x above 0; the relative error is below 2^-63.
static inline SmPair sm_log_pair(SmF64 x)
{
    SmF64 e;
    const SmPair l = sm_log_mantissa(x, &e);
    SmPair sum = sm_join(sm_mul(e, sm_from_bits(0x3FE62E42FEFA3800u)), l.hi);                 // exact: ln 2 in 42 bits
    sum.lo = sm_add(sum.lo, sm_add(l.lo, sm_mul(e, sm_from_bits(0x3D2EF35793C76730u))));
    return sum;
}
// snippet of emitted C: sm_log
static inline SmF64 sm_log(SmF64 x)
{
    SmPair l;
    if (sm_log_special(x, &x))
        return x;
    l = sm_log_pair(x);
    return sm_add(l.hi, l.lo);
}
// snippet of emitted C: sm_log10
static inline SmF64 sm_log10(SmF64 x)
{
    SmF64 e;
    SmPair l, factor;
    if (sm_log_special(x, &x))
        return x;
    factor.hi = sm_from_bits(0x3FDBCB7B10000000u);                                            // 1 / ln 10
    factor.lo = sm_from_bits(0x3E349B9438CA9AAEu);
    l = sm_log_mantissa(x, &e);
    l = sm_pair_mul(l, factor, sm_from_bits(0x3FDBCB7B1526E50Eu));
    x = l.lo;
    l = sm_join(sm_mul(e, sm_from_bits(0x3FD34413509F7800u)), l.hi);                          // exact: log10 2 in 42 bits
    return sm_add(l.hi, sm_add(l.lo, sm_add(x, sm_mul(e, sm_from_bits(0x3D1FEF311F12B358u)))));
}
// snippet of emitted C: sm_pow_positive
// x^y for a finite x above 0 and a finite y.
static inline SmF64 sm_pow_positive(SmF64 x, SmF64 y)
{
    const SmPair l = sm_log_pair(x);
    const SmPair log = sm_join(l.hi, l.lo);
    const SmF64 estimate = sm_mul(y, log.hi), head = sm_head(log.hi), y_head = sm_head(y);
    SmPair product;
    if (sm_lt(sm_from_i32(710), estimate))
        return sm_from_bits(0x7FF0000000000000u);
    if (sm_lt(estimate, sm_from_i32(-746)))
        return sm_from_i32(0);
    product.hi = sm_mul(y_head, head);
    product.lo = sm_add(sm_mul(y_head, sm_add(sm_sub(log.hi, head), log.lo)), sm_mul(sm_sub(y, y_head), log.hi));
    return sm_exp_pair(sm_join(product.hi, product.lo));
}
// snippet of emitted C: sm_is_whole
static inline bool sm_is_whole(SmF64 x) { return sm_eq(sm_trunc(x), x); }
// snippet of emitted C: sm_pow
static inline SmF64 sm_pow(SmF64 x, SmF64 y)
{
    const SmF64 size = sm_abs(x), zero = sm_from_i32(0), one = sm_from_i32(1), infinity = sm_from_bits(0x7FF0000000000000u);
    const bool odd = sm_is_whole(y) && !sm_is_whole(sm_mul(y, sm_from_bits(0x3FE0000000000000u)));
    const bool endless = sm_eq(sm_abs(y), infinity);
    SmF64 z;
    if (sm_eq(x, one) || sm_eq(y, zero) || (endless && sm_eq(size, one)))
        return one;
    if (sm_is_nan(x) || sm_is_nan(y) || (sm_lt(x, zero) && !sm_is_whole(y) && !sm_eq(size, infinity)))
        return sm_from_bits(0x7FF8000000000000u);
    if (endless || sm_eq(size, zero) || sm_eq(size, infinity))
        z = sm_lt(one, size) == sm_lt(zero, y) ? infinity : zero;
    else
        z = sm_pow_positive(size, y);
    return odd && (sm_bits(x) & 0x8000000000000000u) != 0 ? sm_neg(z) : z;
}
// snippet of emitted C: sm_turn_table
// The bits of 2 / pi, after 64 zeros
static const uint32_t sm_turn_table[39] SM_FLASH = {
    0x00000000u, 0x00000000u, 0xA2F9836Eu, 0x4E441529u, 0xFC2757D1u, 0xF534DDC0u, 0xDB629599u, 0x3C439041u,
    0xFE5163ABu, 0xDEBBC561u, 0xB7246E3Au, 0x424DD2E0u, 0x06492EEAu, 0x09D1921Cu, 0xFE1DEB1Cu, 0xB129A73Eu,
    0xE88235F5u, 0x2EBB4484u, 0xE99C7026u, 0xB45F7E41u, 0x3991D639u, 0x835339F4u, 0x9C845F8Bu, 0xBDF9283Bu,
    0x1FF897FFu, 0xDE05980Fu, 0xEF2F118Bu, 0x5A0A6D1Fu, 0x6D367ECFu, 0x27CB09B7u, 0x4F463F66u, 0x9E5FEA2Du,
    0x7527BAC7u, 0xEBE5F17Bu, 0x3D0739F7u, 0x8A5292EAu, 0x6BFB5FB1u, 0x1F8D5D08u, 0x56033046u,
};
// snippet of emitted C: sm_turn_fraction
// For |x| from 0.78 on: the bits of |x| * 2 / pi modulo 4, of which the first two are the whole part, in six words, the lowest first.  The error
// is below 2^-137.
static inline void sm_turn_fraction(SmF64 x, uint32_t product[6])
{
    const uint64_t mantissa = (sm_bits(x) & 0x000FFFFFFFFFFFFFu) | 0x0010000000000000u;
    const unsigned exponent = (unsigned)(sm_bits(x) >> 52) & 0x7FFu;
    // Bits of 2 / pi whose product with the mantissa is a multiple of 4 are skipped.
    const unsigned skipped = exponent - 1075u + 62u, shift = skipped % 32u;
    const uint32_t *word = &sm_turn_table[skipped / 32u];
    const uint32_t low = (uint32_t)mantissa, high = (uint32_t)(mantissa >> 32);
    uint32_t next = 0, last = 0, w;
    uint64_t sum = 0, carry = 0;
    int i;
    sm_flash_read(&next, &word[6], sizeof next);
    for (i = 0; i < 6; i++) {
        const uint32_t lower = next;
        sm_flash_read(&next, &word[5 - i], sizeof next);
        w = (uint32_t)((((uint64_t)next << 32 | lower) << shift) >> 32);
        // the column of weight 2^(32 i): w * low and the previous w * high
        sum += (uint64_t)w * low;
        carry = sum >> 32;
        sum = (sum & 0xFFFFFFFFu) + (uint64_t)last * high;
        carry += sum >> 32;
        product[i] = (uint32_t)sum;
        sum = carry;
        last = w;
    }
}
// snippet of emitted C: sm_reduce
// *r = x - k * pi/2 for the whole number k that is nearest to x * 2/pi, and returns k modulo 4.  x is finite.
static inline unsigned sm_reduce(SmF64 x, SmPair *r)
{
    uint32_t w[6], flip;
    unsigned k, i, top = 5;
    int unit = -32;
    SmPair sum, right;
    if (sm_lt(sm_abs(x), sm_from_bits(0x3FE921FB54442D18u))) {                                // pi/4
        r->hi = x;
        r->lo = sm_from_i32(0);
        return 0;
    }
    sm_turn_fraction(x, w);
    k = (unsigned)(w[5] >> 30);
    flip = (w[5] & 0x20000000u) != 0 ? 0xFFFFFFFFu : 0;                                       // nearer to k + 1, from below
    for (i = 5; i > 0; i--)
        w[i] = (w[i] << 2 | w[i - 1] >> 30) ^ flip;
    if (w[5] == 0) {                                                                          // near a multiple of pi/2
        top = 4;
        unit = -64;
    }
    sum = sm_join(sm_scale(sm_from_u32(w[top]), unit), sm_scale(sm_from_u32(w[top - 1]), unit - 32));
    sum.lo = sm_add(sum.lo, sm_add(sm_scale(sm_from_u32(w[top - 2]), unit - 64), sm_scale(sm_from_u32(w[top - 3]), unit - 96)));
    right.hi = sm_from_bits(0x3FF921FB50000000u);                                             // pi/2
    right.lo = sm_from_bits(0x3E5110B4611A6263u);
    sum = sm_pair_mul(sum, right, sm_from_bits(0x3FF921FB54442D18u));
    *r = sm_join(sum.hi, sum.lo);
    if ((flip != 0) != ((sm_bits(x) & 0x8000000000000000u) != 0)) {
        r->hi = sm_neg(r->hi);
        r->lo = sm_neg(r->lo);
    }
    if (flip != 0)
        k++;
    return ((sm_bits(x) & 0x8000000000000000u) != 0 ? 0u - k : k) & 3u;
}
// snippet of emitted C: sm_sin_table
// (sin r / r - 1) / z, where z = r^2, for |r| up to pi/4
static const uint64_t sm_sin_table[8] SM_FLASH = {
    0xBFC5555555555555u, 0x3F81111111111111u, 0xBF2A01A01A01A019u, 0x3EC71DE3A556C2C9u,
    0xBE5AE64567E732E7u, 0x3DE61245FB516B06u, 0xBD6AE7C53DEED862u, 0x3CE9242C4CC3855Eu,
};
// snippet of emitted C: sm_tan_table
// ((sin r / r - 1) / z + 1/6) / z
static const uint64_t sm_tan_table[6] SM_FLASH = {
    0x3F81111111111111u, 0xBF2A01A01A019ED6u, 0x3EC71DE3A550CC07u, 0xBE5AE64553439E50u,
    0x3DE61225B4F8DA28u, 0xBD6AB9408A23CA6Au,
};
// snippet of emitted C: sm_cos_table
// (cos r - 1 + z / 2) / z^2
static const uint64_t sm_cos_table[6] SM_FLASH = {
    0x3FA5555555555555u, 0xBF56C16C16C16967u, 0x3EFA01A019F4EC88u, 0xBE927E4FA17F5B80u,
    0x3E21EEB6902CBF33u, 0xBDA907DB3EEBA61Fu,
};
// snippet of emitted C: sm_sin_pair
// sin r; hi is r.hi.
static inline SmPair sm_sin_pair(SmPair r)
{
    const SmF64 z = sm_mul(r.hi, r.hi);
    const SmF64 cosine = sm_sub(sm_from_i32(1), sm_mul(z, sm_from_bits(0x3FE0000000000000u)));
    r.lo = sm_add(sm_mul(r.lo, cosine), sm_mul(sm_mul(r.hi, z), sm_polynomial(sm_sin_table, 8, z)));
    return r;
}
// snippet of emitted C: sm_cos_pair
// cos r
static inline SmPair sm_cos_pair(SmPair r)
{
    const SmPair square = sm_square(r.hi);
    const SmF64 half = sm_from_bits(0x3FE0000000000000u), z = sm_add(square.hi, square.lo);
    SmPair c = sm_join(sm_from_i32(1), sm_neg(sm_mul(square.hi, half)));
    c.lo = sm_sub(c.lo, sm_add(sm_mul(square.lo, half), sm_mul(r.hi, r.lo)));
    c.lo = sm_add(c.lo, sm_mul(sm_mul(z, z), sm_polynomial(sm_cos_table, 6, z)));
    return c;
}
// snippet of emitted C: sm_sin_of_turn
// sin(r + k * pi/2)
static inline SmF64 sm_sin_of_turn(SmPair r, unsigned k)
{
    const SmPair s = (k & 1u) != 0 ? sm_cos_pair(r) : sm_sin_pair(r);
    const SmF64 y = sm_add(s.hi, s.lo);
    return (k & 2u) != 0 ? sm_neg(y) : y;
}
// snippet of emitted C: sm_is_small
// Whether |x| is below 2^-27, where sin x, tan x, asin x and atan x are x.
static inline bool sm_is_small(SmF64 x) { return sm_lt(sm_abs(x), sm_from_bits(0x3E40000000000000u)); }
// snippet of emitted C: sm_is_endless
// Whether x is an infinity or NaN.  Of the upper half alone: avr-gcc 5.4 compiles the comparison of all 64 masked bits to `false`.
static inline bool sm_is_endless(SmF64 x) { return ((uint32_t)(sm_bits(x) >> 32) & 0x7FF00000u) == 0x7FF00000u; }
// snippet of emitted C: sm_sin
static inline SmF64 sm_sin(SmF64 x)
{
    SmPair r;
    unsigned k;
    if (sm_is_endless(x) || sm_is_small(x))
        return sm_is_endless(x) ? sm_from_bits(0x7FF8000000000000u) : x;
    k = sm_reduce(x, &r);
    return sm_sin_of_turn(r, k);
}
// snippet of emitted C: sm_cos
static inline SmF64 sm_cos(SmF64 x)
{
    SmPair r;
    unsigned k;
    if (sm_is_endless(x))
        return sm_from_bits(0x7FF8000000000000u);
    k = sm_reduce(x, &r);
    return sm_sin_of_turn(r, k + 1u);
}
// snippet of emitted C: sm_sin_series
// sin r for a quotient: its relative error is below 2^-62.
static inline SmPair sm_sin_series(SmPair r)
{
    SmPair s, z, sixth;
    SmF64 v;
    s.hi = sm_head(r.hi);
    s.lo = sm_add(sm_sub(r.hi, s.hi), r.lo);
    z.hi = sm_mul(s.hi, s.hi);                                                                // exact
    z.lo = sm_mul(s.lo, sm_add(sm_add(s.hi, s.hi), s.lo));
    v = sm_add(z.hi, z.lo);
    sixth.hi = sm_from_bits(0xBFC5555555555555u);                                           // -1/6
    sixth.lo = sm_from_bits(0xBC65555555555555u);
    return sm_series(s, z, sm_from_i32(1), sixth, sm_mul(v, sm_polynomial(sm_tan_table, 6, v)));
}
// snippet of emitted C: sm_tan
static inline SmF64 sm_tan(SmF64 x)
{
    SmPair r, s, c;
    unsigned k;
    if (sm_is_endless(x) || sm_is_small(x))
        return sm_is_endless(x) ? sm_from_bits(0x7FF8000000000000u) : x;
    k = sm_reduce(x, &r);
    s = sm_sin_series(r);
    c = sm_cos_pair(r);
    s = sm_join(s.hi, s.lo);
    c = sm_join(c.hi, c.lo);
    r = (k & 1u) != 0 ? sm_pair_div(c, s) : sm_pair_div(s, c);
    x = sm_add(r.hi, r.lo);
    return (k & 1u) != 0 ? sm_neg(x) : x;
}
// snippet of emitted C: sm_atan_table
// (atan t / t - 1) / z, where z = t^2, for |t| up to 0.164
static const uint64_t sm_atan_table[8] SM_FLASH = {
    0xBFD5555555555555u, 0x3FC9999999999956u, 0xBFC24924924854E7u, 0x3FBC71C71A8D71EEu,
    0xBFB745D05EBFB2E7u, 0x3FB3B0E48255DD35u, 0xBFB1020E41B47EA9u, 0x3FAB6178FE602A5Bu,
};
// snippet of emitted C: sm_arc_table
// atan 0, 1/4, 1/2 and 1, each in two parts
static const uint64_t sm_arc_table[8] SM_FLASH = {
    0x0000000000000000u, 0x0000000000000000u, 0x3FCF5B75F92C80DDu, 0x3C68AB6E3CF7AFBDu,
    0x3FDDAC670561BB4Fu, 0x3C7A2B7F222F65E2u, 0x3FE921FB54442D18u, 0x3C81A62633145C07u,
};
// snippet of emitted C: sm_angle
// The angle of the point (x, y), from 0 to pi.  y is at least 0, x above 0 and y + x neither overflow nor underflow; if `left`, x is the distance to
// the left of the origin.
static inline SmF64 sm_angle(SmPair y, SmPair x, bool left)
{
    const bool steep = sm_lt(x.hi, y.hi), minus = steep != left;
    const SmPair a = steep ? x : y, b = steep ? y : x;
    SmF64 c = sm_from_i32(0), z;
    SmPair t, d, base, arc;
    unsigned i = 0;
    // atan(a / b) = atan c + atan t, where t = (a - c b) / (b + c a)
    if (sm_le(sm_mul(b.hi, sm_from_bits(0x3FC0000000000000u)), a.hi))                         // 1/8
        i = sm_lt(a.hi, sm_mul(b.hi, sm_from_bits(0x3FD8000000000000u))) ? 1u                 // 3/8
            : sm_lt(a.hi, sm_mul(b.hi, sm_from_bits(0x3FE7000000000000u))) ? 2u : 3u;         // 23/32
    if (i > 0)
        c = sm_scale(sm_from_bits(0x3FC0000000000000u), (int)i);
    t.hi = sm_sub(a.hi, sm_mul(c, b.hi));                                                     // exact
    t.lo = sm_sub(a.lo, sm_mul(c, b.lo));
    d = sm_join(b.hi, sm_mul(c, a.hi));
    d.lo = sm_add(d.lo, sm_add(b.lo, sm_mul(c, a.lo)));
    t = sm_pair_div(t, d);
    z = sm_add(t.hi, t.lo);
    c = sm_mul(z, z);
    t.lo = sm_add(t.lo, sm_mul(sm_mul(z, c), sm_polynomial(sm_atan_table, 8, c)));
    // the arc of c, and in `base` the multiple of pi/2 from which the angle is counted
    i *= 2u;
    arc.hi = sm_f64_constant(&sm_arc_table[i]);
    arc.lo = sm_add(sm_f64_constant(&sm_arc_table[i + 1]), t.lo);
    if (minus) {
        arc.hi = sm_neg(arc.hi);
        arc.lo = sm_neg(arc.lo);
        t.hi = sm_neg(t.hi);
    }
    base.hi = base.lo = sm_from_i32(0);
    if (steep || left) {
        base.hi = sm_from_bits(steep ? 0x3FF921FB54442D18u : 0x400921FB54442D18u);
        base.lo = sm_from_bits(steep ? 0x3C91A62633145C07u : 0x3CA1A62633145C07u);
    }
    d = sm_join(base.hi, arc.hi);
    t = sm_join(d.hi, t.hi);
    return sm_add(t.hi, sm_add(t.lo, sm_add(d.lo, sm_add(base.lo, arc.lo))));
}
// snippet of emitted C: sm_with_sign
// y, which is at least 0, with the sign of x.
static inline SmF64 sm_with_sign(SmF64 y, SmF64 x) { return sm_from_bits(sm_bits(y) | (sm_bits(x) & 0x8000000000000000u)); }
// snippet of emitted C: sm_atan
static inline SmF64 sm_atan(SmF64 x)
{
    SmPair y, one;
    if (sm_is_nan(x) || sm_is_small(x))
        return x;
    y.hi = sm_abs(x);
    if (sm_lt(sm_from_bits(0x43F0000000000000u), y.hi))                                       // 2^64
        return sm_with_sign(sm_from_bits(0x3FF921FB54442D18u), x);
    one.hi = sm_from_i32(1);
    one.lo = y.lo = sm_from_i32(0);
    return sm_with_sign(sm_angle(y, one, false), x);
}
// snippet of emitted C: sm_atan2
static inline SmF64 sm_atan2(SmF64 y, SmF64 x)
{
    const SmF64 tiny = sm_from_bits(0x3BF0000000000000u), zero = sm_from_i32(0);              // 2^-64
    const bool left = (sm_bits(x) & 0x8000000000000000u) != 0;
    SmPair a, b;
    int n = 0;
    if (sm_is_nan(x) || sm_is_nan(y))
        return sm_from_bits(0x7FF8000000000000u);
    a.hi = sm_abs(y);
    b.hi = sm_abs(x);
    a.lo = b.lo = zero;
    if (sm_is_endless(x) || sm_is_endless(y)) {
        a.hi = sm_from_i32(sm_is_endless(y));
        b.hi = sm_from_i32(sm_is_endless(x));
    } else if (sm_eq(a.hi, b.hi)) {
        a.hi = sm_from_i32(sm_lt(zero, a.hi));
        b.hi = sm_from_i32(1);
    }
    if (sm_lt(sm_from_bits(0x5F30000000000000u), sm_max(a.hi, b.hi)))                         // 2^500
        n = -600;
    if (sm_lt(sm_max(a.hi, b.hi), sm_from_bits(0x26F0000000000000u)))                         // 2^-400
        n = 600;
    if (sm_le(sm_scale(a.hi, n), sm_mul(sm_scale(b.hi, n), tiny)))
        return sm_with_sign(left ? sm_from_bits(0x400921FB54442D18u) : sm_div(a.hi, b.hi), y);
    if (sm_le(sm_scale(b.hi, n), sm_mul(sm_scale(a.hi, n), tiny)))
        return sm_with_sign(sm_from_bits(0x3FF921FB54442D18u), y);
    a.hi = sm_scale(a.hi, n);
    b.hi = sm_scale(b.hi, n);
    return sm_with_sign(sm_angle(a, b, left), y);
}
// snippet of emitted C: sm_root_pair
// The square root of x as a pair; x is 0 or from 2^-900 to 2^1002.  Three steps of Newton's method find y = 1 / sqrt(x) to 2^-34; the rest of
// sqrt(x) - x y follows from the square of x y.
static inline SmPair sm_root_pair(SmPair x)
{
    const SmF64 half = sm_from_bits(0x3FE0000000000000u), half_x = sm_mul(x.hi, half);
    SmF64 y = sm_from_bits(0x5FE6EB0000000000u - (sm_bits(x.hi) >> 1)), rest;
    SmPair root, square;
    int i;
    for (i = 0; i < 3; i++)
        y = sm_mul(y, sm_sub(sm_from_bits(0x3FF8000000000000u), sm_mul(sm_mul(half_x, y), y)));
    root.hi = sm_mul(x.hi, y);
    square = sm_square(root.hi);
    rest = sm_add(sm_sub(sm_sub(x.hi, square.hi), square.lo), x.lo);
    root.lo = sm_mul(rest, sm_mul(y, half));
    return root;
}
// snippet of emitted C: sm_leg
// sqrt(1 - x^2), for x from 0 to 1.
static inline SmPair sm_leg(SmF64 x)
{
    const SmF64 one = sm_from_i32(1);
    const SmPair sum = sm_join(one, x), difference = sm_join(one, sm_neg(x));
    const SmF64 head = sm_head(sum.hi), head2 = sm_head(difference.hi);
    SmPair u;
    u.hi = sm_mul(head, head2);
    u.lo = sm_add(sm_mul(head, sm_sub(difference.hi, head2)), sm_mul(sm_sub(sum.hi, head), difference.hi));
    u.lo = sm_add(u.lo, sm_add(sm_mul(sum.lo, difference.hi), sm_mul(sum.hi, difference.lo)));
    return sm_root_pair(sm_join(u.hi, u.lo));
}
// snippet of emitted C: sm_asin
static inline SmF64 sm_asin(SmF64 x)
{
    SmPair y;
    if (sm_lt(sm_from_i32(1), sm_abs(x)))
        return sm_from_bits(0x7FF8000000000000u);
    if (sm_is_nan(x) || sm_is_small(x))
        return x;
    y.hi = sm_abs(x);
    y.lo = sm_from_i32(0);
    return sm_with_sign(sm_angle(y, sm_leg(y.hi), false), x);
}
// snippet of emitted C: sm_acos
static inline SmF64 sm_acos(SmF64 x)
{
    SmPair size;
    if (sm_is_nan(x) || sm_lt(sm_from_i32(1), sm_abs(x)))
        return sm_from_bits(0x7FF8000000000000u);
    size.hi = sm_abs(x);
    size.lo = sm_from_i32(0);
    return sm_angle(sm_leg(size.hi), size, sm_lt(x, size.lo));
}
// snippet of emitted C: sm_hypot
static inline SmF64 sm_hypot(SmF64 x, SmF64 y)
{
    const SmF64 infinity = sm_from_bits(0x7FF0000000000000u);
    const SmF64 a = sm_abs(x), b = sm_abs(y);
    SmPair p, q, sum;
    int n = 0;
    if (sm_eq(a, infinity) || sm_eq(b, infinity))
        return infinity;
    if (sm_is_nan(a) || sm_is_nan(b))
        return sm_from_bits(0x7FF8000000000000u);
    x = sm_max(a, b);
    y = sm_min(a, b);
    if (sm_le(y, sm_mul(x, sm_from_bits(0x3E30000000000000u))))                               // 2^-28; also if y is 0
        return x;
    if (sm_lt(sm_from_bits(0x5F30000000000000u), x))                                          // 2^500
        n = -600;
    if (sm_lt(x, sm_from_bits(0x26F0000000000000u)))                                          // 2^-400
        n = 600;
    p = sm_square(sm_scale(x, n));
    q = sm_square(sm_scale(y, n));
    sum = sm_join(p.hi, q.hi);
    sum.lo = sm_add(sum.lo, sm_add(p.lo, q.lo));
    p = sm_root_pair(sm_join(sum.hi, sum.lo));
    return sm_scale(sm_add(p.hi, p.lo), -n);
}
// snippet of emitted C: end

#endif
