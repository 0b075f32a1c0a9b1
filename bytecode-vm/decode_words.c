// SPDX-License-Identifier: Apache-2.0
// The words of the decoded form.
#include <string.h>

#include "bytecode-vm/decode.h"

// ---- words ----

SmvmWord *smvm_word(Decode *d) { return d->out != NULL ? &d->out->code[d->words] : NULL; }

void smvm_put_op(Decode *d, unsigned op)
{
    if (d->out != NULL && d->place != NULL)
        smvm_word(d)->go = d->place[op];
    else if (d->out != NULL)
        smvm_word(d)->u = op;
    d->words++;
}

void smvm_put_u(Decode *d, uint64_t u)
{
    if (d->out != NULL)
        smvm_word(d)->u = u;
    d->words++;
}

static void put_f(Decode *d, SmF64 f)
{
    if (d->out != NULL)
        smvm_word(d)->f = f;
    d->words++;
}

static void *address(const Decode *d, const Value *v)
{
    switch (v->is) {
    case A_LOCAL: return d->out->parts.local + v->offset;
    case AN_ELEMENT: return (uint8_t *)d->out->sv + v->offset;
    default: return &d->out->t;
    }
}

void smvm_put_value(Decode *d, const Value *v)
{
    if (v->kind == FAST_C) {
        put_f(d, v->c);
        return;
    }
    if (d->out != NULL && v->kind <= FAST_RAW)
        smvm_word(d)->p = address(d, v);
    d->words++;
}

// The target of a jump.  Until the whole function is decoded, the word contains the index of the previous jump and the target's
// offset in the function, 32 bits each.
void smvm_put_target(Decode *d, uint32_t target)
{
    uint64_t before = d->jumps;

    d->jumps = d->words;
    smvm_put_u(d, before << 32 | target);
}

// ---- values ----

Value smvm_in_memory(unsigned kind, unsigned is, uint32_t offset)
{
    Value v;

    memset(&v, 0, sizeof v);
    v.kind = (uint8_t)kind;
    v.is = is;
    v.offset = offset;
    return v;
}

Value smvm_constant(SmF64 c)
{
    Value v = smvm_in_memory(FAST_C, A_LOCAL, 0);

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

void smvm_put_load(Decode *d, const Value *x)
{
    if (is_f(x))
        return;
    smvm_put_op(d, is_number(x) ? FAST_LD_C_OP : (unsigned)FAST_LD_I8_OP + x->kind);
    smvm_put_value(d, x);
}

void smvm_put_with(Decode *d, FastOp family, const Value *y)
{
    smvm_put_op(d, (unsigned)family + y->kind);
    smvm_put_value(d, y);
}

void smvm_put_pair(Decode *d, FastOp family, const Value *x, const Value *y)
{
    smvm_put_op(d, (unsigned)family + x->kind);
    smvm_put_value(d, x);
    smvm_put_value(d, y);
}
