// SPDX-License-Identifier: Apache-2.0
// The format of the log, for writers and readers; docs/log.md explains it.  Numbers are little-endian.
//
// A block is a mark, its kind, the length of its payload, the payload, and a CRC-32 of all of these.  For all kinds except the
// description, the CRC starts from the CRC-32 of the session's identity.  A block of another session or layout is therefore never
// accepted.
#ifndef SM_LOG_BLOCK_H
#define SM_LOG_BLOCK_H

#include <stdint.h>

#include "stdlib/crc32.h"

enum {
    LOG_VERSION = 1,
    LOG_MARK = 0xA5,
    LOG_HEAD = 6,             // mark, kind, four bytes of length
    LOG_CHECK = 4,            // bytes of the CRC at the end of a block
    LOG_IDENTITY = 13,        // the first bytes of a description: version, its position in the file (8), layout hash (4)
    LOG_EVENT = 19,           // time (8), kind, source (2), a (4), b (4)
    LOG_DROPPED = 8,          // payload of a gap: records dropped (4), events lost (4)
    LOG_NAMES_HEAD = 10       // the first bytes of names: number of the machine (2), checksum of its image (4), number of states (4)
};

typedef enum LogKind { LOG_DESCRIPTION = 'D', LOG_RECORD = 'R', LOG_EVENTS = 'E', LOG_GAP = 'G', LOG_NAMES = 'N' } LogKind;

static inline void log_put16(uint8_t *to, uint16_t x)
{
    to[0] = (uint8_t)x;
    to[1] = (uint8_t)(x >> 8);
}

static inline void log_put32(uint8_t *to, uint32_t x)
{
    log_put16(to, (uint16_t)x);
    log_put16(to + 2, (uint16_t)(x >> 16));
}

static inline void log_put64(uint8_t *to, uint64_t x)
{
    log_put32(to, (uint32_t)x);
    log_put32(to + 4, (uint32_t)(x >> 32));
}

static inline uint16_t log_get16(const uint8_t *from)
{
    return (uint16_t)(from[0] | (unsigned)from[1] << 8);
}

static inline uint32_t log_get32(const uint8_t *from)
{
    return log_get16(from) | (uint32_t)log_get16(from + 2) << 16;
}

static inline uint64_t log_get64(const uint8_t *from)
{
    return log_get32(from) | (uint64_t)log_get32(from + 4) << 32;
}

// Continues the CRC `crc` over n bytes.  `crc` is SM_CRC32_START or a CRC that has not been finalised.
static inline uint32_t log_crc_update(uint32_t crc, const uint8_t *bytes, uint32_t n)
{
    while (n-- > 0)
        crc = sm_crc32_byte(crc, *bytes++);
    return crc;
}

static inline void log_put_head(uint8_t *to, LogKind kind, uint32_t length)
{
    to[0] = LOG_MARK;
    to[1] = (uint8_t)kind;
    log_put32(to + 2, length);
}

#endif
