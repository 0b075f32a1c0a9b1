// SPDX-License-Identifier: Apache-2.0
// UTF-8, one character at a time.
#ifndef SMC_UTF8_H
#define SMC_UTF8_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Decodes the character at s, where n bytes can be read.  Returns its length in bytes (1 to 4) and stores its code point.  Returns 0 if
// it is not UTF-8: truncated, an overlong form, a surrogate, or above U+10FFFF.
size_t utf8_decode(const char *s, size_t n, uint32_t *code);

// Whether a character is invisible or can disturb the text around it on a screen: control characters, invisible characters, and those
// that change the writing direction.
bool utf8_is_hidden(uint32_t code);

#endif
