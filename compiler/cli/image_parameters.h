// SPDX-License-Identifier: Apache-2.0
// The parameters of an image for `smc set` and `smc device`: their list, and settings NAME=VALUE.
#ifndef SMC_CLI_IMAGE_PARAMETERS_H
#define SMC_CLI_IMAGE_PARAMETERS_H

#include "bytecode-vm/smvm.h"
#include "compiler/cli/cli.h"

// Writes the identities of logic and settings, then a line for each parameter, with its value, unit, type, range and default.  The verifier
// must have accepted the image.
void parameters_list(Cli *c, SmvmBytes bytes, Buf *out);

// Sets the parameter that `word`, as NAME=VALUE, names.  Returns false after a message; then the image has not changed.
bool parameters_set(Cli *c, uint8_t *image, const char *word);

#endif
