// SPDX-License-Identifier: Apache-2.0
#include "compiler/facts/fact.h"

#include <float.h>
#include <math.h>

#include "compiler/ir/eval.h"
#include "stdlib/convert.h"
#include "stdlib/elementary.h"
#include "stdlib/math.h"

// ---- helpers for numbers ----

static double infinity(void) { return sm_from_bits(0x7FF0000000000000u); }
static bool contains_number(Fact a, double x) { return a.lo <= x && x <= a.hi; }
static bool is_finite(Fact a) { return a.lo > -infinity() && a.hi < infinity(); }
static bool has_infinity(Fact a) { return a.lo == -infinity() || a.hi == infinity(); }
static bool can_be_negative(Fact a) { return a.lo < 0 || a.minus_zero; }
static bool is_whole_number(double x) { return sm_trunc(x) == x && x - x == 0; }
static bool is_wide_integer(SmType type) { return type == SM_I64 || type == SM_U64; }
static bool is_f32(double x) { return sm_from_f32(sm_round_f32(x)) == x; }

static double next_up(double x)
{
    const uint64_t u = sm_bits(x);

    if (x == infinity())
        return x;
    return x == 0 ? sm_from_bits(1) : sm_from_bits(x > 0 ? u + 1 : u - 1);
}

// Adjusts `whole`, `f32` and `minus_zero` to what the bounds imply.
static inline Fact normalize_fact(Fact a)
{
    if (a.whole && !is_finite(a))
        a.whole = false;
    if (a.lo == a.hi) {
        a.whole = is_whole_number(a.lo);
        a.f32 = is_f32(a.lo);
    }
    a.f32 |= a.whole && a.lo >= -16777216.0 && a.hi <= 16777216.0;       // 2^24
    a.minus_zero &= contains_number(a, 0);
    a.round_trips |= a.whole && a.lo > -FACT_EXACT && a.hi < FACT_EXACT;
    return a;
}

// Returns a fact with these bounds and properties; `f32` is derived from them.
static Fact make_fact(double lo, double hi, bool whole, bool nan, bool minus_zero)
{
    const Fact a = {lo, hi, whole, false, nan, minus_zero, false};

    return normalize_fact(a);
}

// Returns the fact about a value of which nothing is known.
static Fact any_fact(void) { return make_fact(-infinity(), infinity(), false, true, true); }

// 2^63 - 1 and 2^64 - 1 are not F64 numbers, so the upper bounds of I64 and U64 are 2^63 and 2^64, one above the largest value.
#define HALF(bytes) (2.0 * (double)(UINT64_C(1) << (bytes * 8 - 2)))              // half the number of values of that many bytes
#define BELOW(x, bytes) ((x) - (bytes < 8))
#define BOUNDS_SM_KIND_SIGNED(bytes) -HALF(bytes), BELOW(HALF(bytes), bytes), true, bytes < 4, false, false, bytes < 8
#define BOUNDS_SM_KIND_UNSIGNED(bytes) 0, BELOW(2 * HALF(bytes), bytes), true, bytes < 4, false, false, bytes < 8
#define BOUNDS_SM_KIND_BOOL(bytes) 0, 1, true, true, false, false, true
#define BOUNDS_SM_KIND_FLOAT(bytes) -HUGE_VAL, HUGE_VAL, false, bytes == 4, false, true, false

// Returns the fact of every value that a load of this type can produce; never NaN.
Fact fact_of_type(SmType type)
{
    switch (type) {                                  // not a table: in tcc HUGE_VAL is not a constant expression
    case SM_TYPE_COUNT: break;
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) \
    case SM_##name: return (Fact){BOUNDS_##kind(bytes)};
#include "stdlib/types.def"
#undef SM_TYPE
    }
    return any_fact();
}

