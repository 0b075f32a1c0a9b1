// SPDX-License-Identifier: Apache-2.0
// Inside of the log: the description with which a session begins.
#ifndef SM_LOG_DESCRIBE_H
#define SM_LOG_DESCRIBE_H

#include "runtime-c/log.h"

// Bytes of the whole block, its mark and checksum with it.
uint32_t sm_log_description_size(const SmLog *log);

// Fills in up to `room` of the bytes of a block of `size` bytes, from byte `from` on; gives how many.
uint32_t sm_log_describe(const SmLog *log, uint32_t size, uint32_t from, uint8_t *out, uint32_t room);

// The CRC, not ended, of the session's identity, from which the CRCs of its other blocks go on.
uint32_t sm_log_identity(const SmLog *log);

#endif
