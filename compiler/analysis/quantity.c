// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/quantity.h"

#include "stdlib/elementary.h"
#include "stdlib/math.h"

// Tolerances, relative unless a unit is named.
static const double rounding = 1e-9;          // numbers that differ by the rounding of a few operations only
static const double written_factor = 0.02;    // factors between units are often written with two digits: 3.3 for 3.2808, 9.8 for 9.80665
static const double written_zero = 0.5;       // kelvins: 273 is written for 273.15
static const double least_zero = 100;         // kelvins: a smaller shift is a correction, and not the zero of another scale (273.15, 459.67)
enum { GAIN_MAX = 12 };                       // the largest whole number that is assumed to be a count or a gain: cells of a battery, a dozen

static double size_of(double x) { return x < 0 ? -x : x; }
static bool is_near(double a, double b, double tolerance) { return size_of(a - b) <= tolerance * size_of(b); }

// ---- building ----

Quantity quantity_of_kind(QuantityKind kind) { return (Quantity){.kind = kind, .factor = 1}; }

Quantity quantity_of_number(double x) { return (Quantity){.kind = QUANTITY_NUMBER, .factor = x}; }

Quantity quantity_of_unit(const Measure *unit) { return (Quantity){.kind = QUANTITY_UNIT, .unit = *unit, .factor = 1}; }

Quantity quantity_negated(Quantity a)
{
    a.factor = -a.factor;
    a.shift = -a.shift;
    return a;
}

// Multiplies a value that has a unit with a number.
static Quantity scale_quantity(const Quantity *a, double number)
{
    Quantity out = *a;

    out.factor *= number;
    out.shift *= number;
    out.scaled = a->scaled || size_of(number) != 1;
    return out;
}

// Returns the value to the power 1 or -1.
static Quantity invert_if(const Quantity *a, double power)
{
    Quantity out = *a;

    if (power == 1)
        return out;
    out.unit = measure_power(&a->unit, -1);
    out.factor = 1 / a->factor;
    out.shift = 0;
    out.zero_unknown = false;
    return out;
}

static Quantity drop_unusable_unit(Quantity q)
{
    return q.kind == QUANTITY_UNIT && !measure_is_usable(&q.unit) ? quantity_of_kind(QUANTITY_UNKNOWN) : q;
}

Quantity quantity_product(const Quantity *a, const Quantity *b, double power)
{
    const Quantity divisor = invert_if(b, power);
    Quantity out = *a;

    if (a->kind == QUANTITY_UNKNOWN || b->kind == QUANTITY_UNKNOWN)
        return quantity_of_kind(QUANTITY_UNKNOWN);
    if (a->kind == QUANTITY_UNIT && b->kind == QUANTITY_UNIT) {
        out.unit = measure_product(&a->unit, &b->unit, power);
        out.factor = a->factor * divisor.factor;
        out.shift = 0;
        out.scaled = a->scaled || b->scaled;
        out.constant = a->constant && b->constant;
        out.zero_unknown = false;
        return drop_unusable_unit(out);
    }
    if (b->kind == QUANTITY_UNIT)
        return a->kind == QUANTITY_NUMBER ? scale_quantity(&divisor, a->factor) : divisor;
    if (a->kind == QUANTITY_UNIT)
        return b->kind == QUANTITY_NUMBER ? scale_quantity(a, divisor.factor) : *a;
    if (a->kind == QUANTITY_NUMBER && b->kind == QUANTITY_NUMBER)
        return quantity_of_number(a->factor * divisor.factor);
    return a->kind == QUANTITY_PLAIN ? *b : *a;
}

Quantity quantity_power(const Quantity *a, double power)
{
    Quantity out = *a;

    if (a->kind == QUANTITY_NUMBER)
        return quantity_of_number(sm_pow(a->factor, power));
    if (a->kind != QUANTITY_UNIT)
        return *a;
    out.unit = measure_power(&a->unit, power);
    out.factor = sm_pow(size_of(a->factor), power);
    out.shift = 0;
    out.zero_unknown = false;
    return drop_unusable_unit(out);
}

Quantity quantity_one_of(const Quantity *a, const Quantity *b)
{
    const Quantity *from = a->kind != QUANTITY_UNIT ? b : b->kind != QUANTITY_UNIT || !a->scaled ? a : b;
    Quantity out = *from;

    if (out.kind != QUANTITY_UNIT)
        return a->kind == b->kind && a->kind != QUANTITY_NUMBER ? *a : quantity_of_kind(QUANTITY_UNKNOWN);
    if (a->kind == QUANTITY_UNIT && b->kind == QUANTITY_UNIT) {
        if (a->scaled && b->scaled && a->factor != b->factor)
            out.factor = sm_div(sm_from_i32(0), sm_from_i32(0));      // NaN: not known
        out.shift = a->shift == b->shift ? a->shift : 0;
        out.zero_unknown = a->zero_unknown || b->zero_unknown;
    }
    out.constant = false;
    return out;
}

// Adds to a, which has a unit, a value that has none.
static Quantity add_number(const Quantity *a, const Quantity *number, double sign)
{
    Quantity out = *a;

    if (number->kind == QUANTITY_NUMBER)
        out.shift += sign * number->factor;
    else if (number->kind == QUANTITY_UNKNOWN && measure_is_temperature(&a->unit))
        out.zero_unknown = true;                            // the value can be 273.15, which converts kelvins to degrees Celsius or back
    return out;
}

