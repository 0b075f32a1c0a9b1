// SPDX-License-Identifier: Apache-2.0
// Messages between computers (runtime-c/net.h) of tests/runtime/link.net, in the simulation: the wire form, the causes of refusals and their
// counts, silence, ages, the critical section, floods.
// clause 11.7 clause 11.8 clause 11.9 clause 11.10 clause 11.14 clause 11.15 clause 11.16 clause 11.17 clause 11.18
#include <math.h>
#include <string.h>

#include "link_net.h"
#include "link.h"
#include "bytecode-vm/target/seal.h"
#include "runtime-c/psl/sim/sim.h"
#include "stdlib/crc32.h"
#include "tests/test.h"

const uint8_t linkKey[SM_NET_KEY] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};

enum { COMMANDS = 16 + 1 + 4 + 2 + 8 + 8 + 4, SEALED = 16 + 1 + 16 + 4, TELEMETRY = 16 + 8 + 4 + 1 + 1 + 8 + 2 + 4 };
#define MS 1000000u

static SmNetChannel *commands, *sealed, *telemetry;
static SmNetChannel fresh[3];                 // the channels as generated
static PalSocket other;                       // the socket of the other computer
static const PalAddress to_commands = {{127, 0, 0, 1}, 5001}, to_sealed = {{239, 1, 2, 3}, 5002};

// ---- the other computer, written from the table in net.h alone ----

typedef struct Packet { uint8_t at[64]; size_t n; } Packet;

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

static void put_f32(Packet *p, float x)
{
    uint32_t bits;

    memcpy(&bits, &x, sizeof bits);
    put(p, bits, 4);
}

static void put_f64(Packet *p, double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    put(p, bits, 8);
}

static void finish(Packet *p) { put(p, sm_crc32(p->at, p->n), 4); }

static Packet command(uint32_t run, uint32_t number, uint8_t vent, float throttle, int16_t trim, double target)
{
    Packet p = header(commands->message.hash, false, run, number);

    put(&p, vent, 1);
    put_f32(&p, throttle);
    put(&p, (uint16_t)trim, 2);
    put_f64(&p, target);
    put(&p, UINT64_MAX, 8);
    finish(&p);
    return p;
}

static Packet seal(uint32_t run, uint32_t number, const uint8_t *key)
{
    Packet p = header(sealed->message.hash, true, run, number);

    put(&p, 1, 1);
    smvm_seal(p.at, p.n, key, p.at + p.n);
    p.n += SM_NET_CODE;
    finish(&p);
    return p;
}

static void sends(const PalAddress *to, const Packet *p) { CHECK(pal_socket_send_to(other, to, p->at, p->n) == SM_OK); }

// ---- the application ----

static SmResult step_at(uint64_t ms)
{
    const SmTick tick = {ms * MS, ms / 10};

    return sm_receive_step(&link_receive, &tick);
}

static void renew(void)
{
    const PalAddress here = {{10, 0, 0, 2}, 5000};

    sim_reset();
    memset(&link_sv, 0, sizeof link_sv);
    if (!commands) {
        CHECK(link_receive.channels == 2 && link_send.channels == 1);
        memcpy(fresh, link_receive.channel, 2 * sizeof *fresh);
        fresh[2] = link_send.channel[0];
    }
    memcpy(link_receive.channel, fresh, 2 * sizeof *fresh);
    link_send.channel[0] = fresh[2];
    commands = &link_receive.channel[0];
    sealed = &link_receive.channel[1];
    telemetry = &link_send.channel[0];
    CHECK(sm_statevec_init(&link_vector) == SM_OK);
    CHECK(pal_socket_udp(&other, &here) == SM_OK);
}

static void start(void)
{
    renew();
    link_sv.trim = 7;
    link_sv.run = 5;
    CHECK(sm_receive_init(&link_receive) == SM_OK);
}

// Sends p, runs a step, and checks that only two counts have changed: that of the cause, and the sum of all refused packets, by one each.
static void refused(uint64_t ms, const PalAddress *to, const Packet *p, uint32_t *cause)
{
    LinkSv before = link_sv;
    const uint32_t was = *cause, all = link_sv.refused;

    sends(to, p);
    CHECK(step_at(ms) == SM_OK);
    CHECK(*cause == was + 1);
    CHECK(link_sv.refused == all + (to == &to_commands));
    *cause = was;
    link_sv.refused = all;
    before.age = link_sv.age;
    CHECK(memcmp(&before, &link_sv, sizeof before) == 0);
    *cause = was + 1;
    link_sv.refused = all + (to == &to_commands);
}

// ---- receiving ----

