// SPDX-License-Identifier: Apache-2.0
// Frames of the link: sent frames arrive, damaged ones do not, and after any damage the next frame arrives.
#include <string.h>

#include "runtime-c/link/link.h"
#include "runtime-c/link/transition.h"
#include "tests/test.h"
#include "tests/unit/random.h"

enum { BODY = LINK_BODY_MAX, ROOM = LINK_ROOM(BODY) };

typedef struct Line { uint8_t bytes[ROOM]; uint16_t n, payload; uint8_t sent[ROOM]; } Line;

// A frame of n payload bytes; kind 0: random, 1: all zero, 2: without a zero, 3: mostly zero
static void make_frame(Line *l, uint16_t n, unsigned kind)
{
    l->payload = n;
    for (uint16_t i = 0; i < n; i++) {
        const uint8_t r = (uint8_t)random_u64();
        l->sent[i] = kind == 1 ? 0 : kind == 2 ? (uint8_t)(r | 1) : kind == 3 ? (uint8_t)(r & r >> 3 & r >> 5 & 1) : r;
    }
    memcpy(l->bytes + 1, l->sent, n);
    l->n = sm_link_encode(l->bytes, n);
}

static bool frame_arrives(LinkReceiver *r, const Line *l)
{
    bool whole = false;

    for (uint16_t i = 0; i < l->n; i++)
        whole = sm_link_receive(r, l->bytes[i]);
    return whole && r->n == l->payload && memcmp(r->buffer, l->sent, l->payload) == 0;
}

static void test_sent_frame_arrives(void)
{
    uint8_t buffer[ROOM];
    LinkReceiver r;
    Line l;

    sm_link_receiver_init(&r, buffer, sizeof buffer);
    for (uint16_t n = LINK_HEAD; n <= LINK_HEAD + BODY; n++)
        for (unsigned kind = 0; kind < 4; kind++) {
            make_frame(&l, n, kind);
            CHECK(l.n == n + LINK_TAIL + 2 && memchr(l.bytes, 0, l.n) == l.bytes + l.n - 1);
            CHECK(frame_arrives(&r, &l));
        }
}

// Damage: a byte is lost, repeated or changed.  A sent frame must never arrive with another content.
static void damage(Line *l)
{
    const uint16_t at = (uint16_t)(random_u64() % l->n);

    switch (random_u64() % 3) {
    case 0: memmove(l->bytes + at, l->bytes + at + 1, l->n - at - 1u); l->n--; break;
    case 1: memmove(l->bytes + at + 1, l->bytes + at, l->n - at - 1u); break;
    default: l->bytes[at] ^= (uint8_t)(1 + random_u64() % 255); break;
    }
}

static void test_damaged_frame_is_dropped(void)
{
    uint8_t buffer[ROOM];
    LinkReceiver r;
    Line good, bad;

    sm_link_receiver_init(&r, buffer, sizeof buffer);
    for (unsigned i = 0; i < 20000; i++) {
        make_frame(&good, (uint16_t)(LINK_HEAD + random_u64() % BODY), i % 4);
        bad = good;
        damage(&bad);
        for (uint16_t k = 0; k < bad.n; k++)
            CHECK(!sm_link_receive(&r, bad.bytes[k]) || (r.n == bad.payload && memcmp(r.buffer, bad.sent, r.n) == 0));
        sm_link_receive(&r, 0);
        CHECK(frame_arrives(&r, &good));
    }
}

static void test_too_long_frame_is_dropped(void)
{
    uint8_t buffer[LINK_ROOM(16)];
    LinkReceiver r;
    Line l;

    sm_link_receiver_init(&r, buffer, LINK_HEAD + 16 + LINK_TAIL);
    make_frame(&l, LINK_HEAD + 17, 0);
    CHECK(!frame_arrives(&r, &l));
    make_frame(&l, LINK_HEAD + 16, 0);
    CHECK(frame_arrives(&r, &l));
    for (unsigned i = 0; i < 100000; i++)
        CHECK(!sm_link_receive(&r, (uint8_t)(1 + random_u64() % 255)));
    sm_link_receive(&r, 0);
    CHECK(frame_arrives(&r, &l));
    CHECK(!sm_link_receive(&r, 0) && !sm_link_receive(&r, 0));
}

