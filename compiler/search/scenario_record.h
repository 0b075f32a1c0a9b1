// SPDX-License-Identifier: Apache-2.0
// Records the run of a script as a scenario, from which a search can start.
#ifndef SMC_SCENARIO_RECORD_H
#define SMC_SCENARIO_RECORD_H

#include "compiler/script/engine.h"
#include "compiler/script/scenario.h"

enum { SCENARIO_FEW_CHANGES = 32 };   // a script that is generated from a scenario repeats its changes

// Opens an engine that passes everything on to `inner`, and records what is written in one run.  `writable`: by Var.index, what a scenario can
// set; `most`: the recording ends after this many changes.
Engine *scenario_record_open(Arena *arena, const Program *p, Engine *inner, uint64_t delta_t, const bool *writable, size_t most);
// Returns what was recorded.  The scenario ends before the first write that a scenario cannot contain, such as one to an output, and before too
// many changes.  Its `steps` is 0 if not even the first step could be recorded.
Scenario scenario_recorded(Engine *recorder);
// Returns how many steps the whole run had.  Sets *ended_by to the variable of the write before which the scenario ends; NULL: it has all steps.
uint64_t scenario_recorded_steps(const Engine *recorder, const Var **ended_by);

#endif