// Returns the fact of exactly the number that these bits encode in this type.
Fact fact_of_cell(SmType type, uint64_t bits)
{
    const SmF64 x = ir_number(type, bits);
    Fact r;

    if (sm_is_nan(x))
        return make_fact(1, 0, false, true, false);
    if (x > 0 && x <= INT32_MAX && x == (double)(int32_t)x)              // a shortcut for most constants
        return (Fact){x, x, .whole = true, .f32 = is_f32(x), .round_trips = true};
    r = make_fact(x, x, false, false, x == 0 && sm_bits(x) != 0);
    r.round_trips = !is_wide_integer(type) || sm_cell_from_f64(type, x) == bits;
    return r;
}

Fact fact_of_bool(bool may_be_false, bool may_be_true)
{
    return (Fact){may_be_false ? 0 : 1, may_be_true ? 1 : 0, .whole = true, .f32 = true, .round_trips = true};
}

// ---- arithmetic ----
// If computing a bound gives NaN (inf - inf, 0 * inf), that bound is ignored.

// Returns the fact of a value that is never a number: an empty interval, whose lower bound is above the upper one.
static Fact fact_without_number(bool nan) { return make_fact(1, 0, false, nan, false); }
static bool is_empty(Fact a) { return a.lo > a.hi; }

static Fact add_facts(Fact a, Fact b)
{
    const bool nan = a.nan || b.nan || (a.lo == -infinity() && b.hi == infinity()) || (a.hi == infinity() && b.lo == -infinity());
    const double lo = a.lo + b.lo, hi = a.hi + b.hi;

    return make_fact(lo == lo ? lo : -infinity(), hi == hi ? hi : infinity(), a.whole && b.whole, nan, a.minus_zero && b.minus_zero);
}

static Fact negate_fact(Fact a)
{
    Fact r = make_fact(-a.hi, -a.lo, a.whole, a.nan, contains_number(a, 0));

    r.f32 |= a.f32;
    return r;
}

static Fact subtract_facts(Fact a, Fact b)
{
    Fact r = add_facts(a, negate_fact(b));

    r.minus_zero = a.minus_zero && contains_number(b, 0) && contains_number(r, 0);
    return r;
}

// Moves a bound of *r, if necessary, so that its interval contains x.
static void extend_to_number(Fact *r, double x)
{
    if (x < r->lo)
        r->lo = x;
    if (x > r->hi)
        r->hi = x;
}

// Returns the smallest interval that contains four numbers: the results of an operation on each pair of its operands' bounds.
static Fact hull_of_four(SmF64 w, SmF64 x, SmF64 y, SmF64 z)
{
    Fact r = {infinity(), -infinity(), false, false, false, false, false};

    extend_to_number(&r, w);
    extend_to_number(&r, x);
    extend_to_number(&r, y);
    extend_to_number(&r, z);
    return r;
}

static Fact multiply_facts(Fact a, Fact b)
{
    Fact r = hull_of_four(sm_mul(a.lo, b.lo), sm_mul(a.lo, b.hi), sm_mul(a.hi, b.lo), sm_mul(a.hi, b.hi));
    const bool zero_by_infinity = (contains_number(a, 0) && has_infinity(b)) || (contains_number(b, 0) && has_infinity(a));

    if (contains_number(a, 0) || contains_number(b, 0))
        extend_to_number(&r, 0);
    r.whole = a.whole && b.whole;
    r.nan = a.nan || b.nan || zero_by_infinity;
    // A product of whole numbers is zero only if a factor is zero.  Other products can also underflow to zero.
    r.minus_zero = r.whole ? a.minus_zero || b.minus_zero || (contains_number(a, 0) && b.lo < 0) || (contains_number(b, 0) && a.lo < 0)
                           : can_be_negative(a) || can_be_negative(b);
    return normalize_fact(r);
}

// Returns the fact about a value multiplied by itself: the result is never negative, and zero is never multiplied by infinity.
static Fact square_fact(Fact a)
{
    const double reach = sm_max(sm_abs(a.lo), sm_abs(a.hi)), least = contains_number(a, 0) ? 0 : sm_min(sm_abs(a.lo), sm_abs(a.hi));

    return make_fact(sm_mul(least, least), sm_mul(reach, reach), a.whole, a.nan, false);
}

