// SPDX-License-Identifier: Apache-2.0
// Applications on the command line: functions shared by build and check.
#ifndef SMC_CLI_APP_H
#define SMC_CLI_APP_H

#include "compiler/cli/cli.h"

typedef struct CliApp {
    AstFile *tree;
    AppFiles files;
} CliApp;

// Reads and parses `path` and loads the files that it names. A named file that cannot be read is reported when it is checked. Returns
// false after a message if `path` itself cannot be read or parsed.
bool cli_load_app(Cli *c, const char *path, CliApp *out);

int build_app(Cli *c);        // smc build NAME.app
int check_app_file(Cli *c);   // smc check NAME.app

#endif
