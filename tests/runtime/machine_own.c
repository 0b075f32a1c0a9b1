// SPDX-License-Identifier: Apache-2.0
// A machine that was built without a .sv, on a separate vector that the program describes by hand.
#include "own.h"
#include "runtime-c/machine.h"
#include "tests/test.h"

static OwnSv sv;
static const SmLayout layout = {.hash = OWN_SV_LAYOUT, .whole = {.size = sizeof sv}};
static SmStateVec vector = {.layout = &layout, .at = &sv};
static Own own;
static SmMachine machine = {.name = "own", .type = &own_machine, .self = &own, .sv = &vector};

int main(void)
{
    const SmTick tick = {0, 0};

    CHECK(sm_statevec_init(&vector) == SM_OK && sm_machine_init(&machine) == SM_OK && sv.S == 1);
    for (sv.time = 0; sv.time < 10; sv.time++)
        CHECK(sm_machine_step(&machine, &tick) == SM_OK);
    CHECK(sv.count == 10 && own_machine.publish == NULL);
    vector.guarded = true;
    CHECK(sm_machine_init(&machine) == SM_E_ARGUMENT);
    return test_end("machine_own");
}
