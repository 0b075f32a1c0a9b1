// SPDX-License-Identifier: Apache-2.0
// From the code of an image to the decoded form (fast.def): what is loaded becomes part of what is done with it, as an address or a
// number, and its type chooses the instruction.  The image has been verified; nothing is checked again.  Everything is done twice, at
// first only to count the words.
//
// The decoded form has one register, F.  Y of the image is always something that can be loaded where it is used, for nothing is stored
// before; X may wait likewise, as what was loaded or as an operation on that (Later), until it is known what becomes of it.  All that is
// known of X and Y ends where they end: behind whatever a jump can lead to, X is loaded anew.
#include <string.h>

#include "bytecode-vm/fast.h"
#include "bytecode-vm/image.h"
#include "bytecode-vm/step.h"
#include "stdlib/convert.h"

enum { THE_END = 0 };                                 // the word that ends a step, and no jump's

enum { LATER = FAST_SOURCE_COUNT };                   // as what X holds: it is yet to be computed

// What a register holds.
typedef struct Value {
    uint8_t kind;             // in memory, as this type or FAST_RAW; FAST_C: c; FAST_A: in F; LATER
    enum { A_LOCAL, AN_ELEMENT, THE_TIME } is;        // what is in memory
    uint32_t offset;          // where it lies there
    SmF64 c;
} Value;

// An operation that X waits for.
typedef struct Later {
    uint8_t op;               // SMVM_sub also stands for subi, and so on
    uint32_t n, w;            // relations of set, type of cvt, statistic; window
    Value a, b;
} Later;

