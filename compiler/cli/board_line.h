// SPDX-License-Identifier: Apache-2.0
// What `smc flash` and `smc device` share: the line to a board, and what is said of it.
#ifndef SMC_BOARD_LINE_H
#define SMC_BOARD_LINE_H

#include "compiler/cli/cli.h"
#include "compiler/device/device.h"

typedef struct BoardLine {
    Cli *c;
    int fd;
    Line line;
    LinkHost host;
    DeviceInfo info;
} BoardLine;

// Opens --port and asks who is there.  EXIT_OK, or the exit code after a message.
int board_open(Cli *c, BoardLine *b);
void board_close(BoardLine *b);

// Why the last request came to nothing, as a message behind `what`, and the exit code: EXIT_PROBLEM, the board refused;
// EXIT_ENVIRONMENT, nobody answers.
int board_failed(BoardLine *b, const char *what);

// "slot 1: 443 bytes, checksum 2f0a11c4, identity 0011223344556677, runs, on trial (2 starts left)"
void board_describe(Buf *out, const DeviceImage *image);

#endif
