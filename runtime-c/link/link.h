// SPDX-License-Identifier: Apache-2.0
// Frames on a serial line, for both ends.  A frame is COBS(sequence, message, body, CRC-32 of all preceding bytes), followed by a
// zero.  COBS removes every zero from the data, so a zero always ends a frame.  A receiver that has lost synchronisation recovers
// at the next zero.  Damaged frames are dropped silently, and the sender repeats them.
//
// Stop and wait: the host sends a request and waits for the answer with the same sequence number.  After a timeout it sends the
// same bytes again.  Executing a request twice is harmless, so the device does not remember requests (link.def, docs/link.md).
#ifndef SM_LINK_H
#define SM_LINK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "stdlib/result.h"

#ifdef __cplusplus
extern "C" {
#endif

#define LINK_PROTOCOL 1
#define LINK_HEAD     2u      // sequence, message
#define LINK_TAIL     4u      // CRC-32
#define LINK_BODY_MAX 200u    // the largest body that a device may accept; HELLO reports the device's own limit
// Buffer size in bytes for one frame to send, including COBS and the zero, or for one frame to receive.
#define LINK_ROOM(body) (LINK_HEAD + (body) + LINK_TAIL + 2u)
#define LINK_ANSWER   0x80u   // set in the message number of an answer; the other bits are the number of the request
#define LINK_TRIAL_END 8u     // answer to IMAGE: flags / LINK_TRIAL_END % 4 is how the last trial ended (store.h)
// Flags of MACHINE.
#define LINK_SWAPPABLE 1u     // the machine can be swapped
#define LINK_ON_TRIAL  2u     // the machine's image is on trial after a swap
#define LINK_BUILT_IN  4u     // the machine runs the image with which the application was built
#define LINK_STORED    8u     // its image is stored, and runs again after a restart
#define LINK_WINDOWS  0x80u   // answer to HELLO: in the byte with the most machines of an image: images can contain windows
#define LINK_PARAMETERS 0x40u // in the same byte: images can contain parameters (language.md 5.77)

typedef enum LinkMessage {
#define LINK_MESSAGE(name, number, request, answer) LINK_##name = number,
#include "runtime-c/link/link.def"
#undef LINK_MESSAGE
    LINK_NONE = 0
} LinkMessage;

// The state of a receiver, which processes one byte at a time.
typedef struct LinkReceiver {
    uint8_t *buffer;          // LINK_ROOM(body) bytes
    uint16_t room, n;         // n: bytes of the frame so far; once complete, without its checksum
    uint8_t run_left, run_code;  // COBS: bytes of the current run that are still to come; the code byte at its start
    bool is_too_long;         // this frame is too long; bytes are dropped up to the next zero
    bool is_complete;         // `buffer` contains a complete frame
} LinkReceiver;

void sm_link_receiver_init(LinkReceiver *r, uint8_t *buffer, uint16_t room);

// Processes one byte.  Returns true if r->buffer now contains an intact frame: sequence, message, body, r->n bytes in total.  It
// stays valid until the next byte.
bool sm_link_receive(LinkReceiver *r, uint8_t byte);

// Encodes a frame in place.  The n bytes from frame[1] on are sequence, message and body; LINK_TAIL + 1 further bytes must be
// available after them.  Returns the number of bytes to send, starting at frame[0].
uint16_t sm_link_encode(uint8_t *frame, uint16_t n);

uint32_t sm_link_crc(const uint8_t *bytes, uint16_t n);             // returns the CRC-32 of n bytes

// These load and store a field of 1 to 4 bytes, little-endian.
uint32_t sm_link_load(const uint8_t *at, unsigned bytes);
void sm_link_store(uint8_t *at, uint32_t value, unsigned bytes);

#ifdef __cplusplus
}
#endif
#endif
