// SPDX-License-Identifier: Apache-2.0
// Converts literals exactly. A literal is digits times a power of ten, so it equals a quotient of two big integers. This quotient is
// computed bit by bit, to 63 or 64 bits and a flag for a nonzero remainder, and is rounded once. Short literals are converted by one exact
// multiplication or division.
#include "compiler/syntax/number.h"

#include <string.h>

// ---- 64 bits to F64 ----

enum { E_MIN = -1022, E_MAX = 1023 };     // exponents of the smallest and of the largest normal F64

// Rounds q * 2^e to an F64; returns false if it is too large. `more`: the exact value is larger by less than one unit of q. q is not 0.
static bool round_to_f64(uint64_t q, long e, bool more, SmF64 *value)
{
    uint64_t mantissa, rest, half, bits;
    long drop = 11;                                   // bits of q to drop: 53 of the 64 remain

    for (; !(q >> 63); e--)
        q <<= 1;
    e += 63;                                          // now 2^e <= exact value < 2^(e + 1)
    if (e > E_MAX)
        return false;
    if (e < E_MIN) {                                  // subnormal: fewer than 53 bits remain
        drop += E_MIN - e;
        e = E_MIN;
    }
    *value = sm_from_bits(0);
    if (drop > 64)
        return true;
    mantissa = drop == 64 ? 0 : q >> drop;
    rest = drop == 64 ? q : q & (((uint64_t)1 << drop) - 1);
    half = (uint64_t)1 << (drop - 1);
    mantissa += rest > half || (rest == half && (more || (mantissa & 1)));
    bits = ((uint64_t)(e - E_MIN) << 52) + mantissa;  // a carry out of the mantissa raises the exponent, as it should
    *value = sm_from_bits(bits);
    return bits < 0x7ff0000000000000u;
}

// ---- big whole numbers ----

enum { LIMBS = 128 };                                 // 4096 bits: enough for every number of 810 digits, and for 10^1140 times a number of 64 bits

typedef struct Big { uint32_t limb[LIMBS]; int n; } Big;      // least significant limb first; n does not count leading zeros

static void big_multiply_add(Big *b, uint32_t factor, uint32_t add)
{
    uint64_t carry = add;

    for (int i = 0; i < b->n; i++) {
        carry += (uint64_t)b->limb[i] * factor;
        b->limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry)
        b->limb[b->n++] = (uint32_t)carry;
}

static void big_multiply_power_of_ten(Big *b, long power)
{
    for (; power >= 9; power -= 9)
        big_multiply_add(b, 1000000000u, 0);
    for (; power > 0; power--)
        big_multiply_add(b, 10, 0);
}

// Returns the number of bits of b without leading zeros.
static long big_count_bits(const Big *b)
{
    long bits = b->n * 32L;

    for (uint32_t top = b->limb[b->n - 1]; !(top >> 31); top <<= 1)
        bits--;
    return bits;
}

static void big_shift_left(Big *b, long by)
{
    int limbs = (int)(by / 32), bits = (int)(by % 32);

    if (limbs) {
        memmove(b->limb + limbs, b->limb, (size_t)b->n * sizeof *b->limb);
        memset(b->limb, 0, (size_t)limbs * sizeof *b->limb);
        b->n += limbs;
    }
    if (bits)
        big_multiply_add(b, (uint32_t)1 << bits, 0);
}

static bool big_is_at_least(const Big *a, const Big *b)
{
    if (a->n != b->n)
        return a->n > b->n;
    for (int i = a->n - 1; i >= 0; i--)
        if (a->limb[i] != b->limb[i])
            return a->limb[i] > b->limb[i];
    return true;
}

static void big_subtract(Big *a, const Big *b)        // a -= b; requires a >= b
{
    uint64_t borrow = 0;

    for (int i = 0; i < a->n; i++) {
        uint64_t d = (uint64_t)a->limb[i] - (i < b->n ? b->limb[i] : 0) - borrow;
        a->limb[i] = (uint32_t)d;
        borrow = d >> 63;
    }
    while (a->n && a->limb[a->n - 1] == 0)
        a->n--;
}

