// SPDX-License-Identifier: Apache-2.0
// The guarantees of runtime-c/machine.h for a running machine: for emitted code, images and decoded images.
#include "machine_stage.h"

enum { IDLE = 1, BUSY, HELD };

// ---- starting ----

static void test_start_writes_only_S(Kind kind, bool guarded)
{
    StandSv before, after;

    set_stage(kind, guarded);
    before = stand_sv;
    stage.tick.time = 0;
    CHECK(sm_machine_init(&stage.machine) == SM_OK);
    CHECK(stand_sv.testerState == IDLE && sm_machine_state(&stage.machine) == IDLE && sm_machine_time(&stage.machine) == 0);
    CHECK(happened(SM_EVENT_STATE, 0, IDLE) && nothing_happened());
    after = stand_sv;
    after.testerState = before.testerState;
    CHECK(memcmp(&before, &after, sizeof before) == 0);
}

static void test_start_in_given_state(Kind kind, bool guarded)
{
    set_stage(kind, guarded);
    stage.tick.time = 0;
    stage.machine.initial = HELD;
    CHECK(sm_machine_init(&stage.machine) == SM_OK && stand_sv.testerState == HELD);
    CHECK(happened(SM_EVENT_STATE, 0, HELD));
}

// Starts a machine while S has the value `kept`.  Returns the state in which it starts.
static uint32_t start_with_S(Kind kind, bool guarded, bool resume, const bool *restored, uint32_t kept)
{
    set_stage(kind, guarded);
    stage.machine.initial = kept == HELD ? BUSY : HELD;
    stage.machine.resume = resume;
    stage.machine.restored = restored;
    stand_sv.testerState = kept;
    CHECK(sm_machine_init(&stage.machine) == SM_OK && stand_sv.testerState == sm_machine_state(&stage.machine));
    return sm_machine_state(&stage.machine);
}

static void test_resume_needs_restored_S(Kind kind, bool guarded)
{
    static const bool yes = true, no = false;

    CHECK(start_with_S(kind, guarded, true, &yes, BUSY) == BUSY);
    CHECK(start_with_S(kind, guarded, true, &yes, HELD) == HELD);           // the last state, too
    CHECK(start_with_S(kind, guarded, true, &yes, IDLE) == IDLE);
    CHECK(start_with_S(kind, guarded, true, &no, BUSY) == HELD);
    CHECK(start_with_S(kind, guarded, true, NULL, BUSY) == HELD);
    CHECK(start_with_S(kind, guarded, false, &yes, BUSY) == HELD);
    CHECK(start_with_S(kind, guarded, true, &yes, 0) == HELD);
    CHECK(start_with_S(kind, guarded, true, &yes, HELD + 1) == HELD);
    CHECK(start_with_S(kind, guarded, true, &yes, UINT32_MAX) == HELD);
}

// A second start clears the locals, the windows and the count of refused steps.
static void test_start_clears_memory(Kind kind, bool guarded)
{
    start_stage(kind, guarded);
    stand_sv.pressure = 8;
    step(2);
    step(0);
    CHECK(stand_sv.sum == 8 && stand_sv.flow == 8);
    sm_machine_step(&stage.machine, &stage.tick);
    CHECK(stage.machine.refused == 1);
    CHECK(sm_machine_init(&stage.machine) == SM_OK && stage.machine.refused == 0);
    stand_sv.clock = 0;                   // an earlier time than at the last step: the start has cleared that, too
    stand_sv.pressure = 1;
    CHECK(step(2) == SM_OK && step(0) == SM_OK && stand_sv.sum == 1);
}

// ---- stepping ----

static void test_steps_write_outputs(Kind kind, bool guarded)
{
    start_stage(kind, guarded);
    CHECK(step(1) == SM_OK && stand_sv.valve == 1 && stand_sv.fin == 0);
    CHECK(step(2) == SM_OK && stand_sv.testerState == IDLE && sm_machine_state(&stage.machine) == BUSY);
    stand_sv.pressure = 2.5;
    CHECK(step(0) == SM_OK && stand_sv.testerState == BUSY && stand_sv.fin == -3 && stand_sv.level == 1000 && stand_sv.sum == 2.5);
    CHECK(step(0) == SM_OK && stand_sv.sum == 5 && stand_sv.flow == 1.25f && sm_machine_time(&stage.machine) == 1);
    CHECK(step(4) == SM_OK && stand_sv.fin == 0 && stand_sv.torn == 0);
}

