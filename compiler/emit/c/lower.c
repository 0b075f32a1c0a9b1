// SPDX-License-Identifier: Apache-2.0
// Decides which temporaries of a function become subexpressions of the expressions that use them, and which become variables.  A temporary
// becomes a subexpression if it is used once and no store between its position and its use changes what it reads.  Expressions too deep for
// compilers are split.  Also finds float loads that need no NaN check, and elements that are read once for the whole function.
#include "compiler/emit/c/fn.h"
#include "compiler/ir/comparison.h"

enum { LEVEL_MAX = 40 };      // deeper expressions are split; clang's limit is 256 nested parentheses

// ---- facts ----

// Returns the possible values of r in block b: any value of its type if the facts say that the block is unreachable.
static Fact fact_in_block(const FactFlow *flow, size_t b, IrRef r, SmType type)
{
    Fact any = fact_of_type(type);

    any.nan = ir_is_float(type);
    return flow->reached[b] ? flow->of[r] : any;
}

// Computes CIns.fact of every instruction from the facts `begin` at the start of the function.
void lower_find_facts(CFn *fn, const Env *begin)
{
    const IrFn *f = fn->f;
    const FactFlow flow = facts_of_function(fn->u->facts, f, begin);

    for (size_t b = 0; b < f->blk.n; b++)
        for (size_t p = 0; p < f->blk.at[b].ins.n; p++) {
            const IrRef r = f->blk.at[b].ins.at[p];
            fn->ins[r].fact = fact_in_block(&flow, b, r, f->ins.at[r].type);
        }
}

// ---- counting uses ----

// Counts a use of r. Constants are not counted: they are written at each use.
static void count_use(CFn *fn, IrRef r)
{
    if (r != IR_NONE && !c_is_const(fn, r))
        fn->ins[r].uses++;
}

// Returns how the current function uses variable v, after resetting an entry of another function.
static CVarUse *get_var_use(CFn *fn, uint32_t v)
{
    CVarUse *w = &fn->var[v];

    if (w->stamp != fn->stamp) {
        w->loads = 0;
        w->stored = w->as_double = w->never_nan = false;
        w->copy = NULL;
        w->stamp = fn->stamp;
    }
    return w;
}

// Counts the uses of temporaries and variables in block b, backwards, so that the uses of a result are known before the uses of its operands.
static void count_uses(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    if (c_is_branch(fn, b))
        count_use(fn, blk->jump.cond);
    for (size_t p = blk->ins.n; p-- > 0;) {
        const IrIns *i = &fn->f->ins.at[blk->ins.at[p]];
        const CIns *c = &fn->ins[blk->ins.at[p]];
        if (i->op == IR_store)
            get_var_use(fn, i->var)->stored = true;
        if (i->op == IR_load)
            get_var_use(fn, i->var)->loads += c->uses;
        if ((c->uses == 0 && !ir_op_info[i->op].effect) || i->op == IR_const)
            continue;
        count_use(fn, i->a);
        count_use(fn, i->b);
        if (i->op == IR_cvt && i->type == SM_F64)
            i = c_ins(fn, i->a);
        if (i->op == IR_load)
            get_var_use(fn, i->var)->as_double = true;
    }
}

// Counts the uses in block b that have the same result for 0 and -0.  count_uses must have run.
static void count_sign_free_uses(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    for (size_t p = 0; p < blk->ins.n; p++) {
        const IrIns *i = &fn->f->ins.at[blk->ins.at[p]];
        if (fn->ins[blk->ins.at[p]].uses == 0 || !(ir_is_comparison(i->op) || (i->op == IR_cvt && ir_is_integer(i->type))))
            continue;
        fn->ins[i->a].sign_free_uses += !c_is_const(fn, i->a);
        if (i->b != IR_NONE)
            fn->ins[i->b].sign_free_uses += !c_is_const(fn, i->b);
    }
}

// ---- loads that need no NaN check ----
// 1. A value that the function itself has stored is never NaN.
// 2. The language reads a NaN as 0.  If a condition has the same result for NaN and 0, no check is needed: `x > 775` is false for both.
// 3. `500 < x and x < 825` needs no check either, although 0 < 825: where x is NaN or 0, `500 < x` is false and decides the result.

