// SPDX-License-Identifier: Apache-2.0
// Conditions, block order, functions and machines.  A condition becomes conditional jumps; its value is not computed.  A block in which an
// `if` leaves the function is laid out after the others, so that X keeps its contents across guards that are false.
#include <string.h>

#include "compiler/emit/bytecode/bc_select.h"
#include "stdlib/convert.h"

// ---- conditions ----

// Emits a jump to `label`, and records it as the label's last jump: its index plus 1.
static void emit_jump(BcSelect *s, uint32_t op, uint32_t n, uint32_t label)
{
    BcIns *i = bc_emit(s, (uint8_t)op);

    i->n = n;
    i->to = label;
    s->out->label.at[label].last_jump = (uint32_t)s->out->ins.n;
}

// Whether the conditional jump of the current block created the label.  The contents of X are unknown after such a label, so a value in X that
// is still needed must be saved before a jump to it.
static bool is_inner_label(const BcSelect *s, uint32_t label) { return label >= s->first_inner_label; }

// Sets *n if r is a constant that a jump can encode: a whole number, not below 0.  Returns false if not.
static bool match_jump_constant(const BcSelect *s, IrRef r, int32_t *n)
{
    return bc_ins(s, r)->op == IR_const && bc_try_whole(bc_const_value(bc_ins(s, r)), n) && *n >= 0;
}

// Jumps to the label if the result of the comparison is `when`.  The opcodes of a group of jumps follow each other by relation, from 1.
static void emit_compare_jump(BcSelect *s, const IrIns *i, bool when, uint32_t label)
{
    uint32_t relation = when ? bc_relation_of(i->op) : bc_negated_relation(bc_relation_of(i->op));
    IrRef a = bc_skip_exact_cvts(s, i->a), b = bc_skip_exact_cvts(s, i->b);
    int32_t n;

    if (match_jump_constant(s, a, &n)) {
        const IrRef c = a;
        a = b;
        b = c;
        relation = bc_swapped_relation(relation);
    }
    if (match_jump_constant(s, b, &n)) {
        bc_bring_to_x(s, a);
        if (is_inner_label(s, label))
            bc_save_x(s);
        emit_jump(s, SMVM_jxn - 1 + relation, (uint32_t)n, label);
    } else {
        if (bc_load_operands(s, a, b, true, is_inner_label(s, label)))
            relation = bc_swapped_relation(relation);
        emit_jump(s, SMVM_jxy - 1 + relation, 0, label);
    }
}

// Jumps to the label if the truth of r equals `when`.  r is not a waiting comparison, `and`, `or` or `not`.
static void emit_truth_jump(BcSelect *s, IrRef r, bool when, uint32_t label)
{
    if (bc_ins(s, r)->op == IR_const) {
        if (sm_to_bool(bc_const_value(bc_ins(s, r))) != when)
            return;
        bc_save_x(s);
        emit_jump(s, SMVM_jmp, 0, label);
        bc_forget_registers(s);
        return;
    }
    bc_bring_to_x(s, r);
    if (is_inner_label(s, label))
        bc_save_x(s);
    emit_jump(s, when ? SMVM_jt : SMVM_jf, 0, label);
}

// Jumps to the label if the truth of r equals `when`; otherwise falls through.
static void emit_conditional_jump(BcSelect *s, IrRef r, bool when, uint32_t label)
{
    const IrIns *i;
    uint32_t past;

    r = bc_skip_truth_cvts(s, r);
    while (s->value[r].waits && bc_ins(s, r)->op == IR_not) {
        when = !when;
        r = bc_skip_truth_cvts(s, bc_ins(s, r)->a);
    }
    i = bc_ins(s, r);
    if (!s->value[r].waits) {
        emit_truth_jump(s, r, when, label);
    } else if (i->op == IR_and || i->op == IR_or) {
        if ((i->op == IR_or) == when) {                          // each operand alone can cause the jump
            emit_conditional_jump(s, i->a, when, label);
            emit_conditional_jump(s, i->b, when, label);
        } else {
            past = bc_label_new(s);
            emit_conditional_jump(s, i->a, !when, past);
            emit_conditional_jump(s, i->b, when, label);
            bc_label_place(s, past);
        }
    } else if (ir_op_info[i->op].types == IR_T_COMPARE) {
        emit_compare_jump(s, i, when, label);
    } else {
        emit_truth_jump(s, r, when, label);
    }
}

