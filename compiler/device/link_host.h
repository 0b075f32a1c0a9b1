// SPDX-License-Identifier: Apache-2.0
// The host's end of the link (docs/link.md): sends a request, waits for its answer, and repeats the request after a timeout.
#ifndef SMC_LINK_HOST_H
#define SMC_LINK_HOST_H

#include "runtime-c/link/link.h"

// A byte stream to the board, and a clock.
typedef struct SerialLine {
    void *context;
    bool (*send)(void *context, const uint8_t *bytes, size_t n);                                  // sends n bytes; false: the line is closed
    // Waits up to `wait` milliseconds.  Returns the number of bytes received, 0 if none, -1 if the line is closed.
    int (*receive)(void *context, uint8_t *bytes, size_t room, uint32_t wait);
    uint32_t (*now)(void *context);       // returns the time in milliseconds, modulo 2^32
} SerialLine;

typedef struct LinkHost {
    const SerialLine *line;
    uint32_t wait;            // timeout in milliseconds before a request is sent again
    unsigned tries;           // total number of times that a request is sent
    uint8_t sequence;         // sequence number of the last request
    bool gone;                // the line is closed: a device that was unplugged, or an error
    bool answered;            // the last request was answered
    SmResult result;          // result in the last answer
    const uint8_t *body;      // the n bytes that follow the result in that answer
    size_t n;
    LinkReceiver in;          // decodes received bytes into `arrived`
    uint8_t arrived[LINK_ROOM(LINK_BODY_MAX)];
} LinkHost;

// Initialises h for a line.  `sequence`: the number before that of the first request.
void link_host_init(LinkHost *h, const SerialLine *line, uint32_t wait, unsigned tries, uint8_t sequence);

// Sends a request with a body of n bytes.  True: it was answered, with h->result and h->body.  False: no answer within all tries, the
// line is closed, or n is above LINK_BODY_MAX.
bool link_request(LinkHost *h, LinkMessage message, const uint8_t *body, size_t n);

#endif
