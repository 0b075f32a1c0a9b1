// SPDX-License-Identifier: Apache-2.0
// Tests the board's end of the link and the host's: updates, requests and events, over a good line and over one in trouble (pair.h).
// Whatever happens to the line and to the board's power, the old or the new image must run afterwards, and the next update over a good line
// must succeed.
//   agent OLD.smb NEW.smb PARAMETERS.smb [RUNS [SEED]]         PARAMETERS.smb: tests/device/limits.sm
#include <stdlib.h>

#include "stdlib/convert.h"
#include "stdlib/crc32.h"
#include "tests/store/pair.h"

static Image limits;

// ---- trouble ----

typedef struct Ends { unsigned succeeded, refused, silent; } Ends;

static void check_soundness(Pair *p, DeviceStep step)
{
    const bool is_old = is_running(&p->board, &old_image), is_new = is_running(&p->board, &new_image);

    CHECK(is_old || is_new || p->board.slots == 1);
    CHECK(step != DEVICE_DONE || is_new);
    CHECK(step >= DEVICE_ACTIVATE || step == DEVICE_DONE || step == DEVICE_FIND || !is_new);
}

static void check_recovery(Pair *p)
{
    Update u;

    CHECK(update_image(p, &new_image, &u) == DEVICE_DONE && is_running(&p->board, &new_image));
    CHECK(device_confirm_image(&p->host, new_image.checksum));
    for (int i = 0; i < STORE_TRIES * STORE_START + 1; i++)
        CHECK(board_start(&p->board) && is_running(&p->board, &new_image));
}

static void update_in_trouble(const char *memory, uint8_t slots, Ends *ends)
{
    DeviceStep step;
    Update u;
    Pair p;

    prepare_pair(&p, memory, slots);
    p.wire.trouble = random_below(4) ? 2 + random_below(12) : 0;
    p.wire.restart = random_below(3) ? 0 : p.wire.taken + 1 + random_below(1200);
    if (random_below(3) == 0) {
        const uint32_t after = random_below(24);
        sim_cut_power(after, random_below(40));
    }
    if (random_below(16) == 0)
        p.board.fits = SM_E_MEMORY;
    step = update_image(&p, &new_image, &u);
    ends->succeeded += step == DEVICE_DONE;
    ends->refused += step != DEVICE_DONE && p.host.answered;
    ends->silent += step != DEVICE_DONE && !p.host.answered;
    check_soundness(&p, step);
    repair_line(&p);
    CHECK(board_start(&p.board));
    check_soundness(&p, step == DEVICE_DONE ? DEVICE_FIND : step);
    check_recovery(&p);
}

// ---- a good line ----

static void test_armed_board_refuses_update(const char *memory, uint8_t slots)
{
    static uint8_t kept[SIM_NVM_SIZE];
    static const SmResult reasons[] = {SM_E_ARMED, SM_E_UNSAFE};
    DeviceInfo info;
    DeviceImage image;
    Update u;
    Pair p;

    for (size_t i = 0; i < 2; i++) {
        prepare_pair(&p, memory, slots);
        memcpy(kept, sim_nvm(memory), sizeof kept);
        p.board.may = reasons[i];
        CHECK(device_query_info(&p.host, &info) && info.may == reasons[i]);
        CHECK(update_image(&p, &new_image, &u) == DEVICE_BEGIN && p.host.answered && p.host.result == reasons[i]);
        CHECK(!device_erase_image(&p.host, old_image.checksum) && p.host.result == reasons[i]);
        CHECK(!device_confirm_image(&p.host, old_image.checksum) && p.host.result == reasons[i]);
        CHECK(!device_restart(&p.host, &info) && p.host.answered && p.host.result == reasons[i]);
        CHECK(device_find_running_image(&p.host, &info, &image) && image.checksum == old_image.checksum);
        CHECK(memcmp(kept, sim_nvm(memory), sizeof kept) == 0 && p.board.left == 0);
    }
}

