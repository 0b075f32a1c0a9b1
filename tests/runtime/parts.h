// SPDX-License-Identifier: Apache-2.0
// The common part of the tests of tasks, executors and applications: tasks that record their calls, and events that are read one by one.
#ifndef RUNTIME_PARTS_H
#define RUNTIME_PARTS_H

#include <string.h>

#include "crew.h"
#include "runtime-c/event.h"
#include "runtime-c/psl/sim/sim.h"
#include "runtime-c/task.h"
#include "tests/test.h"

#define MS ((uint64_t)PAL_MILLISECOND)
#define S ((uint64_t)PAL_SECOND)
#define CREW(name) (&crew_element[CREW_E_##name])

// The calls so far: a letter each, and the tick that came with it.
#define CALLS 4096
static char calls[CALLS + 1];
static SmTick ticks[CALLS];
static unsigned called;

// The context of a task that records its letter; its duration (it advances the clock) and its result can be changed.
typedef struct Part {
    char letter;
    uint64_t takes;
    SmResult gives;
} Part;

static inline void note(char letter, const SmTick *tick)
{
    if (called < CALLS) {
        calls[called] = letter;
        ticks[called] = tick ? *tick : (SmTick){0, 0};
    }
    called++;
}

static inline SmResult part_step(void *context, const SmTick *tick)
{
    const Part *const p = context;

    note(p->letter, tick);
    sim_advance(p->takes);
    return p->gives;
}

// The letter is lower-case in the safe mode, and a digit at the start.
static inline SmResult part_safe(void *context, const SmTick *tick)
{
    const Part *const p = context;

    note((char)(p->letter - 'A' + 'a'), tick);
    return p->gives;
}

static inline SmResult part_init(void *context)
{
    const Part *const p = context;

    note((char)(p->letter - 'A' + '0'), NULL);
    return p->gives;
}

static inline void parts_forget(void)
{
    memset(calls, 0, sizeof calls);
    called = 0;
}

static SmEvent event_storage[64];
static SmEvents events;
static uint32_t event_cursor;

// Resets the time to 1 s, the calls, the events and the vector, which is guarded if its .sv requires it.
static inline void parts_reset(void)
{
    sim_reset();
    parts_forget();
    memset(&crew_sv, 0, sizeof crew_sv);
    crew_vector.lock.id = 0;
    crew_vector.guarded = true;
    memset(&events, 0, sizeof events);
    events.at = event_storage;
    events.room = 64;
    event_cursor = 0;
}

// Whether the next event has these values.
static inline bool is_event(SmEventKind kind, uint16_t source, uint32_t a, uint32_t b)
{
    SmEvent e;

    return sm_events_read(&events, &event_cursor, &e, 1, NULL) == 1 && e.kind == kind && e.source == source && e.a == a && e.b == b;
}

static inline bool is_no_event(void)
{
    SmEvent e;

    return sm_events_read(&events, &event_cursor, &e, 1, NULL) == 0;
}

#endif
