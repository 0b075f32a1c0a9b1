// SPDX-License-Identifier: Apache-2.0
// The decoded form behaves like the image: every opcode on memory of every type and on difficult numbers, with and without a later use of X;
// random code; then its memory.  Random images are tested by vm_mutate and the fuzzer, whole programs by the engine, which runs both forms.
#include <stdlib.h>

#include "tests/test.h"
#include "tests/unit/vm_hammer.h"

#ifndef DECODE_TEST
#define DECODE_TEST "vm_decode"
#endif

// Each instruction writes to its own 8 bytes.  It loads elements and locals of all types, a RAW local, T, or numbers.  X may also have been
// computed in one of these ways.
enum { RESULTS = 96, NUMBERS = 14, FIRST_NUMBER = 2 * SM_TYPE_COUNT + 2, SOURCES = FIRST_NUMBER + NUMBERS, WAYS = 6 };
enum { SOURCE_AT = 16, RESULT_AT = SOURCE_AT + 8 * SM_TYPE_COUNT, VECTOR = RESULT_AT + 8 * RESULTS };      // in the state vector
enum { RAW_AT = 8 * SM_TYPE_COUNT, OTHERS_AT = RAW_AT + 8, LOCALS = OTHERS_AT + 8 * (SM_TYPE_COUNT + 1) };  // among the locals
enum { ALL = SMVM_LESS | SMVM_EQUAL | SMVM_GREATER | SMVM_UNORDERED, TO_Y = SMVM_ldy_local - SMVM_ldx_local };

typedef struct Case {
    Build b;
    unsigned instructions;    // number of instructions added
    uint64_t seed;
} Case;

static void put_source(Build *b, unsigned k, unsigned to_y)      // ldx, or with TO_Y ldy
{
    static const struct { uint8_t op; uint32_t n; } number[NUMBERS] = {
        {SMVM_ldx_plus, 0}, {SMVM_ldx_plus, 1}, {SMVM_ldx_plus, 7}, {SMVM_ldx_plus, SMVM_VARINT_END - 1}, {SMVM_ldx_minus, 0}, {SMVM_ldx_minus, 2},
        {SMVM_ldx_f32, 0}, {SMVM_ldx_f32, 1}, {SMVM_ldx_f64, 0}, {SMVM_ldx_f64, 1}, {SMVM_ldx_f64, 2}, {SMVM_ldx_f64, 3},
        {SMVM_ldx_f64, 4}, {SMVM_ldx_f64, 5},
    };

    if (k < SM_TYPE_COUNT)
        typed(b, SMVM_ldx_elem + to_y, k, SOURCE_AT + 8 * k);
    else if (k <= 2 * SM_TYPE_COUNT)                             // the last of them RAW
        typed(b, SMVM_ldx_local + to_y, k - SM_TYPE_COUNT, 8 * (k - SM_TYPE_COUNT));
    else if (k < FIRST_NUMBER)
        code(b, SMVM_ldx_time + to_y, 0);
    else
        code(b, number[k - FIRST_NUMBER].op + to_y, 1, (unsigned)number[k - FIRST_NUMBER].n);
}

// Loads X from a source, or computes it.
static void put_x(Case *c, unsigned k)
{
    if (k < SOURCES) {
        put_source(&c->b, k, 0);
        return;
    }
    put_source(&c->b, c->instructions % SOURCES, 0);
    put_source(&c->b, c->instructions * 7 % SOURCES, TO_Y);
    switch (k - SOURCES) {
    case 0: code(&c->b, SMVM_div, 0); break;
    case 1: code(&c->b, SMVM_set, 1, 1 + c->instructions % 14); break;
    case 2: code(&c->b, SMVM_neg, 0); break;
    case 3: code(&c->b, SMVM_addi, 1, c->instructions % 3); break;
    case 4: code(&c->b, SMVM_cvt, 1, c->instructions % SM_TYPE_COUNT); break;
    default: code(&c->b, SMVM_and, 0); break;
    }
}

