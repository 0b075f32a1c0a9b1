// SPDX-License-Identifier: Apache-2.0
// Key files: what --key names.
#ifndef SMC_CLI_KEY_H
#define SMC_CLI_KEY_H

#include "bytecode-vm/auth.h"
#include "compiler/cli/cli.h"

// Whether a file with these bytes is a key: 32 hexadecimal digits and line ends.
bool key_is_file(const char *text, size_t n);

// EXIT_OK, or the exit code after a message.  Warns of a file that others can read.
int key_load(Cli *c, uint8_t key[SMVM_KEY]);

// Whether an image is signed with the key that was loaded; if not, says why, and `then` behind it.
bool key_signed(Cli *c, const Source *image, const uint8_t *key, const char *then);

#endif
