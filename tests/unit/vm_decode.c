// SPDX-License-Identifier: Apache-2.0
// The decoded form does what the image does: every opcode on operands of every kind, on numbers that are hard on somebody; then its
// memory.  (Random images are for vm_mutate and the fuzzer, whole programs for the engine, which runs both forms.)
#include <stdlib.h>

#include "tests/test.h"
#include "tests/unit/vm_hammer.h"

#ifndef DECODE_TEST
#define DECODE_TEST "vm_decode"
#endif

// Each instruction has a place of its own to write to.  What is read: elements and locals of all types, a temp, T, numbers; an
// accumulator is read where READ_ACC stands for an operand.
enum { RESULTS = 96, SOURCES = 2 * SM_TYPE_COUNT + 11, READ_ACC = SOURCES, VECTOR_WORDS = 2 + SM_TYPE_COUNT + RESULTS, FIRST_LOCAL = SM_TYPE_COUNT };
enum { G_AT = RESULTS, S_AT, SOURCE_AT, ACC_AT = SOURCE_AT + SOURCES, OTHERS_AT = ACC_AT + SM_TYPE_COUNT + 1 };

typedef struct Case {
    Build b;
    unsigned results;
    unsigned acc;             // which accumulator is next
    uint64_t seed;
    unsigned instructions;
} Case;

static void put_sources(Build *b)
{
    const uint32_t number[] = {OPERAND(22, 0), OPERAND(23, 0), OPERAND(24, 0), OPERAND(24, 7), OPERAND(24, 0x7fffd), OPERAND(25, 0), OPERAND(25, 1),
                               OPERAND(26, 0), OPERAND(26, 1), OPERAND(26, 2), OPERAND(26, 3)};

    for (unsigned t = 0; t < SM_TYPE_COUNT; t++) {
        b->operand[SOURCE_AT + t] = OPERAND(t, (16 + 8 * t) >> smvm_type_shift(t));
        b->operand[SOURCE_AT + FIRST_LOCAL + t] = OPERAND(11 + t, 8 * t >> smvm_type_shift(t));
        b->operand[ACC_AT + t] = OPERAND(27, t);
    }
    b->operand[ACC_AT + SM_TYPE_COUNT] = OPERAND(27, SM_TYPE_COUNT);
    memcpy(b->operand + SOURCE_AT + 2 * SM_TYPE_COUNT, number, sizeof number);
    memcpy(b->f32, (const uint32_t[]){0x3e800000u, 0xff800000u}, 8);                                  // 0.25, -infinity
    memcpy(b->f64, (const uint64_t[]){0x7ff8000000000000u, 0x8000000000000000u, 0x4340000000000000u, 0x41dfffffffc00000u}, 32);
    b->f32s = 2;                                                                                       // NaN, -0, 2^53, 2^31 - 1
    b->f64s = 4;
}

static void begin(Case *c)
{
    memset(&c->b, 0, sizeof c->b);
    c->results = 0;
    c->b.sv_words = VECTOR_WORDS;
    c->b.locals = 8 * SM_TYPE_COUNT + 8 * SM_TYPE_COUNT;
    c->b.temps = 2;
    c->b.outputs = RESULTS;
    c->b.states = 1;
    c->b.width = 2;
    c->b.operand[G_AT] = OPERAND(SM_U64, 0);
    c->b.operand[S_AT] = OPERAND(SM_U32, 2);
    put_sources(&c->b);
    for (unsigned t = 0; t < SM_TYPE_COUNT; t++)
        c->b.operand[OTHERS_AT + t] = OPERAND(11 + t, (8 * SM_TYPE_COUNT + 8 * t) >> smvm_type_shift(t));
    c->b.operand[OTHERS_AT + SM_TYPE_COUNT] = OPERAND(22, 1);
    c->b.operands = OTHERS_AT + SM_TYPE_COUNT + 1;
    code(&c->b, SMVM_end, 0);                         // sample: nothing
    end_function(&c->b);
    end_function(&c->b);
    for (unsigned t = 0; t < SM_TYPE_COUNT; t++)      // the locals, and a temp, take what the elements hold
        code(&c->b, SMVM_mov, 2, SOURCE_AT + FIRST_LOCAL + t, SOURCE_AT + (t + 3) % SM_TYPE_COUNT);
    code(&c->b, SMVM_sub, 3, SOURCE_AT + 2 * SM_TYPE_COUNT, SOURCE_AT + SM_F64, SOURCE_AT + SM_F32);   // infinity less infinity is NaN
}

static void run_case(Case *c)
{
    static uint8_t image[16384];
    SmvmVerdict v;

    for (unsigned i = c->results; i < RESULTS; i++)
        c->b.operand[i] = OPERAND(SM_F64, 2 + SM_TYPE_COUNT + i);
    code(&c->b, SMVM_end, 0);
    end_function(&c->b);
    end_function(&c->b);
    CHECK(smvm_verify(image, build_image(&c->b, image), &v) == 0);
    if (v.rule != 0)
        fprintf(stderr, "rule %u at %u\n", v.rule, (unsigned)v.at);
    else
        hammer(image, build_image(&c->b, image), 40, ++c->seed | 1);
    begin(c);
}

