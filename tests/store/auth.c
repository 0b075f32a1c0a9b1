// SPDX-License-Identifier: Apache-2.0
// A board with a key: images without its signature are neither chosen nor run, and no old number is accepted, wherever the power fails.
//   auth OLD.smb NEW.smb
#include <stdlib.h>

#include "compiler/device/sign.h"
#include "stdlib/crc32.h"
#include "tests/store/board.h"
#include "tests/test.h"

static const uint8_t our_key[SMVM_KEY] = "not a good key.", other_key[SMVM_KEY] = "not a good kez.";
static Image old_image, new_image;         // not signed

static Image signed_with(const uint8_t *key, const Image *image, uint32_t number)
{
    Image s;

    s.length = image_sign(image->bytes, image->length, key, number, s.bytes);
    s.checksum = smvm_uint(s.bytes, SMVM_CRC_AT, 4);
    return s;
}

static bool is_ours(SmvmBytes image, uint32_t *number) { return smvm_auth_check(image, our_key, number); }

// ---- images ----

static void put_crc(Image *image)
{
    uint32_t crc = SM_CRC32_START;

    for (uint32_t i = 0; i < image->length; i++)
        if (i < SMVM_CRC_AT || i >= SMVM_CRC_AT + 4)
            crc = sm_crc32_byte(crc, image->bytes[i]);
    crc = sm_crc32_end(crc);
    for (unsigned i = 0; i < 4; i++)
        image->bytes[SMVM_CRC_AT + i] = (uint8_t)(crc >> 8 * i);
}

static bool is_accepted(const Image *image, const uint8_t *key)
{
    SmvmVerdict why;
    uint32_t number;

    return smvm_verify(image->bytes, image->length, &why) == 0 && smvm_auth_check(image->bytes, key, &number);
}

static void signing_leaves_the_rest(void)
{
    Image s = signed_with(our_key, &new_image, 7), again;
    SmvmAuth auth;
    SmvmMachine a, b;

    CHECK(s.length == new_image.length + SIGN_ROOM && is_accepted(&s, our_key) && !is_accepted(&s, other_key));
    CHECK(smvm_auth_read(s.bytes, &auth) && auth.number == 7 && auth.mark == smvm_auth_mark(our_key) && auth.mark != smvm_auth_mark(other_key));
    CHECK(!smvm_auth_read(new_image.bytes, &auth) && auth.number == 0 && auth.mark == 0 && !is_accepted(&new_image, our_key));
    CHECK(smvm_machine(new_image.bytes, 0, &a) && smvm_machine(s.bytes, 0, &b) && a.code_size == b.code_size);
    CHECK(memcmp(new_image.bytes + a.code_at, s.bytes + b.code_at, a.code_size) == 0);
    again = signed_with(other_key, &s, 8);
    CHECK(again.length == s.length && is_accepted(&again, other_key) && !is_accepted(&again, our_key));
    again = signed_with(our_key, &again, 7);
    CHECK(memcmp(again.bytes, s.bytes, s.length) == 0);
}

// "0: there is no room for another section": an image has 255 of them at most, and 2^24 - 1 bytes.
static void signing_has_limits(void)
{
    enum { MOST = 0xffffff, SECTIONS = SMVM_HEADER + 255 * SMVM_SECTION_ENTRY };
    uint8_t *image = calloc(2, MOST + SIGN_ROOM), *out = image + MOST + SIGN_ROOM;

    CHECK(image != NULL);
    if (!image)
        return;
    image[SMVM_SECTIONS_AT] = 254;
    CHECK(image_sign(image, SECTIONS - SMVM_SECTION_ENTRY, our_key, 1, out) == 0 && out[0] == 0);
    image[SMVM_SECTIONS_AT] = 253;
    CHECK(image_sign(image, SECTIONS - 2 * SMVM_SECTION_ENTRY, our_key, 1, out) == SECTIONS - 2 * SMVM_SECTION_ENTRY + SIGN_ROOM && out[SMVM_SECTIONS_AT] == 255);
    image[SMVM_SECTIONS_AT] = 1;
    CHECK(image_sign(image, MOST - SIGN_ROOM + 1, our_key, 1, out) == 0);
    CHECK(image_sign(image, MOST - SIGN_ROOM, our_key, 1, out) == MOST);
    free(image);
}