// A board that is armed during an update refuses its requests.  After disarming, the update continues.
static void test_arming_pauses_an_update(void)
{
    uint8_t body[9], data[5 + 8];
    Pair p;

    prepare_pair(&p, "eeprom", 2);
    sm_link_store(body, 5, 2);
    sm_link_store(body + 2, new_image.length, 3);
    sm_link_store(body + 5, new_image.checksum, 4);
    CHECK(link_request(&p.host, LINK_BEGIN, body, 9) && p.host.result == SM_OK);
    sm_link_store(data, 5, 2);
    sm_link_store(data + 2, 0, 3);
    memcpy(data + 5, new_image.bytes, 8);
    p.board.may = SM_E_ARMED;
    CHECK(link_request(&p.host, LINK_DATA, data, sizeof data) && p.host.result == SM_E_ARMED);
    CHECK(link_request(&p.host, LINK_END, body, 2) && p.host.result == SM_E_ARMED);
    CHECK(link_request(&p.host, LINK_ACTIVATE, body, 2) && p.host.result == SM_E_ARMED);
    p.board.may = SM_OK;
    CHECK(link_request(&p.host, LINK_DATA, data, sizeof data) && p.host.result == SM_OK && sm_link_load(p.host.body, 3) == 8);
}

static void test_too_large_image_is_refused(void)
{
    Image damaged = new_image;
    uint8_t body[9] = {1};
    Update u;
    Pair p;

    prepare_pair(&p, "eeprom", 1);
    sm_link_store(body + 2, SIM_NVM_SIZE, 3);
    CHECK(link_request(&p.host, LINK_BEGIN, body, 9) && p.host.result == SM_E_SPACE && p.board.left == 0);
    damaged.bytes[damaged.length - 1] ^= 1;
    for (int i = 0; i < 2; i++)        // a second update with the same image is refused like the first
        CHECK(update_image(&p, &damaged, &u) == DEVICE_END && p.host.result == SM_E_IMAGE && u.rule != 0);
    prepare_pair(&p, "eeprom", 2);
    p.board.fits = SM_E_MEMORY;
    CHECK(update_image(&p, &new_image, &u) == DEVICE_END && p.host.result == SM_E_MEMORY && u.rule == 0);
    CHECK(link_request(&p.host, LINK_ACTIVATE, (const uint8_t[]){(uint8_t)u.session, (uint8_t)(u.session >> 8)}, 2) &&
          p.host.result == SM_E_HANDLE);
    p.board.fits = SM_OK;
    p.board.board.longest_step = 1;
    CHECK(update_image(&p, &new_image, &u) == DEVICE_END && p.host.result == SM_E_SIZE);
    CHECK(board_start(&p.board) && is_running(&p.board, &old_image));
}

// With one slot, a refused image has replaced the chosen one, but is not chosen itself.
static void test_refused_image_is_not_chosen(void)
{
    DeviceImage image;
    Update u;
    Pair p;

    prepare_pair(&p, "eeprom", 1);
    p.board.fits = SM_E_MEMORY;
    for (int i = 0; i < 2; i++) {
        CHECK(update_image(&p, &new_image, &u) == DEVICE_END && p.host.result == SM_E_MEMORY);
        CHECK(device_read_image_info(&p.host, 0, &image) && image.state == DEVICE_WHOLE && !image.chosen && !image.runs);
    }
    CHECK(board_start(&p.board) && p.board.slot == STORE_BUILT_IN);
}

// An image that was accepted but cannot run: if it is on trial, the trial ends; if it is confirmed, it stays chosen.
static void test_unusable_image_is_skipped(const char *memory)
{
    DeviceImage image;
    Update u;
    Pair p;

    prepare_pair(&p, memory, 2);
    CHECK(update_image(&p, &new_image, &u) == DEVICE_DONE && is_running(&p.board, &new_image));
    CHECK(device_read_image_info(&p.host, 0, &image) && image.before && !image.chosen);
    CHECK(smvm_store_skip_image(&p.board.store, &p.board.slot) == SM_OK && is_running(&p.board, &old_image));
    CHECK(device_read_image_info(&p.host, 1, &image) && image.end == DEVICE_NOT_RUNNABLE);
    CHECK(board_start(&p.board) && is_running(&p.board, &old_image));
    CHECK(smvm_store_skip_image(&p.board.store, &p.board.slot) == SM_OK && p.board.slot == STORE_BUILT_IN);
    CHECK(device_read_image_info(&p.host, 0, &image) && image.chosen && !image.runs);
    CHECK(board_start(&p.board) && is_running(&p.board, &old_image));
}

