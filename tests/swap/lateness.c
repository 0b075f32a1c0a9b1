// SPDX-License-Identifier: Apache-2.0
// Measures whether swaps make ticks late on this computer.  An executor of 1 kHz runs two machines, for some seconds without swaps and as long
// with one swap after another.  The result is valid only for this computer and its current load.
//     lateness [SECONDS]
#include <stdlib.h>

#include "runtime-c/pal/clock.h"
#include "tests/swap/stage.h"
#include "tests/test.h"

#define COUNT(elements, element, by) elements "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + " #by "\n" element " = n + roll_avg(p, 100)\n"

static SwapMachine machine[2][2];
static uint64_t run_time;
static bool swaps_now;
static unsigned exchanged;

// Begins a swap of both machines, or confirms one, whenever that is possible.
static void act(const SmTick *tick)
{
    const SwapMachine *a = &machine[0][exchanged & 1], *b = &machine[1][exchanged & 1];
    const SmSwapChange change[] = {{"a", a->image, a->image_size, SM_SWAP_CONTINUE, NULL, false}, {"b", b->image, b->image_size, SM_SWAP_CONTINUE, NULL, false}};

    if (tick->time >= run_time)
        sm_app_stop(&stage.app);
    if (swaps_now && stage_phase() == SM_SWAP_TRIAL)
        exchanged += sm_swap_confirm(&stage.swaps) == SM_OK;
    else if (swaps_now)
        (void)sm_swap_begin(&stage.swaps, change, 2);
}

static void measure(bool swaps)
{
    const StagePlan plan = {.a = &machine[0][1], .b = &machine[1][1], .room = STAGE_ROOM, .guarded = true, .act = act};
    const SmExecutor *e = &stage.executor[0];

    swaps_now = swaps;
    exchanged = 0;
    stage_set_up(&plan);
    stage.executor[0].priority = 80;
    CHECK(sm_app_run(&stage.app) == SM_OK);
    CHECK((exchanged > 0) == swaps);
    printf("  %-13s %7llu ticks, %llu late by a period or more, %llu left out; late by at most %llu us, busy for at most %llu us; %u swaps\n",
           swaps ? "with swaps" : "without swaps", (unsigned long long)e->ticks, (unsigned long long)e->overruns, (unsigned long long)e->skipped,
           (unsigned long long)(e->late_max / PAL_MICROSECOND), (unsigned long long)(e->busy_max / PAL_MICROSECOND), exchanged);
}

int main(int argc, char **argv)
{
    run_time = (argc > 1 ? strtoul(argv[1], NULL, 10) : 5) * (uint64_t)PAL_SECOND;
    machine_compile(&machine[0][0], COUNT(A, "out", 1), STAGE_SV, 2, true);
    machine_compile(&machine[0][1], COUNT(A, "out", 10), STAGE_SV, 2, true);
    machine_compile(&machine[1][0], COUNT(B, "more", 1), STAGE_SV, 2, true);
    machine_compile(&machine[1][1], COUNT(B, "more", 10), STAGE_SV, 2, true);
    measure(false);
    measure(true);
    return test_end("swap/lateness");
}
