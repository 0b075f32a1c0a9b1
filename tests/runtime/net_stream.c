// SPDX-License-Identifier: Apache-2.0
// Messages over TCP (runtime-c/net_stream.h) of tests/runtime/stream.net, in the simulation: boundaries, damage, peers that send wrong lengths,
// stop or leave, several peers, reconnects and their pauses, and keys.  No step may block.
// clause 11.21 clause 11.22 clause 11.23 clause 11.24 clause 11.25
#include <math.h>
#include <string.h>

#include "stream_net.h"
#include "stream.h"
#include "bytecode-vm/target/seal.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/sim/sim.h"
#include "stdlib/crc32.h"
#include "tests/test.h"

const uint8_t streamKey[SM_NET_KEY] = {9, 9, 9};

enum { ORDERS = 16 + 4 + 2 + 8 + 4, SECRET = 16 + 1 + 16 + 4, REPORT = 16 + 8 + 8 + 1 + 4, BEACON = 16 + 2 + 4, ROOM = 4096 };
#define MS ((uint64_t)1000000)

static const PalAddress at_report = {{10, 0, 0, 1}, 6001}, at_beacon = {{127, 0, 0, 1}, 6002}, at_orders = {{127, 0, 0, 1}, 6003},
                        at_secret = {{10, 0, 0, 1}, 6004};
static SmNetChannel fresh[4], *orders, *secret, *report, *beacon;

// ---- the other computers, written from the table in net.h alone ----

typedef struct Packet { uint8_t at[128]; size_t n; } Packet;

static void put(Packet *p, uint64_t x, unsigned bytes)
{
    for (unsigned i = 0; i < bytes; i++)
        p->at[p->n++] = (uint8_t)(x >> 8 * i);
}

static Packet header(uint32_t hash, bool is_sealed, uint32_t run, uint32_t number)
{
    Packet p = {{0}, 0};

    put(&p, 0x4D53, 2);
    put(&p, 1, 1);
    put(&p, is_sealed, 1);
    put(&p, hash, 4);
    put(&p, run, 4);
    put(&p, number, 4);
    return p;
}

static Packet order(uint32_t run, uint32_t number, float throttle, int16_t trim)
{
    Packet p = header(orders->message.hash, false, run, number);
    uint32_t bits;

    memcpy(&bits, &throttle, sizeof bits);
    put(&p, bits, 4);
    put(&p, (uint16_t)trim, 2);
    put(&p, UINT64_MAX, 8);
    put(&p, sm_crc32(p.at, p.n), 4);
    return p;
}

static Packet seal(uint32_t run, uint32_t number, const uint8_t *key)
{
    Packet p = header(secret->message.hash, true, run, number);

    put(&p, 1, 1);
    smvm_seal(p.at, p.n, key, p.at + p.n);
    p.n += SM_NET_CODE;
    put(&p, sm_crc32(p.at, p.n), 4);
    return p;
}

static PalSocket connects(const PalAddress *to)
{
    PalSocket s = {0};

    CHECK(pal_socket_connect(&s, to, 0) == SM_OK);
    return s;
}

static PalSocket listens(const PalAddress *at)
{
    PalSocket s = {0};

    CHECK(pal_socket_listen(&s, at) == SM_OK);
    return s;
}

// Returns the stream that a client of the application has opened; its number is 0 if no client has opened one.
static PalSocket accepts(PalSocket listening)
{
    PalSocket s = {0};

    (void)pal_socket_accept(listening, &s, NULL, 0);
    return s;
}

static void sends(PalSocket s, const void *bytes, size_t n)
{
    size_t sent = 0;

    CHECK(pal_socket_send(s, bytes, n, &sent, 0) == SM_OK && sent == n);
}

static bool is_closed(PalSocket s)
{
    uint8_t byte;
    size_t n = 0;

    return pal_socket_receive(s, &byte, 1, &n, 0) == SM_E_CLOSED;
}

// Receives all bytes that have arrived, and returns their number.
static size_t gains(PalSocket s, uint8_t *bytes)
{
    size_t all = 0, n = 0;

    while (all < ROOM && pal_socket_receive(s, bytes + all, ROOM - all, &n, 0) == SM_OK)
        all += n;
    return all;
}

// ---- the application ----

static SmResult receive_at(uint64_t ms)
{
    const SmTick tick = {ms * MS, 0};
    const uint64_t before = pal_clock_now();
    const SmResult r = sm_receive_step(&stream_receive, &tick);

    CHECK(pal_clock_now() == before);             // no call has waited
    return r;
}

