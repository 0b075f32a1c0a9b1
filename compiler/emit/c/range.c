// SPDX-License-Identifier: Apache-2.0
// What values a temporary can have, seen from its own block alone: enough to leave out conversions that cannot saturate and
// checks for NaN where there can be none.  Bounds are computed with the language's own operations, which are monotonic, so
// they hold after rounding too.
#include "compiler/emit/c/fn.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

static double infinity(void) { return sm_from_bits(0x7FF0000000000000u); }

static CRange range(double lo, double hi, bool nan)
{
    CRange r = { lo, hi, nan };
    return r;
}

static CRange anything(bool nan) { return range(-infinity(), infinity(), nan); }

CRange range_of_type(SmType type)
{
    const unsigned bits = sm_type_info[type].bytes * 8u;
    const double power = bits == 64 ? 18446744073709551616.0 : (double)(UINT64_C(1) << (bits < 64 ? bits : 0));

    switch (sm_type_info[type].kind) {
    case SM_KIND_SIGNED: return range(-power / 2, bits == 64 ? power / 2 : power / 2 - 1, false);
    case SM_KIND_UNSIGNED: return range(0, bits == 64 ? power : power - 1, false);
    case SM_KIND_FLOAT: return anything(false);
    case SM_KIND_BOOL: return range(0, 1, false);
    }
    return anything(true);
}

bool range_fits(CRange r, SmType type)
{
    const CRange t = range_of_type(type);

    // 2^63 and 2^64 are bounds that the 64-bit types themselves do not reach.
    return !r.nan && r.lo >= t.lo && (sm_type_info[type].bytes == 8 ? r.hi < t.hi : r.hi <= t.hi);
}

static bool is_infinite(CRange r) { return r.lo == -infinity() || r.hi == infinity(); }
static bool has_zero(CRange r) { return r.lo <= 0 && r.hi >= 0; }

static CRange add(CRange a, CRange b)
{
    if (is_infinite(a) && is_infinite(b))
        return anything(true);
    return range(sm_add(a.lo, b.lo), sm_add(a.hi, b.hi), a.nan || b.nan);
}

static CRange negate(CRange a) { return range(-a.hi, -a.lo, a.nan); }

// The hull of the four ways to combine the bounds; none of them may be NaN.
static CRange corners(SmF64 (*op)(SmF64, SmF64), CRange a, CRange b)
{
    const double c[4] = { op(a.lo, b.lo), op(a.lo, b.hi), op(a.hi, b.lo), op(a.hi, b.hi) };
    CRange r = { c[0], c[0], a.nan || b.nan };

    for (int i = 1; i < 4; i++) {
        r.lo = c[i] < r.lo ? c[i] : r.lo;
        r.hi = c[i] > r.hi ? c[i] : r.hi;
    }
    return r;
}

static CRange multiply(CRange a, CRange b)
{
    if (is_infinite(a) || is_infinite(b))
        return anything(a.nan || b.nan || has_zero(a) || has_zero(b));
    return corners(sm_mul, a, b);
}

static CRange divide(CRange a, CRange b)
{
    if (has_zero(b) || is_infinite(b))
        return anything(true);
    if (is_infinite(a))
        return anything(a.nan || b.nan);
    return corners(sm_div, a, b);
}

static CRange monotonic(SmF64 (*op)(SmF64), CRange a) { return range(op(a.lo), op(a.hi), a.nan); }

static CRange absolute(CRange a)
{
    const double lo = sm_abs(a.lo), hi = sm_abs(a.hi);

    return range(has_zero(a) ? 0 : lo < hi ? lo : hi, lo < hi ? hi : lo, a.nan);
}

static CRange root(CRange a)
{
    return a.lo < 0 ? range(0, infinity(), true) : monotonic(sm_sqrt, a);
}

// A conversion's result is in the type's range; what was in it before stays where it was, but for fractions.
static CRange convert(CRange a, SmType to)
{
    const CRange t = range_of_type(to);

    if (to == SM_BOOL || to == SM_F32)
        return t;
    if (to != SM_F64)
        a = monotonic(sm_trunc, a);
    if (a.nan && !has_zero(a))
        a = range(a.lo < 0 ? a.lo : 0, a.hi > 0 ? a.hi : 0, false);
    return range(sm_min(sm_max(a.lo, t.lo), t.hi), sm_max(sm_min(a.hi, t.hi), t.lo), false);
}

static double rounded(double x) { return (double)sm_round_f32(x); }

static CRange range_of_op(const CFn *fn, const IrIns *i)
{
    const CRange a = i->a != IR_NONE ? fn->ins[i->a].range : anything(true);
    const CRange b = i->b != IR_NONE ? fn->ins[i->b].range : anything(true);

    switch (i->op) {
    case IR_const: {
        const SmF64 x = i->type == SM_F64 ? sm_from_bits(i->bits) : sm_cell_to_f64(i->type, i->bits);
        return sm_is_nan(x) ? anything(true) : range(x, x, false);
    }
    case IR_load: return range_of_type(i->type);
    case IR_cvt: return convert(a, i->type);
    case IR_add: return add(a, b);
    case IR_sub: return add(a, negate(b));
    case IR_mul: return multiply(a, b);
    case IR_div: return divide(a, b);
    case IR_neg: return negate(a);
    case IR_abs: return absolute(a);
    case IR_floor: return monotonic(sm_floor, a);
    case IR_ceil: return monotonic(sm_ceil, a);
    case IR_trunc: return monotonic(sm_trunc, a);
    case IR_round: return monotonic(sm_round, a);
    case IR_sqrt: return root(a);
    case IR_sign: return monotonic(sm_sign, a);
    case IR_min: return range(sm_min(a.lo, b.lo), sm_min(a.hi, b.hi), a.nan || b.nan);
    case IR_max: return range(sm_max(a.lo, b.lo), sm_max(a.hi, b.hi), a.nan || b.nan);
    case IR_eq: case IR_ne: case IR_lt: case IR_le: case IR_gt: case IR_ge: case IR_and: case IR_or: case IR_not:
        return range(0, 1, false);
    case IR_stat: return anything(true);
    case IR_store: case IR_sample: case IR_OP_COUNT: break;
    }
    return anything(true);
}

CRange range_of(const CFn *fn, const IrIns *i)
{
    const CRange r = range_of_op(fn, i);

    return i->type == SM_F32 ? monotonic(rounded, r) : r;
}
