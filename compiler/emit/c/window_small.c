// SPDX-License-Identifier: Apache-2.0
// The memory for a rolling window in emitted C that is compiled with SM_ROLL_SMALL.
#define SM_ROLL_SMALL 1
#include "compiler/emit/c/unit.h"
#include "stdlib/roll.h"

uint32_t c_small_roll_words(uint32_t n, uint32_t kind) { return sm_roll_words(n, kind); }
