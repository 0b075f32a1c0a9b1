// SPDX-License-Identifier: Apache-2.0
// Random and mutated packets for the channels of tests/runtime/link.net, in the simulation.  An independent oracle predicts the effect of each
// step: a packet that the oracle refuses changes no element and no age, and is counted under its cause.  `make net-campaign` runs it for an hour
// under the sanitizers.
//     hostile SEED PACKETS [SECONDS]
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "link_net.h"
#include "link.h"
#include "bytecode-vm/target/seal.h"
#include "runtime-c/psl/sim/sim.h"
#include "stdlib/crc32.h"
#include "tests/net/oracle.h"
#include "tests/test.h"

const uint8_t linkKey[SM_NET_KEY] = {9, 8, 7, 6, 5, 4, 3, 2, 1};

enum { COMMANDS = 43, SEALED = 37, ROOM = 1472 };

static const PalAddress to_commands = {{127, 0, 0, 1}, 5001}, to_sealed = {{239, 1, 2, 3}, 5002};
static PalSocket other;
static uint64_t accepted_by_oracle, refused_by_oracle[SM_NET_COUNTS];

// ---- the oracle ----

static bool is_finite_f64(uint64_t bits) { return (bits & 0x7FF0000000000000u) != 0x7FF0000000000000u; }

// Whether each value of the payload is valid in its type: 0 or 1 for BOOL, and no NaN or infinity.  The sealed message has only one BOOL.
static bool has_valid_values(const Oracle *o, const uint8_t *at)
{
    return at[16] <= 1 && (o->sealed || (is_finite_f32(get(at + 17, 4)) && is_finite_f64(get(at + 23, 8))));
}

static bool has_code(const uint8_t *at)
{
    uint8_t code[SM_NET_CODE];

    smvm_seal(at, 17, linkKey, code);
    return at[3] == 1 && memcmp(code, at + 17, sizeof code) == 0;
}

static SmNetCount judge(Oracle *o, const uint8_t *at, size_t n, uint64_t now)
{
    if (n != o->size)
        return n < o->size ? SM_NET_short_ : SM_NET_long_;
    if (get(at, 2) != 0x4D53 || at[2] != 1 || at[3] > 1 || get(at + n - 4, 4) != sm_crc32(at, n - 4))
        return SM_NET_damaged;
    if (get(at + 4, 4) != o->hash)
        return SM_NET_hash;
    if (o->sealed ? !has_code(at) : at[3] != 0)
        return SM_NET_key;
    if (!has_valid_values(o, at))
        return SM_NET_nan;
    return judge_order(o, (uint32_t)get(at + 8, 4), (uint32_t)get(at + 12, 4), now);
}

// ---- packets ----

// Makes a message that is valid or nearly valid: its number is near the newest, and its values are random.
static size_t make_message(const Oracle *o, uint8_t *at)
{
    put(at, 0x4D53, 2);
    at[2] = 1;
    at[3] = o->sealed;
    put(at + 4, below(20) ? o->hash : next_random(), 4);
    put(at + 8, o->run + (below(10) ? 0 : below(4) - 1), 4);
    put(at + 12, o->number + (below(3) ? 1 : below(140) - 70), 4);
    for (size_t i = 16; i < o->size; i++)
        at[i] = below(4) ? (uint8_t)next_random() : below(2) ? 0xFF : 0;
    at[16] = below(20) ? (uint8_t)below(2) : (uint8_t)next_random();
    return o->size;
}

static void mutate(uint8_t *at, size_t *n)
{
    switch (below(5)) {
    case 0: at[below(*n)] = (uint8_t)next_random(); break;
    case 1: at[below(*n)] ^= (uint8_t)(1u << below(8)); break;
    case 2: *n = below(*n + 1); break;
    case 3: *n += below(ROOM - *n + 1); break;
    case 4: at[below(4)] = (uint8_t)below(3); break;
    }
}

static void finish(const Oracle *o, uint8_t *at)
{
    if (o->sealed && below(20))
        smvm_seal(at, 17, linkKey, at + 17);
    put(at + o->size - 4, sm_crc32(at, o->size - 4), 4);
}

