// SPDX-License-Identifier: Apache-2.0
// The square root of root.c and root_integers.c, on the bits of a binary64.
#include <stdint.h>

uint64_t root_by_integers(uint64_t x);       // where the processor has no instruction for it
