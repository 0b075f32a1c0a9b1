// SPDX-License-Identifier: Apache-2.0
// Comparisons.  Both sides are doubles by their meaning; where the result is the same they come out as what they are:
// integers, or truths.
#include "compiler/emit/c/fn.h"
#include "stdlib/convert.h"

static const IrIns *ins(const CFn *fn, IrRef r) { return &fn->f->ins.at[r]; }
static void put(CFn *fn, const char *text) { buf_str(&fn->line, text); }

// The integer or bool that r converts to F64 in place, or IR_NONE.
static IrRef converted_from(const CFn *fn, IrRef r)
{
    const IrIns *i = ins(fn, r);

    if (fn->ins[r].is_const || fn->ins[r].how != C_INLINE || i->op != IR_cvt || i->type != SM_F64)
        return IR_NONE;
    return c_is_integer(ins(fn, i->a)->type) || ins(fn, i->a)->type == SM_BOOL ? i->a : IR_NONE;
}

static IrOp mirrored(IrOp op)
{
    return op == IR_lt ? IR_gt : op == IR_le ? IR_ge : op == IR_gt ? IR_lt : op == IR_ge ? IR_le : op;
}

static double number(const CFn *fn, IrRef r)
{
    return ins(fn, r)->type == SM_F64 ? sm_from_bits(fn->ins[r].bits) : sm_cell_to_f64(ins(fn, r)->type, fn->ins[r].bits);
}

// Whether `integer op constant` can be written with integers: the order is the same as after conversion to F64.  It is for
// constants below 2^53; 2^53 + 1 is converted to 2^53 itself.  Not where the type's limits decide, since compilers warn
// about comparisons that hold always or never.
static bool is_plain_limit(const CFn *fn, IrOp op, IrRef constant, SmType t)
{
    const CRange r = range_of_type(t);
    const double x = number(fn, constant);

    if (!fn->ins[constant].is_const || !(x >= r.lo && x <= r.hi && x > -9007199254740992.0 && x < 9007199254740992.0))
        return false;
    if ((x == r.lo && (op == IR_lt || op == IR_ge)) || (x == r.hi && (op == IR_gt || op == IR_le)))
        return false;
    return (double)(int64_t)x == x;
}

static const char *const compare_text[] = {
    [IR_eq - IR_eq] = " == ", [IR_ne - IR_eq] = " != ", [IR_lt - IR_eq] = " < ",
    [IR_le - IR_eq] = " <= ", [IR_gt - IR_eq] = " > ", [IR_ge - IR_eq] = " >= ",
};

static void put_integer_operand(CFn *fn, IrRef r, SmType t)
{
    if (fn->ins[r].is_const)
        put_constant(fn, r, t, sm_cell_from_f64(t, sm_from_bits(fn->ins[r].bits)));
    else
        put_value(fn, converted_from(fn, r), PREC_ADD);
}

static SmType integer_compared(const CFn *fn, const IrIns *i)
{
    const IrRef a = converted_from(fn, i->a), b = converted_from(fn, i->b);

    if (a != IR_NONE && c_is_integer(ins(fn, a)->type) && is_plain_limit(fn, i->op, i->b, ins(fn, a)->type))
        return ins(fn, a)->type;
    if (b != IR_NONE && c_is_integer(ins(fn, b)->type) && is_plain_limit(fn, mirrored(i->op), i->a, ins(fn, b)->type))
        return ins(fn, b)->type;
    return SM_TYPE_COUNT;
}

// The bool that r is, or converts to F64 in place; or IR_NONE.
static IrRef truth_of(const CFn *fn, IrRef r)
{
    const IrRef from = ins(fn, r)->type == SM_BOOL ? r : converted_from(fn, r);

    return from != IR_NONE && !fn->ins[from].is_const && ins(fn, from)->type == SM_BOOL ? from : IR_NONE;
}

// `flag == true` and its kin: the bool alone.  Gives the bool and whether it is negated.
static IrRef bool_compared(const CFn *fn, const IrIns *i, bool *negated)
{
    for (int side = 0; side < 2; side++) {
        const IrRef b = side ? i->b : i->a, c = side ? i->a : i->b, flag = truth_of(fn, b);
        if ((i->op == IR_eq || i->op == IR_ne) && flag != IR_NONE && fn->ins[c].is_const &&
            (number(fn, c) == 1.0 || number(fn, c) == 0.0)) {
            *negated = (number(fn, c) == 1.0) != (i->op == IR_eq);
            return flag;
        }
    }
    return IR_NONE;
}

