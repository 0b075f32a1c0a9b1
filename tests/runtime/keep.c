// SPDX-License-Identifier: Apache-2.0
// The guarantees of runtime-c/keep.h, in the simulation: the power is cut at every byte of every write, bits change, layouts differ, and
// memories refuse calls.
// that refuse.
#include <string.h>

#include "many.h"
#include "runtime-c/keep.h"
#include "runtime-c/psl/sim/sim.h"
#include "tests/test.h"
#include "wide.h"

enum { PACKED_MOST = 1000 };

static uint8_t buffer[2 * SM_KEEP_SIZE(PACKED_MOST)];
static SmKeep keep;
static const SmTick tick = {0, 0};

// Starts a program on memory `name`: the vector is 0, then the saved one is restored.
static SmResult start_program(const char *name, SmStateVec *sv)
{
    (void)pal_lock_close(keep.lock);
    (void)pal_lock_close(sv->lock);
    memset(&keep, 0, sizeof keep);
    memset(buffer, 0x5a, sizeof buffer);
    memset(sv->at, 0, sv->layout->whole.size);
    keep.memory = name;
    keep.sv = sv;
    keep.buffer = buffer;
    CHECK(sm_statevec_init(sv) == SM_OK);
    return sm_keep_restore(&keep);
}

// Starts the program again after a power failure.
static SmResult restart_program(const char *name, SmStateVec *sv)
{
    sim_power_on();
    return start_program(name, sv);
}

// Fills the vector with values that are computed from the number k.
static void fill_vector(uint32_t k)
{
    wide_sv.time = k;
    wide_sv.i64 = -(int64_t)k;
    wide_sv.f64 = k;
    wide_sv.flag = k % 2;
    wide_sv.app = k % 3 == 0;
    wide_sv.u16 = (uint16_t)k;
}

// Returns the number k with which the vector was filled; -1: it is a mixture.
static int64_t number_of_vector(void)
{
    const uint64_t k = wide_sv.time;

    return wide_sv.i64 == -(int64_t)k && wide_sv.f64 == (double)k && wide_sv.flag == k % 2 && wide_sv.app == (k % 3 == 0 && k > 0) &&
            wide_sv.u16 == (uint16_t)k ? (int64_t)k : -1;
}

static SmResult store_vector(uint32_t k)
{
    fill_vector(k);
    CHECK(sm_keep_step(&keep, &tick) == SM_OK);
    return sm_keep_write(&keep);
}

static const char *const memories[] = {"eeprom", "flash"};

static void test_plain(const char *name)
{
    sim_reset();
    CHECK(start_program(name, &wide_vector) == SM_OK && !keep.restored);
    CHECK(sm_keep_write(&keep) == SM_OK && sim_count(SIM_nvm_write) == 0);    // no snapshot is waiting
    for (uint32_t k = 1; k < 10; k++) {
        CHECK(store_vector(k) == SM_OK && keep.taken == k && keep.written == k && keep.replaced == 0);
        CHECK(restart_program(name, &wide_vector) == SM_OK && keep.restored && number_of_vector() == k);
        keep.taken = keep.written = k;
    }
    CHECK(restart_program(name, &wide_vector) == SM_OK && number_of_vector() == 9);     // restoring changes nothing
}

// ---- the power goes ----

// Stores vectors from number `from` on until the power fails; returns the last stored number.
static uint32_t store_until_cut(uint32_t from)
{
    uint32_t k = from;

    while (k < from + 10 && store_vector(k) == SM_OK)
        k++;
    return k - 1;
}

// The power fails in write or erase number n from now, after a number of bytes, and once more after the restart.
static void check_cut(const char *name, uint32_t after, uint32_t bytes, uint32_t again, uint32_t bytes_again)
{
    uint32_t last;

    sim_reset();
    CHECK(start_program(name, &wide_vector) == SM_OK);
    CHECK(store_vector(1) == SM_OK);
    sim_cut_power(after, bytes);
    last = store_until_cut(2);
    CHECK(restart_program(name, &wide_vector) == SM_OK);
    CHECK(keep.restored && (number_of_vector() == last || number_of_vector() == last + 1));
    sim_cut_power(again, bytes_again);
    last = (uint32_t)number_of_vector();
    last = store_until_cut(last + 1);
    CHECK(restart_program(name, &wide_vector) == SM_OK);
    CHECK(keep.restored && (number_of_vector() == last || number_of_vector() == last + 1));
    CHECK(store_vector(50) == SM_OK && restart_program(name, &wide_vector) == SM_OK && number_of_vector() == 50);
}

