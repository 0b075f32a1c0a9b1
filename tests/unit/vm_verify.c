// SPDX-License-Identifier: Apache-2.0
// The verifier.  A valid image is changed so that it violates each rule, in each way that a hostile image can.  It must be refused for exactly
// this rule.  Then the longest step.
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "tests/test.h"
#include "tests/unit/vm_build.h"

enum { FLAG, VALUE };         // outputs: bool at 24, F64 at 16
enum { IN = 32, COUNT = 2 };  // an element, F64; a local, U16

static void put_load_input(Build *b) { typed(b, SMVM_ldx_elem, SM_F64, IN); }

// Builds a valid machine with each kind of item: two windows, of which the second follows the first, and two states.
static void put_good_machine(Build *b)
{
    memset(b, 0, sizeof *b);
    b->sv_words = 5;
    b->locals = 16;
    b->s = 2;
    b->states = 2;
    b->width = 1;
    b->windows = 2;
    b->window[0] = WINDOW(5, 1u << SM_STAT_AVG | 1u << SM_STAT_MIN);
    b->window[1] = WINDOW(3, 1u << SM_STAT_MEDIAN);
    b->outputs = 2;
    b->output[FLAG] = PLACE(BOOL, 24);
    b->output[VALUE] = PLACE(F64, 16);
    b->f32s = b->f64s = 1;
    memcpy(b->init, (const uint8_t[]){1, 0, SM_U16, 7, 0}, 5);       // U16 at 2 = 7
    b->init_size = 5;
    put_load_input(b);
    code(b, SMVM_sample, 1, 0);
    code(b, SMVM_stat, 2, SM_STAT_AVG, 0);
    code(b, SMVM_sample, 1, 1);
    code(b, SMVM_end, 0);
    end_function(b);
}

