// SPDX-License-Identifier: Apache-2.0
// From the code of an image to the decoded form (fast.def): operands become addresses and numbers, their types choose the
// instruction.  The image has been verified; nothing is checked again.  Everything is done twice, at first only to count the words.
#include <string.h>

#include "bytecode-vm/fast.h"
#include "bytecode-vm/image.h"
#include "stdlib/convert.h"

enum { THE_END = 0 };                                 // the word that ends a step, and no jump's

typedef struct Operand {
    uint8_t kind;             // a type, FAST_RAW, FAST_C or FAST_A
    uint8_t acc;              // of an accumulator that is written: its type or SMVM_RAW
    bool output;
    uint32_t index;           // among the operands: of an output its number
    void *p;
    SmF64 c;
} Operand;

typedef struct Decode {
    const SmvmMachine *m;
    SmvmDecoded *out;         // NULL while words are counted
    const void *const *place; // of each FastOp
    uint32_t *where;          // by offset in the function: the word where the instruction there begins
    uint32_t words;           // so far
    uint32_t at, start, end;  // in the image: the instruction, the function
    uint32_t jumps;           // the last word that is the target of a jump not yet known, or 0
    uint32_t goes;            // the last GO whose target is not yet known, or 0
    uint32_t longest;         // function, in bytes
    enum { IN_SAMPLE, IN_ENTRY, IN_OTHERS } in;
} Decode;

// ---- words ----

static SmvmWord *word(Decode *d) { return d->out != NULL ? &d->out->code[d->words] : NULL; }

static void put_op(Decode *d, unsigned op)
{
    if (d->out != NULL && d->place != NULL)
        word(d)->go = d->place[op];
    else if (d->out != NULL)
        word(d)->u = op;
    d->words++;
}

static void put_u(Decode *d, uint64_t u)
{
    if (d->out != NULL)
        word(d)->u = u;
    d->words++;
}

static void put_f(Decode *d, SmF64 f)
{
    if (d->out != NULL)
        word(d)->f = f;
    d->words++;
}

static void put_operand(Decode *d, const Operand *o)             // an address or a number; for F itself a word nobody reads
{
    if (o->kind == FAST_C) {
        put_f(d, o->c);
        return;
    }
    if (d->out != NULL)
        word(d)->p = o->p;
    d->words++;
}

// The target of a jump, for now its offset in the function and where the jump before it is, both 32 bits.
static void put_target(Decode *d, uint32_t target)
{
    uint64_t before = d->jumps;

    d->jumps = d->words;
    put_u(d, before << 32 | target);
}

// ---- operands ----

static uint32_t next(Decode *d)
{
    uint32_t v = 0;

    smvm_varint(d->m->image, &d->at, d->end, &v);
    return v;
}

static SmF64 constant(const Decode *d, const SmvmOperand *o)
{
    const SmvmMachine *m = d->m;

    if (o->kind == SMVM_K_INT)
        return sm_from_i32((int32_t)o->payload - (o->payload > (uint32_t)SMVM_INT_MOST ? SMVM_PAYLOADS : 0));
    if (o->kind == SMVM_K_F32)
        return sm_from_f32(sm_f32_from_bits(smvm_uint(m->image, m->f32s_at + 4 * o->payload, 4)));
    return sm_from_bits(smvm_cell(m->image, m->f64s_at + 8 * o->payload, 8));
}

static void *address(const Decode *d, const SmvmOperand *o)
{
    if (d->out == NULL)
        return NULL;
    if (o->kind < SMVM_K_LOCAL)
        return (uint8_t *)d->out->sv + o->offset;
    if (o->kind < SMVM_K_TEMP)
        return d->out->parts.local + o->offset;
    return o->kind == SMVM_K_TEMP ? (void *)&d->out->parts.temp[o->payload] : (void *)&d->out->t;
}

