// SPDX-License-Identifier: Apache-2.0
// A line on the terminal that shows how far a long command is.  Nothing is shown if standard error is not a terminal.
#ifndef SMC_CLI_PROGRESS_H
#define SMC_CLI_PROGRESS_H

#include "compiler/cli/cli.h"

typedef struct ProgressLine {
    Cli *c;
    double last;              // when the line was last written, in seconds; 0: never
    bool is_shown;
} ProgressLine;

// Whether the line can be written again: five times a second, on a terminal.
bool progress_is_due(const ProgressLine *k);
// Replaces the line.  `text` has at most PROGRESS_WIDTH characters.
void progress_show(ProgressLine *k, const char *text);
// Removes the line.
void progress_end(ProgressLine *k);

enum { PROGRESS_WIDTH = 78 };

#endif
