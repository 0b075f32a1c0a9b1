// SPDX-License-Identifier: Apache-2.0
// The size of a rolling window of samples in emitted C that is compiled with SM_ROLL_SMALL.  A file of its own, because roll.h is included with
// that macro set.
#define SM_ROLL_SMALL 1
#include "compiler/emit/c/unit.h"
#include "stdlib/roll.h"

uint32_t c_small_roll_words(uint32_t n, uint32_t kind) { return sm_roll_words(n, kind); }
