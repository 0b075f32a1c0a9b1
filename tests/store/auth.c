// SPDX-License-Identifier: Apache-2.0
// A board with a key: images without a valid signature are neither chosen nor run, and no earlier number is accepted, wherever the power fails.
//   auth OLD.smb NEW.smb
#include <stdlib.h>

#include "compiler/device/sign.h"
#include "stdlib/crc32.h"
#include "tests/store/board.h"
#include "tests/test.h"

static const uint8_t our_key[SMVM_KEY] = "not a good key.", other_key[SMVM_KEY] = "not a good kez.";
static Image old_image, new_image;         // not signed

static Image sign_image(const uint8_t *key, const Image *image, uint32_t number)
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

static void test_signing_preserves_the_content(void)
{
    Image s = sign_image(our_key, &new_image, 7), again;
    SmvmAuth auth;
    SmvmMachine a, b;

    CHECK(s.length == new_image.length + SIGN_ROOM && is_accepted(&s, our_key) && !is_accepted(&s, other_key));
    CHECK(smvm_auth_read(s.bytes, &auth) && auth.number == 7 && auth.mark == smvm_auth_mark(our_key) && auth.mark != smvm_auth_mark(other_key));
    CHECK(!smvm_auth_read(new_image.bytes, &auth) && auth.number == 0 && auth.mark == 0 && !is_accepted(&new_image, our_key));
    CHECK(smvm_machine(new_image.bytes, 0, &a) && smvm_machine(s.bytes, 0, &b) && a.code_size == b.code_size);
    CHECK(memcmp(new_image.bytes + a.code_at, s.bytes + b.code_at, a.code_size) == 0);
    again = sign_image(other_key, &s, 8);
    CHECK(again.length == s.length && is_accepted(&again, other_key) && !is_accepted(&again, our_key));
    again = sign_image(our_key, &again, 7);
    CHECK(memcmp(again.bytes, s.bytes, s.length) == 0);
}

// sign.h: "0: there is no room for another section".  An image has at most 255 sections and 2^24 - 1 bytes.
static void test_signing_has_limits(void)
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