static Operand operand(Decode *d)
{
    uint32_t index = next(d);
    SmvmOperand from = smvm_operand(d->m, index);
    Operand o;

    memset(&o, 0, sizeof o);
    o.output = from.kind < SMVM_K_LOCAL;
    o.index = index;
    if (from.kind == SMVM_K_ACC) {
        o.kind = FAST_A;
        o.acc = (uint8_t)from.payload;
    } else if (from.kind <= SMVM_K_TIME) {
        o.kind = from.kind == SMVM_K_TEMP ? (uint8_t)FAST_RAW : from.kind == SMVM_K_TIME ? (uint8_t)SM_U64 : (uint8_t)from.type;
        o.p = address(d, &from);
    } else {
        o.kind = FAST_C;
        o.c = constant(d, &from);
    }
    return o;
}

static bool is_memory(const Operand *o) { return o->kind <= FAST_RAW; }
static bool is_f(const Operand *o) { return o->kind == FAST_A; }
static bool is_number(const Operand *o) { return o->kind == FAST_C; }

static bool is_integer(const Operand *o) { return o->kind <= SM_U64; }       // the types up to it

// Whether c is a whole number in -limit … limit, and gives it.
static bool is_whole(SmF64 c, int64_t limit, int64_t *v)
{
    if (!sm_le(sm_from_i64(-limit), c) || !sm_le(c, sm_from_i64(limit)))
        return false;
    *v = sm_to_i64(c);
    return sm_eq(sm_from_i64(*v), c);
}

// ---- families: the first instruction of one and the operand's kind make the instruction ----

static void put_load(Decode *d, const Operand *x)
{
    if (is_f(x))
        return;
    put_op(d, is_number(x) ? FAST_LD_C_OP : (unsigned)FAST_LD_I8_OP + x->kind);
    put_operand(d, x);
}

static void put_with(Decode *d, FastOp family, const Operand *y)             // F and y
{
    put_op(d, (unsigned)family + y->kind);
    put_operand(d, y);
}

static void put_pair(Decode *d, FastOp family, const Operand *x, const Operand *y)     // x in memory, y there too or a number
{
    put_op(d, (unsigned)family + x->kind);
    put_operand(d, x);
    put_operand(d, y);
}

// Up to the destination.  That an output is written stands in the first 64 bits, or for others in a bit of a byte: which byte
// above, mask in the low eight bits.
static void put_written(Decode *d, FastOp family, FastOp noting, unsigned which, const Operand *to)
{
    if (to->output && to->index >= 64) {
        put_op(d, FAST_NOTE_OP);
        put_u(d, (uint64_t)((to->index - 64) >> 3) << 8 | 1u << (to->index & 7u));
    }
    if (to->output && to->index < 64) {
        put_op(d, (unsigned)noting + which);
        put_u(d, (uint64_t)1 << to->index);
    } else {
        put_op(d, (unsigned)family + which);
    }
    put_operand(d, to);
}

// F to where it goes.  `truth`: it is 0 or 1.
static void put_store(Decode *d, const Operand *to, bool truth)
{
    if (!is_f(to))
        put_written(d, FAST_ST_I8_OP, FAST_STN_I8_OP, to->kind, to);
    else if (to->acc != SMVM_RAW && !truth)
        put_op(d, (unsigned)FAST_CVT_I8_OP + to->acc);
}

// ---- mov ----

static void put_set(Decode *d, const Operand *to, SmF64 c)       // a number to memory: as it will lie there
{
    uint64_t cell = to->kind == FAST_RAW ? sm_bits(c) : sm_cell_from_f64((SmType)to->kind, c);

    put_written(d, FAST_SET_1_OP, FAST_SETN_1_OP, to->kind == FAST_RAW ? 3 : smvm_type_shift(to->kind), to);
    put_u(d, cell);
}

static void put_mov(Decode *d, const Operand *to, const Operand *x)
{
    if (is_number(x) && is_memory(to)) {
        put_set(d, to, x->c);
    } else if (is_memory(x) && to->kind == x->kind) {
        put_written(d, FAST_MOV_I8_OP, FAST_MOVN_I8_OP, to->kind, to);
        put_operand(d, x);
    } else {
        put_load(d, x);
        put_store(d, to, false);
    }
}

// ---- operations ----

