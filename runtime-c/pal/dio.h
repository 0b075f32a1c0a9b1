// SPDX-License-Identifier: Apache-2.0
// Digital pins: valves, igniters, switches.  `true` is the high level.  What a high level does to a valve depends on the wiring.
// (Rules for all of these headers: pal.h.)
//
// Pins are identified by number.  The platform's section of docs/porting.md defines the numbers.  On Linux: 1000 × chip + line, so
// that 4 is line 4 of /dev/gpiochip0.  On an Arduino: the number printed on the board.
#ifndef PAL_DIO_H
#define PAL_DIO_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalDio { uint8_t id; } PalDio;

typedef enum PalDioMode {
    PAL_DIO_INPUT,            // follows the connected signal; floats if nothing is connected
    PAL_DIO_PULL_UP,          // an input that reads high if nothing is connected
    PAL_DIO_PULL_DOWN,        // an input that reads low if nothing is connected
    PAL_DIO_OUTPUT            // drives the level that was set
} PalDioMode;

// Opens a pin.  An output has `level` as soon as it becomes an output, without a pulse of the opposite level.  For an input `level`
// is ignored.
//     SM_E_MISSING       no such pin
//     SM_E_BUSY          it is already open, in this program or another one
//     SM_E_DENIED        no permission
//     SM_E_UNSUPPORTED   the platform has no pins, or this pin does not support the mode
//     SM_E_ARGUMENT      no such mode
//     SM_E_FULL          the table has no free entry
SmResult pal_dio_open(PalDio *pin, uint16_t number, PalDioMode mode, bool level);

// Reads the level at the pin.  For an output this is the last level that was set.
SmResult pal_dio_read(PalDio pin, bool *level);

// Sets an output.  SM_OK: the pin now has that level.  SM_E_ARGUMENT: the pin is an input.  SM_E_DEVICE: the level is unknown.
SmResult pal_dio_write(PalDio pin, bool level);

// Closes the pin.  Afterwards the platform determines the level of an output, so set it to its safe level first.  Neither closing
// the pin nor ending the program sets a safe level.
SmResult pal_dio_close(PalDio pin);

#ifdef __cplusplus
}
#endif
#endif
