// SPDX-License-Identifier: Apache-2.0
// The two I/O tasks.  Inputs copy pins to elements before the other tasks of a tick.  Outputs copy elements to pins after them.
// The pin table comes from a .io file (docs/config.md 9), either as C or as part of an image.
//
//     SmResult r = sm_inputs_init(&rocket_inputs);                  // once; likewise for the outputs
//     r = sm_inputs_step(&rocket_inputs, &tick);                    // then in every tick: inputs, tasks, outputs
//
// Analog values are in volts (or amperes): the millionths of pal/aio.h divided by 1,000,000.  The element of an input is this
// value times `scale`, plus `zero`.  An output uses the inverse, rounded to the nearest millionth, halves away from 0, and
// saturated to int32_t.  If an input cannot be read, its element keeps its value for `hold` steps.  After that it becomes NaN,
// which is 0 in integers and false in bool (language.md).  The other pins are still read.
//
// All elements of one direction are stored, or loaded, in one critical section.  No pin is accessed while the lock is held.
#ifndef SM_IO_H
#define SM_IO_H

#include "runtime-c/pin.h"
#include "runtime-c/task.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct SmIo {
    const SmIoPin *pin;
    uint16_t pins;
    SmStateVec *sv;
    uint8_t *handle;          // one byte for each pin: the PAL handles
    uint16_t *missed;         // one for each pin: consecutive failed steps, at most 65535; init sets them
    uint64_t *value;          // one for each pin: bits of the value that is being copied between pin and element
    // The field below belongs to the runtime.
    uint16_t failed;          // index into `pin`: after init, the pin that could not be opened; later, the last pin that failed
} SmIo;

// Compatible with SmTaskInit and SmTaskStep; the context is an SmIo.  A table may contain both directions; each function ignores
// the pins of the other one.

// Opens all pins, outputs at their safe value.  If a pin fails, the result is its error, `failed` is its index, and the pins
// opened so far are closed.  SM_E_ARGUMENT: a row is invalid (an element outside the vector, an unknown type or kind, a scale of
// 0).
SmResult sm_inputs_init(void *io);
SmResult sm_outputs_init(void *io);

// Returns SM_OK, or the error of the first pin that failed.  SM_E_TIMEOUT: the lock of the state vector timed out, and no element
// was changed.
SmResult sm_inputs_step(void *io, const SmTick *tick);

// Sets every output in every step, even if its element has not changed, so that a disturbance of a pin lasts at most one step.
// Results as for sm_inputs_step.  If the lock of the state vector times out, outputs stay as they are.
SmResult sm_outputs_step(void *io, const SmTick *tick);
SmResult sm_outputs_safe(void *io, const SmTick *tick);       // sets every output to its safe value

// Closes all pins of one direction; outputs are first set to their safe values.  For an application that ends.
void sm_inputs_close(SmIo *io);
void sm_outputs_close(SmIo *io);

#ifdef __cplusplus
}
#endif
#endif
