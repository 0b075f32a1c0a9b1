// SPDX-License-Identifier: Apache-2.0
// The verifier: one good image, each rule broken in it once and in each way that a hostile image might, and each refused by
// that rule and no other.  Then the longest step.
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "tests/test.h"
#include "tests/unit/vm_build.h"

enum { FLAG, VALUE, G, S, IN, COUNT, T0, T1, TIME, SEVEN, SINGLE, DOUBLE, OPERANDS };

// A machine with a bit of everything: two windows, the second over the first, two states.
static void good(Build *b)
{
    const uint32_t operand[OPERANDS] = {ELEMENT(BOOL, 24), ELEMENT(F64, 16), ELEMENT(U64, 0), ELEMENT(U32, 8), ELEMENT(F64, 32), LOCAL(U16, 2),
                                        OPERAND(22, 0), OPERAND(22, 1), OPERAND(23, 0), OPERAND(24, 7), OPERAND(25, 0), OPERAND(26, 0)};

    memset(b, 0, sizeof *b);
    b->sv_words = 5;
    b->locals = 4;
    b->temps = 2;
    b->outputs = 2;
    b->states = 2;
    b->width = 1;
    b->windows = 2;
    b->window[0] = WINDOW(5, 1u << SM_STAT_AVG | 1u << SM_STAT_MIN);
    b->window[1] = WINDOW(3, 1u << SM_STAT_MEDIAN);
    b->operands = OPERANDS;
    memcpy(b->operand, operand, sizeof operand);
    b->f32s = b->f64s = 1;
    memcpy(b->init, (const uint8_t[]){0x30, 0, 0, 7, 0}, 5);         // U16 at 2 = 7
    b->init[0] = (uint8_t)LOCAL(U16, 2);
    b->init_size = 5;
    code(b, SMVM_sample, 2, 0, IN);
    code(b, SMVM_avg, 2, T0, 0);
    code(b, SMVM_sample, 2, 1, T0);
    code(b, SMVM_end, 0);
    end_function(b);
}

static void put_state(Build *b, unsigned target)
{
    code(b, SMVM_mov, 2, COUNT, SEVEN);
    code(b, SMVM_end, 0);
    end_function(b);
    code(b, SMVM_median, 2, T1, 1);
    code(b, SMVM_jlt, 3, IN, T1, 2);
    code(b, SMVM_goto, 1, target);
    code(b, SMVM_add, 3, VALUE, DOUBLE, SINGLE);
    code(b, SMVM_end, 0);
    end_function(b);
    code(b, SMVM_not, 2, FLAG, FLAG);
    code(b, SMVM_end, 0);
    end_function(b);
}

static void good_states(Build *b)
{
    put_state(b, 2);
    put_state(b, 1);
}

static uint8_t image[8192];

static uint8_t verify(const Build *b, SmvmVerdict *v)
{
    return smvm_verify(image, build_image(b, image), v);
}

