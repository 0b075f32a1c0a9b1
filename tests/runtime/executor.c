// SPDX-License-Identifier: Apache-2.0
// The promises of runtime-c/executor.h: order, time, overruns, G, vitals, refused plans.
#include "runtime-c/executor.h"
#include "runtime-c/pal/clock.h"
#include "tests/runtime/parts.h"

static Part part[3];
static SmTask task[3];
static SmTask *const a_and_b[] = {&task[0], &task[1]}, *const c[] = {&task[2]};
static SmRate rates[2];
static SmExecutor e;

// Tasks A and B run in every tick of 10 ms, C in every second tick.
static void prepare_executor(void)
{
    const SmRate plan[2] = {{1, 2, a_and_b}, {2, 1, c}};
    const SmExecutor fresh = {.name = "e", .period = 10 * MS, .rate = rates, .rates = 2, .sv = &crew_vector, .events = &events,
                              .time = CREW(time), .unit = MS, .number = 4};

    parts_reset();
    memcpy(rates, plan, sizeof rates);
    for (int i = 0; i < 3; i++) {
        const Part p = {(char)('A' + i), 0, SM_OK};
        const SmTask t = {.name = "t", .init = part_init, .step = part_step, .context = &part[i], .number = (uint16_t)i};

        part[i] = p;
        task[i] = t;
    }
    e = fresh;
    CHECK(sm_statevec_init(&crew_vector) == SM_OK && sm_events_init(&events) == SM_OK);
}

static void start_executor(void)
{
    CHECK(sm_executor_init(&e, NULL) == SM_OK);
    parts_forget();
    sm_executor_start(&e, pal_clock_now());
}

// Waits for the tick and runs it, as an application does.
static void run_tick(void)
{
    pal_clock_sleep_until(sm_executor_due(&e));
    sm_executor_tick(&e);
}

static void run_ticks_until(uint64_t number)
{
    while (e.next < number)
        run_tick();
}

// ---- the plan ----

static bool is_refused(void)
{
    const SmTask *failed = &task[0];
    const bool refused = sm_executor_init(&e, &failed) == SM_E_ARGUMENT && failed == NULL && called == 0;

    prepare_executor();
    return refused;
}

#define REFUSED(change) (prepare_executor(), change, is_refused())

static void test_plan(void)
{
    static const SmElement foreign = {0, SM_U64, 0};
    static SmTask *const holes[] = {&task[0], NULL};

    CHECK(sm_executor_init(NULL, NULL) == SM_E_ARGUMENT);
    CHECK(REFUSED(e.period = 0));
    CHECK(REFUSED(e.rates = 0));
    CHECK(REFUSED(e.rate = NULL));
    CHECK(REFUSED(rates[1].every = 0));
    CHECK(REFUSED(rates[1].tasks = 0));
    CHECK(REFUSED(rates[1].task = NULL));
    CHECK(REFUSED(rates[0].task = holes));
    CHECK(REFUSED(e.unit = 0));
    CHECK(REFUSED(e.time = CREW(v_u32)));
    CHECK(REFUSED(e.time = &foreign));
    CHECK(REFUSED(e.sv = NULL));
    CHECK(REFUSED((e.sv = NULL, e.time = NULL, e.vitals.late = CREW(v_u8))));
    CHECK(REFUSED((e.sv = NULL, e.time = NULL, task[2].mode = CREW(first))));
    CHECK(REFUSED(task[2].mode = &foreign));
    CHECK(REFUSED(e.vitals.ticks = CREW(number)));
    CHECK(REFUSED(e.vitals.overruns = CREW(flag)));
    CHECK(REFUSED(e.vitals.skipped = &foreign));
    CHECK(REFUSED(e.vitals.late = CREW(number)));
    CHECK(REFUSED(e.vitals.busy = CREW(number)));
    prepare_executor();
    e.sv = NULL;
    e.time = NULL;
    e.events = NULL;
    CHECK(sm_executor_init(&e, NULL) == SM_OK && strcmp(calls, "012") == 0);
    start_executor();
    run_tick();
    CHECK(strcmp(calls, "ABC") == 0);
}

static void test_task_refuses(void)
{
    const SmTask *failed = NULL;

    prepare_executor();
    part[1].gives = SM_E_MISSING;
    CHECK(sm_executor_init(&e, &failed) == SM_E_MISSING && failed == &task[1] && strcmp(calls, "01") == 0);
    CHECK(sm_executor_init(&e, NULL) == SM_E_MISSING);
    part[1].gives = SM_OK;
    task[2].step = NULL;
    CHECK(sm_executor_init(&e, &failed) == SM_E_ARGUMENT && failed == &task[2]);
}

// ---- order and time ----

