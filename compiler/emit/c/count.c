// SPDX-License-Identifier: Apache-2.0
// Counters and sums of 64 bits.  What is stored is a number, exact up to 2^53 and rounded beyond, where counting by one ends: no
// operation of the IR says that on integers, but a function of stdlib does, which looks at run time.
#include "compiler/emit/c/fn.h"
#include "stdlib/convert.h"

static const IrIns *ins(const CFn *fn, IrRef r) { return &fn->f->ins.at[r]; }
static void put(CFn *fn, const char *text) { buf_str(&fn->line, text); }

// What is counted, and by what: a constant or the conversion of an integer.
typedef struct Count {
    IrRef v, by;
    bool down;
} Count;

// The integer that r converts to F64 in place, or IR_NONE.
static IrRef integer_of(const CFn *fn, IrRef r)
{
    const IrIns *i = ins(fn, r);

    return !fn->ins[r].is_const && fn->ins[r].how == C_INLINE && i->op == IR_cvt && c_is_integer(ins(fn, i->a)->type) ? i->a : IR_NONE;
}

static bool is_step(const CFn *fn, IrRef r)
{
    const Fact x = fn->ins[r].fact;

    return x.whole && fact_within(x, -FACT_EXACT / 2, FACT_EXACT / 2) && (fn->ins[r].is_const ? x.lo != 0 : integer_of(fn, r) != IR_NONE);
}

static bool is_counted(const CFn *fn, IrRef r, SmType to)
{
    return integer_of(fn, r) != IR_NONE && ins(fn, integer_of(fn, r))->type == to;
}

// Whether r is an F64 `v + n` or `v - n`, written in place.
static bool find_count(const CFn *fn, IrRef r, SmType to, Count *c)
{
    const IrIns *i = ins(fn, r);
    const bool swap = i->op == IR_add && !is_counted(fn, i->a, to);

    if ((i->op != IR_add && i->op != IR_sub) || i->type != SM_F64 || fn->ins[r].how != C_INLINE)
        return false;
    c->v = swap ? i->b : i->a;
    c->by = swap ? i->a : i->b;
    c->down = i->op == IR_sub;
    return is_counted(fn, c->v, to) && is_step(fn, c->by);
}

static bool is_up_by_one(const CFn *fn, const Count *c, SmType to)
{
    double by;

    return to == SM_U64 && !c->down && fact_is_number(fn->ins[c->by].fact, &by) && by == 1 && fact_within(fn->ins[c->v].fact, 0, FACT_EXACT);
}

static void put_step(CFn *fn, const Count *c)
{
    const IrRef n = integer_of(fn, c->by);
    const double x = fn->ins[c->by].fact.lo;

    put(fn, ", ");
    if (fn->ins[c->by].is_const) {
        put_constant(fn, c->by, SM_I64, sm_cell_from_f64(SM_I64, c->down ? -x : x));
    } else if (c->down || ins(fn, n)->type == SM_U64) {
        put(fn, c->down ? "-(int64_t)" : "(int64_t)");
        put_value(fn, n, PREC_PRIMARY);
    } else {
        put_assigned(fn, n);
    }
}

bool soft_put_count(CFn *fn, const IrIns *store)
{
    const IrIns *i = ins(fn, store->a);
    IrRef v;
    Count c;

    if (!fn->u->soft || i->op != IR_cvt || i->type != SM_U64 || fn->ins[store->a].is_const || fn->ins[store->a].how != C_INLINE ||
        ins(fn, i->a)->type != SM_F64 || !find_count(fn, i->a, SM_U64, &c) || !is_up_by_one(fn, &c, SM_U64))
        return false;
    v = integer_of(fn, c.v);
    if (ins(fn, v)->op != IR_load || ins(fn, v)->var != store->var || fn->ins[v].how != C_INLINE)
        return false;
    put(fn, "sm_soft_count(&");
    put_cell(fn, store->var);
    put(fn, ")");
    return true;
}

bool put_count(CFn *fn, IrRef r, SmType to)
{
    const char *helper = to == SM_U64 ? "sm_count_u64" : "sm_count_i64";
    Count c;

    if ((to != SM_U64 && to != SM_I64) || !find_count(fn, r, to, &c))
        return false;
    if (is_up_by_one(fn, &c, to))
        helper = "sm_count_up";
    buf_printf(&fn->line, "%s(", helper_use(fn->u, helper));
    put_value(fn, integer_of(fn, c.v), PREC_ANY);
    if (!is_up_by_one(fn, &c, to))
        put_step(fn, &c);
    put(fn, ")");
    return true;
}