static SmResult send_at(uint64_t ms)
{
    const SmTick tick = {ms * MS, 0};
    const uint64_t before = pal_clock_now();
    const SmResult r = sm_send_step(&stream_send, &tick);

    CHECK(pal_clock_now() == before);
    return r;
}

static void renew(void)
{
    sim_reset();
    memset(&stream_sv, 0, sizeof stream_sv);
    if (!orders) {
        CHECK(stream_receive.channels == 2 && stream_send.channels == 2);
        memcpy(fresh, stream_receive.channel, 2 * sizeof *fresh);
        memcpy(fresh + 2, stream_send.channel, 2 * sizeof *fresh);
    }
    memcpy(stream_receive.channel, fresh, 2 * sizeof *fresh);
    memcpy(stream_send.channel, fresh + 2, 2 * sizeof *fresh);
    orders = &stream_receive.channel[0];
    secret = &stream_receive.channel[1];
    report = &stream_send.channel[0];
    beacon = &stream_send.channel[1];
    CHECK(sm_statevec_init(&stream_vector) == SM_OK);
}

static void start_receiving(void)
{
    renew();
    CHECK(sm_receive_init(&stream_receive) == SM_OK);
}

static void start_sending(void)
{
    renew();
    CHECK(sm_send_init(&stream_send) == SM_OK);
}

// ---- receiving ----

static void test_values(void)
{
    PalSocket s;
    Packet p;

    start_receiving();
    CHECK(orders->message.size == ORDERS && secret->message.size == SECRET);
    s = connects(&at_orders);
    p = order(9, 0, 0.25f, -3);
    sends(s, p.at, p.n);
    CHECK(receive_at(10) == SM_OK && stream_sv.throttle == 0.25f && stream_sv.trim == -3 && stream_sv.wide == UINT64_MAX);
    CHECK(stream_sv.accepted == 1 && stream_sv.refused == 0 && stream_sv.begun == 1 && stream_sv.broken == 0 && stream_sv.age == 0);
    CHECK(receive_at(210) == SM_OK && stream_sv.throttle == 0.25f && stream_sv.age == 200);
    CHECK(receive_at(211) == SM_OK && stream_sv.throttle == 0.5f && stream_sv.trim == -3 && stream_sv.wide == 0);      // silent
    p = order(9, 1, 0.75f, 4);
    sends(s, p.at, p.n);
    CHECK(receive_at(220) == SM_OK && stream_sv.throttle == 0.75f && stream_sv.begun == 1);          // on the same connection
}

// Bytes arrive one by one: half a message changes nothing.
static void test_pieces(void)
{
    PalSocket s;
    Packet p;

    start_receiving();
    s = connects(&at_orders);
    for (uint32_t number = 0; number < 3; number++) {
        p = order(9, number, 0.25f, (int16_t)(number + 1));
        for (size_t i = 0; i < p.n; i++) {
            CHECK(receive_at(10) == SM_OK && stream_sv.accepted == number && stream_sv.trim == (int16_t)number);
            sends(s, p.at + i, 1);
        }
        CHECK(receive_at(10) == SM_OK && stream_sv.accepted == number + 1 && stream_sv.trim == (int16_t)(number + 1));
    }
    sim_streams((SimStreams){0, 0, 5});           // at most 5 bytes per call
    p = order(9, 3, 0.25f, 9);
    sends(s, p.at, p.n);
    for (size_t i = 5; i < ORDERS; i += 5)
        CHECK(receive_at(10) == SM_OK && stream_sv.accepted == 3 && stream_sv.trim == 3);
    CHECK(receive_at(10) == SM_OK && stream_sv.accepted == 4 && stream_sv.trim == 9 && stream_sv.refused == 0);
}

static void test_flood(void)
{
    uint8_t rubbish[64] = {0};
    PalSocket s, other;

    start_receiving();
    s = connects(&at_orders);
    other = connects(&at_orders);
    for (uint32_t i = 0; i < 20; i++) {
        const Packet p = order(9, i, (float)i, 1);
        sends(s, p.at, p.n);
    }
    for (int i = 0; i < 100; i++)
        sends(other, rubbish, sizeof rubbish);
    CHECK(receive_at(10) == SM_OK && stream_sv.accepted == SM_NET_BURST && stream_sv.throttle == SM_NET_BURST - 1 && stream_sv.begun == 1);
    CHECK(receive_at(20) == SM_OK && stream_sv.accepted == 2 * SM_NET_BURST && stream_sv.damaged == 1 && is_closed(other));
    CHECK(receive_at(30) == SM_OK && stream_sv.accepted == 20 && stream_sv.refused == 1);
}

