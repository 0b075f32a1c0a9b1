// SPDX-License-Identifier: Apache-2.0
// What happened and when: a ring of events that tasks fill and that a log, a ground link, a test drain, each with a cursor of its own.
// A reader that is too slow loses the oldest and is told how many.  Nobody waits for readers.
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
#include "runtime-c/events.def"
#undef SM_EVENT
    SM_EVENT_NONE = 0
} SmEventKind;

typedef struct SmEvent {
    uint64_t time;            // nanoseconds since the application started, of the tick in which it happened
    uint32_t a, b;            // by kind: events.def
    uint16_t source;          // number of the task, machine or executor (they are numbered apart, from 0)
    uint8_t kind;             // SmEventKind
} SmEvent;

typedef struct SmEvents {
    SmEvent *at;
    uint16_t room;            // how many of them, a power of two
    bool guarded;             // several threads use it
    PalLock lock;
    uint32_t next;            // how many there have been, modulo 2^32
    uint32_t faults;          // how often the lock could not be had within SM_LOCK_WAIT: an event was dropped, or none was read
} SmEvents;

// Empties it and opens its lock.  SM_E_ARGUMENT: `room` is no power of two, or there is no storage.  SM_E_FULL: no lock left.
SmResult sm_events_init(SmEvents *e);

// Never fails: the newest takes the place of the oldest.  e may be NULL: then it is dropped.
void sm_event(SmEvents *e, const SmEvent *event);

// Takes up to n events from *cursor on, the oldest first, and moves *cursor behind them; gives how many.  *lost, where it is not
// NULL: how many between the cursor and them are gone.  A cursor starts at 0.  All counts are modulo 2^32.
uint32_t sm_events_read(SmEvents *e, uint32_t *cursor, SmEvent *out, uint32_t n, uint32_t *lost);

// "STATE", …; "" for a number that is no kind.
const char *sm_event_name(uint8_t kind);

#ifdef __cplusplus
}
#endif
#endif
