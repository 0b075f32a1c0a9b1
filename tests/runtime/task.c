// SPDX-License-Identifier: Apache-2.0
// The guarantees of runtime-c/task.h.
#include "tests/runtime/parts.h"

static Part part;
static SmTask task;
static SmTick tick = {20 * MS, 2};

static void start(const SmElement *mode)
{
    const Part a = {'A', 0, SM_OK};
    const SmTask t = {.name = "a", .init = part_init, .step = part_step, .safe = part_safe, .context = &part, .mode = mode, .number = 7};

    parts_reset();
    CHECK(sm_statevec_init(&crew_vector) == SM_OK && sm_events_init(&events) == SM_OK);
    part = a;
    task = t;
}

static void run(uint8_t mode)
{
    crew_sv.first = mode;
    sm_task_run(&task, &crew_vector, &events, &tick);
}

static void test_init(void)
{
    start(CREW(first));
    CHECK(sm_task_init(&task) == SM_OK && strcmp(calls, "0") == 0);
    part.gives = SM_E_BUSY;
    CHECK(sm_task_init(&task) == SM_E_BUSY);
    part.gives = SM_OK;
    task.init = NULL;
    CHECK(sm_task_init(&task) == SM_OK);
    task.mode = CREW(v_i8);
    CHECK(sm_task_init(&task) == SM_E_ARGUMENT);
    task.mode = NULL;
    CHECK(sm_task_init(&task) == SM_OK);
    task.step = NULL;
    CHECK(sm_task_init(&task) == SM_E_ARGUMENT && sm_task_init(NULL) == SM_E_ARGUMENT && called == 2);
}

static void test_modes(void)
{
    start(CREW(first));
    run(0);
    CHECK(called == 0);
    run(2);
    run(1);
    run(3);
    run(255);
    run(2);
    CHECK(strcmp(calls, "AaaaA") == 0 && task.steps == 2 && task.safings == 3 && task.failures == 0);
    CHECK(ticks[0].time == tick.time && ticks[1].number == tick.number);
    task.safe = NULL;
    run(1);
    CHECK(called == 5 && task.safings == 3 && task.last_mode == SM_SAFED);
}

static void test_no_mode(void)
{
    start(NULL);
    run(0);
    CHECK(strcmp(calls, "A") == 0 && is_no_event());
    sm_task_run(&task, NULL, NULL, &tick);                 // then neither of them is needed
    CHECK(task.steps == 2);
}

static void test_mode_events(void)
{
    start(CREW(first));
    run(0);
    CHECK(is_no_event());
    run(2);
    run(2);
    CHECK(is_event(SM_EVENT_MODE, 7, 0, 2) && is_no_event());
    run(9);
    run(1);                                                // the same mode with another number
    CHECK(is_event(SM_EVENT_MODE, 7, 2, 1) && is_no_event());
    run(0);
    CHECK(is_event(SM_EVENT_MODE, 7, 1, 0) && is_no_event());
}

// If a mode cannot be read, the last one continues.
static void test_unread(void)
{
    start(CREW(first));
    run(2);
    crew_sv.first = 0;
    sim_fail(SIM_lock_take, 0, SM_E_TIMEOUT);
    sm_task_run(&task, &crew_vector, NULL, &tick);
    CHECK(strcmp(calls, "AA") == 0 && task.last_mode == SM_ENABLED && crew_vector.faults == 1);
    sm_task_run(&task, &crew_vector, NULL, &tick);
    CHECK(called == 2);
    crew_vector.faults = 0;
}

static void test_faults(void)
{
    start(CREW(first));
    run(2);
    part.gives = SM_E_DEVICE;
    run(2);
    CHECK(is_event(SM_EVENT_MODE, 7, 0, 2) && is_event(SM_EVENT_FAULT, 7, 17, 1));
    part.gives = SM_REFUSED;
    run(2);
    CHECK(is_no_event() && task.last_result == SM_REFUSED && task.failures_in_row == 2);
    run(1);                                                // the safe function fails, too: the task continues to fail
    CHECK(is_event(SM_EVENT_MODE, 7, 2, 1) && is_no_event() && task.failures == 3);
    part.gives = SM_OK;
    run(0);                                                // not called, so the result is unknown
    CHECK(is_event(SM_EVENT_MODE, 7, 1, 0) && is_no_event() && task.failures_in_row == 3);
    run(2);
    CHECK(is_event(SM_EVENT_MODE, 7, 0, 2) && is_event(SM_EVENT_FAULT, 7, 0, 3) && task.failures_in_row == 0 && task.last_result == SM_OK);
    part.gives = SM_REFUSED;
    run(2);
    CHECK(is_event(SM_EVENT_FAULT, 7, 1, 1) && is_no_event());
}

static void test_long_failing(void)
{
    start(NULL);
    part.gives = SM_E_DEVICE;
    task.failures_in_row = UINT32_MAX;
    run(2);
    run(2);
    CHECK(task.failures_in_row == UINT32_MAX && is_no_event());
    part.gives = SM_OK;
    run(2);
    CHECK(is_event(SM_EVENT_FAULT, 7, 0, UINT32_MAX));
}

int main(void)
{
    test_init();
    test_modes();
    test_no_mode();
    test_mode_events();
    test_unread();
    test_faults();
    test_long_failing();
    return test_end("task");
}