static void put_state(Build *b, unsigned target)
{
    code(b, SMVM_ldx_plus, 1, 7);
    typed(b, SMVM_st_local, SM_U16, COUNT);
    code(b, SMVM_end, 0);
    end_function(b);
    code(b, SMVM_stat, 2, SM_STAT_MEDIAN, 1);
    typed(b, SMVM_ldy_elem, SM_F64, IN);
    code(b, SMVM_jxy - 1 + SMVM_LESS, 1, 2);
    code(b, SMVM_goto, 1, target);
    code(b, SMVM_ldx_f64, 1, 0);
    code(b, SMVM_ldy_f32, 1, 0);
    code(b, SMVM_add, 0);
    code(b, SMVM_out, 1, VALUE);
    code(b, SMVM_end, 0);
    end_function(b);
    typed(b, SMVM_ldx_elem, SM_BOOL, 24);
    code(b, SMVM_ldy_plus, 1, 0);
    code(b, SMVM_set, 1, SMVM_EQUAL);
    code(b, SMVM_out, 1, FLAG);
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

static Build build_good_machine(void)
{
    Build b;

    put_good_machine(&b);
    good_states(&b);
    return b;
}

static void test_good_machine_is_accepted(void)
{
    Build b = build_good_machine();
    SmvmVerdict v;
    SmvmMachine m;
    uint32_t n;

    CHECK(verify(&b, &v) == 0 && v.rule == 0);
    n = build_image(&b, image);
    CHECK(smvm_verify(image, n + 5, &v) == 0);        // bytes after an image do not matter
    CHECK(v.longest == (SMVM_LONGEST ? 5 + 3 + 4 + 5 : 0));      // sample; entry; stat, ldy, jxy, goto; exit.  Staying costs 8.
    CHECK(smvm_machine(image, 0, &m) && smvm_longest_step(&m) == v.longest);
}

// ---- the container: the image's bytes are changed ----

static uint8_t verify_patched(uint32_t at, uint8_t value, bool crc)
{
    Build b = build_good_machine();
    SmvmVerdict v;
    uint32_t n = build_image(&b, image);

    image[at] = value;
    if (crc)
        fix_crc(image);
    return smvm_verify(image, n, &v);
}

static void test_truncated_image_is_refused(void)
{
    Build b = build_good_machine();
    uint32_t n = build_image(&b, image);
    SmvmVerdict v;

    for (uint32_t i = 0; i < n; i++) {
        uint8_t copy[512];
        memcpy(copy, image, n);
        CHECK(smvm_verify(copy, i, &v) == SMVM_R_LENGTH);
    }
    for (uint32_t i = 0; i < n; i++) {                // with the correct length and checksum
        uint8_t copy[512];
        memcpy(copy, image, n);
        copy[8] = (uint8_t)i;
        copy[9] = (uint8_t)(i >> 8);
        if (i >= 12)
            fix_crc(copy);
        CHECK(smvm_verify(copy, i, &v) == (i < 12 + 4 * 8 ? SMVM_R_LENGTH : SMVM_R_SECTION));
    }
}

static void test_image_without_machine_is_refused(void)
{
    SmvmVerdict v;
    uint32_t n = put_header(image, 0, NULL, NULL);

    CHECK(n == 12 && smvm_verify(image, n, &v) == SMVM_R_GROUP);
}

// The verdict contains the position of the error.
static void test_verdict_has_the_position(void)
{
    enum { NUMBERS = 16 };
    Build b = build_good_machine();
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
    image[3] = 2;
    image[28] = 0x8f;
    fix_crc(image);
    CHECK(smvm_verify(image, 500, &v) == SMVM_R_UNKNOWN && v.at == 28);
    b.window[1] = 0;
    CHECK(verify(&b, &v) == SMVM_R_WINDOW && v.at == machine + NUMBERS + 4);
    b = build_good_machine();
    b.output[VALUE] = PLACE(F64, 40);
    CHECK(verify(&b, &v) == SMVM_R_OUTPUTS && v.at == machine + NUMBERS + 8 + 3 * VALUE);
    b = build_good_machine();
    b.s = 0;
    CHECK(verify(&b, &v) == SMVM_R_PROTECTED && v.at == machine);
    b = build_good_machine();
    b.end[3] = 0;
    CHECK(verify(&b, &v) == SMVM_R_FUNCTIONS && v.at == machine + NUMBERS + 8 + 6 + 3);
    b = build_good_machine();
    b.size++;
    CHECK(verify(&b, &v) == SMVM_R_FUNCTIONS && v.at == machine + NUMBERS + 8 + 6 + 6);
    b = build_good_machine();
    b.code[b.end[0] + 3] = 8;                         // the variable to which st_local stores
    CHECK(verify(&b, &v) == SMVM_R_OPERAND && v.at == code_at + b.end[0] + 3 && v.machine == 0);
}

static void test_damaged_header_is_refused(void)
{
    CHECK(verify_patched(0, 'S', true) == SMVM_R_MAGIC);
    CHECK(verify_patched(1, 'M', true) == SMVM_R_MAGIC);
    CHECK(verify_patched(2, 0, true) == SMVM_R_MAGIC);
    CHECK(verify_patched(3, 1, true) == SMVM_R_FORMAT);
    CHECK(verify_patched(3, 0, true) == SMVM_R_FORMAT);
    test_image_without_machine_is_refused();
    test_verdict_has_the_position();
    CHECK(verify_patched(10, 1, false) == SMVM_R_LENGTH);
    CHECK(verify_patched(11, 255, false) == SMVM_R_LENGTH);
    CHECK(verify_patched(4, 0, false) == SMVM_R_CRC || verify_patched(4, 1, false) == SMVM_R_CRC);
    CHECK(verify_patched(60, 0xee, false) == SMVM_R_CRC);
    test_truncated_image_is_refused();
}

static uint8_t verify_sections(unsigned n, const uint8_t *id)
{
    Build b = build_good_machine();
    SmvmVerdict v;

    return smvm_verify(image, build_sections(&b, n, id, image), &v);
}

static void test_wrong_section_table_is_refused(void)
{
    enum { FIRST = 12, SECOND = 20, THIRD = 28, FOURTH = 36 };

    CHECK(verify_patched(FIRST + 2, 43, true) == SMVM_R_SECTION);           // in the section table
    CHECK(verify_patched(FIRST + 2, 0, true) == SMVM_R_SECTION);
    CHECK(verify_patched(SECOND + 2, 45, true) == SMVM_R_SECTION);          // over the end of the first
    CHECK(verify_patched(THIRD + 4, 0x80, true) == SMVM_R_SECTION);         // a section that ends far beyond the image
    CHECK(verify_patched(THIRD + 4, 0xff, true) == SMVM_R_SECTION);
    CHECK(verify_patched(FOURTH + 7, 0xff, true) == SMVM_R_SECTION);        // an end far after the end of the image
    CHECK(verify_patched(FOURTH + 5, 6, true) == SMVM_R_SECTION);
    CHECK(verify_patched(FIRST, 0xff, true) == SMVM_R_UNKNOWN);
    CHECK(verify_patched(FIRST, 0x84, true) == SMVM_R_UNKNOWN);
    CHECK(verify_patched(FIRST, 0x80, true) == SMVM_R_UNKNOWN);
    CHECK(verify_patched(FIRST + 1, 9, true) == 0);                         // an optional section, whatever its version
    CHECK(verify_patched(SECOND + 1, 1, true) == SMVM_R_UNKNOWN);
    CHECK(verify_patched(THIRD + 1, 0, true) == SMVM_R_UNKNOWN);
    CHECK(verify_patched(FOURTH + 1, 3, true) == SMVM_R_UNKNOWN);
    CHECK(verify_patched(SECOND, 0x7e, true) == SMVM_R_GROUP);              // no MACHINE
    CHECK(verify_patched(THIRD, 0x7e, true) == SMVM_R_GROUP);               // no CODE
    CHECK(verify_patched(FIRST, 0x82, true) == SMVM_R_GROUP);               // CODE before MACHINE
    CHECK(verify_patched(FIRST, 0x83, true) == SMVM_R_GROUP);               // INIT before MACHINE
    CHECK(verify_patched(FIRST, 0x02, true) == SMVM_R_GROUP);               // DEBUG before MACHINE
    CHECK(verify_patched(FIRST, 0x81, true) == SMVM_R_GROUP);               // a MACHINE without CODE
    CHECK(verify_patched(FOURTH, 0x82, true) == SMVM_R_GROUP);              // two CODEs
    CHECK(verify_patched(FOURTH, 0x81, true) == SMVM_R_GROUP);              // the last MACHINE without CODE
    CHECK(verify_sections(5, (const uint8_t[]){0x81, 0x82, 0x83, 0x02, 0x83}) == SMVM_R_GROUP);              // two INITs
    CHECK(verify_sections(5, (const uint8_t[]){0x81, 0x83, 0x02, 0x01, 0x82}) == 0);
    CHECK(verify_sections(5, (const uint8_t[]){0x81, 0x83, 0x82, 0x03, 0x82}) == SMVM_R_GROUP);
    CHECK(verify_sections(4, (const uint8_t[]){0x81, 0x83, 0x82, 0x04}) == 0);
    CHECK(verify_sections(3, (const uint8_t[]){0x05, 0x81, 0x82}) == SMVM_R_GROUP);                          // SAFE before MACHINE
    CHECK(verify_patched(11, 0, true) == SMVM_R_GROUP);                     // no section at all
}

// ---- safe states ----

static uint8_t verify_marks(uint8_t section, uint32_t size, uint8_t first, uint8_t second)
{
    const uint8_t id[] = {0x81, 0x82, section};
    Build b = build_good_machine();
    SmvmVerdict v;

    b.safe_size = size;
    b.safe[0] = first;
    b.safe[1] = second;
    return smvm_verify(image, build_sections(&b, 3, id, image), &v);
}

static uint8_t verify_safe(uint32_t size, uint8_t first, uint8_t second) { return verify_marks(0x05, size, first, second); }

static void test_swap_and_abort_marks_are_checked(void)               // of a machine of two states
{
    Build b[2] = {build_good_machine(), build_good_machine()};
    SmvmVerdict v;
    SmvmMachine m;

    for (uint8_t id = 0x07; id <= 0x08; id++) {
        for (unsigned bits = 0; bits < 256; bits++) {
            CHECK(verify_marks(id, 1, (uint8_t)bits, 0) == 0 && smvm_machine(image, 0, &m) && smvm_state_is_safe(&m, 1) && smvm_state_is_safe(&m, 2));
            CHECK(smvm_state_allows_swap(&m, 1) == (id == 0x07 && (bits & 1)) && smvm_state_allows_swap(&m, 2) == (id == 0x07 && (bits & 2)));
            CHECK(smvm_state_is_abort(&m, 1) == (id == 0x08 && (bits & 1)) && smvm_state_is_abort(&m, 2) == (id == 0x08 && (bits & 2)));
        }
        CHECK(verify_marks(id, 0, 0, 0) == 0 && smvm_machine(image, 0, &m) && !smvm_state_allows_swap(&m, 1) && !smvm_state_is_abort(&m, 1));
        CHECK(verify_sections(3, (const uint8_t[]){id, 0x81, 0x82}) == 0);
        CHECK(smvm_machine(image, 0, &m) && !smvm_state_allows_swap(&m, 1) && !smvm_state_is_abort(&m, 1));   // before MACHINE: of no machine
    }
    CHECK(verify_safe(1, 2, 0) == 0 && smvm_machine(image, 0, &m) && !smvm_state_allows_swap(&m, 1) && smvm_state_allows_swap(&m, 2));
    b[1].safe_size = 1;
    b[1].safe[0] = 2;
    CHECK(smvm_verify(image, build_sections(b, 6, (const uint8_t[]){0x81, 0x82, 0x81, 0x82, 0x07, 0x08}, image), &v) == 0);
    CHECK(smvm_machine(image, 0, &m) && !smvm_state_allows_swap(&m, 2) && !smvm_state_is_abort(&m, 2));
    CHECK(smvm_machine(image, 1, &m) && !smvm_state_allows_swap(&m, 1) && smvm_state_allows_swap(&m, 2) && smvm_state_is_abort(&m, 2));
}

static void test_safe_marks_are_checked(void)                         // of a machine of two states
{
    Build b[2] = {build_good_machine(), build_good_machine()};
    SmvmVerdict v;
    SmvmMachine m;

    for (uint8_t bits = 1; bits < 4; bits++) {
        CHECK(verify_safe(1, bits, 0) == 0 && smvm_machine(image, 0, &m));
        CHECK(smvm_state_is_safe(&m, 1) == (bits & 1) && smvm_state_is_safe(&m, 2) == bits >> 1);
    }
    CHECK(verify_safe(1, 0, 0) == SMVM_R_SAFE && verify_safe(0, 0, 0) == SMVM_R_SAFE && verify_safe(2, 1, 0) == SMVM_R_SAFE);
    CHECK(verify_safe(1, 4, 0) == SMVM_R_SAFE && verify_safe(1, 0x83, 0) == SMVM_R_SAFE && verify_safe(2, 1, 1) == SMVM_R_SAFE);
    b[1].safe_size = 1;
    b[1].safe[0] = 2;
    CHECK(smvm_verify(image, build_sections(b, 5, (const uint8_t[]){0x81, 0x82, 0x81, 0x82, 0x05}, image), &v) == 0);
    CHECK(smvm_machine(image, 0, &m) && smvm_state_is_safe(&m, 1) && smvm_state_is_safe(&m, 2));  // the section of this machine marks no state
    CHECK(smvm_machine(image, 1, &m) && !smvm_state_is_safe(&m, 1) && smvm_state_is_safe(&m, 2));
    CHECK(smvm_verify(image, build_sections(b + 1, 4, (const uint8_t[]){0x81, 0x05, 0x82, 0x05}, image), &v) == SMVM_R_GROUP);
    build_sections(b + 1, 3, (const uint8_t[]){0x81, 0x82, 0x05}, image);
    image[12 + 16 + 1] = 9;                           // a section with another version is ignored
    fix_crc(image);
    CHECK(smvm_verify(image, 500, &v) == 0 && smvm_machine(image, 0, &m) && smvm_state_is_safe(&m, 1));
}

static void test_marks_of_nine_states_need_two_bytes(void)                         // two bytes
{
    Build b = build_good_machine();
    SmvmMachine m;
    SmvmVerdict v;

    while (b.states < 9) {
        code(&b, SMVM_end, 0);
        end_function(&b);
        for (int i = 0; i < 2; i++)
            end_function(&b);
        b.states++;
    }
    b.safe_size = 2;
    b.safe[1] = 1;
    CHECK(smvm_verify(image, build_sections(&b, 3, (const uint8_t[]){0x81, 0x82, 0x05}, image), &v) == 0);
    for (uint32_t s = 1; smvm_machine(image, 0, &m) && s <= 9; s++)
        CHECK(smvm_state_is_safe(&m, s) == (s == 9));
    b.safe[1] = 2;
    CHECK(smvm_verify(image, build_sections(&b, 3, (const uint8_t[]){0x81, 0x82, 0x05}, image), &v) == SMVM_R_SAFE);
}

// ---- the machine ----

static void test_wrong_machine_record_is_refused(void)
{
    Build b = build_good_machine();
    SmvmVerdict v;
    uint32_t n = build_image(&b, image), at = section_at(image, 1);

    image[at + 5] = 0x80;                             // a byte that cannot be part of a number
    fix_crc(image);
    CHECK(smvm_verify(image, n, &v) == SMVM_R_RECORD && v.at == at);
    n = build_image(&b, image);
    image[at + 5] = 0xff;
    fix_crc(image);
    CHECK(smvm_verify(image, n, &v) == SMVM_R_RECORD);
    for (uint32_t i = 8; i < 14; i++) {               // counts: one more than exist, and the largest that can be encoded
        if (i == 11)                                  // width
            continue;
        build_image(&b, image);
        image[at + i]++;
        fix_crc(image);
        CHECK(smvm_verify(image, n, &v) == SMVM_R_RECORD);
        build_image(&b, image);
        memset(image + at + i, 0x7f, 4);
        fix_crc(image);
        CHECK(smvm_verify(image, n, &v) == SMVM_R_RECORD || v.rule == SMVM_R_STATES || v.rule == BEYOND(SMVM_R_RECORD));
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

static void short_machine(void)                       // a MACHINE section of 0 … 16 bytes; the last number is cut
{
    for (uint32_t i = 0; i < 17; i++) {
        static const uint8_t id[] = {0x81, 0x82};
        uint32_t size[] = {i, 5}, n;
        SmvmVerdict v;
        memset(image + 28, 1, 22);
        if (i > 4)
            image[28 + i - 1] = i & 1 ? 0x60 : 0x78;
        n = put_header(image, 2, id, size);
        CHECK(smvm_verify(image, n, &v) == SMVM_R_RECORD);
    }
}

static void test_wrong_tables_are_refused(void)
{
    static const uint32_t good_window[] = {WINDOW(1, 4), WINDOW(100000, 7), WINDOW(5, 31), WINDOW(2, 6), WINDOW(2, 96), WINDOW_OF(SM_I8, 5, 255),
                                           WINDOW_OF(SM_F32, 5, 1), WINDOW_OF(SM_BOOL, 3, 4)};
    static const uint32_t bad_window[] = {WINDOW(0, 1), WINDOW(100001, 1), WINDOW(131071, 1), WINDOW(5, 256), WINDOW(5, 512), WINDOW(5, 1024), WINDOW_OF(SM_U64, 5, 257), WINDOW_OF(SM_U64, 5, 768), WINDOW_OF(SM_U64, 5, 128), 0, 0xffffff,
                                          UINT32_MAX, WINDOW_OF(SM_I64, 5, 1), WINDOW_OF(SM_U64, 5, 1), WINDOW_OF(11, 5, 1), WINDOW_OF(15, 5, 1)};
    Build b;

    for (unsigned i = 0; i < sizeof bad_window / sizeof *bad_window; i++) {
        b = build_good_machine();
        b.window[1] = bad_window[i];
        REFUSED(&b, WINDOW);
        b = build_good_machine();
        b.window[0] = bad_window[i];
        REFUSED(&b, WINDOW);
    }
    for (unsigned i = 0; i < sizeof good_window / sizeof *good_window; i++) {
        SmvmVerdict v;
        b = build_good_machine();
        b.window[1] = good_window[i] | (uint32_t)SM_ROLL_MEDIAN << 17;
        CHECK(verify(&b, &v) == ((good_window[i] & SMVM_WINDOW_SIZE_MASK) < 1000 ? 0 : BEYOND(0)));
    }
}

static void test_elements_outside_the_vector_are_refused(void)
{
    static const struct { uint32_t from, to, g, s; uint8_t rule; } row[] = {
        {0, 5, 0, 2, 0}, {0, 6, 0, 2, SMVM_R_SPAN}, {0, 0x1000c5f, 0, 2, BEYOND(SMVM_R_SPAN)}, {6, 5, 0, 2, SMVM_R_SPAN}, {0x1000c5f, 5, 0, 2, BEYOND(SMVM_R_SPAN)},
        {1, 5, 0, 2, SMVM_R_TIME_STATE}, {1, 5, 1, 1, SMVM_R_TIME_STATE}, {0, 5, 5, 2, SMVM_R_TIME_STATE}, {0, 5, 0x1000c5f, 2, BEYOND(SMVM_R_TIME_STATE)},
        {0, 5, 0, 10, SMVM_R_TIME_STATE}, {0, 5, 0, 0x1000c5f, BEYOND(SMVM_R_TIME_STATE)}, {0, 5, 0, 9, 0}, {5, 5, 0, 2, SMVM_R_TIME_STATE},
        {0, 5, 0, 0, SMVM_R_PROTECTED}, {0, 5, 0, 1, SMVM_R_PROTECTED}, {0, 5, 4, 8, SMVM_R_PROTECTED}, {0, 5, 2, 2, SMVM_R_PROTECTED},
        {0, 5, 0, 5, SMVM_R_PROTECTED}, {0, 5, 0, 6, SMVM_R_PROTECTED}, {2, 5, 4, 7, 0},
    };

    for (unsigned i = 0; i < sizeof row / sizeof *row; i++) {
        SmvmVerdict v;
        Build b = build_good_machine();
        b.from = row[i].from;
        b.to = row[i].to;
        b.g = row[i].g;
        b.s = row[i].s;
        if (verify(&b, &v) != row[i].rule)
            fprintf(stderr, "row %u: rule %u\n", i, v.rule);
        CHECK(v.rule == row[i].rule);
    }
}

static void test_wrong_outputs_are_refused(void)
{
    const uint32_t bad[] = {PLACE(F64, 40), PLACE(U8, 40), PLACE(U16, 40), PLACE(I32, 40), PLACE_OF(SM_F64, 0xfffff), PLACE_OF(SM_BOOL, 0xfffff),
                            PLACE_OF(SM_F64, 0x10002), PLACE_OF(11, 0), PLACE_OF(12, 0), PLACE_OF(15, 2)};
    const uint32_t over[] = {PLACE(U8, 0), PLACE(U8, 7), PLACE(F64, 0), PLACE(F64, 8), PLACE(BOOL, 11), PLACE(U32, 4), PLACE(I16, 8), PLACE(I32, 8)};
    const uint32_t fine[] = {PLACE(F64, 32), PLACE(U8, 39), PLACE(I32, 36), PLACE(U16, 12), PLACE(U32, 12)};
    SmvmVerdict v;
    Build b;

    for (unsigned i = 0; i < sizeof bad / sizeof *bad; i++)
        for (unsigned k = 0; k < 2; k++) {
            b = build_good_machine();
            b.output[k] = bad[i];
            REFUSED(&b, OUTPUTS);
        }
    for (unsigned i = 0; i < sizeof over / sizeof *over; i++) {
        b = build_good_machine();
        b.output[VALUE] = over[i];
        REFUSED(&b, PROTECTED);
    }
    for (unsigned i = 0; i < sizeof fine / sizeof *fine; i++) {
        b = build_good_machine();
        b.output[VALUE] = fine[i];
        CHECK(verify(&b, &v) == 0);
    }
    b = build_good_machine();                                      // S is directly between two outputs
    b.s = 3;
    b.output[FLAG] = PLACE(U32, 8);
    b.output[VALUE] = PLACE(U8, 16);
    CHECK(verify(&b, &v) == 0);
    b = build_good_machine();                                      // before the part that the machine uses
    b.from = 1;
    b.g = 1;
    b.s = 4;
    b.output[VALUE] = PLACE(F64, 24);
    b.output[FLAG] = PLACE(BOOL, 7);
    REFUSED(&b, OUTPUTS);
}

static void test_too_many_windows_are_refused(void)
{
    static uint8_t big[12 + 16 + 64 + 4 * 1400];
    static const uint8_t id[] = {0x81, 0x82};
    uint32_t size[2], n;
    uint8_t *p = big + 28;
    SmvmVerdict v;

    put_bytes(&p, 0, 4);                              // 1400 windows of 100000 with a median need 2.2 GB
    for (unsigned i = 0; i < 12; i++)
        p += put_number(p, ((const uint32_t[]){5, 0, 5, 0, 1400, 0, 1, 1, 0, 0, 0, 2})[i]);
    for (unsigned i = 0; i < 1400; i++)
        put_bytes(&p, WINDOW(100000, 1u << SM_STAT_MEDIAN), 4);
    put_bytes(&p, 0, 4);
    size[0] = (uint32_t)(p - big) - 28;
    size[1] = 0;
    n = put_header(big, 2, id, size);
    CHECK(smvm_verify(big, n, &v) == SMVM_R_RAM);
}

static void test_wrong_initial_values_are_refused(void)
{
    const uint32_t bad[] = {PLACE(U16, 16), PLACE_OF(11, 0), PLACE_OF(15, 0), PLACE(U8, 16), PLACE(F64, 16), PLACE_OF(SM_U8, 0x10000), PLACE_OF(SM_F64, 0xfffff),
                            PLACE_OF(SM_I8, 0xfffff)};
    Build b;

    for (unsigned i = 0; i < 8; i++) {
        uint8_t *p;
        b = build_good_machine();
        p = b.init;
        put_bytes(&p, bad[i], 3);
        put_bytes(&p, 0, 8);
        b.init_size = 11;
        REFUSED(&b, INIT);
    }
    b = build_good_machine();
    for (b.init_size = 1; b.init_size < 5; b.init_size++)
        REFUSED(&b, INIT);
    memcpy(b.init + 5, b.init, 5);
    for (b.init_size = 6; b.init_size < 10; b.init_size++)
        REFUSED(&b, INIT);
    CHECK(verify(&b, &(SmvmVerdict){0}) == 0);
}

// The last positions that exist are accepted, those after them are refused.
static void test_initial_values_after_the_last_are_refused(void)
{
    static const struct { uint8_t type, bytes; uint32_t good; } row[] = {{SM_F64, 8, 0}, {SM_U16, 2, 5}, {SM_I32, 4, 2}, {SM_BOOL, 1, 12}};

    for (unsigned i = 0; i < 4; i++)
        for (uint32_t more = 0; more < 2; more++) {
            Build b = build_good_machine();
            uint8_t *p = b.init;
            SmvmVerdict v;
            b.locals = 13;
            b.size = b.ends = 0;                      // (without code that uses more)
            b.windows = 0;
            for (int k = 0; k < 7; k++)
                end_function(&b);
            put_bytes(&p, PLACE_OF(row[i].type, row[i].good + more), 3);
            b.init_size = 3u + row[i].bytes;
            CHECK(verify(&b, &v) == (more ? SMVM_R_INIT : 0));
        }
}

// Either of two machines can be the invalid one.
static void test_verdict_names_the_machine(void)
{
    static const uint8_t id[] = {0x81, 0x82, 0x02, 0x81, 0x82, 0x83, 0x02};
    SmvmVerdict v;
    Build b[2];

    for (uint32_t k = 0; k < 2; k++) {
        b[0] = b[1] = build_good_machine();
        b[k].output[VALUE] = PLACE(F64, 40);
        CHECK(smvm_verify(image, build_sections(b, 7, id, image), &v) == SMVM_R_OUTPUTS && v.machine == k);
        b[k] = build_good_machine();
        b[k].states++;
        CHECK(smvm_verify(image, build_sections(b, 7, id, image), &v) == SMVM_R_RECORD && v.machine == k);
        b[k] = build_good_machine();
        b[k].code[b[k].size - 1] = 0xd0;
        CHECK(smvm_verify(image, build_sections(b, 7, id, image), &v) == SMVM_R_OPCODE && v.machine == k);
        b[k] = build_good_machine();
        memmove(b[k].code + b[k].end[0] + 4, b[k].code + b[k].end[0], b[k].size - b[k].end[0]);
        memcpy(b[k].code + b[k].end[0], (const uint8_t[]){SMVM_ldx_plus, 0, SMVM_ldy_plus, 1}, 4);
        b[k].size += 4;
        for (unsigned i = 1; i < b[k].ends; i++)
            b[k].end[i] += 4;
        CHECK(smvm_verify(image, build_sections(b, 7, id, image), &v) == 0 && v.machine == 0 && v.longest == (SMVM_LONGEST ? 19 : 0));
    }
}

// ---- the code ----

static void test_wrong_function_ends_are_refused(void)
{
    Build b = build_good_machine();

    b.end[2]--;                                       // the last instruction before `end`
    REFUSED(&b, FALLS_OUT);
    b = build_good_machine();
    b.end[2] -= 2;                                    // into the middle of an instruction
    REFUSED(&b, TRUNCATED);
    b = build_good_machine();
    b.end[2] = b.end[1] - 1;                          // an end before the start
    REFUSED(&b, FUNCTIONS);
    b = build_good_machine();
    b.end[6] = b.size + 1;                            // after the end of the code
    b.end[5] = b.size;
    REFUSED(&b, FUNCTIONS);
    b = build_good_machine();
    b.end[6] = 255;
    REFUSED(&b, FUNCTIONS);
    b = build_good_machine();
    b.size++;                                         // code outside all functions
    REFUSED(&b, FUNCTIONS);
}

// Begins a state.  The instructions that the caller adds until close_step become its step function.
static void open_step(Build *b)
{
    put_good_machine(b);
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

static void test_unknown_opcodes_are_refused(void)
{
    for (unsigned op = 0; op < 256; op++) {           // a single byte
        const uint32_t shape = smvm_shape((uint8_t)op);
        if (op == SMVM_end)
            continue;
        if (shape == 0)
            STEP_REFUSED(code(&b, op, 0), OPCODE);
        else if (shape & (SMVM_SHAPE_X | SMVM_SHAPE_Y))
            STEP_REFUSED(code(&b, op, 0), REGISTER);
        else if (shape & SMVM_SHAPE_FOLLOWS)
            STEP_REFUSED(code(&b, op, 0), TRUNCATED);
        else
            STEP_REFUSED(code(&b, op, 0), FALLS_OUT);
    }
}

// Loads the registers, then appends op with these numbers, and `end`.
#define WITH_BOTH(op, n, a, c, rule)                              \
    STEP_REFUSED(put_load_input(&b); typed(&b, SMVM_ldy_elem, SM_F64, IN);    \
                 code(&b, op, n, a, c); code(&b, SMVM_end, 0), rule)

static void test_truncated_instructions_are_refused(void)
{
    STEP_REFUSED(code(&b, SMVM_stat, 1, 0), TRUNCATED);
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jxn, 1, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_ldx_plus, 1, 0x60); b.size--, TRUNCATED);         // a varint of two bytes without its second
    STEP_REFUSED(code(&b, SMVM_goto, 1, 0xc60); b.size--, TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_ldx_plus, 1, 0x60); b.code[b.size - 1] = 0x80; code(&b, SMVM_end, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_ldx_plus, 1, 0); b.code[b.size - 1] = 0x80; code(&b, SMVM_end, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_stat, 2, 0, 0); b.code[b.size - 2] = 0xff; code(&b, SMVM_end, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 0); b.code[b.size - 1] = SMVM_end; code(&b, SMVM_end, 0), TRUNCATED);
}

// Of each kind of operand, the last one that exists is accepted, and the next one is refused.
static void test_operands_out_of_range_are_refused(void)
{
    static const uint32_t far[] = {0x60, 0xc60, 0x10000, 0x1000c5f};

    for (unsigned t = 0; t <= SMVM_RAW; t++)
        for (unsigned y = 0; y < 0x40; y += 0x20) {
            const unsigned bytes = t == SMVM_RAW ? 8 : sm_type_info[t].bytes;
            WITH_BOTH(SMVM_ldx_local + y + t, 1, 16 / bytes, 0, OPERAND);
            WITH_BOTH(SMVM_ldx_local + y + t, 1, 16 / bytes - 1, 0, OK);
            if (t < SMVM_RAW) {
                WITH_BOTH(SMVM_ldx_elem + y + t, 1, 40 / bytes, 0, OPERAND);
                WITH_BOTH(SMVM_ldx_elem + y + t, 1, 40 / bytes - 1, 0, OK);
            }
            for (unsigned i = 0; i < 4; i++) {
                WITH_BOTH(SMVM_ldx_local + y + t, 1, far[i], 0, OPERAND);
                if (t < SMVM_RAW)
                    WITH_BOTH(SMVM_ldx_elem + y + t, 1, far[i], 0, OPERAND);
            }
        }
    for (unsigned t = 0; t <= SMVM_RAW; t++) {
        const unsigned bytes = t == SMVM_RAW ? 8 : sm_type_info[t].bytes;
        WITH_BOTH(SMVM_st_local + t, 1, 16 / bytes, 0, OPERAND);
        WITH_BOTH(SMVM_st_local + t, 1, 16 / bytes - 1, 0, OK);
        WITH_BOTH(SMVM_st_local + t, 1, 0x1000c5f, 0, OPERAND);
        WITH_BOTH(SMVM_cvt, 1, t, 0, OK + (t == SMVM_RAW ? SMVM_R_OPERAND : 0));
    }
    for (unsigned m = 0; m < 20; m++)
        WITH_BOTH(SMVM_set, 1, m, 0, OK + (m < 1 || m > 14 ? SMVM_R_OPERAND : 0));
    for (unsigned n = 0; n < 40; n++) {
        WITH_BOTH(SMVM_fn, 1, n, 0, OK + (n > 8 && (n < 16 || n > 18) ? SMVM_R_FUNCTION : 0));
    }
    for (unsigned i = 0; i < 4; i++) {
        WITH_BOTH(SMVM_fn, 1, far[i], 0, OK + SMVM_R_FUNCTION);
        WITH_BOTH(SMVM_out, 1, far[i], 0, OPERAND);
        WITH_BOTH(SMVM_cvt, 1, far[i], 0, OPERAND);
        WITH_BOTH(SMVM_set, 1, far[i], 0, OPERAND);
        WITH_BOTH(SMVM_ldx_f32, 1, far[i], 0, OPERAND);
        WITH_BOTH(SMVM_ldy_f64, 1, far[i], 0, OPERAND);
        WITH_BOTH(SMVM_ldx_plus, 1, far[i], 0, OK);
        WITH_BOTH(SMVM_ldy_minus, 1, far[i], 0, OK);
        WITH_BOTH(SMVM_addi, 1, far[i], 0, OK);
        WITH_BOTH(SMVM_jxn, 2, far[i], 0, OK);
    }
    WITH_BOTH(SMVM_out, 1, 2, 0, OPERAND);
    WITH_BOTH(SMVM_ldx_f32, 1, 1, 0, OPERAND);
    WITH_BOTH(SMVM_ldy_f32, 1, 1, 0, OPERAND);
    WITH_BOTH(SMVM_ldx_f64, 1, 1, 0, OPERAND);
    WITH_BOTH(SMVM_ldy_f64, 1, 1, 0, OPERAND);
}

// Elements before and after the part of the vector that the machine uses.
static void test_elements_outside_the_part_are_refused(void)
{
    for (unsigned t = 0; t < SM_TYPE_COUNT; t++)
        for (unsigned k = 0; k < 4; k++) {
            const unsigned bytes = sm_type_info[t].bytes;
            const uint32_t at[] = {16 / bytes - 1, 16 / bytes, 48 / bytes - 1, 48 / bytes};
            SmvmVerdict v;
            Build b;
            open_step(&b);
            code(&b, SMVM_ldx_elem + t, 1, at[k]);
            code(&b, SMVM_end, 0);
            close_step(&b);
            b.sv_words = 8;
            b.from = 2;
            b.to = 6;
            b.g = 5;
            b.s = 8;
            CHECK(verify(&b, &v) == (k == 0 || k == 3 ? SMVM_R_OPERAND : 0));
        }
}

static void test_statistics_that_a_window_lacks_are_refused(void)
{
    static const struct { unsigned stat, window; uint8_t rule; } row[] = {
        {SM_STAT_AVG, 2, SMVM_R_WINDOW_USED}, {SM_STAT_AVG, 0x1000c5f, SMVM_R_WINDOW_USED}, {SM_STAT_AVG, 0x10000, SMVM_R_WINDOW_USED},
        {SM_STAT_AVG, 1, SMVM_R_WINDOW_USED}, {SM_STAT_MEDIAN, 0, SMVM_R_WINDOW_USED}, {SM_STAT_MIN, 1, SMVM_R_WINDOW_USED},       // not in the window
        {SM_STAT_MAX, 0, SMVM_R_WINDOW_USED}, {SM_STAT_RANGE, 0, SMVM_R_WINDOW_USED}, {SM_STAT_COUNT, 0, SMVM_R_OPERAND},
        {0x10000, 0, SMVM_R_OPERAND}, {0x1000c5f, 0, SMVM_R_OPERAND}, {SM_STAT_AVG, 0, 0}, {SM_STAT_MIN, 0, 0}, {SM_STAT_MEDIAN, 1, 0},
    };

    for (unsigned i = 0; i < sizeof row / sizeof *row; i++)
        STEP_REFUSED(code(&b, SMVM_stat, 2, row[i].stat, row[i].window); code(&b, SMVM_end, 0), OK + row[i].rule);
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_sample, 1, 2); code(&b, SMVM_end, 0), WINDOW_USED);
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_sample, 1, 0); code(&b, SMVM_end, 0), SAMPLE);           // outside the sample function
}

