// SPDX-License-Identifier: Apache-2.0
// The common part of the tests of logs: a vector whose values are a function of time, a machine that only has names, and a log of both.
#ifndef LOG_PARTS_H
#define LOG_PARTS_H

#include <string.h>

#include "runtime-c/log.h"
#include "tests/test.h"
#include "wide.h"

enum { ROOM = 1024, GUARD = 64 };     // GUARD: bytes after the ring that must not change
#define TICK ((uint64_t)10 * PAL_MILLISECOND)

static SmResult fake_open(void *self, uint32_t layout, uint32_t size) { return (void)self, (void)layout, (void)size, SM_OK; }
static SmResult fake_init(void *self, void *sv, uint32_t state) { return (void)self, (void)sv, (void)state, SM_OK; }
static SmResult fake_step(void *self, void *sv) { return (void)self, (void)sv, SM_OK; }
static uint32_t fake_state(const void *self) { return (void)self, 1; }
static bool fake_moved(const void *self) { return (void)self, false; }
static uint64_t fake_time(const void *self) { return (void)self, 0; }
static uint32_t fake_states(const void *self) { return (void)self, 2; }
static const char *fake_name(const void *self, uint32_t state) { return (void)self, state == 1 ? "Coast" : "Landed"; }
static SmRange fake_uses(const void *self) { return (void)self, (SmRange){0, 0}; }
static SmRange fake_number(const void *self)
{
    (void)self;
    return (SmRange){wide_element[WIDE_E_state].offset, 4};
}

static const SmMachineType fake_type = {fake_open,  fake_init, fake_step,   fake_state, fake_moved,  fake_time,
                                        fake_name, fake_states, fake_uses, fake_number, NULL};
static SmMachine machine = {.name = "mission", .type = &fake_type, .number = 3};
static const SmMachine *const machines[] = {&machine};
static const char *const tasks[] = {"inputs", "engine"};

static SmEvent event_at[16];
static SmEvents events;
static uint8_t ring[ROOM + GUARD];
static SmLog flight;

// Resets the log, its vector and its events to an empty log.
static void reset_log(const char *name)
{
    (void)pal_lock_close(wide_vector.lock);               // closes a lock that an earlier test left open
    (void)pal_lock_close(events.lock);
    memset(&wide_sv, 0, sizeof wide_sv);
    memset(&flight, 0, sizeof flight);
    memset(&events, 0, sizeof events);
    events.at = event_at;
    events.room = 16;
    CHECK(sm_statevec_init(&wide_vector) == SM_OK && sm_events_init(&events) == SM_OK);
    memset(ring, 0x77, sizeof ring);
    flight.file = name;
    flight.sv = &wide_vector;
    flight.names = &wide_names;
    flight.events = &events;
    flight.machine = machines;
    flight.machines = 1;
    flight.buffer = ring;
    flight.room = ROOM;
    flight.task = tasks;
    flight.tasks = 2;
}

// Fills the vector as at tick k of session `salt`.
static void fill_vector(uint64_t k, uint32_t salt)
{
    wide_sv.time = k * TICK;
    wide_sv.state = (uint32_t)(k % 2 + 1);
    wide_sv.f64 = (double)k * 0.25 + salt;
    wide_sv.i64 = -(int64_t)k;
    wide_sv.u32 = salt;
    wide_sv.flag = k % 3 == 0;
    wide_sv.u8 = (uint8_t)(0xA5 + k);                     // resembles the mark of a block
}

#endif
