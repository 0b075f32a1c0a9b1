// SPDX-License-Identifier: Apache-2.0
// Hints about a number with a unit, as in T > 5 s. Removing the unit would change the value, so the hint contains the number to write.
#ifndef SMC_HINT_UNIT_H
#define SMC_HINT_UNIT_H

#include "compiler/diag/diag.h"

// Labels d with what to write instead of a number literal and the unit after it.
void hint_label_unit(Diags *diags, Diag *d, const char *number, const char *unit);
bool hint_is_time_unit(const char *unit);
// Converts a time to milliseconds, as a decimal literal; returns NULL if `unit` is not a unit of time or the result is too long to read.
const char *hint_to_milliseconds(Arena *arena, const char *number, const char *unit);

#endif