// Returns top / bottom, which is < 2^64, rounded down. Afterwards `top` is nonzero exactly if the division has a remainder.
static uint64_t big_divide(Big *top, Big *bottom)
{
    uint64_t q = 0;

    big_shift_left(bottom, 63);
    for (int i = 0; i < 64; i++) {
        q <<= 1;
        if (big_is_at_least(top, bottom)) {
            big_subtract(top, bottom);
            q |= 1;
        }
        big_multiply_add(top, 2, 0);
    }
    return q;
}

// ---- decimal ----

enum {
    DIGITS_MAX = 800,         // digits stored. The midpoint between two adjacent F64 has at most 767 digits; further digits only break ties
    FACTOR_DIGITS = 2,        // decimal digits of the largest factor of number_to_scaled_f64
    LARGEST = 310, SMALLEST = -330    // limits of Decimal.point: above LARGEST every value is too large, below SMALLEST every value rounds to 0
};

typedef struct Decimal {
    char digit[DIGITS_MAX + 1 + FACTOR_DIGITS];   // '0' … '9', the first not '0'; value: 0.d d d… * 10^point
    int n;
    int64_t point;
    bool more;                // a nonzero digit after the stored digits was left out
} Decimal;

static void add_digit(Decimal *d, char c)
{
    if (d->n < DIGITS_MAX)
        d->digit[d->n++] = c;
    else
        d->more = d->more || c != '0';
}

// Returns the value of the exponent in the text from s to `end`, saturated: an exponent can have any number of digits.
static int64_t read_exponent(const char *s, const char *end)
{
    bool negative = *s == '-';
    int64_t e = 0;

    for (s += *s == '-' || *s == '+'; s < end; s++)
        if (*s != '_' && e < 100000000000)
            e = e * 10 + (*s - '0');
    return negative ? -e : e;
}

static void read_decimal(Decimal *d, const char *s, const char *end)
{
    bool fraction = false;

    d->n = 0;
    d->point = 0;
    d->more = false;
    for (; s < end && *s != 'e' && *s != 'E'; s++) {
        if (*s == '.')
            fraction = true;
        if (*s == '.' || *s == '_')
            continue;
        if (d->n || *s != '0') {
            add_digit(d, *s);
            d->point += !fraction;
        } else {
            d->point -= fraction;
        }
    }
    if (s < end)
        d->point += read_exponent(s + 1, end);
    while (d->n && !d->more && d->digit[d->n - 1] == '0')
        d->n--;
    if (d->more)
        d->digit[d->n++] = '1';                       // stands for the digits left out, which are more than 0 and less than 1 in the last place
}

// Converts a literal with few digits and a small power of ten by one F64 operation on two exact numbers, which rounds only once. Returns
// false if the literal has too many digits or too large a power.
static bool convert_exactly(const Decimal *d, SmF64 *value)
{
    enum { EXACT = 15 };                              // integers of up to 15 digits are exact, because 10^15 < 2^53
    int64_t power = d->point - d->n;
    uint64_t digits = 0, ten = 1;

    if (d->n > EXACT || power < -EXACT || power > EXACT)
        return false;
    for (int i = 0; i < d->n; i++)
        digits = digits * 10 + (uint64_t)(d->digit[i] - '0');
    for (int64_t i = power < 0 ? -power : power; i > 0; i--)
        ten *= 10;
    *value = power < 0 ? sm_div(sm_from_u64(digits), sm_from_u64(ten)) : sm_mul(sm_from_u64(digits), sm_from_u64(ten));
    return true;
}

// Converts a decimal literal, however many digits it has, by an exact division of big integers. Returns false if the value is too large for an F64.
static bool convert_by_division(const Decimal *d, SmF64 *value)
{
    Big top = {{0}, 0}, bottom = {{1}, 1};
    long power = (long)(d->point - d->n), shift;
    uint64_t q;

    for (int i = 0; i < d->n; i++)
        big_multiply_add(&top, 10, (uint32_t)(d->digit[i] - '0'));
    big_multiply_power_of_ten(power < 0 ? &bottom : &top, power < 0 ? -power : power);
    shift = 63 - (big_count_bits(&top) - big_count_bits(&bottom));            // 2^62 < quotient < 2^64
    big_shift_left(shift < 0 ? &bottom : &top, shift < 0 ? -shift : shift);
    q = big_divide(&top, &bottom);
    return round_to_f64(q, -shift, top.n > 0, value);
}