#define REFUSED(b, r)                                                                       \
    do {                                                                                    \
        SmvmVerdict v_;                                                                     \
        uint8_t got_ = verify(b, &v_);                                                      \
        if (got_ != SMVM_R_##r)                                                             \
            fprintf(stderr, "line %d: rule %u at %u\n", __LINE__, got_, (unsigned)v_.at);   \
        CHECK(got_ == SMVM_R_##r);                                                          \
    } while (0)

static Build whole(void)
{
    Build b;

    good(&b);
    good_states(&b);
    return b;
}

static void accepts(void)
{
    Build b = whole();
    SmvmVerdict v;
    SmvmMachine m;
    uint32_t n;

    CHECK(verify(&b, &v) == 0 && v.rule == 0);
    n = build_image(&b, image);
    CHECK(smvm_verify(image, n + 5, &v) == 0);        // what lies behind an image does not matter
    CHECK(v.longest == 4 + 2 + 3 + 2);                // sample; entry; median, jlt, goto; exit.  Staying costs 4.
    CHECK(smvm_machine(image, 0, &m) && smvm_longest_step(&m) == v.longest);
}

// ---- the container: the image's bytes are changed ----

static uint8_t patched(uint32_t at, uint8_t value, bool crc)
{
    Build b = whole();
    SmvmVerdict v;
    uint32_t n = build_image(&b, image);

    image[at] = value;
    if (crc)
        fix_crc(image);
    return smvm_verify(image, n, &v);
}

static void truncated(void)
{
    Build b = whole();
    uint32_t n = build_image(&b, image);
    SmvmVerdict v;

    for (uint32_t i = 0; i < n; i++) {
        uint8_t copy[512];
        memcpy(copy, image, n);
        CHECK(smvm_verify(copy, i, &v) == SMVM_R_LENGTH);
    }
    for (uint32_t i = 0; i < n; i++) {                // with a length that says so, and a checksum that is right
        uint8_t copy[512];
        memcpy(copy, image, n);
        copy[8] = (uint8_t)i;
        copy[9] = (uint8_t)(i >> 8);
        if (i >= 12)
            fix_crc(copy);
        CHECK(smvm_verify(copy, i, &v) == (i < 12 + 4 * 8 ? SMVM_R_LENGTH : SMVM_R_SECTION));
    }
}

static void header_alone(void)
{
    SmvmVerdict v;
    uint32_t n = put_header(image, 0, NULL, NULL);

    CHECK(n == 12 && smvm_verify(image, n, &v) == SMVM_R_GROUP);
}

// Where the rule is broken: the verdict says.
static void places_told(void)
{
    enum { NUMBERS = 14 };
    Build b = whole();
    uint32_t machine, code_at;
    SmvmVerdict v;

    build_image(&b, image);
    machine = section_at(image, 1);
    code_at = section_at(image, 2);
    CHECK(smvm_verify(image, 11, &v) == SMVM_R_LENGTH && v.at == 0);
    image[0] = 0;
    CHECK(smvm_verify(image, 500, &v) == SMVM_R_MAGIC && v.at == 0);
    image[0] = 's';
    image[3] = 0;
    CHECK(smvm_verify(image, 500, &v) == SMVM_R_FORMAT && v.at == 3);
    image[3] = 1;
    image[28] = 0x8f;
    fix_crc(image);
    CHECK(smvm_verify(image, 500, &v) == SMVM_R_UNKNOWN && v.at == 28);
    b.window[1] = 0;
    CHECK(verify(&b, &v) == SMVM_R_WINDOW && v.at == machine + NUMBERS + 4);
    b = whole();
    b.operand[T1] = OPERAND(31, 0);
    CHECK(verify(&b, &v) == SMVM_R_OPERAND_KIND && v.at == machine + NUMBERS + 8 + 3 * T1);
    b = whole();
    b.operand[S] = b.operand[G];
    CHECK(verify(&b, &v) == SMVM_R_TIME_STATE && v.at == machine + NUMBERS + 8 + 3 * 2);
    b = whole();
    b.end[3] = 0;
    CHECK(verify(&b, &v) == SMVM_R_FUNCTIONS && v.at == machine + NUMBERS + 8 + 3 * OPERANDS + 3);
    b = whole();
    b.size++;
    CHECK(verify(&b, &v) == SMVM_R_FUNCTIONS && v.at == machine + NUMBERS + 8 + 3 * OPERANDS + 6);
    b = whole();
    b.code[b.end[0] + 1] = SEVEN;
    CHECK(verify(&b, &v) == SMVM_R_WRITE && v.at == code_at + b.end[0] + 1 && v.machine == 0);
}

static void container(void)
{
    CHECK(patched(0, 'S', true) == SMVM_R_MAGIC);
    CHECK(patched(1, 'M', true) == SMVM_R_MAGIC);
    CHECK(patched(2, 0, true) == SMVM_R_MAGIC);
    CHECK(patched(3, 2, true) == SMVM_R_FORMAT);
    CHECK(patched(3, 0, true) == SMVM_R_FORMAT);
    header_alone();
    places_told();
    CHECK(patched(10, 1, false) == SMVM_R_LENGTH);
    CHECK(patched(11, 255, false) == SMVM_R_LENGTH);
    CHECK(patched(4, 0, false) == SMVM_R_CRC || patched(4, 1, false) == SMVM_R_CRC);
    CHECK(patched(60, 0xee, false) == SMVM_R_CRC);
    truncated();
}

static uint8_t arranged(unsigned n, const uint8_t *id)
{
    Build b = whole();
    SmvmVerdict v;

    return smvm_verify(image, build_sections(&b, n, id, image), &v);
}

static void sections(void)
{
    enum { FIRST = 12, SECOND = 20, THIRD = 28, FOURTH = 36 };

    CHECK(patched(FIRST + 2, 43, true) == SMVM_R_SECTION);           // in the section table
    CHECK(patched(FIRST + 2, 0, true) == SMVM_R_SECTION);
    CHECK(patched(SECOND + 2, 45, true) == SMVM_R_SECTION);          // over the end of the first
    CHECK(patched(THIRD + 4, 0x80, true) == SMVM_R_SECTION);         // far behind the end
    CHECK(patched(THIRD + 4, 0xff, true) == SMVM_R_SECTION);
    CHECK(patched(FOURTH + 7, 0xff, true) == SMVM_R_SECTION);        // an end far behind the end
    CHECK(patched(FOURTH + 5, 6, true) == SMVM_R_SECTION);
    CHECK(patched(FIRST, 0xff, true) == SMVM_R_UNKNOWN);
    CHECK(patched(FIRST, 0x84, true) == SMVM_R_UNKNOWN);
    CHECK(patched(FIRST, 0x80, true) == SMVM_R_UNKNOWN);
    CHECK(patched(FIRST + 1, 9, true) == 0);                         // one that can be skipped, whatever its version
    CHECK(patched(SECOND + 1, 2, true) == SMVM_R_UNKNOWN);
    CHECK(patched(THIRD + 1, 0, true) == SMVM_R_UNKNOWN);
    CHECK(patched(FOURTH + 1, 2, true) == SMVM_R_UNKNOWN);
    CHECK(patched(SECOND, 0x7e, true) == SMVM_R_GROUP);              // no MACHINE
    CHECK(patched(THIRD, 0x7e, true) == SMVM_R_GROUP);               // no CODE
    CHECK(patched(FIRST, 0x82, true) == SMVM_R_GROUP);               // CODE before MACHINE
    CHECK(patched(FIRST, 0x83, true) == SMVM_R_GROUP);               // INIT before MACHINE
    CHECK(patched(FIRST, 0x02, true) == SMVM_R_GROUP);               // DEBUG before MACHINE
    CHECK(patched(FIRST, 0x81, true) == SMVM_R_GROUP);               // a MACHINE without CODE
    CHECK(patched(FOURTH, 0x82, true) == SMVM_R_GROUP);              // two CODEs
    CHECK(patched(FOURTH, 0x81, true) == SMVM_R_GROUP);              // the last MACHINE without CODE
    CHECK(arranged(5, (const uint8_t[]){0x81, 0x82, 0x83, 0x02, 0x83}) == SMVM_R_GROUP);              // two INITs
    CHECK(arranged(5, (const uint8_t[]){0x81, 0x83, 0x02, 0x01, 0x82}) == 0);
    CHECK(arranged(5, (const uint8_t[]){0x81, 0x83, 0x82, 0x03, 0x82}) == SMVM_R_GROUP);
    CHECK(arranged(4, (const uint8_t[]){0x81, 0x83, 0x82, 0x04}) == 0);
    CHECK(patched(11, 0, true) == SMVM_R_GROUP);                     // no section at all
}

// ---- the machine ----

static void record(void)
{
    Build b = whole();
    SmvmVerdict v;
    uint32_t n = build_image(&b, image), at = section_at(image, 1);

    image[at + 5] = 0x80;                             // a byte that is none of a number
    fix_crc(image);
    CHECK(smvm_verify(image, n, &v) == SMVM_R_RECORD && v.at == at);
    n = build_image(&b, image);
    image[at + 5] = 0xff;
    fix_crc(image);
    CHECK(smvm_verify(image, n, &v) == SMVM_R_RECORD);
    for (uint32_t i = 7; i < 14; i++) {               // counts: one more than there is, and as many as can be said
        if (i == 11)                                  // width
            continue;
        build_image(&b, image);
        image[at + i]++;
        fix_crc(image);
        if (i != 8)                                   // outputs have no table of their own
            CHECK(smvm_verify(image, n, &v) == SMVM_R_RECORD);
        build_image(&b, image);
        memset(image + at + i, 0x7f, 4);
        fix_crc(image);
        CHECK(smvm_verify(image, n, &v) == SMVM_R_RECORD || v.rule == SMVM_R_STATES);
    }
    b.states = 0;
    REFUSED(&b, STATES);
    b.states = 2;
    b.width = 0;
    REFUSED(&b, STATES);
    b.width = 4;
    REFUSED(&b, STATES);
    b.width = 3;
    CHECK(verify(&b, &v) == 0);
}

static void short_machine(void)                       // a MACHINE section of 0 … 14 bytes; the last number is cut
{
    for (uint32_t i = 0; i < 15; i++) {
        static const uint8_t id[] = {0x81, 0x82};
        uint32_t size[] = {i, 5}, n;
        SmvmVerdict v;
        memset(image + 28, 1, 20);
        if (i > 4)
            image[28 + i - 1] = i & 1 ? 0x60 : 0x78;
        n = put_header(image, 2, id, size);
        CHECK(smvm_verify(image, n, &v) == SMVM_R_RECORD);
    }
}

static void tables(void)
{
    static const uint32_t good_window[] = {WINDOW(1, 4), WINDOW(100000, 7), WINDOW(5, 31), WINDOW(2, 6), WINDOW_OF(SM_I8, 5, 31),
                                           WINDOW_OF(SM_F32, 5, 1), WINDOW_OF(SM_BOOL, 3, 4)};
    static const uint32_t bad_window[] = {WINDOW(0, 1), WINDOW(100001, 1), WINDOW(131071, 1), WINDOW(5, 32), WINDOW(5, 64), 0, 0xffffff,
                                          UINT32_MAX, WINDOW_OF(SM_I64, 5, 1), WINDOW_OF(SM_U64, 5, 1), WINDOW_OF(11, 5, 1), WINDOW_OF(15, 5, 1)};
    static const uint32_t bad_kind[] = {28, 29, 30, 31};
    Build b;

    for (unsigned i = 0; i < sizeof bad_window / sizeof *bad_window; i++) {
        b = whole();
        b.window[1] = bad_window[i];
        REFUSED(&b, WINDOW);
        b = whole();
        b.window[0] = bad_window[i];
        REFUSED(&b, WINDOW);
    }
    for (unsigned i = 0; i < sizeof good_window / sizeof *good_window; i++) {
        SmvmVerdict v;
        b = whole();
        b.window[1] = good_window[i] | (uint32_t)SM_ROLL_MEDIAN << 17;
        CHECK(verify(&b, &v) == 0);
    }
    for (unsigned i = 0; i < sizeof bad_kind / sizeof *bad_kind; i++) {
        b = whole();
        b.operand[SEVEN] = OPERAND(bad_kind[i], 0);
        REFUSED(&b, OPERAND_KIND);
    }
    const uint32_t bad_place[] = {
        OPERAND(SM_F64, 0x1000), OPERAND(SM_F64, 0x10000), OPERAND(SM_I8, 0x800), LOCAL(I8, 4),
        ELEMENT(F64, 40), ELEMENT(U8, 40), ELEMENT(U16, 40), ELEMENT(I32, 40), OPERAND(SM_F64, 0x7ffff), OPERAND(SM_BOOL, 0x7ffff),
        LOCAL(U16, 4), LOCAL(BOOL, 4), LOCAL(U64, 0), LOCAL(F32, 4), OPERAND(11 + SM_I64, 0x7ffff), OPERAND(11 + SM_F32, 0x7ffff),
        OPERAND(22, 2), OPERAND(22, 0x7ffff), OPERAND(23, 1), OPERAND(25, 1), OPERAND(26, 1), OPERAND(26, 0x7ffff),
        OPERAND(27, 12), OPERAND(27, 0x7ffff)};
    for (unsigned i = 0; i < sizeof bad_place / sizeof *bad_place; i++) {
        b = whole();
        b.operand[T1] = bad_place[i];
        REFUSED(&b, OPERAND_AT);
        b = whole();
        b.operand[FLAG] = bad_place[i];
        REFUSED(&b, OPERAND_AT);
    }
    const uint32_t good_place[] = {ELEMENT(F64, 32), ELEMENT(U8, 39), ELEMENT(I32, 36), LOCAL(U16, 2), LOCAL(F32, 0), LOCAL(U8, 3), OPERAND(24, 0x7ffff)};
    for (unsigned i = 0; i < sizeof good_place / sizeof *good_place; i++) {
        SmvmVerdict v;
        b = whole();
        b.operand[IN] = good_place[i];
        CHECK(verify(&b, &v) == 0);
    }
}

static void outputs(void)
{
    const uint32_t no_element[] = {LOCAL(I8, 2), OPERAND(22, 0), OPERAND(23, 0), OPERAND(24, 1), OPERAND(25, 0), OPERAND(26, 0)};
    const uint32_t no_g[] = {ELEMENT(I64, 0), ELEMENT(F64, 0), ELEMENT(U32, 12), LOCAL(U16, 0), OPERAND(22, 0), OPERAND(24, 0)};
    const uint32_t no_s[] = {ELEMENT(I32, 8), ELEMENT(F32, 8), ELEMENT(U64, 8), ELEMENT(U16, 8), LOCAL(F32, 0), OPERAND(24, 0)};
    const uint32_t over[] = {ELEMENT(U8, 0), ELEMENT(U8, 7), ELEMENT(F64, 0), ELEMENT(F64, 8), ELEMENT(BOOL, 11), ELEMENT(U32, 4), ELEMENT(I16, 8), ELEMENT(I32, 8)};
    Build b;

    for (unsigned i = 0; i < 6; i++) {
        b = whole();
        b.operand[VALUE] = no_element[i];
        REFUSED(&b, OUTPUTS);
        b = whole();
        b.operand[G] = no_g[i];
        REFUSED(&b, TIME_STATE);
        b = whole();
        b.operand[S] = no_s[i];
        REFUSED(&b, TIME_STATE);
    }
    for (unsigned i = 0; i < 8; i++) {
        b = whole();
        b.operand[VALUE] = over[i];
        REFUSED(&b, PROTECTED);
    }
    b = whole();                                      // beside S on both sides
    b.operand[S] = ELEMENT(U32, 12);
    b.operand[FLAG] = ELEMENT(U32, 8);
    b.operand[VALUE] = ELEMENT(U8, 16);
    CHECK(verify(&b, &(SmvmVerdict){0}) == 0);
    b = whole();
    b.outputs = OPERANDS - 1;                         // no room for G and S behind them
    REFUSED(&b, TIME_STATE);
    b.outputs = 4000000;
    REFUSED(&b, TIME_STATE);
    b = whole();
    b.operands = 1;
    REFUSED(&b, TIME_STATE);
    b.operands = 0;
    REFUSED(&b, TIME_STATE);
}

static void memory(void)
{
    static uint8_t big[12 + 16 + 64 + 4 * 1400];
    static const uint8_t id[] = {0x81, 0x82};
    Build b = whole();
    uint32_t size[2], n;
    uint8_t *p = big + 28;
    SmvmVerdict v;

    put_bytes(&p, 0, 4);                              // 1400 windows of 100000 with a median need 2.2 GB
    for (unsigned i = 0; i < 10; i++)
        p += put_number(p, ((const uint32_t[]){5, 0, 0, 1400, 0, 2, 1, 1, 0, 0})[i]);
    for (unsigned i = 0; i < 1400; i++)
        put_bytes(&p, WINDOW(100000, 1u << SM_STAT_MEDIAN), 4);
    put_bytes(&p, b.operand[G], 3);
    put_bytes(&p, b.operand[S], 3);
    put_bytes(&p, 0, 4);
    size[0] = (uint32_t)(p - big) - 28;
    size[1] = 0;
    n = put_header(big, 2, id, size);
    CHECK(smvm_verify(big, n, &v) == SMVM_R_RAM);
}

static void initial_values(void)
{
    const uint32_t bad[] = {ELEMENT(U16, 16), OPERAND(22, 0), OPERAND(24, 0), OPERAND(31, 0), LOCAL(U16, 4), LOCAL(U8, 4), LOCAL(F64, 0), OPERAND(11 + SM_F64, 0x7ffff)};
    Build b;

    for (unsigned i = 0; i < 8; i++) {
        uint8_t *p;
        b = whole();
        p = b.init;
        put_bytes(&p, bad[i], 3);
        put_bytes(&p, 0, 8);
        b.init_size = 11;
        REFUSED(&b, INIT);
    }
    b = whole();
    for (b.init_size = 1; b.init_size < 5; b.init_size++)
        REFUSED(&b, INIT);
    memcpy(b.init + 5, b.init, 5);
    for (b.init_size = 6; b.init_size < 10; b.init_size++)
        REFUSED(&b, INIT);
    CHECK(verify(&b, &(SmvmVerdict){0}) == 0);
}

// Values that are complete, of what is no local of the machine.
static void initial_values_elsewhere(void)
{
    const uint32_t bad[] = {OPERAND(22, 0), ELEMENT(BOOL, 0), LOCAL(F64, 8), LOCAL(U16, 12), OPERAND(27, 0)};
    const uint8_t bytes[] = {8, 1, 8, 2, 8};
    Build b;

    for (unsigned i = 0; i < 5; i++) {
        uint8_t *p;
        b = whole();
        b.locals = 12;
        p = b.init;
        put_bytes(&p, bad[i], 3);
        b.init_size = 3u + bytes[i];
        REFUSED(&b, INIT);
    }
    b = whole();
    memcpy(b.init, (const uint8_t[]){11, 0, 0, 9}, 4);               // I8 at 0
    b.init_size = 4;
    CHECK(verify(&b, &(SmvmVerdict){0}) == 0);
}

// Of two machines either may be the broken one.
static void two_machines(void)
{
    static const uint8_t id[] = {0x81, 0x82, 0x02, 0x81, 0x82, 0x83, 0x02};
    SmvmVerdict v;
    Build b[2];

    for (uint32_t k = 0; k < 2; k++) {
        b[0] = b[1] = whole();
        b[k].operand[T1] = OPERAND(22, 5);
        CHECK(smvm_verify(image, build_sections(b, 7, id, image), &v) == SMVM_R_OPERAND_AT && v.machine == k);
        b[k] = whole();
        b[k].states++;
        CHECK(smvm_verify(image, build_sections(b, 7, id, image), &v) == SMVM_R_RECORD && v.machine == k);
        b[k] = whole();
        b[k].code[b[k].size - 1] = 0xff;
        CHECK(smvm_verify(image, build_sections(b, 7, id, image), &v) == SMVM_R_OPCODE && v.machine == k);
        b[k] = whole();
        memmove(b[k].code + b[k].end[0] + 4, b[k].code + b[k].end[0], b[k].size - b[k].end[0]);
        memcpy(b[k].code + b[k].end[0], (const uint8_t[]){SMVM_add, T0, T0, T0}, 4);
        b[k].size += 4;
        for (unsigned i = 1; i < b[k].ends; i++)
            b[k].end[i] += 4;
        CHECK(smvm_verify(image, build_sections(b, 7, id, image), &v) == 0 && v.machine == 0 && v.longest == 12);
    }
}

// ---- the code ----

static void functions(void)
{
    Build b = whole();

    b.end[2]--;                                       // into the middle of `end`'s predecessor
    REFUSED(&b, FALLS_OUT);
    b = whole();
    b.end[2] -= 2;                                    // into the middle of an instruction
    REFUSED(&b, TRUNCATED);
    b = whole();
    b.end[2] = b.end[1] - 1;                          // backwards
    REFUSED(&b, FUNCTIONS);
    b = whole();
    b.end[6] = b.size + 1;                            // behind the code
    b.end[5] = b.size;
    REFUSED(&b, FUNCTIONS);
    b = whole();
    b.end[6] = 255;
    REFUSED(&b, FUNCTIONS);
    b = whole();
    b.size++;                                         // code that belongs to no function
    REFUSED(&b, FUNCTIONS);
}

// A state whose step function is the code put between these two.
static void open_step(Build *b)
{
    good(b);
    end_function(b);
}

static void close_step(Build *b)
{
    end_function(b);
    end_function(b);
    put_state(b, 1);
}

#define STEP_REFUSED(statements, rule)  \
    do {                                \
        Build b;                        \
        open_step(&b);                  \
        statements;                     \
        close_step(&b);                 \
        REFUSED(&b, rule);              \
    } while (0)

static void instructions(void)
{
    for (unsigned op = 0; op < 256; op++)             // a single byte; no opcode of any operand is complete with it
        if (op != SMVM_end) {
            if (smvm_shape((uint8_t)op) == 0)
                STEP_REFUSED(code(&b, op, 0), OPCODE);
            else
                STEP_REFUSED(code(&b, op, 0), TRUNCATED);
        }
    STEP_REFUSED(code(&b, SMVM_mov, 1, T0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_add, 2, T0, T1), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_jeq, 2, T0, T1), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_mov, 2, T0, 0x60); b.size--, TRUNCATED);          // a varint of two bytes without its second
    STEP_REFUSED(code(&b, SMVM_goto, 1, 0xc60); b.size--, TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_mov, 2, T0, 0x60); b.code[b.size - 1] = 0x80; code(&b, SMVM_end, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_mov, 2, T0, T0); b.code[b.size - 1] = 0x80; code(&b, SMVM_end, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_mov, 2, T0, T0); b.code[b.size - 2] = 0xff; code(&b, SMVM_end, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 0); b.code[b.size - 1] = SMVM_end; code(&b, SMVM_end, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_mov, 2, T0, OPERANDS); code(&b, SMVM_end, 0), OPERAND);
    STEP_REFUSED(code(&b, SMVM_mov, 2, OPERANDS, T0); code(&b, SMVM_end, 0), OPERAND);
    STEP_REFUSED(code(&b, SMVM_add, 3, T0, T0, OPERANDS); code(&b, SMVM_end, 0), OPERAND);
    STEP_REFUSED(code(&b, SMVM_mov, 2, T0, 0x1000c5f); code(&b, SMVM_end, 0), OPERAND);
    STEP_REFUSED(code(&b, SMVM_jt, 2, OPERANDS, 0); code(&b, SMVM_end, 0), OPERAND);
    STEP_REFUSED(code(&b, SMVM_jle, 3, T0, OPERANDS, 0); code(&b, SMVM_end, 0), OPERAND);
}

