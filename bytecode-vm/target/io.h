// SPDX-License-Identifier: Apache-2.0
// Converts the pins of an image to tables of the flight runtime (runtime-c/io.h).
//
//     static SmIoPin row[16];
//     static uint8_t handle[16]; static uint16_t missed[16]; static uint64_t value[16];
//     static SmIo pins = {row, 0, &rocket_vector, handle, missed, value, 0};
//     if (smvm_target_pins(image, &rocket_vector, row, 16, &pins.pins) != SM_OK)
//         refuse();
//     sm_inputs_init(&pins); sm_outputs_init(&pins);                    // the table has both directions: each call opens only its own
#ifndef SMVM_TARGET_IO_H
#define SMVM_TARGET_IO_H

#include "bytecode-vm/smvm.h"
#include "runtime-c/io.h"

#ifdef __cplusplus
extern "C" {
#endif

// Fills `row` and *n from an image that smvm_verify has accepted, in the order of the .io file; *n is 0 if it has no pins.
// SM_E_LAYOUT: they belong to another state vector.  SM_E_MEMORY: there are more than `room`.
SmResult smvm_target_pins(SmvmBytes image, const SmStateVec *sv, SmIoPin *row, uint16_t room, uint16_t *n);

// Converts a pin that smvm_next_pin has read to a row of a table of the flight runtime.
void smvm_target_pin(const SmvmPin *p, SmIoPin *row);

#ifdef __cplusplus
}
#endif
#endif
