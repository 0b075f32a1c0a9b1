// SPDX-License-Identifier: Apache-2.0
// Tests the board's end of the link and the host's.  The line between them loses, repeats, delays, cuts and damages bytes, and the board
// restarts or loses its power at any byte.  Afterwards the old or the new image must run, and the next update over a good line must succeed.
//   agent OLD.smb NEW.smb PARAMETERS.smb [RUNS [SEED]]         PARAMETERS.smb: tests/device/limits.sm
#include <stdlib.h>

#include "bytecode-vm/target/state_log.h"
#include "compiler/device/device.h"
#include "stdlib/convert.h"
#include "stdlib/crc32.h"
#include "tests/store/board.h"
#include "tests/test.h"

enum { QUEUE = 4096 };

static Image old_image, new_image, limits;
static uint64_t random_state;

static uint32_t random_below(uint32_t n)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return n ? (uint32_t)(random_state >> 11) % n : 0;
}

// ---- the line ----

typedef struct Way { uint8_t byte[QUEUE]; uint32_t first, n; uint8_t late[LINK_ROOM(LINK_BODY_MAX) + 1]; size_t lates; } Way;

typedef struct Wire {
    Board *board;
    Way to_board, to_host;
    uint32_t now;             // milliseconds
    uint32_t trouble;         // one frame in this many is affected; 0: none
    uint32_t restart;         // the board restarts after this many received bytes; 0: never
    uint32_t taken;           // bytes that the board has received
} Wire;

static void put(Way *w, const uint8_t *bytes, size_t n)
{
    for (size_t i = 0; i < n && w->n < QUEUE; i++)
        w->byte[(w->first + w->n++) % QUEUE] = bytes[i];
}

static uint8_t take(Way *w)
{
    const uint8_t byte = w->byte[w->first];

    w->first = (w->first + 1) % QUEUE;
    w->n--;
    return byte;
}

static void send_noise(Way *w)
{
    for (uint32_t n = random_below(40); n > 0; n--) {
        const uint8_t byte = (uint8_t)random_below(256);
        put(w, &byte, 1);
    }
}

// Carries a frame over a line that can lose, damage or repeat it.
static void carry_frame(Way *w, const uint8_t *bytes, size_t n, uint32_t trouble)
{
    uint8_t copy[LINK_ROOM(LINK_BODY_MAX) + 1];

    memcpy(copy, bytes, n);
    switch (trouble && random_below(trouble) == 0 ? 1 + random_below(7) : 0) {
    case 1: break;                                             // lost
    case 2: put(w, copy, n); put(w, copy, n); break;           // twice
    case 3: put(w, copy, random_below((uint32_t)n)); break;           // its end is lost
    case 4: copy[random_below((uint32_t)n)] ^= (uint8_t)(1u << random_below(8)); put(w, copy, n); break;
    case 5: send_noise(w); put(w, copy, n); send_noise(w); break;
    case 6: memcpy(w->late, copy, n); w->lates = n; break;     // after the next one
    case 7: put(w, copy + 1 + random_below((uint32_t)n - 1), 1); put(w, copy, n); break;
    default:
        put(w, copy, n);
        if (w->lates && random_below(2)) {
            put(w, w->late, w->lates);
            w->lates = 0;
        }
    }
}

static void board_restarts(Wire *w)
{
    w->to_board.n = 0;
    CHECK(board_start(w->board));
}

// Lets the board process the bytes that have arrived.
static void run_board(Wire *w)
{
    while (w->to_board.n > 0) {
        const uint16_t n = board_takes(w->board, take(&w->to_board));
        if (n > 0)
            carry_frame(&w->to_host, w->board->frame, n, w->trouble);
        if (!w->board->up || ++w->taken == w->restart || w->board->agent.restart)
            board_restarts(w);
    }
}

static bool wire_send(void *context, const uint8_t *bytes, size_t n)
{
    Wire *w = context;

    carry_frame(&w->to_board, bytes, n, w->trouble);
    return true;
}

