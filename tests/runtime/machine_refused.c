// SPDX-License-Identifier: Apache-2.0
// The causes for which sm_machine_init refuses a machine, with their results, and images that must not be trusted.
#include "bytecode-vm/image.h"
#include "machine_stage.h"
#include "plain_tester.h"
#include "stdlib/crc32.h"

// Checks that init returns `expected`, and writes no byte and no event.  Afterwards the machine does not step.
static void expect_refused(SmResult expected)
{
    StandSv before = stand_sv;

    stage.cursor = 0;
    CHECK(sm_machine_init(&stage.machine) == expected);
    CHECK(sm_machine_step(&stage.machine, &stage.tick) == SM_E_ARGUMENT);
    CHECK(memcmp(&before, &stand_sv, sizeof before) == 0 && nothing_happened());
}

static void test_other_layout_is_refused(Kind kind, bool guarded)
{
    SmLayout layout = *stand_vector.layout;

    set_stage(kind, guarded);
    stage.vector.layout = &layout;
    layout.hash++;
    expect_refused(SM_E_LAYOUT);
    layout.hash--;
    layout.whole.size -= 8;
    expect_refused(SM_E_LAYOUT);
    layout.whole.size += 16;
    expect_refused(SM_E_LAYOUT);
    layout.whole.size -= 8;
    CHECK(sm_machine_init(&stage.machine) == SM_OK);
}

static void test_missing_state_is_refused(Kind kind, bool guarded)
{
    set_stage(kind, guarded);
    stage.machine.initial = TESTER_STATES + 1;
    expect_refused(SM_E_ARGUMENT);
    stage.machine.initial = UINT32_MAX;
    expect_refused(SM_E_ARGUMENT);
    stage.machine.initial = TESTER_STATES;
    CHECK(sm_machine_init(&stage.machine) == SM_OK);
}

// After a refused init, the machine that ran before does not step.
static void test_refused_init_stops_the_machine(Kind kind, bool guarded)
{
    start_stage(kind, guarded);
    CHECK(step(1) == SM_OK);
    stage.machine.initial = TESTER_STATES + 1;
    CHECK(sm_machine_init(&stage.machine) == SM_E_ARGUMENT && step(1) == SM_E_ARGUMENT && stand_sv.valve == 1);
    CHECK(stage.machine.type->step(stage.machine.self, &stand_sv) == SM_E_ARGUMENT);
}

static void test_misaligned_memory_is_refused(Kind kind, bool guarded)
{
    static uint64_t room[sizeof(StandSv) / 8 + 1];

    set_stage(kind, guarded);
    stage.vector.at = (uint8_t *)room + 4;
    expect_refused(SM_E_ALIGNMENT);
    stage.vector.at = &stand_sv;
    if (!guarded)
        return;
    stage.machine.copy = (uint8_t *)room + 1;
    expect_refused(SM_E_ALIGNMENT);
    stage.machine.copy = NULL;
    expect_refused(SM_E_ARGUMENT);
}

// A machine emitted without --track-stores runs in place.  On a guarded vector it is refused, because the stores to write back are unknown.
static void test_untracked_needs_unguarded_vector(void)
{
    static PlainTester self;

    set_stage(EMITTED, true);
    stage.machine.type = &plain_tester_machine;
    stage.machine.self = &self;
    expect_refused(SM_E_UNSUPPORTED);
    set_stage(EMITTED, false);
    stage.machine.type = &plain_tester_machine;
    stage.machine.self = &self;
    CHECK(sm_machine_init(&stage.machine) == SM_OK);
}

// ---- images ----

