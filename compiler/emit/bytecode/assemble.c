// SPDX-License-Identifier: Apache-2.0
// Places locals, numbers operands and turns instructions into bytes.
#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/emit/bytecode/bytecode.h"
#include "stdlib/convert.h"

// ---- numbers ----

void bc_varint(Buf *out, uint32_t v)
{
    if (v < SMVM_VARINT_1) {
        buf_char(out, (char)v);
        return;
    }
    if (v < SMVM_VARINT_MID) {
        v -= SMVM_VARINT_1;
        buf_char(out, (char)(SMVM_VARINT_1 + (v >> 7)));
    } else {
        v -= SMVM_VARINT_MID;
        buf_char(out, (char)(SMVM_VARINT_2 + (v >> 21)));
        buf_char(out, (char)(v >> 14 & 0x7f));
        buf_char(out, (char)(v >> 7 & 0x7f));
    }
    buf_char(out, (char)(v & 0x7f));
}

static uint32_t varint_size(uint32_t v) { return v < SMVM_VARINT_1 ? 1 : v < SMVM_VARINT_MID ? 2 : 4; }

// ---- locals: the largest types first, so that no byte is lost to alignment ----

static void place_locals(Arena *arena, BcMachine *m)
{
    const IrMachine *ir = m->ir;

    m->local_at = ARENA_ARRAY(arena, uint32_t, ir->var.n);
    for (uint32_t bytes = 8; bytes > 0; bytes /= 2) {
        for (size_t v = 0; v < ir->var.n; v++)
            if (ir->var.at[v].space == IR_LOCAL && sm_type_info[ir->var.at[v].type].bytes == bytes) {
                m->local_at[v] = m->locals;
                m->locals += bytes;
            }
        for (size_t t = 0; t < SM_TYPE_COUNT; t++)
            if (sm_type_info[t].bytes == bytes) {
                m->scratch_at[t] = m->locals;
                m->locals += m->scratches[t] * bytes;
            }
    }
}

// ---- the operand table ----

static uint32_t entry(uint32_t kind, uint32_t payload)
{
    return payload < (uint32_t)SMVM_PAYLOADS ? payload << SMVM_KIND_BITS | kind : UINT32_MAX;
}

uint32_t bc_var_entry(const BcMachine *m, uint32_t var)
{
    const IrVar *v = &m->ir->var.at[var];
    uint32_t bytes = sm_type_info[v->type].bytes;

    switch (v->space) {
    case IR_ELEMENT: return entry(SMVM_K_ELEMENT + (uint32_t)v->type, v->offset / bytes);
    case IR_LOCAL: return entry(SMVM_K_LOCAL + (uint32_t)v->type, m->local_at[var] / bytes);
    case IR_TIME: return entry(SMVM_K_TIME, 0);
    }
    return UINT32_MAX;
}

static bool is_small(SmF64 x)
{
    return sm_le(sm_from_i32(SMVM_INT_LEAST), x) && sm_le(x, sm_from_i32(SMVM_INT_MOST))
        && sm_bits(sm_from_i32(sm_to_i32(x))) == sm_bits(x);     // whole, and not -0
}

static bool is_f32(SmF64 x) { return sm_is_nan(x) || sm_bits(sm_from_f32(sm_round_f32(x))) == sm_bits(x); }

static uint32_t const_entry(const BcOperand *o)                  // its index among the constants is known already
{
    SmF64 x = sm_from_bits(o->bits);

    if (is_small(x))
        return entry(SMVM_K_INT, (uint32_t)sm_to_i32(x) & ((uint32_t)SMVM_PAYLOADS - 1u));
    return entry(is_f32(x) ? SMVM_K_F32 : SMVM_K_F64, o->index);
}

uint32_t bc_operand_entry(const BcMachine *m, const BcOperand *o)
{
    switch (o->kind) {
    case BC_VAR: return bc_var_entry(m, o->var);
    case BC_SCRATCH: return entry(SMVM_K_LOCAL + (uint32_t)o->type, m->scratch_at[o->type] / sm_type_info[o->type].bytes + o->index);
    case BC_TEMP: return entry(SMVM_K_TEMP, o->index);
    case BC_ACC: return entry(SMVM_K_ACC, o->index);
    case BC_CONST: return const_entry(o);
    }
    return UINT32_MAX;
}

static void add_constant(Arena *arena, BcMachine *m, BcOperand *o)
{
    SmF64 x = sm_from_bits(o->bits);

    if (is_small(x))
        return;
    if (is_f32(x)) {
        o->index = (uint32_t)m->f32s.n;
        vec_push(arena, &m->f32s, sm_is_nan(x) ? 0x7fc00000u : sm_f32_bits(sm_round_f32(x)));
    } else {
        o->index = (uint32_t)m->f64s.n;
        vec_push(arena, &m->f64s, o->bits);
    }
}

// ---- their order: outputs, G, S, the rest; what is used most gets the numbers that take one byte ----

// Sorts n keys; `other` is as long.  A merge sort: the C library's may ask for memory.
static void sort(uint64_t *key, uint64_t *other, size_t n)
{
    for (size_t width = 1; width < n; width *= 2) {
        for (size_t lo = 0; lo < n; lo += 2 * width) {
            size_t mid = lo + width < n ? lo + width : n, hi = lo + 2 * width < n ? lo + 2 * width : n;
            size_t a = lo, b = mid;
            for (size_t i = lo; i < hi; i++)
                other[i] = a < mid && (b >= hi || key[a] <= key[b]) ? key[a++] : key[b++];
        }
        memcpy(key, other, n * sizeof *key);
    }
}

