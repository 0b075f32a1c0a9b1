// SPDX-License-Identifier: Apache-2.0
// The flight log with a step in one thread and a drain in another, on real files; the same for saved vectors.
#define _GNU_SOURCE
#include <setjmp.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

#include "compiler/report/flight_log.h"
#include "log_parts.h"
#include "runtime-c/keep.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/thread.h"
#include "runtime-c/shared.h"
#include "tests/heap.h"

enum { STEPS = 20000 };

static char folder[256];
static uint32_t ended, dropped, trouble;
static uint8_t kept[2 * SM_KEEP_SIZE(200)];
static SmKeep keep;

static void run_steps(void *argument)
{
    (void)argument;
    for (uint64_t k = 0; k < STEPS; k++) {
        const SmTick tick = {k * TICK, k};
        const SmEvent e = {k * TICK, (uint32_t)k, 0, 1, SM_EVENT_MODE};

        trouble += sm_enter(&wide_vector) != SM_OK;
        fill_vector(k, 5);
        sm_leave(&wide_vector);
        if (k % 5 == 0)
            sm_event(&events, &e);
        dropped += sm_log_step(&flight, &tick) != SM_OK;
        trouble += sm_keep_step(&keep, &tick) != SM_OK;
        if (k % 16 == 0)
            pal_clock_sleep_until(pal_clock_now() + 20 * PAL_MICROSECOND);
    }
    sm_shared_write(&ended, 1);
}

static void run_both(void)
{
    const SmTick end = {STEPS * TICK, STEPS};
    const PalThreadPlan plan = {"steps", 0, 0};
    PalThread thread = {0};

    CHECK(pal_thread_create(&thread, &plan, run_steps, NULL) == SM_OK);
    for (int i = 0; !sm_shared_read(&ended); i++) {
        (void)sm_log_drain(&flight, PAL_MILLISECOND);
        if (i % 64 == 0)
            CHECK(sm_keep_write(&keep) == SM_OK);
    }
    CHECK(pal_thread_join(thread, 100 * (uint64_t)PAL_SECOND) == SM_OK && trouble == 0);
    (void)sm_log_drain(&flight, PAL_SECOND);
    fill_vector(STEPS, 5);
    CHECK(sm_log_step(&flight, &end) == SM_OK && sm_log_close(&flight) == SM_OK);
    CHECK(sm_keep_write(&keep) == SM_OK && keep.taken == STEPS && keep.written + keep.replaced == STEPS);
    CHECK(pal_nvm_close(keep.nvm) == SM_OK);
}

// ---- the file afterwards ----

static jmp_buf oom;

static void check_log(const uint8_t *bytes, size_t n)
{
    Arena arena;
    Log *log;
    static uint64_t seen;

    arena_init(&arena, heap_alloc, NULL, &oom);
    if (setjmp(oom))
        abort();
    log = log_read(&arena, bytes, (uint32_t)n);
    CHECK(log->session.n == 1 && log->damaged == 0);
    for (size_t i = 0; log->session.n == 1 && i < log->session.at[0]->item.n; i++)
        if (log->session.at[0]->item.at[i].kind == ITEM_RECORD) {
            const LogItem *r = &log->session.at[0]->item.at[i];
            const LogElement *e = log->session.at[0]->d->element;
            const uint64_t k = log_read_time(r) / TICK;
            CHECK(log_read_cell(r, &e[WIDE_E_time]) == k * TICK && log_read_cell(r, &e[WIDE_E_i64]) == (uint64_t)-(int64_t)k);
            CHECK(log_read_cell(r, &e[WIDE_E_u8]) == (uint8_t)(0xA5 + k));
            seen++;
        }
    CHECK(seen == STEPS + 1 - dropped && log->session.at[0]->dropped == dropped);
    CHECK(log->session.at[0]->events + log->session.at[0]->lost == STEPS / 5);
    arena_free(&arena);
}

static void read_file(const char *name)
{
    FILE *f = fopen(name, "rb");
    uint8_t *bytes = malloc(64u << 20);
    const size_t n = f && bytes ? fread(bytes, 1, 64u << 20, f) : 0;

    CHECK(n > 0);
    check_log(bytes, n);
    free(bytes);
    if (f)
        fclose(f);
}

static void check_stored(void)
{
    (void)pal_lock_close(keep.lock);
    memset(&keep.nvm, 0, sizeof keep.nvm);
    keep.lock.id = 0;
    memset(&wide_sv, 0, sizeof wide_sv);
    CHECK(sm_keep_restore(&keep) == SM_OK && keep.restored && wide_sv.time == (STEPS - 1) * TICK && wide_sv.i64 == 1 - STEPS);
    CHECK(pal_nvm_close(keep.nvm) == SM_OK);
}

// A file at its size limit is full; the program continues.
static void test_limit(void)
{
    struct rlimit before, now;
    static const uint8_t bytes[100];
    uint64_t size = 0;
    PalLogFile file = {0};
    SmResult r = SM_OK;

    CHECK(getrlimit(RLIMIT_FSIZE, &before) == 0);
    now = before;
    now.rlim_cur = 1000;
    CHECK(pal_log_open(&file, "limited") == SM_OK && setrlimit(RLIMIT_FSIZE, &now) == 0);
    for (int i = 0; i < 11 && r == SM_OK; i++)
        r = pal_log_append(file, bytes, sizeof bytes);
    CHECK(r == SM_E_SPACE && pal_log_size(file, &size) == SM_OK && size == 1000);
    CHECK(setrlimit(RLIMIT_FSIZE, &before) == 0 && pal_log_append(file, bytes, sizeof bytes) == SM_OK);
    CHECK(pal_log_close(file) == SM_OK && unlink("limited") == 0);
}

// ---- files that hold something else ----

// A source file given by mistake, shorter than two slots, is not changed, not even lengthened.
static void test_foreign(void)
{
    static const char text[] = "[regions]\nSensors\n[elements]\nF64 temperature Sensors\n";
    char now[2 * sizeof text] = {0};
    FILE *f = fopen("kettle.sv", "wb");

    CHECK(f && fputs(text, f) >= 0 && fclose(f) == 0);
    keep.memory = flight.file = "kettle.sv";
    CHECK(sm_keep_restore(&keep) == SM_E_FOREIGN && keep.nvm.id == 0 && sm_log_init(&flight) == SM_E_FOREIGN);
    f = fopen("kettle.sv", "rb");
    CHECK(f && fread(now, 1, sizeof now, f) == strlen(text) && fclose(f) == 0 && strcmp(now, text) == 0);
    CHECK(unlink("kettle.sv") == 0);
    keep.memory = "kept";
    reset_log("flight.log");
    events.guarded = true;
    CHECK(sm_events_init(&events) == SM_OK);
}

int main(void)
{
    snprintf(folder, sizeof folder, "%s/smc-log.XXXXXX", getenv("TMPDIR") ? getenv("TMPDIR") : P_tmpdir);
    CHECK(mkdtemp(folder) != NULL && chdir(folder) == 0);
    reset_log("flight.log");
    events.guarded = true;
    CHECK(sm_events_init(&events) == SM_OK);
    keep.memory = "kept";
    keep.sv = &wide_vector;
    keep.buffer = kept;
    test_foreign();
    CHECK(sm_log_init(&flight) == SM_OK && sm_keep_restore(&keep) == SM_OK);
    run_both();
    test_limit();
    read_file("flight.log");
    check_stored();
    CHECK(unlink("flight.log") == 0 && unlink("kept") == 0 && chdir("/") == 0 && rmdir(folder) == 0);
    return test_end("log_linux");
}