// ---- the ends of a function ----

static bool ends_function(const IrBlk *b) { return b->jump.kind == IR_RET || b->jump.kind == IR_GOTO; }
static bool only_ends_function(const IrBlk *b) { return b->ins.n == 0 && ends_function(b); }

static uint32_t line_of(Span span) { return span.src ? source_position(span.src, span.at).line : 0; }
static bool is_same_line(Span a, Span b) { return (a.src == b.src && a.at == b.at) || line_of(a) == line_of(b); }

// Returns the current function's record of the exit j (`end`, or `goto` to one state), cleared when the function first uses it.
static BcExit *find_or_add_exit(BcSelect *s, const IrJump *j)
{
    const uint32_t index = j->kind == IR_GOTO ? j->state : 0;
    BcExit *e = &s->exit[index];

    if (e->fn != s->fn) {
        memset(e, 0, sizeof *e);
        e->fn = s->fn;
        e->label = UINT32_MAX;
        vec_push(s->arena, &s->exits, index);
    }
    return e;
}

// Emits the goto or end of j, and records its index plus 1 in the exit's `at`.
static void emit_exit(BcSelect *s, const IrJump *j)
{
    if (j->span.src)
        s->span = j->span;
    find_or_add_exit(s, j)->at = (uint32_t)s->out->ins.n + 1;
    bc_emit(s, j->kind == IR_GOTO ? SMVM_goto : SMVM_end)->n = j->kind == IR_GOTO ? j->state : 0;
    bc_forget_registers(s);
}

// Returns the label for jumps to block `to`.  Blocks that only end the function in the same way share one label.
static uint32_t find_or_add_label(BcSelect *s, IrBlkRef to)
{
    const IrJump *j = &s->f->blk.at[to].jump;
    BcExit *e;

    if (!only_ends_function(&s->f->blk.at[to]))
        return s->label[to];
    e = find_or_add_exit(s, j);
    if (e->label == UINT32_MAX) {
        e->label = bc_label_new(s);
        e->span = j->span;
    }
    e->of_many_lines = e->of_many_lines || !is_same_line(j->span, e->span);
    return e->label;
}

// Places the label of the exit `end` (state 0) or `goto state` at the last `end` or `goto` instruction emitted for this exit.  Emits another one
// at the end of the function if a jump to the label comes after that instruction.
static void place_exit(BcSelect *s, uint32_t state)
{
    BcExit *e = &s->exit[state];
    BcLabel *l;
    BcIns *i;

    if (e->label == UINT32_MAX || s->out->label.at[e->label].last_jump == 0)
        return;
    l = &s->out->label.at[e->label];
    if (e->at <= l->last_jump) {
        s->span = e->span.src ? e->span : s->span;
        bc_emit(s, state ? SMVM_goto : SMVM_end)->n = state;
        e->at = (uint32_t)s->out->ins.n;
    }
    l->at = e->at - 1;
    i = &s->out->ins.at[l->at];
    i->of_many_lines = state != 0 && (e->of_many_lines || !is_same_line(i->span, e->span));
}

// ---- a block's jump ----

// Emits the jump to block `to`, unless it is `next`, the block that follows in the output.  If block `to` only ends the function, emits its
// `end` or `goto` instead.
static void select_jmp(BcSelect *s, IrBlkRef to, IrBlkRef next)
{
    if (to == next)
        return;
    if (only_ends_function(&s->f->blk.at[to])) {
        emit_exit(s, &s->f->blk.at[to].jump);
        return;
    }
    emit_jump(s, SMVM_jmp, 0, s->label[to]);
    bc_forget_registers(s);
}

