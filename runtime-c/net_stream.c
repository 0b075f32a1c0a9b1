// SPDX-License-Identifier: Apache-2.0
// The connections of messages over TCP (net_stream.h).
#include "runtime-c/net_stream.h"

#include <string.h>

enum { FREE, CONNECTING, OPEN };          // SmNetPeer.state

#define PATIENCE ((uint64_t)5 * PAL_SECOND)       // a sender closes the connection of a peer that acknowledges nothing for this long
enum { MESSAGES_WAITING = 4 };            // about how many messages the platform may store for a peer that does not receive

static bool is_sender(const SmNetChannel *c) { return c->period != 0; }
static bool is_local_failure(SmResult r) { return r != SM_OK && r != SM_E_TIMEOUT && r != SM_E_UNREACHABLE && r != SM_E_CLOSED; }
static void count_event(SmNetChannel *c, SmNetCount what) { c->count[what]++; }

// ---- one connection ----

// Marks the row of a peer as an open connection without any message yet.
static void begin_connection(SmNetChannel *c, SmNetPeer *p, uint64_t now)
{
    p->state = OPEN;
    p->since = p->used = now;
    p->n = p->sent = 0;
    count_event(c, SM_NET_connected);
}

// Closes a connection.  A client waits before it connects again: twice as long as the last time, up to SM_NET_RETRY_MOST.  After a
// connection that existed for that long, it begins again with the shortest wait.
static void close_connection(SmNetChannel *c, SmNetPeer *p, uint64_t now)
{
    const bool lasted = p->state == OPEN && now - p->since >= SM_NET_RETRY_MOST;

    if (p->state != FREE)
        pal_socket_close(p->socket);
    if (p->state == OPEN)
        count_event(c, SM_NET_broken);
    if (is_sender(c) && p->n > 0)             // a message that was sent in part
        count_event(c, SM_NET_lost);
    p->state = FREE;
    p->n = p->sent = 0;
    c->pause = lasted || c->pause == 0 ? SM_NET_RETRY_LEAST : c->pause < SM_NET_RETRY_MOST / 2 ? 2 * c->pause : SM_NET_RETRY_MOST;
    c->retry = now + c->pause;
}

// Returns how long a connection can be without a message, in nanoseconds.  Then a receiver with a timeout ends it, and a server can replace it.
static uint64_t patience_of(const SmNetChannel *c) { return c->timeout > PAL_SECOND ? c->timeout : PAL_SECOND; }

// ---- clients ----

static SmResult begin_to_connect(SmNetChannel *c, uint64_t now)
{
    SmNetPeer *p = c->peer;
    const SmResult r = pal_socket_connect_start(&p->socket, &c->address);

    p->since = now;
    if (r == SM_OK)
        p->state = CONNECTING;
    else
        close_connection(c, p, now);
    return is_local_failure(r) ? r : SM_OK;
}

// Checks whether the pending connection is established.  Gives up an attempt that takes too long.
static SmResult continue_to_connect(SmNetChannel *c, uint64_t now)
{
    SmNetPeer *p = c->peer;
    SmResult r = pal_socket_connected(p->socket);

    if (r == SM_OK && is_sender(c))
        r = pal_socket_limit(p->socket, (size_t)MESSAGES_WAITING * c->message.size, PATIENCE);
    if (r == SM_OK)
        begin_connection(c, p, now);
    else if (r != SM_E_TIMEOUT || now - p->since >= SM_NET_RETRY_MOST)
        close_connection(c, p, now);
    return is_local_failure(r) ? r : SM_OK;
}

// Begins to connect after the pause, or continues an attempt.
static SmResult update_client(SmNetChannel *c, uint64_t now)
{
    SmResult r = SM_OK;

    if (c->peer->state == FREE && now >= c->retry)
        r = begin_to_connect(c, now);
    if (r == SM_OK && c->peer->state == CONNECTING)
        r = continue_to_connect(c, now);
    return r;
}

