// SPDX-License-Identifier: Apache-2.0
// Who made an image: the code in its section AUTH, which only who has the key can make, and a number that grows from image to image.
// The code is Chaskey-12 (ISO/IEC 29192-6), with 16 bytes of key and of code.  It proves the key and nothing else: who can read the
// key out of one board can make images for all that have it.
//
//     AUTH: u32 number, u32 mark of the key, then 16 bytes of code, with which the image ends.  The code is made of all bytes before it,
//     those of the CRC taken as 0.
//
// The mark tells keys apart without telling them: a host sees by it, before it sends anything, that a board has another key.
#ifndef SMVM_AUTH_H
#define SMVM_AUTH_H

#include "bytecode-vm/smvm.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { SMVM_KEY = 16, SMVM_CODE = 16, SMVM_AUTH = 8 + SMVM_CODE };     // bytes

// What an image that the verifier accepts says of its code.  False: it has none.
typedef struct SmvmAuth { uint32_t number, mark; } SmvmAuth;
bool smvm_auth_read(SmvmBytes image, SmvmAuth *auth);

// The mark of a key: the first four bytes of its code over no bytes at all.
uint32_t smvm_auth_mark(const uint8_t *key);

// Whether an image's code was made with this key, and its number.  Takes the same time wherever a code is wrong.
bool smvm_auth_check(SmvmBytes image, const uint8_t *key, uint32_t *number);

// The code of an image whose last SMVM_CODE bytes are left for it: `length` is that of all before them.
void smvm_auth_code(SmvmBytes image, uint32_t length, const uint8_t *key, uint8_t *code);

// Chaskey-12 over bytes as they come.
typedef struct SmvmMac {
    uint32_t v[4];
    uint8_t n;                // bytes of the last block that are in v
} SmvmMac;

void smvm_mac_begin(SmvmMac *m, const uint8_t *key);
void smvm_mac_byte(SmvmMac *m, uint8_t byte);
void smvm_mac_end(SmvmMac *m, const uint8_t *key, uint8_t *code);

#ifdef __cplusplus
}
#endif
#endif