#define SAMPLE_REFUSED(statements, rule)          \
    do {                                          \
        Build b;                                  \
        put_good_machine(&b);                                 \
        b.size = b.ends = 0;                      \
        statements;                               \
        end_function(&b);                         \
        good_states(&b);                          \
        REFUSED(&b, rule);                        \
    } while (0)

static void put_sample(Build *b, unsigned w)
{
    put_load_input(b);
    code(b, SMVM_sample, 1, w);
}

static void put_average(Build *b) { code(b, SMVM_stat, 2, SM_STAT_AVG, 0); }

static void test_each_window_is_sampled_once(void)
{
    SAMPLE_REFUSED((void)b, SAMPLE);                                                            // the sample function has no sample
    SAMPLE_REFUSED(put_sample(&b, 0); code(&b, SMVM_end, 0), SAMPLE);                               // one sample is missing
    SAMPLE_REFUSED(put_sample(&b, 1); put_sample(&b, 0); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(put_sample(&b, 0); put_sample(&b, 0); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(put_sample(&b, 0); put_sample(&b, 1); put_sample(&b, 1); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(put_average(&b); code(&b, SMVM_end, 0), SAMPLE);  // a statistic is read before its window is sampled
    SAMPLE_REFUSED(put_average(&b); put_sample(&b, 0); put_sample(&b, 1); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 2); code(&b, SMVM_sample, 1, 0); put_sample(&b, 1); code(&b, SMVM_end, 0), SAMPLE);      // can be skipped
    SAMPLE_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 1); code(&b, SMVM_end, 0); put_sample(&b, 0); put_sample(&b, 1); code(&b, SMVM_end, 0), SAMPLE);     // can end before
    SAMPLE_REFUSED(put_sample(&b, 0); put_sample(&b, 1); code(&b, SMVM_goto, 1, 1), GOTO);
}

