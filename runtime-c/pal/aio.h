// SPDX-License-Identifier: Apache-2.0
// Analog channels: pressure transducers, thermocouples, current loops.  A value is in millionths of what the channel measures,
// microvolts or microamperes, as an int32_t: ±2147 V in steps of 1 µV, exact on every chip, and no chip needs floating
// point for it.  Values beyond saturate.  (Rules for all of these headers: pal.h.)
//
// A channel is a number that the platform's own page explains (docs/porting.md): on Linux 1000 × device + channel, of the IIO
// device of that number; on an Arduino the number behind the A.
#ifndef PAL_AIO_H
#define PAL_AIO_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalAio { uint8_t id; } PalAio;

typedef enum PalAioMode { PAL_AIO_INPUT, PAL_AIO_OUTPUT } PalAioMode;

typedef struct PalAioInfo {
    int32_t lowest, highest;  // what it can show or be set to, in millionths; where that is not known, INT32_MIN and INT32_MAX
    uint32_t step;            // the smallest difference, in millionths, rounded down: 0 is less than one millionth, or not known
} PalAioInfo;

// Takes a channel.  An output has no defined value before its first write.
// SM_E_MISSING: no such channel.  SM_E_BUSY: it is open already.  SM_E_DENIED: not permitted.
// SM_E_UNSUPPORTED: no channels, or this one cannot do that.  SM_E_ARGUMENT: no such mode.  SM_E_FULL.
SmResult pal_aio_open(PalAio *channel, uint16_t number, PalAioMode mode);

SmResult pal_aio_info(PalAio channel, PalAioInfo *info);

// A value measured during the call, which waits for one conversion (tens of microseconds on a chip, milliseconds where the
// converter is behind a slow bus).  SM_E_ARGUMENT: it is an output.  SM_E_DEVICE: there was no measurement.
SmResult pal_aio_read(PalAio channel, int32_t *millionths);

// Sets an output.  A value beyond info's range becomes the nearest within it; where the platform does not know the range, such a
// value may give SM_E_DEVICE and change nothing.  SM_E_ARGUMENT: it is an input.
SmResult pal_aio_write(PalAio channel, int32_t millionths);

// Gives the channel back.  What an output does from here on is the platform's: give it its safe value first.
SmResult pal_aio_close(PalAio channel);

#ifdef __cplusplus
}
#endif
#endif
