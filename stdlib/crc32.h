// SPDX-License-Identifier: Apache-2.0
// CRC-32 as IEEE 802.3 has it (reflected 0xEDB88320, all ones in and out): "123456789" gives 0xCBF43926.
// Bit by bit, for it needs no table in a small chip's memory.
#ifndef SM_CRC32_H
#define SM_CRC32_H

#include <stddef.h>
#include <stdint.h>

// Byte by byte, for bytes that lie where no pointer reaches: start with SM_CRC32_START, end with sm_crc32_end.
#define SM_CRC32_START 0xFFFFFFFFu

static inline uint32_t sm_crc32_byte(uint32_t crc, uint8_t byte)
{
    unsigned i;
    crc ^= byte;
    for (i = 0; i < 8; i++)
        crc = crc >> 1 ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
    return crc;
}

static inline uint32_t sm_crc32_end(uint32_t crc) { return crc ^ 0xFFFFFFFFu; }

static inline uint32_t sm_crc32(const void *bytes, size_t n)
{
    const uint8_t *p = (const uint8_t *)bytes;
    uint32_t crc = SM_CRC32_START;
    while (n-- > 0)
        crc = sm_crc32_byte(crc, *p++);
    return sm_crc32_end(crc);
}

#endif