static void test_wrong_transitions_are_refused(void)
{
    STEP_REFUSED(code(&b, SMVM_goto, 1, 0), GOTO);
    STEP_REFUSED(code(&b, SMVM_goto, 1, 3), GOTO);
    STEP_REFUSED(code(&b, SMVM_goto, 1, 0x1000c5f), GOTO);
}

static void test_transition_in_exit_is_refused(void)
{
    Build b;

    open_step(&b);
    end_function(&b);
    code(&b, SMVM_goto, 1, 1);
    end_function(&b);
    put_state(&b, 1);
    REFUSED(&b, GOTO);
}

static void test_wrong_jumps_are_refused(void)
{
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 1); code(&b, SMVM_end, 0), JUMP);                 // to the function's end
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 0), JUMP);
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 2); code(&b, SMVM_end, 0), JUMP);                 // into the next function
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 0x1000c5f); code(&b, SMVM_end, 0), JUMP);         // the largest that can be encoded
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 0x10000); code(&b, SMVM_end, 0), JUMP);
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 1); put_load_input(&b); code(&b, SMVM_end, 0), JUMP);                // into an instruction
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 2); code(&b, SMVM_stat, 2, 0, 0); code(&b, SMVM_end, 0), JUMP);
    STEP_REFUSED(put_load_input(&b), FALLS_OUT);
    STEP_REFUSED(code(&b, SMVM_end, 0); put_load_input(&b), FALLS_OUT);
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 0); code(&b, SMVM_ldx_time, 0), FALLS_OUT);
}

