// SPDX-License-Identifier: Apache-2.0
// Fuzz target: any bytes on the line to a board, first unchanged, then as the bodies of valid frames.  The sanitizers check that no access is
// outside its memory.  Every answer must be a valid frame.  After any requests, the board must start again with a complete image.
#include "tests/fuzz/fuzz.h"
#include "tests/store/board.h"

static void answer_is_sound(const Board *b, uint16_t n)
{
    uint8_t buffer[LINK_ROOM(BOARD_BODY)];
    LinkReceiver in;
    bool whole = false;

    FUZZ_CHECK(n <= sizeof b->frame);
    sm_link_receiver_init(&in, buffer, sizeof buffer);
    for (uint16_t i = 0; i < n; i++) {
        FUZZ_CHECK(!whole);
        whole = sm_link_receive(&in, b->frame[i]);
    }
    FUZZ_CHECK(whole && (in.buffer[1] & LINK_ANSWER) != 0 && in.n > LINK_HEAD);
}

unsigned long fuzz_reached;           // inputs that send an image to the board which runs after a start
const unsigned fuzz_floor = 10;

static void give(Board *b, const uint8_t *bytes, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const uint16_t length = board_takes(b, bytes[i]);
        if (length > 0)
            answer_is_sound(b, length);
        if (b->agent.restart)
            FUZZ_CHECK(board_start(b));
    }
}

// Maps a byte to a message.  A number of link.def is this message.  Other bytes below 128 select one of the messages; the rest are invalid.
static uint8_t message_of(uint8_t byte)
{
    static const uint8_t messages[] = {
#define LINK_MESSAGE(name, number, request, answer) number,
#include "runtime-c/link/link.def"
#undef LINK_MESSAGE
    };

    for (size_t i = 0; i < sizeof messages; i++)
        if (messages[i] == byte)
            return byte;
    return byte & 0x80 ? byte : messages[byte % sizeof messages];
}

// Sends a frame.  The first byte is the length of its body, the second selects the request (message_of).
static size_t give_frame(Board *b, const uint8_t *data, size_t size)
{
    uint8_t frame[LINK_ROOM(BOARD_BODY) + 1] = {0};
    const size_t n = data[0] % (BOARD_BODY + 1u);

    if (size < n + 2)
        return size;
    frame[1] = (uint8_t)size;
    frame[2] = message_of(data[1]);
    memcpy(frame + 3, data + 2, n);
    give(b, frame, sm_link_encode(frame, (uint16_t)(LINK_HEAD + n)));
    return n + 2;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static Board b;
    if (size < 2 || size > 65536)
        return 0;
    FUZZ_CHECK(board_new(&b, data[0] & 1 ? "flash" : "eeprom", (uint8_t)(1 + (data[0] >> 1 & 1))));
    give(&b, data, size);
    for (size_t at = 1; at + 1 < size;)
        at += give_frame(&b, data + at, size - at);
    FUZZ_CHECK(board_start(&b));
    fuzz_reached += b.slot != STORE_BUILT_IN;
    FUZZ_CHECK(b.slot == STORE_BUILT_IN || smvm_store_state(&b.store, b.slot) != STORE_EMPTY);
    return 0;
}
