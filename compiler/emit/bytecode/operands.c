// SPDX-License-Identifier: Apache-2.0
// Operands of instructions: variables, statistics, constants, and slots for intermediate results.
#include <string.h>

#include "compiler/emit/bytecode/bc_select.h"
#include "stdlib/convert.h"

static BcRef add_operand(BcSelect *s, BcOperandKind kind, uint32_t type)
{
    BcOperand o;

    memset(&o, 0, sizeof o);
    o.kind = kind;
    o.type = type;
    vec_push(s->arena, &s->m->operand, o);
    return (BcRef)(s->m->operand.n - 1);
}

// Returns the operand for a variable. Creates the operand at the first use of the variable.
BcRef bc_var_operand(BcSelect *s, uint32_t var)
{
    BcRef *r = &s->m->of_var[var];

    if (*r == BC_NONE) {
        *r = add_operand(s, BC_VAR, s->m->ir->var.at[var].type);
        s->m->operand.at[*r].var = var;
    }
    return *r;
}

// Returns the operand for a statistic of a rolling window. Creates the operand at the first use of the statistic.
BcRef bc_stat_operand(BcSelect *s, uint32_t window, SmStat stat)
{
    BcRef *r = &s->m->of_stat[window * SM_STAT_COUNT + stat];

    if (*r == BC_NONE) {
        *r = add_operand(s, BC_STAT, SM_F64);
        s->m->operand.at[*r].var = window;
        s->m->operand.at[*r].index = stat;
    }
    return *r;
}

uint32_t bc_type_of(const BcSelect *s, BcRef r) { return s->m->operand.at[r].type; }

// ---- numbers ----

// Sets *n to x if x is a whole number that an instruction can encode.  Returns false if not.
bool bc_try_whole(SmF64 x, int32_t *n)
{
    if (!sm_le(sm_from_i32(-(int32_t)SMVM_VARINT_END), x) || !sm_lt(x, sm_from_i32((int32_t)SMVM_VARINT_END)))
        return false;
    *n = sm_to_i32(x);
    return sm_bits(sm_from_i32(*n)) == sm_bits(x);               // a whole number and not -0
}

// Whether an F32 constant represents x exactly; true for NaN.
bool bc_is_f32(SmF64 x) { return sm_is_nan(x) || sm_bits(sm_from_f32(sm_round_f32(x))) == sm_bits(x); }

static void add_to_const_table(BcSelect *s, BcOperand *o)          // adds constant o to the table of F32s or F64s, unless instructions can encode it
{
    const SmF64 x = sm_from_bits(o->bits);
    int32_t n;

    if (bc_try_whole(x, &n))
        return;
    if (bc_is_f32(x)) {
        o->index = (uint32_t)s->m->f32s.n;
        vec_push(s->arena, &s->m->f32s, sm_is_nan(x) ? 0x7fc00000u : sm_f32_bits(sm_round_f32(x)));
    } else {
        o->index = (uint32_t)s->m->f64s.n;
        vec_push(s->arena, &s->m->f64s, o->bits);
    }
}

// Returns the index of the constant in the hash table, or of the free entry where it would be added.
static size_t find_const_slot(const BcMachine *m, const BcRef *table, size_t cap, uint64_t bits)
{
    const uint64_t folded = bits ^ bits >> 32;       // the low half of most F64 is 0
    size_t i = (size_t)(folded * UINT64_C(0x9e3779b97f4a7c15) >> 32) & (cap - 1);

    while (table[i] != BC_NONE && m->operand.at[table[i]].bits != bits)
        i = (i + 1) & (cap - 1);
    return i;
}

// Doubles the hash table of constants.
static void grow_consts(BcSelect *s)
{
    BcMachine *m = s->m;
    size_t cap = m->const_cap ? m->const_cap * 2 : 64;
    BcRef *table = ARENA_ARRAY(s->arena, BcRef, cap);

    memset(table, 0xff, cap * sizeof *table);
    for (size_t i = 0; i < m->const_cap; i++)
        if (m->const_slot[i] != BC_NONE)
            table[find_const_slot(m, table, cap, m->operand.at[m->const_slot[i]].bits)] = m->const_slot[i];
    m->const_slot = table;
    m->const_cap = cap;
}

// Returns the operand for constant x. Constants with equal bits share one.
BcRef bc_const_operand(BcSelect *s, SmF64 x)
{
    const uint64_t bits = sm_bits(x);
    size_t slot;

    if (s->m->consts * 2 >= s->m->const_cap)
        grow_consts(s);
    slot = find_const_slot(s->m, s->m->const_slot, s->m->const_cap, bits);
    if (s->m->const_slot[slot] == BC_NONE) {
        BcRef r = add_operand(s, BC_CONST, SM_F64);
        s->m->operand.at[r].bits = bits;
        add_to_const_table(s, &s->m->operand.at[r]);
        s->m->const_slot[slot] = r;
        s->m->consts++;
    }
    return s->m->const_slot[slot];
}

BcRef bc_operand_of(BcSelect *s, const IrIns *i)
{
    return i->op == IR_const ? bc_const_operand(s, bc_const_value(i)) : bc_var_operand(s, i->var);
}

// ---- slots ----

// Returns a temporary slot of a pool: a free one if the pool has one, else a new one.
BcRef bc_slot_alloc(BcSelect *s, uint32_t pool)
{
    BcRef r;

    if (s->free[pool].n > 0)
        return s->free[pool].at[--s->free[pool].n];
    r = add_operand(s, BC_SLOT, pool);
    s->m->operand.at[r].index = s->m->slots[pool]++;
    return r;
}

// Returns a slot to its pool; other operands are ignored.
void bc_slot_free(BcSelect *s, BcRef r)
{
    const BcOperand *o = &s->m->operand.at[r];

    if (o->kind == BC_SLOT)
        vec_push(s->arena, &s->free[o->type], r);
}
