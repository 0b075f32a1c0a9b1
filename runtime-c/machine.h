// SPDX-License-Identifier: Apache-2.0
// A state machine as a task sees it, whether it is C that smc emitted (--runtime) or an image on the VM (bytecode-vm/target/machine.h).
//
// On a guarded state vector a step works on a snapshot: what the machine may read is copied in one go, the step runs without the lock,
// and in one go those elements are written back that it stored.  On an unguarded vector it works in place.
#ifndef SM_MACHINE_H
#define SM_MACHINE_H

#include "runtime-c/task.h"

#ifdef __cplusplus
extern "C" {
#endif

// A place in the state vector.
typedef struct SmPlace { uint32_t offset, size; } SmPlace;

// What kind of machine it is: constant, one for each emitted machine, one for all images.
typedef struct SmMachineType {
    SmResult (*init)(void *self, void *sv, uint32_t state);       // SM_E_ARGUMENT: no such state; SM_E_UNSUPPORTED: cannot keep its meaning here
    SmResult (*step)(void *self, void *sv);                       // SM_OK, SM_REFUSED
    uint32_t (*state)(const void *self);                          // that the next step runs
    uint64_t (*time)(const void *self);                           // T
    const char *(*state_name)(const void *self, uint32_t state);  // "" where names were not kept
    uint32_t (*states)(const void *self);
    uint32_t (*layout)(const void *self);                         // hash of the state vector it was made for
    SmPlace (*uses)(const void *self);                            // from the first byte it may read or write to the last
    SmPlace (*number)(const void *self);                          // the element S
    // The elements that the last step stored, one by one: start with *at = 0; false: no more.
    bool (*stored)(const void *self, uint32_t *at, SmPlace *place);
} SmMachineType;

typedef struct SmMachine {
    const char *name;
    const SmMachineType *type;
    void *self;               // the emitted struct, or the VM's memory
    SmStateVec *sv;
    SmEvents *events;
    void *copy;               // layout->whole.size bytes aligned as uint64_t, for snapshots; NULL where sv is not guarded
    uint32_t initial;         // the state it starts in; 0: the first
    bool resume;              // after a restart with a restored vector it starts in the state that S tells, if there is one of that number
    const bool *restored;     // whether the vector was restored; or NULL
    uint16_t number;          // of the machine in its application: SmEvent.source
    // What follows is the runtime's; all zero at first.
    uint32_t last, refused;
} SmMachine;

// As SmTaskInit and SmTaskStep; the context is an SmMachine.
// SM_E_LAYOUT: it was made for another state vector.  Event STATE from 0.
SmResult sm_machine_init(void *machine);
// SM_REFUSED: time did not advance.  Event STATE when it has changed its state.
SmResult sm_machine_step(void *machine, const SmTick *tick);

uint32_t sm_machine_state(const SmMachine *m);
uint64_t sm_machine_time(const SmMachine *m);
const char *sm_machine_state_name(const SmMachine *m, uint32_t state);

#ifdef __cplusplus
}
#endif
#endif
