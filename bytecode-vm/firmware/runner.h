// SPDX-License-Identifier: Apache-2.0
// Runs an image as a whole application.  All its machines share one state vector.  A step reads the input pins, steps each machine, and
// writes the output pins.  Nothing about the image must be known when this is compiled.
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

enum {
    SMVM_RUNNER_MACHINES = 4,         // the most machines of an image
    SMVM_RUNNER_DIGITAL = offsetof(SmIoPin, scale), SMVM_RUNNER_ANALOG = offsetof(SmIoPin, safe)       // bytes of memory for a pin of each kind
};

typedef struct SmvmRunner {
    uint64_t *memory;         // for the state vector, followed by machines and pins
    uint16_t size;            // bytes of `memory`
    SmvmPhysicalPin *physical_pin;  // NULL: smvm_runner_fits cannot detect a missing pin, only smvm_runner_open can
    // The remaining fields belong to the runner.
    uint8_t machines;         // number of machines that run; 0: nothing runs
    uint16_t rows, rows_end;  // start and end of the rows of open pins in `memory`, as byte offsets
    SmvmBytes image;                        // the image that runs
    SmVm *vm[SMVM_RUNNER_MACHINES];         // by machine: its memory, inside `memory`
    uint16_t g[SMVM_RUNNER_MACHINES];                  // by machine: offset of element G in the state vector
} SmvmRunner;

// Whether an image that smvm_verify has accepted fits.  SM_E_MEMORY: too little RAM or too many machines.
// SM_E_MISSING: it uses a pin that does not exist.  SM_E_LAYOUT: its machines and pins belong to different state vectors.
SmResult smvm_runner_fits(const SmvmRunner *r, SmvmBytes image);

// Sets all machines to their initial states and opens all pins, outputs at their safe values.  Returns an error of smvm_runner_fits, or the error of
// the first pin that could not be opened; then nothing runs and no pin is open.
SmResult smvm_runner_open(SmvmRunner *r, SmvmBytes image);

// Reads the input pins, steps each machine and writes the output pins.  g points to the time of the step, a U64.
void smvm_runner_step(SmvmRunner *r, const void *g);

// Sets outputs to their safe values, closes the pins and stops all machines.
void smvm_runner_stop(SmvmRunner *r);

#ifdef __cplusplus
}
#endif
#endif
