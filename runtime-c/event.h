// SPDX-License-Identifier: Apache-2.0
// Timestamped events.  Tasks write them to a ring.  Readers, such as a log, a ground link or a test, each read it with their own
// cursor.  A slow reader loses the oldest events and learns how many.  Writers never wait for readers.
//
//     static SmEvent storage[64];
//     SmEvents events = {storage, 64, true, {0}, 0, 0};
//     sm_events_init(&events);
//     uint32_t cursor = 0, lost;
//     n = sm_events_read(&events, &cursor, out, 8, &lost);
#ifndef SM_EVENT_H
#define SM_EVENT_H

#include <stdbool.h>
#include <stdint.h>

#include "runtime-c/pal/lock.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum SmEventKind {
#define SM_EVENT(name, number, source, a, b, text) SM_EVENT_##name = number,
#define SM_EVENT_OF_SWAP SM_EVENT
#include "runtime-c/events.def"
#undef SM_EVENT
    SM_EVENT_NONE = 0
} SmEventKind;

typedef struct SmEvent {
    uint64_t time;            // from the start of the application to the tick of the event, in nanoseconds
    uint32_t a, b;            // meaning depends on `kind`: events.def
    uint16_t source;          // number of the task, machine or executor (each kind is numbered separately, from 0)
    uint8_t kind;             // SmEventKind
} SmEvent;

typedef struct SmEvents {
    SmEvent *at;
    uint16_t room;            // number of elements, a power of two
    bool guarded;             // several threads use the ring, so it has a lock
    PalLock lock;
    uint32_t next;            // number of events so far, modulo 2^32
    uint32_t faults;          // how often the lock timed out (SM_LOCK_WAIT): an event was dropped, or a read returned none
} SmEvents;

// Empties the ring and opens its lock.  SM_E_ARGUMENT: `room` is not a power of two, or `at` is NULL.  SM_E_FULL: the lock table
// has no free entry.
SmResult sm_events_init(SmEvents *e);

// Adds an event.  If the ring is full, it overwrites the oldest event.  If `e` is NULL, it drops the event.  Never waits for a
// reader.
void sm_event(SmEvents *e, const SmEvent *event);

// Reads up to n events from *cursor on, the oldest first, advances *cursor past them, and returns their number.  If `lost` is not
// NULL, *lost receives the number of events after the cursor that were overwritten before this read.  A cursor starts at 0.  All
// counts are modulo 2^32.
uint32_t sm_events_read(SmEvents *e, uint32_t *cursor, SmEvent *out, uint32_t n, uint32_t *lost);

// Returns the name of a kind ("STATE", …), or "" for an unknown number.
const char *sm_event_name(uint8_t kind);

#ifdef __cplusplus
}
#endif
#endif
