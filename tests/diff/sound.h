// SPDX-License-Identifier: Apache-2.0
// Whether what analyses call impossible stays away: a program is run from its first state, statement by statement, and held
// and compares it with what was proved about it before.
#ifndef SM_DIFF_SOUND_H
#define SM_DIFF_SOUND_H

#include "tests/diff/run.h"

// Adds guards that are often decided by others: repeated, tightened, contradicting, complete.
void gen_bias(Gen *g);

RunResult run_sound(Gen *g, Arena *arena);

#endif
