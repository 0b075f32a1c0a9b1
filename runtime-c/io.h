// SPDX-License-Identifier: Apache-2.0
// The two I/O tasks: inputs bring pins to elements before the other tasks of a tick, outputs bring elements to pins after them.
// The table comes from a .io file (docs/config.md): as C, or carried by an image.
//
// A number at an analog pin is in volts (or amperes): millionths of pal/aio.h divided by 1,000,000.  The element is that times scale, plus
// offset; an output goes the other way.  A pin that cannot be read gives no measurement: after `hold` further steps with the last one the
// element becomes NaN, which is 0 in integers and false in bool (language.md).  The other pins are read all the same.
#ifndef SM_IO_H
#define SM_IO_H

#include "runtime-c/pal/aio.h"
#include "runtime-c/pal/dio.h"
#include "runtime-c/task.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum SmIoKind { SM_ANALOG_IN, SM_ANALOG_OUT, SM_DIGITAL_IN, SM_DIGITAL_OUT } SmIoKind;

enum { SM_IO_INVERTED = 1, SM_IO_PULL_UP = 2, SM_IO_PULL_DOWN = 4 };     // SmIoPin.flags

typedef struct SmIoPin {
    uint8_t kind;             // SmIoKind
    uint8_t type;             // of the element
    uint8_t flags;
    uint8_t hold;             // IN: steps that the last measurement is kept
    uint16_t pin;
    uint32_t offset;          // the element's place in the state vector
    SmF64 scale, zero;        // analog: element = volts * scale + zero
    SmF64 safe;               // OUT: what it is set to while the outputs are safed; what it has before the first step
} SmIoPin;

typedef struct SmIo {
    const SmIoPin *pin;
    uint16_t pins;
    SmStateVec *sv;
    uint8_t *handle;          // one byte a pin: the PAL's handles
    uint8_t *missed;          // one byte a pin: failed steps in a row, up to 255
    // What follows is the runtime's.
    uint16_t failed;          // START: the pin that could not be opened; afterwards the last that failed
} SmIo;

// As SmTaskInit and SmTaskStep; the context is an SmIo.  Opens all pins of their direction, outputs at their safe value; the result is
// that of the first that fails (then `failed` tells which, and those opened are closed again).
SmResult sm_inputs_init(void *io);
SmResult sm_outputs_init(void *io);
SmResult sm_inputs_step(void *io, const SmTick *tick);        // one critical section for all elements
SmResult sm_outputs_step(void *io, const SmTick *tick);
SmResult sm_outputs_safe(void *io, const SmTick *tick);       // every output to its safe value

#ifdef __cplusplus
}
#endif
#endif
