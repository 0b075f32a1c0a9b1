// SPDX-License-Identifier: Apache-2.0
// A number with a unit: T > 5 s. Removing the unit would change the value, so the hint contains the number to write.
#ifndef SMC_HINT_UNIT_H
#define SMC_HINT_UNIT_H

#include "compiler/diag/diag.h"

// `number` is a number literal as written, `unit` the word after it.
void hint_label_unit(Diags *diags, Diag *d, const char *number, const char *unit);
bool hint_is_time_unit(const char *unit);
// The number in milliseconds; NULL if `unit` is not a unit of time or the result is too long to read.
const char *hint_to_milliseconds(Arena *arena, const char *number, const char *unit);

#endif