// Returns false if the value is too large for an F64.
static bool convert_decimal(const Decimal *d, SmF64 *value)
{
    *value = sm_from_bits(0);
    if (d->n == 0 || d->point < SMALLEST)
        return true;
    if (d->point > LARGEST)
        return false;
    return convert_exactly(d, value) || convert_by_division(d, value);
}

// Multiplies d, which is not 0, by a factor of at most FACTOR_DIGITS digits.
static void multiply_decimal(Decimal *d, unsigned factor)
{
    unsigned carry = 0;

    for (int i = d->n - 1; i >= 0; i--) {
        carry += (unsigned)(d->digit[i] - '0') * factor;
        d->digit[i] = (char)('0' + carry % 10);
        carry /= 10;
    }
    for (; carry; carry /= 10) {
        memmove(d->digit + 1, d->digit, (size_t)d->n++);
        d->digit[0] = (char)('0' + carry % 10);
        d->point++;
    }
}

// ---- hexadecimal ----

static unsigned hex_digit_value(char c)
{
    return c <= '9' ? (unsigned)(c - '0') : (unsigned)((c | 0x20) - 'a' + 10);
}

// Converts the hexadecimal digits from s to `end`. Returns false if the value is too large for an F64.
static bool convert_hexadecimal(const char *s, const char *end, SmF64 *value)
{
    uint64_t q = 0;
    long e = 0;
    bool more = false;

    for (; s < end; s++) {
        if (*s == '_')
            continue;
        if (q >> 60) {
            more = more || *s != '0';
            e += e < 100000 ? 4 : 0;
        } else {
            q = q << 4 | hex_digit_value(*s);
        }
    }
    *value = sm_from_bits(0);
    return q == 0 || round_to_f64(q, e, more, value);
}

// Computes the F64 nearest to a well-formed literal, which can contain `_` (language.md 1.12 to 1.15, 1.17); ties round to even.
bool number_to_f64(const char *text, size_t len, SmF64 *value)
{
    Decimal d;

    if (len > 2 && (text[1] == 'x' || text[1] == 'X'))
        return convert_hexadecimal(text + 2, text + len, value);
    read_decimal(&d, text, text + len);
    return convert_decimal(&d, value);
}

// Computes the F64 nearest to a decimal literal times factor * 10^exponent: the exact product is rounded once. factor: 1 to 99. Returns
// false if the result is too large.
bool number_to_scaled_f64(const char *text, size_t len, unsigned factor, int exponent, SmF64 *value)
{
    Decimal d;

    read_decimal(&d, text, text + len);
    if (d.n && factor > 1)
        multiply_decimal(&d, factor);
    d.point += exponent;
    return convert_decimal(&d, value);
}

// ---- literals as decimal digits ----

// Stores the exact value of the hexadecimal digits from s to `end`. Returns false if it has more than 60 bits.
static bool read_hexadecimal(const char *s, const char *end, uint64_t *digits)
{
    for (*digits = 0; s < end; s++) {
        if (*s == '_')
            continue;
        if (*digits >> 56)
            return false;
        *digits = *digits << 4 | hex_digit_value(*s);
    }
    return true;
}

// Splits a literal exactly into digits * 10^exponent, where digits has no trailing zeros.  Returns false if it has more than 18 digits.
bool number_to_decimal(const char *text, size_t len, uint64_t *digits, int *exponent)
{
    enum { MOST = 18 };
    Decimal d;

    *digits = 0;
    *exponent = 0;
    if (len > 2 && (text[1] == 'x' || text[1] == 'X'))
        return read_hexadecimal(text + 2, text + len, digits);
    read_decimal(&d, text, text + len);
    if (d.n > MOST || d.point < SMALLEST || d.point > LARGEST)
        return d.n == 0;
    for (int i = 0; i < d.n; i++)
        *digits = *digits * 10 + (uint64_t)(d.digit[i] - '0');
    if (d.n)
        *exponent = (int)d.point - d.n;
    return true;
}