static Fact divide_facts(Fact a, Fact b)
{
    Fact r;

    if (contains_number(b, 0))
        return make_fact(-infinity(), infinity(), false, a.nan || b.nan || contains_number(a, 0) || has_infinity(a), true);
    r = hull_of_four(sm_div(a.lo, b.lo), sm_div(a.lo, b.hi), sm_div(a.hi, b.lo), sm_div(a.hi, b.hi));
    r.nan = a.nan || b.nan || (has_infinity(a) && has_infinity(b));
    if (r.lo > r.hi || r.nan)
        return make_fact(-infinity(), infinity(), false, r.nan, true);
    r.minus_zero = can_be_negative(a) || can_be_negative(b);
    return normalize_fact(r);
}

// Returns the fact about the result of a rounding operation or of sign.  These are monotonic, so applying `op` to the bounds of a gives the
// bounds of the result.
static Fact apply_monotonic(SmF64 (*op)(SmF64), Fact a, bool minus_zero)
{
    return make_fact(op(a.lo), op(a.hi), true, a.nan, minus_zero);
}

static Fact fact_of_abs(Fact a)
{
    const double lo = sm_abs(a.lo), hi = sm_abs(a.hi);
    Fact r = make_fact(contains_number(a, 0) ? 0 : lo < hi ? lo : hi, lo < hi ? hi : lo, a.whole, a.nan, false);

    r.f32 |= a.f32;
    return r;
}

static Fact fact_of_sqrt(Fact a)
{
    if (a.hi < 0)
        return fact_without_number(true);
    return make_fact(a.lo > 0 ? sm_sqrt(a.lo) : 0, sm_sqrt(a.hi), false, a.nan || a.lo < 0, a.minus_zero);
}

// ---- elementary functions ----

// Returns y, moved toward `to` by more than the errors of two results.  An error is below 1 ulp, which is at most two neighbours, and
// results are not proved to be monotonic.
static double move_bound(double y, double to)
{
    const double finite = sm_max(sm_min(y, DBL_MAX), -DBL_MAX), error = sm_max(sm_abs(finite) * 0x1p-50, 0x1p-1070);

    return to < finite ? finite - error : finite + error;
}

// Returns the fact about f(x) for an x with the fact a. f increases on the numbers from `from` to `to`, has results from `least` to `most`, and is
// NaN for any other number.
static Fact fact_of_increasing(SmF64 (*f)(SmF64), Fact a, double from, double to, double least, double most)
{
    const double lo = sm_max(a.lo, from), hi = sm_min(a.hi, to);
    const bool nan = a.nan || a.lo < from || a.hi > to;

    if (lo > hi)
        return fact_without_number(true);
    return make_fact(sm_max(move_bound(f(lo), -infinity()), least), sm_min(move_bound(f(hi), infinity()), most), false, nan, a.minus_zero);
}

static Fact fact_of_acos(Fact a)
{
    const Fact r = fact_of_increasing(sm_asin, a, -1, 1, -2, 2);

    return is_empty(r) ? r : make_fact(0, 0x1.921fb54442d18p+1, false, r.nan, false);
}

// Returns the fact about pow(x, y). The result is negative only for negative x, and is a number for every other x.
static Fact fact_of_pow(Fact x, Fact y)
{
    const bool negative = can_be_negative(x);

    return make_fact(negative ? -infinity() : 0, infinity(), false, x.nan || y.nan || x.lo < 0, negative);
}

