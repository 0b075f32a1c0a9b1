// SPDX-License-Identifier: Apache-2.0
// Hostile peers for the messages over TCP of tests/runtime/stream.net, in the simulation.  Messages are random, mutated, cut and lengthened, and
// arrive in pieces of any size.  Connections end anywhere, and a receiver reads slowly, leaves, or answers.  An independent oracle divides the
// bytes into messages.  It predicts which messages are accepted, the cause of each refusal, and which connections are closed.  No step may
// block.  `make net-campaign` runs it under the sanitizers.
//     hostile_stream SEED ROUNDS [SECONDS]
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "stream_net.h"
#include "stream.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/sim/sim.h"
#include "stdlib/crc32.h"
#include "tests/net/oracle.h"
#include "tests/test.h"

const uint8_t streamKey[SM_NET_KEY] = {1};

enum { ORDERS = 34, REPORT = 37, PEERS = 2, MOST = 8, ROOM = 4096 };
#define MS ((uint64_t)1000000)

static const PalAddress at_orders = {{127, 0, 0, 1}, 6003}, at_report = {{10, 0, 0, 1}, 6001};

// ---- the oracle of what is received ----

typedef struct Peer {
    PalSocket socket;         // the socket of the simulated peer; 0: not connected
    bool closed;              // the oracle predicts that the receiver closes the connection
    uint8_t part[ORDERS];
    size_t n;
    uint64_t used;            // nanoseconds: the time when the connection was opened or its last message was accepted
} Peer;

static Peer peer[PEERS];
static Oracle oracle = {ORDERS, 0, false, false, 0, 0, 0, 0, 200 * MS};
static uint64_t count[SM_NET_COUNTS], total[SM_NET_COUNTS];              // predicted counts: of this round; of all rounds
static uint8_t accepted[MOST * 3][14];    // the elements that a step can show: those before it, then those after each accepted message
static size_t states;

static SmNetCount judge_header(const uint8_t *at)
{
    if (get(at, 2) != 0x4D53 || at[2] != 1 || at[3] > 1)
        return SM_NET_damaged;
    return get(at + 4, 4) == oracle.hash ? SM_NET_accepted : SM_NET_hash;
}

static SmNetCount judge(const uint8_t *at, uint64_t now)
{
    if (get(at + ORDERS - 4, 4) != sm_crc32(at, ORDERS - 4))
        return SM_NET_damaged;
    if (at[3] != 0)
        return SM_NET_key;
    return is_finite_f32(get(at + 16, 4)) ? judge_order(&oracle, (uint32_t)get(at + 8, 4), (uint32_t)get(at + 12, 4), now) : SM_NET_nan;
}

static void judge_byte(Peer *p, uint8_t byte, uint64_t now)
{
    SmNetCount cause = SM_NET_accepted;

    p->part[p->n++] = byte;
    if (p->n == 16)
        cause = judge_header(p->part);
    if (cause == SM_NET_accepted && p->n < ORDERS)
        return;
    if (cause == SM_NET_accepted) {
        cause = judge(p->part, now);
        p->n = 0;
    }
    count[cause]++;
    if (cause == SM_NET_accepted) {
        memcpy(accepted[states++], p->part + 16, 14);
        p->used = now;
    } else {
        count[SM_NET_refused]++;
        p->closed = cause == SM_NET_damaged || cause == SM_NET_hash || cause == SM_NET_key;
    }
}

// ---- bytes ----

static size_t make_message(uint8_t *at)
{
    put(at, 0x4D53, 2);
    at[2] = 1;
    at[3] = below(40) == 0;
    put(at + 4, below(40) ? oracle.hash : next_random(), 4);
    put(at + 8, oracle.run + (below(20) ? 0 : below(4) - 1), 4);
    put(at + 12, oracle.number + (below(4) ? 1 : below(140) - 70), 4);
    for (size_t i = 16; i < ORDERS; i++)
        at[i] = below(4) ? (uint8_t)next_random() : below(2) ? 0xFF : 0;
    put(at + ORDERS - 4, sm_crc32(at, ORDERS - 4), 4);
    return ORDERS;
}

static size_t mutate(uint8_t *at, size_t n)
{
    switch (below(5)) {
    case 0: at[below(n)] = (uint8_t)next_random(); return n;
    case 1: at[below(n)] ^= (uint8_t)(1u << below(8)); return n;
    case 2: return below(n + 1);
    case 3: return n + below(40);
    default: memmove(at, at + 1, n - 1); return n - 1;
    }
}

