// SPDX-License-Identifier: Apache-2.0
// Makes a failing program smaller as long as it has the same failure.
#ifndef SM_DIFF_REDUCE_H
#define SM_DIFF_REDUCE_H

#include "tests/diff/run.h"

// Changes g; returns the result of the smallest program found.
RunResult reduce(Gen *g, const RunOptions *o, RunResult first, Arena *arena);

#endif