// Sends bytes on a new connection.  Returns whether they were refused for this cause, the connection was closed, and nothing else changed.
static bool is_refused(const void *bytes, size_t n, const uint32_t *cause)
{
    const StreamSv before = stream_sv;
    const uint32_t was = *cause;
    PalSocket s = connects(&at_orders);
    bool good;

    sends(s, bytes, n);
    CHECK(receive_at(20) == SM_OK);
    good = is_closed(s) && *cause == was + 1 && stream_sv.refused == before.refused + 1 && stream_sv.broken == before.broken + 1 &&
           stream_sv.accepted == before.accepted && stream_sv.trim == before.trim && stream_sv.age == before.age + 10;
    CHECK(pal_socket_close(s) == SM_OK && receive_at(10) == SM_OK);
    return good;
}

static void test_damage(void)
{
    PalSocket s;
    Packet p;

    start_receiving();
    s = connects(&at_orders);
    p = order(9, 0, 0.25f, 7);
    sends(s, p.at, p.n);
    CHECK(receive_at(10) == SM_OK && stream_sv.accepted == 1);
    p = order(9, 1, 0.25f, 8);
    for (size_t bit = 0; bit < 8 * ORDERS; bit++) {
        p.at[bit / 8] ^= (uint8_t)(1 << bit % 8);
        CHECK(is_refused(p.at, p.n, bit / 32 == 1 ? &stream_sv.hashes : &stream_sv.damaged));
        p.at[bit / 8] ^= (uint8_t)(1 << bit % 8);
    }
    sends(s, p.at, p.n);                          // the other connection is not affected
    CHECK(receive_at(20) == SM_OK && stream_sv.accepted == 2 && stream_sv.trim == 8);
}

// Peers that send wrong lengths: their messages are shorter or longer, or they stop inside one.
static void test_lengths(void)
{
    PalSocket s;
    Packet p, more;

    start_receiving();
    s = connects(&at_orders);
    p = order(9, 0, 0.25f, 4);
    sends(s, p.at, p.n);
    CHECK(receive_at(10) == SM_OK && stream_sv.accepted == 1 && pal_socket_close(s) == SM_OK && receive_at(10) == SM_OK);
    p = header(orders->message.hash + 1, false, 1, 1);                    // another message, of which only the header is sent
    CHECK(is_refused(p.at, p.n, &stream_sv.hashes));
    p = order(9, 1, 1, 1);
    p.n -= 3;                                     // 3 bytes are missing before the next message
    more = order(9, 2, 1, 1);
    memcpy(p.at + p.n, more.at, more.n);
    CHECK(is_refused(p.at, p.n + more.n, &stream_sv.damaged));
    s = connects(&at_orders);
    p = order(9, 3, 0.25f, 5);
    memset(p.at + p.n, 0, 20);                    // zeros after the message
    sends(s, p.at, p.n + 20);
    CHECK(receive_at(30) == SM_OK && stream_sv.accepted == 2 && stream_sv.damaged == 2 && stream_sv.trim == 5 && is_closed(s));
    CHECK(pal_socket_close(s) == SM_OK);
    for (size_t n = 0; n < ORDERS; n++) {         // the connection ends after each number of bytes
        const uint32_t shorts = stream_sv.shorts, broken = stream_sv.broken;
        p = order(9, 5, 1, 9);
        s = connects(&at_orders);
        sends(s, p.at, n);
        CHECK(receive_at(40) == SM_OK && pal_socket_close(s) == SM_OK && receive_at(40) == SM_OK);
        CHECK(stream_sv.shorts == shorts + (n > 0) && stream_sv.trim == 5 && stream_sv.broken == broken + 1);
    }
    s = connects(&at_orders);                     // a whole message on the next connection is accepted
    sends(s, p.at, p.n);
    CHECK(receive_at(50) == SM_OK && stream_sv.accepted == 3 && stream_sv.trim == 9);
}

