// SPDX-License-Identifier: Apache-2.0
// Functions shared by `smc flash` and `smc device`: the serial line to a board, and the description of its images.
#ifndef SMC_BOARD_LINE_H
#define SMC_BOARD_LINE_H

#include "compiler/cli/cli.h"
#include "compiler/device/app_host.h"
#include "compiler/device/device.h"

typedef struct BoardLine {
    Cli *c;
    int fd;
    SerialLine line;
    LinkHost host;
    DeviceInfo info;          // the properties that a board has reported; valid unless `is_application`
    bool is_application;      // an application answers at the other end, not a board: `app` is valid instead of `info`
    ApplicationInfo app;
} BoardLine;

// Opens --port and queries what is there: a board, or an application. EXIT_OK, or the exit code after a message.
int board_open(Cli *c, BoardLine *b);
// Opens `where`, and queries the application that must be there.
int application_open(Cli *c, BoardLine *b, const char *where);
void board_close(BoardLine *b);

// Prints why the last request failed, as a message after `what`. Returns EXIT_PROBLEM if the board or the application refused it (refusals.def),
// EXIT_ENVIRONMENT if there was no answer.
int board_report_failure(BoardLine *b, const char *what);

// Returns why a trial ended (DeviceEnd), as a clause of a sentence.
const char *board_trial_end_text(uint8_t end);

// Describes an image, as in "slot 1: 443 bytes, checksum 2f0a11c4, identity 0011223344556677, runs, on trial (2 starts left)".
void board_describe(Buf *out, const DeviceImage *image);

#endif