static void load_both_registers(Build *b)
{
    put_load_input(b);
    typed(b, SMVM_ldy_elem, SM_F64, IN);
}

#define THEN(statements, rule) STEP_REFUSED(statements; code(&b, SMVM_end, 0), rule)

// Each instruction leaves a value in X, in Y, in both or in neither.  Reading a register without a value is refused.
static void test_registers_without_value_are_refused(void)
{
    THEN(code(&b, SMVM_addi, 1, 1), REGISTER);                                                  // X has no value yet
    THEN(code(&b, SMVM_ldy_plus, 1, 1); code(&b, SMVM_neg, 0), REGISTER);
    THEN(put_load_input(&b); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_add, 0); code(&b, SMVM_mul, 0), OK);
    THEN(code(&b, SMVM_fn, 1, SMVM_FN_exp), REGISTER);
    THEN(code(&b, SMVM_ldx_plus, 1, 1); code(&b, SMVM_fn, 1, SMVM_FN_exp), OK);
    THEN(code(&b, SMVM_ldx_plus, 1, 1); code(&b, SMVM_fn, 1, SMVM_FN_pow), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_fn, 1, SMVM_FN_pow), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_fn, 1, SMVM_FN_exp); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_set, 1, 1); code(&b, SMVM_add, 0), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_addi, 1, 1); code(&b, SMVM_cvt, 1, 0); code(&b, SMVM_neg, 0); code(&b, SMVM_or, 0), OK);
    THEN(load_both_registers(&b); put_load_input(&b); code(&b, SMVM_add, 0), REGISTER);  // Y no longer has a value
    THEN(load_both_registers(&b); code(&b, SMVM_ldx_time, 0); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_ldx_plus, 1, 0); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_stat, 2, 0, 0); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); typed(&b, SMVM_st_local, SM_I8, 0); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); typed(&b, SMVM_st_local, SM_I8, 0); code(&b, SMVM_neg, 0), OK);              // X is not changed
    THEN(load_both_registers(&b); code(&b, SMVM_out, 1, 0); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_out, 1, 0); code(&b, SMVM_jt, 1, 0), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_jmp, 1, 0); code(&b, SMVM_ldy_plus, 1, 0), REGISTER);          // (a jump to ldy)
    THEN(load_both_registers(&b); code(&b, SMVM_end, 0); code(&b, SMVM_neg, 0), REGISTER);                     // after the end
    THEN(load_both_registers(&b); code(&b, SMVM_goto, 1, 1); code(&b, SMVM_neg, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_jt, 1, 2); code(&b, SMVM_jmp, 1, 0); put_load_input(&b); code(&b, SMVM_add, 0), REGISTER);
    SAMPLE_REFUSED(load_both_registers(&b); code(&b, SMVM_sample, 1, 0); code(&b, SMVM_add, 0); code(&b, SMVM_sample, 1, 1); code(&b, SMVM_end, 0), REGISTER);
    SAMPLE_REFUSED(load_both_registers(&b); code(&b, SMVM_sample, 1, 0); code(&b, SMVM_neg, 0); code(&b, SMVM_sample, 1, 1); code(&b, SMVM_end, 0), OK);
}

