// SPDX-License-Identifier: Apache-2.0
// UTF-8, one character at a time.
#ifndef SMC_UTF8_H
#define SMC_UTF8_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// The length in bytes (1 to 4) of the character at s, of which n bytes can be read, and its code point; 0 when they are not
// UTF-8: too short, too long a form, a surrogate, beyond U+10FFFF.
size_t utf8_decode(const char *s, size_t n, uint32_t *code);

// A character that would not be seen or would disturb the text around it on a screen: controls, invisible ones, those
// that turn the direction of writing.
bool utf8_is_hidden(uint32_t code);

#endif
