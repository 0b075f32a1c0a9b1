// SPDX-License-Identifier: Apache-2.0
// IR to instructions.  The target's operands convert by themselves, so loads, stores and most conversions vanish into the
// operands of the operation between them: `counter = counter + 1` is one instruction.
//
// Within a block an operation whose result is used once waits for its user, which then asks for it; what is used more often
// is computed where it stands, into a temp.  A load is read by its users directly, unless a store to its variable comes
// before the last of them.  Conditions become jumps over jumps, never numbers.
#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/emit/bytecode/bytecode.h"
#include "stdlib/convert.h"

enum { DEEPEST = 100 };       // how many operations may wait for each other: a bound of this file's recursion

// What is known of one instruction of the IR, in its block.
typedef struct Value {
    uint32_t uses;            // by live instructions and the jump
    uint32_t left;            // of these, not yet selected
    uint32_t last;            // position + 1 at which the last user is computed
    uint32_t depth;           // how many operations wait for each other in it
    bool placed;              // it has been computed where it stands: `slot` holds it
    bool waits;               // it is computed by its user, or by each if it is a conversion that changes nothing
    bool early;               // of a load: it must be read where it stands, for a store to its variable follows
    BcRef slot;
} Value;

typedef struct Select {
    Arena *arena;
    BcMachine *m;
    const IrFn *f;
    BcFn *out;
    Value *value;             // by instruction
    uint32_t *store_at;       // by variable: position + 1 of the next store to it…
    uint32_t *store_in;       // …in block store_in - 1
    VEC(BcRef) free[SM_TYPE_COUNT + 1];       // slots nobody uses; [F64] is typed scratch, the last one temps
    Span span;                // of what is being selected
    uint32_t *label;          // by block: its label
    IrBlkRef *through;        // by block: itself, or where it leads if it only jumps
} Select;

// ---- operands ----

static BcRef add_operand(Select *s, BcOperandKind kind, SmType type)
{
    BcOperand o;

    memset(&o, 0, sizeof o);
    o.kind = kind;
    o.type = type;
    vec_push(s->arena, &s->m->operand, o);
    return (BcRef)(s->m->operand.n - 1);
}

static BcRef var_operand(Select *s, uint32_t var)
{
    BcRef *r = &s->m->of_var[var];

    if (*r == BC_NONE) {
        *r = add_operand(s, BC_VAR, s->m->ir->var.at[var].type);
        s->m->operand.at[*r].var = var;
    }
    return *r;
}

static size_t const_place(const BcMachine *m, const BcRef *table, size_t cap, uint64_t bits)
{
    size_t i = (size_t)(bits * UINT64_C(0x9e3779b97f4a7c15) >> 32) & (cap - 1);

    while (table[i] != BC_NONE && m->operand.at[table[i]].bits != bits)
        i = (i + 1) & (cap - 1);
    return i;
}

static void grow_consts(Select *s)
{
    BcMachine *m = s->m;
    size_t cap = m->const_cap ? m->const_cap * 2 : 64;
    BcRef *table = ARENA_ARRAY(s->arena, BcRef, cap);

    memset(table, 0xff, cap * sizeof *table);
    for (size_t i = 0; i < m->const_cap; i++)
        if (m->const_slot[i] != BC_NONE)
            table[const_place(m, table, cap, m->operand.at[m->const_slot[i]].bits)] = m->const_slot[i];
    m->const_slot = table;
    m->const_cap = cap;
}

static BcRef const_operand(Select *s, uint64_t bits)
{
    size_t place;

    if (s->m->consts * 2 >= s->m->const_cap)
        grow_consts(s);
    place = const_place(s->m, s->m->const_slot, s->m->const_cap, bits);
    if (s->m->const_slot[place] == BC_NONE) {
        BcRef r = add_operand(s, BC_CONST, SM_F64);
        s->m->operand.at[r].bits = bits;
        s->m->const_slot[place] = r;
        s->m->consts++;
    }
    return s->m->const_slot[place];
}

// The F64 that a constant stands for.  (A NaN is one only as an F64, and then stays one.)
static SmF64 const_value(const IrIns *i)
{
    return i->type == SM_F64 ? sm_from_bits(i->bits) : sm_cell_to_f64(i->type, i->bits);
}

// ---- slots: temps for numbers as they are, scratch locals for those that a conversion rounds ----

static BcRef slot_take(Select *s, size_t pool)
{
    BcMachine *m = s->m;
    BcRef r;

    if (s->free[pool].n > 0)
        return s->free[pool].at[--s->free[pool].n];
    r = add_operand(s, pool == SM_TYPE_COUNT ? BC_TEMP : BC_SCRATCH, pool == SM_TYPE_COUNT ? SM_F64 : (SmType)pool);
    m->operand.at[r].index = pool == SM_TYPE_COUNT ? m->temps++ : m->scratches[pool]++;
    return r;
}