static unsigned result(Case *c, unsigned type)        // the next place, of this type
{
    c->b.operand[c->results] = OPERAND(type, (16 + 8 * SM_TYPE_COUNT + 8 * c->results) >> smvm_type_shift(type));
    return c->results++;
}

static void make_room(Case *c)
{
    if (c->results + 4 > RESULTS || c->b.size + 100 > sizeof c->b.code)
        run_case(c);
}

// An operand to read; where it is an accumulator, of a type that is another each time, writes that.
static unsigned source(Case *c, unsigned k)
{
    unsigned acc = ACC_AT + c->acc % (SM_TYPE_COUNT + 1u);

    if (k != READ_ACC)
        return SOURCE_AT + k;
    c->acc += 5;
    code(&c->b, c->acc % 2 ? SMVM_mov : SMVM_div, c->acc % 2 ? 2 : 3, acc, SOURCE_AT + c->acc / 2 % SOURCES, SOURCE_AT + SM_F64);
    return acc;
}

static void sources(Case *c, unsigned *x, unsigned *y)           // both; of two accumulators there is but one
{
    bool both = *x == READ_ACC && *y == READ_ACC;

    *x = source(c, *x);
    *y = both ? *x : source(c, *y);
}

// op d, x and y: to each kind of place in turn.  What is not an output is then seen as an F64, as true or not, and as equal to itself
// or not, which a NaN is not.
static void put_writing(Case *c, unsigned op, unsigned x, unsigned y, bool two)
{
    unsigned kind = c->instructions++ % (3 * SM_TYPE_COUNT + 2), seen = OTHERS_AT + SM_TYPE_COUNT;

    make_room(c);
    sources(c, &x, &y);
    if (kind < SM_TYPE_COUNT) {
        code(&c->b, op, two ? 3 : 2, result(c, kind), x, y);
        return;
    }
    code(&c->b, op, two ? 3 : 2, kind < 2 * SM_TYPE_COUNT + 1 ? OTHERS_AT + kind - SM_TYPE_COUNT : ACC_AT + kind - 2 * SM_TYPE_COUNT - 1, x, y);
    code(&c->b, SMVM_mov, 2, seen, kind < 2 * SM_TYPE_COUNT + 1 ? OTHERS_AT + kind - SM_TYPE_COUNT : ACC_AT + kind - 2 * SM_TYPE_COUNT - 1);
    code(&c->b, SMVM_mov, 2, result(c, SM_F64), seen);
    code(&c->b, SMVM_truth, 2, result(c, SM_BOOL), seen);
    code(&c->b, SMVM_eq, 3, result(c, SM_BOOL), seen, seen);
}

static void put_jump(Case *c, unsigned op, unsigned x, unsigned y, bool two)
{
    unsigned d;

    make_room(c);
    d = result(c, SM_U8);
    code(&c->b, SMVM_mov, 2, d, SOURCE_AT + 2 * SM_TYPE_COUNT + 2);
    sources(c, &x, &y);
    code(&c->b, op, two ? 3 : 2, x, two ? y : 4u, 4u);
    code(&c->b, SMVM_mov, 2, d, SOURCE_AT + 2 * SM_TYPE_COUNT + 3);
}

static void every_instruction(Case *c)
{
    begin(c);
    for (unsigned op = SMVM_mov; op <= SMVM_not; op++)
        for (unsigned x = 0; x <= SOURCES; x++)
            for (unsigned i = 0; i < 3 * SM_TYPE_COUNT + 2; i++)
                put_writing(c, op, x, 0, false);
    for (unsigned op = SMVM_add; op <= SMVM_or; op++)
        for (unsigned x = 0; x <= SOURCES; x++)
            for (unsigned y = 0; y <= SOURCES; y++)
                put_writing(c, op, x, y, true);
    for (unsigned op = SMVM_jeq; op <= SMVM_jnle; op++)
        for (unsigned x = 0; x <= SOURCES; x++)
            for (unsigned y = 0; y <= SOURCES; y++)
                put_jump(c, op, x, y, true);
    for (unsigned x = 0; x <= SOURCES; x++)
        for (unsigned op = SMVM_jt; op <= SMVM_jf; op++)
            put_jump(c, op, x, 0, false);
    run_case(c);
}

// Counting, `x = x + c`, in each type and from values at which the types end.
static void counting(Case *c)
{
    for (unsigned t = 0; t < SM_TYPE_COUNT; t++)
        for (unsigned k = 2 * SM_TYPE_COUNT + 2; k < SOURCES; k++)
            for (unsigned op = SMVM_add; op <= SMVM_sub; op++) {
                make_room(c);
                code(&c->b, SMVM_mov, 2, result(c, t), SOURCE_AT + (t + k) % SOURCES);
                code(&c->b, op, 3, c->results - 1, c->results - 1, SOURCE_AT + k);
                code(&c->b, op, 3, OTHERS_AT + t, SOURCE_AT + t, SOURCE_AT + k);
                code(&c->b, SMVM_add, 3, OTHERS_AT + t, SOURCE_AT + k, OTHERS_AT + t);
                code(&c->b, SMVM_mov, 2, result(c, t), OTHERS_AT + t);
            }
    run_case(c);
}

