// SPDX-License-Identifier: Apache-2.0
// One pin and the element that it stands for (docs/config.md 9); io.h has tables of them.
#ifndef SM_PIN_H
#define SM_PIN_H

#include <stdint.h>

#include "runtime-c/pal/pal.h"
#include "stdlib/f64.h"

#ifdef __cplusplus
extern "C" {
#endif

// Bit 0: an output; bit 1: digital.
typedef enum SmIoKind { SM_ANALOG_IN, SM_ANALOG_OUT, SM_DIGITAL_IN, SM_DIGITAL_OUT } SmIoKind;

enum { SM_IO_INVERTED = 1, SM_IO_PULL_UP = 2, SM_IO_PULL_DOWN = 4 };     // SmIoPin.flags

typedef struct SmIoPin {
    uint8_t kind;             // SmIoKind
    uint8_t type;             // of the element
    uint8_t flags;
    uint8_t hold;             // IN: steps that the last measurement is kept
    uint16_t pin;
    uint32_t offset;          // the element's place in the state vector
    // Bits of an SmF64 (sm_from_bits), so that the table is constant on every chip:
    uint64_t scale, zero;     // analog: element = volts * scale + zero
    uint64_t safe;            // OUT: what it is set to while the outputs are safed; what it has before the first step
} SmIoPin;

// `handle` is the PAL's, one byte.  Results are those of pal/dio.h and pal/aio.h.
SmResult sm_pin_open(const SmIoPin *p, uint8_t *handle);             // an output at its safe value
SmResult sm_pin_read(const SmIoPin *p, uint8_t handle, SmF64 *x);  // x: the element's number
SmResult sm_pin_write(const SmIoPin *p, uint8_t handle, SmF64 x);
void sm_pin_close(const SmIoPin *p, uint8_t handle);                 // as it is

// The same in parts.  v: millionths; of a digital pin 1 where its element is true, else 0.
SmResult sm_pin_get(const SmIoPin *p, uint8_t handle, int32_t *v);
SmResult sm_pin_set(const SmIoPin *p, uint8_t handle, int32_t v);
SmF64 sm_pin_number(const SmIoPin *p, int32_t v);                     // the element's number of it (9.8)
int32_t sm_pin_value(const SmIoPin *p, SmF64 x);                      // and back: the nearest millionth, as far as there are any

#ifdef __cplusplus
}
#endif
#endif
