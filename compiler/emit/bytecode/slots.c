// SPDX-License-Identifier: Apache-2.0
// What instructions name: variables, numbers, and slots for what an operation gives; and how they are put out.
#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/emit/bytecode/select.h"

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

BcRef bc_var_operand(Select *s, uint32_t var)
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

BcRef bc_const_operand(Select *s, uint64_t bits)
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

// ---- slots ----

BcRef bc_slot_take(Select *s, size_t pool)
{
    BcMachine *m = s->m;
    BcRef r;

    if (s->free[pool].n > 0)
        return s->free[pool].at[--s->free[pool].n];
    r = add_operand(s, pool == BC_TEMPS ? BC_TEMP : BC_SCRATCH, pool == BC_TEMPS ? SM_F64 : (SmType)pool);
    m->operand.at[r].index = pool == BC_TEMPS ? m->temps++ : m->scratches[pool]++;
    return r;
}

void bc_slot_give(Select *s, BcRef r)
{
    const BcOperand *o = &s->m->operand.at[r];

    if (o->kind == BC_TEMP)
        vec_push(s->arena, &s->free[BC_TEMPS], r);
    else if (o->kind == BC_SCRATCH)
        vec_push(s->arena, &s->free[o->type], r);
}

// ---- output ----

BcIns *bc_put(Select *s, uint8_t op)
{
    BcIns i;

    memset(&i, 0, sizeof i);
    i.op = op;
    i.span = s->span;
    i.d = i.x = i.y = BC_NONE;
    vec_push(s->arena, &s->out->ins, i);
    return &s->out->ins.at[s->out->ins.n - 1];
}

BcRef bc_count(Select *s, BcRef r)
{
    s->m->operand.at[r].uses++;
    return r;
}

BcIns *bc_put_dxy(Select *s, uint8_t op, BcRef d, BcRef x, BcRef y)
{
    BcIns *i = bc_put(s, op);

    i->d = bc_count(s, d);
    s->m->operand.at[d].stored = true;
    i->x = bc_count(s, x);
    if (y != BC_NONE)
        i->y = bc_count(s, y);
    return i;
}

// ---- accumulators ----

static BcRef acc_like(Select *s, BcRef slot)          // the one that keeps a number as the slot does
{
    size_t pool = s->m->operand.at[slot].kind == BC_TEMP ? (size_t)BC_TEMPS : (size_t)s->m->operand.at[slot].type;

    if (s->acc[pool] == 0) {
        s->acc[pool] = add_operand(s, BC_ACC, s->m->operand.at[slot].type);
        s->m->operand.at[s->acc[pool]].index = (uint32_t)pool;
    }
    return s->acc[pool];
}

static void rename(Select *s, BcRef *r, BcRef from, BcRef to)
{
    if (*r != from)
        return;
    s->m->operand.at[from].uses--;
    *r = bc_count(s, to);
}

void bc_use_acc(Select *s)
{
    BcIns *ins = s->out->ins.at;
    bool *target = ARENA_ARRAY(s->arena, bool, s->out->ins.n + 1);

    for (size_t i = 0; i < s->out->ins.n; i++)
        if (smvm_shape(ins[i].op) & SMVM_SHAPE_J)
            target[s->out->label.at[ins[i].to]] = true;
    for (size_t i = 0; i + 1 < s->out->ins.n; i++) {
        BcRef d = ins[i].d;
        if (ins[i].reads == 0 || target[i + 1] || ins[i].reads != (uint32_t)(ins[i + 1].x == d) + (uint32_t)(ins[i + 1].y == d))
            continue;
        rename(s, &ins[i].d, d, acc_like(s, d));
        rename(s, &ins[i + 1].x, d, ins[i].d);
        rename(s, &ins[i + 1].y, d, ins[i].d);
    }
}

static bool is_slot(const BcOperand *o) { return o->kind == BC_TEMP || o->kind == BC_SCRATCH; }

// Slots that accumulators have replaced everywhere; the others get new numbers.
void bc_drop_unused(Select *s)
{
    BcMachine *m = s->m;
    BcRef *now = ARENA_ARRAY(s->arena, BcRef, m->operand.n);
    size_t n = 0;

    m->temps = 0;
    memset(m->scratches, 0, sizeof m->scratches);
    for (size_t i = 0; i < m->operand.n; i++) {
        BcOperand *o = &m->operand.at[i];
        if (is_slot(o) && o->uses == 0)
            continue;
        if (is_slot(o))
            o->index = o->kind == BC_TEMP ? m->temps++ : m->scratches[o->type]++;
        now[i] = (BcRef)n;
        m->operand.at[n++] = *o;
    }
    m->operand.n = n;
    for (size_t f = 0; f < m->fns; f++)
        for (size_t i = 0; i < m->fn[f].ins.n; i++) {
            BcIns *ins = &m->fn[f].ins.at[i];
            ins->d = ins->d == BC_NONE ? BC_NONE : now[ins->d];
            ins->x = ins->x == BC_NONE ? BC_NONE : now[ins->x];
            ins->y = ins->y == BC_NONE ? BC_NONE : now[ins->y];
        }
}

// ---- labels ----

uint32_t bc_label_new(Select *s)
{
    vec_push(s->arena, &s->out->label, UINT32_MAX);
    return (uint32_t)(s->out->label.n - 1);
}

void bc_label_here(Select *s, uint32_t label) { s->out->label.at[label] = (uint32_t)s->out->ins.n; }
