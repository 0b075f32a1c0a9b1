// SPDX-License-Identifier: Apache-2.0
// The contents of a register of the interpreter.  Internal to interp.c.
//
// The value is always an F64.  If floating point is done in software, a value that is a 32-bit integer is stored as one (`whole`), and
// operations on such values use integer arithmetic if their result is such a value too.  On an 8-bit computer that is ten times as fast.
// A whole 0 means +0; -0 is stored as an F64.
#ifndef SMVM_NUMBER_H
#define SMVM_NUMBER_H

#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/step.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

#if SM_F64_SOFT
typedef struct Number {
    union { int32_t whole; SmF64 real; } as;
    bool is_real;
} Number;

static inline void number_set_integer(Number *x, int32_t v)
{
    x->as.whole = v;
    x->is_real = false;
}

static inline void number_set_real(Number *x, SmF64 v)
{
    x->as.real = v;
    x->is_real = true;
}

SMVM_NOINLINE static SmF64 number_f64(const Number *x) { return x->is_real ? x->as.real : sm_from_i32(x->as.whole); }

// ---- memory ----

// Returns the upper or lower half of a value of eight bytes at p.
static inline uint32_t number_load_half(const uint8_t *p, bool upper)
{
    const uint16_t one = 1;
    uint8_t first;
    uint32_t half;

    memcpy(&first, &one, sizeof first);
    memcpy(&half, p + ((first == 1) == upper ? 4 : 0), sizeof half);
    return half;
}

// Loads a value whose type is F32, U32, I64 or U64, as an F64.  A separate function, so that loads of other types reserve no stack for it.
SMVM_NOINLINE static void number_load_wide(Number *x, uint8_t type, const uint8_t *p)
{
    uint32_t v;
    uint64_t w;

    if (type == SM_F32 || type == SM_U32) {
        memcpy(&v, p, sizeof v);
        number_set_real(x, type == SM_U32 ? sm_from_u32(v) : sm_read_f32(sm_f32_from_bits(v)));
    } else {
        memcpy(&w, p, sizeof w);
        number_set_real(x, type == SM_I64 ? sm_from_i64((int64_t)w) : sm_from_u64(w));
    }
}

// Loads an F64.  NaN becomes 0, unless `type` is RAW.
SMVM_NOINLINE static void number_load_f64(Number *x, uint8_t type, const uint8_t *p)
{
    const uint32_t upper = number_load_half(p, true);

    if (type == SM_F64 && (upper & 0x7FF00000u) == 0x7FF00000u && ((upper & 0xFFFFFu) | number_load_half(p, false)) != 0) {
        number_set_integer(x, 0);  // a NaN
        return;
    }
    memcpy(&x->as.real, p, sizeof x->as.real);
    x->is_real = true;
}

// Whether an I64 or U64, given as its halves, is an I32.
static bool number_is_small(uint8_t type, uint32_t upper, uint32_t lower)
{
    return lower <= INT32_MAX ? upper == 0 : type == SM_I64 && upper == UINT32_MAX;
}

SMVM_NOINLINE static void number_load(Number *x, uint8_t type, const uint8_t *p)
{
    int32_t whole;

    if (type == SM_F64 || type == SMVM_RAW) {
        number_load_f64(x, type, p);
        return;
    }
    if (type == SM_BOOL)
        whole = *p != 0;
    else if (type == SM_U8)
        whole = *p;
    else if (type == SM_I8)
        whole = *p < 0x80 ? *p : *p - 0x100;
    else if (type == SM_I16) {
        int16_t v;
        memcpy(&v, p, sizeof v);
        whole = v;
    } else if (type == SM_U16) {
        uint16_t v;
        memcpy(&v, p, sizeof v);
        whole = v;
    } else if (type == SM_I32 || (type == SM_U32 && !(p[0] & 0x80) && !(p[3] & 0x80)))
        memcpy(&whole, p, sizeof whole);
    else if ((type == SM_U64 || type == SM_I64) && number_is_small(type, number_load_half(p, true), number_load_half(p, false)))
        whole = (int32_t)number_load_half(p, false);
    else {
        number_load_wide(x, type, p);
        return;
    }
    number_set_integer(x, whole);
}

