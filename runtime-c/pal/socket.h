// SPDX-License-Identifier: Apache-2.0
// Sockets over IPv4: datagrams (UDP) for telemetry, where the newest counts; streams (TCP) for commands, where all counts.
// One thread may send on a socket while another receives.  (Rules for all of these headers: pal.h.)
//
// A datagram arrives whole or not at all, perhaps twice, perhaps after a later one; whoever needs more numbers them.  A stream
// has no borders between what was sent: two sends may arrive as one receive, or as three.
#ifndef PAL_SOCKET_H
#define PAL_SOCKET_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalSocket { uint8_t id; } PalSocket;

typedef struct PalAddress {
    uint8_t ip[4];            // as it is written: 192.168.0.7 is {192, 168, 0, 7}.  As one's own: {0, 0, 0, 0} is any
    uint16_t port;            // as one's own: 0 lets the platform choose
} PalAddress;

#define PAL_DATAGRAM_MAX 1472 // bytes that go into one Ethernet frame; a platform need not do more

// ---- datagrams ----

// A socket for datagrams at the address `own` of this computer.  It may send to broadcast addresses.
// SM_E_BUSY: the port is in use.  SM_E_MISSING: this computer has no such address.  SM_E_DENIED: not permitted.  SM_E_FULL.
SmResult pal_socket_udp(PalSocket *socket, const PalAddress *own);

// Hands n bytes, 0 to PAL_DATAGRAM_MAX, to the network as one datagram.  Never waits.  SM_OK does not mean that it arrives.
// SM_E_BUSY: the network takes no more now; the datagram is lost.  SM_E_UNREACHABLE: there is no way to that address.
// SM_E_ARGUMENT: too long, or the socket is for streams.
SmResult pal_socket_send_to(PalSocket socket, const PalAddress *to, const void *bytes, size_t n);

// The next datagram: *n bytes (which may be 0) and, where from is not NULL, who sent it.  SM_E_TIMEOUT: none came.
// SM_E_SIZE: it was longer than `room`: the first `room` bytes are filled in, *n is `room`, the rest is lost.
// SM_E_ARGUMENT: the socket is for streams.
SmResult pal_socket_receive_from(PalSocket socket, PalAddress *from, void *bytes, size_t room, size_t *n, uint64_t timeout);

// ---- streams ----

// Listens for streams at the address `own`.  Results as of pal_socket_udp.
SmResult pal_socket_listen(PalSocket *socket, const PalAddress *own);

// The next stream that somebody connected; `peer`, where it is not NULL, says who.  The new socket is closed on its own.
// SM_E_TIMEOUT: nobody did.  SM_E_FULL: no entry left; who connected waits on.  SM_E_ARGUMENT: the socket does not listen.
SmResult pal_socket_accept(PalSocket listening, PalSocket *stream, PalAddress *peer, uint64_t timeout);

// Connects to somebody who listens.  SM_E_UNREACHABLE: nobody listens there, or there is no way.  SM_E_TIMEOUT: no answer.
// SM_E_FULL.
SmResult pal_socket_connect(PalSocket *stream, const PalAddress *to, uint64_t timeout);

// Hands n bytes to the stream.  SM_OK: all are in the platform's hands; it does not mean that they arrived.  SM_E_TIMEOUT: the
// first *sent bytes are.  SM_E_CLOSED: the peer is gone.  *sent is filled in whatever the result.  SM_E_ARGUMENT: not a stream.
SmResult pal_socket_send(PalSocket stream, const void *bytes, size_t n, size_t *sent, uint64_t timeout);

// Fills `bytes` with what has arrived, 1 to `room` bytes, as soon as there is any; *n says how many.  room: 1 or more.
// SM_E_TIMEOUT: nothing came.  SM_E_CLOSED: the peer has closed, and all that it sent has been received; or it is gone.
// SM_E_ARGUMENT: not a stream.
SmResult pal_socket_receive(PalSocket stream, void *bytes, size_t room, size_t *n, uint64_t timeout);

// ---- all ----

// The address at this end, with the port that the platform chose.
SmResult pal_socket_own(PalSocket socket, PalAddress *own);

// Closes it.  A stream's peer still receives what was sent before, if the network lets it.
SmResult pal_socket_close(PalSocket socket);

#ifdef __cplusplus
}
#endif
#endif