static void put_one(Decode *d, uint8_t op, const Operand *to, const Operand *x)
{
    static const uint16_t plain[] = {FAST_NEG_OP, FAST_ABS_OP, FAST_FLOOR_OP, FAST_CEIL_OP, FAST_TRUNC_OP, FAST_ROUND_OP, FAST_SQRT_OP,
                                     FAST_SIGN_OP, FAST_TRUTH_OP, FAST_NOT_OP};

    if (op == SMVM_mov) {
        put_mov(d, to, x);
        return;
    }
    put_load(d, x);
    put_op(d, plain[op - SMVM_neg]);
    put_store(d, to, op == SMVM_truth || op == SMVM_not);
}

// An operation of two, in its forms: F op y, x op F, x in memory op a number, a number op y in memory, two in memory of one type.
typedef struct Forms { uint16_t with, swapped, number, number_first, pair; } Forms;

static const Forms forms[] = {                        // from SMVM_add to SMVM_or; 0: there is no such form
    {FAST_ADD_I8_OP, FAST_ADD_I8_OP, FAST_ADDC_I8_OP, FAST_ADDC_I8_OP, FAST_ADD2_I8_OP},
    {FAST_SUB_I8_OP, FAST_RSUB_I8_OP, FAST_ADDC_I8_OP, FAST_RSUBC_I8_OP, FAST_SUB2_I8_OP},
    {FAST_MUL_I8_OP, FAST_MUL_I8_OP, FAST_MULC_I8_OP, FAST_MULC_I8_OP, FAST_MUL2_I8_OP},
    {FAST_DIV_I8_OP, FAST_RDIV_I8_OP, FAST_DIVC_I8_OP, FAST_RDIVC_I8_OP, FAST_DIV2_I8_OP},
    {FAST_MIN_I8_OP, FAST_MIN_I8_OP, 0, 0, 0},
    {FAST_MAX_I8_OP, FAST_MAX_I8_OP, 0, 0, 0},
    {FAST_EQ_I8_OP, FAST_EQ_I8_OP, 0, 0, 0},
    {FAST_NE_I8_OP, FAST_NE_I8_OP, 0, 0, 0},
    {FAST_LT_I8_OP, FAST_GT_I8_OP, 0, 0, 0},
    {FAST_LE_I8_OP, FAST_GE_I8_OP, 0, 0, 0},
    {FAST_AND_I8_OP, FAST_AND_I8_OP, 0, 0, 0},
    {FAST_OR_I8_OP, FAST_OR_I8_OP, 0, 0, 0},
};

static void swap(Operand *x, Operand *y)
{
    Operand t = *x;

    *x = *y;
    *y = t;
}

// `to = x + c`, both of one integer type, c whole and small.  False if it is not that.
static bool put_count(Decode *d, const Operand *to, const Operand *x, const Operand *y)
{
    int64_t c;

    if (!is_integer(x) || to->kind != x->kind || !is_number(y) || !is_whole(y->c, INT32_MAX, &c))
        return false;
    put_written(d, FAST_INC_I8_OP, FAST_INCN_I8_OP, to->kind, to);
    put_operand(d, x);
    put_u(d, (uint64_t)c);
    return true;
}

static void put_two(Decode *d, uint8_t op, const Operand *to, Operand x, Operand y)
{
    const Forms *f = &forms[op - SMVM_add];

    if (op == SMVM_sub && is_number(&y)) {            // x - c is x + -c, of zeros too
        y.c = sm_neg(y.c);
        op = SMVM_add;
        f = &forms[0];
    }
    if (op == SMVM_add && is_number(&x))
        swap(&x, &y);
    if (op == SMVM_add && put_count(d, to, &x, &y))
        return;
    if (is_f(&x)) {
        put_with(d, (FastOp)f->with, &y);
    } else if (is_f(&y)) {
        put_with(d, (FastOp)f->swapped, &x);
    } else if (is_memory(&x) && is_number(&y) && f->number != 0) {
        put_pair(d, (FastOp)f->number, &x, &y);
    } else if (is_number(&x) && is_memory(&y) && f->number_first != 0) {
        put_pair(d, (FastOp)f->number_first, &y, &x);
    } else if (is_memory(&x) && x.kind == y.kind && f->pair != 0) {
        put_pair(d, (FastOp)f->pair, &x, &y);
    } else {
        put_load(d, &x);
        put_with(d, (FastOp)f->with, &y);
    }
    put_store(d, to, op >= SMVM_eq);
}