static Fact fact_of_elementary(IrOp op, Fact a, Fact b)
{
    const double pi = 0x1.921fb54442d18p+1;

    switch ((int)op) {
    case IR_exp: return fact_of_increasing(sm_exp, a, -infinity(), infinity(), 0, infinity());
    case IR_log: return fact_of_increasing(sm_log, a, 0, infinity(), -infinity(), infinity());
    case IR_log10: return fact_of_increasing(sm_log10, a, 0, infinity(), -infinity(), infinity());
    case IR_sin: case IR_cos: return make_fact(-1, 1, false, a.nan || has_infinity(a), true);
    case IR_tan: return make_fact(-infinity(), infinity(), false, a.nan || has_infinity(a), true);
    case IR_asin: return fact_of_increasing(sm_asin, a, -1, 1, -pi / 2, pi / 2);
    case IR_acos: return fact_of_acos(a);
    case IR_atan: return fact_of_increasing(sm_atan, a, -infinity(), infinity(), -pi / 2, pi / 2);
    case IR_pow: return fact_of_pow(a, b);
    case IR_atan2: return make_fact(-pi, pi, false, a.nan || b.nan, true);
    default: return make_fact(0, infinity(), false, a.nan || b.nan, false);
    }
}

static Fact fact_of_min_or_max(SmF64 (*op)(SmF64, SmF64), Fact a, Fact b)
{
    Fact r = make_fact(op(a.lo, b.lo), op(a.hi, b.hi), a.whole && b.whole, a.nan || b.nan, a.minus_zero || b.minus_zero);

    r.f32 |= a.f32 && b.f32;
    return r;
}

// ---- conversions ----

// Returns the fact about a value with the fact a, converted to type `to`.
Fact fact_convert(Fact a, SmType to)
{
    Fact r;

    if (to == SM_BOOL)
        return fact_of_bool(contains_number(a, 0) || a.nan, !is_empty(a) && (a.lo < 0 || a.hi > 0));
    if (a.nan) {                                      // a conversion turns NaN into 0
        const Fact zero = make_fact(0, 0, true, false, false);
        a = is_empty(a) ? zero : fact_join(a, zero);
    }
    a.nan = false;
    if (to == SM_F64)
        return a;
    if (to != SM_F32) {
        const Fact t = fact_of_type(to);
        return make_fact(sm_min(sm_max(sm_trunc(a.lo), t.lo), t.hi), sm_max(sm_min(sm_trunc(a.hi), t.hi), t.lo), true, false, false);
    }
    // Rounding to F32 is monotonic.  A small negative number becomes -0.
    r = make_fact(sm_from_f32(sm_round_f32(a.lo)), sm_from_f32(sm_round_f32(a.hi)), a.whole, false, a.minus_zero || (a.lo < 0 && !a.whole));
    r.f32 = true;
    return r;
}

// ---- comparisons ----

// Returns the fact about the result of a comparison that is always true, never true, or (neither) sometimes true.
static Fact fact_of_outcome(bool always, bool never) { return fact_of_bool(!always, !never); }

// Return the facts about the results of a < b and of a <= b. `nan`: an operand may be NaN, which makes the comparison false.
static Fact fact_of_less(Fact a, Fact b, bool nan) { return fact_of_outcome(!nan && a.hi < b.lo, a.lo >= b.hi); }
static Fact fact_of_less_or_equal(Fact a, Fact b, bool nan) { return fact_of_outcome(!nan && a.hi <= b.lo, a.lo > b.hi); }

// Whether b is one number that a cannot be: a is whole and b is not, or a is an F32 and b is not.
static bool cannot_contain(Fact a, Fact b) { return b.lo == b.hi && ((a.whole && !b.whole) || (a.f32 && !b.f32)); }

static bool always_equal(Fact a, Fact b, bool nan) { return !nan && a.lo == a.hi && b.lo == b.hi && a.lo == b.lo; }
static bool never_equal(Fact a, Fact b) { return a.hi < b.lo || b.hi < a.lo || cannot_contain(a, b) || cannot_contain(b, a); }

// Whether the conversion of a value of this type to F64 may round.  The fact of an I64 or U64 bounds the number before the conversion.
// From 2^53 on, different numbers may round to the same F64.
static bool may_be_rounded(Fact a, SmType type)
{
    return is_wide_integer(type) && !fact_within(a, -FACT_EXACT, FACT_EXACT);
}