static void begin(Case *c)
{
    Build *b = &c->b;

    memset(b, 0, sizeof *b);
    b->sv_words = VECTOR / 8;
    b->locals = LOCALS;
    b->states = 1;
    b->width = 2;
    b->s = 2;
    memcpy(b->f32, (const uint32_t[]){0x3e800000u, 0xff800000u}, 8);                                  // 0.25, -infinity
    memcpy(b->f64, (const uint64_t[]){0x7ff8000000000000u, 0x8000000000000000u, 0x4340000000000000u, 0x41dfffffffc00000u, 0xc340000000000000u, 0xc1e0000000200000u}, 48);
    b->f32s = 2;                                                                  // NaN, -0, 2^53, 2^31 - 1, -2^53, -2^31 - 1
    b->f64s = 6;
    code(b, SMVM_end, 0);                             // sample: nothing
    end_function(b);
    end_function(b);
    for (unsigned t = 0; t < SM_TYPE_COUNT; t++) {    // the locals take what the elements hold
        put_source(b, (t + 3) % SM_TYPE_COUNT, 0);
        typed(b, SMVM_st_local, t, 8 * t);
    }
    put_source(b, SM_F64, 0);
    put_source(b, SM_F32, TO_Y);
    code(b, SMVM_sub, 0);                             // infinity less infinity is NaN
    typed(b, SMVM_st_local, SMVM_RAW, RAW_AT);
}

static void run_case(Case *c)
{
    static uint8_t image[16384];
    uint32_t size;
    SmvmVerdict v;

    code(&c->b, SMVM_end, 0);
    end_function(&c->b);
    end_function(&c->b);
    size = build_image(&c->b, image);
    CHECK(smvm_verify(image, size, &v) == 0);
    if (v.rule != 0)
        fprintf(stderr, "rule %u at %u\n", v.rule, (unsigned)v.at);
    else
        hammer(image, size, 40, ++c->seed | 1);
    begin(c);
}

static unsigned put_use_of_x(Case *c, unsigned type)        // the next output, of this type
{
    c->b.output[c->b.outputs] = PLACE_OF(type, (RESULT_AT + 8 * c->b.outputs) >> smvm_type_shift(type));
    return c->b.outputs++;
}

static void make_room(Case *c)
{
    if (c->b.outputs + 5 > RESULTS || c->b.size + 100 > sizeof c->b.code)
        run_case(c);
}

// Copies X to each kind of destination.  A destination that is not an output is then observed as an F64, as a condition, and compared with
// itself, which detects a NaN.
static void put_observations(Case *c)
{
    unsigned kind = c->instructions++ % (2 * SM_TYPE_COUNT + 1), t = kind - SM_TYPE_COUNT, from = SMVM_ldx_local;

    if (kind < SM_TYPE_COUNT) {
        code(&c->b, SMVM_out, 1, put_use_of_x(c, kind));
        if (c->instructions % 3)                      // X again, or not
            code(&c->b, SMVM_out, 1, put_use_of_x(c, SM_F64));
        return;
    }
    typed(&c->b, SMVM_st_local, t, OTHERS_AT + 8 * t);
    if (c->instructions % 3)
        typed(&c->b, from, t, OTHERS_AT + 8 * t);
    code(&c->b, SMVM_out, 1, put_use_of_x(c, SM_F64));
    code(&c->b, SMVM_ldy_plus, 1, 0);
    code(&c->b, SMVM_set, 1, SMVM_LESS | SMVM_GREATER);
    code(&c->b, SMVM_out, 1, put_use_of_x(c, SM_BOOL));
    typed(&c->b, from, t, OTHERS_AT + 8 * t);
    typed(&c->b, from + TO_Y, t, OTHERS_AT + 8 * t);
    code(&c->b, SMVM_set, 1, SMVM_EQUAL);
    code(&c->b, SMVM_out, 1, put_use_of_x(c, SM_BOOL));
}

// Puts code that loads X and Y.  From SOURCES on, Y is the first of the sources again.
static void put_operands(Case *c, unsigned x, unsigned y)
{
    make_room(c);
    put_x(c, x);
    put_source(&c->b, y % SOURCES, TO_Y);
}

