// SPDX-License-Identifier: Apache-2.0
#include "compiler/device/sign.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "stdlib/crc32.h"

// Fails to compile if SIGN_ROOM does not have room for two section table entries and the sections.
typedef char sign_room_is_two_sections[SIGN_ROOM == 2 * SMVM_SECTION_ENTRY + SMVM_CODE + SMVM_AUTH ? 1 : -1];

static void store_little_endian(uint8_t *at, uint32_t value, unsigned bytes)
{
    for (; bytes > 0; bytes--, value >>= 8)
        *at++ = (uint8_t)value;
}

// Writes an entry of the section table.
static void write_section_entry(uint8_t *entry, uint8_t id, uint8_t version, uint32_t at, uint32_t size)
{
    entry[0] = id;
    entry[1] = version;
    store_little_endian(entry + 2, at, 3);
    store_little_endian(entry + 5, size, 3);
}

// What an image has without its signature: the number of its sections, and where the last of them ends.
typedef struct Content { uint32_t sections, end; } Content;

// Finds the content of an image without its signature: the number of its other sections, and the offset of their end.
static Content find_content(const uint8_t *image, uint32_t length)
{
    Content c = {smvm_section_count(image), length};
    uint8_t permit[SMVM_PERMIT];
    SmvmAuth auth;

    if (smvm_auth_read(image, &auth)) {
        c.sections--;
        c.end -= SMVM_AUTH;
        if (smvm_permit_read(image, permit)) {
            c.sections--;
            c.end -= SMVM_CODE;
        }
    }
    return c;
}

// Copies the content of the image, with room for the sections PERMIT and AUTH at its end and entries for them in its section table.  Returns
// the new length; 0 if the table or the image would be too long.
static uint32_t add_sections(const uint8_t *image, uint32_t length, uint8_t *out)
{
    const Content c = find_content(image, length);
    const uint32_t old_data = SMVM_HEADER + (uint32_t)smvm_section_count(image) * SMVM_SECTION_ENTRY,
        table_end = SMVM_HEADER + c.sections * SMVM_SECTION_ENTRY;
    const uint32_t data = table_end + 2 * SMVM_SECTION_ENTRY, end = data + (c.end - old_data);
    uint8_t *const entry = out + table_end;

    if (c.sections + 2 > UINT8_MAX || end + SMVM_CODE + SMVM_AUTH > 0xffffffu)
        return 0;
    memcpy(out, image, table_end);
    memcpy(out + data, image + old_data, c.end - old_data);
    for (uint8_t i = 0; i < c.sections; i++) {
        SmvmSection s;
        smvm_read_section(image, i, &s);
        store_little_endian(out + SMVM_HEADER + i * SMVM_SECTION_ENTRY + 2, s.at + data - old_data, 3);
    }
    write_section_entry(entry, SMVM_S_PERMIT, SMVM_V_PERMIT, end, SMVM_CODE);
    write_section_entry(entry + SMVM_SECTION_ENTRY, SMVM_S_AUTH, SMVM_V_AUTH, end + SMVM_CODE, SMVM_AUTH);
    out[SMVM_SECTIONS_AT] = (uint8_t)(c.sections + 2);
    length = end + SMVM_CODE + SMVM_AUTH;
    store_little_endian(out + SMVM_LENGTH_AT, length, 3);
    return length;
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

// Signs an image that the verifier accepts.  `out` must have room for `length` plus SIGN_ROOM bytes.  Returns the length of the signed
// image.
uint32_t image_sign(const uint8_t *image, uint32_t length, const uint8_t *key, uint32_t number, uint8_t *out)
{
    if ((length = add_sections(image, length, out)) == 0)
        return 0;
    smvm_permit_code(number, length, key, out + length - SMVM_AUTH - SMVM_CODE);
    store_little_endian(out + length - SMVM_AUTH, number, 4);
    store_little_endian(out + length - SMVM_AUTH + 4, smvm_auth_mark(key), 4);
    smvm_auth_code(out, length - SMVM_CODE, key, out + length - SMVM_CODE);
    store_little_endian(out + SMVM_CRC_AT, image_crc(out, length), 4);
    return length;
}

// Returns the number that a signed image or swap gets at a time in seconds since 1970: the seconds since 2020.  Returns 0 if the time is outside the
// range, because the clock is wrong.
uint32_t sign_number_at(int64_t time)
{
    const int64_t start_of_2020 = 1577836800, number = time - start_of_2020;

    return number >= 1 && number <= SIGN_NUMBER_MOST ? (uint32_t)number : 0;
}