// An image that has been overwritten is not reported as the image that would run again.
static void test_previous_image_is_known_by_checksum(void)
{
    DeviceImage image;
    Update u;
    Pair p;

    prepare_pair(&p, "eeprom", 2);
    CHECK(update_image(&p, &new_image, &u) == DEVICE_DONE && device_confirm_image(&p.host, new_image.checksum));
    CHECK(device_read_image_info(&p.host, 0, &image) && image.checksum == old_image.checksum && image.before);
    CHECK(image_send(&p.board.store, &new_image) == SM_OK);
    CHECK(device_read_image_info(&p.host, 0, &image) && image.checksum == new_image.checksum && !image.before && !image.chosen);
    CHECK(device_read_image_info(&p.host, DEVICE_BUILT_IN, &image) && !image.before);
}

static void test_pins_are_found(void)
{
    uint8_t place;
    Pair p;

    prepare_pair(&p, "eeprom", 2);
    CHECK(device_find_chip_pin(&p.host, 2, 3, &place) && place == 3);
    CHECK(device_find_chip_pin(&p.host, 2, 4, &place) && place == SMVM_NO_PIN);
    CHECK(device_find_chip_pin(&p.host, 1, 3, &place) && place == SMVM_NO_PIN);
    CHECK(device_find_chip_pin(&p.host, 2, 0x103, &place) && place == SMVM_NO_PIN);
    p.board.board.physical_pin = NULL;
    CHECK(!device_find_chip_pin(&p.host, 2, 3, &place) && p.host.result == SM_E_UNSUPPORTED);
}

// With one slot, an image on trial continues to run after a refused BEGIN.
static void test_refused_update_does_not_stop_a_trial(void)
{
    Update u;
    Pair p;

    prepare_pair(&p, "eeprom", 1);
    CHECK(update_image(&p, &new_image, &u) == DEVICE_DONE && p.board.left == 1);
    CHECK(update_image(&p, &old_image, &u) == DEVICE_BEGIN && p.host.result == SM_E_BUSY);
    CHECK(p.board.left == 1 && is_running(&p.board, &new_image));
    CHECK(device_confirm_image(&p.host, new_image.checksum));
}

static void test_images_are_listed_and_erased(void)
{
    DeviceInfo info;
    DeviceImage image;
    Update u;
    Pair p;

    prepare_pair(&p, "flash", 2);
    CHECK(update_image(&p, &new_image, &u) == DEVICE_DONE && !u.was_running);
    CHECK(device_query_info(&p.host, &info) && info.protocol == LINK_PROTOCOL && info.slots == 2);
    CHECK(info.ram == 1000 && info.block % 8 == 0);
    CHECK(info.functions == 0x70001 && !info.requires_signature);
    CHECK(info.reports_limits && info.windows && info.parameters && info.machines == 3 && info.ram_digital == 10 && info.ram_analog == 26 && info.period == 300 && info.cycles == 14400);
    CHECK(device_read_image_info(&p.host, 0, &image) && image.state == DEVICE_WHOLE && image.checksum == old_image.checksum && !image.runs);
    CHECK(device_read_image_info(&p.host, 1, &image) && image.state == DEVICE_TRIAL && image.runs && image.chosen);
    CHECK(image.starts == STORE_TRIES - 1);
    CHECK(device_read_image_info(&p.host, DEVICE_BUILT_IN, &image) && image.state == DEVICE_EMPTY && !image.runs);
    CHECK(!device_read_image_info(&p.host, 2, &image) && p.host.result == SM_E_MISSING);
    CHECK(update_image(&p, &new_image, &u) == DEVICE_DONE && u.was_running);
    CHECK(!device_confirm_image(&p.host, old_image.checksum) && p.host.result == SM_E_ARGUMENT);
    CHECK(!device_erase_image(&p.host, 1) && p.host.result == SM_E_MISSING);
    CHECK(device_erase_image(&p.host, new_image.checksum) && device_restart(&p.host, &info));
    CHECK(is_running(&p.board, &old_image) && device_find_running_image(&p.host, &info, &image) && image.checksum == old_image.checksum);
    CHECK(device_erase_image(&p.host, old_image.checksum) && device_restart(&p.host, &info));
    CHECK(device_find_running_image(&p.host, &info, &image) && image.slot == DEVICE_BUILT_IN);
}