// Makes bytes that a connection sends next: messages, few of them changed, or random bytes.
static size_t make_bytes(uint8_t *at)
{
    size_t n = 0;

    if (below(30) == 0) {
        for (n = 0; n < 200; n++)
            at[n] = (uint8_t)next_random();
        return 1 + below(n);
    }
    for (size_t messages = 1 + below(MOST); messages > 0; messages--) {
        const size_t size = make_message(at + n);
        n += below(15) ? size : mutate(at + n, size);
    }
    return n;
}

// ---- the receiver ----

static size_t read_elements(uint8_t *at)
{
    memcpy(at, &stream_sv.throttle, 4);
    put(at + 4, (uint16_t)stream_sv.trim, 2);
    put(at + 6, stream_sv.wide, 8);
    return 14;
}

static void step(uint64_t now)
{
    const SmTick tick = {now, 0};
    const uint64_t before = pal_clock_now();

    CHECK(sm_receive_step(&stream_receive, &tick) == SM_OK);
    CHECK(pal_clock_now() == before);
}

// Steps until all bytes have been received or dropped.  The receiver must see only whole messages, however the bytes are divided.
static void settle(uint64_t now, size_t bytes)
{
    for (size_t i = 0; i < bytes + 2; i++) {
        uint8_t at[14];
        bool known = false;
        step(now);
        read_elements(at);
        for (size_t k = 0; k < states; k++)
            known = known || memcmp(at, accepted[k], sizeof at) == 0;
        CHECK(known);
    }
}

static bool is_closed(PalSocket s)
{
    uint8_t byte;
    size_t n = 0;

    return pal_socket_receive(s, &byte, 1, &n, 0) == SM_E_CLOSED;
}

static void leave(Peer *p, uint64_t now)
{
    if (p->n > 0) {
        count[SM_NET_short_]++;
        count[SM_NET_refused]++;
    }
    CHECK(pal_socket_close(p->socket) == SM_OK);
    memset(p, 0, sizeof *p);
    step(now);
}

static void join(Peer *p, uint64_t now)
{
    CHECK(pal_socket_connect(&p->socket, &at_orders, 0) == SM_OK);
    p->used = now;
    step(now);
}

// A receiver with a timeout closes a connection on which no message arrived in the last second.
static void end_silent_peers(uint64_t now)
{
    for (Peer *p = peer; p < peer + PEERS; p++)
        if (p->socket.id && now - p->used > 1000 * MS) {
            CHECK(is_closed(p->socket) && pal_socket_close(p->socket) == SM_OK);
            memset(p, 0, sizeof *p);
        }
}

static void send_round(Peer *p, uint64_t now)
{
    static uint8_t at[ROOM];
    size_t n = make_bytes(at), sent = 0;

    CHECK(pal_socket_send(p->socket, at, n, &sent, 0) == SM_OK && sent == n);
    for (size_t i = 0; i < n && !p->closed; i++)
        judge_byte(p, at[i], now);
    settle(now, n);
    CHECK(is_closed(p->socket) == p->closed);
    if (p->closed) {
        CHECK(pal_socket_close(p->socket) == SM_OK);
        memset(p, 0, sizeof *p);
    }
}

static void receive_round(uint64_t now)
{
    SmNetChannel *c = stream_receive.channel;
    Peer *p = &peer[below(PEERS)];
    uint32_t before[SM_NET_COUNTS];

    step(now);
    end_silent_peers(now);
    memcpy(before, c->count, sizeof before);
    memset(count, 0, sizeof count);
    states = 1;
    read_elements(accepted[0]);
    sim_streams((SimStreams){0, 0, below(3) ? 0 : 1 + (uint32_t)below(50)});
    if (!p->socket.id)
        join(p, now);
    if (below(20) == 0)
        leave(p, now);
    else
        send_round(p, now);
    for (int i = 0; i < SM_NET_COUNTS; i++) {
        if (i != SM_NET_connected && i != SM_NET_broken)
            CHECK(c->count[i] - before[i] == count[i]);
        total[i] += count[i];
    }
}

// ---- the sender ----

static PalSocket listening, far;
static uint8_t arrived[ROOM];
static size_t arrived_n;
static uint32_t newest;
static bool any_arrived;
static uint64_t messages, connections, leaves;

// Checks the messages of one connection: whole, undamaged, and each newer than the one before.  Returns whether the connection exists.
static bool read_messages(void)
{
    size_t n = 0;
    const SmResult r = pal_socket_receive(far, arrived + arrived_n, 1 + below(ROOM - arrived_n), &n, 0);

    arrived_n += n;
    while (arrived_n >= REPORT) {
        const uint32_t number = (uint32_t)get(arrived + 12, 4);
        CHECK(get(arrived, 2) == 0x4D53 && sm_crc32(arrived, REPORT) == SM_CRC32_RESIDUE && get(arrived + 16, 8) == get(arrived + 24, 8));
        CHECK(!any_arrived || (int32_t)(number - newest) > 0);
        newest = number;
        any_arrived = true;
        messages++;
        arrived_n -= REPORT;
        memmove(arrived, arrived + REPORT, arrived_n);
    }
    return r != SM_E_CLOSED;
}

