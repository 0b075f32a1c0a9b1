// SPDX-License-Identifier: Apache-2.0
// Arithmetic on whole numbers that F64 holds exactly gives the same in C's integers, and costs less there.  A tree of sums,
// differences and products of integer variables and whole constants is written so when every value in it stays within
// 2^53, and when what becomes of it (a store, a comparison) does not see the difference: the sign of zero is lost.
#include "compiler/emit/c/fn.h"
#include "stdlib/convert.h"

static const IrIns *ins(const CFn *fn, IrRef r) { return &fn->f->ins.at[r]; }

static bool is_within(CRange r, double limit) { return !r.nan && r.lo >= -limit && r.hi <= limit; }

// ---- what is whole ----

static bool is_whole_constant(const CIns *c)
{
    return is_within(c->range, 9007199254740992.0) && (double)(int64_t)c->range.lo == c->range.lo;
}

static bool is_small_integer(SmType t) { return t == SM_BOOL || (c_is_integer(t) && sm_type_info[t].bytes <= 4); }

bool integer_is_whole(const CFn *fn, const IrIns *i, const CIns *c)
{
    if (i->type != SM_F64)
        return false;
    if (c->is_const)
        return is_whole_constant(c);
    if (i->op == IR_cvt)
        return is_small_integer(ins(fn, i->a)->type);
    return (i->op == IR_add || i->op == IR_sub || i->op == IR_mul) && fn->ins[i->a].whole && fn->ins[i->b].whole &&
           is_within(c->range, 9007199254740992.0);
}

// ---- whether a tree can be written ----

typedef struct Tree {
    bool wide;                // some value in it needs 64 bits
    unsigned operations;
} Tree;

static bool can_write(const CFn *fn, IrRef r, Tree *t)
{
    const IrIns *i = ins(fn, r);
    const CIns *c = &fn->ins[r];

    if (!c->whole || (!c->is_const && c->how != C_INLINE))
        return false;
    t->wide |= !(c->range.lo >= INT32_MIN && c->range.hi <= INT32_MAX);
    if (c->is_const || i->op == IR_cvt)
        return true;
    t->operations++;
    return can_write(fn, i->a, t) && can_write(fn, i->b, t);
}

// ---- writing ----

static void put(CFn *fn, const char *text) { buf_str(&fn->line, text); }

static void put_leaf(CFn *fn, IrRef r, bool wide, int prec)
{
    const IrRef v = ins(fn, r)->a;
    const SmType type = ins(fn, v)->type;
    const bool as_is = type == SM_I32 && !wide;
    const bool parens = type == SM_BOOL ? prec > PREC_ANY : !as_is && prec > PREC_UNARY;

    put(fn, parens ? "(" : "");
    if (type == SM_BOOL) {
        put_condition(fn, v, false, PREC_OR);
        put(fn, wide ? " ? INT64_C(1) : 0" : " ? INT32_C(1) : 0");      // an int could be too narrow for the sum
    } else {
        put(fn, as_is ? "" : wide ? "(int64_t)" : "(int32_t)");
        put_value(fn, v, as_is ? prec : PREC_PRIMARY);
    }
    put(fn, parens ? ")" : "");
}

static void put_tree(CFn *fn, IrRef r, bool wide, int prec)
{
    const IrIns *i = ins(fn, r);
    const int own = i->op == IR_mul ? PREC_MUL : PREC_ADD;

    if (fn->ins[r].is_const) {
        put_constant(fn, r, SM_I64, sm_cell_from_f64(SM_I64, sm_from_bits(fn->ins[r].bits)));
    } else if (i->op == IR_cvt) {
        put_leaf(fn, r, wide, prec);
    } else {
        put(fn, own < prec ? "(" : "");
        put_tree(fn, i->a, wide, own);
        put(fn, i->op == IR_add ? " + " : i->op == IR_sub ? " - " : " * ");
        put_tree(fn, i->b, wide, own + 1);
        put(fn, own < prec ? ")" : "");
    }
}

// ---- stores ----

