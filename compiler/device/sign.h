// SPDX-License-Identifier: Apache-2.0
// Signs images: puts section AUTH into them (bytecode-vm/auth.h).
#ifndef SMC_SIGN_H
#define SMC_SIGN_H

#include "bytecode-vm/auth.h"

enum { SIGN_ROOM = 8 + SMVM_AUTH };       // bytes by which an image grows at most

// Of an image that the verifier accepts makes a signed one; one that is signed already is signed anew.  `out` has room for SIGN_ROOM
// bytes more than the image has.  Gives the length; 0: there is no room for another section.
uint32_t image_sign(const uint8_t *image, uint32_t length, const uint8_t *key, uint32_t number, uint8_t *out);

#endif
