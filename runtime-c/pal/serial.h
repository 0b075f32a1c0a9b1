// SPDX-License-Identifier: Apache-2.0
// Serial lines: bytes in both directions, 8 data bits, no parity, 1 stop bit, no flow control.  The platform passes every byte
// unchanged.  One thread may send while another receives.  Bytes can be lost or corrupted in transit, so a sender must add a
// checksum.  (Rules for all of these headers: pal.h.)
#ifndef PAL_SERIAL_H
#define PAL_SERIAL_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalSerial { uint8_t id; } PalSerial;

// Opens a line by its platform-specific name ("/dev/ttyUSB0", "Serial1").  Discards bytes received earlier.
//     SM_E_MISSING       no such line
//     SM_E_DENIED        no permission
//     SM_E_BUSY          it is already open
//     SM_E_ARGUMENT      the line does not support this bit rate, or the name is not shorter than PAL_NAME
//     SM_E_UNSUPPORTED   the name is not a serial line
//     SM_E_FULL          the table has no free entry
SmResult pal_serial_open(PalSerial *line, const char *name, uint32_t bits_per_second);

// Sends n bytes.  SM_OK: all bytes have been sent or are in the platform's buffer.  SM_E_TIMEOUT: the buffer was full, and only the
// first *sent bytes were accepted.  SM_E_CLOSED: the line no longer exists (an unplugged adapter). *sent is always filled in,
// whatever the result.
SmResult pal_serial_send(PalSerial line, const void *bytes, size_t n, size_t *sent, uint64_t timeout);

// Receives 1 to `room` bytes, as soon as any are available, and stores their count in *n.  `room` must be 1 or more.  SM_E_TIMEOUT:
// no byte arrived.  SM_E_CLOSED: the line no longer exists.  The platform buffers at least 64 received bytes; further bytes are
// lost until the program reads them.
SmResult pal_serial_receive(PalSerial line, void *bytes, size_t room, size_t *n, uint64_t timeout);

// Closes the line.  Bytes that are not yet transmitted may be lost.
SmResult pal_serial_close(PalSerial line);

#ifdef __cplusplus
}
#endif
#endif
