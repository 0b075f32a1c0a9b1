// SPDX-License-Identifier: Apache-2.0
// The guarantees of runtime-c/app.h in one thread: the start and what refuses it, order, fairness, the watchdog, the end.
#include "runtime-c/app.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/watchdog.h"
#include "tests/runtime/parts.h"

static Part part[5];
static SmTask task[5];
static SmTask *const group[5][1] = {{&task[0]}, {&task[1]}, {&task[2]}, {&task[3]}, {&task[4]}};
static SmRate rate[4];
static SmExecutor executor[4];
static SmExecutor *const all[4] = {&executor[0], &executor[1], &executor[2], &executor[3]};
static SmApp app;
static unsigned most;                     // after this number of calls the application stops
static uint8_t handle[1];
static uint16_t missed[1];
static uint64_t value[1];
static const SmIoPin pin[1] = {{.kind = SM_DIGITAL_IN, .type = SM_BOOL, .pin = 10203}};
static SmIo pins = {.pin = pin, .pins = 1, .sv = &crew_vector, .handle = handle, .missed = missed, .value = value};

static const SmIoPin no_pin[1] = {{.kind = SM_DIGITAL_IN, .type = SM_TYPE_COUNT, .pin = 7}};
static SmIo no_pins = {.pin = no_pin, .pins = 1, .sv = &crew_vector, .handle = handle, .missed = missed, .value = value};

static SmResult step(void *context, const SmTick *tick)
{
    const SmResult r = part_step(context, tick);

    if (called >= most)
        sm_app_stop(&app);
    return r;
}

static void set(void *sv)
{
    ((CrewSv *)sv)->third = 42;
    note('s', NULL);
}

static void prepare_executor(int i, uint64_t period)
{
    static const char *const name[] = {"one", "two", "three", "four"}, *const work[] = {"a", "b", "c", "d"};
    const Part p = {(char)('A' + i), 0, SM_OK};
    const SmTask t = {.name = work[i], .init = part_init, .step = step, .context = &part[i], .number = (uint16_t)i};
    const SmRate r = {1, 1, group[i]};
    const SmExecutor e = {.name = name[i], .period = period, .rate = &rate[i], .rates = 1, .sv = &crew_vector, .events = &events,
                          .time = CREW(time), .unit = MS, .number = (uint16_t)i};

    part[i] = p;
    task[i] = t;
    rate[i] = r;
    executor[i] = e;
}

// Prepares four executors of 10, 20, 30 and 1000 ms with one task each, A to D; the application has the first n.
static void prepare_app(uint16_t n)
{
    const SmApp fresh = {.name = "crew", .sv = &crew_vector, .events = &events, .executor = all, .executors = n};

    parts_reset();
    events.guarded = true;
    prepare_executor(0, 10 * MS);
    prepare_executor(1, 20 * MS);
    prepare_executor(2, 30 * MS);
    prepare_executor(3, 1000 * MS);
    app = fresh;
    most = 50;
}

static unsigned count(char letter)
{
    unsigned n = 0;

    for (unsigned i = 0; i < called && i < CALLS; i++)
        n += calls[i] == letter;
    return n;
}

// ---- the start ----

static void test_start(void)
{
    prepare_app(3);
    app.set = set;
    most = 9;
    CHECK(sm_app_main(&app) == 0 && strcmp(calls, "s012ABCAA") == 0 && crew_sv.third == 42);
    CHECK(is_event(SM_EVENT_START, 0, 0, 0) && is_event(SM_EVENT_STOP, 0, 0, 0) && is_no_event());
    CHECK(strcmp(sim_console(), "") == 0 && sm_app_stopping(&app));
}

// A start after a reset by the watchdog is reported.
static void test_bitten_before(void)
{
    uint64_t actual;

    prepare_app(1);
    CHECK(pal_watchdog_start(MS, &actual) == SM_OK);
    sim_advance(S);
    CHECK(pal_watchdog_stop() == SM_OK && sm_app_run(&app) == SM_OK && is_event(SM_EVENT_START, 0, 0, 1));
}

