// SPDX-License-Identifier: Apache-2.0
// The machine tester.sm on stand.sv in every form: emitted, from an image, from its decoded form; in place and guarded.
// A test of a machine runs on all six.
#ifndef MACHINE_STAGE_H
#define MACHINE_STAGE_H

#include <string.h>

#include "bytecode-vm/target/machine.h"
#include "images.h"
#include "runtime-c/machine.h"
#include "runtime-c/psl/sim/sim.h"
#include "stand.h"
#include "tester.h"
#include "tests/test.h"

typedef enum Kind { EMITTED, IMAGE, DECODED, KINDS } Kind;

typedef struct Stage {
    SmStateVec vector;        // stand_vector, guarded or in place
    SmEvents events;
    SmEvent ring[16];
    uint32_t cursor;
    SmMachine machine;
    SmTick tick;
    Tester tester;
    SmvmTarget target;
    uint64_t memory[64], decoded[512], copy[sizeof(StandSv) / 8];
} Stage;

static Stage stage;

// Prepares everything without starting it.  The vector contains 0xa5 in each byte.
static void set_stage(Kind kind, bool guarded)
{
    sim_reset();
    memset(&stage, 0, sizeof stage);
    memset(&stand_sv, 0xa5, sizeof stand_sv);
    memset(stage.copy, 0x5a, sizeof stage.copy);
    stage.vector = stand_vector;
    stage.vector.guarded = guarded;
    CHECK(sm_statevec_init(&stage.vector) == SM_OK);
    stage.events.at = stage.ring;
    stage.events.room = 16;
    CHECK(sm_events_init(&stage.events) == SM_OK);
    stage.target.image = tester_image;
    stage.target.size = sizeof tester_image;
    stage.target.memory = stage.memory;
    stage.target.memory_size = sizeof stage.memory;
    stage.target.decoder = kind == DECODED ? &smvm_decoder : NULL;
    stage.target.decoded = stage.decoded;
    stage.target.decoded_size = sizeof stage.decoded;
    stage.machine.name = "tester";
    stage.machine.type = kind == EMITTED ? &tester_machine : &smvm_machine_type;
    stage.machine.self = kind == EMITTED ? (void *)&stage.tester : (void *)&stage.target;
    stage.machine.sv = &stage.vector;
    stage.machine.events = &stage.events;
    stage.machine.copy = guarded ? stage.copy : NULL;
    stage.machine.number = 7;
    stage.tick.time = 1000;
}

// Sets the inputs to 0, and starts the machine.
static void start_stage(Kind kind, bool guarded)
{
    set_stage(kind, guarded);
    memset(&stand_sv, 0, sizeof stand_sv);
    CHECK(sm_machine_init(&stage.machine) == SM_OK);
    stage.cursor = 1;                     // after the event of the start
}

static SmResult step(int16_t order)
{
    stand_sv.order = order;
    stand_sv.clock++;
    stage.tick.time += 10;
    stage.tick.number++;
    return sm_machine_step(&stage.machine, &stage.tick);
}

static inline bool next_event(SmEvent *e) { return sm_events_read(&stage.events, &stage.cursor, e, 1, NULL) == 1; }

// Whether the next event has these values, the current time, and this machine.
static inline bool happened(SmEventKind kind, uint32_t a, uint32_t b)
{
    SmEvent e;

    return next_event(&e) && e.kind == kind && e.a == a && e.b == b && e.source == 7 && e.time == stage.tick.time;
}

static inline bool nothing_happened(void)
{
    SmEvent e;

    return !next_event(&e);
}

static inline void for_all(void (*test)(Kind kind, bool guarded))
{
    for (int kind = EMITTED; kind < KINDS; kind++)
        for (int guarded = 0; guarded < 2; guarded++)
            test((Kind)kind, guarded != 0);
}

#endif
