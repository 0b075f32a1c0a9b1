// SPDX-License-Identifier: Apache-2.0
// Internal to the log: the description that begins each session.
#ifndef SM_LOG_DESCRIBE_H
#define SM_LOG_DESCRIBE_H

#include "runtime-c/log.h"

// Size of the whole block in bytes, including its head and checksum.
uint32_t sm_log_description_size(const SmLog *log);

// Fills `out` with up to `room` bytes of a block of `size` bytes, from byte `from` on, and returns the number of bytes.
uint32_t sm_log_describe(const SmLog *log, uint32_t size, uint32_t from, uint8_t *out, uint32_t room);

// Returns the CRC of the session's identity, not finalised.  The CRCs of the session's other blocks continue from it.
uint32_t sm_log_identity_crc(const SmLog *log);

#endif