static void writes(void)
{
    static const unsigned target[] = {G, S, IN, TIME, SEVEN, SINGLE, DOUBLE};

    for (unsigned i = 0; i < 7; i++) {
        STEP_REFUSED(code(&b, SMVM_mov, 2, target[i], T0); code(&b, SMVM_end, 0), WRITE);
        STEP_REFUSED(code(&b, SMVM_mul, 3, target[i], T0, T0); code(&b, SMVM_end, 0), WRITE);
        STEP_REFUSED(code(&b, SMVM_median, 2, target[i], 1); code(&b, SMVM_end, 0), WRITE);
    }
}

static void window_use(void)
{
    STEP_REFUSED(code(&b, SMVM_avg, 2, T0, 2); code(&b, SMVM_end, 0), WINDOW_USED);
    STEP_REFUSED(code(&b, SMVM_avg, 2, T0, 0x1000c5f); code(&b, SMVM_end, 0), WINDOW_USED);
    STEP_REFUSED(code(&b, SMVM_avg, 2, T0, 1); code(&b, SMVM_end, 0), WINDOW_USED);             // statistics that it does not keep
    STEP_REFUSED(code(&b, SMVM_median, 2, T0, 0); code(&b, SMVM_end, 0), WINDOW_USED);
    STEP_REFUSED(code(&b, SMVM_lowest, 2, T0, 1); code(&b, SMVM_end, 0), WINDOW_USED);
    STEP_REFUSED(code(&b, SMVM_highest, 2, T0, 0); code(&b, SMVM_end, 0), WINDOW_USED);
    STEP_REFUSED(code(&b, SMVM_range, 2, T0, 0); code(&b, SMVM_end, 0), WINDOW_USED);
    STEP_REFUSED(code(&b, SMVM_sample, 2, 2, T0); code(&b, SMVM_end, 0), WINDOW_USED);
    STEP_REFUSED(code(&b, SMVM_sample, 2, 0, T0); code(&b, SMVM_end, 0), SAMPLE);               // outside the sample function
}

