// SPDX-License-Identifier: Apache-2.0
// Measures how late ticks begin on this computer: an executor of 1 kHz and one of 100 Hz, for some seconds without real-time priorities and as
// long with them (if they are permitted).  The result is valid only for this computer and its current load.
//     lateness [SECONDS]
#include <stdio.h>
#include <stdlib.h>

#include "runtime-c/app.h"
#include "runtime-c/pal/clock.h"

#define MOST 600000

// The task of an executor.  It records how late each tick began.  The task of the slow executor ends the application.
typedef struct Notes {
    uint32_t late[MOST];                  // nanoseconds
    uint32_t n, stop_at;
} Notes;

static Notes notes[2];
static SmApp app;

static SmResult note(void *context, const SmTick *tick)
{
    Notes *const n = context;
    const uint64_t late = pal_clock_now() - app.start - tick->time;

    if (n->n < MOST)
        n->late[n->n++] = late < UINT32_MAX ? (uint32_t)late : UINT32_MAX;
    if (tick->number >= n->stop_at)
        sm_app_stop(&app);
    return SM_OK;
}

static int by_size(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;

    return (x > y) - (x < y);
}

static double at(const Notes *n, double share)
{
    return n->late[(uint32_t)(share * (n->n - 1))] / 1000.0;
}

static void show(const SmExecutor *e, Notes *n)
{
    qsort(n->late, n->n, sizeof *n->late, by_size);
    printf("  %-7s %7u ticks, %llu left out; late by: min %.1f, median %.1f, 99 %% %.1f, 99.9 %% %.1f, max %.1f us\n", e->name, n->n,
           (unsigned long long)e->skipped, at(n, 0), at(n, 0.5), at(n, 0.99), at(n, 0.999), at(n, 1));
}

static int measure(uint32_t seconds, uint8_t priority)
{
    static SmTask fast, slow;
    static SmTask *const fasts[] = {&fast}, *const slows[] = {&slow};
    static const SmRate fast_rate = {1, 1, fasts}, slow_rate = {1, 1, slows};
    const SmTask task = {.name = "note", .step = note, .context = &notes[0]};
    SmExecutor one = {.name = "1 kHz", .period = PAL_MILLISECOND, .rate = &fast_rate, .rates = 1},
               two = {.name = "100 Hz", .period = 10 * PAL_MILLISECOND, .rate = &slow_rate, .rates = 1};
    SmExecutor *const all[] = {&one, &two};
    const SmApp fresh = {.name = "lateness", .executor = all, .executors = 2};
    int result;

    app = fresh;
    fast = slow = task;
    slow.context = &notes[1];
    notes[0].n = notes[1].n = 0;
    notes[0].stop_at = UINT32_MAX;
    notes[1].stop_at = seconds * 100;
    one.priority = priority;
    two.priority = (uint8_t)(priority > 0 ? priority - 1 : 0);
    printf(priority > 0 ? "with real-time priorities\n" : "without\n");
    fflush(stdout);
    result = sm_app_main(&app);
    show(&one, &notes[0]);
    show(&two, &notes[1]);
    return result;
}

int main(int argc, char *argv[])
{
    const uint32_t seconds = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 5;

    return seconds == 0 || seconds > MOST / 1000 || measure(seconds, 0) != 0 || measure(seconds, 80) != 0;
}