// ---- jumps ----

// A condition on two operands, in its forms: F and y, x and F, two in memory of one type; one in memory and a number, either first;
// an integer and a whole number, either first.
typedef struct Conditions { uint16_t with, swapped, pair, number, number_first, whole, whole_first; } Conditions;

static const Conditions conditions[] = {              // from SMVM_jeq to SMVM_jnle
    {FAST_JEQ_I8_OP, FAST_JEQ_I8_OP, FAST_JEQ2_I8_OP, FAST_JEQC_I8_OP, FAST_JEQC_I8_OP, FAST_JEQI_I8_OP, FAST_JEQI_I8_OP},
    {FAST_JNE_I8_OP, FAST_JNE_I8_OP, FAST_JNE2_I8_OP, FAST_JNEC_I8_OP, FAST_JNEC_I8_OP, FAST_JNEI_I8_OP, FAST_JNEI_I8_OP},
    {FAST_JLT_I8_OP, FAST_JGT_I8_OP, FAST_JLT2_I8_OP, FAST_JLTC_I8_OP, FAST_JGTC_I8_OP, FAST_JLTI_I8_OP, FAST_JGTI_I8_OP},
    {FAST_JNLT_I8_OP, FAST_JNGT_I8_OP, FAST_JNLT2_I8_OP, FAST_JNLTC_I8_OP, FAST_JNGTC_I8_OP, FAST_JGEI_I8_OP, FAST_JLEI_I8_OP},
    {FAST_JLE_I8_OP, FAST_JGE_I8_OP, FAST_JLE2_I8_OP, FAST_JLEC_I8_OP, FAST_JGEC_I8_OP, FAST_JLEI_I8_OP, FAST_JGEI_I8_OP},
    {FAST_JNLE_I8_OP, FAST_JNGE_I8_OP, FAST_JNLE2_I8_OP, FAST_JNLEC_I8_OP, FAST_JNGEC_I8_OP, FAST_JGTI_I8_OP, FAST_JLTI_I8_OP},
};

static void put_jump(Decode *d, FastOp family, const Operand *x, const Operand *y)
{
    put_op(d, (unsigned)family + x->kind);
    put_target(d, 0);
    put_operand(d, x);
    if (y != NULL)
        put_operand(d, y);
}

// The ten conditions on x and a number c, each with the one that differs from it only in what it makes of a NaN.
typedef struct NanForm { uint16_t condition, of_nan_false, of_nan_true; } NanForm;

static const NanForm nan_forms[] = {
    {FAST_JEQC_I8_OP, FAST_JEQC_I8_OP, 0},
    {FAST_JNEC_I8_OP, 0, FAST_JNEC_I8_OP},
    {FAST_JLTC_I8_OP, FAST_JLTC_I8_OP, FAST_JNGEC_I8_OP},
    {FAST_JNLTC_I8_OP, FAST_JGEC_I8_OP, FAST_JNLTC_I8_OP},
    {FAST_JLEC_I8_OP, FAST_JLEC_I8_OP, FAST_JNGTC_I8_OP},
    {FAST_JNLEC_I8_OP, FAST_JGTC_I8_OP, FAST_JNLEC_I8_OP},
    {FAST_JGTC_I8_OP, FAST_JGTC_I8_OP, FAST_JNLEC_I8_OP},
    {FAST_JNGTC_I8_OP, FAST_JLEC_I8_OP, FAST_JNGTC_I8_OP},
    {FAST_JGEC_I8_OP, FAST_JGEC_I8_OP, FAST_JNLTC_I8_OP},
    {FAST_JNGEC_I8_OP, FAST_JLTC_I8_OP, FAST_JNGEC_I8_OP},
};