// An attacker who changes the image can correct its checksum, but not its authentication code.
static void test_every_bit_is_authenticated(void)
{
    const Image s = sign_image(our_key, &new_image, 7);

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

// The authentication code does not cover bytes after the image.
static void test_code_ends_the_image(void)
{
    Image s = sign_image(our_key, &new_image, 7);
    SmvmAuth auth;
    uint32_t number;

    s.bytes[s.length++] = 0;
    for (unsigned i = 0; i < 3; i++)
        s.bytes[SMVM_LENGTH_AT + i] = (uint8_t)(s.length >> 8 * i);
    smvm_auth_code(s.bytes, s.length - 1 - SMVM_CODE, our_key, s.bytes + s.length - 1 - SMVM_CODE);
    CHECK(!smvm_auth_check(s.bytes, our_key, &number) && !smvm_auth_read(s.bytes, &auth));
}

// ---- a board ----

static bool start_board(Board *b) { return board_opens(b) && smvm_store_boot(&b->store, &b->slot) == SM_OK; }

static bool restart_board(Board *b)
{
    sim_power_on();
    return start_board(b);
}

static SmResult send_number(Board *b, uint32_t number)
{
    const Image s = sign_image(our_key, number % 2 ? &old_image : &new_image, number);
    return image_send(&b->store, &s);
}

static uint32_t newest_number(const Board *b) { return smvm_uint(b->store.choice.newest, 0, 4); }

// Sends, chooses and starts an image; also confirms it if `confirm`.
static bool run_number(Board *b, uint32_t number, bool confirm)
{
    const Image s = sign_image(our_key, number % 2 ? &old_image : &new_image, number);

    return image_send(&b->store, &s) == SM_OK && smvm_store_activate(&b->store, IMAGE_SESSION, 0) == SM_OK && restart_board(b) && b->slot != STORE_BUILT_IN &&
           (!confirm || smvm_store_confirm(&b->store, s.checksum) == SM_OK);
}

static void new_board_with_key(Board *b, const char *memory, uint8_t slots)
{
    CHECK(board_new(b, memory, slots));
    b->is_authentic = is_ours;
    b->mark = smvm_auth_mark(our_key);
    CHECK(restart_board(b));
}

static void test_unsigned_image_is_refused(uint8_t slots)
{
    const Image theirs = sign_image(other_key, &new_image, 7);
    Board b;

    new_board_with_key(&b, "eeprom", slots);
    CHECK(image_send(&b.store, &new_image) == SM_E_UNSIGNED && smvm_store_activate(&b.store, IMAGE_SESSION, 0) == SM_E_HANDLE);
    CHECK(image_send(&b.store, &theirs) == SM_E_UNSIGNED && smvm_store_activate(&b.store, IMAGE_SESSION, 0) == SM_E_HANDLE);
    CHECK(restart_board(&b) && b.slot == STORE_BUILT_IN);
    CHECK(run_number(&b, 7, true) && newest_number(&b) == 7);
    CHECK(image_send(&b.store, &theirs) == SM_E_UNSIGNED && smvm_store_activate(&b.store, IMAGE_SESSION, 0) == SM_E_HANDLE);
    CHECK(restart_board(&b) && (b.slot != STORE_BUILT_IN) == (slots == 2));
}

static void test_no_number_is_reused(uint8_t slots)
{
    Board b;

    new_board_with_key(&b, "flash", slots);
    CHECK(send_number(&b, 0) == SM_E_REPLAY);
    CHECK(run_number(&b, 5, true) && newest_number(&b) == 5);
    CHECK(send_number(&b, 4) == SM_E_REPLAY && smvm_store_activate(&b.store, IMAGE_SESSION, 0) == SM_E_HANDLE);
    CHECK(send_number(&b, 5) == SM_E_REPLAY);
    CHECK(run_number(&b, 9, false) && newest_number(&b) == 5);
    for (int i = 0; i < STORE_TRIES * STORE_START; i++)
        CHECK(restart_board(&b));
    CHECK(run_number(&b, 6, true) && newest_number(&b) == 6);        // a trial without a confirmation does not count
    CHECK(restart_board(&b) && newest_number(&b) == 6 && send_number(&b, 6) == SM_E_REPLAY);
    CHECK(run_number(&b, 0xffffffff, true) && newest_number(&b) == 0xffffffff && send_number(&b, 7) == SM_E_REPLAY);
}

static const Image *sign_numbered(uint32_t number)
{
    static Image s;

    s = sign_image(our_key, number % 2 ? &old_image : &new_image, number);
    return &s;
}

// A start does not fall back to an image that was overwritten and sent again, but not accepted.
static void test_no_fallback_to_unaccepted_image(uint8_t slots)
{
    Board b;

    new_board_with_key(&b, "eeprom", slots);
    CHECK(run_number(&b, 1, true) && run_number(&b, 2, true));
    if (slots == 2)
        CHECK(image_send(&b.store, sign_numbered(3)) == SM_OK);             // overwrites number 1
    else
        smvm_store_run_built_in(&b.store);
    CHECK(image_send(&b.store, sign_numbered(1)) == SM_E_REPLAY);
    if (slots == 2)
        CHECK(smvm_store_erase(&b.store, sign_numbered(2)->checksum) == SM_OK);
    CHECK(restart_board(&b) && b.slot == STORE_BUILT_IN);
}

// A board without a key and with one slot does not confirm it either.
static void test_interrupted_update_is_not_confirmed(void)
{
    Board b;

    CHECK(board_new(&b, "eeprom", 1) && run_number(&b, 1, true) && run_number(&b, 2, true));
    smvm_store_run_built_in(&b.store);
    CHECK(image_send(&b.store, sign_numbered(1)) == SM_OK && restart_board(&b) && b.slot == STORE_BUILT_IN);
}

// A refused request does not make the board leave a slot.
static void test_refused_begin_has_no_effect(void)
{
    uint8_t request[LINK_ROOM(9)] = {0, 1, LINK_BEGIN, 0, 0, 64, 0, 0, 1, 2, 3, 4};        // no session
    uint16_t length;
    Board b;

    CHECK(board_new(&b, "eeprom", 1) && run_number(&b, 1, true) && board_start(&b) && b.slot == 0);
    length = sm_link_encode(request, LINK_HEAD + 9);
    for (uint16_t i = 0; i < length; i++)
        (void)board_takes(&b, request[i]);
    CHECK(b.left == 0 && b.slot == 0);
}

// Returns the result of a BEGIN for this image, with the first n bytes of a permit.
static SmResult request_begin(Board *b, const Image *image, const uint8_t *permit, uint16_t n)
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

// With one slot, a request stops the running image only if it has a permit for a new number.  Only an owner of the key can make a permit.
static void test_stop_needs_a_permit(void)
{
    const Image s = sign_image(our_key, &old_image, 9), theirs = sign_image(other_key, &old_image, 9), used = sign_image(our_key, &old_image, 5);
    uint8_t permit[SMVM_PERMIT], wrong[SMVM_PERMIT];
    Image longer = s;
    Board b;

    new_board_with_key(&b, "eeprom", 1);
    b.key = our_key;
    CHECK(run_number(&b, 5, true) && board_start(&b) && b.slot == 0 && smvm_permit_read(s.bytes, permit));
    longer.length++;
    for (uint16_t n = 0; n < SMVM_PERMIT; n++)
        CHECK(request_begin(&b, &s, permit, n) == SM_E_UNSIGNED && b.left == 0);
    for (unsigned bit = 0; bit < 8 * SMVM_PERMIT; bit++) {
        memcpy(wrong, permit, sizeof wrong);
        wrong[bit / 8] ^= (uint8_t)(1u << bit % 8);
        CHECK(request_begin(&b, &s, wrong, SMVM_PERMIT) == SM_E_UNSIGNED && b.left == 0);
    }
    CHECK(request_begin(&b, &longer, permit, SMVM_PERMIT) == SM_E_UNSIGNED && b.left == 0);
    CHECK(smvm_permit_read(theirs.bytes, wrong) && request_begin(&b, &s, wrong, SMVM_PERMIT) == SM_E_UNSIGNED && b.left == 0);
    CHECK(smvm_permit_read(used.bytes, wrong) && request_begin(&b, &s, wrong, SMVM_PERMIT) == SM_E_REPLAY && b.left == 0 && b.slot == 0);
    CHECK(request_begin(&b, &s, permit, SMVM_PERMIT) == SM_OK && b.left == 1 && b.slot == STORE_BUILT_IN);
    CHECK(request_begin(&b, &s, permit, SMVM_PERMIT) == SM_OK && b.left == 1);           // the answer was lost
}

// An image that was signed by a version without permits gets one when it is signed again.
static void test_signing_adds_a_permit(void)
{
    const Image s = sign_image(our_key, &new_image, 7);
    uint8_t permit[SMVM_PERMIT], code[SMVM_CODE];
    Image old = s, again;

    CHECK(smvm_permit_read(s.bytes, permit) && sm_link_load(permit, 4) == 7 && !smvm_permit_read(new_image.bytes, permit));
    smvm_permit_code(7, s.length, our_key, code);
    CHECK(memcmp(permit + 4, code, SMVM_CODE) == 0);
    old.bytes[SMVM_HEADER + (smvm_section_count(old.bytes) - 2) * SMVM_SECTION_ENTRY] = 0x70;     // a section of an unknown kind
    smvm_auth_code(old.bytes, old.length - SMVM_CODE, our_key, old.bytes + old.length - SMVM_CODE);
    put_crc(&old);
    CHECK(is_accepted(&old, our_key) && !smvm_permit_read(old.bytes, permit));
    again = sign_image(our_key, &old, 8);
    CHECK(is_accepted(&again, our_key) && smvm_permit_read(again.bytes, permit) && again.length == old.length + SMVM_SECTION_ENTRY + SMVM_CODE);
}

// A correct checksum is not sufficient: an image that was written and chosen without a request does not run on a board with a key.
static void test_injected_image_does_not_run(void)
{
    Board b;

    CHECK(board_new(&b, "eeprom", 2) && image_send(&b.store, &new_image) == SM_OK && smvm_store_activate(&b.store, IMAGE_SESSION, 0) == SM_OK);
    CHECK(restart_board(&b) && b.slot == 0 && smvm_store_confirm(&b.store, new_image.checksum) == SM_OK);
    b.is_authentic = is_ours;
    CHECK(restart_board(&b) && b.slot == STORE_BUILT_IN);
}

// A board without a key checks no code and stores no number.
static void test_board_without_key_accepts_all(void)
{
    Board b;

    CHECK(board_new(&b, "eeprom", 2) && run_number(&b, 5, true) && newest_number(&b) == 0 && run_number(&b, 4, true));
}

// HELLO reports to a host that the board has a key, so that the host need not try images without a signature.
static void test_hello_reports_the_key(void)
{
    uint8_t request[LINK_ROOM(0)] = {0, 1, LINK_HELLO}, answer[LINK_ROOM(BOARD_BODY)];
    LinkReceiver r;
    uint16_t n = 0, length;
    Board b;

    new_board_with_key(&b, "eeprom", 2);
    CHECK(run_number(&b, 0x01020304, true) && board_start(&b));
    length = sm_link_encode(request, LINK_HEAD);
    for (uint16_t i = 0; i < length; i++)
        n = board_takes(&b, request[i]);
    sm_link_receiver_init(&r, answer, sizeof answer);
    for (uint16_t i = 0; i + 1 < n; i++)
        sm_link_receive(&r, b.frame[i]);
    CHECK(n > 0 && sm_link_receive(&r, b.frame[n - 1]) && r.n == LINK_HEAD + 1 + 35);
    CHECK(answer[LINK_HEAD + 1 + 15] == 1 && sm_link_load(answer + LINK_HEAD + 1 + 16, 4) == 0x01020304);
    CHECK(sm_link_load(answer + LINK_HEAD + 1 + 27, 4) == smvm_auth_mark(our_key));
}

// ---- cuts ----

// The power fails while the record of the confirmation is written.  Afterwards the image is confirmed and its number stored, or neither.
static void test_confirming_is_atomic(const char *memory)
{
    for (uint32_t byte = 0; byte <= STORE_RECORD; byte++)
        for (uint32_t call = 0; call < 2; call++) {
            const Image s = sign_image(our_key, &old_image, 9);
            Board b;
            new_board_with_key(&b, memory, 2);
            CHECK(run_number(&b, 6, true) && run_number(&b, 9, false));
            sim_cut_power(call, byte);
            smvm_store_confirm(&b.store, s.checksum);
            CHECK(restart_board(&b) && b.slot != STORE_BUILT_IN);
            CHECK(newest_number(&b) == (b.store.choice.confirmed ? 9u : 6u));
            CHECK(smvm_store_confirm(&b.store, s.checksum) == SM_OK && restart_board(&b) && newest_number(&b) == 9);
            CHECK(send_number(&b, 8) == SM_E_REPLAY);
        }
}

int main(int argc, char **argv)
{
    if (argc < 3 || !image_load(argv[1], &old_image) || !image_load(argv[2], &new_image) ||
        old_image.length + SIGN_ROOM > IMAGE_ROOM || new_image.length + SIGN_ROOM > IMAGE_ROOM)
        return fprintf(stderr, "auth OLD.smb NEW.smb\n"), 2;
    test_signing_preserves_the_content();
    test_signing_has_limits();
    test_every_bit_is_authenticated();
    test_code_ends_the_image();
    for (uint8_t slots = 1; slots <= 2; slots++) {
        test_unsigned_image_is_refused(slots);
        test_no_number_is_reused(slots);
        test_no_fallback_to_unaccepted_image(slots);
    }
    test_injected_image_does_not_run();
    test_board_without_key_accepts_all();
    test_interrupted_update_is_not_confirmed();
    test_refused_begin_has_no_effect();
    test_signing_adds_a_permit();
    test_stop_needs_a_permit();
    test_hello_reports_the_key();
    test_confirming_is_atomic("eeprom");
    test_confirming_is_atomic("flash");
    return test_end("auth");
}
