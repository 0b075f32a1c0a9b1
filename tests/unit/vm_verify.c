// SPDX-License-Identifier: Apache-2.0
// The verifier and the data of an image: the container, its sections, marks of states, the machine and its tables.  A valid image is changed
// so that it violates each rule, in each way that a hostile image can.  It must be refused for exactly this rule.
#include "tests/unit/vm_good.h"

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
    return test_end("vm_verify");
}