static SmResult stop_at_init(void *context)
{
    sm_app_stop(&app);
    return part_init(context);
}

static void test_stopped_at_once(void)
{
    prepare_app(2);
    task[0].init = stop_at_init;
    CHECK(sm_app_run(&app) == SM_OK && strcmp(calls, "01") == 0);
}

// Whether the start is refused with this text, while no task has run a step and the watchdog is not running.
static bool is_start_refused(const char *text)
{
    uint64_t actual;
    const bool said = sm_app_main(&app) == 1 && strcmp(sim_console(), text) == 0;

    if (!said)
        fprintf(stderr, "%s", sim_console());
    return said && count('A') == 0 && pal_watchdog_start(MS, &actual) == SM_OK;
}

static void test_refused(void)
{
    prepare_app(2);
    app.executors = 0;
    CHECK(is_start_refused("crew: the application does not start: it has no executor\n"));
    prepare_app(2);
    crew_vector.guarded = false;
    CHECK(is_start_refused("crew: the state vector does not start: several threads use it, so its .sv must say `lock`\n"));
    prepare_app(2);
    events.guarded = false;
    CHECK(is_start_refused("crew: the event ring does not start: several threads use it, so it must be guarded\n"));
    prepare_app(2);
    events.room = 3;
    CHECK(is_start_refused("crew: the event ring does not start: an argument is out of its range\n"));
    prepare_app(2);
    executor[1].period = 0;
    CHECK(is_start_refused("crew: executor 'two' does not start: invalid configuration\n"));
    prepare_app(2);
    part[1].gives = SM_E_BUSY;
    CHECK(is_start_refused("crew: task 'b' does not start: it is in use\n"));
    prepare_app(2);
    task[1].init = sm_inputs_init;
    task[1].context = &pins;
    app.inputs = &pins;
    CHECK(is_start_refused("crew: task 'b' does not start: pin 10203: there is no such device, file or address\n"));
    prepare_app(2);                              // a row that is not a pin is not named as one
    task[1].init = sm_inputs_init;
    task[1].context = &no_pins;
    app.inputs = &no_pins;
    CHECK(is_start_refused("crew: task 'b' does not start: an argument is out of its range\n"));
    prepare_app(2);
    app.watchdog = 3600 * S;
    CHECK(is_start_refused("crew: the watchdog does not start: an argument is out of its range\n"));
    prepare_app(2);
    app.watchdog = S;
    sim_fail(SIM_watchdog_start, 0, SM_E_MISSING);
    CHECK(is_start_refused("crew: the watchdog does not start: there is no such device, file or address\n"));
    prepare_app(2);
    sim_break(SIM_lock_take, 0, SM_E_TIMEOUT);
    CHECK(is_start_refused("crew: executor 'one' does not start: timeout\n"));
    sim_break(SIM_lock_take, 0, SM_OK);
    prepare_app(2);
    sim_fail(SIM_clock_sleep_until, 0, SM_E_DEVICE);
    CHECK(is_start_refused("crew: the clock does not start: it has stopped\n"));
}

static void test_no_lock_left(void)
{
    PalLock lock;

    prepare_app(1);
    while (pal_lock_open(&lock) == SM_OK) {}
    CHECK(sm_app_main(&app) == 1);
    CHECK(strcmp(sim_console(), "crew: the state vector does not start: its table is full\n") == 0 && called == 0);
}

// An application in one thread needs neither locks nor a guarded event ring.
static void test_one_thread(void)
{
    prepare_app(2);
    crew_vector.guarded = events.guarded = false;
    app.one_thread = true;
    CHECK(sm_app_run(&app) == SM_OK && called == most && sim_count(SIM_lock_take) == 0);
}

// ---- order ----

