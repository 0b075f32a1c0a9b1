// SPDX-License-Identifier: Apache-2.0
// Data in transit between simulated sockets: datagrams and streams.  (The sockets: socket.c.)
#ifndef PSL_SIM_NETWORK_H
#define PSL_SIM_NETWORK_H

#include "runtime-c/psl/sim/world.h"

typedef struct SimDatagram {
    bool used;
    uint64_t arrives, order;  // clock time; sequence number, for datagrams that arrive at the same time
    PalAddress from, to;
    size_t n;
    uint8_t bytes[PAL_DATAGRAM_MAX];
} SimDatagram;

void sim_datagrams_reset(void);

// Sends a datagram, subject to the faults of SimNetwork.  Returns false if there are too many in transit; the datagram is lost.
bool sim_datagram_send(const SimDatagram *d);

// Returns the next datagram for an address, or NULL.  The caller clears `used` after reading it.
SimDatagram *sim_datagram_next(const PalAddress *at);

// Whether a message to `to` reaches a socket at `local`.
bool sim_reaches(const PalAddress *to, const PalAddress *local);

// ---- streams ----

#define SIM_STREAM_ROOM 8192u

typedef struct SimStream {
    bool used;
    bool open[2];             // whether each end is open: 0 the connecting one, 1 the accepting one
    uint8_t listening;        // the listening socket that has not accepted it yet; 0: none
    uint64_t order;
    PalAddress address[2];
    size_t n[2], room[2];     // by end: bytes in transit to it, and the most that the other end may have in transit
    uint8_t bytes[2][SIM_STREAM_ROOM];
} SimStream;

void sim_streams_reset(void);
const SimStreams *sim_stream_faults(void);

// Returns a new stream with end 0 open, or NULL if the table is full.
SimStream *sim_stream_new(uint8_t listening);

// Returns the oldest stream that waits for that listening socket, or NULL.
SimStream *sim_stream_waiting(uint8_t listening);

// Send bytes to an end, as many as fit; receive bytes that arrived at an end.  Both return their number.
size_t sim_stream_send(SimStream *s, int end, const void *bytes, size_t n);
size_t sim_stream_receive(SimStream *s, int end, void *bytes, size_t room);

// Closes an end; frees the stream when both are closed.
void sim_stream_close(SimStream *s, int end);

// Called when a listening socket is closed: drops the streams that wait for it.
void sim_streams_drop(uint8_t listening);

#endif
