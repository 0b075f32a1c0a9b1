// SPDX-License-Identifier: Apache-2.0
// Assigns offsets to locals, and encodes instructions as bytes.
#include "bytecode-vm/image.h"
#include "compiler/emit/bytecode/bytecode.h"
#include "stdlib/convert.h"

// ---- numbers ----

enum { VARINT_BYTES_MAX = 4 };

// Encodes v as a varint that ends just before `end`.  Returns a pointer to its first byte.
static uint8_t *write_varint_before(uint8_t *end, uint32_t v)
{
    if (v < SMVM_VARINT_1) {
        *--end = (uint8_t)v;
        return end;
    }
    if (v < SMVM_VARINT_MID) {
        v -= SMVM_VARINT_1;
        *--end = (uint8_t)(v & 0x7f);
        *--end = (uint8_t)(SMVM_VARINT_1 + (v >> 7));
        return end;
    }
    v -= SMVM_VARINT_MID;
    *--end = (uint8_t)(v & 0x7f);
    *--end = (uint8_t)(v >> 7 & 0x7f);
    *--end = (uint8_t)(v >> 14 & 0x7f);
    *--end = (uint8_t)(SMVM_VARINT_2 + (v >> 21));
    return end;
}

// Appends v as a varint, one to four bytes (docs/bytecode.md).
void bc_write_varint(Buf *out, uint32_t v)
{
    uint8_t bytes[VARINT_BYTES_MAX], *const end = bytes + sizeof bytes, *const from = write_varint_before(end, v);

    buf_put(out, from, (size_t)(end - from));
}

// Writes the low 24 bits of v, low byte first.
void bc_write_u24(Buf *out, uint32_t v)
{
    for (int i = 0; i < 3; i++)
        buf_char(out, (char)(v >> 8 * i & 0xff));
}

// ---- offsets of locals: variables of the largest types first, so that alignment needs no padding ----

static uint32_t bytes_of_pool_type(uint32_t pool) { return pool == BC_RAW ? 8 : sm_type_info[pool].bytes; }

// Assigns the first offsets to the parameters, so that they form one contiguous range of the locals, to which no instruction writes.
static void assign_parameter_offsets(BcMachine *m)
{
    const IrMachine *ir = m->ir;

    for (uint32_t bytes = 8; bytes > 0; bytes /= 2)
        for (size_t v = 0; v < ir->var.n; v++)
            if (ir->var.at[v].parameter && sm_type_info[ir->var.at[v].type].bytes == bytes) {
                m->local_at[v] = m->locals;
                m->locals += bytes;
            }
    m->locals = (m->locals + 7) / 8 * 8;
}

// Assigns byte offsets: parameters first, then the other locals and the temporary slots, from the widest type to the narrowest.
static void assign_local_offsets(Arena *arena, BcMachine *m)
{
    const IrMachine *ir = m->ir;

    m->local_at = ARENA_ARRAY(arena, uint32_t, ir->var.n);
    assign_parameter_offsets(m);
    for (uint32_t bytes = 8; bytes > 0; bytes /= 2) {
        for (size_t v = 0; v < ir->var.n; v++)
            if (ir->var.at[v].space == IR_LOCAL && !ir->var.at[v].parameter && sm_type_info[ir->var.at[v].type].bytes == bytes) {
                m->local_at[v] = m->locals;
                m->locals += bytes;
            }
        for (uint32_t t = 0; t < BC_POOLS; t++)
            if (bytes_of_pool_type(t) == bytes) {
                m->slot_at[t] = m->locals;
                m->locals += m->slots[t] * bytes;
            }
    }
}

static uint32_t offset_of(const BcMachine *m, uint32_t var)      // the variable's offset, in units of its type's size; 0 for T, which is not stored
{
    const IrVar *v = &m->ir->var.at[var];

    return (v->space == IR_ELEMENT ? v->offset : v->space == IR_LOCAL ? m->local_at[var] : 0) >> SMVM_TYPE_SHIFT(v->type);
}

// Packs an offset and a type into a location, three bytes of an image.
uint32_t bc_pack_offset(uint32_t offset, uint32_t type) { return (offset & 0xffff) | type << 16 | (offset >> 16 & 0xf) << 20; }

// Returns the location of a variable; UINT32_MAX if its offset is too large for the format.
uint32_t bc_pack_location(const BcMachine *m, uint32_t var)
{
    const uint32_t at = offset_of(m, var);

    return at < SMVM_LOCATION_OFFSETS ? bc_pack_offset(at, (uint32_t)m->ir->var.at[var].type) : UINT32_MAX;
}

// Assigns offsets to locals and slots.  Returns NULL, or the name of the quantity that exceeds a limit of the image format.
const char *bc_lay_out_locals(Arena *arena, BcMachine *m)
{
    if (m->ir->var.n > SMVM_IMAGE_MAX || m->operand.n > SMVM_IMAGE_MAX)
        return "variables";
    assign_local_offsets(arena, m);
    if (m->locals >= SMVM_VARINT_END)
        return "bytes of elements or locals";
    for (uint32_t v = 0; v < m->ir->var.n; v++)
        if (bc_pack_location(m, v) == UINT32_MAX)
            return "bytes of elements or locals";
    return NULL;
}

// ---- instructions ----