#define SAMPLE_REFUSED(statements, rule)          \
    do {                                          \
        Build b;                                  \
        good(&b);                                 \
        b.size = b.ends = 0;                      \
        statements;                               \
        end_function(&b);                         \
        good_states(&b);                          \
        REFUSED(&b, rule);                        \
    } while (0)

static void sampling(void)
{
    SAMPLE_REFUSED((void)b, SAMPLE);                                                            // no sample at all
    SAMPLE_REFUSED(code(&b, SMVM_sample, 2, 0, IN); code(&b, SMVM_end, 0), SAMPLE);             // one is missing
    SAMPLE_REFUSED(code(&b, SMVM_sample, 2, 1, IN); code(&b, SMVM_sample, 2, 0, IN); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(code(&b, SMVM_sample, 2, 0, IN); code(&b, SMVM_sample, 2, 0, IN); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(code(&b, SMVM_sample, 2, 0, IN); code(&b, SMVM_sample, 2, 1, IN); code(&b, SMVM_sample, 2, 1, IN); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(code(&b, SMVM_avg, 2, T0, 0); code(&b, SMVM_end, 0), SAMPLE);                // read before
    SAMPLE_REFUSED(code(&b, SMVM_avg, 2, T0, 0); code(&b, SMVM_sample, 2, 0, IN); code(&b, SMVM_sample, 2, 1, IN); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(code(&b, SMVM_jt, 2, IN, 3); code(&b, SMVM_sample, 2, 0, IN);                // passed over
                   code(&b, SMVM_sample, 2, 1, IN); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(code(&b, SMVM_jt, 2, IN, 1); code(&b, SMVM_end, 0); code(&b, SMVM_sample, 2, 0, IN);     // over by then
                   code(&b, SMVM_sample, 2, 1, IN); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(code(&b, SMVM_sample, 2, 0, IN); code(&b, SMVM_sample, 2, 1, IN); code(&b, SMVM_goto, 1, 1), GOTO);
}

static void transitions(void)
{
    STEP_REFUSED(code(&b, SMVM_goto, 1, 0), GOTO);
    STEP_REFUSED(code(&b, SMVM_goto, 1, 3), GOTO);
    STEP_REFUSED(code(&b, SMVM_goto, 1, 0x1000c5f), GOTO);
}

static void transition_in_exit(void)
{
    Build b;

    open_step(&b);
    end_function(&b);
    code(&b, SMVM_goto, 1, 1);
    end_function(&b);
    put_state(&b, 1);
    REFUSED(&b, GOTO);
}

static void jumps(void)
{
    STEP_REFUSED(code(&b, SMVM_jt, 2, T0, 1); code(&b, SMVM_end, 0), JUMP);                     // to the function's end
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 0), JUMP);
    STEP_REFUSED(code(&b, SMVM_jt, 2, T0, 2); code(&b, SMVM_end, 0), JUMP);                     // into the next function
    STEP_REFUSED(code(&b, SMVM_jt, 2, T0, 0x1000c5f); code(&b, SMVM_end, 0), JUMP);             // as far as can be said
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 1); code(&b, SMVM_mov, 2, T0, T1); code(&b, SMVM_end, 0), JUMP);      // into an instruction
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 2); code(&b, SMVM_mov, 2, T0, T1); code(&b, SMVM_end, 0), JUMP);
    STEP_REFUSED(code(&b, SMVM_mov, 2, T0, T1), FALLS_OUT);
    STEP_REFUSED(code(&b, SMVM_end, 0); code(&b, SMVM_mov, 2, T0, T1), FALLS_OUT);
}

