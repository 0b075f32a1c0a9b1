// SPDX-License-Identifier: Apache-2.0
// Signs images: adds the sections PERMIT and AUTH (bytecode-vm/auth.h, permit.h).
#ifndef SMC_SIGN_H
#define SMC_SIGN_H

#include "bytecode-vm/permit.h"

// the most bytes by which an image grows: two section table entries of 8 bytes, and the sections
enum { SIGN_ROOM = 2 * 8 + SMVM_CODE + SMVM_AUTH };

// Numbers count seconds from the start of 2020: time increases on every computer that signs.  Higher numbers are refused, so that no mistake
// uses up those that a board can still accept.
#define SIGN_NUMBER_MOST 4000000000u
// Returns the number for a time in seconds since 1970; 0 if the time is outside the range, because the clock is wrong.
uint32_t sign_number_at(int64_t time);

// Signs an image that the verifier accepts.  An image that is already signed is signed again.  `out` must have room for `length` plus
// SIGN_ROOM bytes.  Returns the length of the signed image, or 0 if there is no room for the sections.
uint32_t image_sign(const uint8_t *image, uint32_t length, const uint8_t *key, uint32_t number, uint8_t *out);

#endif
