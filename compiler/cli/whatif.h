// SPDX-License-Identifier: Apache-2.0
// A machine with its scripts and requirements, for smc faults and smc sweep.
#ifndef SMC_CLI_WHATIF_H
#define SMC_CLI_WHATIF_H

#include "compiler/cli/cli.h"
#include "compiler/script/baseline.h"

typedef struct WhatIf {
    const Program *p;
    const Requirements *requirements;     // NULL: none
    VEC(const Script *) script;
    uint64_t max_steps;
} WhatIf;

// Compiles the files that the command names, and reads --max-steps.  EXIT_OK, or the exit code after a message.
int whatif_load(Cli *c, WhatIf *w);
// Reports that all scripts, or some of them, fail or violate requirements without a change.  `what`: "fault", "change".  Returns the exit code
// for it.
int whatif_report_baseline(Cli *c, const Baseline *b, const char *what);
// Reads a list of words between commas.  Calls `add` for each; it returns false after a message, and so does this.
bool whatif_read_list(const char *list, void *context, bool (*add)(void *context, const char *word, size_t n));

#endif
