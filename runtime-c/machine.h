// SPDX-License-Identifier: Apache-2.0
// A state machine as a task runs it, whether it is C that smc emitted or an image on the VM (machine_type.h).
//
//     static Mission mission;
//     static uint64_t copy[sizeof(RocketSv) / 8];                       // where the .sv says `lock`
//     static SmMachine m = {.name = "mission", .type = &mission_machine, .self = &mission, .sv = &rocket_vector, .events = &events, .copy = copy};
//     static SmTask task = {.name = "mission", .init = sm_machine_init, .step = sm_machine_step, .context = &m};
//
// On a guarded state vector a step works on a snapshot: what the machine may read is copied in one critical section, the step runs
// without the lock, and in a second one those elements are written that it stored, no others.  So whatever others write meanwhile stays;
// the machine never sees half of what somebody wrote in one go, nor anybody half of what it stored.  On an unguarded vector it works in place.
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
    void *self;               // the emitted struct, or an SmvmTarget; its own, of no other SmMachine
    SmStateVec *sv;
    SmEvents *events;
    void *copy;               // layout->whole.size bytes aligned as uint64_t, its own; NULL where sv is not guarded
    uint32_t initial;         // the state it starts in; 0: the first
    bool resume;              // after a restart with a restored vector it starts in the state that S tells, if there is one of that number
    const bool *restored;     // whether the vector was restored; or NULL
    uint16_t number;          // of the machine in its application: SmEvent.source
    // What follows is the runtime's; all zero at first.
    uint32_t last;            // the state that the next step runs; 0 where init has not succeeded
    uint32_t refused;         // steps
    bool standing;            // the last step was refused
    bool owed;                // `copy` holds stores that could not be written yet
} SmMachine;

// As SmTaskInit and SmTaskStep; the context is an SmMachine.

// Starts it: locals at their initial values, windows empty, the state's number in S.  Event STATE from 0.
// SM_E_LAYOUT: it was made for another state vector.  SM_E_ARGUMENT: there is no such state, or no `copy` for a guarded vector.
// SM_E_ALIGNMENT: copy or vector.  SM_E_UNSUPPORTED: its numbers would come out otherwise here, or the vector is guarded and the machine
// cannot tell what it stores.  An image: what bytecode-vm/target/machine.h says.
SmResult sm_machine_init(void *machine);

// SM_REFUSED: time did not advance; nothing has changed.  Event REFUSED when that begins.  Event STATE at each transition, also of a
// state to itself.  SM_E_TIMEOUT (guarded): the lock could not be had.  Then either nothing has happened; or the step was run and what it stored is
// written when the lock can be had again, before the next step.
SmResult sm_machine_step(void *machine, const SmTick *tick);

// Of a machine whose init succeeded.  The first two from the thread that steps it; from others read S.
uint32_t sm_machine_state(const SmMachine *m);        // that the next step runs
uint64_t sm_machine_time(const SmMachine *m);         // T, as of the last step
const char *sm_machine_state_name(const SmMachine *m, uint32_t state);     // "" where names were not kept

#ifdef __cplusplus
}
#endif
#endif
