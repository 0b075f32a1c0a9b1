// SPDX-License-Identifier: Apache-2.0
// A machine and its scripts, for the commands that run them: their arguments, compiling, and the runs on the VM for smc report and smc graph.
#ifndef SMC_CLI_RUNS_H
#define SMC_CLI_RUNS_H

#include "compiler/cli/cli.h"
#include "compiler/review.h"

// Checks that the arguments are one machine and scripts, and for some commands requirements.  Returns EXIT_OK, or the exit code after a message.
int runs_check_arguments(Cli *c);
// Reports that the command is for one machine, and what to name instead of an application.  Returns an exit code.
int runs_refuse_app(Cli *c, const char *app);
// Compiles `in` for a command that runs the scripts itself: no analysis runs, and each script still needs session_script.  Returns EXIT_OK, or
// the exit code after messages.
int runs_compile(Cli *c, const CompileInput *in, CompileOptions *o, Compiled *made);
// Returns the machine, or the application, among the compiled sources.
const CompiledSource *runs_find_machine(const CompileInput *in, const Compiled *made);
// Reports two requirements of one machine that no step can meet together.  Returns whether there are any.
bool runs_report_contradiction(Cli *c, const Requirements *r);
// Runs the scripts of `in` into r->run, on an image with names of p: the machine of r->analysis, compiled for scripts.
int runs_execute(Cli *c, Report *r, const CompileInput *in, const Compiled *made);
// Runs the scripts of an application into r->run and the runs of its machines.
int runs_execute_app(Cli *c, Report *r, const CompileInput *in, const Compiled *made);

#endif