// Clips a value to the range of a type.
SMVM_NOINLINE static int32_t number_clip(int32_t v, uint8_t type)
{
    switch (type) {
    case SM_I8: return sm_clip_i32(v, INT8_MIN, INT8_MAX);
    case SM_I16: return sm_clip_i32(v, INT16_MIN, INT16_MAX);
    case SM_U8: return sm_clip_i32(v, 0, UINT8_MAX);
    case SM_U16: return sm_clip_i32(v, 0, UINT16_MAX);
    case SM_U32: case SM_U64: return v < 0 ? 0 : v;
    case SM_BOOL: return v != 0;
    default: return v;
    }
}

SMVM_NOINLINE static void number_write_bytes(int32_t v, uint8_t bytes, uint8_t *p)
{
    switch (bytes) {
    case 1: *p = (uint8_t)v; break;
    case 2: { const int16_t u = (int16_t)v; memcpy(p, &u, sizeof u); break; }
    case 4: memcpy(p, &v, sizeof v); break;
    default: { const int64_t u = v; memcpy(p, &u, sizeof u); }
    }
}

SMVM_NOINLINE static void number_write_real(SmF64 x, uint8_t type, uint8_t *p)
{
    switch (type) {
    case SM_I64: { const int64_t v = sm_to_i64(x); memcpy(p, &v, sizeof v); break; }
    case SM_U32: { const uint32_t v = sm_to_u32(x); memcpy(p, &v, sizeof v); break; }
    case SM_U64: { const uint64_t v = sm_to_u64(x); memcpy(p, &v, sizeof v); break; }
    case SM_F32: { const float v = sm_to_f32(x); memcpy(p, &v, sizeof v); break; }
    case SM_F64: { const SmF64 v = sm_to_f64(x); memcpy(p, &v, sizeof v); break; }
    case SM_BOOL: *p = sm_to_bool(x); break;
    default: { const SmF64 v = smvm_raw(x); memcpy(p, &v, sizeof v); }
    }
}

// Whether this is an integer type all values of which an I32 can represent.
static bool number_is_narrow(uint8_t type) { return type <= SM_I32 || type == SM_U8 || type == SM_U16; }

static void number_write_integer(int32_t v, uint8_t type, uint8_t *p)
{
    number_write_bytes(number_clip(v, type), (uint8_t)(1u << smvm_type_shift(type)), p);
}

SMVM_NOINLINE static void number_store_real(SmF64 x, uint8_t type, uint8_t *p)
{
    if (number_is_narrow(type))
        number_write_integer(sm_to_i32(x), type, p);
    else
        number_write_real(x, type, p);
}

SMVM_NOINLINE static void number_store(const Number *x, uint8_t type, uint8_t *p)
{
    if (!x->is_real && (type < SM_F32 || type == SM_BOOL))
        number_write_integer(x->as.whole, type, p);
    else
        number_store_real(number_f64(x), type, p);
}

// ---- operations ----

static bool number_is_true(const Number *x) { return x->is_real ? sm_to_bool(x->as.real) : x->as.whole != 0; }

SMVM_NOINLINE static uint8_t number_real_relation(const Number *x, const Number *y)
{
    return sm_soft_relation(sm_bits(number_f64(x)), sm_bits(number_f64(y)));
}

SMVM_INLINE uint8_t number_integer_relation(int32_t x, int32_t y) { return x == y ? SMVM_EQUAL : x < y ? SMVM_LESS : SMVM_GREATER; }

SMVM_NOINLINE static uint8_t number_relation(const Number *x, const Number *y)
{
    if (x->is_real || y->is_real)
        return number_real_relation(x, y);
    return number_integer_relation(x->as.whole, y->as.whole);
}

// Returns the relation of x, which must be stored as an F64, to n.
SMVM_NOINLINE static uint8_t number_real_relation_to(const Number *x, int32_t n)
{
    return sm_soft_relation(sm_bits(x->as.real), sm_bits(sm_from_i32(n)));
}

static inline uint8_t number_relation_to(const Number *x, int32_t n)
{
    return x->is_real ? number_real_relation_to(x, n) : number_integer_relation(x->as.whole, n);
}

static inline bool number_is_related(const Number *x, const Number *y, uint8_t m) { return (number_relation(x, y) & m) != 0; }