static void test_values(void)
{
    Packet p;

    start();
    CHECK(link_sv.vent == 1);                     // the @safe value, from the start
    CHECK(link_sv.throttle == 0 && link_sv.trim == 7 && link_sv.age == 65535);
    p = command(9, 0, 0, 0.25f, -300, 12.5);
    CHECK(p.n == COMMANDS && commands->message.size == COMMANDS);
    sends(&to_commands, &p);
    CHECK(step_at(10) == SM_OK);
    CHECK(link_sv.vent == 0 && link_sv.throttle == 0.25f && link_sv.trim == -300 && link_sv.target == 12.5);
    CHECK(link_sv.total == UINT64_MAX && link_sv.accepted == 1 && link_sv.refused == 0 && link_sv.age == 0);
    CHECK(step_at(110) == SM_OK);
    CHECK(link_sv.age == 100 && link_sv.vent == 0 && link_sv.throttle == 0.25f);        // not yet silent
    CHECK(step_at(120) == SM_OK);
    CHECK(link_sv.age == 110 && link_sv.vent == 1 && link_sv.throttle == 0.5f && link_sv.trim == -300);
    CHECK(isnan(link_sv.target) && link_sv.total == 0);
    p = command(9, 1, 1, 1, 1, 1);
    sends(&to_commands, &p);
    CHECK(step_at(130) == SM_OK);
    CHECK(link_sv.vent == 1 && link_sv.throttle == 1 && link_sv.trim == 1 && link_sv.target == 1 && link_sv.age == 0);
}

// A count and an age stop at the largest value of their elements' types.
static void test_largest(void)
{
    Packet p;

    start();
    p = command(9, 0, 0, 1, 1, 1);
    sends(&to_commands, &p);
    CHECK(step_at(10) == SM_OK && link_sv.accepted == 1);
    commands->count[SM_NET_accepted] = 300;
    CHECK(step_at(70010) == SM_OK && link_sv.accepted == 255 && link_sv.age == 65535);
}

static void test_silent_from_the_start(void)
{
    start();
    CHECK(step_at(100) == SM_OK && link_sv.throttle == 0);
    CHECK(step_at(101) == SM_OK && link_sv.throttle == 0.5f && link_sv.trim == 7 && isnan(link_sv.target));
    CHECK(link_sv.age == 65535);
}

static void test_refused(void)
{
    Packet good, p;

    start();
    good = command(9, 10, 0, 0.25f, 3, 1);
    sends(&to_commands, &good);
    CHECK(step_at(10) == SM_OK && link_sv.accepted == 1);
    refused(20, &to_commands, &good, &link_sv.repeated);
    p = command(9, 9, 1, 1, 1, 1);
    refused(20, &to_commands, &p, &link_sv.late);
    p = command(8, 11, 1, 1, 1, 1);               // another run of the sender, while the channel is not silent
    refused(20, &to_commands, &p, &link_sv.late);
    p = command(9, 10 + 0x80000000u, 1, 1, 1, 1);
    refused(20, &to_commands, &p, &link_sv.late);
    p = command(9, 11, 1, NAN, 1, 1);
    refused(20, &to_commands, &p, &link_sv.nans);
    p = command(9, 11, 1, 1, 1, -INFINITY);
    refused(20, &to_commands, &p, &link_sv.nans);
    p = command(9, 11, 2, 1, 1, 1);
    refused(20, &to_commands, &p, &link_sv.nans);
    p = command(9, 11, 1, 1, 1, 1);
    for (size_t n = 0; n < COMMANDS; n++) {       // every length
        p.n = n;
        refused(20, &to_commands, &p, &link_sv.shorts);
    }
    p.n = COMMANDS + 1;
    refused(20, &to_commands, &p, &link_sv.longs);
    p.n = COMMANDS;
    for (size_t bit = 0; bit < 8 * COMMANDS; bit++) {            // every bit
        p.at[bit / 8] ^= (uint8_t)(1 << bit % 8);
        refused(20, &to_commands, &p, &link_sv.damaged);
        p.at[bit / 8] ^= (uint8_t)(1 << bit % 8);
    }
    p = header(commands->message.hash + 1, false, 9, 11);
    p.n = COMMANDS - 4;
    finish(&p);
    refused(20, &to_commands, &p, &link_sv.hashes);
    CHECK(link_sv.age == 10);
    p = command(9, 11, 1, 1, 1, 1);               // none of the refused packets has used up the number
    sends(&to_commands, &p);
    CHECK(step_at(30) == SM_OK && link_sv.accepted == 2 && link_sv.age == 0);
}