// Who changes an image can make its checksum right, but not its code.
static void every_bit_is_guarded(void)
{
    const Image s = signed_with(our_key, &new_image, 7);

    for (uint32_t bit = 0; bit < 8 * s.length; bit++) {
        Image changed = s;
        changed.bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
        CHECK(!is_accepted(&changed, our_key));
        if (bit / 32 == SMVM_CRC_AT / 4)
            continue;
        put_crc(&changed);
        CHECK(!is_accepted(&changed, our_key));
    }
}

// A code does not cover the bytes after it.
static void the_code_ends_the_image(void)
{
    Image s = signed_with(our_key, &new_image, 7);
    SmvmAuth auth;
    uint32_t number;

    s.bytes[s.length++] = 0;
    for (unsigned i = 0; i < 3; i++)
        s.bytes[SMVM_LENGTH_AT + i] = (uint8_t)(s.length >> 8 * i);
    smvm_auth_code(s.bytes, s.length - 1 - SMVM_CODE, our_key, s.bytes + s.length - 1 - SMVM_CODE);
    CHECK(!smvm_auth_check(s.bytes, our_key, &number) && !smvm_auth_read(s.bytes, &auth));
}

// ---- a board ----

static bool starts(Board *b) { return board_opens(b) && smvm_store_boot(&b->store, &b->slot) == SM_OK; }

static bool restarts(Board *b)
{
    sim_power_on();
    return starts(b);
}

static SmResult send_number(Board *b, uint32_t number)
{
    const Image s = signed_with(our_key, number % 2 ? &old_image : &new_image, number);
    return image_send(&b->store, &s);
}

static uint32_t newest(const Board *b) { return smvm_uint(b->store.choice.newest, 0, 4); }

// Chosen, started, and confirmed if `confirm`.
static bool runs_number(Board *b, uint32_t number, bool confirm)
{
    const Image s = signed_with(our_key, number % 2 ? &old_image : &new_image, number);

    return image_send(&b->store, &s) == SM_OK && smvm_store_activate(&b->store, IMAGE_SESSION, 0) == SM_OK && restarts(b) && b->slot != STORE_BUILT_IN &&
           (!confirm || smvm_store_confirm(&b->store, s.checksum) == SM_OK);
}

static void board_with_key(Board *b, const char *memory, uint8_t slots)
{
    CHECK(board_new(b, memory, slots));
    b->is_authentic = is_ours;
    b->mark = smvm_auth_mark(our_key);
    CHECK(restarts(b));
}

static void unsigned_image_is_refused(uint8_t slots)
{
    const Image theirs = signed_with(other_key, &new_image, 7);
    Board b;

    board_with_key(&b, "eeprom", slots);
    CHECK(image_send(&b.store, &new_image) == SM_E_UNSIGNED && smvm_store_activate(&b.store, IMAGE_SESSION, 0) == SM_E_HANDLE);
    CHECK(image_send(&b.store, &theirs) == SM_E_UNSIGNED && smvm_store_activate(&b.store, IMAGE_SESSION, 0) == SM_E_HANDLE);
    CHECK(restarts(&b) && b.slot == STORE_BUILT_IN);
    CHECK(runs_number(&b, 7, true) && newest(&b) == 7);
    CHECK(image_send(&b.store, &theirs) == SM_E_UNSIGNED && smvm_store_activate(&b.store, IMAGE_SESSION, 0) == SM_E_HANDLE);
    CHECK(restarts(&b) && (b.slot != STORE_BUILT_IN) == (slots == 2));
}