// Puts a jump over a store.  X can be stored on the path that is not taken.
static void put_jump(Case *c, unsigned op, int numbers, unsigned n)
{
    unsigned d = put_use_of_x(c, SM_U8), seen = put_use_of_x(c, SM_F64);
    const bool again = c->instructions++ % 3 == 0;
    const uint32_t skip = 1 + 1 + 1 + 1 + (again ? 2u : 0u);      // ldx 3; out d

    if (numbers == 2)
        code(&c->b, op, 2, n, (unsigned)skip);
    else
        code(&c->b, op, 1, (unsigned)skip);
    if (again)
        code(&c->b, SMVM_out, 1, seen);
    code(&c->b, SMVM_ldx_plus, 1, 3);
    code(&c->b, SMVM_out, 1, d);
    code(&c->b, SMVM_ldx_plus, 1, 5);                 // here
    code(&c->b, SMVM_out, 1, put_use_of_x(c, SM_U8));
}

static void test_operations_decode_alike(Case *c)
{
    for (unsigned x = 0; x < SOURCES + WAYS; x++) {
        for (unsigned op = SMVM_neg; op <= SMVM_sign; op++)
            for (unsigned i = 0; i < 2 * SM_TYPE_COUNT + 1; i++) {
                make_room(c);
                put_x(c, x);
                code(&c->b, op, 0);
                put_observations(c);
            }
        for (unsigned i = 0; i < 8 * SM_TYPE_COUNT; i++) {
            make_room(c);
            put_x(c, x);
            code(&c->b, i % 4 == 0 ? SMVM_addi : i % 4 == 1 ? SMVM_subi : SMVM_cvt, 1, i % 4 < 2 ? (unsigned)(SMVM_VARINT_END - 1) >> i % 32 : i / 8);
            put_observations(c);
        }
        for (unsigned op = SMVM_add; op <= SMVM_or; op++)
            for (unsigned y = 0; y < SOURCES; y++) {
                put_operands(c, x, y);
                code(&c->b, op, 0);
                put_observations(c);
            }
        for (unsigned n = 0; n < 9; n++) {
            make_room(c);
            put_x(c, x);
            code(&c->b, SMVM_fn, 1, n);
            put_observations(c);
        }
        for (unsigned y = 0; y < 3 * SOURCES; y++) {
            put_operands(c, x, y % SOURCES);
            code(&c->b, SMVM_fn, 1, SMVM_FN_OF_TWO + y / SOURCES);
            put_observations(c);
        }
        for (unsigned i = 0; i < 3 * SM_TYPE_COUNT; i++) {        // stored as it is
            make_room(c);
            put_x(c, x);
            put_observations(c);
        }
    }
}

static void test_relations_decode_alike(Case *c)
{
    for (unsigned x = 0; x < SOURCES + WAYS; x++)
        for (unsigned m = 1; m < ALL; m++) {
            for (unsigned y = 0; y < SOURCES; y++) {
                put_operands(c, x, y);
                code(&c->b, SMVM_set, 1, m);
                put_observations(c);
                put_operands(c, x, y);
                put_jump(c, SMVM_jxy + m - 1, 1, 0);
                put_operands(c, x, y);                // the condition of the jump was computed
                code(&c->b, SMVM_set, 1, m);
                put_jump(c, m % 2 ? SMVM_jt : SMVM_jf, 1, 0);
            }
            for (unsigned n = 0; n < 4; n++) {
                make_room(c);
                put_x(c, x);
                put_jump(c, SMVM_jxn + m - 1, 2, n * n);
            }
        }
    for (unsigned x = 0; x < SOURCES + WAYS; x++)
        for (unsigned op = SMVM_jf; op <= SMVM_jt; op += SMVM_jt - SMVM_jf)
            for (unsigned i = 0; i < 3; i++) {
                make_room(c);
                put_x(c, x);
                put_jump(c, op, 1, 0);
            }
}