// ---- servers ----

// Returns a free row of c->peer; else the row of the peer whose last message is oldest, if that peer has been silent for too long; else NULL.
static SmNetPeer *find_peer_row(SmNetChannel *c, uint64_t now)
{
    SmNetPeer *oldest = c->peer;

    for (uint8_t i = 0; i < c->peers; i++) {
        if (c->peer[i].state == FREE)
            return &c->peer[i];
        if (c->peer[i].used < oldest->used)
            oldest = &c->peer[i];
    }
    return now - oldest->used > patience_of(c) ? oldest : NULL;
}

// Accepts at most one connection.  While no row is free, new peers wait in the platform's queue.
static SmResult update_server(SmNetChannel *c, uint64_t now)
{
    SmNetPeer *row = find_peer_row(c, now);
    PalSocket stream = {0};
    SmResult r;

    if (!row)
        return SM_OK;
    r = pal_socket_accept(c->socket, &stream, NULL, 0);
    if (r == SM_OK && is_sender(c)) {
        r = pal_socket_limit(stream, (size_t)MESSAGES_WAITING * c->message.size, PATIENCE);
        if (r != SM_OK)
            pal_socket_close(stream);
    }
    if (r != SM_OK)
        return is_local_failure(r) ? r : SM_OK;
    if (row->state != FREE)
        close_connection(c, row, now);
    row->socket = stream;
    begin_connection(c, row, now);
    return SM_OK;
}

// ---- opening and closing ----

// Whether the table of peers is valid: each has a buffer, and a client has exactly one.
static bool has_peers(const SmNetChannel *c)
{
    for (uint8_t i = 0; i < c->peers; i++)
        if (!c->peer || !c->peer[i].bytes)
            return false;
    return c->peers >= 1 && (c->is_server || c->peers == 1);
}

static SmResult open_stream(SmNetChannel *c)
{
    if (!has_peers(c))
        return SM_E_ARGUMENT;
    for (uint8_t i = 0; i < c->peers; i++) {
        c->peer[i].state = FREE;
        c->peer[i].n = c->peer[i].sent = 0;
    }
    c->retry = c->pause = 0;
    return c->is_server ? pal_socket_listen(&c->socket, &c->address) : update_client(c, 0);
}

static void close_stream(SmNetChannel *c)
{
    for (uint8_t i = 0; i < c->peers; i++)
        if (c->peer[i].state != FREE)
            close_connection(c, &c->peer[i], 0);
    if (c->is_server)
        pal_socket_close(c->socket);
}

// ---- sending ----

// Sends the rest of the message in p->bytes, as far as the platform accepts it.
static void send_rest(SmNetChannel *c, SmNetPeer *p, uint64_t now)
{
    size_t sent = 0;
    const SmResult r = pal_socket_send(p->socket, p->bytes + p->sent, (size_t)(p->n - p->sent), &sent, 0);

    p->sent = (uint16_t)(p->sent + sent);
    if (p->sent == p->n) {
        p->n = p->sent = 0;
        p->used = now;
        count_event(c, SM_NET_sent);
    }
    if (r != SM_OK && r != SM_E_TIMEOUT)
        close_connection(c, p, now);
}

// Whether the connection to the peer is still open.  A receiver of this channel sends nothing: the connection of a peer that sends a byte is
// closed.
static bool is_still_connected(SmNetChannel *c, SmNetPeer *p, uint64_t now)
{
    uint8_t byte;
    size_t n;

    if (p->state == OPEN && pal_socket_receive(p->socket, &byte, 1, &n, 0) != SM_E_TIMEOUT)
        close_connection(c, p, now);
    return p->state == OPEN;
}