static void test_cuts(const char *name)
{
    const uint32_t size = SM_KEEP_SIZE(wide_layout.whole.packed);

    for (uint32_t after = 0; after < 5; after++)
        for (uint32_t bytes = 0; bytes <= size; bytes++)
            for (uint32_t again = 0; again < 3; again++)
                check_cut(name, after, bytes, again, (bytes * 7 + again) % (size + 1));
}

// Before the first snapshot is stored: it is complete or absent.
static void test_first_cut(const char *name)
{
    for (uint32_t bytes = 0; bytes <= SM_KEEP_SIZE(wide_layout.whole.packed); bytes++) {
        sim_reset();
        CHECK(start_program(name, &wide_vector) == SM_OK);
        sim_cut_power(0, bytes);
        (void)store_vector(1);
        CHECK(restart_program(name, &wide_vector) == SM_OK && number_of_vector() == (keep.restored ? 1 : 0));
    }
}

// ---- bits flip ----

static void test_flips(const char *name)
{
    const uint32_t size = SM_KEEP_HEAD + wide_layout.whole.packed;
    uint8_t *bytes;

    sim_reset();
    CHECK(start_program(name, &wide_vector) == SM_OK && store_vector(1) == SM_OK && store_vector(2) == SM_OK && store_vector(3) == SM_OK);
    bytes = sim_nvm(name);
    for (uint32_t bit = 0; bit < 8 * size; bit++) {
        const uint32_t slot = keep.slot;                  // the third snapshot replaced the first, so its number is odd
        bytes[slot + bit / 8] ^= (uint8_t)(1 << bit % 8);
        CHECK(restart_program(name, &wide_vector) == SM_OK && keep.restored && number_of_vector() == 2);
        bytes[bit / 8] ^= 1;
        CHECK(restart_program(name, &wide_vector) == SM_OK && !keep.restored && number_of_vector() == 0);
        bytes[bit / 8] ^= 1;
        bytes[slot + bit / 8] ^= (uint8_t)(1 << bit % 8);
        CHECK(restart_program(name, &wide_vector) == SM_OK && keep.restored && number_of_vector() == 3);
    }
}

// The numbers of the slots continue after 2^32.
static void test_wrap(const char *name)
{
    sim_reset();
    CHECK(start_program(name, &wide_vector) == SM_OK);
    keep.number = UINT32_MAX - 3;
    for (uint32_t k = 1; k < 8; k++) {
        CHECK(store_vector(k) == SM_OK);
        CHECK(restart_program(name, &wide_vector) == SM_OK && number_of_vector() == k);
    }
}

// ---- another layout ----

static void test_layouts(void)
{
    SmLayout other = wide_layout;
    SmStateVec as_other = wide_vector;

    sim_reset();
    CHECK(start_program("eeprom", &many_vector) == SM_OK && sm_keep_step(&keep, &tick) == SM_OK && sm_keep_write(&keep) == SM_OK);
    CHECK(restart_program("eeprom", &wide_vector) == SM_OK && !keep.restored && number_of_vector() == 0);
    CHECK(store_vector(1) == SM_OK && restart_program("eeprom", &wide_vector) == SM_OK && number_of_vector() == 1);
    other.hash ^= 1;                                      // another layout of the same size
    as_other.layout = &other;
    CHECK(restart_program("eeprom", &as_other) == SM_OK && !keep.restored && number_of_vector() == 0);
    CHECK(restart_program("eeprom", &wide_vector) == SM_OK && keep.restored && number_of_vector() == 1);
}

// ---- foreign content ----

// Whether a memory that begins with these bytes and has the same content everywhere is refused and not changed.
static void is_memory_refused(const char *name, const char *begins)
{
    uint8_t before[1024];
    uint8_t *bytes = sim_nvm(name);

    sim_reset();
    memset(bytes, 'x', sizeof before);
    memcpy(bytes, begins, strlen(begins));
    memcpy(before, bytes, sizeof before);
    CHECK(start_program(name, &wide_vector) == SM_E_FOREIGN && !keep.restored && keep.nvm.id == 0);
    CHECK(memcmp(before, bytes, sizeof before) == 0 && sim_count(SIM_nvm_write) == 0 && sim_count(SIM_nvm_erase) == 0);
    sim_reset();
    CHECK(start_program(name, &wide_vector) == SM_OK && !keep.unusable);
}

