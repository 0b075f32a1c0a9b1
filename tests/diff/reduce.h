// SPDX-License-Identifier: Apache-2.0
// Makes a failing program smaller as long as it fails in the same way.
#ifndef SM_DIFF_REDUCE_H
#define SM_DIFF_REDUCE_H

#include "tests/diff/run.h"

// Changes g; gives what the smallest one found does.
RunResult reduce(Gen *g, const RunOptions *o, RunResult first, Arena *arena);

#endif
