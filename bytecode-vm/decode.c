// SPDX-License-Identifier: Apache-2.0
// Translates the code of an image to the decoded form (fast.def).  A loaded operand becomes part of the instruction that uses it, as an
// address or a number, and its type selects the instruction.  The image has been verified; nothing is checked again.  There are two
// passes; the first one only counts the words.
//
// The decoded form has one register, F.  Loading Y can always be deferred until its use, because no store happens in between.  X can be
// deferred too, as an operand or as an operation on operands (DeferredOp), until the decoder knows how X is used.  Nothing known about X
// and Y crosses the target of a jump: the code there loads X again.
#include <string.h>

#include "bytecode-vm/decode.h"

enum { END_WORD = 0 };                                 // index of the word that ends a step; never the target of a jump

// ---- operands ----

// Returns the constant that a load with operand n loads.  The low two bits of the opcode select its form: n, -1 - n, or entry n of a table.
static DecodedValue decode_constant(const DecodeState *d, unsigned op, uint32_t n)
{
    const SmvmMachine *m = d->m;

    switch (op & 3u) {
    case SMVM_ldx_plus & 3: return smvm_constant_operand(sm_from_u32(n));
    case SMVM_ldx_minus & 3: return smvm_constant_operand(sm_from_i32(-1 - (int32_t)n));
    case SMVM_ldx_f32 & 3: return smvm_constant_operand(sm_from_f32(sm_f32_from_bits(smvm_uint(m->image, m->f32s_at + 4 * n, 4))));
    default: return smvm_constant_operand(sm_from_bits(smvm_cell(m->image, m->f64s_at + 8 * n, 8)));
    }
}

// Returns the value that opcode `op`, a load of X or Y, loads.
static DecodedValue decode_load(const DecodeState *d, unsigned op)
{
    unsigned kind = op & 15u;

    if (op == SMVM_ldx_time || op == SMVM_ldy_time)
        return smvm_memory_operand(SM_U64, THE_TIME, 0);
    if ((smvm_shape((uint8_t)op) & (SMVM_SHAPE_L | SMVM_SHAPE_E)) == 0)
        return decode_constant(d, op, d->n[0]);
    return smvm_memory_operand(kind, smvm_shape((uint8_t)op) & SMVM_SHAPE_L ? A_LOCAL : AN_ELEMENT, d->n[0] * size_of_kind(kind));
}

// ---- instructions ----

// Emits a transition: a jump to the state's .exit, or to the end of the step if .exit is empty.  link_transitions resolves it.
static void emit_transition(DecodeState *d, uint32_t state)
{
    uint64_t before = d->gotos;

    smvm_emit_op(d, FAST_GO_OP);
    d->gotos = d->words;
    smvm_emit_integer(d, before);
    smvm_emit_integer(d, state);
}

// Emits the end of .entry: a jump to .step, which follows it.
static void emit_end_of_entry(DecodeState *d)
{
    if (d->at < d->end)
        smvm_emit_jump(d, FAST_JMP_OP, (uint32_t)(d->end - d->start));
}

// Decodes the instruction that ends a function: .entry continues with .step, the sample function with the state's first block; the others
// end the step.
static void decode_end(DecodeState *d)
{
    if (d->in == IN_ENTRY)
        emit_end_of_entry(d);
    else
        smvm_emit_op(d, d->in == IN_SAMPLE ? FAST_BODY_OP : FAST_END_OP);
}

// Defers an operation whose result is X: on X, on X and Y, or `stat`, which reads neither.
static void decode_operation(DecodeState *d, uint8_t op)
{
    if (op == SMVM_addi || op == SMVM_subi)
        smvm_defer_operation(d, op == SMVM_addi ? SMVM_add : SMVM_sub, smvm_constant_operand(sm_from_u32(d->n[0])));
    else if (op == SMVM_stat) {
        d->x = smvm_constant_operand(sm_from_i32(0));
        smvm_defer_operation(d, op, d->x);
    } else
        smvm_defer_operation(d, op, d->y);
}

// Translates the image's next instruction into words of the fast interpreter.
static void decode_instruction(DecodeState *d)
{
    uint8_t op = smvm_u8(d->m->image, d->at++);
    uint32_t shape = smvm_shape(op);

    for (unsigned i = 0; i < 2 && d->at < d->end && smvm_u8(d->m->image, d->at) < SMVM_OP_FIRST; i++)
        smvm_read_varint(d->m->image, &d->at, d->end, &d->n[i]);
    if ((shape & SMVM_SHAPE_J) != 0)
        smvm_decode_jump(d, op);
    else if (op == SMVM_goto)
        emit_transition(d, d->n[0]);
    else if (op == SMVM_end)
        decode_end(d);
    else if (op == SMVM_sample)
        smvm_decode_sample(d);
    else if ((shape & (SMVM_SHAPE_GX | SMVM_SHAPE_GY)) == 0)
        smvm_decode_store(d, op);
    else if ((shape & SMVM_SHAPE_GY) != 0)
        d->y = decode_load(d, op);
    else if ((shape & SMVM_SHAPE_X) != 0 || op == SMVM_stat)
        decode_operation(d, op);
    else
        d->x = decode_load(d, op);
}