bool is_same_text(const CFn *fn, IrRef a, IrRef b)
{
    const IrIns *x = ins(fn, a), *y = ins(fn, b);

    if (a == b)
        return true;
    if (fn->ins[a].is_const || fn->ins[b].is_const)
        return fn->ins[a].is_const && fn->ins[b].is_const && fn->ins[a].bits == fn->ins[b].bits;
    if (x->op != y->op || x->type != y->type)
        return false;
    if (x->op == IR_load || x->op == IR_stat)
        return x->var == y->var && (x->op == IR_load || x->stat == y->stat);
    return is_same_text(fn, x->a, y->a) && (x->b == IR_NONE || is_same_text(fn, x->b, y->b));
}

// Both sides are truths.
static bool are_bools(const CFn *fn, const IrIns *i)
{
    const IrRef a = truth_of(fn, i->a), b = truth_of(fn, i->b);

    return (i->op == IR_eq || i->op == IR_ne) && a != IR_NONE && b != IR_NONE && !is_same_text(fn, a, b);
}

// ---- comparisons of narrow types ----

static SmType source_type(const CFn *fn, IrRef r) { return ins(fn, is_widening(fn, r) ? ins(fn, r)->a : r)->type; }

// Not where both come out as the same text or where a type's limits decide: compilers warn about what holds always or never.
static bool compares_as_integers(const CFn *fn, const IrIns *i)
{
    if (!c_is_integer(ins(fn, i->a)->type) || is_same_text(fn, i->a, i->b))
        return false;
    if (fn->ins[i->a].is_const)
        return is_plain_limit(fn, mirrored(i->op), i->a, source_type(fn, i->b));
    return !fn->ins[i->b].is_const || is_plain_limit(fn, i->op, i->b, source_type(fn, i->a));
}

// One side of a comparison of integers.  C converts a shorter one itself where the other is not one too.
static void put_integer_side(CFn *fn, IrRef r, bool bare)
{
    put_value(fn, bare && is_widening(fn, r) ? ins(fn, r)->a : r, PREC_ADD);
}

// How both sides of a comparison are written.
typedef struct Sides {
    bool bools;               // as truths
    bool same;                // as they are: integers, or floats
    bool bare;                // that one of them is shorter is left to C
    SmType integer;           // as this type, one of them being a constant; SM_TYPE_COUNT: not so
    bool tree, wide;          // as sums and products of integers
} Sides;

static Sides sides_of(const CFn *fn, const IrIns *i)
{
    const SmType type = ins(fn, i->a)->type;
    Sides s = { are_bools(fn, i), type == SM_F32, false, SM_TYPE_COUNT, false, false };

    if (type != SM_F64) {
        s.same |= compares_as_integers(fn, i);
        s.bare = !is_widening(fn, i->a) || !is_widening(fn, i->b);
        return s;
    }
    s.integer = integer_compared(fn, i);
    s.tree = !s.bools && s.integer == SM_TYPE_COUNT && integer_compares(fn, i, &s.wide);
    return s;
}

static void put_side(CFn *fn, IrRef r, const Sides *s)
{
    if (s->bools)
        put_value(fn, truth_of(fn, r), PREC_PRIMARY);
    else if (s->same)
        put_integer_side(fn, r, s->bare);
    else if (s->tree)
        integer_put(fn, r, s->wide, PREC_ADD);
    else if (s->integer != SM_TYPE_COUNT)
        put_integer_operand(fn, r, s->integer);
    else
        put_double(fn, r, PREC_ADD);
}

void put_compare(CFn *fn, const IrIns *i, bool negated, int prec)
{
    const Sides sides = sides_of(fn, i);
    const bool equality = i->op == IR_eq || i->op == IR_ne;
    const int own = equality ? PREC_EQ : PREC_REL;
    const IrOp op = !negated ? i->op : i->op == IR_eq ? IR_ne : i->op == IR_ne ? IR_eq : i->op;
    const bool inverted = negated && !equality;
    bool opened, flag_negated;
    const IrRef flag = bool_compared(fn, i, &flag_negated);

    if (flag != IR_NONE) {
        put_condition(fn, flag, flag_negated != negated, prec);
        return;
    }
    if (inverted)
        put(fn, "!");
    opened = open_parens(fn, own, inverted ? PREC_PRIMARY : prec);
    put_side(fn, i->a, &sides);
    put(fn, compare_text[op - IR_eq]);
    put_side(fn, i->b, &sides);
    close_parens(fn, opened);
}