// After a jump that is not taken, both registers have their numbers.  After a jump that is taken, they are unknown.
static void test_jumps_preserve_registers(void)
{
    for (unsigned op = 0x80; op < 0x100; op++) {      // a jump to each instruction
        const uint32_t shape = smvm_shape((uint8_t)op);
        const bool alone = (shape & SMVM_SHAPE_GX && !(shape & SMVM_SHAPE_X)) || op == SMVM_goto || op == SMVM_end || op == SMVM_jmp;
        if (shape == 0 || op == SMVM_sample)
            continue;
        THEN(load_both_registers(&b); code(&b, SMVM_jt, 1, 0); code(&b, op, shape & SMVM_SHAPE_K || (shape & SMVM_SHAPE_N && shape & SMVM_SHAPE_J) ? 2
             : shape & SMVM_SHAPE_FOLLOWS ? 1 : 0, op == SMVM_set || op == SMVM_goto ? 1 : op >= SMVM_ldx_elem && op < SMVM_stat ? 4 : 0, 0), OK + (alone ? 0 : SMVM_R_REGISTER));
    }
    THEN(load_both_registers(&b); code(&b, SMVM_jxy, 1, 1); code(&b, SMVM_add, 0), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_jxn, 2, 5, 1); code(&b, SMVM_add, 0), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_jf, 1, 1); code(&b, SMVM_add, 0), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_jt, 1, 1); code(&b, SMVM_add, 0), OK);
}

