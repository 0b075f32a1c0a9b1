// SPDX-License-Identifier: Apache-2.0
// The decoded form of a machine: the interface between decode*.c, which create it, and fast.c, which runs it.
#ifndef SMVM_FAST_H
#define SMVM_FAST_H

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"

// Lists of operand types; each applies the macro M to every type of the list.  FAST_TYPES: the types of values in memory, in the order of
// their numbers (SmType).  FAST_KINDS: also RAW, an F64 stored as it is.  FAST_SOURCES: also C, a constant in the code.  FAST_INTS: an
// int64_t can represent all their values except the upper half of U64.  DecodedValue.kind has one more, FAST_IN_F: the value is in F.
#define FAST_TYPES(M) SMVM_EACH_TYPE(M)
#define FAST_KINDS(M) SMVM_EACH_KIND(M)
#define FAST_SOURCES(M) FAST_KINDS(M) M(C)
#define FAST_FLOATS(M) M(F32) M(F64)
#define FAST_INTS(M) M(I8) M(I16) M(I32) M(I64) M(U8) M(U16) M(U32) M(U64)

enum { FAST_RAW = SM_TYPE_COUNT, FAST_C, FAST_IN_F, FAST_SOURCE_COUNT };

// The families: name and code of the instruction for a type K.  ip[1], ip[2], … are its operands; NEXT(n) goes to the next instruction, n
// words on; GO_IF jumps to ip[1]; NOTE and get_K etc. are in fast.c.
#define FAST_LD(K) FAST(LD_##K, F = get_##K(ip + 1, F); NEXT(2);)
#define FAST_ADD(K) FAST(ADD_##K, F = sm_add(F, get_##K(ip + 1, F)); NEXT(2);)
#define FAST_SUB(K) FAST(SUB_##K, F = sm_sub(F, get_##K(ip + 1, F)); NEXT(2);)
#define FAST_RSUB(K) FAST(RSUB_##K, F = sm_sub(get_##K(ip + 1, F), F); NEXT(2);)
#define FAST_MUL(K) FAST(MUL_##K, F = sm_mul(F, get_##K(ip + 1, F)); NEXT(2);)
#define FAST_DIV(K) FAST(DIV_##K, F = sm_div(F, get_##K(ip + 1, F)); NEXT(2);)
#define FAST_MIN(K) FAST(MIN_##K, F = sm_min(F, get_##K(ip + 1, F)); NEXT(2);)
#define FAST_MAX(K) FAST(MAX_##K, F = sm_max(F, get_##K(ip + 1, F)); NEXT(2);)
#define FAST_EQ(K) FAST(EQ_##K, F = sm_from_bool(sm_eq(F, get_##K(ip + 1, F))); NEXT(2);)
#define FAST_NE(K) FAST(NE_##K, F = sm_from_bool(!sm_eq(F, get_##K(ip + 1, F))); NEXT(2);)
#define FAST_LT(K) FAST(LT_##K, F = sm_from_bool(sm_lt(F, get_##K(ip + 1, F))); NEXT(2);)
#define FAST_LE(K) FAST(LE_##K, F = sm_from_bool(sm_le(F, get_##K(ip + 1, F))); NEXT(2);)
#define FAST_GT(K) FAST(GT_##K, F = sm_from_bool(sm_lt(get_##K(ip + 1, F), F)); NEXT(2);)
#define FAST_GE(K) FAST(GE_##K, F = sm_from_bool(sm_le(get_##K(ip + 1, F), F)); NEXT(2);)
#define FAST_REL(K) FAST(REL_##K, F = sm_from_bool(is_related((unsigned)ip[2].u, F, get_##K(ip + 1, F))); NEXT(3);)
#define FAST_FN2(K) FAST(FN2_##K, F = smvm_call((uint8_t)ip[2].u, F, get_##K(ip + 1, F)); NEXT(3);)
#define FAST_AND(K) FAST(AND_##K, F = sm_from_bool(sm_to_bool(F) && sm_to_bool(get_##K(ip + 1, F))); NEXT(2);)
#define FAST_OR(K) FAST(OR_##K, F = sm_from_bool(sm_to_bool(F) || sm_to_bool(get_##K(ip + 1, F))); NEXT(2);)
#define FAST_CVT(K) FAST(CVT_##K, F = convert_##K(F); NEXT(1);)