static void test_bad_image_is_refused(Kind kind, bool guarded)
{
    static uint8_t image[sizeof tester_image];

    memcpy(image, tester_image, sizeof image);
    set_stage(kind, guarded);
    stage.target.image = image;
    image[sizeof image / 2] ^= 1;
    expect_refused(SM_E_IMAGE);
    CHECK(stage.target.why.rule == SMVM_R_CRC);
    image[sizeof image / 2] ^= 1;
    stage.target.size--;
    expect_refused(SM_E_IMAGE);
    CHECK(stage.target.why.rule == SMVM_R_LENGTH);
    stage.target.size = 0;
    expect_refused(SM_E_IMAGE);
    stage.target.size = sizeof image + 100;       // more memory than it needs is accepted
    stage.target.machine = 2;
    expect_refused(SM_E_MISSING);
    stage.target.machine = UINT32_MAX;
    expect_refused(SM_E_MISSING);
    stage.target.machine = 0;
    CHECK(sm_machine_init(&stage.machine) == SM_OK);
}

static void test_little_memory_is_refused(Kind kind, bool guarded)
{
    SmvmMachine m;

    smvm_machine(tester_image, 0, &m);
    set_stage(kind, guarded);
    stage.target.memory_size = smvm_ram_size(&m) - 1;
    expect_refused(SM_E_MEMORY);
    stage.target.memory_size++;
    stage.target.memory = (uint8_t *)stage.memory + 4;
    expect_refused(SM_E_ALIGNMENT);
    stage.target.memory = stage.memory;
    if (kind == DECODED) {
        stage.target.decoded_size = smvm_decoded_size(&m) - 1;
        expect_refused(SM_E_MEMORY);
        stage.target.decoded_size++;
        stage.target.decoded = (uint8_t *)stage.decoded + 4;
        expect_refused(SM_E_ALIGNMENT);
        stage.target.decoded = stage.decoded;
    }
    CHECK(sm_machine_init(&stage.machine) == SM_OK);
}

static void for_images(void (*test)(Kind kind, bool guarded))
{
    for (int guarded = 0; guarded < 2; guarded++) {
        test(IMAGE, guarded != 0);
        test(DECODED, guarded != 0);
    }
}

// The second machine of an image with two machines, and an image without names.
static void test_second_machine_of_an_image(void)
{
    set_stage(IMAGE, true);
    stage.target.image = pair_image;
    stage.target.size = sizeof pair_image;
    stage.target.machine = 1;
    CHECK(sm_machine_init(&stage.machine) == SM_OK && strcmp(sm_machine_state_name(&stage.machine, 2), "Busy") == 0);
    set_stage(IMAGE, true);
    stage.target.image = stripped_image;
    stage.target.size = sizeof stripped_image;
    CHECK(sm_machine_init(&stage.machine) == SM_OK && strcmp(sm_machine_state_name(&stage.machine, 2), "") == 0);
    CHECK(step(2) == SM_OK && sm_machine_state(&stage.machine) == 2);
}

// A machine that is started without a decoder does not run the code that was decoded before.
static void test_start_without_decoder(void)
{
    start_stage(DECODED, false);
    CHECK(step(1) == SM_OK);
    stage.target.decoder = NULL;
    memset(stage.decoded, 0, sizeof stage.decoded);
    CHECK(sm_machine_init(&stage.machine) == SM_OK && step(1) == SM_OK && stand_sv.valve == 0);
}

static void test_needed_memory_is_reported(void)
{
    SmvmMachine m;
    uint32_t words = 0;

    smvm_machine(tester_image, 0, &m);
    for (uint32_t w = 0; w < m.windows; w++) {
        uint32_t entry = smvm_window(tester_image, m.windows_at, w);
        words += sm_roll_words(entry & SMVM_WINDOW_SIZE_MASK, entry >> SMVM_WINDOW_SIZE_BITS);
    }
    CHECK(m.windows == 1 && smvm_target_memory(tester_image, sizeof tester_image, 0) == smvm_ram_size(&m));
    CHECK(SMVM_WORDS(m.windows, words, m.locals, m.outputs) == (smvm_ram_size(&m) + 7) / 8);
    CHECK(smvm_target_memory(tester_image, sizeof tester_image, 2) == 0 && smvm_target_memory(tester_image, 10, 0) == 0);
    smvm_machine(picker_image, 0, &m);
    CHECK(m.outputs == 70 && SMVM_WORDS(0, 0, m.locals, m.outputs) == (smvm_ram_size(&m) + 7) / 8);
}