// Operations on whole numbers, which store their result in *x. They return false, and store nothing, if the result is not a 32-bit integer or
// would be -0; the caller then computes the result as an F64.
static bool number_try_add(Number *x, int32_t a, int32_t b)
{
    if (b < 0 ? a < INT32_MIN - b : a > INT32_MAX - b)
        return false;
    x->as.whole = a + b;
    return true;
}

// X = a * b if the exact product is certain to fit and is not a negative zero; otherwise returns false and changes nothing.
static bool number_try_mul(Number *x, int32_t a, int32_t b)
{
    if (sm_clip_i32(a, INT16_MIN, INT16_MAX) != a || sm_clip_i32(b, INT16_MIN, INT16_MAX) != b
        || ((a | b) < 0 && (a == 0 || b == 0)))
        return false;
    x->as.whole = a * b;
    return true;
}

// Computes X op b in integers; returns false if the result needs floating point.
static bool number_try_integer_binary(Number *x, uint8_t op, int32_t b)
{
    const int32_t a = x->as.whole;

    switch (op) {
    case SMVM_add: return number_try_add(x, a, b);
    case SMVM_sub: return b != INT32_MIN && number_try_add(x, a, -b);
    case SMVM_mul: return number_try_mul(x, a, b);
    case SMVM_min: x->as.whole = a < b ? a : b; return true;
    case SMVM_max: x->as.whole = a > b ? a : b; return true;
    default: return false;
    }
}

// Computes op of X in integers; returns false if the result needs floating point.
static bool number_try_integer_unary(Number *x, uint8_t op)
{
    const int32_t a = x->as.whole;

    switch (op) {
    case SMVM_neg: if (a == 0) return false; // fall through
    case SMVM_abs:
        if (a == INT32_MIN)
            return false;
        if (a < 0 || op == SMVM_neg)
            x->as.whole = -a;
        return true;
    case SMVM_sqrt: return false;
    case SMVM_sign: x->as.whole = sm_sign_i32(a); return true;
    default: return true;                             // floor, ceil, trunc, round: unchanged
    }
}

static uint64_t number_min(uint64_t a, uint64_t b) { return sm_bits(sm_min(sm_from_bits(a), sm_from_bits(b))); }
static uint64_t number_max(uint64_t a, uint64_t b) { return sm_bits(sm_max(sm_from_bits(a), sm_from_bits(b))); }

// Selects the operation first, then calls it through a pointer: one call for all operations is less code than one for each.
SMVM_NOINLINE static void number_real_binary(Number *x, uint8_t op, const Number *y)
{
    uint64_t (*f)(uint64_t a, uint64_t b) = sm_soft_add;

    if (op == SMVM_sub)
        f = sm_soft_sub;
    else if (op == SMVM_mul)
        f = sm_soft_mul;
    else if (op == SMVM_div)
        f = sm_soft_div;
    else if (op == SMVM_min)
        f = number_min;
    else if (op == SMVM_max)
        f = number_max;
    number_set_real(x, sm_from_bits(f(sm_bits(number_f64(x)), sm_bits(number_f64(y)))));
}

static SmF64 number_round(uint8_t op, SmF64 x)
{
    switch (op) {
    case SMVM_floor: return sm_floor(x);
    case SMVM_ceil: return sm_ceil(x);
    case SMVM_trunc: return sm_trunc(x);
    case SMVM_round: return sm_round(x);
    case SMVM_sqrt: return sm_sqrt(x);
    default: return sm_sign(x);
    }
}

SMVM_NOINLINE static void number_real_unary(Number *x, uint8_t op)
{
    const SmF64 a = number_f64(x);

    number_set_real(x, op == SMVM_neg ? sm_neg(a) : op == SMVM_abs ? sm_abs(a) : number_round(op, a));
}

// x = x op y for the opcodes SMVM_add to SMVM_max; x = op x, without y, for SMVM_neg to SMVM_sign.
SMVM_NOINLINE static void number_compute(Number *x, uint8_t op, const Number *y)
{
    if (op >= SMVM_neg) {
        if (x->is_real || !number_try_integer_unary(x, op))
            number_real_unary(x, op);
    } else if (x->is_real || y->is_real || !number_try_integer_binary(x, op, y->as.whole))
        number_real_binary(x, op, y);
}