// `x = x + c` in each type, from values near the limits of the type.  The last X is used again.
static void test_counters_decode_alike(Case *c)
{
    static const uint8_t op[] = {SMVM_add, SMVM_sub, SMVM_addi, SMVM_subi};

    for (unsigned t = 0; t < SM_TYPE_COUNT; t++)
        for (unsigned k = FIRST_NUMBER; k < SOURCES; k++)
            for (unsigned i = 0; i < 4; i++)
                for (unsigned again = 0; again < 2; again++) {
                    make_room(c);
                    put_source(&c->b, (t + k) % SOURCES, 0);
                    typed(&c->b, SMVM_st_local, t, OTHERS_AT + 8 * t);
                    typed(&c->b, SMVM_ldx_local, t, OTHERS_AT + 8 * t);
                    put_source(&c->b, k, TO_Y);
                    code(&c->b, op[i], i < 2 ? 0 : 1, k);
                    if (again)
                        typed(&c->b, SMVM_st_local, t, OTHERS_AT + 8 * t);
                    code(&c->b, SMVM_out, 1, put_use_of_x(c, t));
                    if (again)
                        code(&c->b, SMVM_out, 1, put_use_of_x(c, SM_F64));
                    put_source(&c->b, k, 0);
                    typed(&c->b, SMVM_ldy_local, t, 8 * t);
                    code(&c->b, op[i], i < 2 ? 0 : 1, k);
                    code(&c->b, SMVM_out, 1, put_use_of_x(c, t));
                }
}

// Results with each possible Y, stored as F32 and as F64.
static void test_float_stores_decode_alike(Case *c)
{
    for (unsigned op = SMVM_add; op <= SMVM_div; op++)
        for (unsigned y = 0; y < SOURCES; y++)
            for (unsigned i = 0; i < 8; i++) {
                unsigned type = i % 2 ? SM_F64 : SM_F32;
                put_operands(c, SOURCES + i / 2 % 2 * 2, y);
                code(&c->b, op, 0);
                if (i < 4) {
                    code(&c->b, SMVM_out, 1, put_use_of_x(c, type));
                } else {
                    typed(&c->b, SMVM_st_local, type, OTHERS_AT + 8 * type);
                    typed(&c->b, SMVM_ldy_local, type, OTHERS_AT + 8 * type);
                    code(&c->b, SMVM_set, 1, SMVM_EQUAL);
                }
                code(&c->b, SMVM_out, 1, put_use_of_x(c, SM_F64));     // X is unchanged
            }
}

// X is loaded from a variable that is then overwritten, and X is used again.
static void test_overwritten_x_decodes_alike(Case *c)
{
    for (unsigned x = 0; x <= SM_TYPE_COUNT; x++)
        for (unsigned t = 0; t <= SM_TYPE_COUNT; t++)
            for (unsigned at = OTHERS_AT; at < OTHERS_AT + 16; at += t == SMVM_RAW ? 8 : 1u << smvm_type_shift(t)) {
                make_room(c);
                put_source(&c->b, SM_F64, 0);
                typed(&c->b, SMVM_st_local, SM_F64, OTHERS_AT);
                put_source(&c->b, SM_U64, 0);
                typed(&c->b, SMVM_st_local, SM_U64, OTHERS_AT + 8);
                typed(&c->b, SMVM_ldx_local, x, OTHERS_AT + 8);
                typed(&c->b, SMVM_st_local, t, at);
                code(&c->b, SMVM_out, 1, put_use_of_x(c, SM_F64));
                code(&c->b, SMVM_ldy_plus, 1, 1);
                code(&c->b, SMVM_add, 0);
                code(&c->b, SMVM_out, 1, put_use_of_x(c, SM_F64));
            }
}

// ---- code without sense: whatever the verifier accepts, with jumps and over locals that lie in each other ----

typedef struct Nonsense {
    Case *c;
    uint64_t seed;
    uint32_t jump[8], jumps;  // offsets of the distance bytes of forward jumps whose targets are not yet known
    bool x, y;                // whether it is known
} Nonsense;

static unsigned random_below(Nonsense *n, unsigned sides) { return (unsigned)(hammer_random(&n->seed) >> 20) % sides; }

