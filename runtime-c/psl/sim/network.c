// SPDX-License-Identifier: Apache-2.0
// Data in transit between simulated sockets.
#include <string.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/sim/network.h"

#define DATAGRAMS_IN_TRANSIT 64

static SimDatagram in_transit[DATAGRAMS_IN_TRANSIT], held;     // held: the one held back for reordering
static SimNetwork network;
static uint32_t sent;
static uint64_t order;

void sim_datagrams_reset(void)
{
    const SimNetwork perfect = {0, 0, 0, 0};

    memset(in_transit, 0, sizeof in_transit);
    held.used = false;
    sim_network(perfect);
    order = 0;
}

// Sets the faults of the network from now on.
void sim_network(SimNetwork n)
{
    network = n;
    sent = 0;
}

// Whether a fault that affects one of `every` datagrams affects the current one.
static bool is_fault_due(uint32_t every)
{
    return every != 0 && sent % every == 0;
}

// Puts a copy of the datagram in transit.  Returns false if there is no space.
static bool enqueue(const SimDatagram *d)
{
    for (size_t i = 0; i < DATAGRAMS_IN_TRANSIT; i++)
        if (!in_transit[i].used) {
            in_transit[i] = *d;
            in_transit[i].used = true;
            in_transit[i].arrives = pal_clock_now() + network.delay;
            in_transit[i].order = order++;
            return true;
        }
    return false;
}

// Enqueues the datagram that was held back for reordering.  Returns false if there was none or no space.
static bool enqueue_held(void)
{
    bool was = held.used;

    held.used = false;
    return was && enqueue(&held);
}

// Sends a datagram, subject to the faults of SimNetwork.  Returns false if too many are in transit; the datagram is lost.
bool sim_datagram_send(const SimDatagram *d)
{
    bool accepted = true;

    sent++;
    if (is_fault_due(network.reorder) && !held.used) {     // held back until the next one is sent
        held = *d;
        held.used = true;
        return true;
    }
    if (!is_fault_due(network.lose))
        accepted = enqueue(d);
    if (is_fault_due(network.repeat))
        accepted = enqueue(d) && accepted;
    enqueue_held();
    return accepted;
}

// Whether a message to `to` reaches a socket at `local`.
bool sim_reaches(const PalAddress *to, const PalAddress *local)
{
    const uint8_t any[4] = {0, 0, 0, 0};

    return to->port == local->port && (memcmp(local->ip, any, 4) == 0 || memcmp(local->ip, to->ip, 4) == 0);
}

// Returns the datagram for a socket at that address that arrives first; NULL if no datagram waits for it.
static SimDatagram *find_earliest(const PalAddress *at)
{
    SimDatagram *next = NULL;

    for (SimDatagram *d = in_transit; d < in_transit + DATAGRAMS_IN_TRANSIT; d++)
        if (d->used && sim_reaches(&d->to, at))
            if (!next || d->arrives < next->arrives || (d->arrives == next->arrives && d->order < next->order))
                next = d;
    return next;
}

// If nothing is in transit, the datagram held back for reordering is delivered, because no later one may follow.
SimDatagram *sim_datagram_next(const PalAddress *at)
{
    SimDatagram *next = find_earliest(at);

    return !next && enqueue_held() ? find_earliest(at) : next;
}

// ---- streams ----

static SimStream streams[PAL_SOCKETS];
static SimStreams faults;

void sim_streams_reset(void)
{
    const SimStreams perfect = {0, 0, 0};

    memset(streams, 0, sizeof streams);
    faults = perfect;
}

// Sets the faults of all streams from now on.
void sim_streams(SimStreams s) { faults = s; }

const SimStreams *sim_stream_faults(void) { return &faults; }

// Limits n to the most bytes that a call transfers.
static size_t limit_to(size_t n, uint32_t most) { return most != 0 && n > most ? most : n; }

// Returns a new stream with end 0 open, or NULL if the table is full.
SimStream *sim_stream_new(uint8_t listening)
{
    for (SimStream *s = streams; s < streams + PAL_SOCKETS; s++)
        if (!s->used) {
            memset(s, 0, sizeof *s);
            s->used = s->open[0] = true;
            s->listening = listening;
            s->order = order++;
            s->room[0] = s->room[1] = SIM_STREAM_ROOM;
            return s;
        }
    return NULL;
}

// Returns the oldest stream that waits for that listening socket, or NULL.
SimStream *sim_stream_waiting(uint8_t listening)
{
    SimStream *oldest = NULL;

    for (SimStream *s = streams; s < streams + PAL_SOCKETS; s++)
        if (s->used && s->listening == listening && (!oldest || s->order < oldest->order))
            oldest = s;
    return oldest;
}

// Sends bytes to an end, as many as fit.  Returns their number.
size_t sim_stream_send(SimStream *s, int end, const void *bytes, size_t n)
{
    const size_t room = s->n[end] < s->room[end] ? s->room[end] - s->n[end] : 0, taken = limit_to(n < room ? n : room, faults.send);

    memcpy(s->bytes[end] + s->n[end], bytes, taken);
    s->n[end] += taken;
    return taken;
}

// Receives bytes that have arrived at an end.  Returns their number.
size_t sim_stream_receive(SimStream *s, int end, void *bytes, size_t room)
{
    const size_t n = limit_to(s->n[end] < room ? s->n[end] : room, faults.receive);

    memcpy(bytes, s->bytes[end], n);
    s->n[end] -= n;
    memmove(s->bytes[end], s->bytes[end] + n, s->n[end]);
    return n;
}

static void free_if_unused(SimStream *s)
{
    s->used = s->open[0] || s->open[1] || s->listening != 0;
}

// Closes an end; frees the stream when both are closed.
void sim_stream_close(SimStream *s, int end)
{
    s->open[end] = false;
    free_if_unused(s);
}

// Called when a listening socket is closed: drops the streams that wait for it.
void sim_streams_drop(uint8_t listening)
{
    for (SimStream *s = streams; s < streams + PAL_SOCKETS; s++)
        if (s->used && s->listening == listening) {
            s->listening = 0;
            free_if_unused(s);
        }
}
