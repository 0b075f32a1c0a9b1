// SPDX-License-Identifier: Apache-2.0
// Records the run of a script as a scenario, from which a search can start.
#ifndef SMC_SCENARIO_RECORD_H
#define SMC_SCENARIO_RECORD_H

#include "compiler/script/engine.h"
#include "compiler/search/scenario.h"

// Opens an engine that passes everything on to `inner`, and records what is written in one run.
Engine *scenario_record_open(Arena *arena, const Program *p, Engine *inner, uint64_t delta_t);
// Returns what was recorded.  It ends before the first write that no scenario has, such as one to an output, and before too many changes: a
// script that is generated from it would repeat them.  steps: 0 if nothing is left.
Scenario scenario_recorded(Engine *recorder);

#endif
