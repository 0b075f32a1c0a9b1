// SPDX-License-Identifier: Apache-2.0
// The ring of events between threads: every event is complete, those of one source arrive in order, and unread ones are counted.
#include "runtime-c/event.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/thread.h"
#include "tests/test.h"

enum { WRITERS = 3, READERS = 3, EACH = 30000, ROOM = 64 };
#define LONG ((uint64_t)60 * PAL_SECOND)

static SmEvent storage[ROOM];
static SmEvents events = {storage, ROOM, true, {0}, 0, 0};

typedef struct Part {
    PalThread thread;
    uint16_t source;
    uint32_t taken, lost, wrong;
} Part;

static uint64_t time_of(uint32_t n) { return n * 0x9E3779B97F4A7C15u; }

static void add_events(void *argument)
{
    const Part *part = (const Part *)argument;

    for (uint32_t n = 0; n < EACH; n++) {
        const SmEvent e = {time_of(n), n, ~n, part->source, SM_EVENT_MODE};
        sm_event(&events, &e);
    }
}

// Whether an event is valid.  `from`: by source, the lowest number that it can have.
static bool is_expected(const SmEvent *e, uint32_t *from)
{
    const bool whole = e->source < WRITERS && e->kind == SM_EVENT_MODE && e->b == ~e->a && e->time == time_of(e->a);

    if (!whole || e->a < from[e->source])
        return false;
    from[e->source] = e->a + 1;
    return true;
}

static void read_all_events(void *argument)
{
    Part *part = (Part *)argument;
    uint32_t cursor = 0, from[WRITERS] = {0};

    while (part->taken + part->lost < WRITERS * EACH) {
        SmEvent out[5];
        uint32_t lost, n = sm_events_read(&events, &cursor, out, 5, &lost);
        part->lost += lost;
        part->taken += n;
        for (uint32_t i = 0; i < n; i++)
            part->wrong += !is_expected(&out[i], from);
        if (n == 0)
            pal_clock_sleep_until(pal_clock_now() + 20 * PAL_MICROSECOND);
    }
}

int main(void)
{
    static const PalThreadPlan plan = {"part", 0, 0};
    static Part part[WRITERS + READERS];

    CHECK(sm_events_init(&events) == SM_OK);
    for (uint16_t i = 0; i < WRITERS + READERS; i++) {
        part[i].source = i;
        CHECK(pal_thread_create(&part[i].thread, &plan, i < WRITERS ? add_events : read_all_events, &part[i]) == SM_OK);
    }
    for (uint16_t i = 0; i < WRITERS + READERS; i++)
        CHECK(pal_thread_join(part[i].thread, LONG) == SM_OK);
    for (uint16_t i = WRITERS; i < WRITERS + READERS; i++)
        CHECK(part[i].wrong == 0 && part[i].taken + part[i].lost == WRITERS * EACH && part[i].taken >= ROOM);
    CHECK(events.next == WRITERS * EACH && events.faults == 0);
    return test_end("event_linux");
}
