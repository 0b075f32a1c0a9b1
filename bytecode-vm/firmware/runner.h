// SPDX-License-Identifier: Apache-2.0
// An image as a whole application: its machines on one state vector, its pins before and behind them.  Nothing of it is known when
// this is compiled.
//
//     static uint64_t memory[128];
//     SmvmRunner r = {.memory = memory, .size = sizeof memory};
//     if (smvm_verify(image, size, &why) == 0 && smvm_runner_open(&r, image) == SM_OK)
//         for (;;)
//             smvm_runner_step(&r, &g);                  // inputs, machines in their order, outputs
#ifndef SMVM_RUNNER_H
#define SMVM_RUNNER_H

#include <stddef.h>

#include "bytecode-vm/smvm.h"
#include "runtime-c/pin.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { SMVM_RUNNER_MACHINES = 4, SMVM_RUNNER_DIGITAL = offsetof(SmIoPin, scale), SMVM_RUNNER_ANALOG = offsetof(SmIoPin, safe) };     // bytes of a pin

typedef struct SmvmRunner {
    uint64_t *memory;         // for the state vector, and behind it machines and pins
    uint16_t size;            // bytes of it
    SmvmPinPlace *pin_place;  // NULL: whether there is such a pin is seen when it is opened
    // What follows is the runner's.
    uint8_t machines;         // 0: nothing runs
    uint16_t rows, rows_end;  // where in `memory` the open pins are
    SmvmBytes image;
    SmVm *vm[SMVM_RUNNER_MACHINES];
    uint16_t g[SMVM_RUNNER_MACHINES];                  // where in the state vector it finds the time
} SmvmRunner;

// Whether there is room for an image that smvm_verify has accepted.  SM_E_MEMORY: too little RAM, too many machines.
// SM_E_MISSING: it names a pin that there is not.  SM_E_LAYOUT: its machines and pins are not all for one state vector.
SmResult smvm_runner_fits(const SmvmRunner *r, SmvmBytes image);

// Puts all machines at their initial states and opens all pins, outputs at their safe values.  Results as above, or of the first pin that
// could not be opened; then nothing runs and no pin is open.
SmResult smvm_runner_open(SmvmRunner *r, SmvmBytes image);

void smvm_runner_step(SmvmRunner *r, const void *g);       // g: the time, as a U64 in memory

// Outputs to their safe values, pins closed; nothing runs any more.
void smvm_runner_stop(SmvmRunner *r);

#ifdef __cplusplus
}
#endif
#endif
