// SPDX-License-Identifier: Apache-2.0
// Emitted C: many programs in one translation unit, compiled by several compilers, each fed the whole conversation at once;
// what it answers must be what the reference answered, byte for byte.
#ifndef SM_DIFF_CBATCH_H
#define SM_DIFF_CBATCH_H

#include "tests/diff/run.h"

enum { C_BATCH_MAX = 100 };

// Runs n programs (at most C_BATCH_MAX), each in some forms (1u << Form …), with each compiler command; r[i] tells of the i-th.
// Files are made in `folder`.
void run_c_batch(Gen *const *g, const unsigned *forms, uint32_t n, const char *const *cc, uint32_t ccs, const char *folder,
                 Arena *arena, RunResult *r);

#endif
