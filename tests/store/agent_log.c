// SPDX-License-Identifier: Apache-2.0
// The log of transitions in the slot of the image that runs: it survives restarts and torn records, is written seldom, yields to an image
// that needs its room, and any bytes in its place are read without harm.
//   agent_log OLD.smb NEW.smb
#include <stdlib.h>

#include "bytecode-vm/target/state_log.h"
#include "stdlib/crc32.h"
#include "tests/store/pair.h"

typedef struct Logged { Pair p; StateLog log; LinkTransition read[LINK_TRANSITIONS]; size_t n; uint32_t g; } Logged;

static uint8_t *logged_image(const Logged *l) { return (uint8_t *)(uintptr_t)l->p.board.store.plan.image[l->p.board.slot]; }

static void reopen_log(Logged *l) { smvm_state_log_open(&l->log, logged_image(l), l->p.board.store.slot_size); }

// The memory accepts `most` of the next bytes.
static unsigned write_log(Logged *l, unsigned most)
{
    unsigned n = 0;
    uint8_t byte;
    SmvmAt at;

    for (; n < most && smvm_state_log_next(&l->log, &at, &byte); n++) {
        CHECK(at >= smvm_u24(logged_image(l), SMVM_LENGTH_AT) && at < l->p.board.store.slot_size);
        logged_image(l)[at] = byte;
        smvm_state_log_advance(&l->log);
    }
    return n;
}

// Logs a transition from state `g` to the next, at second `g`.  Writes all bytes of its record, or only `bytes`.
static unsigned log_transition(Logged *l, unsigned bytes, uint32_t lost)
{
    SmEvent e;

    memset(&e, 0, sizeof e);
    e.kind = SM_EVENT_STATE;
    e.time = ++l->g * UINT64_C(1000000000);
    e.source = 2;
    e.a = l->g;
    e.b = l->g + 1;
    CHECK(smvm_state_log_is_idle(&l->log));
    smvm_state_log_add(&l->log, &e, lost);
    return write_log(l, bytes);
}

static void log_many(Logged *l, unsigned n)
{
    while (n-- > 0) {
        smvm_state_log_add_credit(&l->log);
        CHECK(log_transition(l, LINK_TRANSITION, 0) == LINK_TRANSITION);
    }
}

static bool read_log(Logged *l, uint8_t slot)
{
    DeviceInfo info;
    DeviceImage image;

    return device_query_info(&l->p.host, &info) && device_read_image_info(&l->p.host, slot, &image) && device_read_transitions(&l->p.host, &info, &image, l->read, &l->n);
}

// Whether the log has n transitions, of which the last one is at second `last`.
static bool log_ends_at(Logged *l, size_t n, uint32_t last)
{
    bool same = read_log(l, l->p.board.slot) && l->n == n;

    for (size_t i = 0; i < n && same; i++) {
        const uint32_t g = last - (uint32_t)(n - 1 - i);
        same = l->read[i].from == g && l->read[i].to == g + 1 && l->read[i].machine == 2 && l->read[i].time == (uint32_t)(g * UINT64_C(1000000000) >> 20);
    }
    return same;
}

static void prepare_log(Logged *l, const char *memory, uint8_t slots)
{
    uint32_t room;

    memset(l, 0, sizeof *l);
    prepare_pair(&l->p, memory, slots);
    reopen_log(l);
    room = (l->p.board.store.slot_size - old_image.length) / LINK_TRANSITION;
    CHECK(l->log.records == (room < LINK_TRANSITIONS ? room : LINK_TRANSITIONS) && l->log.records >= STATE_LOG_LEAST);
    CHECK(read_log(l, l->p.board.slot) && l->n == 0);
}

static void test_log_survives_restarts(void)
{
    Logged l;

    for (uint8_t slots = 1; slots <= 2; slots++) {
        prepare_log(&l, "eeprom", slots);
        log_many(&l, 3);
        CHECK(log_ends_at(&l, 3, 3) && board_start(&l.p.board) && is_running(&l.p.board, &old_image) && log_ends_at(&l, 3, 3));
        reopen_log(&l);
        log_many(&l, 2);
        CHECK(log_ends_at(&l, 5, 5));
        for (int i = 0; i < 10; i++) {                 // once around the ring, and numbers beyond 255
            log_many(&l, l.log.records - 1u);
            CHECK(log_ends_at(&l, l.log.records, l.g));
            reopen_log(&l);
        }
        CHECK(l.g > 256);
    }
}

// The power fails after each byte of a record: only the record that it would replace is lost.
static void test_torn_record_is_skipped(void)
{
    Logged l;

    for (unsigned bytes = 0; bytes < LINK_TRANSITION; bytes++) {
        prepare_log(&l, "eeprom", 2);
        log_many(&l, 2u * l.log.records);
        smvm_state_log_add_credit(&l.log);
        CHECK(log_transition(&l, bytes, 0) == bytes);
        l.g--;
        CHECK(log_ends_at(&l, l.log.records - (bytes > 0 ? 1u : 0u), l.g));
        reopen_log(&l);
        log_many(&l, 1);
        CHECK(log_ends_at(&l, l.log.records, l.g));
    }
}

