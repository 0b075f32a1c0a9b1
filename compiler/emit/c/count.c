// SPDX-License-Identifier: Apache-2.0
// Counters of 64 bits.  What is stored is a number, exact up to 2^53 and rounded beyond, where counting by one ends: no
// operation of the IR says that on integers, but a function of stdlib does, which looks at run time.
#include "compiler/emit/c/fn.h"

static const IrIns *ins(const CFn *fn, IrRef r) { return &fn->f->ins.at[r]; }

// What is counted, of what type, and by how much.
typedef struct Count {
    IrRef v;
    int32_t by;
} Count;

static bool is_step(const CFn *fn, IrRef r, double *by)
{
    return ins(fn, r)->type == SM_F64 && fact_is_number(fn->ins[r].fact, by) && *by >= -2147483647.0 && *by <= 2147483647.0 &&
           *by != 0 && (double)(int32_t)*by == *by;
}

// Whether r is an F64 `to + n` or `to - n`, written in place.
static bool find_count(const CFn *fn, IrRef r, SmType to, Count *c)
{
    const IrIns *i = ins(fn, r);
    const bool sum = i->op == IR_add && i->type == SM_F64, difference = i->op == IR_sub && i->type == SM_F64;
    const bool swap = sum && fn->ins[i->a].is_const;
    const IrRef v = swap ? i->b : i->a, n = swap ? i->a : i->b;
    double by;

    if ((!sum && !difference) || fn->ins[r].how != C_INLINE || !fn->ins[n].is_const || !is_step(fn, n, &by))
        return false;
    if (fn->ins[v].is_const || fn->ins[v].how != C_INLINE || ins(fn, v)->op != IR_cvt || ins(fn, ins(fn, v)->a)->type != to)
        return false;
    c->v = ins(fn, v)->a;
    c->by = (int32_t)(difference ? -by : by);
    return true;
}

bool put_count(CFn *fn, IrRef r, SmType to)
{
    Count c;

    if ((to != SM_U64 && to != SM_I64) || !find_count(fn, r, to, &c))
        return false;
    if (c.by == 1 && to == SM_U64 && fact_within(fn->ins[c.v].fact, 0, FACT_EXACT)) {
        buf_printf(&fn->line, "%s(", helper_use(fn->u, "sm_count_up"));
        put_value(fn, c.v, PREC_ANY);
        buf_str(&fn->line, ")");
        return true;
    }
    buf_printf(&fn->line, "%s(", helper_use(fn->u, to == SM_U64 ? "sm_count_u64" : "sm_count_i64"));
    put_value(fn, c.v, PREC_ANY);
    buf_printf(&fn->line, ", %ld)", (long)c.by);
    return true;
}
