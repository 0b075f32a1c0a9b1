// SPDX-License-Identifier: Apache-2.0
// Runs the decoded form of a machine.  Its results equal those of the interpreter (interp.c) bit for bit, because it uses the same
// functions of stdlib.  Only whole numbers take another path, where no difference can be observed.
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 8
#define SM_ROLL_UNROLL _Pragma("GCC unroll 4")         // for loops over short windows (stdlib/roll.h), whose size is not a constant here
#endif
#include <string.h>

#include "bytecode-vm/fast.h"
#include "bytecode-vm/fast_window.h"
#include "bytecode-vm/step.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-gcse", "no-crossjumping", "no-tree-tail-merge")   // these optimisations would merge the jumps between instructions into one
#pragma GCC optimize("no-tree-fre", "no-tree-pre")     // these optimisations take a third of gcc's time for this file and gain nothing
#endif

// ---- functions for each type K, used by the instructions of fast.h; `w` is the word of an operand ----
//   cell_K     the value in memory, in its C type
//   get_K      the value as the language reads it; `f`, the register F, is not used
//   bare_K     the value as the language reads it, except that a stored NaN remains NaN
//   put_K      stores x as the language does
//   convert_K  x after it is stored and read again
//   true_K     whether the value is neither zero nor NaN
//   whole_K    an integer as a 64-bit integer
//   number_K   the constant in a word, to compare with whole_K
//   move_K     stores the value of x at d; both have type K
//   increment_K  w[0] = w[1] + w[2], where w[0] and w[1] are in memory and w[2] is a constant

#define DEFINE_TYPE(K, ctype, from, to, bare, is_true)                                                                          \
    static inline ctype cell_##K(const SmvmWord *w) { ctype v; memcpy(&v, w->p, sizeof v); return v; }                          \
    static inline SmF64 get_##K(const SmvmWord *w, SmF64 f) { (void)f; return from(cell_##K(w)); }                              \
    static inline void put_##K(const SmvmWord *w, SmF64 x) { const ctype v = to(x); memcpy(w->p, &v, sizeof v); }               \
    static inline SmF64 bare_##K(const SmvmWord *w) { return bare(cell_##K(w)); }                                               \
    static inline SmF64 convert_##K(SmF64 x) { return from(to(x)); }                                                            \
    static inline bool true_##K(const SmvmWord *w) { return is_true(cell_##K(w)); }

