// SPDX-License-Identifier: Apache-2.0
// The typed .io (config.md 9): which pin is connected to which element.  The checker's output for a tree without errors.  The
// emitters read it; no code changes it after the check.
#ifndef SMC_IOMAP_H
#define SMC_IOMAP_H

#include "compiler/sema/program.h"

typedef enum PinKind { PIN_ANALOG_IN, PIN_ANALOG_OUT, PIN_DIGITAL_IN, PIN_DIGITAL_OUT } PinKind;      // ordered as SmIoKind of runtime-c/io.h

typedef struct Pin {
    PinKind kind;
    uint16_t number;
    const Element *element;
    bool inverted, pull_up, pull_down;
    uint8_t hold;             // inputs: how many steps in a row the element keeps its value while the pin cannot be read
    SmF64 scale, offset;      // analog: element = volts * scale + offset
    SmF64 safe;               // outputs: the value before the first step and while outputs are safed, in the element's unit; digital: 0 or 1
    Span span;                // position of the element's name
} Pin;

typedef struct IoMap {
    Str name;                 // the file's stem
    const Source *src;
    const StateVec *sv;
    VEC(Pin) pin;             // in file order
} IoMap;

static inline bool pin_is_output(const Pin *p) { return p->kind == PIN_ANALOG_OUT || p->kind == PIN_DIGITAL_OUT; }
static inline bool pin_is_digital(const Pin *p) { return p->kind == PIN_DIGITAL_IN || p->kind == PIN_DIGITAL_OUT; }

#endif
