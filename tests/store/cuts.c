// SPDX-License-Identifier: Apache-2.0
// Updates with the power cut before, inside and after every write and erase: one cut, or two of which the second is after the restart.  Wherever
// the power fails, the old or the new image runs.  With one slot, the built-in image runs if the old one was already overwritten.
//   cuts OLD.smb NEW.smb          all single cuts, and one in 65 pairs
//   cuts OLD.smb NEW.smb all      all pairs
#include <string.h>

#include "runtime-c/link/link.h"
#include "tests/store/image.h"
#include "tests/test.h"

// The simulated device: a restart clears `store`, but not the simulated memory.
typedef struct Device {
    const char *memory;
    uint8_t slots;
    Store store;
    uint8_t slot;             // the slot of the running image
} Device;

typedef enum Runs { RUNS_OLD, RUNS_NEW, RUNS_BUILT_IN, RUNS_NOTHING } Runs;

static Image old_image, new_image;

// ---- what happens to it ----

static bool open_store(Device *d) { return image_store(&d->store, d->memory, d->slots); }

// Starts the device and returns the running image.  The power can also fail while it chooses an image; then no image runs yet.
static Runs start_device(Device *d)
{
    const uint8_t *there;
    uint32_t checksum;

    sim_power_on();
    if (!open_store(d) || smvm_store_boot(&d->store, &d->slot) != SM_OK)
        return RUNS_NOTHING;
    if (d->slot == STORE_BUILT_IN)
        return RUNS_BUILT_IN;
    if (smvm_store_state(&d->store, d->slot) == STORE_EMPTY)
        return RUNS_NOTHING;
    there = d->store.plan.image[d->slot];
    checksum = smvm_uint(there, SMVM_CRC_AT, 4);
    if (checksum == old_image.checksum && memcmp(there, old_image.bytes, old_image.length) == 0)
        return RUNS_OLD;
    return checksum == new_image.checksum && memcmp(there, new_image.bytes, new_image.length) == 0 ? RUNS_NEW : RUNS_NOTHING;
}

static bool send_image(Device *d, const Image *image) { return image_send(&d->store, image) == SM_OK; }
static bool update_device(Device *d, const Image *image) { return send_image(d, image) && smvm_store_activate(&d->store, 7, 0) == SM_OK; }

// How far an update came before the power failed.
typedef struct Progress { bool chosen, confirmed; } Progress;

// Sends, chooses, starts and confirms the new image.  Ends when the power fails.
static Progress update_and_confirm(Device *d)
{
    Progress p = {false, false};

    if (!update_device(d, &new_image))
        return p;
    p.chosen = true;
    pal_nvm_close(d->store.nvm);
    if (!open_store(d) || smvm_store_boot(&d->store, &d->slot) != SM_OK)
        return p;
    p.confirmed = smvm_store_confirm(&d->store, new_image.checksum) == SM_OK;
    return p;
}

// Prepares a device on which the old image is confirmed and runs.
static void prepare_device(Device *d, const char *memory, uint8_t slots)
{
    memset(d, 0, sizeof *d);
    d->memory = memory;
    d->slots = slots;
    sim_reset();
    CHECK(open_store(d) && update_device(d, &old_image));
    CHECK(start_device(d) == RUNS_OLD);
    CHECK(smvm_store_confirm(&d->store, old_image.checksum) == SM_OK);
}

// ---- cuts ----

// Whether the device runs the right image after a cut: the new one if it was chosen; otherwise the old one or, with one slot, the built-in one.
static bool runs_expected_image(const Device *d, Runs runs, Progress p)
{
    if (p.chosen || runs == RUNS_NEW)
        return runs == RUNS_NEW;
    return runs == RUNS_OLD || (d->slots == 1 && runs == RUNS_BUILT_IN);
}