// Sends the message of this step to a peer.  A message that has been sent in part is completed before the next one.  If the platform does not accept
// the first byte of a message, the message is dropped, so that the peer later receives a newer one.
static void send_to_peer(SmNetChannel *c, SmNetPeer *p, uint64_t now)
{
    if (p->n == 0) {
        memcpy(p->bytes, c->bytes, c->message.size);
        p->n = c->message.size;
        send_rest(c, p, now);
        if (p->n == 0 || p->sent > 0)
            return;
        p->n = 0;
    }
    count_event(c, SM_NET_full);
    count_event(c, SM_NET_lost);
}

// Sends the message in c->bytes to all connected peers. Without any, counts it as lost.
static void send_to_peers(SmNetChannel *c, uint64_t now)
{
    bool any = false;

    for (uint8_t i = 0; i < c->peers; i++)
        if (is_still_connected(c, &c->peer[i], now)) {
            any = true;
            send_to_peer(c, &c->peer[i], now);
        }
    if (!any) {
        count_event(c, SM_NET_unconnected);
        count_event(c, SM_NET_lost);
    }
}

// ---- receiving ----

// Counts a message that is refused before it is whole, and closes the connection.
static void refuse_message(SmNetChannel *c, SmNetPeer *p, SmNetCount cause, uint64_t now)
{
    count_event(c, cause);
    count_event(c, SM_NET_refused);
    close_connection(c, p, now);
}

// Checks a whole message.  Over TCP, damage or a wrong key can only mean another kind of sender or lost message boundaries: closes the connection.
static void accept_message(SmNetChannel *c, SmNetPeer *p, uint64_t now)
{
    const SmNetCount cause = sm_net_accept(c, p->bytes, c->message.size, now);

    p->n = 0;
    if (cause == SM_NET_accepted)
        p->used = now;
    else if (cause == SM_NET_damaged || cause == SM_NET_key)
        close_connection(c, p, now);
}

// Receives bytes of a connection once.  Returns whether they completed a message.
static bool receive_once(SmNetChannel *c, SmNetPeer *p, uint64_t now)
{
    SmNetCount cause = SM_NET_accepted;
    size_t got = 0;
    const SmResult r = pal_socket_receive(p->socket, p->bytes + p->n, (size_t)(c->message.size - p->n), &got, 0);

    if (r == SM_E_TIMEOUT)
        return false;
    if (r != SM_OK) {
        if (p->n > 0)
            refuse_message(c, p, SM_NET_short_, now);
        else
            close_connection(c, p, now);
        return false;
    }
    p->n = (uint16_t)(p->n + got);
    if (p->n >= SM_NET_HEADER)
        cause = sm_net_check_header(&c->message, p->bytes);
    if (cause != SM_NET_accepted)
        refuse_message(c, p, cause, now);
    else if (p->n == c->message.size)
        accept_message(c, p, now);
    return p->state == OPEN && p->n == 0;
}

// ---- every step ----

// Called in every step: continues partly sent messages, closes silent connections, and accepts or makes new ones.
static SmResult update_stream(SmNetChannel *c, uint64_t now)
{
    for (uint8_t i = 0; i < c->peers; i++) {
        SmNetPeer *p = &c->peer[i];
        if (p->state == OPEN && is_sender(c) && p->n > 0)
            send_rest(c, p, now);
        else if (p->state == OPEN && c->timeout && now - p->used > patience_of(c))
            close_connection(c, p, now);
    }
    return c->is_server ? update_server(c, now) : update_client(c, now);
}

static SmResult receive_stream(SmNetChannel *c, uint64_t now)
{
    const SmResult r = update_stream(c, now);

    for (uint8_t i = 0; i < c->peers; i++)
        for (int k = 0; k < SM_NET_BURST && c->peer[i].state == OPEN && receive_once(c, &c->peer[i], now); k++)
            ;
    return r;
}

static SmResult send_stream(SmNetChannel *c, uint64_t now)
{
    const SmResult r = update_stream(c, now);

    if (c->due)
        send_to_peers(c, now);
    return r;
}

const SmNetStream sm_net_tcp = {open_stream, close_stream, receive_stream, send_stream};
