// SPDX-License-Identifier: Apache-2.0
// Finds rolling windows of the machine and of the requirements that store the same runs of true samples, because their conditions are equal
// although they are written differently: max(a, b) > 60, and a > 60 or b > 60.  A model then has one window for both (prove_window.c).
//
// Only conditions are compared that no step changes.  Two conditions are equal if the facts of a step with any values of all variables allow
// neither of them without the other.
#ifndef SMC_PROVE_EQUAL_H
#define SMC_PROVE_EQUAL_H

#include "compiler/ir/ir.h"
#include "compiler/sema/requirements.h"

// Returns, by window of the requirements, the window of the machine that stores the same run; IR_NONE: none is known.
const uint32_t *prove_find_equal_windows(Arena *arena, const IrMachine *m, const Requirements *all);

#endif