static Fact fact_of_comparison_ins(const IrIns *i, Fact a, Fact b, SmType type)
{
    const bool nan = a.nan || b.nan;

    if (is_empty(a) || is_empty(b))                       // an operand without numbers can only be NaN
        return i->op == IR_ne ? fact_of_bool(false, true) : fact_of_bool(true, false);
    if (may_be_rounded(a, type) || may_be_rounded(b, type))
        return fact_of_bool(true, true);
    switch ((int)i->op) {
    case IR_eq: return fact_of_outcome(always_equal(a, b, nan), never_equal(a, b));
    case IR_ne: return fact_of_outcome(never_equal(a, b), always_equal(a, b, nan));
    case IR_lt: return fact_of_less(a, b, nan);
    case IR_le: return fact_of_less_or_equal(a, b, nan);
    case IR_gt: return fact_of_less(b, a, nan);
    default: return fact_of_less_or_equal(b, a, nan);
    }
}

// ---- what a true comparison says about its operands ----

static void bound_above(Fact *a, double hi)
{
    if (hi < a->hi)
        a->hi = hi;
}

static void bound_below(Fact *a, double lo)
{
    if (lo > a->lo)
        a->lo = lo;
}

// Narrows both facts to the values for which *a < *b, or *a <= *b.
static void bound_by_less(Fact *a, Fact *b, bool or_equal)
{
    const Fact was = *a;

    bound_above(a, or_equal ? b->hi : fact_next_below(*a, b->hi));
    bound_below(b, or_equal ? was.lo : fact_next_above(*b, was.lo));
}

// Excludes b from *a, if b is exactly one number and a bound of *a.
static void bound_by_unequal(Fact *a, const Fact *b)
{
    if (b->lo != b->hi)
        return;
    if (a->lo == b->lo)
        bound_below(a, fact_next_above(*a, a->lo));
    if (a->hi == b->lo)
        bound_above(a, fact_next_below(*a, a->hi));
}

// Narrows the facts of both operands to the values for which `*a op *b` is true.
void fact_bound_by_comparison(Fact *a, IrOp op, Fact *b)
{
    switch ((int)op) {
    case IR_eq: bound_by_less(a, b, true); bound_by_less(b, a, true); break;
    case IR_ne: bound_by_unequal(a, b); bound_by_unequal(b, a); break;
    case IR_lt: bound_by_less(a, b, false); break;
    case IR_le: bound_by_less(a, b, true); break;
    case IR_gt: bound_by_less(b, a, false); break;
    case IR_ge: bound_by_less(b, a, true); break;
    }
}

// ---- all operations ----

static Fact fact_of_logic(const IrIns *i, Fact a, Fact b)
{
    if (i->op == IR_not)
        return fact_of_bool(a.hi == 1, a.lo == 0);
    if (i->op == IR_and)
        return fact_of_bool(a.lo == 0 || b.lo == 0, a.hi == 1 && b.hi == 1);
    return fact_of_bool(a.lo == 0 && b.lo == 0, a.hi == 1 || b.hi == 1);
}

static Fact fact_of_arithmetic(const IrIns *i, Fact a, Fact b)
{
    switch ((int)i->op) {
    case IR_add: return add_facts(a, b);
    case IR_sub: return subtract_facts(a, b);
    case IR_mul: return i->a == i->b ? square_fact(a) : multiply_facts(a, b);
    case IR_div: return divide_facts(a, b);
    case IR_neg: return negate_fact(a);
    case IR_abs: return fact_of_abs(a);
    case IR_floor: return apply_monotonic(sm_floor, a, a.minus_zero);
    case IR_ceil: return apply_monotonic(sm_ceil, a, can_be_negative(a));
    case IR_trunc: return apply_monotonic(sm_trunc, a, can_be_negative(a));
    case IR_round: return apply_monotonic(sm_round, a, can_be_negative(a));
    case IR_sqrt: return fact_of_sqrt(a);
    case IR_sign: return apply_monotonic(sm_sign, a, a.minus_zero);
    case IR_min: return fact_of_min_or_max(sm_min, a, b);
    case IR_max: return fact_of_min_or_max(sm_max, a, b);
    }
    return ir_is_elementary(i->op) ? fact_of_elementary(i->op, a, b) : any_fact();
}

