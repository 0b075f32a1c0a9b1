// SPDX-License-Identifier: Apache-2.0
// Signs images: adds the section AUTH (bytecode-vm/auth.h).
#ifndef SMC_SIGN_H
#define SMC_SIGN_H

#include "bytecode-vm/auth.h"

enum { SIGN_ROOM = 8 + SMVM_AUTH };       // the most bytes by which an image grows: a section table entry of 8 bytes, and the section

// Signs an image that the verifier accepts.  An image that is already signed is signed again.  `out` must have room for `length` plus
// SIGN_ROOM bytes.  Returns the length of the signed image, or 0 if there is no room for another section.
uint32_t image_sign(const uint8_t *image, uint32_t length, const uint8_t *key, uint32_t number, uint8_t *out);

#endif