// The update is cut, the device restarts, the same update is cut again, and then completes: the new image must run at the end.
static bool survives_two_cuts(const char *memory, uint8_t slots, const uint32_t first[2], const uint32_t second[2])
{
    Device d;
    Progress p;
    Runs runs;

    prepare_device(&d, memory, slots);
    sim_cut_power(first[0], first[1]);
    p = update_and_confirm(&d);
    runs = start_device(&d);
    if (!runs_expected_image(&d, runs, p))
        return false;
    if (runs == RUNS_NEW)
        return smvm_store_confirm(&d.store, new_image.checksum) == SM_OK && start_device(&d) == RUNS_NEW;
    if (second) {
        sim_cut_power(second[0], second[1]);
        p = update_and_confirm(&d);
        runs = start_device(&d);
        if (!runs_expected_image(&d, runs, p))
            return false;
    }
    if (runs != RUNS_NEW && (!update_device(&d, &new_image) || start_device(&d) != RUNS_NEW))
        return false;
    return smvm_store_confirm(&d.store, new_image.checksum) == SM_OK && start_device(&d) == RUNS_NEW;
}

// The positions at which the power can fail in an update: the number of the write or erase, and how many of its bytes are done.
typedef struct Cuts { uint32_t at[2048][2]; uint32_t n; } Cuts;

static uint32_t writes_of_an_update(const char *memory, uint8_t slots)
{
    uint32_t before;
    Device d;

    prepare_device(&d, memory, slots);
    before = sim_count(SIM_nvm_write) + sim_count(SIM_nvm_erase);
    CHECK(update_and_confirm(&d).confirmed);
    return sim_count(SIM_nvm_write) + sim_count(SIM_nvm_erase) - before;
}

// Returns in `bytes` the memory after an update in which the power fails in write or erase number `call`, after `byte` bytes.
static void memory_after_cut(const char *memory, uint8_t slots, uint32_t call, uint32_t byte, uint8_t *bytes)
{
    Device d;

    prepare_device(&d, memory, slots);
    sim_cut_power(call, byte);
    update_and_confirm(&d);
    memcpy(bytes, sim_nvm(memory), SIM_NVM_SIZE);
}

// Lists each write or erase of an update, and each number of bytes after which it can be cut.
static void list_cuts(const char *memory, uint8_t slots, Cuts *cuts)
{
    static uint8_t done[SIM_NVM_SIZE], now[SIM_NVM_SIZE];
    const uint32_t calls = writes_of_an_update(memory, slots);

    cuts->n = 0;
    for (uint32_t call = 0; call < calls; call++) {
        memory_after_cut(memory, slots, call, SIM_NVM_SIZE, done);
        for (uint32_t byte = 0;; byte++) {
            memory_after_cut(memory, slots, call, byte, now);
            cuts->at[cuts->n][0] = call;
            cuts->at[cuts->n++][1] = byte;
            if (memcmp(now, done, sizeof now) == 0 || cuts->n == 2048)
                break;
        }
    }
    CHECK(cuts->n < 2048);
}

static void test_cuts_of_an_update(const char *memory, uint8_t slots, bool all)
{
    static Cuts cuts;
    uint32_t pairs = 0;

    list_cuts(memory, slots, &cuts);
    for (uint32_t i = 0; i < cuts.n; i++) {
        CHECK(survives_two_cuts(memory, slots, cuts.at[i], NULL));
        for (uint32_t k = 0; k < cuts.n; k++)
            if (all || (i % 13 == 0 && k % 5 == 0)) {
                CHECK(survives_two_cuts(memory, slots, cuts.at[i], cuts.at[k]));
                pairs++;
            }
    }
    printf("%s, %u slots: %u single cuts, %u pairs\n", memory, slots, (unsigned)cuts.n, (unsigned)pairs);
}

// ---- trials ----

static void test_unconfirmed_trial_ends(void)
{
    Device d;

    prepare_device(&d, "eeprom", 2);
    CHECK(update_device(&d, &new_image));
    CHECK(smvm_store_confirm(&d.store, new_image.checksum) == SM_E_ARGUMENT);       // it does not run yet
    for (int i = 0; i < STORE_TRIES; i++) {
        CHECK(start_device(&d) == RUNS_NEW && smvm_store_count_start(&d.store) == SM_OK);
        CHECK(smvm_store_begin(&d.store, 8, old_image.length, old_image.checksum) == SM_E_BUSY);
    }
    CHECK(start_device(&d) == RUNS_OLD);
    CHECK(start_device(&d) == RUNS_OLD && d.store.choice.confirmed);
}

