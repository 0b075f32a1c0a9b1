// SPDX-License-Identifier: Apache-2.0
// Analog channels: pressure transducers, thermocouples, current loops.
//
// A value is an int32_t in millionths of the measured unit: microvolts or microamperes.  The range is ±2147 V in steps of 1 µV.
// Values beyond the range saturate.  Integer values are exact on every chip and need no floating point.  (Rules for all of these
// headers: pal.h.)
//
// Channels are identified by number.  The platform's section of docs/porting.md defines the numbers.  On Linux: 1000 × device +
// channel, where `device` is the number of the IIO device.  On an Arduino: the number after the A.
#ifndef PAL_AIO_H
#define PAL_AIO_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalAio { uint8_t id; } PalAio;

typedef enum PalAioMode { PAL_AIO_INPUT, PAL_AIO_OUTPUT } PalAioMode;

typedef struct PalAioInfo {
    int32_t lowest, highest;  // range that it can measure or output, in millionths; INT32_MIN and INT32_MAX if unknown
    uint32_t step;            // resolution in millionths, rounded down; 0: less than one millionth, or unknown
} PalAioInfo;

// Opens an analog channel for input or output.  The value of an output is undefined until its first write.
//     SM_E_MISSING       no such channel
//     SM_E_BUSY          it is already open
//     SM_E_DENIED        no permission
//     SM_E_UNSUPPORTED   the platform has no analog channels, or this channel does not support the mode
//     SM_E_ARGUMENT      no such mode
//     SM_E_FULL          the table has no free entry
SmResult pal_aio_open(PalAio *channel, uint16_t number, PalAioMode mode);

SmResult pal_aio_info(PalAio channel, PalAioInfo *info);

// Measures the channel.  The call waits for one conversion: tens of microseconds on a chip, milliseconds if the converter is on a
// slow bus.  SM_E_ARGUMENT: the channel is an output.  SM_E_DEVICE: the measurement failed.
SmResult pal_aio_read(PalAio channel, int32_t *millionths);

// Sets an output.  A value outside the range of PalAioInfo is clamped to it.  If the platform does not know the range, a value
// outside it may return SM_E_DEVICE and change nothing.  SM_E_ARGUMENT: the channel is an input.
SmResult pal_aio_write(PalAio channel, int32_t millionths);

// Closes the channel.  Afterwards the platform determines the value of an output, so set it to its safe value first.
SmResult pal_aio_close(PalAio channel);

#ifdef __cplusplus
}
#endif
#endif