// Returns the fact about the result of an arithmetic operation.  An operation narrowed to an integer or F32 (passes/narrow.c) has the
// result of the operation on F64, converted to its type.
static Fact fact_of_operation(const IrIns *i, Fact a, Fact b)
{
    const bool two = ir_op_info[i->op].operands == 2;
    Fact r;
    bool nan;

    if (i->op == IR_pow || i->op == IR_hypot) {       // these two can return a number although an operand is NaN
        if (is_empty(a) || is_empty(b))
            return any_fact();
    } else if (is_empty(a) || (two && is_empty(b)))
        return fact_without_number(true);
    r = fact_of_arithmetic(i, a, b);
    nan = r.nan;
    if (i->type == SM_F64)
        return r;
    r = fact_convert(r, i->type);
    r.nan = nan && i->type == SM_F32;
    r.round_trips = true;
    return r;
}

// Returns the fact about a value of type `from` with the fact a, converted to type `to`.  Conversions go through F64, and a 64-bit integer
// converted from an F64 is this number or the last integer of its type, which is the nearest to an F64.  So it round-trips.
static Fact fact_of_conversion(Fact a, SmType from, SmType to)
{
    Fact r = fact_convert(a, to);

    if (is_wide_integer(to))
        r.round_trips |= from != to || a.round_trips;
    return r;
}

// Returns the fact about the result of instruction i if its operands have the facts *a and *b.
Fact fact_of_result(const IrIns *i, const Fact *a, const Fact *b, SmType type_of_a)
{
    switch (ir_op_info[i->op].types) {
    case IR_T_CONST: return fact_of_cell(i->type, i->bits);
    case IR_T_CONVERT: return fact_of_conversion(*a, type_of_a, i->type);
    case IR_T_SAME: return fact_of_operation(i, *a, *b);
    case IR_T_COMPARE: return fact_of_comparison_ins(i, *a, *b, type_of_a);
    case IR_T_LOGIC: return fact_of_logic(i, *a, *b);
    case IR_T_LOAD: return fact_of_type(i->type);
    case IR_T_STORE: case IR_T_SAMPLE: case IR_T_STAT: break;
    }
    return any_fact();
}

// Returns the fact about the mean of samples that have the fact a.  The sum of up to SM_WINDOW_MAX whole 32-bit numbers is exact.  Other
// samples are summed in pairs, which rounds each at most 17 times (`error` covers that), and can overflow.
static Fact fact_of_average(Fact a)
{
    const double reach = sm_max(sm_abs(a.lo), sm_abs(a.hi)), error = reach / 1099511627776.0;       // a relative error of 2^-40

    if (a.whole && reach <= 4294967296.0)
        return make_fact(a.lo, a.hi, false, false, a.minus_zero);
    if (!(reach < 1e300))
        return any_fact();
    return make_fact(a.lo - error, a.hi + error, false, false, true);
}

// Returns the fact about a statistic of a rolling window whose samples have the fact `sample`.
Fact fact_of_stat(SmStat stat, Fact sample)
{
    const IrIns difference = {.op = IR_sub, .type = SM_F64};
    const bool infinite = has_infinity(sample);

    switch (stat) {
    case SM_STAT_AVG: return fact_of_average(sample);
    case SM_STAT_MEDIAN: return make_fact(sample.lo, sample.hi, false, infinite, true);      // not whole, because it can be the mean of two samples
    case SM_STAT_RANGE: return make_fact(0, infinite ? infinity() : sample.hi - sample.lo, sample.whole, infinite, false);
    case SM_STAT_CHANGE: return fact_of_result(&difference, &sample, &sample, SM_F64);
    case SM_STAT_ELAPSED: case SM_STAT_RUN_TIME: return make_fact(0, 18446744073709551616.0, true, false, false);
    case SM_STAT_RUN_STEPS: return make_fact(0, SM_WINDOW_MAX, true, false, false);
    case SM_STAT_MIN: case SM_STAT_MAX: case SM_STAT_OLDEST: case SM_STAT_NEWEST: case SM_STAT_COUNT: break;
    }
    return sample;
}

