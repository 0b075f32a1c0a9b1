// SPDX-License-Identifier: Apache-2.0
// The connections of messages over TCP (config.md 11.21 to 11.25), for net.c alone.  A channel is a client with one connection, or a server
// with several.  A connection carries messages in one direction, without gaps.  As all messages of a channel have one size, the receiver
// knows where each ends; if its first bytes are wrong there, the connection is of no further use and is closed.
//
// No call waits.  Each makes a number of system calls that the tables bound, whatever the peer does.  Times are those of ticks.
#ifndef SM_NET_STREAM_H
#define SM_NET_STREAM_H

#include "runtime-c/net.h"

// A server listens; a client begins to connect.  A peer that cannot be reached now is no error.  SM_E_ARGUMENT: the rows are inconsistent.
SmResult sm_stream_open(SmNetChannel *c);

void sm_stream_close(SmNetChannel *c);

// Accepts or continues to connect, continues messages that were sent in part, and ends connections that have been silent for too long.
// Returns failures of this computer only.
SmResult sm_stream_update(SmNetChannel *c, uint64_t now);

// Receives bytes of a connection once.  Returns whether there is something to count, which *cause receives:
//     SM_NET_accepted    p->bytes has a whole message, which the caller checks and passes to sm_stream_judged
//     any other cause    the connection was closed: it ended inside a message, or its bytes cannot be a message of this channel
bool sm_stream_receive(SmNetChannel *c, SmNetPeer *p, SmNetCount *cause, uint64_t now);

// Closes the connection if a message of it was refused for a cause that only another sender or damage explains.
void sm_stream_judged(SmNetChannel *c, SmNetPeer *p, SmNetCount cause, uint64_t now);

// Sends c->bytes to each peer, and counts what becomes of it.
void sm_stream_send(SmNetChannel *c, uint64_t now);

#endif