static void test_order(void)
{
    prepare_executor();
    start_executor();
    run_ticks_until(5);
    CHECK(strcmp(calls, "ABCABABCABABC") == 0 && pal_clock_now() == S + 40 * MS);
    for (unsigned i = 0; i < called; i++)
        CHECK(ticks[i].time == ticks[i].number * 10 * MS);
    CHECK(ticks[0].number == 0 && ticks[12].number == 4 && e.ticks == 5 && e.skipped == 0 && e.overruns == 0 && e.late_max == 0);
}

// The duration of a tick does not move the ticks after it.
static void test_absolute(void)
{
    prepare_executor();
    start_executor();
    part[0].takes = 9 * MS;
    run_ticks_until(1000);
    CHECK(pal_clock_now() == S + 999 * 10 * MS + 9 * MS && e.overruns == 0 && e.busy == 9 * MS && e.late_max == 0);
}

// A tick that begins less than a period late is no overrun, and the delay does not accumulate.
static void test_late(void)
{
    prepare_executor();
    start_executor();
    part[0].takes = 19 * MS;
    run_tick();
    part[0].takes = 0;
    run_tick();
    CHECK(e.late == 9 * MS && e.busy_max == 19 * MS && e.overruns == 0);
    run_tick();
    CHECK(e.late == 0 && e.late_max == 9 * MS && e.next == 3 && pal_clock_now() == S + 20 * MS && is_no_event());
}

// ---- overruns ----

static void test_skip(void)
{
    prepare_executor();
    start_executor();
    part[0].takes = 35 * MS;
    run_tick();                                                // tick 0, which lasts until 35
    part[0].takes = 0;
    run_tick();                                                // tick 1, due at 10: an overrun; ticks 2 and 3 have been missed
    CHECK(e.next == 4 && e.overruns == 1 && e.skipped == 2 && e.late == 25 * MS && e.ticks == 2);
    CHECK(is_event(SM_EVENT_OVERRUN, 4, 2, 25000) && is_no_event());
    run_tick();
    CHECK(pal_clock_now() == S + 40 * MS && e.late == 0 && crew_sv.time == 40);
    CHECK(strcmp(calls, "ABCABABC") == 0 && ticks[7].number == 4);
}

// A tick that is due exactly now has not been missed.
static void test_skip_exactly(void)
{
    prepare_executor();
    start_executor();
    part[0].takes = 30 * MS;
    run_tick();
    part[0].takes = 0;
    run_tick();
    CHECK(e.next == 3 && e.skipped == 1 && sm_executor_due(&e) == pal_clock_now());
}

// A tick that begins exactly one period late is an overrun; a nanosecond earlier it is not.
static void test_border(void)
{
    prepare_executor();
    start_executor();
    sim_advance(10 * MS - 1);
    sm_executor_tick(&e);
    CHECK(e.overruns == 0 && e.next == 1);
    sim_advance(10 * MS + 1);
    sm_executor_tick(&e);
    CHECK(e.overruns == 1 && e.next == 2 && e.skipped == 0);
}

// Groups count ticks: a group whose tick was skipped waits for its next tick.
static void test_group_left_out(void)
{
    prepare_executor();
    rates[1].every = 5;
    start_executor();
    run_ticks_until(4);
    sim_advance(29 * MS);                                  // 59: tick 4 begins 19 ms late, tick 5 is missed
    run_ticks_until(11);
    CHECK(strcmp(calls, "ABCABABABABABABABABABC") == 0 && e.skipped == 1);
}

static void test_catch_up(void)
{
    prepare_executor();
    e.overrun = SM_CATCH_UP;
    e.most = 3;
    start_executor();
    part[0].takes = 35 * MS;
    run_tick();
    part[0].takes = 0;
    for (int i = 0; i < 3; i++)
        run_tick();
    CHECK(pal_clock_now() == S + 35 * MS && e.next == 4 && e.skipped == 0 && e.overruns == 2 && e.late == 5 * MS);
    run_tick();
    CHECK(e.late == 0 && strcmp(calls, "ABCABABCABABC") == 0);
}

static void test_catch_up_most(void)
{
    prepare_executor();
    e.overrun = SM_CATCH_UP;
    e.most = 3;
    start_executor();
    sim_advance(95 * MS);                                  // ticks 1 to 9 are late: 1 to 6 are skipped
    run_tick();
    CHECK(e.next == 7 && e.skipped == 6);
    run_tick();
    run_tick();
    run_tick();
    CHECK(e.next == 10 && e.skipped == 6 && pal_clock_now() == S + 95 * MS && is_event(SM_EVENT_OVERRUN, 4, 6, 95000) && is_no_event());
    e.most = 0;                                            // the same as SM_SKIP
    sim_advance(55 * MS);
    run_tick();
    CHECK(e.next == 15 && e.skipped == 10);
}

