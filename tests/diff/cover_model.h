// SPDX-License-Identifier: Apache-2.0
// Coverage by its definition in docs/testing.md, implemented in the plainest way: the reference's arithmetic runs the machine and records every
// place of compiler/cover.  A condition decides if flipping this condition alone changes the result.
#ifndef SM_DIFF_COVER_MODEL_H
#define SM_DIFF_COVER_MODEL_H

#include "compiler/cover/cover.h"

// Opens an engine that counts how often the places of c are executed.
Engine *cover_model_open(Arena *arena, const Program *p, const Cover *c);
// Returns NULL if c has the same counts; otherwise a sentence about the first place that differs.  The counts of c must be final.
const char *cover_model_compare(const Engine *model, const Cover *c, Arena *arena);

#endif