// ---- parameters ----

// Writes the bits of a value that no host has judged, and the correct checksum.
static Image forge_value(uint32_t number, uint64_t bits)
{
    Image image = limits;
    SmvmMachine m;
    SmvmReader r;
    SmvmParameterEntry e = {.bytes = 0};
    uint32_t crc = SM_CRC32_START;

    CHECK(smvm_machine(image.bytes, 0, &m));
    r = smvm_parameters(&m);
    for (uint32_t i = 0; i <= number; i++)
        CHECK(smvm_read_parameter(&r, &e));
    for (unsigned i = 0; i < e.bytes; i++)
        image.bytes[smvm_parameter_number(&e, SMVM_PARAMETER_VALUE) + i] = (uint8_t)(bits >> 8 * i);
    for (uint32_t i = 0; i < image.length; i++)
        crc = i >= SMVM_CRC_AT && i < SMVM_CRC_AT + 4 ? crc : sm_crc32_byte(crc, image.bytes[i]);
    image.checksum = sm_crc32_end(crc);
    sm_link_store(image.bytes + SMVM_CRC_AT, image.checksum, 4);
    return image;
}

// A board refuses a value out of range that a host sends nevertheless, and a damaged image with parameters.  limits.sm: parameter 0 is an F64 from 700
// to 800, parameter 1 a U8 from 1 to 9.
static void test_values_are_verified(const char *memory, uint8_t slots)
{
    static const struct { uint32_t parameter; double x; uint64_t bits; } out[] = {
        {0, 800.5, 0}, {0, -775, 0}, {0, 0, UINT64_C(0x7ff8000000000000)}, {0, 0, UINT64_C(0x7ff0000000000000)}, {0, 0, UINT64_C(0xfff8000000000001)}, {1, 0, 0}, {1, 0, 10}};
    const Image good[] = {forge_value(0, sm_bits(sm_from_i32(800))), forge_value(1, 9)};
    Image image;
    Update u;
    Pair p;

    for (size_t i = 0; i < sizeof out / sizeof *out; i++) {
        prepare_pair(&p, memory, slots);
        image = forge_value(out[i].parameter, out[i].x != 0 ? sm_bits(out[i].x) : out[i].bits);
        CHECK(update_image(&p, &image, &u) == DEVICE_END && p.host.answered && p.host.result == SM_E_IMAGE && u.rule == SMVM_R_VALUE);
        CHECK(board_start(&p.board) && (slots == 1 ? p.board.slot == STORE_BUILT_IN : is_running(&p.board, &old_image)));
    }
    for (uint32_t bit = 0; bit < 8 * limits.length; bit += 5) {
        prepare_pair(&p, memory, slots);
        image = limits;
        image.bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
        image.checksum = smvm_uint(image.bytes, SMVM_CRC_AT, 4);
        CHECK(update_image(&p, &image, &u) == DEVICE_END && p.host.answered && p.host.result != SM_OK);
        CHECK(board_start(&p.board) && (slots == 1 ? p.board.slot == STORE_BUILT_IN : is_running(&p.board, &old_image)));
    }
    for (size_t i = 0; i < 2; i++) {
        prepare_pair(&p, memory, slots);
        CHECK(update_image(&p, &limits, &u) == DEVICE_DONE && device_confirm_image(&p.host, limits.checksum));
        CHECK(update_image(&p, &good[i], &u) == DEVICE_DONE && is_running(&p.board, &good[i]));
    }
}

