// SPDX-License-Identifier: Apache-2.0
// stdlib_roll.c as on processors that compare integers faster than numbers: all windows that compare samples store them as ordered integers.
// Three samples are put in order when they are read, as in emitted C.
#define SM_ROLL_BY_VALUE 0
#define SM_ROLL_LATE_ORDER 1
#include "tests/unit/stdlib_roll.c"