// ---- names are not verified ----

static void fix_crc(uint8_t *image, uint32_t size)
{
    uint32_t crc = SM_CRC32_START;

    for (uint32_t i = 0; i < size; i++)
        if (i < SMVM_CRC_AT || i >= SMVM_CRC_AT + 4)
            crc = sm_crc32_byte(crc, image[i]);
    crc = sm_crc32_end(crc);
    for (uint32_t i = 0; i < 4; i++)
        image[SMVM_CRC_AT + i] = (uint8_t)(crc >> 8 * i);
}

// Each byte of the names is changed to several other values.  Each name that is read still begins and ends in the image.
static void test_changed_names_stay_in_the_image(void)
{
    static uint8_t image[sizeof tester_image];
    const char *name;
    SmvmMachine m;

    smvm_machine(tester_image, 0, &m);
    memcpy(image, tester_image, sizeof image);
    for (uint32_t i = 0; i < m.debug_size; i++)
        for (unsigned flip = 1; flip < 256; flip *= 2) {
            image[m.debug_at + i] ^= (uint8_t)flip;
            fix_crc(image, sizeof image);
            set_stage(IMAGE, false);
            stage.target.image = image;
            CHECK(sm_machine_init(&stage.machine) == SM_OK);
            for (uint32_t s = 0; s < 5; s++) {
                name = sm_machine_state_name(&stage.machine, s);
                CHECK(*name == '\0' || (name >= (char *)image + m.debug_at && name + strlen(name) < (char *)image + sizeof image));
            }
            image[m.debug_at + i] ^= (uint8_t)flip;
        }
}

// The name of the first state is in the last three bytes: its length, and two characters, of which the second is `last`.
static const char *check_name_at_the_end(uint8_t length, uint8_t last)
{
    static uint8_t image[sizeof tester_image + 1];        // followed by a 0
    SmvmMachine m;
    uint8_t *names;

    smvm_machine(tester_image, 0, &m);
    memcpy(image, tester_image, sizeof tester_image);
    names = image + m.debug_at;
    names[3 * SMVM_DEBUG_NUMBERS] = (uint8_t)(m.debug_size - 3);
    names[3 * SMVM_DEBUG_NUMBERS + 1] = (uint8_t)((m.debug_size - 3) >> 8);
    names[m.debug_size - 3] = length;
    names[m.debug_size - 2] = 'a';
    names[m.debug_size - 1] = last;
    fix_crc(image, sizeof tester_image);
    set_stage(IMAGE, false);
    stage.target.image = image;
    CHECK(m.debug_at + m.debug_size == sizeof tester_image && sm_machine_init(&stage.machine) == SM_OK);
    return sm_machine_state_name(&stage.machine, 1);
}

static void test_names_without_end(void)
{
    CHECK(strcmp(check_name_at_the_end(1, 0), "a") == 0);
    CHECK(strcmp(check_name_at_the_end(1, 'b'), "") == 0);      // no 0 follows
    CHECK(strcmp(check_name_at_the_end(2, 'b'), "") == 0);      // the 0 would be outside the section
    CHECK(strcmp(check_name_at_the_end(9, 'b'), "") == 0);
}

int main(void)
{
    for_all(test_other_layout_is_refused);
    for_all(test_missing_state_is_refused);
    for_all(test_refused_init_stops_the_machine);
    for_all(test_misaligned_memory_is_refused);
    test_untracked_needs_unguarded_vector();
    for_images(test_bad_image_is_refused);
    for_images(test_little_memory_is_refused);
    test_second_machine_of_an_image();
    test_start_without_decoder();
    test_needed_memory_is_reported();
    test_changed_names_stay_in_the_image();
    test_names_without_end();
    return test_end("machine_refused");
}
