// SPDX-License-Identifier: Apache-2.0
#include "compiler/device/link_host.h"

#include <string.h>

// Initialises h for a line.  wait: ms to wait for each answer.  sequence: the first request has the next number.
void link_host_init(LinkHost *h, const SerialLine *line, uint32_t wait, unsigned tries, uint8_t sequence)
{
    memset(h, 0, sizeof *h);
    h->line = line;
    h->wait = wait;
    h->tries = tries;
    h->sequence = sequence;
    sm_link_receiver_init(&h->in, h->arrived, sizeof h->arrived);
}

// If the received frame answers the current request, stores its result and body and returns true.  Any other frame is a late answer to an
// earlier request.
static bool accept_answer(LinkHost *h, LinkMessage message)
{
    const uint8_t *b = h->in.buffer;

    if (h->in.n <= LINK_HEAD || b[0] != h->sequence || b[1] != ((uint8_t)message | LINK_ANSWER))
        return false;
    h->result = (SmResult)(int8_t)b[LINK_HEAD];
    h->body = b + LINK_HEAD + 1;
    h->n = h->in.n - LINK_HEAD - 1u;
    return true;
}

// Receives until the answer is complete (then returns true), the timeout is over or the line is closed.  Reads byte by byte, so that bytes
// after an answer stay on the line.
static bool wait_for_answer(LinkHost *h, LinkMessage message)
{
    const uint32_t start = h->line->now(h->line->context);
    uint32_t elapsed = 0;
    uint8_t byte;

    while (elapsed < h->wait) {
        const int n = h->line->receive(h->line->context, &byte, 1, h->wait - elapsed);
        if (n < 0) {
            h->gone = true;
            return false;
        }
        if (n == 1 && sm_link_receive(&h->in, byte) && accept_answer(h, message))
            return true;
        elapsed = h->line->now(h->line->context) - start;
    }
    return false;
}

// Sends a request with a body of n bytes.  True: it was answered, with h->result and h->body.  False: no answer within all tries, or the
// line is closed.
bool link_request(LinkHost *h, LinkMessage message, const uint8_t *body, size_t n)
{
    uint8_t frame[LINK_ROOM(LINK_BODY_MAX) + 1] = {0};           // begins with a zero, which ends noise before the frame
    uint16_t length;

    h->answered = false;
    if (n > LINK_BODY_MAX)
        return false;
    h->sequence++;
    frame[2] = h->sequence;
    frame[3] = (uint8_t)message;
    if (n > 0)
        memcpy(frame + 4, body, n);
    length = sm_link_encode(frame + 1, (uint16_t)(LINK_HEAD + n));
    for (unsigned i = 0; i < h->tries && !h->gone && !h->answered; i++) {
        if (!h->line->send(h->line->context, frame, length + 1u))
            h->gone = true;
        else if (wait_for_answer(h, message))
            h->answered = true;
    }
    return h->answered;
}
