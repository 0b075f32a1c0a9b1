// SPDX-License-Identifier: Apache-2.0
// Number literals to F64, exactly and without the C library, whose reading depends on the locale.
#ifndef SMC_NUMBER_H
#define SMC_NUMBER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "stdlib/f64.h"

// The F64 nearest to a well-formed literal (language.md 1.12 to 1.15, `_` included), of two equally near ones the even one.
// False when it is too large; what is too small gives a subnormal number or 0.
bool number_value(const char *text, size_t len, SmF64 *value);

// The literal as it is written: digits * 10^exponent, digits without zeros at their end.  False when it has more digits than 18.
bool number_decimal(const char *text, size_t len, uint64_t *digits, int *exponent);

#endif