// Jumps on the value of cond: to `otherwise` if `then` is the next block in the code, else to `then` and after that to `otherwise`.
static void select_br(BcSelect *s, IrRef cond, IrBlkRef then, IrBlkRef otherwise, IrBlkRef next)
{
    const bool on = then != next;
    const uint32_t label = find_or_add_label(s, on ? then : otherwise);

    s->first_inner_label = (uint32_t)s->out->label.n;
    emit_conditional_jump(s, cond, on, label);
    if (on)
        select_jmp(s, otherwise, next);
}

// Emits the end of a block. A branch on a constant becomes an unconditional jump.
static void select_jump(BcSelect *s, const IrJump *j, IrBlkRef next)
{
    const IrIns *cond = j->kind == IR_BR ? bc_ins(s, j->cond) : NULL;

    if (j->span.src)
        s->span = j->span;
    if (cond && cond->op == IR_const) {
        select_jmp(s, s->final_target[cond->bits ? j->then : j->otherwise], next);
        return;
    }
    switch (j->kind) {
    case IR_RET: case IR_GOTO: emit_exit(s, j); break;
    case IR_JMP: select_jmp(s, s->final_target[j->then], next); break;
    case IR_BR: select_br(s, j->cond, s->final_target[j->then], s->final_target[j->otherwise], next); break;
    }
}

// Emits a block. `next`: the block that follows in the code.
static void select_block(BcSelect *s, IrBlkRef block, IrBlkRef next)
{
    const IrBlk *b = &s->f->blk.at[block];

    bc_analyse_block(s, block);
    bc_label_place(s, s->label[block]);
    s->x.value = IR_NONE;
    for (size_t p = 0; p < b->ins.n; p++)
        bc_select_ins(s, b->ins.at[p]);
    select_jump(s, &b->jump, next);
}

// ---- the order of blocks ----

// Sets the label and the final target of each block.  Returns, by block, whether it is emitted: block 0, and each other block that is reachable
// and does more than jump or end the function.
static bool *find_emitted_blocks(BcSelect *s)
{
    const IrFn *f = s->f;
    bool *kept = ir_find_reachable(s->arena, f);

    s->label = ARENA_ARRAY(s->arena, uint32_t, f->blk.n);
    s->final_target = ARENA_ARRAY(s->arena, IrBlkRef, f->blk.n);
    for (size_t b = 0; b < f->blk.n; b++)
        s->label[b] = bc_label_new(s);
    for (size_t b = f->blk.n; b-- > 0;) {
        const IrBlk *blk = &f->blk.at[b];
        const bool jumps = blk->ins.n == 0 && blk->jump.kind == IR_JMP;
        s->final_target[b] = jumps ? s->final_target[blk->jump.then] : (IrBlkRef)b;
        kept[b] = kept[b] && (b == 0 || (!jumps && !only_ends_function(blk)));
    }
    return kept;
}

static uint32_t *count_block_entries(BcSelect *s, const bool *kept)  // by block: edges from emitted blocks
{
    uint32_t *n = ARENA_ARRAY(s->arena, uint32_t, s->f->blk.n);

    for (size_t b = 0; b < s->f->blk.n; b++) {
        const IrJump *j = &s->f->blk.at[b].jump;
        if (kept[b] && (j->kind == IR_JMP || j->kind == IR_BR))
            n[s->final_target[j->then]]++;
        if (kept[b] && j->kind == IR_BR)
            n[s->final_target[j->otherwise]]++;
    }
    return n;
}

// Marks the blocks to lay out after all others: a block that ends the function and whose only incoming edge is from a branch, if the other
// target of the branch is emitted, too.
static void mark_blocks_laid_out_last(BcSelect *s, const bool *kept, bool *laid_out_last)
{
    const uint32_t *entries = count_block_entries(s, kept);
    const IrBlk *blk = s->f->blk.at;

    for (size_t b = 0; b < s->f->blk.n; b++) {
        const IrJump *j = &blk[b].jump;
        IrBlkRef then, otherwise;
        if (!kept[b] || j->kind != IR_BR)
            continue;
        then = s->final_target[j->then];
        otherwise = s->final_target[j->otherwise];
        if (kept[then] && ends_function(&blk[then]) && entries[then] == 1)
            laid_out_last[then] = kept[otherwise];
        else if (kept[otherwise] && ends_function(&blk[otherwise]) && entries[otherwise] == 1)
            laid_out_last[otherwise] = kept[then];
    }
}

