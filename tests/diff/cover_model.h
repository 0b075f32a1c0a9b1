// SPDX-License-Identifier: Apache-2.0
// Coverage as its definition says it (docs/testing.md), as plainly as possible: a machine run by the reference's arithmetic that notes every
// place of compiler/cover.  A condition decides if the result is another one when only this condition is flipped.
#ifndef SM_DIFF_COVER_MODEL_H
#define SM_DIFF_COVER_MODEL_H

#include "compiler/cover/cover.h"

// Opens an engine that counts the places of c.
Engine *cover_model_open(Arena *arena, const Program *p, const Cover *c);
// Returns NULL if c, whose counts are settled, has the same counts; otherwise a sentence about the first place that differs.
const char *cover_model_compare(const Engine *model, const Cover *c, Arena *arena);

#endif