static int wire_receive(void *context, uint8_t *bytes, size_t room, uint32_t wait)
{
    Wire *w = context;
    size_t n = 0;

    run_board(w);
    while (n < room && w->to_host.n > 0)
        bytes[n++] = take(&w->to_host);
    w->now += n > 0 ? 0 : wait;
    return (int)n;
}

static uint32_t wire_now(void *context) { return ((const Wire *)context)->now; }

// ---- a board and a host ----

typedef struct Pair { Board board; Wire wire; SerialLine line; LinkHost host; } Pair;

static void connect_pair(Pair *p, const char *memory, uint8_t slots)
{
    memset(p, 0, sizeof *p);
    CHECK(board_new(&p->board, memory, slots));
    p->wire.board = &p->board;
    p->line.context = &p->wire;
    p->line.send = wire_send;
    p->line.receive = wire_receive;
    p->line.now = wire_now;
    link_host_init(&p->host, &p->line, 100, 8, (uint8_t)random_below(256));
}

static DeviceStep update_image(Pair *p, const Image *image, Update *u)
{
    DeviceInfo info;

    memset(u, 0, sizeof *u);
    u->bytes = image->bytes;
    u->length = image->length;
    u->checksum = image->checksum;
    u->session = (uint16_t)(1 + random_below(65535));
    return device_query_info(&p->host, &info) ? device_update(&p->host, &info, u) : DEVICE_FIND;
}

static bool is_running(const Board *b, const Image *image)
{
    return b->slot != STORE_BUILT_IN && memcmp(b->store.plan.image[b->slot], image->bytes, image->length) == 0;
}

// Prepares a pair whose old image is confirmed and runs.
static void prepare_pair(Pair *p, const char *memory, uint8_t slots)
{
    Update u;

    connect_pair(p, memory, slots);
    CHECK(update_image(p, &old_image, &u) == DEVICE_DONE && is_running(&p->board, &old_image));
    CHECK(device_confirm_image(&p->host, old_image.checksum));
}

// Makes the line error-free again.
static void repair_line(Pair *p)
{
    memset(&p->wire.to_board, 0, sizeof p->wire.to_board);
    memset(&p->wire.to_host, 0, sizeof p->wire.to_host);
    p->wire.trouble = p->wire.restart = 0;
    p->board.may = p->board.fits = SM_OK;
}

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
static uint32_t spoiled;

static SmResult damage_slot(void *context, SmvmBytes image)
{
    static const uint8_t bits[] = {0x41, 0x06, 0x71, 0xdb, 0x01};
    const Board *b = context;
    uint8_t *at = sim_nvm(b->memory) + (b->store.plan.image[b->store.target] - sim_nvm(b->memory)) + spoiled;

    (void)image;
    for (size_t i = 0; i < sizeof bits; i++)
        at[i] ^= bits[i];
    return SM_OK;
}