// An accumulator: TIME and SEVEN are two of them here.
#define ACC_STEP(statements) \
    open_step(&b);           \
    b.operand[TIME] = OPERAND(27, 11);    \
    b.operand[SEVEN] = OPERAND(27, SM_U8); \
    statements;              \
    code(&b, SMVM_end, 0);   \
    end_function(&b);        \
    end_function(&b);        \
    for (int i_ = 0; i_ < 3; i_++) { \
        code(&b, SMVM_end, 0); \
        end_function(&b);    \
    }

static void accumulators(void)
{
    enum { ACC = TIME, ACC_U8 = SEVEN };
    SmvmVerdict v;
    Build b;

    ACC_STEP(code(&b, SMVM_mov, 2, ACC, T0); code(&b, SMVM_add, 3, ACC_U8, ACC, ACC); code(&b, SMVM_jeq, 3, T0, ACC_U8, 0));
    CHECK(verify(&b, &v) == 0);
    ACC_STEP(code(&b, SMVM_median, 2, ACC, 1); code(&b, SMVM_jt, 2, ACC, 3); code(&b, SMVM_mov, 2, T0, T1));     // over what reads none
    CHECK(verify(&b, &v) == 0);
    ACC_STEP(code(&b, SMVM_mov, 2, T0, ACC));                                                                    // nobody wrote it
    REFUSED(&b, ACC);
    ACC_STEP(code(&b, SMVM_mov, 2, ACC, T0); code(&b, SMVM_mov, 2, T1, T0); code(&b, SMVM_mov, 2, T0, ACC));     // too late
    REFUSED(&b, ACC);
    ACC_STEP(code(&b, SMVM_mov, 2, ACC, T0); code(&b, SMVM_mov, 2, T0, ACC); code(&b, SMVM_mov, 2, T0, ACC));
    REFUSED(&b, ACC);
    ACC_STEP(code(&b, SMVM_mov, 2, ACC, ACC));
    REFUSED(&b, ACC);
    ACC_STEP(code(&b, SMVM_mov, 2, ACC, T0); code(&b, SMVM_add, 3, T0, T0, ACC_U8));                             // another
    REFUSED(&b, ACC);
    ACC_STEP(code(&b, SMVM_jt, 2, T0, 3); code(&b, SMVM_mov, 2, ACC, T0); code(&b, SMVM_mov, 2, T0, ACC));       // a jump to its reader
    REFUSED(&b, ACC);
    ACC_STEP(code(&b, SMVM_jt, 2, T0, 3); code(&b, SMVM_mov, 2, ACC, T0); code(&b, SMVM_jlt, 3, T0, ACC, 0));
    REFUSED(&b, ACC);
    ACC_STEP(code(&b, SMVM_mov, 2, ACC, T0); code(&b, SMVM_end, 0));                                             // into another function
    b.end[3] = b.size;
    b.end[4] = b.size + 3;
    REFUSED(&b, FUNCTIONS);
    open_step(&b);
    b.operand[TIME] = OPERAND(27, 11);
    code(&b, SMVM_jmp, 1, 3);                                                                                    // what is there is cut short
    code(&b, SMVM_mov, 2, ACC, T0);
    code(&b, SMVM_mov, 1, T0);
    close_step(&b);
    REFUSED(&b, TRUNCATED);
}

