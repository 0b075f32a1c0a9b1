// SPDX-License-Identifier: Apache-2.0
// The actions `parameters` and `set` of `smc device` (docs/link.md, chapter 10).
#ifndef SMC_CLI_DEVICE_PARAMETERS_H
#define SMC_CLI_DEVICE_PARAMETERS_H

#include "compiler/cli/board_line.h"

// Lists the parameters of the image that the board runs.
int device_show_parameters(BoardLine *b, Buf *out);

// Sends the image that the board runs with the values of the settings c->file[1] and following.
int device_set_parameters(BoardLine *b, Buf *out);

// Whether c->file[1] and the following have the form NAME=VALUE.  Returns false after a message.
bool device_check_settings(Cli *c);

#endif