static void slot_give(Select *s, BcRef r)                        // back, if it is one
{
    const BcOperand *o = &s->m->operand.at[r];

    if (o->kind == BC_TEMP)
        vec_push(s->arena, &s->free[SM_TYPE_COUNT], r);
    else if (o->kind == BC_SCRATCH)
        vec_push(s->arena, &s->free[o->type], r);
}

// ---- output ----

static BcIns *put(Select *s, uint8_t op)
{
    BcIns i;

    memset(&i, 0, sizeof i);
    i.op = op;
    i.span = s->span;
    i.d = i.x = i.y = BC_NONE;
    vec_push(s->arena, &s->out->ins, i);
    return &s->out->ins.at[s->out->ins.n - 1];
}

static BcRef count(Select *s, BcRef r)
{
    s->m->operand.at[r].uses++;
    return r;
}

static void put_dxy(Select *s, uint8_t op, BcRef d, BcRef x, BcRef y)
{
    BcIns *i = put(s, op);

    i->d = count(s, d);
    s->m->operand.at[d].stored = true;
    i->x = count(s, x);
    if (y != BC_NONE)
        i->y = count(s, y);
}

static uint32_t label_new(Select *s)
{
    vec_push(s->arena, &s->out->label, UINT32_MAX);
    return (uint32_t)(s->out->label.n - 1);
}

static void label_here(Select *s, uint32_t label) { s->out->label.at[label] = (uint32_t)s->out->ins.n; }

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

// Whether r's number can be NaN.  Only an F64 can be one; what was read, converted or counted is none.
static bool may_be_nan(const Select *s, IrRef r)
{
    const IrIns *i = ins(s, r);

    if (i->op == IR_const)
        return i->type == SM_F64 && sm_is_nan(sm_from_bits(i->bits));
    return i->type == SM_F64 && i->op != IR_load && i->op != IR_cvt;
}

// Whether a conversion leaves the number as it is once its operand has been read.  (One that is not to F64 is from it.)
static bool changes_nothing(const Select *s, const IrIns *cvt) { return cvt->type == SM_F64 && !may_be_nan(s, cvt->a); }

// r without conversions that do not matter to who asks only whether it is true.
static IrRef without_truth(const Select *s, IrRef r)
{
    while (s->value[r].waits && ins(s, r)->op == IR_cvt && (ins(s, r)->type == SM_BOOL || changes_nothing(s, ins(s, r))))
        r = ins(s, r)->a;
    return r;
}

// A conversion that is computed by its user rounds into a slot of its type, unless the user's destination does the same.
static size_t pool_of(const IrIns *i) { return i->op == IR_cvt && i->type != SM_BOOL ? (size_t)i->type : (size_t)SM_TYPE_COUNT; }

static BcRef operand(Select *s, IrRef r);

static void used(Select *s, IrRef r, BcRef slot)                 // r has been read from `slot` once
{
    Value *v = &s->value[r];

    if (v->placed && --v->left > 0)
        return;
    slot_give(s, slot);
}

// Which value lies in the slot that operand(r) gives: r, or what it is a mere conversion of.
static IrRef source(const Select *s, IrRef r)
{
    while (s->value[r].waits && ins(s, r)->op == IR_cvt && changes_nothing(s, ins(s, r)))
        r = ins(s, r)->a;
    return r;
}

static void compute(Select *s, IrRef r, BcRef d);

// Where r's number is; computes it if it waits.  The slot is given back by used(source(r)).
static BcRef operand(Select *s, IrRef r)
{
    const Value *v;

    r = source(s, r);
    v = &s->value[r];
    if (v->placed)
        return v->slot;
    if (ins(s, r)->op == IR_const)
        return const_operand(s, sm_bits(const_value(ins(s, r))));
    if (ins(s, r)->op == IR_load)
        return var_operand(s, ins(s, r)->var);
    compute(s, r, BC_NONE);
    return v->slot;
}

static BcRef choose_slot(Select *s, IrRef r, BcRef d)            // d, or a new slot of the right kind
{
    return d != BC_NONE ? d : (s->value[r].slot = slot_take(s, pool_of(ins(s, r))));
}

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
    BcRef x, y;

    operands(s, a, b, &x, &y);
    d = choose_slot(s, r, d);
    put_dxy(s, op, d, swap ? y : x, swap ? x : y);
}

static void compute_one(Select *s, IrRef r, BcRef d, IrRef a, uint8_t op)
{
    BcRef x = operand(s, a);

    used(s, source(s, a), x);
    put_dxy(s, op, choose_slot(s, r, d), x, BC_NONE);
}