#define FAST_ADDC(K) FAST(ADDC_##K, F = sm_add(get_##K(ip + 1, F), ip[2].f); NEXT(3);)
#define FAST_RSUBC(K) FAST(RSUBC_##K, F = sm_sub(ip[2].f, get_##K(ip + 1, F)); NEXT(3);)
#define FAST_MULC(K) FAST(MULC_##K, F = sm_mul(get_##K(ip + 1, F), ip[2].f); NEXT(3);)
#define FAST_DIVC(K) FAST(DIVC_##K, F = sm_div(get_##K(ip + 1, F), ip[2].f); NEXT(3);)
#define FAST_RDIVC(K) FAST(RDIVC_##K, F = sm_div(ip[2].f, get_##K(ip + 1, F)); NEXT(3);)
#define FAST_ADD2(K) FAST(ADD2_##K, F = sm_add(get_##K(ip + 1, F), get_##K(ip + 2, F)); NEXT(3);)
#define FAST_SUB2(K) FAST(SUB2_##K, F = sm_sub(get_##K(ip + 1, F), get_##K(ip + 2, F)); NEXT(3);)
#define FAST_MUL2(K) FAST(MUL2_##K, F = sm_mul(get_##K(ip + 1, F), get_##K(ip + 2, F)); NEXT(3);)
#define FAST_DIV2(K) FAST(DIV2_##K, F = sm_div(get_##K(ip + 1, F), get_##K(ip + 2, F)); NEXT(3);)

#define FAST_ST(K) FAST(ST_##K, put_##K(ip + 1, F); NEXT(2);)
#define FAST_STN(K) FAST(STN_##K, NOTE; put_##K(ip + 2, F); NEXT(3);)
#define FAST_MOV(K) FAST(MOV_##K, move_##K(ip + 1, ip + 2); NEXT(3);)
#define FAST_MOVN(K) FAST(MOVN_##K, NOTE; move_##K(ip + 2, ip + 3); NEXT(4);)
#define FAST_INC(K) FAST(INC_##K, increment_##K(ip + 1); NEXT(4);)
#define FAST_INCN(K) FAST(INCN_##K, NOTE; increment_##K(ip + 2); NEXT(5);)

// F = F op y, also stored as type K; y is of type K in memory, or a constant (ADDCST and so on).
#define FAST_ADDST(K) FAST(ADDST_##K, F = sm_add(F, get_##K(ip + 2, F)); put_##K(ip + 1, F); NEXT(3);)
#define FAST_SUBST(K) FAST(SUBST_##K, F = sm_sub(F, get_##K(ip + 2, F)); put_##K(ip + 1, F); NEXT(3);)
#define FAST_MULST(K) FAST(MULST_##K, F = sm_mul(F, get_##K(ip + 2, F)); put_##K(ip + 1, F); NEXT(3);)
#define FAST_DIVST(K) FAST(DIVST_##K, F = sm_div(F, get_##K(ip + 2, F)); put_##K(ip + 1, F); NEXT(3);)
#define FAST_ADDSTN(K) FAST(ADDSTN_##K, NOTE; F = sm_add(F, get_##K(ip + 3, F)); put_##K(ip + 2, F); NEXT(4);)
#define FAST_SUBSTN(K) FAST(SUBSTN_##K, NOTE; F = sm_sub(F, get_##K(ip + 3, F)); put_##K(ip + 2, F); NEXT(4);)
#define FAST_MULSTN(K) FAST(MULSTN_##K, NOTE; F = sm_mul(F, get_##K(ip + 3, F)); put_##K(ip + 2, F); NEXT(4);)
#define FAST_DIVSTN(K) FAST(DIVSTN_##K, NOTE; F = sm_div(F, get_##K(ip + 3, F)); put_##K(ip + 2, F); NEXT(4);)
#define FAST_ADDCST(K) FAST(ADDCST_##K, F = sm_add(F, ip[2].f); put_##K(ip + 1, F); NEXT(3);)
#define FAST_MULCST(K) FAST(MULCST_##K, F = sm_mul(F, ip[2].f); put_##K(ip + 1, F); NEXT(3);)
#define FAST_DIVCST(K) FAST(DIVCST_##K, F = sm_div(F, ip[2].f); put_##K(ip + 1, F); NEXT(3);)
#define FAST_ADDCSTN(K) FAST(ADDCSTN_##K, NOTE; F = sm_add(F, ip[3].f); put_##K(ip + 2, F); NEXT(4);)
#define FAST_MULCSTN(K) FAST(MULCSTN_##K, NOTE; F = sm_mul(F, ip[3].f); put_##K(ip + 2, F); NEXT(4);)
#define FAST_DIVCSTN(K) FAST(DIVCSTN_##K, NOTE; F = sm_div(F, ip[3].f); put_##K(ip + 2, F); NEXT(4);)