static void test_invalid_request_is_rejected(void)
{
    static const uint8_t far[5] = {0, 0xff, 0xff, 0xff, 10};
    uint8_t body[5] = {0, 0, 0, 0, BOARD_BODY};
    Pair p;

    prepare_pair(&p, "eeprom", 2);
    CHECK(link_request(&p.host, (LinkMessage)0x7e, NULL, 0) && p.host.result == SM_E_UNSUPPORTED);
    CHECK(link_request(&p.host, LINK_BEGIN, body, 3) && p.host.result == SM_E_ARGUMENT);
    CHECK(link_request(&p.host, LINK_READ, body, 5) && p.host.result == SM_E_ARGUMENT);
    CHECK(link_request(&p.host, LINK_READ, far, 5) && p.host.result == SM_E_ARGUMENT);
    for (unsigned slot = 2; slot < STORE_BUILT_IN; slot++) {                                    // there are two slots, and the built-in image
        const uint8_t of[5] = {(uint8_t)slot, 0, 0, 0, 1};
        CHECK(link_request(&p.host, LINK_READ, of, 5) && p.host.result == SM_E_MISSING);
        CHECK(link_request(&p.host, LINK_IMAGE, of, 1) && p.host.result == SM_E_MISSING);
    }
    for (uint32_t before = 0; before < 3; before++)                                             // up to the slot's end, but not beyond
        for (uint8_t n = 0; n < 5; n++) {
            uint8_t end[5] = {0, 0, 0, 0, n};
            sm_link_store(end + 1, p.board.store.slot_size - before, 3);
            CHECK(link_request(&p.host, LINK_READ, end, 5) && p.host.result == (n <= before ? SM_OK : SM_E_ARGUMENT) && p.host.n == (n <= before ? n : 0));
        }
    p.host.tries = 2;
    CHECK(!link_request(&p.host, LINK_READ, new_image.bytes, BOARD_BODY + 1) && !p.host.gone);   // longer than the timeout
    CHECK(!link_request(&p.host, (LinkMessage)0x81, NULL, 0));                                  // the number of an answer is not a request
}

// The first zero after noise ends the noise, not the request that follows.
static void test_noise_before_a_request_is_skipped(void)
{
    static const uint8_t rubbish[] = {40, 1, 2, 3};
    DeviceInfo info;
    Pair p;

    prepare_pair(&p, "eeprom", 2);
    p.host.tries = 1;
    put(&p.wire.to_board, rubbish, sizeof rubbish);
    CHECK(device_query_info(&p.host, &info));
}

// A board that restarts during an update has lost the session, and the host begins again.
static void test_update_restarts_after_a_reset(void)
{
    Update u;
    Pair p;

    prepare_pair(&p, "flash", 2);
    for (uint32_t at = 50; at < 800; at += 50) {
        Image *image = is_running(&p.board, &old_image) ? &new_image : &old_image;
        p.wire.taken = 0;
        p.wire.restart = at;
        CHECK(update_image(&p, image, &u) == DEVICE_DONE && is_running(&p.board, image));
        CHECK(device_confirm_image(&p.host, image->checksum));
    }
}

// ---- events ----

static uint32_t read_all_events(Pair *p, uint32_t *cursor, uint32_t *next)
{
    uint8_t body[4];
    uint32_t events;

    sm_link_store(body, *cursor, 4);
    if (!link_request(&p->host, LINK_EVENTS, body, 4) || p->host.result != SM_OK)
        return 0;
    *cursor = sm_link_load(p->host.body, 4);
    *next += sm_link_load(p->host.body + 4, 4);
    events = (uint32_t)(p->host.n - 8) / 19;
    for (uint32_t i = 0; i < events; i++, ++*next)
        CHECK(sm_link_load(p->host.body + 8 + 19 * i + 11, 4) == *next);
    return events;
}