static unsigned random_location(Nonsense *n, unsigned type) { return (random_below(n, 24) >> smvm_type_shift(type)) << smvm_type_shift(type); }

static void put_random_load(Nonsense *n, unsigned to_y)
{
    unsigned type = random_below(n, SM_TYPE_COUNT + 1);

    if (random_below(n, 3) == 0)
        put_source(&n->c->b, random_below(n, SOURCES), to_y);
    else
        typed(&n->c->b, SMVM_ldx_local + to_y, type, random_location(n, type));
    if (!to_y)
        n->x = true;
    n->y = to_y != 0;
}

static void here(Nonsense *n)                         // resolves all forward jumps to this position, where X is loaded
{
    while (n->jumps > 0) {
        uint32_t at = n->jump[--n->jumps];
        n->c->b.code[at] = (uint8_t)(n->c->b.size - at - 1);
    }
    if (random_below(n, 8) == 0) {
        code(&n->c->b, SMVM_jmp, 1, 0);
        n->jump[n->jumps++] = n->c->b.size - 1;
    }
    put_random_load(n, 0);
}

static void put_random_jump(Nonsense *n)
{
    unsigned m = random_below(n, ALL - 1);
    Build *b = &n->c->b;

    switch (random_below(n, n->y ? 4 : 3)) {
    case 0: code(b, SMVM_jt, 1, 0); break;
    case 1: code(b, SMVM_jf, 1, 0); break;
    case 2: code(b, SMVM_jxn + m, 2, random_below(n, 5), 0); break;
    default: code(b, SMVM_jxy + m, 1, 0); break;
    }
    n->jump[n->jumps++] = b->size - 1;
}

static void put_random_store(Nonsense *n)
{
    unsigned type = random_below(n, SM_TYPE_COUNT + 1);

    if (random_below(n, 3) == 0 && n->c->b.outputs < RESULTS)
        code(&n->c->b, SMVM_out, 1, put_use_of_x(n->c, random_below(n, SM_TYPE_COUNT)));
    else
        typed(&n->c->b, SMVM_st_local, type, random_location(n, type));
    n->y = false;
}

static void put_random_operation(Nonsense *n)
{
    switch (random_below(n, n->y ? 9 : 6)) {
    case 0: code(&n->c->b, SMVM_neg + random_below(n, 8), 0); break;
    case 1: case 2: code(&n->c->b, SMVM_addi, 1, random_below(n, 200)); break;
    case 3: code(&n->c->b, SMVM_subi, 1, random_below(n, 200)); break;
    case 4: code(&n->c->b, SMVM_cvt, 1, random_below(n, SM_TYPE_COUNT)); break;
    case 5: code(&n->c->b, SMVM_fn, 1, random_below(n, 9)); n->y = false; break;
    case 6: code(&n->c->b, SMVM_set, 1, 1 + random_below(n, ALL - 1)); break;
    default: code(&n->c->b, SMVM_add + random_below(n, 8), 0); break;
    }
}

static void test_random_code_decodes_alike(Case *c, uint64_t seed)
{
    Nonsense n = {c, seed * 0x9e3779b97f4a7c15u | 1, {0}, 0, false, false};

    begin(c);
    for (uint32_t far = 0; c->b.size < 1500;) {
        if (n.jumps == 0)
            far = c->b.size;
        if (!n.x || n.jumps == sizeof n.jump / sizeof n.jump[0] || c->b.size > far + 80) {
            here(&n);
            far = c->b.size;
        }
        switch (random_below(&n, 8)) {
        case 0: here(&n); break;
        case 1: put_random_load(&n, 0); break;
        case 2: case 3: put_random_load(&n, TO_Y); break;
        case 4: put_random_store(&n); break;
        case 5: n.jumps < 7 ? put_random_jump(&n) : put_random_store(&n); break;
        default: put_random_operation(&n); break;
        }
    }
    here(&n);
    c->seed = seed;
    run_case(c);
}

// ---- the step: states, with and without each of their functions, which go here and there ----

