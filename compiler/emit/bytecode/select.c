// SPDX-License-Identifier: Apache-2.0
// IR to instructions.  The target's operands convert by themselves, so loads, stores and most conversions vanish into the
// operands of the operation between them: `counter = counter + 1` is one instruction.
//
// Within a block an operation whose result is used once waits for its user, which then asks for it; what is used more often
// is computed where it stands, into a slot.  A load is read by its users directly, unless a store to its variable comes
// before the last of them.  Conditions become jumps over jumps, never numbers.
#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/emit/bytecode/select.h"
#include "stdlib/convert.h"

enum { DEEPEST = 100 };       // how many operations may wait for each other: a bound of this file's recursion

// ---- how an operation is computed ----

// How many operations wait for each other in r; 0 where nothing does.
static uint32_t depth_of(const Select *s, IrRef r) { return s->value[r].waits && s->value[r].depth <= DEEPEST ? s->value[r].depth : 0; }

// The opcode of an operation; *swap when its operands change places.
static uint8_t opcode(IrOp op, bool *swap)
{
    *swap = op == IR_gt || op == IR_ge;
    switch (op) {
    case IR_add: return SMVM_add;
    case IR_sub: return SMVM_sub;
    case IR_mul: return SMVM_mul;
    case IR_div: return SMVM_div;
    case IR_neg: return SMVM_neg;
    case IR_abs: return SMVM_abs;
    case IR_floor: return SMVM_floor;
    case IR_ceil: return SMVM_ceil;
    case IR_trunc: return SMVM_trunc;
    case IR_round: return SMVM_round;
    case IR_sqrt: return SMVM_sqrt;
    case IR_sign: return SMVM_sign;
    case IR_min: return SMVM_min;
    case IR_max: return SMVM_max;
    case IR_eq: return SMVM_eq;
    case IR_ne: return SMVM_ne;
    case IR_lt: case IR_gt: return SMVM_lt;
    case IR_le: case IR_ge: return SMVM_le;
    case IR_and: return SMVM_and;
    case IR_or: return SMVM_or;
    case IR_not: return SMVM_not;
    case IR_const: case IR_load: case IR_store: case IR_cvt: case IR_stat: case IR_sample: case IR_OP_COUNT: break;
    }
    return 0;
}

static const IrIns *ins(const Select *s, IrRef r) { return &s->f->ins.at[r]; }

// The F64 that a constant stands for.  (A NaN is one only as an F64, and then stays one.)
static SmF64 const_value(const IrIns *i)
{
    return i->type == SM_F64 ? sm_from_bits(i->bits) : sm_cell_to_f64(i->type, i->bits);
}

// Whether r's number can be one that its type has not: a NaN, or of an F32 operation a number that is not yet rounded, for it is
// computed as F64.  What was read, converted or counted is of its type.
static bool is_raw(const Select *s, IrRef r)
{
    const IrIns *i = ins(s, r);

    if (i->op == IR_const)
        return i->type == SM_F64 && sm_is_nan(sm_from_bits(i->bits));
    return sm_type_info[i->type].kind == SM_KIND_FLOAT && i->op != IR_load && i->op != IR_cvt;
}

// Whether every number of type `a` is one of type `b`.  (Of I64 and U64 those that the F64 they are read as stands for.)
static bool is_within(SmType a, SmType b)
{
    const SmTypeInfo *x = &sm_type_info[a], *y = &sm_type_info[b];

    if (a == b || a == SM_BOOL || b == SM_F64)
        return b != SM_BOOL || a == b;
    if (b == SM_F32)
        return x->bytes < 4;
    if (x->kind == SM_KIND_FLOAT || y->kind == SM_KIND_BOOL)
        return false;
    return x->kind == y->kind ? x->bytes <= y->bytes : x->kind == SM_KIND_UNSIGNED && x->bytes < y->bytes;
}

// Whether a conversion leaves the number as it is once its operand has been read.
static bool changes_nothing(const Select *s, const IrIns *cvt) { return !is_raw(s, cvt->a) && is_within(ins(s, cvt->a)->type, cvt->type); }

// r without conversions that do not matter to who asks only whether it is true.
static IrRef without_truth(const Select *s, IrRef r)
{
    while (s->value[r].waits && ins(s, r)->op == IR_cvt && (ins(s, r)->type == SM_BOOL || changes_nothing(s, ins(s, r))))
        r = ins(s, r)->a;
    return r;
}