// Whether the condition holds of 0, which is what a stored NaN reads as.
static bool holds_of_zero(FastOp family, SmF64 c)
{
    const SmF64 zero = sm_from_i32(0);

    switch (family) {
    case FAST_JEQC_I8_OP: return sm_eq(zero, c);
    case FAST_JNEC_I8_OP: return !sm_eq(zero, c);
    case FAST_JLTC_I8_OP: return sm_lt(zero, c);
    case FAST_JNLTC_I8_OP: return !sm_lt(zero, c);
    case FAST_JLEC_I8_OP: return sm_le(zero, c);
    case FAST_JNLEC_I8_OP: return !sm_le(zero, c);
    case FAST_JGTC_I8_OP: return sm_lt(c, zero);
    case FAST_JNGTC_I8_OP: return !sm_lt(c, zero);
    case FAST_JGEC_I8_OP: return sm_le(c, zero);
    default: return !sm_le(c, zero);
    }
}

// A float element or local and a number: the form that makes of a NaN what is made of 0; 0 if there is none.
static uint16_t form_for_nan(FastOp family, SmF64 c)
{
    const NanForm *f = nan_forms;

    if (sm_is_nan(c))
        return 0;
    while (f->condition != (uint16_t)family)
        f++;
    return holds_of_zero(family, c) ? f->of_nan_true : f->of_nan_false;
}

static void put_jump_number(Decode *d, const Conditions *c, const Operand *x, const Operand *number, bool first)
{
    FastOp family = (FastOp)(first ? c->number_first : c->number);
    int64_t v;

    if (is_integer(x) && is_whole(number->c, ((int64_t)1 << 53) - 1, &v) && (v >= 0 || x->kind != SM_U64)) {
        put_jump(d, (FastOp)(first ? c->whole_first : c->whole), x, NULL);
        put_u(d, (uint64_t)v);
        return;
    }
    if (x->kind == SM_F32 || x->kind == SM_F64)
        family = (FastOp)form_for_nan(family, number->c);
    if (family != 0) {
        put_jump(d, family, x, number);
    } else {
        put_load(d, first ? number : x);
        put_jump(d, (FastOp)c->with, first ? x : number, NULL);
    }
}

static void put_jump_two(Decode *d, uint8_t op, const Operand *x, const Operand *y)
{
    const Conditions *c = &conditions[op - SMVM_jeq];

    if (is_f(x)) {
        put_jump(d, (FastOp)c->with, y, NULL);
    } else if (is_f(y)) {
        put_jump(d, (FastOp)c->swapped, x, NULL);
    } else if (is_memory(x) && is_number(y)) {
        put_jump_number(d, c, x, y, false);
    } else if (is_number(x) && is_memory(y)) {
        put_jump_number(d, c, y, x, true);
    } else if (is_memory(x) && x->kind == y->kind) {
        put_jump(d, (FastOp)c->pair, x, y);
    } else {
        put_load(d, x);
        put_jump(d, (FastOp)c->with, y, NULL);
    }
}

static void put_jump_truth(Decode *d, bool when, const Operand *x)
{
    if (is_memory(x)) {
        put_jump(d, when ? FAST_JT_I8_OP : FAST_JF_I8_OP, x, NULL);
        return;
    }
    put_load(d, x);
    put_op(d, when ? FAST_JT_A_OP : FAST_JF_A_OP);
    put_target(d, 0);
}

// ---- instructions ----

static void decode_jump(Decode *d, uint8_t op)
{
    uint32_t before = d->jumps, distance;

    if (op == SMVM_jmp) {
        put_op(d, FAST_JMP_OP);
        put_target(d, 0);
    } else {
        Operand x = operand(d);
        if (op < SMVM_jeq) {
            put_jump_truth(d, op == SMVM_jt, &x);
        } else {
            Operand y = operand(d);
            put_jump_two(d, op, &x, &y);
        }
    }
    distance = next(d);
    if (d->out != NULL)
        d->out->code[d->jumps].u = (uint64_t)before << 32 | (d->at + distance - d->start);
}

static void put_window(Decode *d, uint32_t w)            // which, of what size and kind
{
    uint32_t entry = smvm_window(d->m->image, d->m->windows_at, w);

    if (d->out != NULL)
        word(d)->p = d->out->parts.window[w];
    d->words++;
    put_u(d, entry & SMVM_WINDOW_SIZE_MASK);
    put_u(d, entry >> SMVM_WINDOW_SIZE_BITS);
}