// Over any line, each event arrives once and in order, or is counted as lost.
static void test_events_come_once_and_in_order(void)
{
    uint32_t cursor = 0, next = 0, made = 0, came = 0;
    Pair p;

    prepare_pair(&p, "eeprom", 2);
    p.wire.trouble = 4;
    p.host.tries = 40;
    for (int round = 0; round < 200; round++) {
        for (uint32_t n = random_below(12); n > 0; n--) {
            SmEvent e = {0, 0, 0, 7, SM_EVENT_STATE};
            e.a = made++;
            sm_event(&p.board.events, &e);
        }
        came += read_all_events(&p, &cursor, &next);
    }
    while (read_all_events(&p, &cursor, &next) > 0)
        came++;
    CHECK(next == made && came > 100);
}

// Each stored byte is compared with the sent one before an image is chosen.  A memory can change after the verdict, and the checksum need not
// show it: the changed bits here are the polynomial's.
enum { SPOILED_BYTES = 5 };
static uint32_t spoiled;

static void spoil(uint8_t *at)
{
    static const uint8_t bits[SPOILED_BYTES] = {0x41, 0x06, 0x71, 0xdb, 0x01};

    for (size_t i = 0; i < sizeof bits; i++)
        at[i] ^= bits[i];
}

static SmResult damage_slot(void *context, SmvmBytes image)
{
    const Board *b = context;

    (void)image;
    spoil(sim_nvm(b->memory) + (b->store.plan.image[b->store.target] - sim_nvm(b->memory)) + spoiled);
    return SM_OK;
}

// Returns the first offset from `at` on where the verifier accepts the damaged image, so that only the comparison can notice the damage; 0: none.
static uint32_t find_hidden_damage(uint32_t at)
{
    for (; at + SPOILED_BYTES <= new_image.length; at++) {
        Image damaged = new_image;
        SmvmVerdict why;
        spoil(damaged.bytes + at);
        if (smvm_verify(damaged.bytes, damaged.length, &why) == 0)
            return at;
    }
    return 0;
}

static void test_sent_image_is_read_back(const char *memory, uint8_t slots)
{
    DeviceImage image;
    Update u;
    Pair p;

    CHECK(find_hidden_damage(SMVM_HEADER) > 0);
    for (spoiled = find_hidden_damage(SMVM_HEADER); spoiled > 0; spoiled = find_hidden_damage(spoiled + 32)) {
        prepare_pair(&p, memory, slots);
        p.board.board.fits = damage_slot;
        CHECK(update_image(&p, &new_image, &u) == DEVICE_READ && p.host.answered && p.host.result == SM_E_DEVICE);
        CHECK(!is_running(&p.board, &new_image));
        p.board.board.fits = board_fits;
        CHECK(device_read_image_info(&p.host, slots == 2 ? 1 : 0, &image) && !image.chosen && !image.runs);
        CHECK(board_start(&p.board) && (slots == 2 ? is_running(&p.board, &old_image) : p.board.slot == STORE_BUILT_IN));
    }
}

// The running slot was not sent in this update, even if it contains the same image.  Here an image runs, and is sent again with another period.
static void test_running_image_is_not_read_back(const char *memory)
{
    DeviceInfo info;
    Update u;
    Pair p;

    prepare_pair(&p, memory, 2);
    spoiled = SMVM_HEADER;
    p.board.board.fits = damage_slot;
    memset(&u, 0, sizeof u);
    u.bytes = old_image.bytes;
    u.length = old_image.length;
    u.checksum = old_image.checksum;
    u.session = 9;
    u.period = 7;
    CHECK(device_query_info(&p.host, &info) && device_update(&p.host, &info, &u) == DEVICE_READ && p.host.result == SM_E_DEVICE);
    p.board.board.fits = board_fits;
    u.session = 10;
    CHECK(device_update(&p.host, &info, &u) == DEVICE_DONE && !u.was_running && smvm_store_period(&p.board.store, p.board.slot) == 7);
    u.session = 11;                        // already stored: nothing is sent
    CHECK(device_update(&p.host, &info, &u) == DEVICE_DONE && u.was_running);
}