// Whether r is an integer that the VM, which computes it as F64, may find to be -0.  As an operand in a slot of its type it is 0, so
// no other operation on integers can come to -0.
static bool may_be_minus_zero(const Select *s, IrRef r)
{
    const IrIns *i = ins(s, r);

    return sm_type_info[i->type].kind != SM_KIND_FLOAT && (i->op == IR_mul || i->op == IR_neg);
}

// Where a result lies that its user does not take into its own destination: what an operation gives stays as it is, in a temp; what
// is converted, or read before it is overwritten, or has to be 0 where it is -0, lies in a slot of its type.
static size_t pool_of(const Select *s, IrRef r)
{
    const IrIns *i = ins(s, r);

    return may_be_minus_zero(s, r) || i->op == IR_cvt || (i->op == IR_load && i->type != SM_F64) ? (size_t)i->type : (size_t)BC_TEMPS;
}

static BcRef operand(Select *s, IrRef r);

static void used(Select *s, IrRef r, BcRef slot)                 // r has been read from `slot` once
{
    Value *v = &s->value[r];

    if (v->placed && --v->left > 0)
        return;
    bc_slot_give(s, slot);
}

// Which value lies in the slot that operand(r) gives: r, or what it is a mere conversion of.
static IrRef source(const Select *s, IrRef r)
{
    while (s->value[r].waits && ins(s, r)->op == IR_cvt && changes_nothing(s, ins(s, r)))
        r = ins(s, r)->a;
    return r;
}

static void compute(Select *s, IrRef r);

// Where r's number is; computes it if it waits.  The slot is given back by used(source(r)).
static BcRef operand(Select *s, IrRef r)
{
    const Value *v;

    r = source(s, r);
    v = &s->value[r];
    if (v->placed)
        return v->slot;
    if (ins(s, r)->op == IR_const)
        return bc_const_operand(s, sm_bits(const_value(ins(s, r))));
    if (ins(s, r)->op == IR_load)
        return bc_var_operand(s, ins(s, r)->var);
    compute(s, r);
    return v->slot;
}

static BcRef choose_slot(Select *s, IrRef r, BcRef d)            // d, or a new slot of the right kind
{
    return d != BC_NONE ? d : (s->value[r].slot = bc_slot_take(s, pool_of(s, r)));
}

// How often r will be read from the slot that was taken for it; d as above.
static uint32_t reads_of(const Select *s, IrRef r, BcRef d) { return d != BC_NONE ? 0 : s->value[r].waits ? 1 : s->value[r].left; }

// Both operands; the deeper one is computed first, which keeps the other's slot free for it.
static void operands(Select *s, IrRef a, IrRef b, BcRef *x, BcRef *y)
{
    bool b_first = depth_of(s, source(s, b)) > depth_of(s, source(s, a));

    if (b_first)
        *y = operand(s, b);
    *x = operand(s, a);
    if (!b_first)
        *y = operand(s, b);
    used(s, source(s, b), *y);
    used(s, source(s, a), *x);
}

static void compute_two(Select *s, IrRef r, BcRef d, IrRef a, IrRef b, uint8_t op, bool swap)
{
    BcRef x, y, slot;

    operands(s, a, b, &x, &y);
    slot = choose_slot(s, r, d);
    bc_put_dxy(s, op, slot, swap ? y : x, swap ? x : y)->reads = reads_of(s, r, d);
}

static void compute_one(Select *s, IrRef r, BcRef d, IrRef a, uint8_t op)
{
    BcRef x = operand(s, a);

    used(s, source(s, a), x);
    bc_put_dxy(s, op, choose_slot(s, r, d), x, BC_NONE)->reads = reads_of(s, r, d);
}

static void compute_stat(Select *s, const IrIns *stat, IrRef r, BcRef d)
{
    BcRef slot = choose_slot(s, r, d);
    BcIns *i = bc_put(s, (uint8_t)((unsigned)SMVM_avg + (unsigned)stat->stat));

    i->d = bc_count(s, slot);
    i->reads = reads_of(s, r, d);
    s->m->operand.at[slot].stored = true;
    i->w = s->m->window_number[stat->var];
}

// Whether storing in a destination of type `type` does what a conversion to `to` does before it.  NaN becomes 0 in all of them, so
// conversions of F64 to itself vanish; and what is cut to a range is cut again to one inside it.
static bool storing_converts(SmType to, SmType type)
{
    return to == type || to == SM_F64 || (sm_type_info[to].kind != SM_KIND_FLOAT && type != SM_BOOL && to != SM_BOOL && is_within(type, to));
}

// r without conversions that storing in a destination of type `type` does.
static IrRef stored(const Select *s, IrRef r, SmType type)
{
    const IrIns *i = ins(s, r);

    for (; s->value[r].waits && i->op == IR_cvt && (storing_converts(i->type, type) || changes_nothing(s, i)); i = ins(s, r))
        r = i->a;
    return r;
}

