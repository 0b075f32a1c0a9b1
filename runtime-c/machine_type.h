// SPDX-License-Identifier: Apache-2.0
// What a machine can do, whatever it is made of: C that smc emitted (`smc build mission.sm --sv rocket.sv --emit=c --runtime` gives
// mission_machine), or an image on the VM (smvm_machine_type, bytecode-vm/target/machine.h).  machine.h runs them alike.
//
// Emitted C includes this header and carries its own arithmetic, so nothing of stdlib but results is included here.
#ifndef SM_MACHINE_TYPE_H
#define SM_MACHINE_TYPE_H

#include <stdbool.h>
#include <stdint.h>

#include "stdlib/result.h"

#ifdef __cplusplus
extern "C" {
#endif

// A place in the state vector.
typedef struct SmPlace { uint32_t offset, size; } SmPlace;

// Constant: one for each emitted machine, one for all images.  `self` is the machine's memory: the emitted struct, or an SmvmTarget.
// `open` comes first, once; where it refused, nothing else may be called.
typedef struct SmMachineType {
    // Whether the machine was made for a state vector of this layout and size, else SM_E_LAYOUT; and whatever else can be refused
    // once for all: an image that the verifier does not accept, memory that is too small.
    SmResult (*open)(void *self, uint32_t layout, uint32_t size);
    // Puts it at a state and stores that in S.  SM_E_ARGUMENT: no such state; SM_E_UNSUPPORTED: it would not keep its meaning here.
    SmResult (*init)(void *self, void *sv, uint32_t state);
    SmResult (*step)(void *self, void *sv);                       // SM_OK or SM_REFUSED; SM_E_ARGUMENT where init has not succeeded
    uint32_t (*state)(const void *self);                          // that the next step runs
    bool (*moved)(const void *self);                              // the last step made a transition, to the same state perhaps
    uint64_t (*time)(const void *self);                           // T
    const char *(*state_name)(const void *self, uint32_t state);  // "" for a state that there is not, and where names were not kept
    uint32_t (*states)(const void *self);                         // how many; they are numbered from 1
    SmPlace (*uses)(const void *self);                            // from the first byte of sv that it may read or write to the last
    SmPlace (*number)(const void *self);                          // the element S
    // Copies from one state vector to another what the last step stored there, S when it did, and not a byte more.
    // NULL: it was built without --track-stores and cannot tell, so it runs on a state vector without `lock` only.
    void (*publish)(const void *self, const void *from, void *to);
} SmMachineType;

#ifdef __cplusplus
}
#endif
#endif