// ---- the lattice ----

// Returns what is known about a value for which a or b is true.
Fact fact_join(Fact a, Fact b)
{
    Fact r = is_empty(a) ? b : a;

    if (!is_empty(a) && !is_empty(b)) {
        extend_to_number(&r, b.lo);
        extend_to_number(&r, b.hi);
        r.whole = a.whole && b.whole;
        r.f32 = a.f32 && b.f32;
        r.minus_zero = a.minus_zero || b.minus_zero;
        r.round_trips = a.round_trips && b.round_trips;
    }
    r.nan = a.nan || b.nan;
    return r;
}

// Returns what is known about a value for which a and b are true; a if they contradict.
Fact fact_meet(Fact a, Fact b)
{
    Fact r = {a.lo > b.lo ? a.lo : b.lo, a.hi < b.hi ? a.hi : b.hi, a.whole || b.whole, a.f32 || b.f32, a.nan && b.nan,
              a.minus_zero && b.minus_zero, a.round_trips || b.round_trips};

    if (r.lo > r.hi)
        return a;
    return normalize_fact(r);
}

bool fact_is_same(const Fact *a, const Fact *b)
{
    return sm_bits(a->lo) == sm_bits(b->lo) && sm_bits(a->hi) == sm_bits(b->hi) && fact_equal(*a, *b);
}

// Returns the number of limits below x.
static size_t count_limits_below(const FactLimits *limits, double x)
{
    size_t below = 0, end = limits->n;

    while (below < end) {
        const size_t middle = below + (end - below) / 2;
        if (limits->at[middle] < x)
            below = middle + 1;
        else
            end = middle;
    }
    return below;
}

// Widens a fact that has grown from `before` to `now`: each bound that grew moves outward to the next limit, or to the type's bound if there
// is no limit beyond it.
Fact fact_widen(Fact before, Fact now, SmType type, const FactLimits *limits)
{
    const Fact t = fact_of_type(type);

    if (now.lo < before.lo) {
        const size_t i = count_limits_below(limits, now.lo), next = i + (i < limits->n && limits->at[i] == now.lo);
        now.lo = next > 0 && limits->at[next - 1] > t.lo ? limits->at[next - 1] : t.lo;
    }
    if (now.hi > before.hi) {
        const size_t next = count_limits_below(limits, now.hi);
        now.hi = next < limits->n && limits->at[next] < t.hi ? limits->at[next] : t.hi;
    }
    return normalize_fact(now);
}

// ---- queries ----

// Whether a is exactly one number, which *x receives; +0 and -0 count as two.
bool fact_is_number(Fact a, double *x)
{
    *x = a.lo == 0 ? 0 : a.lo;
    return a.lo == a.hi && !a.nan && !a.minus_zero;
}

// Whether a is always a number within these bounds.
bool fact_within(Fact a, double lo, double hi) { return !a.nan && !is_empty(a) && a.lo >= lo && a.hi <= hi; }

// Whether a is always a number in the type's range: conversion never saturates.
bool fact_fits(Fact a, SmType type)
{
    const Fact t = fact_of_type(type);

    // The upper bounds of I64 and U64, 2^63 and 2^64, are one above their largest values.
    return fact_within(a, t.lo, t.hi) && (sm_type_info[type].bytes < 8 || type == SM_F64 || a.hi < t.hi);
}

// Returns the next number above x that a value with fact a can have: the next whole number if a.whole, else the next F64.
double fact_next_above(Fact a, double x)
{
    return a.whole && sm_abs(x) < FACT_EXACT ? sm_floor(x) + 1 : next_up(x);
}

// Returns the next number below x that a value with fact a can have: the next whole number if a.whole, else the next F64.
double fact_next_below(Fact a, double x)
{
    return a.whole && sm_abs(x) < FACT_EXACT ? sm_ceil(x) - 1 : -next_up(-x);
}
