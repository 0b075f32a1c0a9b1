// SPDX-License-Identifier: Apache-2.0
// Runs the decoded form of a machine.  It gives bit for bit what the interpreter gives (interp.c), for the code is made of the same
// functions of stdlib; only whole numbers go another way where that cannot be told.
#include <string.h>

#include "bytecode-vm/fast.h"
#include "bytecode-vm/step.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

#ifdef __GNUC__
#define BRANCH __asm__ volatile("")
#else
#define BRANCH
#endif
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-gcse", "no-crossjumping")   // they bring the jumps from instruction to instruction together again
#endif

// ---- what the instructions of a type are made of; `w` is the word of the operand ----
//   get      what the language reads; `f` is F         put      stores as the language does
//   convert  what is read again after it was stored    true     whether it is not zero
//   whole    an integer as it is, U64 from 2^63 on as the last I64
//   move     from one place to another of the type     count    x + c, stored: w[0] = w[1] + w[2]

#define TYPE(K, ctype, from, to)                                                                                        \
    static inline ctype cell_##K(const SmvmWord *w) { ctype v; memcpy(&v, w->p, sizeof v); return v; }                  \
    static inline SmF64 get_##K(const SmvmWord *w, SmF64 f) { (void)f; return from(cell_##K(w)); }                      \
    static inline void put_##K(const SmvmWord *w, SmF64 x) { const ctype v = to(x); memcpy(w->p, &v, sizeof v); }       \
    static inline SmF64 convert_##K(SmF64 x) { return from(to(x)); }                                                    \
    static inline bool true_##K(const SmvmWord *w) { return sm_to_bool(from(cell_##K(w))); }

