// SPDX-License-Identifier: Apache-2.0
// Creates the decoded form: declarations that the decoder's files share.  decode.c explains the method.
#ifndef SMVM_DECODE_H
#define SMVM_DECODE_H

#include "bytecode-vm/fast.h"
#include "bytecode-vm/image.h"
#include "stdlib/convert.h"

enum { LATER = FAST_SOURCE_COUNT };                   // as the kind of X: not computed yet

// The contents of a register.
typedef struct Value {
    uint8_t kind;             // a type or FAST_RAW: in memory, as that type; FAST_C: c; FAST_A: in F; LATER
    enum { A_LOCAL, AN_ELEMENT, THE_TIME } is;        // if it is in memory: what it is
    uint32_t offset;          // if it is in memory: in bytes
    SmF64 c;
} Value;

// A deferred operation whose result is X.
typedef struct Later {
    uint8_t op;               // SMVM_sub also for subi, and so on
    uint32_t n, w;            // n: relations of set, type of cvt, or statistic; w: window
    Value a, b;
} Later;

typedef struct Decode {
    const SmvmMachine *m;
    SmvmDecoded *out;         // NULL in the first pass, which only counts words
    const void *const *place; // the address of each FastOp's code
    uint32_t *where;          // indexed by offset in the function: the word where that instruction begins
    uint32_t words;           // words written so far
    SmvmAt at, start, end;    // in the image: the current position; start and end of the function
    uint32_t n[2];            // operands of the current instruction
    Value x, y;
    Later later;              // valid if x is LATER
    uint32_t jumps;           // the last word that is an unresolved jump target, or 0
    uint32_t goes;            // the last GO whose target is not resolved yet, or 0
    uint32_t longest;         // size of the longest function, in bytes
    enum { IN_SAMPLE, IN_ENTRY, IN_OTHERS } in;
} Decode;

// The destination of a store.
typedef struct Place {
    Value to;
    bool output;
    uint32_t index;           // the output's number
} Place;

// ---- values ----

static inline bool is_memory(const Value *v) { return v->kind <= FAST_RAW; }
static inline bool is_f(const Value *v) { return v->kind == FAST_A; }
static inline bool is_number(const Value *v) { return v->kind == FAST_C; }
static inline bool is_integer(const Value *v) { return v->kind <= SM_U64; }         // integer types have the numbers up to SM_U64
static inline bool is_zero(const Value *v) { return is_number(v) && sm_eq(v->c, sm_from_i32(0)); }
static inline uint32_t size_of_kind(unsigned kind) { return 1u << smvm_type_shift(kind); }

// Whether v cannot be NaN.  A stored NaN reads as 0 in every type but RAW.
static inline bool is_never_nan(const Value *v) { return v->kind < FAST_RAW || (is_number(v) && !sm_is_nan(v->c)); }

static inline void swap(Value *x, Value *y)
{
    Value t = *x;

    *x = *y;
    *y = t;
}

Value smvm_in_memory(unsigned kind, unsigned is, uint32_t offset);
Value smvm_constant(SmF64 c);
bool smvm_is_whole(SmF64 c, int64_t limit, int64_t *v);    // whether c is a whole number in -limit … limit; stores it in *v

// ---- words (decode_words.c) ----

SmvmWord *smvm_word(Decode *d);                       // the next one; NULL in the pass that counts words
void smvm_put_op(Decode *d, unsigned op);
void smvm_put_u(Decode *d, uint64_t u);
void smvm_put_value(Decode *d, const Value *v);       // an address or a number; for F itself a word that no instruction reads
void smvm_put_target(Decode *d, uint32_t target);     // of a jump: an offset in the function

// The kind of the value selects the instruction within the family; `family` is the family's first instruction.
void smvm_put_load(Decode *d, const Value *x);
void smvm_put_with(Decode *d, FastOp family, const Value *y);                      // F and y
void smvm_put_pair(Decode *d, FastOp family, const Value *x, const Value *y);      // x in memory; y in memory or a number

// ---- X (decode_x.c) ----

enum { IS_TRUE = SMVM_LESS | SMVM_GREATER, IS_FALSE = SMVM_EQUAL | SMVM_UNORDERED };       // relations of x to 0

// m without impossible relations: 0 if the condition is never true, 15 if it is always true.
unsigned smvm_possible(unsigned m, const Value *x, const Value *y);

// m; or, if neither operand can be NaN, an equivalent m with UNORDERED where an instruction exists only for that form (not equal).
unsigned smvm_with_nan(unsigned m, const Value *x, const Value *y);

Value *smvm_x_of(Decode *d);                          // X, ready to be read: computes a deferred operation
void smvm_load_x(Decode *d);                          // loads X into F
void smvm_wait_for(Decode *d, uint8_t op, Value y);   // X = op of X, or of X and y

// ---- windows (decode_window.c), stores (decode_store.c), jumps (decode_jump.c) ----

void smvm_decode_sample(Decode *d);
void smvm_put_statistic(Decode *d);                   // loads the deferred statistic of X into F
bool smvm_put_statistic_to(Decode *d, const Place *to);
void smvm_decode_store(Decode *d, uint8_t op);
void smvm_put_jump(Decode *d, unsigned op, uint32_t target);
void smvm_decode_jump(Decode *d, uint8_t op);

#endif
