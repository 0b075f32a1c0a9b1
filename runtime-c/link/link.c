// SPDX-License-Identifier: Apache-2.0
// COBS (Cheshire and Baker, 1999), in place in both directions.  A frame is shorter than 254 bytes, so the encoding adds exactly
// one byte.  A run is a code byte and the bytes up to the next zero that was removed; the code is 1 + their number.
#include "runtime-c/link/link.h"

#include "stdlib/crc32.h"

typedef char link_frame_is_one_run[LINK_HEAD + LINK_BODY_MAX + LINK_TAIL < 254 ? 1 : -1];

// Stores a field of 1 to 4 bytes, little-endian.
void sm_link_store(uint8_t *at, uint32_t value, unsigned bytes)
{
    for (unsigned i = 0; i < bytes; i++) {
        at[i] = (uint8_t)value;
        value >>= 8;
    }
}

// Loads a field of 1 to 4 bytes, little-endian.
uint32_t sm_link_load(const uint8_t *at, unsigned bytes)
{
    uint32_t value = 0;

    while (bytes-- > 0)
        value = value << 8 | at[bytes];
    return value;
}

uint32_t sm_link_crc(const uint8_t *bytes, uint16_t n) { return sm_crc32(bytes, n); }

// ---- sending ----

// Encodes in place a frame whose n bytes from frame[1] on are sequence, message and body.  Returns the number of bytes to send.
uint16_t sm_link_encode(uint8_t *frame, uint16_t n)
{
    const uint16_t end = (uint16_t)(1 + n + LINK_TAIL);
    uint16_t zero = end;      // position of the next zero after byte i

    sm_link_store(frame + 1 + n, sm_link_crc(frame + 1, n), LINK_TAIL);
    frame[end] = 0;
    for (uint16_t i = end; i-- > 1;)
        if (frame[i] == 0) {
            frame[i] = (uint8_t)(zero - i);
            zero = i;
        }
    frame[0] = (uint8_t)zero;
    return (uint16_t)(end + 1);
}

// ---- receiving ----

// Prepares for the next frame.
static void reset_frame(LinkReceiver *r)
{
    r->n = 0;
    r->run_left = 0;
    r->run_code = 0xff;           // no zero precedes the first run
    r->is_too_long = false;
}

void sm_link_receiver_init(LinkReceiver *r, uint8_t *buffer, uint16_t room)
{
    r->buffer = buffer;
    r->room = room;
    r->is_complete = false;
    reset_frame(r);
}

// Called at the zero that ends a frame.  If the frame is intact, removes its checksum and returns true.
static bool try_finish_frame(LinkReceiver *r)
{
    if (r->is_too_long || r->run_left != 0 || r->n < LINK_HEAD + LINK_TAIL)
        return false;
    if (sm_link_crc(r->buffer, r->n) != SM_CRC32_RESIDUE)
        return false;
    r->n = (uint16_t)(r->n - LINK_TAIL);
    return true;
}

// Processes one byte.  Returns true if r->buffer now contains an intact frame, which stays valid until the next byte.
bool sm_link_receive(LinkReceiver *r, uint8_t byte)
{
    if (r->is_complete) {
        r->is_complete = false;
        reset_frame(r);
    }
    if (byte == 0) {
        r->is_complete = try_finish_frame(r);
        if (!r->is_complete)
            reset_frame(r);
        return r->is_complete;
    }
    if (r->run_left > 0) {
        r->run_left--;
    } else {
        const bool zero = r->run_code != 0xff;   // a zero was removed between the runs
        r->run_code = byte;
        r->run_left = (uint8_t)(byte - 1);
        if (!zero)
            return false;
        byte = 0;
    }
    if (r->n < r->room)
        r->buffer[r->n++] = byte;
    else
        r->is_too_long = true;
    return false;
}
