// SPDX-License-Identifier: Apache-2.0
// Sockets over IPv4: datagrams (UDP) for telemetry, where only the newest value matters; streams (TCP) for commands, where every
// byte matters.  Streams also exist between programs of one computer, by the path of a file.  One thread may send on a socket while
// another receives.  (Rules for all of these headers: pal.h.)
//
// A datagram arrives whole or not at all.  It may arrive twice, or after a later one.  A sender that must detect this numbers its
// datagrams.  A stream does not preserve message boundaries: two sends may arrive as one receive, or as three.
#ifndef PAL_SOCKET_H
#define PAL_SOCKET_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalSocket { uint8_t id; } PalSocket;

typedef struct PalAddress {
    uint8_t ip[4];            // in written order: 192.168.0.7 is {192, 168, 0, 7}.  As a local address, {0, 0, 0, 0} is any
    uint16_t port;            // as a local port, 0 lets the platform choose
} PalAddress;

#define PAL_DATAGRAM_MAX 1472 // bytes that fit into one Ethernet frame; platforms need not support more

#define PAL_SOCKET_PATH 107   // most characters of a path

// ---- datagrams ----

// Creates a UDP socket at the address `local`.  It may send to broadcast addresses.  SM_E_BUSY: the port is in use.
// SM_E_MISSING: the computer does not have this address.  SM_E_DENIED: no permission.  SM_E_FULL: the table has no free entry.
SmResult pal_socket_udp(PalSocket *socket, const PalAddress *local);

// Makes a UDP socket use multicast on the network interface with the address `interface`; {0, 0, 0, 0} lets the platform choose.  If `group`
// is not NULL, the socket receives what is sent to that group, 224.0.0.0 to 239.255.255.255; open it with the group as local address.
// Datagrams that it sends to a group leave by that interface.  SM_E_MISSING: there is no such interface.  SM_E_ARGUMENT: not a group, or
// the socket is a stream.
SmResult pal_socket_multicast(PalSocket socket, const uint8_t *group, const uint8_t *interface);

// Sends n bytes, 0 to PAL_DATAGRAM_MAX, as one datagram.  Never waits.  SM_OK does not mean that the datagram arrives.
//     SM_E_BUSY          the network cannot accept more now; the datagram is lost
//     SM_E_UNREACHABLE   there is no route to the address
//     SM_E_ARGUMENT      n is too large, or the socket is a stream
SmResult pal_socket_send_to(PalSocket socket, const PalAddress *to, const void *bytes, size_t n);

// Receives the next datagram: *n bytes, which may be 0.  If `from` is not NULL, it receives the sender's address.
//     SM_E_TIMEOUT       none arrived
//     SM_E_SIZE          it was longer than `room`: the first `room` bytes are filled in, *n is `room`, the rest is lost
//     SM_E_ARGUMENT      the socket is a stream
SmResult pal_socket_receive_from(PalSocket socket, PalAddress *from, void *bytes, size_t room, size_t *n, uint64_t timeout);

// ---- streams ----

// Listens for streams at the address `local`.  Results as for pal_socket_udp.
SmResult pal_socket_listen(PalSocket *socket, const PalAddress *local);

// Listens for streams of programs on the same computer, at a path of its file system.  Only the user of the program can connect: the file
// has mode 0600.  A socket that a program has left there is replaced, if it no longer runs.  pal_socket_close removes the file.  Of
// several programs that call this with the same path at the same instant, one succeeds; the others wait for at most a few seconds.
//     SM_E_BUSY          a program listens there, and has received a stream that is closed at once
//     SM_E_FOREIGN       there is a file that is not a socket
//     SM_E_MISSING       the folder does not exist
//     SM_E_DENIED        no permission
//     SM_E_ARGUMENT      the path is empty, or has more than PAL_SOCKET_PATH characters
//     SM_E_FULL          the table has no free entry
SmResult pal_socket_listen_local(PalSocket *socket, const char *path);

// Accepts the next incoming stream.  If `peer` is not NULL, it receives the peer's address, or zeros from a path.  The caller must close the new
// socket separately.  A stream that broke before it could be accepted is skipped.
//     SM_E_TIMEOUT       no peer connected
//     SM_E_FULL          the table has no free entry; the peer stays in the queue
//     SM_E_ARGUMENT      the socket is not a listening socket
SmResult pal_socket_accept(PalSocket listening, PalSocket *stream, PalAddress *peer, uint64_t timeout);

// Connects to a listening socket.  SM_E_UNREACHABLE: no socket listens there, or there is no route.  SM_E_TIMEOUT: no answer.
// SM_E_FULL: the table has no free entry.
SmResult pal_socket_connect(PalSocket *stream, const PalAddress *to, uint64_t timeout);

// Begins to connect to a listening socket, and does not wait.  SM_OK: the caller owns a socket that is connecting; until
// pal_socket_connected returns SM_OK, only that function and pal_socket_close accept it.  A failure may be reported here or by pal_socket_connected:
// SM_E_UNREACHABLE: no socket listens there, or there is no route.  SM_E_FULL: the table has no free entry.
SmResult pal_socket_connect_start(PalSocket *stream, const PalAddress *to);

// Returns whether a socket from pal_socket_connect_start is connected by now, and does not wait.  After any result but SM_OK and
// SM_E_TIMEOUT, the caller closes the socket.
//     SM_OK              the socket is connected: a stream.  So is every stream from pal_socket_connect and pal_socket_accept
//     SM_E_TIMEOUT       not yet; the platform ends the attempt after minutes, so a caller that cannot wait so long closes the socket
//     SM_E_UNREACHABLE   no socket listens there, or there is no route
//     SM_E_ARGUMENT      not a stream
SmResult pal_socket_connected(PalSocket stream);

// Bounds what a stream stores for a peer that does not receive.  The platform accepts no more than about `room` bytes that the peer's
// computer has not acknowledged; platforms round up, Linux to a few kilobytes.  If bytes are not acknowledged for `patience` nanoseconds,
// 1 ms to PAL_TIMEOUT_MAX, the stream breaks, where the platform can notice that.  `room` is from 1 byte to 1 MiB.  SM_E_ARGUMENT: not a stream, or a
// number is out of range.
SmResult pal_socket_limit(PalSocket stream, size_t room, uint64_t patience);

// Sends n bytes on a stream.  SM_OK: the platform has accepted all bytes, which does not mean that they arrived.  SM_E_TIMEOUT:
// only the first *sent bytes were accepted.  SM_E_CLOSED: the peer has disconnected.  SM_E_ARGUMENT: not a stream. *sent is always
// filled in, whatever the result.
SmResult pal_socket_send(PalSocket stream, const void *bytes, size_t n, size_t *sent, uint64_t timeout);

// Receives 1 to `room` bytes, as soon as any are available, and stores their count in *n.  `room` must be 1 or more.  SM_E_TIMEOUT:
// no byte arrived.  SM_E_CLOSED: the connection is broken, or the peer has closed it and everything it sent has been received.
// SM_E_ARGUMENT: not a stream.
SmResult pal_socket_receive(PalSocket stream, void *bytes, size_t room, size_t *n, uint64_t timeout);

// ---- all ----

// Stores the local address of the socket in *local, with the port that the platform chose.  SM_E_UNSUPPORTED: it has a path.
SmResult pal_socket_local_address(PalSocket socket, PalAddress *local);

// Closes the socket.  The peer of a stream still receives bytes sent earlier, if the network delivers them.
SmResult pal_socket_close(PalSocket socket);

#ifdef __cplusplus
}
#endif
#endif