// If r is the load of a float element, or the conversion of such a load from F32 to F64, returns the load; otherwise IR_NONE.
static IrRef find_float_load(const CFn *fn, IrRef r)
{
    const IrIns *i;

    if (r == IR_NONE || c_is_const(fn, r))
        return IR_NONE;
    i = c_ins(fn, r);
    if (i->op == IR_cvt && i->type == SM_F64 && c_ins(fn, i->a)->type == SM_F32)
        i = c_ins(fn, r = i->a);
    return i->op == IR_load && fn->u->m->var.at[i->var].space == IR_ELEMENT && sm_type_info[i->type].kind == SM_KIND_FLOAT ? r : IR_NONE;
}

// Whether `0 op y` equals `NaN op y` for all values of y.
static bool is_same_for_nan(IrOp op, Fact y)
{
    switch (op) {
    case IR_lt: return y.hi <= 0;
    case IR_le: return y.hi < 0;
    case IR_gt: return y.lo >= 0;
    case IR_ge: return y.lo > 0;
    case IR_eq: case IR_ne: return y.lo > 0 || y.hi < 0;
    default: return false;
    }
}

// If exactly one operand of comparison i is the value of a float element, returns that operand; otherwise IR_NONE.
static IrRef find_element_operand(const CFn *fn, const IrIns *i)
{
    const IrRef a = find_float_load(fn, i->a), b = find_float_load(fn, i->b);

    return (a == IR_NONE) == (b == IR_NONE) ? IR_NONE : a != IR_NONE ? i->a : i->b;
}

// Finds whether comparison r has the same result if an element that it reads is NaN or 0.  If so, fills decided_by and decided_value.
static void analyze_comparison(CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    const IrRef x = find_element_operand(fn, i);
    CIns *c = &fn->ins[r];

    if (x != IR_NONE && soft_compares_bytes(fn, i, x)) {
        fn->ins[x].nan_is_zero_uses += c->uses > 0;
        return;
    }
    if (x == IR_NONE || !is_same_for_nan(x == i->a ? i->op : ir_swapped_comparison(i->op), fn->ins[x == i->a ? i->b : i->a].fact))
        return;
    c->decided_by = find_float_load(fn, x);
    c->decided_value = i->op == IR_ne;
    fn->ins[x].nan_is_zero_uses += c->uses > 0;
}

// Sets is_masked of the comparisons in condition r that read `load` and have no other use.  r is an operand of a logical operation whose other
// operand decides the result if `load` reads NaN or 0.
static void mask_comparisons(CFn *fn, IrRef r, IrRef load)
{
    const IrIns *i = c_ins(fn, r);
    CIns *c = &fn->ins[r];
    const IrRef x = ir_is_comparison(i->op) ? find_element_operand(fn, i) : IR_NONE;

    if (i->op == IR_const || c->uses != 1 || c->is_masked)
        return;
    if (x != IR_NONE && find_float_load(fn, x) == load && c->decided_by == IR_NONE) {
        c->is_masked = true;
        fn->ins[x].nan_is_zero_uses++;
    } else if (i->op == IR_and || i->op == IR_or || i->op == IR_not) {
        mask_comparisons(fn, i->a, load);
        if (i->b != IR_NONE)
            mask_comparisons(fn, i->b, load);
    }
}

// Sets decided_by and decided_value of `and` or `or`: if a load that reads NaN or 0 makes one operand true (of `or`) or false (of `and`),
// the load alone decides the result.
static void record_deciding_operand(CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    CIns *c = &fn->ins[r];

    for (int side = 0; side < 2; side++) {
        const IrRef x = side ? i->b : i->a, y = side ? i->a : i->b;
        const CIns *by = &fn->ins[x];
        if (c_is_const(fn, x) || by->decided_by == IR_NONE || by->decided_value != (i->op == IR_or))
            continue;
        mask_comparisons(fn, y, by->decided_by);
        c->decided_by = by->decided_by;
        c->decided_value = by->decided_value;
    }
}

// Sets decided_by and decided_value of r if a load that reads NaN or 0 decides r's result, and counts in nan_is_zero_uses the uses of loads
// to which NaN and 0 make no difference.
static void analyze_condition(CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    CIns *c = &fn->ins[r];

    c->decided_by = IR_NONE;
    if (i->op == IR_const)
        return;
    if (i->op == IR_sample) {
        fn->ins[i->a].nan_is_zero_uses += c_window_reads_nan_as_zero(fn, i);
    } else if (ir_is_comparison(i->op)) {
        analyze_comparison(fn, r);
    } else if (i->op == IR_and || i->op == IR_or) {
        record_deciding_operand(fn, r);
    } else if (i->op == IR_not && !c_is_const(fn, i->a)) {
        c->decided_by = fn->ins[i->a].decided_by;
        c->decided_value = !fn->ins[i->a].decided_value;
    }
}

