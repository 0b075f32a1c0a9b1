// SPDX-License-Identifier: Apache-2.0
// Brackets in expressions, which the lexer would read as the header of a section: x[i + 1], S in [A, B].
#ifndef SMC_HINT_LISTS_H
#define SMC_HINT_LISTS_H

#include "compiler/diag/diag.h"

// Reports brackets that are no header and that follow a name or the word `in` on their line. The [ is at `at`, and the ] ends at `end`. Returns
// false, and reports nothing, if something else is before them.
bool hint_report_brackets(Diags *diags, const Source *src, uint32_t at, uint32_t end);

#endif
