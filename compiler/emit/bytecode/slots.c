// SPDX-License-Identifier: Apache-2.0
// What instructions name: variables, numbers, and slots for what an operation gives; and how they are put out.
#include <string.h>

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

uint32_t bc_label_new(Select *s)
{
    vec_push(s->arena, &s->out->label, UINT32_MAX);
    return (uint32_t)(s->out->label.n - 1);
}

void bc_label_here(Select *s, uint32_t label) { s->out->label.at[label] = (uint32_t)s->out->ins.n; }