static void test_restart_of_the_sender(void)
{
    Packet p;

    start();
    p = command(9, 1000, 0, 1, 1, 1);
    sends(&to_commands, &p);
    CHECK(step_at(10) == SM_OK && link_sv.accepted == 1);
    p = command(10, 0, 0, 1, 1, 1);
    sends(&to_commands, &p);
    CHECK(step_at(110) == SM_OK && link_sv.accepted == 1 && link_sv.late == 1);
    sends(&to_commands, &p);
    CHECK(step_at(111) == SM_OK && link_sv.accepted == 2 && link_sv.age == 0);
}

// The window of the numbers that were received, beyond its end and at the wrap.
static void test_order(void)
{
    SmNetOrder o = {0};
    const SmNetStamp a = {1, UINT32_MAX - 1}, b = {1, 1}, c = {1, UINT32_MAX}, d = {1, 64}, e = {1, 200};

    CHECK(sm_net_order(&o, a, false, false) == SM_NET_accepted);
    CHECK(sm_net_order(&o, b, false, false) == SM_NET_accepted);
    CHECK(sm_net_order(&o, c, false, false) == SM_NET_late);
    CHECK(sm_net_order(&o, a, false, false) == SM_NET_repeated);
    CHECK(sm_net_order(&o, d, false, false) == SM_NET_accepted);
    CHECK(sm_net_order(&o, b, false, false) == SM_NET_repeated);
    CHECK(sm_net_order(&o, a, false, false) == SM_NET_late);              // too old to be distinguished
    CHECK(sm_net_order(&o, e, false, false) == SM_NET_accepted);
    CHECK(sm_net_order(&o, d, false, true) == SM_NET_late);               // the same run, even if the channel is silent
}

static void test_sealed(void)
{
    static const uint8_t wrong[SM_NET_KEY] = {1};
    Packet p, old;

    start();
    CHECK(sealed->message.size == SEALED);
    p = seal(4, 0, linkKey);                      // of an earlier run than the one that the channel has accepted
    sends(&to_sealed, &p);
    CHECK(step_at(10) == SM_OK && link_sv.lit == 0 && sealed->count[SM_NET_late] == 1);
    p = seal(6, 0, wrong);
    refused(10, &to_sealed, &p, &link_sv.keys);
    p = seal(6, 0, linkKey);
    p.at[3] = 0;                                  // marked as not sealed
    p.n -= 4;
    finish(&p);
    refused(10, &to_sealed, &p, &link_sv.keys);
    old = seal(6, 3, linkKey);
    sends(&to_sealed, &old);
    CHECK(step_at(10) == SM_OK && link_sv.lit == 1 && link_sv.run == 6);
    p = seal(7, 0, linkKey);
    sends(&to_sealed, &p);
    CHECK(step_at(20) == SM_OK && link_sv.run == 7 && sealed->count[SM_NET_accepted] == 2);
    sends(&to_sealed, &old);                      // a replay after an hour of silence
    CHECK(step_at(3600000) == SM_OK && sealed->count[SM_NET_accepted] == 2 && sealed->count[SM_NET_late] == 2 && link_sv.run == 7);
}

// A flood: a step reads at most SM_NET_BURST packets, of which the newest one counts.
static void test_flood(void)
{
    start();
    for (uint32_t i = 0; i < 40; i++) {
        Packet p = command(9, i, 0, (float)i, 1, 1);
        sends(&to_commands, &p);
    }
    CHECK(step_at(10) == SM_OK && link_sv.accepted == SM_NET_BURST && link_sv.throttle == SM_NET_BURST - 1);
    CHECK(sim_count(SIM_socket_receive_from) == SM_NET_BURST + 1);        // and one call for the other channel
}

// While the lock cannot be taken, nothing changes.  The next step stores what has arrived.
static void test_lock(void)
{
    Packet p;

    start();
    p = command(9, 0, 0, 0.25f, 1, 1);
    sends(&to_commands, &p);
    sim_fail(SIM_lock_take, 0, SM_E_TIMEOUT);
    CHECK(step_at(10) == SM_E_TIMEOUT && link_sv.throttle == 0 && link_sv.accepted == 0);
    CHECK(step_at(20) == SM_OK && link_sv.throttle == 0.25f && link_sv.accepted == 1 && link_sv.age == 10);
}

static void test_failing_socket(void)
{
    Packet p;

    start();
    p = seal(6, 0, linkKey);
    sends(&to_sealed, &p);
    sim_fail(SIM_socket_receive_from, 0, SM_E_DEVICE);
    CHECK(step_at(10) == SM_E_DEVICE && link_receive.failed == 0 && link_sv.lit == 1);       // the other channel is served
}

