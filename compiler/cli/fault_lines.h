// SPDX-License-Identifier: Apache-2.0
// The list of what faults do, and the scripts that reproduce each line of it: for smc faults and smc report.
#ifndef SMC_CLI_FAULT_LINES_H
#define SMC_CLI_FAULT_LINES_H

#include "compiler/cli/cli.h"
#include "compiler/cli/progress.h"
#include "compiler/whatif/faults.h"

// One line of the list: the faults of one kind, of the same inputs and with the same outcome.
typedef struct FaultLine {
    const FaultResult *r;     // the result of the first run of this line
    uint32_t others;          // number of other triggers at which the same fault has the same outcome
    const char *script;       // the file that reproduces the fault; NULL: none
    const char *text;         // the contents of the file
} FaultLine;

typedef struct FaultLines {
    Cli *c;
    const Program *p;
    Faults *f;
    VEC(FaultLine) at;        // single faults first, then pairs; of these, violated requirements, aborts, failed asserts, others
    uint32_t scripts;         // number of lines with a script
} FaultLines;

// Sets kinds, sizes and the number of runs to their defaults.
void fault_lines_set_defaults(FaultOptions *o);
void fault_lines_show_progress(const Faults *f, ProgressLine *k);
// Collects the results with an effect in lines.  `each`: each in a line of its own.
void fault_lines_collect(FaultLines *l, bool each);
// Makes and writes the scripts of all lines into the folder of --scripts, if that is given.  EXIT_OK, or the exit code after a message.
int fault_lines_write_scripts(FaultLines *l);

#endif
