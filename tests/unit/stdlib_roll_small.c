// SPDX-License-Identifier: Apache-2.0
// stdlib_roll.c where memory matters more than time: no sums and extremes of blocks are stored, and the samples of a median are one sorted
// array.
#define SM_ROLL_SMALL 1
#include "tests/unit/stdlib_roll.c"