// A register has no value at the start of the next function.
static void test_registers_end_with_the_function(void)
{
    Build b;

    open_step(&b);
    put_load_input(&b);
    code(&b, SMVM_end, 0);
    end_function(&b);
    code(&b, SMVM_neg, 0);
    code(&b, SMVM_end, 0);
    end_function(&b);
    put_state(&b, 1);
    REFUSED(&b, REGISTER);
}

// ---- the longest step ----

static uint32_t longest_step_of(Build *b)
{
    SmvmVerdict v;

    close_step(b);
    memcpy(b->code + b->end[3], (const uint8_t[]){SMVM_end, SMVM_end, SMVM_end}, 3);            // the other state: 1, 1, 1
    b->size = b->end[3] + 3;
    b->end[4] = b->end[3] + 1;
    b->end[5] = b->end[3] + 2;
    b->end[6] = b->end[3] + 3;
    CHECK(verify(b, &v) == 0);
    return v.longest - 5;                             // without the sample function
}

static void test_longest_step_is_exact(void)
{
    Build b;

    open_step(&b);                                    // 4 and a jump on one side, 1 on the other, 2 before and 1 after
    code(&b, SMVM_ldx_time, 0);
    code(&b, SMVM_jt, 1, 2 + 4);
    for (unsigned i = 0; i < 4; i++)
        code(&b, SMVM_ldx_time, 0);
    code(&b, SMVM_jmp, 1, 1);
    code(&b, SMVM_ldx_time, 0);
    code(&b, SMVM_end, 0);
    CHECK(longest_step_of(&b) == 2 + 4 + 1 + 1);
    open_step(&b);                                    // unreachable code has no cost
    code(&b, SMVM_jmp, 1, 3);
    for (unsigned i = 0; i < 3; i++)
        code(&b, SMVM_ldx_time, 0);
    code(&b, SMVM_end, 0);
    CHECK(longest_step_of(&b) == 2);
}