// The windows that instructions are made for: of five types, that keep nothing but what one statistic needs, or both ends.
enum { FOR_MEDIAN, FOR_AVG, FOR_ENDS, FOR_NONE };

static unsigned made_for(uint32_t kind, unsigned *type)
{
    static const uint8_t types[] = {SM_ROLL_I16, SM_ROLL_U16, SM_ROLL_I32, SM_ROLL_F32, SM_ROLL_F64};
    const uint32_t stats = kind & ~(uint32_t)SM_ROLL_TYPE;

    for (*type = 0; *type < sizeof types && (kind & SM_ROLL_TYPE) != types[*type];)
        ++*type;
    if (*type == sizeof types)
        return FOR_NONE;
    if (stats == SM_ROLL_MEDIAN || stats == SM_ROLL_AVG)
        return stats == SM_ROLL_AVG ? FOR_AVG : FOR_MEDIAN;
    return (stats & (SM_ROLL_MEDIAN | SM_ROLL_AVG)) == 0 && (stats & SM_ROLL_RANGE) != 0 ? FOR_ENDS : FOR_NONE;
}

static unsigned sampling(uint32_t kind)
{
    static const uint16_t family[] = {FAST_PUSH_MEDIAN_I16_OP, FAST_PUSH_AVG_I16_OP, FAST_PUSH_ENDS_I16_OP};
    unsigned type, use = made_for(kind, &type);

    return use == FOR_NONE ? (unsigned)FAST_SAMPLE_OP : family[use] + type;
}

static unsigned asking(uint32_t kind, uint8_t op)
{
    unsigned type, use = made_for(kind, &type);

    if (op == SMVM_median && use == FOR_MEDIAN)
        return (unsigned)FAST_MEDIAN_I16_OP + type;
    if (op == SMVM_avg && use == FOR_AVG)
        return (unsigned)FAST_AVG_I16_OP + type;
    return op == SMVM_range && use == FOR_ENDS ? (unsigned)FAST_RANGE_I16_OP + type : (unsigned)FAST_STAT_OP;
}

static uint32_t kind_of(const Decode *d, uint32_t w) { return smvm_window(d->m->image, d->m->windows_at, w) >> SMVM_WINDOW_SIZE_BITS; }

static void decode_window(Decode *d, uint8_t op)
{
    Operand o;
    uint32_t w;

    if (op == SMVM_sample) {
        w = next(d);
        o = operand(d);
        put_load(d, &o);
        put_op(d, sampling(kind_of(d, w)));
        put_window(d, w);
        return;
    }
    o = operand(d);
    w = next(d);
    put_op(d, asking(kind_of(d, w), op));
    put_window(d, w);
    put_u(d, (uint64_t)(op - SMVM_avg));
    put_store(d, &o, false);
}

// A transition: to the end of the step, or where the state's .exit will begin.
static void put_go(Decode *d)
{
    uint64_t before = d->goes;

    put_op(d, FAST_GO_OP);
    d->goes = d->words;
    put_u(d, before);
    put_u(d, next(d));
}

// On to .step, which stands behind.
static void put_end_of_entry(Decode *d)
{
    if (d->at == d->end)
        return;
    put_op(d, FAST_JMP_OP);
    put_target(d, d->end - d->start);
}

static void decode_instruction(Decode *d)
{
    uint8_t op = smvm_u8(d->m->image, d->at++);
    Operand to, x;

    if (op >= SMVM_avg) {
        decode_window(d, op);
    } else if (op >= SMVM_mov) {
        to = operand(d);
        x = operand(d);
        if (op < SMVM_add)
            put_one(d, op, &to, &x);
        else
            put_two(d, op, &to, x, operand(d));
    } else if (op >= SMVM_jmp) {
        decode_jump(d, op);
    } else if (op == SMVM_goto) {
        put_go(d);
    } else if (d->in == IN_ENTRY) {
        put_end_of_entry(d);
    } else {
        put_op(d, d->in == IN_SAMPLE ? FAST_BODY_OP : FAST_END_OP);
    }
}