// A host that restarts the board whenever it opens the line hardly shortens a trial.  An image that never runs for long still loses its trial.
static void test_short_start_counts_less(void)
{
    int starts = 0;
    Device d;

    prepare_device(&d, "eeprom", 2);
    CHECK(update_device(&d, &new_image) && start_device(&d) == RUNS_NEW && smvm_store_count_start(&d.store) == SM_OK);
    CHECK(d.store.choice.tries == (STORE_TRIES - 1) * STORE_START);
    for (; starts < 100 && start_device(&d) == RUNS_NEW; starts++)
        CHECK(smvm_store_flags(&d.store, 0) == STORE_FALLBACK);
    CHECK(starts == (STORE_TRIES - 1) * STORE_START && d.slot == 0);
    CHECK(smvm_store_flags(&d.store, 1) == STORE_STARTS_USED && smvm_store_flags(&d.store, 0) == 0);
    CHECK(start_device(&d) == RUNS_OLD && smvm_store_flags(&d.store, 1) == STORE_STARTS_USED);
    CHECK(update_device(&d, &new_image) && smvm_store_flags(&d.store, 1) == 0 && smvm_store_flags(&d.store, 0) == STORE_FALLBACK);
}

// A start counts once, only on trial, and only while the image on trial runs.
static void test_start_counts_once(void)
{
    uint32_t number;
    Device d;

    prepare_device(&d, "eeprom", 2);
    CHECK(update_device(&d, &new_image) && start_device(&d) == RUNS_NEW);
    number = sm_link_load(d.store.choice.number, 4);
    for (int i = 0; i < 3; i++)
        CHECK(smvm_store_count_start(&d.store) == SM_OK && sm_link_load(d.store.choice.number, 4) == number + 1);
    CHECK(start_device(&d) == RUNS_NEW && smvm_store_confirm(&d.store, new_image.checksum) == SM_OK);
    number = sm_link_load(d.store.choice.number, 4);
    CHECK(smvm_store_count_start(&d.store) == SM_OK && sm_link_load(d.store.choice.number, 4) == number);
    CHECK(update_device(&d, &old_image) && smvm_store_count_start(&d.store) == SM_OK);         // chosen, and not started yet
    CHECK(d.store.choice.tries == STORE_TRIES * STORE_START);
}

// If the record of a choice cannot be written, the earlier choice on the medium remains.
static void test_failed_choice_changes_nothing(void)
{
    Device d;

    prepare_device(&d, "eeprom", 2);
    CHECK(update_device(&d, &new_image) && start_device(&d) == RUNS_NEW);
    sim_break(SIM_nvm_write, 0, SM_E_DEVICE);
    CHECK(smvm_store_confirm(&d.store, new_image.checksum) == SM_E_DEVICE && !d.store.choice.confirmed);
    CHECK(smvm_store_count_start(&d.store) == SM_E_DEVICE && d.store.choice.tries == STORE_TRIES * STORE_START - 1);
    sim_break(SIM_nvm_write, 0, SM_OK);
    CHECK(smvm_store_confirm(&d.store, new_image.checksum) == SM_OK && d.store.choice.confirmed);
}

// If a start cannot be counted, the image on trial does not run, because the number of its starts would be unlimited.
static void test_uncounted_trial_does_not_run(void)
{
    Device d;

    prepare_device(&d, "eeprom", 2);
    CHECK(update_device(&d, &new_image));
    sim_break(SIM_nvm_write, 0, SM_E_DEVICE);
    sim_power_on();
    CHECK(open_store(&d) && smvm_store_boot(&d.store, &d.slot) == SM_E_DEVICE && d.slot == 0);
    sim_break(SIM_nvm_write, 0, SM_OK);
    CHECK(start_device(&d) == RUNS_NEW);
}

// At a start, an image on trial that cannot run is skipped, and the power fails during this: afterwards the trial continues, or it has ended.
static void test_cut_while_a_trial_is_skipped(const char *memory)
{
    Device d;
    Runs runs;

    for (uint32_t cut = 0; cut < 3 * (STORE_RECORD + 1); cut++) {
        prepare_device(&d, memory, 2);
        CHECK(update_device(&d, &new_image) && start_device(&d) == RUNS_NEW);
        sim_cut_power(cut / (STORE_RECORD + 1), cut % (STORE_RECORD + 1));
        (void)smvm_store_skip_image(&d.store, &d.slot);
        CHECK(d.slot == 0);
        runs = start_device(&d);
        CHECK(runs == RUNS_OLD || runs == RUNS_NEW);
        if (runs == RUNS_NEW)
            CHECK(smvm_store_skip_image(&d.store, &d.slot) == SM_OK && start_device(&d) == RUNS_OLD);
    }
}