static size_t make_packet(const Oracle *o, uint8_t *at)
{
    size_t n = make_message(o, at);
    const bool early = below(3) == 0, late = below(3) == 0;

    if (below(10) == 0) {                         // random bytes
        n = below(10) ? below(80) : below(ROOM + 1);
        for (size_t i = 0; i < n; i++)
            at[i] = (uint8_t)next_random();
        return n;
    }
    if (early)
        mutate(at, &n);
    if (n == o->size)
        finish(o, at);
    if (late && n > 0)
        mutate(at, &n);
    return n;
}

// ---- one round ----

// Checks the elements after a step: they are those of the message if it was accepted, otherwise those before the step.
static void check_elements(const Oracle *o, const uint8_t *at, bool accepted, const LinkSv *before)
{
    if (!accepted) {
        CHECK(o->sealed ? link_sv.lit == before->lit && link_sv.run == before->run
                        : memcmp(&link_sv.vent, &before->vent, (size_t)((const char *)&before->lit - (const char *)&before->vent)) == 0);
        return;
    }
    if (o->sealed) {
        CHECK(link_sv.lit == at[16] && link_sv.run == o->run);
        return;
    }
    CHECK(link_sv.vent == at[16] && memcmp(&link_sv.throttle, at + 17, 4) == 0 && (uint16_t)link_sv.trim == get(at + 21, 2));
    CHECK(memcmp(&link_sv.target, at + 23, 8) == 0 && link_sv.total == get(at + 31, 8));
}

static void play(Oracle *o, SmNetChannel *c, const PalAddress *to, uint64_t now)
{
    static uint8_t at[ROOM];
    const SmTick tick = {now, 0};
    const size_t n = make_packet(o, at);
    uint32_t count[SM_NET_COUNTS];
    LinkSv before = link_sv;
    SmNetCount expected;

    memcpy(count, c->count, sizeof count);
    CHECK(pal_socket_send_to(other, to, at, n) == SM_OK);
    expected = judge(o, at, n, now);
    CHECK(sm_receive_step(&link_receive, &tick) == SM_OK);
    count[expected]++;
    count[SM_NET_refused] += expected != SM_NET_accepted;
    CHECK(memcmp(count, c->count, sizeof count) == 0);
    check_elements(o, at, expected == SM_NET_accepted, &before);
    accepted_by_oracle += expected == SM_NET_accepted;
    refused_by_oracle[expected]++;
}

int main(int n, char **argument)
{
    const PalAddress here = {{10, 0, 0, 2}, 5000};
    const unsigned long packets = n > 2 ? strtoul(argument[2], NULL, 10) : 20000;
    const time_t end = n > 3 ? time(NULL) + strtol(argument[3], NULL, 10) : 0;
    SmNetChannel *channel = link_receive.channel;
    Oracle oracle[2] = {{COMMANDS, channel[0].message.hash, false, false, 0, 0, 0, 0, 100000000u},
                        {SEALED, channel[1].message.hash, true, false, 3, 0, 0, 0, 1000000000u}};
    uint64_t now = 0, played = 0;

    state = n > 1 ? strtoull(argument[1], NULL, 10) * 2654435769u + 1 : 1;
    sim_reset();
    CHECK(sm_statevec_init(&link_vector) == SM_OK && pal_socket_udp(&other, &here) == SM_OK);
    link_sv.run = 3;
    CHECK(sm_receive_init(&link_receive) == SM_OK);
    channel[0].timeout = 100000000u;
    while (played < packets || (end && time(NULL) < end)) {
        const size_t which = below(2);
        // A long pause makes the channels silent.  A step without a packet then stores the values of silence, so that `before` contains them.
        now += below(200) ? 1000000u : 2000000000u;
        CHECK(sm_receive_step(&link_receive, &(SmTick){now, 0}) == SM_OK);
        play(&oracle[which], &channel[which], which ? &to_sealed : &to_commands, now);
        played++;
    }
    CHECK(accepted_by_oracle > played / 20);
    for (int i = SM_NET_short_; i < SM_NET_range; i++)                    // each cause has occurred; this link has no element with a range
        CHECK(refused_by_oracle[i] > 0);
    fprintf(stderr, "%llu packets, %llu accepted\n", (unsigned long long)played, (unsigned long long)accepted_by_oracle);
    return test_end("net-hostile");
}
