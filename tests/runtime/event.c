// SPDX-License-Identifier: Apache-2.0
// The guarantees of runtime-c/event.h, in the simulation.  event_linux.c tests threads.
#include <string.h>

#include "runtime-c/event.h"
#include "runtime-c/psl/sim/sim.h"
#include "tests/test.h"

enum { ROOM = 8 };

static SmEvent storage[ROOM];
static SmEvents events = {storage, ROOM, true, {0}, 0, 0};

static void start(void)
{
    sim_reset();
    memset(storage, 0xEE, sizeof storage);
    CHECK(sm_events_init(&events) == SM_OK && events.next == 0);
}

static void add_events(uint32_t n)
{
    const SmEvent e = {1000u + n, n, ~n, (uint16_t)(n & 0xFFFFu), SM_EVENT_STATE};

    sm_event(&events, &e);
}

static bool is_event(const SmEvent *e, uint32_t n)
{
    return e->time == 1000u + n && e->a == n && e->b == ~n && e->source == (uint16_t)(n & 0xFFFFu) && e->kind == SM_EVENT_STATE;
}

static bool is_free(void) { return pal_lock_take(events.lock, 0) == SM_OK && pal_lock_give(events.lock) == SM_OK; }

static void test_in_order(void)
{
    SmEvent out[ROOM];
    uint32_t cursor = 0, lost = 9;

    start();
    CHECK(sm_events_read(&events, &cursor, out, ROOM, &lost) == 0 && cursor == 0 && lost == 0);
    for (uint32_t i = 0; i < 5; i++)
        add_events(i);
    CHECK(sm_events_read(&events, &cursor, out, 3, &lost) == 3 && cursor == 3 && lost == 0);
    CHECK(is_event(&out[0], 0) && is_event(&out[2], 2));
    CHECK(sm_events_read(&events, &cursor, out, ROOM, NULL) == 2 && cursor == 5 && is_event(&out[1], 4));
    CHECK(sm_events_read(&events, &cursor, out, ROOM, &lost) == 0 && cursor == 5 && is_free());
}

static void test_full_to_the_brim(void)
{
    SmEvent out[ROOM + 1];
    uint32_t cursor = 0, lost = 9;

    start();
    for (uint32_t i = 0; i < ROOM; i++)
        add_events(i);
    CHECK(sm_events_read(&events, &cursor, out, ROOM + 1, &lost) == ROOM && lost == 0 && is_event(&out[0], 0) && is_event(&out[ROOM - 1], ROOM - 1));
}

static void test_too_slow(void)
{
    SmEvent out[ROOM];
    uint32_t cursor = 0, late = 0, lost = 9;

    start();
    for (uint32_t i = 0; i < ROOM + 3; i++)
        add_events(i);
    CHECK(sm_events_read(&events, &cursor, out, 2, &lost) == 2 && lost == 3 && cursor == 5 && is_event(&out[0], 3) && is_event(&out[1], 4));
    CHECK(sm_events_read(&events, &cursor, out, ROOM, &lost) == 6 && lost == 0 && is_event(&out[5], ROOM + 2));
    CHECK(sm_events_read(&events, &late, out, ROOM, &lost) == ROOM && lost == 3 && is_event(&out[0], 3));  // each reader counts its own losses
}

// A read of 0 events reports the lost ones, and only once.
static void test_asking_for_none(void)
{
    SmEvent out[1];
    uint32_t cursor = 0, lost = 9;

    start();
    for (uint32_t i = 0; i < ROOM + 1; i++)
        add_events(i);
    CHECK(sm_events_read(&events, &cursor, NULL, 0, &lost) == 0 && lost == 1 && cursor == 1);
    CHECK(sm_events_read(&events, &cursor, out, 1, &lost) == 1 && lost == 0 && is_event(out, 1));
}

// The numbers of events continue after 2^32.
static void test_wrap(void)
{
    SmEvent out[ROOM];
    uint32_t cursor = 0xFFFFFFFAu, old = 0xFFFFFFF0u, ancient = 0, lost = 9;

    start();
    events.next = 0xFFFFFFFAu;
    for (uint32_t i = 0; i < 10; i++)
        add_events(0xFFFFFFFAu + i);
    CHECK(events.next == 4);
    CHECK(sm_events_read(&events, &cursor, out, ROOM, &lost) == ROOM && lost == 2 && cursor == 4);
    CHECK(is_event(&out[0], 0xFFFFFFFCu) && is_event(&out[3], 0xFFFFFFFFu) && is_event(&out[4], 0) && is_event(&out[7], 3));
    CHECK(sm_events_read(&events, &old, out, ROOM, &lost) == ROOM && lost == 12 && old == 4 && is_event(&out[0], 0xFFFFFFFCu));
    CHECK(sm_events_read(&events, &ancient, out, ROOM, &lost) == 4 && lost == 0 && is_event(&out[0], 0));    // counts are modulo 2^32
}