// Moved, a number of up to 32 bits stays what it is; sums of two are exact in 64 bits, and cut at the same ends.
#define SMALL(K, ctype, from, to, lo, hi)                                                                               \
    TYPE(K, ctype, from, to)                                                                                         \
    static inline int64_t whole_##K(const SmvmWord *w) { return cell_##K(w); }                                          \
    static inline void move_##K(const SmvmWord *d, const SmvmWord *x) { const ctype v = cell_##K(x); memcpy(d->p, &v, sizeof v); } \
    static inline void count_##K(const SmvmWord *w)                                                                     \
    {                                                                                                                   \
        const ctype v = (ctype)clip(cell_##K(w + 1) + w[2].i, lo, hi);                                               \
        memcpy(w->p, &v, sizeof v);                                                                                     \
    }

#define LARGE(K, ctype, from, to, count)                                                                                \
    TYPE(K, ctype, from, to)                                                                                         \
    static inline void move_##K(const SmvmWord *d, const SmvmWord *x) { put_##K(d, get_##K(x, sm_from_i32(0))); }       \
    static inline void count_##K(const SmvmWord *w)                                                                     \
    {                                                                                                                   \
        const ctype v = count(cell_##K(w + 1), (int32_t)w[2].i);                                                        \
        memcpy(w->p, &v, sizeof v);                                                                                     \
    }

#define FLOATING(K, ctype, from, to)                                                                                    \
    TYPE(K, ctype, from, to)                                                                                            \
    static inline void move_##K(const SmvmWord *d, const SmvmWord *x) { put_##K(d, get_##K(x, sm_from_i32(0))); }

static inline int64_t clip(int64_t x, int64_t lo, int64_t hi) { return x < lo ? lo : x > hi ? hi : x; }
// As sm_read_f64; by a branch that is hardly ever taken, where compilers put several dependent instructions.
static inline SmF64 read_f64(SmF64 x)
{
    if (sm_is_nan(x)) {
        BRANCH;
        return sm_from_i32(0);
    }
    return x;
}
static inline SmF64 read_f32(float v) { return read_f64(sm_from_f32(v)); }
static inline SmF64 from_byte(uint8_t v) { return sm_from_bool(v != 0); }
static inline SmF64 as_it_is(SmF64 x) { return x; }

SMALL(I8, int8_t, sm_from_i8, sm_to_i8, INT8_MIN, INT8_MAX)
SMALL(I16, int16_t, sm_from_i16, sm_to_i16, INT16_MIN, INT16_MAX)
SMALL(I32, int32_t, sm_from_i32, sm_to_i32, INT32_MIN, INT32_MAX)
LARGE(I64, int64_t, sm_from_i64, sm_to_i64, sm_count_i64)
SMALL(U8, uint8_t, sm_from_u8, sm_to_u8, 0, UINT8_MAX)
SMALL(U16, uint16_t, sm_from_u16, sm_to_u16, 0, UINT16_MAX)
SMALL(U32, uint32_t, sm_from_u32, sm_to_u32, 0, UINT32_MAX)
LARGE(U64, uint64_t, sm_from_u64, sm_to_u64, sm_count_u64)
FLOATING(F32, float, read_f32, sm_to_f32)
FLOATING(F64, SmF64, read_f64, sm_to_f64)
FLOATING(BOOL, uint8_t, from_byte, sm_to_bool)
FLOATING(RAW, SmF64, as_it_is, as_it_is)
static inline int64_t whole_I64(const SmvmWord *w) { return cell_I64(w); }
static inline int64_t whole_U64(const SmvmWord *w) { return cell_U64(w) > INT64_MAX ? INT64_MAX : (int64_t)cell_U64(w); }
static inline SmF64 get_C(const SmvmWord *w, SmF64 f) { (void)f; return w->f; }
static inline SmF64 get_A(const SmvmWord *w, SmF64 f) { (void)w; return f; }

#define SET(ctype, n) do { const ctype v_ = (ctype)ip[(n) + 1].u; memcpy(ip[n].p, &v_, sizeof v_); } while (0)
#define NOTE stored[ip[1].u >> 8] |= (uint8_t)ip[1].u       // an output is written: see note() of decode.c

// ---- what is too long to stand in the code of an instruction ----

static SmF64 root(SmF64 x) { return sm_sqrt(x); }
static void push(SmRoll *w, SmF64 x) { sm_roll_push(w, x); }
static SmF64 stat(const SmRoll *w, SmStat which) { return sm_roll_stat(w, which); }

// ---- running: each instruction goes straight to the next, or where C has no such thing through a switch ----

#if SMVM_COMPUTED_GOTO
#pragma GCC diagnostic ignored "-Wpedantic"
#define NEXT(n) ip += (n); goto *ip->go
#define BEGIN goto *ip->go;
#define FAST(name, ...) name##_: __VA_ARGS__
#define FINISH
#else
#define NEXT(n) ip += (n); continue
#define BEGIN for (;;) switch ((FastOp)ip->u) {
#define FAST(name, ...) case FAST_##name##_OP: __VA_ARGS__
#define FINISH case FAST_OPS: return 0; }
#endif
#define GO_IF(condition, n) if (condition) { NEXT(ip[1].i); } NEXT(n)

uint32_t smvm_fast_run(const SmvmDecoded *d, const void *const **places)
{
#if SMVM_COMPUTED_GOTO
    static const void *const place[] = {
#undef FAST
#define FAST(name, ...) &&name##_,
#include "bytecode-vm/fast.def"
#undef FAST
#define FAST(name, ...) name##_: __VA_ARGS__
    };
#else
    static const void *const *const place = NULL;
#endif
    const SmvmWord *ip;
    uint8_t *stored;
    uint32_t to = 0;
    SmF64 F = sm_from_i32(0);
    SmVm *vm;

    if (d == NULL) {
        *places = place;
        return 0;
    }
    vm = d->vm;
    stored = vm->stored;
    ip = d->code + 1;
    BEGIN
#include "bytecode-vm/fast.def"
    FINISH
}

// ---- the step ----

// As memset for n bytes; for up to eight without a call.
static void clear(uint8_t *p, uint32_t n)
{
    if (n > 8) {
        memset(p, 0, n);
    } else if (n >= 4) {
        memset(p, 0, 4);
        memset(p + n - 4, 0, 4);
    } else if (n > 0) {
        p[0] = p[n / 2] = p[n - 1] = 0;
    }
}

SmResult smvm_step_decoded(SmvmDecoded *d, void *sv)
{
    SmVm *vm = d->vm;

    if (sv != d->sv)
        return smvm_step(vm, sv);
    if (!smvm_begin(vm, sv))
        return SM_REFUSED;
    clear(vm->stored, (vm->outputs + 7u) / 8u);
    d->t = vm->last - vm->start;
    smvm_finish(vm, smvm_fast_run(d, NULL));
    return SM_OK;
}