// An interrupted erase leaves undefined bytes in the first slot.  The other slot was erased before, and is blank.
static void test_torn_erase(void)
{
    sim_reset();
    memset(sim_nvm("flash"), 'x', 32);
    CHECK(start_program("flash", &wide_vector) == SM_OK && !keep.restored && keep.unusable);
    CHECK(store_vector(1) == SM_OK && restart_program("flash", &wide_vector) == SM_OK && number_of_vector() == 1);
}

// A saved vector that cannot be used: no error, but an event.
static void test_unusable(const char *name)
{
    sim_reset();
    CHECK(start_program(name, &wide_vector) == SM_OK && !keep.unusable && store_vector(1) == SM_OK && store_vector(2) == SM_OK);
    CHECK(restart_program(name, &wide_vector) == SM_OK && keep.restored && !keep.unusable);
    sim_nvm(name)[SM_KEEP_HEAD] ^= 1;
    sim_nvm(name)[keep.slot + SM_KEEP_HEAD] ^= 1;
    CHECK(restart_program(name, &wide_vector) == SM_OK && !keep.restored && keep.unusable);
    sim_reset();
    CHECK(start_program(name, &many_vector) == SM_OK && sm_keep_step(&keep, &tick) == SM_OK && sm_keep_write(&keep) == SM_OK);
    CHECK(sm_keep_step(&keep, &tick) == SM_OK && sm_keep_write(&keep) == SM_OK);
    CHECK(restart_program(name, &wide_vector) == SM_OK && !keep.restored && keep.unusable);
}

// ---- memories that refuse ----

static void test_refused(void)
{
    SmLayout large = wide_layout;
    SmStateVec as_large = wide_vector;

    sim_reset();
    large.whole.packed = SIM_NVM_SIZE / 2 - SM_KEEP_HEAD;
    as_large.layout = &large;
    keep.memory = "eeprom";
    keep.sv = &as_large;
    keep.buffer = buffer;
    CHECK(sm_keep_restore(&keep) == SM_OK);               // a slot that ends with the last byte of the memory
    CHECK(pal_nvm_close(keep.nvm) == SM_OK);
    large.whole.packed++;
    CHECK(sm_keep_restore(&keep) == SM_E_SPACE);
    CHECK(start_program("tape", &wide_vector) == SM_E_MISSING);
    sim_break(SIM_nvm_read, 0, SM_E_DEVICE);
    CHECK(start_program("eeprom", &wide_vector) == SM_OK && !keep.restored);
    CHECK(sm_keep_restore(NULL) == SM_E_ARGUMENT);
    keep.buffer = NULL;
    CHECK(sm_keep_restore(&keep) == SM_E_ARGUMENT);
}

// A snapshot whose write failed waits until there is a newer one.
static void test_failed_write(const char *name)
{
    sim_reset();
    CHECK(start_program(name, &wide_vector) == SM_OK && store_vector(1) == SM_OK);
    sim_fail(SIM_nvm_write, 0, SM_E_DEVICE);
    CHECK(store_vector(2) == SM_E_DEVICE && keep.written == 1 && keep.replaced == 0);
    CHECK(sm_keep_write(&keep) == SM_OK && keep.written == 2);
    CHECK(restart_program(name, &wide_vector) == SM_OK && number_of_vector() == 2);
    sim_fail(SIM_nvm_write, 0, SM_E_DEVICE);
    CHECK(store_vector(3) == SM_E_DEVICE);
    fill_vector(4);
    CHECK(sm_keep_step(&keep, &tick) == SM_E_DEVICE && keep.replaced == 1);
    fill_vector(5);
    CHECK(sm_keep_step(&keep, &tick) == SM_E_DEVICE && keep.replaced == 2);
    CHECK(sm_keep_write(&keep) == SM_OK && keep.taken == 3 && keep.written == 1);
    CHECK(restart_program(name, &wide_vector) == SM_OK && number_of_vector() == 5);
}

// The write after a failed write uses the same slot.  If it is interrupted, the other slot is still valid.
static void test_cut_after_failure(const char *name)
{
    sim_reset();
    CHECK(start_program(name, &wide_vector) == SM_OK && store_vector(1) == SM_OK);
    sim_fail(SIM_nvm_write, 0, SM_E_DEVICE);
    CHECK(store_vector(2) == SM_E_DEVICE);
    sim_cut_power(0, 20);
    CHECK(sm_keep_write(&keep) == SM_E_DEVICE);
    CHECK(restart_program(name, &wide_vector) == SM_OK && keep.restored && number_of_vector() == 1);
}