// A function is encoded from its end to its start.  Jumps only go forward, so their targets are already encoded and each distance gets its
// shortest encoding at once.  Each write_… function below writes one instruction in the bytes just before `end`, and returns a pointer to its
// first byte.  `op` is SMVM_ldx_local, SMVM_ldy_local or SMVM_st_local: the first opcode of its group.

// The write_… functions write an instruction before `end`, from its last byte to its first, and return the address of its opcode.
static uint8_t *write_number(uint8_t *end, uint32_t op, uint32_t n)
{
    end = write_varint_before(end, n);
    *--end = (uint8_t)op;
    return end;
}

// Writes, in front of `end`, a load of constant o into X or Y (`op`: the register's load of a local); returns its first byte.
static uint8_t *write_const(uint8_t *end, uint32_t op, const BcOperand *o)
{
    const SmF64 x = sm_from_bits(o->bits);
    int32_t n;

    op -= SMVM_ldx_local;             // 0 for a load of X; for a load of Y, the distance between the two groups of opcodes
    if (bc_try_whole(x, &n))
        return n < 0 ? write_number(end, op + SMVM_ldx_minus, (uint32_t)(-1 - n)) : write_number(end, op + SMVM_ldx_plus, (uint32_t)n);
    return write_number(end, op + (bc_is_f32(x) ? SMVM_ldx_f32 : SMVM_ldx_f64), o->index);
}

// Writes, in front of `end`, a load or store (`op`) of a state-vector element or local; returns its first byte.
static uint8_t *write_var(uint8_t *end, const BcMachine *m, uint32_t op, const BcOperand *o)
{
    switch (m->ir->var.at[o->var].space) {
    case IR_ELEMENT: return write_number(end, op - SMVM_ldx_local + SMVM_ldx_elem + o->type, offset_of(m, o->var));
    case IR_LOCAL: return write_number(end, op + o->type, offset_of(m, o->var));
    case IR_TIME: break;
    }
    *--end = (uint8_t)(op - SMVM_ldx_local + SMVM_ldx_time);
    return end;
}

// Writes, in front of `end`, the load or store `op` with operand o of any kind; returns its first byte.
static uint8_t *write_load_or_store(uint8_t *end, const BcMachine *m, uint32_t op, const BcOperand *o)
{
    switch (o->kind) {
    case BC_VAR: return write_var(end, m, op, o);
    case BC_SLOT: return write_number(end, op + o->type, m->slot_at[o->type] / bytes_of_pool_type(o->type) + o->index);
    case BC_STAT: return write_number(write_varint_before(end, m->window_number[o->var]), op - SMVM_ldx_local + SMVM_stat, o->index);
    case BC_CONST: break;
    }
    return write_const(end, op, o);
}

// Writes a store of X in front of `end`. A state-vector element that is an output is named by its output number, counted from 1.
static uint8_t *write_store(uint8_t *end, const BcMachine *m, const BcOperand *o)
{
    return o->output ? write_number(end, SMVM_out, o->output - 1) : write_load_or_store(end, m, SMVM_st_local, o);
}

// Distance from the first byte of instruction i to the function's end.
static uint32_t distance_to_end(const BcFn *f, size_t i) { return i < f->ins.n ? f->ins.at[i].at : 0; }

// Writes an instruction that is neither a load nor a store: the opcode, then its immediate operand and its jump distance if it has them.
static uint8_t *write_plain(uint8_t *end, const BcFn *f, size_t i)
{
    const BcIns *ins = &f->ins.at[i];
    const uint32_t shape = smvm_shape(ins->op);

    if (shape & SMVM_SHAPE_J)
        end = write_varint_before(end, distance_to_end(f, i + 1) - distance_to_end(f, f->label.at[ins->to].at));
    if (shape & SMVM_SHAPE_FOLLOWS & ~(uint32_t)SMVM_SHAPE_J)
        end = write_varint_before(end, ins->n);
    *--end = ins->op;
    return end;
}

// Writes instruction i before `end`, and returns the address of its opcode.
static uint8_t *write_instruction(uint8_t *end, const BcMachine *m, const BcFn *f, size_t i)
{
    const BcIns *ins = &f->ins.at[i];

    switch (ins->op) {
    case SMVM_ldx_local: case SMVM_ldy_local: return write_load_or_store(end, m, ins->op, &m->operand.at[ins->operand_ref]);
    case SMVM_st_local: return write_store(end, m, &m->operand.at[ins->operand_ref]);
    default: return write_plain(end, f, i);
    }
}

// Appends the function's bytes; sets *ok to false when it is too long.
void bc_assemble(Arena *arena, const BcMachine *m, BcFn *f, Buf *out, bool *ok)
{
    enum { MOST = 1 + 3 * VARINT_BYTES_MAX };                    // the longest instruction, in bytes
    const size_t room = f->ins.n * MOST;
    uint8_t *const end = (uint8_t *)arena_alloc_unzeroed(arena, room) + room, *from = end;

    for (size_t i = f->ins.n; i-- > 0 && *ok;) {
        from = write_instruction(from, m, f, i);
        f->ins.at[i].at = (uint32_t)(end - from);
        *ok = f->ins.at[i].at <= SMVM_IMAGE_MAX;
    }
    f->size = (uint32_t)(end - from);
    for (size_t i = 0; i < f->ins.n; i++)
        f->ins.at[i].at = f->size - f->ins.at[i].at;
    buf_put(out, from, f->size);
}
