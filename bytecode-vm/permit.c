// SPDX-License-Identifier: Apache-2.0
// Implements permit.h.  As in auth.c, no branch depends on a bit of the key or of a code.
#include "bytecode-vm/permit.h"

#include "bytecode-vm/image.h"

enum { LENGTH_AT = 2 };                // offset of the image's length in the body of BEGIN

// Returns a little-endian number of up to 4 bytes.
static uint32_t load_number(const uint8_t *at, uint8_t bytes)
{
    uint32_t number = 0;

    while (bytes-- > 0)
        number = number << 8 | at[bytes];
    return number;
}

// Adds the low `bytes` bytes of a number to the authentication code, low byte first.
static void add_number(SmvmMac *m, uint32_t number, uint8_t bytes)
{
    for (; bytes > 0; bytes--, number >>= 8)
        smvm_mac_byte(m, (uint8_t)number);
}

void smvm_permit_code(uint32_t number, uint32_t length, const uint8_t *key, uint8_t *code)
{
    SmvmMac m;

    smvm_mac_begin(&m, key);
    add_number(&m, number, 4);
    add_number(&m, length, 3);
    smvm_mac_end(&m, key, code);
}

void smvm_confirm_code(uint32_t number, uint32_t checksum, const uint8_t *key, uint8_t *code)
{
    SmvmMac m;

    smvm_mac_begin(&m, key);
    smvm_mac_byte(&m, 'C');
    add_number(&m, number, 4);
    add_number(&m, checksum, 4);
    smvm_mac_end(&m, key, code);
}

// Copies the permit of an image that the verifier accepts.  Returns false if the image has no permit.
bool smvm_permit_read(SmvmBytes image, uint8_t *permit)
{
    SmvmReader r, auth;
    SmvmAuth a;

    if (!smvm_auth_read(image, &a) || !smvm_find_section(image, SMVM_S_AUTH, &auth) || !smvm_find_section(image, SMVM_S_PERMIT, &r))
        return false;
    if (r.end != auth.at || (SmvmAt)(r.end - r.at) != SMVM_CODE)
        return false;
    for (uint8_t i = 0; i < SMVM_PERMIT; i++)
        permit[i] = i < 4 ? (uint8_t)(a.number >> 8 * i) : smvm_u8(image, (SmvmAt)(r.at + i - 4));
    return true;
}

// Whether the body of a BEGIN, of n bytes and at least SMVM_PERMIT_AT, permits to stop the image that runs: SM_OK, or SM_E_UNSIGNED.
SmResult smvm_permit_check(const uint8_t *begin, uint8_t n, uint32_t newest, const uint8_t *key)
{
    const uint8_t *permit = begin + SMVM_PERMIT_AT;
    uint8_t code[SMVM_CODE], differs = 0;

    if (n < SMVM_PERMIT_AT + SMVM_PERMIT)
        return SM_E_UNSIGNED;
    smvm_permit_code(load_number(permit, 4), load_number(begin + LENGTH_AT, 3), key, code);
    for (uint8_t i = 0; i < SMVM_CODE; i++)
        differs |= (uint8_t)(code[i] ^ permit[4 + i]);
    return differs != 0 ? SM_E_UNSIGNED : load_number(permit, 4) <= newest ? SM_E_REPLAY : SM_OK;
}
