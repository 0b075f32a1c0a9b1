// SPDX-License-Identifier: Apache-2.0
// The square root where the processor has none, which tests/unit/stdlib_sqrt.c compares with the definition of rounding.
#include "stdlib/f64.h"
#undef SM_SQRT_INSTRUCTION
#include "stdlib/math.h"
#include "tests/targets/root.h"

uint64_t root_by_integers(uint64_t x) { return sm_bits(sm_sqrt(sm_from_bits(x))); }
