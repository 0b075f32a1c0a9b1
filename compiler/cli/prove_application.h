// SPDX-License-Identifier: Apache-2.0
// smc prove of an application: decides the requirements that one of its machines decides alone, and says why others are not decided.
#ifndef SMC_CLI_PROVE_APPLICATION_H
#define SMC_CLI_PROVE_APPLICATION_H

#include "compiler/cli/cli.h"
#include "compiler/prove/prove.h"

// The limits of a search and of a proof; 0: the defaults.
typedef struct ProveSettings { uint64_t effort, memory; } ProveSettings;

// Decides the requirements, and appends the text, or the JSON if `is_json`, to *out.  Returns an exit code; EXIT_PROBLEM: two requirements contradict
// each other, which was printed.
int prove_application(Cli *c, const Requirements *what, const ProveSettings *s, bool is_json, Buf *out);

#endif
