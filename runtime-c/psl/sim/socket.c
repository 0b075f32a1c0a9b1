// SPDX-License-Identifier: Apache-2.0
// Simulated sockets.  The simulated computer has the addresses 127.x.x.x and 10.x.x.x.  A test simulates the other computers
// itself.
#include <string.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/sim/network.h"

#define FIRST_PORT 49152u

typedef enum SimSocketKind { DATAGRAMS, LISTENING, CONNECTING, STREAM } SimSocketKind;

typedef struct SimSocket {
    SimSocketKind kind;
    PalAddress local;
    SimStream *stream;
    int end;                  // which end of `stream` this socket is
    PalAddress to;            // CONNECTING: the address, and the time at which its answer arrives
    uint64_t answer;
} SimSocket;

static bool used[PAL_SOCKETS];
static SimSocket entries[PAL_SOCKETS];

void sim_socket_reset(void)
{
    memset(used, 0, sizeof used);
    sim_datagrams_reset();
    sim_streams_reset();
}

// ---- addresses ----

static bool is_any_address(const PalAddress *a)
{
    return (a->ip[0] | a->ip[1] | a->ip[2] | a->ip[3]) == 0;
}

static bool is_group(const PalAddress *a) { return a->ip[0] >= 224 && a->ip[0] <= 239; }

static bool is_port_taken(const PalAddress *a, SimSocketKind kind)
{
    for (uint8_t i = 0; i < PAL_SOCKETS; i++)
        if (used[i] && entries[i].kind == kind && entries[i].local.port == a->port &&
            (is_any_address(a) || is_any_address(&entries[i].local) || memcmp(a->ip, entries[i].local.ip, 4) == 0))
            return true;
    return false;
}

// Checks that the address is one of this computer and its port is free.  Chooses a free port for port 0.
static SmResult choose_port(PalAddress *a, SimSocketKind kind)
{
    if (!is_any_address(a) && a->ip[0] != 127 && a->ip[0] != 10 && !(is_group(a) && kind == DATAGRAMS))
        return SM_E_MISSING;
    if (a->port != 0)
        return is_port_taken(a, kind) ? SM_E_BUSY : SM_OK;
    a->port = FIRST_PORT;
    while (is_port_taken(a, kind))                              // the loop ends: there are more ports than sockets
        a->port++;
    return SM_OK;
}

// Returns the sender address that others see, which is never "any".
static PalAddress visible_address(const PalAddress *local)
{
    PalAddress a = *local;

    if (is_any_address(local)) {
        a.ip[0] = 127;
        a.ip[3] = 1;
    }
    return a;
}

// ---- opening ----

// Takes an entry for a socket at `local`, or returns the reason for the failure.
static SmResult open_socket(PalSocket *s, SimSocketKind kind, const PalAddress *local)
{
    PalAddress a = *local;
    SmResult r = choose_port(&a, kind);
    uint8_t id;

    if (r != SM_OK)
        return r;
    id = psl_table_allocate(used, PAL_SOCKETS);
    if (id == 0)
        return SM_E_FULL;
    memset(&entries[id - 1], 0, sizeof entries[0]);
    entries[id - 1].kind = kind;
    entries[id - 1].local = a;
    s->id = id;
    return SM_OK;
}

static bool is_table_full(void)
{
    for (uint8_t i = 0; i < PAL_SOCKETS; i++)
        if (!used[i])
            return false;
    return true;
}

SmResult pal_socket_udp(PalSocket *s, const PalAddress *local)
{
    SmResult r;

    if (!s || !local)
        return SM_E_ARGUMENT;
    r = sim_begin_call(SIM_socket_udp);
    return r == SM_OK ? open_socket(s, DATAGRAMS, local) : r;
}

SmResult pal_socket_listen(PalSocket *s, const PalAddress *local)
{
    SmResult r;

    if (!s || !local)
        return SM_E_ARGUMENT;
    r = sim_begin_call(SIM_socket_listen);
    return r == SM_OK ? open_socket(s, LISTENING, local) : r;
}

// The simulated computer has no paths.
SmResult pal_socket_listen_local(PalSocket *s, const char *path)
{
    return s && path && *path != '\0' && strlen(path) <= PAL_SOCKET_PATH ? SM_E_UNSUPPORTED : SM_E_ARGUMENT;
}

// Returns the handle number of the socket that listens at the address; 0 if no socket listens there.
static uint8_t find_listening(const PalAddress *to)
{
    for (uint8_t i = 0; i < PAL_SOCKETS; i++)
        if (used[i] && entries[i].kind == LISTENING && sim_reaches(to, &entries[i].local))
            return (uint8_t)(i + 1);
    return 0;
}

