// SPDX-License-Identifier: Apache-2.0
// Additions to 64-bit integer variables, such as `count = count + 1`.  The language computes the sum as an F64, which is exact up to 2^53; from
// there on, adding one changes nothing.  Emitted C calls an integer function of stdlib that tests at run time for sums beyond that limit.
#include "compiler/emit/c/fn.h"
#include "stdlib/convert.h"

// The sum or difference of a counter and its increment, which is a constant or the conversion of an integer or a bool.
typedef struct CCounter {
    IrRef v, by;              // the counter and the increment, as F64s
    IrRef condition;          // a bool: the increment is 1 if it is true, else 0; IR_NONE: the increment is always 1
    bool down;                // the increment is subtracted, not added
} CCounter;

// If r is the conversion of an integer to F64 and is written as a subexpression, returns the integer; otherwise IR_NONE.
static IrRef find_converted_integer(const CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);

    return !c_is_const(fn, r) && fn->ins[r].form == C_SUBEXPRESSION && i->op == IR_cvt && ir_is_integer(c_ins(fn, i->a)->type) ? i->a : IR_NONE;
}

// If r is the conversion of a bool to F64 and is written as a subexpression, returns the bool; otherwise IR_NONE.
static IrRef find_converted_bool(const CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);

    return !c_is_const(fn, r) && fn->ins[r].form == C_SUBEXPRESSION && i->op == IR_cvt && c_ins(fn, i->a)->type == SM_BOOL ? i->a : IR_NONE;
}

// Whether r can be an increment: a bool, or a whole number from -2^52 to 2^52, as the count helpers require.
static bool is_increment(const CFn *fn, IrRef r)
{
    const Fact x = fn->ins[r].fact;

    if (find_converted_bool(fn, r) != IR_NONE)
        return true;
    return x.whole && fact_within(x, -FACT_EXACT / 2, FACT_EXACT / 2) && (c_is_const(fn, r) ? x.lo != 0 : find_converted_integer(fn, r) != IR_NONE);
}

// Whether r is an integer of type `to`, converted to F64.
static bool is_counter_value(const CFn *fn, IrRef r, SmType to)
{
    return find_converted_integer(fn, r) != IR_NONE && c_ins(fn, find_converted_integer(fn, r))->type == to;
}

// If r is an F64 `v + n`, `n + v` or `v - n` that is written as a subexpression, with a counter v of type `to` and an increment n (is_increment),
// fills *c and returns true.  Otherwise *c has no meaning.
static bool match_counter(const CFn *fn, IrRef r, SmType to, CCounter *c)
{
    const IrIns *i = c_ins(fn, r);
    const bool swap = i->op == IR_add && !is_counter_value(fn, i->a, to);

    if ((i->op != IR_add && i->op != IR_sub) || i->type != SM_F64 || fn->ins[r].form != C_SUBEXPRESSION)
        return false;
    c->v = swap ? i->b : i->a;
    c->by = swap ? i->a : i->b;
    c->down = i->op == IR_sub;
    c->condition = find_converted_bool(fn, c->by);
    return is_counter_value(fn, c->v, to) && is_increment(fn, c->by);
}

// Whether c adds one, or a bool, to a U64 that is at most 2^53.
static bool counts_up_by_one(const CFn *fn, const CCounter *c, SmType to)
{
    double by;
    const bool by_one = c->condition != IR_NONE || (fact_is_number(fn->ins[c->by].fact, &by) && by == 1);

    return to == SM_U64 && !c->down && by_one && fact_within(fn->ins[c->v].fact, 0, FACT_EXACT);
}

// Writes the increment as the second argument of a helper.  `up`: the helper is sm_count_up, which has no second argument, or sm_count_up_if,
// whose second argument is the condition.
static void write_increment(CFn *fn, const CCounter *c, bool up)
{
    const IrRef n = find_converted_integer(fn, c->by);
    const double x = fn->ins[c->by].fact.lo;

    if (up && c->condition == IR_NONE)
        return;
    c_write(fn, ", ");
    if (c->condition != IR_NONE) {
        c_write_condition(fn, c->condition, false, up ? PREC_ANY : PREC_OR);
        c_write(fn, up ? "" : c->down ? " ? -1 : 0" : " ? 1 : 0");
    } else if (c_is_const(fn, c->by)) {
        c_write_constant(fn, c->by, SM_I64, sm_cell_from_f64(SM_I64, c->down ? -x : x));
    } else if (c->down || c_ins(fn, n)->type == SM_U64) {
        c_write(fn, c->down ? "-(int64_t)" : "(int64_t)");
        c_write_value(fn, n, PREC_PRIMARY);
    } else {
        c_write_assigned(fn, n);
    }
}

// If the store increments its own variable by one and numbers are soft, writes a call of sm_soft_increment and returns true.
bool soft_try_write_count(CFn *fn, const IrIns *store)
{
    const IrIns *i = c_ins(fn, store->a);
    IrRef v;
    CCounter c;

    if (!fn->u->soft || i->op != IR_cvt || i->type != SM_U64 || c_is_const(fn, store->a) || fn->ins[store->a].form != C_SUBEXPRESSION ||
        c_ins(fn, i->a)->type != SM_F64 || !match_counter(fn, i->a, SM_U64, &c) || c.condition != IR_NONE ||
        !counts_up_by_one(fn, &c, SM_U64))
        return false;
    v = find_converted_integer(fn, c.v);
    if (c_ins(fn, v)->op != IR_load || c_ins(fn, v)->var != store->var || fn->ins[v].form != C_SUBEXPRESSION)
        return false;
    c_write(fn, "sm_soft_increment(&");
    c_write_member(fn, store->var);
    c_write(fn, ")");
    return true;
}

// Returns the name of the stdlib function that computes c.
static const char *counter_helper(CFn *fn, const CCounter *c, SmType to)
{
    if (!counts_up_by_one(fn, c, to))
        return to == SM_U64 ? "sm_count_u64" : "sm_count_i64";
    return c->condition == IR_NONE ? "sm_count_up" : "sm_count_up_if";
}

// If r is a counter plus or minus a whole number, as an F64 that is about to be converted to the 64-bit integer type `to`, writes the
// converted sum as a call of a count helper and returns true.
bool c_try_write_count(CFn *fn, IrRef r, SmType to)
{
    CCounter c;

    if ((to != SM_U64 && to != SM_I64) || !match_counter(fn, r, to, &c))
        return false;
    c_write(fn, helper_require(fn->u, counter_helper(fn, &c, to)));
    c_write(fn, "(");
    c_write_value(fn, find_converted_integer(fn, c.v), PREC_ANY);
    write_increment(fn, &c, counts_up_by_one(fn, &c, to));
    c_write(fn, ")");
    return true;
}
