// SPDX-License-Identifier: Apache-2.0
// Hints about a number with a unit that cannot follow it: `5s`, `5 seconds`, `5 bar`.
#ifndef SMC_HINT_UNIT_H
#define SMC_HINT_UNIT_H

#include "compiler/diag/diag.h"

// Labels d with what to write instead of the literal `number` followed by `unit`, which together are at `whole`.
void hint_label_unit(Diags *diags, Diag *d, const char *number, const char *unit, Span whole);

#endif
