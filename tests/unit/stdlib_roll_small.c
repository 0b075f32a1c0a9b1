// SPDX-License-Identifier: Apache-2.0
// stdlib_roll.c where memory matters more than time: no sums and extremes of parts are kept, and a median's samples are one row.
#define SM_ROLL_SMALL 1
#include "tests/unit/stdlib_roll.c"