static void hang_up(void)
{
    CHECK(pal_socket_close(far) == SM_OK);
    far.id = 0;
    arrived_n = 0;
    leaves++;
}

static void send_step(uint64_t now)
{
    const SmTick tick = {now, 0};
    const uint64_t before = pal_clock_now(), bits = next_random() & 0x3FEFFFFFFFFFFFFFu;
    size_t sent;

    memcpy(&stream_sv.pressure, &bits, sizeof bits);
    stream_sv.wide2 = (int64_t)bits;
    sim_streams((SimStreams){below(2) ? 0 : before % (30 * MS), below(3) ? 0 : 1 + (uint32_t)below(40), 0});
    CHECK(sm_send_step(&stream_send, &tick) == SM_OK);
    CHECK(pal_clock_now() == before);
    if (!far.id && below(3) && pal_socket_accept(listening, &far, NULL, 0) == SM_OK)
        connections++;
    if (far.id && below(3) && !read_messages())
        hang_up();
    if (far.id && below(100) == 0)
        (void)pal_socket_send(far, "?", 1, &sent, 0);
    if (far.id && below(100) == 0)
        hang_up();
    if (below(200) == 0) {                        // the server refuses connections for some time
        CHECK(pal_socket_close(listening) == SM_OK);
        CHECK(pal_socket_listen(&listening, &at_report) == SM_OK);
    }
}

// Every message was sent or lost.  Every lost message has a counted cause, unless its connection broke.
static void check_sums(void)
{
    const uint32_t *c = stream_send.channel[0].count;
    const uint32_t pending = stream_send.channel[0].peer[0].n > 0;

    CHECK(c[SM_NET_sent] + c[SM_NET_lost] + pending == stream_send.channel[0].next.number);
    CHECK(c[SM_NET_full] + c[SM_NET_unconnected] <= c[SM_NET_lost] && c[SM_NET_lost] <= c[SM_NET_full] + c[SM_NET_unconnected] + c[SM_NET_broken]);
    CHECK(messages <= c[SM_NET_sent] && c[SM_NET_broken] <= c[SM_NET_connected]);
}

int main(int n, char **argument)
{
    const unsigned long rounds = n > 2 ? strtoul(argument[2], NULL, 10) : 2000;
    const time_t end = n > 3 ? time(NULL) + strtol(argument[3], NULL, 10) : 0;
    uint64_t now = 0, sent_at = 0, played = 0;

    state = n > 1 ? strtoull(argument[1], NULL, 10) * 2654435769u + 1 : 1;
    sim_reset();
    CHECK(sm_statevec_init(&stream_vector) == SM_OK && pal_socket_listen(&listening, &at_report) == SM_OK);
    CHECK(sm_receive_init(&stream_receive) == SM_OK && sm_send_init(&stream_send) == SM_OK);
    oracle.hash = stream_receive.channel[0].message.hash;
    while (played < rounds || (end && time(NULL) < end)) {
        now += below(50) ? 1 * MS : below(2) ? 300 * MS : 1500 * MS;
        receive_round(now);
        for (int i = 0; i < 8; i++) {
            sim_advance(10 * MS);
            send_step(sent_at += 10 * MS);
        }
        check_sums();
        played++;
    }
    CHECK(total[SM_NET_accepted] > played / 2);
    CHECK(total[SM_NET_short_] > 0 && total[SM_NET_damaged] > 0 && total[SM_NET_hash] > 0 && total[SM_NET_key] > 0);
    CHECK(total[SM_NET_repeated] > 0 && total[SM_NET_late] > 0 && total[SM_NET_nan] > 0);
    CHECK(messages > played && connections > played / 100 && leaves > played / 100);
    CHECK(stream_send.channel[0].count[SM_NET_full] > 0 && stream_send.channel[0].count[SM_NET_unconnected] > 0);
    fprintf(stderr, "%llu rounds, %llu messages accepted, %llu refused, %llu sent over %llu connections\n", (unsigned long long)played,
            (unsigned long long)total[SM_NET_accepted], (unsigned long long)total[SM_NET_refused], (unsigned long long)messages,
            (unsigned long long)connections);
    return test_end("net-hostile-stream");
}
