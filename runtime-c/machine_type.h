// SPDX-License-Identifier: Apache-2.0
// The interface of a machine, independent of its implementation.  It is either C emitted by smc (`smc build mission.sm --sv
// rocket.sv --emit=c --runtime` produces mission_machine), or an image on the VM (smvm_machine_type, bytecode-vm/target/machine.h).
// machine.h runs both kinds.
//
// Emitted C includes this header and contains its own arithmetic.  Therefore this header includes nothing of stdlib except results.
#ifndef SM_MACHINE_TYPE_H
#define SM_MACHINE_TYPE_H

#include <stdbool.h>
#include <stdint.h>

#include "stdlib/result.h"

#ifdef __cplusplus
extern "C" {
#endif

// A range of bytes in the state vector.
typedef struct SmRange { uint32_t offset, size; } SmRange;

// Constant: one for each emitted machine, one for all images.  `self` is the machine's memory: the emitted struct, or an
// SmvmTarget.  Call `open` first, once.  If it fails, call nothing else.
typedef struct SmMachineType {
    // Returns SM_E_LAYOUT if the machine was not built for a state vector of this layout and size.  Performs all other checks that
    // are needed only once: that the verifier accepts an image, that the memory is large enough.
    SmResult (*open)(void *self, uint32_t layout, uint32_t size);
    // Enters a state and stores its number in S.  SM_E_ARGUMENT: no such state.  SM_E_UNSUPPORTED: the floating-point arithmetic of
    // this computer, as the program was built and set up, does not give the results that the language defines.
    SmResult (*init)(void *self, void *sv, uint32_t state);
    SmResult (*step)(void *self, void *sv);                       // SM_OK or SM_REFUSED; SM_E_ARGUMENT if init has not succeeded
    uint32_t (*state)(const void *self);                          // the state that the next step runs
    bool (*moved)(const void *self);                              // whether the last step made a transition, possibly to the same state
    uint64_t (*time)(const void *self);                           // T, the time in the current state
    const char *(*state_name)(const void *self, uint32_t state);  // "" for an unknown state, and without names
    uint32_t (*states)(const void *self);                         // number of states; they are numbered from 1
    SmRange (*accessed)(const void *self);                        // range of sv from the first byte that it may access to the last
    SmRange (*state_number)(const void *self);                    // range of element S, which stores the number of the state
    // Copies what the last step stored from one state vector to another, including S if it was stored, and nothing else.  NULL: the
    // machine was built without --track-stores and does not record its stores, so it requires a state vector without `lock`.
    void (*publish)(const void *self, const void *from, void *to);
} SmMachineType;

#ifdef __cplusplus
}
#endif
#endif