// n conditions each jump to a separate `end` after 96 loads, the first condition to the last `end`.  While the verifier can follow all n jumps,
// the longest path passes all conditions.  Beyond that limit the verifier adds the costs of all code.
static void test_longest_step_of_many_jumps(void)
{
    enum { LOADS = 96, MOST = SMVM_JOINS + 20 };

    for (unsigned n = 1; n < MOST; n++) {
        uint32_t counted;
        Build b;
        open_step(&b);
        code(&b, SMVM_ldx_time, 0);
        for (unsigned i = 0; i < n; i++)
            code(&b, SMVM_jt, 1, 3 * (n - 1 - i) + LOADS + n - i);
        for (unsigned i = 0; i < LOADS; i++)
            code(&b, SMVM_ldx_time, 0);
        for (unsigned i = 0; i <= n; i++)
            code(&b, SMVM_end, 0);
        b.width = 2;
        counted = longest_step_of(&b);
        CHECK(n <= SMVM_JOINS ? counted == 1 + n + LOADS + 1 : counted == 1 + n + LOADS + n + 1);
    }
}

// ---- the longest step of random functions, found by trying every path ----

// `to`: the target of a jump; jt represents a load and a jump.
typedef struct Random { uint8_t op; unsigned to; } Random;

static uint64_t seed = 1;

static unsigned random_below(unsigned n)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (unsigned)(seed >> 20) % n;
}

// Returns the length of the longest path from instruction i that ends in `last`; 0 if there is none.
static unsigned measure_longest_path(const Random *r, unsigned i, uint8_t last)
{
    unsigned next, jump;

    if (r[i].op == SMVM_end || r[i].op == SMVM_goto)
        return r[i].op == last;
    if (r[i].op == SMVM_ldx_time) {
        next = measure_longest_path(r, i + 1, last);
        return next ? next + 1 : 0;
    }
    jump = measure_longest_path(r, r[i].to, last);
    next = r[i].op == SMVM_jmp ? 0 : measure_longest_path(r, i + 1, last);
    next = next > jump ? next : jump;
    return next ? next + (r[i].op == SMVM_jt ? 2 : 1) : 0;
}

static unsigned make_random_function(Random *r, bool may_go)
{
    unsigned n = 1 + random_below(14);

    for (unsigned i = 0; i < n; i++) {
        unsigned k = random_below(10);
        bool last = i + 1 == n;
        r[i].op = last || k == 0 ? (may_go && random_below(2) ? SMVM_goto : SMVM_end) : k < 3 ? SMVM_jmp : k < 7 ? SMVM_jt : SMVM_ldx_time;
        r[i].to = last ? 0 : i + 1 + random_below(n - i - 1);
    }
    return n;
}

static void put_random(Build *b, const Random *r, unsigned n)
{
    unsigned at[15] = {0};

    for (unsigned i = 0; i < n; i++)
        at[i + 1] = at[i] + (r[i].op == SMVM_jt ? 3 : r[i].op == SMVM_goto || r[i].op == SMVM_jmp ? 2 : 1);
    for (unsigned i = 0; i < n; i++) {
        if (r[i].op == SMVM_jt)
            code(b, SMVM_ldx_time, 0);
        if (r[i].op == SMVM_end || r[i].op == SMVM_ldx_time)
            code(b, r[i].op, 0);
        else
            code(b, r[i].op, 1, r[i].op == SMVM_goto ? 1 : at[r[i].to] - at[i + 1]);
    }
    end_function(b);
}

static void test_longest_step_of_random_functions(void)
{
    for (unsigned k = 0; k < 3000; k++) {
        unsigned ends[3], leaves[3], longest_max = 0;
        SmvmVerdict v;
        Build b;
        put_good_machine(&b);
        for (unsigned f = 0; f < 3; f++) {
            Random r[15];
            unsigned n = make_random_function(r, f < 2);
            put_random(&b, r, n);
            ends[f] = measure_longest_path(r, 0, SMVM_end);
            leaves[f] = measure_longest_path(r, 0, SMVM_goto);
        }
        if (leaves[0])                                                           // every path through a step
            longest_max = leaves[0] + ends[2];
        for (unsigned first = 0; first < 2; first++) {
            unsigned before = first ? ends[0] : 0;
            if (first && !ends[0])
                continue;
            if (ends[1] && before + ends[1] > longest_max)
                longest_max = before + ends[1];
            if (leaves[1] && before + leaves[1] + ends[2] > longest_max)
                longest_max = before + leaves[1] + ends[2];
        }
        b.states = 1;
        b.width = 2;
        CHECK(verify(&b, &v) == 0 && v.longest == 5 + longest_max);
    }
}

int main(void)
{
    test_good_machine_is_accepted();
    test_damaged_header_is_refused();
    test_wrong_section_table_is_refused();
    test_safe_marks_are_checked();
    test_swap_and_abort_marks_are_checked();
    test_marks_of_nine_states_need_two_bytes();
    test_wrong_machine_record_is_refused();
    short_machine();
    test_wrong_tables_are_refused();
    test_elements_outside_the_vector_are_refused();
    test_wrong_outputs_are_refused();
    test_too_many_windows_are_refused();
    test_wrong_initial_values_are_refused();
    test_initial_values_after_the_last_are_refused();
    test_verdict_names_the_machine();
    test_wrong_function_ends_are_refused();
    test_unknown_opcodes_are_refused();
    test_truncated_instructions_are_refused();
    test_operands_out_of_range_are_refused();
    test_elements_outside_the_part_are_refused();
    test_statistics_that_a_window_lacks_are_refused();
    test_each_window_is_sampled_once();
    test_wrong_transitions_are_refused();
    test_transition_in_exit_is_refused();
    test_wrong_jumps_are_refused();
    test_registers_without_value_are_refused();
    test_jumps_preserve_registers();
    test_registers_end_with_the_function();
    if (SMVM_LONGEST) {
        test_longest_step_is_exact();
        test_longest_step_of_many_jumps();
        test_longest_step_of_random_functions();
    }
    return test_end("vm_verify");
}
