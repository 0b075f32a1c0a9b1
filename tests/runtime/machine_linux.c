// SPDX-License-Identifier: Apache-2.0
// Two machines, emitted and from an image, each in its own thread, and a third thread, on one state vector.  No thread reads a part of another's
// write, and no write is lost.
#include "bytecode-vm/target/machine.h"
#include "first.h"
#include "images.h"
#include "runtime-c/machine.h"
#include "runtime-c/pal/thread.h"
#include "shared.h"
#include "tests/test.h"

enum { STEPS = 3000, MOST = 100 };       // of each machine; copied values stay below MOST, so that they fit into a U8

typedef struct Runner {
    SmMachine machine;
    uint64_t copy[sizeof(SharedSv) / 8];
    uint32_t ran, failed;
} Runner;

static First first;
static uint64_t memory[32];
static SmvmTarget second = {.image = second_image, .size = sizeof second_image, .memory = memory, .memory_size = sizeof memory};
static SmEvent ring[64];
static SmEvents events = {.at = ring, .room = 64, .guarded = true};
static Runner runner[2];

static void run(void *argument)
{
    Runner *r = argument;
    SmTick tick = {0, 0};

    while (r->ran < STEPS) {
        SmResult result = sm_machine_step(&r->machine, &tick);
        r->ran += result == SM_OK;
        r->failed += result != SM_OK && result != SM_REFUSED;
        tick.number++;
    }
}

static void set_up(Runner *r, const char *name, const SmMachineType *type, void *self)
{
    r->machine.name = name;
    r->machine.type = type;
    r->machine.self = self;
    r->machine.sv = &shared_vector;
    r->machine.events = &events;
    r->machine.copy = r->copy;
    CHECK(sm_machine_init(&r->machine) == SM_OK);
}

// Runs one round of the third thread.  Returns whether everything that it read was consistent.
static bool write_and_look(uint32_t round)
{
    uint32_t mine = shared_mine();
    bool whole;

    if (sm_enter(&shared_vector) != SM_OK)
        return false;
    shared_sv.now++;
    shared_sv.left = round % MOST;
    shared_sv.right = round % MOST;
    whole = shared_sv.firstLow == shared_sv.firstHigh && (float)shared_sv.secondLow == shared_sv.secondHigh;
    sm_leave(&shared_vector);
    shared_set_mine(round);
    return whole && mine == round - 1 && shared_mine() == round;
}

int main(void)
{
    PalThreadPlan plan = {"machine", 0, 0};
    PalThread thread[2];
    uint32_t round = 0, torn = 0;
    bool done[2] = {false, false};

    CHECK(sm_statevec_init(&shared_vector) == SM_OK && sm_events_init(&events) == SM_OK);
    set_up(&runner[0], "first", &first_machine, &first);
    set_up(&runner[1], "second", &smvm_machine_type, &second);
    for (int i = 0; i < 2; i++)
        CHECK(pal_thread_create(&thread[i], &plan, run, &runner[i]) == SM_OK);
    while (!(done[0] && done[1])) {
        torn += !write_and_look(++round);
        for (int i = 0; i < 2; i++)
            if (!done[i] && pal_thread_join(thread[i], 0) == SM_OK)
                done[i] = true;
    }
    CHECK(torn == 0 && shared_firstTorn() == 0 && shared_secondTorn() == 0);
    CHECK(runner[0].ran == STEPS && runner[1].ran == STEPS && runner[0].failed == 0 && runner[1].failed == 0);
    CHECK(shared_vector.faults == 0 && events.next >= 2 + STEPS);      // the first machine makes a transition at each step
    return test_end("machine_linux");
}