// A request that is too short for its message is refused, even if bytes of an earlier request in the buffer would complete it.
static void test_too_short_request_is_refused(void)
{
    static const struct { LinkMessage message; uint8_t least; } all[] = {
        {LINK_IMAGE, 1}, {LINK_PIN, 3}, {LINK_BEGIN, 9}, {LINK_DATA, 6}, {LINK_END, 2}, {LINK_ACTIVATE, 2}, {LINK_CONFIRM, 4}, {LINK_ERASE, 4},
        {LINK_READ, 5}, {LINK_EVENTS, 4},
    };
    const uint8_t body[9] = {1, 0, 16};                   // slot 1, pin 16, session 1 with 16 bytes, …
    Pair p;

    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        prepare_pair(&p, "eeprom", 2);
        for (uint8_t n = 0; n < all[i].least; n++) {
            (void)link_request(&p.host, LINK_PIN, body, 9);
            CHECK(link_request(&p.host, all[i].message, body, n) && p.host.result == SM_E_ARGUMENT && p.host.n == 0);
        }
        CHECK(link_request(&p.host, LINK_BEGIN, body, 9) && p.host.result == SM_OK);
    }
}

// An answer is never longer than the board's largest body, however many events wait.
static void test_events_fit_into_an_answer(void)
{
    uint8_t cursor[4] = {0};
    Pair p;

    connect_pair(&p, "eeprom", 2);
    for (uint32_t i = 0; i < 5; i++) {
        const SmEvent e = {i, i, 0, 7, SM_EVENT_STATE};
        sm_event(&p.board.events, &e);
    }
    for (uint32_t i = 0; i < 5; i++) {
        CHECK(link_request(&p.host, LINK_EVENTS, cursor, 4) && p.host.result == SM_OK && p.host.n == 8 + 19);    // two would need 47 bytes of 37
        memcpy(cursor, p.host.body, 4);
        CHECK(sm_link_load(cursor, 4) == i + 1 && sm_link_load(p.host.body + 8, 4) == i);
    }
    CHECK(link_request(&p.host, LINK_EVENTS, cursor, 4) && p.host.n == 8);
}

int main(int argc, char **argv)
{
    const unsigned long number = argc > 4 ? strtoul(argv[4], NULL, 10) : 400;
    static const char *const memories[] = {"eeprom", "flash"};
    Ends ends = {0, 0, 0};

    if (argc < 4 || !image_load(argv[1], &old_image) || !image_load(argv[2], &new_image) || !image_load(argv[3], &limits)) {
        fprintf(stderr, "agent OLD.smb NEW.smb PARAMETERS.smb [RUNS [SEED]]\n");
        return 2;
    }
    random_state = UINT64_C(88172645463325252) * (argc > 5 ? strtoul(argv[5], NULL, 10) : 1);
    for (unsigned i = 0; i < 4; i++)
        test_armed_board_refuses_update(memories[i % 2], (uint8_t)(1 + i / 2));
    for (unsigned i = 0; i < 4; i++)
        test_sent_image_is_read_back(memories[i % 2], (uint8_t)(1 + i / 2));
    test_running_image_is_not_read_back("eeprom");
    test_running_image_is_not_read_back("flash");
    test_arming_pauses_an_update();
    test_too_large_image_is_refused();
    test_refused_image_is_not_chosen();
    test_unusable_image_is_skipped("eeprom");
    test_unusable_image_is_skipped("flash");
    test_previous_image_is_known_by_checksum();
    test_pins_are_found();
    test_refused_update_does_not_stop_a_trial();
    test_images_are_listed_and_erased();
    for (unsigned i = 0; i < 4; i++)
        test_values_are_verified(memories[i % 2], (uint8_t)(1 + i / 2));
    test_invalid_request_is_rejected();
    test_noise_before_a_request_is_skipped();
    test_update_restarts_after_a_reset();
    test_events_come_once_and_in_order();
    test_events_fit_into_an_answer();
    test_too_short_request_is_refused();
    for (unsigned long i = 0; i < number; i++)
        update_in_trouble(memories[i % 2], (uint8_t)(1 + i / 2 % 2), &ends);
    printf("%lu updates: %u succeeded, %u refused, %u without an answer\n", number, ends.succeeded, ends.refused, ends.silent);
    CHECK(number < 100 || (ends.succeeded > number / 8 && ends.refused > 0 && ends.silent > 0));
    return test_end("agent");
}
