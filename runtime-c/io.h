// SPDX-License-Identifier: Apache-2.0
// The two I/O tasks: inputs bring pins to elements before the other tasks of a tick, outputs bring elements to pins after them.
// The table comes from a .io file (docs/config.md 9): as C, or carried by an image.
//
//     SmResult r = sm_inputs_init(&rocket_inputs);                  // once; the same of the outputs
//     r = sm_inputs_step(&rocket_inputs, &tick);                    // then in every tick: inputs, tasks, outputs
//
// A number at an analog pin is in volts (or amperes): millionths of pal/aio.h divided by 1,000,000.  The element is that times
// scale, plus offset; an output goes the other way, and the nearest millionth is set, halves away from 0, as far as an int32_t
// reaches.  A pin that cannot be read gives no measurement: for `hold` steps the element stays as it is, then it becomes NaN,
// which is 0 in integers and false in bool (language.md).  The other pins are read all the same.
//
// All elements of one direction are stored, or read, in one critical section, and nothing else happens in it: no pin is touched
// while the lock is held.
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
    uint8_t *handle;          // one byte a pin: the PAL's handles
    uint16_t *missed;         // one a pin: failed steps in a row, up to 65535; any value before init
    uint64_t *value;          // one a pin: the element's bits on their way
    // What follows is the runtime's.
    uint16_t failed;          // INIT: which of `pin` could not be opened; afterwards the last one that failed
} SmIo;

// As SmTaskInit and SmTaskStep; the context is an SmIo.  A table may hold both directions: each of these minds its own.

// Opens all pins, outputs at their safe value.  The result is that of the first that fails: then `failed` tells which, and those
// opened are closed again.  SM_E_ARGUMENT: a row that nothing could be done with (an element beyond the vector, a type or a kind
// that there is not, a scale of 0).
SmResult sm_inputs_init(void *io);
SmResult sm_outputs_init(void *io);

// SM_OK, or what the first pin that failed said; SM_E_TIMEOUT: the vector could not be had, elements stay as they are.
SmResult sm_inputs_step(void *io, const SmTick *tick);

// Sets every output in every step, whether its element has changed or not: what disturbed a pin does so for one step only.
// Results as above; where the vector cannot be had, outputs stay as they are.
SmResult sm_outputs_step(void *io, const SmTick *tick);
SmResult sm_outputs_safe(void *io, const SmTick *tick);       // every output to its safe value

// Outputs to their safe values, then gives all pins of that direction back.  For an application that ends.
void sm_inputs_close(SmIo *io);
void sm_outputs_close(SmIo *io);

#ifdef __cplusplus
}
#endif
#endif