// Updates the never_nan of a variable at its store; marks a load as unchecked if a store of its variable dominates it.  Blocks are visited in
// order, so the dominators of b have been visited.
static void track_never_nan(CFn *fn, uint32_t b, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    CVarUse *w;

    if (i->op != IR_store && i->op != IR_load)
        return;
    w = &fn->var[i->var];
    if (w->stamp != fn->stamp)
        return;
    if (i->op == IR_load) {
        fn->ins[r].unchecked = find_float_load(fn, r) == r && w->never_nan && flow_dominates(&fn->flow, w->never_nan_from, b);
    } else if (!w->never_nan || !flow_dominates(&fn->flow, w->never_nan_from, b)) {
        w->never_nan = true;
        w->never_nan_from = b;
    }
}

// Finds the loads of block b that need no check, and subtracts their uses from CVarUse.loads.  count_uses must have run.
static void find_unchecked_loads(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    for (size_t p = 0; p < blk->ins.n; p++) {
        track_never_nan(fn, b, blk->ins.at[p]);
        analyze_condition(fn, blk->ins.at[p]);
    }
    for (size_t p = blk->ins.n; p-- > 0;) {           // backwards, so that a conversion is visited before its operand
        const IrRef r = blk->ins.at[p], load = find_float_load(fn, r);
        CIns *c = &fn->ins[r];
        if (load == IR_NONE || c->uses == 0 || c->nan_is_zero_uses != c->uses)
            continue;
        if (load == r)
            c->unchecked = true;
        else
            fn->ins[load].nan_is_zero_uses++;
    }
    for (size_t p = 0; p < blk->ins.n; p++) {
        const CIns *c = &fn->ins[blk->ins.at[p]];
        if (c->unchecked)
            get_var_use(fn, c_ins(fn, blk->ins.at[p])->var)->loads -= c->uses;
    }
}

// ---- elements that are read once for the whole function ----

// Whether reading variable v takes more than a load: a float element needs a NaN check, and T a subtraction.
static bool needs_computation(const CFn *fn, uint32_t v)
{
    const IrVar *var = &fn->u->m->var.at[v];

    return (var->space == IR_TIME && !fn->u->soft) || (var->space == IR_ELEMENT && ir_is_float(var->type));
}

// Chooses the variables loaded in block b that are copied into a C variable at the start of the function: variables that the function never stores
// and reads at least twice with a NaN check or subtraction.
static void choose_copies(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    for (size_t p = 0; p < blk->ins.n; p++) {
        const IrIns *i = &fn->f->ins.at[blk->ins.at[p]];
        CVarUse *w;
        if (i->op != IR_load || !needs_computation(fn, i->var))
            continue;
        w = get_var_use(fn, i->var);
        if (fn->ins[blk->ins.at[p]].unchecked || w->copy || w->stored || w->loads < 2)
            continue;
        w->copy = c_copy_name(fn, i->var);
        w->copy_type = i->type == SM_F32 && w->as_double ? SM_F64 : i->type;
        vec_push(fn->u->arena, &fn->copied, i->var);
    }
}

// ---- the form of each instruction ----

static uint32_t max_u32(uint32_t a, uint32_t b) { return a > b ? a : b; }

// Records that an expression at position `at` of the block uses r at nesting depth `level`.
static void record_use(CFn *fn, IrRef r, uint32_t at, uint32_t level)
{
    if (r == IR_NONE)
        return;
    fn->ins[r].latest = max_u32(fn->ins[r].latest, at);
    fn->ins[r].level = max_u32(fn->ins[r].level, level);
}

// Returns the position of the next instruction of the block that changes what i reads; UINT32_MAX: none.
static uint32_t find_next_change(CFn *fn, const IrIns *i)
{
    if (i->op == IR_load)
        return get_var_use(fn, i->var)->block_stamp == fn->block ? fn->var[i->var].next_store : UINT32_MAX;
    return i->op == IR_stat ? fn->window_sample[i->var] : UINT32_MAX;
}

// Whether a repeated conversion costs little, because C compilers compute it once: to a wider integer, or of an unsigned integer to a bool or a
// float of at least its size.
static bool is_cheap_conversion(SmType to, SmType from)
{
    if (ir_is_float(to) || to == SM_BOOL)
        return sm_type_info[from].kind == SM_KIND_UNSIGNED && sm_type_info[to].bytes >= sm_type_info[from].bytes;
    return ir_is_integer(from) && ir_integer_contains(to, from);
}

