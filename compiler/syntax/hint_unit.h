// SPDX-License-Identifier: Apache-2.0
// Hints about a number with a unit, as in T > 5 s. Removing the unit would change the value, so the hint contains the number to write.
#ifndef SMC_HINT_UNIT_H
#define SMC_HINT_UNIT_H

#include "compiler/diag/diag.h"

// Labels d with what to write instead of the literal `number` followed by `unit`.
void hint_label_unit(Diags *diags, Diag *d, const char *number, const char *unit);
bool hint_is_time_unit(const char *unit);
// Converts the time `number` `unit` to a literal in milliseconds; returns NULL if `unit` is not a unit of time or the literal is too long.
const char *hint_to_milliseconds(Arena *arena, const char *number, const char *unit);

#endif