static void test_erased_trial_runs_the_previous_image(void)
{
    Device d;

    prepare_device(&d, "flash", 2);
    CHECK(update_device(&d, &new_image) && start_device(&d) == RUNS_NEW);
    CHECK(smvm_store_erase(&d.store, 1) == SM_E_MISSING);
    CHECK(smvm_store_erase(&d.store, new_image.checksum) == SM_OK);
    CHECK(memcmp(d.store.plan.image[d.slot], new_image.bytes, new_image.length) == 0);          // it still runs
    CHECK(smvm_store_begin(&d.store, 8, new_image.length, new_image.checksum) == SM_E_BUSY);   // one slot is chosen, the other runs
    CHECK(start_device(&d) == RUNS_OLD);
    CHECK(smvm_store_erase(&d.store, old_image.checksum) == SM_OK);
    CHECK(start_device(&d) == RUNS_BUILT_IN);
    CHECK(update_device(&d, &new_image) && start_device(&d) == RUNS_NEW);
}

// Both slots contain the same image, and the memory fails at one call of the erasure.  This is reported for either slot.
static void test_failed_erasure_is_reported(void)
{
    static const SimCall calls[] = {SIM_nvm_write, SIM_nvm_erase};

    for (unsigned k = 0; k < sizeof calls / sizeof *calls; k++) {
        unsigned failures = 0;
        for (uint32_t n = 0; n < 6; n++) {
            Device d;
            uint32_t before;
            SmResult r;
            prepare_device(&d, "flash", 2);
            CHECK(update_device(&d, &old_image) && start_device(&d) == RUNS_OLD && smvm_store_confirm(&d.store, old_image.checksum) == SM_OK);
            CHECK(memcmp(d.store.plan.image[0], d.store.plan.image[1], old_image.length) == 0);
            before = sim_count(calls[k]);
            sim_fail(calls[k], n, SM_E_DEVICE);
            r = smvm_store_erase(&d.store, old_image.checksum);
            if (sim_count(calls[k]) - before <= n) {  // it had ended before this call
                CHECK(r == SM_OK);
                break;
            }
            failures++;
            CHECK(r == SM_E_DEVICE);
            CHECK(smvm_store_erase(&d.store, old_image.checksum) == SM_OK && start_device(&d) == RUNS_BUILT_IN);
        }
        CHECK(failures > 0);
    }
}

// A request that is repeated because its answer was lost has no further effect.  A request that does not belong to the update is refused.
static void test_steps_can_be_repeated(void)
{
    Device d;
    uint32_t writes;
    SmvmVerdict why;

    prepare_device(&d, "eeprom", 2);
    CHECK(send_image(&d, &new_image));
    writes = sim_count(SIM_nvm_write);
    CHECK(smvm_store_begin(&d.store, 7, new_image.length, new_image.checksum) == SM_OK);
    CHECK(smvm_store_write(&d.store, 7, 0, new_image.bytes, IMAGE_BLOCK) == SM_OK);
    CHECK(smvm_store_write(&d.store, 7, 0, old_image.bytes + 32, IMAGE_BLOCK) == SM_E_ARGUMENT);
    CHECK(smvm_store_write(&d.store, 6, 0, new_image.bytes, IMAGE_BLOCK) == SM_E_HANDLE);
    CHECK(smvm_store_write(&d.store, 7, new_image.length, new_image.bytes, 1) == SM_E_ARGUMENT);
    CHECK(smvm_store_end(&d.store, 7, &why) == SM_OK && sim_count(SIM_nvm_write) == writes);
    CHECK(smvm_store_activate(&d.store, 7, 0) == SM_OK && smvm_store_activate(&d.store, 7, 0) == SM_OK);
    CHECK(sim_count(SIM_nvm_write) == writes + 1);
    CHECK(start_device(&d) == RUNS_NEW);
    CHECK(smvm_store_confirm(&d.store, new_image.checksum) == SM_OK && smvm_store_confirm(&d.store, new_image.checksum) == SM_OK);
    CHECK(smvm_store_activate(&d.store, 7, 0) == SM_E_HANDLE && smvm_store_end(&d.store, 7, &why) == SM_E_HANDLE);
}