static void no_number_is_reused(uint8_t slots)
{
    Board b;

    board_with_key(&b, "flash", slots);
    CHECK(send_number(&b, 0) == SM_E_REPLAY);
    CHECK(runs_number(&b, 5, true) && newest(&b) == 5);
    CHECK(send_number(&b, 4) == SM_E_REPLAY && smvm_store_activate(&b.store, IMAGE_SESSION, 0) == SM_E_HANDLE);
    CHECK(send_number(&b, 5) == SM_E_REPLAY);
    CHECK(runs_number(&b, 9, false) && newest(&b) == 5);
    for (int i = 0; i < STORE_TRIES * STORE_START; i++)
        CHECK(restarts(&b));
    CHECK(runs_number(&b, 6, true) && newest(&b) == 6);        // a trial without a confirmation does not count
    CHECK(restarts(&b) && newest(&b) == 6 && send_number(&b, 6) == SM_E_REPLAY);
    CHECK(runs_number(&b, 0xffffffff, true) && newest(&b) == 0xffffffff && send_number(&b, 7) == SM_E_REPLAY);
}

static const Image *numbered(uint32_t number)
{
    static Image s;

    s = signed_with(our_key, number % 2 ? &old_image : &new_image, number);
    return &s;
}

// A start does not fall back to an image that was overwritten and is sent again, but was not accepted.
static void no_fallback_to_unaccepted_image(uint8_t slots)
{
    Board b;

    board_with_key(&b, "eeprom", slots);
    CHECK(runs_number(&b, 1, true) && runs_number(&b, 2, true));
    if (slots == 2)
        CHECK(image_send(&b.store, numbered(3)) == SM_OK);             // over number 1
    else
        smvm_store_run_built_in(&b.store);
    CHECK(image_send(&b.store, numbered(1)) == SM_E_REPLAY);
    if (slots == 2)
        CHECK(smvm_store_erase(&b.store, numbered(2)->checksum) == SM_OK);
    CHECK(restarts(&b) && b.slot == STORE_BUILT_IN);
}

// Nor on a board without a key that has one slot.
static void an_update_cut_off_is_not_confirmed(void)
{
    Board b;

    CHECK(board_new(&b, "eeprom", 1) && runs_number(&b, 1, true) && runs_number(&b, 2, true));
    smvm_store_run_built_in(&b.store);
    CHECK(image_send(&b.store, numbered(1)) == SM_OK && restarts(&b) && b.slot == STORE_BUILT_IN);
}

// A request that is refused has the board leave no slot.
static void refused_begin_has_no_effect(void)
{
    uint8_t request[LINK_ROOM(9)] = {0, 1, LINK_BEGIN, 0, 0, 64, 0, 0, 1, 2, 3, 4};        // no session
    uint16_t length;
    Board b;

    CHECK(board_new(&b, "eeprom", 1) && runs_number(&b, 1, true) && board_start(&b) && b.slot == 0);
    length = sm_link_encode(request, LINK_HEAD + 9);
    for (uint16_t i = 0; i < length; i++)
        (void)board_takes(&b, request[i]);
    CHECK(b.left == 0 && b.slot == 0);
}

// The result of a BEGIN for this image, with the first n bytes of a permit.
static SmResult begin(Board *b, const Image *image, const uint8_t *permit, uint16_t n)
{
    uint8_t request[LINK_ROOM(SMVM_PERMIT_AT + SMVM_PERMIT)] = {0, 1, LINK_BEGIN, 77}, answer[LINK_ROOM(BOARD_BODY)];
    LinkReceiver r;
    uint16_t length, got = 0;

    sm_link_store(request + 5, image->length, 3);
    sm_link_store(request + 8, image->checksum, 4);
    memcpy(request + 12, permit, n);
    length = sm_link_encode(request, (uint16_t)(LINK_HEAD + SMVM_PERMIT_AT + n));
    for (uint16_t i = 0; i < length; i++)
        got = board_takes(b, request[i]);
    sm_link_receiver_init(&r, answer, sizeof answer);
    for (uint16_t i = 0; i < got; i++)
        (void)sm_link_receive(&r, b->frame[i]);
    return r.is_complete ? (SmResult)(int8_t)answer[LINK_HEAD] : SM_E_TIMEOUT;
}

