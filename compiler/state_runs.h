// SPDX-License-Identifier: Apache-2.0
// Runs that reach the states of a machine, found by the search of `smc cover`.  Trial runs begin along them (AnalysisSearch).
#ifndef SMC_STATE_RUNS_H
#define SMC_STATE_RUNS_H

#include "compiler/analysis/analysis.h"

AnalysisRuns state_runs_find(Arena *arena, const Program *p, uint64_t delta_t, const uint64_t *parameter, uint32_t share);

#endif
