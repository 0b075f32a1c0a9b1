// SPDX-License-Identifier: Apache-2.0
#include "compiler/cover/drift.h"

#include "compiler/ir/eval.h"

static const Drift unknown = {.any = true};

static void join_bounds(double a[2], const double b[2])
{
    a[0] = b[0] < a[0] ? b[0] : a[0];
    a[1] = b[1] > a[1] ? b[1] : a[1];
}

Drift drift_join(Drift a, Drift b)
{
    if (a.any || b.any)
        return unknown;
    if (a.is_relative && b.is_relative)
        join_bounds(a.by, b.by);
    if (a.is_number && b.is_number)
        join_bounds(a.number, b.number);
    if (b.is_relative && !a.is_relative) {
        a.by[0] = b.by[0];
        a.by[1] = b.by[1];
    }
    if (b.is_number && !a.is_number) {
        a.number[0] = b.number[0];
        a.number[1] = b.number[1];
    }
    a.is_relative |= b.is_relative;
    a.is_number |= b.is_number;
    return a;
}

double drift_cap(SmType type)
{
    switch (type) {
    case SM_I8: return 127;
    case SM_U8: return 255;
    case SM_I16: return 32767;
    case SM_U16: return 65535;
    case SM_I32: return 2147483647.0;
    case SM_U32: return 4294967295.0;
    case SM_I64: case SM_U64: return 9007199254740992.0;      // 2^53: beyond it, adding 1 can change nothing
    default: return 0;
    }
}

static bool is_number(Drift d, double *x)
{
    *x = d.number[0];
    return !d.any && d.is_number && !d.is_relative && d.number[0] == d.number[1];
}

// Returns the drift of d plus x; unknown if x is not from 0 to a million.
static Drift add_number(Drift d, double x)
{
    if (d.any || !(x >= 0 && x <= 1e6))
        return unknown;
    for (int i = 0; i < 2; i++) {
        d.by[i] += x;
        d.number[i] += x;
    }
    return d;
}

// Returns the drift of a known number; unknown if it is not a whole number from 0 to a million.
static Drift number_of(double x)
{
    const Drift d = {.is_number = true, .number = {x, x}};

    return x >= 0 && x <= 1e6 && x == (double)(int64_t)x ? d : unknown;
}

static bool drift_is_within(Drift d, double cap) { return !d.any && (!d.is_number || d.number[1] <= cap); }

// Returns the drift of an instruction's result: a number, or `variable plus a number`.  `now`: the drift of the variable at this place.
static Drift drift_of(const IrFn *f, const IrIns *i, const DriftPaths *p, Drift now, uint32_t var)
{
    Drift a = i->a == IR_NONE || i->op == IR_load || i->op == IR_stat ? unknown : p->of[i->a], b = i->b == IR_NONE ? unknown : p->of[i->b];
    double x;

    switch (i->op) {
    case IR_const: return number_of(ir_number(i->type, i->bits));
    case IR_load: return i->var == var ? now : unknown;
    case IR_cvt: return (i->type == SM_F64 || i->type == f->ins.at[i->a].type || drift_cap(i->type) > 0) && drift_is_within(a, i->type == SM_F64 ? 1e15 : drift_cap(i->type)) ? a : unknown;
    case IR_add: return is_number(b, &x) ? add_number(a, x) : is_number(a, &x) ? add_number(b, x) : unknown;
    case IR_min: case IR_max: return drift_join(a, b);
    default: return unknown;
    }
}

// Joins d with the drifts of the other paths that reach the block `to`.
static void join_drift_at(DriftPaths *p, IrBlkRef to, Drift *begin, Drift d)
{
    begin[to] = p->reached[to] ? drift_join(begin[to], d) : d;
    p->reached[to] = true;
}

DriftPaths drift_of_function(Arena *arena, const IrFn *f, uint32_t var)
{
    DriftPaths p = {arena_array(arena, f->ins.n + 1, sizeof *p.of), arena_array(arena, f->blk.n, sizeof *p.at_end), arena_array(arena, f->blk.n, sizeof *p.reached)};
    Drift *begin = arena_array(arena, f->blk.n, sizeof *begin);

    p.reached[0] = true;
    begin[0].is_relative = true;
    for (uint32_t b = 0; b < f->blk.n; b++) {
        const IrBlk *blk = &f->blk.at[b];
        Drift now = begin[b];
        for (uint32_t n = 0; p.reached[b] && n < blk->ins.n; n++) {
            const IrIns *i = &f->ins.at[blk->ins.at[n]];
            p.of[blk->ins.at[n]] = drift_of(f, i, &p, now, var);
            if (i->op == IR_store && i->var == var)
                now = p.of[i->a];
        }
        p.at_end[b] = now;
        if (p.reached[b] && (blk->jump.kind == IR_JMP || blk->jump.kind == IR_BR))
            join_drift_at(&p, blk->jump.then, begin, now);
        if (p.reached[b] && blk->jump.kind == IR_BR)
            join_drift_at(&p, blk->jump.otherwise, begin, now);
    }
    return p;
}

Drift drift_at_returns(const IrFn *f, const DriftPaths *p)
{
    Drift all = {.any = false};

    for (uint32_t b = 0; b < f->blk.n; b++)
        if (p->reached[b] && f->blk.at[b].jump.kind == IR_RET)
            all = drift_join(all, p->at_end[b]);
    return all;
}