// A message that is refused for its values or its number does not lose the boundaries: the connection stays open.
static void test_refused_without_closing(void)
{
    PalSocket s, again;
    Packet p;

    start_receiving();
    s = connects(&at_orders);
    p = order(9, 10, 0.25f, 1);
    sends(s, p.at, p.n);
    CHECK(receive_at(10) == SM_OK && stream_sv.accepted == 1);
    p = order(9, 11, NAN, 2);
    sends(s, p.at, p.n);
    CHECK(receive_at(20) == SM_OK && stream_sv.nans == 1 && stream_sv.trim == 1);
    p = order(9, 10, 0.25f, 3);
    sends(s, p.at, p.n);
    CHECK(receive_at(30) == SM_OK && stream_sv.repeated == 1);
    again = connects(&at_orders);                 // numbers belong to the channel, not to a connection
    sends(again, p.at, p.n);
    p = order(8, 0, 0.25f, 3);                    // another run of the sender, while the channel is not silent
    sends(again, p.at, p.n);
    CHECK(receive_at(40) == SM_OK && stream_sv.repeated == 2 && stream_sv.late == 1 && stream_sv.trim == 1 && stream_sv.broken == 0);
    CHECK(receive_at(211) == SM_OK);
    sends(again, p.at, p.n);                      // the sender was restarted
    CHECK(receive_at(212) == SM_OK && stream_sv.accepted == 2 && stream_sv.trim == 3 && stream_sv.broken == 0);
}

// There is room for two peers.  A third one waits until one of them leaves, or has sent no message for more than a second.
static void test_places(void)
{
    PalSocket s[4];
    Packet p;

    start_receiving();
    for (int i = 0; i < 3; i++) {
        s[i] = connects(&at_orders);
        CHECK(receive_at(10) == SM_OK);
    }
    p = order(9, 0, 0.25f, 1);
    sends(s[2], p.at, p.n);
    CHECK(receive_at(20) == SM_OK && stream_sv.begun == 2 && stream_sv.accepted == 0);
    CHECK(pal_socket_close(s[0]) == SM_OK && receive_at(30) == SM_OK && receive_at(40) == SM_OK);
    CHECK(stream_sv.begun == 3 && stream_sv.accepted == 1 && stream_sv.shorts == 0);
    s[3] = connects(&at_orders);
    CHECK(receive_at(1010) == SM_OK && stream_sv.begun == 3 && !is_closed(s[1]));
    CHECK(receive_at(1011) == SM_OK && stream_sv.begun == 4 && is_closed(s[1]) && !is_closed(s[2]) && !is_closed(s[3]));
    p = order(9, 1, 0.25f, 2);                    // a part of a message does not keep a connection open
    sends(s[3], p.at, 20);
    CHECK(receive_at(1041) == SM_OK && is_closed(s[2]) && receive_at(2012) == SM_OK && is_closed(s[3]));
}

static void test_sealed(void)
{
    static const uint8_t wrong[SM_NET_KEY] = {1};
    PalSocket listening, s;
    Packet p;

    renew();
    listening = listens(&at_secret);
    stream_sv.run = 5;
    CHECK(sm_receive_init(&stream_receive) == SM_OK && receive_at(0) == SM_OK);
    s = accepts(listening);
    p = seal(4, 0, streamKey);                    // of an earlier run of the sender
    sends(s, p.at, p.n);
    CHECK(receive_at(10) == SM_OK && stream_sv.lit == 0 && secret->count[SM_NET_late] == 1 && stream_sv.secretBroken == 0);
    p = seal(6, 0, wrong);
    sends(s, p.at, p.n);
    CHECK(receive_at(20) == SM_OK && stream_sv.lit == 0 && stream_sv.keys == 1 && stream_sv.secretBroken == 1 && is_closed(s));
    CHECK(receive_at(119) == SM_OK && accepts(listening).id == 0 && receive_at(120) == SM_OK);
    s = accepts(listening);
    p = seal(6, 0, streamKey);
    sends(s, p.at, p.n);
    CHECK(receive_at(130) == SM_OK && stream_sv.lit == 1 && stream_sv.run == 6);
}

// ---- sending ----

// A connection that is refused is tried again after 100, 200, 400, ... ms, at most 2 s.
static void test_pauses(void)
{
    static const uint16_t at[] = {0, 100, 300, 700, 1500, 3100, 5100, 7100};
    uint32_t tries = 0;

    start_sending();
    for (uint64_t ms = 0; ms < 8000; ms += 10) {
        CHECK(send_at(ms) == SM_OK);
        tries += tries < 8 && ms == at[tries];
        CHECK(sim_count(SIM_socket_connect_start) == tries);
    }
    CHECK(tries == 8 && stream_sv.reportApart == 799 && stream_sv.reportLost == 799 && stream_sv.reportSent == 0 && stream_sv.reportBegun == 0);
}