// The targets of the jumps of a function, when it is known where everything in it lies.
static void link_jumps(Decode *d)
{
    while (d->jumps != 0) {
        SmvmWord *w = &d->out->code[d->jumps];
        d->jumps = (uint32_t)(w->u >> 32);
        w->to = d->out->code + d->where[w->u & UINT32_MAX];
    }
}

// The same for the transitions of a state, when it is known where its .exit begins.
static void link_goes(Decode *d, uint32_t exit)
{
    while (d->out != NULL && d->goes != 0) {
        SmvmWord *w = &d->out->code[d->goes];
        d->goes = (uint32_t)w->u;
        w->to = d->out->code + exit;
    }
}

// Gives where the function begins, or where there is none THE_END.
static uint32_t decode_function(Decode *d, uint32_t index)
{
    uint32_t first = d->words;

    d->start = d->m->code_at + (index == 0 ? 0 : smvm_function_end(d->m, index - 1));
    d->end = d->m->code_at + smvm_function_end(d->m, index);
    d->longest = d->end - d->start > d->longest ? d->end - d->start : d->longest;
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
    return d->start == d->end ? THE_END : first;
}

static void decode_state(Decode *d, uint32_t s)
{
    uint32_t entry, step;

    d->goes = 0;
    d->in = IN_ENTRY;
    entry = decode_function(d, 3 * s - 2);
    d->in = IN_OTHERS;
    step = decode_function(d, 3 * s - 1);
    if (entry != THE_END && step == THE_END)
        put_op(d, FAST_END_OP);
    if (d->out != NULL) {
        d->out->body[2 * s] = step;
        d->out->body[2 * s + 1] = entry == THE_END ? step : entry;
    }
    link_goes(d, decode_function(d, 3 * s));
}

static void decode_machine(Decode *d)
{
    bool samples;

    d->words = 0;
    put_op(d, FAST_END_OP);                           // THE_END
    d->in = IN_SAMPLE;
    samples = decode_function(d, 0) != THE_END;
    if (d->out != NULL)
        d->out->samples = samples;
    for (uint32_t s = 1; s <= d->m->states; s++)
        decode_state(d, s);
}

// ---- the whole: SmvmDecoded, the words, the states, and while it is made `where` of the longest function ----

static uint64_t size_of(const SmvmMachine *m, uint32_t *words)
{
    Decode d;

    memset(&d, 0, sizeof d);
    d.m = m;
    decode_machine(&d);
    *words = d.words;
    return sizeof(SmvmDecoded) + (uint64_t)d.words * sizeof(SmvmWord) + (2 * ((uint64_t)m->states + 1) + d.longest + 1) * sizeof(uint32_t);
}

uint32_t smvm_decoded_size(const SmvmMachine *m)
{
    uint32_t words;
    uint64_t size = size_of(m, &words);

    return size > UINT32_MAX ? UINT32_MAX : (uint32_t)size;
}

SmResult smvm_decode(SmvmDecoded **decoded, void *memory, uint32_t size, const SmvmMachine *m, SmVm *vm, void *sv)
{
    SmvmDecoded *out = memory;
    uint32_t words;
    Decode d;

    if ((uintptr_t)memory % sizeof(SmvmWord) != 0)
        return SM_E_ALIGNMENT;
    if (size < size_of(m, &words))
        return SM_E_MEMORY;
    memset(&d, 0, sizeof d);
    d.m = m;
    d.out = *decoded = out;
    out->vm = vm;
    out->sv = sv;
    out->g = (uint8_t *)sv + smvm_operand(m, m->outputs).offset;
    out->s = (uint8_t *)sv + smvm_operand(m, m->outputs + 1).offset;
    out->parts = smvm_parts(vm, m);
    out->t = 0;
    out->code = (SmvmWord *)(out + 1);
    out->body = (uint32_t *)(out->code + words);
    d.where = out->body + 2 * ((size_t)m->states + 1);
    d.place = out->place = smvm_fast_places();
    decode_machine(&d);
    return SM_OK;
}
