// SPDX-License-Identifier: Apache-2.0
// Authenticates the author of an image.  The section AUTH has a code that only an owner of the key can compute, and a number that
// grows from image to image.  The code is Chaskey-12 (ISO/IEC 29192-6), with a key and a code of 16 bytes each.  It proves possession of
// the key and nothing else: an attacker who reads the key from one board can create images for all boards with that key.
//
//     AUTH: u32 number, u32 mark of the key, then 16 bytes of code, which end the image.  The code covers all bytes before it; the
//     bytes of the CRC count as 0.
//
// The mark identifies a key without revealing it: a host can see that a board has another key before it sends an image.
#ifndef SMVM_AUTH_H
#define SMVM_AUTH_H

#include "bytecode-vm/smvm.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { SMVM_KEY = 16, SMVM_CODE = 16, SMVM_AUTH = 8 + SMVM_CODE };     // bytes of a key, a code, and the AUTH section

// Reads the number and the mark in the AUTH section of an image that the verifier accepts. Returns false if the image has no AUTH section.
typedef struct SmvmAuth { uint32_t number, mark; } SmvmAuth;
bool smvm_auth_read(SmvmBytes image, SmvmAuth *auth);

// Returns the mark of a key: the first four bytes of the authentication code of no bytes, computed with this key.
uint32_t smvm_auth_mark(const uint8_t *key);

// Checks an image's authentication code with this key.  If the image has an AUTH section, sets *number to its number.  Returns whether the code is
// correct.  The time does not depend on which bytes of a code are wrong.
bool smvm_auth_check(SmvmBytes image, const uint8_t *key, uint32_t *number);

// Computes the authentication code of an image whose last SMVM_CODE bytes are reserved for the code.  `length` is the number of bytes before them.
void smvm_auth_code(SmvmBytes image, uint32_t length, const uint8_t *key, uint8_t *code);

// Chaskey-12 over a stream of bytes.
typedef struct SmvmMac {
    uint32_t v[4];            // the state of the algorithm
    uint8_t n;                // how many bytes of the current block are added to v
} SmvmMac;

void smvm_mac_begin(SmvmMac *m, const uint8_t *key);
void smvm_mac_byte(SmvmMac *m, uint8_t byte);
void smvm_mac_end(SmvmMac *m, const uint8_t *key, uint8_t *code);

#ifdef __cplusplus
}
#endif
#endif
