// SPDX-License-Identifier: Apache-2.0
// A machine and its scripts for smc report and smc graph: their arguments, and the runs of the scripts on the VM.
#ifndef SMC_CLI_RUNS_H
#define SMC_CLI_RUNS_H

#include "compiler/cli/cli.h"
#include "compiler/report/report.h"

// Finds the one machine among the arguments; all others are scripts. Returns EXIT_OK, or the exit code after a message.
int runs_machine(Cli *c, const char **machine);
// Reads the scripts, by argument; false after a message.
bool runs_load(Cli *c, Source ***ss, Map *written);
// Runs them into r->run, on an image with names of p: the machine of r->analysis, compiled for scripts.
int runs_make(Cli *c, Report *r, const Program *p, Source *const *ss);

#endif
