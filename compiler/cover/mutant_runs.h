// SPDX-License-Identifier: Apache-2.0
// Runs the scripts of a machine on its mutants.  The unchanged machine runs each script once, and these runs are recorded: what the script
// writes in each step, and, at certain steps that are called *points*, the states of the machine and of the script.
//
// A mutant behaves like the machine until it first executes the changed statement.  So its run begins at the last point before that.  From there
// it steps with the recorded inputs, without the script.  As long as the script would read the recorded values, it would write what it wrote in
// the recorded run.  The script itself runs only from the point before the first difference on.  If the mutant has the recorded state at a point,
// the steps up to the next execution of the changed statement are skipped.
#ifndef SMC_MUTANT_RUNS_H
#define SMC_MUTANT_RUNS_H

#include "compiler/cover/flat.h"
#include "compiler/script/baseline.h"
#include "compiler/script/script.h"
#include "compiler/script/scenario.h"
#include "compiler/sema/program.h"

typedef struct MutantRuns MutantRuns;

// Records the runs of the scripts, and which statements they execute.  A run fails if it violates one of the requirements `rq`, which
// can be NULL, and which the unchanged machine does not violate with this script.  p: a machine, or an application, of whose machines number
// `member` has the mutants.  Its scripts run whole on each of these.
MutantRuns *mutant_runs_new(Arena *arena, const Program *p, size_t member, const Script *const *script, uint32_t scripts, const Requirements *rq,
                            uint64_t max_steps);
// Returns the runs on the unchanged machine: which scripts and requirements are left out.
const Baseline *mutant_runs_baseline(const MutantRuns *r);
// Used instead of a Stmt.number for a change that is in no statement: in code that each step executes, or in an initial value.
#define MUTANT_EACH_STEP UINT32_C(0)
#define MUTANT_START UINT32_MAX

// Returns the index of a script that fails on the mutant; `scripts`: all pass.  *violated receives the requirement that this run violates, or
// NULL.  stmt: the n changed statements, each a Stmt.number or one of the constants above.  A run also fails if it takes more steps than 1000 plus
// four times the steps of the unchanged machine.  `work`: memory for the call.
uint32_t mutant_runs_find_noticing(MutantRuns *r, Arena *work, FlatMachine *mutant, const uint32_t *stmt, uint32_t n, const Requirement **violated);
// Returns what a recorded run writes to the inputs of the machine, as a scenario; NULL: the run was not recorded.  What a script writes to
// variables that the machine stores is left out.
const Scenario *mutant_runs_scenario(const MutantRuns *r, Arena *arena, uint32_t script);
// Returns the unchanged machine.
FlatMachine *mutant_runs_original(const MutantRuns *r);

#endif