// Even with a wrong cursor, only events of the ring are read.
static void test_any_cursor(void)
{
    SmEvent out[ROOM];

    start();
    for (uint32_t i = 0; i < 3 * ROOM; i++)
        add_events(i);
    for (int bit = 0; bit < 32; bit++) {
        uint32_t cursor = 1u << bit, lost = 0, n = sm_events_read(&events, &cursor, out, ROOM, &lost);
        CHECK(n <= ROOM && cursor == events.next && (1u << bit) + lost + n == events.next);
        CHECK(n == 0 || is_event(&out[n - 1], 3 * ROOM - 1));
    }
}

static void test_no_lock(void)
{
    SmEvent out[ROOM];
    uint32_t cursor = 0, lost = 9;

    start();
    add_events(0);
    sim_break(SIM_lock_take, 0, SM_E_TIMEOUT);
    add_events(1);
    CHECK(events.faults == 1 && events.next == 1);
    CHECK(sm_events_read(&events, &cursor, out, ROOM, &lost) == 0 && lost == 0 && cursor == 0 && events.faults == 2);
    sim_break(SIM_lock_take, 0, SM_OK);
    CHECK(sm_events_read(&events, &cursor, out, ROOM, &lost) == 1 && is_event(out, 0));
}

static void test_one_thread(void)
{
    static SmEvent one[1];
    SmEvents small = {one, 1, false, {0}, 0, 0};
    const SmEvent e = {5, 1, 2, 3, SM_EVENT_STOP};
    uint32_t cursor = 0, lost = 9;
    SmEvent out;

    sim_reset();
    CHECK(sm_events_init(&small) == SM_OK);
    sm_event(&small, &e);
    sm_event(&small, &e);
    CHECK(sm_events_read(&small, &cursor, &out, 1, &lost) == 1 && lost == 1 && cursor == 2 && out.time == 5 && out.kind == SM_EVENT_STOP);
    CHECK(sim_count(SIM_lock_take) == 0);
}

static void test_refused(void)
{
    static const uint16_t rooms[] = {0, 3, 6, 7, 65535};
    PalLock taken[PAL_LOCKS];
    uint32_t cursor = 0, lost = 9;
    SmEvents e = {NULL, 4, false, {0}, 0, 0};
    SmEvent out;

    start();
    CHECK(sm_events_init(NULL) == SM_E_ARGUMENT && sm_events_init(&e) == SM_E_ARGUMENT);
    e.at = storage;
    for (size_t i = 0; i < sizeof rooms / sizeof *rooms; i++) {
        e.room = rooms[i];
        CHECK(sm_events_init(&e) == SM_E_ARGUMENT);
    }
    sm_event(NULL, &out);
    sm_event(&events, NULL);
    CHECK(events.next == 0);
    add_events(0);
    CHECK(sm_events_read(NULL, &cursor, &out, 1, &lost) == 0 && lost == 0);
    CHECK(sm_events_read(&events, NULL, &out, 1, &lost) == 0);
    CHECK(sm_events_read(&events, &cursor, NULL, 1, &lost) == 0 && cursor == 0);
    sim_reset();
    for (int i = 0; i < PAL_LOCKS; i++)
        CHECK(pal_lock_open(&taken[i]) == SM_OK);
    CHECK(sm_events_init(&events) == SM_E_FULL);
}

static void test_names(void)
{
    CHECK(strcmp(sm_event_name(SM_EVENT_STATE), "STATE") == 0 && strcmp(sm_event_name(SM_EVENT_STOP), "STOP") == 0);
    CHECK(strcmp(sm_event_name(SM_EVENT_NONE), "") == 0 && strcmp(sm_event_name(255), "") == 0);
}

int main(void)
{
    test_in_order();
    test_full_to_the_brim();
    test_too_slow();
    test_asking_for_none();
    test_wrap();
    test_any_cursor();
    test_no_lock();
    test_one_thread();
    test_refused();
    test_names();
    return test_end("event");
}