// ---- the step: states, with and without each of their functions, which go here and there ----

static void states(Case *c)
{
    for (unsigned present = 0; present < 64; present++) {
        begin(c);
        c->b.size = c->b.ends = 0;
        c->b.states = 2;
        if (present % 3)
            code(&c->b, SMVM_end, 0);
        end_function(&c->b);
        for (unsigned f = 0; f < 6; f++) {
            if (present >> f & 1) {
                code(&c->b, SMVM_add, 3, f, f, SOURCE_AT + 2 * SM_TYPE_COUNT + 3);
                code(&c->b, SMVM_jlt, 3, SOURCE_AT + f, SOURCE_AT + f + 1, 1);
                code(&c->b, SMVM_end, 0);
                code(&c->b, SMVM_add, 3, f, f, SOURCE_AT + 2 * SM_TYPE_COUNT + 3);
                code(&c->b, SMVM_jlt, 3, SOURCE_AT + f, SOURCE_AT + SM_F64, f % 3 == 2 ? 1 : 2);
                code(&c->b, f % 3 == 2 ? SMVM_end : SMVM_goto, f % 3 == 2 ? 0 : 1, 1 + f % 2);
                code(&c->b, SMVM_end, 0);
            }
            end_function(&c->b);
        }
        for (unsigned i = 0; i < RESULTS; i++)
            c->b.operand[i] = OPERAND(i % 2 ? SM_I8 : SM_F64, (2 + SM_TYPE_COUNT + i) << (i % 2 ? 3 : 0));
        static uint8_t image[16384];
        CHECK(hammer(image, build_image(&c->b, image), 400, present + 1) == 0);
    }
}

// ---- windows of all types and statistics ----

static void windows(Case *c)
{
    static const unsigned size[] = {11, 1, 40, 70};
    static uint8_t image[16384];

    for (unsigned k = 0; k < SM_TYPE_COUNT * 31; k++) {
        unsigned type = k / 31, stats = k % 31 + 1;
        begin(c);
        c->b.size = c->b.ends = 0;
        c->b.windows = 1;
        c->b.window[0] = WINDOW_OF(type == SM_I64 || type == SM_U64 ? SM_ROLL_F64 : type, size[k % 4], stats);
        code(&c->b, SMVM_sample, 2, 0, SOURCE_AT + (k % 3 ? type : SM_F64));
        code(&c->b, SMVM_end, 0);
        end_function(&c->b);
        end_function(&c->b);
        for (unsigned s = 0; s < SM_STAT_COUNT; s++)
            if (stats >> s & 1)
                code(&c->b, SMVM_avg + s, 2, result(c, SM_F64), 0);
        for (unsigned i = c->results; i < RESULTS; i++)
            c->b.operand[i] = OPERAND(SM_F64, 2 + SM_TYPE_COUNT + i);
        code(&c->b, SMVM_end, 0);
        end_function(&c->b);
        end_function(&c->b);
        CHECK(hammer(image, build_image(&c->b, image), 200, k + 1) == 0);
    }
}

// ---- memory, and another state vector ----

static void memory(void)
{
    static uint8_t image[16384];
    uint64_t sv[2][VECTOR_WORDS] = {{0}, {0}}, ram[300], decoded[20000];
    const SmvmVector vector = {sv[0], sizeof sv[0], 0};
    SmvmDecoded *d = NULL;
    SmvmMachine m;
    SmVm *vm = (SmVm *)ram;
    static Case c;
    uint32_t need;

    begin(&c);
    code(&c.b, SMVM_add, 3, result(&c, SM_F64), SOURCE_AT + SM_F64, SOURCE_AT + 2 * SM_TYPE_COUNT + 3);
    for (unsigned i = c.results; i < RESULTS; i++)
        c.b.operand[i] = OPERAND(SM_F64, 2 + SM_TYPE_COUNT + i);
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
        sv[i][2 + SM_F64] = sm_bits(sm_from_i32(3));
        CHECK(smvm_step_decoded(d, sv[i]) == SM_OK && sm_from_bits(sv[i][2 + SM_TYPE_COUNT]) == 10);
        CHECK(smvm_step_decoded(d, sv[i]) == SM_REFUSED && smvm_stored(vm, 0) && !smvm_stored(vm, 1));
    }
    CHECK(sv[0][0] == 1 && smvm_init(ram, sizeof ram, &m, &vector, 1) == SM_OK);               // as at first
    sv[0][2 + SM_F64] = sm_bits(sm_from_i32(4));
    CHECK(smvm_step_decoded(d, sv[0]) == SM_OK && sm_from_bits(sv[0][2 + SM_TYPE_COUNT]) == 11 && smvm_stored_state(vm));
}

int main(void)
{
    static Case c;

    every_instruction(&c);
    counting(&c);
    states(&c);
    windows(&c);
    memory();
    return test_end(DECODE_TEST);
}