// A function counts its runs in an element; then it ends, continues or makes a transition, depending on other elements.
static void put_function(Case *c, unsigned f)
{
    typed(&c->b, SMVM_ldx_elem, SM_F64, RESULT_AT + 8 * f);
    code(&c->b, SMVM_addi, 1, 1);
    code(&c->b, SMVM_out, 1, f);
    put_source(&c->b, f, 0);
    put_source(&c->b, f + 1, TO_Y);
    code(&c->b, SMVM_jxy + SMVM_LESS - 1, 1, 1);
    code(&c->b, SMVM_end, 0);
    typed(&c->b, SMVM_ldx_elem, SM_F64, RESULT_AT + 8 * f);
    code(&c->b, SMVM_addi, 1, 1);
    code(&c->b, SMVM_out, 1, f);
    put_source(&c->b, f, 0);
    put_source(&c->b, SM_F64, TO_Y);
    code(&c->b, SMVM_jxy + SMVM_LESS - 1, 1, f % 3 == 2 ? 1 : 2);
    code(&c->b, f % 3 == 2 ? SMVM_end : SMVM_goto, f % 3 == 2 ? 0 : 1, 1 + f % 2);
    code(&c->b, SMVM_end, 0);
}

static void test_transitions_decode_alike(Case *c)
{
    static uint8_t image[16384];

    for (unsigned present = 0; present < 64; present++) {
        begin(c);
        c->b.size = c->b.ends = 0;
        c->b.states = 2;
        for (unsigned i = 0; i < 70; i++)
            put_use_of_x(c, SM_F64);
        if (present % 3)
            code(&c->b, SMVM_end, 0);
        end_function(&c->b);
        for (unsigned f = 0; f < 6; f++) {
            if (present >> f & 1)
                put_function(c, f);
            end_function(&c->b);
        }
        CHECK(hammer(image, build_image(&c->b, image), 400, present + 1) == 0);
    }
}

// ---- windows of all types and statistics ----

// Uses a statistic: stores it, and compares it in the condition of a jump with a number or with a variable in memory.
static void put_stat(Case *c, unsigned stat, unsigned type)
{
    code(&c->b, SMVM_stat, 2, stat, 0);
    code(&c->b, SMVM_out, 1, put_use_of_x(c, type));
    for (unsigned m = 1; m < ALL; m += 6) {
        code(&c->b, SMVM_stat, 2, stat, 0);
        put_jump(c, SMVM_jxn + m - 1, 2, 2);
        code(&c->b, SMVM_stat, 2, stat, 0);
        put_source(&c->b, SM_F64, TO_Y);
        put_jump(c, SMVM_jxy + m - 1, 1, 0);
    }
}

// Checks one window of a type.  Its sample is loaded with that type or another one, and its statistics are stored there.
static void check_window(Case *c, unsigned type, unsigned n, unsigned stats, unsigned how)
{
    static uint8_t image[16384];

    begin(c);
    c->b.size = c->b.ends = 0;
    c->b.windows = 1;
    c->b.window[0] = WINDOW_OF(type == SM_I64 || type == SM_U64 ? SM_ROLL_F64 : type, n, stats);
    put_source(&c->b, how % 3 ? type : SM_F64, 0);
    code(&c->b, SMVM_sample, 1, 0);
    code(&c->b, SMVM_out, 1, put_use_of_x(c, SM_F64));      // X is unchanged
    code(&c->b, SMVM_end, 0);
    end_function(&c->b);
    end_function(&c->b);
    while (how % 5 < 3 && (stats & (stats - 1)) == 0 && c->b.outputs < 63 + how % 5)      // one of the last in a word, or the next
        put_use_of_x(c, SM_F64);
    for (unsigned s = 0; s < SM_STAT_COUNT; s++)
        if (stats >> s & 1)
            put_stat(c, s, how % 2 ? type : SM_F64);
    code(&c->b, SMVM_end, 0);
    end_function(&c->b);
    end_function(&c->b);
    CHECK(hammer(image, build_image(&c->b, image), 3 * n + 40, how + 1) == 0);
}

static void test_windows_decode_alike(Case *c)
{
    static const unsigned size[] = {11, 1, 40, 70};

    for (unsigned k = 0; k < SM_TYPE_COUNT * 31; k++)
        check_window(c, k / 31, size[k % 4], k % 31 + 1, k);
}

