// SPDX-License-Identifier: Apache-2.0
// The cost of a machine as a task of the runtime: runs N steps of the example mission by one of the methods below.
//     machine WAY STEPS      machine_cost.sh counts the instructions
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/target/machine.h"
#include "mission.h"
#include "plain_mission.h"
#include "rocket.h"
#include "runtime-c/machine.h"

static PlainMission plain;
static Mission tracked;
static uint8_t image[20000];
static uint64_t memory[2000], decoded[4000], copy[sizeof(RocketSv) / 8];
static SmStateVec vector;
static SmvmTarget target = {.image = image, .memory = memory, .memory_size = sizeof memory, .decoded = decoded, .decoded_size = sizeof decoded};
static SmMachine machine = {.name = "mission", .sv = &vector, .copy = copy};

static void input(unsigned long k)
{
    rocket_sv.time += 10;
    rocket_sv.acceleration = (float)(k % 7);
    rocket_sv.velocity = (float)(k % 11);
    rocket_sv.altitude = (float)(k % 13);
}

static void run_input(unsigned long n)
{
    for (unsigned long k = 0; k < n; k++)
        input(k);
}

static void run_plain(unsigned long n)
{
    plain_mission_init(&plain, &rocket_sv, 1);
    for (unsigned long k = 0; k < n; k++) {
        input(k);
        plain_mission_step(&plain, &rocket_sv);
    }
}

static void run_tracked(unsigned long n)
{
    mission_init(&tracked, &rocket_sv, 1);
    for (unsigned long k = 0; k < n; k++) {
        input(k);
        mission_step(&tracked, &rocket_sv);
    }
}

static void run_machine(const SmMachineType *type, void *self, bool guarded, unsigned long n)
{
    const SmTick tick = {0, 0};

    vector = rocket_vector;
    vector.guarded = guarded;
    machine.type = type;
    machine.self = self;
    if (sm_statevec_init(&vector) != SM_OK || sm_machine_init(&machine) != SM_OK)
        exit(1);
    for (unsigned long k = 0; k < n; k++) {
        input(k);
        sm_machine_step(&machine, &tick);
    }
}

static void run_locks(unsigned long n)            // two critical sections with nothing in them
{
    vector = rocket_vector;
    if (sm_statevec_init(&vector) != SM_OK)
        exit(1);
    for (unsigned long k = 0; k < 2 * n; k++) {
        sm_enter(&vector);
        sm_leave(&vector);
    }
}

int main(int argc, char **argv)
{
    const char *way = argc > 3 ? argv[1] : "";
    const unsigned long n = argc > 3 ? strtoul(argv[2], NULL, 10) : 0;
    FILE *f = argc > 3 ? fopen(argv[3], "rb") : NULL;

    if (f == NULL)
        return 2;
    target.size = (uint32_t)fread(image, 1, sizeof image, f);
    fclose(f);
    if (strstr(way, "decoded") != NULL)
        target.decoder = &smvm_decoder;
    if (strcmp(way, "input") == 0)
        run_input(n);
    else if (strcmp(way, "locks") == 0)
        run_locks(n);
    else if (strcmp(way, "plain") == 0)
        run_plain(n);
    else if (strcmp(way, "tracked") == 0)
        run_tracked(n);
    else if (strncmp(way, "emitted", 7) == 0)
        run_machine(strstr(way, "guarded") != NULL ? &mission_machine : &plain_mission_machine,
                    strstr(way, "guarded") != NULL ? (void *)&tracked : (void *)&plain, strstr(way, "guarded") != NULL, n);
    else
        run_machine(&smvm_machine_type, &target, strstr(way, "guarded") != NULL, n);
    return 0;
}
