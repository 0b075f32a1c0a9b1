// SPDX-License-Identifier: Apache-2.0
// Random machines whose guards are windows of conditions, and requirements with windows of the same conditions in another form, or of almost the same
// ones (compiler/prove/prove_equal.h).  They have a parameter, and inputs with @range.
#ifndef TESTS_PROVE_HELD_TEXT_H
#define TESTS_PROVE_HELD_TEXT_H

#include "compiler/base/buf.h"
#include "tests/diff/gen.h"

typedef struct Held { uint32_t family; const char *time; } Held;      // the condition that leaves state One, and for how long it has to be true

Held held_print_machine(Rng *rng, Buf *out);
void held_print_requirement(Rng *rng, const Held *of, Buf *out);

#endif