// Whether i can be written several times at no cost: a plain member, or a cheap conversion of one.
static bool is_free_to_repeat(CFn *fn, const IrIns *i, const CIns *c)
{
    const IrIns *from = i->op == IR_cvt ? &fn->f->ins.at[i->a] : i;

    if (i->op == IR_cvt)
        return from->op == IR_load && is_cheap_conversion(i->type, from->type) && !needs_computation(fn, from->var);
    return i->op == IR_load && (!needs_computation(fn, i->var) || c->unchecked || get_var_use(fn, i->var)->copy);
}

// Whether condition r costs little where its value does not matter: a bool, its negation, or a comparison of integers that are members or
// constants.  Comparisons of floats are slower without a jump.
static bool is_cheap_condition(CFn *fn, IrRef r)
{
    const IrIns *i = c_ins(fn, r);
    const IrRef operand[2] = { i->a, ir_is_comparison(i->op) ? i->b : IR_NONE };

    if (i->op == IR_load)
        return true;
    if (i->op != IR_not && !ir_is_comparison(i->op))
        return false;
    for (int k = 0; k < 2; k++)
        if (operand[k] != IR_NONE && (ir_is_float(c_ins(fn, operand[k])->type) ||
                                      (!c_is_const(fn, operand[k]) && !is_free_to_repeat(fn, c_ins(fn, operand[k]), &fn->ins[operand[k]]))))
            return false;
    return true;
}

// If `store` stores an `and` or `or` of cheap conditions, these become C variables, because C compilers then compute the result without a jump.
static void name_conditions(CFn *fn, const IrIns *store)
{
    const IrIns *i = c_is_const(fn, store->a) ? store : c_ins(fn, store->a);

    if ((i->op != IR_and && i->op != IR_or) || c_is_const(fn, i->a) || c_is_const(fn, i->b) || !is_cheap_condition(fn, i->a) ||
        !is_cheap_condition(fn, i->b))
        return;
    fn->ins[i->a].is_named = fn->ins[i->b].is_named = true;
}

// Returns the form of instruction i, whose uses are known.
static CForm choose_form(CFn *fn, const IrIns *i, const CIns *c)
{
    if (ir_op_info[i->op].effect)
        return C_STATEMENT;
    if (c->uses == 0 || i->op == IR_const)
        return C_OMITTED;
    if (find_next_change(fn, i) < c->latest || c->is_named)
        return C_VARIABLE;
    if (is_free_to_repeat(fn, i, c))
        return C_SUBEXPRESSION;
    return c->uses > 1 || c->level > LEVEL_MAX ? C_VARIABLE : C_SUBEXPRESSION;
}

// Records that instruction i at position `at` changes a variable or a rolling window.
static void record_change(CFn *fn, const IrIns *i, uint32_t at)
{
    if (i->op == IR_store) {
        fn->var[i->var].block_stamp = fn->block;
        fn->var[i->var].next_store = at;
    } else if (i->op == IR_sample) {
        fn->window_sample[i->var] = at;
    }
}

// Chooses the forms of block b, backwards, so that an instruction is visited after its uses.
static void choose_forms_of_block(CFn *fn, uint32_t b)
{
    const IrBlk *blk = &fn->f->blk.at[b];

    fn->block = ++*fn->block_stamps;
    if (c_is_branch(fn, b))
        record_use(fn, blk->jump.cond, (uint32_t)blk->ins.n, 1);
    for (size_t p = blk->ins.n; p-- > 0;) {
        const IrRef r = blk->ins.at[p];
        const IrIns *i = &fn->f->ins.at[r];
        CIns *c = &fn->ins[r];
        if (i->op == IR_store && !fn->u->soft)
            name_conditions(fn, i);
        c->form = choose_form(fn, i, c);
        if (c->form != C_OMITTED) {
            const bool own = c->form != C_SUBEXPRESSION;  // the instruction is a separate statement
            record_use(fn, i->a, own ? (uint32_t)p : c->latest, own ? 1 : c->level + 1);
            record_use(fn, i->b, own ? (uint32_t)p : c->latest, own ? 1 : c->level + 1);
        }
        record_change(fn, i, (uint32_t)p);
    }
}

// Chooses CIns.form of every instruction, the float loads that need no check, and the copies.
void lower_choose_forms(CFn *fn)
{
    const uint32_t end = fn->flow.n - 1;

    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            count_uses(fn, b);
    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            count_sign_free_uses(fn, b);
    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            find_unchecked_loads(fn, b);
    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            choose_copies(fn, b);
    for (uint32_t b = 0; b < end; b++)
        if (fn->flow.reached[b])
            choose_forms_of_block(fn, b);
}
