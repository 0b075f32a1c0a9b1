// SPDX-License-Identifier: Apache-2.0
// What is under way between simulated sockets: datagrams in the air, streams in their queues.  socket.c holds the sockets.
#ifndef PSL_SIM_NETWORK_H
#define PSL_SIM_NETWORK_H

#include "runtime-c/psl/sim/world.h"

typedef struct Datagram {
    bool used;
    uint64_t arrives, order;
    PalAddress from, to;
    size_t n;
    uint8_t bytes[PAL_DATAGRAM_MAX];
} Datagram;

void sim_air_reset(void);

// Sends a datagram through the air, with what may happen to it there.  False: the air is full; it is lost.
bool sim_air_send(const Datagram *d);

// The next to arrive at an address, or NULL.  The caller clears `used` when it has taken it.
Datagram *sim_air_next(const PalAddress *at);

// Whether what is sent to `to` comes to a socket at `own`.
bool sim_reaches(const PalAddress *to, const PalAddress *own);

// ---- streams ----

#define SIM_STREAM_ROOM 8192u

typedef struct Stream {
    bool used;
    bool open[2];             // its ends: 0 connected, 1 accepted
    uint8_t listening;        // the socket that has not accepted it yet; 0: none
    uint64_t order;
    PalAddress address[2];
    size_t n[2];              // bytes on their way to each end
    uint8_t bytes[2][SIM_STREAM_ROOM];
} Stream;

void sim_streams_reset(void);

// A new stream with its near end open, or NULL if there is no room.
Stream *sim_stream_new(uint8_t listening);

// The oldest that waits for that socket, or NULL.
Stream *sim_stream_waiting(uint8_t listening);

// Puts bytes on their way to an end, as many as fit; takes those that have come there.
size_t sim_stream_put(Stream *s, int end, const void *bytes, size_t n);
size_t sim_stream_take(Stream *s, int end, void *bytes, size_t room);

// Closes an end; frees the stream with the last one.
void sim_stream_close(Stream *s, int end);

// The listening socket is gone: so are those that wait for it.
void sim_streams_forget(uint8_t listening);

#endif