#define FAST_SAMPLED(M) M(I16) M(U16) M(I32) M(F32) M(F64)
#define FAST_PUSH_MEDIAN(K) FAST(PUSH_MEDIAN_##K, push_median_##K(ip + 1, sample_##K(F)); NEXT(4);)
#define FAST_PUSH_AVG(K) FAST(PUSH_AVG_##K, push_avg_##K(ip + 1, sample_##K(F)); NEXT(4);)
#define FAST_PUSH_EXTREMES(K) FAST(PUSH_EXTREMES_##K, push_extremes_##K(ip + 1, sample_##K(F)); NEXT(4);)
#define FAST_PUSH_MEMORY_MEDIAN(K) FAST(PUSH_MEMORY_MEDIAN_##K, push_median_##K(ip + 1, memory_sample_##K(ip + 4)); F = sm_from_i32(0); NEXT(5);)
#define FAST_PUSH_MEMORY_AVG(K) FAST(PUSH_MEMORY_AVG_##K, push_avg_##K(ip + 1, memory_sample_##K(ip + 4)); F = sm_from_i32(0); NEXT(5);)
#define FAST_PUSH_MEMORY_EXTREMES(K) FAST(PUSH_MEMORY_EXTREMES_##K, push_extremes_##K(ip + 1, memory_sample_##K(ip + 4)); F = sm_from_i32(0); NEXT(5);)
#define FAST_MEDIAN(K) FAST(MEDIAN_##K, F = median_##K(ip + 1); NEXT(5);)
#define FAST_AVG(K) FAST(AVG_##K, F = avg_##K(ip + 1); NEXT(5);)
#define FAST_RANGE(K) FAST(RANGE_##K, F = range_##K(ip + 1); NEXT(5);)
#define FAST_SMALLEST(K) FAST(SMALLEST_##K, F = smallest_##K(ip + 1); NEXT(5);)
#define FAST_LARGEST(K) FAST(LARGEST_##K, F = largest_##K(ip + 1); NEXT(5);)
#define FAST_MEDIANN(K) FAST(MEDIANN_##K, NOTE; F = median_##K(ip + 3); put_##K(ip + 2, F); NEXT(7);)
#define FAST_AVGN(K) FAST(AVGN_##K, NOTE; F = avg_##K(ip + 3); put_##K(ip + 2, F); NEXT(7);)
#define FAST_RANGEN(K) FAST(RANGEN_##K, NOTE; F = range_##K(ip + 3); put_##K(ip + 2, F); NEXT(7);)

