// SPDX-License-Identifier: Apache-2.0
// The parts of a report that take time, each only if an option requests it: proofs, changes of the machine, faults of sensors, other values of
// parameters.
#ifndef SMC_CLI_REPORT_PARTS_H
#define SMC_CLI_REPORT_PARTS_H

#include "compiler/cli/cli.h"
#include "compiler/report/page.h"

// Replaces --all by the options of all parts, and lets --scripts and --pairs imply --faults.
void report_parts_choose(Cli *c);
// Runs the requested parts on the scripts of r, which have run.  p: the machine as its scripts run it.  A part that cannot run is not an error: the
// page and a note say why.  One that a signal or the end of `seconds` (0: no limit) stops is in r->unfinished, and the page has what was found until
// then.  EXIT_OK, or the exit code after a message.
int report_parts_run(Cli *c, Report *r, const Program *p, const CompileOptions *o, double seconds);

#endif