static void test_order(void)
{
    prepare_app(3);
    most = 3 + 25;
    CHECK(sm_app_run(&app) == SM_OK);
    CHECK(strcmp(calls, "012" "ABC" "A" "AB" "AC" "AB" "A" "ABC" "A" "AB" "AC" "AB" "A" "ABC") == 0);
    CHECK(executor[0].late_max == 0 && executor[2].late_max == 0 && executor[0].start == executor[2].start);
}

// 10 Hz to 1 kHz in one executor, and in another one: the exact number of calls, in order, in exactly ten seconds.
static void test_rates(void)
{
    static SmRate groups[4];
    const uint32_t every[4] = {1, 2, 10, 100};

    prepare_app(2);
    task[4] = task[3];
    for (int i = 0; i < 4; i++) {
        const SmRate r = {every[i], 1, group[i]};

        groups[i] = r;
    }
    executor[0].period = executor[1].period = MS;
    executor[0].rate = groups;
    executor[0].rates = 4;
    executor[1].rates = 1;
    rate[1].every = 7;
    rate[1].task = group[4];
    most = 5 + 10000 + 5000 + 1000 + 100 + 1429;
    CHECK(sm_app_run(&app) == SM_OK);
    CHECK(task[0].steps == 10000 && task[1].steps == 5000 && task[2].steps == 1000 && task[3].steps == 100 && task[4].steps == 1429);
    for (unsigned i = 6; i < CALLS; i++)                   // in one tick, from A to D
        CHECK(ticks[i].number > ticks[i - 1].number || (ticks[i].number == ticks[i - 1].number && calls[i] >= calls[i - 1]));
    CHECK(executor[0].late_max == 0 && executor[1].late_max == 0 && executor[0].overruns == 0 && crew_sv.time == 9999);
}

static void test_same_in_every_run(void)
{
    static char calls_before[CALLS];
    static SmTick ticks_before[CALLS];

    for (int i = 0; i < 2; i++) {
        prepare_app(4);
        part[0].takes = 7 * MS;
        part[1].takes = 13 * MS;
        part[2].takes = 3 * MS;
        most = CALLS;
        CHECK(sm_app_run(&app) == SM_OK);
        CHECK(i == 0 || (memcmp(calls, calls_before, CALLS) == 0 && memcmp(ticks, ticks_before, sizeof ticks) == 0));
        memcpy(calls_before, calls, CALLS);
        memcpy(ticks_before, ticks, sizeof ticks);
    }
}

// A task that is always late delays the others by at most one tick.
static void test_fair(void)
{
    prepare_app(2);
    executor[0].period = 1000;
    executor[0].overrun = SM_CATCH_UP;
    executor[0].most = UINT32_MAX;
    part[0].takes = 5 * MS;
    part[1].takes = MS;
    most = 1000;
    CHECK(sm_app_run(&app) == SM_OK);
    CHECK(executor[1].overruns == 0 && executor[1].late_max <= 5 * MS && count('B') >= 200);
    CHECK(executor[0].skipped == 0 && executor[0].overruns > 700);
}

static void test_all_late(void)
{
    prepare_app(3);
    for (int i = 0; i < 3; i++) {
        part[i].takes = 50 * MS;
        executor[i].overrun = SM_CATCH_UP;
        executor[i].most = 10;
    }
    most = 303;
    CHECK(sm_app_run(&app) == SM_OK && count('A') == 100 && count('B') == 100 && count('C') == 100);
}

// ---- stop ----

static void stop_now(void)
{
    sm_app_stop(&app);
}

// A stop during a sleep of an hour is noticed at once.
static void test_stop(void)
{
    prepare_app(1);
    executor[0].period = 3600 * S;
    sim_every(1500 * S, stop_now);
    CHECK(sm_app_run(&app) == SM_OK && strcmp(calls, "0A") == 0 && pal_clock_now() <= S + 1500 * S + 100 * MS);
}

