// SPDX-License-Identifier: Apache-2.0
// The guarantees of runtime-c/app.h for logs and saved state vectors, in one thread: when they are written, and what is restored.
#include "runtime-c/app.h"
#include "runtime-c/pal/clock.h"
#include "tests/runtime/parts.h"

static Part part;
static uint8_t ring[4096], slots[2 * SM_KEEP_SIZE(sizeof crew_sv)];
static SmLog record;
static SmKeep keeper;
static SmTask task[3];
static SmTask *const every_tick[] = {&task[0], &task[1]}, *const every_tenth[] = {&task[2]};
static const SmRate rate[] = {{1, 2, every_tick}, {10, 1, every_tenth}};
static SmExecutor executor;
static SmExecutor *const all[] = {&executor};
static SmApp app;
static unsigned most;

static SmResult step(void *context, const SmTick *tick)
{
    const SmResult r = part_step(context, tick);

    crew_set_number(crew_number() + 1);
    if (called >= most)
        sm_app_stop(&app);
    return r;
}

static void set(void *sv)
{
    ((CrewSv *)sv)->third = 42;
    ((CrewSv *)sv)->number = 1000;
}

// Prepares a task and the log every 10 ms and the saved vector every 100 ms, for 100 ticks.
static void prepare_app(void)
{
    const SmLog l = {.file = "flight", .sv = &crew_vector, .names = &crew_names, .events = &events, .buffer = ring, .room = sizeof ring};
    const SmKeep k = {.memory = "eeprom", .sv = &crew_vector, .buffer = slots};
    const SmTask work = {.name = "work", .step = step, .context = &part},
                 log = {.name = "log", .init = sm_log_init, .step = sm_log_step, .context = &record, .number = 1},
                 keep = {.name = "keep", .step = sm_keep_step, .context = &keeper, .number = 2};
    const SmExecutor e = {.name = "one", .period = 10 * MS, .rate = rate, .rates = 2, .sv = &crew_vector, .events = &events,
                          .time = CREW(time), .unit = MS};
    const SmApp a = {.name = "crew", .sv = &crew_vector, .events = &events, .executor = all, .executors = 1, .set = set,
                     .keep = &keeper, .log = &record, .writing = &sm_writing};
    const Part p = {'A', 0, SM_OK};

    record = l;
    keeper = k;
    task[0] = work;
    task[1] = log;
    task[2] = keep;
    executor = e;
    app = a;
    part = p;
    most = 100;
}

static void start(void)
{
    parts_reset();
    prepare_app();
}

static size_t logged(void)
{
    size_t n = 0;

    return sim_log("flight", &n) ? n : 0;
}

static void test_written(void)
{
    start();
    CHECK(sm_app_run(&app) == SM_OK && !app.restored && crew_sv.number == 1100 && crew_sv.third == 42);
    CHECK(executor.late_max == 0 && record.dropped == 0 && record.cursor == events.next && record.out.id == 0);
    CHECK(logged() > 100 * SM_LOG_RECORD(sizeof crew_sv) / 2 && sim_log_synced("flight") == logged());
    CHECK(keeper.written == 10 && keeper.replaced == 0 && task[1].failures == 0 && task[2].failures == 0);
    CHECK(is_event(SM_EVENT_START, 0, 0, 0) && is_event(SM_EVENT_STOP, 0, 0, 0) && is_no_event());
}

// A new program on the same computer: the saved vector replaces [start], and G continues.
static void test_restored(void)
{
    start();
    CHECK(sm_app_run(&app) == SM_OK);
    sim_cut_power(0, 0);
    sim_power_on();
    memset(&crew_sv, 0, sizeof crew_sv);
    parts_forget();
    prepare_app();
    most = 2;
    CHECK(sm_app_run(&app) == SM_OK && app.restored && crew_sv.third == 42 && crew_sv.number == 1091 + 2);
    CHECK(executor.base == 900 && crew_sv.time == 910 && is_event(SM_EVENT_START, 0, 1, 0));
}

// The saved vector is damaged: [start] applies, and an event reports that a damaged one was found.
static void test_unusable(void)
{
    start();
    CHECK(sm_app_run(&app) == SM_OK);
    sim_cut_power(0, 0);
    sim_power_on();
    sim_nvm(keeper.memory)[SM_KEEP_HEAD] ^= 1;
    sim_nvm(keeper.memory)[keeper.slot + SM_KEEP_HEAD] ^= 1;
    memset(&crew_sv, 0, sizeof crew_sv);
    parts_forget();
    prepare_app();
    most = 2;
    CHECK(sm_app_run(&app) == SM_OK && !app.restored && is_event(SM_EVENT_START, 0, 2, 0));
}

static void test_refused(void)
{
    start();
    sim_fail(SIM_nvm_open, 0, SM_E_MISSING);
    CHECK(sm_app_main(&app) == 1 && called == 0);
    CHECK(strcmp(sim_console(), "crew: the saved state vector does not start: eeprom: there is no such device, file or address\n") == 0);
    start();
    record.room = 10;
    CHECK(sm_app_main(&app) == 1 && strcmp(sim_console(), "crew: task 'log' does not start: flight: the memory given is too small\n") == 0);
    start();
    app.writing = NULL;
    CHECK(sm_app_run(&app) == SM_E_ARGUMENT && called == 0);
}

// The application has only a log, and the task that writes it is missing: nothing is written.
static void test_without_tasks(void)
{
    start();
    executor.rates = 1;
    app.keep = NULL;
    task[1] = task[0];
    CHECK(sm_app_run(&app) == SM_OK && logged() == 0 && sim_count(SIM_nvm_open) == 0);
}

// An executor that is always late leaves no time to write.  The log is still written.
static void test_busy(void)
{
    start();
    executor.overrun = SM_CATCH_UP;
    executor.most = UINT32_MAX;
    part.takes = 15 * MS;
    CHECK(sm_app_run(&app) == SM_OK && executor.overruns >= 97);
    CHECK(record.dropped == 0 && keeper.written >= 9 && sim_log_synced("flight") == logged());
}

// A broken or slow medium does not delay the tasks.
static void test_broken(void)
{
    start();
    sim_break(SIM_log_append, 3, SM_E_SPACE);
    sim_break(SIM_nvm_write, 1, SM_E_DEVICE);
    most = 1000;
    CHECK(sm_app_run(&app) == SM_OK && executor.late_max == 0 && executor.ticks == 1000 && record.dropped > 0);
}

int main(void)
{
    test_written();
    test_restored();
    test_unusable();
    test_refused();
    test_without_tasks();
    test_busy();
    test_broken();
    return test_end("app_written");
}