// ---- the longest step ----

static uint32_t longest(Build *b)
{
    SmvmVerdict v;

    close_step(b);
    memcpy(b->code + b->end[3], (const uint8_t[]){SMVM_end, SMVM_end, SMVM_end}, 3);            // the other state: 1, 1, 1
    b->size = b->end[3] + 3;
    b->end[4] = b->end[3] + 1;
    b->end[5] = b->end[3] + 2;
    b->end[6] = b->end[3] + 3;
    CHECK(verify(b, &v) == 0);
    return v.longest - 4;                             // less the sample function
}

static void longest_steps(void)
{
    Build b;

    open_step(&b);                                    // 3 on one side, 1 on the other, 1 before and after
    code(&b, SMVM_jt, 2, T0, 2 + 4 * 3);
    for (unsigned i = 0; i < 4; i++)
        code(&b, SMVM_mov, 2, T0, T1);
    code(&b, SMVM_jmp, 1, 3);
    code(&b, SMVM_mov, 2, T0, T1);
    code(&b, SMVM_end, 0);
    CHECK(longest(&b) == 1 + 4 + 1 + 1);
    open_step(&b);                                    // unreachable code costs nothing
    code(&b, SMVM_jmp, 1, 9);
    for (unsigned i = 0; i < 3; i++)
        code(&b, SMVM_mov, 2, T0, T1);
    code(&b, SMVM_end, 0);
    CHECK(longest(&b) == 2);
}

