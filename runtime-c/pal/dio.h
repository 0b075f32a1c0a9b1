// SPDX-License-Identifier: Apache-2.0
// Digital pins: valves, igniters, switches.  `true` is the high level; what high means for a valve is the wiring's.
// (Rules for all of these headers: pal.h.)
//
// A pin is a number that the platform's own page explains (docs/porting.md): on Linux 1000 × chip + line, so that 4 is line 4 of
// /dev/gpiochip0; on an Arduino the number printed on the board.
#ifndef PAL_DIO_H
#define PAL_DIO_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalDio { uint8_t id; } PalDio;

typedef enum PalDioMode {
    PAL_DIO_INPUT,            // follows what is connected; floats if nothing is
    PAL_DIO_PULL_UP,          // an input that reads high if nothing is connected
    PAL_DIO_PULL_DOWN,        // an input that reads low if nothing is connected
    PAL_DIO_OUTPUT            // driven
} PalDioMode;

// Takes a pin.  An output has `level` from its first moment as an output, without a pulse of the other; for an input it means
// nothing. SM_E_MISSING: no such pin.  SM_E_BUSY: it is open already, here or in another program.  SM_E_DENIED: not permitted.
// SM_E_UNSUPPORTED: no pins, or this one cannot do that.  SM_E_ARGUMENT: no such mode.  SM_E_FULL.
SmResult pal_dio_open(PalDio *pin, uint16_t number, PalDioMode mode, bool level);

// The level at the pin; of an output, the one it was last given.
SmResult pal_dio_read(PalDio pin, bool *level);

// Sets an output.  SM_OK: the pin has that level now.  SM_E_ARGUMENT: it is an input.
// SM_E_DEVICE: the level is not known.
SmResult pal_dio_write(PalDio pin, bool level);

// Gives the pin back.  What an output does from here on is the platform's: give it its safe level first, and do not rely
// on close, nor on a program's end, to do so.
SmResult pal_dio_close(PalDio pin);

#ifdef __cplusplus
}
#endif
#endif
