// SPDX-License-Identifier: Apache-2.0
// Making the decoded form: what the files of the decoder share.  What each does stands in decode.c.
#ifndef SMVM_DECODE_H
#define SMVM_DECODE_H

#include "bytecode-vm/fast.h"
#include "bytecode-vm/image.h"
#include "stdlib/convert.h"

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

// Where something is stored.
typedef struct Place {
    Value to;
    bool output;
    uint32_t index;           // of an output its number
} Place;

// ---- values ----

static inline bool is_memory(const Value *v) { return v->kind <= FAST_RAW; }
static inline bool is_f(const Value *v) { return v->kind == FAST_A; }
static inline bool is_number(const Value *v) { return v->kind == FAST_C; }
static inline bool is_integer(const Value *v) { return v->kind <= SM_U64; }         // the types up to it
static inline bool is_zero(const Value *v) { return is_number(v) && sm_eq(v->c, sm_from_i32(0)); }
static inline uint32_t size_of_kind(unsigned kind) { return 1u << smvm_type_shift(kind); }

// Whether it cannot be NaN, which reads as 0 from all but RAW.
static inline bool is_never_nan(const Value *v) { return v->kind < FAST_RAW || (is_number(v) && !sm_is_nan(v->c)); }

static inline void swap(Value *x, Value *y)
{
    Value t = *x;

    *x = *y;
    *y = t;
}

Value smvm_in_memory(unsigned kind, unsigned is, uint32_t offset);
Value smvm_constant(SmF64 c);
bool smvm_is_whole(SmF64 c, int64_t limit, int64_t *v);    // whether c is a whole number in -limit … limit, and gives it

// ---- words (decode_words.c) ----

SmvmWord *smvm_word(Decode *d);                       // the next one; NULL while words are counted
void smvm_put_op(Decode *d, unsigned op);
void smvm_put_u(Decode *d, uint64_t u);
void smvm_put_value(Decode *d, const Value *v);       // an address or a number; for F itself a word nobody reads
void smvm_put_target(Decode *d, uint32_t target);     // of a jump: its offset in the function

// The first instruction of a family and the value's kind make the instruction.
void smvm_put_load(Decode *d, const Value *x);
void smvm_put_with(Decode *d, FastOp family, const Value *y);                      // F and y
void smvm_put_pair(Decode *d, FastOp family, const Value *x, const Value *y);      // x in memory, y there too or a number

// ---- X (decode_x.c) ----

enum { IS_TRUE = SMVM_LESS | SMVM_GREATER, IS_FALSE = SMVM_EQUAL | SMVM_UNORDERED };       // of x to 0

// m without what cannot be: 0 if nothing is left, 15 if nothing else can be.
unsigned smvm_possible(unsigned m, const Value *x, const Value *y);

// m, or where no NaN is about the same with UNORDERED if there is an instruction for that only: for not equal.
unsigned smvm_with_nan(unsigned m, const Value *x, const Value *y);

Value *smvm_x_of(Decode *d);                          // X to be read: not waiting
void smvm_load_x(Decode *d);                          // into F
void smvm_wait_for(Decode *d, uint8_t op, Value y);   // X = op of X, or of X and y

// ---- windows (decode_window.c), stores (decode_store.c), jumps (decode_jump.c) ----

void smvm_decode_sample(Decode *d);
void smvm_put_statistic(Decode *d);                   // that X waits for, into F
bool smvm_put_statistic_to(Decode *d, const Place *to);
void smvm_decode_store(Decode *d, uint8_t op);
void smvm_put_jump(Decode *d, unsigned op, uint32_t target);
void smvm_decode_jump(Decode *d, uint8_t op);

#endif
