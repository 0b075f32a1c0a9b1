// SPDX-License-Identifier: Apache-2.0
// Between net.c and net_stream.c: the connections of messages over TCP (config.md 11.21 to 11.25).  A channel is a client with one connection,
// or a server with several.  A connection carries messages in one direction, without gaps.  As all messages of a channel have one size, the
// receiver knows where each ends; if its bytes are wrong there, the connection is of no further use and is closed.
//
// No function waits.  Each makes a number of system calls that the tables bound, whatever the peer does.  Times are those of ticks.
#ifndef SM_NET_STREAM_H
#define SM_NET_STREAM_H

#include "runtime-c/net.h"

struct SmNetStream {
    // A server listens; a client begins to connect.  A peer that cannot be reached now is no error.  SM_E_ARGUMENT: the rows are inconsistent.
    SmResult (*open)(SmNetChannel *c);
    void (*close)(SmNetChannel *c);

    // Accepts or continues to connect, and ends connections that have been silent for too long.  Then receives the messages of each
    // connection, at most SM_NET_BURST; or continues messages that were sent in part, and if c->due, sends c->bytes to each peer.  Counts
    // what becomes of them.  Returns failures of this computer only.
    SmResult (*receive)(SmNetChannel *c, uint64_t now);
    SmResult (*send)(SmNetChannel *c, uint64_t now);
};

// Checks n bytes that were received as one message, and counts them.  If the result is SM_NET_accepted, c->value has its values.
SmNetCount sm_net_accept(SmNetChannel *c, const uint8_t *bytes, size_t n, uint64_t now);

#endif
