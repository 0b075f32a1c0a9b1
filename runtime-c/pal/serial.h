// SPDX-License-Identifier: Apache-2.0
// Serial lines: bytes both ways, 8 data bits, no parity, 1 stop bit, no flow control, no byte changed or swallowed on the
// way.  One thread may send while another receives.  Bytes can be lost or wrong: whoever sends puts a checksum around them.
// (Rules for all of these headers: pal.h.)
#ifndef PAL_SERIAL_H
#define PAL_SERIAL_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalSerial { uint8_t id; } PalSerial;

// Opens a line by the name that the platform has for it ("/dev/ttyUSB0", "Serial1").  What was received before is dropped.
// SM_E_MISSING: no such line.  SM_E_DENIED: not permitted.  SM_E_BUSY: it is open already.  SM_E_ARGUMENT: the line cannot
// do that many bits a second, or the name is as long as PAL_NAME.  SM_E_UNSUPPORTED: what has that name is no line.  SM_E_FULL.
SmResult pal_serial_open(PalSerial *line, const char *name, uint32_t bits_per_second);

// Hands over n bytes.  SM_OK: all are on their way, in the platform's buffer or the wire.  SM_E_TIMEOUT: the buffer was full;
// the first *sent bytes are on their way.  SM_E_CLOSED: the line is gone (an unplugged adapter).  *sent is filled in whatever
// the result.
SmResult pal_serial_send(PalSerial line, const void *bytes, size_t n, size_t *sent, uint64_t timeout);

// Fills `bytes` with what has arrived, 1 to `room` bytes, as soon as there is any; *n says how many.  room: 1 or more.
// SM_E_TIMEOUT: nothing came.  SM_E_CLOSED: the line is gone.  Bytes that nobody fetches in time are lost (a platform keeps at
// least 64).
SmResult pal_serial_receive(PalSerial line, void *bytes, size_t room, size_t *n, uint64_t timeout);

// Closes it; what is still on its way may be lost.
SmResult pal_serial_close(PalSerial line);

#ifdef __cplusplus
}
#endif
#endif
