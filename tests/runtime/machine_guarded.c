// SPDX-License-Identifier: Apache-2.0
// A machine on a guarded state vector: other code writes while it steps, and locks cannot be taken.
#include "machine_stage.h"
#include "many.h"
#include "picker.h"

static const SmMachineType *inner;
static SmMachineType around;              // like `inner`, but other code writes before and after the step
static void (*others)(void);

static SmResult step_with_concurrent_write(void *self, void *sv)
{
    SmResult r;

    others();
    r = inner->step(self, sv);
    others();
    return r;
}

static void set_concurrent_write(SmMachine *m, void (*act)(void))
{
    inner = m->type;
    around = *inner;
    around.step = step_with_concurrent_write;
    others = act;
    m->type = &around;
}

// ---- elements that it does not store ----

static StandSv theirs;                    // what the other code writes: the whole vector, repeatedly

static void write_everything(void)
{
    CHECK(sm_enter(&stage.vector) == SM_OK);          // the lock is free while a machine steps
    stand_sv = theirs;
    sm_leave(&stage.vector);
}

static void check_stored_alone(Kind kind)
{
    StandSv expected;

    start_stage(kind, true);
    memset(&theirs, 0x33, sizeof theirs);
    set_concurrent_write(&stage.machine, write_everything);
    expected = theirs;
    expected.testerState = 1;             // the first step of a state stores S
    expected.valve = 1;
    CHECK(step(1) == SM_OK && memcmp(&stand_sv, &expected, sizeof expected) == 0);
    CHECK(step(1) == SM_OK);              // the step uses the valve that it has stored itself, whatever the other code writes meanwhile
    expected = theirs;
    expected.valve = 0;
    CHECK(memcmp(&stand_sv, &expected, sizeof expected) == 0);
}

// A step does not see what other code writes to the vector during the step.
static void check_snapshot(Kind kind)
{
    start_stage(kind, true);
    stand_sv.pressure = 4;
    CHECK(step(2) == SM_OK);
    memset(&theirs, 0, sizeof theirs);
    theirs.left = 1;
    theirs.pressure = 100;
    set_concurrent_write(&stage.machine, write_everything);
    stand_sv.pressure = 4;
    CHECK(step(0) == SM_OK && stand_sv.sum == 4 && stand_sv.torn == 0);
}

// The machine writes no byte of the copy outside the range that it accesses.
static void check_copy(Kind kind)
{
    const uint8_t *copy = (const uint8_t *)stage.copy;
    SmRange uses;

    start_stage(kind, true);
    uses = stage.machine.type->accessed(stage.machine.self);
    step(1);
    step(2);
    for (size_t i = 0; i < sizeof stage.copy; i++)
        if (i < uses.offset || i >= uses.offset + uses.size)
            CHECK(copy[i] == 0x5a);
}

// ---- locks ----

static void check_refused_lock_at_begin(Kind kind)
{
    StandSv before;

    start_stage(kind, true);
    before = stand_sv;
    sim_fail(SIM_lock_take, 0, SM_E_TIMEOUT);
    CHECK(step(2) == SM_E_TIMEOUT && sm_machine_state(&stage.machine) == 1 && nothing_happened());
    before.clock = stand_sv.clock;
    before.order = stand_sv.order;
    CHECK(memcmp(&before, &stand_sv, sizeof before) == 0 && stage.vector.faults == 1);
    CHECK(sm_machine_step(&stage.machine, &stage.tick) == SM_OK && happened(SM_EVENT_STATE, 1, 2));
}

// The step has run.  Its stores are written when the lock is free, even if the next step is refused.
static void check_refused_lock_at_end(Kind kind)
{
    start_stage(kind, true);
    sim_fail(SIM_lock_take, 1, SM_E_TIMEOUT);
    CHECK(step(1) == SM_E_TIMEOUT && stand_sv.valve == 0);
    CHECK(sm_machine_step(&stage.machine, &stage.tick) == SM_REFUSED && stand_sv.valve == 1 && happened(SM_EVENT_REFUSED, 1, 0));
    stand_sv.valve = 0;
    CHECK(sm_machine_step(&stage.machine, &stage.tick) == SM_REFUSED && stand_sv.valve == 0);      // the stores are written only once
    sim_fail(SIM_lock_take, 1, SM_E_TIMEOUT);
    CHECK(step(2) == SM_E_TIMEOUT && sm_machine_state(&stage.machine) == 2);
    CHECK(happened(SM_EVENT_STATE, 1, 2));
    CHECK(step(1) == SM_OK && stand_sv.testerState == 2 && stand_sv.level == 1000);
}

static void check_refused_lock_at_start(Kind kind)
{
    set_stage(kind, true);
    sim_fail(SIM_lock_take, 0, SM_E_TIMEOUT);
    CHECK(sm_machine_init(&stage.machine) == SM_E_TIMEOUT && sm_machine_step(&stage.machine, &stage.tick) == SM_E_ARGUMENT);
    stage.machine.resume = true;
    stage.machine.restored = &stage.machine.resume;
    sim_fail(SIM_lock_take, 0, SM_E_TIMEOUT);
    CHECK(sm_machine_init(&stage.machine) == SM_E_TIMEOUT && nothing_happened());
    CHECK(sm_machine_init(&stage.machine) == SM_OK);
}

// ---- more outputs than one word notes ----

static Picker picker;
static uint64_t many_memory[64], many_copy[sizeof(ManySv) / 8];

static ManySv many_theirs;

static void write_many_elements(void) { many_sv = many_theirs; }

static void check_many_outputs(Kind kind)
{
    SmvmTarget target = {.image = picker_image, .size = sizeof picker_image, .memory = many_memory, .memory_size = sizeof many_memory};
    SmMachine m = {.name = "picker", .type = &picker_machine, .self = &picker, .sv = &many_vector, .copy = many_copy};
    uint16_t *const e = &many_sv.e0;
    SmTick tick = {0, 0};

    if (kind == IMAGE) {
        m.type = &smvm_machine_type;
        m.self = &target;
    }
    sim_reset();
    memset(&many_sv, 0, sizeof many_sv);
    CHECK(sm_statevec_init(&many_vector) == SM_OK && sm_machine_init(&m) == SM_OK);
    set_concurrent_write(&m, write_many_elements);
    for (uint8_t i = 0; i < 70; i++) {
        memset(&many_theirs, 0x11, sizeof many_theirs);
        many_sv.which = i;
        many_sv.G = i + 1u;
        e[i] = (uint16_t)(1000 + i);
        CHECK(sm_machine_step(&m, &tick) == SM_OK);
        for (uint8_t k = 0; k < 70; k++)
            CHECK(e[k] == (k == i ? 1001 + i : 0x1111));
        CHECK(many_sv.S == (i == 0 ? 1 : 0x11111111u) && many_sv.which == 0x11);
    }
}

int main(void)
{
    for (int kind = EMITTED; kind < KINDS; kind++) {
        check_stored_alone((Kind)kind);
        check_snapshot((Kind)kind);
        check_copy((Kind)kind);
        check_refused_lock_at_begin((Kind)kind);
        check_refused_lock_at_end((Kind)kind);
        check_refused_lock_at_start((Kind)kind);
    }
    check_many_outputs(EMITTED);
    check_many_outputs(IMAGE);
    return test_end("machine_guarded");
}