static void test_messages(void)
{
    static uint8_t bytes[ROOM];
    PalSocket listening, s;

    renew();
    listening = listens(&at_report);
    stream_sv.pressure = 1.5;
    stream_sv.open = 1;
    CHECK(sm_send_init(&stream_send) == SM_OK && report->message.size == REPORT && beacon->message.size == BEACON);
    CHECK(send_at(0) == SM_OK && send_at(10) == SM_OK);
    s = accepts(listening);
    CHECK(gains(s, bytes) == 2 * REPORT && bytes[0] == 'S' && bytes[12] == 0 && bytes[REPORT + 12] == 1 && bytes[16 + 6] == 0xF8);
    CHECK(sm_crc32(bytes, REPORT) == SM_CRC32_RESIDUE && sm_crc32(bytes + REPORT, REPORT) == SM_CRC32_RESIDUE);
    CHECK(pal_socket_close(s) == SM_OK && send_at(20) == SM_OK && send_at(30) == SM_OK);
    CHECK(stream_sv.reportBroken == 1 && stream_sv.reportLost == 1 && stream_sv.reportSent == 2);
    CHECK(send_at(119) == SM_OK && accepts(listening).id == 0 && send_at(120) == SM_OK && send_at(130) == SM_OK);
    s = accepts(listening);
    CHECK(gains(s, bytes) == 2 * REPORT && bytes[12] == 5 && bytes[8] == (uint8_t)report->next.run);    // the numbers continue
    sends(s, "x", 1);                             // the receiver of a channel must not send
    CHECK(send_at(140) == SM_OK && is_closed(s) && send_at(150) == SM_OK && stream_sv.reportBroken == 2);
}

// A connection is answered late or never.
static void test_slow_connection(void)
{
    PalSocket listening;

    renew();
    listening = listens(&at_report);
    sim_streams((SimStreams){50 * MS, 0, 0});
    CHECK(sm_send_init(&stream_send) == SM_OK && send_at(0) == SM_OK && send_at(10) == SM_OK);
    CHECK(accepts(listening).id == 0);
    sim_advance(50 * MS);
    CHECK(send_at(50) == SM_OK && send_at(60) == SM_OK && accepts(listening).id != 0 && stream_sv.reportSent == 1 && stream_sv.reportApart == 2);
    renew();
    listening = listens(&at_report);
    sim_streams((SimStreams){3600000 * MS, 0, 0});
    CHECK(sm_send_init(&stream_send) == SM_OK && send_at(1999) == SM_OK && sim_count(SIM_socket_connect_start) == 1);
    CHECK(send_at(2000) == SM_OK && send_at(2100) == SM_OK && sim_count(SIM_socket_connect_start) == 2);
}

// After a connection that lasted, the next attempt follows after the shortest pause.  After one that did not, each pause is longer.
static void test_pause_after_connection(void)
{
    PalSocket listening, s;

    renew();
    listening = listens(&at_report);
    CHECK(sm_send_init(&stream_send) == SM_OK);
    CHECK(send_at(0) == SM_OK && pal_socket_close(accepts(listening)) == SM_OK);
    CHECK(send_at(10) == SM_OK && send_at(110) == SM_OK && pal_socket_close(accepts(listening)) == SM_OK);
    CHECK(send_at(120) == SM_OK && send_at(310) == SM_OK && accepts(listening).id == 0 && send_at(320) == SM_OK);
    s = accepts(listening);
    CHECK(send_at(2320) == SM_OK && pal_socket_close(s) == SM_OK && send_at(2330) == SM_OK && send_at(2430) == SM_OK);
    CHECK(accepts(listening).id != 0);
}

// The platform accepts 7 bytes per call.  Messages that become due meanwhile are dropped, and only whole messages arrive.
static void test_parts(void)
{
    static uint8_t bytes[ROOM];
    PalSocket listening, s;
    size_t n = 0;

    renew();
    listening = listens(&at_report);
    sim_streams((SimStreams){0, 7, 0});
    CHECK(sm_send_init(&stream_send) == SM_OK);
    s = accepts(listening);
    for (uint64_t ms = 0; ms <= 400; ms += 10) {
        CHECK(send_at(ms) == SM_OK);
        n += gains(s, bytes + n);
    }
    CHECK(send_at(401) == SM_OK && n / REPORT == 8 && stream_sv.reportSent == n / REPORT);
    for (size_t i = 0; i + REPORT <= n; i += REPORT)
        CHECK(sm_crc32(bytes + i, REPORT) == SM_CRC32_RESIDUE);
    CHECK(stream_sv.reportFull > 20 && stream_sv.reportFull == stream_sv.reportLost && stream_sv.reportApart == 0);
    CHECK(pal_socket_close(s) == SM_OK && send_at(410) == SM_OK && send_at(420) == SM_OK && stream_sv.reportBroken == 1);
    sim_streams((SimStreams){0, 0, 0});
    CHECK(send_at(520) == SM_OK);
    s = accepts(listening);
    CHECK(gains(s, bytes) == REPORT && sm_crc32(bytes, REPORT) == SM_CRC32_RESIDUE);      // nothing of the message on the earlier connection
}

