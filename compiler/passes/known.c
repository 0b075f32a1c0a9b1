// SPDX-License-Identifier: Apache-2.0
// known: simplifies with facts: the possible values of variables and temporaries (facts/facts.h).  An operation that has only one
// possible result becomes a constant: a comparison with a known result, a guard that an earlier guard implies, a local with one possible
// value.  An operation that never changes its operand is bypassed: replacing NaN where none occurs, rounding of whole numbers, limits
// that are never reached.
// Needs values; invalidates use counts.
#include "compiler/facts/facts.h"
#include "compiler/passes/pass.h"
#include "stdlib/convert.h"

typedef struct KnownPass {
    IrFn *f;
    const Fact *fact;     // by temporary: its possible values
    IrRef *same;          // by temporary: an earlier temporary with the same value, or itself
} KnownPass;

static bool is_never_negative(Fact a) { return a.lo >= 0 && !a.minus_zero; }

// Returns the operand that a min or max always returns, or IR_NONE.  Neither operand may be NaN, and the bounds must not be equal, because
// they could be -0 and +0.
static IrRef decided_min_max_operand(const IrIns *i, Fact a, Fact b)
{
    const Fact low = i->op == IR_min ? a : b, high = i->op == IR_min ? b : a;

    if (a.nan || b.nan)
        return IR_NONE;
    if (low.hi < high.lo)
        return i->a;
    return high.hi < low.lo ? i->b : IR_NONE;
}

// Returns the operand that always equals the result of i, or IR_NONE.
static IrRef unchanged_operand(const KnownPass *k, const IrIns *i)
{
    const Fact a = k->fact[i->a];

    if (i->op == IR_cvt)
        return i->type == SM_F64 && k->f->ins.at[i->a].type == SM_F64 && !a.nan ? i->a : IR_NONE;
    if (ir_is_rounding(i->op))
        return a.whole ? i->a : IR_NONE;                         // rounding does not change NaN and -0, either
    if (i->op == IR_abs)
        return is_never_negative(a) ? i->a : IR_NONE;            // the sign of a NaN is not observable
    if (i->op == IR_min || i->op == IR_max)
        return decided_min_max_operand(i, a, k->fact[i->b]);
    return IR_NONE;
}

// Turns the instruction into a constant if its value is known, or else records the operand that it always equals.
static void replace_known_ins(KnownPass *k, IrRef ref)
{
    IrIns *i = &k->f->ins.at[ref];
    const uint8_t operands = ir_op_info[i->op].operands;
    IrRef same;
    double x;

    k->same[ref] = ref;
    if (operands > 0)
        i->a = k->same[i->a];
    if (operands > 1)
        i->b = k->same[i->b];
    if (ir_op_info[i->op].effect || i->op == IR_const)
        return;
    if (fact_is_number(k->fact[ref], &x)
        && (sm_type_info[i->type].bytes < 8 || i->type == SM_F64 || fact_within(k->fact[ref], -FACT_EXACT, FACT_EXACT))) {
        i->op = IR_const;
        i->a = i->b = IR_NONE;
        i->bits = i->type == SM_F64 ? sm_bits(x) : sm_cell_from_f64(i->type, x);
    } else if (operands > 0 && (same = unchanged_operand(k, i)) != IR_NONE)
        k->same[ref] = same;
}

// Runs the pass on one function: `flow` has the facts about its temporaries.
static void replace_known_values(Arena *arena, Arena *work, IrFn *f, FactFlow flow)
{
    KnownPass k = {f, flow.of, ARENA_ARRAY(work, IrRef, f->ins.n)};

    (void)arena;
    for (size_t b = 0; b < f->blk.n; b++) {
        IrBlk *blk = &f->blk.at[b];
        for (size_t i = 0; flow.reached[b] && i < blk->ins.n; i++)
            replace_known_ins(&k, blk->ins.at[i]);
        if (flow.reached[b] && blk->jump.kind == IR_BR)
            blk->jump.cond = k.same[blk->jump.cond];
    }
}

// The pass `known`: replaces what can only be one number by facts on every path, and removes what changes nothing.
void pass_known(Arena *arena, IrMachine *m, FactMachine *values)
{
    pass_on_each_function(arena, m, values, replace_known_values);
}