// Resolves the jumps of a function once the words of all its instructions are known.
static void link_jumps(DecodeState *d)
{
    while (d->jumps != 0) {
        SmvmWord *w = &d->out->code[d->jumps];
        d->jumps = (uint32_t)(w->u >> 32);
        w->to = d->out->code + d->where[w->u & UINT32_MAX];
    }
}

// Resolves the transitions of a state once the start of its .exit is known.
static void link_transitions(DecodeState *d, uint32_t exit)
{
    while (d->out != NULL && d->gotos != 0) {
        SmvmWord *w = &d->out->code[d->gotos];
        d->gotos = (uint32_t)w->u;
        w->to = d->out->code + exit;
    }
}

// Decodes function `index` of the image. Returns the index of the first word of its decoded form; END_WORD if the function is empty.
static uint32_t decode_function(DecodeState *d, uint32_t index)
{
    uint32_t first = d->words, length;

    d->start = (SmvmAt)(d->m->code_at + (index == 0 ? 0 : smvm_function_end(d->m, index - 1)));
    d->end = (SmvmAt)(d->m->code_at + smvm_function_end(d->m, index));
    length = (uint32_t)(d->end - d->start);
    d->longest = length > d->longest ? length : d->longest;
    d->at = d->start;
    d->jumps = 0;
    while (d->at < d->end) {
        if (d->out != NULL)
            d->where[d->at - d->start] = d->words;
        decode_instruction(d);
    }
    if (d->out != NULL) {
        d->where[d->end - d->start] = d->words;
        link_jumps(d);
    }
    return d->start == d->end ? END_WORD : first;
}

// Translates the functions of state s, which are numbered from 3 * s - 2.
static void decode_state(DecodeState *d, uint32_t s)
{
    uint32_t entry, step;

    d->gotos = 0;
    d->in = IN_ENTRY;
    entry = decode_function(d, 3 * s - 2);
    d->in = IN_OTHERS;
    step = decode_function(d, 3 * s - 1);
    if (entry != END_WORD && step == END_WORD)
        smvm_emit_op(d, FAST_END_OP);
    if (d->out != NULL) {
        d->out->body[2 * s] = d->out->code + step;
        d->out->body[2 * s + 1] = d->out->code + (entry == END_WORD ? step : entry);
    }
    link_transitions(d, decode_function(d, 3 * s));
}

static void decode_machine(DecodeState *d)
{
    const bool clears = d->m->outputs > 64;
    bool samples;

    d->words = 0;
    smvm_emit_op(d, FAST_END_OP);                     // END_WORD
    if (clears)
        smvm_emit_op(d, FAST_CLEAR_OP);
    d->in = IN_SAMPLE;
    samples = decode_function(d, 0) != END_WORD;
    if (clears && !samples)
        smvm_emit_op(d, FAST_BODY_OP);
    if (d->out != NULL)
        d->out->samples = clears || samples;
    for (uint32_t s = 1; s <= d->m->states; s++)
        decode_state(d, s);
}

// ---- memory: SmvmDecoded, the words, the states, and during decoding `where` for the longest function ----

// Returns the bytes of memory for decoding m, and stores in *words the number of words.
static uint64_t decoded_bytes(const SmvmMachine *m, uint32_t *words)
{
    DecodeState d;

    memset(&d, 0, sizeof d);
    d.m = m;
    decode_machine(&d);
    *words = d.words;
    return sizeof(SmvmDecoded) + (uint64_t)d.words * sizeof(SmvmWord) + 2 * ((uint64_t)m->states + 1) * sizeof(SmvmWord *)
        + ((uint64_t)d.longest + 1) * sizeof(uint32_t);
}

// Returns the bytes of memory that smvm_decode needs for m.
uint32_t smvm_decoded_size(const SmvmMachine *m)
{
    uint32_t words;
    uint64_t size = decoded_bytes(m, &words);

    return size > UINT32_MAX ? UINT32_MAX : (uint32_t)size;
}

// Decodes the code of the machine that runs at vm, into memory that the caller owns; sets *decoded to the decoded form.
SmResult smvm_decode(SmvmDecoded **decoded, void *memory, uint32_t size, const SmvmMachine *m, SmVm *vm, void *sv)
{
    SmvmDecoded *out = memory;
    uint32_t words;
    DecodeState d;

    if ((uintptr_t)memory % sizeof(SmvmWord) != 0)
        return SM_E_ALIGNMENT;
    if (size < decoded_bytes(m, &words))
        return SM_E_MEMORY;
    memset(&d, 0, sizeof d);
    d.m = m;
    d.out = *decoded = out;
    out->vm = vm;
    out->sv = sv;
    out->g = (uint8_t *)sv + m->g;
    out->s = (uint8_t *)sv + m->s;
    out->parts = smvm_parts(vm, m);
    out->t = 0;
    out->code = (SmvmWord *)(out + 1);
    out->body = (const SmvmWord **)(out->code + words);
    d.where = (uint32_t *)(out->body + 2 * ((size_t)m->states + 1));
    d.label = out->label = smvm_fast_labels();
    decode_machine(&d);
    return SM_OK;
}