// With one slot, the image that runs is stopped only for an owner of the key: no request without a permit for a new number does it.
static void machine_is_stopped_with_a_permit_only(void)
{
    const Image s = signed_with(our_key, &old_image, 9), theirs = signed_with(other_key, &old_image, 9), used = signed_with(our_key, &old_image, 5);
    uint8_t permit[SMVM_PERMIT], wrong[SMVM_PERMIT];
    Image longer = s;
    Board b;

    board_with_key(&b, "eeprom", 1);
    b.key = our_key;
    CHECK(runs_number(&b, 5, true) && board_start(&b) && b.slot == 0 && smvm_permit_read(s.bytes, permit));
    longer.length++;
    for (uint16_t n = 0; n < SMVM_PERMIT; n++)
        CHECK(begin(&b, &s, permit, n) == SM_E_UNSIGNED && b.left == 0);
    for (unsigned bit = 0; bit < 8 * SMVM_PERMIT; bit++) {
        memcpy(wrong, permit, sizeof wrong);
        wrong[bit / 8] ^= (uint8_t)(1u << bit % 8);
        CHECK(begin(&b, &s, wrong, SMVM_PERMIT) == SM_E_UNSIGNED && b.left == 0);
    }
    CHECK(begin(&b, &longer, permit, SMVM_PERMIT) == SM_E_UNSIGNED && b.left == 0);
    CHECK(smvm_permit_read(theirs.bytes, wrong) && begin(&b, &s, wrong, SMVM_PERMIT) == SM_E_UNSIGNED && b.left == 0);
    CHECK(smvm_permit_read(used.bytes, wrong) && begin(&b, &s, wrong, SMVM_PERMIT) == SM_E_REPLAY && b.left == 0 && b.slot == 0);
    CHECK(begin(&b, &s, permit, SMVM_PERMIT) == SM_OK && b.left == 1 && b.slot == STORE_BUILT_IN);
    CHECK(begin(&b, &s, permit, SMVM_PERMIT) == SM_OK && b.left == 1);           // the answer was lost
}

// An image that was signed by a version without permits gets one when it is signed again.
static void signing_adds_a_permit(void)
{
    const Image s = signed_with(our_key, &new_image, 7);
    uint8_t permit[SMVM_PERMIT], code[SMVM_CODE];
    Image old = s, again;

    CHECK(smvm_permit_read(s.bytes, permit) && sm_link_load(permit, 4) == 7 && !smvm_permit_read(new_image.bytes, permit));
    smvm_permit_code(7, s.length, our_key, code);
    CHECK(memcmp(permit + 4, code, SMVM_CODE) == 0);
    old.bytes[SMVM_HEADER + (smvm_section_count(old.bytes) - 2) * SMVM_SECTION_ENTRY] = 0x70;     // a section that nothing knows
    smvm_auth_code(old.bytes, old.length - SMVM_CODE, our_key, old.bytes + old.length - SMVM_CODE);
    put_crc(&old);
    CHECK(is_accepted(&old, our_key) && !smvm_permit_read(old.bytes, permit));
    again = signed_with(our_key, &old, 8);
    CHECK(is_accepted(&again, our_key) && smvm_permit_read(again.bytes, permit) && again.length == old.length + SMVM_SECTION_ENTRY + SMVM_CODE);
}

