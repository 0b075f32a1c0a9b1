// SPDX-License-Identifier: Apache-2.0
// The scripts of smc mutate --scripts: each fails on changes of the machine that no given script notices.
#ifndef SMC_CLI_MUTATE_SCRIPTS_H
#define SMC_CLI_MUTATE_SCRIPTS_H

#include "compiler/cli/cli.h"
#include "compiler/cli/progress.h"
#include "compiler/cover/mutate.h"

// Shows how many changes have been tried, and for how many unnoticed changes a script has been searched.
void mutate_show_progress(const Mutation *u, ProgressLine *k);

typedef struct MutateScripts {
    const char **by_mutant;   // by index in mutation_list: the script that fails on the mutant; NULL: none
    unsigned long scripts, shown;     // number of scripts written; number of mutants that they show
} MutateScripts;

// Writes the scripts of all mutants for which inputs were found into a folder, which is created.  A script that also fails on later mutants is
// the script of these, too.  machine: the name of its file, without folders.  EXIT_OK, or the exit code after a message.
int mutate_write_scripts(Cli *c, Mutation *u, const Program *p, const char *machine, const char *folder, MutateScripts *out);

#endif
