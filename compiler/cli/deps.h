// SPDX-License-Identifier: Apache-2.0
// -MD: the dependencies of an output, as a make rule.
#ifndef SMC_CLI_DEPS_H
#define SMC_CLI_DEPS_H

#include "compiler/cli/cli.h"

typedef struct DepInputs { const char **at; size_t n; } DepInputs;      // names of input files; "-", standard input, is skipped

bool deps_wanted(const Cli *c);
// Checks that the file of the rule has a name, from -MF or from the output. Returns false after a message.
bool deps_check_name(Cli *c, const OsOutput *output);
// Lists the files that the command has read: its arguments, what they include, recorded data, and files that options name.
DepInputs deps_list_inputs(Cli *c);
// Adds the rule after the *n outputs, where n > 0; the array has room for one more. The rule names them in order, and its file is named
// after the first by default: ninja requires the first output of a command to be first in its rule.
void deps_add_rule(Cli *c, OsOutput *out, size_t *n, DepInputs in);
// The same for a command with one output, the file of -o or standard output: checks the name, and writes the output with the rule of -MD.
// deps_write_result returns the exit code.
bool deps_check_result(Cli *c);
int deps_write_result(Cli *c, const Buf *result);

#endif