// A frame of n payload bytes, with no zero in them or in their checksum: COBS encodes it as one block.
static void make_one_block(Line *l, uint16_t n)
{
    do
        make_frame(l, n, 2);
    while (memchr(l->bytes + 1, 0, l->n - 2u) || l->bytes[0] != l->n - 1);
}

// A block that ends too early: bytes are missing, although the checksum of the others is correct.
static void test_truncated_frame_is_dropped(void)
{
    uint8_t buffer[ROOM];
    LinkReceiver r;
    Line l;

    sm_link_receiver_init(&r, buffer, sizeof buffer);
    for (unsigned more = 1; more < 100; more++) {
        make_one_block(&l, 20);
        l.bytes[0] = (uint8_t)(l.bytes[0] + more);
        CHECK(!frame_arrives(&r, &l));
        l.bytes[0] = (uint8_t)(l.bytes[0] - more);
        CHECK(frame_arrives(&r, &l));
    }
}

// A frame longer than the buffer, whose beginning would be a valid frame.
static void test_too_long_frame_with_good_beginning_is_dropped(void)
{
    uint8_t buffer[LINK_HEAD + 16 + LINK_TAIL];
    LinkReceiver r;
    Line l;

    sm_link_receiver_init(&r, buffer, sizeof buffer);
    for (unsigned more = 1; more < 50; more++) {
        make_one_block(&l, LINK_HEAD + 16);
        memset(l.bytes + l.n - 1, 0x55, more);
        l.bytes[0] = (uint8_t)(l.bytes[0] + more);
        l.n = (uint16_t)(l.n + more);
        l.bytes[l.n - 1] = 0;
        CHECK(!frame_arrives(&r, &l));
        make_frame(&l, LINK_HEAD + 16, 0);
        CHECK(frame_arrives(&r, &l));
    }
}

static void test_fields_are_read_back(void)
{
    uint8_t at[4];

    sm_link_store(at, 0x01020304u, 4);
    CHECK(at[0] == 4 && at[3] == 1 && sm_link_load(at, 4) == 0x01020304u && sm_link_load(at, 3) == 0x020304u);
}

// A stored record is read unchanged.  If a bit is changed, or if it belongs to another image, it is refused.
static void test_transitions_are_read_back(void)
{
    static const LinkTransition t = {255, 15, LINK_LOST_MAX, 0x1234, 0xfedc, 0x89abcdef};
    uint8_t record[LINK_TRANSITION];
    LinkTransition read;

    sm_link_store_transition(record, &t, 0xdeadbeef);
    CHECK(sm_link_load_transition(record, 0xdeadbeef, &read) && read.number == t.number && read.machine == t.machine && read.lost == t.lost);
    CHECK(read.from == t.from && read.to == t.to && read.time == t.time && !sm_link_load_transition(record, 0xdeadbeee, &read));
    for (unsigned i = 0; i < sizeof record; i++)
        for (unsigned bit = 1; bit < 256; bit *= 2) {
            record[i] ^= (uint8_t)bit;
            CHECK(!sm_link_load_transition(record, 0xdeadbeef, &read));
            record[i] ^= (uint8_t)bit;
        }
    CHECK(sm_link_is_later(1, 0) && sm_link_is_later(0, 255) && sm_link_is_later(127, 0) && !sm_link_is_later(0, 0) && !sm_link_is_later(255, 0) && !sm_link_is_later(0, 1));
}

int main(void)
{
    test_sent_frame_arrives();
    test_damaged_frame_is_dropped();
    test_too_long_frame_is_dropped();
    test_truncated_frame_is_dropped();
    test_too_long_frame_with_good_beginning_is_dropped();
    test_fields_are_read_back();
    test_transitions_are_read_back();
    return test_end("link");
}
