// SPDX-License-Identifier: Apache-2.0
// Key files: what --key names.
#ifndef SMC_CLI_KEY_H
#define SMC_CLI_KEY_H

#include "bytecode-vm/auth.h"
#include "compiler/cli/cli.h"

// EXIT_OK, or the exit code after a message.  Warns of a file that others can read.
int key_load(Cli *c, uint8_t key[SMVM_KEY]);

#endif
