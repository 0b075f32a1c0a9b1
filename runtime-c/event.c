// SPDX-License-Identifier: Apache-2.0
// The ring of events.  Event number n is at index n modulo `room`.  `room` divides 2^32, so the counter may wrap around.
#include "runtime-c/event.h"

#include "runtime-c/shared.h"

// Empties the ring and opens its lock.
SmResult sm_events_init(SmEvents *e)
{
    if (!e || !e->at || e->room == 0 || (e->room & (e->room - 1u)) != 0)
        return SM_E_ARGUMENT;
    e->next = 0;
    e->faults = 0;
    return e->guarded ? pal_lock_open(&e->lock) : SM_OK;
}

// Takes the lock of a guarded ring.  Returns false, and counts a fault, if the lock timed out.
static bool lock_ring(SmEvents *e)
{
    if (!e->guarded || pal_lock_take(e->lock, SM_LOCK_WAIT) == SM_OK)
        return true;
    sm_shared_increment(&e->faults);
    return false;
}

static void unlock_ring(SmEvents *e)
{
    if (e->guarded)
        pal_lock_give(e->lock);
}

// Copies byte by byte: for so few bytes a small chip has no faster method.
static void copy_event(SmEvent *to, const SmEvent *from)
{
    for (uint8_t i = 0; i < sizeof *to; i++)
        ((uint8_t *)to)[i] = ((const uint8_t *)from)[i];
}

static SmEvent *event_slot(const SmEvents *e, uint32_t number) { return &e->at[(uint16_t)number & (uint16_t)(e->room - 1u)]; }

// Adds an event, in place of the oldest one if the ring is full.  Never waits for a reader.
void sm_event(SmEvents *e, const SmEvent *event)
{
    if (!e || !event || !lock_ring(e))
        return;
    copy_event(event_slot(e, e->next++), event);
    unlock_ring(e);
}

// Returns the number of events after a cursor that have been overwritten.
static uint32_t count_overwritten(const SmEvents *e, uint32_t cursor)
{
    const uint32_t behind = e->next - cursor;

    return behind > e->room ? behind - e->room : 0;
}

// Reads up to n events from *cursor on, the oldest first, advances *cursor past them, and returns their number.
uint32_t sm_events_read(SmEvents *e, uint32_t *cursor, SmEvent *out, uint32_t n, uint32_t *lost)
{
    uint32_t missing, taken = 0;

    if (lost)
        *lost = 0;
    if (!e || !cursor || (!out && n > 0) || !lock_ring(e))
        return 0;
    missing = count_overwritten(e, *cursor);
    *cursor += missing;
    for (; taken < n && *cursor != e->next; taken++)
        copy_event(&out[taken], event_slot(e, (*cursor)++));
    unlock_ring(e);
    if (lost)
        *lost = missing;
    return taken;
}

// Returns the name of a kind ("STATE", …), or "" for an unknown number.
const char *sm_event_name(uint8_t kind)
{
    switch (kind) {
#define SM_EVENT(name, number, source, a, b, text) case number: return #name;
#include "runtime-c/events.def"
#undef SM_EVENT
    default: return "";
    }
}