// A checksum proves nothing: what was written without asking, its checksum chosen, does not run on a board with a key.
static void injected_image_does_not_run(void)
{
    Board b;

    CHECK(board_new(&b, "eeprom", 2) && image_send(&b.store, &new_image) == SM_OK && smvm_store_activate(&b.store, IMAGE_SESSION, 0) == SM_OK);
    CHECK(restarts(&b) && b.slot == 0 && smvm_store_confirm(&b.store, new_image.checksum) == SM_OK);
    b.is_authentic = is_ours;
    CHECK(restarts(&b) && b.slot == STORE_BUILT_IN);
}

// Without a key nothing is asked, and no number kept.
static void board_without_key_accepts_all(void)
{
    Board b;

    CHECK(board_new(&b, "eeprom", 2) && runs_number(&b, 5, true) && newest(&b) == 0 && runs_number(&b, 4, true));
}

// HELLO tells a host that the board has a key, so that it need not try other images.
static void hello_reports_the_key(void)
{
    uint8_t request[LINK_ROOM(0)] = {0, 1, LINK_HELLO}, answer[LINK_ROOM(BOARD_BODY)];
    LinkReceiver r;
    uint16_t n = 0, length;
    Board b;

    board_with_key(&b, "eeprom", 2);
    CHECK(runs_number(&b, 0x01020304, true) && board_start(&b));
    length = sm_link_encode(request, LINK_HEAD);
    for (uint16_t i = 0; i < length; i++)
        n = board_takes(&b, request[i]);
    sm_link_receiver_init(&r, answer, sizeof answer);
    for (uint16_t i = 0; i + 1 < n; i++)
        sm_link_receive(&r, b.frame[i]);
    CHECK(n > 0 && sm_link_receive(&r, b.frame[n - 1]) && r.n == LINK_HEAD + 1 + 31);
    CHECK(answer[LINK_HEAD + 1 + 15] == 1 && sm_link_load(answer + LINK_HEAD + 1 + 16, 4) == 0x01020304);
    CHECK(sm_link_load(answer + LINK_HEAD + 1 + 27, 4) == smvm_auth_mark(our_key));
}

// ---- cuts ----

// The power goes in the middle of the record that confirms: the image is confirmed and its number known, or neither.
static void confirming_is_cut(const char *memory)
{
    for (uint32_t byte = 0; byte <= STORE_RECORD; byte++)
        for (uint32_t call = 0; call < 2; call++) {
            const Image s = signed_with(our_key, &old_image, 9);
            Board b;
            board_with_key(&b, memory, 2);
            CHECK(runs_number(&b, 6, true) && runs_number(&b, 9, false));
            sim_cut_power(call, byte);
            smvm_store_confirm(&b.store, s.checksum);
            CHECK(restarts(&b) && b.slot != STORE_BUILT_IN);
            CHECK(newest(&b) == (b.store.choice.confirmed ? 9u : 6u));
            CHECK(smvm_store_confirm(&b.store, s.checksum) == SM_OK && restarts(&b) && newest(&b) == 9);
            CHECK(send_number(&b, 8) == SM_E_REPLAY);
        }
}

int main(int argc, char **argv)
{
    if (argc < 3 || !image_load(argv[1], &old_image) || !image_load(argv[2], &new_image) ||
        old_image.length + SIGN_ROOM > IMAGE_ROOM || new_image.length + SIGN_ROOM > IMAGE_ROOM)
        return fprintf(stderr, "auth OLD.smb NEW.smb\n"), 2;
    signing_leaves_the_rest();
    signing_has_limits();
    every_bit_is_guarded();
    the_code_ends_the_image();
    for (uint8_t slots = 1; slots <= 2; slots++) {
        unsigned_image_is_refused(slots);
        no_number_is_reused(slots);
        no_fallback_to_unaccepted_image(slots);
    }
    injected_image_does_not_run();
    board_without_key_accepts_all();
    an_update_cut_off_is_not_confirmed();
    refused_begin_has_no_effect();
    signing_adds_a_permit();
    machine_is_stopped_with_a_permit_only();
    hello_reports_the_key();
    confirming_is_cut("eeprom");
    confirming_is_cut("flash");
    return test_end("auth");
}
