// SPDX-License-Identifier: Apache-2.0
// Converts number literals to F64, exactly and without the C library, whose conversion depends on the locale.
#ifndef SMC_NUMBER_H
#define SMC_NUMBER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "stdlib/f64.h"

// Computes the F64 nearest to a well-formed literal, which can contain `_` (language.md 1.12 to 1.15, 1.17); ties round to even. Returns
// false if the literal is too large. Too small a literal produces a subnormal number or 0.
bool number_to_f64(const char *text, size_t len, SmF64 *value);

// Computes the F64 nearest to a decimal literal times factor * 10^exponent: the exact product is rounded once. factor: 1 to 99. Returns
// false if the result is too large.
bool number_to_scaled_f64(const char *text, size_t len, unsigned factor, int exponent, SmF64 *value);

// Splits a literal exactly into digits * 10^exponent, where digits has no trailing zeros. Returns false if it has more than 18 digits.
bool number_to_decimal(const char *text, size_t len, uint64_t *digits, int *exponent);

#endif