// A machine that changes its state in every step does not wear out the memory.
static void test_log_is_written_seldom(void)
{
    Logged l;

    prepare_log(&l, "eeprom", 2);
    for (int i = 0; i < STATE_LOG_CREDIT + 9; i++)
        CHECK(log_transition(&l, LINK_TRANSITION, 0) == (i < STATE_LOG_CREDIT ? LINK_TRANSITION : 0u));
    smvm_state_log_add_credit(&l.log);
    CHECK(log_transition(&l, LINK_TRANSITION, 2) == LINK_TRANSITION && read_log(&l, l.p.board.slot));
    CHECK(l.n > 1 && l.read[l.n - 1].lost == 11 && l.read[l.n - 2].lost == 0);
    CHECK(log_transition(&l, LINK_TRANSITION, 400) == 0);
    smvm_state_log_add_credit(&l.log);
    CHECK(log_transition(&l, LINK_TRANSITION, 0) == LINK_TRANSITION && read_log(&l, l.p.board.slot) && l.read[l.n - 1].lost == LINK_LOST_MAX);
}

// The log reserves no room in a slot: an update can use the whole slot, and the log of an earlier image is not read as that of the new one.
static void test_log_yields_to_images(void)
{
    Image full = new_image;
    Update u;
    Logged l;

    prepare_log(&l, "eeprom", 1);
    log_many(&l, 2u * l.log.records);
    CHECK(update_image(&l.p, &new_image, &u) == DEVICE_DONE && is_running(&l.p.board, &new_image) && read_log(&l, 0) && l.n == 0);
    reopen_log(&l);
    log_many(&l, 1);
    CHECK(log_ends_at(&l, 1, l.g));
    prepare_log(&l, "eeprom", 2);
    log_many(&l, 5);
    CHECK(update_image(&l.p, &new_image, &u) == DEVICE_DONE && read_log(&l, 0) && l.n == 5 && read_log(&l, 1) && l.n == 0);
    full.length = l.p.board.store.slot_size - STATE_LOG_LEAST * LINK_TRANSITION + 1;
    sm_link_store(full.bytes + SMVM_LENGTH_AT, full.length, 3);
    smvm_state_log_open(&l.log, full.bytes, l.p.board.store.slot_size);
    CHECK(l.log.records == 0 && log_transition(&l, LINK_TRANSITION, 0) == 0);
}

// Whatever bytes the slot contains, reading and writing the log terminates and accesses no byte outside the slot.
static void test_any_bytes_are_a_log(void)
{
    DeviceImage image = {0};
    DeviceInfo info;
    Logged l;

    prepare_log(&l, "eeprom", 2);
    for (int round = 0; round < 300; round++) {
        uint8_t *const at = logged_image(&l) + old_image.length;
        for (uint32_t i = 0; i < l.p.board.store.slot_size - old_image.length; i++)
            at[i] = (uint8_t)random_below(256);
        for (uint32_t i = random_below(l.log.records + 1u); i > 0; i--) {         // records with any numbers
            const LinkTransition t = {(uint8_t)random_below(256), (uint8_t)random_below(16), (uint8_t)random_below(16), 1, 2, random_below(1u << 31)};
            sm_link_store_transition(at + random_below(l.log.records) * LINK_TRANSITION, &t, old_image.checksum);
        }
        reopen_log(&l);
        CHECK(l.log.next < l.log.records && read_log(&l, l.p.board.slot) && l.n <= l.log.records);
        CHECK(log_transition(&l, LINK_TRANSITION, 0) == LINK_TRANSITION);
    }
    image.state = DEVICE_WHOLE;                        // a board that reports an image longer than its slot
    CHECK(device_query_info(&l.p.host, &info));
    image.length = info.slot_size + 1;
    l.n = 1;
    CHECK(device_read_transitions(&l.p.host, &info, &image, l.read, &l.n) && l.n == 0);
    for (int round = 0; round < 100; round++) {        // a slot without an image
        uint8_t bytes[IMAGE_ROOM];
        for (size_t i = 0; i < sizeof bytes; i++)
            bytes[i] = (uint8_t)random_below(256);
        smvm_state_log_open(&l.log, bytes, round % 2 ? IMAGE_ROOM : 0);
        CHECK(smvm_u24(bytes, SMVM_LENGTH_AT) + l.log.records * LINK_TRANSITION <= IMAGE_ROOM || l.log.records == 0);
    }
}

int main(int argc, char **argv)
{
    if (argc != 3 || !image_load(argv[1], &old_image) || !image_load(argv[2], &new_image)) {
        fprintf(stderr, "agent_log OLD.smb NEW.smb\n");
        return 2;
    }
    random_state = UINT64_C(88172645463325252);
    test_log_survives_restarts();
    test_torn_record_is_skipped();
    test_log_is_written_seldom();
    test_log_yields_to_images();
    test_any_bytes_are_a_log();
    return test_end("agent-log");
}