// n conditions, each of which jumps to an `end` of its own behind 32 moves, the first to the last.  While the verifier can
// follow all n, the longest way is that past all conditions; beyond, it adds up everything.
static void many_ways(void)
{
    enum { MOVES = 32, MOST = SMVM_JOINS + 20 };

    for (unsigned n = 1; n < MOST; n++) {
        uint32_t counted;
        Build b;
        open_step(&b);
        for (unsigned i = 0; i < n; i++)
            code(&b, SMVM_jt, 2, T0, 4 * (n - 1 - i) + 3 * MOVES + n - i);
        for (unsigned i = 0; i < MOVES; i++)
            code(&b, SMVM_mov, 2, T0, T1);
        for (unsigned i = 0; i <= n; i++)
            code(&b, SMVM_end, 0);
        b.width = 2;
        counted = longest(&b);
        CHECK(n <= SMVM_JOINS ? counted == n + MOVES + 1 : counted == n + MOVES + n + 1);
    }
}

// ---- the longest step of random functions, found by trying every way ----

typedef struct Random { uint8_t op; unsigned to; } Random;     // `to`: which instruction a jump leads to

static uint64_t seed = 1;

static unsigned below(unsigned n)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (unsigned)(seed >> 20) % n;
}

// The longest way from instruction i that ends in `last`, or 0.
static unsigned try_ways(const Random *r, unsigned i, uint8_t last)
{
    unsigned next, jump;

    if (r[i].op == SMVM_end || r[i].op == SMVM_goto)
        return r[i].op == last;
    if (r[i].op == SMVM_mov) {
        next = try_ways(r, i + 1, last);
        return next ? next + 1 : 0;
    }
    jump = try_ways(r, r[i].to, last);
    next = r[i].op == SMVM_jmp ? 0 : try_ways(r, i + 1, last);
    next = next > jump ? next : jump;
    return next ? next + 1 : 0;
}