static void compute_stat(Select *s, IrRef r, BcRef d)
{
    BcIns *i;

    d = choose_slot(s, r, d);
    i = put(s, (uint8_t)((unsigned)SMVM_avg + (unsigned)ins(s, r)->stat));
    i->d = count(s, d);
    s->m->operand.at[d].stored = true;
    i->w = s->m->window_number[ins(s, r)->var];
}

// Computes r into d, or where that is BC_NONE into a slot that it takes and notes.
static void compute(Select *s, IrRef r, BcRef d)
{
    const IrIns *i = ins(s, r);
    bool logic = ir_op_info[i->op].types == IR_T_LOGIC, swap;
    uint8_t op = opcode(i->op, &swap);

    if (i->op == IR_stat)
        compute_stat(s, r, d);
    else if (i->op == IR_cvt)
        compute_one(s, r, d, i->a, i->type == SM_BOOL ? SMVM_truth : SMVM_mov);
    else if (ir_op_info[i->op].operands == 2)
        compute_two(s, r, d, logic ? without_truth(s, i->a) : i->a, logic ? without_truth(s, i->b) : i->b, op, swap);
    else
        compute_one(s, r, d, logic ? without_truth(s, i->a) : i->a, op);
}

// Whether storing does what a conversion to `to` does, in a destination of type `type`.  NaN becomes 0 in all of them, so
// conversions of F64 to itself vanish.
static bool storing_converts(SmType to, SmType type) { return to == type || to == SM_F64; }

// Computes r into an element or local of type `type`.
static void compute_into(Select *s, IrRef r, BcRef d, SmType type)
{
    const IrIns *i = ins(s, r);
    BcRef x;

    while (s->value[r].waits && i->op == IR_cvt && (storing_converts(i->type, type) || changes_nothing(s, i))) {
        r = i->a;
        i = ins(s, r);
    }
    if (s->value[r].waits && (i->op != IR_cvt || i->type == SM_BOOL)) {
        compute(s, r, d);
        return;
    }
    x = operand(s, r);
    used(s, source(s, r), x);
    put_dxy(s, SMVM_mov, d, x, BC_NONE);
}

// ---- conditions ----

static void put_jump(Select *s, uint8_t op, BcRef x, BcRef y, uint32_t label)
{
    BcIns *i = put(s, op);

    if (x != BC_NONE)
        i->x = count(s, x);
    if (y != BC_NONE)
        i->y = count(s, y);
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
            past = label_new(s);
            jump_on(s, i->a, !when, past);
            jump_on(s, i->b, when, label);
            label_here(s, past);
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
        d = slot_take(s, SM_TYPE_COUNT);
        put_dxy(s, SMVM_mov, d, var_operand(s, ins(s, r)->var), BC_NONE);
        v->slot = d;
    } else {
        compute(s, r, BC_NONE);
    }
    v->placed = true;
}

static void select_sample(Select *s, const IrIns *i)
{
    BcRef x = operand(s, i->a);
    BcIns *b;

    used(s, source(s, i->a), x);
    b = put(s, SMVM_sample);
    b->x = count(s, x);
    b->w = s->m->window_number[i->var];
}

static void select_ins(Select *s, IrRef r)
{
    const IrIns *i = ins(s, r);
    const Value *v = &s->value[r];

    s->span = i->span;
    if (i->op == IR_store)
        compute_into(s, i->a, var_operand(s, i->var), i->type);
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
        put(s, SMVM_end);
    else if (b->ins.n == 0 && b->jump.kind == IR_GOTO)
        put(s, SMVM_goto)->to = b->jump.state;
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
    case IR_RET: put(s, SMVM_end); break;
    case IR_GOTO: put(s, SMVM_goto)->to = j->state; break;
    case IR_JMP: select_jmp(s, s->through[j->then], next); break;
    case IR_BR: select_br(s, j->cond, s->through[j->then], s->through[j->otherwise], next); break;
    }
}

static void select_block(Select *s, uint32_t block, IrBlkRef next)
{
    const IrBlk *b = &s->f->blk.at[block];

    plan_block(s, block);
    label_here(s, s->label[block]);
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
        s->label[b] = label_new(s);
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
    var_operand(&s, m->g);
    var_operand(&s, m->s);
    number_windows(&s);
    if (m->sample)
        select_function(&s, m->sample, &out->fn[0]);
    for (size_t i = 0; i < m->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (m->state.at[i].block[b] && !does_nothing(m->state.at[i].block[b]))
                select_function(&s, m->state.at[i].block[b], &out->fn[1 + 3 * i + (size_t)b]);
}