// The memory can already contain the image that is sent.  Only bytes that were sent in this session count.
static void test_old_content_does_not_count_as_sent(void)
{
    Device d;
    SmvmVerdict why;

    prepare_device(&d, "eeprom", 2);
    CHECK(send_image(&d, &new_image));
    CHECK(smvm_store_begin(&d.store, 8, new_image.length, new_image.checksum) == SM_OK);
    CHECK(smvm_store_activate(&d.store, 8, 0) == SM_E_HANDLE);
    CHECK(smvm_store_write(&d.store, 8, 0, new_image.bytes, IMAGE_BLOCK) == SM_OK);
    CHECK(smvm_store_write(&d.store, 8, 0, new_image.bytes, 2 * IMAGE_BLOCK) == SM_E_ARGUMENT);
    CHECK(smvm_store_end(&d.store, 8, &why) == SM_E_ARGUMENT && smvm_store_activate(&d.store, 8, 0) == SM_E_HANDLE);
}

// A valid image that is not the announced one is refused.
static void test_unannounced_image_is_refused(void)
{
    Image announced = new_image;
    Device d;

    prepare_device(&d, "flash", 2);
    announced.checksum ^= 1;
    CHECK(image_send(&d.store, &announced) == SM_E_DEVICE && smvm_store_activate(&d.store, 7, 0) == SM_E_HANDLE);
    CHECK(start_device(&d) == RUNS_OLD);
}

// After a failed write the content at its address is undefined.
static void test_failed_write_ends_the_update(void)
{
    Device d;

    prepare_device(&d, "flash", 2);
    CHECK(smvm_store_begin(&d.store, 7, new_image.length, new_image.checksum) == SM_OK);
    sim_fail(SIM_nvm_write, 0, SM_E_DEVICE);
    CHECK(smvm_store_write(&d.store, 7, 0, new_image.bytes, IMAGE_BLOCK) == SM_E_DEVICE);
    CHECK(smvm_store_write(&d.store, 7, 0, new_image.bytes, IMAGE_BLOCK) == SM_E_HANDLE);
    CHECK(update_device(&d, &new_image) && start_device(&d) == RUNS_NEW);
}

// The answer to the choice was lost, and the host repeats the choice after the image was confirmed.  The image stays confirmed, and the board
// still knows the image before it.
static void test_late_repetition_does_no_harm(void)
{
    Device d;

    prepare_device(&d, "eeprom", 2);
    CHECK(update_device(&d, &new_image));
    d.store.running = d.store.choice.active;
    CHECK(smvm_store_confirm(&d.store, new_image.checksum) == SM_OK && smvm_store_activate(&d.store, 7, 0) == SM_OK);
    CHECK(d.store.choice.confirmed && d.store.choice.previous != d.store.choice.active);
}

// A period is stored with its image.  With one slot, another period for the same image begins a new trial.
static void test_period_belongs_to_its_image(void)
{
    Device d;

    for (uint8_t slots = 1; slots <= 2; slots++) {
        prepare_device(&d, "eeprom", slots);
        CHECK(send_image(&d, &new_image) && smvm_store_activate(&d.store, 7, 20) == SM_OK && start_device(&d) == RUNS_NEW);
        CHECK(smvm_store_period(&d.store, d.store.running) == 20 && smvm_store_confirm(&d.store, new_image.checksum) == SM_OK);
        smvm_store_run_built_in(&d.store);
        CHECK(send_image(&d, &new_image) && smvm_store_activate(&d.store, 7, 30) == SM_OK);
        for (int i = 0; i < STORE_TRIES * STORE_START; i++)
            CHECK(start_device(&d) == RUNS_NEW && smvm_store_period(&d.store, d.store.running) == 30);
        CHECK(start_device(&d) == (slots == 1 ? RUNS_BUILT_IN : RUNS_NEW));
        CHECK(smvm_store_period(&d.store, d.store.running) == (slots == 1 ? 0 : 20));
    }
}