static const char *limit_text(SmType t, bool upper)
{
    switch (t) {
    case SM_I8: return upper ? "INT8_MAX" : "INT8_MIN";
    case SM_I16: return upper ? "INT16_MAX" : "INT16_MIN";
    case SM_I32: return upper ? "INT32_MAX" : "INT32_MIN";
    case SM_I64: return upper ? "INT64_MAX" : "INT64_MIN";
    case SM_U8: return upper ? "UINT8_MAX" : "0";
    case SM_U16: return upper ? "UINT16_MAX" : "0";
    case SM_U32: return upper ? "UINT32_MAX" : "0";
    case SM_U64: return upper ? "INT64_MAX" : "0";      // of what the tree can be
    case SM_F32: case SM_F64: case SM_BOOL: case SM_TYPE_COUNT: break;
    }
    return "";
}

static void put_clipped(CFn *fn, IrRef r, SmType to, bool wide)
{
    put(fn, helper_use(fn->u, "sm_clip_i64"));
    put(fn, "(");
    put_tree(fn, r, wide, PREC_ANY);
    buf_printf(&fn->line, ", %s, %s)", limit_text(to, false), limit_text(to, true));
}

// counter + 1 in 64 bits: exact only while the counter is below 2^53, which the helper knows.
static bool put_count(CFn *fn, IrRef r, SmType to)
{
    const IrIns *i = ins(fn, r);
    const bool swap = i->op == IR_add && fn->ins[i->a].is_const;
    const IrRef v = swap ? i->b : i->a, n = swap ? i->a : i->b;
    const double x = fn->ins[r].how == C_INLINE && (i->op == IR_add || i->op == IR_sub) ? fn->ins[n].range.lo : 0;

    if (sm_type_info[to].bytes != 8 || !c_is_integer(to) || x == 0 || !fn->ins[n].is_const || !is_whole_constant(&fn->ins[n]) ||
        x < -2147483647.0 || x > 2147483647.0 || fn->ins[v].is_const || fn->ins[v].how != C_INLINE || ins(fn, v)->op != IR_cvt ||
        ins(fn, ins(fn, v)->a)->type != to)
        return false;
    put(fn, helper_use(fn->u, to == SM_U64 ? "sm_count_u64" : "sm_count_i64"));
    put(fn, "(");
    put_value(fn, ins(fn, v)->a, PREC_ANY);
    buf_printf(&fn->line, ", %ld)", (long)(i->op == IR_sub ? -x : x));
    return true;
}

bool integer_put_cvt(CFn *fn, IrRef r, SmType to, int prec)
{
    Tree t = { false, 0 };
    const bool fits = range_fits(fn->ins[r].range, to);
    bool parens, cast;

    if (!c_is_integer(to) || fn->ins[r].is_const)
        return false;
    if (!can_write(fn, r, &t))
        return put_count(fn, r, to);
    cast = fits && t.operations == 0 ? ins(fn, ins(fn, r)->a)->type != to : to != (!fits || t.wide ? SM_I64 : SM_I32);
    parens = (cast ? PREC_UNARY : PREC_PRIMARY) < prec;
    put(fn, parens ? "(" : "");
    if (cast)
        buf_printf(&fn->line, "(%s)", c_type_of(to));
    if (!fits)
        put_clipped(fn, r, to, t.wide);
    else if (t.operations == 0)
        put_value(fn, ins(fn, r)->a, cast ? PREC_PRIMARY : prec);
    else
        put_tree(fn, r, t.wide, cast ? PREC_PRIMARY : prec);
    put(fn, parens ? ")" : "");
    return true;
}

// ---- comparisons ----

bool integer_compares(const CFn *fn, const IrIns *i, bool *wide)
{
    const CRange a = fn->ins[i->a].range, b = fn->ins[i->b].range;
    Tree t = { false, 0 };

    if (!can_write(fn, i->a, &t) || !can_write(fn, i->b, &t))
        return false;
    *wide = t.wide;
    // Where ranges decide, compilers may warn that the comparison is always so.
    return !(fn->ins[i->a].is_const && fn->ins[i->b].is_const) && a.lo < b.hi && b.lo < a.hi && !is_same_text(fn, i->a, i->b);
}

void integer_put(CFn *fn, IrRef r, bool wide, int prec) { put_tree(fn, r, wide, prec); }
