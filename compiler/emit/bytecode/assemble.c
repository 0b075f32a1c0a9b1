// SPDX-License-Identifier: Apache-2.0
// Places locals and turns instructions into bytes.
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

void bc_u24(Buf *out, uint32_t v)
{
    for (int i = 0; i < 3; i++)
        buf_char(out, (char)(v >> 8 * i & 0xff));
}

// ---- locals: the largest types first, so that no byte is lost to alignment ----

static uint32_t bytes_of(uint32_t pool) { return pool == BC_RAW ? 8 : sm_type_info[pool].bytes; }

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
        for (uint32_t t = 0; t < BC_POOLS; t++)
            if (bytes_of(t) == bytes) {
                m->slot_at[t] = m->locals;
                m->locals += m->slots[t] * bytes;
            }
    }
}

static uint32_t offset_of(const BcMachine *m, uint32_t var)      // in units of its type
{
    const IrVar *v = &m->ir->var.at[var];

    return (v->space == IR_ELEMENT ? v->offset : v->space == IR_LOCAL ? m->local_at[var] : 0) >> SMVM_TYPE_SHIFT(v->type);
}

uint32_t bc_pack(uint32_t offset, uint32_t type) { return (offset & 0xffff) | type << 16 | (offset >> 16 & 0xf) << 20; }

uint32_t bc_place(const BcMachine *m, uint32_t var)
{
    const uint32_t at = offset_of(m, var);

    return at < SMVM_PLACES ? bc_pack(at, (uint32_t)m->ir->var.at[var].type) : UINT32_MAX;
}

const char *bc_layout(Arena *arena, BcMachine *m)
{
    if (m->ir->var.n > SMVM_IMAGE_MAX || m->operand.n > SMVM_IMAGE_MAX)
        return "variables";
    place_locals(arena, m);
    if (m->locals >= SMVM_VARINT_END)
        return "bytes of elements or locals";
    for (uint32_t v = 0; v < m->ir->var.n; v++)
        if (bc_place(m, v) == UINT32_MAX)
            return "bytes of elements or locals";
    return NULL;
}

// ---- instructions ----

// An instruction as it stands in the image, but for a jump's distance.
typedef struct Code {
    uint8_t op, n;            // how many numbers follow
    uint32_t number[2];
    bool jumps;
} Code;

static Code code_of_const(const BcOperand *o)
{
    int32_t n;

    if (bc_whole(sm_from_bits(o->bits), &n))
        return n < 0 ? (Code){SMVM_ldx_minus, 1, {(uint32_t)(-1 - n), 0}, false} : (Code){SMVM_ldx_plus, 1, {(uint32_t)n, 0}, false};
    return (Code){bc_is_f32(sm_from_bits(o->bits)) ? SMVM_ldx_f32 : SMVM_ldx_f64, 1, {o->index, 0}, false};
}

static Code code_of_var(const BcMachine *m, const BcOperand *o)
{
    switch (m->ir->var.at[o->var].space) {
    case IR_ELEMENT: return (Code){(uint8_t)(SMVM_ldx_elem + o->type), 1, {offset_of(m, o->var), 0}, false};
    case IR_LOCAL: return (Code){(uint8_t)(SMVM_ldx_local + o->type), 1, {offset_of(m, o->var), 0}, false};
    case IR_TIME: break;
    }
    return (Code){SMVM_ldx_time, 0, {0, 0}, false};
}

static Code code_of_load(const BcMachine *m, const BcOperand *o)           // to X
{
    switch (o->kind) {
    case BC_VAR: return code_of_var(m, o);
    case BC_SLOT: return (Code){(uint8_t)(SMVM_ldx_local + o->type), 1, {m->slot_at[o->type] / bytes_of(o->type) + o->index, 0}, false};
    case BC_STAT: return (Code){SMVM_stat, 2, {o->index, m->window_number[o->var]}, false};
    case BC_CONST: break;
    }
    return code_of_const(o);
}

static Code code_of_store(const BcMachine *m, const BcOperand *o)
{
    Code c = code_of_load(m, o);

    if (o->output)
        return (Code){SMVM_out, 1, {o->output - 1, 0}, false};
    c.op = (uint8_t)(c.op - SMVM_ldx_local + SMVM_st_local);
    return c;
}

static Code code_of_other(const BcIns *i)
{
    const uint32_t shape = smvm_shape(i->op);

    return (Code){i->op, (shape & SMVM_SHAPE_FOLLOWS & ~(uint32_t)SMVM_SHAPE_J) != 0, {i->n, 0}, (shape & SMVM_SHAPE_J) != 0};
}

static Code code_of(const BcMachine *m, const BcIns *i)
{
    Code c;

    switch (i->op) {
    case SMVM_ldx_local: return code_of_load(m, &m->operand.at[i->what]);
    case SMVM_ldy_local:
        c = code_of_load(m, &m->operand.at[i->what]);
        c.op = (uint8_t)(c.op - SMVM_ldx_local + SMVM_ldy_local);
        return c;
    case SMVM_st_local: return code_of_store(m, &m->operand.at[i->what]);
    default: return code_of_other(i);
    }
}

static uint32_t size_of(const Code *c)
{
    uint32_t size = 1;

    for (uint8_t k = 0; k < c->n; k++)
        size += varint_size(c->number[k]);
    return size;
}

static void put_code(const Code *c, Buf *out)
{
    buf_char(out, (char)c->op);
    for (uint8_t k = 0; k < c->n; k++)
        bc_varint(out, c->number[k]);
}

// Jumps only go forward, so sizes are known from the end backwards and each distance gets the shortest form at once.
void bc_assemble(Arena *arena, const BcMachine *m, BcFn *f, Buf *out, bool *ok)
{
    const size_t n = f->ins.n;
    uint32_t *to_end = ARENA_ARRAY(arena, uint32_t, n + 1);      // from the start of an instruction
    uint32_t *distance = ARENA_ARRAY(arena, uint32_t, n);
    Code *code = ARENA_ARRAY(arena, Code, n);

    for (size_t i = n; i-- > 0;) {
        const BcIns *ins = &f->ins.at[i];
        code[i] = code_of(m, ins);
        to_end[i] = to_end[i + 1] + size_of(&code[i]);
        if (code[i].jumps) {
            distance[i] = to_end[i + 1] - to_end[f->label.at[ins->to].at];
            to_end[i] += varint_size(distance[i]);
        }
        if (to_end[i] > SMVM_IMAGE_MAX) {
            *ok = false;
            return;
        }
    }
    for (size_t i = 0; i < n; i++) {
        f->ins.at[i].at = to_end[0] - to_end[i];
        put_code(&code[i], out);
        if (code[i].jumps)
            bc_varint(out, distance[i]);
    }
    f->size = to_end[0];
}