static unsigned random_function(Random *r, bool may_go)
{
    unsigned n = 1 + below(14);

    for (unsigned i = 0; i < n; i++) {
        unsigned k = below(10);
        bool last = i + 1 == n;
        r[i].op = last || k == 0 ? (may_go && below(2) ? SMVM_goto : SMVM_end) : k < 3 ? SMVM_jmp : k < 7 ? SMVM_jt : SMVM_mov;
        r[i].to = last ? 0 : i + 1 + below(n - i - 1);
    }
    return n;
}

static void put_random(Build *b, const Random *r, unsigned n)
{
    static const unsigned bytes[4] = {1, 2, 2, 3};
    unsigned at[15] = {0};

    for (unsigned i = 0; i < n; i++)
        at[i + 1] = at[i] + bytes[r[i].op == SMVM_end ? 0 : r[i].op == SMVM_goto ? 1 : r[i].op == SMVM_jmp ? 2 : 3];
    for (unsigned i = 0; i < n; i++) {
        if (r[i].op == SMVM_end)
            code(b, SMVM_end, 0);
        else if (r[i].op == SMVM_goto)
            code(b, SMVM_goto, 1, 1);
        else if (r[i].op == SMVM_mov)
            code(b, SMVM_mov, 2, T0, SEVEN);
        else if (r[i].op == SMVM_jmp)
            code(b, SMVM_jmp, 1, at[r[i].to] - at[i + 1]);
        else
            code(b, SMVM_jt, 2, T0, at[r[i].to] - at[i + 1]);
    }
    end_function(b);
}

static void random_ways(void)
{
    for (unsigned k = 0; k < 3000; k++) {
        unsigned ends[3], leaves[3], longest_of = 0;
        SmvmVerdict v;
        Build b;
        good(&b);
        for (unsigned f = 0; f < 3; f++) {
            Random r[15];
            unsigned n = random_function(r, f < 2);
            put_random(&b, r, n);
            ends[f] = try_ways(r, 0, SMVM_end);
            leaves[f] = try_ways(r, 0, SMVM_goto);
        }
        if (leaves[0])                                                           // every way through a step
            longest_of = leaves[0] + ends[2];
        for (unsigned first = 0; first < 2; first++) {
            unsigned before = first ? ends[0] : 0;
            if (first && !ends[0])
                continue;
            if (ends[1] && before + ends[1] > longest_of)
                longest_of = before + ends[1];
            if (leaves[1] && before + leaves[1] + ends[2] > longest_of)
                longest_of = before + leaves[1] + ends[2];
        }
        b.states = 1;
        b.width = 2;
        CHECK(verify(&b, &v) == 0 && v.longest == 4 + longest_of);
    }
}

int main(void)
{
    accepts();
    container();
    sections();
    record();
    short_machine();
    tables();
    outputs();
    memory();
    initial_values();
    initial_values_elsewhere();
    two_machines();
    functions();
    instructions();
    writes();
    window_use();
    sampling();
    transitions();
    transition_in_exit();
    jumps();
    accumulators();
    longest_steps();
    many_ways();
    random_ways();
    return test_end("vm_verify");
}
