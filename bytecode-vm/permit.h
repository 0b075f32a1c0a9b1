// SPDX-License-Identifier: Apache-2.0
// Permits.  A board with one slot has to stop its image before it can receive another one, and can check the authentication code of the new
// image (auth.h) only after its last byte.  So a signed image also has a permit, which a host sends first: a code over the number and the length
// of the image.  Without a permit, no request stops the machine of a board that has a key.
//
//     PERMIT: 16 bytes, directly before AUTH: the code of seven bytes, the number of the image (u32) and its length (u24).  Every image is
//     longer than seven bytes, so the code of an image is never a permit.
#ifndef SMVM_PERMIT_H
#define SMVM_PERMIT_H

#include "bytecode-vm/auth.h"
#include "stdlib/result.h"

#ifdef __cplusplus
extern "C" {
#endif

// The form in which a host sends a permit: the number (u32) and the code, at the end of BEGIN (runtime-c/link/link.def).
enum { SMVM_PERMIT = 4 + SMVM_CODE, SMVM_PERMIT_AT = 9 };

void smvm_permit_code(uint32_t number, uint32_t length, const uint8_t *key, uint8_t *code);

// Copies the permit of an image that the verifier accepts.  Returns false if the image has no permit.
bool smvm_permit_read(SmvmBytes image, uint8_t *permit);

// Checks whether a request BEGIN permits to stop the image that runs.  `begin`: its body, of n bytes, at least SMVM_PERMIT_AT.  SM_E_UNSIGNED:
// it has no permit that `key` has signed for the length of the image that it announces.  SM_E_REPLAY: its number is not above `newest`.
SmResult smvm_permit_check(const uint8_t *begin, uint8_t n, uint32_t newest, const uint8_t *key);

// The code with which a host confirms the swap of an application (bytecode-vm/target/swap_link.h): over 9 bytes, 'C', the number of the swap and
// its checksum.  A swap has more than 9 bytes, so its code never confirms one.
void smvm_confirm_code(uint32_t number, uint32_t checksum, const uint8_t *key, uint8_t *code);

#ifdef __cplusplus
}
#endif
#endif