// Returns the kept blocks in the order in which they are emitted; *n is their number.
static IrBlkRef *order_blocks(BcSelect *s, const bool *kept, uint32_t *n)
{
    IrBlkRef *order = ARENA_ARRAY(s->arena, IrBlkRef, s->f->blk.n + 1);
    bool *laid_out_last = ARENA_ARRAY(s->arena, bool, s->f->blk.n);

    *n = 0;
    mark_blocks_laid_out_last(s, kept, laid_out_last);
    for (int side = 0; side < 2; side++)
        for (IrBlkRef b = 0; b < s->f->blk.n; b++)
            if (kept[b] && laid_out_last[b] == (side == 1))
                order[(*n)++] = b;
    order[*n] = IR_NONE;
    return order;
}

// ---- functions ----

void bc_select_function(BcSelect *s, const IrFn *f, BcFn *out)
{
    const IrBlkRef *order;
    uint32_t n;

    s->f = f;
    s->out = out;
    s->fn++;
    s->exits.n = 0;
    s->straight_start = 0;
    while (s->values.cap < f->ins.n)
        vec_reserve(s->arena, (void **)&s->values.at, &s->values.cap, sizeof *s->values.at);
    s->value = s->values.at;
    if (f->ins.n)
        memset(s->value, 0, f->ins.n * sizeof *s->value);
    out->ins.cap = f->ins.n;                                     // bytecode usually has no more instructions than the IR
    out->ins.at = arena_alloc_unzeroed(s->arena, out->ins.cap * sizeof *out->ins.at);
    order = order_blocks(s, find_emitted_blocks(s), &n);
    bc_forget_registers(s);
    for (uint32_t i = 0; i < n; i++)
        select_block(s, order[i], order[i + 1]);
    for (size_t i = 0; i < s->exits.n; i++)
        place_exit(s, s->exits.at[i]);
}

// Whether a function only returns.  It then needs no code.
static bool does_nothing(const IrFn *f) { return f->blk.at[0].ins.n == 0 && f->blk.at[0].jump.kind == IR_RET; }

// Numbers the windows in the order in which the machine's sample function samples them.
static void assign_window_numbers(BcSelect *s)
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

static BcRef *new_empty_refs(Arena *arena, size_t n)
{
    BcRef *of = ARENA_ARRAY(arena, BcRef, n);

    memset(of, 0xff, n * sizeof *of);
    return of;
}

void bc_select_machine(Arena *arena, BcMachine *out, const IrMachine *m)
{
    BcSelect s;

    memset(out, 0, sizeof *out);
    memset(&s, 0, sizeof s);
    out->ir = m;
    s.arena = arena;
    s.m = out;
    s.store_at = ARENA_ARRAY(arena, uint32_t, m->var.n);
    s.store_in = ARENA_ARRAY(arena, uint32_t, m->var.n);
    s.exit = ARENA_ARRAY(arena, BcExit, m->state.n + 1);
    out->of_var = new_empty_refs(arena, m->var.n);
    out->of_stat = new_empty_refs(arena, m->window.n * SM_STAT_COUNT);
    out->fns = 1 + 3 * m->state.n;
    out->fn = ARENA_ARRAY(arena, BcFn, out->fns);
    assign_window_numbers(&s);
    if (m->sample)
        bc_select_function(&s, m->sample, &out->fn[0]);
    for (size_t i = 0; i < m->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (m->state.at[i].block[b] && !does_nothing(m->state.at[i].block[b]))
                bc_select_function(&s, m->state.at[i].block[b], &out->fn[1 + 3 * i + (size_t)b]);
}