#define FAST_JEQ(K) FAST(JEQ_##K, GO_IF(sm_eq(F, get_##K(ip + 2, F)), 3);)
#define FAST_JNE(K) FAST(JNE_##K, GO_IF(!sm_eq(F, get_##K(ip + 2, F)), 3);)
#define FAST_JLT(K) FAST(JLT_##K, GO_IF(sm_lt(F, get_##K(ip + 2, F)), 3);)
#define FAST_JNLT(K) FAST(JNLT_##K, GO_IF(!sm_lt(F, get_##K(ip + 2, F)), 3);)
#define FAST_JLE(K) FAST(JLE_##K, GO_IF(sm_le(F, get_##K(ip + 2, F)), 3);)
#define FAST_JNLE(K) FAST(JNLE_##K, GO_IF(!sm_le(F, get_##K(ip + 2, F)), 3);)
#define FAST_JGT(K) FAST(JGT_##K, GO_IF(sm_lt(get_##K(ip + 2, F), F), 3);)
#define FAST_JNGT(K) FAST(JNGT_##K, GO_IF(!sm_lt(get_##K(ip + 2, F), F), 3);)
#define FAST_JGE(K) FAST(JGE_##K, GO_IF(sm_le(get_##K(ip + 2, F), F), 3);)
#define FAST_JNGE(K) FAST(JNGE_##K, GO_IF(!sm_le(get_##K(ip + 2, F), F), 3);)
#define FAST_JREL(K) FAST(JREL_##K, GO_IF(is_related((unsigned)ip[3].u, F, get_##K(ip + 2, F)), 4);)
#define FAST_JT(K) FAST(JT_##K, GO_IF(true_##K(ip + 2), 3);)
#define FAST_JF(K) FAST(JF_##K, GO_IF(!true_##K(ip + 2), 3);)
#define FAST_JEQ2(K) FAST(JEQ2_##K, GO_IF(sm_eq(get_##K(ip + 2, F), get_##K(ip + 3, F)), 4);)
#define FAST_JNE2(K) FAST(JNE2_##K, GO_IF(!sm_eq(get_##K(ip + 2, F), get_##K(ip + 3, F)), 4);)
#define FAST_JLT2(K) FAST(JLT2_##K, GO_IF(sm_lt(get_##K(ip + 2, F), get_##K(ip + 3, F)), 4);)
#define FAST_JLE2(K) FAST(JLE2_##K, GO_IF(sm_le(get_##K(ip + 2, F), get_##K(ip + 3, F)), 4);)
// Comparison with a constant.  A stored NaN remains NaN here; decode_jump.c selects a condition whose result for NaN is that for 0.
#define FAST_JEQC(K) FAST(JEQC_##K, GO_IF(sm_eq(bare_##K(ip + 2), ip[3].f), 4);)
#define FAST_JNEC(K) FAST(JNEC_##K, GO_IF(!sm_eq(bare_##K(ip + 2), ip[3].f), 4);)
#define FAST_JLTC(K) FAST(JLTC_##K, GO_IF(sm_lt(bare_##K(ip + 2), ip[3].f), 4);)
#define FAST_JNLTC(K) FAST(JNLTC_##K, GO_IF(!sm_lt(bare_##K(ip + 2), ip[3].f), 4);)
#define FAST_JLEC(K) FAST(JLEC_##K, GO_IF(sm_le(bare_##K(ip + 2), ip[3].f), 4);)
#define FAST_JNLEC(K) FAST(JNLEC_##K, GO_IF(!sm_le(bare_##K(ip + 2), ip[3].f), 4);)
#define FAST_JGTC(K) FAST(JGTC_##K, GO_IF(sm_lt(ip[3].f, bare_##K(ip + 2)), 4);)
#define FAST_JNGTC(K) FAST(JNGTC_##K, GO_IF(!sm_lt(ip[3].f, bare_##K(ip + 2)), 4);)
#define FAST_JGEC(K) FAST(JGEC_##K, GO_IF(sm_le(ip[3].f, bare_##K(ip + 2)), 4);)
#define FAST_JNGEC(K) FAST(JNGEC_##K, GO_IF(!sm_le(ip[3].f, bare_##K(ip + 2)), 4);)
// Comparison of an integer with a whole constant of at most 53 bits.  The result equals that for F64: rounding an integer beyond 2^53 does
// not change its order relative to the constant.  For U64 the constant is not negative.
#define FAST_JEQI(K) FAST(JEQI_##K, GO_IF(whole_##K(ip + 2) == number_##K(ip + 3), 4);)
#define FAST_JNEI(K) FAST(JNEI_##K, GO_IF(whole_##K(ip + 2) != number_##K(ip + 3), 4);)
#define FAST_JLTI(K) FAST(JLTI_##K, GO_IF(whole_##K(ip + 2) < number_##K(ip + 3), 4);)
#define FAST_JLEI(K) FAST(JLEI_##K, GO_IF(whole_##K(ip + 2) <= number_##K(ip + 3), 4);)
#define FAST_JGTI(K) FAST(JGTI_##K, GO_IF(whole_##K(ip + 2) > number_##K(ip + 3), 4);)
#define FAST_JGEI(K) FAST(JGEI_##K, GO_IF(whole_##K(ip + 2) >= number_##K(ip + 3), 4);)

typedef enum FastOp {
#define FAST(name, ...) FAST_##name##_OP,
#include "bytecode-vm/fast.def"
#undef FAST
    FAST_OPS
} FastOp;

// The code is an array of words: each instruction is followed by its operands.
typedef union SmvmWord {
    const void *go;           // an instruction: the address of its code.  (Without computed goto, `u` has its FastOp.)
    void *p;                  // the address of an operand in memory
    const union SmvmWord *to; // the target of a jump
    SmF64 f;                  // a constant
    int64_t i;                      // a signed integer constant
    uint64_t u;                     // an unsigned integer: a constant, a size, a bit mask …
} SmvmWord;

// A decoded machine.  Its functions are linked by jumps: the sample function continues with the first block that the state runs, `.entry`
// with `.step`, and a transition with `.exit`.
struct SmvmDecoded {
    SmVm *vm;                       // the machine, as smvm_init started it
    void *sv;                 // the state vector that addresses in the code point into
    const void *g;            // element G of that vector
    void *s;                  // the machine's element S
    SmvmParts parts;               // where the windows, locals and stored bits are in the machine's memory
    uint64_t t;               // T, updated at the start of each step: instructions read it as an operand in memory
    SmvmWord *code;           // the words, which begin with the sample function
    const SmvmWord **body;    // [2 * state]: where the code of the state's later steps starts; [2 * state + 1]: that of its first step
    const void *const *label; // the result of smvm_fast_labels
    bool samples;             // a step begins at the second word of the code: it clears stored bits, runs the sample function, or both
};

// Returns the address of the code of each FastOp, or NULL if the code contains its number instead.
const void *const *smvm_fast_labels(void);

#endif