typedef struct Decode {
    const SmvmMachine *m;
    SmvmDecoded *out;         // NULL while words are counted
    const void *const *place; // of each FastOp
    uint32_t *where;          // by offset in the function: the word where the instruction there begins
    uint32_t words;           // so far
    SmvmAt at, start, end;    // in the image: the instruction, the function
    uint32_t n[2];            // what follows the instruction's opcode
    Value x, y;
    Later later;              // where x is that
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

static void *address(const Decode *d, const Value *v)
{
    switch (v->is) {
    case A_LOCAL: return d->out->parts.local + v->offset;
    case AN_ELEMENT: return (uint8_t *)d->out->sv + v->offset;
    default: return &d->out->t;
    }
}

static void put_value(Decode *d, const Value *v)      // an address or a number; for F itself a word nobody reads
{
    if (v->kind == FAST_C) {
        put_f(d, v->c);
        return;
    }
    if (d->out != NULL && v->kind <= FAST_RAW)
        word(d)->p = address(d, v);
    d->words++;
}

// The target of a jump, for now its offset in the function and where the jump before it is, both 32 bits.
static void put_target(Decode *d, uint32_t target)
{
    uint64_t before = d->jumps;

    d->jumps = d->words;
    put_u(d, before << 32 | target);
}

// ---- values ----

static Value in_memory(unsigned kind, unsigned is, uint32_t offset)
{
    Value v;

    memset(&v, 0, sizeof v);
    v.kind = (uint8_t)kind;
    v.is = is;
    v.offset = offset;
    return v;
}

static Value number(SmF64 c)
{
    Value v = in_memory(FAST_C, A_LOCAL, 0);

    v.c = c;
    return v;
}

static uint32_t size_of_kind(unsigned kind) { return 1u << smvm_type_shift(kind); }

static Value constant(const Decode *d, unsigned op, uint32_t n)
{
    const SmvmMachine *m = d->m;

    switch (op & 3u) {
    case SMVM_ldx_plus & 3: return number(sm_from_u32(n));
    case SMVM_ldx_minus & 3: return number(sm_from_i32(-1 - (int32_t)n));
    case SMVM_ldx_f32 & 3: return number(sm_from_f32(sm_f32_from_bits(smvm_uint(m->image, m->f32s_at + 4 * n, 4))));
    default: return number(sm_from_bits(smvm_cell(m->image, m->f64s_at + 8 * n, 8)));
    }
}

// What ldx_ or ldy_ loads.
static Value loaded(const Decode *d, unsigned op)
{
    unsigned kind = op & 15u;

    if (op == SMVM_ldx_time || op == SMVM_ldy_time)
        return in_memory(SM_U64, THE_TIME, 0);
    if ((smvm_shape((uint8_t)op) & (SMVM_SHAPE_L | SMVM_SHAPE_E)) == 0)
        return constant(d, op, d->n[0]);
    return in_memory(kind, smvm_shape((uint8_t)op) & SMVM_SHAPE_L ? A_LOCAL : AN_ELEMENT, d->n[0] * size_of_kind(kind));
}

static bool is_memory(const Value *v) { return v->kind <= FAST_RAW; }
static bool is_f(const Value *v) { return v->kind == FAST_A; }
static bool is_number(const Value *v) { return v->kind == FAST_C; }
static bool is_integer(const Value *v) { return v->kind <= SM_U64; }         // the types up to it
static bool is_zero(const Value *v) { return is_number(v) && sm_eq(v->c, sm_from_i32(0)); }

// Whether it cannot be NaN, which reads as 0 from all but RAW.
static bool is_never_nan(const Value *v) { return v->kind < FAST_RAW || (is_number(v) && !sm_is_nan(v->c)); }

// Whether c is a whole number in -limit … limit, and gives it.
static bool is_whole(SmF64 c, int64_t limit, int64_t *v)
{
    if (!sm_le(sm_from_i64(-limit), c) || !sm_le(c, sm_from_i64(limit)))
        return false;
    *v = sm_to_i64(c);
    return sm_eq(sm_from_i64(*v), c);
}

static void swap(Value *x, Value *y)
{
    Value t = *x;

    *x = *y;
    *y = t;
}

// Whether nobody reads X behind this instruction.  (Who jumps leads to where X is loaded.)
static bool is_x_dead(const Decode *d)
{
    SmvmAt at = d->at;

    for (;;) {
        uint32_t shape = smvm_shape(smvm_u8(d->m->image, at++));
        if ((shape & SMVM_SHAPE_X) != 0)
            return false;
        if ((shape & (SMVM_SHAPE_GX | SMVM_SHAPE_Z)) != 0)
            return true;
        while (smvm_u8(d->m->image, at) < SMVM_OP_LEAST)         // Y is loaded
            at++;
    }
}

// ---- families: the first instruction of one and the value's kind make the instruction ----

static void put_load(Decode *d, const Value *x)
{
    if (is_f(x))
        return;
    put_op(d, is_number(x) ? FAST_LD_C_OP : (unsigned)FAST_LD_I8_OP + x->kind);
    put_value(d, x);
}

static void put_with(Decode *d, FastOp family, const Value *y)               // F and y
{
    put_op(d, (unsigned)family + y->kind);
    put_value(d, y);
}

static void put_pair(Decode *d, FastOp family, const Value *x, const Value *y)         // x in memory, y there too or a number
{
    put_op(d, (unsigned)family + x->kind);
    put_value(d, x);
    put_value(d, y);
}

// ---- windows ----

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

static unsigned sampling(uint32_t kind, bool memory)
{
    static const uint16_t family[2][3] = {{FAST_PUSH_MEDIAN_I16_OP, FAST_PUSH_AVG_I16_OP, FAST_PUSH_ENDS_I16_OP},
                                          {FAST_TAKE_MEDIAN_I16_OP, FAST_TAKE_AVG_I16_OP, FAST_TAKE_ENDS_I16_OP}};
    unsigned type, use = made_for(kind, &type);

    return use == FOR_NONE ? (unsigned)FAST_SAMPLE_OP : family[memory][use] + type;
}

static unsigned asking(uint32_t kind, uint32_t stat, bool store)
{
    static const uint16_t family[2][3] = {{FAST_MEDIAN_I16_OP, FAST_AVG_I16_OP, FAST_RANGE_I16_OP},
                                          {FAST_MEDIANN_I16_OP, FAST_AVGN_I16_OP, FAST_RANGEN_I16_OP}};
    static const uint8_t made_to_ask[] = {SM_STAT_MEDIAN, SM_STAT_AVG, SM_STAT_RANGE};
    unsigned type, use = made_for(kind, &type);

    return use == FOR_NONE || stat != made_to_ask[use] ? (unsigned)FAST_STAT_OP : family[store][use] + type;
}

static uint32_t kind_of(const Decode *d, uint32_t w) { return smvm_window(d->m->image, d->m->windows_at, w) >> SMVM_WINDOW_SIZE_BITS; }

// ---- operations, which give F ----

static void put_one(Decode *d, uint8_t op, const Value *x)
{
    static const uint16_t plain[] = {FAST_NEG_OP, FAST_ABS_OP, FAST_FLOOR_OP, FAST_CEIL_OP, FAST_TRUNC_OP, FAST_ROUND_OP, FAST_SQRT_OP, FAST_SIGN_OP};

    put_load(d, x);
    put_op(d, plain[op - SMVM_neg]);
}

// An operation of two, in its forms: F op y, x in memory op a number, a number op y in memory, two in memory of one type.
typedef struct Forms { uint16_t with, number, number_first, pair; } Forms;

static const Forms forms[] = {                        // from SMVM_add to SMVM_or; 0: there is no such form
    {FAST_ADD_I8_OP, FAST_ADDC_I8_OP, FAST_ADDC_I8_OP, FAST_ADD2_I8_OP},
    {FAST_SUB_I8_OP, FAST_ADDC_I8_OP, FAST_RSUBC_I8_OP, FAST_SUB2_I8_OP},
    {FAST_MUL_I8_OP, FAST_MULC_I8_OP, FAST_MULC_I8_OP, FAST_MUL2_I8_OP},
    {FAST_DIV_I8_OP, FAST_DIVC_I8_OP, FAST_RDIVC_I8_OP, FAST_DIV2_I8_OP},
    {FAST_MIN_I8_OP, 0, 0, 0},
    {FAST_MAX_I8_OP, 0, 0, 0},
    {FAST_AND_I8_OP, 0, 0, 0},
    {FAST_OR_I8_OP, 0, 0, 0},
};

static void put_two(Decode *d, uint8_t op, Value x, Value y)
{
    const Forms *f = &forms[op - SMVM_add];

    if (op == SMVM_sub && is_number(&y)) {            // x - c is x + -c, of zeros too
        y.c = sm_neg(y.c);
        f = &forms[0];
    }
    if (is_f(&x)) {
        put_with(d, (FastOp)f->with, &y);
    } else if (is_f(&y)) {                            // of sub only
        put_with(d, FAST_RSUB_I8_OP, &x);
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
}

// ---- relations: sums of SMVM_LESS and so on, of x to y ----

enum { IS_TRUE = SMVM_LESS | SMVM_GREATER, IS_FALSE = SMVM_EQUAL | SMVM_UNORDERED };       // of x to 0

static unsigned mirrored(unsigned m) { return (m & 10u) | (m & SMVM_LESS) << 2 | (m & SMVM_GREATER) >> 2; }

static unsigned relation(SmF64 x, SmF64 y)
{
    if (sm_lt(x, y))
        return SMVM_LESS;
    return sm_lt(y, x) ? SMVM_GREATER : sm_eq(x, y) ? SMVM_EQUAL : SMVM_UNORDERED;
}

// m without what cannot be: 0 if nothing is left, 15 if nothing else can be.
static unsigned possible(unsigned m, const Value *x, const Value *y)
{
    unsigned can = is_never_nan(x) && is_never_nan(y) ? 7u : 15u;

    return (m & can) == 0 ? 0 : (m & can) == can ? 15u : m & can;
}

// m, or where no NaN is about the same with UNORDERED if there is an instruction for that only: for not equal.
static unsigned with_nan(unsigned m, const Value *x, const Value *y)
{
    return m == IS_TRUE && is_never_nan(x) && is_never_nan(y) ? m | SMVM_UNORDERED : m;
}

static void put_set(Decode *d, unsigned m, Value x, Value y)
{
    static const uint16_t of[16] = {0, FAST_LT_I8_OP, FAST_EQ_I8_OP, FAST_LE_I8_OP, FAST_GT_I8_OP, 0, FAST_GE_I8_OP, 0, 0, 0, 0, 0, 0, FAST_NE_I8_OP, 0, 0};
    Value c;

    m = possible(m, &x, &y);
    if (m == 0 || m == 15) {
        c = number(sm_from_bool(m != 0));
        put_load(d, &c);
        return;
    }
    m = with_nan(m, &x, &y);
    put_load(d, &x);
    if (is_zero(&y) && of[m] == 0 && (m == IS_TRUE || m == IS_FALSE)) {
        put_op(d, m == IS_TRUE ? FAST_TRUTH_OP : FAST_NOT_OP);
        return;
    }
    put_with(d, (FastOp)(of[m] != 0 ? of[m] : FAST_REL_I8_OP), &y);
    if (of[m] == 0)
        put_u(d, m);
}

// ---- X that waits ----

// Puts what X waits for: then it is in F.
static void compute(Decode *d)
{
    const Later *l = &d->later;

    if (l->op == SMVM_stat) {
        put_op(d, asking(kind_of(d, l->w), l->n, false));
        put_window(d, l->w);
        put_u(d, l->n);
    } else if (l->op == SMVM_set) {
        put_set(d, l->n, l->a, l->b);
    } else if (l->op == SMVM_cvt) {
        put_load(d, &l->a);
        put_op(d, (unsigned)FAST_CVT_I8_OP + l->n);
    } else if (l->op < SMVM_neg) {
        put_two(d, l->op, l->a, l->b);
    } else {
        put_one(d, l->op, &l->a);
    }
    d->x.kind = FAST_A;
}

static Value *x_of(Decode *d)                         // X to be read: not waiting
{
    if (d->x.kind == LATER)
        compute(d);
    return &d->x;
}

static void load_x(Decode *d)                         // into F
{
    put_load(d, x_of(d));
    d->x.kind = FAST_A;
}

// Whether X is as a local of this type would keep it: it was read from one, or is 0 or 1, which all types have.
static bool is_of_type(const Decode *d, uint32_t type)
{
    const uint8_t kind = d->x.kind, op = d->later.op;

    return kind == type || kind == SM_BOOL || (kind == LATER && (op == SMVM_set || op == SMVM_and || op == SMVM_or));
}

// X = op of X, or of X and y.
static void wait_for(Decode *d, uint8_t op, Value y)
{
    bool opposite = d->x.kind == LATER && d->later.op == SMVM_neg && op == SMVM_add;       // y + -a is y - a
    Value x;

    if (op == SMVM_cvt && is_of_type(d, d->n[0]))
        return;
    x = opposite ? d->later.a : *x_of(d);
    memset(&d->later, 0, sizeof d->later);
    d->later.op = opposite ? SMVM_sub : op;
    d->later.n = d->n[0];
    d->later.w = d->n[1];
    d->later.a = opposite ? y : x;
    d->later.b = opposite ? x : y;
    d->x.kind = LATER;
}

// ---- storing ----

typedef struct Place { Value to; bool output; uint32_t index; } Place;       // of an output its number

// Up to the destination.  That an output is written stands in the first 64 bits, or for others in a bit of a byte: which byte
// above, mask in the low eight bits.
static void put_written(Decode *d, FastOp family, FastOp noting, unsigned which, const Place *to)
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
    put_value(d, &to->to);
}

static void put_number(Decode *d, const Place *to, SmF64 c)      // to memory: as it will lie there
{
    unsigned kind = to->to.kind;
    uint64_t cell = kind == FAST_RAW ? sm_bits(smvm_raw(c)) : sm_cell_from_f64((SmType)kind, c);

    put_written(d, FAST_SET_1_OP, FAST_SETN_1_OP, smvm_type_shift(kind), to);
    put_u(d, cell);
}

// `to = x + c`, both of one integer type, c whole and small, and X not used again.  False if it is not that.
static bool put_count(Decode *d, const Place *to)
{
    Value x = d->later.a, y = d->later.b;
    int64_t c;

    if (d->x.kind != LATER || (d->later.op != SMVM_add && d->later.op != SMVM_sub) || !is_x_dead(d))
        return false;
    if (d->later.op == SMVM_add && is_number(&x))
        swap(&x, &y);
    if (!is_integer(&x) || to->to.kind != x.kind || !is_number(&y) || !is_whole(y.c, INT32_MAX, &c))
        return false;
    put_written(d, FAST_INC_I8_OP, FAST_INCN_I8_OP, x.kind, to);
    put_value(d, &x);
    put_u(d, (uint64_t)(d->later.op == SMVM_sub ? -c : c));
    return true;
}

// `to = F op y`, of an output or local of F32 or F64; y is one of that type, or a number.  False if it is not that.
static bool put_operation_to(Decode *d, const Place *to)
{
    static const uint16_t family[2][4][2] = {
        {{FAST_ADDST_F32_OP, FAST_ADDSTN_F32_OP}, {FAST_SUBST_F32_OP, FAST_SUBSTN_F32_OP}, {FAST_MULST_F32_OP, FAST_MULSTN_F32_OP},
         {FAST_DIVST_F32_OP, FAST_DIVSTN_F32_OP}},
        {{FAST_ADDCST_F32_OP, FAST_ADDCSTN_F32_OP}, {FAST_ADDCST_F32_OP, FAST_ADDCSTN_F32_OP}, {FAST_MULCST_F32_OP, FAST_MULCSTN_F32_OP},
         {FAST_DIVCST_F32_OP, FAST_DIVCSTN_F32_OP}},
    };
    Value y = d->later.b;
    const uint8_t op = d->later.op;
    const uint16_t *f;

    if (d->x.kind != LATER || op < SMVM_add || op > SMVM_div || !is_f(&d->later.a) || (to->to.kind != SM_F32 && to->to.kind != SM_F64))
        return false;
    if (y.kind != to->to.kind && !is_number(&y))
        return false;
    if (is_number(&y) && op == SMVM_sub)
        y.c = sm_neg(y.c);
    f = family[is_number(&y)][op - SMVM_add];
    put_written(d, (FastOp)f[0], (FastOp)f[1], to->to.kind - (unsigned)SM_F32, to);
    put_value(d, &y);
    d->x.kind = FAST_A;
    return true;
}

// The same of a statistic that there is an instruction for, to one of the first 64 outputs.
static bool put_statistic_to(Decode *d, const Place *to)
{
    uint32_t kind;

    if (d->x.kind != LATER || d->later.op != SMVM_stat || !to->output || to->index >= 64)
        return false;
    kind = kind_of(d, d->later.w);
    if ((kind & SM_ROLL_TYPE) != to->to.kind || asking(kind, d->later.n, true) == FAST_STAT_OP)
        return false;
    put_op(d, asking(kind, d->later.n, true));
    put_u(d, (uint64_t)1 << to->index);
    put_value(d, &to->to);
    put_window(d, d->later.w);
    put_u(d, d->later.n);
    d->x.kind = FAST_A;
    return true;
}

// X to where it goes.  Where X still lies in memory, it is the same behind a move: what overlaps that and is of its type is that.
static void put_store(Decode *d, const Place *to)
{
    if (put_count(d, to) || put_operation_to(d, to) || put_statistic_to(d, to))
        return;
    if (is_number(x_of(d))) {
        put_number(d, to, d->x.c);
    } else if (d->x.kind == to->to.kind) {
        put_written(d, FAST_MOV_I8_OP, FAST_MOVN_I8_OP, d->x.kind, to);
        put_value(d, &d->x);
    } else {
        load_x(d);
        put_written(d, FAST_ST_I8_OP, FAST_STN_I8_OP, to->to.kind, to);
    }
}

static void decode_store(Decode *d, uint8_t op)
{
    Place to;
    SmvmPlace p;

    to.output = op == SMVM_out;
    to.index = d->n[0];
    if (to.output) {
        p = smvm_output(d->m, d->n[0]);
        to.to = in_memory(p.type, AN_ELEMENT, p.offset);
    } else {
        to.to = in_memory(op & 15u, A_LOCAL, d->n[0] * size_of_kind(op & 15u));
    }
    put_store(d, &to);
}

// ---- jumps ----

// A condition by its relations, in its forms: F and y; two in memory of one type; one in memory and a number; an integer and a whole
// number.  0: there is none, for NaN is in some as well as in others of one line.
typedef struct Condition { uint16_t with, pair, number, whole; } Condition;

static const Condition conditions[16] = {
    {0, 0, 0, 0},
    {FAST_JLT_I8_OP, FAST_JLT2_I8_OP, FAST_JLTC_I8_OP, FAST_JLTI_I8_OP},
    {FAST_JEQ_I8_OP, FAST_JEQ2_I8_OP, FAST_JEQC_I8_OP, FAST_JEQI_I8_OP},
    {FAST_JLE_I8_OP, FAST_JLE2_I8_OP, FAST_JLEC_I8_OP, FAST_JLEI_I8_OP},
    {FAST_JGT_I8_OP, 0, FAST_JGTC_I8_OP, FAST_JGTI_I8_OP},
    {0, 0, 0, 0},
    {FAST_JGE_I8_OP, 0, FAST_JGEC_I8_OP, FAST_JGEI_I8_OP},
    {0, 0, 0, 0},
    {0, 0, 0, 0},
    {FAST_JNGE_I8_OP, 0, FAST_JNGEC_I8_OP, 0},
    {0, 0, 0, 0},
    {FAST_JNGT_I8_OP, 0, FAST_JNGTC_I8_OP, 0},
    {FAST_JNLE_I8_OP, 0, FAST_JNLEC_I8_OP, 0},
    {FAST_JNE_I8_OP, FAST_JNE2_I8_OP, FAST_JNEC_I8_OP, FAST_JNEI_I8_OP},
    {FAST_JNLT_I8_OP, 0, FAST_JNLTC_I8_OP, 0},
    {0, 0, 0, 0},
};

static void put_jump(Decode *d, unsigned op, uint32_t target)
{
    put_op(d, op);
    put_target(d, target);
}

static void put_jump_truth(Decode *d, bool when, const Value *x, uint32_t target)
{
    if (is_memory(x)) {
        put_jump(d, (when ? (unsigned)FAST_JT_I8_OP : (unsigned)FAST_JF_I8_OP) + x->kind, target);
        put_value(d, x);
        return;
    }
    put_load(d, x);
    put_jump(d, when ? FAST_JT_A_OP : FAST_JF_A_OP, target);
}

// F and y; F may be NaN.
static void put_jump_with(Decode *d, unsigned m, const Value *y, uint32_t target)
{
    unsigned with = conditions[m].with;

    if (is_zero(y) && (m == IS_TRUE || m == IS_FALSE)) {
        put_jump(d, m == IS_TRUE ? FAST_JT_A_OP : FAST_JF_A_OP, target);
        return;
    }
    put_jump(d, (with != 0 ? with : (unsigned)FAST_JREL_I8_OP) + y->kind, target);
    put_value(d, y);
    if (with == 0)
        put_u(d, m);
}

// x in memory and a number.  Elements and locals are compared as they are, a NaN among them too: of it the form makes what is made of 0.
static void put_jump_number(Decode *d, unsigned m, const Value *x, const Value *c, uint32_t target)
{
    int64_t v;

    if (is_integer(x) && is_whole(c->c, ((int64_t)1 << 53) - 1, &v) && (v >= 0 || x->kind != SM_U64)) {
        put_jump(d, (unsigned)conditions[with_nan(m, x, c)].whole + x->kind, target);
        put_value(d, x);
        put_u(d, (uint64_t)v);
        return;
    }
    if (is_never_nan(x))
        m = (m & 7u) | ((m & relation(sm_from_i32(0), c->c)) != 0 ? SMVM_UNORDERED : 0u);
    if (is_zero(c) && (m == IS_TRUE || m == IS_FALSE))
        put_jump_truth(d, m == IS_TRUE, x, target);
    else if (conditions[m].number != 0) {
        put_jump(d, (unsigned)conditions[m].number + x->kind, target);
        put_value(d, x);
        put_value(d, c);
    } else {
        put_load(d, x);
        put_jump_with(d, m, c, target);
    }
}

// Whether there is a form with y before x only.
static bool is_swapped(unsigned m, const Value *x, const Value *y)
{
    return is_memory(y) && (is_number(x) || (x->kind == y->kind && (m == SMVM_GREATER || m == (SMVM_GREATER | SMVM_EQUAL))));
}

static void put_jump_if(Decode *d, unsigned m, Value x, Value y, uint32_t target)
{
    m = possible(m, &x, &y);
    if (m == 0)
        return;
    if (m == 15) {
        put_jump(d, FAST_JMP_OP, target);
        return;
    }
    if (is_swapped(m, &x, &y)) {
        swap(&x, &y);
        m = mirrored(m);
    }
    if (is_memory(&x) && is_number(&y)) {
        put_jump_number(d, m, &x, &y, target);
    } else if (is_memory(&x) && is_never_nan(&x) && x.kind == y.kind) {
        put_jump(d, (unsigned)conditions[with_nan(m, &x, &y)].pair + x.kind, target);
        put_value(d, &x);
        put_value(d, &y);
    } else {
        m = with_nan(m, &x, &y);
        put_load(d, &x);
        put_jump_with(d, m, &y, target);
    }
}

// jt and jf.  Of what was only just compared the condition is the jump's.
static void decode_jump_truth(Decode *d, bool when, uint32_t target)
{
    if (d->x.kind == LATER && d->later.op == SMVM_set)
        put_jump_if(d, when ? d->later.n : 15u - d->later.n, d->later.a, d->later.b, target);
    else
        put_jump_truth(d, when, x_of(d), target);
}

static void decode_jump(Decode *d, uint8_t op)
{
    bool counted = (smvm_shape(op) & SMVM_SHAPE_N) != 0;
    uint32_t target = (uint32_t)(d->at + d->n[counted] - d->start);
    Value y = counted ? number(sm_from_u32(d->n[0])) : d->y;

    if (op == SMVM_jmp)
        put_jump(d, FAST_JMP_OP, target);
    else if (op == SMVM_jt || op == SMVM_jf)
        decode_jump_truth(d, op == SMVM_jt, target);
    else
        put_jump_if(d, op & 15u, *x_of(d), y, target);
}

// ---- instructions ----

static void decode_sample(Decode *d)
{
    uint32_t kind = kind_of(d, d->n[0]);
    const Value *x = x_of(d);
    bool memory = is_memory(x) && x->kind == (kind & SM_ROLL_TYPE) && sampling(kind, true) != FAST_SAMPLE_OP;

    if (!memory)
        load_x(d);
    put_op(d, sampling(kind, memory));
    put_window(d, d->n[0]);
    if (memory)
        put_value(d, x);
}

// A transition: to the end of the step, or where the state's .exit will begin.
static void put_go(Decode *d, uint32_t state)
{
    uint64_t before = d->goes;

    put_op(d, FAST_GO_OP);
    d->goes = d->words;
    put_u(d, before);
    put_u(d, state);
}

// On to .step, which stands behind.
static void put_end_of_entry(Decode *d)
{
    if (d->at < d->end)
        put_jump(d, FAST_JMP_OP, (uint32_t)(d->end - d->start));
}

static void decode_end(Decode *d)
{
    if (d->in == IN_ENTRY)
        put_end_of_entry(d);
    else
        put_op(d, d->in == IN_SAMPLE ? FAST_BODY_OP : FAST_END_OP);
}

// What gives X, from itself or from nothing.
static void decode_operation(Decode *d, uint8_t op)
{
    if (op == SMVM_addi || op == SMVM_subi)
        wait_for(d, op == SMVM_addi ? SMVM_add : SMVM_sub, number(sm_from_u32(d->n[0])));
    else if (op == SMVM_stat) {
        d->x = number(sm_from_i32(0));
        wait_for(d, op, d->x);
    } else
        wait_for(d, op, d->y);
}

static void decode_instruction(Decode *d)
{
    uint8_t op = smvm_u8(d->m->image, d->at++);
    uint32_t shape = smvm_shape(op);

    for (unsigned i = 0; i < 2 && d->at < d->end && smvm_u8(d->m->image, d->at) < SMVM_OP_LEAST; i++)
        smvm_varint(d->m->image, &d->at, d->end, &d->n[i]);
    if ((shape & SMVM_SHAPE_J) != 0)
        decode_jump(d, op);
    else if (op == SMVM_goto)
        put_go(d, d->n[0]);
    else if (op == SMVM_end)
        decode_end(d);
    else if (op == SMVM_sample)
        decode_sample(d);
    else if ((shape & (SMVM_SHAPE_GX | SMVM_SHAPE_GY)) == 0)
        decode_store(d, op);
    else if ((shape & SMVM_SHAPE_GY) != 0)
        d->y = loaded(d, op);
    else if ((shape & SMVM_SHAPE_X) != 0 || op == SMVM_stat)
        decode_operation(d, op);
    else
        d->x = loaded(d, op);
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
        d->out->body[2 * s] = d->out->code + step;
        d->out->body[2 * s + 1] = d->out->code + (entry == THE_END ? step : entry);
    }
    link_goes(d, decode_function(d, 3 * s));
}

static void decode_machine(Decode *d)
{
    const bool clears = d->m->outputs > 64;
    bool samples;

    d->words = 0;
    put_op(d, FAST_END_OP);                           // THE_END
    if (clears)
        put_op(d, FAST_CLEAR_OP);
    d->in = IN_SAMPLE;
    samples = decode_function(d, 0) != THE_END;
    if (clears && !samples)
        put_op(d, FAST_BODY_OP);
    if (d->out != NULL)
        d->out->samples = clears || samples;
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
    return sizeof(SmvmDecoded) + (uint64_t)d.words * sizeof(SmvmWord) + 2 * ((uint64_t)m->states + 1) * sizeof(SmvmWord *)
        + ((uint64_t)d.longest + 1) * sizeof(uint32_t);
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
    out->g = (uint8_t *)sv + m->g;
    out->s = (uint8_t *)sv + m->s;
    out->parts = smvm_parts(vm, m);
    out->t = 0;
    out->code = (SmvmWord *)(out + 1);
    out->body = (const SmvmWord **)(out->code + words);
    d.where = (uint32_t *)(out->body + 2 * ((size_t)m->states + 1));
    d.place = out->place = smvm_fast_places();
    decode_machine(&d);
    return SM_OK;
}