// Each size that has its own instruction, and the sizes next to it.
static void test_short_windows_decode_alike(Case *c)
{
    static const uint8_t types[] = {SM_I16, SM_U16, SM_I32, SM_F32, SM_F64};
    static const uint8_t stats[] = {1u << SM_STAT_AVG, 1u << SM_STAT_MEDIAN, 1u << SM_STAT_MIN | 1u << SM_STAT_MAX, 1u << SM_STAT_RANGE};

    for (unsigned n = 1; n <= SM_ROLL_SCAN + 1; n = n == SM_ROLL_SHORT + 1 ? SM_ROLL_SCAN - 1 : n + 1)
        for (unsigned t = 0; t < sizeof types; t++)
            for (unsigned s = 0; s < sizeof stats; s++)
                check_window(c, types[t], n, stats[s], n * 7 + t + s);
}

// ---- memory, and another state vector ----

static void test_decoding_needs_aligned_memory(void)
{
    static uint8_t image[16384];
    uint64_t sv[2][VECTOR / 8] = {{0}, {0}}, ram[300], decoded[20000];
    const SmvmVector vector = {sv[0], sizeof sv[0], 0};
    SmvmDecoded *d = NULL;
    SmvmMachine m;
    SmVm *vm = (SmVm *)ram;
    static Case c;
    uint32_t need;

    begin(&c);
    put_source(&c.b, SM_F64, 0);
    code(&c.b, SMVM_addi, 1, 7);
    code(&c.b, SMVM_out, 1, put_use_of_x(&c, SM_F64));
    put_use_of_x(&c, SM_F64);
    code(&c.b, SMVM_end, 0);
    end_function(&c.b);
    end_function(&c.b);
    build_image(&c.b, image);
    CHECK(smvm_machine(image, 0, &m) && smvm_init(ram, sizeof ram, &m, &vector, 1) == SM_OK);
    need = smvm_decoded_size(&m);
    CHECK(need <= sizeof decoded && smvm_decode(&d, decoded, need - 1, &m, vm, sv[0]) == SM_E_MEMORY);
    CHECK(smvm_decode(&d, (uint8_t *)decoded + 4, need, &m, vm, sv[0]) == SM_E_ALIGNMENT && d == NULL);
    CHECK(smvm_decode(&d, decoded, need, &m, vm, sv[0]) == SM_OK);
    for (unsigned i = 0; i < 2; i++) {                // on either state vector
        sv[i][0] = i + 1;
        sv[i][SOURCE_AT / 8 + SM_F64] = sm_bits(sm_from_i32(3));
        CHECK(smvm_step_decoded(d, sv[i]) == SM_OK && sm_from_bits(sv[i][RESULT_AT / 8]) == 10);
        CHECK(smvm_step_decoded(d, sv[i]) == SM_REFUSED && smvm_stored(vm, 0) && !smvm_stored(vm, 1));
    }
    CHECK(sv[0][0] == 1 && smvm_init(ram, sizeof ram, &m, &vector, 1) == SM_OK);               // the same as the first time
    sv[0][SOURCE_AT / 8 + SM_F64] = sm_bits(sm_from_i32(4));
    CHECK(smvm_step_decoded(d, sv[0]) == SM_OK && sm_from_bits(sv[0][RESULT_AT / 8]) == 11 && smvm_stored_state(vm));
}

int main(void)
{
    static Case c;

    begin(&c);
    test_operations_decode_alike(&c);
    test_relations_decode_alike(&c);
    test_counters_decode_alike(&c);
    test_float_stores_decode_alike(&c);
    test_overwritten_x_decodes_alike(&c);
    run_case(&c);
    for (unsigned i = 1; i <= 200; i++)
        test_random_code_decodes_alike(&c, i);
    test_transitions_decode_alike(&c);
    test_windows_decode_alike(&c);
    test_short_windows_decode_alike(&c);
    test_decoding_needs_aligned_memory();
    return test_end(DECODE_TEST);
}
