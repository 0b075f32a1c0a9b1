// SPDX-License-Identifier: Apache-2.0
// Compares the cost of ticks and task steps with handwritten code: rows for ticks.sh.  Reading the simulated clock takes only a few
// instructions.
//     ticks            prints the names of the rows
//     ticks ROW N      runs N ticks of a row
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crew.h"
#include "runtime-c/app.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/sim/sim.h"

#define TASKS 10
#define MS ((uint64_t)PAL_MILLISECOND)

static unsigned long steps;

static SmResult step(void *context, const SmTick *tick)
{
    (void)tick;
    ++*(unsigned long *)context;
    return SM_OK;
}

static SmTask task[TASKS];
static SmTask *list[TASKS];
static SmRate rate = {1, TASKS, list};
static SmExecutor executor = {.name = "e", .period = MS, .rate = &rate, .rates = 1, .sv = &crew_vector};

// Handwritten code for the same purpose: a table of functions, each called at its period.
static struct { SmResult (*step)(void *, const SmTick *); void *context; } hand[TASKS];

static void by_hand(uint64_t n)
{
    SmTick tick = {0, 0};

    for (uint64_t i = 0; i < n; i++) {
        for (int t = 0; t < TASKS; t++)
            if (hand[t].step(hand[t].context, &tick) != SM_OK)
                exit(2);
        tick.time += MS;
        tick.number++;
        sim_advance(MS);
    }
}

static void nothing(uint64_t n)
{
    for (uint64_t i = 0; i < n; i++)
        sim_advance(MS);
}

static void run(uint64_t n)
{
    if (sm_executor_init(&executor, NULL) != SM_OK)
        exit(2);
    sm_executor_start(&executor, pal_clock_now());
    for (uint64_t i = 0; i < n; i++) {
        sm_executor_tick(&executor);
        sim_advance(MS);
    }
}

static void with_modes(uint64_t n)
{
    for (int t = 0; t < TASKS; t++)
        task[t].mode = &crew_element[CREW_E_first];
    crew_sv.first = SM_ENABLED;
    run(n);
}

static void with_lock(uint64_t n)
{
    crew_vector.guarded = true;
    with_modes(n);
}

static void with_none(uint64_t n)
{
    rate.every = UINT32_MAX;
    executor.next = 1;
    run(n);
}

static void with_time(uint64_t n)
{
    executor.time = &crew_element[CREW_E_time];
    executor.unit = MS;
    with_none(n);
}

static void with_vitals(uint64_t n)
{
    const SmVitals v = {&crew_element[CREW_E_v_u64], &crew_element[CREW_E_v_u8], &crew_element[CREW_E_v_i16], &crew_element[CREW_E_v_u32],
                        &crew_element[CREW_E_v_i32]};

    executor.vitals = v;
    with_time(n);
}

static const struct { const char *name; void (*run)(uint64_t n); } rows[] = {
    {"nothing", nothing}, {"by-hand-10-tasks", by_hand}, {"empty-tick", with_none}, {"empty-tick-G", with_time},
    {"empty-tick-G-5-vitals", with_vitals}, {"10-tasks", run}, {"10-tasks-modes", with_modes}, {"10-tasks-modes-lock", with_lock},
};

int main(int argc, char *argv[])
{
    sim_reset();
    crew_vector.guarded = false;
    for (int t = 0; t < TASKS; t++) {
        task[t].step = hand[t].step = step;
        task[t].context = hand[t].context = &steps;
        list[t] = &task[t];
    }
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (argc < 3) {
            puts(rows[i].name);
        } else if (strcmp(argv[1], rows[i].name) == 0) {
            crew_vector.guarded = strstr(argv[1], "lock") != NULL;
            if (sm_statevec_init(&crew_vector) != SM_OK)
                return 2;
            rows[i].run(strtoull(argv[2], NULL, 10));
        }
    return 0;
}