// Computes an operation into d, or where that is BC_NONE into a slot for r, which is the operation or a conversion of it.
static void compute_op(Select *s, const IrIns *i, IrRef r, BcRef d)
{
    bool logic = ir_op_info[i->op].types == IR_T_LOGIC, swap;
    uint8_t op = opcode(i->op, &swap);

    if (i->op == IR_stat)
        compute_stat(s, i, r, d);
    else if (ir_op_info[i->op].operands == 2)
        compute_two(s, r, d, logic ? without_truth(s, i->a) : i->a, logic ? without_truth(s, i->b) : i->b, op, swap);
    else
        compute_one(s, r, d, logic ? without_truth(s, i->a) : i->a, i->op == IR_cvt ? SMVM_truth : op);
}

// Computes r into a destination d of type `type`, which converts; or where d is BC_NONE into a slot of that type for `owner`.
static void compute_into(Select *s, IrRef r, IrRef owner, BcRef d, SmType type)
{
    const IrIns *i;
    bool sign;                                        // it would take a -0 that is to be 0

    r = stored(s, r, type);
    i = ins(s, r);
    sign = sm_type_info[type].kind == SM_KIND_FLOAT && may_be_minus_zero(s, r);
    if (s->value[r].waits && (i->op != IR_cvt || i->type == SM_BOOL) && !sign)
        compute_op(s, i, owner, d);
    else
        compute_one(s, owner, d, r, SMVM_mov);
}

// Computes r into a slot that it takes and notes.
static void compute(Select *s, IrRef r)
{
    const IrIns *i = ins(s, r);

    if (i->op == IR_cvt && i->type != SM_BOOL)
        compute_into(s, i->a, r, BC_NONE, i->type);
    else
        compute_op(s, i, r, BC_NONE);
}

// ---- conditions ----

static void put_jump(Select *s, uint8_t op, BcRef x, BcRef y, uint32_t label)
{
    BcIns *i = bc_put(s, op);

    if (x != BC_NONE)
        i->x = bc_count(s, x);
    if (y != BC_NONE)
        i->y = bc_count(s, y);
    i->to = label;
}

// Jumps to the label if the comparison gives `when`.
static void jump_compare(Select *s, const IrIns *i, bool when, uint32_t label)
{
    bool swap = i->op == IR_gt || i->op == IR_ge;
    BcRef x, y;
    uint8_t op;

    if (i->op == IR_eq || i->op == IR_ne)
        op = (i->op == IR_eq) == when ? SMVM_jeq : SMVM_jne;
    else if (i->op == IR_lt || i->op == IR_gt)
        op = when ? SMVM_jlt : SMVM_jnlt;
    else
        op = when ? SMVM_jle : SMVM_jnle;
    operands(s, i->a, i->b, &x, &y);
    put_jump(s, op, swap ? y : x, swap ? x : y, label);
}

static void jump_number(Select *s, IrRef r, bool when, uint32_t label)
{
    BcRef x;

    if (ins(s, r)->op == IR_const) {
        if (sm_to_bool(const_value(ins(s, r))) == when)
            put_jump(s, SMVM_jmp, BC_NONE, BC_NONE, label);
        return;
    }
    x = operand(s, r);
    used(s, source(s, r), x);
    put_jump(s, when ? SMVM_jt : SMVM_jf, x, BC_NONE, label);
}

// Jumps to the label if r is true (`when`) or not true (!when), else goes on.
static void jump_on(Select *s, IrRef r, bool when, uint32_t label)
{
    const IrIns *i;
    uint32_t past;

    r = without_truth(s, r);
    while (s->value[r].waits && ins(s, r)->op == IR_not) {
        when = !when;
        r = without_truth(s, ins(s, r)->a);
    }
    i = ins(s, r);
    if (!s->value[r].waits) {
        jump_number(s, r, when, label);
    } else if (i->op == IR_and || i->op == IR_or) {
        if ((i->op == IR_or) == when) {                          // either decides
            jump_on(s, i->a, when, label);
            jump_on(s, i->b, when, label);
        } else {
            past = bc_label_new(s);
            jump_on(s, i->a, !when, past);
            jump_on(s, i->b, when, label);
            bc_label_here(s, past);
        }
    } else if (ir_op_info[i->op].types == IR_T_COMPARE) {
        jump_compare(s, i, when, label);
    } else {
        jump_number(s, r, when, label);
    }
}

// ---- which operations wait ----