static bool is_output(const BcMachine *m, const BcOperand *o)
{
    return o->kind == BC_VAR && o->stored && m->ir->var.at[o->var].space == IR_ELEMENT;
}

static uint64_t rank(const BcMachine *m, BcRef r)                // outputs, then G, then S, then the rest, each by falling use
{
    const BcOperand *o = &m->operand.at[r];
    uint64_t group = 3;

    if (is_output(m, o))
        group = 0;
    else if (o->kind == BC_VAR && o->var == m->ir->g)
        group = 1;
    else if (o->kind == BC_VAR && o->var == m->ir->s)
        group = 2;
    return group << 62 | (uint64_t)(UINT32_MAX / 4 - (o->uses < UINT32_MAX / 4 ? o->uses : UINT32_MAX / 4)) << 32 | r;
}

static const char *order_operands(Arena *arena, BcMachine *m)
{
    size_t n = m->operand.n;
    uint64_t *key = ARENA_ARRAY(arena, uint64_t, n), *other = ARENA_ARRAY(arena, uint64_t, n);

    for (size_t i = 0; i < n; i++)
        key[i] = rank(m, (BcRef)i);
    sort(key, other, n);
    m->order = ARENA_ARRAY(arena, BcRef, n);
    for (size_t i = 0; i < n; i++) {
        BcOperand *o = &m->operand.at[key[i] & UINT32_MAX];
        m->order[i] = (BcRef)(key[i] & UINT32_MAX);
        o->number = (uint32_t)i;
        m->outputs += is_output(m, o);
        if (o->kind == BC_CONST)
            add_constant(arena, m, o);
    }
    return n < SMVM_VARINT_END ? NULL : "variables and numbers";
}

const char *bc_number(Arena *arena, BcMachine *m)
{
    const char *what;

    if (m->ir->var.n > SMVM_IMAGE_MAX || m->temps > SMVM_IMAGE_MAX)
        return "variables";
    place_locals(arena, m);
    what = order_operands(arena, m);
    for (size_t i = 0; !what && i < m->operand.n; i++)
        if (bc_operand_entry(m, &m->operand.at[i]) == UINT32_MAX)
            what = m->operand.at[i].kind == BC_CONST ? "numbers" : m->operand.at[i].kind == BC_VAR ? "bytes of elements or locals" : "temporary values";
    for (uint32_t v = 0; !what && v < m->ir->var.n; v++)
        if (bc_var_entry(m, v) == UINT32_MAX)
            what = "bytes of elements or locals";
    return what;
}

// ---- bytes ----

static uint32_t number_of(const BcMachine *m, BcRef r) { return m->operand.at[r].number; }

// The instruction's bytes but for a jump's distance.
static uint32_t size_of(const BcMachine *m, const BcIns *i)
{
    uint8_t shape = smvm_shape(i->op);
    uint32_t n = 1;

    n += shape & SMVM_SHAPE_D ? varint_size(number_of(m, i->d)) : 0;
    n += shape & SMVM_SHAPE_W ? varint_size(i->w) : 0;
    n += shape & SMVM_SHAPE_X ? varint_size(number_of(m, i->x)) : 0;
    n += shape & SMVM_SHAPE_Y ? varint_size(number_of(m, i->y)) : 0;
    n += shape & SMVM_SHAPE_S ? varint_size(i->to) : 0;
    return n;
}

static void put_ins(const BcMachine *m, const BcIns *i, uint32_t distance, Buf *out)
{
    uint8_t shape = smvm_shape(i->op);

    buf_char(out, (char)i->op);
    if (shape & SMVM_SHAPE_D)
        bc_varint(out, number_of(m, i->d));
    if (shape & SMVM_SHAPE_W)
        bc_varint(out, i->w);
    if (shape & SMVM_SHAPE_X)
        bc_varint(out, number_of(m, i->x));
    if (shape & SMVM_SHAPE_Y)
        bc_varint(out, number_of(m, i->y));
    if (shape & SMVM_SHAPE_S)
        bc_varint(out, i->to);
    if (shape & SMVM_SHAPE_J)
        bc_varint(out, distance);
}

// Jumps only go forward, so sizes are known from the end backwards and each distance gets the shortest form at once.
void bc_assemble(Arena *arena, const BcMachine *m, BcFn *f, Buf *out, bool *ok)
{
    size_t n = f->ins.n;
    uint32_t *to_end = ARENA_ARRAY(arena, uint32_t, n + 1);      // from the start of an instruction
    uint32_t *distance = ARENA_ARRAY(arena, uint32_t, n);

    for (size_t i = n; i-- > 0;) {
        const BcIns *ins = &f->ins.at[i];
        to_end[i] = to_end[i + 1] + size_of(m, ins);
        if (smvm_shape(ins->op) & SMVM_SHAPE_J) {
            distance[i] = to_end[i + 1] - to_end[f->label.at[ins->to]];
            to_end[i] += varint_size(distance[i]);
        }
        if (to_end[i] > SMVM_IMAGE_MAX) {
            *ok = false;
            return;
        }
    }
    for (size_t i = 0; i < n; i++) {
        f->ins.at[i].at = to_end[0] - to_end[i];
        put_ins(m, &f->ins.at[i], distance[i], out);
    }
    f->size = to_end[0];
}