static void test_open(void)
{
    SmNetField field;
    PalSocket first;

    renew();
    CHECK(pal_socket_udp(&first, &to_commands) == SM_OK);
    CHECK(sm_receive_init(&link_receive) == SM_E_BUSY && link_receive.failed == 0);
    renew();
    sim_fail(SIM_socket_multicast, 0, SM_E_MISSING);
    CHECK(sm_receive_init(&link_receive) == SM_E_MISSING && link_receive.failed == 1);
    CHECK(sm_receive_init(&link_receive) == SM_OK);                       // the sockets were closed
    sm_net_close(&link_receive);
    renew();
    field = commands->message.field[0];
    commands->message.field = &field;
    commands->message.fields = 1;
    commands->message.size = 21;
    field.offset = sizeof link_sv;                                        // outside the vector
    CHECK(sm_receive_init(&link_receive) == SM_E_ARGUMENT);
    CHECK(sm_receive_init(NULL) == SM_E_ARGUMENT);
}

// ---- sending ----

static size_t next_sent(uint8_t *bytes)
{
    size_t n = 0;

    return pal_socket_receive_from(other, NULL, bytes, 64, &n, 0) == SM_OK ? n : 0;
}

static SmResult send_at(uint64_t ms)
{
    const SmTick tick = {ms * MS, ms / 10};

    return sm_send_step(&link_send, &tick);
}

static void test_sending(void)
{
    static const uint8_t values[] = {0, 0, 0, 0, 0, 0, 0xF8, 0x3F, 0, 0, 0, 0xC0, 1, 0xFB, 0xFE, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x34, 0x12};
    uint8_t bytes[64];

    renew();
    link_sv.pressure = 1.5;
    link_sv.flow = -2;
    link_sv.open = 1;
    link_sv.tiny = -5;
    link_sv.wide = -2;
    link_sv.level = 0x1234;
    CHECK(sm_send_init(&link_send) == SM_OK && send_at(0) == SM_OK);
    CHECK(next_sent(bytes) == TELEMETRY && memcmp(bytes + SM_NET_HEADER, values, sizeof values) == 0);
    CHECK(bytes[0] == 'S' && bytes[1] == 'M' && bytes[2] == 1 && bytes[3] == 0 && bytes[12] == 0);
    CHECK(sm_crc32(bytes, TELEMETRY) == SM_CRC32_RESIDUE);
    CHECK(send_at(10) == SM_OK && next_sent(bytes) == 0);                 // one message every 20 ms
    CHECK(send_at(20) == SM_OK && next_sent(bytes) == TELEMETRY && bytes[12] == 1);
    CHECK(send_at(60) == SM_OK && next_sent(bytes) == TELEMETRY && next_sent(bytes) == 0);      // a missed period is not sent later
    CHECK(send_at(70) == SM_OK && link_sv.sent == 3);
}

// A value that a receiver would refuse is not sent: NaN becomes 0, an infinity becomes the largest finite number.
static void test_sent_is_acceptable(void)
{
    uint64_t value[8];
    SmNetStamp stamp;
    uint8_t bytes[64];

    renew();
    link_sv.pressure = NAN;
    link_sv.flow = -INFINITY;
    CHECK(sm_send_init(&link_send) == SM_OK && send_at(0) == SM_OK && next_sent(bytes) == TELEMETRY);
    CHECK(sm_net_check(&telemetry->message, bytes, TELEMETRY, &stamp) == SM_NET_accepted);
    sm_net_values(&telemetry->message, bytes, value);
    CHECK(value[0] == 0 && value[1] == 0xFF7FFFFFu);
    link_sv.pressure = 1001;                                              // sent unchanged; the receiver refuses it
    CHECK(send_at(20) == SM_OK && next_sent(bytes) == TELEMETRY);
    CHECK(sm_net_check(&telemetry->message, bytes, TELEMETRY, &stamp) == SM_NET_range);
}

static void test_lost(void)
{
    renew();
    CHECK(sm_send_init(&link_send) == SM_OK);
    sim_fail(SIM_socket_send_to, 0, SM_E_UNREACHABLE);
    CHECK(send_at(0) == SM_E_UNREACHABLE && send_at(20) == SM_OK && send_at(30) == SM_OK);
    CHECK(link_sv.lost == 1 && link_sv.sent == 1);
}

int main(void)
{
    test_values();
    test_largest();
    test_silent_from_the_start();
    test_refused();
    test_restart_of_the_sender();
    test_order();
    test_sealed();
    test_flood();
    test_lock();
    test_failing_socket();
    test_open();
    test_sending();
    test_sent_is_acceptable();
    test_lost();
    return test_end("net");
}
