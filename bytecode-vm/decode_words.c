// SPDX-License-Identifier: Apache-2.0
// The words of the decoded form.
#include <string.h>

#include "bytecode-vm/decode.h"

// ---- words ----

SmvmWord *smvm_word(DecodeState *d) { return d->out != NULL ? &d->out->code[d->words] : NULL; }

void smvm_emit_op(DecodeState *d, unsigned op)
{
    if (d->out != NULL && d->label != NULL)
        smvm_word(d)->go = d->label[op];
    else if (d->out != NULL)
        smvm_word(d)->u = op;
    d->words++;
}

void smvm_emit_u(DecodeState *d, uint64_t u)
{
    if (d->out != NULL)
        smvm_word(d)->u = u;
    d->words++;
}

static void emit_f(DecodeState *d, SmF64 f)
{
    if (d->out != NULL)
        smvm_word(d)->f = f;
    d->words++;
}

static void *value_address(const DecodeState *d, const DecodedValue *v)
{
    switch (v->is) {
    case A_LOCAL: return d->out->parts.local + v->offset;
    case AN_ELEMENT: return (uint8_t *)d->out->sv + v->offset;
    default: return &d->out->t;
    }
}

void smvm_emit_value(DecodeState *d, const DecodedValue *v)
{
    if (v->kind == FAST_C) {
        emit_f(d, v->c);
        return;
    }
    if (d->out != NULL && v->kind <= FAST_RAW)
        smvm_word(d)->p = value_address(d, v);
    d->words++;
}

// The target of a jump.  Until the whole function is decoded, the word contains the index of the previous jump and the target's
// offset in the function, 32 bits each.
void smvm_emit_target(DecodeState *d, uint32_t target)
{
    uint64_t before = d->jumps;

    d->jumps = d->words;
    smvm_emit_u(d, before << 32 | target);
}

// ---- values ----

DecodedValue smvm_in_memory(unsigned kind, unsigned is, uint32_t offset)
{
    DecodedValue v;

    memset(&v, 0, sizeof v);
    v.kind = (uint8_t)kind;
    v.is = is;
    v.offset = offset;
    return v;
}

DecodedValue smvm_constant(SmF64 c)
{
    DecodedValue v = smvm_in_memory(FAST_C, A_LOCAL, 0);

    v.c = c;
    return v;
}

bool smvm_is_whole(SmF64 c, int64_t limit, int64_t *v)
{
    if (!sm_le(sm_from_i64(-limit), c) || !sm_le(c, sm_from_i64(limit)))
        return false;
    *v = sm_to_i64(c);
    return sm_eq(sm_from_i64(*v), c);
}

// ---- families ----

void smvm_emit_load(DecodeState *d, const DecodedValue *x)
{
    if (is_in_f(x))
        return;
    smvm_emit_op(d, is_constant(x) ? FAST_LD_C_OP : (unsigned)FAST_LD_I8_OP + x->kind);
    smvm_emit_value(d, x);
}

void smvm_emit_with(DecodeState *d, FastOp family, const DecodedValue *y)
{
    smvm_emit_op(d, (unsigned)family + y->kind);
    smvm_emit_value(d, y);
}

void smvm_emit_pair(DecodeState *d, FastOp family, const DecodedValue *x, const DecodedValue *y)
{
    smvm_emit_op(d, (unsigned)family + x->kind);
    smvm_emit_value(d, x);
    smvm_emit_value(d, y);
}
