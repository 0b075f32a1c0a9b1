// SPDX-License-Identifier: Apache-2.0
// Sends an image to a board, for `smc flash` and `smc device set`.
#ifndef SMC_CLI_BOARD_FLASH_H
#define SMC_CLI_BOARD_FLASH_H

#include "compiler/cli/board_line.h"
#include "compiler/device/flash.h"

// Checks whether the board can be sent the image, sends it, restarts the board and prints what runs now.  `name` denotes the image in messages.
// With --dry-run nothing is sent; with --confirm the image is confirmed as soon as it runs.  Returns the exit code.
int board_flash(BoardLine *b, const char *name, const FlashImage *image);

#endif