static void test_sent_image_is_read_back(const char *memory, uint8_t slots)
{
    DeviceImage image;
    Update u;
    Pair p;

    for (spoiled = SMVM_HEADER; spoiled + 5 <= new_image.length; spoiled += new_image.length - 5 - SMVM_HEADER) {
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

// ---- the log of transitions in the slot of the image that runs ----

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

// ---- boards of other firmware: a line that answers each request with the same bytes ----

typedef struct Canned {
    uint8_t body[LINK_BODY_MAX];
    size_t n;                 // the number of bytes in the answer, after its result
    uint8_t answer[LINK_ROOM(LINK_BODY_MAX)];
    size_t length, given;
    LinkReceiver in;
    uint8_t arrived[LINK_ROOM(LINK_BODY_MAX)];
    uint32_t now;
} Canned;

static bool canned_send(void *context, const uint8_t *bytes, size_t n)
{
    Canned *c = context;

    for (size_t i = 0; i < n; i++)
        if (sm_link_receive(&c->in, bytes[i])) {
            c->answer[1] = c->in.buffer[0];
            c->answer[2] = (uint8_t)(c->in.buffer[1] | LINK_ANSWER);
            c->answer[3] = SM_OK;
            memcpy(c->answer + 4, c->body, c->n);
            c->length = sm_link_encode(c->answer, (uint16_t)(LINK_HEAD + 1 + c->n));
            c->given = 0;
        }
    return true;
}

static int canned_receive(void *context, uint8_t *bytes, size_t room, uint32_t wait)
{
    Canned *c = context;
    size_t n = 0;

    while (n < room && c->given < c->length)
        bytes[n++] = c->answer[c->given++];
    c->now += n > 0 ? 0 : wait;
    return (int)n;
}

static uint32_t canned_now(void *context) { return ((const Canned *)context)->now; }

// HELLO now has more fields (link.def: "from the signatures on it may be cut").  Fields that a board omits are empty, even if an earlier, longer
// answer is still in the buffer.
static void test_older_boards_report_less(void)
{
    static const uint8_t all[35] = {1, 200, 128, 2, 0, 4, 0, 0, 2, 0, 9, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0xc3, 10, 26, 20, 0, 0x40, 0x1f, 4, 3, 2, 1, 7, 0, 3, 0};
    static const uint8_t none[31] = {0};
    Canned c;
    SerialLine line = {&c, canned_send, canned_receive, canned_now};
    LinkHost host;
    DeviceInfo info;
    DeviceImage image;
    uint8_t place;

    memset(&c, 0, sizeof c);
    sm_link_receiver_init(&c.in, c.arrived, sizeof c.arrived);
    link_host_init(&host, &line, 100, 1, 0);
    for (size_t n = 14; n <= sizeof all; n++) {
        memcpy(c.body, all, c.n = sizeof all);
        CHECK(device_query_info(&host, &info) && info.requires_signature && info.newest == 5 && info.reports_limits && info.windows && info.parameters && info.machines == 3);
        CHECK(info.ram_digital == 10 && info.ram_analog == 26 && info.period == 20 && info.cycles == 8000 && info.reports_mark);
        CHECK(info.mark == 0x01020304 && info.slots == 2 && info.slot_size == 1024 && info.ram == 512 && info.longest == 9);
        c.n = n;
        CHECK(device_query_info(&host, &info) == (n >= 15) && (n >= 15 || host.result == SM_E_UNSUPPORTED));
        CHECK(n < 15 || (info.requires_signature == (n >= 20) && info.newest == (n >= 20 ? 5 : 0)));
        CHECK(n < 15 || (info.reports_limits == (n >= 27) && info.windows == (n >= 27) && info.parameters == (n >= 27) && info.machines == (n >= 27 ? 3 : 0)));
        CHECK(n < 15 || info.functions == (n >= 35 ? 0x30007 : 0));
        CHECK(n < 15 || (info.period == (n >= 27 ? 20 : 0) && info.reports_mark == (n >= 31) && info.mark == (n >= 31 ? 0x01020304 : 0)));
    }
    memcpy(c.body, none, c.n = 20);
    c.body[18] = 44;                       // IMAGE now also has the milliseconds between steps
    CHECK(device_read_image_info(&host, 0, &image) && image.period == 44);
    for (c.n = 17; c.n < 20; c.n++)
        CHECK(device_read_image_info(&host, 0, &image) == (c.n >= 18) && (c.n < 18 || image.period == 0));
    c.n = 0;                               // an answer without a position reports none
    CHECK(!device_find_chip_pin(&host, 2, 3, &place) && host.result == SM_E_UNSUPPORTED);
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
    test_older_boards_report_less();
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
    test_log_survives_restarts();
    test_torn_record_is_skipped();
    test_log_is_written_seldom();
    test_log_yields_to_images();
    test_any_bytes_are_a_log();
    for (unsigned long i = 0; i < number; i++)
        update_in_trouble(memories[i % 2], (uint8_t)(1 + i / 2 % 2), &ends);
    printf("%lu updates: %u succeeded, %u refused, %u without an answer\n", number, ends.succeeded, ends.refused, ends.silent);
    CHECK(number < 100 || (ends.succeeded > number / 8 && ends.refused > 0 && ends.silent > 0));
    return test_end("agent");
}
