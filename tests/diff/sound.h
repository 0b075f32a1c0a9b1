// SPDX-License-Identifier: Apache-2.0
// Checks that what analyses call impossible does not occur.  A program runs from its first state, statement by statement, and is compared with
// what the analyses proved about it.
#ifndef SM_DIFF_SOUND_H
#define SM_DIFF_SOUND_H

#include "tests/diff/run.h"

// Adds guards whose result other guards often decide: repeated, narrower, contradicting, and complementary ones.
void gen_bias(Gen *g);

RunResult run_sound(Gen *g, Arena *arena);

#endif
