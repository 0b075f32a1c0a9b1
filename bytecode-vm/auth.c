// SPDX-License-Identifier: Apache-2.0
// Implements auth.h.  No branch here depends on a bit of the key or of a code.
#include "bytecode-vm/auth.h"

#include <string.h>

#include "bytecode-vm/image.h"

enum { BLOCK = 16, ROUNDS = 12 };

// ---- Chaskey-12 ----

// Returns the address of byte i of the block in v.  The algorithm defines the words of v as little-endian, whatever this computer is.
static uint8_t *byte_of(uint32_t *v, uint8_t i)
{
    const uint16_t one = 1;
    uint8_t low;

    memcpy(&low, &one, 1);
    return (uint8_t *)v + (low ? i : i ^ 3);
}

// The algorithm rotates left by 5, 8, 13, 7 and 16 bits.  An 8-bit computer rotates by whole bytes most cheaply, so 5, 13 and 7 are
// composed of a rotation left by 8 or 16 bits and rotations right by one bit.
static uint32_t rotate_right_1(uint32_t x) { return x >> 1 | x << 31; }
static uint32_t rotate_left_8(uint32_t x) { return x << 8 | x >> 24; }
static uint32_t rotate_left_16(uint32_t x) { return x << 16 | x >> 16; }

// Applies the permutation of Chaskey, ROUNDS rounds, to v.
static void permute(uint32_t *v)
{
    for (uint8_t i = 0; i < ROUNDS; i++) {
        v[0] += v[1];
        v[1] = rotate_right_1(rotate_right_1(rotate_right_1(rotate_left_8(v[1])))) ^ v[0];
        v[0] = rotate_left_16(v[0]);
        v[2] += v[3];
        v[3] = rotate_left_8(v[3]) ^ v[2];
        v[0] += v[3];
        v[3] = rotate_right_1(rotate_right_1(rotate_right_1(rotate_left_16(v[3])))) ^ v[0];
        v[2] += v[1];
        v[1] = rotate_right_1(rotate_left_8(v[1])) ^ v[2];
        v[2] = rotate_left_16(v[2]);
    }
}

// Doubles the key as a polynomial over GF(2), modulo x^128 + x^7 + x^2 + x + 1.
static void double_key(uint8_t *key)
{
    const uint8_t out = (uint8_t)(0u - (key[BLOCK - 1] >> 7));

    for (uint8_t i = BLOCK - 1; i > 0; i--)
        key[i] = (uint8_t)(key[i] << 1 | key[i - 1] >> 7);
    key[0] = (uint8_t)(key[0] << 1 ^ (out & 0x87));
}

// Combines the state v with a block of bytes by exclusive or.
static void xor_block(uint32_t *v, const uint8_t *bytes)
{
    for (uint8_t i = 0; i < BLOCK; i++)
        *byte_of(v, i) ^= bytes[i];
}

void smvm_mac_begin(SmvmMac *m, const uint8_t *key)
{
    memset(m, 0, sizeof *m);
    xor_block(m->v, key);
}

void smvm_mac_byte(SmvmMac *m, uint8_t byte)
{
    if (m->n == BLOCK) {               // another byte follows, so the full block is not the last one
        permute(m->v);
        m->n = 0;
    }
    *byte_of(m->v, m->n++) ^= byte;
}

void smvm_mac_end(SmvmMac *m, const uint8_t *key, uint8_t *code)
{
    uint8_t last[BLOCK];

    memcpy(last, key, BLOCK);
    double_key(last);
    if (m->n < BLOCK) {
        double_key(last);
        *byte_of(m->v, m->n) ^= 1;
    }
    xor_block(m->v, last);
    permute(m->v);
    xor_block(m->v, last);
    for (uint8_t i = 0; i < BLOCK; i++)
        code[i] = *byte_of(m->v, i);
}

// ---- images ----

// Computes the authentication code of an image whose last SMVM_CODE bytes are reserved for the code.  `length` is the number of bytes before them.
void smvm_auth_code(SmvmBytes image, uint32_t length, const uint8_t *key, uint8_t *code)
{
    SmvmMac m;

    smvm_mac_begin(&m, key);
    for (SmvmAt i = 0; i < length; i++)
        smvm_mac_byte(&m, (uint32_t)i - SMVM_CRC_AT < 4u ? 0 : smvm_u8(image, i));
    smvm_mac_end(&m, key, code);
}

// Returns the offset of the AUTH section; 0 if the image does not end with one.
static SmvmAt find_auth_section(SmvmBytes image)
{
    for (uint8_t i = 0; i < smvm_section_count(image); i++) {
        SmvmSection s;
        smvm_read_section(image, i, &s);
        if (s.kind.id == SMVM_S_AUTH && s.size == SMVM_AUTH && s.at + s.size == smvm_u24(image, SMVM_LENGTH_AT))
            return (SmvmAt)s.at;
    }
    return 0;
}

// Reads the number and the mark in the AUTH section of an image.  Returns false, and both are 0, if the image has no AUTH section.
bool smvm_auth_read(SmvmBytes image, SmvmAuth *auth)
{
    const SmvmAt at = find_auth_section(image);

    auth->number = at ? smvm_uint(image, at, 4) : 0;
    auth->mark = at ? smvm_uint(image, (SmvmAt)(at + 4), 4) : 0;
    return at != 0;
}

// Returns the mark of a key: the first four bytes of the authentication code of no bytes, computed with this key.
uint32_t smvm_auth_mark(const uint8_t *key)
{
    uint8_t code[SMVM_CODE];
    SmvmMac m;

    smvm_mac_begin(&m, key);
    smvm_mac_end(&m, key, code);
    return (uint32_t)code[3] << 24 | (uint32_t)code[2] << 16 | (uint32_t)code[1] << 8 | code[0];
}

// Checks an image's authentication code with this key. If the image has an AUTH section, sets *number to its number. Returns whether the code
// is correct.
bool smvm_auth_check(SmvmBytes image, const uint8_t *key, uint32_t *number)
{
    const SmvmAt at = find_auth_section(image), end = (SmvmAt)(at + SMVM_AUTH - SMVM_CODE);
    uint8_t code[SMVM_CODE], differs = 0;

    if (at == 0)
        return false;
    smvm_auth_code(image, end, key, code);
    for (uint8_t i = 0; i < SMVM_CODE; i++)
        differs |= (uint8_t)(code[i] ^ smvm_u8(image, (SmvmAt)(end + i)));
    *number = smvm_uint(image, at, 4);
    return differs == 0;
}