// However late the executor is, the first tick runs, and no tick runs twice.
static void test_first_late(void)
{
    prepare_executor();
    start_executor();
    sim_advance(3 * 3600 * S + 1);
    run_tick();
    CHECK(strcmp(calls, "ABC") == 0 && ticks[0].number == 0 && e.next == 3 * 3600 * 100 + 1 && e.ticks + e.skipped == e.next);
    CHECK(is_event(SM_EVENT_OVERRUN, 4, 3 * 3600 * 100, UINT32_MAX));
    run_tick();
    CHECK(e.late == 0 && crew_sv.time == (3 * 3600 * 100 + 1) * 10);
}

// Overruns emit at most one event per second.  While they continue, each is counted in some event.
static void test_overrun_event(void)
{
    SmEvent event;
    uint64_t told = 0, last = 0, n = 0;

    prepare_executor();
    start_executor();
    part[0].takes = 35 * MS;
    run_ticks_until(1000);
    while (sm_events_read(&events, &event_cursor, &event, 1, NULL) == 1) {
        CHECK(event.kind == SM_EVENT_OVERRUN && (n == 0 || event.time - last >= S));
        told += event.a;
        last = event.time;
        n++;
    }
    CHECK(n == 10 && told == e.reported_skipped && e.skipped > told && e.skipped - told < 100);
}

// Overruns exactly one second apart are each reported.
static void test_overrun_event_each_second(void)
{
    SmEvent event;
    uint64_t n = 0;

    prepare_executor();
    e.period = 500 * MS;
    e.overrun = SM_CATCH_UP;
    e.most = UINT32_MAX;
    start_executor();
    part[0].takes = S;                                     // from tick 1 on, every tick is an overrun
    run_ticks_until(10);
    while (sm_events_read(&events, &event_cursor, &event, 1, NULL) == 1) {
        CHECK(event.kind == SM_EVENT_OVERRUN && event.time == n * S + 500 * MS);
        n++;
    }
    CHECK(n == 5 && e.overruns == 9);
}

// A count that does not fit into one event is reported with the next one.
static void test_count_beyond_one_event(void)
{
    prepare_executor();
    e.period = 1000;
    e.unit = 1;
    start_executor();
    sim_advance(3 * 3600 * S);                             // 10,800,000,000 ticks
    run_tick();
    CHECK(is_event(SM_EVENT_OVERRUN, 4, UINT32_MAX, UINT32_MAX) && is_no_event());
    run_ticks_until(e.next + 1000000);
    sim_advance(5000);
    run_tick();
    CHECK(is_event(SM_EVENT_OVERRUN, 4, UINT32_MAX, 4));
}

// ---- G ----

static void test_time(void)
{
    prepare_executor();
    crew_sv.time = 500;
    start_executor();
    run_tick();
    CHECK(crew_sv.time == 500);
    run_tick();
    CHECK(crew_sv.time == 510);
    crew_sv.time = 600;                                    // G is never set to an earlier time
    run_tick();
    CHECK(crew_sv.time == 600);
    run_ticks_until(12);
    CHECK(crew_sv.time == 610);
}

static void test_time_uneven(void)
{
    prepare_executor();
    e.unit = 3 * MS;
    start_executor();
    run_ticks_until(8);
    CHECK(crew_sv.time == 70 / 3);
    prepare_executor();
    e.unit = 1;
    start_executor();
    run_ticks_until(8);
    CHECK(crew_sv.time == 70 * MS);
}

static void test_time_ends(void)
{
    prepare_executor();
    crew_sv.time = UINT64_MAX - 15;
    start_executor();
    run_ticks_until(2);
    CHECK(crew_sv.time == UINT64_MAX - 5);
    run_ticks_until(5);
    CHECK(crew_sv.time == UINT64_MAX);
}

// Tick numbers and times up to 2^64.
static void test_far(void)
{
    prepare_executor();
    start_executor();
    e.next = (UINT64_MAX / e.period) - 1;
    e.start -= e.next * e.period;                          // due exactly now
    run_tick();
    CHECK(e.ticks == 1 && e.overruns == 0 && crew_sv.time == UINT64_MAX / e.period * 10 - 10);
    for (int i = 0; i < 5; i++) {                          // the time wraps: G does not change, and no tick counts as an overrun
        const uint64_t g = crew_sv.time;

        sim_advance(10 * MS);
        sm_executor_tick(&e);
        CHECK(crew_sv.time >= g && e.overruns == 0 && e.late == 0);
    }
    CHECK(e.ticks == 6);
}