// At the end the safe function of every enabled task with @safe is called once, in order.
static void test_rest(void)
{
    prepare_app(4);
    most = 1;
    task[0].safe = task[1].safe = task[3].safe = part_safe;
    task[1].mode = CREW(first);
    task[3].mode = CREW(second);
    crew_sv.first = SM_DISABLED;
    crew_sv.second = SM_SAFED;
    CHECK(sm_app_run(&app) == SM_OK && strcmp(calls, "0123Aad") == 0);
    CHECK(task[0].safings == 1 && task[1].safings == 0 && task[3].safings == 1 && ticks[5].number == 1);
}

// A failed sleep does not make a tick run early.
static void test_sleep_fails(void)
{
    prepare_app(1);
    sim_break(SIM_clock_sleep_until, 3, SM_E_DEVICE);
    sim_delay(SIM_clock_sleep_until, 100000);
    most = 21;
    CHECK(sm_app_run(&app) == SM_OK && executor[0].ticks == 20 && executor[0].next == 20);
    CHECK(pal_clock_now() >= executor[0].start + 190 * MS && executor[0].late_max <= 200000);
}

static void test_oversleep(void)
{
    prepare_app(1);
    sim_oversleep(3 * MS);
    CHECK(sm_app_run(&app) == SM_OK && executor[0].late_max == 3 * MS && executor[0].skipped == 0);
    prepare_app(1);
    sim_oversleep(12 * MS);
    CHECK(sm_app_run(&app) == SM_OK && executor[0].overruns > 20 && executor[0].ticks + executor[0].skipped == executor[0].next);
}

// ---- the watchdog ----

static void test_fed(void)
{
    prepare_app(2);
    app.watchdog = 50 * MS;
    executor[1].period = 10 * S;                           // a wait that is longer than the timeout of the watchdog does not count as stuck
    most = 5000;
    CHECK(sm_app_run(&app) == SM_OK && !sim_watchdog_fired() && sim_count(SIM_watchdog_feed) > 900);
    CHECK(sim_count(SIM_watchdog_feed) < 4500 && pal_watchdog_feed() == SM_E_HANDLE);
}

// The watchdog is also fed while the application waits.  A feeding that fails now and then has no effect.
static void test_fed_alone(void)
{
    prepare_app(1);
    app.watchdog = 50 * MS;
    executor[0].period = 10 * S;
    sim_fail(SIM_watchdog_feed, 20, SM_E_DEVICE);
    CHECK(sm_app_run(&app) == SM_OK && !sim_watchdog_fired() && executor[0].ticks == 49);
}

static bool run_long_tick(uint64_t stuck)
{
    prepare_app(2);
    app.watchdog = 50 * MS;
    part[1].takes = stuck;
    most = 4;
    CHECK(sm_app_run(&app) == SM_OK);
    return sim_watchdog_fired();
}

// The watchdog fires if a tick takes longer than its timeout, counted from the last feeding: up to a quarter earlier.
static void test_bites(void)
{
    CHECK(!run_long_tick(37 * MS));
    CHECK(run_long_tick(51 * MS));
}

static void test_cannot_be_fed(void)
{
    prepare_app(1);
    app.watchdog = 50 * MS;
    sim_break(SIM_watchdog_feed, 5, SM_E_DEVICE);
    CHECK(sm_app_run(&app) == SM_OK && sim_watchdog_fired());
}

int main(void)
{
    test_start();
    test_bitten_before();
    test_stopped_at_once();
    test_refused();
    test_no_lock_left();
    test_one_thread();
    test_order();
    test_rates();
    test_same_in_every_run();
    test_fair();
    test_all_late();
    test_stop();
    test_rest();
    test_sleep_fails();
    test_oversleep();
    test_fed();
    test_fed_alone();
    test_bites();
    test_cannot_be_fed();
    return test_end("app");
}