static bool is_pure_operation(IrOp op) { return !ir_op_info[op].effect && op != IR_const && op != IR_load; }

static void use(Select *s, IrRef r, uint32_t at, uint32_t times)
{
    Value *v = &s->value[r];

    v->uses += times;
    if (v->last < at)
        v->last = at;
}

// Counts the uses by what is live, from the block's end; `at` is a position + 1.
static void count_block(Select *s, const IrBlk *b, bool deep_known, uint32_t block)
{
    if (b->jump.kind == IR_BR)
        use(s, b->jump.cond, (uint32_t)b->ins.n + 1, 1);
    for (uint32_t p = (uint32_t)b->ins.n; p-- > 0;) {
        IrRef r = b->ins.at[p];
        const IrIns *i = ins(s, r);
        Value *v = &s->value[r];
        uint32_t at = p + 1;
        bool same;

        if (!ir_op_info[i->op].effect && v->uses == 0)
            continue;
        v->left = v->uses;
        same = i->op == IR_cvt && changes_nothing(s, i);
        v->waits = is_pure_operation(i->op) && (v->uses == 1 || same) && !(deep_known && v->depth > DEEPEST);
        if (v->waits)
            at = v->last;
        if (i->op == IR_load)
            v->early = s->store_in[i->var] == block + 1 && s->store_at[i->var] < v->last;
        if (i->op == IR_store) {
            s->store_at[i->var] = p + 1;
            s->store_in[i->var] = block + 1;
        }
        if (ir_op_info[i->op].operands > 0)
            use(s, i->a, at, v->waits ? v->uses : 1);
        if (ir_op_info[i->op].operands > 1)
            use(s, i->b, at, 1);
    }
}

static void find_depths(Select *s, const IrBlk *b)
{
    for (size_t p = 0; p < b->ins.n; p++) {
        const IrIns *i = ins(s, b->ins.at[p]);
        uint32_t x = ir_op_info[i->op].operands > 0 ? depth_of(s, i->a) : 0;
        uint32_t y = ir_op_info[i->op].operands > 1 ? depth_of(s, i->b) : 0;
        if (is_pure_operation(i->op))
            s->value[b->ins.at[p]].depth = 1 + (x > y ? x : y);
    }
}

static void plan_block(Select *s, uint32_t block)
{
    const IrBlk *b = &s->f->blk.at[block];

    count_block(s, b, false, block);
    find_depths(s, b);
    for (size_t p = 0; p < b->ins.n; p++) {
        Value *v = &s->value[b->ins.at[p]];
        v->uses = v->last = 0;
    }
    for (size_t p = 0; p < b->ins.n; p++)
        if (ins(s, b->ins.at[p])->op == IR_store)
            s->store_in[ins(s, b->ins.at[p])->var] = 0;
    count_block(s, b, true, block);
}

// ---- instructions, blocks, functions ----

static void place(Select *s, IrRef r)                            // computes r where it stands
{
    Value *v = &s->value[r];
    BcRef d;

    if (ins(s, r)->op == IR_load) {
        d = bc_slot_take(s, pool_of(s, r));
        bc_put_dxy(s, SMVM_mov, d, bc_var_operand(s, ins(s, r)->var), BC_NONE)->reads = v->left;
        v->slot = d;
    } else {
        compute(s, r);
    }
    v->placed = true;
}

static void select_sample(Select *s, const IrIns *i)
{
    BcRef x = operand(s, i->a);
    BcIns *b;

    used(s, source(s, i->a), x);
    b = bc_put(s, SMVM_sample);
    b->x = bc_count(s, x);
    b->w = s->m->window_number[i->var];
}

static void select_ins(Select *s, IrRef r)
{
    const IrIns *i = ins(s, r);
    const Value *v = &s->value[r];

    s->span = i->span;
    if (i->op == IR_store)
        compute_into(s, i->a, i->a, bc_var_operand(s, i->var), i->type);
    else if (i->op == IR_sample)
        select_sample(s, i);
    else if (v->uses > 0 && !v->waits && i->op != IR_const && (i->op != IR_load || v->early))
        place(s, r);
}

// Goes on at block `to`; `next` is the block that follows in the output.  A jump to an end is an end.
static void select_jmp(Select *s, IrBlkRef to, IrBlkRef next)
{
    const IrBlk *b = &s->f->blk.at[to];

    if (to == next)
        return;
    if (b->ins.n == 0 && b->jump.kind == IR_RET)
        bc_put(s, SMVM_end);
    else if (b->ins.n == 0 && b->jump.kind == IR_GOTO)
        bc_put(s, SMVM_goto)->to = b->jump.state;
    else
        put_jump(s, SMVM_jmp, BC_NONE, BC_NONE, s->label[to]);
}

