// SPDX-License-Identifier: Apache-2.0
// CRC-32 as in IEEE 802.3 (reflected 0xEDB88320, initial value and final XOR all ones); for "123456789" it is 0xCBF43926.
// It is computed four bits at a time; bit by bit on AVR, where the table for four bits would take RAM.
#ifndef SM_CRC32_H
#define SM_CRC32_H

#include <stddef.h>
#include <stdint.h>

// To compute a CRC byte by byte, for bytes that a pointer cannot address: start with SM_CRC32_START, call sm_crc32_byte for each byte, and
// sm_crc32_end at the end.
#define SM_CRC32_START 0xFFFFFFFFu

#ifdef __AVR__
__attribute__((noinline, unused)) static uint32_t sm_crc32_byte(uint32_t crc, uint8_t byte)
{
    uint8_t i;
    crc ^= byte;
    for (i = 0; i < 8; i++) {
        const uint8_t odd = (uint8_t)crc & 1u;
        crc >>= 1;
        if (odd)
            crc ^= 0xEDB88320u;
    }
    return crc;
}
#else
static inline uint32_t sm_crc32_byte(uint32_t crc, uint8_t byte)
{
    static const uint32_t step[16] = {                // the value to XOR, indexed by the four bits that are shifted out
        0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu, 0x76DC4190u, 0x6B6B51F4u, 0x4DB26158u, 0x5005713Cu,
        0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu, 0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu,
    };
    crc ^= byte;
    crc = crc >> 4 ^ step[crc & 15u];
    return crc >> 4 ^ step[crc & 15u];
}
#endif

// The residue: the CRC of any bytes followed by their own CRC, least significant byte first.
#define SM_CRC32_RESIDUE 0x2144DF1Cu

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