static void test_far_clock(void)
{
    prepare_executor();
    sim_advance(UINT64_MAX - pal_clock_now() - 25 * MS);
    start_executor();
    for (int i = 0; i < 6; i++) {
        sm_executor_tick(&e);
        CHECK(e.late == 0);
        sim_advance(10 * MS);
    }
    CHECK(e.ticks == 6 && e.overruns == 0 && crew_sv.time == 50);
    sim_advance(35 * MS);
    sm_executor_tick(&e);
    CHECK(e.late == 35 * MS && e.skipped == 3);
    prepare_executor();                                               // late, while the time wraps
    sim_advance(UINT64_MAX - pal_clock_now() - 5 * MS);
    start_executor();
    sim_advance(35 * MS);
    sm_executor_tick(&e);
    CHECK(e.late == 35 * MS && e.skipped == 3 && e.overruns == 1);
}

// ---- vitals ----

static void test_vitals(void)
{
    const SmVitals v = {CREW(v_u64), CREW(v_u8), CREW(v_i16), CREW(v_i8), CREW(v_u32)};

    prepare_executor();
    e.vitals = v;
    start_executor();
    part[0].takes = 35 * MS + 999;
    run_tick();
    CHECK(crew_sv.v_u64 == 1 && crew_sv.v_u8 == 0 && crew_sv.v_i8 == 0 && crew_sv.v_u32 == 35000);
    part[0].takes = 0;
    run_tick();
    CHECK(crew_sv.v_u64 == 2 && crew_sv.v_u8 == 1 && crew_sv.v_i16 == 2 && crew_sv.v_i8 == INT8_MAX && crew_sv.v_u32 == 0);
    e.overruns = 1000;
    e.skipped = 100000;
    sim_advance(3600 * S * 2);
    run_tick();
    CHECK(crew_sv.v_u8 == UINT8_MAX && crew_sv.v_i16 == INT16_MAX);
}

static void test_vitals_of_all_types(void)
{
    const SmVitals v = {CREW(v_i8), CREW(v_i32), CREW(v_i64), CREW(v_u16), CREW(v_i16)};

    prepare_executor();
    e.vitals = v;
    start_executor();
    e.ticks = e.overruns = e.skipped = UINT64_MAX - 2;
    part[0].takes = 40 * MS;
    sim_advance(80 * MS);
    run_tick();
    CHECK(crew_sv.v_i8 == INT8_MAX && crew_sv.v_i32 == INT32_MAX && crew_sv.v_u16 == UINT16_MAX && crew_sv.v_i16 == INT16_MAX);
    CHECK(crew_sv.v_i64 == 8);                             // it wrapped: 2^64 - 3 + 11
}

// A vector whose lock is not available: tasks run, G and vitals do not change.
static void test_locked_out(void)
{
    prepare_executor();
    e.vitals.ticks = CREW(v_u64);
    start_executor();
    run_tick();
    sim_break(SIM_lock_take, 0, SM_E_TIMEOUT);
    run_tick();
    CHECK(strcmp(calls, "ABCAB") == 0 && crew_sv.time == 0 && crew_sv.v_u64 == 1 && crew_vector.faults == 2);
    sim_break(SIM_lock_take, 0, SM_OK);
    run_tick();
    CHECK(crew_sv.time == 20 && crew_sv.v_u64 == 3);
    crew_vector.faults = 0;
}

// A vector that cannot be entered when the executor starts.  Without the value of G, the executor would count from 0, and machines would refuse
// each step until G reaches its old value.
static void test_locked_out_at_the_start(void)
{
    const SmTask *failed = &task[0];

    prepare_executor();
    crew_sv.time = 5000;
    sim_break(SIM_lock_take, 0, SM_E_TIMEOUT);
    CHECK(sm_executor_init(&e, &failed) == SM_E_TIMEOUT && failed == NULL);
    sim_break(SIM_lock_take, 0, SM_OK);
    start_executor();
    run_tick();
    run_tick();
    CHECK(crew_sv.time == 5010);
    crew_vector.faults = 0;
}

// One thread and a vector without `lock`: no lock is taken.
static void test_no_locks(void)
{
    prepare_executor();
    crew_vector.guarded = false;
    task[0].mode = CREW(first);
    crew_sv.first = SM_ENABLED;
    e.vitals.ticks = CREW(v_u64);
    start_executor();
    run_ticks_until(100);
    CHECK(sim_count(SIM_lock_take) == 0 && crew_sv.v_u64 == 100);
}

int main(void)
{
    test_plan();
    test_task_refuses();
    test_order();
    test_absolute();
    test_late();
    test_skip();
    test_skip_exactly();
    test_border();
    test_group_left_out();
    test_catch_up();
    test_catch_up_most();
    test_first_late();
    test_overrun_event();
    test_overrun_event_each_second();
    test_count_beyond_one_event();
    test_time();
    test_time_uneven();
    test_time_ends();
    test_far();
    test_far_clock();
    test_vitals();
    test_vitals_of_all_types();
    test_locked_out();
    test_locked_out_at_the_start();
    test_no_locks();
    return test_end("executor");
}