// Integers of up to 32 bits: a move copies them unchanged.  A sum of two is exact in 64 bits, so clipping it equals storing an F64 sum.
#define DEFINE_SMALL_INTEGER(K, ctype, from, to, lo, hi)                                                                        \
    DEFINE_TYPE(K, ctype, from, to, from, is_not_zero)                                                                          \
    static inline int64_t whole_##K(const SmvmWord *w) { return cell_##K(w); }                                                  \
    static inline int64_t number_##K(const SmvmWord *w) { return w->i; }                                                        \
    static inline void move_##K(const SmvmWord *d, const SmvmWord *x) { const ctype v = cell_##K(x); memcpy(d->p, &v, sizeof v); } \
    static inline void increment_##K(const SmvmWord *w)                                                                         \
    {                                                                                                                           \
        const ctype v = (ctype)clip_to(cell_##K(w + 1) + w[2].i, lo, hi);                                                       \
        memcpy(w->p, &v, sizeof v);                                                                                             \
    }

#define DEFINE_LARGE_INTEGER(K, ctype, from, to, count)                                                                         \
    DEFINE_TYPE(K, ctype, from, to, from, is_not_zero)                                                                          \
    static inline void move_##K(const SmvmWord *d, const SmvmWord *x) { put_##K(d, get_##K(x, sm_from_i32(0))); }               \
    static inline void increment_##K(const SmvmWord *w)                                                                         \
    {                                                                                                                           \
        const ctype v = count(cell_##K(w + 1), (int32_t)w[2].i);                                                                \
        memcpy(w->p, &v, sizeof v);                                                                                             \
    }

#define DEFINE_OTHER(K, ctype, from, to, bare, is_true)                                                                         \
    DEFINE_TYPE(K, ctype, from, to, bare, is_true)                                                                              \
    static inline void move_##K(const SmvmWord *d, const SmvmWord *x) { put_##K(d, get_##K(x, sm_from_i32(0))); }

static inline int64_t clip_to(int64_t x, int64_t lo, int64_t hi) { return x < lo ? lo : x > hi ? hi : x; }
static inline SmF64 read_f32(float v) { return smvm_read_f64(sm_from_f32(v)); }
static inline SmF64 from_byte(uint8_t v) { return sm_from_bool(v != 0); }
#define is_not_zero(v) ((v) != 0)
static inline bool is_f32_true(float v) { return sm_to_bool(sm_from_f32(v)); }
static inline SmF64 identity(SmF64 x) { return x; }

DEFINE_SMALL_INTEGER(I8, int8_t, sm_from_i8, sm_to_i8, INT8_MIN, INT8_MAX)
DEFINE_SMALL_INTEGER(I16, int16_t, sm_from_i16, sm_to_i16, INT16_MIN, INT16_MAX)
DEFINE_SMALL_INTEGER(I32, int32_t, sm_from_i32, sm_to_i32, INT32_MIN, INT32_MAX)
DEFINE_LARGE_INTEGER(I64, int64_t, sm_from_i64, sm_to_i64, sm_count_i64)
DEFINE_SMALL_INTEGER(U8, uint8_t, sm_from_u8, sm_to_u8, 0, UINT8_MAX)
DEFINE_SMALL_INTEGER(U16, uint16_t, sm_from_u16, sm_to_u16, 0, UINT16_MAX)
DEFINE_SMALL_INTEGER(U32, uint32_t, sm_from_u32, sm_to_u32, 0, UINT32_MAX)
DEFINE_LARGE_INTEGER(U64, uint64_t, sm_from_u64, sm_to_u64, sm_count_u64)
DEFINE_OTHER(F32, float, read_f32, sm_to_f32, sm_from_f32, is_f32_true)
DEFINE_OTHER(F64, SmF64, smvm_read_f64, sm_to_f64, identity, sm_to_bool)
DEFINE_OTHER(BOOL, uint8_t, from_byte, sm_to_bool, from_byte, is_not_zero)
DEFINE_OTHER(RAW, SmF64, identity, smvm_raw, identity, sm_to_bool)
static inline int64_t whole_I64(const SmvmWord *w) { return cell_I64(w); }
static inline uint64_t whole_U64(const SmvmWord *w) { return cell_U64(w); }
static inline int64_t number_I64(const SmvmWord *w) { return w->i; }
static inline uint64_t number_U64(const SmvmWord *w) { return w->u; }
static inline SmF64 get_C(const SmvmWord *w, SmF64 f) { (void)f; return w->f; }

// Stores the constant of word n + 1, which is already converted to ctype, at the address in word n.
#define SET(ctype, n) do { const ctype v_ = (ctype)ip[(n) + 1].u; memcpy(ip[n].p, &v_, sizeof v_); } while (0)
#define NOTE notes |= ip[1].u                          // records that one of the first 64 outputs is stored: ip[1] has the output's bit

// Whether x and y are in one of the relations m (image.h).
static inline bool is_related(unsigned m, SmF64 x, SmF64 y)
{
    unsigned is = (unsigned)sm_lt(x, y) | (unsigned)sm_eq(x, y) << 1 | (unsigned)sm_lt(y, x) << 2;

    return (m & (is != 0 ? is : (unsigned)SMVM_UNORDERED)) != 0;
}

// A function that is not inlined, because sm_sqrt is long where the processor has no square root.
static SmF64 compute_sqrt(SmF64 x) { return sm_sqrt(x); }

// ---- execution: each instruction jumps directly to the next, or through a switch if C has no computed goto ----

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
#define FINISH case FAST_OPS: return SM_OK; }
#endif
#define GO_IF(condition, n) if (condition) { ip = ip[1].to; NEXT(0); } NEXT(n)

// Runs a step on a state vector other than d->sv, to which the decoded code points.  If d has no machine, only sets d->label (smvm_fast_labels).
static SmResult step_other_vector(SmvmDecoded *d, void *sv, const void *const *label)
{
    if (d->vm != NULL)
        return smvm_step(d->vm, sv);
    d->label = label;
    return SM_OK;
}

// Like smvm_step, with the same results, on the decoded code.
SmResult smvm_step_decoded(SmvmDecoded *d, void *sv)
{
#if SMVM_COMPUTED_GOTO
    static const void *const label[] = {
#undef FAST
#define FAST(name, ...) &&name##_,
#include "bytecode-vm/fast.def"
#undef FAST
#define FAST(name, ...) name##_: __VA_ARGS__
    };
#else
    static const void *const *const label = NULL;
#endif
    SmVm *const vm = d->vm;
    const SmvmWord *ip;
    uint64_t notes = 0;
    SmF64 F = sm_from_i32(0);

    if (sv != d->sv)
        return step_other_vector(d, sv, label);
    if (!smvm_advance(vm, d->g))
        return SM_REFUSED;
    if (vm->first || vm->entered) {                   // in most steps neither is set
        smvm_enter(vm, d->s);
        vm->first = false;                            // the code sets it again if it makes a transition; `entered` has the old value
    }
    d->t = vm->next - vm->start;
    ip = d->samples ? d->code + 1 : d->body[2 * (size_t)vm->state + vm->entered];
    BEGIN
#include "bytecode-vm/fast.def"
    FINISH
}

// Returns the address of the code of each FastOp, or NULL if the code contains its number instead.
const void *const *smvm_fast_labels(void)
{
    SmvmDecoded none;

    memset(&none, 0, sizeof none);
    smvm_step_decoded(&none, &none);
    return none.label;
}