static void test_too_large_image_is_refused(void)
{
    Device d;
    StorePlan plan = {64, 2, {NULL, NULL}};
    Image damaged = new_image;
    Store s;

    prepare_device(&d, "eeprom", 2);
    CHECK(smvm_store_begin(&d.store, 9, d.store.slot_size + 1, 0) == SM_E_SPACE);
    CHECK(smvm_store_begin(&d.store, 9, 11, 0) == SM_E_ARGUMENT);         // an image begins with a header of 12 bytes
    CHECK(smvm_store_begin(&d.store, 0, 100, 0) == SM_E_ARGUMENT);
    damaged.bytes[damaged.length - 1] ^= 1;
    CHECK(!send_image(&d, &damaged) && smvm_store_activate(&d.store, 7, 0) == SM_E_HANDLE);
    CHECK(start_device(&d) == RUNS_OLD);
    CHECK(smvm_store_open(&s, d.store.nvm, &plan) == SM_E_SPACE);
    plan.slots = 3;
    CHECK(smvm_store_open(&s, d.store.nvm, &plan) == SM_E_ARGUMENT);
}

// ---- memory that goes bad ----

// Each bit of the memory is changed while the power is off.  A valid image runs, a damaged one never does.
static void test_flipped_bits_are_noticed(const char *memory)
{
    Device d;
    static uint8_t kept[SIM_NVM_SIZE];
    unsigned built_in = 0;

    prepare_device(&d, memory, 2);
    CHECK(update_device(&d, &new_image) && start_device(&d) == RUNS_NEW && smvm_store_confirm(&d.store, new_image.checksum) == SM_OK);
    memcpy(kept, sim_nvm(memory), sizeof kept);
    for (uint32_t bit = 0; bit < 8 * SIM_NVM_SIZE; bit++) {
        Runs runs;
        memcpy(sim_nvm(memory), kept, sizeof kept);
        sim_nvm(memory)[bit / 8] ^= (uint8_t)(1u << bit % 8);
        runs = start_device(&d);
        CHECK(runs == RUNS_NEW || runs == RUNS_OLD || runs == RUNS_BUILT_IN);
        built_in += runs == RUNS_BUILT_IN;
    }
    CHECK(built_in == 0);              // of two images and two records, one was always undamaged
}

// One bit of the memory is stuck during the update: the update is refused, or it works.
static void test_stuck_bits_are_noticed(void)
{
    for (uint32_t bit = 0; bit < 8 * SIM_NVM_SIZE; bit++)
        for (unsigned value = 0; value < 2; value++) {
            Device d;
            Runs runs;
            bool chosen;
            prepare_device(&d, "eeprom", 2);
            sim_stick("eeprom", bit / 8, (uint8_t)(1u << bit % 8), value ? 0xff : 0);
            chosen = update_device(&d, &new_image);
            runs = start_device(&d);
            CHECK(runs == RUNS_NEW || runs == RUNS_OLD);
            CHECK(chosen || runs == RUNS_OLD || bit / 8 < 2 * STORE_RECORD);
        }
}

int main(int argc, char **argv)
{
    const bool all = argc > 3 && strcmp(argv[3], "all") == 0;

    if (argc < 3 || !image_load(argv[1], &old_image) || !image_load(argv[2], &new_image)) {
        fprintf(stderr, "cuts OLD.smb NEW.smb [all]\n");
        return 2;
    }
    test_unconfirmed_trial_ends();
    test_short_start_counts_less();
    test_start_counts_once();
    test_failed_choice_changes_nothing();
    test_uncounted_trial_does_not_run();
    test_cut_while_a_trial_is_skipped("eeprom");
    test_cut_while_a_trial_is_skipped("flash");
    test_erased_trial_runs_the_previous_image();
    test_failed_erasure_is_reported();
    test_late_repetition_does_no_harm();
    test_steps_can_be_repeated();
    test_failed_write_ends_the_update();
    test_old_content_does_not_count_as_sent();
    test_unannounced_image_is_refused();
    test_period_belongs_to_its_image();
    test_too_large_image_is_refused();
    test_flipped_bits_are_noticed("eeprom");
    test_flipped_bits_are_noticed("flash");
    test_stuck_bits_are_noticed();
    for (uint8_t slots = 1; slots <= 2; slots++) {
        test_cuts_of_an_update("eeprom", slots, all);
        test_cuts_of_an_update("flash", slots, all);
    }
    return test_end("store");
}