// Connects the socket e by a stream to the socket that listens at e->to.
static SmResult connect_to_listener(SimSocket *e)
{
    const uint8_t listening = find_listening(&e->to);
    SimStream *s;

    if (listening == 0)
        return SM_E_UNREACHABLE;
    s = sim_stream_new(listening);
    if (!s)
        return SM_E_FULL;
    s->address[0] = e->local;
    s->address[1] = e->to;
    e->stream = s;
    e->kind = STREAM;
    return SM_OK;
}

// Takes an entry for a socket that connects to `to`.
static SmResult open_connecting(PalSocket *stream, const PalAddress *to)
{
    const PalAddress local = {{127, 0, 0, 1}, 0};
    const SmResult r = open_socket(stream, CONNECTING, &local);

    if (r == SM_OK)
        entries[stream->id - 1].to = *to;
    return r;
}

SmResult pal_socket_connect(PalSocket *stream, const PalAddress *to, uint64_t timeout)
{
    PalSocket s = {0};
    SmResult r;

    if (!stream || !to || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = sim_begin_call(SIM_socket_connect);
    if (r == SM_OK)
        r = open_connecting(&s, to);
    if (r != SM_OK)
        return r;
    r = connect_to_listener(&entries[s.id - 1]);
    if (r != SM_OK)
        used[s.id - 1] = false;
    else
        *stream = s;
    return r;
}

SmResult pal_socket_connect_start(PalSocket *stream, const PalAddress *to)
{
    SmResult r;

    if (!stream || !to)
        return SM_E_ARGUMENT;
    r = sim_begin_call(SIM_socket_connect_start);
    if (r == SM_OK)
        r = open_connecting(stream, to);
    if (r == SM_OK)
        entries[stream->id - 1].answer = pal_clock_now() + sim_stream_faults()->connect;
    return r;
}

// ---- checking handles ----

// Stores the entry of an open socket in *e.  SM_E_ARGUMENT: it is of another kind.
static SmResult find_socket(PalSocket s, SimSocketKind kind, SimSocket **e)
{
    if (!psl_table_is_used(used, PAL_SOCKETS, s.id))
        return SM_E_HANDLE;
    *e = &entries[s.id - 1];
    return (*e)->kind == kind ? SM_OK : SM_E_ARGUMENT;
}

SmResult pal_socket_connected(PalSocket stream)
{
    SimSocket *e;
    SmResult r = find_socket(stream, STREAM, &e);

    if (r != SM_E_ARGUMENT)
        return r;
    r = find_socket(stream, CONNECTING, &e);
    if (r == SM_OK)
        r = sim_begin_call(SIM_socket_connected);
    if (r != SM_OK)
        return r;
    return pal_clock_now() < e->answer ? SM_E_TIMEOUT : connect_to_listener(e);
}

// The simulation does not notice that bytes are not acknowledged: a peer is open or closed.
SmResult pal_socket_limit(PalSocket stream, size_t room, uint64_t patience)
{
    SimSocket *e;
    SmResult r;

    if (room == 0 || room > 1u << 20 || patience < PAL_MILLISECOND || patience > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(stream, STREAM, &e);
    if (r == SM_OK)
        r = sim_begin_call(SIM_socket_limit);
    if (r == SM_OK)
        e->stream->room[!e->end] = room < SIM_STREAM_ROOM ? room : SIM_STREAM_ROOM;
    return r;
}

SmResult pal_socket_accept(PalSocket listening, PalSocket *stream, PalAddress *peer, uint64_t timeout)
{
    const uint64_t deadline = pal_clock_now() + timeout;
    SimStream *s = NULL;
    SimSocket *e;
    SmResult r;

    if (!stream || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(listening, LISTENING, &e);
    if (r == SM_OK)
        r = is_table_full() ? SM_E_FULL : sim_begin_call(SIM_socket_accept);
    if (r != SM_OK)
        return r;
    while (r == SM_OK && (s = sim_stream_waiting(listening.id)) == NULL)
        r = sim_wait(deadline) ? find_socket(listening, LISTENING, &e) : SM_E_TIMEOUT;
    if (r == SM_OK && is_table_full())                     // the function set by sim_every has taken the last entry
        r = SM_E_FULL;
    if (r != SM_OK)
        return r;
    stream->id = psl_table_allocate(used, PAL_SOCKETS);
    e = &entries[stream->id - 1];
    e->kind = STREAM;
    e->local = s->address[1];
    e->stream = s;
    e->end = 1;
    s->open[1] = true;
    s->listening = 0;
    if (peer)
        *peer = s->address[0];
    return SM_OK;
}

// ---- datagrams ----

SmResult pal_socket_multicast(PalSocket s, const uint8_t *group, const uint8_t *interface)
{
    SimSocket *e;
    SmResult r;

    if (!interface || (group && (group[0] < 224 || group[0] > 239)))
        return SM_E_ARGUMENT;
    r = find_socket(s, DATAGRAMS, &e);
    if (r == SM_OK)
        r = sim_begin_call(SIM_socket_multicast);
    if (r == SM_OK && (interface[0] | interface[1] | interface[2] | interface[3]) != 0 && interface[0] != 127 && interface[0] != 10)
        r = SM_E_MISSING;
    return r;
}

SmResult pal_socket_send_to(PalSocket s, const PalAddress *to, const void *bytes, size_t n)
{
    SimDatagram d;
    SimSocket *e;
    SmResult r;

    if (!to || !bytes || n > PAL_DATAGRAM_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(s, DATAGRAMS, &e);
    if (r == SM_OK)
        r = sim_begin_call(SIM_socket_send_to);
    if (r != SM_OK)
        return r;
    memset(&d, 0, sizeof d);
    d.from = visible_address(&e->local);
    d.to = *to;
    d.n = n;
    memcpy(d.bytes, bytes, n);
    return sim_datagram_send(&d) ? SM_OK : SM_E_BUSY;
}

static SmResult deliver_datagram(SimDatagram *d, PalAddress *from, void *bytes, size_t room, size_t *n)
{
    *n = d->n < room ? d->n : room;
    memcpy(bytes, d->bytes, *n);
    if (from)
        *from = d->from;
    d->used = false;
    return d->n > room ? SM_E_SIZE : SM_OK;
}

SmResult pal_socket_receive_from(PalSocket s, PalAddress *from, void *bytes, size_t room, size_t *n, uint64_t timeout)
{
    const uint64_t deadline = pal_clock_now() + timeout;
    SimDatagram *d = NULL;
    SimSocket *e;
    SmResult r;

    if (!bytes || !n || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(s, DATAGRAMS, &e);
    if (r == SM_OK)
        r = sim_begin_call(SIM_socket_receive_from);
    while (r == SM_OK && ((d = sim_datagram_next(&e->local)) == NULL || d->arrives > pal_clock_now()))
        r = sim_wait(d && d->arrives < deadline ? d->arrives : deadline) ? find_socket(s, DATAGRAMS, &e) : SM_E_TIMEOUT;
    return r == SM_OK ? deliver_datagram(d, from, bytes, room, n) : r;
}

// ---- streams ----

// Whether the peer has closed its end.
static bool has_peer_closed(const SimSocket *e)
{
    return !e->stream->open[!e->end] && e->stream->listening == 0;
}

SmResult pal_socket_send(PalSocket stream, const void *bytes, size_t n, size_t *sent, uint64_t timeout)
{
    const uint64_t deadline = pal_clock_now() + timeout;
    const uint8_t *next = bytes;
    SimSocket *e;
    SmResult r;

    if (sent)
        *sent = 0;
    if (!bytes || !sent || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(stream, STREAM, &e);
    if (r == SM_OK)
        r = sim_begin_call(SIM_socket_send);
    while (r == SM_OK) {
        if (has_peer_closed(e))
            return SM_E_CLOSED;
        *sent += sim_stream_send(e->stream, !e->end, next + *sent, n - *sent);
        if (*sent == n)
            break;
        r = sim_wait(deadline) ? find_socket(stream, STREAM, &e) : SM_E_TIMEOUT;
    }
    return r;
}

SmResult pal_socket_receive(PalSocket stream, void *bytes, size_t room, size_t *n, uint64_t timeout)
{
    const uint64_t deadline = pal_clock_now() + timeout;
    SimSocket *e;
    SmResult r;

    if (!bytes || !n || room == 0 || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    r = find_socket(stream, STREAM, &e);
    if (r == SM_OK)
        r = sim_begin_call(SIM_socket_receive);
    while (r == SM_OK) {
        const size_t got = sim_stream_receive(e->stream, e->end, bytes, room);

        if (got > 0) {
            *n = got;
            break;
        }
        if (has_peer_closed(e))
            return SM_E_CLOSED;
        r = sim_wait(deadline) ? find_socket(stream, STREAM, &e) : SM_E_TIMEOUT;
    }
    return r;
}

// ---- all ----

SmResult pal_socket_local_address(PalSocket s, PalAddress *local)
{
    if (!local)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_SOCKETS, s.id))
        return SM_E_HANDLE;
    *local = entries[s.id - 1].local;
    return SM_OK;
}

SmResult pal_socket_close(PalSocket s)
{
    SimSocket *e;

    if (!psl_table_is_used(used, PAL_SOCKETS, s.id))
        return SM_E_HANDLE;
    e = &entries[s.id - 1];
    if (e->kind == STREAM)
        sim_stream_close(e->stream, e->end);
    if (e->kind == LISTENING)
        sim_streams_drop(s.id);
    used[s.id - 1] = false;
    return SM_OK;
}