#else
typedef SmF64 Number;

// If the interpreter is specialized, the following functions are called with a constant type or opcode and inlined, so each call becomes small.
#if SMVM_SPECIALIZE
#define NUMBER_INLINE SMVM_INLINE
#else
#define NUMBER_INLINE static inline
#endif

static inline void number_set_integer(Number *x, int32_t v) { *x = sm_from_i32(v); }
static inline void number_set_real(Number *x, SmF64 v) { *x = v; }
static inline SmF64 number_f64(const Number *x) { return *x; }

NUMBER_INLINE void number_load(Number *x, uint8_t type, const uint8_t *p)
{
    if (type == SMVM_RAW)
        memcpy(x, p, sizeof *x);
#if SMVM_SPECIALIZE
    else if (type == SM_F32) {
        float v;
        memcpy(&v, p, sizeof v);
        *x = smvm_read_f64(sm_from_f32(v));
    } else if (type == SM_F64) {
        memcpy(x, p, sizeof *x);
        *x = smvm_read_f64(*x);
    }
#endif
    else
        *x = sm_load((SmType)type, p);
}

NUMBER_INLINE void number_store(const Number *x, uint8_t type, uint8_t *p)
{
    const SmF64 raw = smvm_raw(*x);

    if (type == SMVM_RAW)
        memcpy(p, &raw, sizeof raw);
    else
        sm_store((SmType)type, p, *x);
}

static inline void number_store_real(SmF64 x, uint8_t type, uint8_t *p) { number_store(&x, type, p); }

static inline bool number_is_true(const Number *x) { return sm_to_bool(*x); }

static inline uint8_t number_relation(const Number *x, const Number *y)
{
    return sm_lt(*x, *y) ? SMVM_LESS : sm_lt(*y, *x) ? SMVM_GREATER : sm_eq(*x, *y) ? SMVM_EQUAL : SMVM_UNORDERED;
}

static inline uint8_t number_relation_to(const Number *x, int32_t n)
{
    const Number y = sm_from_i32(n);

    return number_relation(x, &y);
}

// Whether x and y are in one of the relations m, a constant: one or two comparisons.
SMVM_INLINE bool number_is_related(const Number *x, const Number *y, uint8_t m)
{
    const bool negated = (m & SMVM_UNORDERED) != 0;

    switch (negated ? m ^ SMVM_ANY_RELATION : m) {
    case SMVM_LESS: return sm_lt(*x, *y) != negated;
    case SMVM_EQUAL: return sm_eq(*x, *y) != negated;
    case SMVM_LESS | SMVM_EQUAL: return sm_le(*x, *y) != negated;
    case SMVM_GREATER: return sm_lt(*y, *x) != negated;
    case SMVM_LESS | SMVM_GREATER: return (sm_lt(*x, *y) || sm_lt(*y, *x)) != negated;
    case SMVM_GREATER | SMVM_EQUAL: return sm_le(*y, *x) != negated;
    default: return (sm_le(*x, *y) || sm_lt(*y, *x)) != negated;
    }
}

// x = x op y for the opcodes SMVM_add to SMVM_max; x = op x, without y, for SMVM_neg to SMVM_sign.
NUMBER_INLINE void number_compute(Number *x, uint8_t op, const Number *y)
{
    switch (op) {
    case SMVM_add: *x = sm_add(*x, *y); break;
    case SMVM_sub: *x = sm_sub(*x, *y); break;
    case SMVM_mul: *x = sm_mul(*x, *y); break;
    case SMVM_div: *x = sm_div(*x, *y); break;
    case SMVM_min: *x = sm_min(*x, *y); break;
    case SMVM_max: *x = sm_max(*x, *y); break;
    case SMVM_neg: *x = sm_neg(*x); break;
    case SMVM_abs: *x = sm_abs(*x); break;
    case SMVM_floor: *x = sm_floor(*x); break;
    case SMVM_ceil: *x = sm_ceil(*x); break;
    case SMVM_trunc: *x = sm_trunc(*x); break;
    case SMVM_round: *x = sm_round(*x); break;
    case SMVM_sqrt: *x = sm_sqrt(*x); break;
    default: *x = sm_sign(*x);
    }
}
#endif

#endif
