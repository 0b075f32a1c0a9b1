// SPDX-License-Identifier: Apache-2.0
// Frames on a serial line, for both ends.  A frame is: COBS(sequence, message, body, CRC-32 of all before it), then a zero.  COBS
// takes every zero out of what it stuffs, so that a zero is always the end of a frame: whoever lost the thread finds it at the next
// zero.  What is not a whole and sound frame is dropped without a word; the sender repeats.
//
// Stop and wait: the host sends a request and waits for the answer of the same sequence number; without one it sends the same
// bytes again.  Every request may be carried out twice without harm, so the device remembers nothing of them (link.def,
// docs/link.md).
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
#define LINK_BODY_MAX 200u    // the largest body that any device may ask for; what it takes it says in HELLO
// Bytes of buffer for a frame on its way, with COBS and zero, or for one that arrives.
#define LINK_ROOM(body) (LINK_HEAD + (body) + LINK_TAIL + 2u)
#define LINK_ANSWER   0x80u
#define LINK_WINDOWS  0x80u   // HELLO: a bit beside the number of machines

typedef enum LinkMessage {
#define LINK_MESSAGE(name, number, request, answer) LINK_##name = number,
#include "runtime-c/link/link.def"
#undef LINK_MESSAGE
    LINK_NONE = 0
} LinkMessage;

// What arrives, byte by byte.
typedef struct LinkReceiver {
    uint8_t *buffer;          // LINK_ROOM(body) bytes
    uint16_t room, n;         // n: bytes of the frame so far; of a whole one, without its checksum
    uint8_t left, code;       // COBS: bytes up to the next stuffed zero; the code it began with
    bool lost;                // this frame is too long: dropped up to the next zero
    bool done;                // a frame is in the buffer
} LinkReceiver;

void sm_link_receiver(LinkReceiver *r, uint8_t *buffer, uint16_t room);

// True: a whole and sound frame is in r->buffer: sequence, message, body, r->n bytes in all.  It stays until the next byte.
bool sm_link_receive(LinkReceiver *r, uint8_t byte);

// Makes a frame, in place: `frame` holds n bytes from frame[1] on (sequence, message, body); behind them is room for LINK_TAIL + 1
// bytes.  Gives the bytes to be sent, from frame[0] on.
uint16_t sm_link_frame(uint8_t *frame, uint16_t n);

uint32_t sm_link_check(const uint8_t *bytes, uint16_t n);           // their CRC-32

// Fields of 1 to 4 bytes, the least significant first.
uint32_t sm_link_get(const uint8_t *at, unsigned bytes);
void sm_link_put(uint8_t *at, uint32_t value, unsigned bytes);

#ifdef __cplusplus
}
#endif
#endif