static void select_br(Select *s, IrRef cond, IrBlkRef then, IrBlkRef otherwise, IrBlkRef next)
{
    if (then == next) {
        jump_on(s, cond, false, s->label[otherwise]);
    } else {
        jump_on(s, cond, true, s->label[then]);
        select_jmp(s, otherwise, next);
    }
}

static void select_jump(Select *s, const IrJump *j, IrBlkRef next)
{
    if (j->span.src)
        s->span = j->span;
    switch (j->kind) {
    case IR_RET: bc_put(s, SMVM_end); break;
    case IR_GOTO: bc_put(s, SMVM_goto)->to = j->state; break;
    case IR_JMP: select_jmp(s, s->through[j->then], next); break;
    case IR_BR: select_br(s, j->cond, s->through[j->then], s->through[j->otherwise], next); break;
    }
}

static void select_block(Select *s, uint32_t block, IrBlkRef next)
{
    const IrBlk *b = &s->f->blk.at[block];

    plan_block(s, block);
    bc_label_here(s, s->label[block]);
    for (size_t p = 0; p < b->ins.n; p++)
        select_ins(s, b->ins.at[p]);
    select_jump(s, &b->jump, next);
}

// Which blocks are put out: those that can be reached and do more than jump; label and `through` of each.
static bool *plan_blocks(Select *s, const IrFn *f)
{
    bool *kept = ir_reachable(s->arena, f);

    s->label = ARENA_ARRAY(s->arena, uint32_t, f->blk.n);
    s->through = ARENA_ARRAY(s->arena, IrBlkRef, f->blk.n);
    for (size_t b = f->blk.n; b-- > 0;) {
        const IrBlk *blk = &f->blk.at[b];
        bool jumps = blk->ins.n == 0 && blk->jump.kind == IR_JMP;
        s->label[b] = bc_label_new(s);
        s->through[b] = jumps ? s->through[blk->jump.then] : (IrBlkRef)b;
        kept[b] = kept[b] && (!jumps || b == 0);
    }
    return kept;
}

static void select_function(Select *s, const IrFn *f, BcFn *out)
{
    bool *kept;
    IrBlkRef next;

    s->f = f;
    s->out = out;
    s->value = ARENA_ARRAY(s->arena, Value, f->ins.n);
    kept = plan_blocks(s, f);
    memset(s->store_in, 0, s->m->ir->var.n * sizeof *s->store_in);
    for (uint32_t b = 0; b < f->blk.n; b = next) {
        for (next = b + 1; next < f->blk.n && !kept[next];)
            next++;
        if (kept[b])
            select_block(s, b, next);
    }
    bc_use_acc(s);
}

// A function that does nothing needs no code.
static bool does_nothing(const IrFn *f) { return f->blk.at[0].ins.n == 0 && f->blk.at[0].jump.kind == IR_RET; }

static void number_windows(Select *s)
{
    const IrFn *f = s->m->ir->sample;
    uint32_t n = 0;

    s->m->window_number = ARENA_ARRAY(s->arena, uint32_t, s->m->ir->window.n);
    for (size_t i = 0; f && i < f->blk.at[0].ins.n; i++) {
        const IrIns *at = &f->ins.at[f->blk.at[0].ins.at[i]];
        if (at->op == IR_sample)
            s->m->window_number[at->var] = n++;
    }
}

void bc_select(Arena *arena, BcMachine *out, const IrMachine *m)
{
    Select s;

    memset(out, 0, sizeof *out);
    memset(&s, 0, sizeof s);
    out->ir = m;
    s.arena = arena;
    s.m = out;
    s.store_at = ARENA_ARRAY(arena, uint32_t, m->var.n);
    s.store_in = ARENA_ARRAY(arena, uint32_t, m->var.n);
    out->of_var = ARENA_ARRAY(arena, BcRef, m->var.n);
    memset(out->of_var, 0xff, m->var.n * sizeof *out->of_var);
    out->fns = 1 + 3 * m->state.n;
    out->fn = ARENA_ARRAY(arena, BcFn, out->fns);
    bc_var_operand(&s, m->g);
    bc_var_operand(&s, m->s);
    number_windows(&s);
    if (m->sample)
        select_function(&s, m->sample, &out->fn[0]);
    for (size_t i = 0; i < m->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (m->state.at[i].block[b] && !does_nothing(m->state.at[i].block[b]))
                select_function(&s, m->state.at[i].block[b], &out->fn[1 + 3 * i + (size_t)b]);
    bc_drop_unused(&s);
}
