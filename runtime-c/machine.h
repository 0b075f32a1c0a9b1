// SPDX-License-Identifier: Apache-2.0
// A state machine that runs as a task: either C emitted by smc, or an image on the VM (machine_type.h).
//
//     static Mission mission;
//     static uint64_t copy[sizeof(RocketSv) / 8];                       // if the .sv says `lock`
//     static SmMachine m = {.name = "mission", .type = &mission_machine, .self = &mission, .sv = &rocket_vector, .events = &events, .copy = copy};
//     static SmTask task = {.name = "mission", .init = sm_machine_init, .step = sm_machine_step, .context = &m};
//
// On a guarded state vector a step works on a snapshot:
// 1. One critical section copies everything that the machine may read.
// 2. The step runs without the lock.
// 3. A second critical section writes back only the elements that the step stored.
// So writes by other tasks in the meantime are preserved.  The machine never sees a partial update by another task, and no other
// task sees a partial update by the machine.  On an unguarded vector the step works in place.
#ifndef SM_MACHINE_H
#define SM_MACHINE_H

#include "runtime-c/machine_type.h"
#include "runtime-c/task.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct SmMachine {
    const char *name;
    const SmMachineType *type;
    void *self;               // the emitted struct, or an SmvmTarget; not shared with another SmMachine
    SmStateVec *sv;
    SmEvents *events;
    void *copy;               // layout->whole.size bytes, aligned as uint64_t, not shared; NULL if sv is not guarded
    uint32_t initial;         // number of the state in which it starts; 0: the first
    bool resume;              // after a restart with a restored vector, start in the state whose number is in S, if that state exists
    const bool *restored;     // whether the vector was restored; or NULL
    uint16_t number;          // number of the machine in its application, for SmEvent.source
    // The fields below belong to the runtime; initially all zero.
    uint32_t last_state;      // the state that the next step runs; 0 if init has not succeeded
    uint32_t refused;         // number of refused steps
    bool was_refused;         // the last step was refused
    bool write_back_due;      // `copy` contains stores that could not be written back yet
} SmMachine;

// Compatible with SmTaskInit and SmTaskStep; the context is an SmMachine.

// Starts the machine: sets locals to their initial values, empties windows, and stores the number of the state in S.  Emits event
// STATE from state 0.
//     SM_E_LAYOUT        the machine was built for another state vector
//     SM_E_ARGUMENT      no such state, or a guarded vector without `copy`
//     SM_E_ALIGNMENT     `copy` or the vector is misaligned
//     SM_E_UNSUPPORTED   floating-point results would differ on this platform, or the vector is guarded and the machine does not
//                        record its stores
// For an image also the results of bytecode-vm/target/machine.h.
SmResult sm_machine_init(void *machine);

// Runs one step.  Emits event STATE at each transition, including a transition of a state to itself.
// SM_REFUSED: time did not advance, and nothing has changed.  The first of several refused steps emits event REFUSED.
// SM_E_TIMEOUT (guarded vector): the lock timed out.  Either nothing has happened, or the step ran and its stores are written
// later, when the lock is available again and before the next step.
SmResult sm_machine_step(void *machine, const SmTick *tick);

// For a machine whose init succeeded.  Call the first two only from the thread that steps the machine; other threads read S.
uint32_t sm_machine_state(const SmMachine *m);        // the state that the next step runs
uint64_t sm_machine_time(const SmMachine *m);         // T, as of the last step
const char *sm_machine_state_name(const SmMachine *m, uint32_t state);     // "" if the machine was built without names

#ifdef __cplusplus
}
#endif
#endif
