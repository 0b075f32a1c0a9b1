// SPDX-License-Identifier: Apache-2.0
// Random machines whose variables are maxima, minima and sums of each other, for proofs that rest on differences of variables.
#ifndef SM_PROVE_RELATED_TEXT_H
#define SM_PROVE_RELATED_TEXT_H

#include "compiler/base/buf.h"
#include "tests/diff/gen.h"

// What the last statement of a step makes true of two variables in most states.
typedef struct Related { const char *x, *y, *by; uint32_t kind; } Related;

Related related_print_machine(Rng *rng, Buf *out);
void related_print_requirement(Rng *rng, const Related *of, Buf *out);

#endif
