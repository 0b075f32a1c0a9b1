// SPDX-License-Identifier: Apache-2.0
// Accesses one pin, and converts between its value and that of its element (docs/config.md 9).  For tables of pins: io.h.
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

enum { SM_IO_INVERTED = 1, SM_IO_PULL_UP = 2, SM_IO_PULL_DOWN = 4 };     // bits of SmIoPin.flags

typedef struct SmIoPin {
    uint8_t kind;             // SmIoKind
    uint8_t type;             // type of the element (SmType)
    uint8_t flags;            // SM_IO_INVERTED …
    uint8_t hold;             // IN: number of failed steps for which the last measurement stays valid
    uint16_t pin;
    uint32_t offset;          // offset of the element in the state vector, in bytes
    // Bits of an SmF64 (sm_from_bits), so that the table is constant on every chip:
    uint64_t scale, zero;     // analog: element = volts * scale + zero
    uint64_t safe;            // OUT: value before the first step and while the outputs are in their safe mode
} SmIoPin;

// `handle` is a PAL handle of one byte.  Results are those of pal/dio.h and pal/aio.h.
SmResult sm_pin_open(const SmIoPin *p, uint8_t *handle);             // an output starts at its safe value
SmResult sm_pin_read(const SmIoPin *p, uint8_t handle, SmF64 *x);  // x: the value of the element
SmResult sm_pin_write(const SmIoPin *p, uint8_t handle, SmF64 x);
void sm_pin_close(const SmIoPin *p, uint8_t handle);                 // does not change the level of an output

// sm_pin_read and sm_pin_write in two parts: access to the pin, and conversion between v and the value of the element.  v: the pin's value in
// millionths; for a digital pin, 1 if its element is true, else 0.
SmResult sm_pin_read_raw(const SmIoPin *p, uint8_t handle, int32_t *v);
SmResult sm_pin_write_raw(const SmIoPin *p, uint8_t handle, int32_t v);
SmF64 sm_pin_from_raw(const SmIoPin *p, int32_t v);                   // converts v to the value of the element (config.md 9.8)
int32_t sm_pin_to_raw(const SmIoPin *p, SmF64 x);                     // converts a value to v, the nearest millionth, saturated

#ifdef __cplusplus
}
#endif
#endif
