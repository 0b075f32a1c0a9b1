// SPDX-License-Identifier: Apache-2.0
// Appends words to the decoded form: instructions and their operands.  In the pass that only counts words, nothing is stored.
#include <string.h>

#include "bytecode-vm/decode.h"

// ---- words ----

// Returns where the next word is stored; NULL in the pass that counts words.
SmvmWord *smvm_next_word(DecodeState *d) { return d->out != NULL ? &d->out->code[d->words] : NULL; }

// Emits an operation: the address of its code if there are labels, else its number. Without output, only counts the word.
void smvm_emit_op(DecodeState *d, unsigned op)
{
    if (d->out != NULL && d->label != NULL)
        smvm_next_word(d)->go = d->label[op];
    else if (d->out != NULL)
        smvm_next_word(d)->u = op;
    d->words++;
}

// Emits u as one word. Without output, only counts the word.
void smvm_emit_integer(DecodeState *d, uint64_t u)
{
    if (d->out != NULL)
        smvm_next_word(d)->u = u;
    d->words++;
}

// Emits f as one word. Without output, only counts the word.
static void emit_f64(DecodeState *d, SmF64 f)
{
    if (d->out != NULL)
        smvm_next_word(d)->f = f;
    d->words++;
}

static void *operand_address_of(const DecodeState *d, const DecodedValue *v)
{
    switch (v->is) {
    case A_LOCAL: return d->out->parts.local + v->offset;
    case AN_ELEMENT: return (uint8_t *)d->out->sv + v->offset;
    default: return &d->out->t;
    }
}

// Emits the address or constant of v; for F, an unused word.
void smvm_emit_operand(DecodeState *d, const DecodedValue *v)
{
    if (v->kind == FAST_C) {
        emit_f64(d, v->c);
        return;
    }
    if (d->out != NULL && v->kind <= FAST_RAW)
        smvm_next_word(d)->p = operand_address_of(d, v);
    d->words++;
}

// Emits the word for the target of a jump.  Until the whole function is decoded, the word contains the index of the previous such word and the
// target's offset in the function, 32 bits each.
void smvm_emit_target(DecodeState *d, uint32_t target)
{
    uint64_t before = d->jumps;

    d->jumps = d->words;
    smvm_emit_integer(d, before << 32 | target);
}

// ---- values ----

// Returns the operand for a value of type `kind` in memory; `is`: what it is the value of (DecodedValue.is).
DecodedValue smvm_memory_operand(unsigned kind, unsigned is, uint32_t offset)
{
    DecodedValue v;

    memset(&v, 0, sizeof v);
    v.kind = (uint8_t)kind;
    v.is = is;
    v.offset = offset;
    return v;
}

DecodedValue smvm_constant_operand(SmF64 c)
{
    DecodedValue v = smvm_memory_operand(FAST_C, A_LOCAL, 0);

    v.c = c;
    return v;
}

// If c is a whole number in -limit … limit, sets *v to it and returns true.
bool smvm_match_whole(SmF64 c, int64_t limit, int64_t *v)
{
    if (!sm_le(sm_from_i64(-limit), c) || !sm_le(c, sm_from_i64(limit)))
        return false;
    *v = sm_to_i64(c);
    return sm_eq(sm_from_i64(*v), c);
}

// ---- families: the kind of an operand selects the instruction ----

// Emits code that loads x into F; nothing if x is there already.
void smvm_emit_load(DecodeState *d, const DecodedValue *x)
{
    if (is_in_f(x))
        return;
    smvm_emit_op(d, is_constant(x) ? FAST_LD_C_OP : (unsigned)FAST_LD_I8_OP + x->kind);
    smvm_emit_operand(d, x);
}

// Emits the instruction of the family with the operands F and y; the kind of y selects it.
void smvm_emit_operation_on_f(DecodeState *d, FastOp family, const DecodedValue *y)
{
    smvm_emit_op(d, (unsigned)family + y->kind);
    smvm_emit_operand(d, y);
}

// Emits the instruction of the family for x in memory, and y in memory or constant.
void smvm_emit_two_operands(DecodeState *d, FastOp family, const DecodedValue *x, const DecodedValue *y)
{
    smvm_emit_op(d, (unsigned)family + x->kind);
    smvm_emit_operand(d, x);
    smvm_emit_operand(d, y);
}
