// SPDX-License-Identifier: Apache-2.0
// stdlib_roll.c as in emitted C: windows without a median compare samples as numbers, four at a time where the processor can, and windows of
// three samples are sorted when they are read.
#define SM_ROLL_BY_VALUE 1
#define SM_ROLL_LATE_ORDER 1
#define SM_ROLL_CONSTANT_SIZE 1
#if defined(__SSE2__) && defined(__GNUC__)
#define SM_ROLL_VECTORS 1
#endif
#include "tests/unit/stdlib_roll.c"
