// SPDX-License-Identifier: Apache-2.0
// Creates the decoded form: declarations that the decoder's files share.  decode.c explains the method.
#ifndef SMVM_DECODE_H
#define SMVM_DECODE_H

#include "bytecode-vm/fast.h"
#include "bytecode-vm/image.h"
#include "stdlib/convert.h"

enum { DEFERRED = FAST_SOURCE_COUNT };                // a value of DecodedValue.kind: X is the result of an operation that is not emitted yet

// What the decoder knows about the contents of register X or Y of the bytecode.
typedef struct DecodedValue {
    uint8_t kind;             // SmType or FAST_RAW: a value of that type in memory; FAST_C: the constant c; FAST_IN_F: the value is in F; DEFERRED
    enum { A_LOCAL, AN_ELEMENT, THE_TIME } is;        // for a value in memory: it is a local, an element or T
    uint32_t offset;          // a value in memory: offset of the local or element, in bytes
    SmF64 c;                  // FAST_C: the constant
} DecodedValue;

// A deferred operation whose result is X.
typedef struct DeferredOp {
    uint8_t op;               // the opcode with two registers as operands: SMVM_sub also represents subi, SMVM_add addi
    uint32_t n, w;            // n: relations of set, type of cvt, or statistic; w: window
    DecodedValue a, b;        // the operands; b only if the operation has two
} DeferredOp;

typedef struct DecodeState {
    const SmvmMachine *m;
    SmvmDecoded *out;         // NULL in the first pass, which only counts words
    const void *const *label; // the address of each FastOp's code
    uint32_t *where;          // indexed by offset in the function: the word where that instruction begins
    uint32_t words;           // words written so far
    SmvmAt at, start, end;    // offsets in the image: the current position; start and end of the function
    uint32_t n[2];            // operands of the current instruction
    DecodedValue x, y;        // the contents of registers X and Y
    DeferredOp deferred;      // valid if x is DEFERRED
    uint32_t jumps;           // index of the last word that is an unresolved jump target; 0: none.  Each such word has the index of the one before
    uint32_t gotos;           // index of the last GO whose target is not resolved yet; 0: none
    uint32_t longest;         // size of the longest function, in bytes
    enum { IN_SAMPLE, IN_ENTRY, IN_OTHERS } in;       // which function is decoded: the sample function, an .entry, or another one
} DecodeState;

// The destination of a store.
typedef struct StoreTarget {
    DecodedValue to;          // the variable in memory
    bool output;              // `to` is an output; otherwise a local
    uint32_t index;           // if `to` is an output: the output's number, counted from 0
} StoreTarget;

// ---- values ----

static inline bool is_memory(const DecodedValue *v) { return v->kind <= FAST_RAW; }
static inline bool is_in_f(const DecodedValue *v) { return v->kind == FAST_IN_F; }
static inline bool is_constant(const DecodedValue *v) { return v->kind == FAST_C; }
static inline bool is_integer(const DecodedValue *v) { return v->kind <= SM_U64; }  // integer types have the numbers up to SM_U64
static inline bool is_zero(const DecodedValue *v) { return is_constant(v) && sm_eq(v->c, sm_from_i32(0)); }
static inline uint32_t size_of_kind(unsigned kind) { return 1u << smvm_type_shift(kind); }

// Whether v cannot be NaN.  A stored NaN reads as 0 in every type but RAW.
static inline bool is_never_nan(const DecodedValue *v) { return v->kind < FAST_RAW || (is_constant(v) && !sm_is_nan(v->c)); }

static inline void swap_values(DecodedValue *x, DecodedValue *y)
{
    DecodedValue t = *x;

    *x = *y;
    *y = t;
}

DecodedValue smvm_memory_operand(unsigned kind, unsigned is, uint32_t offset);
DecodedValue smvm_constant_operand(SmF64 c);
bool smvm_match_whole(SmF64 c, int64_t limit, int64_t *v);    // if c is a whole number in -limit … limit, sets *v to it and returns true

// ---- words (decode_words.c) ----

SmvmWord *smvm_next_word(DecodeState *d);             // where the next word is stored; NULL in the pass that counts words
void smvm_emit_op(DecodeState *d, unsigned op);
void smvm_emit_integer(DecodeState *d, uint64_t u);
void smvm_emit_operand(DecodeState *d, const DecodedValue *v);  // emits the address or constant of v; for F, an unused word
void smvm_emit_target(DecodeState *d, uint32_t target);  // emits the target of a jump, given as an offset in the function

void smvm_emit_load(DecodeState *d, const DecodedValue *x);         // emits code that loads x into F; nothing if x is there already
// In these two, `family` is the first instruction of a family of instructions; the kind of y selects one instruction of the family.
void smvm_emit_operation_on_f(DecodeState *d, FastOp family, const DecodedValue *y);         // emits an instruction with the operands F and y
void smvm_emit_two_operands(DecodeState *d, FastOp family, const DecodedValue *x, const DecodedValue *y);   // x: in memory; y: not F

// ---- X (decode_x.c) ----

enum { IS_TRUE = SMVM_LESS | SMVM_GREATER, IS_FALSE = SMVM_EQUAL | SMVM_UNORDERED };       // relations of x to 0

// Returns m, a set of relations of x to y, without the impossible ones: 0 if the condition is never true, 15 if it is always true.
unsigned smvm_possible_relations(unsigned m, const DecodedValue *x, const DecodedValue *y);

// Adds UNORDERED to m if m is `less or greater` and neither operand can be NaN.  The result, `not equal`, is then equivalent, and only that has
// an instruction.  Returns any other m unchanged.
unsigned smvm_add_unordered(unsigned m, const DecodedValue *x, const DecodedValue *y);

DecodedValue *smvm_compute_x(DecodeState *d);         // emits the deferred operation of X, if it has one; returns X, no longer DEFERRED
void smvm_move_x_to_f(DecodeState *d);                // emits code that loads X into F
void smvm_defer_operation(DecodeState *d, uint8_t op, DecodedValue y);  // defers X = op X, or X = X op y

// ---- windows (decode_window.c), stores (decode_store.c), jumps (decode_jump.c) ----

void smvm_decode_sample(DecodeState *d);
void smvm_emit_statistic(DecodeState *d);             // emits code that loads the deferred statistic of X into F
// Emits one instruction that computes the deferred statistic of X and stores it in `to`.  Returns false if no instruction does both.
bool smvm_try_emit_statistic_to(DecodeState *d, const StoreTarget *to);
void smvm_decode_store(DecodeState *d, uint8_t op);
void smvm_emit_jump(DecodeState *d, unsigned op, uint32_t target);
void smvm_decode_jump(DecodeState *d, uint8_t op);

#endif
