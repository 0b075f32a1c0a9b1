// SPDX-License-Identifier: Apache-2.0
// The host's end of the link (docs/link.md): a request, its answer, and the same again when none comes.
#ifndef SMC_LINK_HOST_H
#define SMC_LINK_HOST_H

#include "runtime-c/link/link.h"

// A line that carries bytes, and a clock.
typedef struct Line {
    void *context;
    bool (*send)(void *context, const uint8_t *bytes, size_t n);                                  // false: the line is gone
    // Waits up to `wait` milliseconds; gives how many bytes came, 0 if none did, -1 when the line is gone.
    int (*receive)(void *context, uint8_t *bytes, size_t room, uint32_t wait);
    uint32_t (*now)(void *context);       // milliseconds, modulo 2^32
} Line;

typedef struct LinkHost {
    const Line *line;
    uint32_t wait;            // milliseconds until the same bytes are sent again
    unsigned tries;           // how often they are sent in all
    uint8_t sequence;         // of the last request
    bool gone;                // the line is
    bool answered;            // the last request was
    SmResult result;          // of its answer
    const uint8_t *body;      // what is behind it
    size_t n;
    LinkReceiver in;
    uint8_t arrived[LINK_ROOM(LINK_BODY_MAX)];
} LinkHost;

void link_host(LinkHost *h, const Line *line, uint32_t wait, unsigned tries, uint8_t sequence);

// Sends a request with a body of n bytes.  True: it was answered, with h->result and h->body.  False: nobody answers, or the line
// is gone.
bool link_ask(LinkHost *h, LinkMessage message, const uint8_t *body, size_t n);

#endif
