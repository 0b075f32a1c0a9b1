// SPDX-License-Identifier: Apache-2.0
// Key files, as --key names them.
#ifndef SMC_CLI_KEY_H
#define SMC_CLI_KEY_H

#include "bytecode-vm/auth.h"
#include "compiler/cli/cli.h"

// Whether a file with these bytes is a key: 32 hexadecimal digits and line ends.
bool key_is_file(const char *text, size_t n);

// Returns EXIT_OK, or the exit code after a message. Warns of a file that other users can read.
int key_load(Cli *c, uint8_t key[SMVM_KEY]);

// Checks that an image is signed with the loaded key; if not, prints the reason followed by `then` and returns false.
bool key_check_signature(Cli *c, const Source *image, const uint8_t *key, const char *then);

#endif
