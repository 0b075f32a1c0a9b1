// SPDX-License-Identifier: Apache-2.0
#include "compiler/device/sign.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "stdlib/crc32.h"

// Fails to compile if SIGN_ROOM does not have room for a section table entry and the section.
typedef char sign_room_is_an_entry_and_auth[SIGN_ROOM == SMVM_SECTION_ENTRY + SMVM_AUTH ? 1 : -1];

static void store_little_endian(uint8_t *at, uint32_t value, unsigned bytes)
{
    for (; bytes > 0; bytes--, value >>= 8)
        *at++ = (uint8_t)value;
}

// Copies the image with room for the section AUTH at its end, and appends an entry for AUTH to its section table.  Returns the new length; 0 if
// the table or the image would be too long.
static uint32_t add_auth_section(const uint8_t *image, uint32_t length, uint8_t *out)
{
    const uint8_t n = smvm_section_count(image);
    const uint32_t table_end = SMVM_HEADER + (uint32_t)n * SMVM_SECTION_ENTRY, longer = length + SIGN_ROOM;
    uint8_t *const entry = out + table_end;

    if (n == UINT8_MAX || longer > 0xffffffu)
        return 0;
    memcpy(out, image, table_end);
    memcpy(entry + SMVM_SECTION_ENTRY, image + table_end, length - table_end);
    for (uint8_t i = 0; i < n; i++) {
        SmvmSection s;
        smvm_read_section(image, i, &s);
        store_little_endian(out + SMVM_HEADER + i * SMVM_SECTION_ENTRY + 2, s.at + SMVM_SECTION_ENTRY, 3);
    }
    entry[0] = SMVM_S_AUTH;
    entry[1] = SMVM_V_AUTH;
    store_little_endian(entry + 2, longer - SMVM_AUTH, 3);
    store_little_endian(entry + 5, SMVM_AUTH, 3);
    out[SMVM_SECTIONS_AT]++;
    store_little_endian(out + SMVM_LENGTH_AT, longer, 3);
    return longer;
}

// Returns the CRC of an image, which leaves out the bytes of the CRC itself.
static uint32_t image_crc(const uint8_t *image, uint32_t length)
{
    uint32_t crc = SM_CRC32_START;

    for (uint32_t i = 0; i < length; i++)
        if (i < SMVM_CRC_AT || i >= SMVM_CRC_AT + 4)
            crc = sm_crc32_byte(crc, image[i]);
    return sm_crc32_end(crc);
}

uint32_t image_sign(const uint8_t *image, uint32_t length, const uint8_t *key, uint32_t number, uint8_t *out)
{
    SmvmAuth old;

    if (smvm_auth_read(image, &old))
        memcpy(out, image, length);
    else if ((length = add_auth_section(image, length, out)) == 0)
        return 0;
    store_little_endian(out + length - SMVM_AUTH, number, 4);
    store_little_endian(out + length - SMVM_AUTH + 4, smvm_auth_mark(key), 4);
    smvm_auth_code(out, length - SMVM_CODE, key, out + length - SMVM_CODE);
    store_little_endian(out + SMVM_CRC_AT, image_crc(out, length), 4);
    return length;
}