static bool has_zero(const Quantity *a) { return a->unit.zero != 0 && !a->zero_unknown; }

Quantity quantity_sum(const Quantity *a, const Quantity *b, bool minus)
{
    const double sign = minus ? -1 : 1;
    const Quantity negated = minus ? quantity_negated(*b) : *b;
    Quantity out;

    if (a->kind == QUANTITY_NUMBER && b->kind == QUANTITY_NUMBER)
        return quantity_of_number(a->factor + sign * b->factor);
    if (a->kind != QUANTITY_UNIT && b->kind != QUANTITY_UNIT)
        return a->kind == QUANTITY_PLAIN && b->kind == QUANTITY_PLAIN ? *a : quantity_of_kind(QUANTITY_UNKNOWN);
    if (b->kind != QUANTITY_UNIT)
        return add_number(a, b, sign);
    if (a->kind != QUANTITY_UNIT)
        return add_number(&negated, a, 1);
    out = quantity_one_of(a, &negated);
    out.constant = a->constant && b->constant;
    out.shift = a->scaled == b->scaled ? a->shift + sign * b->shift : 0;
    // 20 degC + 5 K, 293 K - 273.15 K, 20 degC - 15 degC; but 20 degC + 15 degC is part of an average
    if (measure_is_temperature(&a->unit))
        out.zero_unknown = minus || !has_zero(a) || !has_zero(b);
    return out;
}

// ---- judging ----

// Whether the number is a small whole number, or 1 divided by one: a gain or a count, not a factor between units of one kind.
static bool is_plain_gain(double number)
{
    const double x = number < 1 ? 1 / number : number, whole = sm_round(x);

    return whole <= (double)GAIN_MAX && is_near(x, whole, rounding);
}

// Judges two temperatures whose zeros differ.
static QuantityFit fit_zeros(const Quantity *a, const Quantity *b, double factor, double ratio)
{
    const double zero = (a->unit.zero - b->unit.zero) / b->unit.scale;        // x in a's unit is factor * x + zero in b's
    const double shift = (a->shift - b->shift) / b->factor;

    if (is_near(ratio, factor, written_factor) && size_of(shift - zero) <= written_zero)
        return QUANTITY_FITS;
    if (a->scaled || b->scaled)
        return QUANTITY_MAY_DIFFER;
    return size_of(shift) < least_zero || size_of(shift + zero) <= written_zero ? QUANTITY_DIFFERS : QUANTITY_MAY_DIFFER;     // the second: in the wrong direction
}

// Judges two values that measure the same thing, by the numbers that they are multiplied with. `factor`: 1 of a's unit in b's.
static QuantityFit fit_scales(const Quantity *a, const Quantity *b, QuantityUse use, double factor, double ratio)
{
    if (!a->scaled && !b->scaled)
        return QUANTITY_DIFFERS;
    if (ratio != ratio)
        return QUANTITY_MAY_DIFFER;
    if (is_near(ratio, factor, written_factor))
        return QUANTITY_FITS;
    if (is_near(ratio * factor, 1, written_factor) || is_plain_gain(ratio))
        return QUANTITY_DIFFERS;
    // The weights of a filter, as in 0.9 * a + 0.1 * b.
    return use == QUANTITY_ADDED && is_near(a->factor + b->factor, 1, rounding) && a->factor > 0 && b->factor > 0
           ? QUANTITY_DIFFERS : QUANTITY_MAY_DIFFER;
}

// Whether a is in gn and b is a plain number: both say how many times the standard gravity.
static bool is_count_of_g(const Measure *a, const Measure *b) { return measure_is_g(a) && measure_is_number(b) && is_near(b->scale, 1, rounding); }

QuantityFit quantity_fit(const Quantity *a, const Quantity *b, QuantityUse use)
{
    const double factor = a->unit.scale / b->unit.scale, ratio = size_of(a->factor / b->factor);
    const bool has_zeros = has_zero(a) || has_zero(b);

    if (a->kind != QUANTITY_UNIT || b->kind != QUANTITY_UNIT)
        return QUANTITY_FITS;
    if (is_count_of_g(&a->unit, &b->unit) || is_count_of_g(&b->unit, &a->unit))
        return QUANTITY_FITS;
    if (!measure_is_same_kind(&a->unit, &b->unit))
        return a->scaled || b->scaled ? QUANTITY_MAY_DIFFER : QUANTITY_DIFFERS;
    if (has_zeros && !a->zero_unknown && !b->zero_unknown && a->unit.zero != b->unit.zero && measure_is_temperature(&a->unit)) {
        const bool is_same_step = is_near(factor, 1, rounding);
        // A difference in K is added to a temperature in degC or subtracted from it; but a temperature in degC is not subtracted from one in K.
        if (use != QUANTITY_COMPARED && is_same_step && !(use == QUANTITY_SUBTRACTED && !has_zero(a) && !b->constant && !b->scaled))
            return QUANTITY_FITS;
        return fit_zeros(a, b, factor, ratio);
    }
    return is_near(factor, 1, rounding) ? QUANTITY_FITS : fit_scales(a, b, use, factor, ratio);
}