// A peer does not receive: a few messages wait, the others are dropped.
static void test_full(void)
{
    static uint8_t bytes[ROOM];
    PalSocket listening, s;
    size_t n;

    renew();
    listening = listens(&at_report);
    CHECK(sm_send_init(&stream_send) == SM_OK);
    for (uint64_t ms = 0; ms < 1000; ms += 10)
        CHECK(send_at(ms) == SM_OK);
    CHECK(send_at(1001) == SM_OK && stream_sv.reportSent == 4 && stream_sv.reportFull == 96);
    s = accepts(listening);
    n = gains(s, bytes);
    CHECK(n == 4 * REPORT && send_at(1010) == SM_OK && send_at(1011) == SM_OK && stream_sv.reportSent == 5);
}

// A server sends to each of its peers.
static void test_server(void)
{
    static uint8_t bytes[ROOM];
    PalSocket a, b, c;

    start_sending();
    CHECK(send_at(0) == SM_OK);
    a = connects(&at_beacon);
    b = connects(&at_beacon);
    c = connects(&at_beacon);
    CHECK(send_at(10) == SM_OK && send_at(20) == SM_OK && send_at(30) == SM_OK && stream_sv.beaconApart == 1 && stream_sv.beaconSent == 3);
    CHECK(gains(a, bytes) == 3 * BEACON && gains(b, bytes) == 2 * BEACON && gains(c, bytes) == 0 && bytes[12] == 2);
    CHECK(pal_socket_close(a) == SM_OK && send_at(40) == SM_OK && send_at(50) == SM_OK);
    CHECK(gains(b, bytes) == 2 * BEACON && gains(c, bytes) == BEACON);
    a = connects(&at_beacon);
    for (uint64_t ms = 60; ms < 1200; ms += 10) {             // b stops receiving: the waiting peer replaces it
        CHECK(send_at(ms) == SM_OK);
        (void)gains(c, bytes);
    }
    CHECK(gains(a, bytes) > 0 && gains(b, bytes) == 4 * BEACON && is_closed(b) && !is_closed(c));
}

// ---- opening ----

static void test_open(void)
{
    PalSocket taken;

    renew();
    taken = listens(&at_orders);
    CHECK(sm_receive_init(&stream_receive) == SM_E_BUSY && stream_receive.failed == 0);
    CHECK(pal_socket_close(taken) == SM_OK && sm_receive_init(&stream_receive) == SM_OK && receive_at(0) == SM_OK);
    sm_net_close(&stream_receive);
    CHECK(pal_socket_listen(&taken, &at_orders) == SM_OK);                // the socket was closed
    renew();
    sim_fail(SIM_socket_connect_start, 0, SM_E_UNSUPPORTED);              // a platform without connections
    CHECK(sm_send_init(&stream_send) == SM_E_UNSUPPORTED && stream_send.failed == 0);
    renew();
    beacon->peers = 0;
    CHECK(sm_send_init(&stream_send) == SM_E_ARGUMENT && stream_send.failed == 1);
    renew();
    report->peer = NULL;
    CHECK(sm_send_init(&stream_send) == SM_E_ARGUMENT);
    renew();
    sim_break(SIM_socket_accept, 0, SM_E_DEVICE);                         // a failure of this computer is reported
    CHECK(sm_send_init(&stream_send) == SM_OK && send_at(0) == SM_E_DEVICE && stream_send.failed == 1);
}

int main(void)
{
    test_values();
    test_pieces();
    test_flood();
    test_damage();
    test_lengths();
    test_refused_without_closing();
    test_places();
    test_sealed();
    test_pauses();
    test_messages();
    test_slow_connection();
    test_pause_after_connection();
    test_parts();
    test_full();
    test_server();
    test_open();
    return test_end("net-stream");
}