// A failed write to the medium is reported by the following steps, until a write succeeds.
static void test_failures_are_reported(const char *name)
{
    sim_reset();
    CHECK(start_program(name, &wide_vector) == SM_OK && store_vector(1) == SM_OK);
    fill_vector(2);
    sim_fail(SIM_nvm_write, 0, SM_E_SPACE);
    CHECK(sm_keep_step(&keep, &tick) == SM_OK && sm_keep_write(&keep) == SM_E_SPACE);
    CHECK(sm_keep_step(&keep, &tick) == SM_E_SPACE && sm_keep_step(&keep, &tick) == SM_E_SPACE && keep.taken == 4);
    CHECK(sm_keep_write(&keep) == SM_OK && sm_keep_step(&keep, &tick) == SM_OK);
}

// Two steps while the medium is slow: the first snapshot waits, the second replaces it, and the one that is being written is not
// touched.
static uint32_t next_number;

static void step_during_write(void)
{
    if (next_number > 3)
        return;
    fill_vector(next_number++);
    CHECK(sm_keep_step(&keep, &tick) == SM_OK);
}

static void test_steps_meanwhile(const char *name)
{
    sim_reset();
    CHECK(start_program(name, &wide_vector) == SM_OK);
    fill_vector(1);
    CHECK(sm_keep_step(&keep, &tick) == SM_OK);
    next_number = 2;
    sim_delay(SIM_nvm_write, 10 * PAL_MILLISECOND);
    sim_every(3 * PAL_MILLISECOND, step_during_write);
    CHECK(sm_keep_write(&keep) == SM_OK && next_number == 4 && keep.written == 1 && keep.replaced == 1 && keep.taken == 3);
    sim_every(0, NULL);
    CHECK(restart_program(name, &wide_vector) == SM_OK && number_of_vector() == 1);
    sim_reset();
    CHECK(start_program(name, &wide_vector) == SM_OK);
    fill_vector(1);
    CHECK(sm_keep_step(&keep, &tick) == SM_OK);
    next_number = 2;
    sim_delay(SIM_nvm_write, 10 * PAL_MILLISECOND);
    sim_every(3 * PAL_MILLISECOND, step_during_write);
    CHECK(sm_keep_write(&keep) == SM_OK && sm_keep_write(&keep) == SM_OK && keep.written == 2 && keep.replaced == 1 && sm_keep_write(&keep) == SM_OK);
    CHECK(keep.written + keep.replaced == keep.taken && restart_program(name, &wide_vector) == SM_OK && number_of_vector() == 3);
}

static void test_forget(const char *name)
{
    for (uint32_t after = 0; after < 3; after++)
        for (uint32_t bytes = 0; bytes < 130; bytes += 13) {
            SmResult r;
            sim_reset();
            CHECK(start_program(name, &wide_vector) == SM_OK && store_vector(1) == SM_OK && store_vector(2) == SM_OK);
            fill_vector(3);
            CHECK(sm_keep_step(&keep, &tick) == SM_OK);
            sim_cut_power(after, bytes);
            r = sm_keep_forget(&keep);
            CHECK(r != SM_OK || (sm_keep_write(&keep) == SM_OK && keep.written == 2));
            CHECK(restart_program(name, &wide_vector) == SM_OK && (keep.restored ? r != SM_OK && number_of_vector() == 2 : number_of_vector() == 0));
            CHECK(store_vector(7) == SM_OK && restart_program(name, &wide_vector) == SM_OK && number_of_vector() == 7);
        }
}

int main(void)
{
    for (size_t i = 0; i < sizeof memories / sizeof *memories; i++) {
        test_plain(memories[i]);
        test_cuts(memories[i]);
        test_first_cut(memories[i]);
        test_flips(memories[i]);
        test_wrap(memories[i]);
        test_failed_write(memories[i]);
        test_cut_after_failure(memories[i]);
        test_failures_are_reported(memories[i]);
        test_steps_meanwhile(memories[i]);
        test_forget(memories[i]);
        test_unusable(memories[i]);
        is_memory_refused(memories[i], "[regions]\nSensors\n");
        is_memory_refused(memories[i], "");
    }
    test_layouts();
    test_torn_erase();
    test_refused();
    return test_end("keep");
}