static void test_transitions_emit_events(Kind kind, bool guarded)
{
    start_stage(kind, guarded);
    CHECK(step(0) == SM_OK && nothing_happened());
    CHECK(step(2) == SM_OK && happened(SM_EVENT_STATE, IDLE, BUSY) && nothing_happened());
    CHECK(step(0) == SM_OK && nothing_happened());
    CHECK(step(4) == SM_OK && happened(SM_EVENT_STATE, BUSY, IDLE) && nothing_happened());
    CHECK(step(3) == SM_OK && happened(SM_EVENT_STATE, IDLE, IDLE) && nothing_happened());
    CHECK(step(0) == SM_OK && nothing_happened());
}

static SmResult step_at_next_time(void) { return sm_machine_step(&stage.machine, &stage.tick); }

static void test_time_must_advance(Kind kind, bool guarded)
{
    StandSv before;

    start_stage(kind, guarded);
    CHECK(step(1) == SM_OK);
    before = stand_sv;
    CHECK(step_at_next_time() == SM_REFUSED && happened(SM_EVENT_REFUSED, 1, 0) && nothing_happened());
    CHECK(step_at_next_time() == SM_REFUSED && nothing_happened() && stage.machine.refused == 2);
    CHECK(memcmp(&before, &stand_sv, sizeof before) == 0);
    CHECK(step(1) == SM_OK && stand_sv.valve == 0 && nothing_happened());
    stand_sv.clock = 0;
    CHECK(step_at_next_time() == SM_REFUSED && happened(SM_EVENT_REFUSED, 3, 0) && nothing_happened());
    stand_sv.clock = UINT64_MAX;
    CHECK(step_at_next_time() == SM_REFUSED && nothing_happened());
}

// A refused step does not overwrite what other code has written to the vector since.
static void test_refused_step_writes_nothing(Kind kind, bool guarded)
{
    start_stage(kind, guarded);
    CHECK(step(1) == SM_OK && stand_sv.valve == 1);
    stand_sv.valve = 0;
    stand_sv.testerState = 99;
    CHECK(step_at_next_time() == SM_REFUSED && stand_sv.valve == 0 && stand_sv.testerState == 99);
}

static void test_machine_without_event_ring(Kind kind, bool guarded)
{
    set_stage(kind, guarded);
    stage.machine.events = NULL;
    CHECK(sm_machine_init(&stage.machine) == SM_OK && step(2) == SM_OK && step_at_next_time() == SM_REFUSED);
}

// ---- names ----

static void test_states_have_names(Kind kind, bool guarded)
{
    const SmMachine *m = &stage.machine;

    start_stage(kind, guarded);
    CHECK(strcmp(sm_machine_state_name(m, IDLE), "Idle") == 0 && strcmp(sm_machine_state_name(m, HELD), "Held") == 0);
    CHECK(*sm_machine_state_name(m, 0) == '\0' && *sm_machine_state_name(m, HELD + 1) == '\0' && *sm_machine_state_name(m, UINT32_MAX) == '\0');
}

static void test_positions_of_elements(Kind kind, bool guarded)
{
    const SmRange uses = (start_stage(kind, guarded), stage.machine.type->accessed(stage.machine.self));
    const SmRange number = stage.machine.type->state_number(stage.machine.self);
    const uint32_t unit = kind == EMITTED ? 1 : 8;               // bytes: the memory of an image is a multiple of 8

    CHECK(uses.offset == offsetof(StandSv, clock) / unit * unit);
    CHECK(uses.offset + uses.size == (offsetof(StandSv, torn) + 4 + unit - 1) / unit * unit);
    CHECK(number.offset == offsetof(StandSv, testerState) && number.size == 4);
    CHECK(stage.machine.type->states(stage.machine.self) == TESTER_STATES);
}

int main(void)
{
    for_all(test_start_writes_only_S);
    for_all(test_start_in_given_state);
    for_all(test_resume_needs_restored_S);
    for_all(test_start_clears_memory);
    for_all(test_steps_write_outputs);
    for_all(test_transitions_emit_events);
    for_all(test_time_must_advance);
    for_all(test_refused_step_writes_nothing);
    for_all(test_machine_without_event_ring);
    for_all(test_states_have_names);
    for_all(test_positions_of_elements);
    return test_end("machine");
}
