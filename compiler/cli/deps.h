// SPDX-License-Identifier: Apache-2.0
// -MD: what an output depends on, as a make rule.
#ifndef SMC_CLI_DEPS_H
#define SMC_CLI_DEPS_H

#include "compiler/cli/cli.h"

typedef struct Inputs { const char **at; size_t n; } Inputs;      // "-" among them is no file

bool deps_wanted(const Cli *c);
// Whether the rule has a name for its file: from -MF or from the output.  false after a message.
bool deps_named(Cli *c, const OsOutput *output);
// Adds the rule behind the *n outputs, of which there are some; there is room for one more.  The rule names them in their order, and
// is named after the first, if nothing else is said: ninja wants the first output of a command first in its rule.
void deps_add(Cli *c, OsOutput *out, size_t *n, Inputs in);

#endif
