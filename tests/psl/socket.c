// SPDX-License-Identifier: Apache-2.0
// The guarantees of socket.h, over the loopback address 127.0.0.1.
#include <stdlib.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/socket.h"
#include "runtime-c/pal/thread.h"
#include "tests/psl/suite.h"

#define SOON (10 * (uint64_t)PAL_SECOND)      // a limit for data that arrives at once, on a computer under load

static const PalAddress here = {{127, 0, 0, 1}, 0};

static void without(void)
{
    PalSocket s = {0};
    PalAddress a = here;
    uint8_t x = 0;
    size_t n = 7;

    CHECK(pal_socket_udp(&s, &here) == SM_E_UNSUPPORTED && pal_socket_udp(NULL, NULL) == SM_E_UNSUPPORTED);
    CHECK(pal_socket_listen(&s, &here) == SM_E_UNSUPPORTED);
    CHECK(pal_socket_listen_local(&s, "path") == SM_E_UNSUPPORTED);
    CHECK(pal_socket_accept(s, &s, NULL, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_socket_connect(&s, &here, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_socket_connect_start(&s, &here) == SM_E_UNSUPPORTED && pal_socket_connected(s) == SM_E_UNSUPPORTED);
    CHECK(pal_socket_limit(s, 1, MS) == SM_E_UNSUPPORTED && pal_socket_multicast(s, NULL, here.ip) == SM_E_UNSUPPORTED);
    CHECK(pal_socket_send_to(s, &here, &x, 1) == SM_E_UNSUPPORTED);
    CHECK(pal_socket_receive_from(s, &a, &x, 1, &n, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_socket_send(s, &x, 1, &n, 0) == SM_E_UNSUPPORTED && n == 0);
    CHECK(pal_socket_send(s, &x, 1, NULL, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_socket_receive(s, &x, 1, &n, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_socket_local_address(s, &a) == SM_E_UNSUPPORTED);
    CHECK(pal_socket_close(s) == SM_E_UNSUPPORTED);
    CHECK(s.id == 0);
}

static PalAddress own(PalSocket s)
{
    PalAddress a = {{0, 0, 0, 0}, 0};

    CHECK(pal_socket_local_address(s, &a) == SM_OK && memcmp(a.ip, here.ip, 4) == 0 && a.port != 0);
    return a;
}

static bool same(const PalAddress *a, const PalAddress *b)
{
    return memcmp(a->ip, b->ip, 4) == 0 && a->port == b->port;
}

static void bad_handles(void)
{
    const uint8_t bad[] = {0, PAL_SOCKETS, PAL_SOCKETS + 1, 255};

    for (size_t i = 0; i < COUNT(bad); i++) {
        PalSocket s = {bad[i]}, t = {0};
        PalAddress a = here;
        uint8_t x = 0;
        size_t n = 7;

        CHECK(pal_socket_accept(s, &t, NULL, 0) == SM_E_HANDLE);
        CHECK(pal_socket_connected(s) == SM_E_HANDLE && pal_socket_limit(s, 1, MS) == SM_E_HANDLE);
        CHECK(pal_socket_multicast(s, NULL, here.ip) == SM_E_HANDLE);
        CHECK(pal_socket_send_to(s, &here, &x, 1) == SM_E_HANDLE);
        CHECK(pal_socket_receive_from(s, &a, &x, 1, &n, 0) == SM_E_HANDLE && n == 7);
        CHECK(pal_socket_send(s, &x, 1, &n, 0) == SM_E_HANDLE && n == 0);
        CHECK(pal_socket_receive(s, &x, 1, &n, 0) == SM_E_HANDLE);
        CHECK(pal_socket_local_address(s, &a) == SM_E_HANDLE);
        CHECK(pal_socket_close(s) == SM_E_HANDLE);
    }
}

// ---- datagrams ----

static PalSocket udp(void)
{
    PalSocket s = {0};

    CHECK(pal_socket_udp(&s, &here) == SM_OK && s.id != 0);
    return s;
}

static void datagrams_arrive(PalSocket a, PalSocket b)
{
    uint8_t out[PAL_DATAGRAM_MAX], in[PAL_DATAGRAM_MAX + 1];
    PalAddress to = own(b), from = {{0, 0, 0, 0}, 0}, me = own(a);
    const size_t sizes[] = {5, 0, 1, PAL_DATAGRAM_MAX};
    size_t n = 7;

    for (size_t i = 0; i < sizeof out; i++)
        out[i] = (uint8_t)(i * 31 + 7);
    for (size_t i = 0; i < COUNT(sizes); i++) {            // a datagram can be empty
        memset(in, 0, sizeof in);
        CHECK(pal_socket_send_to(a, &to, out, sizes[i]) == SM_OK);
        CHECK(pal_socket_receive_from(b, &from, in, sizeof in, &n, SOON) == SM_OK);
        CHECK(n == sizes[i] && memcmp(in, out, n) == 0 && same(&from, &me));
    }
    CHECK(pal_socket_send_to(a, &to, "long", 4) == SM_OK);
    CHECK(pal_socket_send_to(a, &to, "next", 4) == SM_OK);
    CHECK(pal_socket_receive_from(b, NULL, in, 2, &n, SOON) == SM_E_SIZE && n == 2 && memcmp(in, "lo", 2) == 0);
    CHECK(pal_socket_receive_from(b, NULL, in, 4, &n, SOON) == SM_OK && n == 4 && memcmp(in, "next", 4) == 0);
}

static void datagrams_do_not(PalSocket a, PalSocket b)
{
    uint64_t before = pal_clock_now();
    PalAddress to = own(b);
    uint8_t x[4];
    size_t n = 7;

    CHECK(pal_socket_receive_from(b, NULL, x, 4, &n, 0) == SM_E_TIMEOUT && n == 7);
    CHECK(pal_socket_receive_from(b, NULL, x, 4, &n, 5 * MS) == SM_E_TIMEOUT && n == 7);
    CHECK(pal_clock_now() - before >= 5 * MS);
    CHECK(pal_socket_send_to(a, NULL, x, 1) == SM_E_ARGUMENT);
    CHECK(pal_socket_send_to(a, &to, NULL, 1) == SM_E_ARGUMENT);
    CHECK(pal_socket_send_to(a, &to, x, PAL_DATAGRAM_MAX + 1) == SM_E_ARGUMENT);
    CHECK(pal_socket_receive_from(b, NULL, NULL, 4, &n, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_receive_from(b, NULL, x, 4, NULL, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_receive_from(b, NULL, x, 4, &n, PAL_TIMEOUT_MAX + 1) == SM_E_ARGUMENT);
    CHECK(pal_socket_send(a, x, 1, &n, 0) == SM_E_ARGUMENT && n == 0);       // a datagram socket is not a stream
    CHECK(pal_socket_receive(a, x, 1, &n, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_accept(a, &b, NULL, 0) == SM_E_ARGUMENT);
}

static void test_datagrams(void)
{
    const PalAddress elsewhere = {{192, 0, 2, 1}, 0};     // an address that no computer has (RFC 5737)
    PalSocket a = udp(), b = udp(), c = {0};
    PalAddress taken = own(a);

    CHECK(pal_socket_udp(NULL, &here) == SM_E_ARGUMENT && pal_socket_udp(&c, NULL) == SM_E_ARGUMENT);
    CHECK(pal_socket_udp(&c, &taken) == SM_E_BUSY);
    CHECK(pal_socket_udp(&c, &elsewhere) == SM_E_MISSING);
    CHECK(c.id == 0);
    CHECK(pal_socket_local_address(a, NULL) == SM_E_ARGUMENT);
    datagrams_arrive(a, b);
    datagrams_do_not(a, b);
    CHECK(pal_socket_close(a) == SM_OK && pal_socket_close(a) == SM_E_HANDLE);
    CHECK(pal_socket_udp(&c, &taken) == SM_OK);           // the port can be used again
    CHECK(pal_socket_close(c) == SM_OK);
    CHECK(pal_socket_close(b) == SM_OK);
}

// ---- streams ----

typedef struct Pair {
    PalSocket listening, near, far;
} Pair;

static Pair connected(void)
{
    Pair p = {{0}, {0}, {0}};
    PalAddress a, near, peer = {{0, 0, 0, 0}, 0};

    CHECK(pal_socket_listen(&p.listening, &here) == SM_OK);
    a = own(p.listening);
    CHECK(pal_socket_connect(&p.near, &a, SOON) == SM_OK);
    CHECK(pal_socket_accept(p.listening, &p.far, &peer, SOON) == SM_OK);
    near = own(p.near);
    CHECK(same(&peer, &near));
    return p;
}

static void close_all(Pair p)
{
    CHECK(pal_socket_close(p.near) == SM_OK);
    CHECK(pal_socket_close(p.far) == SM_OK);
    CHECK(pal_socket_close(p.listening) == SM_OK);
}

static bool sends(PalSocket s, const void *bytes, size_t n)
{
    size_t sent = 0;

    return pal_socket_send(s, bytes, n, &sent, SOON) == SM_OK && sent == n;
}

static bool gains(PalSocket s, const void *expected, size_t n)
{
    uint8_t in[100];
    size_t all = 0, got = 0;

    while (all < n && pal_socket_receive(s, in + all, n - all, &got, SOON) == SM_OK)
        all += got;
    return all == n && memcmp(in, expected, n) == 0;
}

static void streams_arrive(void)
{
    Pair p = connected();
    uint64_t before = pal_clock_now();
    uint8_t x;
    size_t n = 7;

    CHECK(sends(p.near, "one", 3) && sends(p.near, "two", 3) && gains(p.far, "onetwo", 6));
    CHECK(sends(p.far, "back", 4) && gains(p.near, "ba", 2) && gains(p.near, "ck", 2));
    CHECK(sends(p.near, "", 0));
    CHECK(pal_socket_receive(p.far, &x, 1, &n, 0) == SM_E_TIMEOUT && n == 7);
    CHECK(pal_socket_receive(p.far, &x, 1, &n, 5 * MS) == SM_E_TIMEOUT && n == 7);
    CHECK(pal_clock_now() - before >= 5 * MS);
    CHECK(pal_socket_close(p.listening) == SM_OK);        // existing connections stay open
    CHECK(sends(p.near, "still", 5) && gains(p.far, "still", 5));
    CHECK(pal_socket_close(p.near) == SM_OK);
    CHECK(pal_socket_close(p.far) == SM_OK);
}

static void peer_goes(void)
{
    Pair p = connected();
    uint8_t x;
    size_t n = 7;
    SmResult r = SM_OK;

    CHECK(sends(p.near, "last", 4));
    CHECK(pal_socket_close(p.near) == SM_OK);
    CHECK(gains(p.far, "last", 4));                        // all bytes that were sent, then the end
    CHECK(pal_socket_receive(p.far, &x, 1, &n, SOON) == SM_E_CLOSED && n == 7);
    CHECK(pal_socket_receive(p.far, &x, 1, &n, 0) == SM_E_CLOSED);
    for (int i = 0; i < 100 && r == SM_OK; i++) {          // the first may still be taken
        r = pal_socket_send(p.far, "x", 1, &n, SOON);
        pal_clock_sleep_until(pal_clock_now() + MS);
    }
    CHECK(r == SM_E_CLOSED && n == 0);
    CHECK(pal_socket_close(p.far) == SM_OK);
    CHECK(pal_socket_close(p.listening) == SM_OK);
}

// The peer reads nothing: send returns at its timeout with the number of bytes that it sent, none of which is lost.
static void test_slow_peer(void)
{
    static uint8_t bytes[8192], in[8192];
    Pair p = connected();
    size_t all = 0, n = 0, came = 0;
    bool same_bytes = true;
    SmResult r = SM_OK;

    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (uint8_t)(i % 251);
    for (int i = 0; i < 10000 && r == SM_OK; i++) {
        r = pal_socket_send(p.near, bytes, sizeof bytes, &n, 5 * MS);
        all += n;
    }
    CHECK(r == SM_E_TIMEOUT && n < sizeof bytes);
    while (came < all && pal_socket_receive(p.far, in, sizeof in, &n, SOON) == SM_OK)
        for (size_t i = 0; i < n; i++, came++)
            same_bytes = same_bytes && in[i] == bytes[came % sizeof bytes];
    CHECK(came == all && same_bytes);
    close_all(p);
}

typedef struct Reader {
    PalSocket socket;
    size_t came;
    bool same_bytes;
} Reader;

// Receives in small pieces until the peer closes the connection.
static void read_all(void *of)
{
    Reader *r = of;
    uint8_t in[1000];
    size_t n = 0;

    while (pal_socket_receive(r->socket, in, sizeof in, &n, SOON) == SM_OK)
        for (size_t i = 0; i < n; i++, r->came++)
            r->same_bytes = r->same_bytes && in[i] == r->came % 251;
}

// More bytes than the buffers have room for: one call of send transfers them in parts, while another thread reads.
static void test_peer_that_reads(void)
{
    static uint8_t bytes[251 * 16000];
    const PalThreadPlan plan = {NULL, 0, 0};
    PalThread thread = {0};
    Pair p = connected();
    Reader r = {{0}, 0, true};
    size_t n = 0;

    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (uint8_t)(i % 251);
    r.socket = p.far;
    CHECK(pal_thread_create(&thread, &plan, read_all, &r) == SM_OK);
    CHECK(pal_socket_send(p.near, bytes, sizeof bytes, &n, 60 * (uint64_t)PAL_SECOND) == SM_OK && n == sizeof bytes);
    CHECK(pal_socket_close(p.near) == SM_OK);
    CHECK(pal_thread_join(thread, 60 * (uint64_t)PAL_SECOND) == SM_OK);
    CHECK(r.came == sizeof bytes && r.same_bytes);
    CHECK(pal_socket_close(p.far) == SM_OK);
    CHECK(pal_socket_close(p.listening) == SM_OK);
}

static void no_listener(void)
{
    PalSocket s = {0}, t = {0};
    uint64_t before;
    PalAddress a;

    CHECK(pal_socket_listen(NULL, &here) == SM_E_ARGUMENT && pal_socket_listen(&s, NULL) == SM_E_ARGUMENT);
    CHECK(pal_socket_listen(&s, &here) == SM_OK);
    a = own(s);
    CHECK(pal_socket_listen(&t, &a) == SM_E_BUSY);
    before = pal_clock_now();
    CHECK(pal_socket_accept(s, &t, NULL, 0) == SM_E_TIMEOUT);
    CHECK(pal_socket_accept(s, &t, NULL, 5 * MS) == SM_E_TIMEOUT);
    CHECK(pal_clock_now() - before >= 5 * MS);
    CHECK(pal_socket_accept(s, NULL, NULL, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_accept(s, &t, NULL, PAL_TIMEOUT_MAX + 1) == SM_E_ARGUMENT);
    CHECK(pal_socket_close(s) == SM_OK);
    CHECK(pal_socket_connect(&t, &a, SOON) == SM_E_UNREACHABLE);
    CHECK(pal_socket_connect(NULL, &a, 0) == SM_E_ARGUMENT && pal_socket_connect(&t, NULL, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_connect(&t, &a, PAL_TIMEOUT_MAX + 1) == SM_E_ARGUMENT);
    CHECK(t.id == 0);
}

// ---- connecting without a wait ----

static SmResult await_connection(PalSocket s)
{
    const uint64_t end = pal_clock_now() + SOON;
    SmResult r = pal_socket_connected(s);

    while (r == SM_E_TIMEOUT && pal_clock_now() < end) {
        CHECK(pal_clock_sleep_until(pal_clock_now() + MS) == SM_OK);
        r = pal_socket_connected(s);
    }
    return r;
}

// Returns the result of a connection to this address, which the call or a later query reports.
static SmResult try_connection(PalSocket *s, const PalAddress *to)
{
    SmResult r = pal_socket_connect_start(s, to);

    if (r != SM_OK)
        return r;
    r = await_connection(*s);
    if (r != SM_OK)
        CHECK(pal_socket_close(*s) == SM_OK);
    return r;
}

static void connects_without_waiting(void)
{
    PalSocket listening = {0}, near = {0}, far = {0};
    PalAddress a;

    CHECK(pal_socket_listen(&listening, &here) == SM_OK);
    a = own(listening);
    CHECK(try_connection(&near, &a) == SM_OK && pal_socket_connected(near) == SM_OK);
    CHECK(pal_socket_accept(listening, &far, NULL, SOON) == SM_OK && pal_socket_connected(far) == SM_OK);
    CHECK(sends(near, "hello", 5) && gains(far, "hello", 5) && sends(far, "you", 3) && gains(near, "you", 3));
    CHECK(pal_socket_connected(listening) == SM_E_ARGUMENT);
    CHECK(pal_socket_connect_start(NULL, &a) == SM_E_ARGUMENT && pal_socket_connect_start(&far, NULL) == SM_E_ARGUMENT);
    CHECK(pal_socket_close(far) == SM_OK && pal_socket_close(near) == SM_OK && pal_socket_close(listening) == SM_OK);
    near.id = 0;
    CHECK(try_connection(&near, &a) == SM_E_UNREACHABLE);                 // no socket listens there any more
}

// No computer answers at this address (198.51.100.0/24 is reserved for documentation), or this computer has no route to it.  Neither call waits.
static void connects_to_no_computer(void)
{
    const PalAddress nowhere = {{198, 51, 100, 1}, 9};
    const uint64_t before = pal_clock_now();
    PalSocket s = {0};
    uint8_t x = 0;
    size_t n = 7;
    SmResult r = pal_socket_connect_start(&s, &nowhere);

    if (r == SM_OK) {
        r = pal_socket_connected(s);
        if (r == SM_E_TIMEOUT) {                  // until it is connected, it is not a stream
            CHECK(pal_socket_send(s, &x, 1, &n, 0) == SM_E_ARGUMENT && n == 0 && pal_socket_receive(s, &x, 1, &n, 0) == SM_E_ARGUMENT);
            CHECK(pal_socket_limit(s, 1, MS) == SM_E_ARGUMENT);
        }
        CHECK(pal_socket_close(s) == SM_OK && pal_socket_close(s) == SM_E_HANDLE);
    }
    CHECK(r != SM_E_ARGUMENT && pal_clock_now() - before < PAL_SECOND);
}

// With a limit, a peer that does not receive fills its stream after a few messages.  No accepted message is lost.
static void limits(void)
{
    static uint8_t bytes[1000];
    Pair p = connected();
    size_t all = 0, n = 0, came = 0;
    SmResult r = SM_OK;

    CHECK(pal_socket_limit(p.listening, 1, MS) == SM_E_ARGUMENT && pal_socket_limit(p.near, 0, MS) == SM_E_ARGUMENT);
    CHECK(pal_socket_limit(p.near, 1, 0) == SM_E_ARGUMENT && pal_socket_limit(p.near, 1, PAL_TIMEOUT_MAX + 1) == SM_E_ARGUMENT);
    CHECK(pal_socket_limit(p.near, (1u << 20) + 1, MS) == SM_E_ARGUMENT && pal_socket_limit(p.near, 4000, PAL_TIMEOUT_MAX) == SM_OK);
    for (int i = 0; i < 100000 && r == SM_OK; i++) {
        r = pal_socket_send(p.near, bytes, sizeof bytes, &n, 0);
        all += n;
    }
    CHECK(r == SM_E_TIMEOUT && n < sizeof bytes);
    while (came < all && pal_socket_receive(p.far, bytes, sizeof bytes, &n, SOON) == SM_OK)
        came += n;
    CHECK(came == all);
    close_all(p);
}

static void bad_stream_arguments(void)
{
    Pair p = connected();
    uint8_t x = 0;
    size_t n = 7;

    CHECK(pal_socket_send(p.near, NULL, 1, &n, 0) == SM_E_ARGUMENT && n == 0);
    CHECK(pal_socket_send(p.near, &x, 1, NULL, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_send(p.near, &x, 1, &n, PAL_TIMEOUT_MAX + 1) == SM_E_ARGUMENT);
    CHECK(pal_socket_receive(p.near, NULL, 1, &n, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_receive(p.near, &x, 0, &n, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_receive(p.near, &x, 1, NULL, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_receive(p.near, &x, 1, &n, PAL_TIMEOUT_MAX + 1) == SM_E_ARGUMENT);
    CHECK(pal_socket_send(p.listening, &x, 1, &n, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_receive(p.listening, &x, 1, &n, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_send_to(p.near, &here, &x, 1) == SM_E_ARGUMENT);
    CHECK(pal_socket_receive_from(p.near, NULL, &x, 1, &n, 0) == SM_E_ARGUMENT);
    CHECK(pal_socket_accept(p.near, &p.far, NULL, 0) == SM_E_ARGUMENT);
    close_all(p);
}

// ---- multicast ----

// Opens the receiver of a group.  Returns false, and skips the test, if the computer has no interface for it.
static bool joins(PalSocket *s, const PalAddress *group)
{
    SmResult r;

    CHECK(pal_socket_udp(s, group) == SM_OK);
    r = pal_socket_multicast(*s, group->ip, here.ip);
    CHECK(r == SM_OK || r == SM_E_MISSING);
    if (r != SM_OK)
        CHECK(pal_socket_close(*s) == SM_OK);
    return r == SM_OK;
}

// Skipped under an emulator that does not pass the options of multicast to the system (NO_MULTICAST).
static void multicast(void)
{
    const PalAddress group = {{239, 77, 3, 9}, 47113}, other = {{239, 77, 3, 10}, 47113};
    const uint8_t elsewhere[4] = {198, 51, 100, 1}, no_group[4] = {10, 0, 0, 1};
    PalSocket first = {0}, second = {0}, from = udp();
    Pair p = connected();
    uint8_t in[8];
    size_t n = 7;

    CHECK(pal_socket_multicast(from, NULL, NULL) == SM_E_ARGUMENT && pal_socket_multicast(from, no_group, here.ip) == SM_E_ARGUMENT);
    CHECK(pal_socket_multicast(p.near, NULL, here.ip) == SM_E_ARGUMENT && pal_socket_multicast(p.listening, NULL, here.ip) == SM_E_ARGUMENT);
    if (getenv("NO_MULTICAST")) {
        close_all(p);
        CHECK(pal_socket_close(from) == SM_OK);
        return;
    }
    CHECK(pal_socket_multicast(from, NULL, elsewhere) == SM_E_MISSING && pal_socket_multicast(from, NULL, here.ip) == SM_OK);
    if (joins(&first, &group)) {
        CHECK(joins(&second, &other));
        CHECK(pal_socket_send_to(from, &group, "group", 5) == SM_OK);
        CHECK(pal_socket_receive_from(first, NULL, in, sizeof in, &n, SOON) == SM_OK && n == 5 && memcmp(in, "group", 5) == 0);
        CHECK(pal_socket_receive_from(second, NULL, in, sizeof in, &n, 5 * MS) == SM_E_TIMEOUT);        // of another group
        CHECK(pal_socket_close(first) == SM_OK && pal_socket_close(second) == SM_OK);
    }
    CHECK(pal_socket_close(from) == SM_OK);
    close_all(p);
}

// ---- the table ----

static void table_is_full(void)
{
    PalSocket all[PAL_SOCKETS], more = {0};
    PalAddress a;

    CHECK(pal_socket_listen(&all[0], &here) == SM_OK);
    a = own(all[0]);
    CHECK(pal_socket_connect(&all[1], &a, SOON) == SM_OK);
    for (int i = 2; i < PAL_SOCKETS; i++)
        all[i] = udp();
    CHECK(pal_socket_udp(&more, &here) == SM_E_FULL);
    CHECK(pal_socket_listen(&more, &here) == SM_E_FULL);
    CHECK(pal_socket_connect(&more, &a, 0) == SM_E_FULL && pal_socket_connect_start(&more, &a) == SM_E_FULL);
    CHECK(pal_socket_accept(all[0], &more, NULL, SOON) == SM_E_FULL);
    CHECK(more.id == 0);
    CHECK(pal_socket_close(all[2]) == SM_OK);
    CHECK(pal_socket_accept(all[0], &all[2], NULL, SOON) == SM_OK);          // the connection waited in the queue
    CHECK(sends(all[1], "hello", 5) && gains(all[2], "hello", 5));
    for (int i = 0; i < PAL_SOCKETS; i++)
        CHECK(pal_socket_close(all[i]) == SM_OK);
}

Tally contract_socket(void)
{
    if (bench.sockets == HAS_NONE) {
        without();
        return TALLY();
    }
    bad_handles();
    test_datagrams();
    streams_arrive();
    peer_goes();
    test_slow_peer();
    if (bench.threads == HAS)
        test_peer_that_reads();
    no_listener();
    connects_without_waiting();
    connects_to_no_computer();
    limits();
    multicast();
    bad_stream_arguments();
    table_is_full();
    return TALLY();
}
